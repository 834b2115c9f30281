/**
 * A motion that is led by contact: as far as the straight way is free, then along the surface, as near to the goal as it leads.
 *
 * Positions are vectors of weighted coordinates, in which all of them count alike. Every step is the way to the goal projected to what the
 * contacts leave open, to first order: those that touch, and those that earlier attempts have run into.
 */

import {
  CLEAR,
  FARTHEST_LANDING,
  FOLLOWED,
  FOLLOWED_HELD,
  LEAST_BEND,
  LEAST_STEP,
  LIFT_ROOM,
  MOST_BEND,
  NEARER,
  ON_SURFACE,
  PRESSED,
  REACHED,
  RISE,
  SHORT_OF_CORNER,
  STEEPEST,
  TOUCHES,
} from "./tolerance.js";
import { dot, minus, plus, size, times, weighted, weightsOf, type Vec } from "./vector.js";
import { waysAlong, type HalfSpace } from "./ways.js";

export type { Vec };

/** A contact function at a position: its value and gradient by the weighted coordinates. */
export interface Constraint {
  value: number;
  gradient: number[];
}

/** Where a straight motion ends, and the patch that stopped it. */
export interface Stop {
  at: Vec;
  stopped: number | null;
}

export interface Ground {
  /** The straight way from one position to another up to the first contact; not yet tested for whether it is blocked there. */
  advance(from: Vec, to: Vec): Stop;
  /** The patches that touch at a position. */
  touching(at: Vec): number[];
  constraint(patch: number, at: Vec): Constraint;
  isBlocked(at: Vec): boolean;
  /** How far each coordinate may go; null if it may go anywhere. */
  readonly limits: readonly (readonly [number, number] | null)[];
  /** Positions nearer to a contact than this are in contact. */
  readonly contact: number;
  /** A step along the surface is no longer than this. */
  readonly longest: number;
}

/** So many steps along the surface are one motion of the pointer. */
const MOST_STEPS = 16;
/** A step that leads nowhere is tried again, shorter by this factor, so often. */
const SHORTER = 0.25;
const TRIES = 5;
/** Contacts that a step runs into are taken into account one after another, so many for one step. */
const MOST_LEARNT = 6;
/** Of contacts that do not touch so many are remembered: those run into last. */
const MOST_KNOWN = 4;
/** Past an edge of an obstacle so many ways are tried. */
const MOST_EDGES = 4;
/** Newton's method doubles digits with each step: where so many do not do, there is no such place. */
const NEWTON_STEPS = 12;

/**
 * Slides from a position in contact towards a goal, and gives where that ends and which patch stops it there (null at the goal). `patch` is
 * the one that stopped the straight motion to `from`. Each step is no farther from the goal than the one before, and not blocked.
 */
export function slideOn(ground: Ground, from: Vec, to: Vec, patch: number): Stop {
  let at = from;
  let stopped: number | null = patch;
  const whole = size(minus(to, from));
  const least = Math.max(REACHED * whole, TOUCHES * ground.contact);
  let known: number[] = [];
  let last: Taken | null = null;
  for (let k = 0; k < MOST_STEPS && stopped !== null; k++) {
    if (size(minus(to, at)) <= least) break;
    known = latest(known, stopped);
    const step = stepTowards(ground, at, to, known, least, last);
    known = step.known;
    if (!step.taken) break;
    last = step.taken;
    const on = ground.advance(last.next, to);
    // What is but pressed on is in contact as before.
    const isFar = size(minus(on.at, last.next)) > PRESSED * ground.contact || on.stopped === null;
    if (isFar && ground.isBlocked(on.at)) return { at: last.next, stopped };
    [at, stopped] = [on.at, on.stopped];
  }
  return last && ground.isBlocked(at) ? { at: last.next, stopped } : { at, stopped };
}

/** A step that was taken: from where, by which way, along which contacts, and to where. */
interface Taken {
  from: Vec;
  way: Vec;
  along: string;
  next: Vec;
}

/** The patches that are remembered, with one more as the last. */
function latest(known: number[], patch: number): number[] {
  return [...known.filter((p) => p !== patch), patch].slice(-MOST_KNOWN);
}

/**
 * One step along the surface that comes nearer to the goal; none taken if none does. The ways that contacts leave are tried, nearest first. A
 * patch that a step runs into, and that was not among the contacts, joins them, and the ways are found again.
 */
