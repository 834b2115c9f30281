/** Drags a contact curve of the slice or of the plane (u, v): the parameters change by as little as puts the contact there. */

import type { AxesKernel, Configuration, DrawnCurve, PlanarKernel } from "../kernel/api.js";
import type { Place } from "../scene.js";
import type { Editor } from "./edit.js";
import { numbersOf } from "./legs.js";
import { failure, note } from "./message.js";
import type { Session } from "./session.js";
import type { Drag, Viewport } from "./viewport.js";
import type { ContactDrag, Workshop } from "./workshop.js";

/** How near to a curve it is grabbed (pixels). */
const GRAB = 8;
/** A way into free space is looked for so far from the curve first (pixels), then by halves. */
const BESIDE = 2;
const HALVINGS = 24;
/** Motions begin and end no farther from the curve than this (pixels). */
const FAR = 400;
/** A contact comes no nearer to the one across than by this share of the room between them. */
const ROOM = 0.9;

/** A curve in the hand: a place on it, and the way into free space from there, one pixel long. */
interface Held {
  at: Place;
  out: Place;
  /** How far it is free in that direction (pixels). */
  room: number;
}

type PairKernel = PlanarKernel | AxesKernel;

export class ContactHand {
  constructor(
    private readonly session: Session,
    private readonly workshop: Workshop,
    private readonly editor: Editor,
    private readonly spans: () => [string, number, number][],
  ) {}

  /** A drag of the curve at a place; null if there is none, or nothing is edited, or no parameter may change. */
  grab(at: Place, viewport: Viewport, kernel: PairKernel, curves: readonly DrawnCurve[], configuration: (p: Place) => Configuration): Drag | null {
    const { state, scene } = this.session;
    const spans = this.spans();
    if (!state.editing || !scene.design || spans.length === 0) return null;
    const held = this.#held(at, viewport.pixel, kernel, curves, configuration);
    if (!held) return null;
    const edits = this.editor.edits;
    const { store } = this.session;
    const pair = state.pair;
    const isPlanar = kernel.coordinates === "planar";
    let isFirst = true;
    // What is undone or typed meanwhile ends the drag: later answers would overwrite it.
    let { version } = this.editor;
    const isOver = () => this.editor.version !== version;
    let isAsking = false;
    let next: Place | null = null;
    const ask = async (to: Place): Promise<void> => {
      isAsking = true;
      try {
        const { set, none } = await this.workshop.contact(pair, edits, dragOf(held, at, to, viewport.pixel, spans, configuration, isPlanar));
        if (isOver()) return;
        if (none === null) {
          this.editor.setParameters(set, isFirst);
          ({ version } = this.editor);
          isFirst = false;
        } else store.change({ message: note(`The contact cannot be put there: ${none}.`) });
      } catch (error) {
        store.change({ message: failure(error) });
      }
      isAsking = false;
      const again = next;
      next = null;
      if (again) void ask(again);
    };
    store.change({ dragging: true, playing: false, message: null });
    return {
      move: (to) => {
        if (isOver()) return;
        if (isAsking) next = to;
        else void ask(to);
      },
      end: () => store.change({ dragging: false }),
    };
  }

  #held(at: Place, pixel: Place, kernel: PairKernel, curves: readonly DrawnCurve[], configuration: (p: Place) => Configuration): Held | null {
    const found = nearestOn(at, pixel, curves);
    if (!found || found.distance > GRAB) return null;
    const { place, along } = found;
    // Across the curve on the screen, to either side.
    const across = { x: -along.y * pixel.x, y: along.x * pixel.y };
    for (let beside = BESIDE, i = 0; i < HALVINGS; beside /= 2, i += 1) {
      for (const sign of [1, -1]) {
        const out = { x: sign * across.x, y: sign * across.y };
        const begin = moved(place, out, beside);
        if (kernel.classify(configuration(begin) as never) !== "free") continue;
        const reached = kernel.advance(configuration(begin) as never, configuration(moved(place, out, FAR)) as never).at;
        const [x = 0, y = 0] = numbersOf(reached);
        const end = { x, y };
        const room = beside + Math.hypot((end.x - begin.x) / pixel.x, (end.y - begin.y) / pixel.y);
        return { at: place, out, room };
      }
    }
    return null;
  }
}

/** What is asked: a motion against the curve from the middle of what is free, and where it is to meet the contact. */
function dragOf({ at, out, room }: Held, from: Place, to: Place, pixel: Place, spans: [string, number, number][], configuration: (p: Place) => Configuration, isPlanar: boolean): ContactDrag {
  // How far it is dragged, along the way out, in pixels.
  const unit = { x: out.x / pixel.x, y: out.y / pixel.y };
  const by = Math.min(((to.x - from.x) / pixel.x) * unit.x + ((to.y - from.y) / pixel.y) * unit.y, ROOM * room);
  const begin = moved(at, out, (Math.max(by, 0) + room) / 2);
  const end = moved(at, out, Math.min(by, 0) - FAR);
  const wanted = moved(at, out, by);
  const isAcross = Math.abs(unit.x) >= Math.abs(unit.y);
  const displacement = [end.x - begin.x, end.y - begin.y];
  return {
    from: numbersOf(configuration(begin)),
    along: isPlanar ? [...displacement, 0] : displacement,
    of: isPlanar ? (isAcross ? "x" : "y") : isAcross ? "u" : "v",
    value: isAcross ? wanted.x : wanted.y,
    spans,
  };
}

function moved(at: Place, by: Place, times: number): Place {
  return { x: at.x + by.x * times, y: at.y + by.y * times };
}

/** The nearest place on curves, the direction of the curve there as it is on the screen (unit), and the distance in pixels. */
function nearestOn(at: Place, pixel: Place, curves: readonly DrawnCurve[]): { place: Place; along: Place; distance: number } | null {
  let best: { place: Place; along: Place; distance: number } | null = null;
  for (const { points } of curves) {
    for (let i = 0; i + 3 < points.length; i += 2) {
      const a = { x: points[i] ?? 0, y: points[i + 1] ?? 0 };
      const d = { x: ((points[i + 2] ?? 0) - a.x) / pixel.x, y: ((points[i + 3] ?? 0) - a.y) / pixel.y };
      const p = { x: (at.x - a.x) / pixel.x, y: (at.y - a.y) / pixel.y };
      const size = Math.hypot(d.x, d.y);
      if (size === 0) continue;
      const share = Math.min(1, Math.max(0, (p.x * d.x + p.y * d.y) / (size * size)));
      const distance = Math.hypot(p.x - share * d.x, p.y - share * d.y);
      if (!best || distance < best.distance) {
        best = { place: { x: a.x + share * d.x * pixel.x, y: a.y + share * d.y * pixel.y }, along: { x: d.x / size, y: d.y / size }, distance };
      }
    }
  }
  return best;
}
