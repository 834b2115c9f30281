//! Report on a motion: contacts from touch to release, the cycle in which it repeats, its period and drops, the largest forces, in words.

mod contacts;
mod cycle;
mod drops;
mod number;
mod peaks;
mod phase;
mod summary;
mod trajectory;

pub use contacts::ContactInterval;
pub use cycle::{Cycle, PartCycle};
pub use drops::{Drop, Swing};
pub use peaks::{ContactPeak, DrivePeak, Peak, Peaks, Pressing};
pub use trajectory::Trajectory;

use crate::record::Record;
use crate::simulate::Simulation;

/// Report on a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Contacts, in the order in which they begin.
    pub contacts: Vec<ContactInterval>,
    /// The cycle in which the motion repeats, if it does.
    pub cycle: Option<Cycle>,
    /// Drops in one cycle: a part loses contact with another and falls on to the next place.
    pub drops: Vec<Drop>,
    /// The largest forces, if forces are known.
    pub peaks: Option<Peaks>,
    /// Sentences.
    pub summary: Vec<String>,
}

impl Report {
    /// Reports on a recorded motion of a mechanism.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// use cspace_model::{Drive, DriveMotion, Mechanism, PartEntry};
    /// use cspace_motion::{Report, Settings, Simulation};
    /// let disc = |name: &str, x: f64| {
    ///     Part::new(name, vec![vec![Vertex::new(x - 10.0, 0.0, 1.0), Vertex::new(x + 10.0, 0.0, 1.0)]])
    /// };
    /// let mut mechanism = Mechanism::new("cam and roller");
    /// mechanism.parts.push(PartEntry::revolute(disc("cam", 3.0)?, (0.0, 0.0)));
    /// mechanism.parts.push(PartEntry::prismatic(disc("roller", 23.0)?, (1.0, 0.0)));
    /// mechanism.pairs = mechanism.every_two();
    /// let motion = DriveMotion::Rate(core::f64::consts::TAU);
    /// mechanism.dynamics.drives.push(Drive { part: 0, motion });
    /// let simulation = Simulation::new(&mechanism)?;
    /// let record = simulation.kinematic(&Settings { time: 2.0, every: None })?;
    /// let report = Report::of(&simulation, &record);
    /// assert!((report.cycle.ok_or("no cycle")?.period - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(simulation: &Simulation, record: &Record) -> Self {
        let system = simulation.system();
        let trajectory = Trajectory::of(record);
        let contacts = contacts::intervals(record);
        let cycle = cycle::find(system, record, &trajectory);
        let drops = (cycle.as_ref()).map_or(Vec::new(), |cycle| {
            drops::find(system, &trajectory, &contacts, cycle, record)
        });
        let peaks = Peaks::of(record);
        let found = summary::Found {
            contacts: &contacts,
            cycle: cycle.as_ref(),
            drops: &drops,
            peaks: peaks.as_ref(),
        };
        let gaps = (simulation.gaps().iter()).map(|gap| gap.sentence(system.mechanism()));
        let motion = summary::sentences(system, record, &trajectory, &found);
        let summary = gaps.chain(motion).collect();
        Self {
            contacts,
            cycle,
            drops,
            peaks,
            summary,
        }
    }
}
