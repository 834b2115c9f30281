//! Flood fill of (x, y, θ) in boxes that brute force proves to be free or blocked.
//!
//! A verdict with a margin holds for all configurations that move no point of the moving part farther than the margin.
//! So a box is free, blocked, or divided, down to a smallest size. Free boxes that touch are of one region; regions
//! between which all boxes are blocked are separate. Between these two cases the space is too narrow for the boxes.

mod inside;

use std::collections::{BTreeMap, BTreeSet};

use cspace::{Configuration, Edge, Part, Point, Rotation, Vector};

use crate::families::Case;
use crate::judge::Oracle;

use inside::Inside;

/// Number of boxes asked about in each set of free boxes, and one in [`SHARE`] of the others.
const ASKED: u32 = 64;
const SHARE: u32 = 512;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Found {
    Free,
    Blocked,
    Unknown,
}

/// The boxes of a pair: x and y of the moving part's middle about that of the fixed part, and θ.
#[derive(Debug, Clone)]
pub struct Fill {
    oracle: Oracle,
    inside: Inside,
    /// Half the side of the square of positions. Beyond it the parts are apart.
    half: f64,
    /// The farthest point of the moving part from its middle.
    arm: f64,
    theta: (f64, f64),
    full_turn: bool,
    /// Least boxes along an axis.
    n: usize,
    boxes: Vec<Found>,
}

/// Comparison of the boxes with the free regions found by another method.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Compared {
    /// Contradictions.
    pub wrong: Vec<String>,
    /// Number of configurations asked.
    pub configurations: usize,
    /// Sets of boxes that are free or may be, apart from each other, in which some are free: there are at least as many regions.
    pub least: usize,
    /// Sets with free boxes in which all free boxes are of one region.
    pub known: usize,
    /// Sets of boxes without any that is known to be free: each may be a region, or none.
    pub open: usize,
}

impl Compared {
    /// Whether the boxes determine the number of regions, except for pockets smaller than a box.
    pub fn is_settled(&self) -> bool {
        self.known == self.least && self.open == 0
    }
}

/// Largest distance of a point of the part from its middle.
fn reach(part: &Part, middle: Point) -> f64 {
    let far = |e: Edge| {
        let ends = e.start.distance(middle).max(e.end.distance(middle));
        if e.is_line() {
            return ends;
        }
        let by_centre = e.center().distance(middle) + e.radius();
        by_centre.min(ends + 0.5 * e.length())
    };
    part.edges().map(far).fold(0.0, f64::max)
}

impl Fill {
    /// The boxes of a pair over orientations from `lo` to `hi`, divided `depth` times: 2 to the power of that along each axis.
    pub fn new(case: &Case, (lo, hi): (f64, f64), full_turn: bool, depth: u32) -> Self {
        let oracle = Oracle::new(&case.fixed, &case.moving);
        let n = 1 << depth;
        let arm = reach(&case.moving, oracle.moving_center());
        let mut fill = Self {
            inside: Inside::new(&oracle, n),
            half: 1.01 * (arm + reach(&case.fixed, oracle.fixed_center())),
            oracle,
            arm,
            theta: (lo, hi),
            full_turn,
            n,
            boxes: vec![Found::Unknown; n * n * n],
        };
        fill.divide([0; 3], n);
        fill
    }

    /// The moving part's middle from the fixed one's, and θ.
    fn place(&self, [x, y, t]: [f64; 3]) -> (Vector, f64) {
        let at = |s: f64| self.half * (2.0 * s - 1.0);
        let theta = self.theta.0 + t * (self.theta.1 - self.theta.0);
        (Vector::new(at(x), at(y)), theta)
    }

    fn configuration(&self, at: [f64; 3]) -> Configuration {
        let (shift, theta) = self.place(at);
        let turned = Rotation::by(theta) * self.oracle.moving_center().to_vector();
        let p = self.oracle.fixed_center() + shift + -turned;
        Configuration::new(p.x, p.y, theta)
    }

    /// The middle of a box, in parts of the whole.
    fn middle(&self, corner: [usize; 3], size: usize) -> [f64; 3] {
        corner.map(|c| (c as f64 + 0.5 * size as f64) / self.n as f64)
    }

    /// The middle of a box by its number.
    fn middle_of(&self, b: usize) -> Configuration {
        let n = self.n;
        self.configuration(self.middle([b / (n * n), b / n % n, b % n], 1))
    }

    fn divide(&mut self, corner: [usize; 3], size: usize) {
        let half = 0.5 * size as f64 / self.n as f64;
        let moves = 2.0 * self.half * half * core::f64::consts::SQRT_2
            + (self.theta.1 - self.theta.0) * half * self.arm;
        if let Some(found) = self.found(self.middle(corner, size), 1.001 * moves) {
            let [i, j, k] = corner;
            for (i, j) in (i..i + size).flat_map(|i| (j..j + size).map(move |j| (i, j))) {
                let row = (i * self.n + j) * self.n + k;
                self.boxes[row..row + size].fill(found);
            }
        } else if size > 1 {
            let half = size / 2;
            for n in 0..8 {
                self.divide([0, 1, 2].map(|d| corner[d] + half * (n >> d & 1)), half);
            }
        }
    }

