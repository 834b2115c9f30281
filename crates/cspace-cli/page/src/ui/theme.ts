/** Light and dark. */

import type { Theme } from "./state.js";

const DARK = "(prefers-color-scheme: dark)";

export function applyTheme(theme: Theme): void {
  const dark = theme === "dark" || (theme === "auto" && matchMedia(DARK).matches);
  document.documentElement.dataset["theme"] = dark ? "dark" : "light";
}

/** Calls back when the system turns light or dark. */
export function onSystemTheme(changed: () => void): void {
  matchMedia(DARK).addEventListener("change", changed);
}

/** As the system has it, now and later. */
export function followTheme(): void {
  applyTheme("auto");
  onSystemTheme(() => applyTheme("auto"));
}
