//! Free regions against a flood fill of (x, y, θ) in boxes of which brute force proves that they are free or blocked.
//!
//! A verdict of the oracle with a margin holds for all configurations that take no point of the moving part further than
//! that. So a box is free, blocked, or divided, down to a least size. Free boxes that touch are of one region; regions
//! between which all boxes are blocked are two. What is between the two answers is too narrow for the boxes.
#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};

use cspace::{Configuration, ContactSpace, Edge, Options, Part, Point, Rotation, Vector, Window};
use cspace_oracle::{Case, Oracle, families, pairs};
use rayon::prelude::*;

/// Boxes are divided so often: 64 along x, y and θ, and 256 where that is enough to know the number of regions. 32 in
/// families beyond their first values, where the clearance is less than any box anyway.
const DEPTH: u32 = 6;
const FINE_DEPTH: u32 = 8;
const ROUGH_DEPTH: u32 = 5;

/// Pairs of which the boxes tell how many regions there are.
const WIDE: [(&str, usize); 8] = [
    ("annuli", 2),
    ("ball caged in a C", 2),
    ("disc in a hole, clearance 0.1", 2),
    ("disc in annulus", 2),
    ("peg over a plate with holes, holes a side 1", 2),
    ("plate with a hole and a smaller part, ratio 1", 2),
    ("ring about an island", 2),
    ("square in a nearly full hole", 2),
];

/// Larger pairs take the oracle too long.
const MOST_EDGES: usize = 24;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Box3 {
    Free,
    Blocked,
    Unknown,
}

/// The boxes of a pair: x and y of the moving part's middle about that of the fixed part, and θ.
struct Fill {
    oracle: Oracle,
    /// Half the side of the square of positions. Beyond it the parts are apart.
    half: f64,
    /// The farthest point of the moving part from its middle.
    arm: f64,
    theta: (f64, f64),
    full_turn: bool,
    /// Least boxes along an axis.
    n: usize,
    boxes: Vec<Box3>,
}