function stepTowards(
  ground: Ground,
  at: Vec,
  to: Vec,
  before: number[],
  least: number,
  last: Taken | null,
): { taken: Taken | null; known: number[] } {
  const left = minus(to, at);
  const near = ground.touching(at);
  let known = before;
  const failed = new Set<string>();
  for (let k = 0; k < MOST_LEARNT; k++) {
    const contacts = contactsAt(ground, at, [...new Set([...near, ...known])]);
    let learnt: number | null = null;
    for (const way of waysAlong(left, contacts)) {
      const length = size(way.by);
      if (length <= least || dot(way.by, left) <= 0) continue;
      const key = way.held.map((i) => contacts[i]!.patch).join();
      if (!way.allowed && (failed.has(key) || failed.size >= MOST_EDGES)) continue;
      const touch = way.held.every((i) => contacts[i]!.room <= TOUCHES * ground.contact);
      const bend = last?.along === key ? bendOf(last, at, way.by) : 1;
      const step = times(way.by, Math.min(touch ? bend : Math.min(bend, 1), ground.longest / length));
      const held = way.held.map((i) => contacts[i]!);
      const tried = along(ground, at, to, step, contacts, held, way.allowed ? TRIES : 1);
      if (tried.next) return { taken: { from: at, way: way.by, along: key, next: tried.next }, known };
      const met = tried.met;
      if (!way.allowed) failed.add(key);
      else if (met !== null && !contacts.some((c) => c.patch === met)) {
        learnt = met;
        break;
      }
    }
    if (learnt === null) break;
    known = latest(known, learnt);
  }
  return { taken: null, known };
}

/**
 * By how much a step is to be longer than the way that is left along the surface: that is to first order, and surfaces are curved. From how
 * that changed with the last step along the same contacts.
 */
function bendOf(last: Taken, at: Vec, way: Vec): number {
  const moved = minus(at, last.from);
  const less = dot(moved, minus(last.way, way));
  return less > 0 ? Math.min(Math.max(dot(moved, moved) / less, LEAST_BEND), MOST_BEND) : 1;
}

interface Contact extends HalfSpace {
  /** Null of the end of a coordinate's range. */
  patch: number | null;
}

/** What patches and the ends of coordinates' ranges leave open at a position, to first order. */
function contactsAt(ground: Ground, at: Vec, patches: number[]): Contact[] {
  const found: Contact[] = [];
  for (const patch of patches) {
    const { value, gradient } = ground.constraint(patch, at);
    const steep = size(gradient);
    const normal = times(gradient, 1 / steep);
    if (normal.every(Number.isFinite)) found.push({ patch, normal, room: Math.max(value / steep, 0) });
  }
  ground.limits.forEach((limit, i) => {
    if (!limit) return;
    const normal = (sign: number) => at.map((_, k) => (k === i ? sign : 0));
    for (const [room, sign] of [[at[i]! - limit[0], 1], [limit[1] - at[i]!, -1]] as const) {
      if (room < ground.longest) found.push({ patch: null, normal: normal(sign), room: Math.max(room, 0) });
    }
  });
  return found;
}

/** A step along the surface, or a part of it, that comes nearer to the goal; null if none does, with a patch that it runs into. */
function along(
  ground: Ground,
  at: Vec,
  to: Vec,
  whole: Vec,
  contacts: Contact[],
  held: Contact[],
  tries: number,
): { next: Vec | null; met: number | null } {
  const most = size(minus(to, at)) - NEARER * ground.contact;
  const isKnown = (patch: number) => contacts.some((c) => c.patch === patch);
  let met: number | null = null;
  for (let k = 0, step = whole; k < tries; k++, step = times(step, SHORTER)) {
    const length = size(step);
    let landed = landing(ground, at, step, contacts, held);
    for (let turn = 0; landed && turn < 2; turn++) {
      const { goal, followed } = landed;
      const next = over(ground, at, goal, followed, contacts);
      const by = minus(next.at, at);
      const isStep = size(by) >= LEAST_STEP * length && dot(by, step) > 0;
      if (isStep && size(minus(to, next.at)) < most) {
        // Where contacts meet at a small angle, what presses on both is too far into the corner: less far it is not.
        for (const share of [1, SHORT_OF_CORNER]) {
          const found = plus(at, times(by, share));
          if (!ground.isBlocked(found) && size(minus(to, found)) < most) return { next: found, met: null };
        }
      }
      const other = next.stopped;
      if (other !== null && !isKnown(other)) return { next: null, met: other };
      met ??= other;
      // Of surfaces that are all but tangent where the part is another may rise above the one that was followed.
      landed = other === null || followed.includes(other) ? null : landOn(ground, plus(at, step), length, [other]);
    }
  }
  return { next: null, met };
}

