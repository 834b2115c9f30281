/** Puts the page together. */

import type { Scene } from "../scene.js";
import type { Actions } from "./actions.js";
import { USUAL, readAddress, usualView, writeAddress, type Address } from "./address.js";
import { isAssembly, orderOf } from "./assembly-record.js";
import { byId, download, fileName, say } from "./dom.js";
import { Comparison } from "./compare.js";
import { ContactHand } from "./contact-hand.js";
import { DesignPanel } from "./design-panel.js";
import { keepDraft } from "./draft.js";
import { EditPanel } from "./edit-panel.js";
import { Editor } from "./edit.js";
import { canStepForth, isStep, markStepSaved, writeFragment } from "./entries.js";
import { chooseFile, listenToDrops, showFile } from "./files.js";
import { Graphs } from "./graphs.js";
import { makeHelp } from "./help.js";
import { showHints } from "./hints.js";
import { listenToKeys } from "./keys.js";
import { Legend } from "./legend.js";
import { MechanismHand } from "./mechanism-hand.js";
import { answer, failure, showMessage } from "./message.js";
import { PartPanel, isBlank, newModel } from "./part-panel.js";
import { PartsView } from "./parts-view.js";
import { picture, pngFile, svgFile, type Pane } from "./pictures.js";
import { PlaneView } from "./plane-view.js";
import { Readout } from "./readout.js";
import { pageFile, savedAddress } from "./save-page.js";
import { pageInterface } from "./script.js";
import type { Json } from "./record-json.js";
import { isServed, servedPair } from "./server.js";
import { Session } from "./session.js";
import { SliceView } from "./slice-view.js";
import { SpaceView } from "./space-view.js";
import type { Key } from "./state.js";
import { cagedIn } from "./verdict.js";
import { StackView } from "./stack-view.js";
import { VerdictView } from "./verdict-view.js";
import { NEXT_THEME, applyTheme, onSystemTheme } from "./theme.js";
import { ThetaSlider } from "./theta-slider.js";
import { Timeline } from "./timeline.js";
import { showTrace } from "./trace.js";
import { Toolbar } from "./toolbar.js";
import { Ways } from "./ways.js";
import { UNCHANGED, Workshop, type Edits, type ModelText } from "./workshop.js";

/** The address is written once the state has not changed for this long (ms): browsers refuse to write it at every frame. */
const ADDRESS_DELAY = 250;
/** The script's `ready` waits for the surface to be complete, but not longer than this (ms): the page can be used before. */
const READY_DELAY = 1000;

/** What the page shows. */
export interface Shown {
  scene: Scene;
  /** Whether the user has opened it here: the server knows nothing of it. */
  isOpened: boolean;
}

