/** A page in a file computes itself: ways, motions, edits, mechanisms under the hand, and models that are dropped onto it. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, it } from "node:test";
import type { Browser, Page } from "puppeteer-core";
import { PATIENCE, addressOf, drawn, exported, launch, open, root, scratch, skip } from "../../tools/harness.js";

const model = (name: string) => join(root, "models", `${name}.toml`);

/** Clicks a button by its text. */
async function click(page: Page, text: string): Promise<void> {
  await page.evaluate((text) => {
    const all = [...document.querySelectorAll<HTMLButtonElement>("button")];
    const found = all.find((b) => b.textContent === text);
    if (!found) throw new Error(`there is no button ${text}`);
    found.click();
  }, text);
}

/** What the page says until something is said that is looked for. */
async function said(page: Page, selector: string, words: string): Promise<string> {
  await page.waitForFunction(
    (selector, words) => document.querySelector(selector)?.textContent?.includes(words),
    { timeout: PATIENCE },
    selector,
    words,
  );
  return page.$eval(selector, (e) => e.textContent ?? "");
}

describe("a page in a file computes itself", { skip }, () => {
  const folder = scratch();
  let browser: Browser;
  before(async () => {
    browser = await launch(folder.path);
  });
  after(async () => {
    await browser?.close();
    folder.remove();
  });

  it("plans a way out, and says why there is none", async () => {
    const { page, faults } = await open(browser, addressOf(exported(model("peg_hole"), folder.path)));
    await page.evaluate("window.cspace.setConfiguration({ x: 0, y: 5, theta: 0 })");
    await click(page, "Way out");
    await page.waitForFunction(() => !document.getElementById("timeline")?.hidden, { timeout: PATIENCE });
    assert.match(await said(page, "#timeline", "way out"), /of 6 s/);
    assert.deepEqual(faults, []);
    await page.close();
  });

  it("plays the mechanism as its drives move it", async () => {
    const { page, faults } = await open(browser, addressOf(exported(model("geneva"), folder.path)));
    await click(page, "Play mechanism");
    await page.waitForFunction(() => !document.getElementById("timeline")?.hidden, { timeout: PATIENCE });
    // A turn of the driver, in which the wheel goes on by a slot.
    assert.match(await said(page, "#timeline", "mechanism"), /of 1 s/);
    const wheel = () => document.querySelector('[data-part="0"]')?.getAttribute("transform");
    const still = await page.evaluate(wheel);
    await page.waitForFunction((still) => document.querySelector('[data-part="0"]')?.getAttribute("transform") !== still, { timeout: PATIENCE }, still);
    assert.deepEqual(faults, []);
    await page.close();
  });

  it("drags the whole mechanism: what is pushed moves", async () => {
    const { page, faults } = await open(browser, addressOf(exported(model("geneva"), folder.path)));
    await click(page, "Push all parts");
    const wheel = () => page.$eval('[data-part="0"]', (e) => e.getAttribute("transform"));
    const driver = () => page.$eval('[data-part="1"]', (e) => e.getAttribute("transform"));
    const before = [await wheel(), await driver()];
    const box = await page.$eval('[data-part="1"] .grip', (e) => {
      const r = e.getBoundingClientRect();
      return { x: r.x, y: r.y, width: r.width, height: r.height };
    });
    const at = { x: box.x + 0.85 * box.width, y: box.y + box.height / 2 };
    const grabbed = await page.evaluate(({ x, y }) => document.elementFromPoint(x, y)?.closest("[data-part]")?.getAttribute("data-part"), at);
    assert.ok(grabbed !== undefined && grabbed !== null, "a part is under the pointer");
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    for (let k = 1; k <= 24; k++) await page.mouse.move(at.x - 4 * k, at.y - 8 * k);
    await page.mouse.up();
    await page.waitForFunction((old) => document.querySelector('[data-part="1"]')?.getAttribute("transform") !== old, { timeout: PATIENCE }, before[1]);
    assert.deepEqual(faults, []);
    await page.close();
  });

  it("computes edited parts", async () => {
    const { page, faults } = await open(browser, addressOf(exported(model("peg_hole"), folder.path)));
    await click(page, "Edit");
    await page.waitForSelector("#edit:not([hidden])", { timeout: PATIENCE });
    await page.evaluate(() => {
      const offset = [...document.querySelectorAll<HTMLInputElement>("#edit input[type=number]")][0];
      if (!offset) throw new Error("there is no field");
      offset.value = "-0.05";
      offset.dispatchEvent(new Event("change", { bubbles: true }));
    });
    await said(page, "#edit", " ms of ");
    assert.deepEqual(faults, []);
    await page.close();
  });

  it("opens a model that is dropped onto it", async () => {
    const { page, faults } = await open(browser, addressOf(exported(model("peg_hole"), folder.path)));
    const text = readFileSync(model("geneva"), "utf8");
    const loaded = page.waitForNavigation({ timeout: PATIENCE });
    await page.evaluate((text) => {
      const files = new DataTransfer();
      files.items.add(new File([text], "geneva.toml"));
      document.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true }));
    }, text);
    await loaded;
    await drawn(page);
    assert.deepEqual(await page.evaluate("window.cspace.pair()"), ["wheel", "driver"]);
    assert.equal(await page.evaluate("window.cspace.classify({ u: 0, v: 0 })"), await page.evaluate("window.cspace.classify(window.cspace.configuration())"));
    assert.deepEqual(faults, []);
    await page.close();
  });
});
