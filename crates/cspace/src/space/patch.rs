//! Contact patches and their boundary curves.

use crate::contact::{ContactFunction, Spiral};
use crate::feature::{FeatureName, PairFrame};
use crate::geometry::{Configuration, Point, Rotation, Vector};
use crate::ids::RegionId;
use crate::number::{Dual, Real};

/// A maximal piece of the contact space on which one pair of features touches between the same two boundary curves.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Patch {
    /// The feature of the fixed part.
    pub fixed: FeatureName,
    /// The feature of the moving part.
    pub moving: FeatureName,
    /// The contact function, in the pair's frame.
    pub function: ContactFunction,
    /// First orientation, in [−π, π) for a full turn.
    pub lo: f64,
    /// Last orientation, at most a turn later; beyond π where the patch passes it.
    pub hi: f64,
    /// Where the patch begins in the direction of travel: blocked space on the left, free space on the right.
    pub left: Boundary,
    /// Where it ends.
    pub right: Boundary,
    /// The free region it bounds.
    pub region: RegionId,
}

/// A boundary curve of a patch: a position for every orientation, in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case", tag = "kind"))]
pub enum Boundary {
    /// One of the two features ends: its neighbour takes over.
    End {
        /// How the end moves.
        spiral: Spiral,
    },
    /// Another pair of features touches at the same time.
    Crossing {
        /// The contact function of that pair.
        with: ContactFunction,
        /// Which of the two crossings of the curves, if there are two: 0 or 1.
        root: u8,
    },
}

/// The kinds of boundary curves, by the contact curves that cross there (section 3.1 of Sacks 1999).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum BoundaryKind {
    /// The end of a feature.
    FeatureEnd,
    /// Two lines of the fixed part.
    FixedLineFixedLine,
    /// Two lines of the moving part.
    MovingLineMovingLine,
    /// A line of each.
    FixedLineMovingLine,
    /// A line of the fixed part and a circle.
    FixedLineCircle,
    /// A line of the moving part and a circle.
    MovingLineCircle,
    /// Two circles.
    CircleCircle,
}

/// A patch together with the frame it is written in, for evaluation.
#[derive(Debug, Clone, Copy)]
pub struct PatchRef<'a> {
    pub(crate) patch: &'a Patch,
    pub(crate) frame: &'a PairFrame,
}

/// A boundary curve together with its patch.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryCurve<'a> {
    patch: PatchRef<'a>,
    boundary: &'a Boundary,
}

impl<'a> PatchRef<'a> {
    /// The plain data.
    pub fn data(&self) -> &'a Patch {
        self.patch
    }

    /// The contact function at a configuration, in the model's unit of length: zero on the patch, positive on its
    /// free side (equations 1–3).
    pub fn contact_function(&self, c: Configuration) -> f64 {
        let p = self.frame.inner_from_outer(c);
        self.frame
            .outer_length(self.patch.function.value(p, c.theta))
    }

    /// The gradient of the contact function by x, y and θ; its first two components are the unit normal towards free
    /// space in the slice.
    pub fn gradient(&self, c: Configuration) -> [f64; 3] {
        let p = self.frame.inner_from_outer(c);
        let (n, by_theta) = self.patch.function.gradient(p, c.theta);
        // The pair's frame itself moves with θ: p' = s (p − c + R d), so ∂p'/∂θ = s left(R d).
        let d = self.frame.moving_center.to_vector();
        let drift = (Rotation::by(c.theta) * d).left();
        [n.x, n.y, self.frame.outer_length(by_theta) + n.dot(drift)]
    }

    /// Where the patch begins in the direction of travel.
    pub fn left(&self) -> BoundaryCurve<'a> {
        BoundaryCurve {
            patch: *self,
            boundary: &self.patch.left,
        }
    }

    /// Where the patch ends.
    pub fn right(&self) -> BoundaryCurve<'a> {
        BoundaryCurve {
            patch: *self,
            boundary: &self.patch.right,
        }
    }

    /// Whether the patch exists at an orientation, taken modulo a turn.
    pub fn contains_orientation(&self, theta: f64) -> bool {
        self.patch.turned_into(theta).is_some()
    }
}

impl Patch {
    /// The orientation reduced to the patch's interval by whole turns, if possible.
    pub(crate) fn turned_into(&self, theta: f64) -> Option<f64> {
        use core::f64::consts::TAU;
        /// The usual cases, without a division: less than a turn above the first orientation, or below.
        const LESS: f64 = 0.999 * TAU;
        let above = theta - self.lo;
        let t = if (0.0..LESS).contains(&above) {
            theta
        } else if (-LESS..0.0).contains(&above) {
            theta + TAU
        } else {
            theta + TAU * ((self.lo - theta) / TAU).ceil()
        };
        (t <= self.hi).then_some(t)
    }

