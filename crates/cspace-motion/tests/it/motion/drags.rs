//! Random drags from where parts are drawn: brute force judges where they are on the way.

use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::time::{Duration, Instant};

use cspace::{Part, Point};
use cspace_model::Mechanism;
use cspace_motion::{Ending, Hand, PartCoordinates, Target};
use cspace_oracle::{Oracle, effort};

use crate::motion::helpers::{Dice, model};

/// Parts overlap by no more than this on the way, relative to the size of a pair: contacts are known to less.
const CONTACT: f64 = 1e-9;
/// The way is straight between its states for this test, and curved for the hand: overlap there, relative to the distance of the states.
/// Around a rounding it is up to 0.125; what passes through a part is deeper.
const CHORD: f64 = 0.15;
/// Largest displacement between two places that are judged, relative to the size of the mechanism.
const STEP: f64 = 0.01;

/// A mechanism that is dragged about.
struct Drags {
    mechanism: Mechanism,
    hand: Hand,
    /// Pairs that no joint connects, as they are drawn.
    pairs: Vec<(usize, usize, Oracle)>,
    dice: Dice,
    longest: Duration,
    spent: Duration,
    snaps: usize,
    unfinished: usize,
    lost: usize,
}

impl Drags {
    fn new(mechanism: Mechanism, seed: u64) -> Self {
        let part = |i: usize| &mechanism.parts[i].part;
        let pairs =
            (mechanism.pairs.iter()).filter(|p| mechanism.joint(p.fixed, p.moving).is_none());
        let pairs = pairs.map(|p| {
            (
                p.fixed,
                p.moving,
                Oracle::new(part(p.fixed), part(p.moving)),
            )
        });
        Self {
            pairs: pairs.collect(),
            hand: Hand::new(&mechanism).unwrap(),
            mechanism,
            dice: Dice(seed),
            longest: Duration::ZERO,
            spent: Duration::ZERO,
            snaps: 0,
            unfinished: 0,
            lost: 0,
        }
    }

    fn part(&self, name: &str) -> usize {
        (self.mechanism.parts.iter())
            .position(|entry| entry.part.name() == name)
            .unwrap()
    }

    /// Where a part is from where it is drawn: its coordinates.
    fn at(&self, name: &str) -> &[f64] {
        let part = self.part(name);
        &self.hand.state()[self.hand.system().parts()[part].indices()]
    }

    /// How much smaller parts are than drawn, together.
    fn gap(&self) -> f64 {
        self.hand.gaps().iter().map(|gap| gap.gap).sum()
    }

    /// Puts all parts where they are drawn.
    fn back(&mut self) {
        let count = self.hand.state().len();
        self.hand.set_state(&vec![0.0; count]).unwrap();
        assert!(
            self.hand.overlapping().is_empty(),
            "{:?}",
            self.hand.overlapping()
        );
    }

    /// A point of a part.
    fn grip(&mut self, part: usize) -> Point {
        let outline: &Part = &self.mechanism.parts[part].part;
        let bounds = outline.bounds();
        loop {
            let x = self.dice.between(bounds.min.x, bounds.max.x);
            let y = self.dice.between(bounds.min.y, bounds.max.y);
            if outline.contains(Point::new(x, y)) {
                return Point::new(x, y);
            }
        }
    }

    /// Drags a point of a part a way in a direction, and judges all places on the way; its description.
    fn drag(&mut self, part: usize, of: Point, way: f64, direction: f64) -> String {
        let from = self.hand.placement(part).unwrap().point([of.x, of.y]);
        let (sin, cos) = direction.sin_cos();
        let to = Point::new(from[0] + way * cos, from[1] + way * sin);
        let name = self.mechanism.parts[part].part.name();
        let told = format!("{name} by {of:?} to {to:?} from {:?}", self.hand.state());
        let began = Instant::now();
        let dragged = self.hand.drag(part, Target::Point { of, to }).unwrap();
        let took = began.elapsed();
        self.spent += took;
        self.longest = self.longest.max(took);
        self.snaps += dragged.snaps.len();
        self.unfinished += usize::from(dragged.ending == Ending::Unfinished);
        self.lost += usize::from(matches!(dragged.ending, Ending::Lost(_)));
        if std::env::var("SHOW").is_ok() {
            let stopped = dragged.stopped_by.first().map(|s| s.what.to_string());
            eprintln!(
                "{told}\n    {took:?} {:?} {:?} {stopped:?} {:?}",
                dragged.ending,
                dragged.snaps,
                self.hand.state()
            );
        }
        assert!(
            dragged.overlapping.is_empty(),
            "{told}: {:?}",
            dragged.overlapping
        );
        assert_eq!(dragged.way.last().unwrap(), self.hand.state(), "{told}");
        for ends in dragged.way.windows(2) {
            self.judge_between(&ends[0], &ends[1], &told);
        }
        // What was reached is no overlap when it is set.
        let reached = self.hand.state().to_vec();
        self.hand.set_state(&reached).unwrap();
        assert!(
            self.hand.overlapping().is_empty(),
            "{told}: {:?}",
            self.hand.overlapping()
        );
        told
    }

