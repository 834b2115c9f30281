//! Friction where forces balance, against statics.

use cspace_motion::{
    ContactForce, EventKind, Record, Report, Sample, Settings, Simulation, Status, What,
};
use cspace_oracle::effort;

use crate::motion::helpers::{at, model, near, read, run, thrown_model};

fn times(record: &Record, kind: EventKind) -> Vec<f64> {
    let of_kind = record.events.iter().filter(|e| e.kind == kind);
    of_kind.map(|e| e.t).collect()
}

/// The contacts of a sample, ends of ranges left out.
fn contacts(sample: &Sample) -> Vec<ContactForce> {
    let all = sample.forces.iter().flat_map(|f| &f.contacts);
    all.filter(|c| matches!(c.what, What::Contact { .. }))
        .cloned()
        .collect()
}

/// A wedge that slides, under a follower that is pressed down on its slope.
fn wedge(slope: f64, friction: f64, pressed: &str) -> cspace_model::Mechanism {
    let (rise, up) = (100.0 * slope, 5.0 * (1.0 + slope));
    read(&format!(
        r#"
friction = {friction:?}
[[part]]
name = "wedge"
motion = {{ type = "prismatic", direction = [1, 0], range = [-200, 200] }}
loops = [[[-50, 0], [50, 0], [50, {rise:?}]]]
[[part]]
name = "follower"
motion = {{ type = "prismatic", direction = [0, 1], range = [-100, 100] }}
loops = [[[0, {0:?}], [5, {1:?}], [5, 300], [-5, 300], [-5, {2:?}]]]
{pressed}
"#,
        0.5 * rise,
        0.5 * rise + up,
        0.5 * rise + 5.0
    ))
}

/// The force on the wedge along its guide is N (sin α − μ cos α): it gives way if and only if μ < tan α.
#[test]
fn a_wedge_jams_beyond_the_angle_of_friction() {
    for slope in [0.1, 0.364, 1.0, 3.0] {
        for (share, gives_way) in [(1.0 - 1e-6, true), (1.0 + 1e-6, false)] {
            let driven = "[[drive]]\npart = \"follower\"\nrate = -2\n";
            let (_, record) = run(&wedge(slope, slope * share, driven), 1.0, 0.1);
            let status = if gives_way {
                Status::Done
            } else {
                Status::Jammed
            };
            assert_eq!(
                record.status, status,
                "{slope} {share}: {:?}",
                record.reason
            );
            if gives_way {
                let moved = record.samples.last().unwrap().coordinates[0];
                near("the wedge's way", moved, 2.0 / slope, 1e-12);
            } else {
                assert!(record.obstacles.iter().all(|o| o.multiplier > 0.0));
            }
            let loaded = "[[load]]\npart = \"follower\"\nforce = [0, -50]\n";
            let (_, record) = run(&wedge(slope, slope * share, loaded), 1.0, 0.1);
            assert_eq!(record.status, Status::Done, "{:?}", record.reason);
            let snaps = times(&record, EventKind::Snap).len();
            assert_eq!(
                snaps,
                usize::from(gives_way),
                "{slope} {share}: {:?}",
                record.events
            );
        }
    }
}

