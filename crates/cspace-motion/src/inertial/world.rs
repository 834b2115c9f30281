//! A mechanism with masses as a [`World`].

use std::cell::RefCell;

use cspace::Point;
use nalgebra::{DMatrix, DVector};

use crate::contact::{Bound, SAME_PLACE, Watch, ends, overlapping, path, touching};
use crate::dynamic::{Acting, Joints, Sought, State, Step, Surface, Touch, World};
use crate::pairs::Pairs;

use super::bodies::{All, Bodies};
use super::contacts::{Numbers, Opening, opening};
use super::forces::{damped, drives, forces, kinetic};
use super::joints::{Constraint, constraints};
use super::rates::Rates;

/// A step moves no part by more than this, relative to the size of the mechanism; angles count by their parts' sizes.
const LONGEST: f64 = 0.02;
/// How far a contact is past the end of a feature when it is seen to be: an angle, or a length that is always larger than this
/// where it is seen, and never where it is rounding.
const PAST_END: f64 = 2e-11;
/// More sets of contacts than that are not gone through.
const MOST_SETS: usize = 64;

/// The mechanism.
#[derive(Debug)]
pub(super) struct Mechanical<'a> {
    pub(super) bodies: &'a Bodies,
    pub(super) pairs: &'a Pairs,
    numbers: Numbers,
    watch: RefCell<Watch<'a>>,
}

impl<'a> Mechanical<'a> {
    pub(super) fn new(bodies: &'a Bodies, pairs: &'a Pairs) -> Self {
        Self {
            numbers: Numbers::new(&bodies.system),
            watch: RefCell::new(Watch::new(&bodies.system, pairs)),
            bodies,
            pairs,
        }
    }

    /// The contact or end of a range of a number.
    pub(super) fn bound(&self, number: usize) -> Bound {
        self.numbers.bound(number)
    }

    pub(super) fn opening(&self, number: usize, all: &All) -> Opening {
        opening(&self.bodies.system, self.pairs, &self.bound(number), all)
    }

    /// The place of a contact, in the assembly's frame.
    pub(super) fn place(&self, number: usize, q: &[f64]) -> Option<Point> {
        match self.bound(number) {
            Bound::Contact(touch) => {
                let pair = &self.pairs.list()[touch.pair];
                let place = pair.point(&touch, &self.bodies.system, q).ok();
                place.filter(|p| p.is_finite())
            }
            Bound::Limit { .. } => None,
        }
    }

    /// The force of each drive.
    pub(super) fn drive_forces(&self, all: &All, acting: &Acting<'_>) -> Vec<(usize, f64)> {
        if self.bodies.system.drives().is_empty() {
            return Vec::new();
        }
        let contacts: Vec<Opening> = (acting.contacts.iter())
            .map(|c| self.opening(c.0, all))
            .collect();
        let joints = constraints(&self.bodies.system, all);
        drives(self.bodies, all, acting, &contacts, &joints)
    }

    /// Coefficients of the free rates, and what driven ones add.
    fn split(&self, rates: &Rates, v: &[f64]) -> (DVector<f64>, f64) {
        let mut row = DVector::zeros(self.bodies.system.free().len());
        let mut drift = 0.0;
        for &(i, r) in rates.entries() {
            match self.bodies.place[i] {
                Some(k) => row[k] += r.value,
                None => drift += r.value * v[i],
            }
        }
        (row, drift)
    }

    fn touch_of(&self, contact: usize, all: &All) -> (Touch, Opening) {
        let open = self.opening(contact, all);
        let (normal, opens) = self.split(&open.normal, &all.v);
        let (tangent, slides) = self.split(&open.tangent, &all.v);
        let touch = Touch {
            gap: open.gap,
            normal,
            tangent,
            drift: [opens, slides],
        };
        (touch, open)
    }

    /// All of a configuration at rest, but for what is driven.
    fn at(&self, t: f64, q: &DVector<f64>) -> All {
        self.bodies.all(&State {
            t,
            q: q.clone(),
            v: DVector::zeros(q.len()),
        })
    }

    fn constraints(&self, all: &All) -> Vec<Constraint> {
        constraints(&self.bodies.system, all)
    }

    fn path(&self, step: &Step<'_>) -> Vec<Vec<f64>> {
        let [a, b] = [step.from, step.to].map(|s| self.bodies.all(s));
        path((&a.q, &a.v), (&b.q, &b.v), step.to.t - step.from.t)
    }

    fn held(&self, step: &Step<'_>) -> Vec<Bound> {
        step.bearing.iter().map(|&i| self.bound(i)).collect()
    }

    fn are_same(&self, a: usize, b: usize, q: &[f64], near: f64) -> bool {
        let (Bound::Contact(s), Bound::Contact(t)) = (self.bound(a), self.bound(b)) else {
            return a == b;
        };
        let close = || {
            let places = self.place(a, q).zip(self.place(b, q));
            places.is_some_and(|(p, r)| p.distance(r) <= near)
        };
        s.pair == t.pair && (s.features == t.features || close())
    }
}

