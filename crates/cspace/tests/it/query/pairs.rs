//! Queries to a pair of any class, with answers that are distances of circles.

use cspace::pair::PairMotion;
use cspace::{
    AxesError, Axis, Classification, ComputeError, Configuration, Coordinates, MotionError,
    Options, PairClass, PairError, PairSpace, Part, PatchId, Point, QueryError, Relation, Vector,
    Vertex,
};

/// Radii of the fixed and of the moving disc, and the distance of their centres in contact.
const RADII: (f64, f64) = (2.0, 1.0);
const TOUCHING: f64 = RADII.0 + RADII.1;
/// Accuracy of distances, determined by growth, as a share of the size.
const NEAR: f64 = 1e-10;

fn disc(name: &str, radius: f64, x: f64) -> Part {
    let ends = [x - radius, x + radius].map(|x| Vertex::new(x, 0.0, 1.0));
    Part::new(name, vec![ends.to_vec()]).unwrap()
}

fn planar(window: Option<(f64, f64)>) -> PairSpace {
    let options = Options {
        window,
        ..Options::default()
    };
    let (a, b) = (disc("a", RADII.0, 0.0), disc("b", RADII.1, 0.0));
    PairSpace::compute(&a, &b, Relation::Planar, &options).unwrap()
}

/// The first disc turns about its own centre; the second slides through it from a distance of five to the right.
fn sliding() -> PairSpace {
    let (a, b) = (disc("a", RADII.0, 0.0), disc("b", RADII.1, 5.0));
    let relation = Relation::Axes {
        fixed: Axis::revolute(Point::ORIGIN),
        moving: Axis::prismatic(Vector::new(2.0, 0.0)),
    };
    PairSpace::compute(&a, &b, relation, &Options::default()).unwrap()
}

fn at(x: f64, y: f64, theta: f64) -> Coordinates {
    Coordinates::Planar(Configuration::new(x, y, theta))
}

const fn axes(u: f64, v: f64) -> Coordinates {
    Coordinates::Axes { u, v }
}

fn is_near(a: Coordinates, b: Coordinates) -> bool {
    match (a, b) {
        (Coordinates::Planar(a), Coordinates::Planar(b)) => {
            a.position().distance(b.position()) < NEAR && (a.theta - b.theta).abs() < NEAR
        }
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: s, v: t }) => {
            (u - s).abs() < NEAR && (v - t).abs() < NEAR
        }
        _ => false,
    }
}

#[test]
fn discs_in_the_plane_touch_at_the_sum_of_their_radii() {
    let space = planar(None);
    for k in 0..12 {
        let (bearing, theta) = (0.1 + 0.5 * f64::from(k), -3.0 + 0.5 * f64::from(k));
        let out = |r: f64| at(r * bearing.cos(), r * bearing.sin(), theta);
        assert_eq!(space.classify(out(3.1)).unwrap(), Classification::Free);
        assert_eq!(space.classify(out(2.9)).unwrap(), Classification::Blocked);
        let nearest = space.nearest_contact(out(5.0)).unwrap().unwrap();
        assert!((nearest.distance - (5.0 - TOUCHING)).abs() < NEAR);
        assert!(is_near(nearest.at, out(TOUCHING)));
        let contacts = space.contacts(out(TOUCHING), NEAR).unwrap();
        assert!(contacts.iter().any(|c| c.0 == nearest.patch) && contacts[0].1 < NEAR);
        assert!(space.contacts(out(3.1), NEAR).unwrap().is_empty());
    }
}

