//! Parts that just pass and parts that just do not, by formulas.

use core::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, Vector, Vertex};
use cspace_oracle::{Oracle, effort};
use cspace_plan::legs::Scene;
use cspace_plan::{Answer, Clearance, Planner, Verdict, Wishes};

use crate::ways::judge::{is_free, places};

/// Just below and just above, relative.
const CLOSE: [f64; 2] = [1e-6, 1e-8];

pub(crate) fn at(x: f64, y: f64, theta: f64) -> Coordinates {
    Coordinates::Planar(Configuration::new(x, y, theta))
}

pub(crate) fn space(fixed: &Part, moving: &Part, window: Option<(f64, f64)>) -> PairSpace {
    let options = Options {
        window,
        ..Options::default()
    };
    PairSpace::compute(fixed, moving, Relation::Planar, &options).unwrap()
}

pub(crate) fn asked(
    space: &PairSpace,
    from: Coordinates,
    to: Coordinates,
    clearance: Clearance,
) -> Answer {
    let wishes = Wishes {
        clearance,
        ..Wishes::default()
    };
    Planner::new(space)
        .unwrap()
        .plan(from, to, &wishes)
        .unwrap()
}

/// A passage is open for a number just below its threshold, and closed just above.
pub(crate) fn passes_up_to(
    threshold: f64,
    (from, to): (Coordinates, Coordinates),
    pair: impl Fn(f64) -> (Part, Part),
) {
    for close in CLOSE {
        for (number, opens) in [
            (threshold * (1.0 - close), true),
            (threshold * (1.0 + close), false),
        ] {
            let (fixed, moving) = pair(number);
            let space = space(&fixed, &moving, None);
            let answer = asked(&space, from, to, Clearance::Quick);
            match answer.verdict {
                Verdict::Path(path) => {
                    assert!(opens, "{number} passes");
                    assert!(path.narrowest.clearance > 0.0);
                    let (scene, oracle) =
                        (Scene::of(&space).unwrap(), Oracle::new(&fixed, &moving));
                    let name = format!("{number}");
                    is_free(&scene, &oracle, &path, places(), &name);
                }
                Verdict::NoPath(_) => assert!(!opens, "{number} does not pass"),
                other => panic!("{number}: {other:?}"),
            }
        }
    }
}

/// A corridor one wide around a corner, closed at its ends.
fn corridor() -> Part {
    let frame = [(-9.0, -9.0), (3.0, -9.0), (3.0, 3.0), (-9.0, 3.0)];
    let inside = [
        (-8.0, 0.0),
        (0.0, 0.0),
        (0.0, -8.0),
        (1.0, -8.0),
        (1.0, 1.0),
        (-8.0, 1.0),
    ];
    let outline = |corners: &[(f64, f64)]| -> Vec<Vertex> {
        corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
    };
    Part::new("corridor", vec![outline(&frame), outline(&inside)]).unwrap()
}

fn rod(length: f64, width: f64) -> Part {
    Part::rectangle("rod", (0.0, 0.0), length, width).unwrap()
}

#[test]
fn a_rod_turns_a_corner_up_to_its_length() {
    // L ≤ 2 (√2 − w)
    let width = 0.2;
    let threshold = 2.0 * (SQRT_2 - width);
    let ends = (at(-5.0, 0.5, 0.0), at(0.5, -5.0, -FRAC_PI_2));
    passes_up_to(threshold, ends, |length| (corridor(), rod(length, width)));
}

#[test]
fn the_widest_way_around_a_corner_is_as_wide_as_the_formula_says() {
    // With c of clearance the outer walls are nearer by c and the inner corner farther from the rod by c:
    // L = 2 (√2 (1 − c) − (w + c))
    let (length, width) = (2.0, 0.2);
    let widest = (2.0 * SQRT_2 - 2.0 * width - length) / (2.0 * SQRT_2 + 2.0);
    let space = space(&corridor(), &rod(length, width), None);
    let (from, to) = (at(-5.0, 0.5, 0.0), at(0.5, -5.0, -FRAC_PI_2));
    let answer = asked(&space, from, to, Clearance::Widest);
    let bottleneck = answer.bottleneck.unwrap();
    assert!((bottleneck.narrow.clearance - widest).abs() < 1e-8);
    assert!((bottleneck.most.unwrap() - widest).abs() < 1e-8);
    // In the corner, at 45 degrees to it.
    let Coordinates::Planar(c) = bottleneck.narrow.at else {
        panic!("a planar pair");
    };
    assert!(
        (c.theta.rem_euclid(FRAC_PI_2) - FRAC_PI_2 / 2.0).abs() < 1e-3,
        "{c:?}"
    );
    for (least, is_path) in [
        (widest * (1.0 - 1e-6), true),
        (widest * (1.0 + 1e-6), false),
    ] {
        let answer = asked(&space, from, to, Clearance::AtLeast(least));
        assert_eq!(matches!(answer.verdict, Verdict::Path(_)), is_path);
        assert_eq!(answer.verdict == Verdict::TooNarrow, !is_path);
    }
    let Verdict::Path(half) = asked(&space, from, to, Clearance::Half).verdict else {
        panic!("there is a way");
    };
    assert!(half.narrowest.clearance >= 0.5 * widest * (1.0 - 1e-5));
}

