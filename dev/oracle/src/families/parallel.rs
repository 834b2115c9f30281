//! Sides that come to lie on one line, or parallel to each other.

use super::outline::*;
use super::{Case, Family, family, powers};

pub(super) fn add(all: &mut Vec<Family>) {
    let to_nothing = || powers(-1, -16).into_iter().chain([0.0]);
    all.push(family(
        "teeth under a bar, step between their tips",
        to_nothing(),
        |d| {
            let teeth = vec![vec![
                line(-2.0, -1.0),
                line(2.0, -1.0),
                line(2.0, 1.0 + d),
                line(1.0, 1.0 + d),
                line(1.0, 0.0),
                line(-1.0, 0.0),
                line(-1.0, 1.0),
                line(-2.0, 1.0),
            ]];
            Ok(Case::new(teeth, rectangle(3.0, 0.5))?
                .about(&[(0.0, 1.25, 0.0), (0.0, 1.25 + d, 0.0)]))
        },
    ));
    all.push(family("step in a side, height", to_nothing(), |d| {
        let step = vec![vec![
            line(-1.0, -1.0),
            line(1.0, -1.0),
            line(1.0, 1.0),
            line(0.0, 1.0),
            line(0.0, 1.0 + d),
            line(-1.0, 1.0 + d),
        ]];
        Ok(Case::new(step, rectangle(1.0, 0.5))?.about(&[(0.0, 1.25, 0.0)]))
    }));
    all.push(family(
        "wedge in a straight slot, angle",
        to_nothing(),
        |a| {
            let slot = vec![vec![
                line(-2.0, -2.0),
                line(2.0, -2.0),
                line(2.0, 2.0),
                line(0.51, 2.0),
                line(0.51, 0.0),
                line(-0.51, 0.0),
                line(-0.51, 2.0),
                line(-2.0, 2.0),
            ]];
            let w = 0.5 + a.tan();
            let wedge = vec![vec![
                line(-0.5, 0.0),
                line(0.5, 0.0),
                line(w, 1.0),
                line(-0.5, 1.0),
            ]];
            Ok(Case::new(slot, wedge)?.about(&[(0.0, 0.1, 0.0), (0.0, 1.5, 0.0)]))
        },
    ));
    all.push(family(
        "trapezoids, angle of their legs",
        to_nothing(),
        |a| {
            let slanted = |a: f64| {
                let d = a.tan();
                vec![vec![
                    line(-1.0, -0.5),
                    line(1.0, -0.5),
                    line(1.0 - d, 0.5),
                    line(-1.0 + d, 0.5),
                ]]
            };
            Ok(Case::new(slanted(a), slanted(-a))?.about(&[(2.0, 0.0, 0.0), (0.0, 1.0, 0.0)]))
        },
    ));
}
