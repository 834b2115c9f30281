/** Models that come with the project, dropped onto a page in a file: drawn, dragged, edited and planned without a server. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { afterEach, before, describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, drawn, exported, open, shown, skip } from "../../tools/harness.js";
import type { Opened } from "../../tools/harness.js";
import { drop, inBrowser, model, press, settled } from "./support.js";

/** What the page answers in the end: a record, or a message that is no longer that it is computing. */
async function answered(page: Page, computing: RegExp): Promise<string> {
  await page.waitForFunction(
    (computing) => {
      const message = document.getElementById("message");
      const said = message && !message.hidden ? (message.textContent ?? "") : "";
      return !document.getElementById("timeline")?.hidden || (said !== "" && !new RegExp(computing).test(said));
    },
    { timeout: PATIENCE },
    computing.source,
  );
  return page.evaluate(() => (document.getElementById("timeline")?.hidden ? (document.getElementById("message")?.textContent ?? "") : "played"));
}

/** Where a part can be gripped: a place at which it is what the pointer meets. */
function grip(page: Page, part: string): Promise<{ x: number; y: number } | null> {
  return page.evaluate((part) => {
    const outline = document.querySelector(`[data-part="${part}"] .outline`);
    const r = outline?.getBoundingClientRect();
    for (let i = 1; r && i < 400; i += 1) {
      const at = { x: r.x + r.width * ((i * 0.618034) % 1), y: r.y + (r.height * i) / 400 };
      if (document.elementFromPoint(at.x, at.y)?.closest("[data-part]")?.getAttribute("data-part") === part) return at;
    }
    return null;
  }, part);
}

describe("models work in a page in a file", { skip }, () => {
  const suite = inBrowser();
  // One page takes one model after the other, as it does where a user drops them.
  let dropped: Opened | null = null;
  before(async () => {
    dropped = await open(suite.browser, addressOf(exported(model("peg_hole"), suite.folder)));
  });
  afterEach(() => {
    assert.deepEqual(dropped?.faults.splice(0), []);
  });

  for (const path of shown()) {
    it(basename(path), async () => {
      assert.ok(dropped !== null);
      const { page } = dropped;
      // The page that is there is another document, which may still change its address.
      await page.evaluate(() => Object.assign(window, { isBefore: true }));
      await drop(page, basename(path), readFileSync(path));
      await page.waitForFunction(() => !("isBefore" in window), { timeout: PATIENCE });
      await drawn(page);
      // Of models with other pairs no joint is shown first.
      assert.match(await page.$eval("#pair-class", (e) => e.textContent ?? ""), /features, \d+ patches/);
      // What is dragged goes, and never into the other part.
      const [, moving] = await page.evaluate(() => window.cspace.pair());
      const part = await page.$$eval("[data-part]", (all, name) => all.find((e) => e.querySelector("title")?.textContent === name)?.getAttribute("data-part") ?? null, moving);
      assert.ok(part !== null, `${moving} is not drawn`);
      const at = await grip(page, part);
      const before = await page.evaluate(() => window.cspace.classify(window.cspace.configuration()));
      if (at) {
        await page.mouse.move(at.x, at.y);
        await page.mouse.down();
        await page.mouse.move(at.x + 37, at.y - 23, { steps: 6 });
        await page.mouse.up();
        await settled(page);
      }
      const after = await page.evaluate(() => window.cspace.classify(window.cspace.configuration()));
      assert.ok(before === "blocked" || after !== "blocked", `${before} became ${after}`);
      // A part that is shrunk by little is computed again.
      await press(page, "Edit");
      await page.evaluate(() => {
        const offset = document.querySelector<HTMLInputElement>("#edit-offset");
        if (!offset) throw new Error("there is no field");
        offset.value = "0.0001";
        offset.dispatchEvent(new Event("change", { bubbles: true }));
      });
      await page.waitForFunction(() => / ms of /.test(document.getElementById("edit")?.textContent ?? "") || document.querySelector("#edit .said.bad") !== null, { timeout: PATIENCE });
      assert.equal(await page.evaluate(() => document.querySelector("#edit .said.bad")?.textContent ?? null), null);
      await press(page, "Edit");
      // There is a way out, or it is said why there is none.
      const isOut = await page.evaluate(() => [...document.querySelectorAll<HTMLButtonElement>("#ways button")].some((b) => b.textContent === "Way out" && !b.hidden));
      if (!isOut) return;
      await press(page, "Way out");
      assert.match(await answered(page, /^Looking for/), /played|no way out|never come apart|overlap here/);
    });
  }
});
