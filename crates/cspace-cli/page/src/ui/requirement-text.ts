/** What is said of a requirement. */

import { html } from "./dom.js";
import { degrees, length, rounded, short } from "./numbers.js";
import type { CheckRow } from "./workshop.js";

/** Digits of a value. */
const DIGITS = 4;

export function requirementText({ dimension, failure }: CheckRow, value: number | boolean | null, unit: string | null): string {
  if (value === null) return failure ?? "none";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (dimension === "angle") return degrees(value, DIGITS);
  if (dimension === "time") return `${short(rounded(value, DIGITS))} s`;
  return dimension === "length" ? length(rounded(value, DIGITS), unit) : short(rounded(value, DIGITS));
}

/** Whether it is met, as a sign with words. */
export function requirementMark({ undecided, met }: CheckRow): HTMLElement {
  const [sign, words, kind] = undecided ? ["?", "not decided", ""] : met === null ? ["·", "measured alone", ""] : met ? ["✓", "met", " met"] : ["✗", "not met", " unmet"];
  return html("span", { class: `mark${kind}`, role: "img", title: words, "aria-label": words }, sign);
}
