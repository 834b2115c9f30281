/**
 * Which features of two parts touch, or nearly do: distances between the features themselves, as `PairSpace::near_features` has them.
 *
 * Two features are a pair where one line is at right angles to both, from a point of the one to a point of the other, and their outward
 * normals face each other along it. Normals of a vertex are those between its two edges.
 */

import type { Frame } from "../scene.js";
import type { Classification, Touch } from "./api.js";
import { areApart, boxOf, coversWay, directionAlong, fractionHeading, placedEdge, pointAlong, startDirection, sweepOf, type Box, type Edge } from "./edge.js";
import { touchingAt, type FeatureKey, type Features, type Osculating, type Placement } from "./features.js";
import { add, angleOf, cross, distance, dot, fromAngle, left, length, right, sub, TAU, times, turned, type Point } from "./plane.js";
import { ALIGNED, NEAREST, PLACED, ROUNDED, SMOOTH, STRAIGHT } from "./tolerance.js";

/** A line, an arc or a convex vertex of a part that is placed, seen from the fixed part's centre. */
interface Feature {
  key: FeatureKey;
  /** About the part's own centre. */
  circle: Osculating;
  /** Null of a vertex. */
  edge: Edge | null;
  /** The angle of the first of its outward normals, and how far the others turn from it counter-clockwise (radians). */
  normals: { first: number; turn: number };
  box: Box;
}

const UNMOVED: Placement = { at: { x: 0, y: 0 }, turn: { cos: 1, sin: 0 } };

export class NearFeatures {
  private readonly ofFixed: Feature[];
  /** More than the rounding error of points of the two parts about the origin (model unit). */
  private readonly rounding: number;

  constructor(
    private readonly fixed: Features,
    private readonly moving: Features,
    private readonly frame: Frame,
    private readonly resolution: number,
  ) {
    this.ofFixed = featuresOf(fixed, UNMOVED);
    const { fixed_center, moving_center, scale } = frame;
    this.rounding = ROUNDED * (length(fixed_center) + length(moving_center) + 2 / scale);
  }

  /**
   * The features that are no farther than `within` (model unit) apart; the nearest first, and all in the fixed part's frame. They overlap by
   * no more than the configuration's class lets them.
   */
  at(by: Placement, within: number, found: Classification): Touch[] {
    const slack = this.rounding + PLACED * length(by.at);
    // So well it is known where parts in contact are: they may be in each other by as much, and beyond the ends of features.
    const beyond = slack + (found === "contact" ? this.resolution : 0);
    const deepest = found === "blocked" ? within + slack : beyond;
    const { fixed_center: center, moving_center } = this.frame;
    const aboutCenters = { at: add(sub(by.at, center), turned(by.turn, moving_center)), turn: by.turn };
    const touches: Touch[] = [];
    for (const g of featuresOf(this.moving, aboutCenters)) {
      for (const f of this.ofFixed) {
        if (areApart(f.box, g.box, within + beyond)) continue;
        const near = pairOf(f, g, aboutCenters, slack, beyond);
        if (!near || near.distance > within || near.distance < -deepest) continue;
        const at = add(near.at, center);
        const names = { fixed: this.fixed.text(f.key), moving: this.moving.text(g.key) };
        touches.push({ ...names, distance: near.distance, at: [at.x, at.y], normal: [near.normal.x, near.normal.y] });
      }
    }
    return touches.sort((a, b) => Math.abs(a.distance) - Math.abs(b.distance));
  }

  /** The first of all features. */
  nearest(by: Placement, found: Classification): Touch | null {
    const { fixed_center, moving_center } = this.frame;
    const all = this.fixed.arm + length(fixed_center) + this.moving.arm + length(moving_center) + length(by.at);
    for (let within = NEAREST * (this.fixed.size + this.moving.size); ; within *= 2) {
      const [first] = this.at(by, within, found);
      if (first || !(within <= all)) return first ?? null;
    }
  }
}

