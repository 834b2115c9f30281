//! Tolerances of designs whose answers are known, and of random ones against configuration spaces.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use cspace::{ComputeError, Configuration, Progress, Relation, Silent, Stage, overlap_as_drawn};
use cspace_design::{
    Allocation, ChangeKind, Criterion, ToleranceOptions, Tolerances, Unallocated, Unmeasured,
    Value, Variations, allocate, along, check, tolerances, tolerances_with, zones,
};
use cspace_model::Host;
use cspace_model::model::{Coordinate, Subject, Template};
use cspace_oracle::effort;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn analysed(template: &Template, samples: u64) -> Tolerances {
    let model = template.model(&Host::default()).unwrap();
    let options = ToleranceOptions {
        samples,
        seed: 1,
        ..ToleranceOptions::default()
    };
    let mut found = tolerances(template, &[], &model, &options, &Silent).unwrap();
    assert_eq!(found.len(), 1);
    found.remove(0)
}

fn shipped(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/tolerances/");
    std::fs::read_to_string(format!("{folder}{name}.toml")).unwrap()
}

fn template(text: impl Into<String>) -> Template {
    Template::from_text(text.into(), "model.toml").unwrap()
}

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found} for {expected}");
}

/// The smallest and the largest value.
fn ends(found: &Tolerances) -> [f64; 2] {
    let [lo, hi] = found.exact.clone().unwrap();
    assert!(lo.certified && hi.certified, "{lo:?} {hi:?}");
    [lo.value.unwrap(), hi.value.unwrap()]
}

/// The pressure angle of the clutch is acos((hub + c) / (cage − c)) with the mean c of its rollers.
#[test]
fn an_overrunning_clutch_has_its_published_numbers() {
    let found = analysed(&template(shipped("overrunning_clutch")), 0);
    let angle = |hub: f64, roller: f64, cage: f64| ((hub + roller) / (cage - roller)).acos();
    let nominal = angle(55.29, 22.86, 101.6);
    near(nominal.to_degrees(), 7.018_389_803, 1e-9);
    let Value::Number(value) = found.nominal.measured.clone().unwrap().value else {
        panic!("{found:?}");
    };
    near(value, nominal, 1e-12);
    let linear = found.linear.clone().unwrap();
    let of = |name: &str| {
        let mut all = linear.parameters.iter();
        all.find(|p| p.parameter == name).unwrap().clone()
    };
    for (name, derivative, share) in [
        ("hub", -0.103_938_5, 45.63),
        ("roller1", -0.103_549_1, 4.55),
        ("roller2", -0.103_549_1, 4.55),
        ("cage", 0.103_159_7, 45.28),
    ] {
        near(of(name).derivative[0], derivative, 5e-8);
        near(of(name).derivative[1], derivative, 5e-8);
        near(100.0 * of(name).worst_share, share, 5e-3);
    }
    for (range, half) in [(linear.worst, 1.657_659), (linear.rss, 1.070_906)] {
        near((range[1] - nominal).to_degrees(), half, 5e-7);
        near((nominal - range[0]).to_degrees(), half, 5e-7);
    }
    let [lo, hi] = ends(&found);
    near((lo - nominal).to_degrees(), -1.923_094, 5e-7);
    near((hi - nominal).to_degrees(), 1.496_216, 5e-7);
    near(lo, angle(55.29 + 0.127, 22.8727, 101.6 - 0.127), 1e-9);
}

/// Form deviates like the sizes do: a roller off by ±e all around has a diameter off by ±2e, and a ring one by ∓2e.
#[test]
fn form_deviates_along_normals() {
    let profiled = shipped("overrunning_clutch")
        .replace("name = \"cage\"\n", "name = \"cage\"\nprofile = 0.02\n")
        .replace("name = \"roller\"\n", "name = \"roller\"\nprofile = 0.01\n");
    let found = analysed(&template(profiled), 0);
    // The roller's centre is where the drawing has it, its own radius and the ring's are off.
    let angle = |hub: f64, roller: f64, cage: f64, e: f64, f: f64| {
        ((hub + roller) / (cage - 2.0 * f - roller - 2.0 * e)).acos()
    };
    let [lo, hi] = ends(&found);
    near(
        lo,
        angle(55.29 + 0.127, 22.8727, 101.6 - 0.127, 0.01, 0.02),
        1e-9,
    );
    near(
        hi,
        angle(55.29 - 0.127, 22.8473, 101.6 + 0.127, -0.01, -0.02),
        1e-9,
    );
    let linear = found.linear.unwrap();
    let names: Vec<&str> = linear
        .parameters
        .iter()
        .map(|p| p.parameter.as_str())
        .collect();
    assert!(
        names.contains(&"cage_profile") && names.contains(&"roller_profile"),
        "{names:?}"
    );
}

