/** The draft: changes of the model that its file has not. It outlasts the page. */

import { identity } from "./address.js";
import { button, html } from "./dom.js";
import type { Editor } from "./edit.js";
import { isLeaving, isUnsavedStep } from "./entries.js";
import { keeping, kept } from "./kept.js";
import { failure } from "./message.js";
import type { Session } from "./session.js";
import { UNCHANGED, type Edits } from "./workshop.js";

/** Keeps what is changed until it is saved, and asks before it is left. Offers what was kept, and what the page was opened with. */
export function keepDraft(parent: HTMLElement, session: Session, editor: Editor): void {
  const key = `cspace-draft ${Object.values(identity(session.scene)).join(" ")}`;
  let { version } = editor;
  const isOpened = version > 0;
  const draft = isOpened ? editor.edits : (JSON.parse(kept(key) ?? "null") as Edits | null);
  const line = html("div", { id: "draft", role: "status" });
  if (draft) {
    const choice = (text: string, goOn: boolean) =>
      button(text, () => {
        line.remove();
        if (goOn !== isOpened) editor.restore(goOn ? draft : UNCHANGED).catch((error: unknown) => session.store.change({ message: failure(error) }));
        if (!goOn) keeping(key, null);
      });
    const shapes = draft.parts.map((p) => `shape of ${session.scene.parts[p.index]?.name ?? "?"}`);
    const told = [...draft.set.map((s) => `${s.name} = ${s.value}`), ...shapes].join(", ");
    line.append(html("p", {}, `Changes that are not in the file: ${told}.`), html("div", { class: "buttons" }, choice("Go on with your changes", true), choice("As in the file", false)));
    parent.prepend(line);
  }
  session.store.subscribe(() => {
    if (editor.version === version) return;
    version = editor.version;
    if (isOpened) line.remove();
    keeping(key, editor.isSaved ? null : JSON.stringify(editor.edits));
  });
  window.addEventListener("beforeunload", (event) => {
    // Back leads to the address, which has the changes.
    if ((!editor.isSaved || isUnsavedStep()) && !isLeaving()) event.preventDefault();
  });
}
