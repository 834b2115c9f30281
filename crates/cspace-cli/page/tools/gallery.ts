/**
 * Makes `docs/gallery.md` from the models that ship with the project: for each its parts and its configuration space as pictures, and
 * its page as one file. Pictures are kept with the project; pages are not, and made by this command.
 */

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join, relative } from "node:path";
import { launch, root, scratch, skip } from "./harness.js";
import { run, models } from "../test/support/command.js";
import { spaceOf } from "./space-picture.js";

/** What the tables of models say of each file. */
function told(): Map<string, string> {
  const rows = new Map<string, string>();
  for (const folder of ["models", "models/paper"]) {
    for (const line of readFileSync(join(root, folder, "README.md"), "utf8").split("\n")) {
      const row = /^\| `([a-z_]+\.toml)` \| ([^|]+) \|/.exec(line);
      if (row?.[1] !== undefined && row[2] !== undefined) {
        rows.set(join(root, folder, row[1]), row[2]);
      }
    }
  }
  return rows;
}

async function make(): Promise<void> {
  const gallery = join(root, "docs/gallery");
  mkdirSync(gallery, { recursive: true });
  const folder = scratch();
  const browser = await launch(folder.path);
  const rows = told();
  let text = `# Gallery

The models that ship with the project: the parts as they are drawn, and the configuration space of a pair. Each has a page to drag
the parts on, one file that works offline. The pages are not kept with the project; this command makes them, and all of what is here:

\`\`\`sh
cargo build --release -p cspace-cli
npm --prefix crates/cspace-cli/page ci
npm --prefix crates/cspace-cli/page run gallery
\`\`\`

The surfaces are positions (x, y) and, upwards, orientation θ at which the parts touch; colours are free regions. Of a pair on fixed axes
the plane of its two motions is shown: blocked is grey.
`;
  try {
    for (const model of models()) {
      const name = relative(join(root, "models"), model).replace(/\.toml$/, "").replaceAll("/", "_");
      const page_file = join(gallery, `${name}.html`);
      run(["export", model, "-o", page_file]);
      run(["draw", model, "-o", join(gallery, `${name}.svg`), "--labels", "none"]);
      const { picture, pair } = await spaceOf(browser, page_file);
      writeFileSync(join(gallery, `${name}.png`), picture);
      const shows = rows.get(model) ?? basename(model);
      text += `
## ${name.replace(/^paper_/, "the paper's ").replaceAll("_", " ")}

${shows[0]?.toUpperCase()}${shows.slice(1)}. Pair shown: ${pair[1]} relative to ${pair[0]}. [Model](../${relative(root, model)}),
[page](gallery/${name}.html).

| parts | configuration space |
|---|---|
| ![${name}, its parts](gallery/${name}.svg) | ![${name}, its space](gallery/${name}.png) |
`;
      process.stderr.write(`${name}\n`);
    }
  } finally {
    await browser.close();
    folder.remove();
  }
  writeFileSync(join(root, "docs/gallery.md"), text);
}

if (skip !== false) {
  process.stderr.write(`error: ${skip}\n`);
  process.exitCode = 1;
} else {
  await make();
}
