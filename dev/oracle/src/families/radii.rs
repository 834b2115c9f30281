//! Very small and very large arcs, and arcs of nearly equal radii.

use core::f64::consts::FRAC_PI_2;

use super::outline::*;
use super::{Case, Family, family, powers, vanishing};
use crate::shapes::bulge_of;

pub(super) fn add(all: &mut Vec<Family>) {
    all.push(family("corners rounded, radius", powers(-1, -6), |r| {
        Ok(Case::new(rounded(1.0, 1.0, r), rounded(0.7, 0.5, 2.0 * r))?
            .about(&[(0.85, 0.0, 0.0), (0.85, 0.75, 0.0)]))
    }));
    all.push(family("sides bulging, radius", powers(0, 9), |r| {
        Ok(Case::new(curved(r), curved(2.0 * r))?.about(&[(0.0, 1.0, 0.0)]))
    }));
    all.push(family("sides hollow, radius", powers(0, 9), |r| {
        Ok(Case::new(curved(-r), rectangle(0.6, 0.3))?.about(&[(0.0, 0.6, 0.0)]))
    }));
    all.push(family(
        "side bulging into a hollow of its radius",
        powers(0, 9),
        |r| Ok(Case::new(curved(-r), curved(r))?.about(&[(0.0, 1.0, 0.0)])),
    ));
    all.push(family(
        "bowed sides between rounded corners, radius",
        powers(1, 9),
        |r| {
            Ok(Case::new(bowed(0.8, 0.1, r), bowed(0.4, 0.05, -2.0 * r))?
                .about(&[(0.0, 0.75, 0.0)]))
        },
    ));
    all.push(family(
        "bowed bar in a bowed slot, radius",
        powers(3, 9),
        |r| {
            let bar = |height: f64, r: f64| {
                let b = bulge_of(2.0 * (0.5 / r).asin());
                vec![
                    arc(-0.5, -height, b),
                    line(0.5, -height),
                    arc(0.5, height, -b),
                    line(-0.5, height),
                ]
            };
            // A bar that is bent, in a slot as bent and open at its ends.
            let (low, high) = (bar(0.6, r), bar(0.1, r));
            let slot = vec![
                low[0],
                low[1],
                arc(0.5, -0.12, -low[0].bulge),
                line(-0.5, -0.12),
            ];
            let other = vec![
                arc(-0.5, 0.12, low[0].bulge),
                line(0.5, 0.12),
                low[2],
                low[3],
            ];
            Ok(Case::new(vec![slot, other], vec![high])?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    let differences = || {
        let less = vanishing().into_iter();
        less.chain(powers(-1, -15).into_iter().map(|d| -d))
    };
    all.push(family(
        "disc in a socket, difference of radii",
        differences(),
        |d| {
            Ok(Case::new(socket(1.0), disc(1.0 - d))?
                .about(&[(0.0, 0.0, 0.0), (0.0, d.abs(), 0.0)]))
        },
    ));
    all.push(family(
        "rounded corner in a fillet, difference of radii",
        differences(),
        |d| {
            Ok(Case::new(filleted(0.5), rounded(1.4, 1.4, 0.5 - 0.4 * d))?
                .about(&[(0.7, 0.7, 0.0)]))
        },
    ));
    all.push(family(
        "half discs, difference of radii",
        differences(),
        |d| {
            let half = |r: f64| vec![vec![line(-r, 0.0), arc(r, 0.0, 1.0)]];
            Ok(Case::new(half(1.0), half(1.0 - d))?.about(&[(0.0, 0.0, core::f64::consts::PI)]))
        },
    ));
}

/// A square of side 1 whose upper and lower sides are arcs of a radius, hollow if negative.
fn curved(radius: f64) -> Loops {
    let b = bulge_of(2.0 * (0.5 / radius).asin());
    vec![vec![
        arc(-0.5, -0.5, b),
        line(0.5, -0.5),
        arc(0.5, 0.5, b),
        line(-0.5, 0.5),
    ]]
}

/// A square with rounded corners whose sides, of a length, are arcs of a radius that meet the corners smoothly; hollow if
/// negative.
fn bowed(side: f64, corner: f64, radius: f64) -> Loops {
    let turn = 2.0 * (0.5 * side / radius).asin();
    let rest = FRAC_PI_2 - turn;
    // A corner goes as far along either axis.
    let way = corner * 2.0 * (0.5 * rest).sin() * core::f64::consts::FRAC_1_SQRT_2;
    let (a, b) = (0.5 * side, 0.5 * side + way);
    let (s, c) = (bulge_of(turn), bulge_of(rest));
    vec![vec![
        arc(-a, -b, s),
        arc(a, -b, c),
        arc(b, -a, s),
        arc(b, a, c),
        arc(a, b, s),
        arc(-a, b, c),
        arc(-b, a, s),
        arc(-b, -a, c),
    ]]
}

/// A block with a half-round socket about the origin.
fn socket(r: f64) -> Loops {
    vec![vec![
        line(-2.0, -2.0),
        line(2.0, -2.0),
        line(2.0, 0.0),
        arc(r, 0.0, -1.0),
        line(-r, 0.0),
        line(-2.0, 0.0),
    ]]
}

/// Two legs at a right angle along the axes, and a fillet between.
fn filleted(r: f64) -> Loops {
    vec![vec![
        line(-0.5, -0.5),
        line(2.0, -0.5),
        line(2.0, 0.0),
        arc(r, 0.0, -bulge_of(FRAC_PI_2)),
        line(0.0, r),
        line(0.0, 2.0),
        line(-0.5, 2.0),
    ]]
}
