//! Reading the models, and asking what becomes of their parts.

use cspace::{Classification, Configuration, ContactSpace, Options, Part, Rotation, Vector};
use cspace_model::{Mechanism, model};

pub(crate) use Classification::{Blocked, Contact, Free};

pub(crate) fn model(name: &str) -> Mechanism {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/paper");
    model::read(format!("{folder}/{name}.toml")).unwrap()
}

/// The fixed and the moving part.
pub(crate) fn parts(name: &str) -> (Part, Part) {
    let model = model(name);
    let pair = &model.pairs[0];
    let part = |index: usize| model.parts[index].part.clone();
    (part(pair.fixed), part(pair.moving))
}

pub(crate) fn space(name: &str) -> ContactSpace {
    let (fixed, moving) = parts(name);
    ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap()
}

pub(crate) fn at(position: Vector, theta: f64) -> Configuration {
    Configuration::new(position.x, position.y, theta)
}

/// The vector (x, y), turned.
pub(crate) fn turned(x: f64, y: f64, by: f64) -> Vector {
    Rotation::by(by) * Vector::new(x, y)
}

#[track_caller]
pub(crate) fn expect(space: &ContactSpace, c: Configuration, class: Classification) {
    assert_eq!(space.classify(c), Some(class), "{c:?}");
}

/// Displacement of the moving part along a motion of unit rate until it is stopped, if that is within `most`.
#[track_caller]
pub(crate) fn stop(
    space: &ContactSpace,
    from: Configuration,
    rates: [f64; 3],
    most: f64,
) -> Option<f64> {
    let outcome = space.first_contact(from, rates, most).unwrap();
    outcome.contact().map(|contact| contact.time)
}

#[track_caller]
pub(crate) fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() < tolerance, "{a} is not {b}");
}
