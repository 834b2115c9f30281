/** The line at the top that tells what went wrong. */

import { byId, html, say, set } from "./dom.js";

export function showMessage(message: string | null, close: () => void): void {
  const element = byId("message");
  element.hidden = message === null;
  if (message === null) return;
  const button = html("button", { type: "button", "aria-label": "Close the message" }, "✕");
  button.addEventListener("click", close);
  element.replaceChildren(html("span", {}, message), button);
}

/** How long the browser has to draw a message before what keeps the page busy begins (ms). */
const DRAWN = 50;

/** Waits until a message is drawn. */
export function messageDrawn(): Promise<void> {
  return new Promise((drawn) => setTimeout(drawn, DRAWN));
}

export function showFailure(error: unknown): void {
  const element = byId("message");
  set(element, { hidden: null });
  say(element, error instanceof Error ? error.message : String(error));
}
