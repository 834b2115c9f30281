//! The classifier gives the answers of the space itself, and of brute force.

use core::f64::consts::{PI, TAU};

use cspace::{
    Classification, Classifier, Configuration, ContactSpace, Options, Part, PatchId, Symmetry,
    Vector, Vertex,
};
use cspace_oracle::shapes::{gear, pawl, ratchet};
use cspace_oracle::{Oracle, Pair, effort, is_long, near_contact_about, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::SPACES;

/// Too slow, or accepted with conflicts, where optimisation is off.
const SLOW: [&str; 2] = ["gears 26 and 24", "crescents of equal arcs"];

/// Pairs for which the space itself is wrong in a few places, or contact is nearer than rounding resolves.
const INEXACT: [&str; 4] = [
    "crescents of equal arcs",
    // Arcs of radii about 1e9 times their length.
    "nearly straight arcs",
    // Coordinates about 1e6: their rounding exceeds the resolution.
    "squares drawn far away",
    "random parts drawn far away",
];

fn tried() -> impl Iterator<Item = &'static (Pair, ContactSpace)> {
    SPACES
        .iter()
        .filter(|(p, _)| is_long() || !SLOW.contains(&p.name.as_str()))
}

fn space_of(pair: &Pair) -> ContactSpace {
    ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap()
}

/// A configuration anywhere the parts may meet, or a little beyond.
fn anywhere(oracle: &Oracle, rng: &mut impl Rng) -> Configuration {
    let theta = rng.random_range(-PI..PI);
    let (at, drawn) = (oracle.fixed_center(), oracle.moving_center());
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(drawn);
    let mut share = || oracle.size() * rng.random_range(-1.2..1.2);
    Configuration::new(at.x + share() - turned.x, at.y + share() - turned.y, theta)
}

/// Message if the answer at a configuration is wrong.
fn wrong(
    space: &ContactSpace,
    classifier: &Classifier<&ContactSpace>,
    c: Configuration,
    overlap: Option<bool>,
) -> Option<String> {
    let (fast, slow) = (classifier.classify(c), space.classify(c));
    if fast != slow {
        return Some(format!("{fast:?}, the space says {slow:?}, at {c:?}"));
    }
    let expected = overlap.map(|o| {
        if o {
            Classification::Blocked
        } else {
            Classification::Free
        }
    });
    (expected.is_some() && fast != expected)
        .then(|| format!("{fast:?}, brute force says {expected:?}, at {c:?}"))
}

#[test]
fn agrees_with_the_space_and_with_brute_force() {
    let (mut tried_at, mut mistakes) = (0, Vec::new());
    for (pair, space) in tried() {
        let name = &pair.name;
        let classifier = Classifier::new(space);
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let inexact = INEXACT.contains(&name.as_str());
        let certain = if inexact {
            f64::INFINITY
        } else {
            1e-10 * oracle.size()
        };
        let n = if SLOW.contains(&name.as_str()) {
            effort(20, 500)
        } else {
            effort(40, 2000)
        };
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let mut all: Vec<(Configuration, Option<bool>)> =
            near_contact_about(&oracle, &pair.notable, &mut rng, n)
                .into_iter()
                .map(|near| {
                    let overlap = (near.verdict.margin > certain).then_some(!near.free);
                    (near.configuration, overlap)
                })
                .collect();
        for i in 0..n {
            let c = anywhere(&oracle, &mut rng);
            let verdict = (i % 8 == 0).then(|| oracle.judge(c));
            let overlap = verdict.filter(|v| v.margin > certain).map(|v| v.overlap);
            all.push((c, overlap));
        }
        tried_at += all.len();
        let found: Vec<String> = all
            .par_iter()
            .filter_map(|&(c, overlap)| wrong(space, &classifier, c, overlap))
            .collect();
        if let Some(first) = found.first() {
            mistakes.push(format!("{name}: {} mistakes: {first}", found.len()));
        }
    }
    assert!(mistakes.is_empty(), "{}", mistakes.join("\n"));
    assert!(tried_at > effort(4_000, 200_000), "{tried_at}");
}