/// The play of the lock is that of its arc's ends, until the arc itself jams.
#[test]
#[ignore = "long: seconds"]
fn a_geneva_lock_jams_beyond_its_tolerances() {
    let found = analysed(&template(shipped("geneva_lock")), 0);
    let [lo, hi] = ends(&found);
    near(0.5 * lo.to_degrees(), 0.054_406_69, 5e-9);
    near(0.5 * hi.to_degrees(), 0.347_202_24, 5e-9);
    let linear = found.linear.clone().unwrap();
    let half = 0.25 * (linear.worst[1] - linear.worst[0]);
    near(half.to_degrees(), 0.146_395_01, 5e-9);
    assert_eq!(found.structure[0].kind, ChangeKind::Jam);
    near(found.structure[0].share, 1.25, 1e-9);
    // The limit is passed before.
    assert!(found.margin.factor.unwrap() < 1.25);
    // With ±0.03 it jams where the gap 0.1 is used up by four deviations: with a probability of 1/1944.
    let wide = shipped("geneva_lock").replace("tol = 0.02", "tol = 0.03");
    let found = analysed(&template(wide), 100_000);
    let [lo, hi] = found.exact.clone().unwrap();
    assert!(lo.value.is_err() && hi.certified, "{lo:?} {hi:?}");
    near(found.structure[0].share, 0.1 / 0.12, 1e-9);
    assert_eq!(
        found.structure[0].features,
        [["convex arc 0 of loop 0", "concave arc 3 of loop 0"].map(str::to_owned)]
    );
    let samples = found.monte_carlo.unwrap();
    let probability: f64 = 1.0 / 1944.0;
    let error = (probability / 100_000.0).sqrt();
    near(samples.failures["jam"], probability, 4.0 * error);
    assert!(samples.computed < 0.01, "{samples:?}");
}

const PEG: &str = r#"
[parameter]
w = { value = 10, tol = 0.01 }
h = { value = 18, tol = 0.1 }
slot = { value = 10.1, tol = 0.02 }
[[part]]
name = "slot"
loops = [[[-20, 10], ["-slot/2", 10], ["-slot/2", -30], ["slot/2", -30], ["slot/2", 10], [20, 10], [20, -40], [-20, -40]]]
[[part]]
name = "peg"
loops = [[["-w/2", "-h/2"], ["w/2", "-h/2"], ["w/2", "h/2"], ["-w/2", "h/2"]]]
[[requirement]]
name = "tilt"
pair = ["slot", "peg"]
measure = "play"
of = "theta"
at = { y = -12 }
"#;

/// A peg w × h in a slot s tilts by t with w cos t + h sin t = s to either side.
#[test]
fn a_peg_tilts_in_its_slot() {
    let found = analysed(&template(PEG), 300);
    let [lo, hi] = ends(&found);
    near(0.5 * lo.to_degrees(), 0.221_823_92, 5e-9);
    near(0.5 * hi.to_degrees(), 0.416_965_03, 5e-9);
    let tilt = |w: f64, h: f64, s: f64| (s / w.hypot(h)).acos() - h.atan2(w);
    near(0.5 * lo, -tilt(10.01, 18.1, 10.08), 1e-12);
    let range = found.monte_carlo.unwrap().range;
    assert!(lo <= range[0] && range[1] <= hi);
}

/// A pin between two rails touches the one or the other: the gap has a kink at the nominal place, and each side its slope.
#[test]
fn kinks_have_two_slopes() {
    let model = r#"
[parameter]
px = { value = 0, position = 0.2, with = "py" }
py = 0
[[part]]
name = "rails"
motion = { type = "fixed" }
loops = [[[-20, 6], [20, 6], [20, 9], [-20, 9]], [[-20, -9], [20, -9], [20, -6], [-20, -6]]]
[[part]]
name = "pin"
motion = { type = "prismatic", direction = [1, 0], range = [-3, 3] }
loops = [{ circle = 5, at = ["px", "py"] }]
[[requirement]]
name = "gap"
measure = "clearance"
limits = [0.92, 1]
"#;
    let linear = analysed(&template(model), 0).linear.unwrap();
    near(linear.worst[0], 0.9, 1e-9);
    near(linear.worst[1], 1.0, 1e-9);
    near(linear.rss[0], 0.9, 1e-9);
    near(linear.rss[1], 1.0, 1e-9);
    let [across, along] = ["py", "px"].map(|name| {
        linear
            .parameters
            .iter()
            .find(|p| p.parameter == name)
            .unwrap()
    });
    near(across.variance_share, 1.0, 1e-12);
    near(across.worst_share, 1.0, 1e-12);
    near(along.variance_share, 0.0, 1e-12);
}

/// Beyond its tolerances it does not fit: the width and the slot decide, the height does not.
#[test]
#[ignore = "long: seconds"]
fn a_peg_that_is_too_wide_does_not_fit() {
    let wide = PEG
        .replace("tol = 0.01 }", "tol = 0.06 }")
        .replace("tol = 0.02 }", "tol = 0.05 }");
    let found = analysed(&template(wide), 0);
    let [lo, _] = found.exact.clone().unwrap();
    assert_eq!(
        lo.value.unwrap_err(),
        "the parts overlap where it is measured"
    );
    near(found.margin.factor.unwrap(), 0.1 / 0.11, 1e-9);
    let at = &found.structure[0].at;
    near(at[1], -0.05 * 0.1 / 0.11, 1e-9);
    near(at[2], 0.06 * 0.1 / 0.11, 1e-9);
}

