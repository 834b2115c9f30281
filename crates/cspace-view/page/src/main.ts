/** Shows the scene that is in the page. */

import { showFailure } from "./ui/message.js";
import { openPage, readScene } from "./ui/page.js";

try {
  openPage(readScene());
} catch (error) {
  showFailure(error);
  throw error;
}
