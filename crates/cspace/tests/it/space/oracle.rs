//! Contact spaces compared with brute force: every configuration must be classified according to the parts' overlap.
//!
//! The oracle does not use contact curves: it cuts the boundaries of the two placed parts where they meet and determines on which side the
//! pieces lie. A disagreement counts if the oracle's margin exceeds 1e-10 of the pair's size.

use core::f64::consts::{PI, TAU};

use cspace::{Configuration, ContactSpace, Edge, Options, Part, PatchId, Point, Slice, Vector};
use cspace_oracle::{Oracle, Pair, effort, near_contact_about, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::{LARGEST, SPACES};

/// Minimum margin of an oracle's verdict for it to count, as a share of the size.
const CERTAIN: f64 = 1e-10;

/// Distances from contact, as shares of the size.
const STEPS: [f64; 6] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Positions of each kind at each orientation.
const FAR: usize = 15;
const NEAR: usize = 10;
const TOUCHING: usize = 10;
/// Configurations near contact that are found by searching along random motions.
const SEARCHED: usize = 20;

#[derive(Default)]
struct Tally {
    asked: usize,
    certain: usize,
    near: usize,
    free: usize,
    wrong: Vec<String>,
}

struct Trial<'a> {
    pair: &'a Pair,
    space: &'a ContactSpace,
    oracle: Oracle,
    rng: ChaCha8Rng,
    tally: Tally,
}

impl Trial<'_> {
    fn ask(&mut self, slice: &Slice, position: Point, near: bool) {
        let c = Configuration::new(position.x, position.y, slice.theta);
        let verdict = self.oracle.judge(c);
        self.tally.asked += 1;
        if verdict.margin <= CERTAIN * self.oracle.size() {
            return;
        }
        self.tally.certain += 1;
        self.tally.near += usize::from(near);
        self.tally.free += usize::from(!verdict.overlap);
        if slice.is_free(position) == verdict.overlap {
            self.tally
                .wrong
                .push(format!("{}: {c:?} {verdict:?}", self.pair.name));
        }
    }

    /// All orientations, and every other one near one of the pair's notable configurations.
    fn orientation(&mut self, i: usize) -> f64 {
        let notable = &self.pair.notable;
        if i % 2 == 1 && !notable.is_empty() {
            let about = notable[i / 2 % notable.len()].theta;
            return about + 10f64.powf(self.rng.random_range(-8.0..0.0)) * self.sign();
        }
        let near_critical = i % 4 == 2;
        let criticals = self.space.critical_orientations();
        if near_critical && !criticals.is_empty() {
            let about = criticals[self.rng.random_range(0..criticals.len())];
            return about + 10f64.powf(self.rng.random_range(-7.0..-3.0)) * self.sign();
        }
        self.rng.random_range(-PI..PI)
    }

    fn sign(&mut self) -> f64 {
        if self.rng.random_bool(0.5) { 1.0 } else { -1.0 }
    }

    fn step(&mut self) -> f64 {
        STEPS[self.rng.random_range(0..STEPS.len())] * self.sign() * self.oracle.size()
    }

    /// Positions anywhere the parts may meet, half of them near a notable one.
    fn far(&mut self, slice: &Slice) {
        let size = self.oracle.size();
        let middle = carrying(
            self.oracle.moving_center(),
            self.oracle.fixed_center(),
            slice.theta,
        );
        for k in 0..FAR {
            let (about, reach) = if k % 2 == 1 && !self.pair.notable.is_empty() {
                let n = self.rng.random_range(0..self.pair.notable.len());
                let reach = 10f64.powf(self.rng.random_range(-6.0..0.0));
                (self.pair.notable[n].position(), reach)
            } else {
                (middle, 1.0)
            };
            let mut share = || reach * size * self.rng.random_range(-1.0..1.0);
            let p = about + Vector::new(share(), share());
            self.ask(slice, p, false);
        }
    }

    /// Positions beside the curves of the slice.
    fn beside_curves(&mut self, slice: &Slice) {
        if slice.curves.is_empty() {
            return;
        }
        for _ in 0..NEAR {
            let curve = slice.curves[self.rng.random_range(0..slice.curves.len())].geometry;
            let s = self.rng.random_range(0.0..1.0);
            let offset = curve.free_normal(s) * self.step();
            if offset.length().is_finite() {
                self.ask(slice, curve.point(s) + offset, true);
            }
        }
    }

    /// Positions in which a corner of one part is beside an edge of the other, found without the space.
    fn beside_contacts(&mut self, slice: &Slice) {
        for _ in 0..TOUCHING {
            let on_fixed = self.rng.random_bool(0.5);
            let (u, v) = (self.rng.random_range(0.0..1.0), 0.0);
            let (u, v) = if on_fixed { (u, v) } else { (v, u) };
            let e = some_edge(&self.pair.fixed, &mut self.rng);
            let f = some_edge(&self.pair.moving, &mut self.rng);
            let touching = carrying(f.at(v), e.at(u), slice.theta);
            let normal = if on_fixed {
                e.direction_at(u).right()
            } else {
                let c = Configuration::new(0.0, 0.0, slice.theta);
                let n = f.direction_at(v).left();
                let (o, q) = (c.fixed_from_moving(Point::ORIGIN), Point::ORIGIN + n);
                c.fixed_from_moving(q) - o
            };
            let p = touching + normal * self.step();
            self.ask(slice, p, true);
        }
    }
}

