//! Splines of any degree, rational or not.

use cspace::{Point, Vector};

use crate::affine::Affine;

/// The highest degree: programs go to 11, files of a higher one are damaged.
const HIGHEST_DEGREE: usize = 25;

/// A B-spline: Σ N_i(t) w_i P_i / Σ N_i(t) w_i between its first and its last inner knot.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    degree: usize,
    knots: Vec<f64>,
    /// w x, w y and w of each control point.
    control: Vec<[f64; 3]>,
    /// The intervals between different knots, by the index of the knot each starts at.
    spans: Vec<usize>,
}

/// Why numbers make no spline.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SplineError {
    /// The degree is 0 or beyond all use.
    #[error("the degree is {0}, not 1 to {HIGHEST_DEGREE}")]
    Degree(usize),
    /// There are not as many knots as control points and degree ask for.
    #[error("{knots} knots and {control} control points do not make a spline of degree {degree}, which has {} knots", control + degree + 1)]
    Knots {
        /// The number of knots.
        knots: usize,
        /// The number of control points.
        control: usize,
        /// The degree.
        degree: usize,
    },
    /// The knots go down, or are all the same.
    #[error("its knots do not go up")]
    Order,
    /// A knot has a higher multiplicity than the degree, so that the spline jumps there.
    #[error("it is in several pieces: a knot in it has a higher multiplicity than its degree")]
    Broken,
    /// A weight is not positive.
    #[error("a weight is not positive")]
    Weight,
}

impl Spline {
    /// Creates a spline of control points with weights. There are degree + 1 more knots than control points.
    ///
    /// # Errors
    /// If the numbers are inconsistent.
    pub fn new(
        degree: usize,
        knots: Vec<f64>,
        control: &[(Point, f64)],
    ) -> Result<Self, SplineError> {
        if !(1..=HIGHEST_DEGREE).contains(&degree) {
            return Err(SplineError::Degree(degree));
        }
        if control.len() <= degree || knots.len() != control.len() + degree + 1 {
            return Err(SplineError::Knots {
                knots: knots.len(),
                control: control.len(),
                degree,
            });
        }
        if control.iter().any(|&(_, w)| !(w > 0.0 && w.is_finite())) {
            return Err(SplineError::Weight);
        }
        let is_up = knots.windows(2).all(|k| k[0] <= k[1]);
        let spans: Vec<usize> = (degree..control.len())
            .filter(|&k| knots[k] < knots[k + 1])
            .collect();
        if !is_up || spans.is_empty() || !knots.iter().all(|k| k.is_finite()) {
            return Err(SplineError::Order);
        }
        // Where a knot has a higher multiplicity than the degree, the spline goes on elsewhere.
        let is_broken =
            |s: &[usize]| s[1] - s[0] > degree && control[s[1] - degree].0 != control[s[0]].0;
        if spans.windows(2).any(is_broken) {
            return Err(SplineError::Broken);
        }
        let control = control
            .iter()
            .map(|&(p, w)| [p.x * w, p.y * w, w])
            .collect();
        Ok(Self {
            degree,
            knots,
            control,
            spans,
        })
    }

    /// A Bézier curve of two or more control points.
    pub fn bezier(control: &[Point]) -> Self {
        let degree = control.len().saturating_sub(1);
        let mut knots = vec![0.0; degree + 1];
        knots.resize(2 * degree + 2, 1.0);
        Self {
            degree,
            knots,
            control: control.iter().map(|p| [p.x, p.y, 1.0]).collect(),
            spans: vec![degree],
        }
    }

    pub(super) fn spans(&self) -> usize {
        self.spans.len()
    }

    /// Evaluates point and derivative by De Boor's algorithm.
    pub(super) fn at(&self, span: usize, s: f64) -> (Point, Vector) {
        let n = self.degree;
        let k = self.spans[span.min(self.spans.len() - 1)];
        let (lo, hi) = (self.knots[k], self.knots[k + 1]);
        let t = lo + (hi - lo) * s;
        let mut d: Vec<[f64; 3]> = self.control[k - n..=k].to_vec();
        // The last step but one holds the two points whose difference is the derivative.
        let mut derivative = [0.0; 3];
        for r in 1..=n {
            if r == n {
                let width = hi - lo;
                derivative = core::array::from_fn(|c| n as f64 * (d[n][c] - d[n - 1][c]) / width);
            }
            for j in (r..=n).rev() {
                let i = j + k - n;
                let (a, b) = (self.knots[i], self.knots[i + n + 1 - r]);
                let u = if b > a { (t - a) / (b - a) } else { 0.0 };
                d[j] = core::array::from_fn(|c| d[j - 1][c] * (1.0 - u) + d[j][c] * u);
            }
        }
        let [x, y, w] = d[n];
        let point = Point::new(x / w, y / w);
        let [dx, dy, dw] = derivative;
        let velocity = Vector::new((dx - dw * point.x) / w, (dy - dw * point.y) / w);
        (point, velocity * (hi - lo))
    }

    /// Knots and weights, and the control points.
    pub(super) fn form(&self) -> (Vec<f64>, Vec<Point>) {
        let weights = self.control.iter().map(|c| c[2]);
        let points = self
            .control
            .iter()
            .map(|&[x, y, w]| Point::new(x / w, y / w));
        (
            self.knots.iter().copied().chain(weights).collect(),
            points.collect(),
        )
    }

    pub(super) fn mapped(&self, map: &Affine) -> Self {
        let mapped = |&[x, y, w]: &[f64; 3]| {
            let p = map.point(Point::new(x / w, y / w));
            [p.x * w, p.y * w, w]
        };
        Self {
            control: self.control.iter().map(mapped).collect(),
            ..self.clone()
        }
    }

    pub(super) fn reversed(&self) -> Self {
        let ends = self.knots[0] + self.knots[self.knots.len() - 1];
        let knots: Vec<f64> = self.knots.iter().rev().map(|k| ends - k).collect();
        let control: Vec<_> = self.control.iter().rev().copied().collect();
        let spans = (self.degree..control.len())
            .filter(|&k| knots[k] < knots[k + 1])
            .collect();
        Self {
            degree: self.degree,
            knots,
            control,
            spans,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivative_is_that_of_the_points() {
        let points = [
            (0.0, 0.0),
            (1.0, 3.0),
            (3.0, -1.0),
            (5.0, 2.0),
            (6.0, 0.0),
            (7.0, 4.0),
        ];
        let control: Vec<(Point, f64)> = (points.iter().enumerate())
            .map(|(i, &(x, y))| (Point::new(x, y), 1.0 + 0.3 * i as f64))
            .collect();
        let knots = vec![0.0, 0.0, 0.0, 0.0, 0.7, 1.0, 2.0, 2.0, 2.0, 2.0];
        let spline = Spline::new(3, knots, &control).unwrap();
        assert_eq!(spline.spans(), 3);
        for span in 0..3 {
            for s in [0.1, 0.5, 0.9] {
                let h = 1e-6;
                let (a, b) = (spline.at(span, s - h).0, spline.at(span, s + h).0);
                let by_points = (b - a) * (0.5 / h);
                let by_rule = spline.at(span, s).1;
                assert!((by_points - by_rule).length() < 1e-7, "{span} {s}");
                let back = spline.reversed().at(2 - span, 1.0 - s);
                assert!(back.0.distance(spline.at(span, s).0) < 1e-12);
            }
        }
        // Spans meet smoothly: the knots are simple.
        assert!(spline.at(0, 1.0).0.distance(spline.at(1, 0.0).0) < 1e-12);
    }
}
