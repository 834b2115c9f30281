/** The picture of a configuration space, as the gallery has it and a test compares it. */

import { PNG } from "pngjs";
import type { Browser } from "puppeteer-core";
import { PATIENCE, addressOf, open } from "./harness.js";

/** The window that it is taken in, and how large the pictures are of a surface and of a plane, whatever the page has room for (pixels). */
const WINDOW = { width: 1366, height: 720 };
const SIZES = "#space, #plane { position: fixed !important; left: 0; top: 0; z-index: 9; width: 587px; height: 359px; background: var(--panel); } #plane { height: 602px; }";

/** The panes of which that is taken which is shown: of a pair in the plane, on fixed axes, of any. */
const PANES = ["#space", "#plane", "#right"];

/** The picture of a model's space as the page shows it when it is opened. */
export async function spaceOf(browser: Browser, page_file: string): Promise<{ picture: Buffer; pair: [string, string] }> {
  const { page, faults } = await open(browser, `${addressOf(page_file)}#theme=light&view=space`, WINDOW);
  if (faults.length > 0) {
    throw new Error(faults.join("; "));
  }
  await page.addStyleTag({ content: SIZES });
  // What is drawn follows in the next frame.
  await page.evaluate(() => new Promise<void>((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
  // The page can be used before its surface is complete.
  await page.waitForFunction(() => document.querySelector<HTMLElement>("#building")?.hidden ?? true, { timeout: PATIENCE });
  const pair = (await page.evaluate("window.cspace.pair()")) as [string, string];
  for (const pane of PANES) {
    const element = await page.$(pane);
    if (element !== null && (await element.isVisible())) {
      const picture = PNG.sync.read(Buffer.from(await element.screenshot()));
      await page.close();
      return { picture: PNG.sync.write(picture, { deflateLevel: 9, colorType: 2 }), pair };
    }
  }
  throw new Error(`${page_file}: nothing is shown`);
}
