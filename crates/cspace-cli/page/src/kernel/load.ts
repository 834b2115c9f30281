/** Loads the kernel: it is in the page, compressed and as text. */

import { initSync } from "../../build/kernel/cspace.js";
import { unpack } from "./packed.js";

/** The kernel, compiled, once it is loaded: workers are given it. */
let module: WebAssembly.Module | null = null;

/** Gets the kernel ready to be asked. */
export async function loadKernel(packed: string): Promise<void> {
  use(await WebAssembly.compile(await unpack(packed).arrayBuffer()));
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
