/** The page of a drawing: faces light up under the pointer, clicked ones become parts, and the model is saved or opened. */

import { Drawing } from "../../build/kernel/cspace.js";
import { button, byId, download, fileName, html, say, set, svg } from "../ui/dom.js";
import { writeFragment } from "../ui/entries.js";
import { chooseFile, listenToDrops, showFile, showModel } from "../ui/files.js";
import { answer, failure, messageDrawn, note, showMessage } from "../ui/message.js";
import type { Message } from "../ui/state.js";
import { makeHelp } from "../ui/help.js";
import { newModel } from "../ui/part-panel.js";
import { length, short } from "../ui/numbers.js";
import { boxOf, centerOf, curvePath, outlinePath } from "../ui/outline.js";
import { regionColour } from "../ui/colours.js";
import type { SceneVertex } from "../scene.js";
import { followTheme, themeText } from "../ui/theme.js";
import { Viewport } from "../ui/viewport.js";
import { NOTHING, clicked, fragment, fromFragment, imported, joined, options, partOf, removed, renamed, request, wrongName, type Picks } from "./picks.js";
import type { DrawingScene } from "./scene.js";
import { sourceInUtf8 } from "./utf8.js";

/** Browsers draw with single precision: paths are about the drawing's middle, and its largest side is so long. */
const DRAWN_SIZE = 1000;
/** A pointer that moves farther between down and up pans, and does not click (pixels). */
const CLICK = 4;

