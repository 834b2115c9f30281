/** What the page plans and plays itself: the way out of the selected pair, and the motion of the mechanism. */

import { numbersOf } from "./legs.js";
import type { Timeline } from "./timeline.js";
import type { Session } from "./session.js";
import { regionName } from "./region-names.js";
import type { Edits, Workshop } from "./workshop.js";

/** What is read of a plan. */
interface Plan {
  verdict: "path" | "no-path" | "from-blocked" | "to-blocked" | "unknown";
  enclosed?: { region: number; patches: number; touching: [string, string][] };
}

export class Ways {
  readonly #session: Session;
  readonly #workshop: Workshop;
  readonly #timeline: Timeline;
  readonly #edits: () => Edits;

  constructor(session: Session, workshop: Workshop, timeline: Timeline, edits: () => Edits) {
    this.#session = session;
    this.#workshop = workshop;
    this.#timeline = timeline;
    this.#edits = edits;
  }

  /** Plays a way to where the part is free for good, the widest if that is wanted; or says why there is none. */
  out(widest: boolean, from = this.#session.state.configuration): void {
    const { pair } = this.#session.state;
    const ask = (edits: Edits) => this.#workshop.plan(pair, edits, numbersOf(from), [], widest);
    void this.#answered("Looking for a way out …", ask, (text, edits) => {
      const plan = JSON.parse(text) as Plan;
      if (plan.verdict !== "path") this.#session.store.change({ message: this.#why(plan) });
      else this.#timeline.play(widest ? "widest way out" : "way out", text, edits, () => this.out(widest, from));
    });
  }

  #why({ verdict, enclosed }: Plan): string {
    const { pair } = this.#session;
    if (verdict === "from-blocked") return "The parts overlap here: there is no way out of an overlap.";
    if (!enclosed || !pair) return "No way out was found.";
    const [first, ...others] = enclosed.touching.map(([a, b]) => `${a} | ${b}`);
    const by = first === undefined ? "" : `, by ${first}${others.length > 0 ? ` and ${others.length} more` : ""}`;
    return `There is no way out: ${regionName(pair, enclosed.region)} is enclosed${by}.`;
  }

  /** Plays the whole mechanism, as its drives move it. */
  mechanism(): void {
    const ask = (edits: Edits) => this.#workshop.simulate(edits);
    void this.#answered("Computing the motion of the mechanism …", ask, (text, edits) => this.#timeline.play("mechanism", text, edits, () => this.mechanism()));
  }

  /** Asks about the model as it is edited; says what is done as long as it is, and what went wrong. */
  async #answered(message: string, ask: (edits: Edits) => Promise<string>, take: (text: string, edits: Edits) => void): Promise<void> {
    const { store } = this.#session;
    const edits = this.#edits();
    store.change({ message });
    try {
      take(await ask(edits), edits);
    } catch (error) {
      store.change({ message: error instanceof Error ? error.message : String(error) });
    } finally {
      if (store.state.message === message) store.change({ message: null });
    }
  }
}
