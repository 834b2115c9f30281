//! Ways out of others: straight ones without a contact space, and where any way has come out.

use cspace::{Configuration, Coordinates, Part, Vector};

use crate::answer::Path;
use crate::legs::{Coords, Scene};
use crate::out::{Exit, exits};
use crate::path::Legs;
use crate::route;

/// The place as drawn.
const DRAWN: Coords = [0.0; 3];

/// The straight ways by which a part comes out of another from where both are drawn, the shortest first.
pub(super) fn straight(fixed: &Part, moving: &Part) -> impl Iterator<Item = Exit> {
    let scene = Scene::new(fixed, moving, None);
    exits(fixed, moving, Configuration::default())
        .into_iter()
        .filter(move |exit| scene.is_apart(DRAWN, along(*exit), 0.0))
}

/// The path of a straight way.
pub(super) fn path(fixed: &Part, moving: &Part, exit: Exit) -> Path {
    told(&Scene::new(fixed, moving, None), vec![DRAWN, along(exit)])
}

/// Where a straight way ends.
pub(super) fn along(exit: Exit) -> Coords {
    let by = exit.direction * exit.distance;
    [by.x, by.y, 0.0]
}

/// A path with the place where it is narrowest.
pub(super) fn told(scene: &Scene, places: Vec<Coords>) -> Path {
    let legs = Legs::new(scene, places);
    Path {
        configurations: (legs.places().iter())
            .map(|&at| scene.coordinates(at))
            .collect(),
        about: scene.about(),
        narrowest: legs.narrow(),
    }
}

/// The path up to where the moving part is out: a line lies between the convex hulls.
pub(super) fn until_out(fixed: &Part, moving: &Part, path: Path) -> Path {
    /// The end of the way is known to this share of its last leg.
    const HALVINGS: u32 = 30;
    let scene = Scene::new(fixed, moving, None).with_about(path.about);
    let places: Vec<Coords> = (path.configurations.iter())
        .filter_map(|&at| scene.numbers(at).ok())
        .collect();
    let is_out = |at: Coords| match scene.coordinates(at) {
        Coordinates::Planar(at) => exits(fixed, moving, at)
            .first()
            .is_some_and(|e| e.distance <= 0.0),
        Coordinates::Axes { .. } => false,
    };
    let Some(last) = places.iter().position(|&at| is_out(at)).filter(|&i| i > 0) else {
        return path;
    };
    let (from, to) = (places[last - 1], places[last]);
    let part = |t: f64| route::along(from, to, t);
    let (mut before, mut out) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (before + out);
        if is_out(part(middle)) {
            out = middle;
        } else {
            before = middle;
        }
    }
    if out >= 1.0 && last + 1 == places.len() {
        return path;
    }
    let mut kept = places[..last].to_vec();
    kept.push(part(out));
    let mut path = told(&scene, kept);
    // Numbers of the point and back are rounded.
    if let Some(first) = path.configurations.first_mut() {
        *first = Coordinates::Planar(Configuration::default());
    }
    path
}

/// How far a part may be from another along a direction and not be out.
pub(super) fn until_beside(fixed: &Part, moving: &Part, direction: Vector) -> f64 {
    let box_of = |part: &Part| {
        let b = part.bounds();
        (b.center().to_vector(), 0.5 * b.diagonal())
    };
    let ((a, r), (b, s)) = (box_of(fixed), box_of(moving));
    (a - b).dot(direction.unit()) + r + s
}
