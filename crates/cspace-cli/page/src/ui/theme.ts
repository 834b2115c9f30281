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

/** The theme that comes after another when it is changed. */
export const NEXT_THEME = { auto: "dark", dark: "light", light: "auto" } as const;

/** What the button of a theme says. */
export const themeText = (theme: Theme): string => `Theme: ${theme}`;

/** As the system has it, now and later, until another is asked for by what is returned, which gives its name. */
export function followTheme(): () => Theme {
  let theme: Theme = "auto";
  applyTheme(theme);
  onSystemTheme(() => applyTheme(theme));
  return () => {
    theme = NEXT_THEME[theme];
    applyTheme(theme);
    return theme;
  };
}