#[test]
fn a_tilted_peg_goes_into_a_slot_up_to_two_points() {
    // D = d cosθ + l sinθ, with the length l inside.
    let (d, slot, theta) = (1.0, 1.1, 0.05_f64);
    let (sin, cos) = theta.sin_cos();
    let deepest = (slot - d * cos) / sin;
    let block = Part::polygon(
        "block",
        &[
            (-5.0, 0.0),
            (-5.0, -12.0),
            (5.0, -12.0),
            (5.0, 0.0),
            (slot, 0.0),
            (slot, -10.0),
            (0.0, -10.0),
            (0.0, 0.0),
        ],
    )
    .unwrap();
    let peg = Part::rectangle("peg", (0.5 * d, 10.0), d, 20.0).unwrap();
    let space = space(&block, &peg, Some((theta - 0.01, 1.5)));
    for close in CLOSE {
        for (length, fits) in [
            (deepest * (1.0 - close), true),
            (deepest * (1.0 + close), false),
        ] {
            // The corner at the peg's origin so that what is to spare is the same on both sides.
            let spare = slot - d * cos - length * sin;
            let goal = at(length * sin + 0.5 * spare, -length * cos, theta);
            let answer = asked(&space, at(-5.0, 6.0, 1.0), goal, Clearance::Quick);
            match answer.verdict {
                Verdict::Path(_) => assert!(fits, "{length} goes in"),
                Verdict::ToBlocked(_) => assert!(!fits, "{length} does not go in"),
                other => panic!("{length}: {other:?}"),
            }
        }
    }
}

/// A square that is wedged between the four walls of a square hole is let go by a turn alone, whatever point legs are about: the rates
/// of its gaps by the turn depend on that point.
#[test]
fn a_wedged_square_lets_go_about_any_point() {
    // Its corners are all off the walls by this, which counts as contact.
    let (theta, play) = (0.3_f64, 1e-11);
    let half = theta.cos() + theta.sin() + play;
    let sides = |r: f64| [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(x, y)| Vertex::line(x, y));
    let frame = Part::new("frame", vec![sides(3.0).into(), sides(half).into()]).unwrap();
    let square = Part::new("square", vec![sides(1.0).into()]).unwrap();
    let space = space(&frame, &square, None);
    for about in [(0.0, 0.0), (3.0, 40.0), (-2.0, -40.0), (60.0, 5.0)] {
        let planner = Planner::with_about(&space, Vector::new(about.0, about.1)).unwrap();
        let answer = planner
            .plan(at(0.0, 0.0, theta), at(0.1, 0.1, 0.0), &Wishes::default())
            .unwrap();
        assert!(
            matches!(answer.verdict, Verdict::Path(_)),
            "about {about:?}: {:?}",
            answer.verdict
        );
    }
}

#[test]
fn a_key_leaves_its_hole_if_the_bit_is_narrower_than_the_slot() {
    // A round hole with a slot 1 wide; the bit has to be turned to go through it.
    let half = 0.5_f64;
    let radius = 2.0_f64;
    let inner = -(radius * radius - half * half).sqrt();
    // Counter-clockwise around the hole's other side, by tan(sweep/4).
    let opening = 2.0 * (half / radius).asin();
    let bulge = -((core::f64::consts::TAU - opening) / 4.0).tan();
    let plate = Part::new(
        "plate",
        vec![vec![
            Vertex::line(-4.0, -6.0),
            Vertex::line(-half, -6.0),
            Vertex::new(-half, inner, bulge),
            Vertex::line(half, inner),
            Vertex::line(half, -6.0),
            Vertex::line(4.0, -6.0),
            Vertex::line(4.0, 4.0),
            Vertex::line(-4.0, 4.0),
        ]],
    )
    .unwrap();
    let ends = (at(0.0, 0.0, FRAC_PI_2), at(0.0, -12.0, 0.3));
    passes_up_to(1.0, ends, |width| {
        let bit = Part::rectangle("bit", (0.0, 0.0), width, 2.5).unwrap();
        (plate.clone(), bit)
    });
}

