/** What `cspace disassemble` prints, as a motion of all parts: step by step, and what has left goes on out of the way of what comes later. */

import type { Configuration } from "../kernel/api.js";
import type { Scene } from "../scene.js";
import { distance, onLeg } from "./legs.js";
import { IDENTITY, compose, type Placement } from "./placement.js";
import type { PlayableRecord, Sample, Tick } from "./playable.js";
import { RecordError, array, configuration, isObject, number, type Json } from "./record-json.js";

/** Each step is played in so many seconds, */
const STEP_SECONDS = 2;
/** and so is how what has left goes on. */
const ONWARD_SECONDS = 0.7;
/** States are known so often in a second: as often as a screen shows them. */
const RATE = 60;

interface Step {
  leaves: boolean;
  moving: string[];
  staying: string[];
  path: Configuration[];
  about: [number, number];
  words: string[];
  onward: [number, number];
}

export function readAssembly(name: string, record: Json): PlayableRecord {
  const verdict = String(record["verdict"]);
  const tree = isObject(record["tree"]) ? record["tree"] : {};
  const parts = array(name, tree["parts"], "tree.parts").map(String);
  const steps = array(name, record["steps"], "steps").map((s, i) => readStep(name, s, `steps[${i}]`, parts));
  if (steps.length === 0) throw new RecordError(`${name}: there is no step to play; the verdict is "${verdict}"`);
  const played = new Played(parts, steps);
  steps.forEach((step, i) => played.play(step, i + 1));
  const summary = `${verdict}, ${steps.length} ${steps.length === 1 ? "step" : "steps"}`;
  return { kind: "simulation", name, duration: played.time, ticks: played.ticks, summary, parts, steps: played.samples };
}

/** In which order it comes apart, in a sentence; none where that is not known. */
export function orderOf(record: Json): string | null {
  const steps = Array.isArray(record["steps"]) ? (record["steps"] as { kind: string; moving: string[] }[]) : [];
  if (record["verdict"] === "locked") return "All of it together does not come apart: it is locked.";
  if (record["verdict"] !== "apart" || steps.length === 0) return null;
  const told = steps.map(({ kind, moving }) => `${moving.join(" with ")}${kind === "leaves" ? "" : " aside"}`);
  return `All of it comes apart: first ${told.join(", then ")}.`;
}

/** Whether a mechanism is an assembly of free parts, which may come apart. */
export function isAssembly({ parts, joints }: Pick<Scene, "parts" | "joints">): boolean {
  const free = parts.filter(({ motion }) => motion.type === "planar").length;
  return parts.length > 2 && joints.length === 0 && free > 0 && parts.every(({ motion }) => motion.type === "planar" || motion.type === "fixed");
}

function readStep(name: string, step: unknown, place: string, known: readonly string[]): Step {
  if (!isObject(step)) throw new RecordError(`${name}: ${place} is no object`);
  const names = (key: string) => array(name, step[key], `${place}.${key}`).map(String);
  const two = (key: string): [number, number] => {
    const values = array(name, step[key] ?? [0, 0], `${place}.${key}`);
    return [number(name, values[0], `${place}.${key}[0]`), number(name, values[1], `${place}.${key}[1]`)];
  };
  const path = array(name, step["path"], `${place}.path`).map((c, i) => configuration(name, c, i, `${place}.path`));
  const [moving, staying] = [names("moving"), names("staying")];
  const unknown = [...moving, ...staying].find((part) => !known.includes(part));
  if (unknown !== undefined) throw new RecordError(`${name}: ${place} has a part "${unknown}", which is not in "tree"`);
  if (path.length === 0 || moving.length === 0) throw new RecordError(`${name}: nothing moves in ${place}`);
  return { leaves: step["kind"] === "leaves", moving, staying, path, about: two("about"), words: names("words"), onward: two("onward") };
}

/** The parts as they are played. */
class Played {
  readonly samples: Sample[] = [];
  readonly ticks: Tick[] = [];
  time = 0;
  /** The frame of the parts that each part is among, which moves when these leave together; */
  readonly #frames: Map<string, Placement>;
  /** where each part is in that frame, and the coordinates of parts on axes. */
  readonly #at: Map<string, Placement | number>;

  constructor(parts: readonly string[], steps: readonly Step[]) {
    this.#frames = new Map(parts.map((part) => [part, IDENTITY]));
    this.#at = new Map(parts.map((part) => [part, IDENTITY]));
    for (const { path, moving } of steps) if (path[0] && "u" in path[0]) for (const part of moving) this.#at.set(part, 0);
    this.#sample();
  }

  play(step: Step, index: number): void {
    const before = new Map(step.moving.map((part) => [part, this.#at.get(part) ?? IDENTITY]));
    const legs = step.path.slice(1).map((to, i) => ({ from: step.path[i] ?? to, to }));
    const total = legs.reduce((sum, { from, to }) => sum + distance(from, to), 0);
    const told = `${index}. ${step.moving.join(", ")} ${step.leaves ? "out" : step.moving.length === 1 ? "makes room" : "make room"}`;
    legs.forEach(({ from, to }, i) => {
      const seconds = total > 0 ? (STEP_SECONDS * distance(from, to)) / total : STEP_SECONDS / legs.length;
      this.#motion(`${told}: ${step.words[i] ?? ""}`, seconds, (f) => {
        const c = onLeg(from, to, step.about, f);
        if (c) this.#place(before, c);
      });
    });
    if (!step.leaves) return;
    const last = step.path[step.path.length - 1];
    if (!last || !("x" in last)) return;
    const gone = (f: number) => ({ ...last, x: last.x + f * step.onward[0], y: last.y + f * step.onward[1] });
    this.#motion(`${index}. ${step.moving.join(", ")} ${step.moving.length === 1 ? "is" : "are"} out`, ONWARD_SECONDS, (f) => this.#place(before, gone(f)));
    // The parts are among themselves from now on.
    for (const [part, at] of before) {
      this.#frames.set(part, compose(this.#frames.get(part) ?? IDENTITY, gone(1)));
      this.#at.set(part, at);
    }
  }

  #motion(text: string, seconds: number, place: (share: number) => void): void {
    this.ticks.push({ t: this.time, text });
    const [start, count] = [this.time, Math.max(1, Math.ceil(seconds * RATE))];
    for (let k = 1; k <= count; k += 1) {
      place(k / count);
      this.time = start + (seconds * k) / count;
      this.#sample();
    }
  }

  /** Moves parts from where they were before the step. */
  #place(before: ReadonlyMap<string, Placement | number>, c: Configuration): void {
    for (const [part, at] of before) this.#at.set(part, "u" in c ? c.v : typeof at === "number" ? at : compose(c, at));
  }

  #sample(): void {
    const parts = new Map<string, Placement | number>();
    for (const [part, at] of this.#at) parts.set(part, typeof at === "number" ? at : compose(this.#frames.get(part) ?? IDENTITY, at));
    this.samples.push({ t: this.time, time: this.time, parts });
  }
}
