//! The mechanism at some times of a motion.

use cspace::pair::Joint;
use cspace::{Configuration, Point, Rotation, Vector};
use cspace_draw::{ContactMark, MotionFrame, PartsPicture, PlacedPart};
use cspace_model::JointEntry;
use cspace_motion::{PartCoordinates, Record, Report, Sample, Simulation, Trajectory};

use crate::failure::Failure;

/// So many frames are beside each other.
const FRAMES: usize = 6;
/// A frame is moved to an event by up to this share of the time between two.
const NEAR: f64 = 0.45;

/// Frames of the last cycle, or of all of it: at even times, or at events near to these.
pub(super) fn frames<'a>(
    simulation: &'a Simulation,
    record: &Record,
    report: &Report,
    trajectory: &Trajectory<'_>,
) -> Result<Vec<MotionFrame<'a>>, Failure> {
    let until = record.until;
    /// A cycle that takes less of the whole is too short to be found again above the strips.
    const LEAST: f64 = 0.2;
    let (from, step) = match &report.cycle {
        Some(cycle) if cycle.period >= LEAST * until => {
            (until - cycle.period, cycle.period / FRAMES as f64)
        }
        _ => (0.0, until / (FRAMES - 1) as f64),
    };
    let mut chosen: Vec<&Sample> = Vec::new();
    for k in 0..FRAMES {
        let even = from + k as f64 * step;
        let off = |t: f64| (t - even).abs();
        let events = record.events.iter().map(|e| e.t);
        let events = events.filter(|t| off(*t) <= NEAR * step && *t >= from);
        let at = events.min_by(|a, b| off(*a).total_cmp(&off(*b)));
        // Only moments that are known have their contacts closed to rounding.
        if let Some(moment) = trajectory.nearest(at.unwrap_or(even))
            && chosen.last().is_none_or(|last| last.t < moment.t)
        {
            chosen.push(moment);
        }
    }
    chosen.iter().map(|s| frame(simulation, s)).collect()
}

fn frame<'a>(simulation: &'a Simulation, moment: &Sample) -> Result<MotionFrame<'a>, Failure> {
    let system = simulation.system();
    let (model, q) = (system.mechanism(), &moment.coordinates);
    let mut caption = format!("{:.4} s", moment.t);
    if let Some((i, _)) = system.drives().first() {
        let part = system.parts().iter().find(|p| p.indices().start == *i);
        if part.is_some_and(|p| p.orientation() == Some(*i)) {
            caption += &format!(", {:.1}°", q[*i].to_degrees()).replace('-', "−");
        }
    }
    let at: Vec<Configuration> = (system.parts().iter().zip(&model.parts))
        .map(|(part, entry)| match (*part, entry.axis) {
            (PartCoordinates::Planar { first, .. }, _) => {
                Configuration::new(q[first], q[first + 1], q[first + 2])
            }
            (PartCoordinates::Axis { first, .. }, Some(axis)) => axis.configuration(q[first]),
            _ => Configuration::default(),
        })
        .collect();
    let parts = (model.parts.iter().zip(&at).enumerate())
        .map(|(number, (entry, at))| PlacedPart {
            part: &entry.part,
            assembly_from_part: *at,
            axis: entry.axis,
            number,
        })
        .collect();
    Ok(MotionFrame {
        time: moment.t,
        caption,
        parts: PartsPicture {
            parts,
            joints: (model.joints.iter()).map(|j| moved(j, &at)).collect(),
            contacts: contacts(simulation, q, &at)?,
            without_origins: true,
            ..PartsPicture::default()
        },
    })
}

/// A joint where its first part has come to.
fn moved(entry: &JointEntry, at: &[Configuration]) -> JointEntry {
    let by = at[entry.parts.0];
    let joint = match entry.joint {
        Joint::Revolute { at } => Joint::Revolute {
            at: by.fixed_from_moving(at),
        },
        Joint::Prismatic { direction, at } => Joint::Prismatic {
            direction: Rotation::by(by.theta) * direction,
            at: by.fixed_from_moving(at),
        },
    };
    JointEntry { joint, ..*entry }
}

/// The contacts at coordinates `q`, as marks of a picture.
fn contacts(
    simulation: &Simulation,
    q: &[f64],
    at: &[Configuration],
) -> Result<Vec<ContactMark>, Failure> {
    let system = simulation.system();
    let mut marks = Vec::new();
    for (index, pair) in simulation.pairs().list().iter().enumerate() {
        let touches = pair.touches(index, system, q, pair.touch);
        let coordinates = pair.coordinates(system, q);
        for touch in touches.map_err(Failure::new)? {
            let place = touch
                .contact()
                .touching(coordinates)
                .map_err(Failure::new)?;
            let (p, n): (Point, Vector) = (place.on_fixed, place.normal);
            let assembly_from_fixed = at[pair.fixed];
            let [f, m] = [
                pair.space.fixed().feature_text(touch.features.0.name),
                pair.space.moving().feature_text(touch.features.1.name),
            ];
            marks.push(ContactMark {
                at: assembly_from_fixed.fixed_from_moving(p),
                normal: Rotation::by(assembly_from_fixed.theta) * n,
                label: format!(
                    "{f} of {} touches {m} of {}",
                    pair.space.fixed().name(),
                    pair.space.moving().name()
                ),
            });
        }
    }
    Ok(marks)
}
