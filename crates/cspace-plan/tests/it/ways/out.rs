//! Ways out, judged by the two parts alone.

use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, Silent, Vertex};
use cspace_plan::legs::Scene;
use cspace_plan::{Checked, Clearance, Path, PlanError, Planner, Verdict, Wishes, check};

fn part(name: &str, points: &[(f64, f64)]) -> Part {
    let loops = points.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new(name, vec![loops]).unwrap()
}

/// A plate with a slot that goes down, to the left and up.
fn plate() -> Part {
    part(
        "plate",
        &[
            (-30.0, -40.0),
            (30.0, -40.0),
            (30.0, 0.0),
            (3.0, 0.0),
            (3.0, -20.0),
            (9.0, -20.0),
            (9.0, -12.0),
            (15.0, -12.0),
            (15.0, -26.0),
            (-3.0, -26.0),
            (-3.0, 0.0),
            (-30.0, 0.0),
        ],
    )
}

/// The way out from a configuration, which is free, and ends where a line is between the parts.
fn way(fixed: &Part, moving: &Part, from: Configuration) -> Path {
    let space = PairSpace::compute(fixed, moving, Relation::Planar, &Options::default()).unwrap();
    let planner = Planner::new(&space).unwrap();
    let from = Coordinates::Planar(from);
    let (to, answer) = planner.plan_out(from, &Wishes::default(), &Silent).unwrap();
    let Verdict::Path(path) = answer.verdict else {
        panic!("it comes out: {:?}", answer.verdict)
    };
    assert_eq!(path.configurations.first(), Some(&from));
    let (Some(&Coordinates::Planar(last)), Coordinates::Planar(to)) =
        (path.configurations.last(), to)
    else {
        panic!("a planar path")
    };
    assert!((last.x, last.y) == (to.x, to.y));
    let scene = Scene::new(fixed, moving, None);
    let judged = check(&scene, &path.configurations).unwrap();
    assert!(matches!(judged, Checked::Free(_)), "{judged:?}");
    // A line is between them in one of many directions: of points of both, none is beyond it.
    let points = |part: &Part, at: Configuration| -> Vec<cspace::Point> {
        let edges = part.edges();
        edges
            .flat_map(|e| (0..=32).map(move |i| e.at(f64::from(i) / 32.0)))
            .map(|p| at.fixed_from_moving(p))
            .collect()
    };
    let still = points(fixed, Configuration::default());
    let moved = points(moving, last);
    let is_apart = (0..3600).any(|i| {
        let (sin, cos) = (f64::from(i) * 0.1).to_radians().sin_cos();
        let along = |p: &cspace::Point| p.x * cos + p.y * sin;
        let largest = still.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        let smallest = moved.iter().map(along).fold(f64::INFINITY, f64::min);
        smallest > largest
    });
    assert!(is_apart, "{last:?}");
    path
}

#[test]
fn a_key_comes_straight_out_of_its_slot_along_its_walls() {
    // The slot is turned by 0.3, and the key is drawn otherwise turned.
    let turn = |angle: f64, points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let (sin, cos) = angle.sin_cos();
        let turned = points
            .iter()
            .map(|&(x, y)| (x * cos - y * sin, x * sin + y * cos));
        turned.collect()
    };
    let slot = [
        (-9.0, -9.0),
        (9.0, -9.0),
        (9.0, 0.0),
        (3.05, 0.0),
        (3.05, -5.0),
        (-3.05, -5.0),
        (-3.05, 0.0),
        (-9.0, 0.0),
    ];
    let key = [(-3.0, -4.0), (3.0, -4.0), (3.0, 4.0), (-3.0, 4.0)];
    let (fixed, moving) = (
        part("slot", &turn(0.3, &slot)),
        part("key", &turn(-0.5, &key)),
    );
    let path = way(&fixed, &moving, Configuration::new(0.0, 0.0, 0.8));
    assert_eq!(path.configurations.len(), 2, "{path:?}");
    let (Coordinates::Planar(a), Coordinates::Planar(b)) =
        (path.configurations[0], path.configurations[1])
    else {
        panic!("a planar path")
    };
    // Along the walls: the direction of y turned by 0.3.
    let (x, y) = (b.x - a.x, b.y - a.y);
    assert!((x.atan2(y) + 0.3).abs() < 1e-9 && a.theta == b.theta);
}

#[test]
fn a_pin_comes_out_of_a_slot_with_corners() {
    let pin = Part::circle("pin", (0.0, 0.0), 2.5).unwrap();
    let path = way(&plate(), &pin, Configuration::new(12.0, -16.0, 0.0));
    assert!(path.narrowest.clearance > 0.2, "{path:?}");
}

