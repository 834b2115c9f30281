import type { Motion, PlanarConfiguration } from "../api.js";
import type { Classifier } from "./classify.js";
import type { Surface } from "./surface.js";
import type { SavedPart } from "../features.js";

export class PlanarMotion {
  constructor(_s: Surface, private readonly classifier: Classifier, _d: number, _m: SavedPart) {}
  advance(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    return this.classifier.located(to)?.class === "blocked" ? { at: from, stopped: null } : { at: to, stopped: null };
  }
  slide(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    return this.advance(from, to);
  }
}
