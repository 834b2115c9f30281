/** Reads what `cspace plan`, `cspace disassemble` and `cspace simulate` print. */

import { readAssembly } from "./assembly-record.js";
import { distance } from "./legs.js";
import type { Placement } from "./placement.js";
import { playedAt, type Load, type PlayableRecord, type Sample } from "./playable.js";
import { RecordError, array, configuration, isObject, number, type Json } from "./record-json.js";

/** A planned path has no times: it is played in this many seconds. */
const PATH_SECONDS = 6;
/** And so is what goes from one balance to another at once. */
export const SNAP_SECONDS = 0.4;
/** Where contacts come and go there are two states of one time; with more, parts go somewhere. */
const OF_ONE_TIME = 4;

export function readRecord(name: string, record: unknown): PlayableRecord {
  if (!isObject(record)) throw new RecordError(`${name}: not what "cspace plan", "cspace disassemble" or "cspace simulate" prints with --json: no object`);
  if ("verdict" in record && "steps" in record) return readAssembly(name, record);
  // A plan is of a pair, which the command's answer has in a list.
  const [plan] = Array.isArray(record["pairs"]) ? record["pairs"] : [record];
  if (isObject(plan) && "verdict" in plan) return readPlan(name, plan);
  if ("samples" in record) return readSimulation(name, record);
  throw new RecordError(`${name}: neither "verdict" (cspace plan, cspace disassemble) nor "samples" (cspace simulate) is in it`);
}

export function readRecordText(name: string, text: string): PlayableRecord {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (error) {
    throw new RecordError(`${name}: a model (.toml), a drawing (.dxf, .svg), or what "cspace plan" or "cspace simulate" prints with --json is expected; this is not JSON (${error instanceof Error ? error.message : String(error)})`);
  }
  return readRecord(name, json);
}

function readPlan(name: string, record: Json): PlayableRecord {
  const verdict = String(record["verdict"]);
  const path = array(name, record["path"], "path").map((c, i) => configuration(name, c, i));
  if (path.length === 0) throw new RecordError(`${name}: there is no path to play; the verdict is "${verdict}"`);
  const kind = Object.keys(path[0] ?? {}).join();
  if (path.some((c) => Object.keys(c).join() !== kind)) throw new RecordError(`${name}: the path mixes (x, y, theta) and (u, v)`);
  const lengths = path.map((c, i) => (i === 0 ? 0 : distance(path[i - 1] ?? c, c)));
  const total = lengths.reduce((a, b) => a + b, 0);
  let sum = 0;
  const steps = path.map((at, i) => {
    sum += lengths[i] ?? 0;
    return { t: total > 0 ? (PATH_SECONDS * sum) / total : 0, at };
  });
  // At each place the leg is told that begins there.
  const words = array(name, record["words"] ?? [], "words").map(String);
  const ticks = steps.map(({ t }, i) => ({ t, text: words[i] ?? (i === 0 ? "start" : i === steps.length - 1 ? "goal" : `corner ${i}`) }));
  const about = array(name, record["about"] ?? [0, 0], "about");
  const point: [number, number] = [number(name, about[0], "about[0]"), number(name, about[1], "about[1]")];
  const clearance = record["clearance"];
  const summary = typeof clearance === "number" ? `${verdict}, clearance ${clearance.toPrecision(4)}` : verdict;
  return { kind: "plan", name, duration: total > 0 ? PATH_SECONDS : 0, ticks, summary, about: point, steps };
}

