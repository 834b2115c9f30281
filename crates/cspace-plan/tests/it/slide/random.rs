//! Parts dragged about at random.

use cspace::{Classification, Coordinates, PairSpace};
use cspace_oracle::{Oracle, effort};
use cspace_plan::slide::Slider;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::slide::models::all;
use crate::slide::weighted::Weighted;

const STEPS: usize = 15;
const DIRECTIONS: usize = 200;
/// How far aside it is tried (share of the pair's size). What is left to go is known to a thousandth of the whole way.
const ASIDE: [f64; 2] = [1e-2, 1e-3];
const KNOWN: f64 = 1e-3;
/// How much nearer to the goal that may lead, as a share: less is what curved surfaces do at a second look.
const GAIN: f64 = 0.25;

pub(crate) struct Pair<'a> {
    space: &'a PairSpace,
    slider: Slider<'a>,
    pub(crate) weighted: Weighted<'a>,
    oracle: Oracle,
}

impl<'a> Pair<'a> {
    pub(crate) fn new(space: &'a PairSpace) -> Self {
        Self {
            space,
            slider: Slider::new(space),
            weighted: Weighted::new(space),
            oracle: Oracle::new(space.fixed(), space.moving()),
        }
    }

    pub(crate) fn free(&self, rng: &mut ChaCha8Rng) -> Coordinates {
        loop {
            let at = self.weighted.anywhere(rng);
            if self.space.classify(at).unwrap() == Classification::Free {
                return at;
            }
        }
    }

    /// One motion, which ends no farther from the goal than it began, and not blocked: by the space, and by the drawing.
    fn slide(&self, from: Coordinates, goal: Coordinates) -> Coordinates {
        let at = self.slider.slide(from, goal).unwrap().at;
        assert_ne!(
            self.space.classify(at).unwrap(),
            Classification::Blocked,
            "from {from:?} to {goal:?}: {at:?}"
        );
        let placed = match (self.space, at) {
            (PairSpace::FixedAxes(space), Coordinates::Axes { u, v }) => space.configuration(u, v),
            (_, Coordinates::Planar(c)) => c,
            _ => panic!("another class"),
        };
        let verdict = self.oracle.judge(placed);
        assert!(
            !verdict.overlap || verdict.margin < 4.0 * self.space.resolution(),
            "from {from:?} to {goal:?}: {at:?} overlaps by {}",
            verdict.margin
        );
        let (before, after) = (
            self.weighted.apart(from, goal),
            self.weighted.apart(at, goal),
        );
        assert!(
            after <= before * (1.0 + 1e-12),
            "from {from:?} to {goal:?}: {at:?} is {after} from it, not {before}"
        );
        at
    }

    /// Dragged to the goal in steps, and there once more.
    fn dragged(&self, from: Coordinates, goal: Coordinates) -> Coordinates {
        let mut at = from;
        let g = self.weighted.vector(goal);
        for i in 1..=STEPS {
            let a = self.weighted.vector(at);
            let left = (STEPS + 1 - i) as f64;
            let next = core::array::from_fn(|k| a[k] + (g[k] - a[k]) / left);
            at = self.slide(at, self.weighted.configuration(next));
        }
        for _ in 0..8 {
            at = self.slide(at, goal);
        }
        at
    }

    /// A free configuration that a straight motion leads to, nearer to the goal; `None` if none is found.
    fn nearer(
        &self,
        at: Coordinates,
        goal: Coordinates,
        rng: &mut ChaCha8Rng,
    ) -> Option<Coordinates> {
        let a = self.weighted.vector(at);
        let away = self.weighted.apart(at, goal);
        for size in ASIDE {
            if size > away || size < 2.0 * KNOWN * away {
                continue;
            }
            for _ in 0..DIRECTIONS {
                let d = self.weighted.moves().map(|moves| match moves {
                    true => normal(rng),
                    false => 0.0,
                });
                let long = d.iter().map(|x| x * x).sum::<f64>().sqrt();
                let to = core::array::from_fn(|i| a[i] + d[i] / long * size);
                let to = self.weighted.configuration(to);
                if away - self.weighted.apart(to, goal) < GAIN * size {
                    continue;
                }
                let class = self.space.classify(to);
                if class == Ok(Classification::Free)
                    && self.slider.advance(at, to).unwrap().stopped.is_none()
                {
                    return Some(to);
                }
            }
        }
        None
    }
}

fn normal(rng: &mut ChaCha8Rng) -> f64 {
    let (a, b): (f64, f64) = (rng.random(), rng.random());
    (-2.0 * (1.0 - a).ln()).sqrt() * (core::f64::consts::TAU * b).cos()
}

#[test]
fn where_a_dragged_part_stays_no_straight_motion_leads_nearer() {
    let mut stuck = Vec::new();
    let (mut held, mut dragged) = (0, 0);
    for (name, space) in all() {
        let pair = Pair::new(&space);
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        for _ in 0..effort(4, 12) {
            let from = pair.free(&mut rng);
            let goal = pair.weighted.within(pair.weighted.anywhere(&mut rng));
            let at = pair.dragged(from, goal);
            dragged += 1;
            if space.classify(at).unwrap() != Classification::Contact {
                continue;
            }
            held += 1;
            if let Some(to) = pair.nearer(at, goal, &mut rng) {
                stuck.push(format!(
                    "{name}: from {from:?} to {goal:?} it sticks at {at:?}: {to:?} is free"
                ));
            }
        }
    }
    assert!(4 * held > dragged, "{held} of {dragged}");
    assert!(stuck.is_empty(), "{stuck:#?}");
}
