import { initSync } from "./cspace.js";

export * from "./cspace.js";

/** Loads the library: in a browser from beside this module, in Node from the package. */
export async function load() {
  const address = new URL("./cspace_bg.wasm", import.meta.url);
  if (address.protocol === "file:") {
    const { readFile } = await import("node:fs/promises");
    initSync({ module: await readFile(address) });
    return;
  }
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status} ${answer.statusText}`);
  initSync({ module: await WebAssembly.compile(await answer.arrayBuffer()) });
}