/// A ball 5 ± 0.05 leaves a mouth 10.1 ± 0.1 wide unless both are off by more than half of their tolerances together.
#[test]
fn a_ball_is_caged_with_probability_one_eighth() {
    let model = r#"
[parameter]
ball = { value = 5, tol = 0.05 }
mouth = { value = 10.1, tol = 0.1 }
[[part]]
name = "c"
loops = [[[8, "mouth/2"], [8, 9], [-9, 9], [-9, -9], [8, -9], [8, "-mouth/2"], [6, "-mouth/2"], [6, -7], [-7, -7], [-7, 7], [6, 7], [6, "mouth/2"]]]
[[part]]
name = "ball"
loops = [{ circle = "ball", at = [0, 0] }]
[[requirement]]
name = "leaves"
pair = ["c", "ball"]
measure = "caged"
equals = false
"#;
    let found = analysed(&template(model), effort(1200, 4000));
    near(found.margin.factor.unwrap(), 0.5, 1e-6);
    assert_eq!(found.structure[0].kind, ChangeKind::Region);
    let samples = found.monte_carlo.unwrap();
    near(samples.met, 0.875, 4.0 * samples.error);
}

/// A key wider than its slot, deep in its walls, is no sample with play, and no largest value: the slot is at most 10.4.
#[test]
#[ignore = "long: seconds"]
fn parts_deep_in_each_other_have_no_value() {
    let model = r#"
[parameter]
slot = { value = 10.1, tol = 0.3 }
[[part]]
name = "hub"
loops = [[{ mirror = "y", path = [[0, -25], [20, -25], [20, 0], ["slot/2", 0], ["slot/2", -20]] }]]
[[part]]
name = "key"
loops = [[[-5, -19], [5, -19], [5, 10], [-5, 10]]]
[[requirement]]
name = "play"
measure = "play"
of = "x"
"#;
    let found = analysed(&template(model), 20_000);
    let [lo, hi] = found.exact.clone().unwrap();
    assert!(lo.value.is_err());
    near(hi.value.unwrap(), 0.4, 1e-9);
    // A third of the slots are too narrow.
    let samples = found.monte_carlo.unwrap();
    near(samples.failures["jam"], 1.0 / 3.0, 4.0 * samples.error);
    near(samples.moments[0], 0.2, 0.01);
}

/// A ball drops into a slot, or stays on its mouth where that is narrower: a contact that there is not as drawn.
#[test]
fn a_contact_that_comes_about_suddenly_is_told() {
    let model = r#"
[parameter]
w = { value = 6.02, tol = 0.03 }
r = { value = 3, tol = 0.03 }
[[part]]
name = "base"
loops = [[[-12, -10], [12, -10], [12, 0], ["w/2", 0], ["w/2", -6], ["-w/2", -6], ["-w/2", 0], [-12, 0]]]
[[part]]
name = "ball"
loops = [{ circle = "r", at = [0, 0] }]
[[requirement]]
name = "drop"
measure = "position"
of = "y"
at = { y = 20 }
along = [0, -40, 0]
"#;
    let found = analysed(&template(model), 0);
    let [_, hi] = found.exact.clone().unwrap();
    near(
        hi.value.unwrap(),
        (3.03_f64.powi(2) - 2.995_f64.powi(2)).sqrt(),
        1e-9,
    );
    // w = 2 r at 2/9 of the tolerances.
    let change = &found.structure[0];
    assert_eq!(change.kind, ChangeKind::Contact);
    near(change.share, 2.0 / 9.0, 1e-6);
}

/// An arm of a hub and a bar, drawn about 0, 0 and turned away, strikes a pin that is put at a distance: on either side of the pin it has
/// asin((half width + radius) / distance) less than half a turn.
#[test]
fn outlines_vary_with_where_they_are_put() {
    let model = r#"
[parameter]
d = { value = 10, tol = 0.1 }
[[part]]
name = "pin"
motion = { type = "fixed" }
place = { at = ["d", 0], mirror = "x" }
loops = [{ circle = 1, at = [0, 0] }]
[[part]]
name = "arm"
motion = { type = "revolute", center = [0, 0] }
place = { turn = "180deg" }
union = [ [{ circle = 3, at = [0, 0] }], [[[0, -0.5], [20, -0.5], [20, 0.5], [0, 0.5]]] ]
[[requirement]]
name = "swing"
measure = "play"
of = "v"
"#;
    let swing = |d: f64| core::f64::consts::TAU - 2.0 * (1.5 / d).asin();
    let found = analysed(&template(model), 0);
    let derivative = found.linear.clone().unwrap().parameters[0].derivative[1];
    near(derivative, 3.0 / (10.0 * (100f64 - 2.25).sqrt()), 1e-9);
    let [lo, hi] = ends(&found);
    near(lo, swing(9.9), 1e-9);
    near(hi, swing(10.1), 1e-9);
}

