/** What a change makes of a model: marks, A and B, vertices by keys; and what a record shows of itself. */

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, exported, long, open, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { click, downloaded, inBrowser, model, press, settled } from "./support.js";

describe("a page on which things are changed and compared", { skip }, () => {
  const suite = inBrowser();

  async function openFile(file: string, more: string[] = []): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(file, suite.folder, more)));
    return suite.opened.page;
  }

  async function latch(): Promise<Page> {
    const file = join(suite.folder, "latch.toml");
    writeFileSync(file, run(["new", "latch"]));
    return openFile(file);
  }

  const type = (page: Page, name: string, value: string) =>
    page.$eval(`#design input[type=number][aria-label^="${name},"]`, (e, value) => {
      (e as HTMLInputElement).value = value;
      e.dispatchEvent(new Event("change", { bubbles: true }));
    }, value);

  const valueOf = (page: Page, name: string) => page.$eval(`#design input[type=number][aria-label^="${name},"]`, (e) => Number((e as HTMLInputElement).value));

  it("finds where the bolt comes out, beyond the first range of the slider", async () => {
    const page = await latch();
    const slider = '#design input[type=range][aria-label="mouth"]';
    const ends = () => page.$eval(slider, (e) => [Number((e as HTMLInputElement).min), Number((e as HTMLInputElement).max)]);
    assert.deepEqual(await ends(), [4.5, 7.5]);
    assert.match(await page.$eval(slider, (e) => (e as HTMLElement).title), /width of the catch's mouth/);
    await type(page, "mouth", "8");
    await page.waitForFunction(() => document.querySelector(".found:not([hidden])")?.textContent === "Nothing changes in this range.", { timeout: PATIENCE });
    // By half of its width.
    assert.deepEqual(await ends(), [4.5, 9]);
    await type(page, "mouth", "9.5");
    await page.waitForFunction(() => /^from 9\.14601 on: bolt comes out/.test(document.querySelector(".found:not([hidden]) button")?.textContent ?? ""), { timeout: PATIENCE });
    assert.equal(await page.$$eval(".marks i", (all) => all.length), 1);
    await page.$eval(".found:not([hidden]) button", (e) => (e as HTMLElement).click());
    await settled(page);
    const solved = JSON.parse(run(["solve", join(suite.folder, "latch.toml"), "--vary", "mouth=4.5:11.25", "--so-that", "held = no", "--json"])) as { ranges: [number, number][] };
    assert.ok(Math.abs((await valueOf(page, "mouth")) - (solved.ranges[0]?.[0] ?? 0)) < 1e-8);
  });

  it("shows a kept state beside what follows, until Escape", async () => {
    const page = await latch();
    const compare = await page.waitForSelector('::-p-xpath(//button[normalize-space()="A | B" and not(@disabled)])', { timeout: PATIENCE });
    await compare?.click();
    await settled(page);
    assert.equal(await page.$$eval(".ghosts path", (all) => all.length), 2);
    await type(page, "mouth", "9.5");
    const cells = () => page.$$eval("#compare tr", (all) => Object.fromEntries(all.map((r) => [r.children[0]?.textContent ?? "", [...r.children].slice(1).map((c) => c.textContent ?? "")])));
    await page.waitForFunction(() => [...document.querySelectorAll("#compare tr")].some((r) => /^held.*no$/.test(r.textContent ?? "")), { timeout: PATIENCE });
    const told = await cells();
    assert.deepEqual(told["mouth"], ["6", "9.5"]);
    assert.deepEqual(told["held"]?.map((t) => t.slice(-3).trim()), ["yes", "no"]);
    assert.match(told["verdict"]?.[0] ?? "", /^bolt cannot leave: caged by right lip and left lip of catch/);
    assert.match(told["verdict"]?.[1] ?? "", /^bolt can leave/);
    await page.keyboard.press("Escape");
    await settled(page);
    assert.equal(await page.$$eval(".ghosts path, #compare:not([hidden])", (all) => all.length), 0);
  });

  it("plays a parameter from end to end, which is one change", { skip: long }, async () => {
    const page = await latch();
    const seen = new Set<number>();
    await click(page, '#design button[title="Play mouth from end to end"]');
    while (await page.$('::-p-xpath(//div[@id="design"]//button[normalize-space()="❚❚"] | //section[@id="design"]//button[normalize-space()="❚❚"])')) {
      seen.add(await valueOf(page, "mouth"));
      await settled(page);
    }
    assert.ok([...seen].some((x) => x > 4.5 && x < 7.5 && x !== 6), [...seen].join());
    await page.waitForFunction(() => (document.querySelector('#design input[type=number][aria-label^="mouth,"]') as HTMLInputElement).value === "7.5", { timeout: PATIENCE });
    await press(page, "Undo");
    assert.equal(await valueOf(page, "mouth"), 6);
  });

  it("moves vertices by keys, on a grid, and leaves Edit by Escape", { skip: long }, async () => {
    const page = await latch();
    await press(page, "Edit");
    await page.$eval(".handle.vertex", (e) => (e as unknown as HTMLElement).focus());
    await settled(page);
    const label = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "");
    assert.match(await label(), /^vertex 1 of catch at −10, −16/);
    await page.keyboard.press("ArrowRight");
    await settled(page);
    await settled(page);
    const x = Number(/at (\S+),/.exec(await label())?.[1]?.replace("−", "-"));
    assert.ok(x > -10 && x < -9 && Math.abs(100 * x - Math.round(100 * x)) < 1e-9, `${x}`);
    await page.keyboard.press("Escape");
    await settled(page);
    assert.equal(await page.$$eval(".handle", (all) => all.length), 0);
  });

  it("turns a part by two fingers", { skip: long }, async () => {
    const page = await latch();
    const at = await page.$eval('[data-part="1"] .outline', (e) => {
      const r = e.getBoundingClientRect();
      return { x: r.x + r.width / 2, y: r.y + r.height / 2 };
    });
    const client = await page.createCDPSession();
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...points: [number, number][]) =>
      client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    await touch("touchStart", [at.x, at.y]);
    await touch("touchStart", [at.x, at.y], [at.x + 80, at.y]);
    for (let i = 1; i <= 8; i += 1) await touch("touchMove", [at.x, at.y], [at.x + 80, at.y - 2 * i]);
    await settled(page);
    const { theta } = (await page.evaluate(() => window.cspace.configuration())) as { theta: number };
    await touch("touchEnd");
    // Upwards on the right is counter-clockwise; contacts may have stopped it before.
    assert.ok(theta > 0.02 && theta < 0.2, `${theta}`);
  });

  it("draws a record over its own time, traces a point, and saves what it draws", { skip: long }, async () => {
    const record = join(suite.folder, "run.json");
    const text = run(["simulate", model("ratchet_mechanism_dynamic"), "--time", "0.2", "--forces", "--json"]);
    writeFileSync(record, text);
    const { samples } = JSON.parse(text) as { samples: unknown[] };
    const page = await openFile(model("ratchet_mechanism_dynamic"), ["--with", record]);
    assert.equal(await page.$eval("#timeline .time-axis span:last-child", (e) => e.textContent), "0.2 s");
    assert.ok((await page.$$eval("#graphs b", (all) => all.map((e) => e.textContent))).includes("driver torque"));
    await press(page, "Trace");
    const at = await page.$eval('[data-part="1"] .outline', (e) => {
      const r = e.getBoundingClientRect();
      return { x: r.x + r.width / 2, y: r.y + 6 };
    });
    await page.mouse.click(at.x, at.y);
    await settled(page);
    assert.ok((await page.$eval(".trace", (e) => (e.getAttribute("d") ?? "").split("L").length)) > 20);
    await press(page, "Loop");
    const client = await page.createCDPSession();
    await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
    await press(page, "CSV");
    const lines = readFileSync(await downloaded(join(suite.folder, "run.csv")), "utf8").trimEnd().split("\r\n");
    assert.equal(lines.length, 1 + samples.length);
    // It goes on from the beginning.
    await page.click("#timeline .play");
    await new Promise((done) => setTimeout(done, 600));
    assert.equal(await page.$eval("#timeline .play", (e) => e.textContent), "❚❚");
    // A picture is light on a dark page, and says what it shows.
    await press(page, "Theme: auto");
    await press(page, "SVG");
    const picture = readFileSync(await downloaded(join(suite.folder, "ratchet-mechanism-with-masses.svg")), "utf8");
    assert.match(picture, /<rect [^>]*fill="rgb\(255, 255, 255\)"/);
    assert.match(picture, /<title>ratchet mechanism, with masses: pawl can leave/);
    assert.equal(await page.evaluate(() => document.documentElement.dataset["theme"]), "dark");
  });

  it("says why a button would do nothing", { skip: long }, async () => {
    const page = await openFile(model("ball_in_c"));
    const why = await page.$$eval("#ways button:disabled", (all) => all.map((e) => (e as HTMLElement).title));
    assert.deepEqual(why, ["Nothing moves by itself: the model has no drives, loads, springs or masses", "The selected pair is the whole mechanism"]);
  });
});
