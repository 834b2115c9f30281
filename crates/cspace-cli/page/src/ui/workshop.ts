/** Computes in a worker: pairs, and pairs of edited parts. The page goes on meanwhile. */

import type { Came } from "../../build/kernel/cspace.js";
import { compiledKernel } from "../kernel/load.js";
import type { SceneDesign, ScenePair, ScenePart, SceneSetting, SceneSource } from "../scene.js";

export interface PartEdit {
  index: number;
  loops: ScenePart["loops"];
  motion: ScenePart["motion"];
  /** How much the outline is grown (model unit). */
  offset?: number;
}

/** All that is changed of the model: values of parameters first, then parts. */
export interface Edits {
  set: readonly SceneSetting[];
  parts: readonly PartEdit[];
}

export const UNCHANGED: Edits = { set: [], parts: [] };

export interface EditAnswer {
  pair: ScenePair;
  /** All parts of the model. */
  parts: ScenePart[];
  design: SceneDesign | null;
}

/** A requirement, measured, as `cspace check --json` prints it. */
export interface CheckRow {
  name: string;
  /** The parts that it is about, if these are two. */
  pair?: [string, string];
  measure: string;
  value: number | boolean | null;
  dimension: "length" | "angle" | "time" | "number" | "truth";
  limits?: [number, number];
  equals?: boolean;
  met: boolean | null;
  margin: number | null;
  failure?: string;
  undecided?: boolean;
}

/** What `cspace solve --so-that` asks for. */
export interface Goal {
  requirement: string;
  relation: "equal" | "at-least" | "at-most";
  value: number | boolean;
}

/** Where the number of free regions, or of those that are caged, changes: [regions, caged] on both sides, null where there is no space. */
export interface RegionChange {
  at: number;
  below: [number, number] | null;
  above: [number, number] | null;
}

/** A contact that is dragged: where a straight motion first meets it, one coordinate is to have a value. */
export interface ContactDrag {
  from: number[];
  /** The displacement of the motion. */
  along: number[];
  of: "x" | "y" | "u" | "v";
  value: number;
  /** Parameters that may change: name, from, to. */
  spans: [string, number, number][];
}

/** The first message to a worker. */
export interface Start {
  module: WebAssembly.Module;
  /** The scene's source as JSON. */
  source: string;
}

/** What is asked; edits are {@link Edits} as JSON. Answers are JSON. */
export type Question =
  | { what: "pair"; pair: number }
  | { what: "edit"; pair: number; edits: string }
  | { what: "toml"; edits: string }
  | { what: "plan"; pair: number; edits: string; from: number[]; to: number[]; widest: boolean }
  | { what: "simulate"; edits: string }
  | { what: "disassemble"; edits: string }
  | { what: "check"; edits: string }
  | { what: "solve"; edits: string; question: string }
  | { what: "regions"; pair: number; edits: string; parameter: string; range: readonly [number, number] }
  | { what: "contact"; pair: number; edits: string; contact: string }
  | { what: "drag"; edits: string; drag: MechanismDrag };

/** A point of a part, in the part's frame, that is dragged to a place in the assembly. */
export interface MechanismDrag {
  part: number;
  of: [number, number];
  to: [number, number];
  /** Where the parts are when the drag begins: the coordinates of all that move, in order; null while it goes on. */
  state: number[] | null;
}

/** A model as TOML, and whether it has all that its file has beside what is edited: not only numbers. */
export interface ModelText {
  text: string;
  isWhole: boolean;
}

export type Request = { id: number } & Question;

export interface Answer {
  id: number;
  value?: string;
  error?: string;
}

/** Why there is no answer. */
export class WorkError extends Error {
  constructor(
    message: string,
    /** Nobody wants the answer any more: it says nothing of the model. */
    readonly cancelled = false,
  ) {
    super(message);
  }
}

interface Waiting {
  request: Request;
  resolve(value: string): void;
  reject(error: WorkError): void;
}

export class Workshop {
  readonly #script: string;
  readonly #source: string;
  /** Requests in order; the first is at work. */
  #waiting: Waiting[] = [];
  #worker: Worker;
  #count = 0;

  /** `script` is the source text of the worker. */
  constructor(script: string, source: SceneSource) {
    this.#script = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.#source = JSON.stringify(source);
    this.#worker = this.#start();
  }

