//! Clashes beside closed forms, dense points and tests of overlap at single places.

use core::f64::consts::TAU;

use cspace::pair::Joint;
use cspace::{Configuration, FeatureKind, Part, Point, Vertex};
use cspace_model::{JointEntry, Mechanism, PartEntry};
use cspace_oracle::Oracle;
use cspace_plan::clash::{Assembly, Clash, Question, Sample, State};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn mechanism(parts: Vec<Part>) -> Mechanism {
    let mut mechanism = Mechanism::new("test");
    mechanism.parts = parts.into_iter().map(PartEntry::planar).collect();
    mechanism
}

fn drawn(parts: Vec<Part>) -> Vec<Clash> {
    let mechanism = mechanism(parts);
    Assembly::new(&mechanism).drawn(&Question::default()).pairs
}

/// The one pair of two parts.
fn two(a: Part, b: Part) -> Clash {
    let pairs = drawn(vec![a, b]);
    assert_eq!(pairs.len(), 1);
    pairs[0].clone()
}

fn disc(name: &str, x: f64, y: f64, r: f64) -> Part {
    Part::circle(name, [x, y], r).unwrap()
}

fn square(name: &str, (x, y): (f64, f64), (w, h): (f64, f64)) -> Part {
    Part::rectangle(name, (x, y), w, h).unwrap()
}

/// An outline with lines and arcs.
fn drawn_at_random(name: &str, rng: &mut ChaCha8Rng) -> Part {
    loop {
        if let Ok(part) = Part::new(name, cspace_load::outline::outline(rng)) {
            return part;
        }
    }
}

/// How far the points that are told are from each other.
fn apart(clash: &Clash) -> f64 {
    let [p, q] = clash.points.unwrap();
    p.distance(q)
}

#[test]
fn discs_by_their_radii() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..200 {
        let (r, s) = (rng.random_range(0.1..2.0), rng.random_range(0.1..2.0));
        let (x, y) = (rng.random_range(-3.0..3.0), rng.random_range(-3.0..3.0));
        let found = two(disc("a", 0.5, 0.25, r), disc("b", 0.5 + x, 0.25 + y, s));
        let gap = f64::hypot(x, y) - r - s;
        if gap > 0.0 {
            assert_eq!(found.state, State::Clear);
            assert!((found.gap.unwrap() - gap).abs() < 1e-12);
        } else {
            assert_eq!(found.state, State::Overlap);
            assert!((found.depth.unwrap() + gap).abs() < 1e-9, "{found:?} {gap}");
        }
        assert!((apart(&found) - gap.abs()).abs() < 1e-9);
    }
}

#[test]
fn boxes_by_their_sides() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for _ in 0..200 {
        let mut number = |lo: f64, hi: f64| rng.random_range(lo..hi);
        let (w, h) = (
            (number(0.2, 2.0), number(0.2, 2.0)),
            (number(0.2, 2.0), number(0.2, 2.0)),
        );
        let (x, y) = (number(-2.0, 2.0), number(-2.0, 2.0));
        let found = two(square("a", (0.0, 0.0), w), square("b", (x, y), h));
        let across = x.abs() - 0.5 * (w.0 + h.0);
        let up = y.abs() - 0.5 * (w.1 + h.1);
        if across.max(up) > 0.0 {
            let gap = across.max(0.0).hypot(up.max(0.0));
            assert!((found.gap.unwrap() - gap).abs() < 1e-12);
        } else {
            assert!((found.depth.unwrap() - (-across).min(-up)).abs() < 1e-9);
        }
    }
}

