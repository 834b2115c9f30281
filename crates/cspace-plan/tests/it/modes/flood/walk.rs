//! Walks that are free for certain: no step is longer than the clearance of any pair lets it be, as parts intersected by brute force say.

use core::f64::consts::TAU;

use cspace::{Axis, AxisMotion, Configuration, Part, Rotation};
use cspace_model::Mechanism;
use cspace_oracle::Oracle;
use cspace_plan::modes::{ModePlace, Modes};

use super::Dice;

/// A step is no longer than this share of what the clearance lets it be.
const SHARE: f64 = 0.9;

/// Largest displacement of a point of a part per unit of its coordinate.
fn speed(part: &Part, axis: &Axis) -> f64 {
    match axis.motion {
        AxisMotion::Revolute { center } => {
            let points = part.loops().iter().flat_map(|l| l.vertices());
            let far = |v: &cspace::Vertex| (v.x - center.x).hypot(v.y - center.y);
            // Arcs of bulges below 0.2 leave their chords by less than a fifth of them.
            1.5 * points.map(far).fold(0.0, f64::max)
        }
        _ => 1.0,
    }
}

fn relative(a: &Configuration, b: &Configuration) -> Configuration {
    let back = Rotation::by(-a.theta);
    let way = back * (b.position() - a.position());
    Configuration::new(way.x, way.y, b.theta - a.theta)
}

pub(crate) struct Walker<'a> {
    modes: &'a Modes,
    axes: [Axis; 3],
    speeds: [f64; 3],
    pairs: Vec<([usize; 2], Oracle)>,
    /// Distance to contact below which a configuration may count as contact.
    resolution: f64,
}

impl<'a> Walker<'a> {
    pub(crate) fn new(mechanism: &Mechanism, modes: &'a Modes) -> Self {
        let axes = *modes.axes();
        let part = |k: usize| &mechanism.parts[modes.parts()[k]].part;
        Self {
            modes,
            axes,
            resolution: (modes.pairs().iter())
                .filter_map(|p| Some(2.0 * p.space.as_ref()?.resolution()))
                .fold(0.0, f64::max),
            speeds: [0, 1, 2].map(|k| speed(part(k), &axes[k])),
            pairs: (cspace_plan::modes::PAIRS.into_iter())
                .map(|[a, b]| ([a, b], Oracle::new(part(a), part(b))))
                .collect(),
        }
    }

    /// The smallest clearance of the pairs; none where two parts overlap.
    fn clearance(&self, at: [f64; 3]) -> Option<f64> {
        let placed = [0, 1, 2].map(|k| self.axes[k].configuration(at[k]));
        let mut smallest = f64::INFINITY;
        for ([a, b], oracle) in &self.pairs {
            let verdict = oracle.judge(relative(&placed[*a], &placed[*b]));
            if verdict.overlap {
                return None;
            }
            smallest = smallest.min(verdict.clearance);
        }
        Some(smallest)
    }

    /// Walks from a configuration of a mode. Panics where a free step leads out of the mode, or what overlaps is in one.
    pub(crate) fn walk(&self, mode: usize, dice: &mut Dice, steps: usize) -> usize {
        let mut at = self.modes.list()[mode].sample;
        let mut taken = 0;
        for _ in 0..steps {
            let clearance = self.clearance(at);
            let Some(clearance) = clearance else {
                panic!("{at:?} overlaps and is in mode {mode}");
            };
            let towards = [0; 3].map(|_| dice.between(-1.0, 1.0));
            // Two parts move towards each other at once.
            let most = 2.0
                * (0..3)
                    .map(|k| towards[k].abs() * self.speeds[k])
                    .fold(0.0, f64::max);
            // Sometimes far, to see what is blocked.
            let length = if dice.roll() < 0.2 {
                dice.between(0.1, TAU)
            } else {
                SHARE * clearance.min(1.0) / most
            };
            let certain = length * most < clearance - self.resolution;
            let next = [0, 1, 2].map(|k| at[k] + length * towards[k]);
            let inside = (0..3).all(|k| {
                self.axes[k]
                    .range
                    .is_none_or(|(lo, hi)| lo <= next[k] && next[k] <= hi)
            });
            if !inside {
                continue;
            }
            let place = self.modes.locate(next).unwrap();
            match self.clearance(next) {
                None => assert!(
                    matches!(place, ModePlace::Blocked(_) | ModePlace::Contact(_)),
                    "{next:?} overlaps and is {place:?}"
                ),
                Some(room) if room > self.resolution => {
                    assert!(
                        matches!(place, ModePlace::Mode(_)),
                        "{next:?} is free by {room:e} and {place:?}"
                    );
                }
                Some(_) => {}
            }
            if certain {
                assert_eq!(place, ModePlace::Mode(mode), "{at:?} to {next:?}");
                at = next;
                taken += 1;
            }
        }
        taken
    }
}