/// A block on a table, drawn by a spring whose other end goes to and fro: it lies still until the spring pulls with μ W, and then follows.
#[test]
fn a_block_on_a_spring_sticks_and_slips() {
    let (friction, weight, stiffness) = (0.3, 20.0, 4.0);
    let mechanism = read(&format!(
        r#"
friction = {friction}
[[part]]
name = "hand"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [{{ circle = 0.1, at = [20, 0.3] }}]
[[part]]
name = "table"
motion = {{ type = "fixed" }}
loops = [[[-90, -1], [90, -1], [90, 0], [-90, 0]]]
[[part]]
name = "block"
loops = [[[-2, 0], [2, 0], [2, 1], [-2, 1]]]
[[drive]]
part = "hand"
table = [[0, 0], [1, 6], [2, -3], [3, 4], [4, 4]]
[[load]]
part = "block"
force = [0, -{weight}]
[[spring]]
parts = ["block", "hand"]
at = [[0, 0.3], [20, 0.3]]
stiffness = {stiffness}
length = 20
"#
    ));
    let (_, record) = run(&mechanism, 4.0, 1e-3);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let slack = friction * weight / stiffness;
    let mut at = 0.0_f64;
    let mut slips = Vec::new();
    for sample in &record.samples {
        let [hand, x, y, theta] = sample.coordinates[..] else {
            panic!("{:?}", sample.coordinates)
        };
        if (hand - at).abs() > slack && slips.last().is_none_or(|&(s, _)| s != (hand > at)) {
            slips.push((hand > at, sample.t));
        }
        at = at.clamp(hand - slack, hand + slack);
        // The hand turns around between samples.
        near("the block", x, at, 2e-5);
        assert!(y.abs() < 1e-9 && theta.abs() < 1e-9, "{y} {theta}");
        let all = contacts(sample);
        let normal: f64 = all.iter().map(|c| c.normal).sum();
        let tangential: f64 = all.iter().map(|c| c.tangential).sum();
        near("the weight", normal, weight, 1e-7);
        near(
            "the spring",
            tangential.abs(),
            (stiffness * (hand - x)).abs(),
            1e-6,
        );
        assert!(tangential.abs() <= friction * normal * (1.0 + 1e-9));
    }
    let told = times(&record, EventKind::Slip);
    // Both corners slip at once.
    let mut each = told.clone();
    each.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    assert_eq!(each.len(), slips.len(), "{:?} {slips:?}", record.events);
    for (told, (_, seen)) in each.iter().zip(&slips) {
        assert!((told - seen).abs() < 1.001e-3, "{told} {seen}");
    }
}

/// A wheel that a load presses on a belt rolls with it, and a block lies on it: nothing slips, however the belt is driven.
#[test]
fn what_sticks_does_not_creep() {
    let text = r#"
friction = 0.4
[[part]]
name = "belt"
motion = { type = "prismatic", direction = [1, 0] }
loops = [[[-90, -1], [90, -1], [90, 0], [-90, 0]]]
[[part]]
name = "wheel"
loops = [{ circle = 2, at = [0, 2] }]
[[part]]
name = "block"
loops = [[[-22, 0], [-18, 0], [-18, 1], [-22, 1]]]
[[part]]
name = "carriage"
motion = { type = "prismatic", direction = [0, 1] }
loops = [{ circle = 0.5, at = [0, 30] }]
[[joint]]
parts = ["carriage", "wheel"]
type = "revolute"
at = [0, 2]
[[load]]
part = "wheel"
force = [0, -10]
at = [0, 2]
[[load]]
part = "block"
force = [0, -10]
[[drive]]
part = "belt"
table = [[0, 0], [1, 6], [2, 10], [3, 6], [4, -3]]
"#;
    let (_, record) = run(&read(text), 4.0, 0.05);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for sample in &record.samples {
        let [belt, _, _, turned, x, y, theta, ..] = sample.coordinates[..] else {
            panic!("{:?}", sample.coordinates)
        };
        near("the wheel", turned, 0.5 * belt, 1e-10);
        near("the block", x, belt, 1e-10);
        assert!(y.abs() < 1e-10 && theta.abs() < 1e-10);
    }
    assert_eq!(times(&record, EventKind::Slip), [0.0; 0]);
}

/// A block on a table that tilts slides down to a lip as soon as it is beyond the angle of friction.
#[test]
fn a_block_slides_off_beyond_the_angle_of_friction() {
    for friction in [0.3, 0.41] {
        let (_, record) = run(
            &read(&format!(
                r#"
friction = {friction}
[[part]]
name = "table"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [[[-20, -1], [20, -1], [20, 0], [-15, 0], [-15, 2], [-20, 2]]]
[[part]]
name = "block"
loops = [[[-2, 0], [2, 0], [2, 1], [-2, 1]]]
[[load]]
part = "block"
force = [0, -10]
[[drive]]
part = "table"
rate = "30deg"
"#
            )),
            1.0,
            0.01,
        );
        assert_eq!(
            record.status,
            Status::Done,
            "{friction}: {:?}",
            record.reason
        );
        let snaps = times(&record, EventKind::Snap);
        let [snap] = snaps[..] else {
            panic!("{friction}: {:?}", record.events)
        };
        near(
            "when it slides",
            snap,
            f64::atan(friction) / (30.0_f64).to_radians(),
            1e-7,
        );
        let last = &record.samples.last().unwrap().coordinates;
        // The middle of its lower side is 13 down from the pivot.
        let (sin, cos) = last[0].sin_cos();
        near("where it lies, x", last[1], -13.0 * cos, 1e-9);
        near("and y", last[2], -13.0 * sin, 1e-9);
    }
}

