/** What the page shows, in one place. Views are told once a frame which of it has changed. */

import type { Classification, Configuration, Kernel, Touch } from "../kernel/api.js";
import type { Place, Scene, ScenePart, View } from "../scene.js";
import type { Colouring } from "./colours.js";
import type { Placement } from "./placement.js";
import type { PlayableRecord } from "./playable.js";
import type { CheckRow } from "./workshop.js";

export type Theme = "auto" | "light" | "dark";

export type SpaceState =
  | { state: "loading" }
  | { state: "ready"; kernel: Kernel }
  /** A lower pair, or one whose space cannot be computed. */
  | { state: "none"; reason: string; error: boolean };

/** Where the configuration is. */
export interface Where {
  classification: Classification | null;
  /** Whether what is blocked touches, and has no room to move. */
  fits: boolean;
  region: number | null;
  touching: Touch[];
  nearest: Touch | null;
  /** Patches in contact. */
  patches: number[];
}

/** What is said over the views. */
export interface Message {
  /** A note fades; an answer and an error stay until they are closed, and progress until it is over. */
  kind: "note" | "answer" | "progress" | "error";
  text: string;
  /** Ends what is under way. */
  cancel?: () => void;
}

/** A state that is kept beside the present one. */
export interface Kept {
  pair: number;
  parts: readonly ScenePart[];
  placements: readonly Placement[];
  checked: readonly CheckRow[];
  /** Values of parameters by name. */
  parameters: ReadonlyMap<string, number>;
  verdict: string;
  /** The features that touch, or those that are nearest, in words. */
  decides: string;
}

export interface State {
  scene: Scene;
  /** The parts as the model gives them or as they are edited. */
  parts: ScenePart[];
  /** Index of the selected pair. */
  pair: number;
  space: SpaceState;
  /** All parts in the assembly. */
  placements: Placement[];
  /** Of the selected pair. */
  configuration: Configuration;
  where: Where;
  /** Whether what is dragged stops at contacts. */
  stop: boolean;
  theme: Theme;
  colouring: Colouring;
  hidden: ReadonlySet<number>;
  /** Whether the surface is cut away above the current orientation. */
  cut: boolean;
  /** What is large. */
  view: View;
  /** What the verdict rests on: names of features of the pair's parts; they are lit in the drawing. */
  reason: { fixed: readonly string[]; moving: readonly string[] };
  /** In which order an assembly comes apart, in a sentence; null where that is not known. */
  order: string | null;
  /** Whether something is being dragged. */
  dragging: boolean;
  record: PlayableRecord | null;
  /** Where in the record: seconds. */
  time: number;
  playing: boolean;
  speed: number;
  /** Whether the record is of the model before it was changed. */
  stale: boolean;
  editing: boolean;
  /** Whether parts are added, renamed and removed. */
  making: boolean;
  /** The height that is looked at alone, of parts that are stacks of layers; null for all. */
  height: number | null;
  /** Whether clicks on parts measure distances. */
  measuring: boolean;
  /** Whether the space is of a shape before the one that is drawn, which has none. */
  outdated: boolean;
  /** Whether what is dragged pushes all parts of the mechanism, and not the selected pair alone. */
  whole: boolean;
  /** Of the last drag of the mechanism: what stopped it, in words, the names of parts that overlap, and what is smaller than drawn, in words. */
  held: { stopped: readonly string[]; overlapping: readonly (readonly [string, string])[]; gaps: readonly string[] } | null;
  /** Whether the parts are shown elsewhere than they are drawn, where they overlap. */
  displaced: boolean;
  message: Message | null;
  /** The requirements as they are measured of this model; null as long as they are not. */
  checked: readonly CheckRow[] | null;
  /** The point of a part, in its frame, whose path through the record is drawn; `next` is the one that is clicked next. */
  traced: { part: number; at: Place } | "next" | null;
  /** The state A, with which the present one is compared. */
  compared: Kept | null;
}

export type Key = keyof State;

export type Listener = (changed: ReadonlySet<Key>, state: Readonly<State>) => void;

export class Store {
  #state: State;
  #changed = new Set<Key>();
  #listeners: Listener[] = [];
  #frame: number | null = null;

  constructor(state: State) {
    this.#state = state;
  }

  get state(): Readonly<State> {
    return this.#state;
  }

  change(part: Partial<State>): void {
    for (const key of Object.keys(part) as Key[]) {
      if (this.#state[key] !== part[key]) this.#changed.add(key);
    }
    this.#state = { ...this.#state, ...part };
    if (this.#changed.size > 0 && this.#frame === null) this.#frame = requestAnimationFrame(() => this.flush());
  }

  /** Tells the views now. */
  flush(): void {
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#frame = null;
    const changed = this.#changed;
    this.#changed = new Set();
    if (changed.size > 0) for (const listener of this.#listeners) listener(changed, this.#state);
  }

  /** Calls the listener with every key, and later with what has changed. */
  subscribe(listener: Listener): void {
    this.#listeners.push(listener);
    listener(new Set(Object.keys(this.#state) as Key[]), this.#state);
  }
}
