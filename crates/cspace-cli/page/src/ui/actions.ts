/** What buttons and keys do. */

import type { View } from "../scene.js";

export interface Actions {
  toggleStop(): void;
  /** Makes something large, or the parts again. */
  toggleView(view: View): void;
  toggleCut(): void;
  toggleColouring(): void;
  toggleTheme(): void;
  toggleEdit(): void;
  toggleMeasure(): void;
  toggleParts(): void;
  newModel(): void;
  fit(): void;
  help(): void;
  play(): void;
  undo(): void;
  redo(): void;
  removeVertex(): void;
  toggleWhole(): void;
  toggleCompare(): void;
  leave(): void;
  wayOut(widest: boolean): void;
  playMechanism(): void;
  takeApart(): void;
  openRecord(): void;
  saveSvg(asShown: boolean): void;
  savePng(asShown: boolean): void;
  saveModel(): void;
  savePage(): void;
}