/// A lever on a torsion spring is pushed along a ramp: N presses on its tip, μ N opposes its sliding, and the spring
/// balances both about the pivot; the drive bears their component along its direction.
#[test]
fn insertion_takes_the_force_of_statics() {
    let (stiffness, arm) = (500.0, 10.0_f64);
    for slope_deg in [10.0_f64, 30.0, 45.0, 60.0] {
        for friction in [0.0, 0.1, 0.35] {
            let slope = slope_deg.to_radians();
            let (run_up, tan) = (30.0, slope.tan());
            let mechanism = read(&format!(
                r#"
friction = {friction}
[[part]]
name = "carriage"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [{{ circle = 0.5, at = [0, 30] }}]
[[part]]
name = "lever"
loops = [[[-1, -0.2], [{arm}, -0.1], [{arm}, 0], [-1, 0.2]]]
[[part]]
name = "ramp"
motion = {{ type = "fixed" }}
loops = [[[{0:?}, -0.3], [{1:?}, -0.3], [{1:?}, {2:?}]]]
[[joint]]
parts = ["carriage", "lever"]
type = "revolute"
at = [0, 0]
[[drive]]
part = "carriage"
rate = 1
[[spring]]
parts = ["lever", "carriage"]
type = "torsion"
stiffness = {stiffness}
angle = 0
"#,
                arm + 0.1,
                arm + 0.1 + run_up,
                -0.3 + run_up * tan,
            ));
            let (_, record) = run(&mechanism, 3.0, 0.01);
            assert_eq!(
                record.status,
                Status::Done,
                "{slope_deg} {friction}: {:?}",
                record.reason
            );
            let mut pressed = 0;
            for sample in &record.samples {
                let all = contacts(sample);
                let [contact] = &all[..] else { continue };
                pressed += 1;
                let theta = sample.coordinates[3];
                // The lower corner of the tip.
                let (x, y) = (
                    arm * theta.cos() + 0.1 * theta.sin(),
                    arm * theta.sin() - 0.1 * theta.cos(),
                );
                let (n, up) = ([-slope.sin(), slope.cos()], [slope.cos(), slope.sin()]);
                let along = [0, 1].map(|k| n[k] - friction * up[k]);
                let normal = stiffness * theta / (x * along[1] - y * along[0]);
                near(
                    "the contact's force",
                    contact.normal,
                    normal,
                    1e-9 * normal.abs().max(1.0),
                );
                near(
                    "friction",
                    contact.tangential.abs(),
                    friction * normal,
                    1e-9 * normal.abs().max(1.0),
                );
                let drive = sample.forces.as_ref().unwrap().drives[0].force;
                near(
                    "the drive's force",
                    drive,
                    -normal * along[0],
                    1e-8 * normal.abs().max(1.0),
                );
            }
            assert!(pressed > 100, "{pressed}");
        }
    }
}

