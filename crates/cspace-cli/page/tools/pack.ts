/** `npm run package`. */

import { mkdirSync } from "node:fs";
import { resolve } from "node:path";
import { pack } from "./package.js";

const to = resolve(process.cwd(), "build/npm");
mkdirSync(to, { recursive: true });
console.log(pack(resolve(process.cwd(), "build/kernel"), to));
