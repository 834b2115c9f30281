//! Writing what makes a mechanism move.

use crate::mechanism::{
    DriveMotion, Dynamics, LoadKind, Mass, PairEntry, PartDynamics, PartPosition, PartVelocity,
    SpringKind,
};

use super::toml_values::{lines, list, point, text, two, vector};

fn number(x: f64) -> String {
    format!("{x:?}")
}

/// Text of a number that differs from the default, 0.
fn other_than_0(x: f64) -> Option<String> {
    (x != 0.0).then(|| number(x))
}

fn three(a: f64, b: f64, c: f64) -> String {
    format!("[{a:?}, {b:?}, {c:?}]")
}

/// The keys of the file itself.
pub(super) fn of_whole(dynamics: &Dynamics) -> String {
    let gravity = dynamics.gravity;
    lines([
        (
            "gravity",
            (gravity != cspace::Vector::ZERO).then(|| vector(gravity)),
        ),
        ("friction", other_than_0(dynamics.friction)),
        ("restitution", other_than_0(dynamics.restitution)),
    ])
}

/// Further keys of a part.
pub(super) fn of_part(part: &PartDynamics) -> String {
    let (mass, density) = match part.mass {
        Some(Mass::Total(mass)) => (Some(mass), None),
        Some(Mass::Density(density)) => (None, Some(density)),
        None => (None, None),
    };
    lines([
        ("mass", mass.map(number)),
        ("density", density.map(number)),
        ("inertia", part.inertia.map(number)),
        ("center_of_mass", part.center_of_mass.map(point)),
        (
            "start",
            part.start.map(|s| match s {
                PartPosition::Planar(c) => three(c.x, c.y, c.theta),
                PartPosition::Axis(u) => number(u),
            }),
        ),
        (
            "rate",
            part.rate.map(|r| match r {
                PartVelocity::Planar { linear, angular } => three(linear.x, linear.y, angular),
                PartVelocity::Axis(u) => number(u),
            }),
        ),
    ])
}

/// Further keys of a pair.
pub(super) fn of_pair(dynamics: &Dynamics, pair: &PairEntry) -> String {
    let Some(surface) = dynamics.surface(pair.fixed, pair.moving) else {
        return String::new();
    };
    lines([
        ("friction", surface.friction.map(number)),
        ("restitution", surface.restitution.map(number)),
    ])
}

/// Drives, loads and springs; `name` gives the name of a part in quotes.
pub(super) fn written_apart(dynamics: &Dynamics, name: &dyn Fn(usize) -> String) -> String {
    let drives = dynamics.drives.iter().map(|drive| {
        let (rate, table) = match &drive.motion {
            DriveMotion::Rate(rate) => (Some(number(*rate)), None),
            DriveMotion::Table(points) => (None, Some(list(points.iter().map(|&p| two(p))))),
        };
        let part = ("part", Some(name(drive.part)));
        "\n[[drive]]\n".to_owned() + &lines([part, ("rate", rate), ("table", table)])
    });
    let loads = dynamics.loads.iter().map(|load| {
        let (force, at, torque) = match load.kind {
            LoadKind::Force { force, at } => (Some(vector(force)), at.map(point), None),
            LoadKind::Torque(torque) => (None, None, Some(number(torque))),
        };
        let keys = [
            ("part", Some(name(load.part))),
            ("force", force),
            ("at", at),
            ("torque", torque),
        ];
        "\n[[load]]\n".to_owned() + &lines(keys)
    });
    let springs = dynamics.springs.iter().map(|spring| {
        let names = [spring.part].into_iter().chain(spring.other).map(name);
        let parts = lines([("parts", Some(list(names)))]);
        "\n[[spring]]\n".to_owned() + &parts + &of_spring(spring.kind)
    });
    drives.chain(loads).chain(springs).collect()
}

fn of_spring(kind: SpringKind) -> String {
    match kind {
        SpringKind::Linear {
            at: (p, q),
            stiffness,
            length,
            damping,
        } => lines([
            ("at", Some(list([p, q].map(point)))),
            ("stiffness", Some(number(stiffness))),
            ("length", Some(number(length))),
            ("damping", other_than_0(damping)),
        ]),
        SpringKind::Torsion {
            stiffness,
            angle,
            damping,
        } => lines([
            ("type", Some(text("torsion"))),
            ("stiffness", Some(number(stiffness))),
            ("angle", Some(number(angle))),
            ("damping", other_than_0(damping)),
        ]),
    }
}
