/** Shows the faces of the drawing that is in the page, to make parts of those that are picked. */

import { openDrawing } from "./drawing/page.js";
import { readDrawing } from "./drawing/scene.js";
import { showFailure } from "./ui/message.js";

try {
  openDrawing(readDrawing());
} catch (error) {
  showFailure(error);
  throw error;
}
