//! That nothing within tolerances is beyond an extreme: a proof by enclosures.
//!
//! The proof divides the box of tolerances. Within a part of it the value is bounded by contacts: one that comes about in every drawing limits the
//! time from above, and the first of all that may come about from below. Where the derivatives of a contact's time keep their signs, its
//! extreme is at a corner; where one does not, it is off the middle by at most that derivative times half the width.

use cspace::{DrawnContact, Enclosure, Encounter, Encounters, Real};

use super::drawing::{Drawing, Enclosed, Form, Slope};
use super::extremes::{ONE, Summit};
use super::study::Study;
use super::vary::{halves, middle_and_half};

/// Parts of a box are not divided further where they are smaller than this, relative to it.
const SMALLEST: f64 = 1e-6;

/// The most that a value can be in a box, and how far its derivatives vary there.
struct Bound {
    most: f64,
    spread: Vec<f64>,
}

impl Study<'_> {
    /// Whether it is proved that nothing within the tolerances is beyond an extreme; otherwise how much farther it might be, where that is known.
    pub(super) fn prove(&self, summit: &Summit, sign: f64, factor: f64) -> (bool, Option<f64>) {
        if !self.is_drawn() {
            return (false, None);
        }
        let best = sign * summit.value;
        let enough = best + ONE * best.abs();
        let mut boxes = vec![self.variations.scaled(factor)];
        let (mut seen, most) = (0, self.most_boxes());
        let mut open: Option<f64> = Some(best);
        while let Some(next) = boxes.pop() {
            seen += 1;
            let bound = self.bound(&next, sign);
            if bound.as_ref().is_some_and(|b| b.most <= enough) {
                continue;
            }
            match self.widest(&next, bound.as_ref()) {
                Some(k) if seen < most && self.goes_on() => boxes.extend(halves(&next, k)),
                _ => open = open.zip(bound).map(|(open, b)| open.max(b.most)),
            }
        }
        match open {
            Some(most) if most <= best => (true, None),
            open => (false, open.map(|most| most - best)),
        }
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

    /// The most that sign times the requirement can be in a box; `None` where nothing bounds it.
    fn bound(&self, ranges: &[[f64; 2]], sign: f64) -> Option<Bound> {
        let (middle, half) = middle_and_half(ranges);
        let drawings = self.by_parameters(&middle, Some(&half))?;
        let plain: Drawing<Enclosed> = drawings.first()?.map(|x| x.value);
        // Whether a later contact makes sign times the value larger.
        let later = sign
            * match plain.form {
                Form::Play(_) => 1.0,
                Form::Position(of) => f64::from(plain.legs[0].rates[of.index()].ball().sign()),
                Form::Angle(_) => 0.0,
            };
        let encounters = plain.encounters(&self.until);
        let begin = encounters.iter().flat_map(|e| &e.list).any(|e| e.lo <= 0.0);
        if !begin && self.overlaps(&middle) {
            // They do in all of the box, and there is no value.
            let (most, spread) = (f64::NEG_INFINITY, half);
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
        let bounds = bounds.map(|chosen| self.bound_of(&drawings, chosen, (&middle, &half), sign));
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
