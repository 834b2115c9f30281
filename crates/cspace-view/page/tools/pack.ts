/** `npm run package`. */

import { mkdirSync } from "node:fs";
import { resolve } from "node:path";
import { pack } from "./package.js";

const to = resolve(process.cwd(), "build/npm");
mkdirSync(to, { recursive: true });
// Where the program is built, unless another folder was chosen for it.
const built = process.env["CARGO_TARGET_DIR"] ?? resolve(process.cwd(), "../../../target");
console.log(pack(resolve(built, "wasm/kernel"), to));
