//! The configurations among which ways out are looked for.

use core::f64::consts::{PI, TAU};

use cspace::{AxisMotion, Part, Point, Rotation, Vector};

use crate::legs::{Coords, Scene};

use super::energy::{Body, Field};

/// A planar part is out where the circles around the parts are apart. What is looked at goes beyond by this share, so that it can go
/// around.
const AROUND: f64 = 1.1;

/// A box of configurations, in coordinates of which each moves the moving part as little as can be: x and y are the place of a
/// planar part's pivot, in its middle.
#[derive(Debug, Clone)]
pub(super) struct Domain {
    pub(super) lo: Coords,
    pub(super) hi: Coords,
    /// Which coordinates close up.
    pub(super) around: [bool; 3],
    pub(super) pivot: Vector,
    planar: bool,
    /// How far a point of the parts moves at most for a unit of each coordinate.
    levers: Coords,
    /// As above, with the points at which forces act: the coordinate with the larger extent is divided first.
    extents: Coords,
    /// A planar part whose pivot is not within this circle is out.
    circle: (Point, f64),
}

impl Domain {
    pub(super) fn new(scene: &Scene, field: &Field, from: Coords, to: Option<Coords>) -> Self {
        match scene.motions() {
            None => Self::planar(scene, field, from, to),
            Some(motions) => Self::axes(scene, motions, from, to.unwrap_or(from)),
        }
    }

    fn planar(scene: &Scene, field: &Field, from: Coords, to: Option<Coords>) -> Self {
        let (fixed, moving) = scene.parts();
        let symmetry = moving.symmetry();
        let middle = if symmetry.is_round() {
            symmetry.center()
        } else {
            moving.bounds().center()
        };
        let (center, reach) = (fixed.bounds().center(), reach(fixed));
        let own = farthest(moving, middle);
        let pivot = middle.to_vector();
        let arm = (field.weights.iter().map(|w| (w.on, w.at)))
            .chain(field.springs.iter().flat_map(|s| s.ends))
            .filter(|(on, _)| *on == Body::Moving)
            .map(|(_, q)| q.distance(middle))
            .fold(0.0, f64::max);
        let circle = (center, reach + own);
        let (lo, hi) = scene.limits()[2];
        let (around, theta) = if lo.is_finite() {
            (false, (lo, hi))
        } else {
            (true, (-PI, PI))
        };
        let lever = if symmetry.is_round() { 0.0 } else { own };
        let mut domain = Self {
            lo: [0.0, 0.0, theta.0],
            hi: [0.0, 0.0, theta.1],
            around: [false, false, around],
            pivot,
            planar: true,
            levers: [1.0, 1.0, lever],
            extents: [1.0, 1.0, lever.max(arm)],
            circle,
        };
        let half = AROUND * circle.1 + arm;
        let ends = [Some(from), to].into_iter().flatten();
        let ends: Vec<Coords> = ends.map(|c| domain.place(c)).collect();
        let middle = [center.x, center.y];
        for k in 0..2 {
            let beyond = (ends.iter().map(|e| (e[k] - middle[k]).abs())).fold(half, f64::max);
            domain.lo[k] = middle[k] - AROUND * beyond;
            domain.hi[k] = middle[k] + AROUND * beyond;
        }
        domain
    }

    fn axes(scene: &Scene, motions: (AxisMotion, AxisMotion), from: Coords, to: Coords) -> Self {
        let beyond = 2.0 * scene.size();
        let (mut lo, mut hi, mut around) = ([0.0; 3], [0.0; 3], [false; 3]);
        for (k, motion) in [motions.0, motions.1].into_iter().enumerate() {
            let limits = scene.limits()[k];
            let turns = matches!(motion, AxisMotion::Revolute { .. });
            if turns && !limits.0.is_finite() && !limits.1.is_finite() {
                (lo[k], hi[k], around[k]) = (-PI, PI, true);
                continue;
            }
            // A part without a limit goes as far as it has to, to pass all of the other.
            let more = if turns { TAU } else { beyond };
            lo[k] = limits.0.max(from[k].min(to[k]) - more);
            hi[k] = limits.1.min(from[k].max(to[k]) + more);
        }
        Self {
            lo,
            hi,
            around,
            pivot: Vector::ZERO,
            planar: false,
            levers: scene.levers(),
            extents: scene.levers(),
            circle: (Point::ORIGIN, f64::INFINITY),
        }
    }

