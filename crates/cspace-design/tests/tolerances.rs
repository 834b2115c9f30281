//! Tolerances of designs whose answers are known, and of random ones against configuration spaces.
#![allow(clippy::unwrap_used)]

use cspace::Silent;
use cspace_design::{
    ChangeKind, ToleranceOptions, Tolerances, Unmeasured, Value, Variations, check, tolerances,
};
use cspace_io::Host;
use cspace_io::model::Template;
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

/// The play of the lock is that of its arc's ends, until the arc itself jams.
#[test]
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
fn a_peg_fits_its_slot_or_does_not() {
    let found = analysed(&template(PEG), 2000);
    let [lo, hi] = ends(&found);
    near(0.5 * lo.to_degrees(), 0.221_823_92, 5e-9);
    near(0.5 * hi.to_degrees(), 0.416_965_03, 5e-9);
    let tilt = |w: f64, h: f64, s: f64| (s / w.hypot(h)).acos() - h.atan2(w);
    near(0.5 * lo, -tilt(10.01, 18.1, 10.08), 1e-12);
    let range = found.monte_carlo.unwrap().range;
    assert!(lo <= range[0] && range[1] <= hi);
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
    // The width and the slot decide; the height does not.
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
    let found = analysed(&template(model), 4000);
    near(found.margin.factor.unwrap(), 0.5, 1e-6);
    assert_eq!(found.structure[0].kind, ChangeKind::Region);
    let samples = found.monte_carlo.unwrap();
    near(samples.met, 0.875, 4.0 * samples.error);
}

/// A key wider than its slot, deep in its walls, is no sample with play, and no largest value: the slot is at most 10.4.
#[test]
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
}

#[test]
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
fn random_designs_stay_within_their_extremes() {
    const POINTS: usize = 60;
    let number = |name: &str, or: u64| {
        let given = std::env::var(name).ok();
        given.map_or(or, |text| text.parse().unwrap())
    };
    let mut random = ChaCha8Rng::seed_from_u64(number("CSPACE_SEED", 7));
    let (mut certified, mut seen, mut numbers) = (0, 0, 0);
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
        let found = analysed(&template, 500);
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
            if let Ok(lo) = lo.value {
                assert!(
                    value >= lo - slack,
                    "{value} below {lo}:\n{text}{deviations:?}"
                );
            }
            if let Ok(hi) = hi.value {
                assert!(
                    value <= hi + slack,
                    "{value} above {hi}:\n{text}{deviations:?}"
                );
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
            assert!(
                beyond <= 1e-9 * value.abs().max(1.0),
                "{of} beyond {value}:\n{text}"
            );
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
    println!("{seen} designs, {certified} extremes certified, {numbers} points");
    assert!(certified >= seen as usize, "{certified} of {seen}");
}
