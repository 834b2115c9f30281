/** Shows the scene that is in the page. */

import { loadKernel } from "./kernel/load.js";
import { textOf } from "./ui/dom.js";
import { showFailure } from "./ui/message.js";
import { openPage, readScene } from "./ui/page.js";

const opened = async () => {
  const shown = readScene();
  await loadKernel(textOf("kernel"));
  openPage(shown, textOf("worker"));
};

opened().catch((error: unknown) => {
  showFailure(error);
  throw error;
});