export function openDrawing(scene: DrawingScene): void {
  const nextTheme = followTheme();
  document.body.classList.add("drawing");
  set(byId("left"), { "aria-label": "Drawing" });
  const { name, unit, command } = scene.source;
  const inside = scene.faces.map((f) => f.inside);
  const area = (faces: readonly number[]) => {
    const sum = faces.reduce((all, f) => all + (scene.faces[f]?.area ?? 0), 0);
    return `${short(sum)}${unit ? ` ${unit}²` : ""}`;
  };
  let picks: Picks = NOTHING;
  /** Whether clicks add faces to the selected part without Shift. */
  let adding = false;

  say(byId("model-name"), name || "cspace");
  document.title = `${name} – cspace`;
  const listed = scene.faces.length;
  const faces = (n: number) => `${n} ${n === 1 ? "face" : "faces"}`;
  say(byId("face-count"), scene.count > listed ? `the largest ${listed} of ${scene.count} faces` : faces(listed));

  const tell = (message: Message | null) => showMessage(message, () => tell(null));
  const working = (text: string) => tell({ kind: "progress", text });
  const failed = (error: unknown) => tell(failure(error));

  // The drawing.
  let down: { face: number; x: number; y: number } | null = null;
  const faceOf = (target: EventTarget | null) => (target instanceof Element && target.classList.contains("face") ? Number(target.getAttribute("data-face")) : -1);
  const viewport = new Viewport(byId("parts"), {
    uniform: true,
    label: "Drawing: click faces to make parts, drag to pan, wheel to zoom",
    fit: () => viewport.fit(boxOf(scene.curves)),
    grab: (_, event) => {
      down = { face: faceOf(event.target), x: event.clientX, y: event.clientY };
      return null;
    },
  });
  viewport.unit = unit ?? "";
  const click = (face: number, withShift: boolean) => {
    const to = withShift || adding ? joined(picks, face) : clicked(picks, face);
    const refusal = scene.faces[face]?.refusal;
    const isAlone = to.parts.some((p) => p.faces.length === 1 && p.faces[0] === face);
    if (refusal && isAlone && partOf(picks, face) < 0) tell(note(`This face alone is no part (${refusal}). Add it to another part.`));
    else change(to);
  };
  viewport.svg.addEventListener("pointerup", (event) => {
    const at = down;
    down = null;
    if (at && at.face >= 0 && Math.hypot(event.clientX - at.x, event.clientY - at.y) < CLICK) click(at.face, event.shiftKey);
  });
  const hover = (face: number) => {
    const of = scene.faces[face];
    const alone = of?.refusal ? `; alone it is no part: ${of.refusal}` : "";
    say(byId("hovered"), of ? `face at ${of.inside.x}, ${of.inside.y}: area ${area([face])}${alone}` : "");
  };
  viewport.svg.addEventListener("pointerover", (event) => hover(faceOf(event.target)));
  viewport.svg.addEventListener("focusin", (event) => hover(faceOf(event.target)));
  viewport.svg.addEventListener("keydown", (event) => {
    const face = faceOf(event.target);
    if (face < 0 || (event.key !== "Enter" && event.key !== " ")) return;
    event.preventDefault();
    click(face, event.shiftKey);
  });
  const box = boxOf(scene.curves);
  const middle = centerOf(box);
  const drawnUnit = (extent(scene) || 1) / DRAWN_SIZE;
  const local = (loops: readonly SceneVertex[][]) =>
    loops.map((loop) => loop.map(({ x, y, bulge }) => ({ x: (x - middle.x) / drawnUnit, y: (y - middle.y) / drawnUnit, bulge })));
  const paths = scene.faces.map((face, i) =>
    svg("path", { class: "face", "data-face": i, d: outlinePath(local(face.loops)), tabindex: 0, role: "button", "aria-label": `face ${i + 1}, area ${area([i])}` }),
  );
  const drawn = svg("path", { class: "drawn", d: local(scene.curves).map(curvePath).join("") });
  const group = svg("g", { class: "drawing", "data-x": middle.x, "data-y": middle.y, "data-unit": drawnUnit }, ...paths, drawn);
  viewport.world.after(group);
  viewport.onView = () => {
    const at = viewport.toScreen(middle);
    set(group, { transform: `matrix(${drawnUnit / viewport.pixel.x} 0 0 ${-drawnUnit / viewport.pixel.y} ${at.x} ${at.y})` });
  };
  viewport.fit(boxOf(scene.curves));

  // The parts, and what can be done with them.
  let drawing: Drawing | null = null;
  const model = (): string => {
    drawing ??= Drawing.fromSource(JSON.stringify(sourceInUtf8(scene.source)));
    return drawing.toml(JSON.stringify(request(picks, inside)));
  };
  const made = async () => {
    const wrong = wrongName(picks);
    if (wrong !== null) throw new Error(wrong);
    working("The model is made …");
    await messageDrawn();
    const text = model();
    tell(null);
    return text;
  };
  const save = async () => download(fileName(name, "toml"), new Blob([await made()], { type: "application/toml" }));
  const open = async () => showModel(await made(), fileName(name, "toml"));
  const openFile = async (file: File) => {
    if (!(await showFile(file, working))) throw new Error(`${file.name} is neither a model (.toml) nor a drawing (.dxf, .svg)`);
  };
  const taken = (file: File) => void openFile(file).catch(failed);
  listenToDrops(taken);
  const tool = (text: string, title: string, action: () => unknown) => {
    const b = button(text, () => void Promise.resolve().then(action).then(() => undefined, failed), { title });
    byId("tools").append(b);
    return b;
  };
  tool("Fit", "Show everything", () => viewport.fit(boxOf(scene.curves)));
  const add: HTMLButtonElement = tool("Add faces", "Clicks add faces to the selected part, or take them out again, as with Shift", () => {
    adding = !adding;
    set(add, { "aria-pressed": String(adding) });
  });
  set(add, { "aria-pressed": "false" });
  const clear = tool("Clear", "Take all parts back", () => change(NOTHING));
  const saving = tool("Save model", "Save the parts as a model (TOML)", save);
  const opening = tool("Show motion", "Show two parts or more, and their configuration spaces", open);
  tool("New", "Begin a model from nothing", () => newModel(failed));
  tool("Open file", "Open another drawing (DXF, SVG) or a model (TOML)", () => chooseFile(".dxf,.svg,.toml", taken));
  const theme: HTMLButtonElement = tool(themeText("auto"), "Light, dark, or as the system", () => say(theme, themeText(nextTheme())));
  tool("?", "Help", makeHelp().show).setAttribute("aria-label", "Help");

  function change(to: Picks): void {
    picks = to;
    tell(null);
    writeAddress();
    draw();
  }

  function writeAddress(): void {
    writeFragment(`#${fragment(picks, inside)}`);
  }

  function draw(): void {
    paths.forEach((path, i) => {
      const part = partOf(picks, i);
      const colour = part < 0 ? null : regionColour(part);
      set(path, {
        class: part < 0 ? (scene.faces[i]?.refusal ? "face refused" : "face") : part === picks.selected ? "face picked selected" : "face picked",
        style: colour && `fill: ${colour}`,
        "aria-pressed": String(part >= 0),
      });
    });
    byId("picked-parts").replaceChildren(...picks.parts.map(row));
    for (const b of [clear, saving]) b.disabled = picks.parts.length === 0;
    opening.disabled = picks.parts.length < 2;
    byId("command").hidden = picks.parts.length === 0;
    sayCommand();
  }

  function sayCommand(): void {
    const pre = byId("command").querySelector("pre");
    if (pre) say(pre, `${command} ${options(picks, inside)} -o ${fileName(name, "toml")}`);
  }

  function row(part: Picks["parts"][number], index: number): HTMLElement {
    const name = html("input", { type: "text", "aria-label": `Name of part ${index + 1}`, maxlength: 200, spellcheck: "false" });
    name.value = part.name;
    // The row stays while its name is typed.
    name.addEventListener("input", () => {
      picks = renamed(picks, index, name.value);
      writeAddress();
      sayCommand();
    });
    name.addEventListener("focus", () => {
      if (picks.selected === index) return;
      picks = { ...picks, selected: index };
      for (const [i, path] of paths.entries()) path.classList.toggle("selected", partOf(picks, i) === index);
      [...byId("picked-parts").children].forEach((li, i) => li.classList.toggle("selected", i === index));
    });
    const remove = button("✕", () => change(removed(picks, index)), { class: "small", title: "Take this part back", "aria-label": `Take ${part.name} back` });
    const swatch = html("span", { class: "swatch", style: `background: ${regionColour(index)}` });
    const what = html("span", { class: "faint" }, `${faces(part.faces.length)}, ${area(part.faces)}`);
    return html("li", { class: index === picks.selected ? "selected" : "" }, swatch, name, remove, what);
  }

  const readAddress = () => {
    picks = location.hash.length > 1 ? fromFragment(location.hash, inside) : imported(scene.parts);
    draw();
  };
  readAddress();
  // An address that is typed; the page's own does not come here.
  window.addEventListener("hashchange", readAddress);
  const none = `Nothing that is drawn encloses a face (what is drawn is within ${length(extent(scene), unit)}): check the layers, and whether something lies far away. `;
  const left = scene.dropped === null ? "" : `Left out, since it bounds no face: ${scene.dropped}`;
  if (listed === 0 || left !== "") tell(answer(`${listed === 0 ? none : ""}${left}`));
}

function extent(scene: DrawingScene): number {
  const box = boxOf(scene.curves);
  return Math.max(0, box.x1 - box.x0, box.y1 - box.y0);
}
