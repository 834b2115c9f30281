//! A page of a motion.

use cspace::{AxisMotion, PairSpace};
use cspace_api::simulate::Simulated;
use cspace_draw::{
    ContactBar, ContactRow, MotionPicture, PictureOptions, PlanePath, Scene, Track, TrackCurve,
    motion,
};
use cspace_model::{Mechanism, Quantity};
use cspace_motion::{
    EventKind, PartCoordinates, Record, Report, Simulation, System, Trajectory, What,
};

use super::SimulateArgs;
use crate::failure::Failure;
use crate::picture::Plane;

use super::force::{Column, columns};
use super::frames::frames;
use super::text::kind;

/// The options of the picture: x and y are those of the frames.
pub(super) fn options(args: &SimulateArgs, model: &Mechanism) -> Result<PictureOptions, Failure> {
    let unit = model.unit.as_deref();
    (args.picture).options(Plane::Positions, model.name.clone(), unit)
}

pub(super) fn scene(simulated: &Simulated, options: &PictureOptions) -> Result<Scene, Failure> {
    let Simulated {
        simulation,
        record,
        report,
        ..
    } = simulated;
    let system = simulation.system();
    let trajectory = Trajectory::of(record);
    let mut tracks = coordinates(system, &trajectory);
    tracks.extend(forces(simulation, record));
    let said = |e: &cspace_motion::Event| format!("{:.6} s: {}, {}", e.t, kind(e), e.what);
    let picture = MotionPicture {
        until: record.until,
        frames: frames(simulation, record, report, &trajectory)?,
        tracks,
        contacts: rows(system.mechanism(), record, report),
        events: record.events.iter().map(|e| (e.t, said(e))).collect(),
        planes: planes(simulation, &trajectory),
        remarks: report.summary.clone(),
    };
    Ok(motion(&picture, options))
}

/// A strip for each coordinate of each part that can move.
fn coordinates(system: &System, trajectory: &Trajectory<'_>) -> Vec<Track> {
    let model = system.mechanism();
    let mut tracks = Vec::new();
    for (number, part) in system.parts().iter().enumerate() {
        let name = model.parts[number].part.name();
        let labels: &[&str] = match part {
            PartCoordinates::Fixed => &[],
            PartCoordinates::Axis { .. } => &[""],
            PartCoordinates::Planar { .. } => &[" x", " y", " θ"],
        };
        for (i, which) in part.indices().zip(labels) {
            tracks.push(Track {
                label: format!("{name}{which}"),
                unit: model.unit.clone(),
                is_angle: part.orientation() == Some(i),
                curves: vec![TrackCurve {
                    points: trajectory.curve(i),
                    part: number,
                    title: format!("{name}{which}"),
                }],
            });
        }
    }
    tracks
}

/// Strips of the power of drives, and of the forces with which pairs press on each other.
fn forces(simulation: &Simulation, record: &Record) -> Vec<Track> {
    let model = simulation.system().mechanism();
    if record.samples.iter().all(|s| s.forces.is_none()) {
        return Vec::new();
    }
    let pairs = simulation.pairs().list().iter();
    let pairs: Vec<[usize; 2]> = pairs.map(|p| [p.fixed, p.moving]).collect();
    let number = |name: &str| model.parts.iter().position(|p| p.part.name() == name);
    let mut tracks = Vec::new();
    for column in columns(model, &pairs) {
        let (label, quantity, part) = match &column {
            Column::Pair {
                parts: [a, b],
                tangential: false,
            } => (format!("{a} – {b}, force"), Quantity::Force, b),
            Column::Drive { part, power: true } => {
                (format!("{part}, power"), Quantity::Power, part)
            }
            _ => continue,
        };
        let mut points: Vec<(f64, f64)> = (record.samples.iter())
            .filter_map(|s| Some((s.t, column.value(s.forces.as_ref()?))))
            .collect();
        let largest = points.iter().fold(0.0_f64, |m, p| m.max(p.1.abs()));
        if largest > 0.0 {
            let unit = quantity.shown(model.unit.as_deref(), largest);
            points.iter_mut().for_each(|p| p.1 *= unit.factor);
            let title = label.clone();
            let part = number(part).unwrap_or(0);
            let curves = vec![TrackCurve {
                points,
                part,
                title,
            }];
            tracks.push(Track {
                label,
                unit: Some(unit.name),
                is_angle: false,
                curves,
            });
        }
    }
    tracks
}

