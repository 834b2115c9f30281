//! Mechanisms whose motion is known in closed form, with rates and accelerations.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, SQRT_2, TAU};

use cspace::{Part, Vertex};
use cspace_model::{Drive, DriveMotion, Mechanism, PartEntry, PartPosition};
use cspace_motion::{EventKind, Record, Status};

use crate::motion::helpers::{at, mechanism, model, run};

/// The pin's radius, for a crank of 1.
const PIN: f64 = 0.1;
/// Initial angle of the driver: 25 degrees before the pin enters.
const BEGINS: f64 = -70.0 * TAU / 360.0;

/// A Geneva drive of 4 slots without play where it drives: the face that is pushed lies as far from the slot's middle, which goes
/// through the wheel's axis, as the pin is thick, and begins where the pin comes in.
fn geneva() -> Mechanism {
    let mut outline = Vec::new();
    for k in 0..4 {
        let (sin, cos) = (5.0 * FRAC_PI_4 + f64::from(k) * FRAC_PI_2).sin_cos();
        // Along the slot, and to the left of it.
        let corners = [(1.0, -PIN), (0.2, -PIN), (0.2, 2.0 * PIN), (1.0, 2.0 * PIN)];
        for (s, n) in corners {
            outline.push(Vertex::line(SQRT_2 + cos * s - sin * n, sin * s + cos * n));
        }
    }
    let wheel = Part::new("wheel", vec![outline]).unwrap();
    let pin = Part::circle("pin", (1.0, 0.0), PIN).unwrap();
    let parts = vec![
        PartEntry::revolute(pin, (0.0, 0.0)),
        PartEntry::revolute(wheel, (SQRT_2, 0.0)),
    ];
    let mut geneva = mechanism(parts);
    geneva.dynamics.part_mut(0).start = Some(PartPosition::Axis(BEGINS));
    let motion = DriveMotion::Rate(1.0);
    geneva.dynamics.drives.push(Drive { part: 0, motion });
    geneva
}

/// Angle of the wheel from half step, its rate and its acceleration, at an angle of the driver from there.
fn step(alpha: f64) -> [f64; 3] {
    let (sin, cos) = alpha.sin_cos();
    let square = 3.0 - 2.0 * SQRT_2 * cos;
    [
        (sin / (SQRT_2 - cos)).atan(),
        (SQRT_2 * cos - 1.0) / square,
        -SQRT_2 * sin / (square * square),
    ]
}

/// The derivative of the rate of a coordinate by five samples beside a middle one: exact for polynomials of degree four.
fn acceleration(record: &Record, middle: usize, part: usize, every: f64) -> f64 {
    let rate = |k: usize| record.samples[middle + k - 2].rates[part];
    (rate(0) - 8.0 * rate(1) + 8.0 * rate(3) - rate(4)) / (12.0 * every)
}

/// Four slots: peak ratio 1 / (√2 − 1) = 2.414214, acceleration 1 ω² as the pin comes in and 5.406981 ω² at its peak.
#[test]
fn a_geneva_wheel_of_four_slots() {
    // The pin comes in at a sample.
    let before = 800;
    let every = (-FRAC_PI_4 - BEGINS) / before as f64;
    let (_, record) = run(&geneva(), TAU + 2.2, every);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let (mut fastest, mut largest) = (0.0_f64, 0.0_f64);
    for (i, sample) in record.samples.iter().enumerate() {
        let alpha = BEGINS + sample.t;
        let turns = ((alpha + TAU / 2.0) / TAU).floor();
        let from_half = alpha - turns * TAU;
        let [angle, rate, bends] = step(from_half.clamp(-FRAC_PI_4, FRAC_PI_4));
        let known = -(angle + FRAC_PI_4) - turns * FRAC_PI_2;
        let error = (sample.coordinates[1] - known).abs();
        assert!(error < 1e-10, "{from_half}: {error:e}");
        // Where the pin comes and goes the rate has a corner.
        if from_half.abs() > FRAC_PI_4 - 3.0 * every {
            continue;
        }
        let error = (sample.rates[1] + rate).abs();
        assert!(error < 1e-10, "{from_half}: {error:e}");
        fastest = fastest.max(-sample.rates[1]);
        let found = acceleration(&record, i, 1, every);
        assert!((found + bends).abs() < 1e-6, "{from_half}: {found} {bends}");
        largest = largest.max(found.abs());
    }
    assert!((fastest - 2.414_214).abs() < 1e-6, "{fastest}");
    assert!((largest - 5.406_981).abs() < 1e-5, "{largest}");
    // At rest until the pin comes in; the derivative from there on by five samples.
    let rate = |k: usize| -record.samples[before + k].rates[1];
    assert!(record.samples[..before].iter().all(|s| s.rates[1] == 0.0));
    let weights = [-25.0, 48.0, -36.0, 16.0, -3.0];
    let entry: f64 = (weights.iter().enumerate())
        .map(|(k, w)| w * rate(k) / (12.0 * every))
        .sum();
    assert!((entry - 1.0).abs() < 1e-6, "{entry}");
    // The face ends at the rim: the touch is told where the pin has come in, but for what rounding makes of a tangent.
    let touch = &record.events[0];
    assert_eq!(touch.kind, EventKind::Touch);
    let late = touch.t - every * before as f64;
    assert!(late.abs() < 1e-4, "{late:e}");
}

/// Twelve teeth drive ten: from tooth to tooth the ratio is 12/10 to rounding, wherever in the mesh one begins.
#[test]
fn gears_turn_from_tooth_to_tooth() {
    let tooth = 1.0 / 12.0;
    let (_, record) = run(&model("gears_on_shafts"), 2.0, tooth / 16.0);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let samples = &record.samples;
    for i in 16..samples.len() - 16 {
        let (from, to) = (&samples[i], &samples[i + 16]);
        let turned = [0, 1].map(|k| to.coordinates[k] - from.coordinates[k]);
        let error = (turned[1] / turned[0] + 1.2).abs();
        assert!(error < 1e-12, "{}: {error:e}", from.t);
    }
}

/// The claw takes the film on by a hole a turn, and leaves it alone for more than half of it.
#[test]
fn a_film_advances_by_its_pitch() {
    let (_, record) = run(&model("film_advance"), 4.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let film = |t: f64| at(&record, t)[0];
    for t in [1.0, 1.2, 1.45, 1.6, 2.0, 2.5, 2.9] {
        let step = film(t + 1.0) - film(t);
        assert!((step - 7.62).abs() < 1e-9, "{t}: {step}");
    }
    let still = (record.samples.iter())
        .filter(|s| (1.0..2.0).contains(&s.t) && s.rates[0] == 0.0)
        .count();
    assert!(still > 60, "{still}");
}

/// On the base circle and on the dwell of the cam the roller stands still; in between it falls and rises by the lift.
#[test]
fn a_roller_falls_and_rises_by_the_lift() {
    let (simulation, record) = run(&model("cam_roller"), 2.0, 0.005);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let stem = simulation.system().parts()[2].indices().start;
    let lifts = || (record.samples.iter().skip(1)).map(|s| s.coordinates[stem]);
    let (least, most) = (
        lifts().fold(f64::MAX, f64::min),
        lifts().fold(f64::MIN, f64::max),
    );
    assert!((most + 0.1).abs() < 1e-9, "{most}");
    assert!((least + 12.1).abs() < 1e-9, "{least}");
    let whole = at(&record, 1.0)[stem] - at(&record, 2.0)[stem];
    assert!(whole.abs() < 1e-9);
}