    /// Class shared by all configurations at which no point of the moving part is farther than `moves` from its
    /// position at this one; `None` if they differ or it is unknown.
    fn found(&self, at: [f64; 3], moves: f64) -> Option<Found> {
        let (shift, theta) = self.place(at);
        if self.inside.overlaps(theta.sin_cos(), shift, moves) {
            return Some(Found::Blocked);
        }
        let verdict = self.oracle.judge(self.configuration(at));
        (verdict.margin > moves).then_some(if verdict.overlap {
            Found::Blocked
        } else {
            Found::Free
        })
    }

    /// Numbers the connected components of the boxes of some classes, and returns their count; boxes at the border of
    /// the positions are connected outside.
    fn components(&self, through: impl Fn(Found) -> bool) -> (Vec<u32>, u32) {
        const NONE: u32 = u32::MAX;
        let n = self.n;
        let mut number = vec![NONE; n * n * n];
        let mut next = 1;
        let mut stack = Vec::new();
        let border = (0..n * n * n).filter(|b| {
            let (i, j) = (b / (n * n), b / n % n);
            i == 0 || j == 0 || i == n - 1 || j == n - 1
        });
        for b in border {
            if through(self.boxes[b]) {
                number[b] = 0;
                stack.push(b);
            }
        }
        for first in 0..=n * n * n {
            while let Some(b) = stack.pop() {
                let at = [b / (n * n), b / n % n, b % n];
                for d in 0..3 {
                    for step in [n - 1, 1] {
                        let mut beside = at;
                        beside[d] = (at[d] + step) % n;
                        let wraps = beside[d].abs_diff(at[d]) > 1;
                        let c = (beside[0] * n + beside[1]) * n + beside[2];
                        let there = !wraps || (d == 2 && self.full_turn);
                        if there && number[c] == NONE && through(self.boxes[c]) {
                            number[c] = number[b];
                            stack.push(c);
                        }
                    }
                }
            }
            if first < n * n * n && number[first] == NONE && through(self.boxes[first]) {
                number[first] = next;
                next += 1;
                stack.push(first);
            }
        }
        (number, next)
    }

    /// Compares the boxes with free regions, of which number 0 is the outer one, as found by another method;
    /// `region_at` is that method's region of a configuration.
    pub fn compare(
        &self,
        regions: usize,
        region_at: impl Fn(Configuration) -> Option<u32>,
    ) -> Compared {
        let (joined, sets) = self.components(|b| b == Found::Free);
        let (perhaps, separate) = self.components(|b| b != Found::Blocked);
        let free = || (0..self.boxes.len()).filter(|&b| self.boxes[b] == Found::Free);
        let mut wrong = Vec::new();
        // Regions in the sets of free boxes, and for each region the sets that are not joined.
        let mut regions_of = vec![BTreeSet::new(); sets as usize];
        let mut places_of: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
        let mut seen = vec![0_u32; sets as usize];
        let mut configurations = 0;
        for b in free() {
            // Some of each set; of a small one all.
            let set = joined[b] as usize;
            seen[set] += 1;
            let chosen = (b as u32).wrapping_mul(2_654_435_761);
            if seen[set] > ASKED && !chosen.is_multiple_of(SHARE) {
                continue;
            }
            configurations += 1;
            let c = self.middle_of(b);
            match region_at(c) {
                Some(region) => {
                    regions_of[set].insert(region);
                    places_of.entry(region).or_default().insert(perhaps[b]);
                }
                None => wrong.push(format!("not free: {c:?}")),
            }
        }
        for regions in regions_of.iter().filter(|r| r.len() > 1) {
            wrong.push(format!("one motion leads through regions {regions:?}"));
        }
        for (region, places) in places_of.iter().filter(|p| p.1.len() > 1) {
            let n = places.len();
            wrong.push(format!("nothing joins {n} places of region {region}"));
        }
        if regions_of[0].first() != Some(&0) {
            wrong.push(format!("outside is {:?}", regions_of[0]));
        }
        // Connected sets of free boxes in each set of boxes that may be free. If there is one, no region is missing
        // there, nor is there one too many.
        let mut of = vec![BTreeSet::new(); separate as usize];
        for b in free() {
            of[perhaps[b] as usize].insert(joined[b]);
        }
        let count = |f: fn(usize) -> bool| of.iter().filter(|sets| f(sets.len())).count();
        let least = count(|n| n > 0);
        if regions < least {
            wrong.push(format!("{regions} regions instead of at least {least}"));
        }
        Compared {
            wrong,
            configurations,
            least,
            known: count(|n| n == 1),
            open: count(|n| n == 0),
        }
    }
}
