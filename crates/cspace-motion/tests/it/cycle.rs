//! Linkages over a cycle of their drives, beside closed forms and brute force.

use std::f64::consts::{PI, TAU};

use cspace::pair::Joint;
use cspace::{Part, Point};
use cspace_model::{Drive, DriveMotion, JointEntry, Mechanism, PartEntry};
use cspace_motion::cycle::{Cycles, Halt, NoCycle};
use cspace_plan::clash::{Assembly, Passage, Question, State};

/// Poses of brute force.
const POSES: u32 = 100_000;

/// A four-bar: ground pivots, the lengths of crank, coupler and rocker, and the angle of the crank at the start.
struct FourBar {
    pivots: [Point; 2],
    lengths: [f64; 3],
    start: f64,
}

impl FourBar {
    /// The ends of the coupler, by the law of cosines; the rocker is to the left of the line from the crank to its pivot if `side` is 1.
    fn ends(&self, crank: f64, side: f64) -> Option<[Point; 2]> {
        let [a, b, c] = self.lengths;
        let p = Point::new(
            self.pivots[0].x + a * crank.cos(),
            self.pivots[0].y + a * crank.sin(),
        );
        let (dx, dy) = (self.pivots[1].x - p.x, self.pivots[1].y - p.y);
        let d = dx.hypot(dy);
        let cos = (b * b + d * d - c * c) / (2.0 * b * d);
        if cos.abs() > 1.0 {
            return None;
        }
        let angle = dy.atan2(dx) + side * cos.acos();
        Some([p, Point::new(p.x + b * angle.cos(), p.y + b * angle.sin())])
    }

    /// Crank, coupler with a disc of radius 0.2 around a point of its frame, rocker, and a fixed disc. Each part is a small disc, so that
    /// nothing but the coupler and the post are near each other.
    fn model(&self, tracer: [f64; 2], post: [f64; 2], radius: f64) -> Mechanism {
        let [p, r] = self.ends(self.start, 1.0).unwrap();
        let mut model = Mechanism::new("four-bar");
        let disc = |name: &str, at: [f64; 2], r: f64| Part::circle(name, at, r).unwrap();
        let [o, m] = self.pivots;
        (model.parts).push(PartEntry::revolute(disc("crank", [o.x, o.y], 0.1), o));
        let (dx, dy) = (r.x - p.x, r.y - p.y);
        let l = dx.hypot(dy);
        let (ux, uy) = (dx / l, dy / l);
        let at = [
            p.x + ux * tracer[0] - uy * tracer[1],
            p.y + uy * tracer[0] + ux * tracer[1],
        ];
        model
            .parts
            .push(PartEntry::planar(disc("coupler", at, 0.2)));
        (model.parts).push(PartEntry::revolute(disc("rocker", [m.x, m.y], 0.1), m));
        model
            .parts
            .push(PartEntry::fixed(disc("post", post, radius)));
        for (parts, at) in [((0, 1), p), ((1, 2), r)] {
            let joint = Joint::Revolute { at };
            model.joints.push(JointEntry { joint, parts });
        }
        let motion = DriveMotion::Rate(TAU);
        model.dynamics.drives.push(Drive { part: 0, motion });
        model
    }

    /// The distance of the tracer's disc from the post, at an angle of the crank.
    fn gap(&self, crank: f64, tracer: [f64; 2], post: [f64; 2], radius: f64) -> Option<f64> {
        let [p, r] = self.ends(crank, 1.0)?;
        let l = self.lengths[1];
        let (ux, uy) = ((r.x - p.x) / l, (r.y - p.y) / l);
        let at = [
            p.x + ux * tracer[0] - uy * tracer[1],
            p.y + uy * tracer[0] + ux * tracer[1],
        ];
        Some((at[0] - post[0]).hypot(at[1] - post[1]) - 0.2 - radius)
    }
}

fn passage(model: &Mechanism, pair: [usize; 2]) -> (Passage, f64, Option<Halt>) {
    let mut cycles = Cycles::of(model).unwrap();
    assert!(cycles.has(pair));
    let mut cycle = cycles.pair(pair).unwrap();
    let found = Assembly::new(model).over(pair, &mut cycle, &Question::default());
    (found.unwrap(), cycle.reached, cycle.halt)
}

fn grashof() -> FourBar {
    FourBar {
        pivots: [Point::new(0.0, 0.0), Point::new(7.0, 0.0)],
        lengths: [2.0, 6.0, 5.0],
        start: 1.0,
    }
}

