//! Simulation of a mechanism: preparation and the three ways to compute its motion.

use core::cell::Cell;

use cspace::{Progress, Silent, Stage};
use cspace_model::{Compute, Mechanism, compute_anew};

use crate::assemble::assemble;
use crate::contact::{check_start, overlap_error};
use crate::error::SimulateError;
use crate::exact_fit::{Gap, Room, overlaps};
use crate::forces::has_forces;
use crate::inertial::{self, Scheme};
use crate::kinematic::run;
use crate::linear::Rows;
use crate::pairs::Pairs;
use crate::record::{Record, Sample, Status};
use crate::system::{PartCoordinates, System};

/// Default number of samples.
const SAMPLES: f64 = 200.0;
/// Largest number of samples: they take some gigabytes.
const MOST_SAMPLES: usize = 10_000_000;
/// Largest number of steps of one length: more would take days.
const MOST_STEPS: f64 = 1e10;
/// Number of steps of a motion without inertia between two calls of the progress callback.
const ASK_AFTER: u32 = 64;
/// A duration is a whole number of steps to this share of one.
const STEP_ROUNDING: f64 = 1e-6;

/// Settings of a simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Duration, in seconds.
    pub time: f64,
    /// The time between samples; a 200th of the whole if none is given.
    pub every: Option<f64>,
}

/// A mechanism that is ready to move: its coordinates, the spaces of its pairs, and where it starts.
#[derive(Debug)]
pub struct Simulation {
    system: System,
    pairs: Pairs,
    start: Vec<f64>,
    gaps: Vec<Gap>,
    /// Time and rates of the sample from which the motion is restarted.
    taken_up: Option<(f64, Vec<f64>)>,
}

/// Method by which a motion is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    /// Without inertia, as [`Simulation::kinematic`].
    Kinematic,
    /// With masses from event to event, as [`Simulation::dynamic`].
    Dynamic,
    /// As [`Dynamic`](Self::Dynamic), but where several motions agree with the laws of contact, or events cannot be told apart, the motion
    /// ends.
    Strict,
    /// With masses in steps no longer than this, in seconds, as [`Simulation::stepping`].
    Stepping(f64),
}

/// Degrees of freedom left by joints between parts that move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Freedom {
    /// Coordinates that are not driven.
    pub coordinates: usize,
    /// Equations of the joints.
    pub equations: usize,
    /// Number of the equations that do not follow from others.
    pub independent: usize,
}

impl Freedom {
    /// Number of degrees of freedom left, contacts aside.
    pub fn left(&self) -> usize {
        self.coordinates - self.independent
    }

    /// Number of equations that follow from others: the mechanism is over-determined by that many.
    pub fn redundant(&self) -> usize {
        self.equations - self.independent
    }
}

impl Simulation {
    /// Prepares a mechanism: computes the spaces of its pairs, and moves parts that joints carry to where these hold.
    ///
    /// # Errors
    /// If the mechanism is invalid, nothing in it can move, joints cannot hold, or parts overlap at the start.
    pub fn new(mechanism: &Mechanism) -> Result<Self, SimulateError> {
        Self::new_with(mechanism, &Silent)
    }

    /// As [`new`](Self::new), and reports the stages of each space to `progress`.
    ///
    /// # Errors
    /// As [`new`](Self::new), and errors returned by `progress`.
    pub fn new_with(mechanism: &Mechanism, progress: &dyn Progress) -> Result<Self, SimulateError> {
        Self::new_by(mechanism, &compute_anew(progress))
    }

    /// As [`new`](Self::new), with the spaces from elsewhere.
    ///
    /// # Errors
    /// As [`new`](Self::new); and what `compute` returns.
    pub fn new_by(mechanism: &Mechanism, compute: &Compute<'_>) -> Result<Self, SimulateError> {
        mechanism.check()?;
        let mut drawn = Self::prepared(mechanism, compute)?;
        let found = overlaps(&drawn.system, drawn.pairs.list().iter(), &drawn.start)?;
        if let Some(&(pair, depth)) = found.deep.first() {
            return Err(overlap_error(&drawn.system, pair, depth));
        }
        if found.exact.is_empty() {
            return Ok(drawn);
        }
        let room = Room::of(&drawn.system, &found.exact)?;
        room.put_in(&mut drawn.pairs, compute)?;
        drawn.system = System::new(&room.mechanism);
        check_start(&drawn.system, &drawn.pairs, &drawn.start)?;
        drawn.gaps = room.gaps;
        Ok(drawn)
    }

