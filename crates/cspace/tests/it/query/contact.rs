//! Contact functions of drawn features, compared with those of spaces, with differences, and with the parts.

use std::sync::LazyLock;

use cspace::pair::PairMotion;
use cspace::{
    Axis, Configuration, Coordinates, FeatureContact, Location, Options, PairSpace, Part, Point,
    QueryError, Relation, SmoothMotion, SmoothOutcome, Vector, Vertex,
};
use cspace_oracle::shapes::mechanisms::mechanisms;
use cspace_oracle::{Oracle, effort, pairs};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Named = (String, PairSpace);

fn planar() -> &'static [Named] {
    static ALL: LazyLock<Vec<Named>> = LazyLock::new(|| {
        let small =
            |p: &cspace_oracle::Pair| p.fixed.edges().count() * p.moving.edges().count() < 3000;
        (pairs().into_iter().filter(small))
            .map(|p| {
                let options = Options::default();
                let space = PairSpace::compute(&p.fixed, &p.moving, Relation::Planar, &options);
                (p.name, space.unwrap())
            })
            .collect()
    });
    &ALL
}

fn on_axes() -> &'static [Named] {
    static ALL: LazyLock<Vec<Named>> = LazyLock::new(|| {
        (mechanisms().into_iter())
            .map(|m| {
                let relation = Relation::Axes {
                    fixed: m.fixed_axis,
                    moving: m.moving_axis,
                };
                let space = PairSpace::compute(&m.fixed, &m.moving, relation, &Options::default());
                (m.name, space.unwrap())
            })
            .collect()
    });
    &ALL
}

fn size(space: &PairSpace) -> f64 {
    space.fixed().size().max(space.moving().size())
}

/// Largest distance of a part from its origin: it determines the effect of the orientation, and of rounding.
fn lever(space: &PairSpace) -> f64 {
    let reach = |part: &Part| {
        let ends = part.edges().map(|e| e.start.to_vector().length());
        ends.fold(part.size(), f64::max)
    };
    reach(space.fixed()).max(reach(space.moving()))
}

/// Configurations on a patch and beside it, at which one of its functions is evaluated.
fn beside(space: &PairSpace, rng: &mut ChaCha8Rng) -> Vec<(FeatureContact, Coordinates)> {
    let mut all = Vec::new();
    for patch in space.patches().step_by(1 + space.patch_count() / 40) {
        let (lo, hi) = patch.orientations().unwrap();
        let theta = rng.random_range(lo..=hi);
        let Ok([(Coordinates::Planar(a), _), (Coordinates::Planar(b), _)]) = patch.ends_at(theta)
        else {
            continue;
        };
        let middle = a.position().midpoint(b.position());
        let off = || Configuration::new(middle.x, middle.y, theta);
        all.push((patch.contact().unwrap(), Coordinates::Planar(off())));
    }
    all
}

/// The function of the drawing equals that of the space, except for growth.
#[test]
fn values_and_gradients_are_those_of_spaces() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut asked = 0;
    for (name, space) in planar().iter().step_by(effort(2, 1)) {
        let PairSpace::Planar(inner) = &space else {
            panic!("{name}");
        };
        let near = 1e-9 * size(space) + 2.0 * space.resolution() + 1e-13 * lever(space);
        for patch in space.patches().step_by(1 + space.patch_count() / 60) {
            let contact = patch.contact().unwrap();
            let of_space = inner.patch(patch.id()).unwrap();
            let (lo, hi) = patch.orientations().unwrap();
            let theta = rng.random_range(lo..=hi);
            let c = of_space.left().at(theta);
            let c = Configuration::new(c.x + 0.01 * size(space), c.y, theta);
            let f = contact.evaluate(Coordinates::Planar(c)).unwrap();
            let value = of_space.contact_function(c);
            assert!(
                (f.value - value).abs() < near,
                "{name}: {} {value}",
                f.value
            );
            // For circles that almost coincide the direction of the normal is less accurate.
            let radius = f.hessian[0][0] + f.hessian[1][1];
            let known = 1e-8 + near * (1.0 + radius.abs());
            let gradient = of_space.gradient(c);
            for (i, g) in gradient.iter().enumerate() {
                let scale = if i == 2 { lever(space) } else { 1.0 };
                assert!(
                    (f.gradient[i] - g).abs() < known * scale,
                    "{name} {i}: {f:?} {gradient:?}"
                );
            }
            asked += 1;
        }
    }
    assert!(asked > 500, "{asked}");
    for (name, space) in on_axes() {
        let PairSpace::FixedAxes(inner) = &space else {
            panic!("{name}");
        };
        for patch in space.patches().step_by(1 + space.patch_count() / 60) {
            let branch = inner.patches()[patch.id().index()].branches.start as usize;
            let (u, v) = inner.branches()[branch].start;
            let at = Coordinates::Axes { u, v };
            let f = patch.contact().unwrap().evaluate(at).unwrap();
            assert!(f.value.abs() < 1e-7 * size(space), "{name}: {}", f.value);
            let (by_u, by_v) = inner.contact_gradient(patch.id(), u, v).unwrap();
            // Functions of one contact differ by a factor: their gradients have one direction.
            let cross = f.gradient[0] * by_v - f.gradient[1] * by_u;
            let lengths = f.gradient[0].hypot(f.gradient[1]) * by_u.hypot(by_v);
            let dot = f.gradient[0] * by_u + f.gradient[1] * by_v;
            assert!(
                cross.abs() <= 1e-6 * lengths + 1e-9,
                "{name}: {cross} {lengths}"
            );
            assert!(dot >= -1e-9, "{name}");
        }
    }
}

