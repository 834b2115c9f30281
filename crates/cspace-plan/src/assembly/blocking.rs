//! Which groups the first instant of a motion lets go.
//!
//! In a motion that begins with the rates δ = (ẋ, ẏ, ω) of the assembly's frame, a unit is blocked by another if the distance of two
//! features that touch shrinks: g · δ < 0 with its gradient g. What moves takes along what blocks it, and so on: the group of a unit
//! is all that is reached from it in this graph. Which units block which changes with δ only across the planes g · δ = 0, so the
//! lines in which two of them meet, and what is beside these, stand for all δ.

use std::collections::BTreeSet;

use crate::legs::{Coords, Scene};

use super::units::{Set, Units, members};

/// Features that touch are as far apart as the gap, at corners farther by their mitre: they are looked for within so many gaps.
const TOUCHING: f64 = 3.0;
/// Gradients and rates that differ by less, relative to 1, are the same.
const SAME: f64 = 1e-7;
/// How far beside a line rates are tried, relative to 1.
const BESIDE: f64 = 1e-3;
/// Number of gradients that are combined with each other; further ones are not.
const MOST: usize = 64;

/// A contact: where the first unit is moved with these rates towards the second.
#[derive(Debug, Clone, Copy)]
struct Contact {
    moving: usize,
    staying: usize,
    gradient: Coords,
}

/// The contacts of the assembly as drawn.
#[derive(Debug, Clone)]
pub(super) struct Blocking {
    contacts: Vec<Contact>,
    rates: Vec<Coords>,
}

impl Blocking {
    pub(super) fn new(units: &Units) -> Self {
        let mut contacts = Vec::new();
        for a in 0..units.of.len() {
            for b in a + 1..units.of.len() {
                for (&i, &j) in
                    (units.of[a].iter()).flat_map(|i| units.of[b].iter().map(move |j| (i, j)))
                {
                    let scene = Scene::new(&units.here[i], &units.here[j], None);
                    let lever = scene.levers()[2].max(f64::MIN_POSITIVE);
                    for near in scene.near([0.0; 3], TOUCHING * units.gap) {
                        let [x, y, t] = near.gradient;
                        let Some(g) = unit([x, y, t / lever]) else {
                            continue;
                        };
                        // Both move alike: what the second gains by a motion is what the first loses.
                        contacts.push(Contact {
                            moving: b,
                            staying: a,
                            gradient: g,
                        });
                        contacts.push(Contact {
                            moving: a,
                            staying: b,
                            gradient: g.map(|c| -c),
                        });
                    }
                }
            }
        }
        let rates = rates(&contacts);
        Self { contacts, rates }
    }

    /// The groups within a set that some motion lets go, the smallest first.
    pub(super) fn groups(&self, set: Set, still: Set) -> Vec<Set> {
        let mut found = BTreeSet::new();
        for rate in &self.rates {
            let blocked_by = |u: usize| -> Set {
                (self.contacts.iter())
                    .filter(|c| c.moving == u && set >> c.staying & 1 == 1)
                    .filter(|c| dot(&c.gradient, rate) < -SAME)
                    .fold(0, |all, c| all | 1 << c.staying)
            };
            let direct: Vec<(usize, Set)> = members(set).map(|u| (u, blocked_by(u))).collect();
            for &(first, _) in &direct {
                let mut group: Set = 1 << first;
                loop {
                    let more = (direct.iter())
                        .filter(|(u, _)| group >> u & 1 == 1)
                        .fold(group, |all, (_, by)| all | by);
                    if more == group {
                        break;
                    }
                    group = more;
                }
                if group & still == 0 && group != set {
                    found.insert((group.count_ones(), group));
                }
            }
        }
        found.into_iter().map(|(_, group)| group).collect()
    }
}

/// Rates that stand for all.
fn rates(contacts: &[Contact]) -> Vec<Coords> {
    let mut planes: Vec<Coords> = Vec::new();
    for c in contacts {
        let same = |p: &&Coords| (0..3).all(|k| (p[k] - c.gradient[k]).abs() < SAME);
        if planes.len() < MOST && !planes.iter().any(|p| same(&p)) {
            planes.push(c.gradient);
        }
    }
    let mut rates = planes.clone();
    for (i, a) in planes.iter().enumerate() {
        for b in &planes[i + 1..] {
            let Some(line) = unit(cross(a, b)) else {
                continue;
            };
            for sign in [-1.0, 1.0] {
                rates.push(line.map(|c| sign * c));
                for (s, t) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                    let beside = |k: usize| sign * line[k] + BESIDE * (s * a[k] + t * b[k]);
                    rates.push(core::array::from_fn(beside));
                }
            }
        }
    }
    rates
}

fn dot(a: &Coords, b: &Coords) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn cross(a: &Coords, b: &Coords) -> Coords {
    core::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

fn unit(a: Coords) -> Option<Coords> {
    let length = dot(&a, &a).sqrt();
    (length > SAME).then(|| a.map(|c| c / length))
}
