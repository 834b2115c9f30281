//! The two schemes of motions with masses against each other: from event to event, and in steps.
//!
//! The tests compare all coordinates, in the model's unit and in radians, at samples over the whole time. Steps of h
//! must agree to a bound, and steps of ten times h must not: so the bounds can fail, and errors fall with h.

use std::path::Path;

use cspace_motion::{EventKind, Record, Settings, SimulateError, Simulation, Status};

fn prepared(document: cspace_model::Document) -> Simulation {
    match document {
        cspace_model::Document::Model(model) => Simulation::new(&model.mechanism).unwrap(),
        cspace_model::Document::Space(_) => panic!("it is a model"),
    }
}

fn model(text: &str) -> Simulation {
    prepared(cspace_model::read_from(text.as_bytes(), "test.toml").unwrap())
}

fn shipped(name: &str) -> Simulation {
    let path = format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    prepared(cspace_model::read(Path::new(&path)).unwrap())
}

/// Samples at 40 even times.
fn settings(time: f64) -> Settings {
    Settings {
        time,
        every: Some(time / 40.0),
    }
}

fn is_done(record: &Record) {
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
}

/// The largest difference of any coordinate at any sample.
fn difference(a: &Record, b: &Record) -> f64 {
    assert_eq!(a.samples.len(), b.samples.len());
    (a.samples.iter().zip(&b.samples))
        .map(|(s, r)| {
            assert!((s.t - r.t).abs() < 1e-9);
            let each = s.coordinates.iter().zip(&r.coordinates);
            each.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
        })
        .fold(0.0, f64::max)
}

/// Checks that steps of h agree with the event-driven motion to a bound, and that steps ten times as long do not;
/// returns the recordings of the motion and of steps of h.
#[track_caller]
fn agree(simulation: &Simulation, time: f64, h: f64, bound: f64) -> (Record, Record) {
    let settings = settings(time);
    let events = simulation.dynamic(&settings).unwrap();
    is_done(&events);
    let fine = simulation.stepping(&settings, h).unwrap();
    is_done(&fine);
    let coarse = simulation.stepping(&settings, 10.0 * h).unwrap();
    let (small, large) = (difference(&events, &fine), difference(&events, &coarse));
    assert!(small <= bound, "{small:e} is more than {bound:e}");
    assert!(
        large > bound,
        "{large:e} with ten times the step is less than {bound:e}"
    );
    (events, fine)
}

fn impacts(record: &Record) -> Vec<f64> {
    (record.events.iter())
        .filter(|e| e.kind == EventKind::Impact)
        .map(|e| e.t)
        .collect()
}

const BALL: &str = r#"
gravity = [0, -10]
restitution = 0.5
[[part]]
name = "floor"
motion = { type = "fixed" }
loops = [[[-50, -1], [50, -1], [50, 0], [-50, 0]]]
[[part]]
name = "ball"
mass = 1
inertia = 0.4
loops = [[[-1, 2, 1], [1, 2, 1]]]
[[pair]]
fixed = "floor"
moving = "ball"
"#;

/// The first four impacts of a ball, of 1 s² to fall, are at √0.2 times 1, 2, 2.5, 2.75: each scheme has them, that of steps to two of
/// them and no better than a 50th, for three lengths.
#[test]
fn impacts_of_a_ball_converge_with_the_step() {
    let ball = model(BALL);
    let settings = settings(1.3);
    let known: Vec<f64> = [1.0, 2.0, 2.5, 2.75].map(|k| k * f64::sqrt(0.2)).to_vec();
    let exact = impacts(&ball.dynamic(&settings).unwrap());
    for (a, b) in known.iter().zip(&exact) {
        assert!((a - b).abs() < 1e-11, "{a} {b}");
    }
    for h in [3.1e-3, 3.1e-4, 3.1e-5] {
        let record = ball.stepping(&settings, h).unwrap();
        is_done(&record);
        let found = impacts(&record);
        let error = (exact.iter().zip(&found).take(4))
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(error <= 2.0 * h && error > 0.02 * h, "{h}: {error:e}");
        // It overlaps by the way of a step, at most: √20 fast at the first impact.
        assert!(record.open > 0.0 && record.open <= f64::sqrt(20.0) * h);
        // What impacts take: each leaves a quarter. 20 in all from the start to rest; at 1.3 s six are over.
        let energy = record.energy.unwrap();
        assert!(energy.drift.abs() < 1e-9, "{}", energy.drift);
        assert!((energy.impacts - 10.0).abs() < 0.01 + 20.0 * h);
    }
}

