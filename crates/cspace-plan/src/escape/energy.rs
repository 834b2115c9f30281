//! The energy of a pair in a field of force: weights and springs.

use cspace::{AxisMotion, Point, Real, SecondOrder, Vector};

use crate::legs::Coords;

/// A line is halved so often at most to find its highest energy.
const HALVINGS: u32 = 20;

/// The body that a weight or the end of a spring is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// The ground: of a planar pair, the fixed part.
    Ground,
    /// The fixed part.
    Fixed,
    /// The moving part.
    Moving,
}

/// A force that stays the same, at a point of a part: gravity acts at the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    /// The part.
    pub on: Body,
    /// The point, in the part's frame.
    pub at: Point,
    /// The force, in the frame of the fixed part, or of the ground for pairs with fixed axes.
    pub force: Vector,
}

/// A spring between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Bodies that its ends are on, and the points in the frames of these.
    pub ends: [(Body, Point); 2],
    /// Force for a unit of length.
    pub stiffness: f64,
    /// Its length without force.
    pub length: f64,
}

/// A field of force: the energy is
///
/// ```text
/// U = − Σ F · p + Σ k (|p − q| − l)² / 2
/// ```
///
/// over the weights, with force F at p, and the springs, of stiffness k and length l between p and q.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Field {
    /// Constant forces.
    pub weights: Vec<Weight>,
    /// Springs.
    pub springs: Vec<Spring>,
}

/// The energy of a pair as a function of its coordinates.
#[derive(Debug, Clone)]
pub(super) struct Energy<'a> {
    pub(super) field: &'a Field,
    pub(super) motions: Option<(AxisMotion, AxisMotion)>,
    /// The point of a planar moving part whose place is x and y.
    pub(super) pivot: Vector,
}