    /// A mechanism with the spaces of its pairs, where its joints hold.
    fn prepared(mechanism: &Mechanism, compute: &Compute<'_>) -> Result<Self, SimulateError> {
        let system = System::new(mechanism);
        if system.count() == 0 {
            return Err(SimulateError::NothingMoves);
        }
        check_ranges(&system, &system.start())?;
        let pairs = Pairs::compute_by(mechanism, compute)?;
        let Some(start) = assemble(&system, &pairs) else {
            return Err(system.open_joint(&system.start()));
        };
        check_ranges(&system, &start)?;
        Ok(Self {
            system,
            pairs,
            start,
            gaps: Vec::new(),
            taken_up: None,
        })
    }

    /// Restarts the mechanism from a recorded sample: its time, coordinates and rates.
    ///
    /// # Errors
    /// If the number of coordinates or rates is not that of the mechanism, or parts overlap there.
    pub fn taken_up(mut self, at: &Sample) -> Result<Self, SimulateError> {
        let count = self.system.count();
        if at.coordinates.len() != count || at.rates.len() != count {
            return Err(SimulateError::Count {
                found: at.coordinates.len(),
                count,
            });
        }
        check_ranges(&self.system, &at.coordinates)?;
        check_start(&self.system, &self.pairs, &at.coordinates)?;
        self.start.clone_from(&at.coordinates);
        self.taken_up = Some((at.t, at.rates.clone()));
        Ok(self)
    }

