/** Rows asked of `cspace classify`. */

import { run } from "./command.js";

export interface Told {
  class: string;
  region: number | null;
  touching: string[];
}

/** What the command says of configurations of a pair: `header` names their coordinates. */
export function classified(model: string, pair: string, rows: number[][], header: string, columns: string[]): Told[] {
  const input = [header, ...rows.map((r) => r.join(","))].join("\n") + "\n";
  const out = run(["classify", model, "--pair", pair, "--columns", columns.join(","), "--json", "-q"], input);
  const answer = JSON.parse(out) as { pairs: [{ rows: { class: string; region?: number | null; touching?: [string, string][] }[] }] };
  return answer.pairs[0].rows.map((r) => ({
    class: r.class,
    region: r.region ?? null,
    touching: (r.touching ?? []).map((p) => p.join("|")),
  }));
}
