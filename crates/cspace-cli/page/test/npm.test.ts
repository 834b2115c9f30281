/** The npm package: its README runs as it stands, and its answers are the command's. */

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { scratch } from "../tools/harness.js";
import { pack } from "../tools/package.js";
import { MODELS, NO_COMMAND, binary, run } from "./support/command.js";

test("the package is installed, and computes what the command computes", { skip: binary() ? false : NO_COMMAND }, () => {
  const folder = scratch();
  try {
    // The kernel that all tests here have.
    const archive = pack(resolve(process.cwd(), "build/kernel"), folder.path);
    writeFileSync(join(folder.path, "package.json"), JSON.stringify({ type: "module" }));
    execFileSync("npm", ["install", "--silent", "--offline", "--no-audit", archive], { cwd: folder.path });
    const readme = readFileSync(join(folder.path, "node_modules/cspace/README.md"), "utf8");
    const example = /```js\n(.*?)```/s.exec(readme)?.[1] ?? "";
    const toml = /`\n(.*?)`,\n/s.exec(example)?.[1] ?? "";
    const asked = example.replace("pair.classify([0, 0, 0]);", "console.log(pair.classify([0, 0, 0]), pair.classify([1.5, 0, 0]));").replace(/pair\.advance\((.*)\);/, "console.log(pair.advance($1).at[0].toFixed(9));");
    const said = execFileSync("node", ["--input-type=module", "-e", asked], { cwd: folder.path, encoding: "utf8" });
    assert.equal(said, "free blocked\n1.000000000\n");
    const file = join(folder.path, "key.toml");
    writeFileSync(file, toml);
    assert.match(run(["play", file, "--at", "0,0,0", "--by", "5,0,0", "--json"]), /"fraction": 0\.(2|19999999)/);
    // A shipped model, configuration by configuration.
    const model = join(MODELS, "peg_hole.toml");
    const rows = Array.from({ length: 60 }, (_, i) => [0.4 * (i % 10) - 2, 0.7 * i - 10, 0.05 * (i % 7) - 0.15]);
    const told = run(["classify", model], `x,y,theta\n${rows.map((r) => r.join(",")).join("\n")}\n`).trim().split("\n").slice(1).map((line) => line.split(",").at(-1));
    const script = `import { load, Model, Pair } from "cspace"; import { readFileSync } from "node:fs";
      await load();
      const model = Model.read(readFileSync(${JSON.stringify(model)}, "utf8"), "peg_hole.toml");
      const pair = new Pair(JSON.parse(model.pair(0)).space, true);
      console.log(JSON.stringify(${JSON.stringify(rows)}.map((c) => pair.classify(c))));`;
    const answers = execFileSync("node", ["--input-type=module", "-e", script], { cwd: folder.path, encoding: "utf8" });
    assert.deepEqual(JSON.parse(answers), told);
  } finally {
    folder.remove();
  }
});