/// A block on an incline of 20 degrees.
fn incline(height: f64, friction: f64, restitution: f64) -> Simulation {
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let turned = |x: f64, y: f64| [x * cos + y * sin, y * cos - x * sin];
    let corners = |corners: [(f64, f64); 4]| format!("{:?}", corners.map(|(x, y)| turned(x, y)));
    let plane = corners([(-20.0, -2.0), (20.0, -2.0), (20.0, 0.0), (-20.0, 0.0)]);
    let block = corners([
        (-17.0, height),
        (-13.0, height),
        (-13.0, height + 2.0),
        (-17.0, height + 2.0),
    ]);
    let center = turned(-15.0, height + 1.0);
    model(&format!(
        r#"
gravity = [0, -10]
friction = {friction}
restitution = {restitution}
[[part]]
name = "plane"
motion = {{ type = "fixed" }}
loops = [{plane}]
[[part]]
name = "block"
mass = 1
inertia = 1.7
center_of_mass = {center:?}
loops = [{block}]
[[pair]]
fixed = "plane"
moving = "block"
"#
    ))
}

/// A block slides by s = ½ g (sin α − μ cos α) t², which steps follow exactly, or stays, on two corners neither of
/// which bears more than necessary.
#[test]
fn a_block_slides_and_sticks_on_an_incline() {
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    for (friction, acceleration) in [(0.2, 10.0 * (sin - 0.2 * cos)), (0.5, 0.0)] {
        let simulation = incline(0.0, friction, 0.0);
        let settings = settings(2.0);
        let events = simulation.dynamic(&settings).unwrap();
        for h in [1e-2, 1e-3] {
            let record = simulation.stepping(&settings, h).unwrap();
            is_done(&record);
            assert!(difference(&events, &record) < 1e-9);
            let end = &record.samples.last().unwrap().coordinates;
            let way = 2.0 * acceleration;
            assert!((end[0] - way * cos).abs() < 1e-9 && (end[1] + way * sin).abs() < 1e-9);
            // The forces of the two corners carry it, whatever the share of each.
            let middle = record.samples[20].forces.as_ref().unwrap();
            let normal: f64 = middle.contacts.iter().map(|c| c.normal).sum();
            assert!((normal - 10.0 * cos).abs() < 1e-8, "{normal}");
            // Friction takes what the way down gives and motion does not have.
            let energy = record.energy.unwrap();
            let taken = way * (10.0 * sin - acceleration);
            assert!((energy.friction - taken).abs() < 1e-6 && energy.drift.abs() < 1e-6);
        }
    }
}

/// A block falls onto the incline, bounces from corner to corner, and slides.
#[test]
fn a_block_falls_onto_an_incline() {
    agree(&incline(1.0, 0.3, 0.4), 1.5, 1.5e-5, 4e-4);
}

/// A tall block set down askew rocks on its two corners, which do not slide.
#[test]
fn a_block_rocks() {
    let (sin, cos) = 0.15_f64.sin_cos();
    let turned = |x: f64, y: f64| [x * cos - y * sin, x * sin + y * cos];
    let corners = [(-1.0, 0.0), (1.0, 0.0), (1.0, 6.0), (-1.0, 6.0)].map(|(x, y)| turned(x, y));
    let center = turned(0.0, 3.0);
    let block = model(&format!(
        r#"
gravity = [0, -10]
friction = 1
[[part]]
name = "floor"
motion = {{ type = "fixed" }}
loops = [[[-20, -2], [20, -2], [20, 0], [-20, 0]]]
[[part]]
name = "block"
mass = 1
inertia = 3.3
center_of_mass = {center:?}
start = [0, 0.2, 0]
loops = [{corners:?}]
[[pair]]
fixed = "floor"
moving = "block"
"#
    ));
    agree(&block, 2.0, 1e-4, 4e-4);
}

/// A slider strikes its guide four times with two corners at once, lies on it, and changes sides.
#[test]
fn a_slider_has_clearance() {
    let (events, steps) = agree(&shipped("slider_crank_clearance"), 0.05, 2e-6, 0.015);
    for (a, b) in impacts(&events).iter().zip(impacts(&steps)).take(8) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
}

/// The simulation covers one peck and most of a second.
#[test]
fn a_woodpecker_pecks() {
    agree(&shipped("woodpecker"), 0.2, 2.5e-5, 0.1);
}

/// The first ticks: locks, pushes and drops, in radians.
#[test]
fn an_escapement_ticks() {
    agree(&shipped("escapement_pendulum"), 2.2, 1e-4, 1e-4);
}

/// Gears with backlash, one driven to and fro in its speed, rattle.
#[test]
fn driven_gears_rattle() {
    agree(&shipped("gears_backlash"), 0.5, 2e-5, 1e-4);
}

