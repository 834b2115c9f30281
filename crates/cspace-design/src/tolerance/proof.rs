//! Proof by enclosures that nothing within tolerances is beyond an extreme.
//!
//! The proof divides the box of tolerances. Within a part of it the value is bounded by contacts: one that comes about in every drawing limits the
//! time from above, and the first of all that may come about from below. Where the derivatives of a contact's time keep their signs, its
//! extreme is at a corner; where one does not, it is off the middle by at most that derivative times half the width.

use std::rc::Rc;

use crate::drawn::{DrawnContact, Enclosure, Encounter, Encounters};
use cspace::Real;

use super::extremes::{ONE, Summit};
use super::study::Study;
use super::vary::{halves, middle_and_half};
use crate::drawing::{Contacts, Drawing, Enclosed, Form, Slope};

/// Parts of a box are not divided further where they are smaller than this, relative to it.
const SMALLEST: f64 = 1e-6;

/// The most that a value can be in a box, and how far its derivatives vary there.
struct Bound {
    most: f64,
    spread: Vec<f64>,
}

/// A part of the tolerances that is still to be looked at.
struct Open {
    /// The most that the value can be there, as far as is known: that of the box it is half of.
    most: f64,
    ranges: Vec<[f64; 2]>,
    /// Contacts that may come first there.
    known: Option<Rc<Contacts>>,
}