function readSimulation(name: string, record: Json): PlayableRecord {
  const parts = array(name, record["parts"], "parts").map(String);
  const samples = array(name, record["samples"], "samples").map((row, i): Sample => {
    if (!isObject(row)) throw new RecordError(`${name}: samples[${i}] is no object`);
    const at = parts.map((part): [string, Placement | number] => {
      const value = row[part];
      const place = `samples[${i}].${part}`;
      if (!Array.isArray(value)) return [part, number(name, value, place)];
      return [part, { x: number(name, value[0], place), y: number(name, value[1], place), theta: number(name, value[2], place) }];
    });
    const t = number(name, row["t"], `samples[${i}].t`);
    return { t, time: t, parts: new Map(at) };
  });
  const first = samples[0];
  if (!first) throw new RecordError(`${name}: it has no samples`);
  const steps = "states" in record ? readStates(name, record["states"], first) : samples;
  if (steps.some((s, i) => s.time < (steps[i - 1]?.time ?? -Infinity))) throw new RecordError(`${name}: the times of samples do not ascend`);
  pace(steps);
  const ticks = array(name, record["events"] ?? [], "events").map((event, i) => {
    if (!isObject(event)) throw new RecordError(`${name}: events[${i}] is no object`);
    const t = number(name, event["t"], `events[${i}].t`);
    return { t: playedAt(steps, t), text: eventText(event) };
  });
  const reason = typeof record["reason"] === "string" ? `: ${record["reason"]}` : "";
  const duration = steps[steps.length - 1]?.t ?? 0;
  return { kind: "simulation", name, duration, ticks, summary: `${String(record["status"] ?? "done")}${reason}`, parts, steps, drives: readDrives(name, record, steps) };
}

/** States of all parts: each is its time, their coordinates in order, and more that is not looked at. */
function readStates(name: string, states: unknown, first: Sample): Sample[] {
  return array(name, states, "states").map((row, i): Sample => {
    const numbers = array(name, row, `states[${i}]`);
    let next = 0;
    const take = () => number(name, numbers[next], `states[${i}][${next++}]`);
    const time = take();
    const parts = new Map<string, Placement | number>();
    for (const [part, like] of first.parts) parts.set(part, typeof like === "number" ? take() : { x: take(), y: take(), theta: take() });
    return { t: time, time, parts };
  });
}

/** What the samples say of drives. */
function readDrives(name: string, record: Json, steps: readonly Sample[]): Load[] {
  const units = isObject(record["units"]) ? record["units"] : {};
  const all = new Map<string, Load>();
  array(name, record["samples"], "samples").forEach((row, i) => {
    const forces = isObject(row) ? row["forces"] : null;
    if (!isObject(row) || !isObject(forces)) return;
    const place = `samples[${i}].forces.drives`;
    const t = playedAt(steps, number(name, row["t"], `samples[${i}].t`));
    for (const drive of array(name, forces["drives"] ?? [], place)) {
      if (!isObject(drive)) throw new RecordError(`${name}: ${place} has what is no object`);
      const part = String(drive["part"]);
      let load = all.get(part);
      if (!load) all.set(part, (load = { part, unit: String(units["force"] ?? ""), times: [], values: [] }));
      load.times.push(t);
      load.values.push(number(name, drive["force"], `${place}.force`));
    }
  });
  return [...all.values()];
}

/** Gives what happens at once some time to be seen. */
function pace(steps: Sample[]): void {
  let shift = 0;
  for (let from = 0; from < steps.length; ) {
    const time = steps[from]?.time;
    let to = from + 1;
    while (steps[to]?.time === time) to++;
    const lasts = to - from > OF_ONE_TIME ? SNAP_SECONDS : 0;
    for (let i = from; i < to; i++) {
      const step = steps[i];
      if (step) step.t = step.time + shift + (lasts * (i - from)) / Math.max(1, to - from - 1);
    }
    shift += lasts;
    from = to;
  }
}

function eventText(event: Json): string {
  const features = Array.isArray(event["features"]) ? event["features"].map(String) : [];
  const of = [event["fixed"], event["moving"]].map((part, i) => [part, features[i]].filter((x) => x !== undefined).join(", "));
  const parts = of.filter((x) => x !== "").join(" and ") || String(event["part"] ?? "");
  return `${String(event["kind"])}${parts ? `: ${parts}` : ""}`;
}
