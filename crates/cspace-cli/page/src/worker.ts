/** The worker: it computes what takes longer than a frame. */

import { Hand, Model } from "../build/kernel/cspace.js";
import type { Scene, SceneSource } from "./scene.js";
import { use } from "./kernel/load.js";
import type { Answer, MechanismDrag, Request, Start } from "./ui/workshop.js";

/** What the worker knows once it has begun. */
interface Known {
  source: string;
  model: Model;
  hasPairs: boolean;
  /** The mechanism that was dragged last, and its edits. */
  hand: { hand: Hand; edits: string } | null;
}

let known: Known | null = null;

self.onmessage = ({ data }: MessageEvent<Start | Request>) => {
  if ("module" in data) {
    use(data.module);
    const { pairs } = JSON.parse(data.source) as SceneSource;
    known = { source: data.source, model: Model.fromSource(data.source), hasPairs: pairs.length > 0, hand: null };
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
      return known.hasPairs ? model.edit(asked.pair, asked.edits) : edited(model.toml(asked.edits));
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
    case "solve":
      return model.solve(asked.edits, asked.question);
    case "regions":
      return model.regionChanges(asked.pair, asked.edits, asked.parameter, ...asked.range);
    case "contact":
      return model.putContact(asked.pair, asked.edits, asked.contact);
    case "drag":
      return JSON.stringify(dragged(known, asked.edits, asked.drag));
  }
}

/** The answer to an edit of a model without pairs. */
function edited(toml: string): string {
  const [text] = JSON.parse(toml) as [string, boolean];
  const model = Model.read(text, "the model of this page");
  const { parts, design } = JSON.parse(model.scene()) as Scene;
  model.free();
  return JSON.stringify({ pair: { seconds: 0 }, parts, design });
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
