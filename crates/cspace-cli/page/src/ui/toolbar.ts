/** The bar at the top: which model and pair, switches and files. */

import type { Actions } from "./actions.js";
import { isAssembly } from "./assembly-record.js";
import { canKeep } from "./compare.js";
import { button, byId, html, say, set } from "./dom.js";
import type { Editor } from "./edit.js";
import { canStepForth, isStep } from "./entries.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { themeText } from "./theme.js";

export class Toolbar {
  constructor(session: Session, actions: Actions, select: (pair: number) => void, editor: Editor | null) {
    const name = session.scene.name || "cspace";
    say(byId("model-name"), name);
    byId("model-name").title = name;
    document.title = `${name} – cspace`;
    const choice = byId<HTMLSelectElement>("pair");
    const of = (i: number) => session.scene.parts[i]?.name ?? "?";
    choice.append(...session.scene.pairs.map((p, i) => html("option", { value: i }, `${of(p.fixed)} | ${of(p.moving)}${p.class === "lower" ? " (joined)" : ""}`)));
    // Of one pair there is no choice.
    if (choice.parentElement) choice.parentElement.hidden = session.scene.pairs.length < 2;
    choice.addEventListener("change", () => select(choice.selectedIndex));

    const tools = byId("tools");
    const tool = (text: string, label: string, action: (event: MouseEvent) => void, parent = tools) => {
      const b = button(text, action, { title: label });
      parent.append(b);
      return b;
    };
    const slice = tool("Slice", "The slice at the current orientation beside the parts, or the plane of both motions, as large as they are", () => actions.toggleView("slice"));
    const space = tool("Space", "The surface of all contacts in x, y and orientation, and the bands between which contacts change", () => actions.toggleView("space"));
    const stop = tool("Stop at contact", "The moving part stops and slides where it touches (s)", actions.toggleStop);
    const colours = tool("Kinds", "Colour patches by the kind of contact", actions.toggleColouring, byId("details"));
    const cut = tool("Cut", "Cut the surface away above the current orientation (c)", actions.toggleCut);
    const fit = tool("Fit", "Show everything (f)", actions.fit);
    const measure = tool("Measure", "Click two corners or edges of parts: their distance is shown, and follows them (m)", actions.toggleMeasure);
    const edit = editor ? tool("Edit", "Drag vertices, arcs and pivots", actions.toggleEdit) : null;
    tool("New", "Begin a model from nothing", actions.newModel);
    tool("Open", "Open a model (TOML) or a drawing (DXF, SVG), or play what cspace plan or cspace simulate printed", actions.openRecord);
    tool("SVG", "Save a picture as SVG; with Shift in the colours of the page", (event) => actions.saveSvg(event.shiftKey));
    tool("PNG", "Save a picture as PNG; with Shift in the colours of the page", (event) => actions.savePng(event.shiftKey));
    tool("Save page", "Save this page as one file, with the model as it is changed", actions.savePage);
    const theme = tool("Theme", "Light, dark, or as the system", actions.toggleTheme);
    tool("?", "Help (?)", actions.help).setAttribute("aria-label", "Help");
    fit.setAttribute("aria-label", "Fit");
    // What the worker computes.
    const ways = byId("ways");
    ways.hidden = !editor;
    const changes = byId("changes");
    changes.hidden = !editor;
    const undo = tool("Undo", "Take the last change back (Ctrl-Z)", actions.undo, changes);
    const redo = tool("Redo", "Make it again (Ctrl-Shift-Z)", actions.redo, changes);
    const parts = tool("Parts", "Add parts, rename and remove them", actions.toggleParts, changes);
    tool("Save model", "Save the model as it is changed (TOML)", actions.saveModel, changes);
    const out = tool("Way out", "Plan a way from here to where the moving part is free, and play it; with Shift the widest", (event) => actions.wayOut(event.shiftKey), ways);
    const play = tool("Play mechanism", "Play the whole mechanism, as its drives move it", actions.playMechanism, ways);
    disable(play, moves(session.scene.source?.model ?? "") ? null : "Nothing moves by itself: the model has no drives, loads, springs or masses");
    if (isAssembly(session.scene)) tool("Take apart", "Find how all parts come apart, one after the other, and play it", actions.takeApart, ways);
    const whole = tool("Push all parts", "What is dragged pushes all parts of the mechanism, and not the selected pair alone", actions.toggleWhole, ways);
    const compare = tool("A | B", "", actions.toggleCompare, changes);
    disable(whole, session.scene.parts.length > 2 ? null : "The selected pair is the whole mechanism");

    session.store.subscribe((changed, state) => {
      if ((["scene", "space", "checked", "compared"] as Key[]).some((k) => changed.has(k))) canKeep(session, compare);
      if (changed.has("scene") || changed.has("parts")) {
        undo.disabled = !editor?.canUndo && !isStep();
        redo.disabled = !editor?.canRedo && !canStepForth();
      }
      if (changed.has("pair")) choice.selectedIndex = state.pair;
      const pressed = (b: HTMLElement | null, on: boolean) => b && set(b, { "aria-pressed": String(on) });
      pressed(slice, state.view === "slice");
      pressed(space, state.view === "space");
      pressed(stop, state.stop);
      pressed(colours, state.colouring === "kind");
      pressed(cut, state.cut);
      pressed(edit, state.editing);
      pressed(parts, state.making);
      pressed(measure, state.measuring);
      pressed(whole, state.whole);
      pressed(compare, state.compared !== null);
      say(theme, themeText(state.theme));
      if ((["pair", "scene", "space", "view"] as Key[]).some((k) => changed.has(k))) {
        const pair = session.pair;
        const axes = pair?.class === "fixed-axes";
        slice.hidden = !pair || pair.class === "lower";
        out.hidden = space.hidden = slice.hidden || axes;
        cut.hidden = space.hidden || state.view !== "space";
        say(slice, axes ? "Plane" : "Slice");
      }
    });
  }
}

/** A button that would do nothing says why. */
function disable(b: HTMLButtonElement, why: string | null): void {
  b.disabled = why !== null;
  if (why !== null) b.title = why;
}

/** Whether anything in a model moves by itself, by its TOML as the program writes it. */
function moves(model: string): boolean {
  return /^\[\[(drive|load|spring)\]\]|^(mass|density) *=/m.test(model);
}
