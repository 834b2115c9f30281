//! Modes against grids of free configurations, joined step by step.

mod grid;
mod walk;

use core::f64::consts::TAU;

use cspace::{Axis, Classification, Part, Point, Vector, Vertex};
use cspace_model::{Mechanism, PartEntry};
use cspace_oracle::effort;
use cspace_plan::modes::{ModePlace, Modes};
use grid::Grid;
use walk::Walker;

/// Numbers that look random.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn roll(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.roll()
    }
}

/// A star about a point, some of its edges arcs.
pub(crate) fn star(
    dice: &mut Dice,
    name: &str,
    (x, y): (f64, f64),
    points: u32,
    inner: f64,
    outer: f64,
) -> Part {
    loop {
        let mut vertices = Vec::new();
        for k in 0..2 * points {
            let angle = TAU * (f64::from(k) + dice.between(-0.2, 0.2)) / f64::from(2 * points);
            let radius = if k % 2 == 0 { outer } else { inner } * dice.between(0.8, 1.2);
            let straight = dice.roll() < 0.5;
            let bulge = if straight {
                0.0
            } else {
                dice.between(-0.2, 0.2)
            };
            vertices.push(Vertex::new(
                x + radius * angle.cos(),
                y + radius * angle.sin(),
                bulge,
            ));
        }
        // Edges may cross: then another one.
        if let Ok(part) = Part::new(name, vec![vertices]) {
            return part;
        }
    }
}

pub(crate) fn axis(dice: &mut Dice, kind: u32, (x, y): (f64, f64)) -> Axis {
    let aside = (dice.between(-0.3, 0.3), dice.between(-0.3, 0.3));
    let turn = Axis::revolute(Point::new(x + aside.0, y + aside.1));
    let slide = Axis::prismatic(Vector::from_angle(dice.between(0.0, TAU)));
    match kind {
        0 => turn,
        1 => turn.within(dice.between(-4.0, -1.0), dice.between(1.0, 4.0)),
        2 => slide.within(dice.between(-6.0, -2.0), dice.between(2.0, 6.0)),
        _ => slide,
    }
}

/// Three stars at the corners of a triangle, each near both others.
pub(crate) fn stars(seed: u64) -> Mechanism {
    let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let mut mechanism = Mechanism::new("stars");
    for (k, name) in ["a", "b", "c"].into_iter().enumerate() {
        let angle = TAU * k as f64 / 3.0;
        let at = (2.2 * angle.cos(), 2.2 * angle.sin());
        let points = 2 + (dice.roll() * 3.0) as u32;
        let part = star(&mut dice, name, at, points, 0.9, 2.3);
        let kind = (dice.roll() * 4.0) as u32;
        let axis = axis(&mut dice, kind, at);
        mechanism.parts.push(PartEntry::on(part, axis));
    }
    mechanism.pairs = mechanism.every_two();
    mechanism
}

/// Motions from one place of a grid to the next that are free by the pairs' spaces stay in one mode. Mostly, where
/// passages are wider than its step, the grid has as many components as modes.
#[test]
fn what_a_free_step_joins_is_one_mode() {
    let mut exact = 0;
    let seeds = effort(2, 12);
    for seed in 0..seeds {
        let modes = Modes::compute(&stars(seed), [0, 1, 2]).unwrap();
        assert_eq!(modes.doubts(), 0);
        let found = Grid::new(&modes, 40).found();
        assert!(found.components >= found.met && found.met <= modes.list().len());
        exact += u64::from(found.components == modes.list().len());
        for (k, mode) in modes.list().iter().enumerate() {
            for pair in modes.pairs() {
                let [u, v] = pair.coordinates.map(|c| mode.sample[c]);
                let class = pair.space.as_ref().unwrap().classify(u, v);
                assert_eq!(class, Some(Classification::Free), "{seed} {k} {mode:?}");
            }
            assert_eq!(
                modes.locate(mode.sample),
                Ok(ModePlace::Mode(k)),
                "{seed} {mode:?}"
            );
        }
    }
    assert!(2 * exact >= seeds, "{exact} of {seeds}");
}

#[test]
fn walks_that_are_free_by_brute_force_stay_in_their_mode() {
    let mut taken = 0;
    for seed in 40..effort(46, 60) {
        let mechanism = stars(seed);
        let modes = Modes::compute(&mechanism, [0, 1, 2]).unwrap();
        let walker = Walker::new(&mechanism, &modes);
        let mut dice = Dice(seed);
        for mode in 0..modes.list().len() {
            taken += walker.walk(mode, &mut dice, 400);
        }
    }
    assert!(taken > effort(3_000, 10_000), "{taken}");
}

/// Parts in another order, and so swept along another coordinate, have the same modes.
#[test]
fn the_order_of_the_parts_does_not_matter() {
    for seed in 0..effort(10, 40) {
        let mechanism = stars(seed);
        let modes = Modes::compute(&mechanism, [0, 1, 2]).unwrap();
        for order in [[1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let others = Modes::compute(&mechanism, order).unwrap();
            assert_eq!(others.list().len(), modes.list().len(), "{seed} {order:?}");
            for (k, mode) in modes.list().iter().enumerate() {
                let at = order.map(|i| mode.sample[i]);
                let Ok(ModePlace::Mode(other)) = others.locate(at) else {
                    panic!("{seed} {order:?} {mode:?}");
                };
                let other = &others.list()[other];
                for (j, &i) in order.iter().enumerate() {
                    let ((a, b), (c, d)) = (mode.ranges[i], other.ranges[j]);
                    assert!(
                        (a - c).abs() < 1e-7 && (b - d).abs() < 1e-7,
                        "{seed} {order:?} {k} {i}: {mode:?} {other:?}"
                    );
                    assert_eq!(
                        mode.around(i),
                        other.around(j),
                        "{seed} {order:?} {mode:?} {other:?}"
                    );
                }
                assert_eq!(mode.turns.len(), other.turns.len());
            }
        }
    }
}
