//! Forces in balance while drives move, against statics.

use core::f64::consts::PI;

use cspace_model::SpringKind;
use cspace_motion::{EventKind, Record, Sample, Status, What};

use crate::motion::helpers::{model, near, read, run};

/// Times at which balances end, after the start.
fn snaps(record: &Record) -> Vec<f64> {
    let snaps = record.events.iter().filter(|e| e.kind == EventKind::Snap);
    snaps.map(|e| e.t).filter(|t| *t > 0.0).collect()
}

fn kinds(record: &Record) -> Vec<EventKind> {
    record.events.iter().map(|e| e.kind).collect()
}

/// An arm with a roller on an eccentric. The angle at the arm's pivot follows from the sides of a triangle.
#[test]
fn a_follower_does_not_depend_on_its_load() {
    let of = |load: &str| {
        read(&format!(
            r#"
[[part]]
name = "cam"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [{{ circle = 10, at = [0, 3] }}]
[[part]]
name = "arm"
motion = {{ type = "revolute", center = [-30, 14] }}
loops = [{{ circle = 2, at = [0, 15] }}]
[[drive]]
part = "cam"
rate = "360deg"
[[load]]
part = "arm"
torque = {load}
"#
        ))
    };
    let angle = |phi: f64| {
        let (cx, cy) = (3.0 * (phi + PI / 2.0).cos(), 3.0 * (phi + PI / 2.0).sin());
        let (dx, dy) = (cx + 30.0, cy - 14.0);
        let (d, arm, reach) = (dx.hypot(dy), 901.0_f64.sqrt(), 12.0);
        dy.atan2(dx) + ((d * d + arm * arm - reach * reach) / (2.0 * d * arm)).acos()
    };
    let mut first: Option<Vec<u64>> = None;
    for load in ["-1e-6", "-1", "-1000", "-1e9"] {
        let (_, record) = run(&of(load), 1.0, 0.01);
        assert_eq!(record.status, Status::Done);
        for sample in &record.samples {
            let lift = angle(sample.coordinates[0]) - angle(0.0);
            let off = (sample.coordinates[1] - lift).abs();
            assert!(off < 1e-12, "{load} {}: {off:e}", sample.t);
        }
        let all = record.samples.iter().flat_map(|s| &s.coordinates);
        let bits: Vec<u64> = all.map(|x| x.to_bits()).collect();
        assert_eq!(*first.get_or_insert_with(|| bits.clone()), bits, "{load}");
    }
}