/// The zone of a point is a disc: the largest offset is along the slope, not at a corner of the square.
#[test]
fn a_position_is_a_disc() {
    let model = r#"
[parameter]
x = { value = 5, position = 0.2, with = "y" }
y = 5
[[part]]
name = "pin"
loops = [{ circle = 1, at = ["x", "y"] }]
[[part]]
name = "disc"
loops = [{ circle = 1, at = [0, 0] }]
[[requirement]]
name = "reach"
pair = ["pin", "disc"]
measure = "position"
of = "x"
along = [9, 9, 0]
limits = [3.5, 3.7]
"#;
    let found = analysed(&template(model), 1000);
    let [lo, hi] = found.exact.clone().unwrap();
    let (middle, half) = (5.0 - 2.0_f64.sqrt(), 0.1 / 2.0_f64.sqrt());
    near(lo.value.unwrap(), middle - half, 1e-9);
    near(hi.value.unwrap(), middle + half, 1e-9);
    near(hi.at[0], half, 1e-6);
    let samples = found.monte_carlo.unwrap();
    assert!(samples.range[0] >= middle - half && samples.range[1] <= middle + half);
    // Of the coordinate along the diagonal, half of it and half of the other.
    near(samples.moments[1], 0.05 / 2.0_f64.sqrt(), 0.004);
    // The nearest limit is the lower, and the zone may grow until it is reached.
    near(found.margin.factor.unwrap(), (middle - 3.5) / half, 1e-6);
    // Half of the zone: 0.05 along the slope (3, 4).
    let model = template(model).model(&Host::default()).unwrap();
    let farthest = Variations::of(&model).farthest(&[3.0, 4.0], 0.5);
    near(farthest[0], 0.03, 1e-15);
    near(farthest[1], 0.04, 1e-15);
}

#[test]
#[ignore = "long: seconds"]
fn samples_do_not_depend_on_threads() {
    let template = template(PEG);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build()
            .unwrap()
            .install(|| analysed(&template, 5000).monte_carlo.unwrap())
    };
    assert_eq!(with(1), with(3));
}

/// A random outline about the origin with radii between two, of lines and arcs, whose numbers depend on parameters.
fn outline(random: &mut ChaCha8Rng, radii: [f64; 2], parameters: usize, reversed: bool) -> String {
    let n = random.random_range(3..8);
    let mut vertices: Vec<String> = (0..n)
        .map(|i| {
            let spread: f64 = random.random_range(-0.3..0.3);
            let angle = (f64::from(i) + spread) * core::f64::consts::TAU / f64::from(n);
            let r = random.random_range(radii[0]..radii[1]);
            let mut depends = |x: f64| {
                let p = random.random_range(0..parameters);
                let slope: f64 = random.random_range(-1.0..1.0);
                format!("\"{x:.6} + {slope:.4}*p{p}\"")
            };
            let (x, y) = (depends(r * angle.cos()), depends(r * angle.sin()));
            let bulge = match random.random_range(0..3) {
                0 => 0.0,
                _ => random.random_range(-0.2..0.3),
            };
            format!("[{x}, {y}, {bulge:.4}]")
        })
        .collect();
    if reversed {
        vertices.reverse();
    }
    format!("[{}]", vertices.join(", "))
}