/// A pusher that is driven at 1.9 strikes a block of 2 kg, which flies ahead, is braked by friction of 6 N, and struck again until it stays.
/// The drive's work is its rate times all the momentum that it gives: 1.9 (2 · 1.9 + 6 (3 − 1/1.9)).
#[test]
fn a_drive_pushes() {
    let pushed = model(
        r#"
gravity = [0, -10]
friction = 0.3
restitution = 0.2
[[part]]
name = "floor"
motion = { type = "fixed" }
loops = [[[-20, -2], [20, -2], [20, 0], [-20, 0]]]
[[part]]
name = "pusher"
motion = { type = "prismatic", direction = [1, 0] }
mass = 1
loops = [[[-4, 0.5], [-2, 0.5], [-2, 1.5], [-4, 1.5]]]
[[part]]
name = "block"
mass = 2
inertia = 1.3
center_of_mass = [0, 1]
loops = [[[-1, 0], [1, 0], [1, 2], [-1, 2]]]
[[pair]]
fixed = "floor"
moving = "block"
[[pair]]
fixed = "pusher"
moving = "block"
friction = 0
[[drive]]
part = "pusher"
rate = 1.9
"#,
    );
    let (events, steps) = agree(&pushed, 3.0, 3.3e-5, 2e-4);
    let work = 1.9 * (3.8 + 6.0 * (3.0 - 1.0 / 1.9));
    for (record, bound) in [(events, 1e-5), (steps, 1e-2)] {
        let error = record.energy.unwrap().drives - work;
        assert!(error.abs() < bound, "{error:e}");
    }
}

/// A block slides into the corner of a floor and a wall, where one of its vertices has two contacts; a triangle falls
/// onto a convex corner where either of two contacts suffices.
#[test]
fn corners_are_met() {
    let scene = |floor: &str, loops: &str, center: [f64; 2], more: &str| {
        model(&format!(
            r#"
gravity = [0, -10]
friction = 0.2
restitution = 0.3
[[part]]
name = "floor"
motion = {{ type = "fixed" }}
loops = [{floor}]
[[part]]
name = "block"
mass = 1
inertia = 0.7
center_of_mass = {center:?}
loops = [{loops}]
{more}
[[pair]]
fixed = "floor"
moving = "block"
"#
        ))
    };
    let floor = "[[-10, -2], [10, -2], [10, 8], [8, 8], [8, 0], [-10, 0]]";
    let block = "[[-1, 1], [1, 1], [1, 3], [-1, 3]]";
    let into = scene(floor, block, [0.0, 2.0], "rate = [6, 0, 0]");
    agree(&into, 2.0, 6e-5, 9e-4);
    let ledge = "[[-10, -4], [0, -4], [0, 0], [-10, 0]]";
    let triangle = "[[-0.3, 1], [1.5, 3.2], [-1.5, 3.5]]";
    let onto = scene(ledge, triangle, [-0.1, 2.5], "");
    agree(&onto, 1.2, 3.6e-5, 9e-4);
}

#[test]
fn steps_make_sense() {
    let ball = model(BALL);
    let settings = settings(1.0);
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = ball.stepping(&settings, step);
        assert!(matches!(
            refused,
            Err(SimulateError::Time {
                what: "the step",
                ..
            })
        ));
    }
    let refused = ball.stepping(&settings, 1e-12);
    assert!(matches!(refused, Err(SimulateError::TooManySteps { .. })));
    // A step longer than the time is one step.
    is_done(&ball.stepping(&settings, 5.0).unwrap());
}

/// An arm that turns a quarter in two steps comes through a post, which no step sees.
#[test]
fn steps_in_which_parts_come_through_each_other_are_refused() {
    let arm = model(
        r#"
[[part]]
name = "post"
motion = { type = "fixed" }
loops = [{ circle = 1, at = [0, 15] }]
[[part]]
name = "arm"
motion = { type = "revolute", center = [0, 0] }
mass = 1
loops = [[[-1, -1], [20, -1], [20, 1], [-1, 1]]]
[[drive]]
part = "arm"
rate = "360deg"
"#,
    );
    let coarse = arm.stepping(&settings(0.25), 0.125).unwrap();
    assert_eq!(coarse.status, Status::Undetermined);
    assert!(coarse.reason.unwrap().contains("shorter steps"));
    // The arm's upper side meets the post where 15 cos φ = 2, φ from the vertical.
    let fine = arm.stepping(&settings(0.25), 1e-4).unwrap();
    assert_eq!(fine.status, Status::Jammed);
    let known = (90.0 - 2.0_f64.atan2((225.0_f64 - 4.0).sqrt()).to_degrees()) / 360.0;
    assert!((fine.until - known).abs() < 2e-3, "{} {known}", fine.until);
}
