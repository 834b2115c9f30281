//! Discs and rollers that pass from feature to feature of smooth outlines, cams, and wheels that are driven.

use cspace_model::{Load, LoadKind, Mass, Mechanism, PartDynamics};
use cspace_motion::{EventKind, Settings, Status};

use crate::motion::helpers::{balanced, judge, model, near, thrown, thrown_model};

const G: f64 = 9.81;

/// Through a trough of a line, an arc that is tangent to it, and a line: a rolling disc passes without an event.
#[test]
fn a_disc_rolls_over_tangent_features() {
    // A trough: down a slope of 0.4 rad, through an arc of radius 6, up again.
    let angle = 0.4_f64;
    let (c, s) = (angle.cos(), angle.sin());
    let (r, long) = (6.0, 10.0);
    let bulge = (angle / 2.0).tan();
    // The arc's centre is at (0, 6); its ends at ±6 sin, 6 − 6 cos.
    let (ex, ey) = (r * s, r - r * c);
    let (fx, fy) = (ex + long * c, ey + long * s);
    let trough = format!(
        "[[-{fx}, -3], [{fx}, -3], [{fx}, {fy}], [{ex}, {ey}, {}], [-{ex}, {ey}], [-{fx}, {fy}]]",
        -bulge
    );
    let (mass, inertia, rho) = (2.0, 0.25, 0.5);
    for (friction, rolls) in [(2.0, true), (0.0, false)] {
        let far = 7.0;
        let (sx, sy) = (-ex - far * c, ey + far * s);
        let text = format!(
            "gravity = [0, -{G}]\nfriction = {friction}\n[[part]]\nname = \"trough\"\nmotion = {{ type = \"fixed\" }}\nloops = [ {trough} ]\n[[part]]\nname = \"disc\"\nloops = [ [[-0.5, 0, 1], [0.5, 0, 1]] ]\nstart = [{}, {}, 0]\nmass = {mass}\ninertia = {inertia}\n",
            sx + rho * s,
            sy + rho * c,
        );
        let (simulation, record) = thrown(&text, 12.0, 0.02);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        let told: Vec<EventKind> = record.events.iter().map(|e| e.kind).collect();
        assert_eq!(told, [EventKind::Touch], "{rolls}");
        judge(&simulation, &record);
        let start = G * mass * (far * s + r - r * c);
        balanced(&record, start, 1e-9);
        // At the end of the slope at a known time: uniform acceleration.
        let a = if rolls { 2.0 / 3.0 } else { 1.0 } * G * s;
        let t = f64::sqrt(2.0 * far / a);
        let rate = a * t;
        let sample = record.samples.iter().rfind(|k| k.t < t).unwrap();
        let speed = f64::hypot(sample.rates[0], sample.rates[1]);
        near("speed", speed, rate - a * (t - sample.t), 1e-9);
        // The disc comes up as high on the other side.
        let highest = record
            .samples
            .iter()
            .map(|k| k.coordinates[1])
            .fold(0.0, f64::max);
        near("height", highest, sy + rho * c, 1e-10);
        let farthest = record
            .samples
            .iter()
            .map(|k| k.coordinates[0])
            .fold(0.0, f64::max);
        near("far", farthest, ex + far * c - rho * s, 1e-2);
    }
}