/// Random parts in random holes: what first contacts give is what configuration spaces give, and nothing passes the extremes. More
/// pairs with `CSPACE_PAIRS`, another seed with `CSPACE_SEED`.
#[test]
#[ignore = "long: seconds"]
fn random_designs_stay_within_their_extremes() {
    const POINTS: usize = 60;
    let number = |name: &str, or: u64| {
        let given = std::env::var(name).ok();
        given.map_or(or, |text| text.parse().unwrap())
    };
    let mut random = ChaCha8Rng::seed_from_u64(number("CSPACE_SEED", 7));
    let (mut certified, mut passed, mut seen, mut numbers) = (0, 0, 0, 0);
    while seen < number("CSPACE_PAIRS", 6) {
        let parameters = random.random_range(1..5);
        let hole = outline(&mut random, [5.0, 8.0], parameters, true);
        let part = outline(&mut random, [2.0, 4.5], parameters, false);
        let tolerance: f64 = 10.0_f64.powf(random.random_range(-3.0..-0.5));
        let list: String = (0..parameters)
            .map(|p| format!("p{p} = {{ value = 0, tol = {tolerance:.6} }}\n"))
            .collect();
        let of = ["x", "y", "theta"][random.random_range(0..3)];
        let text = format!(
            "[parameter]\n{list}[[part]]\nname = \"frame\"\nloops = [[[-20, -20], [20, -20], [20, 20], [-20, 20]], {hole}]\n\
             [[part]]\nname = \"part\"\nloops = [{part}]\n\
             [[requirement]]\nname = \"play\"\npair = [\"frame\", \"part\"]\nmeasure = \"play\"\nof = \"{of}\"\n"
        );
        let template = template(&*text);
        let Ok(model) = template.model(&Host::default()) else {
            continue;
        };
        if check(&model)[0].measured.is_err() {
            continue;
        }
        seen += 1;
        let found = analysed(&template, number("CSPACE_SAMPLES", 500));
        let [lo, hi] = found.exact.clone().unwrap();
        let variations = Variations::of(&model);
        let range = found.monte_carlo.clone().unwrap().range;
        for _ in 0..POINTS {
            let deviations = variations.draw(&mut random);
            let set = variations.settings(&[], &deviations);
            let host = Host {
                set: &set,
                ..Host::default()
            };
            let Ok(model) = template.model(&host) else {
                continue;
            };
            let Ok(measured) = check(&model)[0].measured.clone() else {
                continue;
            };
            let Value::Number(value) = measured.value else {
                panic!("a play is a number");
            };
            numbers += 1;
            let slack = 1e-9 * value.abs().max(1.0);
            for (end, sign) in [(&lo, -1.0), (&hi, 1.0)] {
                if let (Ok(of), true) = (end.value.clone(), end.certified) {
                    let beyond = sign * (value - of);
                    assert!(
                        beyond <= slack,
                        "{value} beyond {of}:\n{text}{deviations:?}"
                    );
                }
            }
        }
        for (end, of) in [(&lo, range[0]), (&hi, range[1])] {
            let Ok(value) = end.value else {
                continue;
            };
            certified += usize::from(end.certified);
            let beyond = if core::ptr::eq(end, &lo) {
                value - of
            } else {
                of - value
            };
            // What is not proved may be passed, by no more than its gap.
            let may = if end.certified {
                0.0
            } else {
                end.gap.unwrap_or(f64::INFINITY)
            };
            let slack = 1e-9 * value.abs().max(1.0);
            passed += usize::from(beyond > slack);
            assert!(beyond <= may + slack, "{of} beyond {value}:\n{text}");
            // The value there, by a space of its own.
            let measured_at = |at: &[f64]| {
                let set = variations.settings(&[], at);
                let host = Host {
                    set: &set,
                    ..Host::default()
                };
                let there = check(&template.model(&host).unwrap())[0].measured.clone();
                there.map(|m| m.value)
            };
            if end.jumps {
                // Beside the place the value comes near to it.
                let is_near = |k: usize, by: f64| {
                    let mut at = end.at.clone();
                    at[k] += by * tolerance;
                    let there = measured_at(&at);
                    matches!(there, Ok(Value::Number(x)) if (x - value).abs() < 1e-4 * value.abs())
                };
                let mut all = (0..end.at.len()).flat_map(|k| [(k, 1e-7), (k, -1e-7)]);
                assert!(all.any(|(k, by)| is_near(k, by)), "{value}:\n{text}");
                continue;
            }
            let there = match measured_at(&end.at) {
                Ok(Value::Number(there)) => there,
                // Where parts jam within the tolerances, the extreme may be where they begin to.
                Err(Unmeasured::Blocked) if lo.value.is_err() => continue,
                other => panic!("{other:?}: {end:?}\n{text}"),
            };
            assert!(
                (there - value).abs() <= 1e-9 * value.abs().max(1.0),
                "{there} for {value}:\n{text}"
            );
        }
    }
    println!(
        "{seen} designs, {certified} extremes certified, {passed} others passed, {numbers} points"
    );
    assert!(passed <= (seen / 20) as usize, "{passed} of {seen}");
    assert!(certified >= seen as usize, "{certified} of {seen}");
}

const KEY: &str = r#"
[parameter]
pin = { value = 10, tol = 0.01 }
slot = { value = 10.1, tol = 0.04 }
[[part]]
name = "slot"
loops = [[[-19, -9], [19, -9], [19, 0], ["slot/2", 0], ["slot/2", -5], ["-slot/2", -5], ["-slot/2", 0], [-19, 0]]]
[[part]]
name = "key"
loops = [[["-pin/2", -4], ["pin/2", -4], ["pin/2", 4], ["-pin/2", 4]]]
[[requirement]]
name = "sideways"
measure = "play"
of = "x"
limits = [0.04, 0.4]
"#;

/// The play is slot − pin: it falls to a limit when the tolerances together are as wide as what is between, and the parts jam where it is 0.
#[test]
#[ignore = "long: seconds"]
fn a_limit_passed_before_a_jam_is_the_margin() {
    for (tol, margin) in [("0.1", 0.6), ("100", 0.000_6)] {
        let text = KEY
            .replace("tol = 0.04", &format!("tol = {tol}"))
            .replace(", tol = 0.01", "");
        let found = analysed(
            &template(text.replace("pin = { value = 10 }", "pin = 10")),
            0,
        );
        let factor = found.margin.factor.unwrap();
        near(factor, margin, 1e-6 * margin);
        let jam = found.structure.iter().find(|c| c.kind == ChangeKind::Jam);
        near(jam.unwrap().share, margin / 0.6, 1e-6 * margin);
    }
    // Without a value as drawn there is nothing to tell.
    let found = analysed(&template(KEY.replace("value = 10.1", "value = 9.9")), 10);
    assert_eq!(found.margin.factor, Some(0.0));
    assert!(found.exact.is_none() && found.structure.is_empty() && found.monte_carlo.is_none());
}

