//! A mechanism with masses as a [`World`].

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use cspace::Point;
use cspace_model::SpringKind;
use nalgebra::{DMatrix, DVector};

use crate::contact::{
    Bound, LONGEST, PAST_END, Path, SAME_PLACE, Watch, ends, goes_past, nearly_touching,
    nearly_touching_of, one_is_enough, overlapping, touching,
};
use crate::dynamic::{Acting, Equations, Joints, Sought, State, Step, Surface, Touch, World};
use crate::pairs::Pairs;
use crate::system::Row;

use super::bodies::{All, Bodies, Posed};
use super::contacts::{Numbers, Opening, opening};
use super::forces::{drives, forces, kinetic};
use super::rates::InTime;

/// Contacts are held at the gaps at which they were found, up to this share of the touching tolerance: so they stay on
/// their patches.
const LEVEL: f64 = 0.5;
/// Largest number of sets of contacts that are tried.
const MOST_SETS: usize = 64;

/// The mechanism.
#[derive(Debug)]
pub(super) struct Mechanical<'a> {
    pub(super) bodies: &'a Bodies,
    pub(super) pairs: &'a Pairs,
    numbers: Numbers,
    watch: RefCell<Watch<'a>>,
    /// The pair that the last step met that met something, if it was one.
    met: Cell<Option<usize>>,
    last: RefCell<Option<Rc<Known>>>,
    has_dampers: bool,
}

impl<'a> Mechanical<'a> {
    pub(super) fn new(bodies: &'a Bodies, pairs: &'a Pairs) -> Self {
        Self {
            numbers: Numbers::new(&bodies.system),
            watch: RefCell::new(Watch::new(&bodies.system, pairs)),
            met: Cell::new(None),
            last: RefCell::new(None),
            has_dampers: has_dampers(bodies.system.mechanism()),
            bodies,
            pairs,
        }
    }

    /// The contact or end of a range of a number.
    pub(super) fn bound(&self, number: usize) -> Bound {
        self.numbers.bound(number)
    }

    fn opening(&self, number: usize, posed: &Posed) -> Opening {
        opening(&self.bodies.system, self.pairs, &self.bound(number), posed)
    }

    /// The place of a contact, in the assembly's frame.
    pub(super) fn place(&self, number: usize, q: &[f64]) -> Option<Point> {
        match self.bound(number) {
            Bound::Contact(touch) => {
                let pair = &self.pairs.list()[touch.pair];
                let place = pair.point(&touch, &self.bodies.system, q).ok();
                place.filter(|p| p.is_finite())
            }
            Bound::Limit { .. } | Bound::Brake { .. } => None,
        }
    }

    /// The force of each drive, by its coordinate.
    pub(super) fn drive_forces(&self, state: &State, acting: &Acting<'_>) -> Vec<(usize, f64)> {
        if self.bodies.system.drives().is_empty() {
            return Vec::new();
        }
        let known = self.known(state, acting.contacts.iter().map(|c| c.0));
        let pushes = acting.accelerations.map(|_| &known.forces.0[..]);
        let (all, contacts) = (&known.posed.all, &known.contacts);
        drives(self.bodies, all, acting, pushes, contacts, &known.joints)
    }

    /// Quantities of a state with some contacts. The last result is kept for the next call.
    fn known(&self, state: &State, contacts: impl Iterator<Item = usize> + Clone) -> Rc<Known> {
        if let Some(known) = &*self.last.borrow()
            && known.state == *state
            && contacts.clone().eq(known.numbers.iter().copied())
        {
            return Rc::clone(known);
        }
        let posed = self.bodies.posed(state);
        let known = Rc::new(Known {
            state: state.clone(),
            numbers: contacts.clone().collect(),
            contacts: contacts.map(|i| self.opening(i, &posed)).collect(),
            joints: self.bodies.system.joints(&posed.at),
            forces: forces(&self.bodies.system, &posed.all),
            posed,
        });
        *self.last.borrow_mut() = Some(Rc::clone(&known));
        known
    }

