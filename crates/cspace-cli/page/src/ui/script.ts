/** `window.cspace`: the page's interface for lessons and tests. */

import type { Classification, Configuration } from "../kernel/api.js";
import { hasAxes } from "./mechanism.js";
import type { Session } from "./session.js";

export interface CspaceScript {
  /** When the selected pair's space is there and drawn. */
  readonly ready: Promise<void>;
  /** The names of the selected pair's parts: fixed, moving. */
  pair(): [string, string];
  select(fixed: string, moving: string): Promise<void>;
  configuration(): Configuration;
  /** Places the parts exactly so, whatever is in the way. */
  setConfiguration(c: Configuration): void;
  /** Throws outside of the window of orientations or the ranges of motion, as the command refuses such rows. */
  classify(c: Configuration): Classification;
  /** Names of touching features: of the fixed part, of the moving part. */
  touching(): [string, string][];
}

declare global {
  interface Window {
    cspace: CspaceScript;
  }
}

export function pageInterface(session: Session, ready: () => Promise<void>, select: (pair: number) => Promise<void>): CspaceScript {
  const name = (index: number | undefined) => (index === undefined ? "" : (session.scene.parts[index]?.name ?? ""));
  return {
    get ready() {
      return ready();
    },
    pair: () => [name(session.pair?.fixed), name(session.pair?.moving)],
    select(fixed, moving) {
      const index = session.scene.pairs.findIndex((p) => name(p.fixed) === fixed && name(p.moving) === moving);
      return index < 0 ? Promise.reject(new RangeError(`the model has no pair ${fixed}, ${moving}`)) : select(index);
    },
    configuration: () => ({ ...session.state.configuration }),
    setConfiguration(c) {
      session.setConfiguration(checked(session, c));
      session.store.flush();
    },
    classify(c) {
      const { kernel } = session;
      if (!kernel) throw new Error("the selected pair has no configuration space yet: wait for cspace.ready");
      const said = kernel.classify(checked(session, c));
      if (said === null) throw new RangeError("the configuration is outside of the window of orientations or the ranges of motion");
      return said;
    },
    touching: () => session.state.where.touching.map((t): [string, string] => [t.fixed, t.moving]),
  };
}

/** A configuration of the selected pair, or an error that says what is expected. */
function checked(session: Session, c: unknown): Configuration {
  const keys = session.pair && hasAxes(session.pair) ? ["u", "v"] : ["x", "y", "theta"];
  const given = (typeof c === "object" && c !== null ? c : {}) as Record<string, unknown>;
  const values = keys.map((k) => given[k]);
  if (!values.every((v): v is number => typeof v === "number" && Number.isFinite(v))) {
    throw new TypeError(`a configuration of this pair is {${keys.join(", ")}}, finite numbers`);
  }
  return Object.fromEntries(keys.map((k, i) => [k, values[i]])) as unknown as Configuration;
}