fn allocated(text: &str, criterion: Criterion, costs: &[f64]) -> Allocation {
    let template = template(text);
    let model = template.model(&Host::default()).unwrap();
    let options = ToleranceOptions::default();
    allocate(
        &template,
        &[],
        &model,
        &options,
        (criterion, costs),
        &Silent,
    )
    .unwrap()
}

/// With costs c/f and Σ a f = b the factors √(c/a) b / Σ √(c a) cost least.
#[test]
#[ignore = "long: seconds"]
fn allocated_tolerances_cost_least() {
    for costs in [[1.0, 1.0], [4.0, 1.0]] {
        let found = allocated(KEY, Criterion::Worst, &costs);
        let a = [0.01, 0.04];
        let sum: f64 = (costs.iter().zip(a)).map(|(c, a)| (c * a).sqrt()).sum();
        for i in 0..2 {
            let expected = (costs[i] / a[i]).sqrt() * 0.06 / sum;
            // Rounded down to three digits of the tolerance.
            assert!(found.factors[i] <= expected * (1.0 + 1e-9));
            near(found.factors[i], expected, 1e-2 * expected);
        }
        let margin = found.tolerances[0].margin.factor.unwrap();
        assert!((1.0..1.02).contains(&margin), "{margin}");
        // Other factors that fill what is there cost more.
        for share in [0.2, 0.4, 0.6, 0.8] {
            let f = [share * 0.06 / a[0], (1.0 - share) * 0.06 / a[1]];
            let cost = costs[0] / f[0] + costs[1] / f[1];
            assert!(cost > 0.98 * found.cost[1], "{cost} {:?}", found.cost);
        }
    }
}

/// The yield that is asked for is that of the samples: of two uniform parameters that of the corners cut off, in closed form.
#[test]
#[ignore = "long: seconds"]
fn a_yield_is_met_and_no_more() {
    let found = allocated(KEY, Criterion::Yield(0.99), &[1.0, 1.0]);
    let samples = found.tolerances[0].monte_carlo.clone().unwrap();
    assert!(samples.met >= 0.99 - 3.0 * samples.error);
    let [p, s] = [0.01 * found.factors[0], 0.04 * found.factors[1]];
    // Failing are those with s x − p y < −0.06 for x, y from −1 to 1.
    let beyond = (p + s - 0.06).max(0.0);
    let share = 0.5 * beyond * beyond / (4.0 * p * s);
    near(share, 0.01, 2e-3);
}

/// The lock has the same play wherever the disc stands, and a cam with a flat follower its law.
#[test]
fn bands_along_a_motion_are_those_of_closed_forms() {
    let of = |text: String, coordinate, values: &[f64]| {
        let template = template(text);
        let model = template.model(&Host::default()).unwrap();
        let options = ToleranceOptions::default();
        along(
            &template,
            &[],
            &model,
            &options,
            (coordinate, values),
            &Silent,
        )
        .unwrap()
    };
    let turns = [1.0, 0.0, 2.5];
    let turns = &turns[..effort(1, 3)];
    let bands = of(shipped("geneva_lock"), Coordinate::U, turns);
    for station in &bands[0].stations {
        let [lo, hi] = station.exact.clone();
        near(
            lo.value.clone().unwrap().to_degrees(),
            2.0 * 0.054_406_69,
            1e-7,
        );
        near(
            hi.value.clone().unwrap().to_degrees(),
            2.0 * 0.347_202_24,
            1e-7,
        );
        assert!(
            hi.certified && (lo.certified || lo.gap.unwrap() < 1e-4),
            "{lo:?} {hi:?}"
        );
    }
    let cam = r#"
[parameter]
base = { value = 20, tol = 0.05 }
off = { value = 3, tol = 0.02 }
[[part]]
name = "cam"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = "base", at = ["off", 0] }]
[[part]]
name = "follower"
motion = { type = "prismatic", direction = [0, 1], range = [-9, 30] }
loops = [[[-30, 20], [30, 20], [30, 24], [-30, 24]]]
[[requirement]]
name = "lift"
measure = "position"
of = "v"
at = { u = 0, v = 16 }
along = [0, -24]
"#;
    let turns: Vec<f64> = (0..9).map(|i| 0.8 * f64::from(i)).collect();
    let bands = of(cam.to_owned(), Coordinate::U, &turns);
    for station in &bands[0].stations {
        // v = base + off sin u − 20.
        let sin = station.at.sin();
        near(station.nominal.clone().unwrap(), 3.0 * sin, 1e-9);
        let half = 0.05 + 0.02 * sin.abs();
        let [lo, hi] = station.exact.clone();
        near(lo.value.unwrap(), 3.0 * sin - half, 1e-9);
        near(hi.value.unwrap(), 3.0 * sin + half, 1e-9);
    }
}