/// Places where boundaries coincide and nothing crosses.
#[test]
fn what_is_flush_touches_and_what_coincides_overlaps() {
    let flush = two(
        square("a", (0.0, 0.0), (2.0, 2.0)),
        square("b", (2.0, 0.5), (2.0, 2.0)),
    );
    assert_eq!(flush.state, State::Touching);
    assert!(flush.gap.unwrap() < 1e-12 && apart(&flush) < 1e-12);
    let same = two(
        square("a", (0.0, 0.0), (2.0, 2.0)),
        square("b", (0.0, 0.0), (2.0, 2.0)),
    );
    assert_eq!(same.state, State::Overlap);
    assert!((same.depth.unwrap() - 2.0).abs() < 1e-9);
    // A plug in its hole, and one of another size in it, off its middle.
    let circle = |r: f64| {
        Part::circle("c", [0.0, 0.0], r).unwrap().loops()[0]
            .vertices()
            .to_vec()
    };
    let ring = || Part::new("ring", vec![circle(3.0), circle(2.0)]).unwrap();
    assert_eq!(
        two(ring(), disc("plug", 0.0, 0.0, 2.0)).state,
        State::Touching
    );
    assert_eq!(
        two(disc("plug", 0.0, 0.0, 2.0), ring()).state,
        State::Touching
    );
    let loose = two(ring(), disc("plug", 0.5, 0.0, 1.0));
    assert!((loose.gap.unwrap() - 0.5).abs() < 1e-12);
    // A pin within the material: out through the nearer side, which is the hole's.
    let pin = two(ring(), disc("pin", 2.4, 0.0, 0.1));
    assert_eq!(pin.state, State::Overlap);
    assert!((pin.depth.unwrap() - 0.5).abs() < 1e-9);
}

/// Random outlines at random places: no point is nearer than the gap; the translation that is told separates, and none that is
/// shorter does.
#[test]
fn random_parts_beside_points_and_shorter_translations() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let (mut clear, mut overlaps) = (0, 0);
    for number in 0..60 {
        let [a, b] = ["a", "b"].map(|name| drawn_at_random(name, &mut rng));
        let by = Point::new(rng.random_range(-2.0..2.0), rng.random_range(-2.0..2.0));
        let turn = rng.random_range(0.0..TAU);
        let at = Configuration::new(by.x, by.y, turn);
        let mut both = mechanism(vec![a.clone(), b.clone()]);
        both.name = number.to_string();
        let samples = [Sample {
            time: 0.0,
            parts: vec![[0.0; 3], [by.x, by.y, turn]],
        }];
        let found = Assembly::new(&both).along(&samples, &Question::default());
        let found = &found.pairs[0];
        let oracle = Oracle::new(&a, &b);
        let points = |part: &Part, at: Configuration| -> Vec<Point> {
            let on = |e: cspace::Edge| (0..64).map(move |k| e.at(f64::from(k) / 64.0));
            let all = part.edges().flat_map(on);
            all.map(|q| at.fixed_from_moving(q)).collect()
        };
        match found.state {
            State::Clear => {
                clear += 1;
                let gap = found.gap.unwrap();
                let (p, q) = (points(&a, Configuration::default()), points(&b, at));
                let least = (p.iter().flat_map(|p| q.iter().map(move |q| p.distance(*q))))
                    .fold(f64::INFINITY, f64::min);
                let spacing = (a.edges().chain(b.edges()))
                    .map(|e| e.length() / 64.0)
                    .fold(0.0, f64::max);
                assert!(
                    least >= gap - 1e-12 && least <= gap + spacing,
                    "{least} {gap}"
                );
                assert!((apart(found) - gap).abs() < 1e-12);
            }
            State::Overlap => {
                overlaps += 1;
                let depth = found.depth.unwrap();
                let [p, q] = found.points.unwrap();
                let out = p - q;
                let moved = |x: f64, y: f64| Configuration::new(at.x + x, at.y + y, turn);
                assert!((out.length() - depth).abs() < 1e-9);
                // It is at the edge of free space there, which may be a corner of it.
                let beside = |far: f64| {
                    (0..64).any(|k| {
                        let more = cspace::Vector::from_angle(TAU * f64::from(k) / 64.0) * far;
                        !oracle.judge(moved(out.x + more.x, out.y + more.y)).overlap
                    })
                };
                assert!([1e-9, 1e-6, 1e-3].into_iter().any(beside), "{number}");
                for k in 0..45 {
                    let way = cspace::Vector::from_angle(TAU * f64::from(k) / 45.0);
                    for share in [0.25, 0.5, 0.75, 0.95, 0.999] {
                        let by = way * (depth * share);
                        assert!(
                            oracle.judge(moved(by.x, by.y)).overlap,
                            "{number} {k} {share}"
                        );
                    }
                }
            }
            _ => {}
        }
    }
    assert!(clear > 10 && overlaps > 10, "{clear} {overlaps}");
}

