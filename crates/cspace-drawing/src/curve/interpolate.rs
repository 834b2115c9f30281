//! Splines through points.

use cspace::{Point, Vector};

use super::Spline;

/// The cubic spline through points, with the directions at its ends where they are given and without curvature there
/// otherwise; a closed one has no ends. The parameter is the length of the chords. None of fewer than two different points.
///
/// A file that has the points a spline was drawn through but not its control points leaves the spline open: this is the
/// most common choice.
pub fn interpolate(
    points: &[Point],
    ends: [Option<Vector>; 2],
    closed: bool,
) -> Option<Vec<Spline>> {
    let mut points: Vec<Point> = points.to_vec();
    points.dedup();
    if closed && points.len() > 2 && points.first() != points.last() {
        points.push(points[0]);
    }
    let n = points.len().checked_sub(1).filter(|&n| n > 0)?;
    let h: Vec<f64> = points.windows(2).map(|p| p[0].distance(p[1])).collect();
    let chord = |i: usize| (points[i + 1] - points[i]) * (1.0 / h[i]);
    // The derivatives m at the points: continuity of the second derivative between two pieces,
    // m[i-1] / h[i-1] + 2 m[i] (1/h[i-1] + 1/h[i]) + m[i+1] / h[i] = 3 (chord[i-1] / h[i-1] + chord[i] / h[i]).
    let periodic = closed && points[0] == points[n];
    let rows = if periodic { n } else { n + 1 };
    let mut system = Tridiagonal::new(rows);
    for i in 0..rows {
        let (before, after) = match (i.checked_sub(1), periodic) {
            (Some(b), _) => (Some(b), (i < n).then_some(i)),
            (None, true) => (Some(n - 1), Some(0)),
            (None, false) => (None, Some(0)),
        };
        let mut row = [0.0; 3];
        let mut right = Vector::ZERO;
        if let Some(b) = before {
            row[0] = 1.0 / h[b];
            row[1] += 2.0 / h[b];
            right = right + chord(b) * (3.0 / h[b]);
        }
        if let Some(a) = after {
            row[2] = 1.0 / h[a];
            row[1] += 2.0 / h[a];
            right = right + chord(a) * (3.0 / h[a]);
        }
        let end = match (before, after) {
            (None, _) => ends[0],
            (_, None) => ends[1],
            _ => None,
        };
        if let Some(direction) = end.filter(|d| d.length() > 0.0) {
            (row, right) = ([0.0, 1.0, 0.0], direction.unit());
        }
        system.rows[i] = row;
        system.right[i] = right;
    }
    let m = system.solve(periodic);
    let pieces = (0..n).map(|i| {
        let (p, q) = (points[i], points[i + 1]);
        let (dp, dq) = (m[i] * (h[i] / 3.0), m[(i + 1) % rows] * (h[i] / 3.0));
        Spline::bezier(&[p, p + dp, q - dq, q])
    });
    Some(pieces.collect())
}

/// Equations between neighbours, with two right sides; the first and the last may be neighbours too.
struct Tridiagonal {
    rows: Vec<[f64; 3]>,
    right: Vec<Vector>,
}

impl Tridiagonal {
    fn new(rows: usize) -> Self {
        Self {
            rows: vec![[0.0, 1.0, 0.0]; rows],
            right: vec![Vector::ZERO; rows],
        }
    }

    fn solve(self, periodic: bool) -> Vec<Vector> {
        let n = self.rows.len();
        if !periodic || n < 3 {
            let right: Vec<[f64; 2]> = self.right.iter().map(|v| [v.x, v.y]).collect();
            let mut rows = self.rows;
            if periodic {
                // Both neighbours are the same one.
                for row in &mut rows {
                    let both = row[0] + row[2];
                    (row[0], row[2]) = (both, both);
                }
            }
            return sweep(&rows, &right)
                .into_iter()
                .map(|[x, y]| Vector::new(x, y))
                .collect();
        }
        // Sherman and Morrison: the corners are a product of two vectors, taken off and put back.
        let (low, high) = (self.rows[0][0], self.rows[n - 1][2]);
        let gamma = -self.rows[0][1];
        let mut rows = self.rows;
        rows[0][1] -= gamma;
        rows[n - 1][1] -= low * high / gamma;
        let mut right: Vec<[f64; 3]> = self.right.iter().map(|v| [v.x, v.y, 0.0]).collect();
        right[0][2] = gamma;
        right[n - 1][2] = high;
        let solved = sweep(&rows, &right);
        let along = |c: usize| solved[0][c] + solved[n - 1][c] * low / gamma;
        let (fx, fy) = (along(0) / (1.0 + along(2)), along(1) / (1.0 + along(2)));
        (solved.iter())
            .map(|[x, y, z]| Vector::new(x - fx * z, y - fy * z))
            .collect()
    }
}

/// Thomas's algorithm; the rows are dominated by their diagonals.
fn sweep<const N: usize>(rows: &[[f64; 3]], right: &[[f64; N]]) -> Vec<[f64; N]> {
    let n = rows.len();
    let mut upper = vec![0.0; n];
    let mut solution = vec![[0.0; N]; n];
    for i in 0..n {
        let (low, mut diagonal) = (rows[i][0], rows[i][1]);
        let mut value = right[i];
        if i > 0 {
            diagonal -= low * upper[i - 1];
            for (v, s) in value.iter_mut().zip(solution[i - 1]) {
                *v -= low * s;
            }
        }
        upper[i] = rows[i][2] / diagonal;
        solution[i] = value.map(|v| v / diagonal);
    }
    for i in (0..n.saturating_sub(1)).rev() {
        let next = solution[i + 1];
        for (s, x) in solution[i].iter_mut().zip(next) {
            *s -= upper[i] * x;
        }
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Through the points, with the derivatives of neighbours equal up to the second.
    #[test]
    fn spline_is_smooth_to_the_second_derivative() {
        let points: Vec<Point> = [(0.0, 0.0), (2.0, 1.0), (3.0, 4.0), (1.0, 5.0), (-1.0, 2.0)]
            .map(|(x, y)| Point::new(x, y))
            .to_vec();
        for closed in [false, true] {
            let pieces = interpolate(&points, [None; 2], closed).unwrap();
            assert_eq!(pieces.len(), if closed { 5 } else { 4 });
            // By length of chord, as the spline is made.
            let second = |p: &Spline, s: f64, h: f64| {
                let step = 1e-4;
                (p.at(0, s + step).1 - p.at(0, s - step).1) * (1.0 / (2.0 * step * h * h))
            };
            let length = |p: &Spline| p.at(0, 0.0).0.distance(p.at(0, 1.0).0);
            let joints = if closed {
                pieces.len()
            } else {
                pieces.len() - 1
            };
            for i in 0..joints {
                let (a, b) = (&pieces[i], &pieces[(i + 1) % pieces.len()]);
                let (la, lb) = (length(a), length(b));
                assert!(a.at(0, 1.0).0.distance(b.at(0, 0.0).0) < 1e-12);
                assert!(
                    (a.at(0, 1.0).1 * (1.0 / la) - b.at(0, 0.0).1 * (1.0 / lb)).length() < 1e-9
                );
                assert!(
                    (second(a, 1.0, la) - second(b, 0.0, lb)).length() < 1e-6,
                    "{closed} {i}"
                );
            }
            if !closed {
                assert!(second(&pieces[0], 0.0, length(&pieces[0])).length() < 1e-6);
            }
        }
    }
}
