//! Drawn problems with the legs of the best way known by hand: what is planned has at most twice as many.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::{
    Configuration, Coordinates, Options, PairSpace, Part, Relation, Rotation, Silent, Vector,
    Vertex,
};
use cspace_oracle::Oracle;
use cspace_plan::{Path, Planner, Prefer, Verdict, Wishes};

use crate::ways::judge::is_free;

type At = (f64, f64, f64);

/// A problem: what is fixed, what moves, from where, to where or out, and so many legs by hand.
struct Problem {
    name: &'static str,
    fixed: Part,
    moving: Part,
    from: At,
    to: Option<At>,
    by_hand: usize,
}

fn corners(points: &[(f64, f64)]) -> Vec<Vertex> {
    points.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

fn outline(points: &[(f64, f64)]) -> Part {
    part(vec![corners(points)])
}

fn part(loops: Vec<Vec<Vertex>>) -> Part {
    Part::new("part", loops).unwrap()
}

fn block(x: f64, y: f64, width: f64, height: f64) -> Part {
    Part::rectangle("block", (x, y), width, height).unwrap()
}

fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Vertex> {
    corners(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
}

/// A part turned about its origin, and moved.
fn placed(part: &Part, x: f64, y: f64, angle: f64) -> Part {
    let turn = Rotation::by(angle);
    let moved = |v: &Vertex| {
        let p = Vector::new(x, y) + turn * Vector::new(v.x, v.y);
        Vertex::new(p.x, p.y, v.bulge)
    };
    let loops = part
        .loops()
        .iter()
        .map(|l| l.vertices().iter().map(moved).collect());
    Part::new(part.name(), loops.collect()).unwrap()
}

fn pin(radius: f64) -> Part {
    Part::circle("pin", (0.0, 0.0), radius).unwrap()
}

/// A plate with a slot that is open above: along a line of points with a width, within x from −30 to 30 and y from −40 to 0.
fn slotted(walls: &[(f64, f64)]) -> Part {
    let mut points = vec![(-30.0, -40.0), (30.0, -40.0), (30.0, 0.0)];
    points.extend_from_slice(walls);
    points.push((-30.0, 0.0));
    outline(&points)
}

/// Down, to the right and up again.
fn j_slot() -> Part {
    slotted(&[
        (3.0, 0.0),
        (3.0, -20.0),
        (9.0, -20.0),
        (9.0, -12.0),
        (15.0, -12.0),
        (15.0, -26.0),
        (-3.0, -26.0),
        (-3.0, 0.0),
    ])
}

/// Down and to the right.
fn l_slot() -> Part {
    slotted(&[
        (3.0, 0.0),
        (3.0, -14.0),
        (20.0, -14.0),
        (20.0, -20.0),
        (-3.0, -20.0),
        (-3.0, 0.0),
    ])
}

/// Down, to the right, down, and to the left.
fn s_slot() -> Part {
    slotted(&[
        (3.0, 0.0),
        (3.0, -8.0),
        (20.0, -8.0),
        (20.0, -28.0),
        (-20.0, -28.0),
        (-20.0, -22.0),
        (14.0, -22.0),
        (14.0, -14.0),
        (-3.0, -14.0),
        (-3.0, 0.0),
    ])
}

/// A round chamber with a slit above.
fn keyhole() -> Part {
    let mut walls = vec![Vertex::line(1.0, 0.0)];
    let y = -(16.0f64 - 1.0).sqrt();
    // The circle of radius 4 about (0, −11.87).
    let bottom = -8.0;
    let around = (PI - (0.25f64).asin()) * 2.0;
    walls.push(Vertex::new(1.0, bottom, -(around / 8.0).tan()));
    walls.push(Vertex::new(0.0, bottom + y - 4.0, -(around / 8.0).tan()));
    walls.push(Vertex::line(-1.0, bottom));
    walls.push(Vertex::line(-1.0, 0.0));
    let mut outer = corners(&[(-30.0, -40.0), (30.0, -40.0), (30.0, 0.0)]);
    outer.extend(walls);
    outer.push(Vertex::line(-30.0, 0.0));
    part(vec![outer])
}

/// Two walls with gaps that do not face each other, in a room.
fn baffles() -> Part {
    part(vec![
        rectangle(-19.9, -1.0, 4.0, 1.0),
        rectangle(-4.0, 9.0, 19.9, 11.0),
        rectangle(-22.0, -30.0, -20.0, 30.0),
        rectangle(20.0, -30.0, 22.0, 30.0),
    ])
}

fn maze() -> Part {
    part(vec![
        rectangle(-1.0, -1.0, 31.0, 0.0),
        rectangle(-1.0, 1.0, 0.0, 31.0),
        rectangle(30.5, 1.0, 31.0, 25.0),
        rectangle(6.0, 0.5, 7.0, 24.0),
        rectangle(12.0, 6.0, 13.0, 31.0),
        rectangle(18.0, 0.5, 19.0, 24.0),
        rectangle(24.0, 6.0, 25.0, 31.0),
        rectangle(-1.0, 31.5, 31.0, 32.0),
    ])
}

#[expect(clippy::too_many_lines, reason = "a list")]
fn problems() -> Vec<Problem> {
    let problem = |name, fixed: Part, moving: Part, from, to, by_hand| Problem {
        name,
        fixed,
        moving,
        from,
        to,
        by_hand,
    };
    let l_part = outline(&[
        (0.0, 0.0),
        (6.0, 0.0),
        (6.0, 1.0),
        (1.0, 1.0),
        (1.0, 6.0),
        (0.0, 6.0),
    ]);
    let wall = part(vec![
        rectangle(-1.0, -30.0, 1.0, -1.0),
        rectangle(-1.0, 1.0, 1.0, 30.0),
    ]);
    let tray = outline(&[
        (-12.0, -2.0),
        (12.0, -2.0),
        (12.0, 4.0),
        (8.0, 4.0),
        (8.0, 3.5),
        (11.0, 3.5),
        (11.0, 0.0),
        (-11.0, 0.0),
        (-11.0, 3.5),
        (-8.5, 3.5),
        (-8.5, 4.0),
        (-12.0, 4.0),
    ]);
    vec![
        problem(
            "round pin drawn afar in a J slot",
            j_slot(),
            placed(&pin(2.5), 20.0, 0.0, 0.0),
            (-8.0, -16.0, 0.0),
            None,
            3,
        ),
        problem(
            "square pin in a J slot",
            j_slot(),
            block(0.0, 0.0, 5.0, 5.0),
            (12.0, -16.0, 0.0),
            None,
            3,
        ),
        problem(
            "square pin drawn afar in a J slot",
            j_slot(),
            block(40.0, 10.0, 5.0, 5.0),
            (-28.0, -26.0, 0.0),
            None,
            3,
        ),
        problem(
            "pin in an L slot",
            l_slot(),
            pin(2.9),
            (16.0, -17.0, 0.0),
            None,
            2,
        ),
        problem(
            "pin in a turned L slot",
            placed(&l_slot(), 3.0, 4.0, 0.4),
            pin(2.9),
            (
                3.0 + 16.0 * 0.4f64.cos() + 17.0 * 0.4f64.sin(),
                4.0 + 16.0 * 0.4f64.sin() - 17.0 * 0.4f64.cos(),
                0.0,
            ),
            None,
            2,
        ),
        problem(
            "turned block in a turned L slot",
            placed(&l_slot(), 3.0, 4.0, 0.4),
            block(0.0, 0.0, 5.0, 5.5),
            (
                3.0 + 16.0 * 0.4f64.cos() + 17.0 * 0.4f64.sin(),
                4.0 + 16.0 * 0.4f64.sin() - 17.0 * 0.4f64.cos(),
                0.4,
            ),
            None,
            2,
        ),
        problem(
            "pin in an S slot",
            s_slot(),
            pin(2.5),
            (-16.0, -25.0, 0.0),
            None,
            5,
        ),
        problem(
            "block in an S slot",
            s_slot(),
            block(0.0, 0.0, 5.5, 5.5),
            (-16.0, -25.0, 0.0),
            None,
            5,
        ),
        problem(
            "key turned in a keyhole",
            keyhole(),
            block(0.0, 0.0, 6.5, 1.5),
            (0.0, -11.87, 0.0),
            None,
            2,
        ),
        problem(
            "peg in a hole",
            slotted(&[
                (4.0, 0.0),
                (3.0, -1.0),
                (3.0, -15.0),
                (-3.0, -15.0),
                (-3.0, -1.0),
                (-4.0, 0.0),
            ]),
            block(0.0, 6.0, 5.9, 12.0),
            (0.0, -14.9, 0.0),
            None,
            1,
        ),
        problem(
            "long bar around a corner",
            part(vec![
                corners(&[
                    (-40.0, -1.0),
                    (7.0, -1.0),
                    (7.0, 40.0),
                    (6.0, 40.0),
                    (6.0, 0.0),
                    (-40.0, 0.0),
                ]),
                rectangle(-40.0, 6.0, 0.0, 40.0),
            ]),
            block(0.0, 0.0, 9.0, 2.0),
            (-20.0, 3.0, 0.0),
            Some((3.0, 25.0, FRAC_PI_2)),
            3,
        ),
        problem(
            "latch under a lip",
            outline(&[
                (-10.0, -2.0),
                (20.0, -2.0),
                (20.0, 0.0),
                (0.0, 0.0),
                (0.0, 2.5),
                (3.0, 2.5),
                (3.0, 3.5),
                (-1.0, 3.5),
                (-1.0, 0.0),
                (-10.0, 0.0),
            ]),
            block(0.0, 0.0, 8.0, 2.0),
            (4.2, 1.1, 0.0),
            None,
            2,
        ),
        problem(
            "bar in a tray with lips",
            tray,
            block(0.0, 0.0, 18.0, 2.0),
            (0.0, 1.2, 0.0),
            None,
            3,
        ),
        problem(
            "drawer with a stop",
            outline(&[
                (-20.0, -1.0),
                (20.0, -1.0),
                (20.0, 1.0),
                (18.0, 1.0),
                (18.0, 0.0),
                (-20.0, 0.0),
            ]),
            outline(&[(-5.0, 0.0), (5.0, 0.0), (5.0, 3.0), (-5.0, 3.0)]),
            (10.0, 0.05, 0.0),
            Some((40.0, 2.0, 0.0)),
            2,
        ),
        problem(
            "screw head in a hanger",
            part(vec![
                rectangle(-30.0, -30.0, 30.0, 30.0),
                vec![
                    Vertex::line(1.5, 0.0),
                    Vertex::line(1.5, 8.0),
                    Vertex::new(-1.5, 8.0, 0.0),
                    Vertex::line(-1.5, 0.0),
                    Vertex::new(-4.0, -4.0, 1.0),
                    Vertex::new(4.0, -4.0, 0.0),
                ],
            ]),
            pin(1.3),
            (0.0, 6.0, 0.0),
            Some((0.0, -4.0, 0.0)),
            1,
        ),
        problem(
            "wedge in a groove",
            slotted(&[(10.0, 0.0), (0.0, -10.0), (-10.0, 0.0)]),
            outline(&[(0.0, 0.0), (8.0, 8.0), (-8.0, 8.0)]),
            (0.0, -9.5, 0.0),
            None,
            1,
        ),
        problem(
            "rack out of a rack",
            slotted(&[
                (8.0, 0.0),
                (6.0, -4.0),
                (4.0, -4.0),
                (2.0, 0.0),
                (0.0, -4.0),
                (-2.0, -4.0),
                (-4.0, 0.0),
            ]),
            outline(
                &[
                    (-3.0, -3.8),
                    (-0.6, -3.8),
                    (1.4, 0.2),
                    (2.6, 0.2),
                    (4.6, -3.8),
                    (5.6, -3.8),
                    (7.6, 0.2),
                    (7.6, 6.0),
                    (-3.0, 6.0),
                ]
                .map(|(x, y)| (x * 0.8, y + 0.0)),
            ),
            (0.2, 4.2, 0.0),
            None,
            1,
        ),
        problem(
            "disc through a maze",
            maze(),
            pin(2.0),
            (3.0, 27.0, 0.0),
            Some((28.0, 3.5, 0.0)),
            9,
        ),
        problem(
            "disc around a wall",
            part(vec![rectangle(-1.0, -10.0, 1.0, 10.0)]),
            pin(2.0),
            (-6.0, 0.0, 0.0),
            Some((6.0, 0.0, 0.0)),
            3,
        ),
        problem(
            "block past baffles",
            baffles(),
            block(0.0, 0.0, 5.0, 5.0),
            (-10.0, -10.0, 0.0),
            Some((10.0, 20.0, 0.0)),
            5,
        ),
        problem(
            "bar past baffles",
            baffles(),
            block(0.0, 0.0, 9.0, 2.0),
            (-10.0, -10.0, 0.0),
            Some((10.0, 20.0, 0.0)),
            5,
        ),
        problem(
            "angle through a gap",
            wall.clone(),
            l_part.clone(),
            (-12.0, -2.0, 0.0),
            Some((6.0, -2.0, 0.0)),
            3,
        ),
        problem(
            "angle drawn afar through a gap",
            wall.clone(),
            placed(&l_part, 30.0, -20.0, 0.0),
            (-42.0, 18.0, 0.0),
            Some((-24.0, 18.0, 0.0)),
            3,
        ),
        problem(
            "bar turned through a gap",
            wall,
            block(0.0, 0.0, 1.5, 8.0),
            (-10.0, 0.0, 0.0),
            Some((10.0, 0.0, 0.0)),
            3,
        ),
        problem(
            "bracket off a corner",
            block(0.0, 0.0, 20.0, 20.0),
            outline(&[
                (-15.0, 10.05),
                (-10.05, 10.05),
                (-10.05, -5.0),
                (-15.0, -5.0),
            ]),
            (0.0, 0.0, 0.0),
            None,
            1,
        ),
        problem(
            "angle off a corner",
            block(0.0, 0.0, 20.0, 20.0),
            outline(&[
                (-12.0, -5.0),
                (-10.05, -5.0),
                (-10.05, 10.05),
                (5.0, 10.05),
                (5.0, 12.0),
                (-12.0, 12.0),
            ]),
            (0.0, 0.0, 0.0),
            None,
            1,
        ),
        problem(
            "hook over a rod",
            pin(1.0),
            outline(&[
                (-2.5, -3.0),
                (-1.2, -3.0),
                (-1.2, 1.2),
                (1.2, 1.2),
                (1.2, -3.0),
                (2.5, -3.0),
                (2.5, 2.5),
                (-2.5, 2.5),
            ]),
            (0.0, 0.0, 0.0),
            None,
            1,
        ),
        problem(
            "T in a T slot open at the end",
            part(vec![
                corners(
                    &[(-20.0, 0.0), (20.0, 0.0), (20.0, -5.0), (-20.0, -5.0)]
                        .map(|(x, y)| (x, y - 6.0)),
                ),
                rectangle(-20.0, -1.0, -1.5, 2.0),
                rectangle(1.5, -1.0, 20.0, 2.0),
                rectangle(-21.5, -11.0, -20.5, 2.0),
            ]),
            outline(&[
                (-1.2, 6.0),
                (-1.2, -1.5),
                (-5.0, -1.5),
                (-5.0, -4.5),
                (5.0, -4.5),
                (5.0, -1.5),
                (1.2, -1.5),
                (1.2, 6.0),
            ]),
            (0.0, 0.0, 0.0),
            Some((0.0, -0.9, 0.0)),
            1,
        ),
        problem(
            "half turn in a room",
            part(vec![
                rectangle(-20.0, -20.0, 20.0, 20.0),
                rectangle(-7.0, -7.0, 7.0, 7.0),
            ]),
            outline(&[(-4.0, -1.0), (4.0, -1.0), (4.0, 1.0), (0.0, 3.0)]),
            (-2.0, -2.0, 0.0),
            Some((2.0, 2.0, PI)),
            2,
        ),
        problem(
            "three notches",
            slotted(&[
                (12.0, 0.0),
                (12.0, -6.0),
                (7.0, -6.0),
                (7.0, -12.0),
                (2.0, -12.0),
                (2.0, -20.0),
                (-3.0, -20.0),
                (-3.0, -12.0),
                (-6.0, 0.0),
            ]),
            block(0.0, 0.0, 4.5, 7.0),
            (-0.5, -16.4, 0.0),
            None,
            1,
        ),
    ]
}

impl Problem {
    fn space(&self) -> PairSpace {
        let options = Options::default();
        PairSpace::compute(&self.fixed, &self.moving, Relation::Planar, &options).unwrap()
    }

    /// The way to a place, or out, judged to be free.
    fn way(&self, planner: &Planner<'_>, to: Option<At>, prefer: Prefer) -> Path {
        let at = |(x, y, theta): At| Coordinates::Planar(Configuration::new(x, y, theta));
        let wishes = Wishes {
            prefer,
            ..Wishes::default()
        };
        let from = at(self.from);
        let answer = match to {
            Some(to) => planner.plan(from, at(to), &wishes).unwrap(),
            None => planner.plan_out(from, &wishes, &Silent).unwrap().1,
        };
        let Verdict::Path(path) = answer.verdict else {
            panic!("{}: {answer:?}", self.name);
        };
        let oracle = Oracle::new(&self.fixed, &self.moving);
        is_free(planner.scene(), &oracle, &path, 2000, self.name);
        path
    }
}

/// Each leg as the change of x and y of the point that moves straight, and of the orientation in degrees.
fn in_numbers(planner: &Planner<'_>, path: &Path) -> String {
    let places: Vec<_> = (path.configurations.iter())
        .map(|&c| planner.scene().numbers(c).unwrap())
        .collect();
    let leg = |leg: &[[f64; 3]]| {
        let by: [f64; 3] = core::array::from_fn(|k| leg[1][k] - leg[0][k]);
        format!("({:.5} {:.5} {:.4}°)", by[0], by[1], by[2].to_degrees())
    };
    places.windows(2).map(leg).collect::<Vec<_>>().join(" ")
}

#[test]
fn drawn_problems_take_at_most_twice_the_legs_by_hand() {
    let mut wrong = Vec::new();
    let all = problems();
    assert_eq!(all.len(), 30);
    for problem in &all {
        let space = problem.space();
        let planner = Planner::new(&space).unwrap();
        let path = problem.way(&planner, problem.to, Prefer::Legs);
        let legs = path.configurations.len() - 1;
        let told = format!(
            "{}: {legs} legs, {} by hand, clearance {:.4}: {}",
            problem.name,
            problem.by_hand,
            path.narrowest.clearance,
            in_numbers(&planner, &path)
        );
        println!("{told}");
        if legs > 2 * problem.by_hand {
            wrong.push(format!("{told}: {:#?}", path.configurations));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_preferred_is_had() {
    let names = [
        "block past baffles",
        "disc through a maze",
        "pin in an S slot",
        "angle through a gap",
    ];
    for problem in problems().iter().filter(|p| names.contains(&p.name)) {
        let space = problem.space();
        let planner = Planner::new(&space).unwrap();
        let to = problem.to.unwrap_or((-16.0, 30.0, 0.0));
        let [legs, clearance, length] = [Prefer::Legs, Prefer::Clearance, Prefer::Length]
            .map(|prefer| problem.way(&planner, Some(to), prefer));
        let long = |path: &Path| -> f64 {
            let scene = planner.scene();
            let places: Vec<_> = path
                .configurations
                .iter()
                .map(|&c| scene.numbers(c).unwrap())
                .collect();
            let apart = |leg: &[[f64; 3]]| {
                let by: [f64; 3] =
                    core::array::from_fn(|k| (leg[1][k] - leg[0][k]) * scene.levers()[k]);
                by.iter().map(|x| x * x).sum::<f64>().sqrt()
            };
            places.windows(2).map(apart).sum()
        };
        assert!(
            legs.configurations.len() <= clearance.configurations.len(),
            "{}",
            problem.name
        );
        assert!(long(&length) <= 1.01 * long(&clearance), "{}", problem.name);
        assert!(
            clearance.narrowest.clearance >= 0.9 * length.narrowest.clearance,
            "{}",
            problem.name
        );
    }
}

/// Lengths of legs and turns in degrees are whole or half numbers where there is room for it.
#[test]
fn numbers_of_legs_are_round() {
    const ROUNDING: f64 = 1e-9;
    let names = [
        "round pin drawn afar in a J slot",
        "key turned in a keyhole",
        "disc through a maze",
    ];
    let all = problems();
    let chosen: Vec<_> = all.iter().filter(|p| names.contains(&p.name)).collect();
    assert_eq!(chosen.len(), names.len());
    for problem in chosen {
        let space = problem.space();
        let planner = Planner::new(&space).unwrap();
        let path = problem.way(&planner, problem.to, Prefer::Legs);
        let places: Vec<_> = (path.configurations.iter())
            .map(|&c| planner.scene().numbers(c).unwrap())
            .collect();
        for leg in places.windows(2) {
            let by: [f64; 3] = core::array::from_fn(|k| leg[1][k] - leg[0][k]);
            for number in [by[0].hypot(by[1]), by[2].to_degrees()] {
                let off = (2.0 * number - (2.0 * number).round()).abs();
                assert!(off < ROUNDING, "{}: {by:?}", problem.name);
            }
        }
    }
}
