//! Ends of a motion, as entered in the recording.

use crate::contact::{Bound, named};
use crate::record::{Event, EventKind, Obstacle, Record, Sample, Status};

use super::run::{Run, State, Stop, moment};

impl Run<'_> {
    /// The record of a simulation that does not go on.
    pub(super) fn stopped(mut self, state: State, stop: Stop) -> Record {
        let State { time, q, .. } = state;
        match stop {
            Stop::Over => self.record.until = self.duration,
            Stop::Jammed(obstacles) => self.jammed(time, &q, obstacles),
            Stop::Undetermined(bounds) => self.undetermined(time, &q, &bounds),
        }
        self.record
    }

    /// Recording of a simulation that the user has interrupted.
    pub(super) fn stopped_short(mut self, state: State) -> Record {
        let (time, q) = self.interrupted.take().unwrap_or((state.time, state.q));
        let still = vec![0.0; q.len()];
        self.record.trace.push(moment(time, &q, still));
        self.end(time, &q, Status::Interrupted, None);
        self.record
    }

    pub(super) fn end(&mut self, time: f64, q: &[f64], status: Status, reason: Option<String>) {
        self.record.until = time;
        self.record.status = status;
        self.record.reason = reason;
        self.record.samples.retain(|s| s.t < time);
        // They are those before.
        let forces = (self.record.samples.last()).and_then(|s| s.forces.clone());
        self.record.samples.push(Sample {
            t: time,
            coordinates: q.to_vec(),
            rates: vec![0.0; q.len()],
            forces,
        });
    }

    fn jammed(&mut self, time: f64, q: &[f64], obstacles: Vec<(Bound, f64)>) {
        let list: Vec<String> = obstacles.iter().map(|(b, _)| self.text(b)).collect();
        let reason = if list.is_empty() {
            match time > 0.0 {
                // What has gone on so far comes to where the joints let it go no farther.
                true => self.system.dead_point(q, true),
                false => "the drives contradict the joints".to_owned(),
            }
        } else {
            format!("what is driven cannot go on: {}", list.join("; "))
        };
        self.record.obstacles = (obstacles.iter())
            .map(|(bound, multiplier)| Obstacle {
                what: named(self.system, self.pairs, bound),
                multiplier: *multiplier,
            })
            .collect();
        for (bound, _) in &obstacles {
            let at = bound.place(self.system, self.pairs, q);
            let at = at.filter(|p| p.is_finite()).map(|p| [p.x, p.y]);
            self.record.events.push(Event::new(
                time,
                EventKind::Jam,
                named(self.system, self.pairs, bound),
                at,
            ));
        }
        self.end(time, q, Status::Jammed, Some(reason));
    }

    fn undetermined(&mut self, time: f64, q: &[f64], bounds: &[Bound]) {
        let list: Vec<String> = bounds.iter().map(|b| self.text(b)).collect();
        let reason = if let Some(why) = self.gave_up {
            why.to_owned()
        } else if list.is_empty() {
            "a pair left the orientations of its space, or the metric is singular".to_owned()
        } else {
            format!(
                "it is not found which of these contacts hold as it goes on; give the parts a `density`, and their masses decide: {}",
                list.join("; ")
            )
        };
        self.end(time, q, Status::Undetermined, Some(reason));
    }

    fn text(&self, bound: &Bound) -> String {
        named(self.system, self.pairs, bound).to_string()
    }
}
