//! Impacts with known answers: of parts with outlines, whose contacts come from their spaces.

use cspace_motion::{EventKind, Record, Status};

use crate::motion::helpers::{across, balanced, near, thrown};

/// A disc about a place, as a loop.
fn disc(x: f64, y: f64, r: f64) -> String {
    format!("[[{}, {y}, 1], [{}, {y}, 1]]", x - r, x + r)
}

const FLOOR: &str = r#"
[[part]]
name = "floor"
motion = { type = "fixed" }
loops = [ [[-20, -1], [20, -1], [20, 0], [-20, 0]] ]
"#;

fn times(record: &Record, kind: EventKind) -> Vec<f64> {
    let all = record.events.iter().filter(|e| e.kind == kind);
    all.map(|e| e.t).collect()
}

#[test]
fn a_ball_comes_to_rest() {
    for e in [0.1, 0.5, 0.9] {
        let (h, g) = (5.0, 9.81);
        let text = format!(
            "gravity = [0, -{g}]\nrestitution = {e}\n{FLOOR}\n[[part]]\nname = \"ball\"\nloops = [ {} ]\nstart = [0, 6, 0]\nmass = 2\ninertia = 1\n",
            disc(0.0, 0.0, 1.0)
        );
        let fall = f64::sqrt(2.0 * h / g);
        let rests = fall * (1.0 + e) / (1.0 - e);
        let span = 1.5 * rests;
        let (_, record) = thrown(&text, span, span);
        assert_eq!(record.status, Status::Done);
        let rest = times(&record, EventKind::Rest);
        assert_eq!(rest.len(), 1, "{e}");
        near("rest", rest[0], rests, 1e-8 * span);
        let mut t = fall;
        for (k, &struck) in times(&record, EventKind::Impact).iter().enumerate() {
            near("impact", struck, t, 1e-9 * span);
            t += 2.0 * fall * e.powi(k as i32 + 1);
        }
        assert_eq!(record.events.last().unwrap().kind, EventKind::Rest, "{e}");
        let last = record.samples.last().unwrap();
        near("height", last.coordinates[1], 1.0, 1e-11);
        near("rate", last.rates[1], 0.0, 1e-11);
        balanced(&record, 2.0 * g * h, 1e-9);
    }
}

/// Two discs of different masses, one that spins, strike each other off centre: e along the normal, and across it as much as stops
/// the sliding, or as friction allows.
#[test]
fn two_free_discs_strike_each_other() {
    for (friction, e, spin) in [
        (0.1, 0.7, 3.0),
        (5.0, 0.4, 3.0),
        (0.0, 1.0, -2.0),
        (0.3, 0.0, 7.0),
    ] {
        let (m, n) = (1.0, 3.0);
        let (i, j) = (0.5 * m, 0.5 * n * 4.0);
        let text = format!(
            "friction = {friction}\nrestitution = {e}\n[[part]]\nname = \"a\"\nloops = [ {} ]\nmass = {m}\ninertia = {i}\nrate = [2, 0.3, {spin}]\n[[part]]\nname = \"b\"\nloops = [ {} ]\nstart = [7, 1.5, 0]\nmass = {n}\ninertia = {j}\nrate = [-1, 0.1, 0.5]\n",
            disc(0.0, 0.0, 1.0),
            disc(0.0, 0.0, 2.0)
        );
        let (_, record) = thrown(&text, 3.0, 3.0);
        assert_eq!(record.status, Status::Done);
        // Where the centres are 3 apart.
        let (dx, dy, vx, vy) = (7.0, 1.5, -3.0, -0.2);
        let (a, b, c) = (
            vx * vx + vy * vy,
            dx * vx + dy * vy,
            dx * dx + dy * dy - 9.0,
        );
        let t = (-b - f64::sqrt(b * b - a * c)) / a;
        let struck = times(&record, EventKind::Impact);
        assert_eq!(struck.len(), 1);
        near("time", struck[0], t, 1e-10);
        let (nx, ny) = ((dx + vx * t) / 3.0, (dy + vy * t) / 3.0);
        let (tx, ty) = (-ny, nx);
        let closing = vx * nx + vy * ny;
        // Of b's place against a's, along the tangent.
        let slides = vx * tx + vy * ty - 0.5 * 2.0 - spin * 1.0;
        let normal = -(1.0 + e) * closing / (1.0 / m + 1.0 / n);
        let stops = -slides / (1.0 / m + 1.0 / n + 1.0 / i + 4.0 / j);
        let tangential = stops.clamp(-friction * normal, friction * normal);
        let (px, py) = (normal * nx + tangential * tx, normal * ny + tangential * ty);
        let wanted = [
            2.0 - px / m,
            0.3 - py / m,
            spin - tangential / i,
            -1.0 + px / n,
            0.1 + py / n,
            0.5 - 2.0 * tangential / j,
        ];
        let (_, after) = across(&record, struck[0]);
        for (k, (found, wanted)) in after.iter().zip(wanted).enumerate() {
            near(&format!("rate {k} ({friction}, {e})"), *found, wanted, 1e-9);
        }
        balanced(&record, 5.0, 1e-9);
        let kinds: Vec<EventKind> = record.events.iter().map(|e| e.kind).collect();
        if e > 0.0 {
            assert_eq!(kinds, [EventKind::Impact]);
        }
    }
}