/// The least gap over a motion of constant rates beside dense times, and parts that pass through each other between samples.
#[test]
fn motions_beside_dense_times() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for _ in 0..12 {
        let [a, b] = ["a", "b"].map(|name| drawn_at_random(name, &mut rng));
        let mut place = || {
            let angle = rng.random_range(0.0..TAU);
            let far = cspace::Vector::from_angle(angle) * 4.0;
            [far.x, far.y, rng.random_range(-3.0..3.0)]
        };
        let ends = [[place(), [0.0; 3]], [place(), [0.5, 0.0, 1.0]]];
        let sample = |time: f64, parts: [[f64; 3]; 2]| Sample {
            time,
            parts: parts.to_vec(),
        };
        let both = mechanism(vec![a, b]);
        let assembly = Assembly::new(&both);
        let told =
            |samples: &[Sample]| assembly.along(samples, &Question::default()).pairs[0].clone();
        let whole = told(&[sample(10.0, ends[0]), sample(12.0, ends[1])]);
        let dense: Vec<Clash> = (0..=100)
            .map(|k| {
                let share = f64::from(k) / 100.0;
                let between =
                    |i: usize, j: usize| ends[0][i][j] + (ends[1][i][j] - ends[0][i][j]) * share;
                let parts = [0, 1].map(|i| core::array::from_fn(|j| between(i, j)));
                told(&[sample(10.0 + 2.0 * share, parts)])
            })
            .collect();
        let gap = |c: &Clash| c.gap.unwrap_or(0.0);
        let nearest = dense
            .iter()
            .min_by(|a, b| gap(a).total_cmp(&gap(b)))
            .unwrap();
        if nearest.state == State::Clear && whole.state == State::Clear {
            assert!(gap(&whole) <= gap(nearest) * (1.0 + 1e-6));
            // No coordinate moves a point faster than that between two times.
            assert!(gap(&whole) > gap(nearest) - 0.3);
            continue;
        }
        let is_overlap = |c: &Clash| c.state == State::Overlap;
        let at_end = is_overlap(&dense[0]) || is_overlap(&dense[100]);
        match whole.state {
            State::Overlap => assert!(at_end),
            State::Meets => assert!(!at_end),
            state => assert!(!dense.iter().any(is_overlap), "{state:?}"),
        }
    }
}

/// A wheel in a ring about one centre has the same gap all along, which is found once and not again in every leg.
#[test]
fn a_gap_that_stays_the_same() {
    let circle = |r: f64| {
        Part::circle("c", [0.0, 0.0], r).unwrap().loops()[0]
            .vertices()
            .to_vec()
    };
    let ring = Part::new("ring", vec![circle(3.0), circle(2.0)]).unwrap();
    let both = mechanism(vec![ring, disc("wheel", 0.0, 0.0, 1.9)]);
    let samples: Vec<Sample> = (0..50)
        .map(|k| Sample {
            time: f64::from(k),
            parts: vec![[0.0; 3], [0.0, 0.0, 0.7 * f64::from(k)]],
        })
        .collect();
    let found = Assembly::new(&both).along(&samples, &Question::default());
    assert_eq!(found.pairs[0].state, State::Clear);
    assert!((found.pairs[0].gap.unwrap() - 0.1).abs() < 1e-6);
}

