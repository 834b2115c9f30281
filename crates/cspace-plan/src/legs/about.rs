//! Configurations of a moving part by the place of one of its points, which legs move straight.

use cspace::{Configuration, Point, Rotation, Vector};

use super::pose::Coords;

/// The place of a point of the moving part, given in its frame, and the orientation.
pub(crate) fn numbers_about(c: Configuration, about: Vector) -> Coords {
    if about == Vector::ZERO {
        return [c.x, c.y, c.theta];
    }
    let at = c.position() + Rotation::by(c.theta) * about;
    [at.x, at.y, c.theta]
}

/// The configuration in which a point of the moving part is at a place, with an orientation.
pub(crate) fn configuration_about(at: Coords, about: Vector) -> Configuration {
    if about == Vector::ZERO {
        return Configuration::new(at[0], at[1], at[2]);
    }
    let p = Point::new(at[0], at[1]) - Rotation::by(at[2]) * about;
    Configuration::new(p.x, p.y, at[2])
}
