/** What users do with a drawing on the page, served or dropped: pick faces, name parts, save the model, open it. */

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import type { DrawingScene } from "../../src/drawing/scene.js";
import { PATIENCE, addressOf, drawn, exported, load, long, open, root, serve, skip } from "../../tools/harness.js";
import { binary, run } from "../support/command.js";
import { downloaded, drop, inBrowser, model, press, settled } from "./support.js";

const DRAWINGS = join(root, "crates/cspace-drawing/tests/drawings");

/**
 * A frame of 30 by 10 whose sides go beyond its corners, divided at x = 12 and x = 20, with a hole of radius 2 in its left part; its
 * corner is at (at, at), and a unit is so long.
 */
function frame(at = 0, unit = 1): string {
  const p = (x: number): number => at + unit * x;
  const line = (a: number, b: number, c: number, d: number): string => `0\nLINE\n8\n0\n10\n${p(a)}\n20\n${p(b)}\n11\n${p(c)}\n21\n${p(d)}\n`;
  const lines = [
    line(-3, 0, 33, 0),
    line(-3, 10, 33, 10),
    ...[0, 12, 20, 30].map((x) => line(x, -3, x, 13)),
  ];
  return `0\nSECTION\n2\nENTITIES\n${lines.join("")}0\nCIRCLE\n8\n0\n10\n${p(6)}\n20\n${p(5)}\n40\n${2 * unit}\n0\nENDSEC\n0\nEOF\n`;
}

