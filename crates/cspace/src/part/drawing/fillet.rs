//! Corners rounded by an arc that is tangent to both edges.
//!
//! In a frame with the corner as origin, the line or circle of an edge with unit normal n towards the fillet and curvature κ (positive if
//! it curves towards the fillet) is n · p = κ p² / 2. A centre c at distance r of it, on the fillet's side, has
//!
//! n · c = r + κ s, with s = (c² − r²) / 2.
//!
//! Two edges give c = r m + s q, where m solves n · m = 1 and q solves n · q = κ for both; inserted into s, this is a quadratic equation
//! for s. Its root that goes to 0 with r belongs to the circles that start from the corner. Centres of edges do not occur, so that arcs may
//! be arbitrarily flat.

use crate::geometry::Vector;
use crate::number::Real;
use crate::part::Edge;
use crate::part::tolerance::RESOLUTION;

/// Tolerance, as a fraction of an edge's length, within which a fillet that ends near the end of the edge, or beyond it, takes the whole
/// edge.
///
/// Two fillets that share an edge, as at the ends of a slot, leave only the rounding of the radius to some nine digits.
pub const WHOLE_EDGE: f64 = 1e-9;

/// A rounded corner.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fillet<T = f64> {
    /// Remaining part of the edge before the corner; `None` if the fillet takes all of it.
    pub before: Option<Edge<T>>,
    /// The fillet: an arc of at most half a turn. Its index is that of the edge after the corner.
    pub arc: Edge<T>,
    /// Remaining part of the edge after the corner; `None` if the fillet takes all of it.
    pub after: Option<Edge<T>>,
}

/// Reasons for which a corner cannot be rounded.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FilletError {
    /// A radius is not a positive number.
    #[error("the fillet's radius is {radius:?}: give a positive number")]
    BadRadius {
        /// The radius.
        radius: f64,
    },
    /// The edges continue in one direction, or the second turns back on the first, within [`RESOLUTION`] radians.
    #[error(
        "there is no corner to round, for the edges leave it along one line: remove the fillet"
    )]
    NoCorner,
    /// An edge is not described by finite numbers or has no length, or the second does not start where the first ends.
    #[error(
        "the edges beside the fillet do not meet, or one has no length: give edges that follow each other"
    )]
    NoEdges,
    /// The fillet is not tangent to both edges within their ends.
    #[error(
        "a fillet of radius {radius:?} does not fit: {}",
        match largest {
            Some(r) => format!("give at most {r:?}"),
            None => "remove it, or lengthen the edges beside it".to_owned(),
        }
    )]
    TooLarge {
        /// The radius.
        radius: f64,
        /// The largest radius that fits, if there is one.
        largest: Option<f64>,
    },
    /// A fillet at a neighbouring corner takes all of an edge.
    #[error(
        "a fillet of a neighbouring corner takes all of an edge beside this one: give that fillet a smaller radius"
    )]
    NoEdgeLeft,
}

/// Rounds the corner between two edges, lines or arcs, by an arc of a given radius that is tangent to both. It lies on the narrower side of
/// the corner and joins both edges within their ends.
///
/// # Errors
/// If there is no corner to round, or the fillet does not fit; then the error has the largest radius that fits.
///
/// ```
/// use cspace::part::{fillet, FilletError};
/// use cspace::{Edge, Point};
/// let edge = |start: [f64; 2], end: [f64; 2]| Edge { start: start.into(), end: end.into(), bulge: 0.0, index: 0 };
/// let (before, after) = (edge([0.0, 0.0], [4.0, 0.0]), edge([4.0, 0.0], [4.0, 2.0]));
/// let rounded = fillet(&before, &after, 0.5)?;
/// assert!(rounded.arc.start.distance(Point::new(3.5, 0.0)) < 1e-15);
/// assert!(rounded.arc.end.distance(Point::new(4.0, 0.5)) < 1e-15);
///
/// let Err(FilletError::TooLarge { largest: Some(largest), .. }) = fillet(&before, &after, 3.0) else { panic!() };
/// assert!((largest - 2.0).abs() < 1e-12);
/// # Ok::<(), FilletError>(())
/// ```
pub fn fillet<T: Real>(
    before: &Edge<T>,
    after: &Edge<T>,
    radius: T,
) -> Result<Fillet<T>, FilletError> {
    let given = radius.value();
    if !(given.is_finite() && given > 0.0) {
        return Err(FilletError::BadRadius { radius: given });
    }
    let corner = Corner::new(before, after)?;
    if let Some(fillet) = corner.rounded(radius, WHOLE_EDGE) {
        return Ok(fillet);
    }
    Err(FilletError::TooLarge {
        radius: given,
        largest: corner.largest_below(given),
    })
}

/// The corner between two edges.
struct Corner<'a, T> {
    before: &'a Edge<T>,
    after: &'a Edge<T>,
    /// 1 if it turns left, −1 if right.
    side: f64,
    /// The unit directions in which the first edge arrives and the second leaves.
    directions: [Vector<T>; 2],
    /// The unit normals towards the fillet.
    normals: [Vector<T>; 2],
    /// The curvatures, positive towards the fillet.
    curvatures: [T; 2],
    /// The edges' lengths.
    lengths: [T; 2],
}

