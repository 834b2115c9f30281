/** What to try first, until it is dismissed. */

import { button, html } from "./dom.js";
import { keeping, kept } from "./kept.js";
import { isAxes } from "./mechanism.js";
import type { Session } from "./session.js";

const KEY = "cspace-hints-dismissed";

export function showHints(parent: HTMLElement, session: Session): void {
  if (kept(KEY) !== null) return;
  const axes = isAxes(session.state.configuration);
  const turns = matchMedia("(pointer: coarse)").matches ? "Two fingers turn it." : "The wheel turns it.";
  const hints = [
    axes ? "Drag a part: it moves on its axis, and stops where it touches." : `Drag the blue part: it stops where it touches and slides along. ${turns}`,
    axes ? "The point on the right is the same motion: both coordinates of the parts, where grey is overlap." : "The point on the right is the same place: in the slice grey is overlap, and its border is contact.",
    axes ? "Arrow keys move the point." : "Page Up and Page Down go from band to band of orientations between which contacts change.",
  ];
  const close = () => {
    parent.hidden = true;
    keeping(KEY, "1");
  };
  parent.replaceChildren(button("Got it", close, { class: "small" }), html("p", {}, hints.join(" ")));
  parent.hidden = false;
}
