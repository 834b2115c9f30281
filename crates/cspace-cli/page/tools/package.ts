/** The npm package `cspace`: what is written by hand in `cspace-wasm/npm`, with the kernel as it was compiled for the page. */

import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, readdirSync, rmSync } from "node:fs";
import { join, resolve } from "node:path";

const ROOT = resolve(process.cwd(), "../../..");

/** Packs it with the kernel in a folder into another; the path of the archive. */
export function pack(kernel: string, to: string): string {
  if (!existsSync(kernel)) throw new Error(`${kernel} is not there: run \`npm run kernel\` first`);
  const folder = join(to, "cspace");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const from of [join(ROOT, "crates/cspace-wasm/npm"), kernel]) {
    for (const name of readdirSync(from)) copyFileSync(join(from, name), join(folder, name));
  }
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) copyFileSync(join(ROOT, name), join(folder, name));
  const said = execFileSync("npm", ["pack", "--silent", "--pack-destination", to], { cwd: folder, encoding: "utf8" });
  return join(to, said.trim().split("\n").at(-1) ?? "");
}
