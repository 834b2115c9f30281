/** What tests in a browser share: a browser for each suite, and what users do on any page. */

import assert from "node:assert/strict";
import { existsSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before } from "node:test";
import type { Browser, Page } from "puppeteer-core";
import { PATIENCE, launch, root, scratch } from "../../tools/harness.js";
import type { Opened } from "../../tools/harness.js";

export const model = (name: string): string => join(root, `models/${name}.toml`);

export interface Suite {
  /** For files; gone in the end. */
  readonly folder: string;
  browser: Browser;
  /** The page that a test has open: it is closed after the test, which fails if anything went wrong on it. */
  opened: Opened | null;
}

/** To be called within `describe`. */
export function inBrowser(): Suite {
  const folder = scratch();
  const suite = { folder: folder.path, opened: null } as unknown as Suite;
  before(async () => {
    suite.browser = await launch(folder.path);
  });
  afterEach(async () => {
    const faults = suite.opened?.faults ?? [];
    await suite.opened?.page.close();
    suite.opened = null;
    assert.deepEqual(faults, []);
  });
  after(async () => {
    await suite.browser?.close();
    folder.remove();
  });
  return suite;
}

/** Waits for two frames, in which the page draws what has changed. */
export function settled(page: Page): Promise<void> {
  return page.evaluate(() => new Promise<void>((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}

/** The button with a text. */
export const button = (text: string): string => `::-p-xpath(//button[normalize-space()="${text}"])`;

/** Clicks the button with a text, once it stays where it is, and waits until the page has drawn what comes of it. */
export async function press(page: Page, text: string): Promise<void> {
  await page.locator(button(text)).setTimeout(PATIENCE).click();
  await settled(page);
}

/** Clicks an element in the side panel, where answers that come later move what is below them. */
export async function click(page: Page, selector: string): Promise<void> {
  await resting(page, selector);
  await page.click(selector);
}

/** Drops a file onto the page. */
export async function drop(page: Page, name: string, bytes: Buffer): Promise<void> {
  await page.evaluate(
    (name, text) => {
      const files = new DataTransfer();
      files.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name));
      document.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true }));
    },
    name,
    bytes.toString("base64"),
  );
}

/** A file that is being saved, once it is. */
export async function downloaded(path: string): Promise<string> {
  for (let tries = 0; tries < 600; tries++) {
    if (existsSync(path) && statSync(path).size > 0) {
      return path;
    }
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error(`${path} was not saved`);
}

/** The box of an element, by selector and index, once it stays where it is: answers that come later may move it. */
export async function resting(page: Page, selector: string, index = 0): Promise<{ x: number; y: number; width: number; height: number }> {
  for (let before = ""; ; await new Promise((wait) => setTimeout(wait, 150))) {
    const box = await (await page.$$(selector))[index]?.boundingBox();
    const now = JSON.stringify(box);
    if (box && now === before) return box;
    before = now;
  }
}
