/** Drawings in the page: the model of picked faces is the one that the command makes of the same picks, and what is refused is refused in the same words. */

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { Drawing } from "../build/kernel/cspace.js";
import { request } from "../src/drawing/picks.js";
import type { DrawingScene } from "../src/drawing/scene.js";
import { binary, NO_COMMAND, run } from "./support/command.js";
import { inFolder } from "./support/scene.js";

const skip = binary() ? false : NO_COMMAND;

const DRAWINGS = resolve(process.cwd(), "../../cspace-drawing/tests/drawings");

/** Drawings of lines, circles and bulges: no sine decides their last bits, so that models are equal to the last bit wherever they are made. */
const WITHOUT_SINES = new Set(["bare.dxf", "lwpolyline.dxf", "overlapping.dxf", "rings.dxf", "unit_in.dxf", "inches.svg", "path_relative.svg", "styles.svg"]);

/** Sines of the browser and of the system differ in their last bits: coordinates and bulges differ by no more than this, as a share of the largest number. */
const ROUNDING = 16 * Number.EPSILON;

/** Faces of a drawing that are made parts, at most. */
const MOST = 8;

const NUMBER = /-?\d+(\.\d+)?(e-?\d+)?/g;

for (const name of readdirSync(DRAWINGS).filter((n) => /\.(dxf|svg)$/.test(n))) {
  test(`${name} makes the command's model`, { skip }, (t) => {
    const file = join(DRAWINGS, name);
    const opened = open(file);
    if (typeof opened === "string") {
      t.diagnostic(opened);
      assert.equal(opened, refusal(file));
      return;
    }
    const { drawing, scene } = opened;
    const inside = scene.faces.map((f) => f.inside);
    const faces = scene.faces.flatMap((f, i) => (f.refusal === null ? [i] : [])).slice(0, MOST);
    assert.ok(faces.length > 0);
    const picks = request({ parts: faces.map((f, i) => ({ name: "abcdefgh"[i] ?? "", faces: [f] })), selected: 0 }, inside);
    const mine = drawing.toml(JSON.stringify(picks));
    const options = picks.flatMap((p) => ["--pick", `${p.name}=${p.at.map(({ x, y }) => `${x},${y}`).join(";")}`]);
    const told = inFolder((folder) => {
      const out = join(folder, "model.toml");
      run(["import", file, ...options, "-o", out, "-q"]);
      return readFileSync(out, "utf8");
    });
    if (WITHOUT_SINES.has(name)) assert.equal(mine, told);
    assert.equal(mine.replace(NUMBER, "#"), told.replace(NUMBER, "#"));
    const [a, b] = [mine, told].map((text) => (text.match(NUMBER) ?? []).map(Number)) as [number[], number[]];
    const size = Math.max(...b.map(Math.abs));
    const worst = Math.max(...b.map((x, i) => Math.abs(x - (a[i] ?? NaN)) / size));
    t.diagnostic(mine === told ? "equal to the last bit" : `differs by ${worst}`);
    assert.ok(worst <= ROUNDING, `${worst}`);
  });
}

/** The drawing and its faces, or why there are none. */
function open(file: string): { drawing: Drawing; scene: DrawingScene } | string {
  try {
    const drawing = Drawing.read(readFileSync(file), file);
    return { drawing, scene: JSON.parse(drawing.scene()) as DrawingScene };
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}

/** What `cspace view` says of a drawing that it refuses. */
function refusal(file: string): string {
  const done = spawnSync(binary() ?? "cspace", ["view", file, "--no-open"], { encoding: "utf8", timeout: 20_000 });
  assert.equal(done.status, 2, done.stdout);
  const [, error, help] = /^error: (.*)\n {2}help: (.*)\n$/.exec(done.stderr) ?? [];
  return `${error} (${help})`;
}