#[test]
fn a_disc_that_moves_in_the_plane_touches_when_it_has_come_so_far() {
    let space = planar(Some((-1.0, 1.0)));
    let from = at(5.0, 0.0, 0.25);
    let met = space
        .first_contact(from, at(-0.5, 0.0, 0.125), 10.0)
        .unwrap();
    let PairMotion::Contact(contact) = met else {
        panic!("{met:?}")
    };
    // Two lengths at half a length per unit of time.
    assert!((contact.time - 4.0).abs() < NEAR);
    assert!(is_near(contact.at, at(TOUCHING, 0.0, 0.75)));
    let contacts = space.contacts(contact.at, NEAR).unwrap();
    assert!(contacts.iter().any(|c| c.0 == contact.patch));
    let away = space
        .first_contact(from, at(0.5, 0.0, 0.0625), 10.0)
        .unwrap();
    assert!(matches!(away, PairMotion::Free));
    let leaves = space
        .first_contact(from, at(0.5, 0.0, 0.125), 10.0)
        .unwrap();
    assert!(matches!(leaves, PairMotion::Leaves { time } if (time - 6.0).abs() < NEAR));
    let inside = space.first_contact(at(1.0, 0.0, 0.0), at(0.5, 0.0, 0.0), 1.0);
    assert_eq!(inside, Err(QueryError::Motion(MotionError::StartsBlocked)));
    assert_eq!(space.classify(at(5.0, 0.0, 2.0)), Err(QueryError::Outside));
}

#[test]
fn a_disc_that_slides_touches_where_its_centre_is_so_far() {
    let space = sliding();
    for u in [-2.0, 0.0, 0.4, 3.0] {
        // Its centre is at 5 + v.
        for (v, class) in [
            (0.0, Classification::Free),
            (-1.9, Classification::Free),
            (-2.1, Classification::Blocked),
            (-7.9, Classification::Blocked),
            (-8.1, Classification::Free),
        ] {
            assert_eq!(space.classify(axes(u, v)).unwrap(), class, "{u} {v}");
        }
        for (v, touching) in [(0.0, -2.0), (-9.5, -8.0)] {
            let nearest = space.nearest_contact(axes(u, v)).unwrap().unwrap();
            assert!((nearest.distance - (v - touching).abs()).abs() < NEAR);
            assert!(is_near(nearest.at, axes(u, touching)));
            let contacts = space.contacts(nearest.at, NEAR).unwrap();
            assert!(contacts.iter().any(|c| c.0 == nearest.patch));
        }
        assert!(space.contacts(axes(u, 0.0), NEAR).unwrap().is_empty());
        let met = space
            .first_contact(axes(u, 0.0), axes(0.25, -0.5), 10.0)
            .unwrap();
        let PairMotion::Contact(contact) = met else {
            panic!("{met:?}")
        };
        assert!((contact.time - 4.0).abs() < NEAR);
        assert!(is_near(contact.at, axes(u + 1.0, -2.0)));
    }
    let nan = space.first_contact(axes(0.0, 0.0), axes(f64::NAN, 0.0), 1.0);
    assert_eq!(nan, Err(QueryError::Motion(MotionError::NotFinite)));
    let back = space.first_contact(axes(0.0, 0.0), axes(1.0, 0.0), -1.0);
    assert_eq!(back, Err(QueryError::Motion(MotionError::NotFinite)));
}

#[test]
fn coordinates_of_another_class_are_refused() {
    let (plane, slide) = (planar(None), sliding());
    for (space, wrong, right) in [
        (&plane, axes(0.0, 0.0), at(5.0, 0.0, 0.0)),
        (&slide, at(5.0, 0.0, 0.0), axes(0.0, 0.0)),
    ] {
        let error = QueryError::Coordinates {
            class: space.class(),
            wanted: right.names(),
            given: wrong.names(),
        };
        assert_eq!(space.classify(wrong), Err(error));
        assert_eq!(space.contacts(wrong, 1.0), Err(error));
        assert_eq!(space.nearest_contact(wrong), Err(error));
        assert_eq!(space.first_contact(wrong, right, 1.0), Err(error));
        assert_eq!(space.first_contact(right, wrong, 1.0), Err(error));
    }
    assert_eq!(slide.class(), PairClass::FixedAxes);
    assert_eq!((slide.fixed().name(), slide.moving().name()), ("a", "b"));
    assert_eq!((plane.fixed().name(), plane.moving().name()), ("a", "b"));
}