/** `worker` is the source text of the worker. Settles when the selected pair is drawn. */
export function openPage({ scene, isOpened }: Shown, worker: string): Promise<void> {
  const address = readAddress(location.hash || (isOpened ? "" : savedAddress()), scene);
  const workshop = scene.source ? new Workshop(worker, scene.source) : null;
  const fetcher = isServed() && !isOpened ? servedPair : workshop ? (pair: number) => workshop.pair(pair) : null;
  const session = new Session(scene, address, fetcher);
  const { store } = session;
  // Before all that is drawn in the colours of the theme.
  store.subscribe((changed, { theme }) => changed.has("theme") && applyTheme(theme));
  onSystemTheme(() => applyTheme(store.state.theme));
  const editor = workshop && fetcher ? new Editor(session, workshop, fetcher) : null;

  const edits = () => editor?.edits ?? UNCHANGED;
  const hand = workshop ? new MechanismHand(session, workshop, edits) : null;
  const partsView = new PartsView(byId("parts"), session, editor, hand);
  let design: DesignPanel | null = null;
  const contacts = editor && workshop ? new ContactHand(session, workshop, editor, () => design?.spans ?? []) : null;
  const stackView = new StackView(byId("stack"), session);
  const sliceView = new SliceView(byId("slice"), session, contacts);
  const planeView = new PlaneView(byId("plane"), session, contacts);
  const space = new LazySpace(session, address);
  new VerdictView(byId("answer"), session);
  new Legend(byId("legend"), session, (region) => {
    space.showAlone(region);
    sliceView.fitRegion(region);
    planeView.fitRegion(region);
  });
  new Graphs(byId("graphs"), session);
  new Readout(byId("readout"), session);
  new ThetaSlider(byId("theta"), session);
  const timeline = new Timeline(byId("timeline"), session, edits);
  const ways = workshop ? new Ways(session, workshop, timeline, edits) : null;
  const comparison = new Comparison(session, partsView.viewport);
  showTrace(session, partsView.viewport);
  const help = makeHelp();

  const select = (pair: number) => {
    const done = session.select(pair);
    store.flush();
    return done;
  };
  const panes = (): Pane[] => {
    const pair = session.pair;
    const parts = [partsView.viewport.svg, ...(stackView.isShown ? [stackView.svg] : [])];
    if (pair?.class === "fixed-axes") return [...parts, planeView.viewport.svg];
    if (!session.planar) return parts;
    space.view?.drawNow();
    return [...parts, ...(space.view && store.state.view === "space" ? [space.view.canvas] : []), sliceView.viewport.svg];
  };
  /** A picture is light, for paper, unless the colours of the page are asked for. */
  const made = (asShown: boolean) => {
    applyTheme(asShown ? store.state.theme : "light");
    space.view?.applyTheme();
    const { backgroundColor, color } = getComputedStyle(byId("left"));
    const words = [scene.name, document.querySelector(".headline")?.textContent ?? ""].filter((w) => w !== "").join(": ");
    const done = picture(panes(), backgroundColor, color, words);
    applyTheme(store.state.theme);
    space.view?.applyTheme();
    return done;
  };
  const openFile = async (file: File) => {
    if (!(await showFile(file, (text) => store.change({ message: { kind: "progress", text } })))) await timeline.open(file);
  };
  const failed = (error: unknown) => store.change({ message: failure(error) });
  const save = ({ text, isWhole }: ModelText) => {
    download(fileName(scene.name, "toml"), new Blob([text], { type: "application/toml" }));
    editor?.markSaved();
    markStepSaved();
    if (!isWhole && scene.source?.design) store.change({ message: answer("The model is saved with numbers alone, without parameters, requirements and comments: its file is JSON, or the parts that were edited by hand cannot be written into it.") });
  };
  const actions: Actions = {
    toggleStop: () => store.change({ stop: !store.state.stop }),
    toggleView: (view) => store.change({ view: store.state.view === view ? "parts" : view }),
    toggleCut: () => store.change({ cut: !store.state.cut }),
    toggleColouring: () => store.change({ colouring: store.state.colouring === "kind" ? "region" : "kind" }),
    toggleTheme: () => store.change({ theme: NEXT_THEME[store.state.theme] }),
    toggleMeasure: () => store.change({ measuring: !store.state.measuring }),
    toggleParts: () => store.change({ making: !store.state.making }),
    newModel: () => newModel(failed),
    toggleEdit: () => editor && store.change({ editing: !store.state.editing }),
    fit: () => {
      if (store.state.hidden.size > 0) store.change({ hidden: new Set() });
      partsView.fit();
      space.view?.lookFromTheFront();
      sliceView.fit();
      planeView.fit();
    },
    help: help.show,
    play: () => timeline.toggle(),
    undo: () => (editor?.canUndo ? editor.undo() : isStep() && history.back()),
    redo: () => (editor?.canRedo ? editor.redo() : canStepForth() && history.forward()),
    removeVertex: () => editor?.removeSelected(),
    toggleWhole: () => store.change({ whole: !store.state.whole, held: null }),
    toggleCompare: () => comparison.toggle(),
    leave: () => store.change({ measuring: false, editing: false, making: isBlank(scene), compared: null, traced: store.state.traced === "next" ? null : store.state.traced }),
    wayOut: (widest) => void ways?.out(widest).catch(failed),
    playMechanism: () => void ways?.mechanism().catch(failed),
    takeApart: () => void ways?.apart().catch(failed),
    openRecord: () => chooseFile(".toml,.dxf,.svg,.json,.gz,application/json", (file) => void openFile(file).catch(failed)),
    saveSvg: (asShown) => download(fileName(scene.name, "svg"), svgFile(made(asShown))),
    savePng: (asShown) => void pngFile(made(asShown)).then((blob) => download(fileName(scene.name, "png"), blob), failed),
    saveModel: () => void editor?.model().then(save, failed),
    savePage: () => {
      download(fileName(scene.name, "html"), new Blob([pageFile(scene, addressNow())], { type: "text/html" }));
      editor?.markSaved();
      markStepSaved();
    },
  };
  showHints(byId("hints"), session);
  new Toolbar(session, actions, (pair) => void select(pair), editor);
  if (editor && scene.source) {
    const { source } = scene;
    design = new DesignPanel(session, editor, () => new Workshop(worker, source));
    new EditPanel(session, editor, actions);
  }
  if (editor || isBlank(scene)) new PartPanel(session, editor, partsView.viewport, failed);
  listenToKeys(session, actions, { parts: partsView.viewport, plane: planeView.viewport });
  listenToDrops((file) => void openFile(file).catch(failed));

  store.subscribe((changed, state) => {
    if (changed.has("theme")) space.view?.applyTheme();
    if ((["space", "pair", "view"] as Key[]).some((k) => changed.has(k))) {
      space.open();
      showPanes(session, space.view !== null);
    }
    if (changed.has("parts") && state.order !== null) store.change({ order: null });
    if (changed.has("outdated")) document.body.classList.toggle("outdated", state.outdated);
    if (changed.has("message")) showMessage(state.message, () => store.change({ message: null }));
  });
  onSystemTheme(() => space.view?.applyTheme());
  const addressNow = () => writeAddress(store.state, space.camera, edits());
  const restore = async (changes: Edits) => {
    if (editor && JSON.stringify(changes) !== JSON.stringify(edits())) await editor.restore(changes).then(() => editor.markSaved(), failed);
  };
  keepAddress(session, space, addressNow, restore);

  let ready: Promise<void> = Promise.resolve();
  const begin = (done: Promise<void>) => {
    ready = done.then(async () => {
      store.flush();
      const { view } = space;
      if (!view) return;
      view.drawNow();
      await Promise.race([view.built, new Promise((resolve) => setTimeout(resolve, READY_DELAY))]);
      view.drawNow();
    });
    return ready;
  };
  const opened = async () => {
    if (address.edits) await restore(address.edits);
    if (editor) keepDraft(byId("side"), session, editor);
    await session.select(store.state.pair, address.configuration ?? null);
    // What is edited may come apart in another order: it is told of the model as it is opened.
    const { parts } = store.state;
    const tellOrder = (text: string) => parts === store.state.parts && store.change({ order: orderOf(JSON.parse(text) as Json) });
    if (isAssembly(scene)) workshop?.disassemble(edits()).then(tellOrder, () => {});
    // Parts that are not where they are drawn are shown whole before the surface is built.
    partsView.fit();
  };
  if (address.warning !== undefined) store.change({ message: answer(address.warning) });
  if (session.pair) void begin(opened()).then(() => {
      if (address.configuration) return;
      timeline.showStart();
      partsView.fit();
    });
  else store.change({ space: { state: "none", reason: scene.parts.length < 2 ? "Two parts have a configuration space: add them with Parts. New has models to begin with." : "The model has no pairs.", error: false } });
  window.cspace = pageInterface(session, () => ready, (pair) => begin(select(pair)));
  return ready;
}