/// The contacts of each pair that has any.
fn rows(model: &Mechanism, record: &Record, report: &Report) -> Vec<ContactRow> {
    let mut rows = Vec::new();
    for pair in &model.pairs {
        let [a, b] = [pair.fixed, pair.moving].map(|i| model.parts[i].part.name());
        let mut known: Vec<&[String; 2]> = Vec::new();
        let mut row = ContactRow {
            label: format!("{a} – {b}"),
            ..ContactRow::default()
        };
        let of_pair = (report.contacts.iter()).filter(|c| c.fixed == a && c.moving == b);
        for contact in of_pair {
            let features = known.iter().position(|k| **k == contact.features);
            let features = features.unwrap_or_else(|| {
                known.push(&contact.features);
                known.len() - 1
            });
            let [f, m] = &contact.features;
            let (from, to) = (contact.from, contact.end(record.until));
            row.bars.push(ContactBar {
                from,
                to,
                features,
                label: format!("{} | {}", short(f), short(m)),
                title: format!("{from:.6} to {to:.6} s: {f} of {a} and {m} of {b}"),
            });
        }
        for event in record.events.iter().filter(|e| e.kind == EventKind::Impact) {
            if let What::Contact { fixed, moving, .. } = &event.what
                && fixed == a
                && moving == b
            {
                let said = format!("{:.6} s: impact, {}", event.t, event.what);
                row.impacts.push((event.t, said));
            }
        }
        if !row.bars.is_empty() || !row.impacts.is_empty() {
            rows.push(row);
        }
    }
    rows
}

/// A feature in few letters: `convex arc 3 of loop 0` is `A0.3`. A name that the model gives it stays.
fn short(feature: &str) -> String {
    const KINDS: [(&str, &str); 4] = [
        ("line ", "L"),
        ("convex arc ", "A"),
        ("concave arc ", "a"),
        ("vertex ", "V"),
    ];
    let shorter = KINDS.iter().find_map(|(long, letter)| {
        let (index, of) = feature.strip_prefix(long)?.split_once(" of loop ")?;
        let is_number = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
        (is_number(index) && is_number(of)).then(|| format!("{letter}{of}.{index}"))
    });
    shorter.unwrap_or_else(|| feature.to_owned())
}

/// The planes of pairs both of whose parts move on axes, with the paths of the motion in them.
fn planes<'a>(simulation: &'a Simulation, trajectory: &Trajectory<'_>) -> Vec<PlanePath<'a>> {
    let system = simulation.system();
    let mut planes = Vec::new();
    for pair in simulation.pairs().list() {
        let PairSpace::FixedAxes(space) = &pair.space else {
            continue;
        };
        let (u, v) = space.axes();
        if [u, v].iter().any(|a| a.motion == AxisMotion::Fixed) {
            continue;
        }
        let along = |part: usize| trajectory.curve(system.parts()[part].indices().start);
        let path = (along(pair.fixed).iter().zip(along(pair.moving)))
            .map(|(u, v)| (u.1, v.1))
            .collect();
        planes.push(PlanePath { space, path });
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn features_are_short() {
        assert_eq!(short("convex arc 3 of loop 0"), "A0.3");
        assert_eq!(short("vertex 12 of loop 1"), "V1.12");
        assert_eq!(short("line of loop 0"), "line of loop 0");
        assert_eq!(short("impulse face"), "impulse face");
    }
}
