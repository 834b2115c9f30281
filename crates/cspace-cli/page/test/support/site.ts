/** The site that `docs/site` writes. */

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { MODELS, binary } from "./command.js";

/** Writes it to a folder, of some models or of all. */
export function writeSite(folder: string, models: readonly string[] = []): void {
  const env = { ...process.env, CSPACE: binary() ?? "", CSPACE_CACHE: "off" };
  execFileSync("python3", [resolve(MODELS, "../docs/site"), folder, ...models], { env, stdio: ["ignore", "ignore", "pipe"] });
}

/** What a lesson says. */
export interface Lesson {
  title: string;
  choices: string[];
  /** Those that are right. */
  right: string[];
  answer: string;
}

export function lessonsOf(folder: string): Lesson[] {
  const text = readFileSync(join(folder, "teach.html"), "utf8");
  return [...text.matchAll(/<section class="lesson">([^]*?)<\/section>/g)].map(([, lesson = ""]) => {
    const buttons = [...lesson.matchAll(/<button type="button"( data-right)?>([^<]*)</g)];
    const said = (found: string[][]) => found.map(([, , text = ""]) => text);
    return {
      title: /<h2>([^<]*)</.exec(lesson)?.[1] ?? "",
      choices: said(buttons),
      right: said(buttons.filter(([, isRight]) => isRight)),
      answer: /<b><\/b>([^<]*)</.exec(lesson)?.[1] ?? "",
    };
  });
}