/// Random configurations, some near contact; the classifier and the space must agree on them, also after whole turns.
#[test]
fn windows_and_turns() {
    for name in [
        "random 3",
        "gears 10 and 9",
        "ratchet 8 and pawl",
        "mirrored pawls",
    ] {
        let pair = pair(name);
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        for (lo, hi) in [
            (-0.3, 0.4),
            (2.9, 3.5),
            (10.0, 10.2),
            (0.7, 0.7 + 6.2),
            (1.0, 1.001),
        ] {
            let options = Options {
                window: Some((lo, hi)),
                ..Options::default()
            };
            let space = ContactSpace::compute(&pair.fixed, &pair.moving, &options).unwrap();
            let classifier = Classifier::new(&space);
            let mut rng = ChaCha8Rng::seed_from_u64(5);
            let mut asked = 0;
            for _ in 0..effort(100, 2000) {
                let c = anywhere(&oracle, &mut rng);
                let share = rng.random_range(-0.1..1.1);
                for theta in [lo + share * (hi - lo), lo, hi, c.theta] {
                    let c = Configuration::new(c.x, c.y, theta);
                    let found = classifier.classify(c);
                    assert_eq!(found, space.classify(c), "{name} at {c:?}");
                    assert_eq!(found.is_some(), (lo..=hi).contains(&theta));
                    asked += usize::from(found.is_some());
                }
            }
            assert!(asked > effort(200, 4000));
        }
        let space = space_of(&pair);
        let classifier = Classifier::new(&space);
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        for _ in 0..effort(100, 2000) {
            let c = anywhere(&oracle, &mut rng);
            for turns in [-1.0, 0.0, 1.0, -3.0, 100.0, -1e4] {
                let c = Configuration::new(c.x, c.y, c.theta + turns * TAU);
                assert!(
                    wrong(&space, &classifier, c, None).is_none(),
                    "{name}: {c:?}"
                );
            }
            for theta in [PI, -PI, 0.0, -3.0 * PI, 0.5 * PI] {
                let c = Configuration::new(c.x, c.y, theta);
                assert!(
                    wrong(&space, &classifier, c, None).is_none(),
                    "{name}: {c:?}"
                );
            }
        }
    }
}

/// Configurations beside critical orientations, on the curves there and next to them. At a critical orientation itself, reduced by another
/// number of turns than a patch was, rounding decides which patches exist.
#[test]
fn critical_orientations() {
    for name in [
        "squares",
        "square in its square hole",
        "random 5",
        "mirrored pawls",
        "annuli",
    ] {
        let pair = pair(name);
        let space = space_of(&pair);
        let classifier = Classifier::new(&space);
        let size = pair.fixed.size().max(pair.moving.size());
        let mut rng = ChaCha8Rng::seed_from_u64(8);
        for &critical in space.critical_orientations().iter().take(effort(20, 60)) {
            for off in [1e-14, -1e-14, 1e-9, -1e-9, 1e-5, -1e-5] {
                let theta = critical + off;
                let slice = space.slice(theta);
                for curve in &slice.curves {
                    let s = rng.random_range(0.0..1.0);
                    let normal = curve.geometry.free_normal(s);
                    for step in [0.0, 1e-9, -1e-9, 1e-4, -1e-4] {
                        let p = curve.geometry.point(s) + normal * (step * size);
                        let c = Configuration::new(p.x, p.y, theta);
                        let mistake = wrong(&space, &classifier, c, None);
                        assert_eq!(mistake, None, "{name}, {step} beside a curve");
                    }
                }
            }
        }
    }
}

/// Positions in line with corners and with whole edges.
#[test]
fn positions_in_line_with_features() {
    let pair = pair("square in a larger hole");
    let space = space_of(&pair);
    let classifier = Classifier::new(&space);
    for i in -40..=40 {
        for j in -40..=40 {
            for theta in [0.0, 1e-12, 0.5 * PI, 0.25 * PI] {
                let c = Configuration::new(f64::from(i) * 0.1, f64::from(j) * 0.1, theta);
                assert_eq!(wrong(&space, &classifier, c, None), None);
            }
        }
    }
}

/// Positions from which the first ray passes through a joint of two curves, where it might miss both.
#[test]
fn rays_through_joints() {
    /// The direction of that ray.
    const FIRST: f64 = 1.234_567_89;
    let (mut asked, mut mistakes) = (0, Vec::new());
    let mut rng = ChaCha8Rng::seed_from_u64(13);
    for name in [
        "squares",
        "disc in annulus",
        "three pegs in three holes",
        "random 5",
        "peg in chamfered hole",
    ] {
        let pair = pair(name);
        let space = space_of(&pair);
        let classifier = Classifier::new(&space);
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        for _ in 0..12 {
            let slice = space.slice(rng.random_range(-PI..PI));
            for curve in &slice.curves {
                let way = oracle.size() * rng.random_range(-0.01..2.0);
                let p = curve.geometry.point(0.0) + Vector::from_angle(FIRST) * -way;
                let c = Configuration::new(p.x, p.y, slice.theta);
                let verdict = oracle.judge(c);
                let sure = verdict.margin > 1e-9 * oracle.size();
                let overlap = sure.then_some(verdict.overlap);
                mistakes.extend(wrong(&space, &classifier, c, overlap));
                asked += 1;
            }
        }
    }
    assert!(
        mistakes.is_empty(),
        "{} of {asked}: {mistakes:#?}",
        mistakes.len()
    );
    assert!(asked > 500, "{asked}");
}

