/** What users do with the page: drag, slide, step, play, edit, save. */

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import { PNG } from "pngjs";
import type { ElementHandle, Page } from "puppeteer-core";
import type { AxesConfiguration, Configuration, PlanarConfiguration } from "../../src/kernel/api.js";
import {
  PATIENCE,
  addressOf,
  colours,
  difference,
  exported,
  launch,
  long,
  open,
  pictureOf,
  root,
  serve,
  skip,
} from "../../tools/harness.js";
import { run } from "../support/command.js";
import { spaceOf } from "../../tools/space-picture.js";
import { click, downloaded, inBrowser, model, press, settled } from "./support.js";

/** A page without its data has fewer bytes. */
const LARGEST_PAGE = 3.4e6;

const planar = async (page: Page): Promise<PlanarConfiguration> => (await configuration(page)) as PlanarConfiguration;
const axes = async (page: Page): Promise<AxesConfiguration> => (await configuration(page)) as AxesConfiguration;

function configuration(page: Page): Promise<Configuration> {
  return page.evaluate(() => window.cspace.configuration());
}

/** What the command says of a configuration. */
function told(file: string, pair: string, c: Configuration): string {
  const [header, row] = [Object.keys(c), Object.values(c)].map((all: unknown[]) => all.join(","));
  const lines = run(["classify", file, "--pair", pair], `${header}\n${row}\n`).trim().split("\n");
  return lines.at(-1)?.split(",").at(-1) ?? "";
}