impl Study<'_> {
    /// Whether it is proved that nothing within the tolerances is beyond an extreme; otherwise how much farther it might be, where that is known.
    pub(super) fn prove(&self, summit: &Summit, sign: f64, factor: f64) -> (bool, Option<f64>) {
        if !self.is_drawn() {
            return (false, None);
        }
        let best = sign * summit.value;
        let enough = best + ONE * best.abs();
        let mut boxes = vec![Open {
            most: f64::INFINITY,
            ranges: self.variations.scaled(factor),
            known: None,
        }];
        let mut left = self.most_boxes();
        // What is bounded least first, so that little remains when there is no time left.
        while let Some(worst) = worst(&boxes) {
            let Open {
                most,
                ranges,
                known,
            } = boxes.swap_remove(worst);
            let (bound, known) = self.bound(&ranges, sign, known);
            let most = bound.as_ref().map_or(most, |b| b.most.min(most));
            if most <= enough {
                continue;
            }
            match self.widest(&ranges, bound.as_ref()) {
                Some(k) if left > 0 && self.goes_on() => {
                    left -= 1;
                    boxes.extend(halves(&ranges, k).map(|ranges| Open {
                        most,
                        ranges,
                        known: known.clone(),
                    }));
                }
                _ => {
                    let rest = boxes.iter().map(|b| b.most).fold(most, f64::max);
                    let gap = rest - best;
                    return (false, gap.is_finite().then_some(gap));
                }
            }
        }
        (true, None)
    }

    /// The parameter to divide a box by: the one of which the derivative varies most in it.
    fn widest(&self, ranges: &[[f64; 2]], bound: Option<&Bound>) -> Option<usize> {
        let (_, half) = middle_and_half(ranges);
        let whole = &self.variations.list;
        let share = |k: usize| half[k] / whole[k].half();
        let weight = |k: usize| match bound {
            Some(bound) => half[k] * bound.spread[k],
            None => share(k),
        };
        (0..half.len())
            .filter(|&k| half[k] > 0.0 && share(k) > SMALLEST && weight(k) > 0.0)
            .max_by(|&a, &b| weight(a).total_cmp(&weight(b)).then(b.cmp(&a)))
    }

    /// The most that sign times the requirement can be in a box, where something bounds it; and the contacts that may come first there, of those
    /// of a box around it.
    fn bound(
        &self,
        ranges: &[[f64; 2]],
        sign: f64,
        known: Option<Rc<Contacts>>,
    ) -> (Option<Bound>, Option<Rc<Contacts>>) {
        let (middle, half) = middle_and_half(ranges);
        let Some(drawings) = self.by_parameters(&middle, Some(&half)) else {
            return (None, known);
        };
        let Some(plain) = drawings.first().map(|d| d.map(|x| x.value)) else {
            return (None, known);
        };
        let encounters = plain.encounters(&self.until, known.as_deref());
        let bound = self.bound_by(&drawings, &plain, &encounters, (&middle, &half), sign);
        let known = if encounters.iter().all(|e| e.complete) {
            Some(Rc::new(encounters.into_iter().map(|e| e.list).collect()))
        } else {
            known
        };
        (bound, known)
    }

    /// The most that sign times the requirement can be in a box with these encounters.
    fn bound_by(
        &self,
        drawings: &[Drawing<Slope>],
        plain: &Drawing<Enclosed>,
        encounters: &[Encounters],
        (middle, half): (&[f64], &[f64]),
        sign: f64,
    ) -> Option<Bound> {
        // Whether a later contact makes sign times the value larger.
        let later = sign
            * match plain.form {
                Form::Play(_) => 1.0,
                Form::Position(of) => f64::from(plain.legs[0].rates[of.index()].ball().sign()),
                Form::Angle(_) => 0.0,
            };
        let begin = encounters.iter().flat_map(|e| &e.list).any(|e| e.lo <= 0.0);
        if !begin && self.overlaps(middle) {
            // They do in all of the box, and there is no value.
            let (most, spread) = (f64::NEG_INFINITY, half.to_vec());
            return Some(Bound { most, spread });
        }
        let mut combinations = vec![Vec::new()];
        for (found, limit) in encounters.iter().zip(&plain.limits) {
            let deciding = deciding(found, limit.map(|l| l.ball().ends()[0]), later)?;
            combinations = (combinations.iter())
                .flat_map(|chosen: &Vec<Encounter>| {
                    deciding
                        .iter()
                        .map(|next| chosen.iter().chain([next]).copied().collect())
                })
                .collect();
        }
        let bounds = combinations.iter();
        let bounds = bounds.map(|chosen| self.bound_of(drawings, chosen, (middle, half), sign));
        let bounds: Option<Vec<Bound>> = bounds.collect();
        let order = |a: &Bound, b: &Bound| a.most.total_cmp(&b.most);
        if later > 0.0 {
            bounds?.into_iter().min_by(order)
        } else {
            bounds?.into_iter().max_by(order)
        }
    }

    /// The most that sign times the value can be in a box where these contacts decide it.
    fn bound_of(
        &self,
        drawings: &[Drawing<Slope>],
        chosen: &[Encounter],
        (middle, half): (&[f64], &[f64]),
        sign: f64,
    ) -> Option<Bound> {
        let contacts: Vec<DrawnContact> = chosen.iter().map(|e| e.contact).collect();
        let mut at = middle.to_vec();
        let (mut beyond, mut spread) = (0.0, vec![0.0; half.len()]);
        for (k, drawing) in drawings.iter().enumerate() {
            let times: Vec<Slope> = (0..)
                .zip(chosen)
                .map(|(leg, e)| {
                    if e.approaching {
                        drawing.time(leg, e.contact, Enclosed::from_to(e.lo, e.hi))
                    } else {
                        // It comes about at the earliest then, wherever in the box that is.
                        Slope::constant(e.lo)
                    }
                })
                .collect();
            let slope = drawing.value(&contacts, &times).slope[0].ball();
            match slope.sign() {
                0 => beyond += (slope.mid.abs() + slope.radius) * half[k],
                s => at[k] += f64::from(s) * sign * half[k],
            }
            spread[k] = slope.radius;
        }
        let model = self.model(&at).ok()?;
        let drawing = Drawing::<f64>::new(&model, self.requirement_of(&model), None)?;
        let times: Vec<f64> = (0..)
            .zip(chosen)
            .map(|(leg, e)| {
                if e.approaching {
                    drawing.root_or_end(leg, e)
                } else {
                    e.lo
                }
            })
            .collect();
        let most = sign * drawing.value(&contacts, &times) + beyond;
        most.is_finite().then_some(Bound { most, spread })
    }
}

/// The box of which the bound is largest.
fn worst(boxes: &[Open]) -> Option<usize> {
    let all = boxes.iter().enumerate();
    all.max_by(|a, b| a.1.most.total_cmp(&b.1.most))
        .map(|(i, _)| i)
}

/// The contacts that bound when a motion ends: from above those that are certain, from below all that may come about; of what does not follow the
/// time, the only one there may be. `None` where nothing does.
fn deciding(found: &Encounters, leaves: Option<f64>, later: f64) -> Option<Vec<Encounter>> {
    let list = &found.list;
    let certain = list.iter().filter(|e| e.certain);
    let end = certain.clone().map(|e| e.hi).min_by(f64::total_cmp)?;
    if !found.complete || leaves.is_some_and(|l| l <= end) {
        return None;
    }
    if later > 0.0 {
        return Some(certain.copied().collect());
    }
    let is_clear = list.iter().all(|e| e.lo > 0.0);
    let is_only = later < 0.0 || (list.len() == 1 && list[0].approaching);
    (is_clear && is_only).then(|| list.clone())
}
