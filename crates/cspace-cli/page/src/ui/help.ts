/** What keys and pointers do, in a dialog. */

import { button, byId, html } from "./dom.js";

const KEYS: [string[], string][] = [
  [["←", "→", "↑", "↓"], "move the part, or u and v (with Shift ten times finer)"],
  [["q", "e"], "turn it; also [ and ] (with Shift ten times finer)"],
  [["Page Up", "Page Down"], "next and previous band"],
  [["s"], "let the moving part stop and slide at contact, or not"],
  [["c"], "cut the surface at the current orientation"],
  [["m"], "measure: click two corners or edges of parts"],
  [["f"], "show everything again"],
  [["0"], "parts as they are drawn"],
  [["Space"], "play or pause a record"],
  [["Delete"], "remove the selected vertex; also Alt-click on it"],
  [["Ctrl", "z"], "undo an edit; with Shift redo it"],
  [["?"], "this help"],
];

const POINTER: [string, string][] = [
  ["drag a part", "moves it along or about its axis; with Shift a free part is turned"],
  ["wheel over the moving part", "turns it; anywhere with Shift (with Alt ten times finer)"],
  ["drag the point", "moves the configuration in the slice; in 3-D with Shift up and down, which turns the part"],
  ["drag beside them", "moves the picture, or looks from elsewhere; wheel or two fingers zoom, a double click shows all"],
  ["click in the side view", "shows what is at that height alone; another click shows all heights"],
  ["double click an edge", "adds a vertex to it, while parts are edited"],
  ["drop a file", "plays what cspace plan or cspace simulate prints with --json"],
];

export function makeHelp(): { show(): void } {
  const dialog = byId<HTMLDialogElement>("help");
  const close = button("Close", () => dialog.close());
  const keys = KEYS.map(([names, text]) =>
    html("tr", {}, html("td", {}, ...names.flatMap((n, i) => [i > 0 ? " " : "", html("kbd", {}, n)])), html("td", {}, text)),
  );
  const pointer = POINTER.map(([what, text]) => html("tr", {}, html("td", {}, what), html("td", {}, text)));
  dialog.append(html("h2", { id: "help-title" }, "Keys and pointers"), html("table", {}, ...keys, ...pointer), close);
  return { show: () => (dialog.open ? dialog.close() : dialog.showModal()) };
}