    /// The position of one of its boundaries in the pair's frame.
    pub(crate) fn inner_at(&self, boundary: &Boundary, theta: f64) -> Point {
        self.inner_at_turned(boundary, theta, Rotation::by(theta))
    }

    /// Position of one of the patch's boundaries, as [`inner_at`](Self::inner_at), given the rotation by the orientation.
    ///
    /// Where the two carriers almost coincide, their crossing is hardly known, or not at all, yet has a limit. The limit is found from
    /// nearby slices, as section 3.1 of Sacks 1999 has it: along the patch's own curve, on the patch's side.
    pub(crate) fn inner_at_turned(&self, boundary: &Boundary, theta: f64, turn: Rotation) -> Point {
        /// Acceptable rounding error, in the pair's frame.
        const GOOD: f64 = 1e-7;
        /// Distance of the nearest slice used, radians: its square is below the effect of rounding.
        const ASIDE: f64 = 1e-5;
        let (p, error) = boundary.inner_and_error(&self.function, turn);
        if error <= GOOD {
            return p;
        }
        let t = self.turned_into(theta).unwrap_or(theta);
        let step = ASIDE.min(0.25 * (self.hi - self.lo));
        let step = if t - self.lo < self.hi - t {
            step
        } else {
            -step
        };
        let [near, next, far] = [1.0, 2.0, 3.0].map(|k| {
            let turn = Rotation::by(theta + k * step);
            let (p, error) = boundary.inner_and_error(&self.function, turn);
            (p.to_vector(), error)
        });
        // Extrapolation by a straight line through two points, and the distance of the third from it: at a tangency, where places move with
        // the square root of the orientation, that distance is large, and the place itself is better.
        let bend = (near.0 - next.0 * 2.0 + far.0).length();
        if bend + near.1 + next.1 >= error {
            return p;
        }
        let p = Point::ORIGIN + (near.0 * 2.0 - next.0);
        let (normal, _) = self.function.gradient(p, theta);
        p + -(normal * self.function.value(p, theta))
    }
}

impl BoundaryCurve<'_> {
    /// Kind of the curve.
    pub fn kind(&self) -> BoundaryKind {
        let Boundary::Crossing { with, .. } = self.boundary else {
            return BoundaryKind::FeatureEnd;
        };
        // Whether it is a line of the fixed part; `None` of a circle.
        let line = |f: &ContactFunction| match f {
            ContactFunction::FixedLine { .. } => Some(true),
            ContactFunction::MovingLine { .. } => Some(false),
            ContactFunction::Circle { .. } | ContactFunction::FlatCircle { .. } => None,
        };
        match (line(&self.patch.patch.function), line(with)) {
            (Some(true), Some(true)) => BoundaryKind::FixedLineFixedLine,
            (Some(false), Some(false)) => BoundaryKind::MovingLineMovingLine,
            (Some(_), Some(_)) => BoundaryKind::FixedLineMovingLine,
            (Some(true), None) | (None, Some(true)) => BoundaryKind::FixedLineCircle,
            (Some(false), None) | (None, Some(false)) => BoundaryKind::MovingLineCircle,
            (None, None) => BoundaryKind::CircleCircle,
        }
    }

    /// The configuration on the curve at an orientation of the patch.
    ///
    /// Where rounding has just removed the crossing (at a tangency), the point nearest to a crossing.
    pub fn at(&self, theta: f64) -> Configuration {
        let p = self.patch.patch.inner_at(self.boundary, theta);
        self.patch.frame.outer_from_inner(p, theta)
    }

    /// The derivative (dx/dθ, dy/dθ). Not finite where the curves become tangent.
    pub fn derivative(&self, theta: f64) -> Vector {
        let turn = Rotation::by(Dual::<1>::variable(theta, 0));
        let p = (self.boundary).inner(&self.patch.patch.function, turn);
        let drift = (Rotation::by(theta) * self.patch.frame.moving_center.to_vector()).left();
        p.to_vector().map(|x| x.slope[0]) * (1.0 / self.patch.frame.scale) - drift
    }
}

impl Boundary {
    /// The position in the pair's frame, and its rounding error.
    #[inline]
    pub(crate) fn inner_and_error(&self, own: &ContactFunction, turn: Rotation) -> (Point, f64) {
        match self {
            Self::End { spiral } => (spiral.at(turn), 0.0),
            Self::Crossing { with, root } => {
                let (f, g) = (own.cycle(turn), with.cycle(turn));
                let place = f.root(&g, *root, false);
                (f.at(place), f.place_error(&g, place))
            }
        }
    }

    /// The position in the pair's frame, in any arithmetic.
    pub(crate) fn inner<T: Real>(&self, own: &ContactFunction, turn: Rotation<T>) -> Point<T> {
        match self {
            Self::End { spiral } => spiral.lift().at(turn),
            Self::Crossing { with, root } => {
                let f = own.cycle(turn);
                f.at(f.root(&with.cycle(turn), *root, false))
            }
        }
    }
}
