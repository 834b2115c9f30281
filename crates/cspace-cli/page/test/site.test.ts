/** The site: pages share what is the same in all, are found again from each other, and lessons say what the program answers. */

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Scene } from "../src/scene.js";
import { ALL, MODELS, NO_COMMAND, binary, run } from "./support/command.js";
import { inFolder, sceneOf } from "./support/scene.js";
import { lessonsOf, writeSite } from "./support/site.js";

const SHARED = ["style.js", "kernel.js", "page.js"];

/** What a page of the site may have of its own: a model and what is told of its pairs, as text. */
const OWN_BYTES = 60_000;

describe("the site", { skip: binary() ? false : NO_COMMAND }, () => {
  const plane = ["ball_in_c", "peg_hole", "latch_box", "ratchet_mechanism", "paper/blocks"];
  const axes = ["layers/gate", "gears_on_shafts", "cam_tappet", "shift_interlock", "tolerances/geneva_lock"];
  const models = [...plane, ...axes].map((name) => join(MODELS, `${name}.toml`));

  it("has pages that share style, kernel and script, and lead back; lessons are answered by the program", () => {
    inFolder((folder) => {
      writeSite(folder, ALL ? [] : models);
      const files = readdirSync(folder);
      const pages = files.filter((name) => name.endsWith(".html") && !["index.html", "teach.html"].includes(name));
      assert.ok(pages.length >= models.length);
      const index = readFileSync(join(folder, "index.html"), "utf8");
      for (const name of pages) {
        const page = readFileSync(join(folder, name), "utf8");
        assert.deepEqual([...page.matchAll(/<script src="([^"]*)">/g)].map(([, file]) => file), SHARED, name);
        assert.ok(!/<style>|<script>|id="kernel"/.test(page) && page.length < OWN_BYTES, `${name}: ${page.length}`);
        assert.match(page, /<nav id="gallery"><a href="index.html">/);
        assert.equal(index.split(`href="${name}"`).length, 2, `${name} is in the gallery once`);
      }
      // The three are what a page in one file has in it, once.
      assert.deepEqual(files.filter((name) => name.endsWith(".js")).sort(), [...SHARED].sort());
      const one = join(folder, "one.html");
      run(["export", models[0]!, "-o", one]);
      const whole = readFileSync(one, "utf8");
      for (const name of SHARED) {
        const [, text = ""] = /^document\.write\((.*)\);\n$/.exec(readFileSync(join(folder, name), "utf8")) ?? [];
        assert.equal(whole.split(JSON.parse(text) as string).length, 2, name);
      }
      // Nothing of the model is lost but the space, which the page computes.
      const page = readFileSync(join(folder, "latch_box.html"), "utf8");
      const scene = JSON.parse(/id="scene">([^<]*)</.exec(page)?.[1] ?? "") as Scene;
      const plain = (of: Scene) => ({ ...of, pairs: of.pairs.map((pair) => ({ ...pair, space: null, bands: [], seconds: 0 })) });
      assert.deepEqual(plain(scene), plain(sceneOf(join(MODELS, "latch_box.toml"))));
      assert.ok(scene.pairs.every((pair) => pair.space === null));
      assert.match(index, /Comes apart: bolt, then lid, then block\./);

      const lessons = lessonsOf(folder);
      assert.equal(lessons.length, 10);
      for (const { title, choices, right } of lessons) assert.ok(choices.length > 1 && right.length === 1, title);
      const answer = (title: string) => lessons.find((l) => l.title === title)?.answer ?? "";
      // Another command says the same angle.
      const [, angle = ""] = /cannot pass ([\d.]+) deg/.exec(run(["clearance", join(MODELS, "layers/gate.toml")])) ?? [];
      assert.ok(angle !== "" && answer("Angle at which it jams").includes(`${Number(angle).toPrecision(4)}°`), angle);
      // The ball of radius 10 stops where it is 12 from the middles of both lips, which are rounds of radius 2.
      const [x, y] = [11.71, 7.669];
      assert.ok(answer("Caging").includes(` ${(x - Math.sqrt(12 ** 2 - y ** 2)).toFixed(2)}`), answer("Caging"));
    });
  });

  it("has another right choice of another model", () => {
    inFolder((folder) => {
      const text = readFileSync(join(MODELS, "shift_interlock.toml"), "utf8");
      // In the notch are 0.1 at each side of the plunger, and where it ends 1.1 above its floor, 1.1 more to flanks at 45 degrees.
      const short = text.replace(/^length = 11\.9/m, "length = 9.9");
      assert.notEqual(short, text);
      const model = join(folder, "shift_interlock.toml");
      writeFileSync(model, short);
      mkdirSync(join(folder, "site"));
      writeSite(join(folder, "site"), [model]);
      const [lesson] = lessonsOf(join(folder, "site"));
      assert.deepEqual(lesson?.right, ["Farther, but not into gear"]);
      assert.match(lesson?.answer ?? "", /^ By 2\.4 mm,/);
    });
  });
});
