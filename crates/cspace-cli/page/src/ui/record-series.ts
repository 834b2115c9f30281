/** The coordinates of a record over the time of its playing. */

import type { ScenePart } from "../scene.js";
import { rounded } from "./numbers.js";
import { lastAt, timeAt, type PlayableRecord } from "./playable.js";

export interface Series {
  /** Such as `wheel`, or `ring x`. */
  name: string;
  kind: "length" | "angle" | "load";
  /** Of a load. */
  unit?: string;
  /** When values are played (s), ascending, and the values. */
  times: number[];
  values: number[];
  lo: number;
  hi: number;
}

/** Coordinates that change; those of parts that stand still are nothing to look at. */
export function seriesOf(record: PlayableRecord, parts: readonly ScenePart[], names: { fixed: string; moving: string }, unit: string | null = null): Series[] {
  const all = new Map<string, Series>();
  const put = (name: string, kind: Series["kind"], t: number, value: number) => {
    let series = all.get(name);
    if (!series) all.set(name, (series = { name, kind, times: [], values: [], lo: Infinity, hi: -Infinity }));
    series.times.push(t);
    series.values.push(value);
    series.lo = Math.min(series.lo, value);
    series.hi = Math.max(series.hi, value);
  };
  const turns = (name: string) => parts.find((p) => p.name === name)?.motion.type === "revolute";
  const put3 = (name: string, t: number, at: { x: number; y: number; theta: number }) => {
    put(`${name} x`, "length", t, at.x);
    put(`${name} y`, "length", t, at.y);
    put(`${name} θ`, "angle", t, at.theta);
  };
  if (record.kind === "simulation") {
    for (const { t, parts: placed } of record.steps) {
      for (const [name, at] of placed) {
        if (typeof at === "number") put(name, turns(name) ? "angle" : "length", t, at);
        else put3(name, t, at);
      }
    }
  } else {
    for (const { t, at } of record.steps) {
      if (!("u" in at)) put3(names.moving, t, at);
      else for (const [name, value] of [[names.fixed, at.u], [names.moving, at.v]] as const) put(name, turns(name) ? "angle" : "length", t, value);
    }
  }
  const loads = (record.kind === "simulation" ? record.drives : []).map(({ part, unit: force, times, values }): Series => ({
    name: `${part} ${turns(part) ? "torque" : "force"}`,
    kind: "load",
    unit: force === "" ? `kg·${unit ?? "unit"}${turns(part) ? "²" : ""}/s²` : turns(part) ? `${force}·${unit}` : force,
    times,
    values,
    lo: values.reduce((a, b) => Math.min(a, b), Infinity),
    hi: values.reduce((a, b) => Math.max(a, b), -Infinity),
  }));
  return [...all.values(), ...loads].filter((s) => s.hi > s.lo);
}

/** The value at a time: the last that is not after it, as the parts are played; on a planned way, which is straight between its corners, between two. */
export function valueAt({ times, values }: Series, t: number, straight: boolean): number {
  const lo = lastAt(times.length, (i) => times[i], t);
  const [a = 0, b = a] = [values[lo], values[lo + 1]];
  const [s = 0, e = s] = [times[lo], times[lo + 1]];
  return straight && e > s ? a + (b - a) * Math.min(1, Math.max(0, (t - s) / (e - s))) : a;
}

/** Digits of degrees that are more than the rounding of their conversion. */
const DIGITS = 15;

/** All series as CSV: a row for each time, of the motion; angles in degrees. Of a planned path the first column is how far it is, from 0 to 1. */
export function csvOf(record: PlayableRecord, series: readonly Series[], unit: string | null): string {
  const rows = new Map<number, Map<Series, number>>();
  for (const s of series) {
    s.times.forEach((t, i) => {
      let row = rows.get(t);
      if (!row) rows.set(t, (row = new Map()));
      const value = s.values[i] ?? NaN;
      row.set(s, s.kind === "angle" ? rounded((value * 180) / Math.PI, DIGITS) : value);
    });
  }
  const head = (s: Series) => {
    const of = s.kind === "angle" ? "deg" : s.kind === "load" ? s.unit : unit;
    return `"${s.name.replaceAll('"', '""')}${of ? ` (${of})` : ""}"`;
  };
  const first = record.kind === "plan" ? "share of the way" : "time (s)";
  const at = (t: number) => (record.kind === "plan" ? t / (record.duration || 1) : timeAt(record, t));
  const lines = [...rows].sort(([a], [b]) => a - b).map(([t, row]) => [at(t), ...series.map((s) => row.get(s) ?? "")].join());
  return `${[[first, ...series.map(head)].join(), ...lines].join("\r\n")}\r\n`;
}

/** Points of the graph in the unit square, time to the right and values upwards: per column the first, the least, the greatest and the last. */
export function graphOf({ times, values, lo, hi }: Series, duration: number, columns: number): [number, number][] {
  const x = (i: number) => (times[i] ?? 0) / (duration || 1);
  const point = (i: number): [number, number] => [x(i), ((values[i] ?? 0) - lo) / (hi - lo || 1)];
  if (times.length <= 4 * columns) return times.map((_, i) => point(i));
  const points: [number, number][] = [];
  for (let from = 0; from < times.length; ) {
    const column = Math.floor(x(from) * columns);
    let [to, least, most] = [from, from, from];
    for (; to < times.length && Math.floor(x(to) * columns) === column; to += 1) {
      if ((values[to] ?? 0) < (values[least] ?? 0)) least = to;
      if ((values[to] ?? 0) > (values[most] ?? 0)) most = to;
    }
    for (const i of [...new Set([from, least, most, to - 1])].sort((a, b) => a - b)) points.push(point(i));
    from = to;
  }
  return points;
}
