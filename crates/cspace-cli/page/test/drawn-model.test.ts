/** Drawings in the page: the model of picked faces is the one that the command makes of the same picks, and what is refused is refused in the same words. */

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { Drawing } from "../build/kernel/cspace.js";
import { request } from "../src/drawing/picks.js";
import type { DrawingScene } from "../src/drawing/scene.js";
import { inUtf8, sourceInUtf8 } from "../src/drawing/utf8.js";
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

test("texts of old drawings are in the encoding that their header names", { skip }, () => {
  // Two squares on layers whose names are in Shift-JIS.
  const square = (layer: string, x: number) => {
    const corners = [[x, 0], [x + 4, 0], [x + 4, 4], [x, 4]];
    return `0\nLWPOLYLINE\n8\n${layer}\n90\n4\n70\n1\n${corners.map(([a, b]) => `10\n${a}\n20\n${b}\n`).join("")}`;
  };
  const text = `0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\nANSI_932\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n${square("@", 0)}${square("#", 9)}0\nENDSEC\n0\nEOF\n`;
  const [outer, inner] = [[0x8a, 0x4f, 0x8c, 0x60], [0x93, 0xe0, 0x8c, 0x60]];
  const bytes = Uint8Array.from([...text].flatMap((c) => (c === "@" ? outer! : c === "#" ? inner! : [c.charCodeAt(0)])));
  const drawing = Drawing.read(inUtf8(bytes), "old.dxf");
  const scene = JSON.parse(drawing.scene()) as DrawingScene;
  const names = scene.parts.map((p) => p.name).sort();
  const told = inFolder((folder) => {
    writeFileSync(join(folder, "old.dxf"), bytes);
    const out = join(folder, "old.toml");
    run(["import", join(folder, "old.dxf"), "-o", out, "-q"]);
    return [...readFileSync(out, "utf8").matchAll(/^name = "(.*)"$/gm)].map((m) => m[1]);
  });
  assert.deepEqual(names, ["内形", "外形"]);
  assert.ok(names.every((name) => told.includes(name)), told.join());
  // The scene that the command serves has the file's own bytes.
  const source = { ...scene.source, data: Buffer.from(bytes).toString("base64"), layers: ["外形"] };
  const again = Drawing.fromSource(JSON.stringify(sourceInUtf8(source)));
  assert.match(again.toml(JSON.stringify([{ name: "a", at: [{ x: 1, y: 1 }] }])), /name = "a"/);
  assert.throws(() => again.toml(JSON.stringify([{ name: "b", at: [{ x: 10, y: 1 }] }])));
});

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
