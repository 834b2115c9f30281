//! Joints, springs and drives with known answers.

use cspace_motion::{Settings, Simulation, Status};

use crate::motion::helpers::{balanced, near, read, thrown};

const G: f64 = 9.81;

/// The arithmetic-geometric mean.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..60 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    a
}

const BASE: &str = r#"
[[part]]
name = "base"
motion = { type = "fixed" }
loops = [ [[-1, 20], [1, 20], [1, 22], [-1, 22]] ]
"#;

#[test]
fn a_pendulum_by_both_kinds_of_coordinates() {
    // About its pivot: 1.5² · 2 + 0.7.
    let (mass, own, arm) = (2.0, 0.7, 1.5);
    let inertia: f64 = own + mass * arm * arm;
    let body = "loops = [ [[-0.1, -3], [0.1, -3], [0.1, 0], [-0.1, 0]] ]\nmass = 2\ninertia = 0.7\ncenter_of_mass = [0, -1.5]\n";
    for swing in [0.3, 1.5, 3.0] {
        let period = std::f64::consts::TAU * f64::sqrt(inertia / (mass * G * arm))
            / mean(1.0, f64::cos(swing / 2.0));
        let on_axis = format!(
            "gravity = [0, -{G}]\n{BASE}\n[[part]]\nname = \"bob\"\nmotion = {{ type = \"revolute\", center = [0, 0] }}\n{body}start = {swing}\n"
        );
        let free = format!(
            "gravity = [0, -{G}]\n{BASE}\n[[part]]\nname = \"bob\"\n{body}start = [0, 0, {swing}]\n[[joint]]\ntype = \"revolute\"\nparts = [\"base\", \"bob\"]\nat = [0, 0]\n"
        );
        let (_, one) = thrown(&on_axis, period, period / 64.0);
        let (_, other) = thrown(&free, period, period / 64.0);
        assert_eq!(one.status, Status::Done);
        assert_eq!(other.status, Status::Done, "{:?}", other.reason);
        assert_eq!(one.samples.len(), other.samples.len());
        for (a, b) in one.samples.iter().zip(&other.samples) {
            near("angle", b.coordinates[2], a.coordinates[0], 1e-9);
            near(
                "pivot",
                f64::hypot(b.coordinates[0], b.coordinates[1]),
                0.0,
                1e-12,
            );
            near("rate", b.rates[2], a.rates[0], 1e-8);
        }
        let at = |k: usize| one.samples[k].coordinates[0];
        near("a quarter", at(16), 0.0, 1e-9);
        near("a half", at(32), -swing, 1e-9);
        near("a whole", at(64), swing, 1e-9);
        balanced(&one, 2.0 * G * 1.5, 1e-9);
        balanced(&other, 2.0 * G * 1.5, 1e-9);
    }
}

#[test]
fn a_double_pendulum_keeps_its_energy() {
    let arm = "loops = [ [[-0.1, -1], [0.1, -1], [0.1, 0], [-0.1, 0]] ]\ndensity = 5\n";
    let text = format!(
        "gravity = [0, -{G}]\n{BASE}\n[[part]]\nname = \"upper\"\nmotion = {{ type = \"revolute\", center = [0, 0] }}\n{arm}start = 2.5\n[[part]]\nname = \"lower\"\n{arm}start = [{}, {}, 1]\n[[joint]]\ntype = \"revolute\"\nparts = [\"upper\", \"lower\"]\nat = [0, -1]\n[[pair]]\nfixed = \"base\"\nmoving = \"upper\"\n",
        f64::sin(2.5),
        -f64::cos(2.5),
    );
    let text = text.replace(
        "name = \"lower\"\nloops = [ [[-0.1, -1], [0.1, -1], [0.1, 0], [-0.1, 0]] ]",
        "name = \"lower\"\nloops = [ [[-0.1, -2], [0.1, -2], [0.1, -1], [-0.1, -1]] ]",
    );
    // The lower arm is drawn where it hangs: its joint at (0, -1).
    let text = text.replace(
        &format!("start = [{}, {}, 1]", f64::sin(2.5), -f64::cos(2.5)),
        &format!(
            "start = [{}, {}, 1]",
            f64::sin(2.5) - f64::sin(1.0),
            -f64::cos(2.5) + f64::cos(1.0)
        ),
    );
    let (_, record) = thrown(&text, 10.0, 0.1);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    balanced(&record, 1.0 * G * 2.0, 1e-8);
}