/** A place on the surface, and the patches that it is on. */
interface Landing {
  goal: Vec;
  followed: number[];
}

/** Where a step comes down on the surface, and on which patches; null if it does not. */
function landing(ground: Ground, at: Vec, step: Vec, contacts: Contact[], held: Contact[]): Landing | null {
  const length = size(step);
  const end = plus(at, step);
  const isClose = (c: Contact): boolean => {
    const share = held.includes(c) ? FOLLOWED_HELD : FOLLOWED;
    return Math.abs(dot(c.normal, step) + c.room) <= share * length + TOUCHES * ground.contact;
  };
  const patches = contacts.filter((c) => c.patch !== null && isClose(c)).map((c) => c.patch!);
  const all = landOn(ground, end, length, patches);
  if (all || patches.length < 2) return all;
  // Surfaces that are tangent where the part is may part from there on: then one of them is followed.
  const raised = (patch: number): number => {
    const { value, gradient } = ground.constraint(patch, end);
    return value / size(gradient);
  };
  const lowest = patches.reduce((a, b) => (raised(b) < raised(a) ? b : a));
  return landOn(ground, end, length, [lowest]);
}

/** The place on some patches nearest to where a step of a length ends; null if there is none near. */
function landOn(ground: Ground, end: Vec, length: number, followed: number[]): Landing | null {
  const goal = onSurface(ground, end, followed);
  return goal && size(minus(goal, end)) <= FARTHEST_LANDING * length ? { goal, followed } : null;
}

/** From one place on the surface to another: off it by as much as it rises between, across, and down to it again. Also which patch was met. */
function over(ground: Ground, at: Vec, goal: Vec, followed: number[], contacts: Contact[]): Stop {
  const middle = times(plus(at, goal), 0.5);
  let lift = CLEAR * ground.contact;
  for (const patch of followed) {
    const { value, gradient } = ground.constraint(patch, middle);
    lift = Math.max(lift, (-RISE * value) / size(gradient) + CLEAR * ground.contact);
  }
  const raised = ground.advance(at, plus(at, times(offFrom(followed, contacts, lift), lift)));
  const across = ground.advance(raised.at, plus(goal, minus(raised.at, at)));
  const down = onSurface(ground, across.at, followed) ?? goal;
  // What is followed stops a step that is not lifted enough: then it counts what has stopped the lift.
  const isFollowed = across.stopped !== null && followed.includes(across.stopped);
  const stopped = isFollowed ? (raised.stopped ?? across.stopped) : (across.stopped ?? raised.stopped);
  return { at: ground.advance(across.at, down).at, stopped };
}

/**
 * The direction of a lift: the shortest vector with a product of at least 1 with the normal of each contact followed, and of at least 0 with
 * those of contacts that the lift may come to. Zero if there is none.
 */
function offFrom(followed: number[], contacts: Contact[], lift: number): Vec {
  const isFollowed = (c: Contact) => c.patch !== null && followed.includes(c.patch);
  const spaces = contacts
    .filter((c) => isFollowed(c) || c.room <= LIFT_ROOM * lift)
    .map((c) => ({ normal: c.normal, room: isFollowed(c) ? -1 : 0 }));
  const zero = contacts[0]?.normal.map(() => 0) ?? [];
  const way = waysAlong(zero, spaces).find((w) => w.allowed);
  return way && size(way.by) < STEEPEST ? way.by : zero;
}

/** The nearest place at which the contact functions of some patches vanish, by Newton's method; null if it does not come to one. */
function onSurface(ground: Ground, from: Vec, patches: number[]): Vec | null {
  let at = from;
  for (let k = 0; k < NEWTON_STEPS; k++) {
    const all = patches.map((patch) => ground.constraint(patch, at));
    if (all.every((c) => Math.abs(c.value) <= ON_SURFACE * ground.contact)) return at;
    const rows: Vec[] = [];
    let weights: number[] = [];
    const values: number[] = [];
    // Of contacts that depend on each other the first do.
    for (const c of all) {
      if (rows.length === at.length) break;
      const more = weightsOf([...rows, c.gradient], [...values, -c.value]);
      if (!more) continue;
      rows.push(c.gradient);
      values.push(-c.value);
      weights = more;
    }
    at = weighted(rows, weights, at);
    if (!at.every(Number.isFinite)) return null;
  }
  return null;
}
