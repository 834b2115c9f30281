/** A model from nothing, as a student makes it: blank, a part, a second one that is dragged to its place, a verdict, and what is saved. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, drawn, exported, load, long, open, serve, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { button, click, downloaded, inBrowser, model, press, settled } from "./support.js";

describe("a model from nothing in a browser", { skip }, () => {
  const suite = inBrowser();

  /** Waits until the page shows so many parts, drawn. */
  async function shows(page: Page, count: number): Promise<void> {
    await page.waitForFunction((n) => "pair" in (window.cspace ?? {}) && document.querySelectorAll("#parts [data-part]").length === n, { timeout: PATIENCE }, count);
    await drawn(page);
    await settled(page);
  }

  const headline = (page: Page): Promise<string> => page.$eval(".headline", (e) => e.textContent ?? "");
  const wrong = (page: Page): Promise<string> => page.$eval("#making .bad", (e) => e.textContent ?? "");

  /** Clicks a button after which the page is loaded again. */
  const leave = (page: Page, text: string): Promise<void> => click(page, button(text));

  /** Types into the field of a label. */
  async function type(page: Page, label: string, text: string): Promise<void> {
    const field = await page.waitForSelector(`::-p-xpath(//section[@id="making"]//label[starts-with(normalize-space(), "${label}")]/input)`, { timeout: PATIENCE });
    await field?.evaluate((e) => (e as HTMLInputElement).select());
    await field?.type(text);
  }

  async function undo(page: Page, again = false): Promise<void> {
    await page.evaluate((shiftKey) => document.dispatchEvent(new KeyboardEvent("keydown", { key: "z", ctrlKey: true, shiftKey, bubbles: true })), again);
  }

  it("is shown by cspace view without a file, and may begin with a model of cspace new", async () => {
    const server = await serve(null);
    try {
      suite.opened = await load(suite.browser, server.address);
      const { page } = suite.opened;
      await shows(page, 0);
      assert.ok(await page.$("::-p-xpath(//button[.='Add part'])"));
      await press(page, "New");
      const offered = await page.$$eval("dialog.new > button", (all) => all.map((e) => e.textContent ?? ""));
      const kinds = ["latch", "cam", "gears", "geneva", "ratchet", "peg"].map((kind) => run(["new", kind]));
      assert.deepEqual(offered, kinds.map((text) => text.split("\n")[0]?.slice(2)));
      await leave(page, offered[1] ?? "");
      await shows(page, 2);
      assert.match(await headline(page), /^cam turns for ever, follower slides by 16 mm/);
      const client = await page.createCDPSession();
      await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
      await press(page, "Save model");
      assert.equal(readFileSync(await downloaded(join(suite.folder, "cam-and-follower.toml")), "utf8"), kinds[1]);
      await page.goBack({ timeout: PATIENCE });
      await shows(page, 0);
    } finally {
      server.stop();
    }
  });

  it("goes from blank over two parts to a verdict, and back", { skip: long }, async () => {
    suite.opened = await open(suite.browser, addressOf(exported(model("peg_hole"), suite.folder)));
    const { page } = suite.opened;
    await press(page, "New");
    await leave(page, "Blank");
    await shows(page, 0);
    // The first is fixed; a dimension that is none is refused in words.
    await type(page, "width", "-4");
    assert.equal(await wrong(page), "width: type a number greater than 0.");
    assert.ok(await page.$eval("::-p-xpath(//button[.='Add part'])", (b) => (b as HTMLButtonElement).disabled));
    await type(page, "width", "44");
    assert.equal(await wrong(page), "");
    await leave(page, "Add part");
    await shows(page, 1);
    // Its parameters are there at once, and it follows them.
    await type(page, "name", "part 1");
    assert.equal(await wrong(page), "There is a part with the name part 1: choose another.");
    await type(page, "name", "cam");
    await page.select("#making select", "slot");
    await page.select("#making label:last-of-type select", "revolute");
    await settled(page);
    // It is taken beside its pin, which goes with it.
    const field = (label: string) => page.$eval(`::-p-xpath(//section[@id="making"]//label[normalize-space()="${label}"]/input)`, (e) => Number((e as HTMLInputElement).value));
    const [x, y] = [await field("at x"), await field("at y")];
    const box = (await (await page.$(".part.new .drafted"))?.boundingBox())!;
    const [px, py] = [box.x + box.width / 6, box.y + box.height / 2];
    await page.mouse.move(px, py);
    await page.mouse.down();
    await page.mouse.move(px + 40, py - 60, { steps: 4 });
    await page.mouse.up();
    const [atX, atY] = [await field("at x"), await field("at y")];
    assert.ok(atX > x && atY > y, `${atX}, ${atY}`);
    assert.deepEqual([await field("pin x"), await field("pin y")], [atX, atY]);
    await leave(page, "Add part");
    await shows(page, 2);
    assert.match(await headline(page), /^cam turns /);
    const client = await page.createCDPSession();
    await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
    await press(page, "Save model");
    const file = await downloaded(join(suite.folder, "new-model.toml"));
    const text = readFileSync(file, "utf8");
    assert.match(text, /^width_1 = 44 # of the rectangle$/m);
    assert.ok(text.includes(`name = "cam"\nmotion = { type = "revolute", center = [${atX}, ${atY}] }\nplace = { at = [${atX}, ${atY}] }\n`), text);
    assert.match(run(["info", file]), /part 1 \(fixed\), cam \(moving\): fixed-axes/);
    // Undo takes the parts back one by one, and Redo brings them again.
    await undo(page);
    await shows(page, 1);
    await page.$eval("#design input[type=number]", (e) => {
      (e as HTMLInputElement).value = "31";
      e.dispatchEvent(new Event("change"));
    });
    await page.waitForFunction(() => document.querySelector("#design .said")?.textContent === "" && location.hash.includes("set="), { timeout: PATIENCE });
    await undo(page);
    await undo(page);
    await shows(page, 0);
    await undo(page, true);
    await shows(page, 1);
    await undo(page, true);
    await shows(page, 2);
    await press(page, "Parts");
    await click(page, "::-p-xpath(//button[@title='Remove part 1'])");
    await shows(page, 1);
    assert.deepEqual(await page.$$eval("#design .parameter b", (all) => all.map((e) => e.textContent)), ["length_2", "width_2"]);
  });
});