/// No point of the part is farther from its middle.
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
    fn new(case: &Case, window: Window, depth: u32) -> Self {
        let oracle = Oracle::new(&case.fixed, &case.moving);
        let n = 1 << depth;
        let arm = reach(&case.moving, oracle.moving_center());
        let mut fill = Self {
            half: 1.01 * (arm + reach(&case.fixed, oracle.fixed_center())),
            oracle,
            arm,
            theta: (window.lo, window.hi),
            full_turn: window.full_turn,
            n,
            boxes: vec![Box3::Unknown; n * n * n],
        };
        fill.divide([0; 3], n);
        fill
    }

    fn configuration(&self, [x, y, t]: [f64; 3]) -> Configuration {
        let at = |s: f64| self.half * (2.0 * s - 1.0);
        let theta = self.theta.0 + t * (self.theta.1 - self.theta.0);
        let turned = Rotation::by(theta) * self.oracle.moving_center().to_vector();
        let p = self.oracle.fixed_center() + Vector::new(at(x), at(y)) + -turned;
        Configuration::new(p.x, p.y, theta)
    }

    fn middle(&self, corner: [usize; 3], size: usize) -> Configuration {
        self.configuration(corner.map(|c| (c as f64 + 0.5 * size as f64) / self.n as f64))
    }

    fn divide(&mut self, corner: [usize; 3], size: usize) {
        let half = 0.5 * size as f64 / self.n as f64;
        let moves = 2.0 * self.half * half * core::f64::consts::SQRT_2
            + (self.theta.1 - self.theta.0) * half * self.arm;
        let verdict = self.oracle.judge(self.middle(corner, size));
        if verdict.margin > 1.001 * moves {
            let found = if verdict.overlap {
                Box3::Blocked
            } else {
                Box3::Free
            };
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

    /// The boxes that can be reached from each other through such ones, by number, and how many such sets; those at the
    /// border of the positions hang together outside.
    fn components(&self, through: impl Fn(Box3) -> bool) -> (Vec<u32>, u32) {
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
}

/// What is wrong, and how many configurations were asked.
fn compare(name: &str, case: &Case, depth: u32) -> (Vec<String>, usize) {
    let options = Options {
        window: case.window,
        ..Options::default()
    };
    let space = ContactSpace::compute(&case.fixed, &case.moving, &options).unwrap();
    let wide = WIDE.iter().find(|w| w.0 == name);
    let depth = if wide.is_some() { FINE_DEPTH } else { depth };
    let fill = Fill::new(case, space.window(), depth);
    let n = fill.n;
    let (joined, sets) = fill.components(|b| b == Box3::Free);
    let (perhaps, separate) = fill.components(|b| b != Box3::Blocked);
    let mut wrong = Vec::new();
    // What regions the space has in sets of free boxes, and in which sets that nothing joins each region is.
    let mut regions_of = vec![BTreeSet::new(); sets as usize];
    let mut places_of: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    let mut seen = vec![0_u32; sets as usize];
    let mut configurations = 0;
    for b in (0..n * n * n).filter(|&b| fill.boxes[b] == Box3::Free) {
        // Some of each set; of a small one all.
        let set = joined[b] as usize;
        seen[set] += 1;
        if seen[set] > 64 && !(b as u32).wrapping_mul(2_654_435_761).is_multiple_of(512) {
            continue;
        }
        configurations += 1;
        let c = fill.middle([b / (n * n), b / n % n, b % n], 1);
        match space.region_at(c) {
            Some(region) => {
                regions_of[set].insert(region);
                places_of.entry(region).or_default().insert(perhaps[b]);
            }
            None => wrong.push(format!("{name}: not free: {c:?}")),
        }
    }
    for regions in regions_of.iter().filter(|r| r.len() > 1) {
        wrong.push(format!(
            "{name}: one motion leads through regions {regions:?}"
        ));
    }
    for (region, places) in places_of.iter().filter(|p| p.1.len() > 1) {
        let n = places.len();
        wrong.push(format!(
            "{name}: nothing joins {n} places of region {region}"
        ));
    }
    if regions_of[0].first() != Some(&0) {
        wrong.push(format!("{name}: outside is {:?}", regions_of[0]));
    }
    // What may be joined to a set and is free is all of it: no region is missing there, nor is there one too many.
    let mut of = vec![BTreeSet::new(); separate as usize];
    for b in (0..n * n * n).filter(|&b| fill.boxes[b] == Box3::Free) {
        of[perhaps[b] as usize].insert(joined[b]);
    }
    let known = of.iter().filter(|sets| sets.len() == 1).count();
    let regions = space.free_regions().len();
    if let Some(&(_, expected)) = wide
        && (regions != expected || known != expected)
    {
        wrong.push(format!(
            "{name}: {regions} regions, and {known} by the boxes, instead of {expected}"
        ));
    }
    (wrong, configurations)
}

/// Single pairs, and all values of all families.
fn cases() -> Vec<(String, Case, u32)> {
    let named = pairs().into_iter().map(|p| {
        let case = Case {
            fixed: p.fixed,
            moving: p.moving,
            window: None,
            notable: Vec::new(),
        };
        (p.name, case, DEPTH)
    });
    let of_families = families().into_iter().flat_map(|f| {
        let values = f.values.clone().into_iter().enumerate();
        values.filter_map(move |(i, value)| {
            let depth = if i == 0 { DEPTH } else { ROUGH_DEPTH };
            Some((format!("{} {value}", f.name), f.build(value).ok()?, depth))
        })
    });
    named
        .chain(of_families)
        .filter(|(_, c, _)| c.fixed.edges().count() + c.moving.edges().count() <= MOST_EDGES)
        .collect()
}

#[test]
fn free_regions_agree_with_a_flood_fill() {
    let cases = cases();
    for (name, _) in WIDE {
        assert!(cases.iter().any(|c| c.0 == name), "no pair is named {name}");
    }
    let compared: Vec<(Vec<String>, usize)> = cases
        .par_iter()
        .map(|(name, case, depth)| compare(name, case, *depth))
        .collect();
    let wrong: Vec<&String> = compared.iter().flat_map(|c| c.0.iter().take(3)).collect();
    let asked: usize = compared.iter().map(|c| c.1).sum();
    println!("{} pairs, {asked} configurations", cases.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(cases.len() > 300 && asked > 20_000, "{asked}");
}