    /// Judges two states of the way and what is between them.
    fn judge_between(&self, from: &[f64], to: &[f64], told: &str) {
        let system = self.hand.system();
        let far = (from.iter().zip(to).zip(system.lengths()))
            .fold(0.0_f64, |far, ((a, b), length)| {
                far.max((a - b).abs() * length)
            });
        let steps = (far / (STEP * system.size())).ceil().max(1.0) as usize;
        for k in 1..=steps {
            let share = k as f64 / steps as f64;
            let q: Vec<f64> = (from.iter().zip(to))
                .map(|(a, b)| a + share * (b - a))
                .collect();
            let q = if k == steps { to } else { &q };
            for (fixed, moving, oracle) in &self.pairs {
                let verdict = oracle.judge(system.relative(*fixed, *moving, q));
                let deep = if k == steps {
                    CONTACT * oracle.size()
                } else {
                    CHORD * far
                };
                // Corners come farther out by the gap than edges.
                let allowed = deep + 2.0 * self.gap();
                let name = |i: usize| self.mechanism.parts[i].part.name();
                assert!(
                    !verdict.overlap || verdict.margin < allowed,
                    "{told}: {} and {} overlap by {:e} (allowed {allowed:e}), {share} of the way from {from:?} to {to:?}",
                    name(*fixed),
                    name(*moving),
                    verdict.margin,
                );
            }
        }
    }

    /// Drags random parts by random points, 1 to `most` far, a few times from where parts are drawn; `check` looks at each.
    fn run(&mut self, count: usize, most: f64, check: impl Fn(&Self, &str)) {
        let parts: Vec<usize> = (0..self.mechanism.parts.len())
            .filter(|&i| self.hand.system().parts()[i] != PartCoordinates::Fixed)
            .collect();
        for k in 0..count {
            if k % 10 == 0 {
                self.back();
            }
            let pick = (self.dice.roll() * parts.len() as f64) as usize;
            let part = parts[pick.min(parts.len() - 1)];
            let of = self.grip(part);
            let way = most.powf(self.dice.roll());
            let direction = self.dice.between(0.0, TAU);
            let told = self.drag(part, of, way, direction);
            check(self, &told);
        }
        eprintln!(
            "{}: {count} drags, {:.1?} each, {:.1?} the longest; {} snaps, {} unfinished, {} lost",
            self.mechanism.name,
            self.spent / count as u32,
            self.longest,
            self.snaps,
            self.unfinished,
            self.lost,
        );
    }
}

/// A model without what pushes its parts.
fn unloaded(name: &str) -> Mechanism {
    let mut mechanism = model(name);
    mechanism.dynamics.springs.clear();
    mechanism.dynamics.loads.clear();
    mechanism.dynamics.gravity = cspace::Vector::new(0.0, 0.0);
    mechanism
}

/// The bolt fills its keeper and lies on the lid, which lies on the block: they stay as long as it is over the lid, but for the gap.
#[test]
fn a_bolt_holds_what_it_locks() {
    let mut drags = Drags::new(unloaded("latch_box"), 1);
    let [gap] = drags.hand.gaps() else {
        panic!("{:?}", drags.hand.gaps())
    };
    assert_eq!(gap.part, "bolt");
    let gap = gap.gap;
    assert!(gap < 2e-4, "{gap}");
    let held = Cell::new(0);
    let count = effort(50, 1000);
    drags.run(count, 100.0, |drags, told| {
        // Its flat lower side is over that of the lid, which ends at 77 or 1 less, and its upper one in all of the keeper.
        if !(-10.0..6.0).contains(&drags.at("bolt")[0]) {
            return;
        }
        held.set(held.get() + 1);
        // The lid turns about the lip as the bolt tilts.
        for name in ["block", "lid", "bolt"] {
            let [_, y, theta] = *drags.at(name) else {
                panic!("{name} moves in the plane")
            };
            assert!(
                y.abs() < 50.0 * gap && theta.abs() < 5.0 * gap,
                "{told}: {name} at {y}, {theta}"
            );
        }
    });
    assert!(
        held.get() > count / 2,
        "it holds in {} of {count}",
        held.get()
    );
    // Drawn out it lets them go.
    drags.back();
    let (bolt, lid) = (drags.part("bolt"), drags.part("lid"));
    for _ in 0..20 {
        drags.drag(bolt, Point::new(96.0, 43.0), 5.0, 0.0);
    }
    assert!(drags.at("bolt")[0] > 11.0, "{:?}", drags.at("bolt"));
    for _ in 0..5 {
        drags.drag(lid, Point::new(76.0, 37.0), 5.0, FRAC_PI_2);
    }
    assert!(drags.at("lid")[2] > 0.1, "{:?}", drags.at("lid"));
}

/// A spring draws the bolt out of its keeper, not through it.
#[test]
fn springs_draw_a_bolt_out_of_its_keeper() {
    let mut drags = Drags::new(model("latch_box"), 2);
    drags.run(effort(20, 300), 100.0, |_, _| ());
}

#[test]
fn models_are_dragged_about() {
    for (name, most) in [
        ("shift_interlock", 30.0),
        ("snap_in", 30.0),
        ("ratchet_mechanism", 30.0),
        ("knee", 30.0),
        ("peg_hole", 50.0),
    ] {
        let mut drags = Drags::new(model(name), 3);
        drags.run(effort(20, 300), most, |_, _| ());
    }
}
