/** The draft: changes of the model that its file has not. It outlasts the page. */

import { identity } from "./address.js";
import { html } from "./dom.js";
import type { Editor } from "./edit.js";
import { isLeaving } from "./entries.js";
import { keeping, kept } from "./kept.js";
import type { Session } from "./session.js";
import { UNCHANGED } from "./workshop.js";
import type { Edits } from "./workshop.js";

/** Keeps what is changed as a draft until it is saved, and asks before it is left. What the page was opened with is offered as well. */
export function keepDraft(parent: HTMLElement, session: Session, editor: Editor): void {
  const key = `cspace-draft ${Object.values(identity(session.scene)).join(" ")}`;
  let { version } = editor;
  const isOpened = version > 0;
  const draft = isOpened ? editor.edits : readDraft(key);
  if (draft) offer(parent, draft, session, async (goOn) => {
    if (goOn !== isOpened) await editor.restore(goOn ? draft : UNCHANGED);
    if (!goOn) keeping(key, null);
  });
  session.store.subscribe(() => {
    if (editor.version === version) return;
    version = editor.version;
    keeping(key, editor.isSaved ? null : JSON.stringify(editor.edits));
  });
  window.addEventListener("beforeunload", (event) => {
    // Back leads to the address, which has the changes.
    if (!editor.isSaved && !isLeaving()) event.preventDefault();
  });
}

function readDraft(key: string): Edits | null {
  const text = kept(key);
  return text === null ? null : (JSON.parse(text) as Edits);
}

function offer(parent: HTMLElement, { set, parts }: Edits, session: Session, choose: (goOn: boolean) => Promise<void>): void {
  const told = [...set.map((s) => `${s.name} = ${s.value}`), ...parts.map((p) => `shape of ${session.scene.parts[p.index]?.name ?? "?"}`)].join(", ");
  const button = (text: string, goOn: boolean) => {
    const b = html("button", { type: "button" }, text);
    b.addEventListener("click", () => {
      line.remove();
      choose(goOn).catch((error: unknown) => session.store.change({ message: String(error) }));
    });
    return b;
  };
  const line = html("div", { id: "draft", role: "status" }, html("p", {}, `Changes that are not in the file: ${told}.`), html("div", { class: "buttons" }, button("Go on with your changes", true), button("As in the file", false)));
  parent.prepend(line);
}
