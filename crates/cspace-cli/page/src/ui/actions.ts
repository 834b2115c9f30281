/** What buttons and keys do. */

export interface Actions {
  toggleStop(): void;
  toggleCut(): void;
  toggleColouring(): void;
  toggleTheme(): void;
  toggleEdit(): void;
  toggleMeasure(): void;
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
  openRecord(): void;
  saveSvg(asShown: boolean): void;
  savePng(asShown: boolean): void;
  saveModel(): void;
  savePage(): void;
}