/// A crank that is driven, a coupler and a rocker: its angle has a closed form; what the drive puts in is where energy goes.
#[test]
fn a_four_bar_linkage() {
    let (crank, coupler, rocker, ground) = (1.0, 3.0, 2.5, 3.2);
    let closed = |u: f64| -> (f64, f64) {
        let (ax, ay) = (crank * u.cos(), crank * u.sin());
        let (dx, dy) = (ground - ax, -ay);
        let d = f64::hypot(dx, dy);
        let to = dy.atan2(dx);
        // The corner at the crank's end, above the diagonal.
        let at = f64::acos((coupler * coupler + d * d - rocker * rocker) / (2.0 * coupler * d));
        let (bx, by) = (
            ax + coupler * (to + at).cos(),
            ay + coupler * (to + at).sin(),
        );
        ((to + at), by.atan2(bx - ground))
    };
    let (phi, psi) = closed(0.0);
    let bar = |length: f64| format!("[[0, -0.05], [{length}, -0.05], [{length}, 0.05], [0, 0.05]]");
    let text = format!(
        r#"gravity = [0, -9.81]
[[part]]
name = "base"
motion = {{ type = "fixed" }}
loops = [ [[-1, 20], [1, 20], [1, 22], [-1, 22]] ]
[[part]]
name = "crank"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [ {} ]
density = 10
[[part]]
name = "coupler"
loops = [ {} ]
density = 10
start = [1, 0, {phi}]
[[part]]
name = "rocker"
loops = [ {} ]
density = 10
start = [3.2, 0, {psi}]
[[joint]]
type = "revolute"
parts = ["coupler", "crank"]
at = {{ coupler = [0, 0], crank = [1, 0] }}
[[drive]]
part = "crank"
rate = 4
"#,
        bar(crank),
        bar(coupler),
        bar(rocker),
    );
    // Parts are drawn where they are at the start, so that a joint has one place.
    let turned = |x: f64, y: f64, angle: f64, length: f64| {
        let (c, s) = (angle.cos(), angle.sin());
        let at = |u: f64, v: f64| format!("[{}, {}]", x + c * u - s * v, y + s * u + c * v);
        format!(
            "[{}, {}, {}, {}]",
            at(0.0, -0.05),
            at(length, -0.05),
            at(length, 0.05),
            at(0.0, 0.05)
        )
    };
    let text = text
        .replace(&format!("loops = [ {} ]", bar(coupler)), &format!("loops = [ {} ]", turned(1.0, 0.0, phi, coupler)))
        .replace(&format!("loops = [ {} ]", bar(rocker)), &format!("motion = {{ type = \"revolute\", center = [3.2, 0] }}\nloops = [ {} ]", turned(3.2, 0.0, psi, rocker)))
        .replace(&format!("start = [1, 0, {phi}]\n"), "")
        .replace(&format!("start = [3.2, 0, {psi}]\n"), "")
        .replace("parts = [\"coupler\", \"crank\"]\nat = { coupler = [0, 0], crank = [1, 0] }", &format!("parts = [\"crank\", \"coupler\"]\nat = [1, 0]\n[[joint]]\ntype = \"revolute\"\nparts = [\"coupler\", \"rocker\"]\nat = [{}, {}]", 1.0 + coupler * phi.cos(), coupler * phi.sin()))
        + "[[pair]]\nfixed = \"base\"\nmoving = \"crank\"\n";
    let time = std::f64::consts::TAU / 4.0 * 1.5;
    let (simulation, record) = thrown(&text, time, time / 1200.0);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let first = |name: &str| {
        let system = simulation.system();
        let named = |p: &cspace_model::PartEntry| p.part.name() == name;
        let i = system.mechanism().parts.iter().position(named).unwrap();
        system.parts()[i].indices().start
    };
    let rocked = first("rocker");
    for sample in &record.samples {
        let wanted = closed(4.0 * sample.t).1 - psi;
        near("rocker", sample.coordinates[rocked], wanted, 1e-9);
    }
    // The work of the drive by its powers, Simpson's rule, against the balance.
    let powers: Vec<f64> = (record.samples.iter())
        .map(|s| s.forces.as_ref().unwrap().drives[0].power)
        .collect();
    let step = time / 1200.0;
    let inner: f64 = (1..1200)
        .map(|k| powers[k] * if k % 2 == 1 { 4.0 } else { 2.0 })
        .sum();
    let work = (powers[0] + powers[1200] + inner) * step / 3.0;
    let energy = record.energy.unwrap();
    near(
        "work",
        energy.drives,
        work,
        1e-6 * energy.drives.abs().max(1.0),
    );
    near(
        "gain",
        energy.end - energy.start,
        work,
        1e-6 * work.abs().max(1.0),
    );
    balanced(&record, 50.0, 1e-9);
}

