/** A | B: a state that is kept beside the one that is changed on, as ghosts in the drawing and in a table. */

import { byId, html, svg } from "./dom.js";
import { short } from "./numbers.js";
import { outlinePath } from "./outline.js";
import { matrix } from "./parts-view.js";
import { IDENTITY } from "./placement.js";
import { requirementMark, requirementText } from "./requirement-text.js";
import type { Session } from "./session.js";
import type { Kept, Key } from "./state.js";
import type { Viewport } from "./viewport.js";
import type { CheckRow } from "./workshop.js";

/** As many features that touch are listed. */
const LISTED = 3;

/** The state as it is; what it comes to is what the page says of it. */
function kept(session: Session): Kept {
  const { state, scene, kernel } = session;
  const { touching, nearest } = state.where;
  const deciding = touching.length > 0 ? touching : nearest ? [nearest] : [];
  const words = [...new Set(deciding.map((t) => `${kernel?.words(t.fixed, false)} | ${kernel?.words(t.moving, true)}`))];
  return {
    pair: state.pair,
    parts: state.parts,
    placements: state.placements,
    checked: state.checked ?? [],
    parameters: new Map(scene.design?.parameters.map((p) => [p.name, p.value]) ?? []),
    verdict: document.querySelector(".headline")?.textContent ?? "",
    decides: `${words.slice(0, LISTED).join("; ")}${words.length > LISTED ? ` and ${words.length - LISTED} more` : ""}`,
  };
}

export class Comparison {
  readonly #element = byId("compare");

  constructor(private readonly session: Session, { world }: Viewport) {
    const ghosts = svg("g", { class: "ghosts" });
    world.append(ghosts);
    session.store.subscribe((changed, { compared }) => {
      if (changed.has("compared")) {
        this.#element.hidden = !compared;
        ghosts.replaceChildren(...(compared?.parts ?? []).map((part, i) => svg("path", { d: outlinePath(part.loops), transform: matrix(compared?.placements[i] ?? IDENTITY) })));
      }
      // After those who say what the state comes to.
      if ((["compared", "checked", "where", "scene", "pair"] as Key[]).some((k) => changed.has(k))) queueMicrotask(() => this.#draw());
    });
  }

  /** Keeps the present state as A, or lets A go. */
  toggle(): void {
    const { store, state } = this.session;
    store.change({ compared: state.compared ? null : kept(this.session) });
  }

  #draw(): void {
    const a = this.session.state.compared;
    if (!a) return;
    const { scene, state } = this.session;
    const b = kept(this.session);
    const same = a.pair === b.pair;
    const row = (name: string, x: Node | string, y: Node | string) => html("tr", {}, html("th", { scope: "row" }, name), html("td", {}, x), html("td", {}, y));
    const parameters = [...b.parameters].filter(([name, value]) => a.parameters.get(name) !== value);
    const value = (rows: readonly CheckRow[], name: string) => {
      const found = rows.find((r) => r.name === name);
      return found ? html("span", {}, requirementMark(found), ` ${requirementText(found, found.value, scene.unit)}`) : "…";
    };
    this.#element.replaceChildren(
      html("table", {},
        html("thead", {}, html("tr", {}, html("td", {}), html("th", { scope: "col" }, "A"), html("th", { scope: "col" }, "B"))),
        html("tbody", {},
          ...parameters.map(([name, now]) => row(name, short(a.parameters.get(name) ?? NaN), short(now))),
          ...(scene.design?.requirements ?? []).map((name) => row(name, value(a.checked, name), state.checked ? value(b.checked, name) : "…")),
          row("verdict", a.verdict, same ? b.verdict : "another pair"),
          row("nearest", a.decides, same ? b.decides : "–"),
        ),
      ),
    );
  }
}

/** Whether a state can be kept: what it comes to has to be known. */
export function canKeep({ state, scene }: Session, button: HTMLButtonElement): void {
  const waits = scene.design !== null && scene.design.requirements.length > 0 && state.checked === null;
  button.disabled = !state.compared && (waits || state.space.state !== "ready");
  button.title = button.disabled ? "The state can be kept once its space and its requirements are computed" : state.compared ? "Let A go (Escape)" : "Keep this state as A, and see beside it what follows (ghosts in the drawing, and a table)";
}
