//! Contact functions in f64 compared with double-double, with their derivatives.

use super::*;
use crate::number::{Dd, SecondOrder};

/// A line or arc from its middle, with the direction of its outward normal, its length and its bulge.
fn edge(middle: (f64, f64), normal: f64, length: f64, bulge: f64) -> FeatureShape<f64> {
    let (n, half) = (Vector::from_angle(normal), 0.5 * length);
    let chord = n.left();
    let at = |s: f64| {
        let p = Point::new(middle.0, middle.1) + chord * s;
        [p.x, p.y]
    };
    FeatureShape::Edge {
        start: at(-half),
        end: at(half),
        bulge,
    }
}

/// The value and all derivatives of a contact function by the position and orientation of the moving part, in f64.
fn derived<T: Real>(
    fixed: &FeatureShape<f64>,
    moving: &FeatureShape<f64>,
    [x, y, theta]: [f64; 3],
) -> Vec<f64> {
    type Second<T> = SecondOrder<3, T>;
    let real = |_: usize, x: f64| Second::<T>::constant(x);
    let variable = |x: f64, i| Second::<T>::variable(T::constant(x), i);
    let placement = Placement::new([variable(x, 0), variable(y, 1)], variable(theta, 2));
    let f = contact_function(&fixed.map(real), &moving.map(real), &placement);
    let mut all = vec![f.value.value()];
    all.extend(f.gradient.map(T::value));
    all.extend(f.hessian.iter().flatten().map(|h| h.value()));
    all
}

/// Nearly parallel features of radii up to 1e9, whose normals oppose each other up to a small angle.
#[test]
fn doubles_are_as_good_as_double_double() {
    /// Limits of the errors of values, gradients and Hessians, relative to max(1, value). Where a radius of 1e9 turns, an orientation that
    /// is rounded by 1e-16 moves it by 1e-7.
    const LIMITS: [f64; 3] = [1e-12, 1e-7, 1e-13];
    let mut worst = [0.0_f64; 3];
    let bulges = [0.0, 1e-9, 1e-7, 1e-5, -1e-5, 1e-3, -1e-3, 0.1, -0.1];
    let pairs = bulges.into_iter().chain([0.2, 0.9, -0.9]);
    for (bulge, other) in
        pairs.flat_map(|b| bulges[..4].iter().chain(&[0.1, 0.9]).map(move |&o| (b, o)))
    {
        let fixed = edge((0.1, 0.2), 0.3, 1.7, bulge);
        let moving = edge((-0.4, 0.3), 1.1, 0.8, other);
        for (x, turn) in [(0.2, 0.0), (0.3, 1e-7), (0.4, 1e-3), (0.5, 0.1), (0.6, 0.4)] {
            let at = [x, 0.7, 0.3 + core::f64::consts::PI - 1.1 + turn];
            let ours = derived::<f64>(&fixed, &moving, at);
            let exact = derived::<Dd>(&fixed, &moving, at);
            for (i, (a, b)) in ours.iter().zip(&exact).enumerate() {
                let class = usize::from(i > 0) + usize::from(i > 3);
                worst[class] = worst[class].max((a - b).abs() / b.abs().max(1.0));
            }
        }
    }
    assert!(
        worst.iter().zip(LIMITS).all(|(&w, limit)| w < limit),
        "{worst:?}"
    );
}
