//! Roots of a polynomial in an interval, by Bernstein's basis and Descartes' rule of signs, without sampling.

use super::tolerance::ZERO;

/// The highest degree that three contacts make.
pub(super) const MOST: usize = 10;

/// Coefficients of a polynomial in s, lowest power first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Polynomial {
    pub(super) coefficients: [f64; MOST + 1],
    pub(super) degree: usize,
}

impl Polynomial {
    pub(super) const ONE: Self = Self::quadratic([1.0, 0.0, 0.0]);

    /// c₀ + c₁ s + c₂ s².
    pub(super) const fn quadratic(c: [f64; 3]) -> Self {
        let mut coefficients = [0.0; MOST + 1];
        coefficients[0] = c[0];
        coefficients[1] = c[1];
        coefficients[2] = c[2];
        Self {
            coefficients,
            degree: 2,
        }
    }

    /// Product; its degree must not exceed [`MOST`].
    pub(super) fn times(&self, other: &Self) -> Self {
        let mut coefficients = [0.0; MOST + 1];
        for i in 0..=self.degree {
            for j in 0..=other.degree.min(MOST - i) {
                coefficients[i + j] += self.coefficients[i] * other.coefficients[j];
            }
        }
        Self {
            coefficients,
            degree: (self.degree + other.degree).min(MOST),
        }
    }

    /// Sum of this polynomial and a multiple of another.
    pub(super) fn plus(&self, other: &Self, by: f64) -> Self {
        let mut sum = *self;
        sum.degree = self.degree.max(other.degree);
        for (c, d) in sum.coefficients.iter_mut().zip(other.coefficients) {
            *c += by * d;
        }
        sum
    }
}

/// Powers of s on [−1, 1] in Bernstein's basis, for every degree.
///
/// Its coefficient b_j is the blossom at n − j times −1 and j times 1; for sⁱ that is the elementary symmetric polynomial of
/// these numbers over (n over i).
#[derive(Debug)]
pub(super) struct Basis {
    matrices: Vec<[[f64; MOST + 1]; MOST + 1]>,
}

/// Smallest width to which intervals of unknown sign are divided, and smallest distance of different roots: the square
/// root of [`ZERO`] is about the uncertainty of a double root.
const NARROW: f64 = 1e-6;

/// A piece of [−1, 1] still to be looked at, by its ends and the coefficients there.
#[derive(Clone, Copy)]
struct Piece {
    lo: f64,
    hi: f64,
    b: [f64; MOST + 1],
}

impl Basis {
    pub(super) fn new() -> Self {
        let mut choose = [[0.0_f64; MOST + 1]; MOST + 1];
        for n in 0..=MOST {
            choose[n][0] = 1.0;
            for k in 1..=n {
                choose[n][k] = choose[n - 1][k - 1] + choose[n - 1][k];
            }
        }
        let entry = |n: usize, i: usize, j: usize| {
            let terms = (0..=i.min(j)).filter(|k| i - k <= n - j).map(|k| {
                let sign = if (i - k).is_multiple_of(2) { 1.0 } else { -1.0 };
                sign * choose[j][k] * choose[n - j][i - k]
            });
            terms.sum::<f64>() / choose[n][i]
        };
        let matrices = (0..=MOST).map(|n| {
            let mut matrix = [[0.0; MOST + 1]; MOST + 1];
            for (j, row) in matrix.iter_mut().enumerate().take(n + 1) {
                for (i, e) in row.iter_mut().enumerate().take(n + 1) {
                    *e = entry(n, i, j);
                }
            }
            matrix
        });
        Self {
            matrices: matrices.collect(),
        }
    }

