/** The kernel's answers beside the command's. */

import type { TestContext } from "node:test";
import type { Configuration, Kernel } from "../../src/kernel/api.js";
import { classified, type Told } from "./rows.js";

export interface Asked<C extends Configuration> {
  model: string;
  names: string;
  kernel: Kernel<C>;
  /** The columns of the coordinates. */
  header: string;
}

type Column = "class" | "region" | "touching";

function isSame(a: Told, b: Told): boolean {
  const texts = (t: Told) => [...t.touching].sort().join(";");
  return a.class === b.class && a.region === b.region && texts(a) === texts(b);
}

/** How many configurations have other answers; each is told, and how many there are of each class. */
export function compare<C extends Configuration>(
  t: TestContext,
  { model, names, kernel, header }: Asked<C>,
  all: C[],
  row: (c: C) => number[],
  columns: Column[] = ["class", "region", "touching"],
): number {
  const told = classified(model, names, all.map(row), header, columns);
  const start = performance.now();
  const mine = all.map((c): Told => ({
    class: String(kernel.classify(c)),
    region: kernel.region(c),
    touching: kernel.touching(c).map((x) => `${x.fixed}|${x.moving}`),
  }));
  const each = ((performance.now() - start) / all.length) * 1000;
  const counts: Record<string, number> = {};
  const wrong = all.filter((c, i) => {
    const [a, b] = [mine[i]!, told[i]!];
    counts[b.class] = (counts[b.class] ?? 0) + 1;
    const same = isSame(a, b);
    if (!same) t.diagnostic(`${JSON.stringify(c)}: ${JSON.stringify(a)}, but the command says ${JSON.stringify(b)}`);
    return !same;
  });
  t.diagnostic(`${JSON.stringify(counts)}, ${wrong.length} wrong, ${each.toFixed(0)} µs each`);
  return wrong.length;
}
