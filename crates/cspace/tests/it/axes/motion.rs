//! First contacts of pairs on fixed axes, compared with steps of the brute-force oracle along the motion.
//!
//! Up to the contact no step may overlap, the contact must be one of the named patch, and just beyond it, where the motion enters at an
//! angle, the parts must overlap. A verdict of the oracle counts if its margin exceeds the resolution.

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::fixed_axes::{AxisMotion, FixedAxesSpace};
use cspace::{Axis, Classification, PatchId};
use cspace_oracle::Oracle;
use cspace_oracle::shapes::mechanisms::{Mechanism, mechanisms};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Minimum margin of an oracle's verdict for it to count, as a share of the size.
const CERTAIN: f64 = 1e-9;
/// Number of motions of each mechanism, each followed by one from the contact it found.
const MOTIONS: usize = 150;
/// Number of steps of each motion.
const STEPS: u32 = 120;

/// Counts of outcomes.
#[derive(Default, Debug)]
struct Tally {
    contacts: usize,
    entered: usize,
    steps: usize,
    free: usize,
    leaves: usize,
    from_contact: usize,
    wrong: Vec<String>,
}

struct Trial<'a> {
    mechanism: &'a Mechanism,
    space: FixedAxesSpace,
    oracle: Oracle,
    tally: Tally,
}

impl Trial<'_> {
    /// Whether the parts overlap, if the oracle is certain.
    fn overlaps(&self, (u, v): (f64, f64)) -> Option<bool> {
        let verdict = self.oracle.judge(self.space.configuration(u, v));
        let known = CERTAIN * self.oracle.size();
        (verdict.margin > known).then_some(verdict.overlap)
    }

    /// Follows a motion; returns the contact, if there is one.
    fn follow(&mut self, from: (f64, f64), rates: (f64, f64), duration: f64) -> Option<(f64, f64)> {
        let answer = self.space.first_contact(from, rates, duration).unwrap();
        let at = |t: f64| (from.0 + rates.0 * t, from.1 + rates.1 * t);
        let until = match answer {
            AxesMotionOutcome::Free => duration,
            AxesMotionOutcome::Leaves { time } => time,
            AxesMotionOutcome::Contact(c) => c.time,
        };
        let mut wrong = |what: String| {
            self.tally.wrong.push(format!(
                "{}: from {from:?} at {rates:?} for {duration}: {answer:?}: {what}",
                self.mechanism.name
            ));
        };
        if !(0.0..=duration).contains(&until) {
            wrong("the time is not in the motion".into());
        }
        let deep: Option<f64> = (1..STEPS)
            .map(|k| until * f64::from(k) / f64::from(STEPS))
            .find(|&t| {
                let verdict = self
                    .oracle
                    .judge(self.space.configuration(at(t).0, at(t).1));
                verdict.overlap && verdict.margin > CERTAIN * self.oracle.size()
            });
        if let Some(t) = deep {
            wrong(format!("overlap already at {t}"));
        }
        let blocked = (1..STEPS)
            .map(|k| until * f64::from(k) / f64::from(STEPS))
            .find(|&t| {
                self.space.classify(at(t).0, at(t).1) == Some(Classification::Blocked)
                    && self.overlaps(at(t)) != Some(false)
                    && until - t > 1e-9
            });
        // A motion along a boundary may dip into it by rounding; deeper overlaps are detected by the oracle above.
        if let (Some(t), None) = (blocked, deep)
            && self
                .space
                .contacts(at(t).0, at(t).1, 1e-8 * self.oracle.size())
                .is_empty()
        {
            self.tally
                .wrong
                .push(format!("{}: blocked at {t}", self.mechanism.name));
        }
        self.tally.steps += STEPS as usize;
        match answer {
            AxesMotionOutcome::Free => self.tally.free += 1,
            AxesMotionOutcome::Leaves { .. } => self.tally.leaves += 1,
            AxesMotionOutcome::Contact(c) => {
                self.tally.contacts += 1;
                self.touches(at(c.time), rates, c.patch, c.at);
                return Some(at(c.time));
            }
        }
        None
    }

    /// Checks that the contact is one of the patch, and that just beyond it the parts overlap where the motion enters at an angle.
    fn touches(&mut self, at: (f64, f64), rates: (f64, f64), patch: PatchId, given: (f64, f64)) {
        let size = self.oracle.size();
        let mut wrong = Vec::new();
        if given != at {
            wrong.push(format!("{given:?} is not {at:?}"));
        }
        let contacts = self.space.contacts(at.0, at.1, 1e-9 * size);
        if !contacts.iter().any(|c| c.0 == patch) {
            wrong.push(format!(
                "{at:?} is not on patch {patch}, but on {contacts:?}"
            ));
        }
        let (by_u, by_v) = self.space.contact_gradient(patch, at.0, at.1).unwrap();
        let slope = by_u * rates.0 + by_v * rates.1;
        let speed = (by_u * rates.0).abs() + (by_v * rates.1).abs();
        if slope > 1e-9 * speed {
            wrong.push(format!("the parts part at {at:?}: {slope}"));
        }
        // Deeper by some 1e-6 of the size: these parts have no smaller details.
        if slope < -1e-2 * speed && speed > 0.0 {
            let t = 1e-6 * size / -slope;
            let beyond = (at.0 + rates.0 * t, at.1 + rates.1 * t);
            if self.space.classify(beyond.0, beyond.1).is_some() {
                match self.overlaps(beyond) {
                    Some(true) => self.tally.entered += 1,
                    verdict => wrong.push(format!("no overlap beyond {at:?}: {verdict:?}")),
                }
            }
        }
        for w in wrong {
            self.tally
                .wrong
                .push(format!("{}: {w}", self.mechanism.name));
        }
    }
}

