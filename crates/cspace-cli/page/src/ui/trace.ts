/** The path that a point of a part takes through the record. */

import { set, svg } from "./dom.js";
import { pathOf } from "./curves.js";
import { placed } from "./mechanism.js";
import { IDENTITY, apply, type Placement } from "./placement.js";
import { pathAt } from "./playable.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import type { Viewport } from "./viewport.js";

/** A planned path is drawn by so many places: on a leg a part turns while it goes. */
const PLACES = 400;

export function showTrace(session: Session, { world }: Viewport): void {
  const path = svg("path", { class: "trace" });
  world.append(path);
  session.store.subscribe((changed, { traced, record, stale }) => {
    if (!(["traced", "record", "stale", "parts"] as Key[]).some((k) => changed.has(k))) return;
    const points = traced && traced !== "next" && record && !stale ? placementsOf(session).map((p) => apply(p[traced.part] ?? IDENTITY, traced.at)) : [];
    set(path, { d: pathOf(points.flatMap(({ x, y }) => [x, y])) });
  });
}

/** Of all parts, as the record takes them. */
function placementsOf(session: Session): Placement[][] {
  const { state, scene, pair } = session;
  const { record } = state;
  if (record?.kind === "simulation") return record.steps.map((step) => session.placementsBy(step.parts));
  if (!record || !pair) return [];
  return Array.from({ length: PLACES + 1 }, (_, i) => pathAt(record, (record.duration * i) / PLACES)).flatMap((c) => (c ? [placed(scene, pair, state.placements, c)] : []));
}
