/** A page in a file computes itself: ways, motions, edits, mechanisms under the hand, and models that are dropped onto it. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, drawn, exported, long, open, skip } from "../../tools/harness.js";
import { drop, inBrowser, model, press } from "./support.js";

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
  const suite = inBrowser();

  /** The page of a model, from a file. */
  async function openFile(name: string): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(model(name), suite.folder)));
    return suite.opened.page;
  }

  it("plans a way out", async () => {
    const page = await openFile("peg_hole");
    await page.evaluate("window.cspace.setConfiguration({ x: 0, y: 5, theta: 0 })");
    await press(page, "Way out");
    await page.waitForFunction(() => !document.getElementById("timeline")?.hidden, { timeout: PATIENCE });
    assert.match(await said(page, "#timeline", "way out"), /of 6 s/);
  });

  it("says why there is no way out", async () => {
    // The clip's mouth is narrower than the ball.
    const page = await openFile("ball_in_c");
    await page.evaluate("window.cspace.setConfiguration({ x: 0, y: 0, theta: 0 })");
    await press(page, "Way out");
    assert.match(await said(page, "#message", "no way out"), /pocket 1 is enclosed, by /);
  });

  it("plays the mechanism as its drives move it", async () => {
    const page = await openFile("geneva");
    await press(page, "Play mechanism");
    await page.waitForFunction(() => !document.getElementById("timeline")?.hidden, { timeout: PATIENCE });
    // A turn of the driver, in which the wheel goes on by a slot.
    assert.match(await said(page, "#timeline", "mechanism"), /of 1 s/);
    const isTurned = () => {
      const [c, s] = (document.querySelector('[data-part="0"]')?.getAttribute("transform") ?? "").replace("matrix(", "").split(" ").map(Number);
      return Math.abs(Math.atan2(s ?? 0, c ?? 1)) > 0.5;
    };
    await page.waitForFunction(isTurned, { timeout: PATIENCE });
  });

  it("drags the whole mechanism: what is pushed moves", async () => {
    const page = await openFile("ratchet_mechanism");
    await press(page, "Push all parts");
    const [driver, link, pawl] = [1, 2, 3];
    const places = () => page.$$eval("[data-part]", (all) => Object.fromEntries(all.map((e) => [e.getAttribute("data-part"), e.getAttribute("transform")])));
    const before = await places();
    const at = await page.$eval(`[data-part="${driver}"] .outline`, (e) => {
      const r = e.getBoundingClientRect();
      return { x: r.x + 0.5 * r.width, y: r.y + 0.25 * r.height };
    });
    assert.equal(await page.evaluate(({ x, y }) => document.elementFromPoint(x, y)?.closest("[data-part]")?.getAttribute("data-part"), at), String(driver));
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 90, at.y + 30, { steps: 24 });
    // The driver's eccentric pushes the link, which carries the pawl.
    await page.waitForFunction(
      (parts, before) => parts.every((i) => document.querySelector(`[data-part="${i}"]`)?.getAttribute("transform") !== before[i]),
      { timeout: PATIENCE },
      [driver, link, pawl],
      before,
    );
    await page.mouse.up();
    assert.equal((await places())["0"], before["0"], "the frame stands");
  });

  it("computes edited parts", { skip: long }, async () => {
    const page = await openFile("peg_hole");
    await press(page, "Edit");
    await page.waitForSelector("#edit:not([hidden])", { timeout: PATIENCE });
    await page.evaluate(() => {
      const offset = [...document.querySelectorAll<HTMLInputElement>("#edit input[type=number]")][0];
      if (!offset) throw new Error("there is no field");
      offset.value = "-0.05";
      offset.dispatchEvent(new Event("change", { bubbles: true }));
    });
    await said(page, "#edit", " ms of ");
  });

  it("opens a model that is dropped onto it", async () => {
    const page = await openFile("peg_hole");
    await drop(page, "geneva.toml", readFileSync(model("geneva")));
    await said(page, "#model-name", "Geneva");
    await drawn(page);
    assert.deepEqual(await page.evaluate("window.cspace.pair()"), ["wheel", "driver"]);
    assert.equal(await page.evaluate("window.cspace.classify({ u: 0, v: 0 })"), await page.evaluate("window.cspace.classify(window.cspace.configuration())"));
  });
});
