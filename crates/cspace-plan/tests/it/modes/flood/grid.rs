//! Free configurations of three parts on a grid, joined where the motion from one to the next is free in both pairs it concerns: by the
//! pairs' own spaces, whatever the sweep of all three coordinates makes of them.

use core::f64::consts::{PI, TAU};

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{AxisMotion, Classification};
use cspace_plan::modes::{ModePlace, Modes};

/// Modes found on a grid.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// Free configurations.
    pub(crate) free: usize,
    /// Number of their connected components.
    pub(crate) components: usize,
    /// Modes that hold one at least.
    pub(crate) met: usize,
}

pub(crate) struct Grid<'a> {
    modes: &'a Modes,
    n: usize,
    /// Start and step along each coordinate, and whether the last place is adjacent to the first.
    along: [(f64, f64, bool); 3],
}

impl<'a> Grid<'a> {
    pub(crate) fn new(modes: &'a Modes, n: usize) -> Self {
        let along = [0, 1, 2].map(|k| {
            let axis = modes.axes()[k];
            let circle = matches!(axis.motion, AxisMotion::Revolute { .. }) && axis.range.is_none();
            // No round numbers: nothing of a drawing is there.
            let offset = 0.237 + 0.031 * k as f64;
            if circle {
                let step = TAU / n as f64;
                return (-PI + offset * step, step, true);
            }
            let (lo, hi) = axis.range.unwrap_or((-30.0, 30.0));
            let step = (hi - lo) / n as f64;
            (lo + offset * step, step, false)
        });
        Self { modes, n, along }
    }

    fn at(&self, i: [usize; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| self.along[k].0 + self.along[k].1 * i[k] as f64)
    }

    fn is_free(&self, at: [f64; 3]) -> bool {
        self.modes.pairs().iter().all(|pair| {
            let [u, v] = pair.coordinates.map(|c| at[c]);
            pair.space
                .as_ref()
                .is_none_or(|s| s.classify(u, v) == Some(Classification::Free))
        })
    }

    /// Whether the step along a coordinate is free.
    fn passes(&self, at: [f64; 3], along: usize) -> bool {
        let step = self.along[along].1;
        self.modes.pairs().iter().all(|pair| {
            let Some(space) = &pair.space else {
                return true;
            };
            let [a, b] = pair.coordinates;
            let rates = match along {
                k if k == a => (step, 0.0),
                k if k == b => (0.0, step),
                _ => return true,
            };
            let outcome = space.first_contact((at[a], at[b]), rates, 1.0);
            matches!(outcome, Ok(AxesMotionOutcome::Free))
        })
    }

    /// Modes found on the grid. Panics if two configurations that a free motion joins are in two modes, or one is in
    /// none.
    pub(crate) fn found(&self) -> Found {
        let n = self.n;
        let index = |i: [usize; 3]| (i[0] * n + i[1]) * n + i[2];
        let places = |number: usize| [number / (n * n), number / n % n, number % n];
        let mode: Vec<Option<usize>> = (0..n * n * n)
            .map(|number| {
                let at = self.at(places(number));
                if !self.is_free(at) {
                    return None;
                }
                match self.modes.locate(at) {
                    Ok(ModePlace::Mode(mode)) => Some(mode),
                    other => panic!("{at:?} is free and {other:?}"),
                }
            })
            .collect();
        let mut above: Vec<usize> = (0..n * n * n).collect();
        fn root(above: &mut [usize], mut i: usize) -> usize {
            while above[i] != i {
                above[i] = above[above[i]];
                i = above[i];
            }
            i
        }
        for number in 0..n * n * n {
            let Some(own) = mode[number] else { continue };
            for k in 0..3 {
                let mut next = places(number);
                next[k] += 1;
                if next[k] == n && !self.along[k].2 {
                    continue;
                }
                next[k] %= n;
                let Some(other) = mode[index(next)] else {
                    continue;
                };
                let at = self.at(places(number));
                if !self.passes(at, k) {
                    continue;
                }
                assert_eq!(own, other, "{at:?} goes on along {k}");
                let (a, b) = (root(&mut above, number), root(&mut above, index(next)));
                above[a] = b;
            }
        }
        let mut met = vec![false; self.modes.list().len()];
        let mut found = Found::default();
        for (number, own) in mode.iter().enumerate() {
            if let Some(own) = *own {
                found.free += 1;
                met[own] = true;
                found.components += usize::from(root(&mut above, number) == number);
            }
        }
        found.met = met.iter().filter(|m| **m).count();
        found
    }
}
