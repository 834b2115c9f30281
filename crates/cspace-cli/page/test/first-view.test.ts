/** What a model shows first, and the answer that stands there. */

import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import { Model } from "../build/kernel/cspace.js";
import type { AxesKernel, PlanarKernel } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { isAssembly, orderOf } from "../src/ui/assembly-record.js";
import { cageOf } from "../src/ui/cage.js";
import { firstPair } from "../src/ui/first-pair.js";
import { edgeOf, arcOf, featurePlace } from "../src/ui/outline.js";
import { heldOneWay, pushesOf } from "../src/ui/pushes.js";
import { MODELS, NO_COMMAND, binary, models, run } from "./support/command.js";
import { sceneOf, withModel } from "./support/scene.js";

const REST = { u: 0, v: 0 };

describe("the first view", { skip: binary() === null && NO_COMMAND }, () => {
  it("is what each shipped model says, and answers a question", () => {
    const folders = ["layers", "tolerances"].map((name) => join(MODELS, name));
    const others = folders.flatMap((folder) => readdirSync(folder).filter((f) => f.endsWith(".toml")).map((f) => join(folder, f)));
    for (const model of [...models(), ...others]) {
      const scene = sceneOf(model);
      assert.match(scene.show.question ?? "", /\?$/, model);
      assert.ok(scene.pairs.length === 1 || scene.show.pair === firstPair(scene), model);
    }
    for (const name of ["cam", "gears", "geneva", "latch", "peg", "ratchet"]) assert.match(run(["new", name]), /^show = \{ question = ".*\?" \}$/m);
    const snap = sceneOf(join(MODELS, "snap_in.toml"));
    const { fixed, moving } = snap.pairs[firstPair(snap)]!;
    assert.deepEqual([fixed, moving].map((part) => snap.parts[part]?.name), ["catch", "hook"]);
  });

  it("tells which way a ratchet is held, and after how much", () => {
    withModel(run(["new", "ratchet"]), (ratchet) => {
      const held = heldOneWay(pushesOf(openPair(sceneOf(ratchet), 0) as unknown as AxesKernel, REST).u);
      assert.equal(held?.way, "clockwise");
      // The face of the tooth is at a play of 0.2 from the pawl, at the radius of 50.
      assert.ok(Math.abs(held.push.met - Math.asin(0.2 / 50)) < 1e-7, `${held.push.met}`);
      assert.ok(held.push.gone >= held.push.met && held.push.gone < 0.01 && held.push.touching.length > 0);
    });
  });

  it("does not call one way what goes both, or what another place of the other part lets go", () => {
    const pushes = (name: string) => pushesOf(openPair(sceneOf(join(MODELS, `${name}.toml`)), 0) as unknown as AxesKernel, REST);
    const { u: wheel, v: driver } = pushes("geneva");
    assert.ok(driver?.back.gone === Infinity && driver.forth.gone === Infinity);
    // Locked by the disc: as far to both sides, by symmetry.
    assert.ok(wheel && wheel.back.gone < 0.01 && Math.abs(wheel.back.gone - wheel.forth.gone) < 1e-9, JSON.stringify(wheel));
    for (const name of ["geneva", "gears_on_shafts", "escapement"]) {
      const { u, v } = pushes(name);
      assert.deepEqual([heldOneWay(u), heldOneWay(v)], [null, null], name);
    }
  });

  it("lights what cages a part: of a clip its bore and its lips, and nothing outside", () => {
    const scene = sceneOf(join(MODELS, "ball_in_c.toml"));
    const clip = scene.parts[0]!;
    const kernel = openPair(scene, 0) as unknown as PlanarKernel;
    const radii = cageOf(kernel as never, 1).map((feature) => {
      const { loop, index } = featurePlace(clip, feature)!;
      return Math.round(arcOf(edgeOf(clip.loops[loop]!, index)!)!.radius);
    });
    assert.deepEqual([...new Set(radii)].sort((a, b) => a - b), [2, 12]);
  });

  it("tells in which order an assembly comes apart, as the command does", () => {
    const box = join(MODELS, "latch_box.toml");
    const scene = sceneOf(box);
    assert.ok(isAssembly(scene) && !isAssembly(sceneOf(join(MODELS, "snap_in.toml"))) && !isAssembly(sceneOf(join(MODELS, "knee.toml"))));
    const own = JSON.parse(Model.fromSource(JSON.stringify(scene.source)).disassemble('{"set": [], "parts": []}')) as Record<string, unknown>;
    const told = JSON.parse(run(["disassemble", box, "--json"])) as Record<string, unknown>;
    // Sines differ in their last digits, and ways among parts that touch by more; what goes does not.
    const steps = (of: typeof own) => (of["steps"] as Record<string, unknown>[]).map(({ kind, moving, staying }) => ({ kind, moving, staying }));
    assert.deepEqual(steps(own), steps(told));
    assert.equal(orderOf(own as never), "All of it comes apart: first bolt, then lid, then block.");
    assert.equal(orderOf({ verdict: "unknown", steps: [] }), null);
    assert.equal(orderOf({ verdict: "apart", steps: [{ kind: "moves", moving: ["a"] }, { kind: "leaves", moving: ["b", "c"] }] } as never), "All of it comes apart: first a aside, then b with c.");
  });
});
