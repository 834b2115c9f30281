/** Loads the kernel: it is in the page, compressed and as text. */

import { initSync } from "../../build/kernel/cspace.js";

/** The kernel, compiled, once it is loaded: workers are given it. */
let module: WebAssembly.Module | null = null;

/** Gets the kernel ready to be asked. */
export async function loadKernel(packed: string): Promise<void> {
  const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  use(await WebAssembly.compile(await new Response(unpacked).arrayBuffer()));
}

/** Uses a kernel that was compiled before. */
export function use(compiled: WebAssembly.Module): void {
  initSync({ module: compiled });
  module = compiled;
}

export function compiledKernel(): WebAssembly.Module {
  if (!module) throw new Error("the kernel is not loaded");
  return module;
}
