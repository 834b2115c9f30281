//! One drag.
//!
//! The part is led to its target and pushes other parts: this is exact, and goes as far as contacts and joints allow. A
//! part that moves in the plane then slides along obstacles: a spring pulls it towards a series of places on the path
//! to its target, to where the spring is in balance with contacts and with all forces. From there it is led again,
//! until it reaches the target or is stopped.

use core::cell::Cell;

use cspace::{PairSpace, Point};

use crate::contact::overlap;
use crate::error::SimulateError;
use crate::kinematic::run;
use crate::pairs::MovingPair;
use crate::record::{EventKind, Record, Status, What};
use crate::system::System;

use super::Hand;
use super::answer::{Dragged, Ending, Stopper};
use super::target::{Target, Way};

/// Largest displacement by a spring at a time, relative to the size of the mechanism; also the displacement of
/// overlapping parts before the overlap is checked again.
const PIECE: f64 = 0.05;
/// Largest number of steps of one call, each change of contact counted as one, if all parts have axes: some
/// milliseconds, and more where many contacts have to be chosen from. With pairs that are free in the plane it is
/// divided by their number.
const MOST_STEPS: usize = 200;
/// A contact keeps a part that is pulled if it carries more than this share of the pull.
const CARRIES: f64 = 1e-6;
/// Change of coordinates, relative to the size of the mechanism, that counts as rounding.
const STANDS: f64 = 1e-14;

/// Result of bringing a part to a place.
enum Brought {
    /// The part has reached the place.
    There,
    /// The part was led up to this share of the path.
    Jammed(f64),
    /// The drag ended otherwise.
    Ended(Ending),
}

/// State of a drag.
struct Drag<'a> {
    hand: &'a mut Hand,
    part: usize,
    spent: Cell<usize>,
    answer: Dragged,
    /// Stoppers that carried the pull at its last balance.
    carrying: Vec<Stopper>,
}

impl Hand {
    /// Drags a part: it moves towards a target as far as contacts, joints and ends of ranges allow, and pushes parts in
    /// its way. A part that moves in the plane slides along obstacles.
    ///
    /// # Errors
    /// If there is no such part, it is fixed, or the target is of another class than the part or not finite. Then
    /// nothing moves.
    pub fn drag(&mut self, part: usize, target: Target) -> Result<Dragged, SimulateError> {
        let way = Way::new(&self.system, part, target, &self.state)?;
        let began = self.state.clone();
        let mut drag = Drag {
            answer: Dragged {
                ending: Ending::Reached,
                stopped_by: Vec::new(),
                overlapping: Vec::new(),
                snaps: Vec::new(),
                way: vec![began],
            },
            hand: self,
            carrying: Vec::new(),
            part,
            spent: Cell::new(0),
        };
        drag.answer.ending = drag.go(&way)?;
        let Dragged { ending, way, .. } = &mut drag.answer;
        if let (Ending::Reached, Target::Planar(c)) = (&*ending, target) {
            // The position of the centroid determines it but for rounding.
            let at = drag.hand.system.parts()[part].indices();
            drag.hand.state[at].copy_from_slice(&[c.x, c.y, c.theta]);
        }
        way.push(drag.hand.state.clone());
        let mut answer = drag.answer;
        answer.overlapping = self.overlapping();
        Ok(answer)
    }
}

