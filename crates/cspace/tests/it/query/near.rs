//! Near features, compared with the parts' distance, dense points and closed forms.

use cspace::{
    Axis, Configuration, Coordinates, Edge, FeatureKind, FeatureName, NearFeatures, Options,
    PairSpace, Part, Point, QueryError, Relation, Vector, Vertex,
};
use cspace_oracle::pair;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The edge of a feature, or the one that starts at its vertex, placed.
fn edge(part: &Part, name: FeatureName, at: Configuration) -> Edge {
    let mut edges = part.loops()[name.loop_index as usize].edges();
    let found = edges.find(|e| e.index == name.index as usize).unwrap();
    Edge {
        start: at.fixed_from_moving(found.start),
        end: at.fixed_from_moving(found.end),
        ..found
    }
}

/// Many points of a feature; one for a vertex.
fn points(part: &Part, name: FeatureName, at: Configuration) -> Vec<Point> {
    const COUNT: u32 = 200;
    if name.kind == FeatureKind::Vertex {
        let v = part.loops()[name.loop_index as usize].vertices()[name.index as usize];
        return vec![at.fixed_from_moving(Point::new(v.x, v.y))];
    }
    let edge = edge(part, name, at);
    let along = |i| edge.at(f64::from(i) / f64::from(COUNT));
    (0..=COUNT).map(along).collect()
}

/// Distance of a point from a feature.
fn off(part: &Part, name: FeatureName, at: Configuration, p: Point) -> f64 {
    if name.kind == FeatureKind::Vertex {
        return points(part, name, at)[0].distance(p);
    }
    edge(part, name, at).distance(p)
}

fn planar(fixed: &Part, moving: &Part) -> PairSpace {
    PairSpace::compute(fixed, moving, Relation::Planar, &Options::default()).unwrap()
}

fn names(near: &[NearFeatures]) -> Vec<String> {
    let name = |n: &NearFeatures| format!("{} {}", n.fixed.name, n.moving.name);
    near.iter().map(name).collect()
}

/// Places on parts that are apart lie on the features; distances are not below the clearance and not above those of dense points; and the
/// nearest equals the distance of the parts.
#[test]
fn distances_are_between_features() {
    let mut told = 0;
    for name in [
        "peg in chamfered hole",
        "ball caged in a C",
        "ratchet 8 and pawl",
        "random 5",
        "random rings",
        "half discs",
    ] {
        let p = pair(name);
        let (fixed, moving) = (&p.fixed, &p.moving);
        let space = planar(fixed, moving);
        let size = fixed.size().max(moving.size());
        let mut rng = ChaCha8Rng::seed_from_u64(8);
        let mut left = 20;
        while left > 0 {
            let mut on = || rng.random_range(-1.5..1.5) * size;
            let c = Configuration::new(on(), on(), rng.random_range(-3.0..3.0));
            let at = Coordinates::Planar(c);
            let Ok(clearance) = space.clearance(at) else {
                continue;
            };
            left -= 1;
            let near = space.near_features(at, 20.0 * size).unwrap();
            let first = near[0].distance;
            let slack = 1e-12 * size;
            assert!(
                (first - clearance).abs() <= slack,
                "{name} at {c:?}: {first} {clearance}"
            );
            told += near.len();
            for n in &near {
                let t = n.touching;
                let still = Configuration::default();
                assert!(
                    off(fixed, n.fixed.name, still, t.on_fixed) <= slack,
                    "{name} at {c:?}: {n:?}"
                );
                assert!(
                    off(moving, n.moving.name, c, t.on_moving) <= slack,
                    "{name} at {c:?}: {n:?}"
                );
                assert!((t.on_fixed.distance(t.on_moving) - n.distance).abs() <= slack);
                assert!(n.distance >= clearance - slack);
                let along = t.on_fixed + t.normal * n.distance;
                assert!(
                    along.distance(t.on_moving) <= slack,
                    "{name} at {c:?}: {n:?}"
                );
                // Both may curve away from each other and back; but points nearby are never nearer.
                let close = 0.01 * size;
                let around = |part, name, at, p: Point| {
                    let all = points(part, name, at).into_iter();
                    all.filter(|q| q.distance(p) < close)
                        .collect::<Vec<Point>>()
                };
                let of_moving = around(moving, n.moving.name, c, t.on_moving);
                for q in around(fixed, n.fixed.name, still, t.on_fixed) {
                    let nearer = of_moving
                        .iter()
                        .find(|r| r.distance(q) < n.distance - slack);
                    assert_eq!(nearer, None, "{name} at {c:?}: {n:?}");
                }
            }
        }
    }
    assert!(told > 200, "{told}");
}

/// Two triangles, one with a flat arc, whose nearest places are a vertex and a side; extensions of lines and circles are not reported.
#[test]
fn lines_and_circles_end_with_their_features() {
    let fixed = vec![
        Vertex::new(-44.366, 20.14, -0.037_522_192_156_308_816),
        Vertex::line(-51.606, 11.029),
        Vertex::line(-30.0, 5.0),
    ];
    let moving = [
        (-68.783_742, -2.494_091),
        (-60.061_866, -9.057_58),
        (-75.0, -15.0),
    ];
    let moving = moving.map(|(x, y)| Vertex::line(x, y)).to_vec();
    let space = planar(
        &Part::new("fixed", vec![fixed]).unwrap(),
        &Part::new("moving", vec![moving]).unwrap(),
    );
    let near = space
        .near_features(Coordinates::Planar(Configuration::default()), 30.0)
        .unwrap();
    assert!((near[0].distance - 21.134_199_1).abs() < 1e-6);
    assert!(near.iter().all(|n| n.distance >= near[0].distance));
}