    /// Coefficients of the free rates, and what driven ones add.
    fn split(&self, rates: &Row<InTime>, v: &[f64]) -> (DVector<f64>, f64) {
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

    fn touch_of(&self, open: &Opening, all: &All) -> Touch {
        let (normal, opens) = self.split(&open.normal, &all.v);
        let (tangent, slides) = self.split(&open.tangent, &all.v);
        Touch {
            gap: open.gap,
            normal,
            tangent,
            drift: [opens, slides],
        }
    }

    fn rows(&self, joints: &[Row<InTime>], count: usize) -> DMatrix<f64> {
        let mut rows = DMatrix::zeros(joints.len(), count);
        for (k, joint) in joints.iter().enumerate() {
            for &(i, r) in joint.entries() {
                if let Some(place) = self.bodies.place[i] {
                    rows[(k, place)] += r.value;
                }
            }
        }
        rows
    }

    /// Placements at a configuration at rest, except for driven parts.
    fn at(&self, t: f64, q: &DVector<f64>) -> Posed {
        self.bodies.posed(&State {
            t,
            q: q.clone(),
            v: DVector::zeros(q.len()),
        })
    }

    /// Applies a function to the path of a step.
    fn along<T>(&self, step: &Step<'_>, what: impl FnOnce(&Path<'_>) -> T) -> T {
        let [a, b] = [step.from, step.to].map(|s| self.bodies.all(s));
        what(&Path::new(
            (&a.q, &a.v),
            (&b.q, &b.v),
            step.to.t - step.from.t,
        ))
    }

    /// Whether a bearing contact has gone past an end of its features.
    fn is_past(&self, step: &Step<'_>) -> bool {
        let system = &self.bodies.system;
        let contacts = step.bearing.iter().filter_map(|&i| match self.bound(i) {
            Bound::Contact(touch) => Some(touch),
            Bound::Limit { .. } | Bound::Brake { .. } => None,
        });
        let mut contacts = contacts.peekable();
        if contacts.peek().is_none() {
            return false;
        }
        let [from, to] = [step.from, step.to].map(|s| self.bodies.coordinates(s.t, &s.q));
        contacts
            .any(|touch| goes_past(&self.pairs.list()[touch.pair], &touch, system, [&from, &to]))
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
        let known = self.known(state, core::iter::empty());
        self.bodies.free(&known.forces.0)
    }

    fn joints(&self, t: f64, q: &DVector<f64>) -> Joints {
        if self.bodies.system.joint_entries().is_empty() {
            return Joints::none(q.len());
        }
        let posed = self.at(t, q);
        let found = self.bodies.system.joints(&posed.at);
        let rates = found.iter().map(|c| -c.rate(&posed.all.v));
        Joints {
            values: DVector::from_iterator(found.len(), found.iter().map(|c| c.value.value)),
            rates: DVector::from_iterator(found.len(), rates),
            rows: self.rows(&found, q.len()),
        }
    }

    fn joint_bends(&self, state: &State) -> DVector<f64> {
        let known = self.known(state, core::iter::empty());
        known.joint_bends()
    }

    fn equations(&self, state: &State, contacts: &[usize]) -> Equations {
        let known = self.known(state, contacts.iter().copied());
        let all = &known.posed.all;
        Equations {
            force: self.bodies.free(&known.forces.0),
            joints: self.rows(&known.joints, state.q.len()),
            joint_bends: known.joint_bends(),
            contacts: (known.contacts.iter())
                .map(|open| {
                    let bends = [open.normal, open.tangent].map(|r| r.change(&all.v, &all.a));
                    (self.touch_of(open, all), bends)
                })
                .collect(),
        }
    }

    fn watched(&self) -> Vec<usize> {
        (0..self.numbers.limits()).collect()
    }

    fn touch(&self, contact: usize, t: f64, q: &DVector<f64>) -> Touch {
        let posed = self.at(t, q);
        self.touch_of(&self.opening(contact, &posed), &posed.all)
    }

