//! The smallest change that makes joints smooth, to first order: W Jᵀ λ with (J W Jᵀ) λ = −ρ.

use crate::geometry::Vector;
use crate::number::Dd;

use super::side::{Knot, Side};

/// Ratio of a pivot to the diagonal below which its row depends on others.
const DEPENDENT: f64 = 1e-26;
/// Derivatives of the directions in which an edge leaves and arrives.
struct Slopes {
    /// Derivatives by the displacements of its start and of its end.
    leave: [Vector; 2],
    arrive: [Vector; 2],
    /// Derivative by its sagitta for arriving; with the opposite sign for leaving.
    sagitta: f64,
}

impl Slopes {
    /// dθ = left(u)·(d₁ − d₀) / L and dh = 2 db / (1 + b²), where 2 (b/L) / (1 + b²) = sin h / L.
    fn new(side: &Side) -> Self {
        let turn = side.along.left() * (1.0 / side.chord);
        let sin = side.half.1 / side.chord;
        let (start, end) = (side.leave * -sin, side.arrive * sin);
        let square = side.bulge * side.bulge;
        Self {
            leave: [-turn - start, turn - end],
            arrive: [start - turn, end + turn],
            sagitta: if side.is_line() {
                0.0
            } else {
                4.0 / (side.chord * (1.0 + square))
            },
        }
    }
}

/// Dependence of the residuals of some joints on one unknown.
struct Column<const N: usize> {
    joints: [usize; N],
    slopes: [f64; N],
    weight: f64,
}

/// The columns of the Jacobian: two for each vertex, and one for each sagitta.
fn columns(slopes: &[Slopes], knots: &[Knot]) -> impl Iterator<Item = ([Column<3>; 2], Column<2>)> {
    let n = knots.len();
    (0..n).map(move |i| {
        let (previous, next) = ((i + n - 1) % n, (i + 1) % n);
        let (before, after, knot) = (&slopes[previous], &slopes[i], &knots[i]);
        let joints = [previous, i, next];
        let held = joints.map(|j| if knots[j].smooth { 1.0 } else { 0.0 });
        let by = [
            before.leave[1] * held[0],
            (after.leave[0] - before.arrive[1]) * held[1],
            -after.arrive[0] * held[2],
        ];
        let column = |k: usize| Column {
            joints,
            slopes: by.map(|v| v.dot(knot.axes[k])),
            weight: knot.weights[k],
        };
        let sagitta = Column {
            joints: [i, next],
            slopes: [-after.sagitta * held[1], -after.sagitta * held[2]],
            weight: knot.sagitta_weight,
        };
        ([column(0), column(1)], sagitta)
    })
}

impl<const N: usize> Column<N> {
    fn add_to(&self, band: &mut BandMatrix) {
        for (p, &j) in self.joints.iter().enumerate() {
            let weighted = Dd::from(self.slopes[p]) * self.weight;
            for (q, &k) in self.joints.iter().enumerate() {
                band.add(j, k, weighted * self.slopes[q]);
            }
        }
    }

    /// The change of the unknown, for the given multipliers.
    fn change(&self, multipliers: &[Dd]) -> f64 {
        let mut sum = Dd::ZERO;
        for (&j, &slope) in self.joints.iter().zip(&self.slopes) {
            sum = sum + multipliers[j] * slope;
        }
        (sum * self.weight).to_f64()
    }
}

/// The displacements W Jᵀ λ with (J W Jᵀ) λ = −ρ.
pub(super) fn least_moves(sides: &[Side], knots: &[Knot], residuals: &[Dd]) -> Vec<[f64; 3]> {
    let slopes: Vec<Slopes> = sides.iter().map(Slopes::new).collect();
    let mut band = BandMatrix::new(sides.len());
    for ([x, y], sagitta) in columns(&slopes, knots) {
        x.add_to(&mut band);
        y.add_to(&mut band);
        sagitta.add_to(&mut band);
    }
    let wanted: Vec<Dd> = residuals.iter().map(|&r| -r).collect();
    let multipliers = band.solved(&wanted);
    columns(&slopes, knots)
        .map(|([x, y], sagitta)| {
            [
                x.change(&multipliers),
                y.change(&multipliers),
                sagitta.change(&multipliers),
            ]
        })
        .collect()
}

/// A symmetric matrix that couples each of a cyclic chain of n unknowns with two on either side.
///
/// It is in double-double, because a line of many pieces makes it as ill-conditioned as the fourth power of their number.
struct BandMatrix {
    /// Row p, column p − HALF + k is at `[p][k]`.
    rows: Vec<[Dd; HALF + 1]>,
}

/// The half width of the folded band.
const HALF: usize = 4;

impl BandMatrix {
    fn new(n: usize) -> Self {
        Self {
            rows: vec![[Dd::ZERO; HALF + 1]; n],
        }
    }

    /// Index of an unknown in the order 0, n−1, 1, n−2, …
    fn place(&self, i: usize) -> usize {
        let n = self.rows.len();
        if 2 * i < n {
            2 * i
        } else {
            2 * (n - 1 - i) + 1
        }
    }

    /// Adds to row j, column k; entries above the diagonal are ignored.
    fn add(&mut self, j: usize, k: usize, value: Dd) {
        let (p, q) = (self.place(j), self.place(k));
        if q <= p {
            let entry = &mut self.rows[p][HALF + q - p];
            *entry = *entry + value;
        }
    }

    /// The solution of a consistent system; 0 for unknowns whose rows depend on previous ones.
    fn solved(mut self, right: &[Dd]) -> Vec<Dd> {
        let n = self.rows.len();
        // 1/D, with 0 for dependent rows.
        let mut inverse = vec![Dd::ZERO; n];
        for p in 0..n {
            let first = p.saturating_sub(HALF);
            let mut row = self.rows[p];
            let mut pivot = row[HALF];
            for q in first..p {
                let mut sum = row[HALF + q - p];
                for m in first.max(q.saturating_sub(HALF))..q {
                    // There row[m] is still L D.
                    sum = sum - row[HALF + m - p] * self.rows[q][HALF + m - q];
                }
                row[HALF + q - p] = sum;
            }
            for q in first..p {
                let entry = row[HALF + q - p];
                let factor = entry * inverse[q];
                pivot = pivot - entry * factor;
                row[HALF + q - p] = factor;
            }
            if pivot.to_f64() > DEPENDENT * row[HALF].to_f64() {
                inverse[p] = Dd::ONE / pivot;
            } else {
                row = [Dd::ZERO; HALF + 1];
            }
            self.rows[p] = row;
        }
        let mut solution = vec![Dd::ZERO; n];
        for (i, &value) in right.iter().enumerate() {
            solution[self.place(i)] = value;
        }
        for p in 0..n {
            for q in p.saturating_sub(HALF)..p {
                solution[p] = solution[p] - self.rows[p][HALF + q - p] * solution[q];
            }
        }
        for (value, &inverse) in solution.iter_mut().zip(&inverse) {
            *value = *value * inverse;
        }
        for p in (0..n).rev() {
            for q in p.saturating_sub(HALF)..p {
                solution[q] = solution[q] - self.rows[p][HALF + q - p] * solution[p];
            }
        }
        (0..n).map(|i| solution[self.place(i)]).collect()
    }
}
