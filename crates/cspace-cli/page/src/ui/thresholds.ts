/** The values of a parameter at which an answer changes, exactly: where requirements begin or cease to be met, and free regions open or close. */

import type { Editor } from "./edit.js";
import type { Session } from "./session.js";
import { WorkError, type CheckRow, type Goal, type RegionChange, type Workshop } from "./workshop.js";

export interface Mark {
  at: number;
  /** What is so from there on, such as `the bolt comes out`. */
  text: string;
}

/** What is known of a parameter. */
export interface Found {
  name: string;
  marks: readonly Mark[];
  /** How far the search is, or why nothing was found; empty where all is in the marks. */
  text: string;
  isRunning: boolean;
}

type Range = readonly [number, number];

/** Places nearer to each other than this, relative to the range, are told as one. */
const SAME = 1e-6;

/** A requirement is met where all of these hold; one without limits has an answer if that is yes or no. */
export function goalsOf({ name, limits, equals, value }: CheckRow): Goal[] {
  if (equals !== undefined || typeof value === "boolean") return [{ requirement: name, relation: "equal", value: equals ?? true }];
  const [lo = -Infinity, hi = Infinity] = limits ?? [];
  const all: Goal[] = [{ requirement: name, relation: "at-least", value: lo }, { requirement: name, relation: "at-most", value: hi }];
  return all.filter((goal) => Number.isFinite(goal.value));
}

/** The ends, within a range, of where all goals of a requirement are met. */
export function requirementMarks(row: CheckRow, [lo, hi]: Range, met: readonly (readonly Range[])[]): Mark[] {
  const both = met.reduce((a, b) => a.flatMap((r) => b.map((s): Range => [Math.max(r[0], s[0]), Math.min(r[1], s[1])]).filter((r) => r[0] <= r[1])), [[lo, hi]]);
  return both.flatMap(([from, to]) => [
    ...(from > lo ? [{ at: from, text: answer(row, true) }] : []),
    ...(to < hi ? [{ at: to, text: answer(row, false) }] : []),
  ]);
}

function answer({ name, measure, pair, equals, limits }: CheckRow, isMet: boolean): string {
  if (limits) return `${name} is ${isMet ? "met" : "not met"}`;
  const truth = isMet === (equals ?? true);
  if (measure === "caged" && pair) return truth ? `${pair[1]} is held` : `${pair[1]} comes out`;
  return `${name}: ${truth ? "yes" : "no"}`;
}

export function regionMarks(changes: readonly RegionChange[]): Mark[] {
  const count = (regions: readonly [number, number] | null) => (regions ? `${regions[0]} free region${regions[0] === 1 ? "" : "s"}, ${regions[1] === 0 ? "none" : regions[1]} caged` : "no space");
  return changes.map(({ at, above }) => ({ at, text: count(above) }));
}

/** In order; what is so from the same place on is told together, at the place that was told first. */
export function joined(marks: readonly Mark[], [lo, hi]: Range): Mark[] {
  const all: Mark[] = [];
  // The order of what is told of one place is kept: places are compared by the cell of the first of them.
  for (const mark of marks) {
    const same = all.findIndex((m) => Math.abs(m.at - mark.at) <= SAME * (hi - lo));
    const other = all[same];
    if (!other) all.push(mark);
    else if (!other.text.split("; ").includes(mark.text)) all[same] = { ...other, text: `${other.text}; ${mark.text}` };
  }
  return all.sort((a, b) => a.at - b.at);
}

export class Thresholds {
  readonly #session: Session;
  readonly #editor: Editor;
  readonly #make: () => Workshop;
  readonly #show: (found: Found) => void;
  #searches: Workshop | null = null;
  /** What is sought or has been found: all that marks depend on. */
  #key = "";
  #asked = 0;
  #isRunning = false;

  /** `make` starts a worker for the searches, which take long. */
  constructor(session: Session, editor: Editor, make: () => Workshop, show: (found: Found) => void) {
    [this.#session, this.#editor, this.#make, this.#show] = [session, editor, make, show];
  }

  /** Looks for the marks of a parameter in a range, unless they are known or sought. */
  seek(name: string, range: Range): void {
    const edits = this.#editor.edits;
    const others = { ...edits, set: edits.set.filter((s) => s.name !== name) };
    const key = JSON.stringify([name, range, this.#session.state.pair, others]);
    if (key === this.#key) return;
    this.cancel();
    this.#key = key;
    void this.#search(name, range, others);
  }

  /** Ends the search; what was found stays. */
  cancel(): void {
    if (this.#isRunning) this.#searches?.cancel();
    this.#asked += 1;
    this.#isRunning = false;
  }

  async #search(name: string, range: Range, edits: Editor["edits"]): Promise<void> {
    const asked = (this.#asked += 1);
    this.#isRunning = true;
    const searches = (this.#searches ??= this.#make());
    let marks: Mark[] = [];
    const show = (text: string, isRunning: boolean) => {
      if (asked === this.#asked) this.#show({ name, marks: joined(marks, range), text, isRunning });
    };
    let failed = "";
    const work = async () => {
      const rows = this.#session.scene.design?.requirements.length ? await searches.check(this.#editor.edits) : [];
      const steps = rows.map((row) => ({ row, goals: goalsOf(row) })).filter(({ goals }) => goals.length > 0);
      const count = steps.reduce((sum, { goals }) => sum + goals.length, 1);
      let done = 0;
      const progress = () => show(`Looking for values at which something changes: ${(done += 1)} of ${count} …`, true);
      for (const { row, goals } of steps) {
        const met: Range[][] = [];
        for (const goal of goals) {
          progress();
          met.push((await searches.solve(edits, name, range, goal)).ranges ?? []);
        }
        marks = [...marks, ...requirementMarks(row, range, met)];
      }
      progress();
      marks = [...marks, ...regionMarks(await searches.regionChanges(this.#session.state.pair, edits, name, range))];
    };
    await work().catch((error: unknown) => {
      failed = error instanceof WorkError && error.cancelled ? "The search was ended." : error instanceof Error ? error.message : String(error);
    });
    show(failed || (marks.length === 0 ? "Nothing changes in this range." : ""), false);
    if (asked === this.#asked) this.#isRunning = false;
  }
}
