/** Drags any part of the mechanism: it pushes what is in its way, computed in the worker. */

import type { Place } from "../scene.js";
import { busy, failure } from "./message.js";
import { IDENTITY, apply, coordinateOf, inverse, ofMotion, type Placement } from "./placement.js";
import type { Session } from "./session.js";
import type { Drag } from "./viewport.js";
import type { Edits, Workshop } from "./workshop.js";

/** What takes longer is told (ms): at the first drag the spaces of all pairs are computed. */
const PATIENCE = 300;

export class MechanismHand {
  /** Where the point is wanted next; null if it is not dragged on. */
  #wanted: Place | null = null;
  #isAsking = false;

  constructor(private readonly session: Session, private readonly workshop: Workshop, private readonly edits: () => Edits) {}

  /** Takes a part at a place of the assembly. */
  grab(part: number, at: Place): Drag {
    const { store, state } = this.session;
    const of = apply(inverse(state.placements[part] ?? IDENTITY), at);
    let begin: number[] | null = this.#coordinates();
    store.change({ dragging: true, playing: false });
    const take = async () => {
      this.#isAsking = true;
      while (this.#wanted) {
        const to = this.#wanted;
        this.#wanted = null;
        const drag = { part, of: [of.x, of.y] as [number, number], to: [to.x, to.y] as [number, number], state: begin };
        const came = await busy(store, "Computing the pairs of the mechanism …", () => this.workshop.cancel("drag"), PATIENCE, () => this.workshop.drag(this.edits(), drag));
        begin = null;
        this.session.setPlacements(this.#placements(came.parts));
        store.change({ held: { stopped: came.stopped, overlapping: came.overlapping, gaps: came.gaps } });
      }
      this.#isAsking = false;
    };
    const failed = (error: unknown) => {
      this.#isAsking = false;
      store.change({ message: failure(error) });
    };
    return {
      move: (to) => {
        this.#wanted = to;
        if (!this.#isAsking) take().catch(failed);
      },
      end: () => store.change({ dragging: false }),
    };
  }

  /** Of all parts that move, in order. */
  #coordinates(): number[] {
    const { parts, placements } = this.session.state;
    return parts.flatMap(({ motion }, i) => {
      const p = placements[i] ?? IDENTITY;
      if (motion.type === "fixed") return [];
      return motion.type === "planar" ? [p.x, p.y, p.theta] : [coordinateOf(motion, p)];
    });
  }

  #placements(coordinates: readonly number[][]): Placement[] {
    return this.session.state.parts.map(({ motion }, i) => {
      const [a, b, c] = coordinates[i] ?? [];
      if (a === undefined) return IDENTITY;
      return b === undefined || c === undefined ? ofMotion(motion, a) : { x: a, y: b, theta: c };
    });
  }
}