describe("the page in a browser", { skip }, () => {
  const suite = inBrowser();

  async function openModel(name: string, more: string[] = [], fragment = ""): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(model(name), suite.folder, more)) + fragment);
    return suite.opened.page;
  }

  it("is small, and needs no other file", async () => {
    const file = exported(model("knee"), suite.folder);
    const text = readFileSync(file, "utf8");
    const scene = /<script[^>]*id="scene"[^>]*>[^]*?<\/script>/.exec(text)?.[0] ?? "";
    assert.ok(scene.length > 1000);
    assert.ok(Buffer.byteLength(text) - Buffer.byteLength(scene) < LARGEST_PAGE);
    const page = await openModel("knee");
    const fetched = await page.evaluate(() => performance.getEntriesByType("resource").map((e) => e.name));
    assert.deepEqual(fetched.filter((name) => !name.startsWith("blob:") && !name.startsWith("data:")), []);
  });

  it("draws the space, and turns it", async () => {
    const page = await openModel("knee");
    assert.equal(await page.$("#space canvas"), null);
    await press(page, "Space");
    const first = await pictureOf(page, "#space canvas");
    assert.ok(colours(first) > 30, `${colours(first)} colours`);
    const box = await boxOf(page, "#space canvas");
    // The lower left corner is beside the surface and the point.
    await drag(page, [box.x + 30, box.y + box.height - 30], [box.x + 130, box.y + box.height - 60]);
    await settled(page);
    assert.ok(difference(first, await pictureOf(page, "#space canvas")) > 0.02);
  });

  it("shows spaces as the gallery has them", async () => {
    /** Fonts differ from machine to machine, and text is little of a picture. */
    const TEXT = 0.03;
    for (const name of long === false ? ["knee", "peg_hole", "geneva", "cam_tappet"] : ["knee", "geneva"]) {
      const { picture } = await spaceOf(suite.browser, exported(model(name), suite.folder));
      const kept = readFileSync(join(root, `docs/gallery/${name}.png`));
      const differing = difference(PNG.sync.read(picture), PNG.sync.read(kept));
      assert.ok(differing < TEXT, `${name}: ${differing} of the pixels differ: if that is meant, make the gallery again`);
    }
  });

  it("moves the part with the pointer, on either side", async () => {
    const page = await openModel("knee");
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: -150, theta: 0.3 }));
    await page.keyboard.press("f");
    await settled(page);
    const before = await planar(page);
    const slice = await pictureOf(page, "#slice");
    const grip = await middleOf(page, "#parts .part.moving .outline");
    await drag(page, grip, [grip[0] + 40, grip[1] + 10]);
    const moved = await planar(page);
    assert.ok(moved.x > before.x && moved.y < before.y, JSON.stringify(moved));
    assert.equal(moved.theta, before.theta);
    // As far as the pointer, by the scale of the picture.
    assert.ok(Math.abs((moved.x - before.x) / (before.y - moved.y) - 4) < 0.3, JSON.stringify({ before, moved }));
    await settled(page);
    assert.ok(difference(slice, await pictureOf(page, "#slice")) > 0);
    // Back by the point in the slice: the other side.
    const point = await middleOf(page, "#slice .point");
    await drag(page, point, [point[0] - 30, point[1]]);
    const back = await planar(page);
    assert.ok(back.x < moved.x && Math.abs(back.y - moved.y) < 1e-6 * Math.abs(moved.y) + 1, JSON.stringify(back));
  });

  it("moves the part with a finger", async () => {
    const page = await openModel("knee");
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: -150, theta: 0 }));
    await page.keyboard.press("f");
    await settled(page);
    const before = await planar(page);
    const [x, y] = await middleOf(page, "#parts .part.moving .outline");
    await page.touchscreen.touchStart(x, y);
    for (let i = 1; i <= 8; i++) {
      await page.touchscreen.touchMove(x + 5 * i, y);
    }
    await page.touchscreen.touchEnd();
    await settled(page);
    assert.ok((await planar(page)).x > before.x + 1e-3);
  });

  it("turns the part with the wheel and with keys", async () => {
    const page = await openModel("knee");
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: -200, theta: 0 }));
    await page.keyboard.press("f");
    await settled(page);
    const [x, y] = await middleOf(page, "#parts .part.moving .outline");
    await page.mouse.move(x, y);
    await page.mouse.wheel({ deltaY: 120 });
    await settled(page);
    const turned = (await planar(page)).theta;
    assert.notEqual(turned, 0);
    await page.keyboard.press("q");
    await settled(page);
    assert.ok(Math.abs((await planar(page)).theta - turned - Math.PI / 180) < 1e-9);
    await page.keyboard.press("ArrowRight");
    await settled(page);
    assert.notEqual((await planar(page)).x, 0);
  });

  it("stops at contact and slides along it, and passes through where that is switched off", async () => {
    const page = await openModel("peg_hole");
    const pair = (await page.evaluate(() => window.cspace.pair())).join();
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 60, theta: 0.1 }));
    await page.keyboard.press("f");
    await settled(page);
    const height = (await boxOf(page, "#parts")).height;
    let touched = 0;
    const grip = await middleOf(page, "#parts .part.moving .outline");
    await page.mouse.move(...grip);
    await page.mouse.down();
    for (let i = 1; i <= 40; i++) {
      await page.mouse.move(grip[0] + 3 * i, grip[1] + (height / 50) * i);
      await settled(page);
      const c = await planar(page);
      const is = await page.evaluate((at) => window.cspace.classify(at), c);
      assert.notEqual(is, "blocked");
      if (i % 8 === 0) {
        assert.notEqual(told(model("peg_hole"), pair, c), "blocked", JSON.stringify(c));
      }
      if (is === "contact") {
        touched += 1;
        const marks = await page.$$eval("#parts .marks .normal", (all) => all.length);
        const touching = await page.evaluate(() => window.cspace.touching());
        assert.equal(marks, touching.length);
        assert.ok(touching.length > 0);
      }
    }
    assert.ok(touched > 5, `${touched} places in contact`);
    await page.mouse.up();
    await page.keyboard.press("s");
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 60, theta: 0.1 }));
    await settled(page);
    const held = await middleOf(page, "#parts .part.moving .outline");
    // As far down as 60, by the scale of the grid: the peg is then across the wall of its hole.
    const scale = await page.$eval("#parts svg.viewport > g", (e) => Number(/matrix\(([^ ,]+)/.exec(e.getAttribute("transform") ?? "")?.[1]));
    await drag(page, held, [held[0], held[1] + 60 * scale]);
    assert.ok(Math.abs((await planar(page)).y) < 1);
    assert.equal(await page.evaluate(() => window.cspace.classify(window.cspace.configuration())), "blocked");
  });

  it("slides pairs on fixed axes", async () => {
    const page = await openModel("cam_tappet");
    const pair = (await page.evaluate(() => window.cspace.pair())).join();
    let touched = 0;
    for (let i = 0; i < 90; i++) {
      await page.keyboard.press(i % 3 === 0 ? "ArrowDown" : "ArrowRight");
      await settled(page);
      const c = await axes(page);
      const is = await page.evaluate((at) => window.cspace.classify(at), c);
      assert.notEqual(is, "blocked");
      if (is === "contact") {
        touched += 1;
        assert.equal(told(model("cam_tappet"), pair, c), "contact", JSON.stringify(c));
      }
    }
    assert.ok(touched > 3, `${touched} places in contact`);
    assert.ok((await axes(page)).u > 1);
  });

  it("steps through bands", async () => {
    const page = await openModel("knee", [], "#view=space");
    const text = (): Promise<string> => page.$eval("#theta .band-text", (e) => e.textContent ?? "");
    const band = async (): Promise<number> => Number(/band (\d+) of/.exec(await text())?.[1]);
    const all = Number(/band \d+ of (\d+)/.exec(await text())?.[1]);
    const scene = (JSON.parse(run(["compute", model("knee"), "--json"])) as { pairs: { bands: number }[] }).pairs;
    assert.equal(all, scene[0]?.bands);
    const first = await band();
    await page.keyboard.press("s");
    await page.keyboard.press("PageUp");
    await settled(page);
    assert.equal(await band(), (first % all) + 1);
    await page.click('#theta button[aria-label^="Previous"]');
    await settled(page);
    assert.equal(await band(), first);
  });

  it("hides regions, and colours patches by kind", async () => {
    const page = await openModel("fixture_plate", [], "#view=space");
    const first = await pictureOf(page, "#space canvas");
    await click(page, "#legend input[type=checkbox]");
    await settled(page);
    const hidden = await pictureOf(page, "#space canvas");
    assert.ok(difference(first, hidden) > 0.01);
    await click(page, "#legend input[type=checkbox]");
    await settled(page);
    assert.ok(difference(first, await pictureOf(page, "#space canvas")) < 0.002);
    await click(page, "#details summary");
    await press(page, "Kinds");
    assert.ok(difference(first, await pictureOf(page, "#space canvas")) > 0.01);
    assert.match(await page.$eval("#legend", (e) => e.textContent ?? ""), /arc/);
  });

  it("keeps its state in the address", async () => {
    const page = await openModel("ratchet_mechanism", [], "#theme=dark");
    await page.evaluate(() => window.cspace.select("ratchet", "pawl"));
    await page.evaluate(() => window.cspace.setConfiguration({ x: 1, y: 90, theta: 0.25 }));
    await page.waitForFunction(() => location.hash.includes("theta=0.25"), { timeout: PATIENCE });
    const address = page.url();
    const dark = await pictureOf(page, "#parts");
    await suite.opened?.page.close();
    suite.opened = await open(suite.browser, address);
    assert.deepEqual(await suite.opened.page.evaluate(() => window.cspace.pair()), ["ratchet", "pawl"]);
    assert.deepEqual(await planar(suite.opened.page), { x: 1, y: 90, theta: 0.25 });
    assert.equal(await suite.opened.page.$eval("html", (e) => e.dataset["theme"]), "dark");
    await press(suite.opened.page, "Theme: dark");
    assert.ok(difference(dark, await pictureOf(suite.opened.page, "#parts")) > 0.5);
  });

  it("plays planned ways and simulations", async () => {
    const plan = join(suite.folder, "plan.json");
    writeFileSync(plan, run(["plan", model("ball_in_c"), "--from", "60,0,0", "--to=-60,0,0", "--json"]));
    let page = await openModel("ball_in_c", ["--with", plan]);
    await end(page);
    const last = await planar(page);
    assert.ok(Math.hypot(last.x + 60, last.y) < 1e-9, JSON.stringify(last));
    await suite.opened?.page.close();

    const simulation = join(suite.folder, "simulation.json");
    writeFileSync(simulation, run(["simulate", model("geneva"), "--time", "0.5", "--every", "0.01", "--json"]));
    const record = JSON.parse(readFileSync(simulation, "utf8")) as { samples: Record<string, number>[]; events: unknown[] };
    page = await openModel("geneva", ["--with", simulation]);
    assert.equal(await page.$$eval("#timeline .ticks i", (all) => all.length), record.events.length);
    await end(page);
    const [fixed, moving] = await page.evaluate(() => window.cspace.pair());
    const { u, v } = await axes(page);
    const sample = record.samples.at(-1);
    assert.ok(Math.abs(u - (sample?.[fixed] ?? NaN)) < 1e-9 && Math.abs(v - (sample?.[moving] ?? NaN)) < 1e-9, JSON.stringify({ u, v, sample }));
    // By itself as well.
    await page.evaluate(() => {
      const scrub = document.querySelector<HTMLInputElement>("#timeline input[type=range]");
      if (scrub) {
        scrub.value = "0";
        scrub.dispatchEvent(new Event("input"));
      }
    });
    const begin = await axes(page);
    await page.click("#timeline .play");
    await page.waitForFunction((from) => JSON.stringify(window.cspace.configuration()) !== from, { timeout: PATIENCE }, JSON.stringify(begin));
  });

  it("says what is wrong with a record", async () => {
    const page = await openModel("geneva");
    const record = join(suite.folder, "no-record.json");
    writeFileSync(record, '{"verdict": 1}');
    const [chooser] = await Promise.all([page.waitForFileChooser({ timeout: PATIENCE }), press(page, "Open")]);
    await chooser.accept([record]);
    await page.waitForSelector("#message:not([hidden])", { timeout: PATIENCE });
    assert.match(await page.$eval("#message", (e) => e.textContent ?? ""), /no-record\.json/);
  });

  it("saves pictures", async () => {
    const page = await openModel("knee", [], "#view=space");
    const client = await page.createCDPSession();
    await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
    await press(page, "SVG");
    const svg = readFileSync(await downloaded(join(suite.folder, "knee.svg")), "utf8");
    assert.match(svg, /<svg[^>]+viewBox/);
    assert.match(svg, /<path[^>]+ d="M/);
    // The letters may be anywhere in the encoded picture of the 3-D view.
    assert.doesNotMatch(svg.replaceAll(/data:[^"]*/g, ""), /NaN/);
    await press(page, "PNG");
    const png = PNG.sync.read(readFileSync(await downloaded(join(suite.folder, "knee.png"))));
    assert.ok(png.width >= 1440 && colours(png) > 50, `${png.width} wide, ${colours(png)} colours`);
  });

  it("can be read at every width", { skip: long }, async () => {
    for (const [width, height] of [
      [1024, 700],
      [3840, 2160],
    ] as const) {
      suite.opened = await open(suite.browser, `${addressOf(exported(model("snap_fastener"), suite.folder))}#view=space`, { width, height });
      const over = await suite.opened.page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      assert.ok(over <= 0, `${over} pixels too wide at ${width}`);
      for (const pane of ["#parts", "#space", "#slice", "#theta", "#verdict"]) {
        const box = await boxOf(suite.opened.page, pane);
        assert.ok(box.width > 100 && box.height > 15 && box.y + box.height <= height + 1, `${pane} at ${width}: ${JSON.stringify(box)}`);
      }
      await suite.opened.page.close();
    }
    suite.opened = null;
  });

  it("shows the slice where there is no WebGL", async () => {
    const plain = await launch(join(suite.folder, "plain"), ["--disable-gpu", "--disable-software-rasterizer", "--disable-3d-apis"]);
    try {
      const { page } = await open(plain, `${addressOf(exported(model("knee"), suite.folder))}#view=space`);
      assert.match(await page.$eval("#message", (e) => e.textContent ?? ""), /WebGL/);
      assert.ok((await boxOf(page, "#slice")).height > 300);
    } finally {
      await plain.close();
    }
  });

  it("is served with spaces as they are asked for, and shows the same as the file", async () => {
    const server = await serve(model("gears_on_shafts"));
    try {
      suite.opened = await open(suite.browser, server.address);
      const served = await pictureOf(suite.opened.page, "#plane");
      await suite.opened.page.close();
      const page = await openModel("gears_on_shafts");
      assert.ok(difference(served, await pictureOf(page, "#plane")) < 0.002);
    } finally {
      server.stop();
    }
  });

  it("edits parts while the space follows, undoes it, and saves the model", async () => {
    const server = await serve(model("ball_in_c"));
    try {
      suite.opened = await open(suite.browser, server.address);
      const { page } = suite.opened;
      const client = await page.createCDPSession();
      await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
      await press(page, "Edit");
      const patches = (): Promise<string> => page.$eval("#pair-class", (e) => e.textContent ?? "");
      const regions = (): Promise<number> => page.$$eval("#legend input[type=checkbox]", (all) => all.length);
      const said = (): Promise<string> => page.$eval("#announce", (e) => e.textContent ?? "");
      const before = await patches();
      assert.equal(await regions(), 2);
      // A ball that is smaller by 4 gets out of the mouth: the caged region is one with that outside.
      await page.$eval("#edit-offset", (e) => {
        (e as HTMLInputElement).value = "6";
        e.dispatchEvent(new Event("change"));
      });
      await page.waitForFunction(() => document.querySelectorAll("#legend input[type=checkbox]").length === 1, { timeout: PATIENCE });
      assert.notEqual(await said(), "");
      assert.match(await page.$eval("#edit meter + p", (e) => e.textContent ?? ""), /\d ms of 33 ms/);
      await page.keyboard.down("Control");
      await page.keyboard.press("z");
      await page.keyboard.up("Control");
      await page.waitForFunction(() => document.querySelectorAll("#legend input[type=checkbox]").length === 2, { timeout: PATIENCE });
      assert.equal(await patches(), before);

      // A vertex of the fixed part is dragged: the drawing follows the pointer, the space the drawing.
      await press(page, "Fit");
      const handle = (await page.$$("#parts .handle.vertex"))[0] as ElementHandle;
      const at = await middle(handle);
      const slice = await pictureOf(page, "#slice");
      await drag(page, at, [at[0] - 25, at[1] - 25]);
      await settled(page);
      await page.waitForFunction(() => !/nothing/.test(document.querySelector("#edit meter + p")?.textContent ?? ""), { timeout: PATIENCE });
      assert.ok(difference(slice, await pictureOf(page, "#slice")) > 0);
      await press(page, "Save model");
      const saved = await downloaded(join(suite.folder, readdirToml()));
      assert.notEqual(run(["compute", saved]), run(["compute", model("ball_in_c")]));
      // What was not edited is as it was written: all above the outlines.
      const [written, asWas] = [saved, model("ball_in_c")].map((file) => readFileSync(file, "utf8").split("loops")[0] ?? "") as [string, string];
      assert.ok(asWas.includes("# Ball of diameter 20") && written === asWas, written);
      // The page and the command agree on the edited model.
      const pair = (await page.evaluate(() => window.cspace.pair())).join();
      for (let k = 0; k < 40; k++) {
        const c = { x: -40 + 2 * k, y: 13 - 0.6 * k, theta: 0.1 * k };
        assert.equal(await page.evaluate((x) => window.cspace.classify(x), c), told(saved, pair, c));
      }
    } finally {
      server.stop();
    }

    function readdirToml(): string {
      return "ball-in-a-C.toml";
    }
  });
});

async function boxOf(page: Page, selector: string): Promise<{ x: number; y: number; width: number; height: number }> {
  const box = await (await page.$(selector))?.boundingBox();
  assert.ok(box, `${selector} is not shown`);
  return box;
}

async function middle(element: ElementHandle): Promise<[number, number]> {
  const box = await element.boundingBox();
  assert.ok(box);
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** A place inside an element: its middle, or beside it if that is not filled. */
async function middleOf(page: Page, selector: string): Promise<[number, number]> {
  const found = await page.evaluate((of) => {
    const element = document.querySelector(of);
    const box = element?.getBoundingClientRect();
    if (!element || !box) {
      return null;
    }
    const own = element.closest("g");
    for (const [s, t] of [[0.5, 0.5], [0.5, 0.3], [0.5, 0.7], [0.3, 0.5], [0.7, 0.5], [0.4, 0.2], [0.6, 0.8], [0.5, 0.1], [0.5, 0.9]] as const) {
      const at: [number, number] = [box.x + s * box.width, box.y + t * box.height];
      const hit = document.elementFromPoint(...at);
      if (hit && own?.contains(hit)) {
        return at;
      }
    }
    return [box.x + box.width / 2, box.y + box.height / 2] as [number, number];
  }, selector);
  assert.ok(found, `${selector} is not there`);
  return found;
}

async function drag(page: Page, from: [number, number], to: [number, number]): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 8 });
  await settled(page);
  await page.mouse.up();
  await settled(page);
}

/** Scrubs the time line to its end. */
async function end(page: Page): Promise<void> {
  await page.$eval("#timeline input[type=range]", (e) => {
    const scrub = e as HTMLInputElement;
    scrub.value = scrub.max;
    scrub.dispatchEvent(new Event("input"));
  });
  await settled(page);
}