/// A peg in a compliant grip is pushed down a slope and onto a floor: springs, forces of contacts and cones of friction balance about any point.
#[test]
fn a_compliant_peg_is_in_balance_on_a_chamfer() {
    // Where the springs hold the peg, and where the grip holds them at zero motion.
    let springs = [
        ([-2.0, 8.0], [-12.0, 8.0], 40.0),
        ([2.0, 8.0], [12.0, 8.5], 30.0),
        ([0.0, 10.0], [0.3, 20.0], 25.0),
        ([-2.0, 4.0], [-12.0, 3.0], 20.0),
    ];
    for friction in [0.0, 0.05, 0.2, 0.6] {
        let mut text = format!(
            r#"
friction = {friction}
[[part]]
name = "grip"
motion = {{ type = "prismatic", direction = [0, 1] }}
loops = [{{ circle = 0.5, at = [0, 40] }}]
[[part]]
name = "hole"
motion = {{ type = "fixed" }}
loops = [[[-30, -9], [30, -9], [30, 0], [3, -6], [3, -7], [-3, -7], [-3, -6], [-30, 0]]]
[[part]]
name = "peg"
loops = [[[-2, 0.5], [-1.5, 0], [1.5, 0], [2, 0.5], [2, 10], [-2, 10]]]
[[drive]]
part = "grip"
rate = -1
"#
        );
        for (at, from, stiffness) in springs {
            let length = f64::hypot(at[0] - from[0], at[1] - from[1]);
            text += &format!(
                "[[spring]]\nparts = [\"peg\", \"grip\"]\nat = [{at:?}, {from:?}]\nstiffness = {stiffness:?}\nlength = {length:?}\n"
            );
        }
        let (_, record) = run(&read(&text), 9.0, 0.05);
        assert_eq!(
            record.status,
            Status::Done,
            "{friction}: {:?}",
            record.reason
        );
        let mut pressed = 0;
        for sample in &record.samples {
            let [grip, x, y, theta] = sample.coordinates[..] else {
                panic!("{:?}", sample.coordinates)
            };
            let (mut sum, mut largest) = ([0.0; 3], 1.0_f64);
            let mut add = |[px, py]: [f64; 2], [fx, fy]: [f64; 2]| {
                for (sum, f) in sum.iter_mut().zip([fx, fy, px * fy - py * fx]) {
                    *sum += f;
                    largest = largest.max(f.abs());
                }
            };
            for (at, from, stiffness) in springs {
                let (s, c) = theta.sin_cos();
                let p = [x + c * at[0] - s * at[1], y + s * at[0] + c * at[1]];
                let to = [from[0] - p[0], from[1] + grip - p[1]];
                let length = f64::hypot(at[0] - from[0], at[1] - from[1]);
                let pull = stiffness * (1.0 - length / to[0].hypot(to[1]));
                add(p, to.map(|d| pull * d));
            }
            // Normals of the hole from those of its sides; the tip of the peg lies on them.
            for contact in contacts(sample) {
                pressed += 1;
                let at = contact.at.unwrap();
                let n = match at {
                    [px, py] if py < -6.999_999 && px.abs() < 3.0 => [0.0, 1.0],
                    [px, py] if px.abs() < 3.000_001 && py < -6.0 => [-px.signum(), 0.0],
                    [px, _] => {
                        let l = f64::hypot(6.0, 27.0);
                        [-px.signum() * 6.0 / l, 27.0 / l]
                    }
                };
                assert!(contact.tangential.abs() <= friction * contact.normal * (1.0 + 1e-9));
                let t = [-n[1], n[0]];
                add(
                    at,
                    [0, 1].map(|k| n[k] * contact.normal + t[k] * contact.tangential),
                );
            }
            for sum in sum {
                assert!(
                    sum.abs() < 1e-8 * largest,
                    "{friction} {}: {sum:e}",
                    sample.t
                );
            }
        }
        assert!(pressed > 40, "{pressed}");
    }
}

/// A sleeve hangs on its pole by friction, and slides off without.
#[test]
fn a_sleeve_hangs_on_its_pole_by_friction() {
    let settings = Settings {
        time: effort(1.0, 2.5),
        every: None,
    };
    let of = |friction: bool| {
        let mut mechanism = model("woodpecker");
        if !friction {
            mechanism.dynamics.friction = 0.0;
            mechanism
                .dynamics
                .pairs
                .iter_mut()
                .for_each(|p| p.friction = None);
        }
        Simulation::new(&mechanism)
            .unwrap()
            .kinematic(&settings)
            .unwrap()
    };
    assert_eq!(of(true).status, Status::Done);
    let record = of(false);
    assert_eq!(record.status, Status::Undetermined);
    assert!(record.reason.unwrap().starts_with("nothing stops"));
}