    /// A configuration in the coordinates of the domain, within one turn of it.
    pub(super) fn within(&self, c: Coords) -> Coords {
        let mut z = self.place(c);
        for (k, x) in z.iter_mut().enumerate() {
            if self.around[k] {
                *x -= TAU * ((*x - self.lo[k]) / TAU).floor();
            }
            *x = x.clamp(self.lo[k], self.hi[k]);
        }
        z
    }

    /// A configuration in the coordinates of the domain, with its turns.
    pub(super) fn place(&self, c: Coords) -> Coords {
        if !self.planar {
            return c;
        }
        let at = Point::new(c[0], c[1]) + Rotation::by(c[2]) * self.pivot;
        [at.x, at.y, c[2]]
    }

    /// Whether a configuration is in the domain, up to whole turns.
    pub(super) fn holds(&self, c: Coords) -> bool {
        let z = self.place(c);
        (0..3).all(|k| self.around[k] || (self.lo[k] <= z[k] && z[k] <= self.hi[k]))
    }

    /// A configuration at which a planar part is out, in a direction from the fixed part, with an orientation.
    pub(super) fn outside(&self, direction: Vector, theta: f64) -> Coords {
        let (center, radius) = self.circle;
        let at = center + direction * (AROUND * radius);
        self.configuration([at.x, at.y, theta])
    }

    /// The configuration of coordinates in the domain.
    pub(super) fn configuration(&self, z: Coords) -> Coords {
        if !self.planar {
            return z;
        }
        let at = Point::new(z[0], z[1]) - Rotation::by(z[2]) * self.pivot;
        [at.x, at.y, z[2]]
    }

    /// How far a point of a part moves at most against the other, for coordinates up to `half` off.
    pub(super) fn moved(&self, half: Coords) -> f64 {
        let by: Coords = core::array::from_fn(|k| half[k] * self.levers[k]);
        if self.planar {
            by[0].hypot(by[1]) + by[2]
        } else {
            by[0] + by[1]
        }
    }

    /// The coordinate whose range moves the parts most, and by how much.
    pub(super) fn widest(&self, lo: Coords, hi: Coords) -> (usize, f64) {
        let extent = |k: usize| (hi[k] - lo[k]) * self.extents[k];
        let widest = (1..3).fold(0, |best, k| if extent(k) > extent(best) { k } else { best });
        (widest, extent(widest))
    }

    /// Whether a planar part is out everywhere in a box.
    pub(super) fn is_out(&self, lo: Coords, hi: Coords) -> bool {
        let (center, radius) = self.circle;
        let nearest = Point::new(center.x.clamp(lo[0], hi[0]), center.y.clamp(lo[1], hi[1]));
        self.planar && nearest.distance(center) >= radius
    }

    /// The corners of a box at which a planar part is out.
    pub(super) fn out(&self, lo: Coords, hi: Coords) -> impl Iterator<Item = [f64; 2]> + '_ {
        let (center, radius) = self.circle;
        [
            [lo[0], lo[1]],
            [hi[0], lo[1]],
            [lo[0], hi[1]],
            [hi[0], hi[1]],
        ]
        .into_iter()
        .filter(move |&[x, y]| self.planar && Point::new(x, y).distance(center) >= radius)
    }
}

/// The radius of a circle around a part about the middle of its bounds.
fn reach(part: &Part) -> f64 {
    farthest(part, part.bounds().center())
}

/// How far a part's points are from one at most.
fn farthest(part: &Part, from: Point) -> f64 {
    /// More than rounding takes away.
    const SLACK: f64 = 1.0 + 1e-12;
    let edge = |e: cspace::Edge| {
        // Within a disc about the middle of its chord, or all of its circle.
        let ends = e.start.distance(from).max(e.end.distance(from));
        if e.is_line() {
            return ends;
        }
        let on_circle = (e.center() - from).length() + e.radius();
        let chord = e.start.distance(e.end);
        let over_chord =
            e.start.midpoint(e.end).distance(from) + 0.5 * chord * e.bulge.abs().max(1.0);
        ends.max(on_circle.min(over_chord))
    };
    part.edges().map(edge).fold(0.0, f64::max) * SLACK
}