  #start(): Worker {
    const worker = new Worker(this.#script);
    worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      const first = this.#waiting.findIndex((w) => w.request.id === data.id);
      const [done] = first < 0 ? [] : this.#waiting.splice(first, 1);
      if (data.value !== undefined) done?.resolve(data.value);
      else done?.reject(new WorkError(data.error ?? "the worker does not say why"));
    };
    // A fault of the kernel ends the worker: whoever asked is told, and the others are asked again.
    worker.onerror = (event) => this.#restart(new WorkError(event.message || "the worker has ended"));
    worker.postMessage({ module: compiledKernel(), source: this.#source } satisfies Start);
    return worker;
  }

  #restart(reason: WorkError): void {
    this.#worker.terminate();
    this.#worker = this.#start();
    this.#waiting.shift()?.reject(reason);
    for (const { request } of this.#waiting) this.#worker.postMessage(request);
  }

  /** Ends what is at work, or the first that asks so. */
  cancel(what?: Question["what"]): void {
    const at = what === undefined ? 0 : this.#waiting.findIndex((w) => w.request.what === what);
    const reason = new WorkError("nobody waits for it any more", true);
    // The answer to what waits behind other work is not taken.
    if (at > 0) this.#waiting.splice(at, 1)[0]?.reject(reason);
    else if (this.#waiting[at]) this.#restart(reason);
  }

  #ask(question: Question): Promise<string> {
    const request = { id: (this.#count += 1), ...question };
    return new Promise((resolve, reject) => {
      this.#waiting.push({ request, resolve, reject });
      this.#worker.postMessage(request);
    });
  }

  async pair(pair: number): Promise<ScenePair> {
    return { ...(JSON.parse(await this.#ask({ what: "pair", pair })) as ScenePair), own: true };
  }

  async edit(pair: number, edits: Edits): Promise<EditAnswer> {
    const answer = JSON.parse(await this.#ask({ what: "edit", pair, edits: JSON.stringify(edits) })) as EditAnswer;
    return { ...answer, pair: { ...answer.pair, own: true } };
  }

  async model(edits: Edits): Promise<ModelText> {
    const [text, isWhole] = JSON.parse(await this.#ask({ what: "toml", edits: JSON.stringify(edits) })) as [string, boolean];
    return { text, isWhole };
  }

  /** What `cspace plan --json` prints. */
  plan(pair: number, edits: Edits, from: number[], to: number[], widest: boolean): Promise<string> {
    return this.#ask({ what: "plan", pair, edits: JSON.stringify(edits), from, to, widest });
  }

  /** What `cspace simulate --json` prints, of as long as the slowest drive takes for a turn. */
  simulate(edits: Edits): Promise<string> {
    return this.#ask({ what: "simulate", edits: JSON.stringify(edits) });
  }

  /** What `cspace disassemble --json` prints. */
  disassemble(edits: Edits): Promise<string> {
    return this.#ask({ what: "disassemble", edits: JSON.stringify(edits) });
  }

  async drag(edits: Edits, drag: MechanismDrag): Promise<Came> {
    return JSON.parse(await this.#ask({ what: "drag", edits: JSON.stringify(edits), drag })) as Came;
  }

  /** What `cspace check --json` prints. */
  async check(edits: Edits): Promise<CheckRow[]> {
    return JSON.parse(await this.#ask({ what: "check", edits: JSON.stringify(edits) })) as CheckRow[];
  }

  /** What `cspace solve --json` prints, for one parameter; the ranges in which it is so are left out where there are none. */
  async solve(edits: Edits, parameter: string, [lo, hi]: readonly [number, number], goal: Goal): Promise<{ ranges?: [number, number][] }> {
    const question = JSON.stringify({ vary: [{ parameter, lo, hi }], so_that: goal });
    return JSON.parse(await this.#ask({ what: "solve", edits: JSON.stringify(edits), question })) as { ranges?: [number, number][] };
  }

  async regionChanges(pair: number, edits: Edits, parameter: string, range: readonly [number, number]): Promise<RegionChange[]> {
    return JSON.parse(await this.#ask({ what: "regions", pair, edits: JSON.stringify(edits), parameter, range })) as RegionChange[];
  }

  /** The smallest change of parameters that puts a contact where it is dragged to, or why there is none. */
  async contact(pair: number, edits: Edits, contact: ContactDrag): Promise<{ set: SceneSetting[]; none: string | null }> {
    const text = await this.#ask({ what: "contact", pair, edits: JSON.stringify(edits), contact: JSON.stringify(contact) });
    return JSON.parse(text) as { set: SceneSetting[]; none: string | null };
  }
}