#[test]
fn a_four_bar_is_as_near_as_brute_force_finds_it() {
    let bar = grashof();
    let (tracer, post, radius) = ([3.0, 2.5], [4.5, 6.4], 0.5);
    let (found, reached, halt) = passage(&bar.model(tracer, post, radius), [1, 3]);
    assert_eq!((found.clash.state, halt), (State::Clear, None));
    assert!((reached - 1.0).abs() < 1e-15);
    let (gap, time) = (found.clash.gap.unwrap(), found.clash.time.unwrap());
    let at = |t: f64| bar.gap(bar.start + TAU * t, tracer, post, radius).unwrap();
    let least = (0..POSES)
        .map(|i| at(f64::from(i) / f64::from(POSES)))
        .fold(f64::INFINITY, f64::min);
    assert!(gap <= least + 1e-12, "{gap} {least}");
    assert!(least - gap < 1e-6, "{gap} {least}");
    assert!((at(time) - gap).abs() < 1e-9, "{} {gap}", at(time));
    assert!(
        gap - found.least < 1e-9 * gap.max(1.0),
        "{} {gap}",
        found.least
    );
}

#[test]
fn links_of_one_linkage_are_looked_at_together() {
    let bar = grashof();
    let mut model = bar.model([3.0, 2.5], [4.5, 20.0], 0.5);
    // A disc of the crank off its pivot, and one of the rocker.
    let [p, r] = bar.ends(bar.start, 1.0).unwrap();
    model.parts[0].part = Part::circle("crank", [0.5 * p.x, 0.5 * p.y], 0.1).unwrap();
    let on_rocker = [0.5 * (7.0 + r.x), 0.5 * r.y];
    model.parts[2].part = Part::circle("rocker", on_rocker, 0.1).unwrap();
    let (found, ..) = passage(&model, [0, 2]);
    let at = |t: f64| {
        let [p, r] = bar.ends(bar.start + TAU * t, 1.0).unwrap();
        (0.5 * p.x - 0.5 * (7.0 + r.x)).hypot(0.5 * (p.y - r.y)) - 0.2
    };
    let least = (0..POSES)
        .map(|i| at(f64::from(i) / f64::from(POSES)))
        .fold(f64::INFINITY, f64::min);
    let gap = found.clash.gap.unwrap();
    assert!(gap <= least + 1e-12 && least - gap < 1e-6, "{gap} {least}");
    assert!((at(found.clash.time.unwrap()) - gap).abs() < 1e-9);
}

#[test]
fn a_slider_comes_as_near_as_its_crank_and_rod_are_long() {
    // A crank of 1, a rod of 3, a block from 3.5 to 4.5 that is drawn at its end; a wall at 4.6.
    let mut model = Mechanism::new("slider and crank");
    let bar =
        |name: &str, x: f64, l: f64| Part::rectangle(name, (x + 0.5 * l, 0.0), l, 0.2).unwrap();
    let (sin, cos) = 2.0_f64.sin_cos();
    let block = cos + (9.0 - sin * sin).sqrt();
    model
        .parts
        .push(PartEntry::revolute(bar("crank", -0.1, 0.2), Point::ORIGIN));
    model.parts.push(PartEntry::planar(
        Part::circle("rod", [cos, sin], 0.1).unwrap(),
    ));
    (model.parts).push(PartEntry::prismatic(
        bar("slider", block - 0.5, 1.0),
        (1.0, 0.0),
    ));
    model.parts.push(PartEntry::fixed(bar("wall", 4.6, 1.0)));
    for (parts, [x, y]) in [((0, 1), [cos, sin]), ((1, 2), [block, 0.0])] {
        let joint = Joint::Revolute {
            at: Point::new(x, y),
        };
        model.joints.push(JointEntry { joint, parts });
    }
    model.dynamics.drives.push(Drive {
        part: 0,
        motion: DriveMotion::Rate(-2.0),
    });
    let (found, reached, _) = passage(&model, [2, 3]);
    assert!((reached - PI).abs() < 1e-12);
    assert!((found.clash.gap.unwrap() - 0.1).abs() < 1e-12);
    // The crank is drawn at 2 rad, and turns backwards.
    assert!((found.clash.time.unwrap() - 1.0).abs() < 1e-6);
}

