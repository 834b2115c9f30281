//! Circles whose centres come together.

use super::outline::*;
use super::{Case, Family, family, vanishing};
use crate::shapes::{bulge_through, c_shape, ring_sector};
use cspace::Point;

pub(super) fn add(all: &mut Vec<Family>) {
    all.push(family(
        "groove between circles, eccentricity",
        vanishing(),
        |e| {
            let mut groove = plate(6.0, disc(2.01));
            groove.push(disc_at(0.5 * e, 0.0, 0.99));
            Ok(
                Case::new(groove, loops_of(&ring_sector(2.0, 1.0, -0.4, 0.4)))?
                    .about(&[(0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]),
            )
        },
    ));
    all.push(family(
        "sector in a groove, eccentricity of its arcs",
        vanishing(),
        |e| {
            let groove = {
                let mut all = plate(6.0, disc(2.0));
                all.push(disc_at(0.0, 0.0, 1.0));
                all
            };
            // Through three points, the middle one moved: another centre, much the same radius.
            let at = |r: f64, a: f64| Point::new(r * a.cos(), r * a.sin());
            let (o, i) = (
                [-0.4, 0.0, 0.4].map(|a| at(1.99, a)),
                [0.4, 0.0, -0.4].map(|a| at(1.01, a)),
            );
            let moved = |p: Point| Point::new(p.x + 0.05 * e, p.y);
            let sector = vec![vec![
                arc(o[0].x, o[0].y, bulge_through(o[0], moved(o[1]), o[2])),
                line(o[2].x, o[2].y),
                arc(i[0].x, i[0].y, bulge_through(i[0], moved(i[1]), i[2])),
                line(i[2].x, i[2].y),
            ]];
            Ok(Case::new(groove, sector)?.about(&[(0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]))
        },
    ));
    all.push(family(
        "rings with a gap in each other, eccentricity",
        vanishing(),
        |e| {
            let ring = loops_of(&c_shape(1.0, 0.8, 0.5));
            let other = shifted(&loops_of(&c_shape(1.0, 0.8, 0.4)), e, 0.0);
            Ok(Case::new(ring, scaled(&other, 0.75))?.about(&[(0.0, 0.0, 0.0), (0.0, 0.0, 3.0)]))
        },
    ));
}