/// A drawer of depth L in its cabinet that is pushed beside its middle by e touches at two points, and jams if and only if these are less
/// than 2 μ e apart along it, whether a load or a driven finger pushes it. Beyond that it may also be held by pressing the two against each
/// other, which nothing does: it goes home.
#[test]
fn a_drawer_goes_home_where_it_can() {
    let (friction, beside) = (0.1, 25.0);
    let load = format!("[[load]]\npart = \"drawer\"\nforce = [0, -10000]\nat = [{beside}, 340]\n");
    let finger = format!(
        "[[part]]\nname = \"finger\"\nmotion = {{ type = \"prismatic\", direction = [0, -1] }}\nloops = [{{ circle = 3, at = [{beside}, 353] }}]\n\
         [[drive]]\npart = \"finger\"\nrate = 310\n[[pair]]\nfixed = \"cabinet\"\nmoving = \"drawer\"\n\
         [[pair]]\nfixed = \"finger\"\nmoving = \"drawer\"\nfriction = 0\n"
    );
    for pushed in [&load, &finger] {
        let mut jams = 0;
        for depth in [4.0, 4.5, 5.0, 5.25, 5.5, 6.0, 6.5, 7.5, 10.0] {
            let (_, record) = run(
                &read(&format!(
                    r#"
friction = {friction}
[[part]]
name = "cabinet"
motion = {{ type = "fixed" }}
loops = [[[50.0005, 0], [70, 0], [70, -320], [-70, -320], [-70, 0], [-50.0005, 0], [-50.0005, -300], [50.0005, -300]]]
[[part]]
name = "drawer"
loops = [[[-50, -{depth:?}], [50, -{depth:?}], [50, 350], [-50, 350]]]
{pushed}"#
                )),
                1.0,
                0.5,
            );
            let down = -record.samples.last().unwrap().coordinates[1];
            let apart = depth + down;
            let jammed = apart < 2.0 * friction * beside;
            // What a load pushes comes to rest where it jams; a finger cannot go on, not even at the end of the cabinet.
            let status = match *pushed == load {
                true => Status::Done,
                false => Status::Jammed,
            };
            assert_eq!(record.status, status, "{depth}: {:?}", record.reason);
            if jammed {
                jams += 1;
                assert_eq!(record.obstacles.len(), if *pushed == load { 0 } else { 3 });
            } else {
                // The end of the cabinet.
                near(&format!("{depth}"), apart, 300.0, 1e-2);
            }
        }
        assert_eq!(jams, 2, "{pushed}");
    }
}

/// A tappet with a round foot on an eccentric stands upright in its guide, under a spring that pushes it down from above: it falls to a wall
/// of the guide, rolling on the cam, and is lifted by it. The middle of the foot is as far from that of the cam as both radii together.
#[test]
fn a_tappet_that_stands_upright_rolls_off_and_is_lifted() {
    let (_, record) = run(
        &read(
            r#"
friction = 0.12
[[part]]
name = "guide"
motion = { type = "fixed" }
loops = [[[-20, 30], [-5.02, 30], [-5.02, 50], [-20, 50]], [[5.02, 30], [20, 30], [20, 50], [5.02, 50]]]
[[part]]
name = "cam"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 15, at = [0, 4] }]
[[part]]
name = "tappet"
loops = [[[-5, 25], { arc_to = [5, 25], radius = 5 }, [5, 70], [-5, 70]]]
[[spring]]
parts = ["tappet"]
at = [[0, 70], [0, 100]]
stiffness = 2000
length = 50
[[drive]]
part = "cam"
rate = "360deg"
"#,
        ),
        1.0,
        0.01,
    );
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for sample in &record.samples {
        let [turn, x, y, tilt] = sample.coordinates[..] else {
            panic!("four coordinates")
        };
        let foot = [x - 25.0 * tilt.sin(), y + 25.0 * tilt.cos()];
        let cam = [-4.0 * turn.sin(), 4.0 * turn.cos()];
        let apart = f64::hypot(foot[0] - cam[0], foot[1] - cam[1]);
        near(&format!("{}", sample.t), apart, 20.0, 1e-9);
        // Upright it stands free at the start only, and then flat on a wall. Its clearance lets it tilt by 0.04 over the 20 of the guide.
        let leans = (1e-5..2.1e-3).contains(&tilt.abs()) || (x.abs() - 0.02).abs() < 1e-9;
        assert!(sample.t == 0.0 || leans, "{tilt} at {}", sample.t);
    }
}