    /// Computes the motion; if `progress` interrupts it, the part so far is kept, with [`Status::Interrupted`].
    ///
    /// # Errors
    /// As [`kinematic`](Self::kinematic), [`dynamic`](Self::dynamic) and [`stepping`](Self::stepping).
    pub fn kept_with(
        &self,
        way: Way,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Record, SimulateError> {
        let (time, every) = settings.times()?;
        let from = self.taken_up.as_ref().map_or(0.0, |t| t.0);
        if from >= time {
            return Err(SimulateError::Time {
                what: "the time from where the motion is taken up",
                value: time - from,
            });
        }
        let goes_on = |_| progress.stage(Stage::Graph).is_ok();
        let scheme = match way {
            Way::Kinematic => {
                let system = match has_forces(self.system.mechanism()) {
                    true => &self.system.balanced(),
                    false => &self.system,
                };
                let start = self.start.clone();
                let steps = Cell::new(0_u32);
                let goes_on = |share| {
                    steps.set(steps.get().wrapping_add(1));
                    !steps.get().is_multiple_of(ASK_AFTER) || goes_on(share)
                };
                return Ok(run(
                    system,
                    &self.pairs,
                    start,
                    [from, time],
                    every,
                    &goes_on,
                ));
            }
            Way::Dynamic | Way::Strict => Scheme::Events,
            Way::Stepping(step) => Scheme::Steps(steps(time - from, step)?),
        };
        let system = System::about_masses(self.system.mechanism());
        let rates = match &self.taken_up {
            Some((_, rates)) => rates.clone(),
            None => self.system.start_rates(),
        };
        let start = (self.start.clone(), rates);
        let times = ([from, time], every);
        inertial::run(
            system,
            &self.pairs,
            start,
            times,
            (scheme, way == Way::Strict),
            &goes_on,
        )
    }

    /// As [`kept_with`](Self::kept_with), but an interrupted motion is an error.
    fn whole(
        &self,
        way: Way,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Record, SimulateError> {
        let record = self.kept_with(way, settings, progress)?;
        match record.status {
            Status::Interrupted => Err(SimulateError::Interrupted),
            _ => Ok(record),
        }
    }

    /// The coordinates.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The parts that are smaller than drawn, because they fit exactly into another at the start and would have no room to move.
    pub fn gaps(&self) -> &[Gap] {
        &self.gaps
    }

    /// The pairs.
    pub fn pairs(&self) -> &Pairs {
        &self.pairs
    }

    /// Coordinates at the start.
    pub fn start(&self) -> &[f64] {
        &self.start
    }

    /// Degrees of freedom that the joints leave at the start, and number of dependent equations.
    pub fn freedom(&self) -> Freedom {
        let (free, lengths) = (self.system.free(), self.system.lengths());
        let joints = self.system.joints(&self.start);
        let mut rows = Rows::default();
        for joint in &joints {
            let mut row = vec![0.0; free.len()];
            for &(i, by) in joint.entries() {
                if let Ok(k) = free.binary_search(&i) {
                    row[k] = by / lengths[i];
                }
            }
            rows.push(&row);
        }
        Freedom {
            coordinates: free.len(),
            equations: joints.len(),
            independent: rows.rank(),
        }
    }

    /// Dynamic motion: parts with masses, impacts and friction.
    ///
    /// # Errors
    /// If times are invalid, or a part that is free to move has no mass.
    pub fn dynamic(&self, settings: &Settings) -> Result<Record, SimulateError> {
        self.dynamic_with(settings, &Silent)
    }

    /// As [`dynamic`](Self::dynamic); `progress` is called at intervals with the last stage.
    ///
    /// # Errors
    /// As [`dynamic`](Self::dynamic), and errors returned by `progress`.
    pub fn dynamic_with(
        &self,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Record, SimulateError> {
        self.whole(Way::Dynamic, settings, progress)
    }

    /// Dynamic motion by Moreau–Jean time stepping, in steps no longer than `step`, in seconds: a check of
    /// [`dynamic`](Self::dynamic) that shares masses, forces and contact functions with it, but not the integration.
    /// Positions and times of impacts are accurate to the order of a step, and parts overlap by up to the displacement
    /// in one step: the recording's `open` is the penetration.
    ///
    /// # Errors
    /// As [`dynamic`](Self::dynamic), and if the step is not positive or steps are too many.
    pub fn stepping(&self, settings: &Settings, step: f64) -> Result<Record, SimulateError> {
        self.stepping_with(settings, step, &Silent)
    }

    /// As [`stepping`](Self::stepping); `progress` is called at intervals with the last stage.
    ///
    /// # Errors
    /// As [`stepping`](Self::stepping), and errors returned by `progress`.
    pub fn stepping_with(
        &self,
        settings: &Settings,
        step: f64,
        progress: &dyn Progress,
    ) -> Result<Record, SimulateError> {
        self.whole(Way::Stepping(step), settings, progress)
    }

    /// [Dynamic](Self::dynamic_with) motion if a part has a mass, otherwise [kinematic](Self::kinematic_with).
    ///
    /// # Errors
    /// As for the chosen method.
    pub fn follow_with(
        &self,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Record, SimulateError> {
        if self.system.mechanism().has_masses() {
            self.dynamic_with(settings, progress)
        } else {
            self.kinematic_with(settings, progress)
        }
    }

    /// Kinematic motion: drives move slowly, and loads, springs and weights balance at every instant.
    ///
    /// # Errors
    /// If times are invalid.
    pub fn kinematic(&self, settings: &Settings) -> Result<Record, SimulateError> {
        self.kinematic_with(settings, &Silent)
    }

    /// As [`kinematic`](Self::kinematic); `progress` is called at intervals with the last stage.
    ///
    /// # Errors
    /// As [`kinematic`](Self::kinematic), and errors returned by `progress`.
    pub fn kinematic_with(
        &self,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Record, SimulateError> {
        self.whole(Way::Kinematic, settings, progress)
    }
}

impl Settings {
    /// The duration and the time between samples.
    fn times(&self) -> Result<(f64, f64), SimulateError> {
        let time = self.time;
        let every = self.every.unwrap_or(time / SAMPLES);
        for (what, value) in [("the time", time), ("the time between samples", every)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(SimulateError::Time { what, value });
            }
        }
        let samples = time / every;
        if samples > MOST_SAMPLES as f64 {
            return Err(SimulateError::TooMany {
                samples,
                most: MOST_SAMPLES,
            });
        }
        Ok((time, every))
    }
}

/// Number of steps no longer than `step` in a time.
fn steps(time: f64, step: f64) -> Result<usize, SimulateError> {
    if !(step > 0.0 && step.is_finite()) {
        let what = "the step";
        return Err(SimulateError::Time { what, value: step });
    }
    // One that is longer by rounding is no shorter step more.
    let steps = (time / step - STEP_ROUNDING).ceil().max(1.0);
    if steps > MOST_STEPS {
        return Err(SimulateError::TooManySteps {
            steps,
            most: MOST_STEPS,
        });
    }
    Ok(steps as usize)
}

/// Checks that all parts are within their ranges.
pub(crate) fn check_ranges(system: &System, q: &[f64]) -> Result<(), SimulateError> {
    for (i, part) in system.parts().iter().enumerate() {
        if let PartCoordinates::Axis {
            first,
            range: Some((lo, hi)),
            ..
        } = *part
        {
            let slack = 1e-9 * (hi - lo);
            if q[first] < lo - slack || q[first] > hi + slack {
                let part = system.mechanism().parts[i].part.name().to_owned();
                return Err(SimulateError::Range { part });
            }
        }
    }
    Ok(())
}