impl World for Mechanical<'_> {
    fn mass(&self) -> &DMatrix<f64> {
        &self.bodies.mass
    }

    fn force(&self, state: &State) -> DVector<f64> {
        let all = self.bodies.all(state);
        self.bodies.free(&forces(self.bodies, &all))
    }

    fn joints(&self, t: f64, q: &DVector<f64>) -> Joints {
        let all = self.at(t, q);
        let found = self.constraints(&all);
        let rows: Vec<(DVector<f64>, f64)> =
            found.iter().map(|c| self.split(&c.rates, &all.v)).collect();
        Joints {
            values: DVector::from_iterator(found.len(), found.iter().map(|c| c.value)),
            rows: DMatrix::from_fn(found.len(), q.len(), |i, k| rows[i].0[k]),
            rates: DVector::from_iterator(found.len(), rows.iter().map(|r| -r.1)),
        }
    }

    fn joint_bends(&self, state: &State) -> DVector<f64> {
        let all = self.bodies.all(state);
        let found = self.constraints(&all);
        let bends = found.iter().map(|c| -c.rates.change(&all.v, &all.a));
        DVector::from_iterator(found.len(), bends)
    }

    fn watched(&self) -> Vec<usize> {
        (0..self.numbers.limits()).collect()
    }

    fn touch(&self, contact: usize, t: f64, q: &DVector<f64>) -> Touch {
        self.touch_of(contact, &self.at(t, q)).0
    }

    fn bends(&self, contact: usize, state: &State) -> (Touch, [f64; 2]) {
        let all = self.bodies.all(state);
        let (touch, open) = self.touch_of(contact, &all);
        let bends = [open.normal, open.tangent].map(|r| r.change(&all.v, &all.a));
        (touch, bends)
    }

    fn closed(&self, t: f64, q: &DVector<f64>) -> Vec<usize> {
        let q = self.bodies.coordinates(t, q);
        let bounds = touching(&self.bodies.system, self.pairs, &q);
        bounds.iter().map(|b| self.numbers.number(b)).collect()
    }

    fn overlapping(&self, t: f64, q: &DVector<f64>, way: f64) -> Option<Vec<usize>> {
        let q = self.bodies.coordinates(t, q);
        let bounds = overlapping(&self.bodies.system, self.pairs, &q, way)?;
        Some(bounds.iter().map(|b| self.numbers.number(b)).collect())
    }

    fn alternatives(&self, closed: &[usize], t: f64, q: &DVector<f64>) -> Vec<Vec<usize>> {
        let q = self.bodies.coordinates(t, q);
        let near = SAME_PLACE * self.size();
        // Only those are left out that have another at the same place, at first all but one of each place stay.
        let has_other: Vec<bool> = (closed.iter())
            .map(|&a| {
                closed
                    .iter()
                    .any(|&b| a != b && self.are_same(a, b, &q, near))
            })
            .collect();
        let open: Vec<usize> = (0..closed.len()).filter(|&k| has_other[k]).collect();
        if open.is_empty() {
            return vec![closed.to_vec()];
        }
        let bits = open.len().min(MOST_SETS.ilog2() as usize);
        let mut sets: Vec<usize> = (0..1_usize << bits).collect();
        let is_fair = |set: usize| {
            // Each place keeps a contact.
            (0..bits).filter(|k| set >> k & 1 == 1).all(|k| {
                let a = closed[open[k]];
                (0..closed.len()).any(|i| {
                    let left_out = (0..bits).any(|j| set >> j & 1 == 1 && open[j] == i);
                    !left_out && self.are_same(a, closed[i], &q, near)
                })
            })
        };
        sets.sort_by_key(|&set| (!is_fair(set), set.count_ones()));
        (sets.into_iter())
            .map(|set| {
                let left_out = |i: usize| (0..bits).any(|j| set >> j & 1 == 1 && open[j] == i);
                let stays = (0..closed.len()).filter(|&i| !left_out(i));
                stays.map(|i| closed[i]).collect()
            })
            .collect()
    }

    fn is_there(&self, contact: usize, t: f64, q: &DVector<f64>) -> bool {
        let Bound::Contact(touch) = self.bound(contact) else {
            return true;
        };
        let q = self.bodies.coordinates(t, q);
        let pair = &self.pairs.list()[touch.pair];
        let touches = pair.touches(touch.pair, &self.bodies.system, &q, pair.touch);
        touches.is_ok_and(|all| all.iter().any(|t| t.features == touch.features))
    }

    fn is_same(&self, a: usize, b: usize, t: f64, q: &DVector<f64>) -> bool {
        self.passes(a, b, t, q, SAME_PLACE * self.size())
    }

    fn passes(&self, a: usize, b: usize, t: f64, q: &DVector<f64>, way: f64) -> bool {
        let near = way.max(SAME_PLACE * self.size());
        a == b || self.are_same(a, b, &self.bodies.coordinates(t, q), near)
    }

    fn met(&self, step: Step<'_>) -> bool {
        let path = self.path(&step);
        let met = self.watch.borrow_mut().check(&self.held(&step), &path);
        met.is_some()
    }

    fn sought(&self, step: Step<'_>) -> Vec<Sought> {
        let q = self.bodies.coordinates(step.to.t, &step.to.q);
        let system = &self.bodies.system;
        // Where there is nothing but blocked space behind, nothing is told to touch.
        let before = self.bodies.coordinates(step.from.t, &step.from.q);
        let mut sought: Vec<Sought> = Vec::new();
        for bound in [&before, &q]
            .iter()
            .flat_map(|q| touching(system, self.pairs, q))
        {
            let number = self.numbers.number(&bound);
            let gap = Sought::Gap(number);
            if !step.bearing.contains(&number) && !sought.contains(&gap) {
                sought.push(gap);
            }
        }
        for &contact in step.bearing {
            if let Bound::Contact(touch) = self.bound(contact) {
                let pair = &self.pairs.list()[touch.pair];
                let all = ends(pair, &touch, system, &q);
                // At the end to rounding all the time, as where sides lie on each other, is no coming to it.
                let past = (0..all.len()).filter(|&k| all[k] <= -PAST_END);
                sought.extend(past.map(|k| Sought::End(contact, k)));
            }
        }
        sought
    }

    fn value(&self, sought: Sought, t: f64, q: &DVector<f64>) -> f64 {
        let q = self.bodies.coordinates(t, q);
        let system = &self.bodies.system;
        match sought {
            Sought::Gap(contact) => self.bound(contact).function(system, self.pairs, &q).value,
            Sought::End(contact, k) => match self.bound(contact) {
                Bound::Contact(touch) => {
                    let pair = &self.pairs.list()[touch.pair];
                    ends(pair, &touch, system, &q)
                        .get(k)
                        .copied()
                        .unwrap_or(1.0)
                }
                Bound::Limit { .. } => 1.0,
            },
        }
    }

    fn powers(&self, state: &State, acting: &Acting<'_>) -> [f64; 2] {
        let all = self.bodies.all(state);
        let driven = self.drive_forces(&all, acting);
        let put_in = driven.iter().map(|&(i, force)| force * all.v[i]).sum();
        let rubbed: f64 = (acting.contacts.iter())
            .filter(|c| c.2 != 0.0)
            .map(|&(i, _, force)| -force * self.opening(i, &all).tangent.rate(&all.v))
            .sum();
        let damped = if self.has_dampers() {
            damped(self.bodies, &all)
        } else {
            0.0
        };
        [put_in, rubbed + damped]
    }

    fn kinetic(&self, state: &State) -> f64 {
        kinetic(self.bodies, &self.bodies.all(state))
    }

    fn taken(&self, step: Step<'_>) {
        let path = self.path(&step);
        self.watch.borrow_mut().taken(&path);
    }

    fn surface(&self, contact: usize) -> Surface {
        let dynamics = &self.bodies.system.mechanism().dynamics;
        match self.bound(contact) {
            Bound::Contact(touch) => {
                let pair = &self.pairs.list()[touch.pair];
                Surface {
                    friction: dynamics.friction_between(pair.fixed, pair.moving),
                    restitution: dynamics.restitution_between(pair.fixed, pair.moving),
                }
            }
            // Stops bounce as all does, and nothing slides on them.
            Bound::Limit { .. } => Surface {
                friction: 0.0,
                restitution: dynamics.restitution,
            },
        }
    }

    fn size(&self) -> f64 {
        self.bodies.system.size()
    }

    fn reach(&self, change: &DVector<f64>) -> f64 {
        let lengths = self.bodies.system.lengths();
        let free = self.bodies.system.free();
        let each = free.iter().zip(change.iter());
        each.map(|(&i, d)| (d * lengths[i]).abs())
            .fold(0.0, f64::max)
    }

    fn speed(&self, state: &State) -> f64 {
        self.bodies.system.speed(&self.bodies.all(state).v)
    }

    fn longest(&self, state: &State) -> f64 {
        LONGEST * self.size() / self.speed(state)
    }
}

impl Mechanical<'_> {
    fn has_dampers(&self) -> bool {
        use cspace::mechanism::SpringKind;
        let springs = self.bodies.system.mechanism().dynamics.springs.iter();
        springs.into_iter().any(|s| match s.kind {
            SpringKind::Linear { damping, .. } | SpringKind::Torsion { damping, .. } => {
                damping != 0.0
            }
        })
    }
}