fn slider(rest: &str) -> String {
    format!(
        "{BASE}\n[[part]]\nname = \"slider\"\nmotion = {{ type = \"prismatic\", direction = [1, 0] }}\nloops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]\nmass = 3\nstart = 2\n[[spring]]\nparts = [\"slider\"]\nat = [[0, 0], [-10, 0]]\nlength = 10\n{rest}\n"
    )
}

#[test]
fn masses_on_springs_and_dampers() {
    let w = f64::sqrt(48.0 / 3.0);
    let (_, record) = thrown(&slider("stiffness = 48"), 10.0, 0.1);
    for sample in &record.samples {
        near(
            "swings",
            sample.coordinates[0],
            2.0 * (w * sample.t).cos(),
            1e-8,
        );
    }
    balanced(&record, 96.0, 1e-9);
    for damping in [0.6, 24.0, 60.0] {
        let (_, record) = thrown(
            &slider(&format!("stiffness = 48\ndamping = {damping}")),
            5.0,
            0.1,
        );
        let z = damping / (2.0 * 3.0);
        for sample in &record.samples {
            let t = sample.t;
            let x = if z < w {
                let wd = f64::sqrt(w * w - z * z);
                2.0 * (-z * t).exp() * ((wd * t).cos() + z / wd * (wd * t).sin())
            } else if z == w {
                2.0 * (1.0 + z * t) * (-z * t).exp()
            } else {
                let r = f64::sqrt(z * z - w * w);
                let (a, b) = (-z + r, -z - r);
                2.0 * (a * (b * t).exp() - b * (a * t).exp()) / (a - b)
            };
            near("decays", sample.coordinates[0], x, 1e-9);
        }
        balanced(&record, 96.0, 1e-9);
    }
}

/// Two free bodies on a spring, held off their centres: momentum and moment of momentum stay.
#[test]
fn a_spring_between_free_bodies() {
    let text = "[[part]]\nname = \"a\"\nloops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]\nmass = 2\ninertia = 1.5\nrate = [1, 0.5, -3]\n[[part]]\nname = \"b\"\nloops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]\nstart = [9, 0, 0.4]\nmass = 5\ninertia = 3\nrate = [-0.2, 1, 2]\n[[spring]]\nparts = [\"a\", \"b\"]\nat = [[0.8, 0.5], [8.2, -0.5]]\nlength = 9\nstiffness = 20\ndamping = 0.3\n[[spring]]\ntype = \"torsion\"\nparts = [\"a\", \"b\"]\nstiffness = 2\n";
    let mechanism = read(text);
    let simulation = Simulation::new(&mechanism).unwrap();
    let settings = Settings {
        time: 6.0,
        every: Some(0.05),
    };
    let record = simulation.dynamic(&settings).unwrap();
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let moments = |q: &[f64], v: &[f64]| {
        let px = 2.0 * v[0] + 5.0 * v[3];
        let py = 2.0 * v[1] + 5.0 * v[4];
        let about = 2.0 * (q[0] * v[1] - q[1] * v[0]) + 5.0 * (q[3] * v[4] - q[4] * v[3]);
        [px, py, about + 1.5 * v[2] + 3.0 * v[5]]
    };
    let wanted = moments(&record.samples[0].coordinates, &record.samples[0].rates);
    for sample in &record.samples {
        let found = moments(&sample.coordinates, &sample.rates);
        for k in 0..3 {
            near("momentum", found[k], wanted[k], 1e-8);
        }
    }
    balanced(&record, 60.0, 1e-9);
}

