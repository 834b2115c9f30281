/** Parameters, requirements and dragged contacts on a page in a file, against the command. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Page } from "puppeteer-core";
import { PATIENCE, addressOf, exported, open, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { click, downloaded, inBrowser, model, press, resting } from "./support.js";

interface Row {
  name: string;
  value: number;
  met: boolean;
}

describe("a page sets the parameters of its model", { skip }, () => {
  const suite = inBrowser();

  async function openFile(name: string): Promise<Page> {
    suite.opened = await open(suite.browser, addressOf(exported(model(name), suite.folder)));
    return suite.opened.page;
  }

  /** Types the value of a parameter. */
  async function type(page: Page, name: string, value: string): Promise<void> {
    const field = await page.waitForSelector(`#design input[type=number][aria-label^="${name},"]`, { timeout: PATIENCE });
    await field?.evaluate((e, value) => {
      const input = e as HTMLInputElement;
      input.value = value;
      input.dispatchEvent(new Event("change", { bubbles: true }));
    }, value);
  }

  const valueOf = (page: Page, name: string) => page.$eval(`#design input[type=number][aria-label^="${name},"]`, (e) => Number((e as HTMLInputElement).value));

  /** Waits until a field shows a value: it does once the value has been taken. */
  const shows = (page: Page, name: string, value: number) =>
    page.waitForFunction(
      (label, value) => Number(document.querySelector<HTMLInputElement>(`#design input[type=number][aria-label^="${label}"]`)?.value) === value,
      { timeout: PATIENCE },
      `${name},`,
      value,
    );

  /** Waits until a configuration is so. */
  const becomes = (page: Page, c: { u: number; v: number }, said: string) =>
    page.waitForFunction((c, said) => window.cspace.classify(c) === said, { timeout: PATIENCE }, c, said);

  it("a value that is typed, and one that is slid, have the space that the command computes", async () => {
    const page = await openFile("shift_interlock");
    const rows = [-7, -3, -0.5, 0, 0.4, 2, 7].flatMap((u) => [-2.5, -1, -0.9, -0.5, 0.2, 0.9, 1.4].map((v) => ({ u, v })));
    await type(page, "length", "12.5");
    // Longer, it comes less far.
    await becomes(page, { u: 0, v: 1 }, "blocked");
    const same = async (set: string) => {
      const lines = rows.map(({ u, v }) => `${u},${v}`).join("\n");
      const answers = run(["classify", model("shift_interlock"), "--pair", "first rail,plunger", ...set.split(" ")], `u,v\n${lines}\n`);
      const told = answers.trim().split("\n").slice(1).map((line) => line.split(",").at(-1));
      for (const [i, c] of rows.entries()) assert.equal(await page.evaluate((c) => window.cspace.classify(c), c), told[i], JSON.stringify(c));
    };
    await same("--set length=12.5");
    await page.$eval('#design input[type=range][aria-label="gap"]', (e) => {
      const slider = e as HTMLInputElement;
      for (const value of ["10.2", "10.5", "11"]) {
        slider.value = value;
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      }
      slider.dispatchEvent(new Event("change", { bubbles: true }));
    });
    // Free at the last of them alone.
    await becomes(page, { u: 0, v: 1.2 }, "free");
    await shows(page, "gap", 11);
    await same("--set length=12.5 --set gap=11");
    // What was slid is undone at once.
    await press(page, "Undo");
    await becomes(page, { u: 0, v: 1 }, "blocked");
    await shows(page, "gap", 10);
    await same("--set length=12.5");
    // A value that is no model is measured nowhere.
    await type(page, "depth", "6");
    await page.waitForSelector("#design .said.bad", { timeout: PATIENCE });
    await press(page, "Undo");
    await becomes(page, { u: 0, v: 1 }, "blocked");
    // The file keeps its parameters.
    const client = await page.createCDPSession();
    await client.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: suite.folder });
    await press(page, "Save model");
    const saved = readFileSync(await downloaded(join(suite.folder, "shift-interlock.toml")), "utf8");
    assert.match(saved, /length = 12\.5 {2,}# of the plunger/);
  });

  it("requirements are as the command checks them, and drawn over a parameter", async () => {
    const page = await openFile("ratchet_pawl");
    const rows = (JSON.parse(run(["check", model("ratchet_pawl"), "--json"])) as { requirements: Row[] }).requirements;
    const row = () => page.$eval(".requirement", (e) => ({ text: e.textContent ?? "", met: e.querySelector(".mark")?.classList.contains("met") }));
    await page.waitForSelector(".requirement .mark.met", { timeout: PATIENCE });
    assert.ok((await row()).text.includes(Number(rows[0]?.value.toPrecision(4)).toString()), (await row()).text);
    await page.select("#strip-over", "tip");
    // A line for which the tooth was measured.
    await page.waitForFunction(() => (document.querySelector(".requirement .plot path")?.getAttribute("d") ?? "").split("L").length > 6, { timeout: PATIENCE });
    // Beyond its limits it is not met.
    await type(page, "tip", "49.5");
    await page.waitForSelector(".requirement .mark.unmet", { timeout: PATIENCE });
    await type(page, "tip", "-3");
    await page.waitForFunction(() => /tip|radius|cross|edge|ratchet/.test(document.querySelector("#design .said.bad")?.textContent ?? ""), { timeout: PATIENCE });
    await press(page, "Undo");
    await page.waitForFunction(() => document.querySelector("#design .said.bad") === null, { timeout: PATIENCE });
  });

  it("a contact that is dragged takes the parameters along", async () => {
    const page = await openFile("shift_interlock");
    await press(page, "Edit");
    // Only the plunger's length may change.
    for (const name of ["depth", "gap", "travel"]) await click(page, `#design input[type=checkbox][aria-label^="${name} "]`);
    // The plunger on the rail away from its notch: v = -0.95, and goes with half of the length.
    await resting(page, "#plane svg .curve");
    const at = await page.evaluate(() => {
      const matrix = (document.querySelector("#plane svg .curve") as SVGGraphicsElement).getScreenCTM();
      if (!matrix) throw new Error("the plane is not drawn");
      const place = (u: number, v: number) => new DOMPoint(u, v).matrixTransform(matrix);
      const [from, to] = [place(-5, -0.95), place(-5, -1.45)];
      return { from: { x: from.x, y: from.y }, to: { x: to.x, y: to.y } };
    });
    await page.mouse.move(at.from.x, at.from.y);
    await page.mouse.down();
    await page.mouse.move(at.to.x, at.to.y, { steps: 5 });
    await page.mouse.up();
    await page.waitForFunction(() => Math.abs(Number((document.querySelector('#design input[type=number][aria-label^="length,"]') as HTMLInputElement).value) - 12.9) < 0.02, { timeout: PATIENCE });
    const length = await valueOf(page, "length");
    const touches = 10 / 2 - length / 2;
    await becomes(page, { u: -5, v: touches - 1e-4 }, "free");
    assert.equal(await page.evaluate((c) => window.cspace.classify(c), { u: -5, v: touches + 1e-4 }), "blocked");
    assert.equal(await valueOf(page, "gap"), 10);
    // What is undone while answers are on their way stays undone.
    await page.mouse.move(at.to.x, at.to.y);
    await page.mouse.down();
    await page.mouse.move(at.to.x, at.to.y + 20, { steps: 8 });
    await page.keyboard.down("Control");
    await page.keyboard.press("z");
    await page.keyboard.up("Control");
    await page.mouse.move(at.to.x, at.to.y + 40, { steps: 8 });
    await page.mouse.up();
    await new Promise((done) => setTimeout(done, 1500));
    const after = await valueOf(page, "length");
    assert.ok(Math.abs(after - length) < 1e-9 || Math.abs(after - 11.9) < 1e-9, String(after));
  });
});
