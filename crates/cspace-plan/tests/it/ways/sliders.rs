//! The widest ways of an arm that turns and a part that slides past it, against brute force on a grid of (u, v).

use core::cmp::Reverse;
use core::f64::consts::TAU;
use std::collections::{BTreeSet, BinaryHeap};

use cspace::{Axis, Configuration, Coordinates, Options, PairSpace, Part, Point, Relation, Vector};
use cspace_oracle::{Oracle, effort};
use cspace_plan::{Checked, Clearance, Planner, Verdict, Wishes, check};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A whole turn has so many steps of the grid.
const TURN: i32 = 120;
/// A length of 1 has so many steps.
const UNIT: i32 = 8;
/// The least and the greatest v.
const TRAVEL: (i32, i32) = (-3, 24);

/// An arm that turns about the origin, and a slider that goes past it along x.
struct Pair {
    arm: Part,
    slider: Part,
    /// The arm turns between these steps of the grid; without limits if none are given.
    limits: Option<(i32, i32)>,
}

/// A place of the grid: steps of the turn, and of the travel.
type Node = (i32, i32);

fn motions((i, j): Node) -> (f64, f64) {
    let u = TAU * f64::from(i) / f64::from(TURN);
    (u, f64::from(j) / f64::from(UNIT))
}

impl Pair {
    fn random(number: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(number);
        let mut between = |lo: f64, hi: f64| rng.random_range(lo..hi);
        let (half, back, reach) = (between(0.3, 0.9), between(0.3, 1.0), between(3.0, 6.0));
        // Drawn along y, so that u = 0 is where curves of contact begin and end.
        let arm = [(-half, -back), (half, -back), (half, reach), (-half, reach)];
        let (y, high) = (between(1.2, 3.5), between(0.5, 2.0));
        let slider = match number % 3 {
            0 => Part::rectangle("slider", (-10.0, y + 0.5 * high), 4.0, high),
            1 => Part::polygon("slider", &[(-12.0, y), (-8.0, y), (-10.0, y + 1.0)]),
            _ => Part::circle("slider", (-10.0, y + 1.0), 1.0),
        };
        Self {
            arm: Part::polygon("arm", &arm).unwrap(),
            slider: slider.unwrap(),
            limits: (number % 4 == 3).then_some((-TURN / 2 + 2, TURN / 2 - 2)),
        }
    }

    /// How far the arm reaches from its pivot: turning by an angle changes distances by no more than this times the angle.
    fn reach(&self) -> f64 {
        (self.arm.edges())
            .map(|e| e.start.x.hypot(e.start.y))
            .fold(0.0, f64::max)
    }

    /// Distances change by no more between a place of the plane and the nearest of the grid.
    fn grid_error(&self) -> f64 {
        0.5 * (self.reach() * TAU / f64::from(TURN) + 1.0 / f64::from(UNIT))
    }

    fn axes(&self) -> (Axis, Axis) {
        let turn = Axis::revolute(Point::new(0.0, 0.0));
        let turn = match self.limits {
            Some((lo, hi)) => turn.within(motions((lo, 0)).0, motions((hi, 0)).0),
            None => turn,
        };
        let (lo, hi) = TRAVEL;
        let slide = Axis::prismatic(Vector::new(1.0, 0.0));
        (turn, slide.within(lo.into(), hi.into()))
    }

    /// The most clearance of the ways along the grid, each step to one of eight neighbours; 0 if there is none. A way of any
    /// clearance goes along the grid with less by no more than the error of the grid, and the other way around.
    fn widest_on_grid(&self, from: Node, to: Node) -> f64 {
        let oracle = Oracle::new(&self.arm, &self.slider);
        // The slider in the arm's frame: moved, then turned back.
        let clearance = |node: Node| {
            let (u, v) = motions(node);
            let judged = oracle.judge(Configuration::new(v * u.cos(), -v * u.sin(), -u));
            if judged.overlap {
                0.0
            } else {
                judged.clearance
            }
        };
        let (lo, hi) = TRAVEL;
        let place = |(i, j): Node| -> Option<Node> {
            let inside = (lo * UNIT..=hi * UNIT).contains(&j);
            match self.limits {
                Some((least, most)) => (inside && (least..=most).contains(&i)).then_some((i, j)),
                None => inside.then_some((i.rem_euclid(TURN), j)),
            }
        };
        let (from, to) = (place(from).unwrap(), place(to).unwrap());
        let mut seen = BTreeSet::from([from]);
        // Numbers that are not negative are ordered as their bits.
        let mut open = BinaryHeap::from([(clearance(from).to_bits(), Reverse(from))]);
        while let Some((bits, Reverse((i, j)))) = open.pop() {
            let here = f64::from_bits(bits);
            if (i, j) == to || here == 0.0 {
                return here;
            }
            for (di, dj) in (-1..=1).flat_map(|di| (-1..=1).map(move |dj| (di, dj))) {
                if let Some(next) = place((i + di, j + dj))
                    && seen.insert(next)
                {
                    open.push((clearance(next).min(here).to_bits(), Reverse(next)));
                }
            }
        }
        0.0
    }
}