/// Configurations free or blocked within all tolerances are so in drawings by chance, and the bands of the lock end where its plays do.
#[test]
#[ignore = "long: seconds"]
fn contact_zones_hold_for_every_drawing() {
    let tries = 1500;
    let planar = r#"
[parameter]
a = { value = 5, tol = 0.05 }
b = { value = 0.05, tol = 0.01 }
[[part]]
name = "slot"
loops = [[[-9, -9], [9, -9], [9, 4], ["a/2", 4, "b"], ["a/2", -5], ["-a/2", -5], ["-a/2", 4], [-9, 4]]]
[[part]]
name = "key"
loops = [[[-2, -4], ["a/2 - 0.3", -4, "b"], [2, 4], [-2, 4]]]
[[requirement]]
name = "sideways"
measure = "play"
of = "x"
"#;
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let half = 1.0_f64.to_radians();
    let lock = [(-3.0, 3.0), (-half, half)];
    let cases = [
        (shipped("geneva_lock"), lock, 0.0),
        (planar.to_owned(), [(-1.5, 1.5), (-3.0, 8.0)], 0.02),
    ];
    for (text, window, theta) in cases {
        let template = template(text);
        let model = template.model(&Host::default()).unwrap();
        let Subject::Pair(pair, _) = model.requirements[0].subject else {
            panic!("a play is of a pair");
        };
        let found = zones(&template, &[], &model, (pair, window, theta), &Silent).unwrap();
        let variations = Variations::of(&model);
        let width = |r: (f64, f64)| r.1 - r.0;
        let area = |cells: &[[(f64, f64); 2]]| -> f64 {
            cells.iter().map(|c| width(c[0]) * width(c[1])).sum()
        };
        let certain = area(&found.free) + area(&found.blocked);
        assert!(certain < area(&[window]) && found.bands.iter().all(|b| !b.cells.is_empty()));
        let mut seen = [0; 2];
        for _ in 0..tries {
            let at = window.map(|(lo, hi)| random.random_range(lo..hi));
            let is_in = |c: &[(f64, f64); 2]| (0..2).all(|i| c[i].0 <= at[i] && at[i] <= c[i].1);
            let blocked = match (
                found.free.iter().any(is_in),
                found.blocked.iter().any(is_in),
            ) {
                (true, false) => false,
                (false, true) => true,
                (false, false) => continue,
                (true, true) => panic!("{at:?} is free and blocked"),
            };
            seen[usize::from(blocked)] += 1;
            let set = variations.settings(&[], &variations.draw(&mut random));
            let host = Host {
                set: &set,
                ..Host::default()
            };
            let drawn = template.model(&host).unwrap();
            let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &drawn.mechanism.parts[i].part);
            let placed = match drawn.mechanism.relation(&pair) {
                Relation::Axes { fixed, moving } => {
                    let from = fixed.configuration(at[0]).inverse();
                    from.compose(moving.configuration(at[1]))
                }
                _ => Configuration::new(at[0], at[1], theta),
            };
            assert_eq!(
                overlap_as_drawn(fixed, moving, placed),
                blocked,
                "{at:?} {set:?}"
            );
        }
        assert!(seen[0] > tries / 40 && seen[1] > tries / 10, "{seen:?}");
        if window == lock {
            let band = |cells: &[[(f64, f64); 2]]| {
                let ends = cells.iter().flat_map(|c| [c[1].0.abs(), c[1].1.abs()]);
                ends.fold(0.0, f64::max)
            };
            let cell = width(window[1]) / 512.0;
            let outer = found
                .bands
                .iter()
                .map(|b| band(&b.cells))
                .fold(0.0, f64::max);
            assert!(
                (0.347_202_24_f64.to_radians()..0.347_202_24_f64.to_radians() + 2.0 * cell)
                    .contains(&outer)
            );
        }
    }
}

/// A circle that rolls out of a corner: the largest play is beside a place where a contact is just missed.
#[test]
#[ignore = "long: seconds"]
fn extremes_at_a_jump_are_told() {
    let text = include_str!("../data/grazing.toml");
    let found = analysed(&template(text), 0);
    let [_, hi] = found.exact.unwrap();
    near(hi.value.unwrap(), 1.908_391_295_3, 1e-9);
    assert!(hi.jumps && hi.gap.unwrap() < 1e-4);
}

