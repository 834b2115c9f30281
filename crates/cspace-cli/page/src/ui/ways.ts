/** What the page plans and plays itself: the way out of the selected pair, and the motion of the mechanism. */

import { numbersOf } from "./legs.js";
import type { Timeline } from "./timeline.js";
import type { Session } from "./session.js";
import { answer, busy } from "./message.js";
import { regionName } from "./region-names.js";
import type { Edits, Question, Workshop } from "./workshop.js";

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

  /** Plays a way from here, or from elsewhere, to where the part is free for good, the widest if that is wanted; or says why there is none. */
  async out(widest: boolean, from = this.#session.state.configuration): Promise<void> {
    const { state } = this.#session;
    const edits = this.#edits();
    const text = await this.#busy("Looking for a way out …", "plan", () => this.#workshop.plan(state.pair, edits, numbersOf(from), [], widest));
    const plan = JSON.parse(text) as Plan;
    if (plan.verdict === "path") this.#timeline.play(widest ? "widest way out" : "way out", text, edits, () => this.out(widest, from));
    else this.#session.store.change({ message: answer(this.#why(plan)) });
  }

  #why({ verdict, enclosed }: Plan): string {
    const { pair, kernel } = this.#session;
    if (verdict === "from-blocked") return "The parts overlap here: there is no way out of an overlap.";
    if (!enclosed || !pair) return "No way out was found.";
    const [first, ...others] = enclosed.touching.map(([a, b]) => `${kernel?.words(a, false)} | ${kernel?.words(b, true)}`);
    const by = first === undefined ? "" : `, by ${first}${others.length > 0 ? ` and ${others.length} more` : ""}`;
    return `There is no way out: ${regionName(pair, enclosed.region)} is enclosed${by}.`;
  }

  /** Plays the whole mechanism, as its drives move it. */
  async mechanism(): Promise<void> {
    const edits = this.#edits();
    const text = await this.#busy("Computing the motion of the mechanism …", "simulate", () => this.#workshop.simulate(edits));
    this.#timeline.play("mechanism", text, edits, () => this.mechanism());
  }

  /** Plays how the assembly comes apart. */
  async apart(): Promise<void> {
    const edits = this.#edits();
    const text = await this.#busy("Taking the parts apart …", "disassemble", () => this.#workshop.disassemble(edits));
    this.#timeline.play("taken apart", text, edits, () => this.apart());
  }

  #busy(text: string, what: Question["what"], work: () => Promise<string>): Promise<string> {
    return busy(this.#session.store, text, () => this.#workshop.cancel(what), 0, work);
  }
}
