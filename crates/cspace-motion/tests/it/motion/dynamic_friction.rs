//! Sliding, sticking and rolling with known answers.

use cspace_motion::{EventKind, Record, Status};

use crate::motion::helpers::{balanced, near, thrown};

const G: f64 = 9.81;

fn times(record: &Record, kind: EventKind) -> Vec<f64> {
    let all = record.events.iter().filter(|e| e.kind == kind);
    all.map(|e| e.t).collect()
}

/// A block on an incline, that begins with a rate up along it.
fn incline(angle: f64, friction: f64, rate: f64) -> String {
    let (c, s) = (angle.cos(), angle.sin());
    let at = |x: f64, y: f64| format!("[{}, {}]", c * x - s * y, s * x + c * y);
    format!(
        "gravity = [0, -{G}]\nfriction = {friction}\n[[part]]\nname = \"slope\"\nmotion = {{ type = \"fixed\" }}\nloops = [ [{}, {}, {}, {}] ]\n[[part]]\nname = \"block\"\nloops = [ [[-1, 0], [1, 0], [1, 1], [-1, 1]] ]\nstart = [0, 0, {angle}]\nrate = [{}, {}, 0]\nmass = 2\ninertia = 1\ncenter_of_mass = [0, 0.5]\n",
        at(-60.0, -2.0),
        at(60.0, -2.0),
        at(60.0, 0.0),
        at(-60.0, 0.0),
        rate * c,
        rate * s,
    )
}

#[test]
fn a_block_on_an_incline() {
    for angle in [0.2, 0.5, 0.0, -0.3] {
        let (c, s) = (f64::cos(angle), f64::sin(angle));
        for friction in [0.0, 0.1, 0.25, 0.9] {
            for rate in [0.0, 3.0, -2.0] {
                let time = 2.0;
                let (_, record) = thrown(&incline(angle, friction, rate), time, 0.1);
                let what = format!("{angle} {friction} {rate}");
                assert_eq!(record.status, Status::Done, "{what}: {:?}", record.reason);
                // Along the slope: first against the rate, then down if it does not hold.
                let first = -G * s - G * c * friction * f64::signum(rate);
                let slips = f64::abs(s) > friction * c;
                let down = -G * s + G * c * friction * s.signum();
                let stops = if rate == 0.0 { 0.0 } else { -rate / first };
                let moves = |t: f64| -> f64 {
                    let stops = if rate == 0.0 {
                        0.0
                    } else if stops < 0.0 {
                        f64::INFINITY
                    } else {
                        stops
                    };
                    let way = |t: f64| rate * t + 0.5 * first * t * t;
                    if t <= stops {
                        way(t)
                    } else {
                        let more = if slips {
                            0.5 * down * (t - stops).powi(2)
                        } else {
                            0.0
                        };
                        if rate == 0.0 { more } else { way(stops) + more }
                    }
                };
                for sample in &record.samples {
                    let along = sample.coordinates[0] * c + sample.coordinates[1] * s;
                    near(&what, along, moves(sample.t), 1e-8 * 20.0);
                }
                let sticks = times(&record, EventKind::Stick);
                if rate != 0.0 && !slips && stops > 0.0 && stops < time {
                    assert!(!sticks.is_empty(), "{what}: {:?}", record.events);
                    for t in sticks {
                        near("stops", t, stops, 1e-8 * time);
                    }
                }
                balanced(&record, 20.0, 1e-9);
            }
        }
    }
}

#[test]
fn a_disc_slides_then_rolls() {
    let text = |angle: f64, friction: f64, rate: f64, spin: f64| {
        let (c, s) = (angle.cos(), angle.sin());
        let at = |x: f64, y: f64| format!("[{}, {}]", c * x - s * y, s * x + c * y);
        format!(
            "gravity = [0, -{G}]\nfriction = {friction}\n[[part]]\nname = \"slope\"\nmotion = {{ type = \"fixed\" }}\nloops = [ [{}, {}, {}, {}] ]\n[[part]]\nname = \"disc\"\nloops = [ [[-0.5, 0, 1], [0.5, 0, 1]] ]\nstart = [{}, {}, 0]\nrate = [{}, {}, {spin}]\nmass = 2\ninertia = 0.25\n",
            at(-60.0, -2.0),
            at(60.0, -2.0),
            at(60.0, 0.0),
            at(-60.0, 0.0),
            -0.5 * s,
            0.5 * c,
            rate * c,
            rate * s,
        )
    };
    // On a plane.
    let (v, mu) = (4.0, 0.2);
    let (_, record) = thrown(&text(0.0, mu, v, 0.0), 2.0, 0.1);
    assert_eq!(record.status, Status::Done);
    let sticks = times(&record, EventKind::Stick);
    assert_eq!(sticks.len(), 1);
    let rolls = v / (3.0 * mu * G);
    near("rolls", sticks[0], rolls, 1e-8 * 2.0);
    let last = record.samples.last().unwrap();
    near("rate", last.rates[0], 2.0 / 3.0 * v, 1e-10);
    near("spin", last.rates[2], -2.0 / 3.0 * v / 0.5, 1e-10);
    let way = v * rolls - 0.5 * mu * G * rolls * rolls + 2.0 / 3.0 * v * (2.0 - rolls);
    near("way", last.coordinates[0], way, 1e-9);
    // It spins backwards: slides until the spin is gone.
    let (_, record) = thrown(&text(0.0, mu, v, 30.0), 5.0, 0.1);
    let stops = (v + 30.0 * 0.5) / (3.0 * mu * G);
    near(
        "rolls",
        times(&record, EventKind::Stick)[0],
        stops,
        1e-8 * 5.0,
    );
    near(
        "rate",
        record.samples.last().unwrap().rates[0],
        v - mu * G * stops,
        1e-9,
    );
    // Down a slope it rolls where friction is a third of the slope or more, and slides otherwise.
    let angle = 0.4_f64;
    let least = angle.tan() / 3.0;
    for (friction, rolls) in [(least * 1.001, true), (least * 0.999, false), (5.0, true)] {
        let (_, record) = thrown(&text(angle, friction, 0.0, 0.0), 2.0, 0.1);
        assert_eq!(record.status, Status::Done);
        let last = record.samples.last().unwrap();
        let along = last.coordinates[0] * angle.cos() + last.coordinates[1] * angle.sin();
        let a = if rolls {
            2.0 / 3.0 * G * angle.sin()
        } else {
            G * (angle.sin() - friction * angle.cos())
        };
        // The start is half a unit off the slope, and so it stays.
        near("way", along, -0.5 * a * 4.0, 1e-8);
        assert!(
            record.events.iter().all(|e| e.kind == EventKind::Touch),
            "{:?}",
            record.events
        );
        balanced(&record, 20.0, 1e-9);
    }
}

