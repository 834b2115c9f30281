//! An assembly as it is played: all parts, those that have left as well, step by step. None ever meets another.

use cspace::{Axis, Configuration, Coordinates, Part};
use cspace_model::Mechanism;
use cspace_oracle::Oracle;
use cspace_plan::assembly::{Kind, Step, TakenApart};

use crate::assembly::judged::places;

/// Brute force looks at every so many of the places of a step.
const EVERY: usize = 25;

/// Where the parts are.
struct Played {
    /// The frame of the parts that a part is among: it moves as these leave.
    frames: Vec<Configuration>,
    /// In that frame.
    at: Vec<Configuration>,
}

/// Plays all steps.
pub(crate) fn play(mechanism: &Mechanism, parts: &[Part], apart: &TakenApart) {
    let n = parts.len();
    let mut played = Played {
        frames: vec![Configuration::IDENTITY; n],
        at: vec![Configuration::IDENTITY; n],
    };
    for step in &apart.steps {
        played.step(parts, step, mechanism.parts[step.moving[0]].axis);
    }
}

impl Played {
    fn step(&mut self, parts: &[Part], step: &Step, axis: Option<Axis>) {
        let on_axis = matches!(step.path.configurations[0], Coordinates::Axes { .. });
        let frame = self.frames[step.staying[0]];
        for &i in step.moving.iter().chain(&step.staying) {
            assert_eq!(self.frames[i], frame, "all are among the same parts");
        }
        let before = self.at.clone();
        let then = |c: Configuration, i: usize| if on_axis { c } else { c.compose(before[i]) };
        let way = places(step, axis);
        let last = way[way.len() - 1];
        let mut places: Vec<_> = way.into_iter().step_by(EVERY).collect();
        for k in 0..=10 {
            let by = step.onward * (f64::from(k) / 10.0);
            places.push(Configuration::new(last.x + by.x, last.y + by.y, last.theta));
        }
        for &c in &places {
            for &i in &step.moving {
                self.at[i] = then(c, i);
            }
            self.check(parts, &step.moving);
        }
        if step.kind == Kind::Leaves {
            for &i in &step.moving {
                self.at[i] = before[i];
                self.frames[i] = frame.compose(places[places.len() - 1]);
            }
        }
    }

    fn check(&self, parts: &[Part], moving: &[usize]) {
        let world = |i: usize| self.frames[i].compose(self.at[i]);
        for &m in moving {
            for s in (0..parts.len()).filter(|s| !moving.contains(s)) {
                let relative = world(s).inverse().compose(world(m));
                let oracle = Oracle::new(&parts[s], &parts[m]);
                assert!(
                    !oracle.judge(relative).overlap,
                    "{m} meets {s} at {:?}",
                    world(m)
                );
            }
        }
    }
}
