//! Critical orientations at 0, at ±π and at the ends of windows.

use core::f64::consts::{FRAC_PI_2, PI};

use super::outline::*;
use super::{Case, Family, family, powers, vanishing};

pub(super) fn add(all: &mut Vec<Family>) {
    let both = || {
        let above = vanishing().into_iter();
        above.chain(powers(-1, -15).into_iter().map(|d| -d))
    };
    all.push(family(
        "critical orientation at half a turn, but for",
        both(),
        |d| {
            Ok(Case::new(hook(), turned(&wedge(), PI + d))?
                .about(&[(0.0, 1.5, PI), (0.0, 1.5, -PI)]))
        },
    ));
    all.push(family(
        "critical orientation at zero, but for",
        both(),
        |d| Ok(Case::new(hook(), turned(&wedge(), d))?.about(&[(0.0, 1.5, 0.0)])),
    ));
    all.push(family(
        "window that ends at a critical orientation, but for",
        both(),
        |d| {
            Ok(Case::new(hook(), wedge())?
                .within(-1.0, 0.0 + d)
                .about(&[(0.0, 1.5, d), (0.0, 1.5, 0.0)]))
        },
    ));
    all.push(family(
        "window that begins at a critical orientation, but for",
        both(),
        |d| {
            Ok(Case::new(hook(), wedge())?
                .within(d, 1.0)
                .about(&[(0.0, 1.5, d), (0.0, 1.5, 0.0)]))
        },
    ));
    all.push(family(
        "window across half a turn, width",
        powers(0, -9),
        |w| {
            Ok(Case::new(hook(), wedge())?
                .within(PI - w, PI + w)
                .about(&[(0.0, 1.5, PI), (0.0, 1.5, PI + 0.5 * w)]))
        },
    ));
    all.push(family("window short of a turn by", powers(0, -12), |w| {
        Ok(Case::new(hook(), wedge())?
            .within(-FRAC_PI_2 + w, 3.0 * FRAC_PI_2)
            .about(&[(0.0, 1.5, -FRAC_PI_2 + w)]))
    }));
}

fn hook() -> Loops {
    vec![vec![
        line(-1.0, -1.0),
        line(1.0, -1.0),
        line(1.0, 1.0),
        line(0.5, 1.0),
        line(0.5, 0.0),
        line(-0.25, 0.0),
        arc(-0.25, 1.0, 1.0),
        line(-1.0, 1.0),
    ]]
}

/// Wedge with sides parallel to those of the hook, and one that is not.
fn wedge() -> Loops {
    vec![vec![
        line(-0.3, -0.5),
        line(0.3, -0.5),
        line(0.3, 0.5),
        line(-0.2, 0.5),
    ]]
}
