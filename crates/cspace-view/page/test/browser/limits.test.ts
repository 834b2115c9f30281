/** What the page does where users go too far: zooms without end, wrong files, addresses by hand, shapes that are none. */

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, describe, it } from "node:test";
import type { Browser, Page } from "puppeteer-core";
import type { PlanarConfiguration } from "../../src/kernel/api.js";
import { PATIENCE, addressOf, exported, launch, open, root, scratch, serve, skip } from "../../tools/harness.js";
import type { Opened } from "../../tools/harness.js";
import { run } from "../support/command.js";

const model = (name: string): string => join(root, `models/${name}.toml`);

describe("the page at its limits", { skip }, () => {
  const folder = scratch();
  let browser: Browser;
  let opened: Opened | null = null;
  before(async () => {
    browser = await launch(folder.path);
  });
  afterEach(async () => {
    const faults = opened?.faults ?? [];
    await opened?.page.close();
    opened = null;
    assert.deepEqual(faults, []);
  });
  after(async () => {
    await browser?.close();
    folder.remove();
  });

  async function openModel(file: string, fragment = ""): Promise<Page> {
    opened = await open(browser, addressOf(exported(file, folder.path)) + fragment);
    return opened.page;
  }

  async function openRecord(page: Page, name: string, text: string): Promise<void> {
    const file = join(folder.path, name);
    writeFileSync(file, text);
    const [chooser] = await Promise.all([page.waitForFileChooser({ timeout: PATIENCE }), press(page, "Open record")]);
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
});

/** Waits for two frames, in which the page draws what has changed. */
function settled(page: Page): Promise<void> {
  return page.evaluate(() => new Promise<void>((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}

/** Clicks the button of a text. */
async function press(page: Page, text: string): Promise<void> {
  const found = await page.evaluateHandle((of) => [...document.querySelectorAll("button")].find((b) => b.textContent?.startsWith(of)) ?? null, text);
  const button = found.asElement();
  assert.ok(button, `there is no button ${text}`);
  await (button as import("puppeteer-core").ElementHandle<Element>).click();
  await settled(page);
}