describe("a drawing on the page in a browser", { skip }, () => {
  const suite = inBrowser();

  async function opened(more: string[] = [], text = frame()): Promise<{ page: Page; file: string; stop: () => void }> {
    const file = join(suite.folder, "frame.dxf");
    writeFileSync(file, text);
    const server = await serve(file, more);
    suite.opened = await load(suite.browser, server.address);
    await suite.opened.page.waitForSelector(".face", { timeout: PATIENCE });
    await settled(suite.opened.page);
    return { page: suite.opened.page, file, stop: server.stop };
  }

  const scene = (page: Page): Promise<DrawingScene> => page.$eval("#scene", (e) => JSON.parse(e.textContent ?? "") as DrawingScene);
  const parts = (page: Page): Promise<string[]> => page.$$eval("#picked-parts li .faint", (all) => all.map((e) => e.textContent ?? ""));
  const command = (page: Page): Promise<string> => page.$eval("#command pre", (e) => e.textContent ?? "");

  /** Clicks the face of which a point in the drawing is. */
  async function click(page: Page, x: number, y: number): Promise<void> {
    const at = await page.$eval("g.drawing", (e, x, y) => {
      // Where the drawing's middle is, and in which unit it is drawn.
      const [x0, y0, unit] = ["data-x", "data-y", "data-unit"].map((name) => Number(e.getAttribute(name))) as [number, number, number];
      const p = new DOMPoint((x - x0) / unit, (y - y0) / unit).matrixTransform((e as SVGGElement).getScreenCTM() ?? undefined);
      return [p.x, p.y] as [number, number];
    }, x, y);
    await page.mouse.click(...at);
    await settled(page);
  }

  /** Waits until the page shows a model of a name, drawn. */
  async function shows(page: Page, name: string): Promise<void> {
    await page.waitForFunction((name) => "pair" in (window.cspace ?? {}) && document.getElementById("model-name")?.textContent === name, { timeout: PATIENCE }, name);
    await drawn(page);
  }

  /** The parts that are picked, once there are any. */
  async function picked(page: Page): Promise<string[]> {
    await page.waitForSelector("#picked-parts li", { timeout: PATIENCE });
    return parts(page);
  }

  it("shows the faces, each of which a click makes a part", async () => {
    const { page, stop } = await opened();
    try {
      const areas = (await scene(page)).faces.map((f) => f.area);
      const expected = [120 - 4 * Math.PI, 100, 80, 4 * Math.PI];
      assert.equal(areas.length, expected.length);
      areas.forEach((area, i) => assert.ok(Math.abs(area - (expected[i] ?? 0)) < 1e-9, `${areas.join(", ")}`));
      assert.deepEqual(await parts(page), []);
      await click(page, 25, 5);
      await click(page, 1, 5);
      // The hole is a face of its own.
      assert.deepEqual(await parts(page), ["1 face, 100", "1 face, 107.434"]);
      await page.keyboard.down("Shift");
      await click(page, 6, 5);
      assert.deepEqual(await parts(page), ["1 face, 100", "2 faces, 120"]);
      await click(page, 6, 5);
      await page.keyboard.up("Shift");
      assert.deepEqual(await parts(page), ["1 face, 100", "1 face, 107.434"]);
      // A drag pans, and beside the frame is nothing.
      await click(page, 16, 12);
      assert.equal((await parts(page)).length, 2);
      // The address has the picks.
      await page.reload({ waitUntil: "load", timeout: PATIENCE });
      assert.deepEqual(await picked(page), ["1 face, 100", "1 face, 107.434"]);
      await press(page, "Clear");
      assert.deepEqual(await parts(page), []);
    } finally {
      stop();
    }
  });

  it("picks what is under the pointer far from the origin, and of any size", { skip: long }, async () => {
    for (const [at, unit] of [[5e6, 1], [3e8, 10], [0, 1e-5], [1e3, 1e-3]] as const) {
      const { page, stop } = await opened([], frame(at, unit));
      try {
        for (const [x, y] of [[25, 5], [6, 5], [1, 5], [16, 5]] as const) await click(page, at + unit * x, at + unit * y);
        const areas = (await parts(page)).map((text) => Number(text.split(", ")[1]?.replace("−", "-")) / (unit * unit));
        [100, 4 * Math.PI, 120 - 4 * Math.PI, 80].forEach((area, i) => assert.ok(Math.abs((areas[i] ?? 0) / area - 1) < 0.01, `${at}, ${unit}: ${areas.join(", ")}`));
      } finally {
        stop();
        await suite.opened?.page.close();
      }
    }
    suite.opened = null;
  });

  it("tells what is left out because it is open, and how wide its gap is", { skip: long }, async () => {
    const corners = [[40, 0], [50, 0], [50, 10], [40, 10], [40, 0.2]] as const;
    const sides = corners.slice(1).map(([x, y], i) => `0\nLINE\n8\n0\n10\n${corners[i]?.[0]}\n20\n${corners[i]?.[1]}\n11\n${x}\n21\n${y}\n`);
    const text = frame().replace("0\nENDSEC", `${sides.join("")}0\nENDSEC`);
    const first = await opened([], text);
    try {
      assert.equal(await first.page.$eval("#face-count", (e) => e.textContent), "4 faces");
      const said = await first.page.$eval("#message span", (e) => e.textContent ?? "");
      assert.match(said, /^Left out, since it bounds no face: LINE .*is open: its ends are 0\.2 from the nearest.*--join 0\.202/);
    } finally {
      first.stop();
      await first.page.close();
    }
    const { page, stop } = await opened(["--join", "0.202"], text);
    try {
      assert.equal(await page.$eval("#face-count", (e) => e.textContent), "5 faces");
      assert.equal(await page.$eval("#message", (e) => (e as HTMLElement).hidden), true);
    } finally {
      stop();
    }
  });

  it("adds faces without Shift where that is switched on", async () => {
    const { page, stop } = await opened();
    try {
      await click(page, 25, 5);
      await press(page, "Add faces");
      await click(page, 16, 5);
      assert.deepEqual(await parts(page), ["2 faces, 180"]);
    } finally {
      stop();
    }
  });

  it("saves the model that the command makes of the same picks", async () => {
    const { page, stop } = await opened(["--scale", "0.5"]);
    try {
      const client = await page.createCDPSession();
      await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
      await click(page, 8, 2.5);
      await page.keyboard.down("Shift");
      await click(page, 12, 2.5);
      await page.keyboard.up("Shift");
      await click(page, 1, 1);
      await page.focus("#picked-parts li:nth-child(1) input");
      await page.keyboard.down("Control");
      await page.keyboard.press("a");
      await page.keyboard.up("Control");
      await page.keyboard.type("bar's end");
      const line = await command(page);
      assert.match(line, /^cspace import .*frame\.dxf --scale 0\.5 --pick 'bar'\\''s end=[-\d.]+,[-\d.]+;[-\d.]+,[-\d.]+' --pick 'part 2=[-\d.]+,[-\d.]+' -o frame\.toml$/);
      await press(page, "Save model");
      const saved = readFileSync(await downloaded(join(suite.folder, "frame.toml")), "utf8");
      const done = spawnSync("sh", ["-c", line.replace("-o frame.toml", "-o other.toml")], {
        cwd: suite.folder,
        env: { ...process.env, PATH: `${dirname(binary() ?? "")}:${process.env["PATH"]}` },
        encoding: "utf8",
      });
      assert.equal(done.status, 0, done.stderr);
      assert.equal(saved, readFileSync(join(suite.folder, "other.toml"), "utf8"));
      assert.match(run(["info", join(suite.folder, "frame.toml")]), /bar's end/);
    } finally {
      stop();
    }
  });

  it("opens the parts and their spaces, and goes back to the picks", { skip: long }, async () => {
    const { page, stop } = await opened();
    try {
      await click(page, 25, 5);
      await click(page, 6, 5);
      await page.click("::-p-xpath(//button[normalize-space()='Show motion'])");
      await shows(page, "frame");
      assert.deepEqual(await page.evaluate(() => window.cspace.pair()), ["part 1", "part 2"]);
      // A disc of radius 2 beside the square, as drawn.
      assert.equal(await page.evaluate(() => window.cspace.classify({ x: 0, y: 0, theta: 0 })), "free");
      assert.equal(await page.evaluate(() => window.cspace.classify({ x: 12.1, y: 0, theta: 0 })), "blocked");
      // Loaded again, it is the model still.
      await page.reload({ waitUntil: "load", timeout: PATIENCE });
      await shows(page, "frame");
      assert.deepEqual(await page.evaluate(() => window.cspace.pair()), ["part 1", "part 2"]);
      await page.goBack({ timeout: PATIENCE });
      assert.deepEqual(await picked(page), ["1 face, 100", "1 face, 12.5664"]);
      await page.goForward({ timeout: PATIENCE });
      await shows(page, "frame");
    } finally {
      stop();
    }
  });

  describe("dropped onto a page from a file", () => {
    /** A page that was exported, onto which a file is dropped. */
    async function dropped(name: string, bytes: Buffer): Promise<Page> {
      suite.opened = await open(suite.browser, addressOf(exported(model("peg_hole"), suite.folder)));
      const { page } = suite.opened;
      await drop(page, name, bytes);
      return page;
    }

    /** What the page says of a file, once it is read. */
    async function refused(page: Page): Promise<string> {
      await page.waitForFunction(() => /^[^…]+$/.test(document.querySelector("#message:not([hidden]) span")?.textContent ?? ""), { timeout: PATIENCE });
      return page.$eval("#message span", (e) => e.textContent ?? "");
    }

    it("is picked and opened without a server, and Back leads to the picks and to the first model", async () => {
      const page = await dropped("frame.dxf", Buffer.from(frame()));
      await page.waitForSelector(".face", { timeout: PATIENCE });
      await settled(page);
      assert.equal(await page.$eval("#face-count", (e) => e.textContent), "4 faces");
      await click(page, 25, 5);
      await click(page, 6, 5);
      assert.match(await command(page), /^cspace import frame\.dxf --pick /);
      await page.click("::-p-xpath(//button[normalize-space()='Show motion'])");
      await shows(page, "frame");
      assert.deepEqual(await page.evaluate(() => window.cspace.pair()), ["part 1", "part 2"]);
      assert.equal(await page.evaluate(() => window.cspace.classify({ x: 0, y: 0, theta: 0 })), "free");
      assert.equal(await page.evaluate(() => window.cspace.classify({ x: 12.1, y: 0, theta: 0 })), "blocked");
      await page.goBack({ timeout: PATIENCE });
      assert.deepEqual(await picked(page), ["1 face, 100", "1 face, 12.5664"]);
      await page.goBack({ timeout: PATIENCE });
      await shows(page, "peg in hole");
    });

    it("saves the model that the command makes", { skip: long }, async () => {
      const svg = readFileSync(join(DRAWINGS, "styles.svg"));
      const page = await dropped("styles.svg", svg);
      const client = await page.createCDPSession();
      await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
      await picked(page);
      await press(page, "Clear");
      for (const face of [0, 1]) {
        await page.$eval(`.face[data-face="${face}"]`, (e) => (e as SVGElement).focus());
        await page.keyboard.press("Enter");
      }
      const line = await command(page);
      await press(page, "Save model");
      const saved = readFileSync(await downloaded(join(suite.folder, "styles.toml")), "utf8");
      writeFileSync(join(suite.folder, "styles.svg"), svg);
      const done = spawnSync("sh", ["-c", line.replace("-o styles.toml", "-o told.toml")], {
        cwd: suite.folder,
        env: { ...process.env, PATH: `${dirname(binary() ?? "")}:${process.env["PATH"]}` },
        encoding: "utf8",
      });
      assert.equal(done.status, 0, done.stderr);
      assert.equal(saved, readFileSync(join(suite.folder, "told.toml"), "utf8"));
    });

    it("has the parts picked that import makes, until they are taken back", async () => {
      const name = "styles.svg";
      const file = join(DRAWINGS, name);
      const page = await dropped(name, readFileSync(file));
      const names = (): Promise<string[]> => page.$$eval("#picked-parts input", (all) => all.map((e) => (e as HTMLInputElement).value));
      await picked(page);
      const model = JSON.parse(run(["import", file, "--json"])) as { parts: { name: string }[] };
      assert.ok(model.parts.length > 1);
      assert.deepEqual(await names(), model.parts.map((p) => p.name));
      await press(page, "Clear");
      await page.reload({ waitUntil: "load", timeout: PATIENCE });
      await page.waitForSelector(".face", { timeout: PATIENCE });
      assert.deepEqual(await names(), []);
    });

    it("is refused as by the command, and the page stays", async () => {
      const bad = frame().replace("10\n-3\n", "10\nthree\n");
      const page = await dropped("bad.dxf", Buffer.from(bad));
      const message = await refused(page);
      const file = join(suite.folder, "bad.dxf");
      writeFileSync(file, bad);
      const done = spawnSync(binary() ?? "cspace", ["view", file, "--no-open"], { encoding: "utf8" });
      assert.equal(done.status, 2, done.stdout);
      const [, error, help] = /^error: (.*)\n {2}help: (.*)\n$/.exec(done.stderr) ?? [];
      assert.equal(message, `${error?.replace(file, "bad.dxf")} (${help})`);
      assert.deepEqual(await page.evaluate(() => window.cspace.pair()), ["block", "peg"]);
    });

    it("says that other files are neither models nor drawings", { skip: long }, async () => {
      const page = await dropped("frame.dxf", Buffer.from(frame()));
      await page.waitForSelector(".face", { timeout: PATIENCE });
      await drop(page, "notes.txt", Buffer.from("x"));
      assert.match(await refused(page), /notes\.txt is neither a model \(\.toml\) nor a drawing/);
    });
  });

  it("refuses two parts of one name", async () => {
    const { page, stop } = await opened();
    try {
      await click(page, 25, 5);
      await click(page, 6, 5);
      await page.focus("#picked-parts li:nth-child(1) input");
      await page.keyboard.press("Backspace");
      await page.keyboard.type("2");
      await press(page, "Save model");
      assert.match(await page.$eval("#message", (e) => e.textContent ?? ""), /name part 2/);
    } finally {
      stop();
    }
  });
});
