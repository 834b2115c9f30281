/** Contact patches of planar pairs and their boundary curves, in the pair's frame. */

import type { BoundaryData, PatchData } from "../../scene.js";
import { placeError, placeOn, pointAtPlace, type Carrier } from "../carrier.js";
import { carrierOf, gradientOf, spiralAt, valueOf } from "../contact-function.js";
import { add, length, sub, TAU, times, turnBy, type Point, type Turn } from "../plane.js";

/** An orientation brought into a patch's interval by whole turns, if it can be. */
export function turnedInto(patch: PatchData, theta: number): number | null {
  const LESS = 0.999 * TAU;
  const above = theta - patch.lo;
  const t =
    above >= 0 && above < LESS
      ? theta
      : above >= -LESS && above < 0
        ? theta + TAU
        : theta + TAU * Math.ceil((patch.lo - theta) / TAU);
  return t <= patch.hi ? t : null;
}

function placeAndError(own: Carrier, boundary: BoundaryData, t: Turn): { p: Point; error: number } {
  if (boundary.kind === "end") return { p: spiralAt(boundary.spiral, t), error: 0 };
  const other = carrierOf(boundary.with, t);
  const place = placeOn(own, other, boundary.root);
  return { p: pointAtPlace(own, place), error: placeError(own, other, place) };
}

/** A rounding error of an end up to this is accepted (length of the pair's frame). */
const GOOD = 1e-7;
/** How far away the nearest slice is taken where an end is hardly known (radians): the square of it is below what their rounding makes. */
const ASIDE = 1e-5;

/**
 * Where a boundary of a patch is. Where the two carriers almost become one, their crossing is hardly known, yet has a limit: it is found
 * from nearby slices, along the patch's own curve and on the patch's side.
 */
export function boundaryAt(patch: PatchData, own: Carrier, boundary: BoundaryData, theta: number, t: Turn): Point {
  const { p, error } = placeAndError(own, boundary, t);
  if (error <= GOOD) return p;
  const there = turnedInto(patch, theta) ?? theta;
  const size = Math.min(ASIDE, 0.25 * (patch.hi - patch.lo));
  const step = there - patch.lo < patch.hi - there ? size : -size;
  const aside = (k: number) => {
    const turn = turnBy(theta + k * step);
    return placeAndError(carrierOf(patch.function, turn), boundary, turn);
  };
  const near = aside(1);
  const next = aside(2);
  const far = aside(3);
  // A straight line through two, and how far the third is off it: at a tangency, where places move with the square root of the
  // orientation, that is far, and the place itself is better.
  const bend = length(add(sub(near.p, times(next.p, 2)), far.p));
  if (bend + near.error + next.error >= error) return p;
  const q = sub(times(near.p, 2), next.p);
  const { normal } = gradientOf(patch.function, q, t);
  return sub(q, times(normal, valueOf(patch.function, q, t)));
}