/// A rolling disc comes to the edge of a table, and rolls on over the corner: known by its energy, and it leaves where the
/// corner no longer has to hold it.
#[test]
fn a_disc_rolls_over_a_corner() {
    // Slowly enough that it stays on the corner at first: rate² < g R.
    let (rate, radius, mass) = (1.0_f64, 1.0, 1.0);
    let inertia = 0.5;
    let text = format!(
        "gravity = [0, -{G}]\nfriction = 100\n[[part]]\nname = \"table\"\nmotion = {{ type = \"fixed\" }}\nloops = [ [[-20, -10], [0, -10], [0, 0], [-20, 0]] ]\n[[part]]\nname = \"disc\"\nloops = [ [[-1, 0, 1], [1, 0, 1]] ]\nstart = [-1, 1, 0]\nrate = [{rate}, 0, -1]\nmass = {mass}\ninertia = {inertia}\n"
    );
    let (simulation, record) = thrown(&text, 2.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    judge(&simulation, &record);
    balanced(&record, G, 1e-9);
    // m w² R = m g cos φ with ¾ m R² w² = ¾ m v² + m g R (1 − cos φ): sin φ never needs more friction than there is at first.
    let cosine = (rate * rate / (G * radius) + 4.0 / 3.0) / (1.0 + 4.0 / 3.0);
    let leaves: Vec<_> = record
        .events
        .iter()
        .filter(|e| e.kind == EventKind::Release || e.kind == EventKind::Slip)
        .collect();
    let slip = leaves[0];
    // It slips just before, where friction 100 is not enough.
    let rates = record.trace.iter().find(|s| s.t == slip.t).unwrap();
    let c = rates.coordinates[1];
    let s = rates.coordinates[0];
    let w2 = rates.rates[2].powi(2);
    near("by energy", 0.75 * w2, 0.75 + G * (1.0 - c), 1e-9);
    near("on the corner", f64::hypot(c, s), 1.0, 1e-11);
    // Normal: g c − w²; tangential: g s / 3.
    near("slips", 100.0 * (G * c - w2) - G * s / 3.0, 0.0, 1e-6);
    assert!((c - cosine).abs() < 0.01, "{c} {cosine}");
    assert!(record.events.iter().all(|e| e.t >= slip.t || e.t == 0.0));
}

/// A roller pressed on an eccentric disc by a spring follows it until the cam goes down faster than the spring can push.
#[test]
fn a_roller_lifts_off_an_eccentric() {
    let (e, big, small) = (1.0_f64, 4.0, 1.5);
    let (mass, stiffness) = (2.0, 50.0);
    let sum = big + small;
    let lift = |u: f64| e * u.cos() + f64::sqrt(sum * sum - e * e * u.sin().powi(2));
    // Second derivative by the angle.
    let bends = |u: f64| {
        let d = 1e-4;
        let f = |k: f64| lift(u + k * d);
        (-f(-2.0) + 16.0 * f(-1.0) - 30.0 * f(0.0) + 16.0 * f(1.0) - f(2.0)) / (12.0 * d * d)
    };
    // The spring is as long as its end is away, less a preload; it pushes down with k (y − y0) …
    let preload = 60.0;
    let push = |u: f64| preload + stiffness * (lift(u) - lift(std::f64::consts::PI));
    // The force is push + m w² y'': it is least for some angle; the least w at which it vanishes.
    let mut least = f64::INFINITY;
    for k in 0..200_000 {
        let u = std::f64::consts::TAU * f64::from(k) / 200_000.0;
        let b = bends(u);
        if b < 0.0 {
            least = least.min(push(u) / (-b * mass));
        }
    }
    let critical = least.sqrt();
    let bottom = lift(std::f64::consts::PI);
    let length = 20.0;
    let text = |w: f64| {
        format!(
            "[[part]]\nname = \"cam\"\nmotion = {{ type = \"revolute\", center = [0, 0] }}\nloops = [ [[{}, 0, 1], [{}, 0, 1]] ]\n[[part]]\nname = \"roller\"\nmotion = {{ type = \"prismatic\", direction = [0, 1] }}\nloops = [ [[-{small}, 0, 1], [{small}, 0, 1]] ]\nmass = {mass}\nstart = {}\nrate = {}\n[[spring]]\nparts = [\"roller\"]\nat = [[0, 0], [0, {}]]\nlength = {length}\nstiffness = {stiffness}\n[[drive]]\npart = \"cam\"\nrate = {w}\n",
            e - big,
            e + big,
            lift(std::f64::consts::FRAC_PI_2),
            0.0,
            // From the top: the spring is shorter than it would be by preload / stiffness at the bottom.
            bottom + length - preload / stiffness,
        )
        // The disc is drawn to the right, and the roller is above: at π/2 of the lift.
    };
    let at = |t: f64, w: f64| lift(w * t - std::f64::consts::FRAC_PI_2);
    for (share, holds) in [(0.5, true), (0.99999, true), (1.00001, false), (1.2, false)] {
        let w = critical * share;
        let turn = std::f64::consts::TAU / w;
        // Its rate at the start is what the cam gives it.
        let d = 1e-5;
        let rate = (at(d, w) - at(-d, w)) / (2.0 * d);
        let text = text(w).replace("rate = 0\n", &format!("rate = {rate}\n"));
        let (_, record) = thrown(&text, 2.0 * turn, turn / 50.0);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        let lifted = record
            .events
            .iter()
            .find(|k| k.kind == EventKind::Release && k.t > 1e-3 * turn);
        assert_eq!(lifted.is_none(), holds, "{share}: {:?}", record.events);
        let until = lifted.map_or(2.0 * turn, |k| k.t);
        for sample in record.samples.iter().filter(|k| k.t <= until) {
            near("lift", sample.coordinates[1], at(sample.t, w), 1e-9);
        }
        if let Some(event) = lifted {
            let u = w * event.t - std::f64::consts::FRAC_PI_2;
            near("force", push(u) + mass * w * w * bends(u), 0.0, 1e-4);
        }
        let through = 0.5 * mass * (w * e).powi(2) + push(0.0) * 2.0 * e;
        balanced(&record, through, 1e-8);
    }
}

/// A model that ships, with masses for all that moves, and a load that holds a part back.
fn weighed(name: &str, density: f64, held: &str, torque: f64) -> Mechanism {
    let mut mechanism = model(name);
    let count = mechanism.parts.len();
    let dynamics = &mut mechanism.dynamics;
    dynamics.parts.resize(count, PartDynamics::default());
    for part in &mut dynamics.parts {
        part.mass = Some(Mass::Density(density));
    }
    let named = |p: &cspace_model::PartEntry| p.part.name() == held;
    dynamics.loads.push(Load {
        part: mechanism.parts.iter().position(named).unwrap(),
        kind: LoadKind::Torque(torque),
    });
    mechanism
}

/// Held back by more than its inertia, a wheel of a Geneva drive lies on the driver's pin as it does without masses.
#[test]
fn a_geneva_wheel_with_masses_follows_its_pin() {
    let mechanism = weighed("geneva", 1e-9, "wheel", 1.0);
    let (simulation, record) = thrown_model(&mechanism, 1.0, 0.005);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    judge(&simulation, &record);
    let settings = Settings {
        time: 1.0,
        every: Some(0.005),
    };
    let slow = simulation.kinematic(&settings).unwrap();
    let mut driven = 0;
    for (a, b) in record.samples.iter().zip(&slow.samples) {
        if (0.4..0.6).contains(&a.t) {
            driven += 1;
            near(
                &format!("wheel at {}", a.t),
                a.coordinates[0],
                b.coordinates[0],
                1e-9_f64.to_radians(),
            );
        }
    }
    assert!(driven >= 40, "{driven}");
    balanced(&record, record.energy.unwrap().drives.abs(), 1e-7);
}

/// Held back all the time, a pinion runs as its gear does, 12 to 10, once it has crossed the backlash.
#[test]
fn gears_with_masses_keep_their_ratio() {
    let mechanism = weighed("gears_on_shafts", 1e-9, "pinion", 1.0);
    let (simulation, record) = thrown_model(&mechanism, 1.0, 1.0 / 120.0);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    judge(&simulation, &record);
    let (first, last) = (
        &record.samples[24].coordinates,
        &record.samples[94].coordinates,
    );
    near(
        "ratio",
        (last[1] - first[1]) / (last[0] - first[0]),
        -1.2,
        1e-9,
    );
}

/// Six parts that fall onto each other bear on more contacts than they have degrees of freedom: forces are not
/// determined one by one, and the motion goes on.
#[test]
fn a_pile_goes_on() {
    let text = r#"
    unit="m"
    restitution=0.3
    friction=0.3
    gravity=[0,-9.81]
    [[part]]
    name="box"
    motion={type="fixed"}
    loops=[[[-6,-6],[6,-6],[6,6],[-6,6]],[[-5,-5],[-5,5],[5,5],[5,-5]]]
    [[part]]
    name="p0"
    density=1
    rate=[-0.1259792258491803,-1.0952200371784948,0.7312492424421633]
    loops=[[[2.5,0.5],[3.5,0.5],[3.5,0.8],[2.8,0.8],[2.8,1.5],[2.5,1.5]]]
    [[part]]
    name="p1"
    density=1
    rate=[-4.104343765594104,-2.6581704051029464,-4.800086937758192]
    loops=[[[0.5,0.5],[1.5,0.5],[1.5,0.8],[0.8,0.8],[0.8,1.5],[0.5,1.5]]]
    [[part]]
    name="p2"
    density=1
    rate=[4.11158229254748,2.2600193406441003,1.6296219273177313]
    loops=[[[0.5919288712511543,-3.3897292104424963],[1.4080711287488457,-3.3897292104424963],[1.4080711287488457,-2.6102707895575037],[0.5919288712511543,-2.6102707895575037]]]
    [[part]]
    name="p3"
    density=1
    rate=[-4.369113192977815,1.2016796193668426,-1.2279486575924672]
    loops=[[[2.205038561757359,3,1],[3.794961438242641,3,1]]]
    [[part]]
    name="p4"
    density=1
    rate=[1.9130057160597227,-0.02419465009927979,1.4972136554726312]
    loops=[[[0.5969368477117157,-1,1],[1.4030631522882842,-1,1]]]
    [[part]]
    name="p5"
    density=1
    rate=[-3.5179220925238495,3.603125481230153,-0.43736824922699835]
    loops=[[[-0.3856922066767391,-2.664402122977058,0],[-1.335597877022942,-2.385692206676739,0],[-1.614307793323261,-3.335597877022942,0.2],[-0.664402122977058,-3.614307793323261,0]]]
    "#;
    let (simulation, record) = thrown(text, 1.5, 0.01);
    judge(&simulation, &record);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    balanced(&record, 100.0, 1e-9);
}

/// A box that slides over the edge of a table, without friction: it tips as its middle comes over the edge, however long the motion is and
/// its steps are.
#[test]
fn a_box_tips_over_an_edge() {
    for (k, until) in (12..=40).enumerate() {
        let (half, height) = (0.3 + 0.04 * k as f64, 0.5 + 0.1 * k as f64);
        let middle = -12.0;
        let text = format!(
            r#"
            gravity = [0, -10]
            friction = 0
            [[part]]
            name = "table"
            motion = {{ type = "fixed" }}
            loops = [[[-20, 0], [0, 0], [0, -50], [-20, -50]]]
            [[part]]
            name = "box"
            mass = 1
            rate = [1, 0, 0]
            loops = [[[{}, 0], [{}, 0], [{}, {height}], [{}, {height}]]]"#,
            middle - half,
            middle + half,
            middle + half,
            middle - half,
        );
        let (_, record) = thrown(&text, f64::from(until) + 0.1, 0.1);
        assert_eq!(record.status, Status::Done, "{until}: {:?}", record.reason);
        let mut events = record.events.iter();
        let tips = events.find(|e| e.kind == EventKind::Release).unwrap();
        assert!((tips.t - 12.0).abs() < 1e-9, "{until}: {tips:?}");
    }
}

/// Two boxes that slide on a floor, far from each other, stop each by itself, after v²/(2 μ g): neither hides when the other does, nor the
/// feet of one when the other foot does.
#[test]
fn boxes_stop_by_themselves() {
    for k in 0..24 {
        let speeds = [
            0.7 + 0.13 * f64::from(k),
            -0.4 - 0.11 * f64::from((7 * k) % 24),
        ];
        let text = format!(
            r#"
            gravity = [0, -9.81]
            friction = 0.5
            [[part]]
            name = "floor"
            motion = {{ type = "fixed" }}
            loops = [[[-90, -1], [90, -1], [90, 0], [-90, 0]]]
            [[part]]
            name = "a"
            mass = 1
            rate = [{}, 0, 0]
            loops = [[[0, 0], [1, 0], [1, 1], [0, 1]]]
            [[part]]
            name = "b"
            mass = 1
            rate = [{}, 0, 0]
            loops = [[[-20, 0], [-19, 0], [-19, 1], [-20, 1]]]"#,
            speeds[0], speeds[1],
        );
        for time in [1.0, 2.0, 3.0] {
            let (_, record) = thrown(&text, time, 0.1);
            assert_eq!(record.status, Status::Done, "{:?}", record.reason);
            let last = record.samples.last().unwrap();
            for (x, speed) in [last.coordinates[0], last.coordinates[3]]
                .into_iter()
                .zip(speeds)
            {
                let slows = 0.5 * 9.81;
                let until = time.min(speed.abs() / slows);
                let way = (speed.abs() - 0.5 * slows * until) * until * speed.signum();
                assert!((x - way).abs() < 1e-9, "{speeds:?} {time}: {x} {way}");
            }
        }
    }
}