/// The ratchet with friction at all contacts: the tooth that holds the pawl lets it go where its round is steeper than the angle of friction.
/// Friction changes when that is, and not where a turn of the driver takes the parts.
#[test]
fn a_ratchet_with_friction_goes_through_its_cycle() {
    let ends = [0.0, 0.1].map(|friction| {
        let mut ratchet = model("ratchet_mechanism");
        ratchet.dynamics.friction = friction;
        let (_, record) = run(&ratchet, 1.0, 0.01);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        let sticks = times(&record, EventKind::Stick);
        assert_eq!(sticks.is_empty(), friction == 0.0, "{sticks:?}");
        record.samples.last().unwrap().coordinates.clone()
    });
    for (without, with) in ends[0].iter().zip(&ends[1]) {
        near("after a turn", *with, *without, 1e-9);
    }
}

/// A strike comes down with its round on the slanted face of a bolt, passes its tip, and lets it spring out below: the bolt gives way if and
/// only if its face is steeper than the angle of friction.
#[test]
fn a_round_passes_the_tip_of_a_bolt() {
    let friction = 0.2_f64;
    let count = effort(12, 200);
    let across = |i: usize| {
        0.15 + 0.5 * f64::from(u32::try_from(i).unwrap()) / f64::from(u32::try_from(count).unwrap())
    };
    for slant in
        (0..count)
            .map(across)
            .chain([0.34, friction.atan() + 1e-6, friction.atan() - 1e-6])
    {
        let run_out = 6.0 / slant.tan();
        let model = read(&format!(
            r#"
friction = {friction:?}
[[part]]
name = "strike"
motion = {{ type = "prismatic", direction = [0, 1], range = [-2, 40] }}
loops = [[[3, -13], {{ fillet = 1.5 }}, [23, -13], [23, -3.3], [3, -3.3]]]
[[part]]
name = "bolt"
motion = {{ type = "prismatic", direction = [1, 0], range = [-14, 0] }}
loops = [[[-40, -3], [12, -3], [{:?}, 3], [-40, 3]]]
[[drive]]
part = "strike"
table = [[0, 30], [1, 0]]
[[spring]]
parts = ["bolt"]
at = [[-40, 0], [-60, 0]]
stiffness = 500
length = 30
"#,
            12.0 - run_out
        ));
        let (_, record) = run(&model, 1.1, 0.01);
        let reason = &record.reason;
        if slant > friction.atan() {
            assert_eq!(record.status, Status::Done, "{slant}: {reason:?}");
            // The upper corner of the strike has passed the lower side of the bolt, 0.3 farther.
            let out = times(&record, EventKind::Snap);
            assert_eq!(out.len(), 1, "{slant}");
            near("the bolt comes out", out[0], 0.99, 1e-9);
        } else {
            assert_eq!(record.status, Status::Jammed, "{slant}: {reason:?}");
        }
    }
}

/// Two flat pins under a spring stand on each other in the bore of a plug that turns: each touches with roundings at both sides. The upper
/// one is caught by the shell, and stays there as the plug takes the lower one along.
#[test]
fn two_pins_stand_in_a_bore() {
    let lock = include_str!("../../../../cspace-cli/tests/models/tumbler_pin.toml");
    let lock = lock
        .replace("gravity=[0,-9810]", "")
        .replace("density = 5e-5", "");
    let time = if effort(0, 1) == 1 { 2.0 } else { 0.1 };
    let (_, record) = run(&read(&lock), time, 0.02);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let [plug, .., upper] = at(&record, time) else {
        panic!("two pins in a plug")
    };
    near("the plug", *plug, time * 30_f64.to_radians(), 1e-12);
    // It has 0.05 of play in the bore of the shell, over some 5 of its length.
    assert!(upper.abs() < 0.02, "{upper}");
}

