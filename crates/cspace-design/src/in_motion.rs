//! Measures of the motion of the whole mechanism.

use cspace::{ComputeError, Progress};
use cspace_model::model::{Happening, MotionQuantity};
use cspace_model::{Compute, Mechanism};
use cspace_motion::{
    Event, EventKind, Record, Report, Settings, Simulation, Status, Trajectory, What,
};

use crate::value::Unmeasured;

/// A motion that has been followed.
pub(crate) struct Motion {
    simulation: Simulation,
    record: Record,
    report: Report,
}

/// Measured quantity.
pub(crate) struct Found {
    pub(crate) value: f64,
    /// The two parts of an event.
    pub(crate) parts: Option<[usize; 2]>,
    /// Their features, as messages call them.
    pub(crate) features: Vec<[String; 2]>,
    /// The largest gap by which parts that fit exactly at the start are smaller.
    pub(crate) gap: Option<f64>,
}

impl Found {
    const fn value(value: f64) -> Self {
        Self {
            value,
            parts: None,
            features: Vec::new(),
            gap: None,
        }
    }
}

impl Motion {
    /// The motion of a mechanism over a time in seconds: with inertia if a part has a mass.
    ///
    /// # Errors
    /// Why it cannot be followed; the outer error is that `progress` ends it.
    pub(crate) fn follow(
        mechanism: &Mechanism,
        time: f64,
        compute: &Compute<'_>,
        progress: &dyn Progress,
    ) -> Result<Result<Self, Unmeasured>, ComputeError> {
        let settings = Settings { time, every: None };
        let found = Simulation::new_by(mechanism, compute).and_then(|simulation| {
            let record = simulation.follow_with(&settings, progress)?;
            Ok((simulation, record))
        });
        match found {
            Ok((simulation, record)) => {
                let report = Report::of(&simulation, &record);
                Ok(Ok(Self {
                    simulation,
                    record,
                    report,
                }))
            }
            Err(error) if error.is_interrupted() => Err(ComputeError::Interrupted),
            Err(error) => Ok(Err(Unmeasured::Space(error.to_string()))),
        }
    }

    /// Measures a quantity of the motion.
    ///
    /// # Errors
    /// If it has no value.
    pub(crate) fn measure(&self, quantity: MotionQuantity) -> Result<Found, Unmeasured> {
        let gaps = self.simulation.gaps().iter().map(|gap| gap.gap);
        let gap = gaps.reduce(f64::max);
        self.found(quantity).map(|found| Found { gap, ..found })
    }

    fn found(&self, quantity: MotionQuantity) -> Result<Found, Unmeasured> {
        match quantity {
            MotionQuantity::Event {
                happens,
                parts,
                number,
            } => self.event(happens, parts, number),
            MotionQuantity::Stroke { part, of } => {
                self.to_the_end()?;
                let coordinates = self.simulation.system().parts()[part].indices();
                // A part on an axis has one coordinate.
                let k = if coordinates.len() == 1 {
                    0
                } else {
                    of.index()
                };
                let value = match self.in_cycle(part) {
                    Some(cycle) => cycle.stroke(k),
                    None => {
                        let trajectory = Trajectory::of(&self.record);
                        let (from, to) = trajectory.span();
                        let (lo, hi) = trajectory.extent(coordinates.start + k, from, to);
                        hi - lo
                    }
                };
                Ok(Found::value(value))
            }
            MotionQuantity::Ratio { by, of } => {
                self.to_the_end()?;
                let [by, of] = [by, of].map(|part| self.advance(part));
                if by == 0.0 {
                    return Err(Unmeasured::NoAdvance);
                }
                Ok(Found::value(of / by))
            }
        }
    }

    /// Checks that the motion has come to the end of its time.
    fn to_the_end(&self) -> Result<(), Unmeasured> {
        match self.record.status {
            Status::Done => Ok(()),
            _ => Err(self.ends_early()),
        }
    }

    fn ends_early(&self) -> Unmeasured {
        let why = match self.record.status {
            Status::Done | Status::Undetermined | Status::Interrupted => {
                "how it goes on is not determined"
            }
            Status::Jammed => "the mechanism jams",
            Status::Inconsistent => "no forces satisfy the laws of contact and friction",
        };
        Unmeasured::EndsEarly {
            until: self.record.until,
            why,
            is_known: self.record.status == Status::Jammed,
        }
    }

    fn in_cycle(&self, part: usize) -> Option<&cspace_motion::PartCycle> {
        let cycle = self.report.cycle.as_ref()?;
        cycle.parts.iter().find(|p| p.part == part)
    }

    /// How far a part on an axis has gone on: in a cycle, or in all of the motion.
    fn advance(&self, part: usize) -> f64 {
        if let Some(cycle) = self.in_cycle(part) {
            return cycle.advance[0];
        }
        let i = self.simulation.system().parts()[part].indices().start;
        let trajectory = Trajectory::of(&self.record);
        let (from, to) = trajectory.span();
        trajectory.at(to, i) - trajectory.at(from, i)
    }

    fn event(
        &self,
        happens: Happening,
        parts: Option<[usize; 2]>,
        number: u32,
    ) -> Result<Found, Unmeasured> {
        let kind = match happens {
            Happening::Impact => EventKind::Impact,
            Happening::Touch => EventKind::Touch,
            Happening::Release => EventKind::Release,
            Happening::Stick => EventKind::Stick,
            Happening::Slip => EventKind::Slip,
            Happening::Rest => EventKind::Rest,
        };
        let is_meant = |event: &&Event| {
            let both = self.parts_of(event);
            let is_of = match (parts, both) {
                // A part that comes to the end of its range, or leaves it, does so alone.
                (None, both) => both.is_some() || kind == EventKind::Rest,
                (Some([a, b]), Some([c, d])) => [a, b] == [c, d] || [b, a] == [c, d],
                (Some(_), None) => false,
            };
            event.kind == kind && is_of
        };
        let mut all = self.record.events.iter().filter(is_meant);
        let Some(event) = all.nth(number as usize - 1) else {
            return Err(match self.record.status {
                Status::Done => Unmeasured::Never,
                _ => self.ends_early(),
            });
        };
        let mut found = Found {
            parts: self.parts_of(event),
            ..Found::value(event.t)
        };
        if let What::Contact { features, .. } = &event.what {
            found.features.push(features.clone());
        }
        // Named in the order in which the requirement names them.
        if parts.is_some() && found.parts != parts {
            found.parts = parts;
            for [a, b] in &mut found.features {
                core::mem::swap(a, b);
            }
        }
        Ok(found)
    }

    fn parts_of(&self, event: &Event) -> Option<[usize; 2]> {
        let What::Contact { fixed, moving, .. } = &event.what else {
            return None;
        };
        let parts = &self.simulation.system().mechanism().parts;
        let index = |name: &str| parts.iter().position(|p| p.part.name() == name);
        Some([index(fixed)?, index(moving)?])
    }
}
