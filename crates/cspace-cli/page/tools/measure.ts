/** Measures a page in a browser: its size, first paint, work per frame while dragging, and how often a pair is computed under the hand. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import type { Page } from "puppeteer-core";
import { MODELS } from "../test/support/command.js";
import { PATIENCE, addressOf, drawn, exported, launch, scratch } from "./harness.js";

/** How long something is dragged (ms). */
const DRAG = 4000;

interface Counted {
  answers: number;
}

const folder = scratch();
const browser = await launch(folder.path);

/** Milliseconds of work that the page itself does in a frame, while the moving part is dragged. */
async function perFrame(page: Page): Promise<{ work: number; frames: number }> {
  const at = await page.$eval("#slice .point, #plane .point", (e) => {
    const r = e.getBoundingClientRect();
    return { x: r.x + r.width / 2, y: r.y + r.height / 2 };
  });
  await page.evaluate(() => {
    const w = window as unknown as { frames: number };
    w.frames = 0;
    const count = () => {
      w.frames += 1;
      requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  });
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  const before = await page.metrics();
  const end = Date.now() + DRAG;
  for (let i = 0; Date.now() < end; i += 1) await page.mouse.move(at.x + 40 * Math.sin(i / 9), at.y + 30 * Math.cos(i / 7));
  const after = await page.metrics();
  await page.mouse.up();
  const frames = await page.evaluate(() => (window as unknown as { frames: number }).frames);
  const sum = (m: typeof before) => (m.ScriptDuration ?? 0) + (m.LayoutDuration ?? 0) + (m.RecalcStyleDuration ?? 0);
  return { work: (1000 * (sum(after) - sum(before))) / Math.max(1, frames), frames: (1000 * frames) / DRAG };
}

/** Pairs computed in a second, and what the page says of the last: a parameter is changed at every frame, or the clearance where there is none. */
async function perSecond(page: Page, parameter: string | null): Promise<[number, string]> {
  await page.evaluate(() => [...document.querySelectorAll("button")].find((b) => b.textContent === "Edit")?.click());
  return page.evaluate(async (time, parameter) => {
    const counted = window as unknown as Counted;
    const field = document.querySelector<HTMLInputElement>(parameter === null ? "#edit-offset" : `#design input[aria-label^="${parameter},"]`);
    if (!field) throw new Error("nothing can be edited");
    counted.answers = 0;
    const first = Number(field.value);
    const begin = performance.now();
    for (let i = 0; performance.now() - begin < time; i += 1) {
      field.value = String(first + 1e-3 * (i % 50));
      field.dispatchEvent(new Event("change", { bubbles: true }));
      await new Promise((done) => requestAnimationFrame(done));
    }
    const said = [...document.querySelectorAll("#edit p")].find((p) => p.textContent?.includes(" ms of "))?.textContent ?? "";
    return [(1000 * counted.answers) / (performance.now() - begin), said] as [number, string];
  }, DRAG, parameter);
}

for (const [name, parameter] of [["peg_hole", null], ["ratchet_pawl", "tip"], ["geneva", null], ["gears", null]] as const) {
  const file = exported(join(MODELS, `${name}.toml`), folder.path);
  const page = await browser.newPage();
  await page.setViewport({ width: 1440, height: 900 });
  await page.evaluateOnNewDocument(() => {
    const counted = window as unknown as Counted;
    counted.answers = 0;
    const Own = window.Worker;
    window.Worker = class extends Own {
      constructor(address: string | URL) {
        super(address);
        this.addEventListener("message", () => (counted.answers += 1));
      }
    };
  });
  await page.goto(addressOf(file), { timeout: PATIENCE });
  await drawn(page);
  const [paint, ready] = await page.evaluate(() => [performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN, performance.now()]);
  const size = gzipSync(readFileSync(file), { level: 9 }).length;
  const { work, frames } = await perFrame(page);
  const [answers, said] = await perSecond(page, parameter);
  console.log(`${name}: ${(size / 1e6).toFixed(2)} MB, first paint ${paint?.toFixed(0)} ms, drawn ${ready?.toFixed(0)} ms, dragged: ${work.toFixed(1)} ms of work a frame, ${frames.toFixed(0)} frames/s; edited: ${answers.toFixed(1)} pairs/s, the last ${said}`);
  await page.close();
}
await browser.close();
folder.remove();