/// A driven pivot stands still at first, then moves at once, and stops at once: the rod on it gets impulses.
#[test]
fn a_drive_whose_rate_jumps() {
    let text = format!(
        "{BASE}\n[[part]]\nname = \"pusher\"\nmotion = {{ type = \"prismatic\", direction = [1, 0] }}\nloops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]\n[[part]]\nname = \"rod\"\nloops = [ [[-0.1, -2], [0.1, -2], [0.1, 0], [-0.1, 0]] ]\nmass = 1\ninertia = 0.35\ncenter_of_mass = [0, -1]\n[[joint]]\ntype = \"revolute\"\nparts = [\"pusher\", \"rod\"]\nat = [0, 0]\n[[drive]]\npart = \"pusher\"\ntable = [[0.3, 0], [1, 0.7]]\n"
    );
    let (_, record) = thrown(&text, 2.0, 0.1);
    assert_eq!(record.status, Status::Done);
    // Moment of momentum about the pivot: the centre lags behind by the turn, (0.35 + 1) rate = 1 · 1 · the pivot's rate.
    let spin = -1.0 / 1.35;
    let angle: f64 = spin * 0.7;
    // Then it turns evenly about the pivot, which stops: its centre loses what the pivot's rate has along its path.
    let last = spin + angle.cos() / 1.35;
    let rod = 1;
    for sample in &record.samples {
        let [x, y, turned, rate] = [
            sample.coordinates[rod],
            sample.coordinates[rod + 1],
            sample.coordinates[rod + 2],
            sample.rates[rod + 2],
        ];
        let t = sample.t;
        let (at, wanted, turns) = if t < 0.3 + 1e-9 {
            (0.0, 0.0, 0.0)
        } else if t <= 1.0 - 1e-9 {
            (t - 0.3, (t - 0.3) * spin, spin)
        } else {
            (0.7, angle + (t - 1.0) * last, last)
        };
        near("pivot", x, at, 1e-11);
        near("pivot", y, 0.0, 1e-11);
        near("turned", turned, wanted, 1e-9);
        if (t - 0.3).abs() > 1e-6 && (t - 1.0).abs() > 1e-6 {
            near("turns", rate, turns, 1e-9);
        }
    }
    balanced(&record, 1.0, 1e-11);
}

/// Masses of all ratios that numbers can hold: what swings keeps its energy, or the mass is refused by name.
#[test]
fn masses_out_of_proportion() {
    for light in [1e-3, 1e-6, 1e-9, 1e-12, 1e3, 1e6, 1e9, 1e12] {
        let text = format!(
            "gravity = [0, -{G}]\n{BASE}\n[[part]]\nname = \"upper\"\nmotion = {{ type = \"revolute\", center = [0, 0] }}\nloops = [ [[-0.1, -1], [0.1, -1], [0.1, 0], [-0.1, 0]] ]\nmass = 1\n[[part]]\nname = \"lower\"\nloops = [ [[-0.1, -2], [0.1, -2], [0.1, -1], [-0.1, -1]] ]\nmass = {light}\nrate = [1, 0, 1]\n[[joint]]\ntype = \"revolute\"\nparts = [\"upper\", \"lower\"]\nat = [0, -1]\n[[pair]]\nfixed = \"base\"\nmoving = \"upper\"\n"
        );
        let (_, record) = thrown(&text, 1.0, 0.1);
        assert_eq!(record.status, Status::Done, "{light}: {:?}", record.reason);
        let energy = record.energy.unwrap();
        let through: f64 = 1.0 * light;
        near("drift", energy.drift / through.max(1e-9), 0.0, 1e-7);
    }
}