impl<'a, T: Real> Corner<'a, T> {
    fn new(before: &'a Edge<T>, after: &'a Edge<T>) -> Result<Self, FilletError> {
        let directions = [before.end_direction(), after.start_direction()];
        let lengths = [before.length(), after.length()];
        let sound = |length: T| length.value().is_finite() && length.value() > 0.0;
        let [u, w] = directions;
        let sin = u.cross(w).value();
        let meet = before.end.map(T::value) == after.start.map(T::value);
        if !(meet && lengths.into_iter().all(sound) && sin.is_finite()) {
            return Err(FilletError::NoEdges);
        }
        if sin.abs() <= RESOLUTION {
            return Err(FilletError::NoCorner);
        }
        let side = sin.signum();
        Ok(Self {
            before,
            after,
            side,
            directions,
            normals: directions.map(|d| d.left() * T::constant(side)),
            curvatures: [before, after].map(|e| T::constant(side) * e.curvature()),
            lengths,
        })
    }

    /// The fillet, if it fits; it may exceed an edge's length by `slack`.
    fn rounded(&self, radius: T, slack: f64) -> Option<Fillet<T>> {
        let real = T::constant;
        // From here on in units of the radius.
        let [a, b] = self.curvatures.map(|k| k * radius);
        if a.value().max(b.value()) >= 1.0 {
            return None; // An edge curves more than the fillet.
        }
        let (center, normals) = (self.center(a, b)?, self.normals);
        // From the feet to the centre.
        let inward = [(normals[0], a), (normals[1], b)];
        let inward = inward.map(|(n, k)| (n - center * k) * (real(1.0) / (real(1.0) - k)));
        let feet = inward.map(|n| center - n);
        let corner = self.before.end;
        let places = feet.map(|foot| corner + foot * radius);

        let [u, w] = self.directions;
        let is_arc = |curvature: T| curvature.value() != 0.0;
        let used = [along(u, -feet[0], is_arc(a)), along(w, feet[1], is_arc(b))];
        let left = [0, 1].map(|i| real(1.0) - used[i] * radius / self.lengths[i]);
        // Written so that NaN does not fit.
        if !left.into_iter().all(|l| l.value() >= -slack) {
            return None;
        }
        let is_whole = left.map(|l| l.value() <= slack);
        let start = if is_whole[0] {
            self.before.start
        } else {
            places[0]
        };
        let end = if is_whole[1] {
            self.after.end
        } else {
            places[1]
        };
        let (sin, cos) = (
            real(self.side) * inward[0].cross(inward[1]),
            inward[0].dot(inward[1]),
        );
        // Half a turn may be rounded to slightly more.
        let turn = sin.atan2(cos);
        let turn = if turn.value() < 0.0 {
            turn + real(core::f64::consts::TAU)
        } else {
            turn
        };
        let rest = |bulge: T, share: T| (bulge.atan() * share).tan();
        Some(Fillet {
            before: (!is_whole[0]).then(|| Edge {
                end: start,
                bulge: rest(self.before.bulge, left[0]),
                ..*self.before
            }),
            arc: Edge {
                start,
                end,
                bulge: real(self.side) * (real(0.25) * turn).tan(),
                index: self.after.index,
            },
            after: (!is_whole[1]).then(|| Edge {
                start: end,
                bulge: rest(self.after.bulge, left[1]),
                ..*self.after
            }),
        })
    }

    /// The fillet's centre from the corner, in units of the radius, for curvatures in its inverse.
    fn center(&self, a: T, b: T) -> Option<Vector<T>> {
        let ([u, w], n, one) = (self.directions, self.normals[0], T::constant(1.0));
        let (cos, sin) = (u.dot(w), T::constant(self.side) * u.cross(w));
        // Half the angle by which the corner turns.
        let tan = if cos.value() >= 0.0 {
            sin / (one + cos)
        } else {
            (one - cos) / sin
        };
        let m = n - u * tan;
        let q = n * a + u * ((cos * a - b) / sin);
        // q² s² − 2 (1 − m · q) s + m² − 1 = 0, and m² − 1 is the square of the tangent.
        let half = one - m.dot(q);
        let root = half * half - q.dot(q) * tan * tan;
        if !(half.value() > 0.0 && root.value() >= 0.0) {
            return None; // So large a circle does not reach into the corner.
        }
        Some(m + q * (tan * tan / (half + root.sqrt())))
    }

    /// The largest fitting radius below one that does not fit. All smaller radii than a fitting one fit.
    fn largest_below(&self, radius: f64) -> Option<f64> {
        /// Number of halvings after which a radius is negligible compared with the edges.
        const HALVINGS: u32 = 200;
        /// Slightly more than the number of bits of an f64.
        const BISECTIONS: u32 = 60;
        let (mut low, mut high) = (0.5 * radius, radius);
        let mut halvings = 0;
        let fits = |radius: f64| self.rounded(T::constant(radius), 0.0).is_some();
        while !fits(low) {
            if halvings == HALVINGS {
                return None;
            }
            halvings += 1;
            (low, high) = (0.5 * low, low);
        }
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if fits(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(low)
    }
}

/// The length of an edge between the corner and a foot, given the chord and the unit direction at the corner, which differ by half the
/// sweep; negative for a line if the foot is behind the corner.
fn along<T: Real>(direction: Vector<T>, chord: Vector<T>, is_arc: bool) -> T {
    if !is_arc {
        return direction.dot(chord);
    }
    let half = (direction.cross(chord)).atan2(direction.dot(chord)).abs();
    if half.value() == 0.0 {
        return chord.length();
    }
    chord.length() * (half / half.sin_cos().0)
}