/// The answer, with the arm as the part called fixed, or as the moving one. Its way is free, and its bound is one and sharp.
fn asked(pair: &Pair, arm_moves: bool, from: Node, to: Node, clearance: Clearance) -> Verdict {
    let (turn, slide) = pair.axes();
    let (parts, fixed, moving) = if arm_moves {
        ((&pair.slider, &pair.arm), slide, turn)
    } else {
        ((&pair.arm, &pair.slider), turn, slide)
    };
    let relation = Relation::Axes { fixed, moving };
    let space = PairSpace::compute(parts.0, parts.1, relation, &Options::default()).unwrap();
    let planner = Planner::new(&space).unwrap();
    let at = |node: Node| {
        let (turned, slid) = motions(node);
        let (u, v) = if arm_moves {
            (slid, turned)
        } else {
            (turned, slid)
        };
        Coordinates::Axes { u, v }
    };
    let wishes = Wishes {
        clearance,
        ..Wishes::default()
    };
    let answer = planner.plan(at(from), at(to), &wishes).unwrap();
    if let Verdict::Path(path) = &answer.verdict {
        let checked = check(planner.scene(), &path.configurations);
        let Ok(Checked::Free(narrow)) = checked else {
            panic!("{checked:?}");
        };
        if let Some(bottleneck) = answer.bottleneck {
            let (most, widest) = (bottleneck.most.unwrap(), bottleneck.narrow.clearance);
            assert!(narrow.clearance <= most, "{narrow:?} {bottleneck:?}");
            assert!(widest <= most, "{bottleneck:?}");
            assert!(most - widest < 1e-6, "{bottleneck:?}");
            assert!(
                widest - narrow.clearance < 1.001e-3 * widest,
                "{narrow:?} {bottleneck:?}"
            );
        }
    }
    answer.verdict
}

/// Asks the pairs of some numbers for ways from one side of the arm to the other at u = 0, or between places anywhere.
fn compared(numbers: core::ops::Range<u64>) -> usize {
    let mut paths = 0;
    for number in numbers {
        let pair = Pair::random(number);
        let mut rng = ChaCha8Rng::seed_from_u64(number + 1_000_000);
        let mut somewhere = || {
            let i = rng.random_range(-TURN / 2 + 2..TURN / 2 - 2);
            (i, rng.random_range(TRAVEL.0 * UNIT..TRAVEL.1 * UNIT))
        };
        let (from, to) = match number % 5 {
            4 => (somewhere(), somewhere()),
            _ => ((0, 0), (0, 20 * UNIT)),
        };
        let arm_moves = number % 2 == 1;
        let (grid, error) = (pair.widest_on_grid(from, to), pair.grid_error());
        let name = format!("pair {number}, {grid} on the grid");
        match asked(&pair, arm_moves, from, to, Clearance::Widest) {
            Verdict::Path(path) => {
                paths += 1;
                let found = path.narrowest.clearance;
                assert!((found - grid).abs() < error, "{name}: {found}");
            }
            other => assert!(grid < error, "{name}: {other:?}"),
        }
        for (least, is_path) in [(grid - error, true), (grid + error, false)] {
            if least > 0.0 {
                let answer = asked(&pair, arm_moves, from, to, Clearance::AtLeast(least));
                assert_eq!(
                    matches!(answer, Verdict::Path(_)),
                    is_path,
                    "{name}: {least} {answer:?}"
                );
            }
        }
    }
    paths
}

#[test]
fn widest_ways_past_an_arm_are_those_on_a_grid() {
    let paths = compared(1..effort(6, 21));
    assert!(paths > effort(2, 12), "{paths}");
}

#[test]
#[ignore = "takes minutes"]
fn widest_ways_past_a_hundred_arms_are_those_on_a_grid() {
    let paths = compared(21..121);
    assert!(paths > 60, "{paths}");
}

#[test]
fn an_arm_turns_away_to_let_a_bar_pass() {
    // With the arm turned down, the bar's lower side is 3 from the pivot and the arm's back 0.5 above it.
    let arm = Part::polygon("arm", &[(-0.5, -0.5), (0.5, -0.5), (0.5, 5.0), (-0.5, 5.0)]);
    let bar = Part::polygon(
        "slider",
        &[(-12.0, 3.0), (-8.0, 3.0), (-8.0, 4.0), (-12.0, 4.0)],
    );
    let (arm, slider) = (arm.unwrap(), bar.unwrap());
    for limits in [None, Some((-TURN / 2 + 2, TURN / 2 - 2))] {
        let pair = Pair {
            arm: arm.clone(),
            slider: slider.clone(),
            limits,
        };
        for arm_moves in [false, true].into_iter().take(effort(1, 2)) {
            // Where an end is a critical value of u, and where it is none; after whole turns.
            let turned = if limits.is_none() { TURN } else { 0 };
            for from in [0, 1, turned] {
                let ends = ((from, 0), (from - turned, 20 * UNIT));
                let asked = |c| asked(&pair, arm_moves, ends.0, ends.1, c);
                let Verdict::Path(path) = asked(Clearance::Widest) else {
                    panic!("it passes");
                };
                assert!((path.narrowest.clearance - 2.5).abs() < 1e-5);
                assert!(matches!(asked(Clearance::AtLeast(2.499)), Verdict::Path(_)));
                assert_eq!(asked(Clearance::AtLeast(2.501)), Verdict::TooNarrow);
            }
        }
    }
}
