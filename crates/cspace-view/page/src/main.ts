/** Shows the scene that is in the page. */

import { openPage, readScene, showFailure } from "./ui/page.js";

try {
  openPage(readScene());
} catch (error) {
  showFailure(error);
  throw error;
}