/// A bar goes to and fro under a roller that rubs on it: at a point of its table at which it stands for an instant, friction changes its
/// direction, and nothing else happens.
#[test]
fn what_turns_round_rubs_the_other_way() {
    let model = read(
        r#"
friction = 0.3
[[part]]
name = "bar"
motion = { type = "prismatic", direction = [1, 0], range = [-60, 60] }
loops = [[[-50, -10], [50, -10], [50, 0], [-50, 0]]]
[[part]]
name = "roller"
motion = { type = "prismatic", direction = [0, 1], range = [-8, 20] }
loops = [{ circle = 2, at = [0, 2] }]
[[load]]
part = "roller"
force = [0, -3000]
[[drive]]
part = "bar"
table = [[0, 0], [1, -20], [2, 0], [3, -20], [4, 0]]
"#,
    );
    let (_, record) = run(&model, 4.0, 0.1);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for sample in record.samples.iter().filter(|s| s.rates[0].abs() > 1.0) {
        let [contact] = &contacts(sample)[..] else {
            panic!("one contact at {}", sample.t)
        };
        // The bar takes the roller along, and the force is counted to the left of the normal, which points up.
        let way = -sample.rates[0].signum();
        near("it rubs", contact.tangential, way * 900.0, 1e-6);
    }
}

/// A roller lies on a belt under a ramp that comes down by an angle α along it, in a corner into which the belt drives it and a load pushes
/// it: by the moments about its middle both contacts bear the same friction, and it locks if and only if tan (α/2) ≤ μ. With masses, too; and
/// the other way the belt runs.
#[test]
fn a_roller_locks_a_belt_within_twice_the_angle_of_friction() {
    for (friction, degrees) in [
        (0.1, 2.0),
        (0.1, 6.0),
        (0.1, 11.0),
        (0.1, 11.4),
        (0.1, 11.5),
        (0.1, 14.0),
        (0.3, 30.0),
        (0.3, 35.0),
    ] {
        let angle = f64::to_radians(degrees);
        let locks = (0.5 * angle).tan() <= friction;
        let (along, across) = ((angle.cos(), -angle.sin()), (angle.sin(), angle.cos()));
        let corner = |s: f64, up: f64| {
            let at = (
                10.0 * across.0 + s * along.0 + up * across.0,
                10.0 + 10.0 * across.1 + s * along.1 + up * across.1,
            );
            format!("[{:?}, {:?}]", at.0, at.1)
        };
        let ramp = [(-60.0, 0.0), (40.0, 0.0), (40.0, 30.0), (-60.0, 30.0)];
        let ramp = ramp.map(|(s, up)| corner(s, up)).join(", ");
        for (mass, rate) in [("", 5.0), ("mass = 0.01\n", 5.0), ("", -5.0)] {
            let mechanism = read(&format!(
                r#"
friction = {friction}
[[part]]
name = "ramp"
motion = {{ type = "fixed" }}
loops = [[{ramp}]]
[[part]]
name = "belt"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [[[-200, -20], [200, -20], [200, 0], [-200, 0]]]
[[part]]
name = "roller"
{mass}loops = [{{ circle = 10, at = [0, 10] }}]
[[drive]]
part = "belt"
rate = {rate:?}
[[load]]
part = "roller"
force = [10, 0]
[[pair]]
fixed = "ramp"
moving = "roller"
[[pair]]
fixed = "belt"
moving = "roller"
"#
            ));
            let (_, record) = match mass {
                "" => run(&mechanism, 1.0, 0.1),
                _ => thrown_model(&mechanism, 1.0, 1.0),
            };
            let status = match locks && rate > 0.0 {
                true => Status::Jammed,
                false => Status::Done,
            };
            let told = format!("{friction} {degrees} {mass}{rate}: {:?}", record.reason);
            assert_eq!(record.status, status, "{told}");
        }
    }
}

