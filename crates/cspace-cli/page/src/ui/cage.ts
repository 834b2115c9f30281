/** What encloses a free region: the features of the fixed part whose contacts bound it. */

import type { Kernel } from "../kernel/api.js";

const known = new WeakMap<Kernel, Map<number, string[]>>();

export function cageOf(kernel: Kernel, region: number): string[] {
  let of = known.get(kernel);
  if (!of) {
    const sets = new Map<number, Set<string>>();
    for (let i = 0; i < kernel.patchCount; i += 1) {
      const { region: bounded, fixed } = kernel.patch(i);
      if (bounded !== null) sets.set(bounded, (sets.get(bounded) ?? new Set()).add(fixed));
    }
    known.set(kernel, (of = new Map([...sets].map(([r, names]) => [r, [...names]]))));
  }
  return of.get(region) ?? [];
}
