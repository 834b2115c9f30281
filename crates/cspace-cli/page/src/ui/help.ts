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
  [["Escape"], "leave Measure, Edit, Parts and A | B"],
  [["?"], "this help"],
];

const POINTER: [string, string][] = [
  ["drag a part", "moves it along or about its axis; with Shift a free part is turned"],
  ["wheel over the moving part", "turns it; anywhere with Shift (with Alt ten times finer)"],
  ["drag the point", "moves the configuration in the slice; in 3-D with Shift up and down, which turns the part"],
  ["two fingers on the moving part", "turn it"],
  ["drag beside them", "moves the picture, or looks from elsewhere; wheel or two fingers zoom, a double click shows all"],
  ["click in the side view", "shows what is at that height alone; another click shows all heights"],
  ["double click an edge", "adds a vertex to it, while parts are edited"],
  ["drag a vertex", "while parts are edited: it snaps to a grid, with Alt it does not"],
  ["drop a file", "opens a model (TOML) or a drawing (DXF, SVG), or plays what cspace plan, disassemble or simulate prints with --json"],
];

const WORDS: [string, string][] = [
  ["configuration", "where the moving part is, seen from the fixed one: x, y and the orientation θ; of two parts on axes, u and v"],
  ["surface", "all configurations in which the two parts touch: inside of it they would overlap"],
  ["slice", "the surface at one orientation: grey is overlap, a line is contact"],
  ["band", "orientations between which the same features can touch: θ goes from band to band at the ticks"],
  ["region, pocket", "free configurations that lead into each other; a pocket is one from which no way leads out"],
];

export function makeHelp(): { show(): void } {
  const dialog = byId<HTMLDialogElement>("help");
  const close = button("Close", () => dialog.close(), { style: "float: right" });
  const keys = KEYS.map(([names, text]) =>
    html("tr", {}, html("td", {}, ...names.flatMap((n, i) => [i > 0 ? " " : "", html("kbd", {}, n)])), html("td", {}, text)),
  );
  const pointer = POINTER.map(([what, text]) => html("tr", {}, html("td", {}, what), html("td", {}, text)));
  const words = WORDS.map(([what, text]) => html("tr", {}, html("td", {}, html("b", {}, what)), html("td", {}, text)));
  const more = html("p", {}, "More is in docs/page.md of the project, and in ", html("kbd", {}, "cspace view --help"), ".");
  dialog.append(close, html("h2", { id: "help-title" }, "Words"), html("table", {}, ...words), html("h2", {}, "Keys and pointers"), html("table", {}, ...keys, ...pointer), more);
  return { show: () => (dialog.open ? dialog.close() : dialog.showModal()) };
}