/// Gradients and Hessians compared with differences, for both classes.
#[test]
fn derivatives_agree_with_differences() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for (name, space) in planar().iter().step_by(effort(2, 1)) {
        let size = size(space);
        if lever(space) > 100.0 * size {
            // Differences are lost in rounding.
            continue;
        }
        for (contact, at) in beside(space, &mut rng) {
            let Coordinates::Planar(c) = at else { panic!() };
            let by = |i: usize, h: f64| {
                let mut k = [c.x, c.y, c.theta];
                k[i] += h;
                let at = Coordinates::Planar(Configuration::new(k[0], k[1], k[2]));
                contact.evaluate(at).unwrap()
            };
            let f = contact.evaluate(at).unwrap();
            for i in 0..3 {
                let h = if i == 2 { 1e-6 } else { 1e-6 * size };
                let (lo, hi) = (by(i, -h), by(i, h));
                // Near the centre of a small circle differences are inaccurate.
                if f.hessian[0][0].abs() + f.hessian[1][1].abs() > 100.0 / size {
                    continue;
                }
                let slope = (hi.value - lo.value) / (2.0 * h);
                let scale = if i == 2 { size } else { 1.0 };
                assert!(
                    (slope - f.gradient[i]).abs() < 1e-4 * scale,
                    "{name} {i}: {slope} {f:?}"
                );
                for j in 0..3 {
                    let bend = (hi.gradient[j] - lo.gradient[j]) / (2.0 * h);
                    let scale = [1.0 / size, 1.0, size][usize::from(i == 2) + usize::from(j == 2)];
                    let off = (bend - f.hessian[i][j]).abs();
                    assert!(off < 1e-2 * scale, "{name} {i} {j}: {bend} {f:?}");
                }
            }
        }
    }
}

/// A vertex of a part moved, or a bulge changed, changes the function as its derivative says.
#[test]
fn derivatives_by_the_drawing_agree_with_other_drawings() {
    let loops = vec![vec![
        Vertex::new(0.0, 0.0, 0.2),
        Vertex::new(0.3, 2.0, 0.0),
        Vertex::new(2.5, 1.5, -0.15),
        Vertex::new(2.0, -0.5, 0.6),
    ]];
    let fixed = Part::new("fixed", loops.clone()).unwrap();
    assert!(fixed.loops()[0].is_reversed());
    let moving = Part::new(
        "moving",
        vec![vec![
            Vertex::new(-0.4, 0.0, 1.0),
            Vertex::new(0.4, 0.1, 0.0),
            Vertex::new(0.0, 0.9, 0.05),
        ]],
    )
    .unwrap();
    let axes = |c: Point, d: Vector| Relation::Axes {
        fixed: Axis::revolute(c),
        moving: Axis::prismatic(d),
    };
    let (center, direction) = (Point::new(0.7, 0.4), Vector::new(1.0, 2.0));
    for (relation, at) in [
        (
            Relation::Planar,
            Coordinates::Planar(Configuration::new(3.0, 1.0, 0.4)),
        ),
        (
            axes(center, direction),
            Coordinates::Axes { u: 0.3, v: 2.0 },
        ),
    ] {
        let compute = |fixed: &Part, relation| {
            PairSpace::compute(fixed, &moving, relation, &Options::default()).unwrap()
        };
        let space = compute(&fixed, relation);
        let mut asked = 0;
        for patch in space.patches() {
            let contact = patch.contact().unwrap();
            let by = contact.by_drawing(at).unwrap();
            let (feature, _) = patch.features().unwrap();
            let h = 1e-6;
            for v in &by.fixed {
                for (number, expected) in [v.by_position[0], v.by_position[1], v.by_bulge]
                    .into_iter()
                    .enumerate()
                {
                    let moved = |h: f64| {
                        let mut loops = loops.clone();
                        let vertex = &mut loops[0][v.vertex as usize];
                        match number {
                            0 => vertex.x += h,
                            1 => vertex.y += h,
                            _ => vertex.bulge += h,
                        }
                        let part = Part::new("fixed", loops).unwrap();
                        let mut contact = contact;
                        contact.fixed = part.feature_shape(feature.name).unwrap();
                        contact.value(at).unwrap()
                    };
                    // A line that bulges is an arc: a feature with another name, but the same number.
                    let slope = (moved(h) - moved(-h)) / (2.0 * h);
                    assert!(
                        (slope - expected).abs() < 1e-6,
                        "{feature:?} {number}: {slope} {expected}"
                    );
                    asked += 1;
                }
            }
            if let Relation::Axes { .. } = relation {
                let with = |h: f64| {
                    let space = compute(&fixed, axes(center + Vector::new(h, 0.0), direction));
                    let same = (space.patches()).find(|p| p.features() == patch.features());
                    same.map(|p| p.contact().unwrap().value(at).unwrap())
                };
                if let (Some(lo), Some(hi)) = (with(-1e-5), with(1e-5)) {
                    let slope = (hi - lo) / 2e-5;
                    assert!((slope - by.fixed_axis[0]).abs() < 1e-5, "{slope} {by:?}");
                }
            } else {
                assert_eq!((by.fixed_axis, by.moving_axis), ([0.0; 2], [0.0; 2]));
            }
        }
        assert!(asked > 50, "{asked}");
    }
}