/// If one patch comes after another, the other comes before it; and likewise above and below; links agree.
#[test]
fn neighbours_are_mutual() {
    for space in [planar(None), planar(Some((-1.0, 1.0))), sliding()] {
        let count = space.patch_count() as u32;
        let all: Vec<_> = (0..count)
            .map(|i| space.neighbours(PatchId(i)).unwrap())
            .collect();
        let mut links = 0;
        for (i, n) in (0..).map(PatchId).zip(&all) {
            for (mine, theirs) in [(&n.after, 0), (&n.before, 1), (&n.above, 2), (&n.below, 3)] {
                assert!(mine.is_sorted_by(|a, b| a < b));
                for &j in mine {
                    let other = &all[j.index()];
                    let back = [&other.before, &other.after, &other.below, &other.above];
                    assert!(back[theirs].contains(&i), "{i} {j}");
                }
            }
            links += n.after.len() + n.above.len();
        }
        assert!(links >= count as usize / 2, "{links}");
        if let PairSpace::Planar(space) = &space {
            for l in space.side_links() {
                assert!(all[l.before.index()].after.contains(&l.after));
            }
            for l in space.vertical_links() {
                assert!(all[l.lower.index()].above.contains(&l.upper));
            }
        }
        let beyond = QueryError::NoPatch {
            patch: PatchId(count),
            last: PatchId(count - 1),
        };
        assert_eq!(space.neighbours(PatchId(count)), Err(beyond));
    }
}

#[test]
fn axes_that_are_none_are_refused() {
    let (a, b) = (disc("a", RADII.0, 0.0), disc("b", RADII.1, 5.0));
    let refused = |moving: Axis| {
        let relation = Relation::Axes {
            fixed: Axis::revolute(Point::ORIGIN),
            moving,
        };
        match PairSpace::compute(&a, &b, relation, &Options::default()) {
            Err(PairError::Axes(error)) => error,
            other => panic!("{other:?}"),
        }
    };
    let turning = Axis::revolute(Point::ORIGIN);
    for axis in [
        turning.within(f64::NAN, 1.0),
        turning.within(0.0, f64::INFINITY),
        Axis::revolute(Point::new(f64::NAN, 0.0)),
        Axis::prismatic(Vector::new(0.0, f64::INFINITY)),
    ] {
        assert!(
            matches!(refused(axis), AxesError::NotFinite { .. }),
            "{axis:?}"
        );
    }
    // A turn is 6.28…
    let many = refused(turning.within(0.0, 6284.0));
    assert!(
        matches!(many, AxesError::TooManyTurns { turns, .. } if (1000.0..1001.0).contains(&turns))
    );
    let none = refused(Axis::prismatic(Vector::ZERO));
    assert!(matches!(none, AxesError::NoDirection { .. }));
    assert!(matches!(
        refused(turning.within(1.0, 1.0)),
        AxesError::EmptyRange { .. }
    ));
}

/// Slides that meet a thousand million sizes away are rejected, unless a range ends them or they are parallel.
#[test]
fn slides_that_are_all_but_parallel_are_refused() {
    let (a, b) = (disc("a", RADII.0, 0.0), disc("b", RADII.1, 5.0));
    let compute = |fixed: Axis, angle: f64| {
        let moving = Axis::prismatic(Vector::from_angle(0.3 + angle));
        let relation = Relation::Axes { fixed, moving };
        PairSpace::compute(&a, &b, relation, &Options::default())
    };
    let slide = Axis::prismatic(Vector::from_angle(0.3));
    for angle in [1e-9, -1e-7, core::f64::consts::PI + 1e-9] {
        let refused = compute(slide, angle);
        assert!(
            matches!(
                refused,
                Err(PairError::Axes(AxesError::NearlyParallel { .. }))
            ),
            "{angle}"
        );
        assert!(compute(slide.within(-9.0, 9.0), angle).is_ok());
    }
    assert!(compute(slide, 0.0).is_ok() && compute(slide, 1e-5).is_ok());
}

#[test]
fn windows_that_are_none_are_refused() {
    let (a, b) = (disc("a", RADII.0, 0.0), disc("b", RADII.1, 0.0));
    for (lo, hi) in [
        (1.0, 1.0),
        (1.0, 0.5),
        (f64::NAN, 1.0),
        (0.0, 100.0),
        (2e6, 2e6 + 1.0),
    ] {
        let options = Options {
            window: Some((lo, hi)),
            ..Options::default()
        };
        let made = PairSpace::compute(&a, &b, Relation::Planar, &options);
        assert!(
            matches!(made, Err(PairError::Compute(ComputeError::Window { .. }))),
            "{lo} {hi}"
        );
    }
}