/// A bolt with a slanted nose has play in its guide, and a spring; a round strike comes up against the slant. Where friction lets it go by,
/// the spring brings the bolt to where it is slack, 10 to the right.
#[test]
fn a_bolt_with_play_gives_way_and_comes_back() {
    for friction in [0.0, 0.1, 0.15, 0.2, 0.25] {
        let (simulation, record) = run(
            &read(&format!(
                r#"
friction = {friction}
[[part]]
name = "bolt"
loops = [[[-60, -5], [10, -5], [20, 5], [-60, 5]]]
[[part]]
name = "top"
motion = {{ type = "fixed" }}
loops = [[[-40, 5.05], [0, 5.05], [0, 20], [-40, 20]]]
[[part]]
name = "bottom"
motion = {{ type = "fixed" }}
loops = [[[-40, -20], [0, -20], [0, -5.05], [-40, -5.05]]]
[[part]]
name = "strike"
motion = {{ type = "prismatic", direction = [0, 1] }}
loops = [{{ circle = 2, at = [17.414213562373096, -2.414213562373095] }}]
[[spring]]
parts = ["bolt"]
at = [[-60, 0], [-100, 0]]
stiffness = 500
length = 50
[[drive]]
part = "strike"
rate = 5
[[pair]]
fixed = "top"
moving = "bolt"
[[pair]]
fixed = "bottom"
moving = "bolt"
[[pair]]
fixed = "strike"
moving = "bolt"
"#
            )),
            3.0,
            0.05,
        );
        assert_eq!(
            record.status,
            Status::Done,
            "{friction}: {:?}",
            record.reason
        );
        let bolt = record.samples.last().unwrap().coordinates[0];
        near("the bolt", bolt, 10.0, 1e-3);
        // The bolt stands then, and the strike goes on: that is no cycle.
        assert_eq!(Report::of(&simulation, &record).cycle, None);
        let snaps = times(&record, EventKind::Snap);
        // The strike goes by the tip, which stands 5 above the middle, about when its own middle does.
        assert!(
            snaps.iter().any(|t| (1.4..1.8).contains(t)),
            "{friction}: {snaps:?}"
        );
    }
}

/// A lever under a spring that comes over its middle is pushed up: it snaps to its upper end, and the pusher follows until it meets it there.
/// Friction changes none of it.
#[test]
fn a_toggle_snaps_over_with_friction() {
    // Each with a point of the pusher, and how far it is from the lever's middle line in contact.
    let round = ("{ circle = 1, at = [8, -12] }", [8.0, -12.0], 2.0);
    let tip = ("[[7, -13], [9, -13], [8, -11]]", [8.0, -11.0], 1.0);
    let flat = (
        "[[7, -13], [9, -13], [9, -11], [7, -11]]",
        [7.0, -11.0],
        1.0,
    );
    for ((pusher, [x, y], below), off) in [
        (round, 0.0),
        (round, 0.5),
        (tip, 0.0),
        (tip, 0.5),
        (flat, 0.5),
    ] {
        for friction in [0.0, 0.2] {
            let (_, record) = run(
                &read(&format!(
                    r#"
friction = {friction}
[[part]]
name = "lever"
motion = {{ type = "revolute", center = [0, 0], range = ["-30deg", "30deg"] }}
loops = [[[0, -1], [10, -1], [10, 1], [0, 1]]]
start = "-30deg"
[[part]]
name = "pusher"
motion = {{ type = "prismatic", direction = [0, 1] }}
loops = [{pusher}]
[[spring]]
parts = ["lever"]
at = [[10, 0], [40, {off}]]
stiffness = 20
length = 45
[[drive]]
part = "pusher"
rate = 2
"#
                )),
                8.0,
                0.1,
            );
            assert_eq!(
                record.status,
                Status::Jammed,
                "{friction} {pusher} {off}: {:?}",
                record.reason
            );
            let snaps = times(&record, EventKind::Snap);
            assert!(
                snaps.len() == 1 && (5.0..5.1).contains(&snaps[0]),
                "{snaps:?}"
            );
            // There −x sin 30° + y cos 30° = −below.
            let up = (0.5 * x - below) / 0.75_f64.sqrt();
            near(pusher, record.until, 0.5 * (up - y), 1e-9);
        }
    }
}