/// Flush edges give both ends; concentric arcs give every arc; corner on corner gives both corners.
#[test]
fn places_that_are_not_alone() {
    let plate = Part::rectangle("plate", (0.0, 0.0), 4.0, 4.0).unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0).unwrap();
    let space = planar(&plate, &block);
    let near = |x, y, within| {
        let at = Coordinates::Planar(Configuration::new(x, y, 0.0));
        space.near_features(at, within).unwrap()
    };
    let beside = near(3.5, 0.5, 1.0);
    assert_eq!(
        names(&beside),
        [
            "line 1 of loop 0 vertex 0 of loop 0",
            "line 1 of loop 0 vertex 3 of loop 0"
        ]
    );
    assert!(beside.iter().all(|n| (n.distance - 0.5).abs() < 1e-12));
    let apart = near(6.0, 7.0, 5.0);
    assert_eq!(names(&apart), ["vertex 2 of loop 0 vertex 0 of loop 0"]);
    assert!((apart[0].distance - 5.0).abs() < 1e-12);
    let touching = names(&near(3.0, 3.0, space.resolution()));
    assert!(
        touching.contains(&"vertex 2 of loop 0 vertex 0 of loop 0".to_owned()),
        "{touching:?}"
    );
    // Half a unit into the plate, by its side.
    let deep = near(2.5, 0.0, 0.6);
    assert!(
        deep.iter().all(|n| (n.distance + 0.5).abs() < 1e-12) && deep.len() == 2,
        "{deep:?}"
    );

    let hole = Part::new(
        "hole",
        vec![
            vec![Vertex::new(-3.0, 0.0, 1.0), Vertex::new(3.0, 0.0, 1.0)],
            vec![Vertex::new(0.0, -2.0, 1.0), Vertex::new(0.0, 2.0, 1.0)],
        ],
    )
    .unwrap();
    let peg = Part::circle("peg", (0.1, 0.2), 1.5).unwrap();
    let space = planar(&hole, &peg);
    for theta in [0.0, 0.3, 2.0] {
        let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(Point::new(0.1, 0.2));
        let c = Configuration::new(-turned.x, -turned.y, theta);
        let near = space.near_features(Coordinates::Planar(c), 1.0).unwrap();
        assert!(!near.is_empty());
        for n in near {
            assert!((n.distance - 0.5).abs() < 1e-12, "{n:?}");
            assert!(
                (n.touching.on_fixed.to_vector().length() - 2.0).abs() < 1e-12,
                "{n:?}"
            );
        }
    }
}

/// Where a part overlaps both sides of a concave corner by less than the resolution, its corner is beyond the ends of both.
#[test]
fn a_part_in_a_corner_touches_both_sides() {
    let corner = [
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, -1.0),
        (-1.0, -1.0),
        (-1.0, 4.0),
        (0.0, 4.0),
    ];
    let corner = corner.map(|(x, y)| Vertex::line(x, y)).to_vec();
    let corner = Part::new("corner", vec![corner]).unwrap();
    let block = Part::rectangle("block", (1.0, 1.0), 2.0, 2.0).unwrap();
    let space = planar(&corner, &block);
    let off = 0.5 * space.resolution();
    for (x, y) in [(0.0, 0.0), (off, -off), (-off, off), (-off, -off)] {
        let at = Coordinates::Planar(Configuration::new(x, y, 0.0));
        assert_eq!(
            space.classify(at).unwrap(),
            cspace::Classification::Contact,
            "{x} {y}"
        );
        let near = space.near_features(at, space.resolution()).unwrap();
        let mut of_fixed: Vec<String> = near.iter().map(|n| n.fixed.name.to_string()).collect();
        of_fixed.sort();
        of_fixed.dedup();
        assert_eq!(
            of_fixed,
            ["line 0 of loop 0", "line 5 of loop 0"],
            "{x} {y}: {near:?}"
        );
        assert_eq!(near.len(), 4, "{x} {y}: {near:?}");
    }
}

/// On fixed axes distances are lengths, also where a part turns.
#[test]
fn lengths_are_no_angles() {
    let arm = Part::circle("arm", (10.0, 0.0), 1.0).unwrap();
    let stop = Part::circle("stop", (0.0, 10.0), 1.0).unwrap();
    let relation = Relation::Axes {
        fixed: Axis::FIXED,
        moving: Axis::revolute(Point::new(0.0, 0.0)),
    };
    let space = PairSpace::compute(&stop, &arm, relation, &Options::default()).unwrap();
    // The centres are a chord of 2 · 10 sin(0.2) apart.
    let v = core::f64::consts::FRAC_PI_2 - 0.4;
    let at = Coordinates::Axes { u: 0.0, v };
    let apart = 20.0 * 0.2_f64.sin() - 2.0;
    assert!((space.clearance(at).unwrap() - apart).abs() < 1e-12);
    assert_eq!(space.near_features(at, apart - 1e-6).unwrap(), []);
    let near = space.near_features(at, apart + 1e-6).unwrap();
    assert!((near[0].distance - apart).abs() < 1e-12, "{near:?}");
    let slide = Relation::Axes {
        fixed: Axis::FIXED,
        moving: Axis::prismatic(Vector::new(1.0, 0.0)),
    };
    let space = PairSpace::compute(&stop, &arm, slide, &Options::default()).unwrap();
    let wrong = Coordinates::Planar(Configuration::default());
    assert!(matches!(
        space.near_features(wrong, 1.0),
        Err(QueryError::Coordinates { .. })
    ));
}
