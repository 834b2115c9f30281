//! Fits whose clearance goes to nothing.

use super::outline::*;
use super::{Case, Family, family, powers, vanishing};

pub(super) fn add(all: &mut Vec<Family>) {
    all.push(family("peg in a slot, clearance", vanishing(), |c| {
        let (h, d) = (0.5 * (1.0 + c), 2.0);
        let block = vec![vec![
            line(-2.0, -4.0),
            line(2.0, -4.0),
            line(2.0, 0.0),
            line(h, 0.0),
            line(h, -d),
            line(-h, -d),
            line(-h, 0.0),
            line(-2.0, 0.0),
        ]];
        let peg = shifted(&rectangle(1.0, 3.0), 0.0, -1.5);
        Ok(Case::new(block, peg)?.about(&[(0.0, 1.5, 0.0), (0.0, 1.0, 0.0)]))
    }));
    all.push(family("disc in a hole, clearance", vanishing(), |c| {
        Ok(Case::new(plate(4.0, disc(1.0 + c)), disc(1.0))?.about(&[(0.0, 0.0, 0.0)]))
    }));
    all.push(family(
        "hexagon in a hexagonal hole, clearance",
        vanishing(),
        |c| {
            Ok(Case::new(plate(4.0, polygon(6, 1.0 + c)), polygon(6, 1.0))?
                .about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(family(
        "rounded peg between two bars, clearance",
        vanishing(),
        |c| {
            let bar = rectangle(8.0, 1.0);
            let y = 0.5 * (1.0 + 2.0 + c);
            let mut bars = shifted(&bar, 0.0, y);
            bars.extend(shifted(&bar, 0.0, -y));
            Ok(
                Case::new(bars, rounded(3.0, 2.0, 0.25))?
                    .about(&[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]),
            )
        },
    ));
    all.push(family(
        "three pegs in three holes, clearance",
        vanishing(),
        |c| {
            let row = |r: f64| -> Loops { [-1.0, 0.0, 1.0].map(|x| disc_at(x, 0.0, r)).to_vec() };
            let mut holes = rectangle(4.0, 2.0);
            holes.extend(row(0.3 + c));
            let pi = core::f64::consts::PI;
            Ok(Case::new(holes, row(0.3))?.about(&[(0.0, 0.0, 0.0), (0.0, 0.0, pi)]))
        },
    ));
    let both = powers(-1, -15).into_iter().flat_map(|c| [c, -c]);
    all.push(family("disc through a neck, play", both, |c| {
        let y = 0.5 * (1.0 + 1.0 + c);
        let mut posts = vec![disc_at(0.0, y, 0.5)];
        posts.extend(shifted(&rectangle(1.0, 1.0), 0.0, -y));
        Ok(Case::new(posts, disc(0.5))?.about(&[(0.0, 0.0, 0.0)]))
    }));
}
