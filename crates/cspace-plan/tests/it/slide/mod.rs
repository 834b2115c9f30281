//! A part that is dragged goes as far as the surface leads: it does not stick where a small motion aside frees it.

mod models;
mod places;
mod random;
mod sliders;
mod speed;
mod weighted;

use cspace::{Configuration, Coordinates};

/// x, y and θ of a planar pair.
fn planar(at: Coordinates) -> Configuration {
    match at {
        Coordinates::Planar(c) => c,
        Coordinates::Axes { .. } => panic!("the pair is planar"),
    }
}

fn at(x: f64, y: f64, theta: f64) -> Coordinates {
    Coordinates::Planar(Configuration::new(x, y, theta))
}