/// Angles keep being angles where they deviate: v = 10 + 3 sin(u + a) − 20.
#[test]
fn angles_vary_as_they_are_written() {
    let text = r#"
[parameter]
a = { value = "20deg", tol = "1deg" }
r = { value = 10, tol = 0.005 }
[[part]]
name = "cam"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = "r", at = ["3*cos(a)", "3*sin(a)"] }]
[[part]]
name = "tappet"
motion = { type = "prismatic", direction = [0, 1] }
loops = [[[-8, 20], [8, 20], [8, 25], [-8, 25]]]
[[requirement]]
name = "lift"
measure = "position"
at = { u = "90deg", v = 0 }
along = [0, -30]
"#;
    let found = analysed(&template(text), 100);
    let lift = |a: f64, r: f64| 3.0 * (90.0 + a).to_radians().sin() + r - 20.0;
    let [lo, hi] = found.exact.clone().unwrap();
    near(lo.value.unwrap(), lift(21.0, 9.995), 1e-9);
    near(hi.value.unwrap(), lift(19.0, 10.005), 1e-9);
    assert!(found.monte_carlo.unwrap().failures.is_empty());
}

/// A key that is flush with the mouth of its slot: edges slide along each other, and ends lie on each other. No space is needed.
#[test]
#[ignore = "long: seconds"]
fn flush_parts_need_no_space() {
    let text = KEY.replace(
        r#"["pin/2", 4], ["-pin/2", 4]"#,
        r#"["pin/2", 0], ["-pin/2", 0]"#,
    );
    let samples = analysed(&template(text), 200).monte_carlo.unwrap();
    assert!(
        samples.computed == 0.0 && samples.failures.is_empty(),
        "{samples:?}"
    );
}

/// Progress that counts samples, and ends a computation after so many.
struct Samples {
    most: u64,
    done: AtomicU64,
    of: AtomicU64,
}

impl Samples {
    fn new(most: u64) -> Self {
        Self {
            most,
            done: AtomicU64::new(0),
            of: AtomicU64::new(0),
        }
    }
}

impl Progress for Samples {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        match self.done.load(Ordering::Relaxed) < self.most {
            true => Ok(()),
            false => Err(ComputeError::Interrupted),
        }
    }

    fn pieces(&self, done: u64, of: u64) {
        self.done.fetch_max(done, Ordering::Relaxed);
        self.of.store(of, Ordering::Relaxed);
    }
}

/// Each sample is told, and the one after which nobody wants more is the last of its thread.
#[test]
fn samples_are_counted_and_end_when_asked() {
    let template = template(KEY);
    let model = template.model(&Host::default()).unwrap();
    let sampled = |progress: &Samples| {
        let options = ToleranceOptions {
            samples: 3000,
            ..ToleranceOptions::default()
        };
        tolerances(&template, &[], &model, &options, progress).unwrap()
    };
    let whole = Samples::new(u64::MAX);
    assert!(sampled(&whole)[0].monte_carlo.is_some());
    assert_eq!(
        [&whole.done, &whole.of].map(|n| n.load(Ordering::Relaxed)),
        [3000; 2]
    );
    let cut = Samples::new(100);
    let found = sampled(&cut);
    assert!(found[0].interrupted && found[0].monte_carlo.is_none());
    let cut = Samples::new(100);
    let options = ToleranceOptions::default();
    let wanted = (Criterion::Yield(0.9), &[1.0, 1.0][..]);
    let none = allocate(&template, &[], &model, &options, wanted, &cut);
    assert_eq!(none.err(), Some(Unallocated::Interrupted));
    assert_eq!(cut.of.load(Ordering::Relaxed), 1000);
    assert!(cut.done.load(Ordering::Relaxed) < 1000);
}

/// Progress that ends a computation once something is known.
struct UntilKnown(AtomicBool);

impl Progress for UntilKnown {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        match self.0.load(Ordering::Relaxed) {
            true => Err(ComputeError::Interrupted),
            false => Ok(()),
        }
    }
}

#[test]
fn what_is_known_at_once_is_kept() {
    let template = Template::from_text(PEG.to_owned(), "peg.toml").unwrap();
    let model = template.model(&Host::default()).unwrap();
    let options = ToleranceOptions::default();
    let whole = tolerances(&template, &[], &model, &options, &Silent).unwrap();
    let progress = UntilKnown(AtomicBool::new(false));
    let known = |known: &[Tolerances]| {
        assert!(known.iter().all(|of| of.interrupted && of.exact.is_none()));
        progress.0.store(true, Ordering::Relaxed);
    };
    let cut = tolerances_with(&template, &[], &model, &options, &known, &progress).unwrap();
    for (cut, whole) in cut.iter().zip(&whole) {
        let (a, b) = (cut.linear.as_ref().unwrap(), whole.linear.as_ref().unwrap());
        assert!(cut.interrupted && !whole.interrupted && a.worst == b.worst && a.rss == b.rss);
    }
    let options = ToleranceOptions {
        without_proof: true,
        ..options
    };
    let found = tolerances(&template, &[], &model, &options, &Silent).unwrap();
    for (found, whole) in found.iter().zip(&whole) {
        let (found, whole) = (found.exact.as_ref().unwrap(), whole.exact.as_ref().unwrap());
        for (found, proved) in found.iter().zip(whole) {
            assert!(proved.certified && !found.certified);
            near(
                *found.value.as_ref().unwrap(),
                *proved.value.as_ref().unwrap(),
                1e-9,
            );
        }
    }
}
