//! Starts and goals in other numbers than the space's own, and far away.

use core::f64::consts::TAU;

use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, Options, PairSpace, Part, Point, Relation,
};
use cspace_oracle::shapes::{rounded_peg, slotted_block};
use cspace_plan::legs::Scene;
use cspace_plan::{Checked, PlanError, Planner, Verdict, Wishes, check};

fn space(window: Option<(f64, f64)>) -> PairSpace {
    let (block, peg) = (slotted_block(8.0, 1.01, 2.0, 0.1), rounded_peg(1.0, 2.0));
    let options = Options {
        window,
        ..Options::default()
    };
    PairSpace::compute(&block, &peg, Relation::Planar, &options).unwrap()
}

fn path(planner: &Planner<'_>, from: Configuration, to: Configuration) -> Vec<Configuration> {
    let [from, to] = [from, to].map(Coordinates::Planar);
    let answer = planner.plan(from, to, &Wishes::default()).unwrap();
    let Verdict::Path(path) = answer.verdict else {
        panic!("{answer:?}");
    };
    let checked = check(planner.scene(), &path.configurations).unwrap();
    assert!(matches!(checked, Checked::Free(_)), "{checked:?}");
    assert_eq!(path.configurations[0], from);
    (path.configurations.iter())
        .map(|c| match *c {
            Coordinates::Planar(c) => c,
            Coordinates::Axes { .. } => unreachable!("a planar pair"),
        })
        .collect()
}

#[test]
fn orientations_of_a_window_count_from_any_turn() {
    let space = space(Some((5.5, 7.0)));
    let planner = Planner::new(&space).unwrap();
    for from in [-TAU, 0.0, TAU] {
        for to in [0.3, TAU - 0.3, 0.1 - TAU] {
            let found = path(
                &planner,
                Configuration::new(-9.0, 9.0, from),
                Configuration::new(9.0, 9.0, to),
            );
            // It stays within the window, so the end is that many turns from the goal.
            let turns = (found.last().unwrap().theta - to) / TAU;
            assert!((turns - turns.round()).abs() < 1e-9);
            assert!(found.iter().all(|c| (c.theta - from).abs() < 0.8));
        }
    }
}

#[test]
fn from_far_away() {
    let space = space(None);
    let planner = Planner::new(&space).unwrap();
    let to = Configuration::new(9.0, 9.0, 0.1);
    for far in [1e3, 1e6, -1e9] {
        let from = Configuration::new(far, 0.3 * far, 2.0);
        path(&planner, from, to);
        path(&planner, to, from);
    }
    let scene = planner.scene();
    let ends = [1e300, 9.0].map(|x| Coordinates::Planar(Configuration::new(x, 9.0, 0.0)));
    let place = "a configuration of the path";
    assert_eq!(check(scene, &ends), Err(PlanError::TooFar { place }));
    let [from, to] = [Configuration::new(1e300, 0.0, 0.0), to].map(Coordinates::Planar);
    let none = planner.plan(from, to, &Wishes::default());
    assert_eq!(none, Err(PlanError::TooFar { place: "the start" }));
    let none = planner.plan(to, from, &Wishes::default());
    assert_eq!(none, Err(PlanError::TooFar { place: "the goal" }));
}

/// Between two intervals of the swept coordinate all may be blocked, and the way leads the other way around.
#[test]
fn a_lever_goes_around_what_blocks_it() {
    let lever = Part::rectangle("lever", (2.0, 0.0), 5.0, 0.5).unwrap();
    let block = Part::rectangle("block", (0.0, -3.0), 0.5, 1.0).unwrap();
    let relation = Relation::Axes {
        fixed: Axis {
            motion: AxisMotion::Fixed,
            range: None,
        },
        moving: Axis::revolute(Point::ORIGIN),
    };
    let space = PairSpace::compute(&block, &lever, relation, &Options::default()).unwrap();
    let planner = Planner::new(&space).unwrap();
    let at = |v| Coordinates::Axes { u: 0.0, v };
    for (from, to) in [(-0.3, 3.34), (3.34, -0.3), (-1.2, -1.9), (-1.9, -1.2 + TAU)] {
        let answer = planner.plan(at(from), at(to), &Wishes::default()).unwrap();
        let Verdict::Path(path) = answer.verdict else {
            panic!("{answer:?}");
        };
        let checked = check(planner.scene(), &path.configurations).unwrap();
        assert!(matches!(checked, Checked::Free(_)), "{checked:?}");
    }
}

/// A path that begins and ends a little beside contact is judged all along: a disc does not go through a peg.
#[test]
fn a_path_through_material_is_refused_from_beside_contact() {
    let circle = |x: f64, r: f64| Part::circle("circle", (x, 0.0), r).unwrap();
    let scene = Scene::new(&circle(15.0, 10.0), &circle(0.0, 30.0), None);
    let at = |x: f64, y: f64| Coordinates::Planar(Configuration::new(x, y, 0.0));
    let beside = (40.0_f64 * 40.0 - 15.0 * 15.0).sqrt();
    for above in [1e-3, 1e-7, 0.0] {
        let y = beside + above;
        for to in [30.0, 70.0, 1e5] {
            let checked = check(&scene, &[at(0.0, y), at(to, y)]).unwrap();
            assert!(
                !matches!(checked, Checked::Free(_)),
                "{above} {to} {checked:?}"
            );
        }
        let over = check(
            &scene,
            &[at(0.0, y), at(0.0, 41.0), at(30.0, 41.0), at(30.0, y)],
        );
        assert!(matches!(over.unwrap(), Checked::Free(_)), "{above}");
    }
}