impl Energy<'_> {
    /// Where a point of a body is.
    pub(super) fn place<T: Real>(&self, (on, q): (Body, Point), at: [T; 3]) -> [T; 2] {
        let still = [q.x, q.y].map(T::constant);
        let motion = match (self.motions, on) {
            (_, Body::Ground) | (None, Body::Fixed) => return still,
            (None, Body::Moving) => {
                let arm = q.to_vector() - self.pivot;
                return turned(arm, at[2], [at[0], at[1]]);
            }
            (Some((fixed, _)), Body::Fixed) => (fixed, at[0]),
            (Some((_, moving)), Body::Moving) => (moving, at[1]),
        };
        match motion {
            (AxisMotion::Fixed, _) => still,
            (AxisMotion::Revolute { center }, by) => {
                turned(q - center, by, [center.x, center.y].map(T::constant))
            }
            (AxisMotion::Prismatic { direction }, by) => {
                let d = direction.unit();
                [
                    still[0] + by * T::constant(d.x),
                    still[1] + by * T::constant(d.y),
                ]
            }
        }
    }

    /// U at coordinates.
    pub(super) fn of<T: Real>(&self, at: [T; 3]) -> T {
        let mut sum = T::constant(0.0);
        for w in &self.field.weights {
            let p = self.place((w.on, w.at), at);
            sum = sum - p[0] * T::constant(w.force.x) - p[1] * T::constant(w.force.y);
        }
        for s in &self.field.springs {
            let [p, q] = s.ends.map(|end| self.place(end, at));
            let (x, y) = (p[0] - q[0], p[1] - q[1]);
            let stretch = (x * x + y * y).sqrt() - T::constant(s.length);
            sum = sum + stretch * stretch * T::constant(0.5 * s.stiffness);
        }
        sum
    }

    pub(super) fn value(&self, at: Coords) -> f64 {
        self.of(at)
    }

    /// With gradient and Hessian.
    pub(super) fn second_order(&self, at: Coords) -> SecondOrder<3> {
        self.of(core::array::from_fn(|k| SecondOrder::variable(at[k], k)))
    }

    /// How far a point of a body is from what it turns about, and so how far it moves at most for a unit of each coordinate, and
    /// how fast its way bends at most.
    fn levers(&self, (on, q): (Body, Point)) -> (Coords, Coords) {
        let of = |motion: AxisMotion| match motion {
            AxisMotion::Fixed => (0.0, 0.0),
            AxisMotion::Revolute { center } => (q.distance(center), q.distance(center)),
            AxisMotion::Prismatic { .. } => (1.0, 0.0),
        };
        match (self.motions, on) {
            (_, Body::Ground) | (None, Body::Fixed) => ([0.0; 3], [0.0; 3]),
            (None, Body::Moving) => {
                let arm = (q.to_vector() - self.pivot).length();
                ([1.0, 1.0, arm], [0.0, 0.0, arm])
            }
            (Some((fixed, _)), Body::Fixed) => {
                let (lever, bend) = of(fixed);
                ([lever, 0.0, 0.0], [bend, 0.0, 0.0])
            }
            (Some((_, moving)), Body::Moving) => {
                let (lever, bend) = of(moving);
                ([0.0, lever, 0.0], [0.0, bend, 0.0])
            }
        }
    }

    /// The highest U along a line, right to a tolerance, and never too low.
    pub(super) fn highest(&self, from: Coords, to: Coords, tolerance: f64) -> f64 {
        self.highest_in(from, to, tolerance, HALVINGS)
    }

    fn highest_in(&self, from: Coords, to: Coords, tolerance: f64, halvings: u32) -> f64 {
        let middle: Coords = core::array::from_fn(|k| 0.5 * (from[k] + to[k]));
        let half = core::array::from_fn(|k| 0.5 * (to[k] - from[k]).abs());
        let ends = self.value(from).max(self.value(to));
        let bound = self.range(middle, half).1;
        if bound <= ends + tolerance || halvings == 0 {
            return bound.max(ends);
        }
        self.highest_in(from, middle, tolerance, halvings - 1)
            .max(self.highest_in(middle, to, tolerance, halvings - 1))
    }

    /// Least and greatest U of all coordinates within `half` of a middle; the bounds are certain, and right to second order for
    /// weights, to first order for springs.
    pub(super) fn range(&self, middle: Coords, half: Coords) -> (f64, f64) {
        /// U is rounded by less than this share of its terms.
        const ROUNDING: f64 = 1e-14;
        let (mut lo, mut hi) = (0.0, 0.0);
        for w in &self.field.weights {
            let dual = core::array::from_fn(|k| cspace::Dual::<3>::variable(middle[k], k));
            let p = self.place((w.on, w.at), dual);
            let value = -(w.force.x * p[0].value + w.force.y * p[1].value);
            let (_, bends) = self.levers((w.on, w.at));
            let change: f64 = (0..3)
                .map(|k| {
                    let slope = w.force.x * p[0].slope[k] + w.force.y * p[1].slope[k];
                    slope.abs() * half[k] + 0.5 * w.force.length() * bends[k] * half[k] * half[k]
                })
                .sum::<f64>()
                + ROUNDING * value.abs();
            lo += value - change;
            hi += value + change;
        }
        for s in &self.field.springs {
            let [p, q] = s.ends.map(|end| self.place(end, middle));
            let distance = (p[0] - q[0]).hypot(p[1] - q[1]);
            let moved: f64 = (s.ends.iter())
                .map(|&end| {
                    let (levers, _) = self.levers(end);
                    // x and y move a point together by the diagonal.
                    let straight = if self.motions.is_none() {
                        (levers[0] * half[0]).hypot(levers[1] * half[1])
                    } else {
                        levers[0] * half[0] + levers[1] * half[1]
                    };
                    straight + levers[2] * half[2]
                })
                .sum::<f64>()
                + ROUNDING * distance;
            let stretch = (
                (distance - moved).max(0.0) - s.length,
                distance + moved - s.length,
            );
            let squares = (stretch.0 * stretch.0, stretch.1 * stretch.1);
            let least = if stretch.0 <= 0.0 && stretch.1 >= 0.0 {
                0.0
            } else {
                squares.0.min(squares.1)
            };
            lo += 0.5 * s.stiffness * least;
            hi += 0.5 * s.stiffness * squares.0.max(squares.1);
        }
        (lo, hi)
    }
}

fn turned<T: Real>(arm: Vector, by: T, about: [T; 2]) -> [T; 2] {
    let (sin, cos) = by.sin_cos();
    let (x, y) = (T::constant(arm.x), T::constant(arm.y));
    [about[0] + cos * x - sin * y, about[1] + sin * x + cos * y]
}
