/** The worker: it computes what takes longer than a frame. */

import { Model } from "../build/kernel/cspace.js";
import { use } from "./kernel/load.js";
import type { Answer, Request, Start } from "./ui/workshop.js";

let model: Model | null = null;

self.onmessage = ({ data }: MessageEvent<Start | Request>) => {
  if ("module" in data) {
    use(data.module);
    model = Model.fromSource(data.source);
    return;
  }
  const answer = (part: Omit<Answer, "id">) => self.postMessage({ id: data.id, ...part });
  try {
    if (!model) throw new Error("the worker has no model");
    answer({ value: done(model, data) });
  } catch (error) {
    answer({ error: error instanceof Error ? error.message : String(error) });
  }
};

function done(model: Model, { what, pair, edits }: Request): string {
  switch (what) {
    case "pair":
      return model.pair(pair);
    case "edit":
      return model.edit(pair, edits);
    case "toml":
      return model.toml(edits);
  }
}
