/** Computes in a worker: pairs, and pairs of edited parts. The page goes on meanwhile. */

import { compiledKernel } from "../kernel/load.js";
import type { ScenePair, ScenePart, SceneSource } from "../scene.js";

export interface PartEdit {
  index: number;
  loops: ScenePart["loops"];
  motion: ScenePart["motion"];
  /** How much the outline is grown (model unit). */
  offset?: number;
}

export interface EditAnswer {
  pair: ScenePair;
  parts: ScenePart[];
}

/** The first message to a worker. */
export interface Start {
  module: WebAssembly.Module;
  /** The scene's source as JSON. */
  source: string;
}

export interface Request {
  id: number;
  what: "pair" | "edit" | "toml";
  pair: number;
  /** {@link PartEdit}s as JSON. */
  edits: string;
}

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

  /** Ends what is at work. */
  cancel(): void {
    if (this.#waiting.length > 0) this.#restart(new WorkError("a newer request came", true));
  }

  #ask(what: Request["what"], pair: number, edits: readonly PartEdit[]): Promise<string> {
    const request = { id: (this.#count += 1), what, pair, edits: JSON.stringify(edits) };
    return new Promise((resolve, reject) => {
      this.#waiting.push({ request, resolve, reject });
      this.#worker.postMessage(request);
    });
  }

  async pair(index: number): Promise<ScenePair> {
    return JSON.parse(await this.#ask("pair", index, [])) as ScenePair;
  }

  async edit(pair: number, parts: readonly PartEdit[]): Promise<EditAnswer> {
    return JSON.parse(await this.#ask("edit", pair, parts)) as EditAnswer;
  }

  model(parts: readonly PartEdit[]): Promise<string> {
    return this.#ask("toml", 0, parts);
  }
}
