/** What the page says over its views: notes, answers, progress and errors. */

import { button, byId, html, say, set } from "./dom.js";
import type { Message, Store } from "./state.js";
import { WorkError } from "./workshop.js";

export const note = (text: string): Message => ({ kind: "note", text });
export const answer = (text: string): Message => ({ kind: "answer", text });

/** What is said of an error; nothing of work that nobody wants any more. */
export function failure(error: unknown): Message | null {
  return error instanceof WorkError && error.cancelled ? null : { kind: "error", text: error instanceof Error ? error.message : String(error) };
}

/** A note stays for so long, and for so much longer with each character (ms). */
const NOTE = 4000;
const PER_CHARACTER = 50;

let fading: ReturnType<typeof setTimeout> | undefined;

export function showMessage(message: Message | null, close: () => void): void {
  const element = byId("message");
  clearTimeout(fading);
  element.hidden = message === null;
  if (message === null) return;
  const { kind, text, cancel } = message;
  set(element, { class: kind, role: kind === "error" ? "alert" : "status" });
  const closing = () => button("✕", close, { class: "small", "aria-label": "Close the message" });
  const end = cancel ? [button("Cancel", cancel, { class: "small" })] : kind === "progress" ? [] : [closing()];
  element.replaceChildren(...(kind === "progress" ? [html("progress", { "aria-label": text })] : []), html("span", {}, text), ...end);
  if (kind === "note") fading = setTimeout(close, NOTE + PER_CHARACTER * text.length);
}

/** Says what is done as long as it is, once it takes longer than `after` (ms). */
export async function busy<T>(store: Store, text: string, cancel: () => void, after: number, work: () => Promise<T>): Promise<T> {
  const message: Message = { kind: "progress", text, cancel };
  const timer = setTimeout(() => store.change({ message }), after);
  try {
    return await work();
  } finally {
    clearTimeout(timer);
    if (store.state.message === message) store.change({ message: null });
  }
}

/** How long the browser has to draw a message before what keeps the page busy begins (ms). */
const DRAWN = 50;

/** Waits until a message is drawn. */
export function messageDrawn(): Promise<void> {
  return new Promise((drawn) => setTimeout(drawn, DRAWN));
}

/** Of a page that cannot be opened. */
export function showFailure(error: unknown): void {
  const element = byId("message");
  set(element, { hidden: null, class: "error", role: "alert" });
  say(element, error instanceof Error ? error.message : String(error));
}