/// Discs in a row: what comes in on one side goes out on the other, if they do not touch at first.
#[test]
fn a_row_of_discs_passes_a_shock_on() {
    let text = format!(
        "restitution = 1\n[[part]]\nname = \"a\"\nloops = [ {d} ]\nstart = [-4, 0, 0]\nmass = 1\ninertia = 0.5\nrate = [2, 0, 0]\n[[part]]\nname = \"b\"\nloops = [ {d} ]\nmass = 1\ninertia = 0.5\n[[part]]\nname = \"c\"\nloops = [ {d} ]\nstart = [2.5, 0, 0]\nmass = 1\ninertia = 0.5\n",
        d = disc(0.0, 0.0, 1.0)
    );
    let (_, record) = thrown(&text, 3.0, 3.0);
    let struck = times(&record, EventKind::Impact);
    assert_eq!(struck.len(), 2);
    near("first", struck[0], 1.0, 1e-11);
    near("second", struck[1], 1.25, 1e-11);
    let last = record.samples.last().unwrap();
    for (k, wanted) in [(0, 0.0), (3, 0.0), (6, 2.0)] {
        near("rate", last.rates[k], wanted, 1e-11);
    }
    // Where they touch, Newton's law at both at once sends the other two off together: (-1, 2, 2) / 3 of what came.
    let touching = text.replace("2.5, 0, 0", "2, 0, 0");
    let (_, record) = thrown(&touching, 3.0, 3.0);
    assert_eq!(record.status, Status::Done);
    let last = record.samples.last().unwrap();
    for (k, wanted) in [(0, -2.0 / 3.0), (3, 4.0 / 3.0), (6, 4.0 / 3.0)] {
        near("rate", last.rates[k], wanted, 1e-11);
    }
    balanced(&record, 2.0, 1e-10);
}