/// Touching points coincide on a patch, on the boundary of both parts, with the normal of the fixed one.
#[test]
fn touching_points_are_on_both_parts() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for (name, space) in planar().iter().step_by(effort(2, 1)) {
        let size = size(space);
        for patch in space.patches().step_by(1 + space.patch_count() / 40) {
            let (lo, hi) = patch.orientations().unwrap();
            let theta = rng.random_range(lo..=hi);
            let Ok([(a, _), _]) = patch.ends_at(theta) else {
                continue;
            };
            let t = patch.contact().unwrap().touching(a).unwrap();
            let near = 1e-6 * size;
            assert!(t.on_fixed.distance(t.on_moving) < near, "{name}: {t:?}");
            let Coordinates::Planar(c) = a else { panic!() };
            let on_moving = c.inverse().fixed_from_moving(t.on_fixed);
            for (part, p) in [(space.fixed(), t.on_fixed), (space.moving(), on_moving)] {
                let off = (part.edges())
                    .map(|e| distance(&e, p))
                    .fold(f64::INFINITY, f64::min);
                assert!(off < near, "{name}: {off} {t:?}");
            }
            assert!((t.normal.length() - 1.0).abs() < 1e-9);
        }
    }
}

/// Distance of a point and an edge, from many points of the edge and their neighbours.
fn distance(e: &cspace::Edge, p: Point) -> f64 {
    let on = |s: f64| {
        if e.is_line() {
            return e.start.lerp(e.end, s);
        }
        let c = e.center();
        c + cspace::Rotation::by(e.sweep() * s) * (e.start - c)
    };
    let (mut lo, mut hi) = (0.0, 1.0);
    for _ in 0..9 {
        let at = |k: i32| lo + (hi - lo) * f64::from(k) / 100.0;
        let best =
            (0..=100).min_by(|&a, &b| on(at(a)).distance(p).total_cmp(&on(at(b)).distance(p)));
        let k = best.unwrap();
        (lo, hi) = (at((k - 1).max(0)), at((k + 1).min(100)));
    }
    on(0.5 * (lo + hi)).distance(p)
}

/// Locations agree with the overlap of the parts, and clearances with their distance.
#[test]
fn places_and_clearances_are_those_of_the_parts() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let mut free = 0;
    for (name, space) in planar().iter().take(20) {
        let oracle = Oracle::new(space.fixed(), space.moving());
        for _ in 0..30 {
            let far = size(space);
            let c = Configuration::new(
                rng.random_range(-far..far),
                rng.random_range(-far..far),
                rng.random_range(-3.0..3.0),
            );
            let at = Coordinates::Planar(c);
            let verdict = oracle.judge(c);
            match space.locate(at).unwrap() {
                Location::Free(_) => {
                    free += 1;
                    let clearance = space.clearance(at).unwrap();
                    assert!(
                        (clearance - verdict.margin).abs() < 1e-9 * far,
                        "{name} {c:?}: {clearance} {verdict:?}"
                    );
                }
                Location::Blocked => assert_eq!(space.clearance(at), Err(QueryError::Blocked)),
                other => assert_eq!(other, Location::Contact),
            }
        }
    }
    assert!(free > 100, "{free}");
}

