//! Functions that end a step where they fall below 0.

use super::super::flow::{Bearings, Flow, ZERO};
use super::super::world::{State, World};
use super::take::Taken;
use crate::complementarity::{Mode, Solution};

/// Function of a contact whose change of sign is an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Watched {
    /// The gap of a contact that does not bear.
    Gap,
    /// Gap of a contact that does not bear, and never opened by more than rounding.
    Back,
    /// The force of one that does.
    Force,
    /// The rate at which one slides.
    Sliding,
    /// Friction reserve of one that sticks.
    Sticking,
}

impl Watched {
    /// Whether the function concerns the forces of a bearing contact.
    pub(in super::super) fn is_of_force(self) -> bool {
        matches!(self, Self::Force | Self::Sticking)
    }
}

/// Contacts watched in steps between two events, beside the forces of those that bear.
#[derive(Debug, Clone, Default)]
pub(in super::super) struct Looked {
    /// Contacts whose gaps may close.
    pub(in super::super) gaps: Vec<usize>,
    /// Contacts with the force of sliding that others keep from it: they do not slide, and begin to only after another event.
    pub(in super::super) idle: Vec<usize>,
    /// Contacts that go on as they are whatever their own forces are: others take over what these may not bear. Where more contacts bear than
    /// there are freedoms, forces are not determined one by one.
    pub(in super::super) steady: Vec<usize>,
}

/// A function that ends a step where it falls below 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Watch {
    pub(super) contact: usize,
    pub(super) kind: Watched,
    pub(super) value: f64,
}

impl Watch {
    /// Whether the value after a step is negative and lower than before.
    pub(super) fn falls(&self, after: &Self) -> bool {
        after.value < self.value.min(0.0)
    }
}

impl<W: World + ?Sized> Flow<'_, W> {
    /// The functions that are watched, at a state.
    pub(super) fn watches(
        &self,
        state: &State,
        bearings: &Bearings,
        looked: &Looked,
    ) -> Option<Vec<Watch>> {
        let open = |i: &&usize| bearings.iter().all(|b| b.0 != **i);
        let open: Vec<usize> = looked.gaps.iter().filter(open).copied().collect();
        let touches = self.world.touches(&open, state.t, &state.q);
        let gaps = open.into_iter().zip(touches);
        let mut found: Vec<Watch> = gaps
            .map(|(contact, touch)| Watch {
                contact,
                kind: Watched::Gap,
                value: touch.gap,
            })
            .collect();
        if bearings.is_empty() {
            return Some(found);
        }
        let solution = self.accelerations(state, bearings)?;
        for (k, &(contact, mode)) in bearings.iter().enumerate() {
            let kind = match mode {
                Mode::Stick => Some(Watched::Sticking),
                // Without friction it does not matter which way it slides.
                _ if self.world.surface(contact).friction == 0.0 => None,
                _ if looked.idle.contains(&contact) => None,
                _ => Some(Watched::Sliding),
            };
            let is_steady = looked.steady.contains(&contact);
            let all = [Some(Watched::Force), kind].into_iter().flatten();
            for kind in all.filter(|kind| !(is_steady && kind.is_of_force())) {
                found.push(Watch {
                    contact,
                    kind,
                    value: self.bearing_value(kind, k, bearings[k], state, &solution),
                });
            }
        }
        Some(found)
    }

    /// Value of a watched function.
    pub(super) fn watched(&self, watch: &Watch, state: &State, bearings: &Bearings) -> Option<f64> {
        let place = bearings.iter().position(|b| b.0 == watch.contact);
        match (watch.kind, place) {
            (Watched::Gap | Watched::Back, _) | (_, None) => Some(self.gap(watch.contact, state)),
            (kind, Some(k)) => {
                let solution = self.accelerations(state, bearings)?;
                Some(self.bearing_value(kind, k, bearings[k], state, &solution))
            }
        }
    }

    fn gap(&self, contact: usize, state: &State) -> f64 {
        self.world.touch(contact, state.t, &state.q).gap
    }

    /// The first time within a step at which a stage has a force that the mode of its contact does not allow, beyond rounding: one that
    /// comes to its end and begins again within the step, as that of a box that slides over an edge and beyond, has no sign at its end.
    pub(super) fn forbidden(
        &self,
        taken: &Taken,
        h: f64,
        bearings: &Bearings,
        looked: &Looked,
    ) -> Option<f64> {
        let [(_, first_normal, first_tangential), later @ ..] = &taken.forces[..] else {
            return None;
        };
        let mut times = Vec::new();
        for (after, normal, tangential) in later {
            let nothing = ZERO * normal.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
            let falls = |k: usize, contact: usize, mode: Mode| {
                let friction = self.world.surface(contact).friction;
                let below = |first: f64, now: f64| now < first.min(0.0) - nothing;
                let reserve = |normal: f64, tangential: f64| friction * normal - tangential.abs();
                below(first_normal[k], normal[k])
                    || (mode == Mode::Stick
                        && below(
                            reserve(first_normal[k], first_tangential[k]),
                            reserve(normal[k], tangential[k]),
                        ))
            };
            let mut all = bearings.iter().enumerate();
            if *after < h && all.any(|(k, b)| !looked.steady.contains(&b.0) && falls(k, b.0, b.1)) {
                times.push(*after);
            }
        }
        times.into_iter().reduce(f64::min)
    }

    /// Value of a function of the bearing contact at index `place`.
    fn bearing_value(
        &self,
        kind: Watched,
        place: usize,
        (contact, mode): (usize, Mode),
        state: &State,
        solution: &Solution,
    ) -> f64 {
        let (normal, tangential) = (solution.normal[place], solution.tangential[place]);
        match kind {
            Watched::Sticking => self.world.surface(contact).friction * normal - tangential.abs(),
            Watched::Sliding => {
                let touch = self.world.touch(contact, state.t, &state.q);
                touch.sliding(&state.v) * mode.direction()
            }
            _ => normal,
        }
    }
}