    fn touches(&self, contacts: &[usize], t: f64, q: &DVector<f64>) -> Vec<Touch> {
        if contacts.is_empty() {
            return Vec::new();
        }
        let posed = self.at(t, q);
        let each = contacts.iter().map(|&i| self.opening(i, &posed));
        each.map(|open| self.touch_of(&open, &posed.all)).collect()
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

    fn seat(&self, contact: usize, gap: f64) -> Option<f64> {
        let Bound::Contact(touch) = self.bound(contact) else {
            return Some(0.0);
        };
        let level = LEVEL * self.pairs.list()[touch.pair].touch;
        if gap > level {
            None
        } else if gap < -level {
            Some(0.0)
        } else {
            Some(gap)
        }
    }

    fn one_is_enough(&self, a: usize, b: usize) -> bool {
        let (Bound::Contact(s), Bound::Contact(t)) = (self.bound(a), self.bound(b)) else {
            return false;
        };
        s.pair == t.pair && one_is_enough(&self.pairs.list()[s.pair], &s, &t)
    }

    fn passes(&self, a: usize, b: usize, t: f64, q: &DVector<f64>, way: f64) -> bool {
        let near = way.max(SAME_PLACE * self.size());
        a == b || self.are_same(a, b, &self.bodies.coordinates(t, q), near)
    }

    fn met(&self, step: Step<'_>) -> bool {
        let held = self.held(&step);
        let mut watch = self.watch.borrow_mut();
        let met = self.along(&step, |path| watch.check(&held, path));
        if met.is_some() {
            self.met.set(watch.met());
            return true;
        }
        let is_past = self.is_past(&step);
        if is_past {
            self.met.set(None);
        }
        is_past
    }

    fn sought(&self, step: Step<'_>, near: f64) -> Vec<Sought> {
        let q = self.bodies.coordinates(step.to.t, &step.to.q);
        let system = &self.bodies.system;
        // Deep in blocked space no contacts are reported, so those at the beginning of the step are examined as well.
        let before = self.bodies.coordinates(step.from.t, &step.from.q);
        let mut sought: Vec<Sought> = Vec::new();
        // Over some way it is what was met.
        let met = self.met.get().filter(|_| near > 0.0);
        let touching = |q: &Vec<f64>| match met {
            Some(pair) => nearly_touching_of(system, self.pairs, pair, q, near),
            None => nearly_touching(system, self.pairs, q, near),
        };
        for bound in [&before, &q].into_iter().flat_map(touching) {
            let number = self.numbers.number(&bound);
            let gap = Sought::Gap(number);
            if !step.bearing.contains(&number) && !sought.contains(&gap) {
                sought.push(gap);
            }
        }
        for &contact in step.bearing {
            if let Bound::Contact(touch) = self.bound(contact)
                && met.is_none_or(|met| met == touch.pair)
            {
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
                Bound::Limit { .. } | Bound::Brake { .. } => 1.0,
            },
        }
    }

    fn powers(&self, state: &State, acting: &Acting<'_>) -> [f64; 2] {
        let rubs = acting.contacts.iter().any(|c| c.2 != 0.0);
        if !rubs && !self.has_dampers && self.bodies.system.drives().is_empty() {
            return [0.0; 2];
        }
        let known = self.known(state, acting.contacts.iter().map(|c| c.0));
        let v = &known.posed.all.v;
        let driven = self.drive_forces(state, acting);
        let put_in = driven.iter().map(|&(i, force)| force * v[i]).sum();
        let rubbed: f64 = (acting.contacts.iter().zip(&known.contacts))
            .map(|(&(_, _, force), open)| -force * open.tangent.rate(v))
            .sum();
        [put_in, rubbed + known.forces.1]
    }

    fn kinetic(&self, state: &State) -> f64 {
        kinetic(self.bodies, &self.bodies.all(state))
    }

    fn taken(&self, step: Step<'_>) {
        self.along(&step, |path| self.watch.borrow_mut().taken(path));
    }

    fn surface(&self, contact: usize) -> Surface {
        let dynamics = &self.bodies.system.mechanism().dynamics;
        match self.bound(contact) {
            Bound::Contact(touch) => {
                let pair = &self.pairs.list()[touch.pair];
                Surface {
                    friction: pair.friction,
                    restitution: dynamics.restitution_between(pair.fixed, pair.moving),
                }
            }
            // Stops bounce as all does, and nothing slides on them.
            Bound::Limit { .. } | Bound::Brake { .. } => Surface {
                friction: 0.0,
                restitution: dynamics.restitution,
            },
        }
    }

    fn size(&self) -> f64 {
        self.bodies.system.size()
    }

    fn clearance(&self, t: f64, q: &DVector<f64>) -> f64 {
        let q = self.bodies.coordinates(t, q);
        let pairs = self.pairs.list().iter();
        let each = pairs.map(|pair| {
            let at = pair.coordinates(&self.bodies.system, &q);
            pair.space.clearance(at).unwrap_or(0.0)
        });
        each.fold(f64::INFINITY, f64::min)
    }

    fn thinnest(&self) -> f64 {
        let parts = self.bodies.system.mechanism().parts.iter();
        let sides = parts.map(|p| {
            let bounds = p.part.bounds();
            (bounds.max.x - bounds.min.x).min(bounds.max.y - bounds.min.y)
        });
        sides.fold(f64::INFINITY, f64::min)
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

fn has_dampers(mechanism: &cspace_model::Mechanism) -> bool {
    mechanism.dynamics.springs.iter().any(|s| match s.kind {
        SpringKind::Linear { damping, .. } | SpringKind::Torsion { damping, .. } => damping != 0.0,
    })
}

/// Computed quantities of a state.
#[derive(Debug)]
struct Known {
    state: State,
    numbers: Vec<usize>,
    posed: Posed,
    contacts: Vec<Opening>,
    joints: Vec<Row<InTime>>,
    /// Forces on all coordinates, and the power lost to dampers.
    forces: (Vec<f64>, f64),
}

impl Known {
    fn joint_bends(&self) -> DVector<f64> {
        let All { v, a, .. } = &self.posed.all;
        let bends = self.joints.iter().map(|c| -c.change(v, a));
        DVector::from_iterator(self.joints.len(), bends)
    }
}
