/** Values in records, read from JSON or refused with their place. */

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
