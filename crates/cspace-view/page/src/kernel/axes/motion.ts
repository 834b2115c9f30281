import type { AxesConfiguration, Motion } from "../api.js";
import type { AxesClassifier } from "./classify.js";
import type { AxesSpaceData } from "./data.js";
import type { Graphs } from "./graphs.js";
import type { PlaneMap } from "./plane-map.js";

export class AxesMotion {
  constructor(_s: AxesSpaceData, _g: Graphs, _m: PlaneMap, private readonly classifier: AxesClassifier, _d: number) {}
  advance(from: AxesConfiguration, to: AxesConfiguration): Motion<AxesConfiguration> {
    return this.classifier.classify(to.u, to.v) === "blocked" ? { at: from, stopped: null } : { at: to, stopped: null };
  }
  slide(from: AxesConfiguration, to: AxesConfiguration): Motion<AxesConfiguration> {
    return this.advance(from, to);
  }
}
