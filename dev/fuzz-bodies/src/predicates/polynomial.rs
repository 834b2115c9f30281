//! Roots of a product of up to four α cos θ + β sin θ + γ.

use core::f64::consts::{PI, TAU};

use cspace::fuzzing::polynomial_roots;

use super::trig::{Exact, coefficients};
use crate::Finding;
use crate::draw::Bytes;
use crate::exact::Dyadic;

/// Error of a value, in units of its terms, as documented by the library.
const ERROR: f64 = 64.0 * f64::EPSILON;

/// Angles as doubles are right to this, radians.
const ANGLE: f64 = 1e-13;

/// A degree-four polynomial of known roots.
struct Product(Vec<Exact>);

impl Product {
    fn at(&self, theta: f64) -> Dyadic {
        let one = Dyadic::of(1.0);
        self.0.iter().fold(one, |p, f| &p * &f.at(theta))
    }
}

/// In every interval between the brackets that were found the polynomial has one sign, within its error: so two places
/// on either side of a root that no bracket contains must not have values of different signs that are both larger than
/// the error.
pub(super) fn run(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let mut factors: Vec<[f64; 3]> = Vec::new();
    for _ in 0..=bytes.below(4) {
        let fresh = coefficients(bytes);
        let again = bytes.below(3) == 0;
        let [alpha, beta, gamma] = match factors.last() {
            // Roots that all but agree with those before.
            Some(&[a, b, c]) if again => [bytes.nudged(a), bytes.nudged(b), bytes.nudged(c)],
            _ => fresh,
        };
        factors.push([alpha, beta, gamma]);
    }
    let narrowest = bytes.one_of(&[1e-8, 1e-8, 1e-9, 1.0 / (1u64 << 36) as f64]);
    let (lo, hi) = (-PI, PI);
    let terms: f64 = (factors.iter())
        .map(|f| f.iter().map(|x| x.abs()).sum::<f64>())
        .product();
    let value = |c: f64, s: f64| {
        let product = factors.iter().map(|[a, b, g]| a * c + b * s + g).product();
        (product, terms)
    };
    let [found, vague] = polynomial_roots(value, lo, hi, narrowest);
    let exact = Product(
        (factors.iter())
            .map(|f| {
                let [alpha, beta, gamma] = f.map(Dyadic::of);
                Exact { alpha, beta, gamma }
            })
            .collect(),
    );
    let mut roots: Vec<f64> = (exact.0.iter().flat_map(Exact::roots))
        .map(|r| r.near)
        .collect();
    roots.sort_by(f64::total_cmp);
    let mut covered: Vec<(f64, f64)> = found.iter().chain(&vague).copied().collect();
    covered.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (i, &root) in roots.iter().enumerate() {
        let holds = |&(a, b): &(f64, f64)| (a - ANGLE..=b + ANGLE).contains(&root);
        if covered.iter().any(holds) || (root - lo).min(hi - root) < ANGLE {
            continue;
        }
        // Half way to the next root on either side, but not beyond the next bracket.
        let n = roots.len();
        let before = if i > 0 {
            roots[i - 1]
        } else {
            roots[n - 1] - TAU
        };
        let after = if i + 1 < n {
            roots[i + 1]
        } else {
            roots[0] + TAU
        };
        let gap_lo = covered
            .iter()
            .map(|c| c.1)
            .filter(|&x| x < root)
            .fold(lo, f64::max);
        let gap_hi = covered
            .iter()
            .map(|c| c.0)
            .filter(|&x| x > root)
            .fold(hi, f64::min);
        let (a, b) = (
            (0.5 * (before + root)).max(gap_lo),
            (0.5 * (root + after)).min(gap_hi),
        );
        if root - a < narrowest || b - root < narrowest {
            continue;
        }
        let (at_a, at_b) = (exact.at(a), exact.at(b));
        let clear = Dyadic::of(2.0 * ERROR * terms);
        if at_a.sign() * at_b.sign() < 0 && at_a.abs() > clear && at_b.abs() > clear {
            return Err(Finding::new(format!(
                "the polynomial {factors:?} (a product of α cos θ + β sin θ + γ) is {:e} at {a:?} and {:e} at {b:?}, \
                 and no bracket is between: {found:?}, vague {vague:?}",
                at_a.near(),
                at_b.near()
            )));
        }
    }
    Ok(1 + roots.len() as u64)
}