/// A parallelogram linkage that is driven, upright at first.
const PARALLELOGRAM: &str = r#"
        [[part]]
        name = "a"
        mass = 0.1
        motion = { type = "revolute", center = [0, 0] }
        loops = [[[-3, -3], [3, -3], [3, 53], [-3, 53]]]
        [[part]]
        name = "b"
        mass = 0.1
        loops = [[[-3, 47], [103, 47], [103, 53], [-3, 53]]]
        [[part]]
        name = "c"
        mass = 0.1
        motion = { type = "revolute", center = [100, 0] }
        loops = [[[97, -3], [103, -3], [103, 53], [97, 53]]]
        [[joint]]
        type = "revolute"
        parts = ["a", "b"]
        at = [0, 50]
        [[joint]]
        type = "revolute"
        parts = ["b", "c"]
        at = [100, 50]
        [[drive]]
        part = "a"
        rate = "360deg""#;

/// Where its cranks lie on one line with its frame it could go on crossed: it goes on as a parallelogram, in which the cranks are parallel and
/// the rod only moves along, however long the simulation is. Its energy is that of its rates, which is always the same but for weights.
#[test]
fn a_parallelogram_goes_on_as_one() {
    for time in [0.3, 1.0, 1.7, 5.0] {
        for (rate, gravity) in [(360.0_f64, 0.0_f64), (-250.0, 9810.0)] {
            let text = format!("gravity = [0, {:?}]\n{PARALLELOGRAM}", -gravity)
                .replace("360deg", &format!("{rate}deg"));
            let (_, record) = thrown(&text, time, 0.01);
            assert_eq!(record.status, Status::Done, "{time}: {:?}", record.reason);
            for sample in &record.samples {
                let turn = sample.t * f64::to_radians(rate);
                let [a, x, y, theta, c] = sample.coordinates[..] else {
                    panic!("a crank, a rod and a crank")
                };
                near("the crank that is driven", a, turn, 1e-12);
                near("the other", c, turn, 1e-7);
                near("the rod does not turn", theta, 0.0, 1e-7);
                near("it is carried along", x, -50.0 * turn.sin(), 1e-5);
                near("and", y, 50.0 * (turn.cos() - 1.0), 1e-5);
            }
            let through = 0.1 * 50.0 * gravity.max(1000.0);
            balanced(&record, through, 1e-6);
        }
    }
}

/// Cranks of a crossed parallelogram turn against each other, by a whole turn in one, with masses and without.
#[test]
fn crossed_cranks_stay_crossed() {
    // Cranks pass each other: they are drawn shorter than they are.
    let crossed = PARALLELOGRAM
        .replace("[3, 53], [-3, 53]]]", "[3, 30], [-3, 30]]]")
        .replace("[103, 53], [97, 53]", "[103, 3], [97, 3]")
        .replace("at = [100, 50]", "at = [60, -30]");
    for text in [crossed.clone(), crossed.replace("mass = 0.1", "")] {
        let simulation = Simulation::new(&read(&text)).unwrap();
        let settings = Settings {
            time: 3.0,
            every: Some(0.5),
        };
        let record = match text.contains("mass") {
            true => simulation.dynamic(&settings).unwrap(),
            false => simulation.kinematic(&settings).unwrap(),
        };
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        for sample in record.samples.iter().filter(|s| s.t.fract() == 0.0) {
            let turn = sample.coordinates[0];
            near("a crank", turn, sample.t * 360_f64.to_radians(), 1e-12);
            near("the other", sample.coordinates[4], -turn, 1e-7);
        }
    }
}

