//! The backlash of involute gears beside the formula of gearing, over a turn, at several distances of their axes.

use core::f64::consts::PI;

use cspace::{Part, Point, Silent, Vector, Vertex};
use cspace_model::{PartEntry, compute_anew};
use cspace_oracle::effort;
use cspace_oracle::shapes::pen::{bulge_of, bulge_through, polar};
use cspace_plan::ranges::{Backlash, Pair, Verdict};

/// The angle of pressure where standard gears mesh without backlash.
const PRESSURE: f64 = 20.0 * PI / 180.0;
/// Teeth of the gear that is held and of the other one.
const TEETH: [usize; 2] = [24, 30];

fn involute(pressure: f64) -> f64 {
    pressure.tan() - pressure
}

/// A gear of module 1 about a point, its first tooth at an angle, every flank of it some arcs through points of the involute; and how far
/// these are from it.
fn gear(name: &str, teeth: usize, (center, turn): (Point, f64), arcs: usize) -> (Part, f64) {
    let pitch = 0.5 * teeth as f64;
    let (tip, root, base) = (pitch + 1.0, pitch - 1.25, pitch * PRESSURE.cos());
    let step = 2.0 * PI / teeth as f64;
    // By the angle through which the line that unrolls has turned. The flank begins inside of what the mate touches.
    let (first, last) = (0.11_f64, ((tip / base).powi(2) - 1.0).sqrt());
    let middle = 0.25 * step + involute(PRESSURE);
    // The flank that is met first, counter-clockwise, about a tooth on the x axis.
    let flank = |roll: f64| {
        polar(
            Point::ORIGIN,
            base * roll.hypot(1.0),
            roll - roll.atan() - middle,
        )
    };
    let at = |share: f64| flank(first + (last - first) * share);
    let mut off = 0.0_f64;
    let foot = at(0.0);
    let foot_angle = foot.y.atan2(foot.x);
    let below = polar(Point::ORIGIN, root, foot_angle);
    let mut tooth = vec![Vertex::line(below.x, below.y)];
    for k in 0..arcs {
        let share = |part: f64| at((k as f64 + part) / arcs as f64);
        let (from, by, to) = (share(0.0), share(0.5), share(1.0));
        let bulge = bulge_through(from, by, to);
        tooth.push(Vertex::new(from.x, from.y, bulge));
        let edge = cspace::part::Edge::between(from, to, bulge);
        for part in [0.2, 0.8] {
            let away = share(part).distance(edge.center()) - edge.radius();
            off = off.max(away.abs());
        }
    }
    let top = at(1.0);
    let top_angle = top.y.atan2(top.x);
    tooth.push(Vertex::new(top.x, top.y, bulge_of(-2.0 * top_angle)));
    // The other flank is the mirror image, passed the other way.
    let mut back: Vec<Vertex> = Vec::new();
    for (k, v) in tooth.iter().enumerate().rev() {
        let bulge = match k {
            0 => bulge_of(step + 2.0 * foot_angle),
            _ => tooth[k - 1].bulge,
        };
        back.push(Vertex::new(v.x, -v.y, bulge));
    }
    tooth.extend(back);
    let outline = (0..teeth).flat_map(|i| {
        let by = cspace::geometry::Rotation::by(turn + step * i as f64);
        tooth.iter().map(move |v| {
            let p = center + by * Vector::new(v.x, v.y);
            Vertex::new(p.x, p.y, v.bulge)
        })
    });
    (Part::new(name, vec![outline.collect()]).unwrap(), off)
}

/// The backlash of two gears whose axes are farther apart than where they have none, and how far their flanks are from involutes.
fn found(more: f64, arcs: usize) -> (Backlash, f64) {
    let distance = 0.5 * (TEETH[0] + TEETH[1]) as f64 + more;
    let center = Point::new(distance, 0.0);
    let (gear_part, off) = gear("gear", TEETH[0], (Point::ORIGIN, 0.0), arcs);
    // A tooth of the one is where the other has a gap.
    let turned = PI + PI / TEETH[1] as f64;
    let (mate, mate_off) = gear("mate", TEETH[1], (center, turned), arcs);
    let fixed = PartEntry::revolute(gear_part, (0.0, 0.0));
    let moving = PartEntry::revolute(mate, (distance, 0.0));
    let pair = Pair::new([&fixed, &moving], [0.0, 0.0]).unwrap();
    let verdict = pair.over_ranges(f64::INFINITY, &compute_anew(&Silent));
    let Verdict::Touches(held) = verdict.unwrap() else {
        panic!("gears {more} apart do not touch");
    };
    assert_eq!(held.ratio, Some((-4, 5)));
    (held.backlash.unwrap(), off + mate_off)
}

/// With one gear held the other turns by 2 a′ (inv α′ − inv α) along the pitch circle of its mesh, whose radius is a′ z / (z₁ + z₂), where
/// a′ cos α′ = a cos α: the same all around.
fn by_formula(more: f64) -> f64 {
    let teeth = (TEETH[0] + TEETH[1]) as f64;
    let distance = 0.5 * teeth;
    let apart = distance + more;
    let pressure = (distance * PRESSURE.cos() / apart).acos();
    let along = 2.0 * apart * (involute(pressure) - involute(PRESSURE));
    along * teeth / (apart * TEETH[1] as f64)
}

/// Both ends of the play are off by no more than the flanks are, at the radius at which the common normal passes the axis.
#[test]
fn the_backlash_of_involutes() {
    let base = 0.5 * TEETH[1] as f64 * PRESSURE.cos();
    for arcs in [4, effort(12, 128)] {
        for more in [0.05, 0.2, 0.5] {
            let (play, off) = found(more, arcs);
            let formula = by_formula(more);
            let most = 2.0 * off / base + 2e-9;
            println!(
                "{arcs} arcs, {more}: {:e} {:e} of {most:e}",
                play.least - formula,
                play.most - formula
            );
            assert!(
                (play.least - formula).abs() < most,
                "{arcs} {more} {play:?}"
            );
            assert!((play.most - formula).abs() < most, "{arcs} {more} {play:?}");
        }
    }
}