/// A thin rod whose tip slides on a floor. Where 1 + 3 cos θ (cos θ − μ sin θ) < 0 no force holds the tip on the floor.
#[test]
fn painleve_s_rod() {
    let rod = |angle: f64, friction: f64, rate: f64| {
        format!(
            "gravity = [0, -{G}]\nfriction = {friction}\n[[part]]\nname = \"floor\"\nmotion = {{ type = \"fixed\" }}\nloops = [ [[-20, -1], [20, -1], [20, 0], [-20, 0]] ]\n[[part]]\nname = \"rod\"\nloops = [ [[-1, 0], [-0.9, -0.04], [0.9, -0.04], [1, 0], [0.9, 0.04], [-0.9, 0.04]] ]\nstart = [{}, {}, {angle}]\nrate = [{rate}, 0, 0]\nmass = 1\ninertia = 0.3333333333333333\n",
            f64::cos(angle),
            f64::sin(angle)
        )
    };
    for angle in [0.6_f64, 0.9, 1.2] {
        let (c, s) = (angle.cos(), angle.sin());
        let critical = (c + 1.0 / (3.0 * c)) / s;
        for share in [0.5, 0.99, 1.0 - 1e-6, 1.0 + 1e-6, 1.01, 2.0] {
            let friction = critical * share;
            let (_, record) = thrown(&rod(angle, friction, -3.0), 1e-3, 1e-3);
            let what = format!("{angle} {share}: {:?} {:?}", record.status, record.reason);
            if share < 1.0 {
                // Near the bound it may come to it in the meantime.
                if share < 0.999 {
                    assert_eq!(record.status, Status::Done, "{what}");
                }
                assert!(record.until > 0.0, "{what}");
            } else {
                assert_eq!(record.status, Status::Inconsistent, "{what}");
                assert_eq!(record.until, 0.0, "{what}");
                assert!(record.reason.as_ref().unwrap().contains("rod"), "{what}");
            }
            // The other way friction presses nothing.
            let (_, record) = thrown(&rod(angle, friction, 3.0), 1e-3, 1e-3);
            assert_eq!(record.status, Status::Done, "{what}");
        }
    }
}

/// A block slides off a table, without friction: it begins to tip as its centre comes over the edge.
#[test]
fn a_block_slides_off_an_edge() {
    for friction in [0.0, 0.1] {
        let text = format!(
            "gravity = [0, -{G}]\nfriction = {friction}\n[[part]]\nname = \"table\"\nmotion = {{ type = \"fixed\" }}\nloops = [ [[-20, -1], [0, -1], [0, 0], [-20, 0]] ]\n[[part]]\nname = \"block\"\nloops = [ [[-1, -0.25], [1, -0.25], [1, 0.25], [-1, 0.25]] ]\nstart = [-3, 0.25, 0]\nrate = [4, 0, 0]\nmass = 2\ninertia = 0.7083333333333333\n"
        );
        let (simulation, record) = thrown(&text, 2.0, 0.01);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        // Pressure moves ahead of the centre by friction times height.
        let way = 3.0 - friction * 0.25;
        let t = if friction == 0.0 {
            way / 4.0
        } else {
            let a = friction * G;
            (4.0 - f64::sqrt(16.0 - 2.0 * a * way)) / a
        };
        let leaves = record
            .events
            .iter()
            .find(|e| e.kind == EventKind::Release)
            .unwrap();
        near("tips", leaves.t, t, 1e-8 * 2.0);
        crate::motion::helpers::judge(&simulation, &record);
        balanced(&record, 20.0, 1e-9);
    }
}