#[test]
fn a_flatted_ball_leaves_a_c_by_turning() {
    // The ball is wider than the gap but across its flats.
    let c = cspace_oracle::shapes::c_shape(3.0, 2.0, 0.8);
    // The gap between the tips: c_shape is open to the right, by 0.8 to either side at most.
    let gap = 2.0
        * (c.edges().map(|e| e.start))
            .filter(|p| p.x > 0.0 && p.y > 0.0)
            .map(|p| p.y)
            .fold(f64::INFINITY, f64::min);
    let ends = (at(0.0, 0.0, 0.0), at(9.0, 0.0, 0.0));
    passes_up_to(gap, ends, |thick| {
        // Flats above and below after a quarter of a turn.
        let half = 0.5 * thick;
        let reach = (1.5_f64 * 1.5 - half * half).sqrt();
        let bulge = ((PI - 2.0 * (reach / 1.5).asin()) / 4.0).tan();
        let ball = Part::new(
            "ball",
            vec![vec![
                Vertex::line(half, -reach),
                Vertex::new(half, reach, bulge),
                Vertex::line(-half, reach),
                Vertex::new(-half, -reach, bulge),
            ]],
        );
        (c.clone(), ball.unwrap())
    });
}

#[test]
fn a_way_in_contact_at_its_ends_leaves_them() {
    let block = Part::rectangle("block", (0.0, 0.0), 4.0, 2.0).unwrap();
    let table = Part::rectangle("table", (0.0, -5.0), 20.0, 10.0).unwrap();
    let space = space(&table, &block, None);
    // On the table, and beside it.
    let (from, to) = (at(0.0, 1.0, 0.0), at(11.0, -5.0, FRAC_PI_2));
    let answer = asked(&space, from, to, Clearance::Half);
    let Verdict::Path(path) = answer.verdict else {
        panic!("{:?}", answer.verdict);
    };
    assert_eq!(path.configurations.first(), Some(&from));
    assert!(path.narrowest.clearance < 1e-9);
    let checked = cspace_plan::check(&Scene::of(&space).unwrap(), &path.configurations);
    assert!(matches!(checked, Ok(cspace_plan::Checked::Free(_))));
}

/// A curved key with little play in a half ring: it turns about the centre of the ring, far from its own middle, and then goes down.
#[test]
fn a_curved_key_turns_about_the_center_of_its_groove() {
    let play = effort(1e-2, 1e-3);
    let on = |r: f64, degrees: f64, bulge: f64| {
        let angle = degrees.to_radians();
        Vertex::new(r * angle.cos(), r * angle.sin(), bulge)
    };
    let bulge = |degrees: f64| (degrees.to_radians() / 4.0).tan();
    let (inner, outer) = (30.0, 40.0);
    // From 30 degrees the groove is closed by the plate; at 180 it is open below.
    let plate = vec![
        Vertex::line(-60.0, 0.0),
        on(outer + play, 180.0, -bulge(150.0)),
        on(outer + play, 30.0, 0.0),
        on(inner - play, 30.0, bulge(150.0)),
        on(inner - play, 180.0, 0.0),
        Vertex::line(60.0, 0.0),
        Vertex::line(60.0, 60.0),
        Vertex::line(-60.0, 60.0),
    ];
    let key = vec![
        on(outer, 60.0, bulge(50.0)),
        on(outer, 110.0, 0.0),
        on(inner, 110.0, -bulge(50.0)),
        on(inner, 60.0, 0.0),
    ];
    let plate = Part::new("plate", vec![plate]).unwrap();
    let key = Part::new("key", vec![key]).unwrap();
    let space = space(&plate, &key, None);
    let planner = Planner::new(&space).unwrap();
    let (_, answer) = planner
        .plan_out(at(0.0, 0.0, 0.0), &Wishes::default(), &cspace::Silent)
        .unwrap();
    let Verdict::Path(path) = answer.verdict else {
        panic!("{:?}", answer.verdict);
    };
    assert!(path.configurations.len() <= 4, "{path:?}");
    assert!(path.about.length() < 1e-9, "{:?}", path.about);
    assert!((path.narrowest.clearance - play).abs() < 1e-6, "{path:?}");
    let oracle = Oracle::new(&plate, &key);
    is_free(planner.scene(), &oracle, &path, places(), "curved key");
}