struct Straight {
    from: [f64; 3],
    rates: [f64; 3],
    planar: bool,
}

impl SmoothMotion for Straight {
    fn at(&self, t: f64) -> Coordinates {
        let [a, b, c] = core::array::from_fn(|i| self.from[i] + t * self.rates[i]);
        if self.planar {
            Coordinates::Planar(Configuration::new(a, b, c))
        } else {
            Coordinates::Axes { u: a, v: b }
        }
    }
    fn rate_bounds(&self, _: f64, _: f64) -> [f64; 3] {
        self.rates.map(f64::abs)
    }
}

/// A straight motion given as a smooth one touches at the time of the exact search.
#[test]
fn smooth_motions_touch_when_straight_ones_do() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut touched = 0;
    for (name, space) in planar().iter().take(12).chain(on_axes()) {
        let is_planar = matches!(space, PairSpace::Planar(_));
        let far = size(space);
        for _ in 0..12 {
            let way: f64 = rng.random_range(-3.0..3.0);
            let motion = if is_planar {
                Straight {
                    from: [2.5 * far * way.cos(), 2.5 * far * way.sin(), way],
                    rates: [
                        -far * way.cos(),
                        -far * way.sin(),
                        rng.random_range(-1.0..1.0),
                    ],
                    planar: true,
                }
            } else {
                let mut number = || rng.random_range(-1.0..1.0);
                Straight {
                    from: [number(), number(), 0.0],
                    rates: [number(), number(), 0.0],
                    planar: false,
                }
            };
            let rates = Straight {
                from: motion.rates,
                rates: [0.0; 3],
                planar: is_planar,
            }
            .at(0.0);
            let Ok(exact) = space.first_contact(motion.at(0.0), rates, 4.0) else {
                continue;
            };
            let near = 1e-8 * far;
            let smooth = space.first_contact_along(&motion, 4.0, near).unwrap();
            match (exact, smooth) {
                (PairMotion::Contact(c), SmoothOutcome::Contact { time, .. }) => {
                    // Never later; earlier where the motion grazes.
                    assert!(time <= c.time + 1e-9, "{name}: {} {time}", c.time);
                    touched += 1;
                    let still = space.clearance(motion.at(time)).unwrap_or_default();
                    assert!(still <= near, "{name}: {still}");
                }
                (PairMotion::Free, SmoothOutcome::Free)
                | (PairMotion::Leaves { .. }, SmoothOutcome::Leaves { .. }) => {}
                // The motion passes a contact more closely than the tolerance.
                (_, SmoothOutcome::Contact { time, .. }) => {
                    assert!(space.clearance(motion.at(time)).unwrap() <= near, "{name}");
                }
                other => panic!("{name}: {other:?}"),
            }
        }
    }
    assert!(touched > 30, "{touched}");
}

/// Between crossings a motion is free or blocked according to their directions.
#[test]
fn crossings_are_where_free_space_ends_and_begins() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let (mut crossed, mut asked) = (0, 0);
    for (name, space) in planar().iter().take(16).chain(on_axes()) {
        let is_planar = matches!(space, PairSpace::Planar(_));
        let far = size(space);
        for _ in 0..10 {
            let mut number = |scale: f64| rng.random_range(-scale..scale);
            let [from, rates] = if is_planar {
                [
                    [number(2.0 * far), number(2.0 * far), number(3.0)],
                    [number(far), number(far), number(1.0)],
                ]
            } else {
                [
                    [number(1.0), number(1.0), 0.0],
                    [number(1.0), number(1.0), 0.0],
                ]
            };
            let motion = Straight {
                from,
                rates,
                planar: is_planar,
            };
            let by = Straight {
                from: rates,
                rates: [0.0; 3],
                planar: is_planar,
            }
            .at(0.0);
            let Ok(found) = space.crossings(motion.at(0.0), by, 3.0) else {
                continue;
            };
            crossed += found.len();
            for pair in found.windows(2) {
                let (a, b) = (pair[0], pair[1]);
                if b.time - a.time < 1e-6 {
                    continue;
                }
                let place = space.locate(motion.at(0.5 * (a.time + b.time))).unwrap();
                let blocked = place == Location::Blocked;
                assert_eq!(a.enters, blocked, "{name}: {a:?} {b:?} {place:?}");
                asked += 1;
            }
        }
    }
    assert!(crossed > 100 && asked > 50, "{crossed} {asked}");
}