/** The 3-D view, from when it is asked for: its surface costs time, and most do without. */
class LazySpace {
  view: SpaceView | null = null;
  onCamera: (() => void) | null = null;
  /** Where it is looked from as it opens. */
  readonly #from: readonly number[] | null;
  /** Whether a part that is caged is shown with its pocket alone; an address shows what it says. */
  readonly #alone: boolean;

  constructor(private readonly session: Session, { camera, view }: Address) {
    this.#from = camera ?? null;
    this.#alone = view !== "space";
  }

  get camera(): readonly number[] | null {
    return this.view ? this.view.camera : this.#from;
  }

  open(): void {
    const { store, planar, state } = this.session;
    if (this.view || state.view !== "space" || !planar) return;
    const building = byId("building");
    try {
      const region = this.#alone ? cagedIn(this.session) : null;
      if (region !== null) this.#hideOthers(region);
      byId("space").hidden = false;
      this.view = new SpaceView(byId("space"), this.session, this.#from);
      this.view.onProgress = (left) => {
        building.hidden = left === 0;
        if (left > 0) say(building, `${left} pieces left to draw`);
        else if (region !== null) this.view?.fitRegion(region);
      };
      this.view.onCamera = () => this.onCamera?.();
    } catch (error) {
      store.change({ view: "slice", message: answer(`The 3-D view needs WebGL, which this browser does not offer (${failure(error)?.text}); the slice is shown instead.`) });
    }
  }

  /** Looks at a region without what is around it, which would hide it. */
  showAlone(region: number): void {
    if (this.session.planar) this.#hideOthers(region);
    this.view?.fitRegion(region);
  }

  #hideOthers(region: number): void {
    const others = this.session.pair?.regions.map((_, i) => i).filter((i) => i !== region) ?? [];
    this.session.store.change({ hidden: new Set(others) });
  }
}