#[test]
fn what_is_out_stays() {
    let pin = Part::circle("pin", (0.0, 0.0), 2.5).unwrap();
    let path = way(&plate(), &pin, Configuration::new(12.0, 26.0, 0.0));
    assert_eq!(path.configurations.first(), path.configurations.last());
}

#[test]
fn what_is_caged_is_told_to_be() {
    let pin = Part::circle("pin", (0.0, 0.0), 2.5).unwrap();
    // A pin too thick for the mouth.
    let mut mouth = plate().loops()[0].vertices().to_vec();
    for v in &mut mouth {
        if (v.x, v.y) == (3.0, 0.0) {
            v.x = 1.9;
        }
    }
    let fixed = Part::new("plate", vec![mouth]).unwrap();
    let space = PairSpace::compute(&fixed, &pin, Relation::Planar, &Options::default()).unwrap();
    let planner = Planner::new(&space).unwrap();
    let from = Coordinates::Planar(Configuration::new(12.0, -16.0, 0.0));
    let (_, answer) = planner.plan_out(from, &Wishes::default(), &Silent).unwrap();
    assert!(matches!(answer.verdict, Verdict::NoPath(_)), "{answer:?}");
}

#[test]
fn on_axes_nothing_is_out() {
    use cspace::{Axis, Point, Vector};
    let wheel = Part::circle("wheel", (0.0, 0.0), 1.0).unwrap();
    let slide = Part::rectangle("slide", (3.0, 0.0), 1.0, 1.0).unwrap();
    let relation = Relation::Axes {
        fixed: Axis::revolute(Point::new(0.0, 0.0)),
        moving: Axis::prismatic(Vector::new(1.0, 0.0)),
    };
    let space = PairSpace::compute(&wheel, &slide, relation, &Options::default()).unwrap();
    let planner = Planner::new(&space).unwrap();
    let from = Coordinates::Axes { u: 0.0, v: 0.0 };
    let error = planner.plan_out(from, &Wishes::default(), &Silent);
    assert_eq!(error.unwrap_err(), PlanError::NoGoal);
}

/// A bound on all paths out does not hold for those to one place beside the parts alone: a small pin in the middle of a wide slot
/// has less room where it is only just out.
#[test]
fn no_way_out_has_more_clearance_than_is_said() {
    let slot = part(
        "slot",
        &[
            (-20.0, -12.0),
            (20.0, -12.0),
            (20.0, 12.0),
            (10.0, 12.0),
            (10.0, -10.0),
            (-10.0, -10.0),
            (-10.0, 12.0),
            (-20.0, 12.0),
        ],
    );
    let pin = Part::circle("pin", (0.0, 0.0), 1.0).unwrap();
    let angle = part(
        "angle",
        &[
            (-1.0, -1.0),
            (3.0, -1.0),
            (3.0, 0.0),
            (0.0, 0.0),
            (0.0, 3.0),
            (-1.0, 3.0),
        ],
    );
    // The nearest place that is out is above the tray, at less than the part has on the way to it.
    let tray = part(
        "tray",
        &[
            (-30.0, -30.0),
            (30.0, -30.0),
            (30.0, 20.0),
            (12.0, 20.0),
            (12.0, 10.0),
            (20.0, 10.0),
            (20.0, -20.0),
            (-20.0, -20.0),
            (-20.0, 20.0),
            (-30.0, 20.0),
        ],
    );
    let bracket = part(
        "bracket",
        &[
            (-15.0, -15.0),
            (15.0, -15.0),
            (15.0, -11.0),
            (-11.0, -11.0),
            (-11.0, 15.0),
            (-15.0, 15.0),
        ],
    );
    let pairs = [
        (&slot, &pin, 9.0),
        (&slot, &angle, 7.0),
        (&tray, &bracket, 4.86),
    ];
    for (fixed, moving, clearance) in pairs {
        let space =
            PairSpace::compute(fixed, moving, Relation::Planar, &Options::default()).unwrap();
        let planner = Planner::new(&space).unwrap();
        let from = Coordinates::Planar(Configuration::new(0.0, 0.0, 0.0));
        let wishes = Wishes {
            clearance: Clearance::Widest,
            ..Wishes::default()
        };
        let (_, answer) = planner.plan_out(from, &wishes, &Silent).unwrap();
        let bottleneck = answer.bottleneck.unwrap();
        assert!(
            bottleneck.most.unwrap() > clearance * (1.0 - 1e-9),
            "{bottleneck:?}"
        );
        assert!(
            bottleneck.narrow.clearance > 0.999 * clearance,
            "{bottleneck:?}"
        );
        let Verdict::Path(path) = answer.verdict else {
            panic!("it comes out")
        };
        assert!(path.narrowest.clearance > 0.99 * clearance, "{path:?}");
    }
}