    /// Calls `take` with every root in [−1, 1]. Where rounding leaves open whether the polynomial touches zero, once for the
    /// place. None of a polynomial that is zero everywhere.
    pub(super) fn roots(&self, p: &Polynomial, mut take: impl FnMut(f64)) {
        let n = p.degree;
        let mut b = [0.0; MOST + 1];
        for (bj, row) in b.iter_mut().zip(&self.matrices[n]).take(n + 1) {
            *bj = row.iter().zip(p.coefficients).map(|(m, c)| m * c).sum();
        }
        if b.iter().all(|b| b.abs() <= ZERO) {
            return;
        }
        let mut open = vec![Piece {
            lo: -1.0,
            hi: 1.0,
            b,
        }];
        // The last run of pieces, from left to right, in which rounding hides the sign.
        let mut touched = (f64::INFINITY, f64::NEG_INFINITY);
        while let Some(piece) = open.pop() {
            let b = &piece.b[..=n];
            if b.iter().all(|&b| b > ZERO) || b.iter().all(|&b| b < -ZERO) {
                continue;
            }
            let middle = 0.5 * (piece.lo + piece.hi);
            let flat = b.iter().all(|b| b.abs() <= ZERO);
            if flat || piece.hi - piece.lo < NARROW {
                if piece.lo - touched.1 > NARROW {
                    if touched.1 >= touched.0 {
                        take(0.5 * (touched.0 + touched.1));
                    }
                    touched.0 = piece.lo;
                }
                touched.1 = piece.hi;
                continue;
            }
            let certain = b.iter().all(|b| b.abs() > ZERO);
            let changes = b.windows(2).filter(|w| (w[0] > 0.0) != (w[1] > 0.0));
            if certain && changes.count() == 1 {
                take(only_root(b, piece.lo, piece.hi));
                continue;
            }
            let (lower, upper) = halves(&piece, n, middle);
            open.push(upper);
            open.push(lower);
        }
        if touched.1 >= touched.0 {
            take(0.5 * (touched.0 + touched.1));
        }
    }
}

/// De Casteljau's division in the middle.
fn halves(piece: &Piece, n: usize, middle: f64) -> (Piece, Piece) {
    let (mut lower, mut upper) = (*piece, *piece);
    (lower.hi, upper.lo) = (middle, middle);
    for k in 0..n {
        lower.b[k] = upper.b[0];
        for i in 0..n - k {
            upper.b[i] = 0.5 * (upper.b[i] + upper.b[i + 1]);
        }
    }
    lower.b[n] = upper.b[0];
    (lower, upper)
}

/// The value at fraction x of the piece.
fn value(b: &[f64], x: f64) -> f64 {
    let mut c = [0.0; MOST + 1];
    c[..b.len()].copy_from_slice(b);
    for k in (1..b.len()).rev() {
        for i in 0..k {
            c[i] += x * (c[i + 1] - c[i]);
        }
    }
    c[0]
}

/// The root between ends of different signs: secants that keep it enclosed (Illinois), halving when they are slow.
fn only_root(b: &[f64], lo: f64, hi: f64) -> f64 {
    let (mut x, mut y) = (0.0, 1.0);
    let (mut f, mut g) = (b[0], b[b.len() - 1]);
    for step in 0..100 {
        if y - x < 1e-15 {
            break;
        }
        let secant = (x * g - y * f) / (g - f);
        let z = if step % 4 < 3 && secant > x && secant < y {
            secant
        } else {
            0.5 * (x + y)
        };
        let h = value(b, z);
        if h == 0.0 {
            (x, y) = (z, z);
        } else if (h > 0.0) == (f > 0.0) {
            (x, f) = (z, h);
            g *= 0.5;
        } else {
            (y, g) = (z, h);
            f *= 0.5;
        }
    }
    lo + (hi - lo) * 0.5 * (x + y)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(roots: &[f64]) -> Polynomial {
        let one = Polynomial {
            degree: 0,
            ..Polynomial::ONE
        };
        roots.iter().fold(one, |p, &r| {
            let factor = Polynomial {
                degree: 1,
                ..Polynomial::quadratic([-r, 1.0, 0.0])
            };
            p.times(&factor)
        })
    }

    fn found(p: &Polynomial) -> Vec<f64> {
        let mut found = Vec::new();
        Basis::new().roots(p, |s| found.push(s));
        found
    }

    #[test]
    fn roots_in_the_interval_are_found_and_no_others() {
        let inside = [-0.93, -0.4, -0.399, 0.05, 0.31, 0.8];
        let p = product(&[inside.as_slice(), &[1.7, -3.0]].concat());
        let found = found(&p);
        assert_eq!(found.len(), inside.len(), "{found:?}");
        for (f, r) in found.iter().zip(inside) {
            assert!((f - r).abs() < 1e-9, "{f} {r}");
        }
    }

    #[test]
    fn touching_is_found_and_a_near_miss_is_not() {
        let p = product(&[0.25, 0.25, -0.5]);
        let found_here = found(&p);
        assert!(found_here.iter().any(|f| (f - 0.25).abs() < 1e-6));
        assert!(found_here.iter().any(|f| (f + 0.5).abs() < 1e-9));
        assert!(found_here.len() == 2, "{found_here:?}");
        let miss = product(&[0.25, 0.25]).plus(&Polynomial::ONE, 1e-9);
        assert!(found(&miss).is_empty());
    }

    #[test]
    fn nothing_has_no_roots() {
        assert!(found(&Polynomial::quadratic([1e-14, 0.0, 1e-15])).is_empty());
        assert!(found(&Polynomial::ONE).is_empty());
    }
}