impl Drag<'_> {
    fn go(&mut self, way: &Way) -> Result<Ending, SimulateError> {
        let system = &self.hand.system;
        let piece = PIECE * system.size() / way.length(system);
        let mut share = 0.0;
        loop {
            let to = match self.hand.pairs.left_out().is_empty() {
                true => 1.0,
                false => (share + piece).min(1.0),
            };
            match self.led(&way.at(to))? {
                Brought::There if to == 1.0 => return Ok(Ending::Reached),
                Brought::There => {
                    share = to;
                    continue;
                }
                Brought::Jammed(led) => share += led * (to - share),
                Brought::Ended(ending) => return Ok(ending),
            }
            let stopped = match self.answer.stopped_by.is_empty() {
                true => Ending::Held,
                false => Ending::Stopped,
            };
            if share >= 1.0 || matches!(way, Way::Axis { .. }) {
                if stopped == Ending::Held {
                    self.answer.stopped_by.append(&mut self.carrying);
                }
                return Ok(stopped);
            }
            share = (share + piece).min(1.0);
            if let Brought::Ended(ending) = self.pulled(&way.at(share))? {
                return Ok(ending);
            }
        }
    }

    /// Leads the part from its configuration to the end of a path.
    fn led(&mut self, way: &Way) -> Result<Brought, SimulateError> {
        let q = &self.hand.state;
        let ways = match *way {
            Way::Axis { index, ends } => vec![(index, [q[index], ends[1]])],
            Way::Planar {
                first,
                point,
                ends: [_, to],
                turn,
            } => {
                let here = self.hand.system.placement(self.part, q);
                let [x, y] = here.point([point.x, point.y]);
                let angle = turn.map(|[_, to]| (first + 2, [q[first + 2], to]));
                let place = [(first, [x, to.x]), (first + 1, [y, to.y])];
                place.into_iter().chain(angle).collect()
            }
        };
        if ways.iter().all(|(_, [from, to])| from == to) {
            return Ok(Brought::There);
        }
        let point = match *way {
            Way::Axis { .. } => Point::ORIGIN,
            Way::Planar { point, .. } => point,
        };
        let system = self.hand.system.led(self.part, point, &ways);
        let mut record = self.follow(&system)?;
        let part = |what: What| match what {
            What::Part { part } => part,
            other => other.to_string(),
        };
        let snaps = record.events.iter().filter(|e| e.kind == EventKind::Snap);
        let snaps = snaps.map(|e| part(e.what.clone()));
        self.answer.snaps.extend(snaps);
        let jams = record.events.iter().filter(|e| e.kind == EventKind::Jam);
        let stops = jams.map(|e| Stopper {
            what: e.what.clone(),
            at: e.at,
        });
        self.answer.stopped_by = stops.collect();
        Ok(match record.status {
            Status::Done => Brought::There,
            Status::Jammed => Brought::Jammed(record.until),
            Status::Interrupted => Brought::Ended(Ending::Unfinished),
            _ => Brought::Ended(Ending::Lost(record.reason.take().unwrap_or_default())),
        })
    }
    /// Pulls the part to the end of a path by springs, until they balance.
    fn pulled(&mut self, way: &Way) -> Result<Brought, SimulateError> {
        let Way::Planar {
            point,
            ends: [_, to],
            turn,
            ..
        } = *way
        else {
            return Ok(Brought::There);
        };
        let hand = &self.hand;
        let angle = turn.map(|[_, to]| to);
        let system = (hand.system).pulled(self.part, [point, to], angle);
        let record = self.follow(&system)?;
        let here = self.hand.system.placement(self.part, &self.hand.state);
        let [x, y] = here.point([point.x, point.y]);
        let least = CARRIES * to.distance(Point::new(x, y));
        let forces = record.samples.last().and_then(|s| s.forces.as_ref());
        let carry = forces.iter().flat_map(|f| &f.contacts);
        let carry = carry.filter(|contact| contact.normal > least);
        self.carrying = carry
            .map(|contact| Stopper {
                what: contact.what.clone(),
                at: contact.at,
            })
            .collect();
        Ok(match record.status {
            Status::Done => Brought::There,
            Status::Interrupted => Brought::Ended(Ending::Unfinished),
            _ => Brought::Ended(Ending::Lost(record.reason.unwrap_or_default())),
        })
    }

    /// Follows the motion of a system for a second, from where parts are.
    fn follow(&mut self, system: &System) -> Result<Record, SimulateError> {
        let hand = &mut *self.hand;
        let mut still = vec![0.0; hand.state.len()];
        let mut begin = hand.state.clone();
        system.shift(&mut begin, &mut still, false);
        let planar = |pair: &&MovingPair| matches!(pair.space, PairSpace::Planar(_));
        let cost = 1 + hand.pairs.list().iter().filter(planar).count();
        let goes_on = |_| {
            self.spent.set(self.spent.get() + cost);
            self.spent.get() <= MOST_STEPS
        };
        let mut record = run(
            system,
            &hand.pairs,
            begin,
            [0.0, 1.0],
            f64::INFINITY,
            &goes_on,
        );
        let mut home = |q: &mut [f64]| system.shift(q, &mut still, true);
        let Some(last) = record.samples.last_mut() else {
            return Ok(record);
        };
        let mut q = last.coordinates.clone();
        if record.status == Status::Done {
            system.drive(1.0, &mut q);
        }
        home(&mut q);
        let rounding = STANDS * system.size();
        for part in system.parts() {
            let at = part.indices();
            let moved = at
                .clone()
                .map(|i| (q[i] - hand.state[i]).abs() * system.lengths()[i]);
            if moved.fold(0.0, f64::max) <= rounding {
                q[at.clone()].copy_from_slice(&hand.state[at]);
            }
        }
        // The result of the motion is checked again: no part may be forced into another.
        for pair in hand.pairs.list() {
            let reason = match overlap(pair, &hand.system, &q) {
                Ok(None) => continue,
                Ok(Some(_)) => "parts would overlap".to_owned(),
                Err(error) => error.to_string(),
            };
            record.status = Status::Undetermined;
            record.reason = Some(reason);
            return Ok(record);
        }
        let way = core::mem::take(&mut record.trace).into_iter();
        let way = way.map(|at| at.coordinates);
        self.answer.way.extend(way.map(|mut q| {
            home(&mut q);
            q
        }));
        hand.state = q;
        if !hand.pairs.left_out().is_empty() {
            // Where nothing is known they may still overlap.
            let still =
                |p: &&MovingPair| !matches!(overlap(p, &hand.system, &hand.state), Ok(None));
            let still = hand.pairs.left_out().iter().filter(still);
            let still: Vec<_> = still.map(|pair| (pair.fixed, pair.moving)).collect();
            (hand.pairs).leave_out(|pair| still.contains(&(pair.fixed, pair.moving)));
        }
        Ok(record)
    }
}
