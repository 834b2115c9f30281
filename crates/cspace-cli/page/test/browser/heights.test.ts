/** Stacks of layers: the side view, and one height looked at alone. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { addressOf, exported, open, skip } from "../../tools/harness.js";
import { inBrowser, model, settled } from "./support.js";

const CHOICE = "#stack select";

describe("heights", { skip }, () => {
  const suite = inBrowser();

  async function openModel(name: string, fragment = ""): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(model(name), suite.folder)) + fragment);
    return suite.opened.page;
  }

  /** What each outline is called, of those that are faint or those that are not. */
  const outlines = (page: Page, faint: boolean): Promise<string[]> =>
    page.$$eval(`#parts .outline${faint ? ".away" : ":not(.away)"}`, (all) => all.map((e) => e.querySelector("title")?.textContent ?? "").sort());
  const chosen = (page: Page): Promise<string> => page.$eval(CHOICE, (e) => (e as HTMLSelectElement).selectedOptions[0]?.text ?? "");
  const press = async (page: Page, key: "ArrowUp" | "ArrowDown"): Promise<void> => {
    await page.focus(CHOICE);
    await page.keyboard.press(key);
    await settled(page);
  };
  /** Clicks a layer in the side view, above its middle. */
  const click = async (page: Page, title: string): Promise<void> => {
    const box = await page.$$eval("#stack .outline", (all, title) => {
      const r = all.find((e) => e.querySelector("title")?.textContent === title)?.getBoundingClientRect();
      return r ? [r.x + r.width / 2, r.y + r.height / 3] : [NaN, NaN];
    }, title);
    await page.mouse.click(box[0] ?? NaN, box[1] ?? NaN);
    await settled(page);
  };

  it("are chosen in the list, by its keys, and leave the rest faint", async () => {
    const page = await openModel("layers/compound_train");
    assert.deepEqual(await page.$$eval(`${CHOICE} option`, (all) => all.map((o) => o.text)), ["All heights", "8 to 16 mm", "0 to 8 mm"]);
    assert.deepEqual(await outlines(page, true), []);
    await press(page, "ArrowDown");
    assert.equal(await chosen(page), "8 to 16 mm");
    assert.deepEqual(await outlines(page, true), ["first arbor, z 0 to 8", "second arbor, z 0 to 8"]);
    assert.deepEqual(await outlines(page, false), ["second arbor, z 8 to 16", "third arbor, z 8 to 16"]);
    assert.deepEqual(await page.$$eval("#parts .part-names text", (all) => all.map((e) => e.textContent).filter((name) => name === "first arbor")), []);
    await press(page, "ArrowDown");
    assert.deepEqual(await outlines(page, false), ["first arbor, z 0 to 8", "second arbor, z 0 to 8"]);
    // What is faint lets the pointer through.
    assert.equal(await page.$eval("#parts .outline.away", (e) => getComputedStyle(e).pointerEvents), "none");
  });

  it("are chosen by a click in the side view, and left by another", async () => {
    const page = await openModel("layers/compound_train");
    await click(page, "third arbor, z 8 to 16 mm");
    assert.equal(await chosen(page), "8 to 16 mm");
    await click(page, "first arbor, z 0 to 8 mm");
    assert.equal(await chosen(page), "0 to 8 mm");
    assert.equal((await outlines(page, true)).length, 2);
    await click(page, "first arbor, z 0 to 8 mm");
    assert.equal(await chosen(page), "All heights");
    assert.deepEqual(await outlines(page, true), []);
  });

  it("are in the address, and stay while a parameter is changed", async () => {
    const page = await openModel("layers/compound_train", "#height=12");
    assert.equal(await chosen(page), "8 to 16 mm");
    // The second arbor goes with the distance.
    const drawn = (): Promise<string | null | undefined> =>
      page.$$eval("#parts .outline.away", (all) => all.find((e) => e.querySelector("title")?.textContent === "second arbor, z 0 to 8")?.getAttribute("d"));
    const before = await drawn();
    await page.$eval("#design input[type=range]", (e) => {
      (e as HTMLInputElement).value = "44.5";
      e.dispatchEvent(new Event("input", { bubbles: true }));
      e.dispatchEvent(new Event("change", { bubbles: true }));
    });
    for (let tries = 0; tries < 300 && (await drawn()) === before; tries += 1) await settled(page);
    assert.notEqual(await drawn(), before);
    assert.equal(await chosen(page), "8 to 16 mm");
    assert.equal((await outlines(page, true)).length, 2);
    await page.waitForFunction(() => location.hash.includes("height=12"));
    await page.evaluate(() => (location.hash = location.hash.replace("height=12", "height=99")));
    await settled(page);
    assert.equal(await chosen(page), "All heights");
  });

  it("have the contacts of their own layers alone", async () => {
    const page = await openModel("layers/cam_stack");
    assert.deepEqual(await page.evaluate(() => window.cspace.pair()), ["shaft", "lower follower"]);
    for (let i = 0; i < 20; i += 1) await page.keyboard.press("ArrowDown");
    await settled(page);
    assert.equal((await page.evaluate(() => window.cspace.touching())).length, 1);
    const marks = (): Promise<number[]> => Promise.all(["#parts .contact", "#parts .touch-edge"].map((of) => page.$$eval(of, (all) => all.length)));
    assert.deepEqual(await marks(), [1, 2]);
    for (const [title, shown] of [["upper follower, z 11 to 17 mm", [0, 0]], ["lower follower, z 1 to 7 mm", [1, 2]]] as const) {
      await click(page, title);
      assert.deepEqual(await marks(), shown, title);
    }
  });

  it("are not asked for of models without layers", async () => {
    const page = await openModel("peg_hole", "#height=3");
    assert.equal(await page.$eval("#stack", (e) => (e as HTMLElement).hidden), true);
    assert.deepEqual(await outlines(page, true), []);
  });
});
