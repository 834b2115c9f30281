/** The keys of the page. */

import type { Actions } from "./actions.js";
import { isAxes } from "./mechanism.js";
import type { Session } from "./session.js";
import type { Viewport } from "./viewport.js";

/** A key press moves by so many pixels, and turns by so much. */
const PIXELS = 8;
const ANGLE = Math.PI / 180;
/** With Shift. */
const FINE = 0.1;

export function listenToKeys(session: Session, actions: Actions, viewports: { parts: Viewport; plane: Viewport }): void {
  document.addEventListener("keydown", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : null;
    if (document.querySelector("dialog[open]")) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    // Text that is typed is taken back by the browser.
    if ((event.ctrlKey || event.metaKey) && key === "z" && !target?.matches("input:not([type=range], [type=checkbox]), textarea")) {
      event.preventDefault();
      if (event.shiftKey) actions.redo();
      else actions.undo();
      return;
    }
    if (key === "Escape") actions.leave();
    if (event.ctrlKey || event.metaKey || event.altKey || target?.matches("input, select, textarea")) return;
    const fine = event.shiftKey ? FINE : 1;
    const step = steps(session, viewports);
    const does: Record<string, () => void> = {
      ArrowLeft: () => session.nudge(-fine * step.x, 0),
      ArrowRight: () => session.nudge(fine * step.x, 0),
      ArrowUp: () => session.nudge(0, fine * step.y),
      ArrowDown: () => session.nudge(0, -fine * step.y),
      q: () => session.turn(fine * ANGLE),
      e: () => session.turn(-fine * ANGLE),
      "[": () => session.turn(fine * ANGLE),
      "]": () => session.turn(-fine * ANGLE),
      // What Shift makes of the brackets.
      "{": () => session.turn(FINE * ANGLE),
      "}": () => session.turn(-FINE * ANGLE),
      PageUp: () => session.stepBand(1),
      PageDown: () => session.stepBand(-1),
      s: actions.toggleStop,
      c: actions.toggleCut,
      m: actions.toggleMeasure,
      f: actions.fit,
      "0": () => session.reset(),
      "?": actions.help,
      " ": actions.play,
      Delete: actions.removeVertex,
      Backspace: actions.removeVertex,
    };
    // A button takes the space bar for itself.
    if (key === " " && target?.matches("button, summary, a")) return;
    const action = does[key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/** A press moves by the same number of pixels at every zoom. */
function steps(session: Session, { parts, plane }: { parts: Viewport; plane: Viewport }): { x: number; y: number } {
  const { pixel } = isAxes(session.state.configuration) ? plane : parts;
  return { x: PIXELS * pixel.x, y: PIXELS * pixel.y };
}