#[test]
fn joined_parts_are_not_judged_and_far_ones_are_counted() {
    let mut both = mechanism(vec![
        disc("a", 0.0, 0.0, 1.0),
        disc("b", 1.0, 0.0, 1.0),
        disc("c", 5.0, 0.0, 1.0),
        disc("d", 9.0, 0.0, 1.0),
    ]);
    both.joints.push(JointEntry {
        joint: Joint::Revolute { at: Point::ORIGIN },
        parts: (1, 0),
    });
    let assembly = Assembly::new(&both);
    let all = assembly.drawn(&Question::default());
    let states: Vec<_> = all.pairs.iter().map(|p| (p.parts, p.state)).collect();
    assert_eq!(all.beyond, 0);
    assert_eq!(states[0], ([1, 2], State::Clear));
    assert_eq!(states[5], ([0, 1], State::Joined));
    let near = assembly.drawn(&Question {
        within: 2.5,
        ..Question::default()
    });
    assert_eq!((near.pairs.len(), near.beyond), (3, 3));
    let loose = assembly.drawn(&Question {
        touch: Some(2.5),
        pair: Some([2, 1]),
        ..Question::default()
    });
    assert_eq!(loose.pairs[0].state, State::Touching);
    assert_eq!(loose.pairs[0].parts, [2, 1]);
}

#[test]
fn gaps_are_told_in_the_assembly_when_the_first_part_is_turned() {
    let parts = vec![
        square("a", (0.0, 0.0), (4.0, 2.0)),
        square("b", (0.0, 0.0), (1.0, 1.0)),
    ];
    let both = mechanism(parts);
    let sample = Sample {
        time: 0.0,
        parts: vec![[0.0, 0.0, 0.25 * TAU], [1.2, 0.0, 0.0]],
    };
    let found = Assembly::new(&both).along(&[sample], &Question::default());
    let [p, q] = found.pairs[0].points.unwrap();
    // The one is 1 to either side of x = 0, the other begins at 1.2 - 0.5.
    let is_there = (p.x - 1.0).abs() < 1e-9 && (q.x - 0.7).abs() < 1e-9;
    assert!(is_there && (p.y - q.y).abs() < 1e-9, "{p:?} {q:?}");
}

/// A square in a square hole is equally near on four sides, and a disc of two arcs is near where both end: whichever features are told, the
/// points lie on them.
#[test]
fn points_lie_on_the_features_that_are_told() {
    let frame = |x: f64, y: f64, half: f64| {
        let outline = |r: f64| [(-r, -r), (r, -r), (r, r), (-r, r)];
        let outline = |r: f64| outline(r).map(|(a, b)| Vertex::line(x + a, y + b)).to_vec();
        Part::new("frame", vec![outline(half + 2.0), outline(half)]).unwrap()
    };
    let pairs = [
        (
            frame(0.1, 0.3, 3.0),
            square("block", (0.1, 0.3), (2.0, 2.0)),
        ),
        (
            frame(0.0, 0.0, 1e-3),
            square("block", (0.0, 0.0), (1e-3, 1e-3)),
        ),
        (
            square("wall", (0.0, 0.0), (1.0, 9.0)),
            disc("post", 4.0, 3.0, 1.0),
        ),
        (
            square("wall", (0.0, 0.0), (1.0, 9.0)),
            square("block", (3.0, -1.0), (3.0, 3.0)),
        ),
    ];
    for (first, second) in pairs {
        let clash = two(first.clone(), second.clone());
        let told = clash
            .features
            .unwrap()
            .into_iter()
            .zip(clash.points.unwrap());
        for ((feature, point), part) in told.zip([&first, &second]) {
            let outline = &part.loops()[feature.loop_index as usize];
            let away = match feature.kind {
                FeatureKind::Vertex => {
                    let vertex = outline.vertices()[feature.index as usize];
                    Point::new(vertex.x, vertex.y).distance(point)
                }
                _ => outline
                    .edge(feature.index as usize)
                    .unwrap()
                    .distance(point),
            };
            assert!(away < 1e-9 * part.size(), "{feature} {point:?} {away}");
        }
    }
}
