//! Motions without inertia agree with those with masses and large dampers if drives are slow.
//!
//! A coordinate with a damper c and a stiffness k lags by c/k of its rate, the less the more slowly drives move.

use cspace_motion::{Record, Settings, Simulation, Status};
use cspace_oracle::effort;

use crate::motion::helpers::{judge, read};

/// An eccentric lifts a roller on a spring, and a lever hangs between two springs, the one from the eccentric.
fn scene(rate: f64) -> String {
    format!(
        r#"
[[part]]
name = "eccentric"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [{{ circle = 10, at = [0, 3] }}]
[[part]]
name = "roller"
mass = 1e-3
motion = {{ type = "prismatic", direction = [0, 1] }}
loops = [{{ circle = 2, at = [0, 15] }}]
[[part]]
name = "lever"
mass = 1e-3
motion = {{ type = "revolute", center = [40, 0] }}
loops = [{{ circle = 2, at = [42, 0] }}]
[[drive]]
part = "eccentric"
rate = {rate}
[[spring]]
parts = ["roller"]
at = [[0, 15], [0, 40]]
stiffness = 5
length = 60
damping = 1
[[spring]]
parts = ["lever", "eccentric"]
type = "torsion"
stiffness = 2
angle = 0
damping = 0.3
[[spring]]
parts = ["lever"]
at = [[42, 0], [50, 5]]
stiffness = 0.5
length = 7
damping = 1
"#
    )
}

/// Largest difference of two recordings, at the same times.
fn apart(one: &Record, other: &Record) -> f64 {
    let mut most = 0.0_f64;
    for a in &one.samples {
        let near = |b: &&cspace_motion::Sample| (a.t - b.t).abs() < 1e-9 * one.until;
        let b = other.samples.iter().find(near).unwrap();
        for (x, y) in a.coordinates.iter().zip(&b.coordinates) {
            most = most.max((x - y).abs());
        }
    }
    most
}

#[test]
fn slow_drives_leave_the_balance_of_forces() {
    let mut before = f64::INFINITY;
    for rate in [0.1, 0.01, 0.001].into_iter().take(effort(2, 3)) {
        let simulation = Simulation::new(&read(&scene(rate))).unwrap();
        let settings = Settings {
            time: 2.0 / rate,
            every: Some(0.1 / rate),
        };
        let records = [
            simulation.kinematic(&settings).unwrap(),
            simulation.dynamic(&settings).unwrap(),
        ];
        for record in &records {
            assert_eq!(record.status, Status::Done, "{:?}", record.reason);
            judge(&simulation, record);
        }
        // The lever begins at rest elsewhere, and is where it is to be before the second sample.
        let [mut one, mut other] = records;
        one.samples.remove(0);
        other.samples.remove(0);
        let far = apart(&one, &other);
        assert!(far < 10.0 * rate && far > 1e-2 * rate, "{rate}: {far:e}");
        assert!(far < 0.2 * before, "{rate}: {far:e} {before:e}");
        before = far;
    }
}
