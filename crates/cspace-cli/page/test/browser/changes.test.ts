/** What is changed of a model is kept, and what was computed before is not shown as right. */

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, drawn, exported, load, long, open, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { downloaded, inBrowser, press, settled } from "./support.js";

describe("changes of a model", { skip: skip || long }, () => {
  const suite = inBrowser();

  function latch(name: string): string {
    const path = join(suite.folder, `${name}.toml`);
    writeFileSync(path, run(["new", "latch"]));
    return addressOf(exported(path, suite.folder));
  }

  async function opened(address: string): Promise<Page> {
    await suite.opened?.page.close();
    suite.opened = await open(suite.browser, address);
    return suite.opened.page;
  }

  /** Gives the mouth a width, and waits for what follows from it. */
  async function widen(page: Page, width: string, verdict = /./): Promise<void> {
    const field = await page.waitForSelector('#design input[type=number][aria-label^="mouth,"]', { timeout: PATIENCE });
    await field?.click({ count: 3 });
    await field?.type(`${width}\n`);
    await says(page, verdict);
  }

  const says = (page: Page, verdict: RegExp) =>
    page.waitForFunction((text) => new RegExp(text).test(document.querySelector("#verdict")?.textContent ?? ""), { timeout: PATIENCE }, verdict.source);
  const mouth = (page: Page) => page.$eval('#design input[type=number][aria-label^="mouth,"]', (e) => (e as HTMLInputElement).value);
  const addressHas = (page: Page, text: string) => page.waitForFunction((text) => decodeURIComponent(location.hash).includes(text), { timeout: PATIENCE }, text);
  const [CAGED, FREE] = [/cannot leave/, /can leave/];

  it("make a way one of the model before: it is not played, and planned again", async () => {
    const page = await opened(latch("ways"));
    await widen(page, "9.5", FREE);
    await press(page, "Way out");
    await page.waitForSelector("#timeline:not([hidden])", { timeout: PATIENCE });
    const isStale = () => page.evaluate(() => document.body.classList.contains("stale"));
    assert.equal(await isStale(), false);
    await widen(page, "6");
    await page.waitForSelector("body.stale", { timeout: PATIENCE });
    assert.match(await page.$eval("#timeline", (e) => e.textContent ?? ""), /way out.*of the model before the change/);
    const places = () => page.evaluate(() => JSON.stringify(window.cspace.configuration()));
    const before = await places();
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.keyboard.press("Space");
    await settled(page);
    await settled(page);
    assert.equal(await places(), before);
    assert.equal(await page.$eval("#timeline .play", (e) => (e as HTMLButtonElement).disabled), true);
    // Of the same model it is right again.
    await press(page, "Undo");
    await page.waitForSelector("body:not(.stale)", { timeout: PATIENCE });
    await press(page, "Redo");
    await page.waitForSelector("body.stale", { timeout: PATIENCE });
    await press(page, "Plan again");
    await page.waitForFunction(() => document.querySelector("#message")?.textContent?.includes("There is no way out"), { timeout: PATIENCE });
    assert.equal(await page.$eval("#timeline", (e) => (e as HTMLElement).hidden), true);
  });

  it("are in the address, which opens to the same answer, and in the page that is saved", async () => {
    const address = latch("shared");
    let page = await opened(address);
    await says(page, CAGED);
    await widen(page, "9.5", FREE);
    await addressHas(page, "set=mouth=9.5");
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 0.5, theta: 0.01 }));
    await addressHas(page, "theta=0.01");
    const shared = await page.evaluate(() => location.hash);
    const client = await page.createCDPSession();
    await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
    await press(page, "Save page");
    const saved = await downloaded(join(suite.folder, "bolt-in-a-catch.html"));
    assert.ok(readFileSync(saved, "utf8").includes("Content-Security-Policy"));
    for (const again of [address + shared, addressOf(saved)]) {
      page = await opened(again);
      assert.match(await page.$eval("#verdict", (e) => e.textContent ?? ""), FREE);
      assert.equal(await mouth(page), "9.5");
      assert.deepEqual(await page.evaluate(() => window.cspace.configuration()), { x: 0, y: 0.5, theta: 0.01 });
      await press(page, "As in the file");
      await says(page, CAGED);
      assert.equal(await mouth(page), "6");
    }
    // Of another file nothing is taken.
    page = await opened(latch("other") + shared);
    assert.match(await page.$eval("#message", (e) => e.textContent ?? ""), /This address is of shared\.toml/);
    assert.equal(await mouth(page), "6");
  });

  it("are a draft that is offered when the file is opened again, and not left without a question", async () => {
    const address = latch("draft");
    let page = await opened(address);
    const questions: string[] = [];
    const answer = (page: Page) => page.on("dialog", (dialog) => (questions.push(dialog.type()), void dialog.accept()));
    answer(page);
    await widen(page, "9.5", FREE);
    await addressHas(page, "set=mouth=9.5");
    await page.goto("about:blank");
    assert.deepEqual(questions, ["beforeunload"]);
    page = await opened(address);
    assert.match(await page.$eval("#draft", (e) => e.textContent ?? ""), /mouth = 9\.5/);
    assert.equal(await mouth(page), "6");
    await press(page, "Go on with your changes");
    await says(page, FREE);
    await addressHas(page, "set=mouth=9.5");
    // The address has them as well.
    answer(page);
    await page.reload();
    await drawn(page);
    assert.equal(await mouth(page), "9.5");
    await press(page, "As in the file");
    await says(page, CAGED);
    page = await opened(address);
    assert.equal(await page.$("#draft"), null);
  });

  it("by a slider are taken back by the keyboard; and a script may wait from the beginning", async () => {
    suite.opened = await load(suite.browser, latch("keys"));
    const { page } = suite.opened;
    await page.evaluate("window.cspace.ready");
    await page.focus('#design input[type=range][aria-label="mouth"]');
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => (document.querySelector('#design input[type=number][aria-label^="mouth,"]') as HTMLInputElement).value !== "6", { timeout: PATIENCE });
    await page.keyboard.down("Control");
    await page.keyboard.press("z");
    await page.keyboard.up("Control");
    await page.waitForFunction(() => (document.querySelector('#design input[type=number][aria-label^="mouth,"]') as HTMLInputElement).value === "6", { timeout: PATIENCE });
  });
});
