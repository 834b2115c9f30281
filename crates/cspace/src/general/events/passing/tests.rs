//! Meetings of three sheets some of which are flat arcs.

use super::*;
use crate::geometry::{Configuration, Point};
use crate::part::{Part, Vertex};
use crate::query::Classification;
use crate::slice::Slice;
use crate::space::{ContactSpace, Options};

/// A square with a side of this length, its lower and upper sides crowned.
fn crowned(side: f64, bulge: f64) -> Part {
    let h = 0.5 * side;
    let corners = [(-h, -h, bulge), (h, -h, 0.0), (h, h, bulge), (-h, h, 0.0)];
    let corners = corners.map(|(x, y, bulge)| Vertex::new(x, y, bulge));
    Part::new("crowned", vec![corners.to_vec()]).unwrap()
}

/// The straight sides of the hole are parallel: where the pocket closes, their contacts cross for 1e-17 rad at most, and the crossing
/// passes both arcs.
#[test]
fn what_has_play_in_a_crowned_hole_is_free() {
    let mut wrong = Vec::new();
    for bulge in [0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3] {
        let hole = crowned(1.0, bulge).framing(0.5);
        for play in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            for both in [false, true] {
                let moving = crowned(1.0 - play, if both { bulge } else { 0.0 });
                let loops = Slice::compute(&hole, &moving, 0.0).loops.len();
                let options = Options {
                    window: Some((-10.0 * play, 10.0 * play)),
                    ..Options::default()
                };
                let space = ContactSpace::compute(&hole, &moving, &options).unwrap();
                let class = space.classify(Configuration::new(0.0, 0.0, 0.0));
                let conflicts = space.statistics().conflicts;
                // Duration for which two corners lie on one arc (radians): 4e-10 makes the band doubtful.
                let narrow = (0.9e-10..1.1e-10).contains(&(bulge * play));
                let certain = narrow || space.doubtful_orientations().is_empty();
                if loops != 2 || class != Some(Classification::Free) || conflicts > 0 || !certain {
                    wrong.push(format!(
                        "{bulge:e} {play:e} {both}: {loops} {class:?} {conflicts} {certain}"
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Lines and circles of all sizes through one point, which turn and swing: the function is zero where they meet, and a polynomial of degree
/// four between.
#[test]
fn what_vanishes_where_three_meet_is_a_polynomial() {
    // Cycle given by a moving point, the normal, whether that turns too, and the signed radius; 0 for a line.
    let cycle = |(c, turns, radius): (f64, bool, f64), meet: f64, turn: Rotation<Exact>| {
        let exact = |v: Vector| v.map(Exact::from);
        let (normal, w) = (
            Vector::from_angle(c),
            exact(Vector::new(0.3 * c, 0.1 - 0.2 * c)),
        );
        let normal = exact(normal).unit();
        // A point on it that is at (0.4, -0.1) where they meet.
        let at = Rotation::by(Exact::from(meet));
        let place = Point::new(0.4, -0.1).map(Exact::from);
        let mut u = place + -(at * w);
        let n = if turns { turn * normal } else { normal };
        let n_then = if turns { at * normal } else { normal };
        if radius != 0.0 && radius.abs() < 100.0 {
            let r = Exact::from(radius);
            u += -(n_then * r);
            return Cycle::round(u + turn * w, r);
        }
        // Written by another point of it than that of the meeting.
        let through = u + turn * w;
        if radius == 0.0 {
            return Cycle::line(through, n);
        }
        Cycle::flat(through, n, Exact::from(1.0) / radius)
    };
    let kinds = [
        (0.2, false, 0.0),
        (1.9, true, 0.0),
        (1.1, false, 2500.0),
        (2.8, true, -2500.0),
        (4.0, false, -1e6),
        (5.2, true, 1e9),
        (3.3, false, 0.7),
        (0.7, false, -1.3),
    ];
    let meet = 0.37;
    for i in 0..kinds.len() {
        for j in 0..i {
            for k in 0..j {
                let three = [kinds[i], kinds[j], kinds[k]];
                let value =
                    |turn: Rotation<Exact>| concurrency(three.map(|c| cycle(c, meet, turn)));
                let polynomial = TrigPolynomial::sampled(value);
                let (at, slope) = polynomial.at(Exact::from(meet));
                assert!(at.to_f64().abs() <= polynomial.error(), "{three:?} {at:?}");
                assert!(
                    slope.to_f64().abs() > 1e10 * polynomial.error(),
                    "{three:?}"
                );
                for step in 0..20 {
                    let theta = Exact::from(0.3 * f64::from(step));
                    let off = polynomial.at(theta).0 - value(Rotation::by(theta)).0;
                    assert!(
                        off.to_f64().abs() <= polynomial.error(),
                        "{three:?} {off:?}"
                    );
                }
            }
        }
    }
}
