//! How far does a ratchet wheel turn back before the pawl locks it?
//!
//! Both parts turn about axes of their own, so that a configuration is two numbers (u, v): how far the wheel has turned,
//! and how far the pawl. Such a pair is computed as an exact partition of the plane of u and v.
//!
//! Run with `cargo run --release --example ratchet_feed`.

use std::f64::consts::TAU;

use cspace::pair::PairMotion;
use cspace::{Axis, Coordinates, Options, PairSpace, Part, Point, QueryError, Relation, Vector};

const TEETH: u32 = 12;
const PITCH: f64 = TAU / TEETH as f64;
/// How far the wheel turns at a time while the pawl rides on it, radians.
const STEP: f64 = PITCH / 200.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Every tooth has a radial face and a long back.
    let corner = |radius: f64, angle: f64| Point::ORIGIN + Vector::from_angle(angle) * radius;
    let corners: Vec<Point> = (0..TEETH)
        .flat_map(|k| {
            let angle = PITCH * f64::from(k);
            [corner(8.0, angle), corner(10.0, angle)]
        })
        .collect();
    let wheel = Part::polygon("wheel", &corners)?;

    // The pawl reaches from its pivot at (12, 9) down to the wheel. At v = 0 it is lifted; it falls as v grows.
    let pivot = Point::new(12.0, 9.0);
    let pawl = Part::polygon(
        "pawl",
        &[
            (12.0, 8.0),
            (12.5, 9.5),
            (3.0, 11.5),
            (3.0, 10.6),
            (3.6, 10.6),
        ],
    )?;

    let relation = Relation::Axes {
        fixed: Axis::revolute(Point::ORIGIN),
        moving: Axis::revolute(pivot).within(-0.3, 0.6),
    };
    let space = PairSpace::compute(&wheel, &pawl, relation, &Options::default())?;
    println!(
        "{} contact curves in the plane of both angles",
        space.patch_count()
    );

    // The wheel stands where it was fed to, the pawl falls on it, and the load turns the wheel back.
    for fed in [0.0, 0.25, 0.5, 0.75] {
        let (u, v) = (fed * PITCH, drop_pawl(&space, fed * PITCH, -0.2)?);
        let back = turn_back(&space, u, v)?;
        println!(
            "fed by {fed:.2} of a tooth: turns back by {:.3} of a tooth",
            back / PITCH
        );
    }
    // The wheel locks at one angle of every tooth. Feeding by a quarter more costs a quarter more on the way back, until the
    // feed gets past a face: then the tooth that was passed is kept, and little is lost.
    Ok(())
}

/// How far the pawl falls from v, with the wheel held at u.
fn drop_pawl(space: &PairSpace, u: f64, v: f64) -> Result<f64, QueryError> {
    let motion = space.first_contact(
        Coordinates::Axes { u, v },
        Coordinates::Axes { u: 0.0, v: 1.0 },
        1.0,
    )?;
    Ok(match motion {
        PairMotion::Contact(contact) => match contact.at {
            Coordinates::Axes { v, .. } => v,
            Coordinates::Planar(_) => v,
        },
        PairMotion::Leaves { time } => v + time,
        PairMotion::Free => v + 1.0,
    })
}

/// How far the wheel turns back from u until a tooth's face meets the pawl, which rides on the wheel.
fn turn_back(space: &PairSpace, u: f64, mut v: f64) -> Result<f64, QueryError> {
    let mut back = 0.0;
    while back < TAU {
        let from = Coordinates::Axes { u: u - back, v };
        match space.first_contact(from, Coordinates::Axes { u: -1.0, v: 0.0 }, STEP)? {
            PairMotion::Contact(face) => return Ok(back + face.time),
            _ => back += STEP,
        }
        v = drop_pawl(space, u - back, v)?;
    }
    Ok(back)
}
