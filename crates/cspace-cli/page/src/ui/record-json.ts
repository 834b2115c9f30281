/** Values in records, read from JSON or refused with their place. */

import type { Configuration } from "../kernel/api.js";
import { LARGEST_NUMBER, isUsable } from "./numbers.js";

export type Json = Record<string, unknown>;

/** Why a file is no record, for the user. */
export class RecordError extends Error {}

export function isObject(value: unknown): value is Json {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

export function array(name: string, value: unknown, place: string): unknown[] {
  if (!Array.isArray(value)) throw new RecordError(`${name}: "${place}" is no list`);
  return value;
}

export function number(name: string, value: unknown, place: string): number {
  if (typeof value !== "number" || Number.isNaN(value)) throw new RecordError(`${name}: ${place} is no number`);
  if (!isUsable(value)) throw new RecordError(`${name}: ${place} is ${value}, which is beyond what can be shown (${LARGEST_NUMBER})`);
  return value;
}

export function configuration(name: string, c: unknown, index: number, list = "path"): Configuration {
  const place = `${list}[${index}]`;
  if (Array.isArray(c) && c.length === 3) return { x: number(name, c[0], place), y: number(name, c[1], place), theta: number(name, c[2], place) };
  if (Array.isArray(c) && c.length === 2) return { u: number(name, c[0], place), v: number(name, c[1], place) };
  if (isObject(c) && "u" in c) return { u: number(name, c["u"], `${place}.u`), v: number(name, c["v"], `${place}.v`) };
  if (isObject(c)) {
    return { x: number(name, c["x"], `${place}.x`), y: number(name, c["y"], `${place}.y`), theta: number(name, c["theta"], `${place}.theta`) };
  }
  throw new RecordError(`${name}: ${place} is no configuration`);
}
