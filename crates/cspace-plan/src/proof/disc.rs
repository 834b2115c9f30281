//! Discs of a part's material near a point of its boundary.

use core::f64::consts::TAU;

use cspace::{Edge, Part, Point, Rotation, Vector};

/// Smaller discs are left out, as a share of the part's extent from its origin: beside rounding, nothing is left of them.
const LEAST_RADIUS: f64 = 1e-11;
/// The first step into the material, as a share of the depth, and how much farther each next one goes.
const FIRST: f64 = 0.1;
const FARTHER: f64 = 1.6;
/// First step from an edge, as a share of the depth: walls and tips may be that much thinner than the depth.
const THINNEST: f64 = 1e-4;
/// Edges farther away, as a share of the depth, are left out: a place where the shrunk part touches is as far as the depth.
const NEAR: f64 = 1.5;
/// Distance along an edge, as a share of the depth, of places beside a point: a tip holds larger discs away from its
/// end.
const BESIDE: f64 = 0.4;

/// A disc: its centre, and its radius.
pub(crate) type Disc = (Point, f64);

/// A part whose discs are looked for, and how deep.
pub(crate) struct Material<'a> {
    part: &'a Part,
    /// The largest coordinate.
    pub(crate) extent: f64,
    depth: f64,
}

impl<'a> Material<'a> {
    pub(crate) fn new(part: &'a Part, depth: f64) -> Self {
        let bounds = part.bounds();
        let extent = [bounds.min, bounds.max]
            .map(|p| p.x.abs().max(p.y.abs()))
            .into_iter()
            .fold(0.0, f64::max);
        Self {
            part,
            extent,
            depth,
        }
    }

    /// The radius of the largest disc about a point within the part, if it is not too small.
    fn room(&self, p: Point) -> Option<f64> {
        let distances = self.part.edges().map(|e| e.distance(p));
        let nearest = distances.fold(f64::INFINITY, f64::min);
        (nearest > LEAST_RADIUS * self.extent && self.part.contains(p)).then_some(nearest)
    }

    /// Discs about places in directions about one, that reach a point up to `slack`.
    pub(crate) fn inwards(&self, from: Point, inwards: Vector, slack: f64, found: &mut Vec<Disc>) {
        const SIDEWAYS: [f64; 7] = [0.0, 0.35, -0.35, 0.7, -0.7, 1.1, -1.1];
        let mut add = |center, step: f64| {
            let room = self.room(center).filter(|r| r + slack > step);
            found.extend(room.map(|r| (center, r)));
            room.is_some()
        };
        add(from, 0.0);
        for edge in self.part.edges() {
            // About the centre of an arc, the disc does not move while the part turns there.
            if edge.bulge > 0.0 && edge.distance(from) < 2.0 * self.depth {
                add(edge.center(), (edge.center() - from).length());
            }
        }
        for turn in SIDEWAYS {
            let along = Rotation::by(turn) * inwards;
            let mut step = FIRST * self.depth;
            while step < self.part.size() && (add(from + along * step, step) || step < self.depth) {
                step *= FARTHER;
            }
        }
    }

    /// Discs halfway between the edges near a point and the opposite edges, however thin the material is there.
    pub(crate) fn between(&self, from: Point, found: &mut Vec<Disc>) {
        for edge in self.part.edges() {
            if edge.distance(from) > NEAR * self.depth {
                continue;
            }
            for shift in [0.0, -BESIDE, BESIDE] {
                let (start, inwards) = beside(&edge, from, shift * self.depth);
                let mut largest: Option<Disc> = None;
                let mut step = THINNEST * self.depth;
                while step < 2.0 * self.depth {
                    let center = start + inwards * step;
                    match self.room(center) {
                        Some(room) if largest.is_none_or(|(_, most)| room > most) => {
                            largest = Some((center, room));
                        }
                        // Past the middle: farther on there may be other material.
                        _ if largest.is_some() => break,
                        _ => {}
                    }
                    step *= FARTHER;
                }
                found.extend(largest);
            }
        }
    }
}

/// The point of an edge that is nearest to one, moved along the edge but not beyond its ends, and the direction into the material.
fn beside(edge: &Edge, from: Point, shift: f64) -> (Point, Vector) {
    if edge.is_line() {
        let chord = edge.end - edge.start;
        let length = chord.length();
        let at = (from - edge.start).dot(chord) / length + shift;
        let unit = chord * (1.0 / length);
        return (edge.start + unit * at.clamp(0.0, length), unit.left());
    }
    let (center, radius, sweep) = (edge.center(), edge.radius(), edge.sweep());
    let (first, to) = (edge.start - center, from - center);
    let way = sweep.signum();
    let ahead = (way * first.cross(to)).atan2(first.dot(to)).rem_euclid(TAU);
    // Beyond the end, what is nearer to the start is before it.
    let over = sweep.abs();
    let ahead = if ahead > 0.5 * (TAU + over) {
        ahead - TAU
    } else {
        ahead
    };
    let ahead = (ahead.clamp(0.0, over) + shift / radius).clamp(0.0, over);
    let out = Rotation::by(way * ahead) * first;
    (center + out, out * (-way / radius))
}
