/** The page as one file, which opens as it is shown. */

import type { Scene } from "../scene.js";

/** The page as it was loaded, before anything was shown in it. */
const blank = document.documentElement.cloneNode(true) as HTMLElement;

/** `address` is of the state that is shown: it holds until the file has another. */
export function pageFile(scene: Scene, address: string): string {
  const page = blank.cloneNode(true) as HTMLElement;
  page.dataset["address"] = address;
  const element = page.querySelector("#scene");
  // In JSON `<` is nowhere but in texts, where it could end the element.
  if (element) element.textContent = JSON.stringify(scene).replaceAll("<", "\\u003c");
  // What is beside a page of a gallery has been written into it; the links between its pages lead nowhere from elsewhere.
  for (const beside of page.querySelectorAll("script[src], #gallery")) beside.remove();
  // A server sends the policy itself, and has that of files here.
  const policy = page.querySelector("meta[name=policy]");
  policy?.removeAttribute("name");
  policy?.setAttribute("http-equiv", "Content-Security-Policy");
  return `<!doctype html>\n${page.outerHTML}\n`;
}

/** The address that this page was saved with. */
export const savedAddress = (): string => blank.dataset["address"] ?? "";