/// Housner's block rocks from one corner to the other and loses a fixed share of its rate at each stroke.
#[test]
fn a_rocking_block_loses_what_housner_says() {
    for (b, h) in [(0.25, 1.0), (0.4, 1.0)] {
        let alpha = f64::atan2(b, h);
        let inertia = (b * b + h * h) / 3.0;
        let tilt: f64 = 0.1;
        // About the right corner, which stands at b.
        // The block turns clockwise about its right corner.
        let text = format!(
            "gravity = [0, -9.81]\nfriction = 0.8\n{FLOOR}\n[[part]]\nname = \"block\"\nloops = [ [[-{b}, -{h}], [{b}, -{h}], [{b}, {h}], [-{b}, {h}]] ]\nstart = [{}, {}, {}]\nmass = 1\ninertia = {inertia}\n",
            b - (b * tilt.cos() - h * tilt.sin()),
            b * tilt.sin() + h * tilt.cos(),
            -tilt
        );
        let (_, record) = thrown(&text, 4.0, 0.01);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        let r = 1.0 - 1.5 * alpha.sin().powi(2);
        let struck = times(&record, EventKind::Impact);
        assert!((6..200).contains(&struck.len()), "{}", struck.len());
        // From the energy: rate² = 2 g R (cos(α − tilt) − cos α) / (4 R² / 3) at the stroke.
        let big = f64::hypot(b, h);
        let swing = |tilt: f64| {
            // Of the time, with tilt (1 − s²) for the angle: Simpson's rule.
            let n = 20_000;
            let f = |s: f64| {
                let angle = tilt * (1.0 - s * s);
                let fall = (alpha - tilt).cos() - (alpha - angle).cos();
                let rate = f64::sqrt(1.5 * 9.81 / big * fall);
                if s == 0.0 {
                    2.0 * tilt / f64::sqrt(1.5 * 9.81 / big * (alpha - tilt).sin() * tilt)
                } else {
                    2.0 * tilt * s / rate
                }
            };
            let step = 1.0 / f64::from(n);
            let inner: f64 = (1..n)
                .map(|k| f(f64::from(k) * step) * if k % 2 == 1 { 4.0 } else { 2.0 })
                .sum();
            (f(0.0) + f(1.0) + inner) * step / 3.0
        };
        let rate = |tilt: f64| f64::sqrt(1.5 * 9.81 / big * ((alpha - tilt).cos() - alpha.cos()));
        near("first stroke", struck[0], swing(tilt), 1e-8 * 4.0);
        let mut before_last = 0.0;
        for (k, &t) in struck.iter().take(5).enumerate() {
            let (before, after) = across(&record, t);
            near("ratio", after[2] / before[2], r, 1e-9);
            if k == 0 {
                near("rate", before[2].abs(), rate(tilt), 1e-9);
            } else {
                near("rate kept", before[2].abs(), before_last, 1e-9);
            }
            before_last = after[2].abs();
        }
        balanced(
            &record,
            9.81 * big * ((alpha - tilt).cos() - alpha.cos()).abs(),
            1e-8,
        );
    }
}

/// One corner strikes, and friction holds it: the law of impact has a closed form.
#[test]
fn a_dropped_block_strikes_with_one_corner() {
    let text = format!(
        "gravity = [0, -9.81]\nfriction = 10\nrestitution = 0.5\n{FLOOR}\n[[part]]\nname = \"block\"\nloops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]\nstart = [0, 3, 0.3]\nmass = 1\ninertia = 0.6666666666666666\n"
    );
    let (_, record) = thrown(&text, 1.0, 1.0);
    let (c, s) = (0.3_f64.cos(), 0.3_f64.sin());
    // The lowest corner is (-1, -1) turned: at s * -1 + c * -1 below the centre.
    let corner = (-c + s, -s - c);
    let drop = 3.0 + corner.1;
    let t = f64::sqrt(2.0 * drop / 9.81);
    let struck = times(&record, EventKind::Impact);
    near("time", struck[0], t, 1e-10);
    let v = -9.81 * t;
    // Impulses (T, N) so that the corner's rate is (0, −e v).
    let i = 2.0 / 3.0;
    let (x, y) = corner;
    let (tt, tn, nn) = (1.0 + y * y / i, -x * y / i, 1.0 + x * x / i);
    let goal = -(1.0 + 0.5) * v;
    let det = tt * nn - tn * tn;
    let (it, inn) = (-tn * goal / det, tt * goal / det);
    let (_, after) = across(&record, struck[0]);
    near("vx", after[0], it, 1e-9);
    near("vy", after[1], v + inn, 1e-9);
    near("omega", after[2], (x * inn - y * it) / i, 1e-9);
}