fn some_edge(part: &Part, rng: &mut ChaCha8Rng) -> Edge {
    let n = part.edges().count();
    part.edges().nth(rng.random_range(0..n)).unwrap()
}

/// The position that moves a point of the moving part to one of the fixed part.
fn carrying(q: Point, to: Point, theta: f64) -> Point {
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(q);
    Point::ORIGIN + (to - turned)
}

fn try_pair(pair: &Pair, space: &ContactSpace, orientations: usize) -> (Tally, String) {
    let mut trial = Trial {
        pair,
        space,
        oracle: Oracle::new(&pair.fixed, &pair.moving),
        rng: ChaCha8Rng::seed_from_u64(7),
        tally: Tally::default(),
    };
    for i in 0..orientations {
        let theta = trial.orientation(i);
        let slice = space.slice(theta);
        trial.far(&slice);
        trial.beside_curves(&slice);
        trial.beside_contacts(&slice);
    }
    let Trial {
        oracle,
        mut rng,
        mut tally,
        ..
    } = trial;
    for near in near_contact_about(&oracle, &pair.notable, &mut rng, SEARCHED) {
        let c = near.configuration;
        tally.asked += 1;
        if near.verdict.margin <= CERTAIN * oracle.size() {
            continue;
        }
        tally.certain += 1;
        tally.near += 1;
        tally.free += usize::from(near.free);
        if space.slice(c.theta).is_free(c.position()) != near.free {
            tally.wrong.push(format!(
                "{}: {c:?} free={} step={} {:?}",
                pair.name, near.free, near.step, near.verdict
            ));
        }
    }
    let conflicts = space.statistics().conflicts;
    if conflicts > 0 && pair.name != CONTRADICTORY {
        tally
            .wrong
            .push(format!("{}: {conflicts} conflicts", pair.name));
    }
    let line = format!(
        "{:42} {:5} asked {:5} certain {:5} near {:5} free {:3} wrong; {conflicts} conflicts, {} regions",
        pair.name,
        tally.asked,
        tally.certain,
        tally.near,
        tally.free,
        tally.wrong.len(),
        space.free_regions().len(),
    );
    (tally, line)
}

/// Known gap: ends of arcs lie on their circles only up to 10⁻³², and two circles that almost coincide after grazing cross at an angle of
/// 10⁻¹² there; the resulting error is 10⁻²⁰, while events are 10⁻²² rad apart. Its orientations are doubtful, its answers are right.
const CONTRADICTORY: &str = "half disc in socket of equal radius";

#[test]
fn spaces_agree_with_brute_force() {
    let orientations = effort(8, 60);
    let count = SPACES.len();
    assert!(count >= 60, "{count} pairs");
    let tried: Vec<(Tally, String)> = SPACES
        .par_iter()
        .map(|(pair, space)| try_pair(pair, space, orientations))
        .collect();
    let mut all = Tally::default();
    for (tally, line) in tried {
        println!("{line}");
        all.asked += tally.asked;
        all.certain += tally.certain;
        all.near += tally.near;
        all.free += tally.free;
        all.wrong.extend(tally.wrong);
    }
    println!(
        "{} pairs, {} configurations, {} certain, {} of them near contact, {} free, {} wrong",
        count,
        all.asked,
        all.certain,
        all.near,
        all.free,
        all.wrong.len()
    );
    for w in all.wrong.iter().take(60) {
        println!("{w}");
    }
    assert!(all.wrong.is_empty(), "{} wrong", all.wrong.len());
    assert!(
        all.certain >= 1400 * orientations,
        "{} certain",
        all.certain
    );
    assert!(2 * all.near >= all.certain, "{} near", all.near);
}

#[test]
#[ignore = "long: half a minute"]
fn largest_gears_agree_with_brute_force() {
    let largest = pair(LARGEST);
    let options = Options::default();
    let space = ContactSpace::compute(&largest.fixed, &largest.moving, &options).unwrap();
    let (tally, line) = try_pair(&largest, &space, 60);
    println!("{line}");
    assert!(tally.wrong.is_empty(), "{:#?}", tally.wrong);
}

/// A turn more or less is the same orientation.
#[test]
fn orientations_repeat_after_a_turn() {
    let pair = pair("random 7");
    let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for _ in 0..50 {
        let theta = rng.random_range(-PI..PI);
        let patches = |slice: &Slice| -> Vec<Option<PatchId>> {
            slice.curves.iter().map(|c| c.patch).collect()
        };
        let here = patches(&space.slice(theta));
        assert_eq!(here, patches(&space.slice(theta + TAU)));
        assert_eq!(here, patches(&space.slice(theta - 3.0 * TAU)));
    }
}