/// Contact circles that hardly differ cross at places that are lost in rounding, or in an enclosure: circles of one radius about centres
/// far nearer to each other than that.
#[test]
fn circles_that_are_nearly_one() {
    let (mut asked, mut mistakes) = (0, Vec::new());
    for (family, value, orientations) in [
        ("gear with itself, teeth", 8.0, [0.5 * PI, PI]),
        (
            "small part and a larger one around it, ratio",
            1e4,
            [-2.183_566, 0.2],
        ),
        (
            "three pegs in three holes, clearance",
            1e-2,
            [-2.557_647_265_863_493e-6, 3e-3],
        ),
    ] {
        let all = cspace_oracle::families();
        let family = all.iter().find(|f| f.name == family).unwrap();
        let case = family.build(value).unwrap();
        let space = ContactSpace::compute(&case.fixed, &case.moving, &Options::default()).unwrap();
        let classifier = Classifier::new(&space);
        let oracle = Oracle::new(&case.fixed, &case.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(12);
        for theta in orientations {
            let slice = space.slice(theta);
            for _ in 0..effort(100, 2000) {
                let curve = &slice.curves[rng.random_range(0..slice.curves.len())].geometry;
                let s = rng.random_range(0.0..1.0);
                let off = oracle.size() * 10f64.powf(rng.random_range(-8.0..-0.5));
                let p =
                    curve.point(s) + curve.free_normal(s) * if rng.random() { off } else { -off };
                let c = Configuration::new(p.x, p.y, theta);
                mistakes.extend(wrong(&space, &classifier, c, None));
                asked += 1;
            }
        }
    }
    assert!(
        mistakes.is_empty(),
        "{} of {asked}: {:#?}",
        mistakes.len(),
        &mistakes[..1]
    );
}

#[test]
fn saved_spaces_and_what_is_no_configuration() {
    let pair = pair("random 2");
    let space = space_of(&pair);
    let saved = ContactSpace::from_data(space.data().clone()).unwrap();
    let (classifier, again) = (Classifier::new(&space), Classifier::new(&saved));
    assert_eq!(classifier.bytes(), again.bytes());
    let far = Classification::Free;
    for (c, expected) in [
        (Configuration::new(f64::NAN, 0.0, 0.0), None),
        (Configuration::new(0.0, f64::INFINITY, 0.0), None),
        (Configuration::new(0.0, 0.0, f64::NAN), None),
        (Configuration::new(0.0, 0.0, f64::NEG_INFINITY), None),
        (Configuration::new(1e300, -1e300, 1.0), Some(far)),
        (Configuration::new(1e300, 0.0, 1e15), Some(far)),
    ] {
        for space in [&space, &saved] {
            assert_eq!(space.classify(c), expected, "{c:?}");
        }
        for classifier in [&classifier, &again] {
            assert_eq!(classifier.classify(c), expected, "{c:?}");
        }
    }
}

/// A motion is free until its first contact.
#[test]
fn agrees_with_first_contacts() {
    let (fixed, moving) = (gear(10, 1.0), gear(9, 1.0));
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = Classifier::new(&space);
    let at = Configuration::new;
    let mut rng = ChaCha8Rng::seed_from_u64(23);
    let mut contacts = 0;
    for _ in 0..1000 {
        let mut share = |s: f64| rng.random_range(-s..s);
        let from = at(share(14.0), share(14.0), share(PI));
        let rates = [share(10.0), share(10.0), share(3.0)];
        if classifier.classify(from) != Some(Classification::Free) {
            continue;
        }
        let outcome = space.first_contact(from, rates, 2.0).unwrap();
        let until = outcome.contact().map_or(2.0, |c| c.time);
        contacts += usize::from(outcome.contact().is_some());
        for k in 0..1000 {
            let t = until * f64::from(k) / 1000.0;
            let [dx, dy, turning] = rates;
            let c = at(from.x + t * dx, from.y + t * dy, from.theta + t * turning);
            assert_eq!(classifier.classify(c), Some(Classification::Free), "{c:?}");
        }
        if let Some(c) = outcome.contact() {
            let there = classifier.classify(c.configuration);
            assert_eq!(there, Some(Classification::Contact));
        }
    }
    assert!(contacts > 100, "{contacts}");
}

/// A part drawn elsewhere: its motion, and its centre of symmetry, change.
fn moved(part: &Part, by: Vector) -> Part {
    let place = |v: &Vertex| Vertex {
        x: v.x + by.x,
        y: v.y + by.y,
        ..*v
    };
    let loops = part.loops().iter();
    let loops = loops.map(|l| l.vertices().iter().map(place).collect());
    Part::new(part.name(), loops.collect()).unwrap()
}

/// Symmetric pairs are looked up in one period. In the other periods, with either part symmetric or both, drawn anywhere, and for
/// configurations at contact, just beside it, at the ends of periods and anywhere, the answers are those of the space, and of brute force.
#[test]
fn slabs_of_symmetric_pairs() {
    let (away, far) = (Vector::new(3.0, -2.0), Vector::new(-40.0, 7.0));
    let pawl = pawl();
    let pairs = [
        (gear(10, 1.0), gear(9, 1.0)),
        (moved(&gear(8, 1.0), away), moved(&gear(6, 1.0), far)),
        (moved(&ratchet(12), far), pawl.clone()),
        (moved(&pawl, away), moved(&ratchet(9), away)),
    ];
    let mut asked = [0; 3];
    for (fixed, moving) in pairs {
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let slabs = space.symmetry().slabs;
        assert!(slabs > 8, "{slabs}");
        let classifier = Classifier::new(&space);
        let general = Options {
            symmetry: Symmetry::Ignore,
            ..Options::default()
        };
        let general = ContactSpace::compute(&fixed, &moving, &general).unwrap();
        // Only one period is prepared.
        let bytes = Classifier::new(&general).bytes();
        assert!(
            10 * classifier.bytes() < 9 * bytes,
            "{} of {bytes}",
            classifier.bytes()
        );
        let oracle = Oracle::new(&fixed, &moving);
        let size = oracle.size();
        let mut rng = ChaCha8Rng::seed_from_u64(21);
        let period = TAU / f64::from(slabs);
        let mut configurations = Vec::new();
        for i in 0..slabs {
            // Somewhere in the period, next to its ends, and where patches begin, after any number of turns.
            let begin = period * f64::from(i) - PI;
            let critical = space.critical_orientations();
            let critical = critical[rng.random_range(0..critical.len())];
            let turns = TAU * f64::from(rng.random_range(-2..=2));
            let thetas = [
                begin + period * rng.random_range(0.0..1.0),
                begin,
                begin + 1e-13,
                begin - 1e-13,
                critical + 1e-9,
                critical - 1e-12,
            ];
            for theta in thetas.map(|t| t + turns) {
                let slice = space.slice(theta);
                for _ in 0..12 {
                    let curve = &slice.curves[rng.random_range(0..slice.curves.len())].geometry;
                    let s = rng.random_range(0.0..1.0);
                    let off = [0.0, 1e-9, 1e-8, 1e-6, 1e-3][rng.random_range(0..5)] * size;
                    let off = if rng.random() { off } else { -off };
                    let p = curve.point(s) + curve.free_normal(s) * off;
                    configurations.push(Configuration::new(p.x, p.y, theta));
                }
                let c = anywhere(&oracle, &mut rng);
                configurations.push(Configuration::new(c.x, c.y, theta));
            }
        }
        for (i, &c) in configurations.iter().enumerate() {
            let verdict = (i % 8 == 0).then(|| oracle.judge(c));
            let sure = verdict.filter(|v| v.margin > 1e-10 * size);
            let mistake = wrong(&space, &classifier, c, sure.map(|v| v.overlap));
            assert_eq!(mistake, None, "{slabs} slabs");
            match classifier.classify(c).unwrap() {
                Classification::Free => asked[0] += 1,
                Classification::Blocked => asked[1] += 1,
                Classification::Contact => asked[2] += 1,
            }
        }
    }
    assert!(asked.iter().all(|&n| n > 500), "{asked:?}");
}

/// A space that claims to repeat is checked: where its patches are not images of each other, all of them are prepared.
#[test]
fn slabs_that_are_none() {
    let (fixed, moving) = (ratchet(8), pawl());
    let general = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let mut claimed = ContactSpace::compute(&fixed, &moving, &general)
        .unwrap()
        .data()
        .clone();
    claimed.symmetry = space.symmetry();
    let mut shuffled = space.data().clone();
    // Patches with other numbers, also in links.
    let n = shuffled.patches.len() as u32;
    let number = |i: PatchId| PatchId((i.0 + 3) % n);
    shuffled.patches.rotate_right(3);
    for link in &mut shuffled.side_links {
        (link.before, link.after) = (number(link.before), number(link.after));
    }
    for link in &mut shuffled.vertical_links {
        (link.lower, link.upper) = (number(link.lower), number(link.upper));
    }
    let oracle = Oracle::new(&fixed, &moving);
    for data in [claimed, shuffled] {
        let space = ContactSpace::from_data(data).unwrap();
        let classifier = Classifier::new(&space);
        let mut rng = ChaCha8Rng::seed_from_u64(22);
        for _ in 0..4000 {
            let c = anywhere(&oracle, &mut rng);
            assert_eq!(wrong(&space, &classifier, c, None), None);
        }
    }
}