/// A peg seated in a deep hole: off the bottom its clearance rises to the play and no farther, so the leg up to the mouth does not count
/// as one that leaves the contact.
#[test]
fn a_leg_off_a_contact_does_not_hide_a_narrow_place() {
    const PLAY: f64 = 0.05;
    let hole = [
        (-10.0, -5.0),
        (10.0, -5.0),
        (10.0, 20.0),
        (3.0 + PLAY, 20.0),
        (3.0 + PLAY, 0.0),
        (-3.0 - PLAY, 0.0),
        (-3.0 - PLAY, 20.0),
        (-10.0, 20.0),
    ];
    let hole = Part::polygon("hole", &hole).unwrap();
    let peg = Part::rectangle("peg", (0.0, 15.0), 6.0, 30.0).unwrap();
    let space = space(&hole, &peg, None);
    let planner = Planner::new(&space).unwrap();
    let asked = |clearance: Clearance| {
        let wishes = Wishes {
            clearance,
            ..Wishes::default()
        };
        let from = at(0.0, 0.0, 0.0);
        planner.plan_out(from, &wishes, &cspace::Silent).unwrap().1
    };
    let refused = asked(Clearance::AtLeast(2.0 * PLAY));
    assert!(
        matches!(refused.verdict, Verdict::Unknown(_)),
        "{refused:?}"
    );
    let answer = asked(Clearance::Widest);
    let Verdict::Path(path) = answer.verdict else {
        panic!("{:?}", answer.verdict);
    };
    assert_eq!(path.configurations.len(), 2, "{path:?}");
    let found = answer.bottleneck.unwrap().narrow.clearance;
    assert!((found - PLAY).abs() < 1e-3 * PLAY, "{found}");
    let scene = planner.scene().clone().with_about(path.about);
    let places: Vec<_> = (path.configurations.iter())
        .map(|&c| scene.numbers(c).unwrap())
        .collect();
    let rest = cspace_plan::off_contacts(&scene, &places, (true, false));
    let least = scene.least(rest[0], rest[1]).distance;
    assert!((least - PLAY).abs() < 1e-3 * PLAY, "{least} {rest:?}");
}

/// A block in a ring turns past half a turn in one leg, about the centre of the ring, though that is not its own middle.
#[test]
fn a_single_turn_is_found_about_the_point_that_stays() {
    let ring = |name: &str, r: f64| {
        let half = |x: f64| Vertex::new(x, 0.0, 1.0);
        (name.to_owned(), vec![half(-r), half(r)])
    };
    let (name, outer) = ring("ring", 20.0);
    let inner = ring("", 15.0).1;
    let island = ring("", 9.0).1;
    let fixed = Part::new(&name, vec![outer, inner, island]).unwrap();
    let block = Part::rectangle("block", (12.0, 0.0), 4.0, 3.0).unwrap();
    let space = space(&fixed, &block, None);
    for degrees in [20.0_f64, 160.0, 180.0, 200.0, 330.0] {
        let answer = asked(
            &space,
            at(0.0, 0.0, 0.0),
            at(0.0, 0.0, degrees.to_radians()),
            Clearance::Half,
        );
        let Verdict::Path(path) = answer.verdict else {
            panic!("{degrees}: {:?}", answer.verdict);
        };
        assert_eq!(path.configurations.len(), 2, "{degrees}: {path:?}");
        let oracle = Oracle::new(&fixed, &block);
        let scene = Scene::of(&space).unwrap();
        is_free(&scene, &oracle, &path, places(), "block in a ring");
    }
}

