//! A tongue that reaches around more than half a turn, in a groove that leaves as much room inside as outside.

use core::f64::consts::PI;

use super::*;
use crate::part::{Part, Vertex};

/// From the outer radius to the inner one, and to an angle on both sides of the x-axis, each circle in two arcs.
fn sector(inner: f64, outer: f64, half: f64) -> Vec<Vertex> {
    let bulge = (0.25 * half).tan();
    let at = |r: f64, a: f64, bulge: f64| Vertex::new(r * a.cos(), r * a.sin(), bulge);
    vec![
        at(outer, -half, bulge),
        at(outer, 0.0, bulge),
        at(outer, half, 0.0),
        at(inner, half, -bulge),
        at(inner, 0.0, -bulge),
        at(inner, -half, 0.0),
    ]
}

/// Wherever two curves lie on each other, it is told, and nowhere else.
#[test]
fn curves_that_lie_on_each_other_are_known() {
    let block = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)];
    let block = block.map(|(x, y)| Vertex::line(x, y)).to_vec();
    let fixed = Part::new("groove", vec![block, sector(0.65, 1.05, 2.6)]).unwrap();
    let moving = Part::new("tongue", vec![sector(0.7, 1.0, 2.4)]).unwrap();
    let geometry = Geometry::new(&fixed, &moving, None, usize::MAX);
    let contacts = &geometry.contacts;
    let coincidences = Coincidences::new(&geometry);
    let all = coincidences.0.as_ref().unwrap();
    assert!(!all.is_empty());
    let sheets = &contacts.sheets;
    let mut both = 0;
    for k in 0..500 {
        let theta = contacts.span.lo + (f64::from(k) + 0.37) * (2.0 * PI / 500.0);
        let live = |s: usize| sheets[s].lo < theta && theta < sheets[s].hi;
        let circles: Vec<usize> = (0..sheets.len())
            .filter(|&s| sheets[s].is_circle() && live(s))
            .collect();
        for &i in &circles {
            for &j in circles.iter().filter(|&&j| j != i) {
                let (f, g) = (&sheets[i], &sheets[j]);
                if !f.always_tangent(g) || f.locus.radius * g.locus.radius < 0.0 {
                    continue;
                }
                // Of many places of one, some are on the other.
                let ends = (f.start_angle.at(theta), f.end_angle.at(theta));
                let (a, b) = (g.start_angle.at(theta), g.end_angle.at(theta));
                let on = (1..200).any(|n| {
                    let at = ends.0 + (ends.1 - ends.0) * f64::from(n) / 200.0;
                    let off = at - 0.5 * (a + b);
                    let off = off - 2.0 * PI * (off / (2.0 * PI)).round();
                    off.abs() < 0.5 * (a - b).abs() - 1e-9
                });
                let told = all.iter().any(|d| {
                    let pair = (d.first as usize, d.second as usize);
                    (pair == (i, j) || pair == (j, i)) && d.lo <= theta && theta <= d.hi
                });
                assert!(told || !on, "{theta}: {i} {j}");
                both += usize::from(told);
            }
        }
    }
    assert!(both > 100, "{both}");
    for d in all {
        let (f, g) = (&sheets[d.first as usize], &sheets[d.second as usize]);
        assert!(f.same_circle(g) && d.lo < d.hi);
        assert!(d.lo >= f.lo.max(g.lo) && d.hi <= f.hi.min(g.hi));
    }
}