fn try_mechanism(m: &Mechanism) -> Tally {
    let mut trial = Trial {
        mechanism: m,
        space: FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap(),
        oracle: Oracle::new(&m.fixed, &m.moving),
        tally: Tally::default(),
    };
    let size = trial.oracle.size();
    let mut rng = ChaCha8Rng::seed_from_u64(41);
    for k in 0..20 * MOTIONS {
        if trial.tally.contacts + trial.tally.free + trial.tally.leaves >= 2 * MOTIONS {
            break;
        }
        let (from, to) = (m.somewhere(size, &mut rng), m.somewhere(size, &mut rng));
        if trial.space.classify(from.0, from.1) != Some(Classification::Free) {
            continue;
        }
        let duration = 10f64.powf(rng.random_range(-1.0..1.0));
        let share = 10f64.powf(rng.random_range(-1.5..1.0)) / duration;
        let mut rates = (share * (to.0 - from.0), share * (to.1 - from.1));
        match k % 4 {
            0 => rates.0 = 0.0,
            1 => rates.1 = 0.0,
            _ => {}
        }
        let touched = trial.follow(from, rates, duration);
        if let Some(at) = touched
            && trial.space.classify(at.0, at.1) == Some(Classification::Contact)
        {
            // Continues from the contact in any direction.
            let other = m.somewhere(size, &mut rng);
            let rates = (share * (other.0 - at.0), share * (other.1 - at.1));
            trial.tally.from_contact += 1;
            trial.follow(at, rates, duration);
        }
    }
    trial.tally
}

#[test]
fn first_contacts_agree_with_brute_force() {
    let all = mechanisms();
    let tried: Vec<Tally> = all.par_iter().map(try_mechanism).collect();
    let mut sum = Tally::default();
    for (m, t) in all.iter().zip(tried) {
        println!(
            "{:34} {} contacts ({} entered), {} free, {} leave, {} from contact, {} wrong",
            m.name,
            t.contacts,
            t.entered,
            t.free,
            t.leaves,
            t.from_contact,
            t.wrong.len()
        );
        sum.contacts += t.contacts;
        sum.entered += t.entered;
        sum.steps += t.steps;
        sum.free += t.free;
        sum.leaves += t.leaves;
        sum.from_contact += t.from_contact;
        sum.wrong.extend(t.wrong.into_iter().take(4));
    }
    for w in &sum.wrong {
        println!("{w}");
    }
    assert!(sum.wrong.is_empty(), "{} wrong", sum.wrong.len());
    assert!(sum.contacts > 1500 && 2 * sum.entered > sum.contacts);
    assert!(sum.free > 200 && sum.leaves > 50 && sum.from_contact > 500);
}