/// A block in the corner of a tray: off the contacts it has as much clearance as half the play, and no bound is claimed, since other
/// legs off the contacts might leave more.
#[test]
fn a_path_from_a_corner_has_the_clearance_of_the_middle() {
    let tray = [
        (0.0, 0.0),
        (60.0, 0.0),
        (60.0, 40.0),
        (50.0, 40.0),
        (50.0, 10.0),
        (10.0, 10.0),
        (10.0, 40.0),
        (0.0, 40.0),
    ];
    let tray = Part::polygon("tray", &tray).unwrap();
    let block = [(0.0, 0.0), (30.0, 0.0), (30.0, 10.0), (0.0, 10.0)];
    let block = Part::polygon("block", &block).unwrap();
    let space = space(&tray, &block, None);
    let planner = Planner::new(&space).unwrap();
    let asked = |clearance: Clearance| {
        let wishes = Wishes {
            clearance,
            ..Wishes::default()
        };
        let from = at(20.0, 10.0, 0.0);
        planner.plan_out(from, &wishes, &cspace::Silent).unwrap().1
    };
    for clearance in [
        Clearance::Half,
        Clearance::AtLeast(4.0),
        Clearance::AtLeast(4.999),
        Clearance::Widest,
    ] {
        let answer = asked(clearance);
        let Verdict::Path(path) = answer.verdict else {
            panic!("{clearance:?} {:?}", answer.verdict);
        };
        let least = match clearance {
            Clearance::AtLeast(least) => least,
            Clearance::Widest => 4.99,
            _ => 2.5,
        };
        let places = &path.configurations;
        assert!(places.len() <= 3, "{clearance:?} {places:?}");
        let scene = planner.scene();
        for leg in places[1..].windows(2) {
            let [from, to] = [leg[0], leg[1]].map(|c| scene.numbers(c).unwrap());
            assert!(
                scene.least(from, to).distance >= least,
                "{clearance:?} {leg:?}"
            );
        }
        let claimed = answer.bottleneck.map(|b| b.most);
        let is_widest = clearance == Clearance::Widest;
        assert_eq!(claimed, is_widest.then_some(None), "{clearance:?}");
    }
    // Upwards there is no more than 5, but nothing proves it of other legs off the contacts.
    let answer = asked(Clearance::AtLeast(6.0));
    assert!(matches!(answer.verdict, Verdict::Unknown(_)), "{answer:?}");
    assert!(answer.bottleneck.unwrap().most.is_none());
}

#[test]
fn a_blocked_start_tells_how_deep_and_where_it_is_free() {
    let block = Part::rectangle("block", (0.0, 0.0), 4.0, 2.0).unwrap();
    let table = Part::rectangle("table", (0.0, -5.0), 20.0, 10.0).unwrap();
    let space = space(&table, &block, Some((-0.5, 0.5)));
    let answer = asked(
        &space,
        at(0.0, 0.75, 0.0),
        at(0.0, 5.0, 0.0),
        Clearance::Half,
    );
    let Verdict::FromBlocked(blocked) = answer.verdict else {
        panic!("{:?}", answer.verdict);
    };
    assert!((blocked.depth - 0.25).abs() < 1e-9);
    let Some(Coordinates::Planar(free)) = blocked.nearest else {
        panic!("{blocked:?}");
    };
    assert!(free.x.abs() < 1e-9 && (free.y - 1.0).abs() < 1e-9);
}

/// A block that has to turn outside of a bent passage does so by no more than half a turn at once: whole turns lead nowhere.
#[test]
fn no_leg_winds() {
    let bend = Part::polygon(
        "bend",
        &[
            (-60.0, 0.0),
            (0.0, 0.0),
            (0.0, -60.0),
            (10.0, -60.0),
            (10.0, 10.0),
            (-60.0, 10.0),
            (-60.0, 20.0),
            (20.0, 20.0),
            (20.0, -70.0),
            (-70.0, -70.0),
            (-70.0, 0.0),
        ],
    )
    .unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 12.0, 8.0).unwrap();
    let space = space(&bend, &block, None);
    for clearance in [Clearance::Half, Clearance::Widest] {
        let answer = asked(
            &space,
            at(-40.0, 5.0, 0.0),
            at(5.0, -40.0, FRAC_PI_2),
            clearance,
        );
        let Verdict::Path(path) = answer.verdict else {
            panic!("{:?}", answer.verdict);
        };
        for leg in path.configurations.windows(2) {
            let [Coordinates::Planar(a), Coordinates::Planar(b)] = leg else {
                panic!("{leg:?}");
            };
            assert!((b.theta - a.theta).abs() <= PI * (1.0 + 1e-9), "{leg:?}");
        }
    }
}
