/** Shows what is in the page, or was opened in it: a model, or a drawing to make one of. */

import { openDrawing } from "./drawing/page.js";
import { loadKernel } from "./kernel/load.js";
import { textOf } from "./ui/dom.js";
import { shownScene } from "./ui/entries.js";
import { showFailure } from "./ui/message.js";
import { openPage } from "./ui/page.js";
import type { CspaceScript } from "./ui/script.js";

const opened = async () => {
  const { scene, isOpened } = await shownScene();
  await loadKernel(textOf("kernel"));
  if (scene.format === "cspace-drawing") openDrawing(scene);
  else await openPage({ scene, isOpened }, textOf("worker"));
};

// Scripts may wait from the beginning.
const ready = opened().catch((error: unknown) => {
  showFailure(error);
  throw error;
});
window.cspace = { ready } as CspaceScript;
