//! Families of pairs with three and more contacts that meet at once, or nearly.

use core::f64::consts::{FRAC_PI_3, PI, TAU};

use cspace::Point;

use super::outline::*;
use super::{Case, Family, counting, family, powers, vanishing};
use crate::shapes::polar;

pub(super) fn add(all: &mut Vec<Family>) {
    let both = || {
        let more = vanishing().into_iter();
        more.chain(powers(-1, -15).into_iter().map(|d| -d))
    };
    all.push(family("disc amid three discs, play", both(), |d| {
        Ok(Case::new(ring_of_discs(3, 1.0 + 0.2 * d), disc(0.5))?.about(&[(0.0, 0.0, 0.0)]))
    }));
    all.push(family("disc amid four discs, play", both(), |d| {
        Ok(Case::new(ring_of_discs(4, 1.0 + 0.2 * d), disc(0.5))?.about(&[(0.0, 0.0, 0.0)]))
    }));
    all.push(family(
        "triangle with its corners on a triangle's sides, play",
        both(),
        |d| {
            let hole = plate(6.0, polygon(3, 2.0));
            Ok(Case::new(hole, polygon(3, 1.0 - 0.5 * d))?
                .about(&[(0.0, 0.0, PI), (0.0, 0.0, FRAC_PI_3)]))
        },
    ));
    all.push(counting(
        "discs that meet a disc at one place",
        &[3, 4, 5, 6, 8, 12],
        |n| {
            // They touch the moving disc at its centre position all at once, and leave no more.
            let r = 0.9 * (PI / n).sin();
            Ok(Case::new(ring_of(n as usize, 1.0, r), disc(1.0 - r))?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting(
        "square over as many equal posts",
        &[2, 3, 4, 6, 8],
        |n| {
            let posts = (0..n as usize)
                .map(|i| shifted(&rectangle(0.25, 0.25), 0.5 * i as f64, 0.0).swap_remove(0));
            Ok(Case::new(posts.collect(), rectangle(0.25, 0.25))?
                .about(&[(0.25, 0.0, 0.0), (0.25, 0.25, 0.0)]))
        },
    ));
}

/// Discs of radius 0.5 at a distance from the origin.
fn ring_of_discs(n: usize, distance: f64) -> Loops {
    ring_of(n, distance, 0.5)
}

fn ring_of(n: usize, distance: f64, radius: f64) -> Loops {
    (0..n)
        .map(|i| {
            let p = polar(Point::ORIGIN, distance, TAU * i as f64 / n as f64);
            disc_at(p.x, p.y, radius)
        })
        .collect()
}
