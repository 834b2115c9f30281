/** What the page asks of the server that serves it. */

import type { ScenePair } from "../scene.js";

export class ServerError extends Error {
  constructor(
    message: string,
    /** Asked again, the server may answer: it says nothing of the model. */
    readonly passing = false,
  ) {
    super(message);
  }
}

/** Whether this page is served by the command, which sends the policy itself: that of a file is in force wherever its host. */
export function isServed(): boolean {
  return document.querySelector("meta[name=policy]") !== null;
}

/** A pair of the model as it was opened, which the server computes as fast as the machine can. */
export async function servedPair(index: number): Promise<ScenePair> {
  const answer = await ask(`pair/${index}`);
  return (await answer.json()) as ScenePair;
}

async function ask(route: string): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(route);
  } catch {
    throw new ServerError("the server does not answer: is `cspace view` still running?", true);
  }
  if (answer.ok) return answer;
  const said = (await answer.json().catch(() => ({}))) as { error?: string };
  throw new ServerError(said.error ?? `the server answers ${answer.status}`);
}