/// Every point of a gap is free, and every free configuration is in a gap.
#[test]
fn gaps_are_free() {
    let mut rng = ChaCha8Rng::seed_from_u64(43);
    for m in mechanisms() {
        let space =
            FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap();
        let gaps: Vec<_> = space.free_gaps().collect();
        assert_eq!(gaps.is_empty(), space.regions().is_empty(), "{}", m.name);
        if gaps.is_empty() {
            continue;
        }
        let mut asked = 0;
        for _ in 0..400 {
            let gap = &gaps[rng.random_range(0..gaps.len())];
            let [a, b] = gap.ends(rng.random_range(0.01..0.99));
            let (du, dv) = (b.0 - a.0, b.1 - a.1);
            assert!(du == 0.0 || dv == 0.0, "{}: {a:?} {b:?}", m.name);
            if du.hypot(dv) < 1e-6 {
                continue;
            }
            let s = rng.random_range(0.01..0.99);
            let (u, v) = (a.0 + s * du, a.1 + s * dv);
            // The strip drawn for a part that does not move represents its coordinate 0.
            let stays = |axis: &Axis| axis.motion == AxisMotion::Fixed;
            let u = if stays(&m.fixed_axis) { 0.0 } else { u };
            let v = if stays(&m.moving_axis) { 0.0 } else { v };
            asked += 1;
            let class = space.classify(u, v);
            assert_ne!(class, Some(Classification::Blocked), "{} {u} {v}", m.name);
            assert!(class.is_some(), "{}: ({u}, {v}) is outside", m.name);
        }
        assert!(asked > 0, "{}", m.name);
    }
}

/// Motions that turn farther than an angle is known give a result if the parts touch before, otherwise an error.
#[test]
fn motions_that_turn_too_far_end() {
    let disc = |x: f64, r: f64| cspace::Part::circle("disc", (x, 0.0), r).unwrap();
    let turning = Axis::revolute(cspace::Point::new(0.0, 0.0));
    let too_far = Err(cspace::MotionError::TurnsTooFar);
    for (stop, touches) in [(disc(12.0, 0.5), false), (disc(-12.0, 1.5), true)] {
        let space = FixedAxesSpace::compute(&stop, Axis::FIXED, &disc(10.0, 1.0), turning).unwrap();
        for (v, rate, duration) in [(0.0, 1e8, 1.0), (0.0, -1.0, 1e150), (0.0, 1e12, 1e100)] {
            let found = space.first_contact((0.0, v), (0.0, rate), duration);
            if touches {
                assert!(
                    matches!(found, Ok(AxesMotionOutcome::Contact(c)) if c.at.1.abs() < 3.2),
                    "{found:?}"
                );
            } else {
                assert_eq!(found, too_far, "{rate}");
            }
            let all = space.crossings((0.0, v), (0.0, rate), duration);
            assert_eq!(all, Err(cspace::MotionError::TurnsTooFar), "{rate}");
        }
        for v in [1e17, -1.1e6] {
            assert_eq!(space.first_contact((0.0, v), (0.0, 1.0), 1.0), too_far);
        }
    }
}

/// The way back begins where the range ends: in at 3, out at 7.
#[test]
fn crossings_of_a_motion_that_leaves_its_range() {
    let part = |x: f64| cspace::Part::rectangle("p", (x, 0.0), 2.0, 2.0).unwrap();
    let slide = Axis::prismatic(cspace::Vector::new(-1.0, 0.0)).within(0.0, 8.0);
    let space = FixedAxesSpace::compute(&part(0.0), Axis::FIXED, &part(5.0), slide).unwrap();
    let found = space.crossings((0.0, 0.0), (0.0, 1.0), 20.0).unwrap();
    let last = found[found.len() - 1];
    assert!((found[0].0 - 3.0).abs() < 1e-9 && found[0].2, "{found:?}");
    assert!((last.0 - 7.0).abs() < 1e-9 && !last.2, "{found:?}");
}