#[test]
fn a_spike_narrower_than_any_sampling_is_found() {
    let bar = grashof();
    let tracer = [3.0, 2.5];
    // A point post that the tracer's disc all but touches at one angle, and leaves fast.
    let there = 4.123_456_789;
    let at = |t: f64| {
        let [p, r] = bar.ends(t, 1.0).unwrap();
        let (ux, uy) = ((r.x - p.x) / 6.0, (r.y - p.y) / 6.0);
        [p.x + ux * 3.0 - uy * 2.5, p.y + uy * 3.0 + ux * 2.5]
    };
    let [a, b] = [at(there - 1e-7), at(there + 1e-7)];
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let l = dx.hypot(dy);
    let away = 0.2 + 1e-3 + 1e-6;
    let post = [at(there)[0] - dy / l * away, at(there)[1] + dx / l * away];
    let (found, ..) = passage(&bar.model(tracer, post, 1e-3), [1, 3]);
    let gap = found.clash.gap.unwrap();
    assert!((gap - 1e-6).abs() < 1e-9, "{gap} {:?}", found.clash);
    assert!((bar.start + TAU * found.clash.time.unwrap() - there).abs() < 1e-3);
}

#[test]
fn a_collision_is_told_where_it_begins() {
    let bar = grashof();
    let (tracer, radius) = ([3.0, 2.5], 0.5);
    // The post stands where the tracer is a third of a turn later.
    let [p, r] = bar.ends(bar.start + TAU / 3.0, 1.0).unwrap();
    let (ux, uy) = ((r.x - p.x) / 6.0, (r.y - p.y) / 6.0);
    let post = [p.x + ux * 3.0 - uy * 2.5, p.y + uy * 3.0 + ux * 2.5];
    let (found, ..) = passage(&bar.model(tracer, post, radius), [1, 3]);
    assert_eq!(found.clash.state, State::Overlap);
    let gap = |t: f64| bar.gap(bar.start + TAU * t, tracer, post, radius).unwrap();
    let first = (0..POSES)
        .map(|i| f64::from(i) / f64::from(POSES))
        .find(|&t| gap(t) <= 0.0)
        .unwrap();
    let time = found.clash.time.unwrap();
    assert!(gap(time).abs() < 1e-9, "{}", gap(time));
    assert!(time <= first && first - time < 2.0 / f64::from(POSES));
}

#[test]
fn what_cannot_turn_round_stops_at_its_dead_point() {
    let bar = FourBar {
        pivots: [Point::new(0.0, 0.0), Point::new(7.0, 0.0)],
        lengths: [5.0, 4.0, 4.0],
        start: 0.5,
    };
    let (found, reached, halt) = passage(&bar.model([2.0, 1.0], [3.0, 9.0], 0.5), [1, 3]);
    assert_eq!(halt, Some(Halt::DeadPoint));
    // Coupler and rocker are in line: 25 + 49 - 70 cos = 64.
    let dead = (10.0_f64 / 70.0).acos();
    assert!((bar.start + TAU * reached - dead).abs() < 1e-9);
    let least = (0..POSES)
        .filter_map(|i| {
            let t = reached * f64::from(i) / f64::from(POSES);
            bar.gap(bar.start + TAU * t, [2.0, 1.0], [3.0, 9.0], 0.5)
        })
        .fold(f64::INFINITY, f64::min);
    assert!(found.clash.gap.unwrap() <= least + 1e-12);
}

#[test]
fn drives_without_a_cycle_are_told() {
    let bar = grashof();
    let mut model = bar.model([3.0, 2.5], [4.5, 20.0], 0.5);
    model.dynamics.drives[0].motion = DriveMotion::Rate(0.0);
    let mut cycles = Cycles::of(&model).unwrap();
    assert_eq!(cycles.pair([1, 3]).unwrap_err(), NoCycle::Still);
    model.parts[3] = PartEntry::revolute(
        Part::circle("post", [4.5, 20.0], 0.5).unwrap(),
        Point::ORIGIN,
    );
    model.dynamics.drives[0].motion = DriveMotion::Rate(1.0);
    let motion = DriveMotion::Rate(2.0_f64.sqrt());
    model.dynamics.drives.push(Drive { part: 3, motion });
    let mut cycles = Cycles::of(&model).unwrap();
    assert_eq!(
        cycles.pair([1, 3]).unwrap_err(),
        NoCycle::Incommensurable([0, 3])
    );
    model.dynamics.drives[1].motion = DriveMotion::Rate(-1.5);
    let mut cycles = Cycles::of(&model).unwrap();
    let cycle = cycles.pair([1, 3]).unwrap();
    assert_eq!(cycle.span.turns, [(0, 2), (3, 3)]);
    assert!((cycle.reached - 2.0 * TAU).abs() < 1e-12);
}