/// A lever that a soft spring turns over the dead point of a stiff one: V = k/2 (θ − φ)² + K/2 (l(θ) − l₀)².
#[test]
fn a_toggle_snaps_where_its_balance_ends() {
    let (soft, stiff, free) = (8.0, 30.0, 1.2);
    let text = format!(
        r#"
[[part]]
name = "knob"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [{{ circle = 0.1, at = [0, 0] }}]
start = -1.2
[[part]]
name = "lever"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [[[-0.1, 0.2], [0.1, 0.2], [0, 1]]]
start = -0.9
[[pair]]
fixed = "knob"
moving = "lever"
[[drive]]
part = "knob"
rate = 1
[[spring]]
parts = ["lever", "knob"]
type = "torsion"
stiffness = {soft}
angle = 0
[[spring]]
parts = ["lever"]
at = [[0, 1], [0, 2]]
stiffness = {stiff}
length = {free}
"#
    );
    let text = text.replace("[[pair]]\nfixed = \"knob\"\nmoving = \"lever\"\n", "");
    let text = text.replace("circle = 0.1, at = [0, 0]", "circle = 0.05, at = [0, -5]");
    let (_, record) = run(&read(&text), 2.4, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    // The end of the lever is at (−sin θ, cos θ): l² = 5 − 4 cos θ.
    let force = |theta: f64, phi: f64| {
        let l = (5.0 - 4.0 * theta.cos()).sqrt();
        soft * (theta - phi) + stiff * (l - free) * 2.0 * theta.sin() / l
    };
    let stiffness = |theta: f64| {
        let e = 1e-6;
        (force(theta + e, 0.0) - force(theta - e, 0.0)) / (2.0 * e)
    };
    // Where it vanishes, on the side from which the lever comes.
    let (mut lo, mut hi) = (-1.2, 0.0);
    assert!(stiffness(lo) > 0.0 && stiffness(hi) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if stiffness(middle) > 0.0 {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    let phi = force(lo, 0.0) / soft;
    let snaps: Vec<f64> = snaps(&record).into_iter().map(|t| t - 1.2).collect();
    assert_eq!(snaps.len(), 1, "{:?}", record.events);
    near("the angle at which it snaps", snaps[0], phi, 1e-9);
    for sample in &record.samples {
        let off = force(sample.coordinates[1], sample.coordinates[0]);
        assert!(off.abs() < 1e-9 * soft, "{}: {off:e}", sample.t);
        let after = sample.t - 1.2 > phi;
        assert_eq!(sample.coordinates[1] > 0.0, after, "{}", sample.t);
    }
}

/// A stiff hook on a torsion spring is pushed in and pulled out: the work of the drive is always the energy of the spring.
#[test]
fn a_hook_is_pushed_in_with_the_force_of_statics() {
    let mechanism = model("snap_in");
    let SpringKind::Torsion {
        stiffness, angle, ..
    } = mechanism.dynamics.springs[0].kind
    else {
        panic!("the hook's spring turns it");
    };
    let (_, record) = run(&mechanism, 2.5, 0.001);
    assert_eq!(record.status, Status::Done);
    let end = record.samples.last().unwrap();
    near("the hook at the end", end.coordinates[3], 0.0, 1e-12);
    let energy = |s: &Sample| 0.5 * stiffness * (s.coordinates[3] - angle).powi(2);
    let most = record.samples.iter().map(energy).fold(0.0, f64::max);
    let (mut work, mut strongest) = (0.0, 0.0_f64);
    for pair in record.samples.windows(2) {
        let force = |s: &Sample| s.forces.as_ref().unwrap().drives[0].force;
        let way = pair[1].coordinates[0] - pair[0].coordinates[0];
        work += 0.5 * (force(&pair[0]) + force(&pair[1])) * way;
        strongest = strongest.max(force(&pair[0]).abs());
        let off = (work - energy(&pair[1])).abs() / most;
        assert!(off < 1e-2, "{}: {off:e}", pair[1].t);
    }
    assert!(strongest > 1.0 && most > 0.0, "{strongest} {most}");
}

/// A wedge lifts the round end of a lever against a torsion spring: the drive's force is k θ dθ/du, by virtual work.
#[test]
fn a_drive_gives_what_statics_say() {
    for stiffness in [1e-4, 1.0, 1e7] {
        let text = format!(
            r#"
[[part]]
name = "wedge"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [[[-30, -6], [-2, -6], [-30, 8]]]
[[part]]
name = "lever"
motion = {{ type = "revolute", center = [20, 0] }}
loops = [{{ circle = 1, at = [0, 0] }}]
[[drive]]
part = "wedge"
rate = 1
[[spring]]
parts = ["lever"]
type = "torsion"
stiffness = {stiffness}
angle = 0
"#
        );
        let (_, record) = run(&read(&text), 24.0, 0.25);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        let normal = [0.447_213_595_499_957_9, 0.894_427_190_999_915_9];
        let mut seen = 0;
        for sample in &record.samples {
            let [u, theta] = [sample.coordinates[0], sample.coordinates[1]];
            let forces = sample.forces.as_ref().unwrap();
            let force = forces.drives[0].force;
            // The disc's centre turns about (20, 0) at a distance of 20; from there to the slope it is 1 where they touch.
            let center = [20.0 - 20.0 * theta.cos(), -20.0 * theta.sin()];
            let apart = normal[0] * (center[0] - u + 2.0) + normal[1] * (center[1] + 6.0) - 1.0;
            if forces.contacts.is_empty() {
                assert!(apart > -1e-9 && theta.abs() < 1e-12 && force.abs() < 1e-12 * stiffness);
                continue;
            }
            seen += 1;
            let turned = [20.0 * theta.sin(), -20.0 * theta.cos()];
            let by_theta = normal[0] * turned[0] + normal[1] * turned[1];
            let expected = stiffness * theta * normal[0] / by_theta;
            assert!(apart.abs() < 1e-11, "{u}: {apart:e}");
            assert!(
                (force - expected).abs() < 1e-9 * stiffness,
                "{u}: {force} {expected}"
            );
        }
        assert!(seen > 20, "{seen}");
    }
}

/// A disc on two supports, and an arm that leans on it: the forces are those of statics.
#[test]
fn contacts_carry_what_statics_say() {
    let text = r#"
gravity = [0, -10]
[[part]]
name = "trough"
motion = { type = "fixed" }
loops = [[[0, 0], [-4, 3], [-5, 0]], [[0.5, 0], [4.5, 0], [4, 2.0207259421636903]]]
[[part]]
name = "disc"
start = [0.2, 6, 0]
mass = 2
loops = [{ circle = 1, at = [0, 0] }]
[[part]]
name = "knob"
motion = { type = "revolute", center = [20, 0] }
loops = [{ circle = 1, at = [20, 0] }]
[[drive]]
part = "knob"
rate = 1
"#;
    let (_, record) = run(&read(text), 1.0, 0.5);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let forces = record.samples.last().unwrap().forces.as_ref().unwrap();
    let normals: Vec<f64> = forces.contacts.iter().map(|c| c.normal).collect();
    assert_eq!(normals.len(), 2, "{:?}", forces.contacts);
    // Slopes of atan(3/4) falling and 30 degrees rising: sin a / sin(a + b) of the weight on each other's side.
    let (a, b) = (0.75_f64.atan(), PI / 6.0);
    let expected = [a.sin(), b.sin()].map(|s| 20.0 * s / (a + b).sin());
    for wanted in expected {
        assert!(
            normals.iter().any(|n| (n - wanted).abs() < 1e-9),
            "{normals:?} {expected:?}"
        );
    }
    assert!(kinds(&record).contains(&EventKind::Snap));
}

/// A load that nothing stops is reported by the name of its part.
#[test]
fn what_nothing_stops_is_told() {
    let text = r#"
[[part]]
name = "wheel"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 1, at = [0, 0] }]
[[part]]
name = "knob"
motion = { type = "revolute", center = [20, 0] }
loops = [{ circle = 1, at = [20, 0] }]
[[drive]]
part = "knob"
rate = 1
[[load]]
part = "wheel"
torque = 3
"#;
    let (_, record) = run(&read(text), 1.0, 0.5);
    assert_eq!(record.status, Status::Undetermined);
    assert!(record.reason.unwrap().starts_with("nothing stops wheel"));
    // A brake does.
    let braked =
        format!("{text}[[spring]]\nparts = [\"wheel\"]\ntype = \"torsion\"\ndamping = 1\n");
    let (_, record) = run(&read(&braked), 1.0, 0.5);
    assert_eq!(record.status, Status::Done);
    assert_eq!(record.samples.last().unwrap().coordinates[0], 0.0);
}

/// The wheel advances by a tooth per turn, the pawl drops behind it at once, and nothing turns back.
#[test]
fn a_pawl_drops() {
    let (simulation, record) = run(&model("ratchet_mechanism"), 3.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let wheel = simulation.system().parts()[4].indices().start;
    let turned: Vec<f64> = record
        .samples
        .iter()
        .map(|s| s.coordinates[wheel])
        .collect();
    assert!(turned.windows(2).all(|w| w[1] >= w[0] - 1e-12));
    let drops = record.events.iter().filter(|e| {
        e.t > 0.0
            && e.kind == EventKind::Snap
            && matches!(&e.what, What::Part { part } if part == "pawl")
    });
    let times: Vec<f64> = drops.map(|e| e.t).collect();
    assert_eq!(times.len(), 3, "{times:?}");
    near("from drop to drop", times[2] - times[1], 1.0, 1e-9);
}

/// A lever between two springs folds over at 50.18170634°, with the slide at 8.717103086970, however stiff the ends of its range and fast the drive.
#[test]
fn a_fold_is_passed_at_any_rate() {
    for (rate, coupling) in [(1.0, 0.2), (7.0, 0.1), (10.0, 0.2), (30.0, 0.25)] {
        let text = format!(
            r#"
[[part]]
name = "in"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [{{ circle = 1, at = [-100, 0] }}]
[[part]]
name = "lever"
motion = {{ type = "revolute", center = [0, 0], range = ["-60deg", "60deg"] }}
loops = [[[-0.5, -1], [0.5, -1], [0.5, 20], [-0.5, 20]]]
start = "30deg"
[[drive]]
part = "in"
rate = {rate}
[[spring]]
parts = ["lever"]
at = [[0, 20], [0, -10]]
stiffness = {}
length = 20
[[spring]]
parts = ["lever", "in"]
at = [[0, 20], [0, 20]]
stiffness = {coupling}
"#,
            10.0 * coupling
        );
        let (_, record) = run(&read(&text), 60.0 / rate, 1.0 / rate);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        let snaps: Vec<f64> = snaps(&record).into_iter().map(|t| t * rate).collect();
        assert_eq!(snaps.len(), 1, "{rate}: {:?}", record.events);
        near("the slide", snaps[0], 8.717_103_086_970, 1e-9);
    }
}

/// A sprung roller in the sides of a hexagon that is turned by a spring: it comes over a corner once a second, whatever the unit of force.
#[test]
fn a_detent_snaps_over_each_corner() {
    for unit in [1e-9, 1.0, 1e6] {
        let text = format!(
            r#"
[[part]]
name = "wheel"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [[{{ repeat = 6, about = [0, 0], path = [[20, 0]] }}]]
[[part]]
name = "input"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [{{ circle = 1, at = [0, 0] }}]
[[part]]
name = "plunger"
motion = {{ type = "prismatic", direction = [0, 1] }}
loops = [{{ circle = 2, at = [0, 25] }}]
[[pair]]
fixed = "wheel"
moving = "plunger"
[[drive]]
part = "input"
rate = "60deg"
[[spring]]
type = "torsion"
parts = ["wheel", "input"]
stiffness = {}
[[spring]]
parts = ["plunger"]
at = [[0, 27], [0, 60]]
stiffness = {}
length = 50
"#,
            150.0 * unit,
            3.0 * unit
        );
        let (_, record) = run(&read(&text), 10.0, 0.05);
        assert_eq!(record.status, Status::Done, "{unit}: {:?}", record.reason);
        let snaps = snaps(&record);
        assert!(snaps.len() >= 6, "{unit}: {snaps:?}");
        for pair in snaps.windows(2) {
            near("between snaps", pair[1] - pair[0], 1.0, 1e-8);
        }
    }
}

/// A load holds a block on the end of its range until something driven takes it off.
#[test]
fn what_rests_on_the_end_of_its_range_is_pushed_off_it() {
    for load in [-50.0, -10.0, -0.5] {
        let text = format!(
            r#"
[[part]]
name = "block"
motion = {{ type = "prismatic", direction = [1, 0], range = [0, 30] }}
loops = [{{ circle = 3, at = [0, 0] }}]
[[part]]
name = "push"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [{{ circle = 1, at = [-5, 0] }}]
[[drive]]
part = "push"
rate = 1
[[load]]
part = "block"
force = [{load}, 0]
"#
        );
        let (_, record) = run(&read(&text), 8.0, 0.3);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        for sample in &record.samples {
            let block = (sample.coordinates[1] - 1.0).max(0.0);
            near("the block", sample.coordinates[0], block, 1e-12);
            let force = sample.forces.as_ref().unwrap().drives[0].force;
            let expected = if sample.t > 1.0 { -load } else { 0.0 };
            near("the drive's force", force, expected, 1e-9);
        }
    }
}

/// A block that is pushed over the edge of a table tips when its middle passes the edge; on a slope the pusher itself jams.
#[test]
fn a_block_is_pushed_until_it_tips() {
    let scene = |table: &str| {
        format!(
            r#"
[[part]]
name = "table"
motion = {{ type = "fixed" }}
loops = [{table}]
[[part]]
name = "block"
start = [0, 1, 0]
loops = [[[-2, -1], [2, -1], [2, 1], [-2, 1]]]
[[part]]
name = "pusher"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [{{ circle = 0.7, at = [-4, 1] }}]
[[drive]]
part = "pusher"
rate = 5
[[load]]
part = "block"
force = [0, -10]
"#
        )
    };
    let table = "[[-50, -20], [60, -20], [60, -10], [20, -10], [20, 0], [-50, 0]]";
    let (_, record) = run(&read(&scene(table)), 8.0, 0.1);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let snaps: Vec<f64> = (record.events.iter())
        .filter(|e| e.kind == EventKind::Snap)
        .map(|e| e.t)
        .collect();
    assert_eq!(snaps.len(), 1, "{:?}", record.events);
    // The middle is 2.7 before the pusher's, which begins at -4.
    near("when it tips", snaps[0], (20.0 - 2.7 + 4.0) / 5.0, 1e-9);
    let end = &record.samples.last().unwrap().coordinates;
    near("it lies below", end[1], -8.0, 1e-9);
    let slope = "[[-50, -20], [90, -20], [90, 8], [40, 8], [20, 0], [-50, 0]]";
    let (_, record) = run(&read(&scene(slope)), 8.0, 0.1);
    assert_eq!(record.status, Status::Jammed, "{:?}", record.reason);
    // The pusher's disc meets the slope, 2 up for 5 along: its centre is 0.7 from it.
    let along = 20.0 + 2.5 - 0.7 * 29.0_f64.sqrt() / 2.0;
    near("when it jams", record.until, (along + 4.0) / 5.0, 1e-9);
}

/// A plate on a driven carriage is pushed at a point beside their joint, across the direction in which that is free.
#[test]
fn a_joint_carries_a_force_and_its_moment() {
    let text = r#"
[[part]]
name = "carriage"
motion = { type = "prismatic", direction = [1, 0] }
loops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]
[[part]]
name = "plate"
loops = [[[-1, 3], [1, 3], [1, 5], [-1, 5]]]
[[joint]]
type = "prismatic"
direction = [0, 1]
parts = ["carriage", "plate"]
[[load]]
part = "plate"
force = [3, 0]
at = [0, 2]
[[drive]]
part = "carriage"
rate = 1
"#;
    let (_, record) = run(&read(text), 1.0, 0.25);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for sample in &record.samples {
        let forces = sample.forces.as_ref().unwrap();
        near("along", forces.joints[0].force[0], -3.0, 1e-12);
        near("across", forces.joints[0].force[1], 0.0, 1e-12);
        near("torque", forces.joints[0].torque, 6.0, 1e-12);
        near("drive", forces.drives[0].force, -3.0, 1e-12);
    }
}

/// A lever takes its two notches under a spring's plunger four times. A round nose of a radius smaller than the notch rolls through it and is
/// in touch all the time; one that is wider stands on its corners, and changes over from one to the other in the middle of the notch.
#[test]
fn like_passes_are_told_alike() {
    for (nose, passes) in [(1.5, 0), (2.5, 4), (3.0, 4), (6.0, 4), (20.0, 4)] {
        let model = read(&format!(
            r#"
[[part]]
name = "lever"
motion = {{ type = "revolute", center = [0, 0], range = ["-60deg", "60deg"] }}
loops = [[
  ["20*cos(-35deg)", "20*sin(-35deg)"], {{ arc_to = ["20*cos(-25deg)", "20*sin(-25deg)"], center = [0, 0] }},
  {{ arc_to = ["20*cos(-15deg)", "20*sin(-15deg)"], radius = 2.2, direction = "cw" }},
  {{ arc_to = ["20*cos(15deg)", "20*sin(15deg)"], center = [0, 0] }},
  {{ arc_to = ["20*cos(25deg)", "20*sin(25deg)"], radius = 2.2, direction = "cw" }},
  {{ arc_to = ["20*cos(35deg)", "20*sin(35deg)"], center = [0, 0] }},
  ["8*cos(60deg)", "8*sin(60deg)"], {{ arc_to = ["8*cos(-60deg)", "8*sin(-60deg)"], center = [0, 0] }},
]]
[[part]]
name = "plunger"
motion = {{ type = "prismatic", direction = [1, 0], range = [-12, 5] }}
loops = [[[21.5, -1.5], [30, -1.5], [30, 1.5], [21.5, 1.5], {{ arc_to = [21.5, -1.5], radius = {nose:?} }}]]
[[load]]
part = "plunger"
force = [-2000, 0]
[[drive]]
part = "lever"
table = [[0, 0], [1, "30deg"], [2, "55deg"], [3, 0], [4, "-55deg"], [5, 0]]
"#
        ));
        let (_, record) = run(&model, 5.0, 0.02);
        assert_eq!(record.status, Status::Done, "{nose}: {:?}", record.reason);
        let later: Vec<_> = record.events.iter().filter(|e| e.t > 0.0).collect();
        let kinds: Vec<_> = later.iter().map(|e| e.kind).collect();
        assert_eq!(
            kinds,
            [EventKind::Release, EventKind::Touch].repeat(passes),
            "{nose}"
        );
        for event in later {
            let there = record.trace.iter().find(|s| s.t == event.t).unwrap();
            let lever = there.coordinates[0].abs();
            near("the middle of the notch", lever, 20_f64.to_radians(), 1e-12);
        }
    }
}
