//! Two discs of material that overlap at every configuration of a triangle.

use std::borrow::Cow;

use cspace::{Part, Point, Rotation, Touching, Vector};

use crate::proof::disc::{Disc, Material};

/// Margin of a triangle's witness, as a share of the depth, so that rounding does not invalidate it.
const MARGIN: f64 = 1e-6;
/// Margin as a share of the largest coordinate: the checker's bounds have that error, and more for orientations of many
/// turns.
const ROUNDING: f64 = 1e-12;
/// Triangles of a smaller extent, as a share of the depth, have a witness: if none was found, it is looked for everywhere.
const SMALL: f64 = 0.3;

/// Number of discs of each part that are tried with all of the other's.
const PROMISING: usize = 12;

/// A disc of the moving part's material about a point from the pivot, and one of the fixed part's.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Witness {
    pub(crate) moving: (Vector, f64),
    pub(crate) fixed: Disc,
}

/// The configurations between three: of the pivot, orientations unrolled.
pub(crate) struct Corners {
    pub(crate) corners: [[f64; 3]; 3],
    turns: [Rotation; 3],
    /// The square of the range of orientations.
    range: f64,
}

impl Corners {
    pub(crate) fn new(corners: [[f64; 3]; 3]) -> Self {
        let theta = corners.map(|c| c[2]);
        let range = theta[0].max(theta[1]).max(theta[2]) - theta[0].min(theta[1]).min(theta[2]);
        Self {
            corners,
            turns: theta.map(Rotation::by),
            range: range * range,
        }
    }

    pub(crate) fn middle(&self) -> [f64; 3] {
        let [a, b, c] = self.corners;
        core::array::from_fn(|k| (a[k] + b[k] + c[k]) / 3.0)
    }

    /// Extent of the triangle, with radians multiplied by `lever`.
    pub(crate) fn extent(&self, lever: f64) -> f64 {
        let range = |k: usize| {
            let of = self.corners.map(|c| c[k]);
            of[0].max(of[1]).max(of[2]) - of[0].min(of[1]).min(of[2])
        };
        range(0).max(range(1)).max(range(2) * lever)
    }

    /// Position of a point, given from the pivot, at each corner.
    fn places(&self, q: Vector) -> [Point; 3] {
        core::array::from_fn(|k| {
            let [x, y, _] = self.corners[k];
            Point::new(x, y) + self.turns[k] * q
        })
    }

    /// Lower bound of the overlap of a witness's discs, at all configurations of the triangle.
    pub(crate) fn overlap(&self, of: &Witness) -> f64 {
        let (q, r) = of.moving;
        self.overlap_at(self.places(q), q, r, of.fixed)
    }

    fn overlap_at(&self, places: [Point; 3], q: Vector, r: f64, (c, s): Disc) -> f64 {
        let farthest = places
            .map(|p| (p - c).length())
            .into_iter()
            .fold(0.0, f64::max);
        r + s - farthest - q.length() * self.range / 8.0
    }
}

/// Material of both parts in which discs may lie: that of every two layers that meet.
pub(crate) struct Materials<'a> {
    layers: Vec<Layers<'a>>,
    pivot: Point,
    pub(crate) depth: f64,
    margin: f64,
}

/// Material of two layers that meet.
struct Layers<'a> {
    fixed: Material<'a>,
    moving: Material<'a>,
    /// The layers as the checker reads them, asked for the radii.
    checked: [cspace_check::Part; 2],
}

impl Layers<'_> {
    fn room(&self, side: usize, center: Point) -> f64 {
        let part = &self.checked[side];
        part.room(0..part.loops.len(), [center.x, center.y])
    }
}

