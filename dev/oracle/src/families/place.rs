//! Parts drawn far from their origins, and of very different size.

use super::outline::*;
use super::{Case, Family, family, powers};

pub(super) fn add(all: &mut Vec<Family>) {
    all.push(family(
        "squares, the fixed one drawn far away",
        powers(1, 9),
        |d| {
            Ok(
                Case::new(shifted(&rectangle(2.0, 2.0), d, -d), rectangle(1.0, 0.5))?
                    .about(&[(d, -d, 0.0)]),
            )
        },
    ));
    all.push(family(
        "rounded peg and hole, both drawn far away",
        powers(1, 9),
        |d| {
            let hole = shifted(&plate(4.0, rounded(2.1, 1.1, 0.25)), d, 0.0);
            let peg = shifted(&rounded(2.0, 1.0, 0.25), -d, d);
            Ok(Case::new(hole, peg)?.about(&[(2.0 * d, -d, 0.0)]))
        },
    ));
    all.push(family(
        "peg and hole, drawn in another unit",
        powers(-9, 9),
        |s| {
            let hole = plate(4.0, rounded(2.1, 1.1, 0.25));
            Ok(
                Case::new(scaled(&hole, s), scaled(&rounded(2.0, 1.0, 0.25), s))?
                    .about(&[(0.0, 0.0, 0.0)]),
            )
        },
    ));
    all.push(family(
        "plate with a hole and a smaller part, ratio",
        powers(0, -9),
        |s| {
            let hole = plate(4.0, rounded(2.0, 1.0, 0.25));
            Ok(
                Case::new(hole, scaled(&rounded(0.8, 0.6, 0.1), s))?.about(&[
                    (0.0, 0.0, 0.0),
                    (1.0 - 0.3 * s, 0.0, 0.0),
                    (2.0, 2.0, 0.0),
                ]),
            )
        },
    ));
    all.push(family(
        "small part and a larger one around it, ratio",
        powers(0, 9),
        |s| {
            let hole = plate(4.0, rounded(2.0, 1.0, 0.25));
            Ok(Case::new(rounded(0.8, 0.6, 0.1), scaled(&hole, s))?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
}
