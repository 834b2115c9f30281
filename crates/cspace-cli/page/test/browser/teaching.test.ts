/** What the page tells and shows of itself: the verdict, the lens, names, graphs, hints, distances; and that its views stay where they are. */

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import type { PlanarConfiguration } from "../../src/kernel/api.js";
import { PATIENCE, addressOf, exported, load, drawn, long, open, serve, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { click, inBrowser, model, press, resting, settled } from "./support.js";

/** The lens, and the play that is told, follow after so long (ms). */
const PAUSE = 400;

const paused = (): Promise<void> => new Promise((done) => setTimeout(done, PAUSE));

describe("the page that tells", { skip }, () => {
  const suite = inBrowser();

  async function openModel(file: string, fragment = "", more: string[] = []): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(file, suite.folder, more)) + fragment);
    return suite.opened.page;
  }

  const textOf = (page: Page, selector: string): Promise<string> => page.$eval(selector, (e) => e.textContent ?? "");

  it("says in words whether the part can leave, and how much play it has", async () => {
    const page = await openModel(model("ball_in_c"));
    const place = async (x: number): Promise<string> => {
      await page.evaluate((at) => window.cspace.setConfiguration({ x: at, y: 0, theta: 0 }), x);
      await settled(page);
      await paused();
      return `${await textOf(page, "#answer")}${await textOf(page, "#play")}`;
    };
    // The command has the same regions by the same numbers.
    const regions = run(["compute", model("ball_in_c")]);
    assert.match(regions, /outside +open/);
    assert.match(regions, /pocket 1 +caged/);
    // A ball of radius 10 in a bore of radius 12: by Pythagoras, 2 above and below the middle.
    assert.match(await place(0), /^Can the ball leave the clip\?ball cannot leave: caged by clip\..*4 mm along y; without shifting it turns all the way round/);
    assert.match(await place(60), /ball can leave/);
    assert.match(await place(15), /overlap/);
    assert.deepEqual(await page.$$eval("#legend label", (all) => all.map((e) => e.textContent)), ["outside", "pocket 1"]);
  });

  it("shows a pocket that its mark covers in a lens, and fits the view to it", async () => {
    const page = await openModel(model("snap_fastener"), "#view=slice");
    await page.keyboard.press("f");
    await paused();
    const lens = (): Promise<string | null> => page.$eval("#slice .lens", (e) => e.getAttribute("visibility"));
    assert.equal(await lens(), null);
    assert.match(await textOf(page, "#slice .lens-text"), /^0\.\d+ mm wide$/);
    await click(page, '#legend [aria-label="Fit to pocket 1"]');
    await paused();
    assert.equal(await lens(), "hidden");
    const width = await page.$$eval("#slice .curve", (all) => Math.max(...all.map((e) => e.getBoundingClientRect().width)));
    assert.ok(width > 150, `the pocket is ${width} pixels wide`);
  });

  it("has the names of parts on them", { skip: long }, async () => {
    const page = await openModel(model("snap_fastener"));
    assert.deepEqual((await page.$$eval("#parts .part-names text", (all) => all.map((e) => e.textContent ?? ""))).sort(), ["catch", "hook"]);
  });

  it("steps from band to band without overlap", { skip: long }, async () => {
    const page = await openModel(model("snap_fastener"), "#view=space");
    const bandOf = async (): Promise<number> => Number(/band (\d+) of/.exec(await textOf(page, "#theta .band-text"))?.[1]);
    const pair = (await page.evaluate(() => window.cspace.pair())).join();
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 0.05, theta: -0.001 }));
    await settled(page);
    const rows: PlanarConfiguration[] = [];
    for (let i = 0; i < 12; i += 1) {
      const before = await bandOf();
      await page.keyboard.press("PageDown");
      await settled(page);
      const after = await bandOf();
      const message = await page.$eval("#message", (e) => ((e as HTMLElement).hidden ? "" : (e.textContent ?? "")));
      assert.ok(after !== before || /turns no further/.test(message), `band ${before} to ${after}: ${message}`);
      rows.push((await page.evaluate(() => window.cspace.configuration())) as PlanarConfiguration);
    }
    const table = `x,y,theta\n${rows.map(({ x, y, theta }) => `${x},${y},${theta}`).join("\n")}\n`;
    const told = run(["classify", model("snap_fastener"), "--pair", pair], table).trim().split("\n").slice(1);
    assert.equal(told.length, rows.length);
    assert.ok(told.every((row) => !row.endsWith("blocked")), told.join("\n"));
    // From the pocket it does not come out by itself.
    assert.match(await textOf(page, "#verdict"), /cannot leave: caged by catch/);
  });

  it("keeps every view in its place while a part is dragged into contact", { skip: long }, async () => {
    const page = await openModel(model("snap_fastener"), "#view=space");
    const places = (): Promise<string> =>
      page.$$eval("#parts, #space, #slice, #answer, #play, #legend, #readout, #theta", (all) => JSON.stringify(all.map((e) => { const { x, y, width, height } = e.getBoundingClientRect(); return e.id === "readout" ? { x, y, width } : { x, y, width, height }; })));
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 20, theta: 0 }));
    await settled(page);
    const apart = await places();
    const touching = await textOf(page, "#readout .touching-list");
    // As it is drawn, four features touch.
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 0, theta: 0 }));
    await settled(page);
    await paused();
    assert.notEqual(await textOf(page, "#readout .touching-list"), touching);
    assert.equal(await places(), apart);
  });

  it("has its room on a phone", async () => {
    const record = join(suite.folder, "run.json");
    writeFileSync(record, run(["simulate", model("geneva"), "--time", "0.3", "--every", "0.01", "--json"]));
    const size = { width: 390, height: 844, isMobile: true, hasTouch: true };
    for (const [name, more, panes] of [
      ["ball_in_c", [], ["#parts", "#slice", "#verdict .headline", ".theta-slider", "#tools"]],
      ["geneva", ["--with", record], ["#parts", "#plane", "#verdict .headline", "#timeline .track input", "#tools"]],
    ] as const) {
      suite.opened = await load(suite.browser, addressOf(exported(model(name), suite.folder, [...more])), size);
      const { page } = suite.opened;
      await drawn(page);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= size.width, name);
      for (const pane of panes) {
        const box = await (await page.$(pane))?.boundingBox();
        assert.ok(box && box.width > 150 && box.height > 14 && box.x >= 0 && box.x + box.width <= size.width && box.y + box.height <= size.height, `${name} ${pane}: ${JSON.stringify(box)}`);
      }
      await page.close();
    }
    suite.opened = null;
  });

  it("draws coordinates over the time of a record, with a cursor that sets it", async () => {
    const record = join(suite.folder, "turns.json");
    const text = run(["simulate", model("geneva"), "--time", "0.5", "--every", "0.01", "--json"]);
    writeFileSync(record, text);
    const { samples } = JSON.parse(text) as { samples: Record<string, number>[] };
    const page = await openModel(model("geneva"), "", ["--with", record]);
    assert.deepEqual(await page.$$eval("#graphs .strip b", (all) => all.map((e) => e.textContent)), ["wheel", "driver"]);
    const plot = await resting(page, "#graphs .plot", 1);
    await page.mouse.click(plot.x + plot.width - 0.5, plot.y + 8);
    await settled(page);
    const last = ((samples.at(-1)?.["driver"] ?? NaN) * 180) / Math.PI;
    const shown = Number.parseFloat((await page.$$eval("#graphs .strip output", (all) => all.map((e) => e.textContent ?? "")))[1] ?? "");
    assert.ok(Math.abs(shown - last) < 0.02 * Math.abs(last), `${shown} for ${last}`);
  });

  it("gives hints until they are dismissed", { skip: long }, async () => {
    const page = await openModel(model("knee"));
    assert.equal(await page.$eval("#hints", (e) => (e as HTMLElement).hidden), false);
    await click(page, "#hints button");
    assert.equal(await page.$eval("#hints", (e) => (e as HTMLElement).hidden), true);
  });

  it("measures distances that follow the parts", async () => {
    const page = await openModel(model("ball_in_c"));
    await press(page, "Measure");
    const click = async (x: number, y: number): Promise<void> => {
      const at = await page.$eval(
        "#parts svg.viewport",
        (e, [px, py]) => {
          const r = e.getBoundingClientRect();
          const [a = 1, , , d = 1, tx = 0, ty = 0] = (e.querySelector("g")?.getAttribute("transform") ?? "").match(/-?\d[\d.e+-]*/g)?.map(Number) ?? [];
          return [r.x + a * px + tx, r.y + d * py + ty] as const;
        },
        [x, y] as const,
      );
      await page.mouse.click(...at);
      await settled(page);
    };
    const s = Math.SQRT1_2;
    await click(-10 * s, 10 * s);
    assert.equal(await textOf(page, ".dimension-text"), "radius 10 mm");
    await click(-12 * s, -12 * s);
    assert.equal(await textOf(page, ".dimension-text"), "2 mm");
    // The half of the ball above its diameter: nearest straight up to the left.
    await page.evaluate(() => window.cspace.setConfiguration({ x: -1, y: 0, theta: 0 }));
    await settled(page);
    assert.equal(await textOf(page, ".dimension-text"), "1 mm");
  });

  it("adds and removes vertices, and keeps radii while a corner is moved", async () => {
    const server = await serve(model("peg_hole"));
    try {
      suite.opened = await open(suite.browser, server.address);
      const { page } = suite.opened;
      await press(page, "Edit");
      await settled(page);
      const places = (kind: string): Promise<[number, number][]> =>
        page.$$eval(`#parts .handle.${kind}`, (all) => all.map((e) => { const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2] as [number, number]; }));
      const before = await places("vertex");
      // The ends of a straight side whose handles are apart.
      const sides = before.slice(1).map((b, i) => [before[i]!, b] as const);
      const side = sides.find(([a, b]) => Math.abs(a[1] - b[1]) < 1 && Math.abs(a[0] - b[0]) > 60);
      assert.ok(side);
      const [a, b] = side;
      await page.mouse.click((2 * a[0] + b[0]) / 3, (2 * a[1] + b[1]) / 3, { count: 2 });
      await settled(page);
      assert.equal((await places("vertex")).length, before.length + 1);
      await page.keyboard.press("Delete");
      await settled(page);
      assert.equal((await places("vertex")).length, before.length);
      await page.waitForFunction(() => /ms of 33 ms/.test(document.querySelector("#edit meter + p")?.textContent ?? ""), { timeout: PATIENCE });
    } finally {
      server.stop();
    }
  });
});
