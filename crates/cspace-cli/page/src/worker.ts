/** The worker: it computes what takes longer than a frame. */

import { Hand, Model } from "../build/kernel/cspace.js";
import { use } from "./kernel/load.js";
import type { Answer, MechanismDrag, Request, Start } from "./ui/workshop.js";

/** What the worker knows once it has begun. */
interface Known {
  source: string;
  model: Model;
  /** The mechanism that was dragged last, and its edits. */
  hand: { hand: Hand; edits: string } | null;
}

let known: Known | null = null;

self.onmessage = ({ data }: MessageEvent<Start | Request>) => {
  if ("module" in data) {
    use(data.module);
    known = { source: data.source, model: Model.fromSource(data.source), hand: null };
    return;
  }
  const answer = (part: Omit<Answer, "id">) => self.postMessage({ id: data.id, ...part });
  try {
    if (!known) throw new Error("the worker has no model");
    answer({ value: done(known, data) });
  } catch (error) {
    answer({ error: error instanceof Error ? error.message : String(error) });
  }
};

function done(known: Known, asked: Request): string {
  const { model } = known;
  switch (asked.what) {
    case "pair":
      return model.pair(asked.pair);
    case "edit":
      return model.edit(asked.pair, asked.edits);
    case "toml":
      return model.toml(asked.edits);
    case "plan":
      return model.plan(asked.pair, asked.edits, Float64Array.from(asked.from), Float64Array.from(asked.to), asked.widest);
    case "simulate":
      return model.simulate(asked.edits);
    case "disassemble":
      return model.disassemble(asked.edits);
    case "check":
      return model.check(asked.edits);
    case "contact":
      return model.putContact(asked.pair, asked.edits, asked.contact);
    case "drag":
      return JSON.stringify(dragged(known, asked.edits, asked.drag));
  }
}

function dragged(known: Known, edits: string, { part, of, to, state }: MechanismDrag): unknown {
  if (known.hand?.edits !== edits) {
    known.hand?.hand.free();
    known.hand = { hand: new Hand(known.source, edits), edits };
  }
  const { hand } = known.hand;
  if (state) hand.setState(Float64Array.from(state));
  return hand.drag(part, Float64Array.from(of), Float64Array.from(to));
}