/** Which of the views on the right are for the selected pair. */
function showPanes(session: Session, has3d: boolean): void {
  const { space, view } = session.state;
  document.body.dataset["view"] = view;
  const axes = session.pair?.class === "fixed-axes";
  const planar = !axes && (session.planar !== null || space.state === "loading");
  byId("space").hidden = !planar || !has3d || view !== "space";
  byId("slice").hidden = !planar;
  byId("plane").hidden = !axes || space.state === "none";
  const none = byId("no-space");
  const reason = noSpace(session);
  none.hidden = reason === null;
  none.classList.toggle("error", space.state === "none" && space.error);
  if (reason !== null) say(none, reason);
}

function noSpace(session: Session): string | null {
  const { space } = session.state;
  if (space.state === "none") return space.reason;
  const pair = session.pair;
  return space.state === "ready" && pair?.class === "lower" ? session.lowerText(pair) : null;
}

/** Writes the address, and follows one that is typed or gone back to. */
function keepAddress(session: Session, space: LazySpace, address: () => string, restore: (edits: Edits) => Promise<void>): void {
  const { store } = session;
  let timer: ReturnType<typeof setTimeout> | null = null;
  let written = location.hash;
  const write = () => {
    timer = null;
    if (store.state.space.state === "loading" || store.state.playing) return;
    written = address();
    if (!writeFragment(written)) written = location.hash;
  };
  const later = () => {
    if (timer !== null) clearTimeout(timer);
    timer = setTimeout(write, ADDRESS_DELAY);
  };
  store.subscribe(later);
  space.onCamera = later;
  window.addEventListener("hashchange", async () => {
    if (location.hash === written) return;
    const to = readAddress(location.hash, session.scene);
    if (to.warning !== undefined) store.change({ message: answer(to.warning) });
    if (to.warning !== undefined && !to.edits) return;
    await restore(to.edits ?? UNCHANGED);
    const { theme, stop, colouring, cut, height } = { ...USUAL, ...to };
    store.change({ theme, stop, colouring, cut, height, view: to.view ?? usualView(session.scene), hidden: new Set(to.hidden ?? []) });
    if (to.camera) space.view?.setCamera(to.camera);
    else space.view?.lookFromTheFront();
    if (to.pair !== undefined && to.pair !== store.state.pair) void session.select(to.pair, to.configuration ?? null);
    else if (to.configuration) session.setConfiguration(to.configuration);
  });
}
