/** The command that the kernel's answers are compared with. */

import { spawnSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { use } from "../../src/kernel/load.js";

/** The package's folder: the one with `package.json` from which tests are run. */
const PACKAGE = resolve(process.cwd());

/** The kernel that was compiled for the page. */
const KERNEL = resolve(PACKAGE, "build/kernel/cspace_bg.wasm");
if (existsSync(KERNEL)) use(new WebAssembly.Module(readFileSync(KERNEL)));

/** Whether all is tested that is ever tested, by CSPACE_LONG=1, and not only what takes a minute. */
export const ALL = process.env["CSPACE_LONG"] === "1";

/** How often something is tried: less often where not all is tested. */
export const times = (all: number, few: number): number => (ALL ? all : few);

export const MODELS = resolve(PACKAGE, "../../../models");

/** The command's binary: what CSPACE names, or else what has been built; null if there is none. */
export function binary(): string | null {
  const named = process.env["CSPACE"];
  const built = ["release", "debug"].map((profile) => resolve(PACKAGE, "../../../target", profile, "cspace"));
  return (named ? [named] : built).find((path) => existsSync(path)) ?? null;
}

export const NO_COMMAND = "there is no cspace command: build it, or name it in CSPACE";

/** What the command prints, whose answer is yes or no; an error if there is none. */
export function run(args: string[], input = ""): string {
  const path = binary();
  if (!path) throw new Error(NO_COMMAND);
  const done = spawnSync(path, args, { input, encoding: "utf8", maxBuffer: 1 << 30, timeout: 120_000 });
  if (done.status !== 0 && done.status !== 1) throw new Error(`cspace ${args.join(" ")}: ${done.stderr}`);
  return done.stdout;
}

/** All models that come with the project. */
export function models(): string[] {
  const only = process.env["MODELS"]?.split(",");
  const all = [MODELS, join(MODELS, "paper")].flatMap((folder) =>
    readdirSync(folder)
      .filter((name) => name.endsWith(".toml"))
      .sort()
      .map((name) => join(folder, name)),
  );
  return only ? all.filter((path) => only.some((part) => path.includes(part))) : all;
}
