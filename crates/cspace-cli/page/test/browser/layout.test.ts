/** That everything on the page can be reached at every size, and what is said over its views. */

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, drawn, exported, load, long, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { drop, inBrowser, model, press, settled } from "./support.js";

/** A desktop, a small one, a phone, and the desktop at 200 %. */
const SIZES = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844, isMobile: true, hasTouch: true },
  { width: 720, height: 450, deviceScaleFactor: 2 },
] as const;

describe("the page at every size", { skip: skip || long }, () => {
  const suite = inBrowser();

  async function at(size: (typeof SIZES)[number], file: string): Promise<Page> {
    await suite.opened?.page.close();
    suite.opened = await load(suite.browser, addressOf(exported(file, suite.folder)), size);
    await drawn(suite.opened.page);
    return suite.opened.page;
  }

  /** Elements that a pointer does not get once they are scrolled to, with what is in the way. */
  const covered = (page: Page, selector: string): Promise<string[]> =>
    page.$$eval(selector, (all) =>
      all.flatMap((e) => {
        if (!e.checkVisibility()) return [];
        e.scrollIntoView({ block: "center", inline: "center" });
        // A script scrolls what no user can.
        for (let p = e.parentElement; p; p = p.parentElement) {
          if (getComputedStyle(p).overflowY === "hidden") p.scrollTop = 0;
          if (getComputedStyle(p).overflowX === "hidden") p.scrollLeft = 0;
        }
        const r = e.getBoundingClientRect();
        if (r.width * r.height === 0) return [];
        const over = document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2);
        return e.contains(over) ? [] : [`${e.tagName} ${e.textContent} ${e.id} under ${over?.tagName} ${over?.id}`];
      }),
    );

  const headline = "#verdict .headline";

  it("lets everything be reached, while a model is edited too, with the verdict in sight", async () => {
    const latch = join(suite.folder, "latch.toml");
    run(["new", "latch", "-o", latch]);
    for (const size of SIZES) {
      const page = await at(size, latch);
      const all = "#tools button, #pair, #theta button, #side button, #side input, #side select, #side summary, #side output";
      assert.deepEqual(await covered(page, all), [], `${size.width}`);
      await page.$$eval("#tools button", (buttons) => (buttons.find((b) => b.textContent === "Edit") as HTMLElement).click());
      await settled(page);
      assert.equal(await page.$$eval("#edit .buttons button, #changes button", (e) => e.length), 6);
      assert.deepEqual(await covered(page, all), [], `${size.width}, edited`);
      await page.$eval("#side", (e) => e.scrollTo(0, e.scrollHeight));
      assert.deepEqual(await covered(page, headline), [], `${size.width}, verdict`);
      for (const element of await page.$$("#side, #readout")) assert.ok((await element.boundingBox())?.height, `${size.width}`);
      const cut = await page.$eval("#verdict", (e) => [e, ...e.children].some((x) => x.scrollHeight > x.clientHeight + 1 && getComputedStyle(x).display !== "contents"));
      assert.equal(cut, false, `${size.width}: the verdict is cut`);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= size.width);
    }
  });

  it("has its tools in one row, that of the record in another, however long the title is", async () => {
    const [titled, record] = ["titled.toml", "run.json"].map((name) => join(suite.folder, name)) as [string, string];
    writeFileSync(titled, readFileSync(model("geneva"), "utf8").replace(/^name = .*$/m, 'name = "A Geneva drive whose title is longer than any bar has room for beside its tools"'));
    run(["simulate", titled, "--time", "2", "-o", record]);
    const file = addressOf(exported(titled, suite.folder, ["--with", record]));
    for (const size of [...SIZES, { width: 830, height: 700 }]) {
      suite.opened = await load(suite.browser, file, size);
      const { page } = suite.opened;
      await drawn(page);
      const rows = (selector: string): Promise<number> => page.$$eval(selector, (all) => new Set(all.map((e) => e.getBoundingClientRect()).filter((r) => r.width > 0).map((r) => Math.round((r.top + r.bottom) / 2 / 4))).size);
      assert.deepEqual([await rows("#tools button"), await rows("#timeline > :is(button, select)")], [1, 1], `${size.width}`);
      assert.ok((await page.$eval("#bar", (e) => e.clientHeight)) < 80, `${size.width}`);
      assert.deepEqual(await covered(page, "#tools button, #timeline button"), [], `${size.width}`);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= size.width, `${size.width}`);
      // What is beyond the edge is announced by a fade.
      const isFading = await page.$eval("#tools", (e) => getComputedStyle(e).maskImage.includes("gradient"));
      assert.ok(isFading, `${size.width}`);
      await page.close();
      suite.opened = null;
    }
  });

  it("opens on the question, the answer, and large parts, on the pocket of what is caged; and on the surface where that is asked for", async () => {
    const latch = join(suite.folder, "latch.toml");
    run(["new", "latch", "-o", latch]);
    const area = (page: Page, selector: string): Promise<number> => page.$eval(selector, (e) => e.clientWidth * e.clientHeight);
    for (const size of SIZES) {
      const page = await at(size, latch);
      const { height } = await page.$eval("#answer", (e) => ({ height: e.getBoundingClientRect().height }));
      assert.ok(height > 20 && height < size.height / 5, `${size.width}: ${height}`);
      assert.deepEqual(await page.$$eval("#question, #verdict .headline", (all) => all.map((e) => e.textContent)), ["Does the bolt come out?", "bolt cannot leave: caged by right lip and left lip of catch."]);
      assert.ok((await area(page, "#parts")) > 1.4 * (await area(page, "#slice")), `${size.width}`);
      assert.deepEqual(await page.$$eval("#space canvas, #theta button:not([hidden])", (all) => all.length), 0);
      // The pocket is as wide and high as the bolt has room in it: by 2 and 2, of a window that shows little else.
      const [pane, pocket] = await page.$eval("#slice", (e) => [e, ...e.querySelectorAll(".curve")].slice(0, 2).map((x) => x.getBoundingClientRect()).map((r) => [r.width, r.height]));
      assert.ok(Math.max(pocket![0]! / pane![0]!, pocket![1]! / pane![1]!) > 0.4, `${size.width}: ${JSON.stringify({ pane, pocket })}`);
      // Both lips, among what cages it.
      assert.ok((await page.$$eval("#parts .part.fixed .reason-edge, #parts .part.fixed .reason-vertex", (all) => all.length)) >= 4);
      await page.$$eval("#tools button", (all) => (all.find((b) => b.textContent === "Space") as HTMLElement).click());
      await page.waitForFunction(() => location.hash.includes("view=space"), { timeout: PATIENCE });
      assert.ok((await area(page, "#space")) > 10_000, `${size.width}`);
      assert.deepEqual(await page.$$eval("#legend input", (all) => all.map((e) => (e as HTMLInputElement).checked)), [false, true]);
      const address = page.url();
      await suite.opened?.page.close();
      suite.opened = await load(suite.browser, address, size);
      await drawn(suite.opened.page);
      assert.ok((await area(suite.opened.page, "#space canvas")) > 10_000, `${size.width}`);
    }
    const page = await at(SIZES[0], model("latch_box"));
    await page.waitForFunction(() => /first bolt, then lid, then block/.test(document.querySelector("#verdict")?.textContent ?? ""), { timeout: PATIENCE });
  });

  it("says what stopped a drag of the mechanism where the verdict is", async () => {
    for (const size of SIZES) {
      const page = await at(size, model("shift_interlock"));
      await page.$$eval("#ways button", (all) => (all.find((b) => b.textContent === "Push all parts") as HTMLElement).click());
      await settled(page);
      const pull = async (part: string, by: number): Promise<void> => {
        const place = await page.$$eval("[data-part]", (all, name) => {
          const outline = all.find((e) => e.querySelector("title")?.textContent === name)?.querySelector(".outline");
          const r = outline?.getBoundingClientRect() ?? new DOMRect();
          // A place on the part that nothing covers.
          for (let i = 1; i < 20; i += 1) {
            for (let k = 1; k < 20; k += 1) {
              const [x, y] = [r.x + (i * r.width) / 20, r.y + (k * r.height) / 20];
              if (document.elementFromPoint(x, y) === outline) return { x, y };
            }
          }
          return null;
        }, part);
        assert.ok(place, part);
        await page.mouse.move(place.x, place.y);
        await page.mouse.down();
        await page.mouse.move(place.x + by, place.y, { steps: 6 });
      };
      const first = (): Promise<string | null | undefined> => page.$$eval("[data-part]", (all) => all.find((e) => e.querySelector("title")?.textContent === "first rail")?.getAttribute("transform"));
      const begin = await first();
      await pull("first rail", 60);
      while ((await first()) === begin) await settled(page);
      await page.mouse.up();
      await pull("second rail", 60);
      await page.waitForFunction(() => /Stopped: /.test(document.querySelector("#verdict .held")?.textContent ?? ""), { timeout: PATIENCE });
      // While it is still dragged.
      assert.deepEqual(await covered(page, "#verdict .held p"), [], `${size.width}`);
      await page.mouse.up();
      assert.doesNotMatch(await page.$eval("#verdict", (e) => e.textContent ?? ""), /Only these two parts count/);
    }
  });

  it("tells notes, answers, progress and errors apart, and none of them lies on the toolbar", async () => {
    const message = (page: Page) =>
      page.waitForSelector("#message:not([hidden])", { timeout: PATIENCE }).then(() =>
        page.$eval("#message", (e) => ({ kind: e.className, role: e.getAttribute("role"), top: e.getBoundingClientRect().top, bar: document.getElementById("bar")?.getBoundingClientRect().bottom ?? NaN })),
      );
    for (const size of SIZES) {
      const page = await at(size, model("ball_in_c"));
      await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 0, theta: 0 }));
      await page.$$eval("#ways button", (all) => (all.find((b) => b.textContent === "Way out") as HTMLElement).click());
      await page.waitForFunction(() => document.getElementById("message")?.className === "answer", { timeout: PATIENCE });
      const answer = await message(page);
      assert.equal(answer.role, "status");
      assert.ok(answer.top >= answer.bar, JSON.stringify(answer));
      await drop(page, "note.txt", Buffer.from("hello"));
      await page.waitForFunction(() => document.getElementById("message")?.className === "error", { timeout: PATIENCE });
      const error = await message(page);
      assert.equal(error.role, "alert");
      assert.ok(error.top >= error.bar, JSON.stringify(error));
      assert.match(await page.$eval("#message", (e) => e.textContent ?? ""), /note\.txt: a model .* is expected/);
      await page.click('#message [aria-label="Close the message"]');
      await settled(page);
      assert.equal(await page.$eval("#message", (e) => (e as HTMLElement).hidden), true);
    }
    const page = await at(SIZES[0], model("peg_hole"));
    await press(page, "Play mechanism");
    const progress = await message(page);
    assert.deepEqual([progress.kind, progress.role], ["progress", "status"]);
    await press(page, "Cancel");
    await new Promise((done) => setTimeout(done, 500));
    assert.equal(await page.$eval("#message", (e) => (e as HTMLElement).hidden), true);
    assert.equal(await page.$eval("#timeline", (e) => (e as HTMLElement).hidden), true);
    // What is asked afterwards is answered.
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: 5, theta: 0 }));
    await press(page, "Way out");
    await page.waitForFunction(() => !document.getElementById("timeline")?.hidden, { timeout: PATIENCE });
  });

  it("draws the orientation in the colours of the theme", async () => {
    const page = await at(SIZES[0], model("ball_in_c"));
    for (const theme of ["dark", "light"]) {
      await page.$$eval("#tools button", (all) => (all.find((b) => /^Theme/.test(b.textContent ?? "")) as HTMLElement).click());
      await settled(page);
      const [track, line] = await page.$eval(".theta-slider canvas", (e) => {
        const canvas = e as HTMLCanvasElement;
        const probe = document.createElement("canvas").getContext("2d")!;
        // The track, before the first tick.
        probe.drawImage(canvas, -13, -canvas.height / 2);
        const pixel = [...probe.getImageData(0, 0, 1, 1).data.slice(0, 3)];
        const hex = getComputedStyle(canvas).getPropertyValue("--line").trim();
        return [pixel, [1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16))];
      });
      assert.deepEqual(track, line, theme);
    }
  });

  it("shows the vertex that is chosen, numbers in full, and features by what they are", async () => {
    const latch = join(suite.folder, "latch.toml");
    run(["new", "latch", "-o", latch]);
    const page = await at(SIZES[0], latch);
    await page.evaluate(() => window.cspace.setConfiguration({ x: 0, y: -1, theta: 0 }));
    await settled(page);
    assert.match(await page.$eval("#readout .touching-list", (e) => e.textContent ?? ""), /^bottom wall of a recess.* \| round of radius 5 about 0, -6$/);
    assert.equal(await page.$eval(".pair-choice", (e) => (e as HTMLElement).hidden), true);
    assert.match(await page.$eval("#pair-class", (e) => e.textContent ?? ""), /^general pair, 24 \+ 14 features, \d+ patches$/);
    const field = "#design .value input";
    await page.$eval(field, (e) => {
      (e as HTMLInputElement).value = "10.123456789";
      e.dispatchEvent(new Event("change"));
    });
    await settled(page);
    assert.ok(await page.$eval(field, (e) => e.scrollWidth <= e.clientWidth));
    await press(page, "Edit");
    const box = await (await page.$("#parts .handle.vertex"))?.boundingBox();
    assert.ok(box);
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await settled(page);
    assert.equal((await page.$$("#parts .handle.chosen")).length, 1);
    // A pointer leaves no frame round what it was used on.
    assert.equal(await page.$eval("#parts svg.viewport", (e) => (document.activeElement === e ? getComputedStyle(e).outlineStyle : "no focus")), "none");
  });
});
