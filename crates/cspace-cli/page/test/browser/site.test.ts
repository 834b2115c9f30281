/** The gallery from disk: found by words, opened, dragged, saved; and its lessons. */

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join } from "node:path";
import { before, describe, it } from "node:test";
import { PATIENCE, addressOf, drawn, load, long, open, skip } from "../../tools/harness.js";
import { writeSite } from "../support/site.js";
import { downloaded, inBrowser, model, press } from "./support.js";

/** The page's answer without what a card leaves out: what touches, what cages in detail, whose limits they are, and who drives whom. */
function short(headline: string): string {
  const said = headline
    .replace(/: it touches .*, and is not caged/, "")
    .replaceAll(" (its own limits)", "")
    .replace(/cannot leave: caged by (.* of )?/, "is caged by ")
    .replace(/^(.*) turns for ever and takes (.*) along; .*$/, "$2 and $1 turn together for ever.");
  return said.slice(0, 1).toUpperCase() + said.slice(1);
}

describe("the gallery opens from disk", { skip }, () => {
  const suite = inBrowser();
  const at = (name: string) => addressOf(join(suite.folder, "site", name));
  before(() => writeSite(join(suite.folder, "site"), long ? ["ball_in_c", "gears", "latch_box"].map(model) : []));

  it("is searched, and leads to a page that computes its space and leads back", async () => {
    suite.opened = await load(suite.browser, at("index.html"));
    const { page } = suite.opened;
    const left = () => page.$$eval("section:not([hidden]) li:not([hidden]) b", (all) => all.map((e) => e.textContent));
    assert.ok((await left()).length >= 3);
    await page.type("input", "caged ball");
    assert.deepEqual(await left(), ["ball in a C"]);
    assert.match(await page.$eval("li:not([hidden]) .verdict", (e) => e.textContent ?? ""), /^Ball is caged by clip\.$/);
    await Promise.all([page.waitForNavigation({ waitUntil: "load", timeout: PATIENCE }), page.click("li:not([hidden]) a")]);
    await drawn(page);
    assert.match(await page.$eval("#verdict .headline", (e) => e.textContent ?? ""), /^ball cannot leave: caged by clip/);
    assert.deepEqual(await page.evaluate(() => [0, 15, 60].map((x) => window.cspace.classify({ x, y: 0, theta: 0 }))), ["free", "blocked", "free"]);
    await Promise.all([page.waitForNavigation({ waitUntil: "load", timeout: PATIENCE }), page.click("#gallery a")]);
    assert.equal(await page.title(), "Mechanisms – cspace");
  });

  it("says of each mechanism what its page says", async () => {
    suite.opened = await load(suite.browser, at("index.html"));
    const cards = await suite.opened.page.$$eval("li", (all) =>
      all.map((e) => [e.querySelector("a")?.getAttribute("href") ?? "", e.querySelector(".verdict")?.textContent ?? ""] as const),
    );
    await suite.opened.page.close();
    for (const [file, verdict] of cards) {
      suite.opened = await open(suite.browser, at(file));
      const { page, faults } = suite.opened;
      // The order is found after the page is there.
      const words = verdict.startsWith("Comes apart") ? "All of it comes apart" : "";
      await page.waitForFunction((words) => document.querySelector("#verdict")?.textContent?.includes(words), { timeout: PATIENCE }, words);
      const said = await page.$eval("#verdict .headline", (e) => e.textContent ?? "");
      if (!words) assert.equal(short(said), verdict, file);
      assert.deepEqual(faults, [], file);
      await page.close();
    }
    suite.opened = null;
  });

  it("saves a page of its own as one file that is opened anywhere", async () => {
    suite.opened = await open(suite.browser, at("gears.html"));
    const { page } = suite.opened;
    const client = await page.createCDPSession();
    await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
    await press(page, "Save page");
    const saved = await downloaded(join(suite.folder, "gears.html"));
    assert.ok(!/<script src|id="gallery"/.test(readFileSync(saved, "utf8")));
    await page.close();
    suite.opened = await open(suite.browser, addressOf(saved));
    assert.match(await suite.opened.page.$eval("#verdict", (e) => e.textContent ?? ""), /pinion can leave/);
  });

  it("computes its space on any host, one that is called localhost too", async () => {
    const host = createServer((request, response) => {
      const file = join(suite.folder, "site", (request.url ?? "").slice(1));
      const types: Record<string, string> = { ".html": "text/html", ".js": "text/javascript" };
      if (!existsSync(file)) response.writeHead(404).end();
      else response.writeHead(200, { "content-type": types[extname(file)] ?? "text/plain" }).end(readFileSync(file));
    });
    await new Promise<void>((listening) => host.listen(0, "127.0.0.1", listening));
    try {
      suite.opened = await open(suite.browser, `http://localhost:${(host.address() as AddressInfo).port}/gears.html`);
      assert.match(await suite.opened.page.$eval("#verdict", (e) => e.textContent ?? ""), /pinion can leave/);
    } finally {
      host.close();
      host.closeAllConnections();
    }
  });

  it("asks before it answers", async () => {
    suite.opened = await load(suite.browser, at("teach.html"));
    const { page } = suite.opened;
    const caging = async (selector: string) => {
      await page.reload();
      const shown = () => page.$eval(".answer", (e) => (e.checkVisibility() ? (e.textContent ?? "") : null));
      assert.equal(await shown(), null);
      await page.click(`.lesson ${selector}`);
      return shown();
    };
    assert.match((await caging("button[data-right]")) ?? "", /^Right\. No\. Towards the mouth it goes 2\.48/);
    assert.match((await caging("button:not([data-right])")) ?? "", /^Not so\. No\./);
    await Promise.all([page.waitForNavigation({ waitUntil: "load", timeout: PATIENCE }), page.click(".lesson .answer a")]);
    await drawn(page);
    assert.deepEqual(await page.evaluate(() => window.cspace.pair()), ["clip", "ball"]);
  });
});
