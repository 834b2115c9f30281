/** What the page does where users go too far: zooms without end, wrong files, addresses by hand, shapes that are none. */

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, colours, exported, long, open, pictureOf, serve, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { inBrowser, model, press, settled } from "./support.js";


describe("the page at its limits", { skip }, () => {
  const suite = inBrowser();

  async function openModel(file: string, fragment = ""): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(file, suite.folder)) + fragment);
    return suite.opened.page;
  }

  async function openRecord(page: Page, name: string, text: string): Promise<void> {
    const file = join(suite.folder, name);
    writeFileSync(file, text);
    const [chooser] = await Promise.all([page.waitForFileChooser({ timeout: PATIENCE }), press(page, "Open")]);
    await chooser.accept([file]);
  }

  it("zooms in and out without end", async () => {
    const page = await openModel(model("geneva"));
    for (const pane of ["#parts", "#plane"]) {
      for (const deltaY of [-120, 120]) {
        const lines = await page.evaluate(
          async (of, turn) => {
            const view = document.querySelector(`${of} svg.viewport`);
            const r = view?.getBoundingClientRect();
            if (!view || !r) return [NaN];
            for (let i = 0; i < 600; i += 1) {
              view.dispatchEvent(new WheelEvent("wheel", { deltaY: turn, clientX: r.left + 20, clientY: r.top + 20, cancelable: true }));
            }
            return [...view.querySelectorAll(".grid")].map((e) => (e.getAttribute("d") ?? "").split("M").length - 1);
          },
          pane,
          deltaY,
        );
        assert.ok((lines[0] ?? NaN) < 200, `${pane}: ${lines[0]} lines`);
      }
    }
    assert.ok((await page.$$eval("#parts .grid-numbers text", (all) => all.length)) > 2);
  });

  it("refuses records of other models, and forgets them", async () => {
    const simulation = run(["simulate", model("geneva"), "--time", "0.1", "--every", "0.05", "--json"]);
    const plan = run(["plan", model("ball_in_c"), "--from", "60,0,0", "--to=-60,0,0", "--json"]);
    for (const [name, record, right] of [["ball_in_c", simulation, plan], ["geneva", plan, simulation]] as const) {
      const page = await openModel(model(name));
      const said = (): Promise<string> => page.$eval("#message:not([hidden])", (e) => e.textContent ?? "");
      await openRecord(page, "wrong.json", record);
      await page.waitForSelector("#message:not([hidden])", { timeout: PATIENCE });
      assert.match(await said(), /wrong\.json: the (model has no part|path is in)/);
      await openRecord(page, "large.json", '{"verdict": "path", "path": [[0, 0], [1e308, 0]]}');
      await page.waitForFunction(() => /large\.json/.test(document.querySelector("#message")?.textContent ?? ""), { timeout: PATIENCE });
      assert.match(await said(), /beyond what can be shown/);
      assert.equal(await page.$eval("#timeline", (e) => (e as HTMLElement).hidden), true);
      await openRecord(page, "right.json", right);
      await page.waitForSelector("#timeline:not([hidden])", { timeout: PATIENCE });
      assert.deepEqual(await page.$$eval("#timeline select[aria-label=Record] option", (all) => all.map((e) => e.textContent)), ["right.json"]);
      assert.equal(await page.$eval("#message", (e) => (e as HTMLElement).hidden), true);
      await suite.opened?.page.close();
    }
    suite.opened = null;
  });

  it("fetches pairs of edited parts that are chosen in quick succession", { skip: long }, async () => {
    const file = join(suite.folder, "stars.toml");
    writeFileSync(file, stars(4, 34));
    const server = await serve(file);
    try {
      suite.opened = await open(suite.browser, server.address);
      const { page } = suite.opened;
      await press(page, "Edit");
      await page.$eval("#edit-offset", (e) => {
        (e as HTMLInputElement).value = "0.02";
        e.dispatchEvent(new Event("change"));
      });
      for (const pair of ["1", "2", "3"]) {
        await page.select("#pair", pair);
        await new Promise((done) => setTimeout(done, 120));
      }
      for (const pair of ["3", "1", "2"]) {
        await page.select("#pair", pair);
        await page.waitForFunction(() => document.querySelector("#no-space:not([hidden]), #legend input"), { timeout: PATIENCE });
        assert.equal(await page.$eval("#no-space", (e) => ((e as HTMLElement).hidden ? "" : e.textContent)), "", `pair ${pair}`);
      }
    } finally {
      server.stop();
    }
  });

  it("shows parts that are drawn far from the origin", { skip: long }, async () => {
    const file = join(suite.folder, "far.toml");
    const drawn = (points: [number, number][]): string => `[${points.map(([x, y]) => `[${1e6 + x}, ${1e6 + y}]`).join(", ")}]`;
    const block = drawn([[0, 0], [20, 0], [20, 10], [15, 10], [15, 4], [5, 4], [5, 10], [0, 10]]);
    const peg = drawn([[7, 12], [13, 12], [13, 20], [7, 20]]);
    writeFileSync(file, `[[part]]\nname = "block"\nloops = [${block}]\n[[part]]\nname = "peg"\nloops = [${peg}]\n`);
    const page = await openModel(file, "#view=space");
    const numbers = (of: string): Promise<string[]> => page.$$eval(`${of} .grid-numbers text`, (all) => all.map((e) => e.textContent ?? ""));
    const across = (await numbers("#parts")).filter((text) => /^1000\d{3}/.test(text));
    assert.ok(across.length > 4, (await numbers("#parts")).join());
    // Once along each axis at most.
    for (const text of across) assert.ok(across.filter((other) => other === text).length <= 2, across.join());
    // The space is as wide as the parts are, and not as they are far away.
    const axisNumbers = (await page.$$eval(".space-labels span", (all) => all.map((e) => Number(e.textContent)))).filter((n) => !Number.isNaN(n));
    assert.ok(axisNumbers.length > 4 && axisNumbers.every((n) => Math.abs(n) < 100), axisNumbers.join());
    assert.ok(colours(await pictureOf(page, "#space canvas")) > 30);
    for (const theta of [0, 0.001, 0.5, -2]) {
      // Turned about the middle of the peg, which stays above the block.
      const [c, s] = [Math.cos(theta), Math.sin(theta)];
      const m = [1e6 + 10, 1e6 + 18] as const;
      await page.evaluate((at) => window.cspace.setConfiguration(at), { x: m[0] - (c * m[0] - s * m[1]), y: m[1] - (s * m[0] + c * m[1]), theta });
      await settled(page);
      const pane = await page.$eval("#slice", (e) => e.getBoundingClientRect().toJSON() as DOMRect);
      const curves = await page.$$eval("#slice .curve", (all) => all.map((e) => e.getBoundingClientRect().toJSON() as DOMRect));
      assert.ok(curves.length > 0);
      const [left, right] = [Math.min(...curves.map((r) => r.left)), Math.max(...curves.map((r) => r.right))];
      assert.ok(left < pane.right && right > pane.left && right - left > 20, JSON.stringify({ theta, left, right, pane }));
    }
  });

  it("follows addresses by hand, and back to what is as always", async () => {
    const page = await openModel(model("knee"), "#camera=1e300,1,1e300,1e308,0,0&x=1e300&y=1e300&theta=1e300");
    assert.ok(Object.values(await page.evaluate(() => window.cspace.configuration())).every((n) => Math.abs(n) < 1e4));
    const go = async (fragment: string): Promise<void> => {
      await page.evaluate((to) => { location.hash = to; }, fragment);
      await settled(page);
      await settled(page);
    };
    const pressed = (): Promise<string[]> => page.$$eval("#tools button[aria-pressed=true]", (all) => all.map((e) => e.textContent ?? ""));
    const usual = await pressed();
    await go("#theme=dark&stop=0&colours=kind&cut=1&x=1e12&y=-1e12&theta=1e12");
    assert.notDeepEqual(await pressed(), usual);
    assert.equal(await page.$eval("html", (e) => (e as HTMLElement).dataset["theme"]), "dark");
    await go("#x=0&y=-200&theta=0");
    assert.deepEqual(await pressed(), usual);
    assert.equal(await page.$eval("html", (e) => (e as HTMLElement).dataset["theme"]), "light");
    await go("#x=1e300&y=1e300&theta=1e300&camera=9e9,1,1,1,1,1");
  });

  it("takes only numbers for clearances, and radii for straight edges", { skip: long }, async () => {
    const server = await serve(model("peg_hole"));
    try {
      suite.opened = await open(suite.browser, server.address);
      const { page } = suite.opened;
      await press(page, "Edit");
      const clearance = (text: string): Promise<string> =>
        page.$eval("#edit-offset", (e, typed) => {
          (e as HTMLInputElement).value = typed;
          e.dispatchEvent(new Event("change"));
          return (e as HTMLInputElement).value;
        }, text);
      assert.equal(await clearance("0.01"), "0.01");
      const bad = (): Promise<string> => page.$$eval("#edit p.bad:not([hidden])", (all) => all.map((e) => e.textContent ?? "").join());
      for (const text of ["", "1e300"]) {
        assert.equal(await clearance(text), text);
        assert.match(await bad(), /clearance: type a number/);
      }
      // The answer to what was typed before says nothing else in its place, nor does leaving the field.
      await page.waitForFunction(() => /ms of 33 ms/.test(document.querySelector("#edit meter + p")?.textContent ?? ""), { timeout: PATIENCE });
      await settled(page);
      assert.match(await bad(), /clearance: type a number/);
      await clearance("0.01");
      assert.equal(await bad(), "");
      // The panel covers no handle.
      const [left, panel] = await page.$$eval("#left, #edit", (all) => all.map((e) => e.getBoundingClientRect()).map((r) => [r.left, r.right] as const));
      assert.ok(left && panel && panel[0] >= left[1], JSON.stringify({ left, panel }));
      // Some edge is straight: its field is empty, and a radius makes it an arc.
      const middles = await page.$$eval("#parts .handle.bulge", (all) =>
        all.map((e) => { const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2] as const; }),
      );
      const field = (): Promise<string | null> => page.evaluate(() => document.querySelector<HTMLInputElement>("#edit label:not([for]) input")?.value ?? null);
      for (const [x, y] of middles) {
        await page.mouse.click(x, y);
        await settled(page);
        if ((await field()) === "") break;
      }
      assert.equal(await field(), "");
      const outline = (): Promise<string> => page.$$eval("#parts .outline", (all) => all.map((e) => e.getAttribute("d")).join());
      const straight = await outline();
      await page.type("#edit label:not([for]) input", "1000\n");
      await settled(page);
      assert.equal(Number(await field()).toFixed(6), "1000.000000");
      assert.notEqual(await outline(), straight);
    } finally {
      server.stop();
    }
  });

  it("marks the last valid space of a shape that crosses itself", async () => {
    const server = await serve(model("ball_in_c"));
    try {
      suite.opened = await open(suite.browser, server.address);
      const { page } = suite.opened;
      await press(page, "Edit");
      const outdated = (): Promise<boolean> => page.evaluate(() => document.body.classList.contains("outdated"));
      assert.equal(await outdated(), false);
      const places = await page.$$eval("#parts .handle.vertex", (all) =>
        all.map((e) => { const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2] as [number, number]; }),
      );
      const [from, , , to] = places;
      assert.ok(from && to);
      await page.mouse.move(...from);
      await page.mouse.down();
      // Through the far corner: edges cross.
      await page.mouse.move(2 * to[0] - from[0], 2 * to[1] - from[1], { steps: 6 });
      await page.waitForFunction(() => document.body.classList.contains("outdated"), { timeout: PATIENCE });
      assert.match(await page.$eval("#readout", (e) => e.textContent ?? ""), /last valid shape/);
      await page.mouse.move(...from, { steps: 6 });
      await page.mouse.up();
      await page.waitForFunction(() => !document.body.classList.contains("outdated"), { timeout: PATIENCE });
      assert.doesNotMatch(await page.$eval("#readout", (e) => e.textContent ?? ""), /last valid shape/);
    } finally {
      server.stop();
    }
  });
});

/** A model of star-shaped parts with many points. */
function stars(parts: number, points: number): string {
  const star = (k: number): string =>
    Array.from({ length: 2 * points }, (_, i) => {
      const [radius, angle] = [i % 2 === 0 ? 10 + k : 7 + k, (Math.PI * (i + 0.1 * k)) / points];
      return `[${radius * Math.cos(angle)}, ${radius * Math.sin(angle)}]`;
    }).join(", ");
  return Array.from({ length: parts }, (_, k) => `[[part]]\nname = "star ${k}"\nloops = [[${star(k)}]]\n`).join("\n");
}