/// A part that has a start keeps it; what is joined to it and has none comes along.
#[test]
fn what_is_joined_comes_to_what_has_a_start() {
    for angle in [10.0_f64, 120.0, -170.0] {
        let text = format!(
            r#"
            gravity = [0, -9.81]
            [[part]]
            name = "upper"
            mass = 1
            motion = {{ type = "revolute", center = [0, 0] }}
            start = "{angle}deg"
            loops = [[[-0.02, -1], [0.02, -1], [0.02, 0], [-0.02, 0]]]
            [[part]]
            name = "lower"
            mass = 1
            loops = [[[-0.02, -2], [0.02, -2], [0.02, -1], [-0.02, -1]]]
            [[joint]]
            type = "revolute"
            parts = ["upper", "lower"]
            at = [0, -1]"#
        );
        let (simulation, _) = thrown(&text, 1e-3, 1e-3);
        near("start", simulation.start()[0], angle.to_radians(), 1e-12);
    }
}

/// A block that a link without mass pulls along a floor: the joints carry the friction, two links at one place together.
#[test]
fn joints_carry_the_friction_of_contacts() {
    let (friction, mass, weight, rate) = (0.3, 2.0, 20.0, 1.5);
    let once = format!(
        r#"
friction = {friction}
[[part]]
name = "floor"
motion = {{ type = "fixed" }}
loops = [[[-50, -2], [50, -2], [50, 0], [-50, 0]]]
[[part]]
name = "block"
mass = {mass}
rate = [{rate}, 0, 0]
inertia = 1
center_of_mass = [0, 0.5]
loops = [[[-2, 0], [2, 0], [2, 1], [-2, 1]]]
[[part]]
name = "link"
mass = 1e-9
rate = [{rate}, 0, 0]
inertia = 1e-9
center_of_mass = [5, 0.5]
loops = [[[3, 0.4], [7, 0.4], [7, 0.6], [3, 0.6]]]
[[part]]
name = "cart"
motion = {{ type = "prismatic", direction = [1, 0] }}
mass = 1
loops = [[[9, 0.1], [10, 0.1], [10, 0.9], [9, 0.9]]]
[[joint]]
type = "revolute"
parts = ["block", "link"]
at = [0, 0.5]
[[joint]]
type = "revolute"
parts = ["link", "cart"]
at = [8, 0.5]
[[load]]
part = "block"
force = [0, -{weight}]
at = [0, 0.5]
[[pair]]
fixed = "floor"
moving = "block"
[[drive]]
part = "cart"
rate = {rate}
"#
    );
    // The link and its joints once more, by another name.
    let start = once.find("[[part]]\nname = \"link\"").unwrap();
    let end = once.find("[[part]]\nname = \"cart\"").unwrap();
    let joints = &once[once.find("[[joint]]").unwrap()..once.find("[[load]]").unwrap()];
    let second = [&once[start..end], joints]
        .concat()
        .replace("\"link\"", "\"second link\"");
    let twice = format!("{once}{second}");
    for text in [once, twice] {
        let (_, record) = thrown(&text, 1.0, 0.1);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        for sample in &record.samples {
            let forces = sample.forces.as_ref().unwrap();
            let pull = |part: &str| -> [f64; 2] {
                let of = forces.joints.iter().filter(|j| j.parts[1].contains(part));
                of.fold([0.0; 2], |[x, y], j| [x + j.force[0], y + j.force[1]])
            };
            // Each is pulled back by the part before it.
            for part in ["link", "cart"] {
                near("along", pull(part)[0], -friction * weight, 1e-6);
                near("across", pull(part)[1], 0.0, 1e-6);
            }
            let floor: f64 = forces.contacts.iter().map(|c| c.tangential.abs()).sum();
            near("on the floor", floor, friction * weight, 1e-6);
        }
    }
}