function featuresOf(part: Features, by: Placement): Feature[] {
  const features: Feature[] = [];
  part.edges.forEach((loop, loop_index) => {
    const edges = loop.map((e) => placedEdge(e, by.turn, by.at));
    const back = part.reversed[loop_index];
    edges.forEach((edge, index) => {
      const kind = edge.bulge > 0 ? "convexarc" : edge.bulge < 0 ? "concavearc" : "line";
      const heading = edge.bulge < 0 ? directionAlong(edge, 1) : startDirection(edge);
      const key: FeatureKey = { kind, loop_index, index };
      const normals = { first: angleOf(right(heading)), turn: Math.abs(sweepOf(edge)) };
      features.push({ key, circle: part.circle(key), edge, normals, box: boxOf(edge) });

      const after = (back ? index + edges.length - 1 : index + 1) % edges.length;
      const next = edges[after]!;
      const [d, e] = [directionAlong(edge, 1), startDirection(next)];
      const turn = Math.atan2(cross(d, e), dot(d, e));
      if (turn <= (edge.bulge === 0 && next.bulge === 0 ? 2 * STRAIGHT : SMOOTH)) return;
      const vertex: FeatureKey = { kind: "vertex", loop_index, index: back ? index : after };
      const box = { lo: edge.end, hi: edge.end };
      features.push({ key: vertex, circle: part.circle(vertex), edge: null, normals: { first: angleOf(right(d)), turn }, box });
    });
  });
  return features;
}

function hasNormal({ normals: { first, turn } }: Feature, direction: Point): boolean {
  const from = angleOf(direction) - first + ALIGNED;
  return from - TAU * Math.floor(from / TAU) <= turn + 2 * ALIGNED;
}

/** The point of the feature itself, of one on its line or circle; null if it is farther than `most` beyond its ends. */
function onto({ edge, box }: Feature, p: Point, most: number): Point | null {
  if (!edge) return box.lo;
  if (coversWay(edge, sub(p, edge.start))) return p;
  const end = distance(edge.start, p) < distance(edge.end, p) ? edge.start : edge.end;
  return distance(end, p) <= most ? end : null;
}

/** The point of an arc or vertex at which an outward normal is as given. */
function atNormal({ edge, box }: Feature, normal: Point): Point {
  if (!edge) return box.lo;
  const to = left(normal);
  const u = fractionHeading(edge, to);
  if (u !== null) return pointAlong(edge, u);
  // Beyond an end by the rounding of directions.
  return dot(startDirection(edge), to) > dot(directionAlong(edge, 1), to) ? edge.start : edge.end;
}

/** An outward normal of one feature whose opposite is one of the other. */
function commonNormal(f: Feature, g: Feature): Point | null {
  const some = ({ normals: { first, turn } }: Feature) => [first, first + 0.5 * turn, first + turn].map(fromAngle);
  const all = [...some(f), ...some(g).map((n) => times(n, -1))];
  return all.find((n) => hasNormal(f, n) && hasNormal(g, times(n, -1))) ?? null;
}

/** How far two features are apart, the fixed part's point and its normal there. */
interface Near {
  distance: number;
  at: Point;
  normal: Point;
}

/** Where two features face each other, if they do: points nearer to each other than `slack` are one, and some are `beyond` the ends. */
function pairOf(f: Feature, g: Feature, by: Placement, slack: number, beyond: number): Near | null {
  // Lines side by side are told by their ends, and nothing touches a concave arc but what is rounder.
  const radii = [f.circle.radius, g.circle.radius] as const;
  const sum = radii[0] + radii[1];
  if (Math.min(...radii) < 0 ? sum >= 0 : Math.min(...radii) === Infinity) return null;
  const touching = touchingAt(f.circle, g.circle, by);
  let normal: Point | null = touching.normal;
  let ends: [Point | null, Point | null];
  if (sum === Infinity || Math.abs(touching.gap + sum) > slack) {
    ends = [onto(f, touching.onFixed, beyond), onto(g, touching.onMoving, beyond)];
  } else {
    // About one centre they are as near in every direction.
    normal = commonNormal(f, g);
    ends = normal ? [atNormal(f, normal), atNormal(g, times(normal, -1))] : [null, null];
  }
  const [p, q] = ends;
  if (!normal || !p || !q || !hasNormal(f, normal) || !hasNormal(g, times(normal, -1))) return null;
  return { distance: dot(sub(q, p), normal), at: p, normal };
}
