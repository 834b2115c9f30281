/** What the page asks of the server that serves it. */

import type { ScenePair, ScenePart } from "../scene.js";

export interface PartEdit {
  index: number;
  loops: ScenePart["loops"];
  motion: ScenePart["motion"];
  /** How much the outline is grown (model unit). */
  offset?: number;
}

export interface EditAnswer {
  sequence: number;
  pair: ScenePair;
  parts: ScenePart[];
  seconds: number;
  total_seconds: number;
}

export class ServerError extends Error {
  constructor(
    message: string,
    /** A newer request has made this one useless. */
    readonly superseded = false,
    /** Asked again, the server may answer: it says nothing of the model. */
    readonly passing = superseded,
  ) {
    super(message);
  }
}

/** The answer to an edit that a newer one has made useless. */
const CONFLICT = 409;

export class Server {
  /** The server counts the edits of every page for itself. */
  readonly #session = crypto.randomUUID();
  #sequence = 0;

  /** Whether this page is served, and not a file. */
  static isThere(): boolean {
    return /^https?:$/.test(location.protocol) && ["127.0.0.1", "localhost", "[::1]"].includes(location.hostname);
  }

  async pair(index: number): Promise<ScenePair> {
    const answer = await ask(`pair/${index}`);
    return (await answer.json()) as ScenePair;
  }

  /** A pair of edited parts that are not being edited further: edits of a drag do not overtake it, nor it them. */
  async editedPair(pair: number, parts: readonly PartEdit[]): Promise<ScenePair> {
    const answer = await this.#post("edit", pair, parts, `${this.#session}-pair-${pair}`);
    return ((await answer.json()) as EditAnswer).pair;
  }

  async edit(pair: number, parts: readonly PartEdit[]): Promise<EditAnswer> {
    const answer = await this.#post("edit", pair, parts);
    return (await answer.json()) as EditAnswer;
  }

  async model(pair: number, parts: readonly PartEdit[]): Promise<string> {
    const answer = await this.#post("model", pair, parts);
    return answer.text();
  }

  /** Of a session, the server answers only the newest request. */
  #post(route: string, pair: number, parts: readonly PartEdit[], session: string = this.#session): Promise<Response> {
    const body = JSON.stringify({ session, sequence: (this.#sequence += 1), pair, parts });
    return ask(route, { method: "POST", headers: { "content-type": "application/json" }, body });
  }
}

export async function ask(route: string, init?: RequestInit): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(route, init);
  } catch {
    throw new ServerError("the server does not answer: is `cspace view` still running?", false, true);
  }
  if (answer.ok) return answer;
  const said = (await answer.json().catch(() => ({}))) as { error?: string; help?: string };
  const text = said.error ?? `the server answers ${answer.status}`;
  throw new ServerError(said.help ? `${text} (${said.help})` : text, answer.status === CONFLICT);
}