/// A rod and a bob that are joined rigidly, beside one part of both outlines whose mass properties are sums by hand: they swing, strike a
/// post and bounce alike.
#[test]
fn a_welded_pendulum_moves_as_one_of_one_part() {
    let rod = "loops = [[[-1, -20], [1, -20], [1, 0], [-1, 0]]]";
    let bob = "loops = [{ circle = 4, at = [0, -22] }]";
    let turns = "motion = { type = \"revolute\", center = [0, 0] }\nstart = -1";
    let head = "gravity = [0, -9810]\nrestitution = 0.7\n[[part]]\nname = \"post\"\nmotion = { type = \"fixed\" }\nloops = [[[10, -30], [14, -30], [14, -20], [10, -20]]]\n";
    let welded = format!(
        "{head}[[part]]\nname = \"rod\"\n{rod}\ndensity = 1e-5\n[[part]]\nname = \"bob\"\n{bob}\ndensity = 2e-5\n{turns}\n[[joint]]\ntype = \"rigid\"\nparts = [\"bob\", \"rod\"]\n"
    );
    let (m, n) = (40e-5, 32e-5 * std::f64::consts::PI);
    let center = -(10.0 * m + 22.0 * n) / (m + n);
    let inertia =
        m * (404.0 / 12.0 + (center + 10.0).powi(2)) + n * (8.0 + (center + 22.0).powi(2));
    let single = format!(
        "{head}[[part]]\nname = \"pendulum\"\nlayers = [{{ {rod} }}, {{ {bob} }}]\nmass = {}\ninertia = {inertia}\ncenter_of_mass = [0, {center}]\n{turns}\n",
        m + n
    );
    let (_, one) = thrown(&welded, 2.0, 0.05);
    let (_, other) = thrown(&single, 2.0, 0.05);
    assert_eq!((one.status, other.status), (Status::Done, Status::Done));
    assert!(!one.events.is_empty());
    assert_eq!(one.events.len(), other.events.len());
    for (a, b) in one.samples.iter().zip(&other.samples) {
        near("angle", a.coordinates[0], b.coordinates[0], 1e-9);
    }
}

/// A four-bar linkage whose crank cannot turn all around: 4, 6, 3 on a frame of 5.5. It stops where coupler and rocker are in line, 9 from the
/// crank's pivot to the rocker's end, however long the simulation is, and does not come out on the other side.
#[test]
fn a_crank_stops_where_the_linkage_does_not_close() {
    for (rate, end) in [(90.0_f64, 42.164_277_6_f64), (-90.0, -67.842_790_9)] {
        for time in [2.0, 3.0, 5.0, 8.0] {
            let text = format!(
                r#"
                [[part]]
                name = "crank"
                motion = {{ type = "revolute", center = [0, 0] }}
                loops = [{{ circle = 0.1, at = [0, 0] }}]
                [[part]]
                name = "coupler"
                loops = [{{ circle = 0.1, at = [0, 20] }}]
                [[part]]
                name = "rocker"
                motion = {{ type = "revolute", center = [5.5, 0] }}
                loops = [{{ circle = 0.1, at = [5.5, 0] }}]
                [[joint]]
                type = "revolute"
                parts = ["crank", "coupler"]
                at = ["4*cos(100deg)", "4*sin(100deg)"]
                [[joint]]
                type = "revolute"
                parts = ["coupler", "rocker"]
                at = [2.6795073136893652, -1.0221648626656115]
                [[drive]]
                part = "crank"
                rate = "{rate}deg""#
            );
            let simulation = Simulation::new(&read(&text)).unwrap();
            let settings = Settings { time, every: None };
            let record = simulation.kinematic(&settings).unwrap();
            assert_eq!(record.status, Status::Jammed, "{time}: {:?}", record.reason);
            let [crank, ..] = record.samples.last().unwrap().coordinates[..] else {
                panic!("a crank")
            };
            near("the crank", crank.to_degrees(), end, 1e-4);
        }
    }
}