impl<'a> Materials<'a> {
    pub(crate) fn new(
        layers: &'a [(Cow<'a, Part>, Cow<'a, Part>)],
        checked: impl Fn(&Part) -> cspace_check::Part,
        pivot: Point,
        depth: f64,
    ) -> Self {
        let layers: Vec<Layers<'a>> = (layers.iter())
            .map(|(fixed, moving)| Layers {
                checked: [checked(fixed), checked(moving)],
                fixed: Material::new(fixed, depth),
                moving: Material::new(moving, depth),
            })
            .collect();
        let extent =
            (layers.iter()).fold(0.0_f64, |m, l| m.max(l.fixed.extent).max(l.moving.extent));
        Self {
            layers,
            pivot,
            depth,
            margin: MARGIN * depth + ROUNDING * extent,
        }
    }

    pub(crate) fn is_enough(&self, overlap: f64) -> bool {
        overlap > self.margin
    }

    /// The discs that overlap most in a triangle, as large as the checker lets them be; where the features of the shrunk pair touch in its
    /// middle is given.
    pub(crate) fn best(
        &self,
        corners: &Corners,
        touching: &Touching,
        lever: f64,
    ) -> Option<Witness> {
        let [x, y, theta] = corners.middle();
        let back = Rotation::by(-theta);
        let on_moving = self.pivot + back * (touching.on_moving - Point::new(x, y));
        let (on_fixed, normal) = (touching.on_fixed, touching.normal);
        let in_layers = |layers: &Layers<'_>| {
            let (mut of_moving, mut of_fixed) = (Vec::new(), Vec::new());
            // Discs of the moving part hold the point by a margin, so that those of the fixed part need not.
            layers
                .moving
                .inwards(on_moving, back * normal, -0.2 * self.depth, &mut of_moving);
            layers
                .fixed
                .inwards(on_fixed, -normal, 0.8 * self.depth, &mut of_fixed);
            let touch = [on_moving, on_fixed];
            let found = self.most(layers, corners, touch, &of_moving, &of_fixed);
            if found.is_some() || corners.extent(lever) > SMALL * self.depth {
                return found;
            }
            layers.moving.between(on_moving, &mut of_moving);
            layers.fixed.between(on_fixed, &mut of_fixed);
            self.most(layers, corners, touch, &of_moving, &of_fixed)
        };
        let overlap = |w: &Witness| corners.overlap(w);
        (self.layers.iter().filter_map(in_layers)).max_by(|a, b| overlap(a).total_cmp(&overlap(b)))
    }

    /// The two that overlap most, if enough, of those that overlap most with a point each.
    fn most(
        &self,
        layers: &Layers<'_>,
        corners: &Corners,
        [on_moving, on_fixed]: [Point; 2],
        of_moving: &[Disc],
        of_fixed: &[Disc],
    ) -> Option<Witness> {
        let touch = (
            on_moving - self.pivot,
            corners.places(on_moving - self.pivot),
        );
        let of_moving = promising(of_moving.iter().map(|&(p, r)| {
            let q = p - self.pivot;
            let places = corners.places(q);
            (
                (q, r, places),
                corners.overlap_at(places, q, r, (on_fixed, 0.0)),
            )
        }));
        let of_fixed = promising(of_fixed.iter().map(|&fixed| {
            let (q, places) = touch;
            (fixed, corners.overlap_at(places, q, 0.0, fixed))
        }));
        let mut best: Option<(Witness, f64)> = None;
        for &(q, r, places) in &of_moving {
            for &fixed in &of_fixed {
                let overlap = corners.overlap_at(places, q, r, fixed);
                if best.is_none_or(|(_, most)| overlap > most) {
                    let moving = (q, r);
                    best = Some((Witness { moving, fixed }, overlap));
                }
            }
        }
        let (mut best, _) = best.filter(|&(_, overlap)| self.is_enough(overlap))?;
        let (p, c) = (self.pivot + best.moving.0, best.fixed.0);
        best.moving = (p - self.pivot, layers.room(1, p));
        best.fixed.1 = layers.room(0, c);
        self.is_enough(corners.overlap(&best)).then_some(best)
    }
}

/// The first few in order of a score, the largest first.
fn promising<T>(scored: impl Iterator<Item = (T, f64)>) -> Vec<T> {
    let mut scored: Vec<_> = scored.collect();
    scored.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    scored.truncate(PROMISING);
    scored.into_iter().map(|(of, _)| of).collect()
}
