//! Free regions of pairs on fixed axes, compared with a flood fill over a grid of (u, v).
//!
//! The fill uses only the oracle's verdicts. Two neighbours of the grid are joined if the motion between them is certainly free: a step
//! (Δu, Δv) moves no point of one part towards the other by more than the steps times the parts' reaches, and parts that move less than
//! their clearance stay free. Steps that the clearances at both ends do not cover are halved. So places that the fill joins are connected;
//! it may only miss channels that are narrow compared with its steps.

use core::f64::consts::TAU;
use std::collections::{BTreeMap, BTreeSet};

use cspace::fixed_axes::AxisMotion;
use cspace::{Axis, FixedAxesSpace, Location, Part, Point, RegionId};
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, mechanisms};
use cspace_oracle::{Oracle, effort};
use rayon::prelude::*;

/// Number of values of each coordinate.
fn count() -> usize {
    effort(180, 360)
}

/// Number of times that a step between neighbours is halved.
const HALVINGS: u32 = 6;
/// Minimum margin of an oracle's verdict for it to count, as a share of the size.
const CERTAIN: f64 = 1e-9;
/// Ratio of the clearance to the displacement by a step from which places of one region must be joined by the fill: others may be in a cusp
/// between two curves from which no step leads out.
const GENEROUS: f64 = 0.5;

/// The values of one coordinate.
struct Values {
    at: Vec<f64>,
    /// Whether the first value follows the last one.
    around: bool,
    /// Largest displacement of a point of the part per unit of the coordinate.
    reach: f64,
}

impl Values {
    fn new(part: &Part, axis: &Axis, size: f64) -> Self {
        let (lo, hi) = match (axis.motion, axis.range) {
            (AxisMotion::Fixed, _) => (0.0, 0.0),
            (_, Some(range)) => range,
            (AxisMotion::Revolute { .. }, None) => (0.1, 0.1 + TAU),
            (AxisMotion::Prismatic { .. }, None) => (-2.0 * size, 2.0 * size),
        };
        let around = axis.range.is_none() && matches!(axis.motion, AxisMotion::Revolute { .. });
        let step = (hi - lo) / count() as f64;
        let middle = |k: usize| lo + step * (k as f64 + if around { 0.0 } else { 0.5 });
        Self {
            at: match axis.motion {
                AxisMotion::Fixed => vec![0.0],
                _ => (0..count()).map(middle).collect(),
            },
            around,
            reach: match axis.motion {
                AxisMotion::Revolute { center } => farthest(part, center),
                _ => 1.0,
            },
        }
    }

    /// Largest displacement of a point of the part from one value to the next.
    fn step(&self) -> f64 {
        self.after(0)
            .map_or(0.0, |(t, _)| (t - self.at[0]) * self.reach)
    }

    /// The value after the k-th, continued past a turn, and its index.
    fn after(&self, k: usize) -> Option<(f64, usize)> {
        match self.at.get(k + 1) {
            Some(&next) => Some((next, k + 1)),
            None if self.around => Some((self.at[0] + TAU, 0)),
            None => None,
        }
    }

    /// The value before the k-th, continued past a turn, and its index.
    fn before(&self, k: usize) -> Option<(f64, usize)> {
        match k.checked_sub(1) {
            Some(j) => Some((self.at[j], j)),
            None if self.around => self.at.last().map(|t| (t - TAU, self.at.len() - 1)),
            None => None,
        }
    }
}

/// Upper bound of the distance of the part's points from a point: an arc of chord c and bulge b is within c/2 max(1, |b|) of the chord's
/// middle.
fn farthest(part: &Part, from: Point) -> f64 {
    part.edges()
        .map(|e| {
            let half = 0.5 * e.start.distance(e.end);
            let middle = e.start + (e.end - e.start) * 0.5;
            middle.distance(from) + half * e.bulge.abs().max(1.0)
        })
        .fold(0.0, f64::max)
}

struct Fill<'a> {
    space: &'a FixedAxesSpace,
    oracle: &'a Oracle,
}

impl Fill<'_> {
    /// The clearance, if the parts are certainly free of each other.
    fn clearance(&self, (u, v): (f64, f64)) -> Option<f64> {
        let verdict = self.oracle.judge(self.space.configuration(u, v));
        let certain = verdict.margin > CERTAIN * self.oracle.size();
        (certain && !verdict.overlap).then_some(verdict.margin)
    }

    /// Whether the motion from a to b is certainly free; `moved` is a bound of the displacement of any point.
    fn joined(
        &self,
        a: ((f64, f64), f64),
        b: ((f64, f64), f64),
        moved: f64,
        halvings: u32,
    ) -> bool {
        if a.1 + b.1 > moved {
            return true;
        }
        if halvings == 0 {
            return false;
        }
        let at = (0.5 * (a.0.0 + b.0.0), 0.5 * (a.0.1 + b.0.1));
        let Some(clearance) = self.clearance(at) else {
            return false;
        };
        let middle = (at, clearance);
        self.joined(a, middle, 0.5 * moved, halvings - 1)
            && self.joined(middle, b, 0.5 * moved, halvings - 1)
    }
}

fn root(of: &mut [usize], mut i: usize) -> usize {
    while of[i] != i {
        of[i] = of[of[i]];
        i = of[i];
    }
    i
}

/// Errors in the regions of a mechanism, and a line of summary.
fn compare(m: &Mechanism) -> (Vec<String>, String, usize) {
    let space = FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap();
    let oracle = Oracle::new(&m.fixed, &m.moving);
    let fill = Fill {
        space: &space,
        oracle: &oracle,
    };
    let us = Values::new(&m.fixed, &m.fixed_axis, oracle.size());
    let vs = Values::new(&m.moving, &m.moving_axis, oracle.size());
    let (rows, columns) = (us.at.len(), vs.at.len());
    let place = |i: usize| (us.at[i / columns], vs.at[i % columns]);
    let n = rows * columns;
    let clear: Vec<Option<f64>> = (0..n)
        .into_par_iter()
        .map(|i| fill.clearance(place(i)))
        .collect();
    let mut of: Vec<usize> = (0..n).collect();
    for i in 0..n {
        let Some(clearance) = clear[i] else { continue };
        let (u, v) = place(i);
        let (row, column) = (i / columns, i % columns);
        let (right, up) = (us.after(row), vs.after(column));
        let down = vs.before(column);
        let step = |du: Option<(f64, usize)>, dv: Option<(f64, usize)>| {
            let ((s, k), (t, l)) = (du?, dv?);
            let moved = (s - u).abs() * us.reach + (t - v).abs() * vs.reach;
            Some(((s, t), k * columns + l, moved))
        };
        let (still_u, still_v) = (Some((u, row)), Some((v, column)));
        let beside = [
            step(right, still_v),
            step(still_u, up),
            step(right, up),
            step(right, down),
        ];
        for (at, j, moved) in beside.into_iter().flatten() {
            let (a, b) = (root(&mut of, i), root(&mut of, j));
            let Some(there) = clear[j].filter(|_| a != b) else {
                continue;
            };
            if fill.joined(((u, v), clearance), (at, there), moved, HALVINGS) {
                of[a.max(b)] = a.min(b);
            }
        }
    }
    let step = us.step() + vs.step();
    let mut wrong = Vec::new();
    let mut regions_of: BTreeMap<usize, BTreeSet<u32>> = BTreeMap::new();
    let mut fills_of: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
    for i in (0..n).filter(|&i| clear[i].is_some()) {
        let (u, v) = place(i);
        let filled = root(&mut of, i);
        let generous = clear[i].is_some_and(|c| c > GENEROUS * step);
        match space.locate(u, v).region() {
            None => wrong.push(format!("({u}, {v}) is free, but in no region")),
            Some(RegionId(region)) => {
                regions_of.entry(filled).or_default().insert(region);
                if generous {
                    fills_of.entry(region).or_default().insert(filled);
                }
            }
        }
    }
    for (filled, regions) in &regions_of {
        if regions.len() > 1 {
            wrong.push(format!(
                "{:?} hangs together, but is in {regions:?}",
                place(*filled)
            ));
        }
    }
    for (region, filled) in &fills_of {
        if filled.len() > 1 {
            let places: Vec<_> = filled.iter().take(4).map(|&i| place(i)).collect();
            wrong.push(format!(
                "region {region} falls into {}: {places:?}",
                filled.len()
            ));
        }
    }
    let regions = space.regions().len();
    let on_grid: BTreeSet<u32> = regions_of.values().flatten().copied().collect();
    if on_grid.iter().any(|&r| r as usize >= regions) {
        wrong.push("a region that there is not".into());
    }
    let line = format!(
        "{:34} {regions} regions, {} of them on the grid, {} generously; {} filled; {} of {n} free",
        m.name,
        on_grid.len(),
        fills_of.len(),
        regions_of.len(),
        clear.iter().flatten().count(),
    );
    (wrong, line, fills_of.len())
}

#[test]
fn free_regions_agree_with_a_flood_fill() {
    let all = mechanisms();
    let compared: Vec<(Vec<String>, String, usize)> = all.par_iter().map(compare).collect();
    let mut sum = Vec::new();
    let mut joined = 0;
    for (m, (wrong, line, regions)) in all.iter().zip(compared) {
        joined += regions;
        println!("{line}; {} wrong", wrong.len());
        sum.extend(
            wrong
                .into_iter()
                .take(6)
                .map(|w| format!("{}: {w}", m.name)),
        );
    }
    assert!(sum.is_empty(), "{} wrong:\n{}", sum.len(), sum.join("\n"));
    assert!(joined > 50, "{joined}");
}

/// The number of ways in which two gears can mesh, without a motion from one to another, is the greatest common divisor of their numbers of
/// teeth: turning one of them by a tooth leads to another way, and turning both in mesh identifies some of these.
#[test]
fn gears_mesh_in_as_many_ways_as_their_common_divisor() {
    let all = [(9, 6, 3), (8, 8, 8), (10, 9, 1), (6, 12, 6), (14, 12, 2)];
    for (n, m, ways) in all.into_iter().take(effort(3, 5)) {
        let g = gears(n, m);
        let space =
            FixedAxesSpace::compute(&g.fixed, g.fixed_axis, &g.moving, g.moving_axis).unwrap();
        let regions = space.regions();
        assert_eq!(regions.len(), ways, "{n} and {m}");
        assert!(regions.iter().all(|r| r.around_u && r.around_v));
    }
}

/// A region's sample is a configuration of the region: within the ranges of the region and of the motions, in the region according to all
/// queries, and free according to the oracle.
#[test]
fn samples_lie_in_their_regions() {
    let (mut samples, mut unrolled) = (0, 0);
    for m in mechanisms().into_iter().chain([gears(10, 9), gears(6, 12)]) {
        let space =
            FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap();
        let oracle = Oracle::new(&m.fixed, &m.moving);
        for (i, r) in space.regions().iter().enumerate() {
            let (u, v) = r.sample;
            let name = format!("{}: region {i}, ({u}, {v})", m.name);
            let within = |t: f64, (lo, hi): (f64, f64)| (lo..=hi).contains(&t);
            assert!(within(u, r.u) && within(v, r.v), "{name}: {r:?}");
            for (t, axis) in [(u, m.fixed_axis), (v, m.moving_axis)] {
                assert!(axis.range.is_none_or(|range| within(t, range)), "{name}");
            }
            assert_eq!(
                space.locate(u, v),
                Location::Free(RegionId(i as u32)),
                "{name}"
            );
            let verdict = oracle.judge(space.configuration(u, v));
            assert!(
                !verdict.overlap || verdict.margin <= CERTAIN * oracle.size(),
                "{name}"
            );
            samples += 1;
            unrolled += usize::from(r.u.1 - r.u.0 > TAU || r.v.1 - r.v.0 > TAU);
        }
    }
    assert!(samples > 50 && unrolled > 10, "{samples} {unrolled}");
}

/// Two ways past a part are as wide as it: the slot, and below the block at its upper limit. Where flush sides are told apart by moving the
/// parts, neither opens, and the part stops where it meets the block.
#[test]
fn a_passage_as_wide_as_the_part_stays_closed() {
    let vertices = |corners: [(f64, f64); 4]| {
        let corners = corners.map(|(x, y)| cspace::Vertex::line(x, y));
        corners.to_vec()
    };
    let bar = |[x0, y0, x1, y1]: [f64; 4]| vertices([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]);
    let slide = |x: f64, y: f64| Axis::prismatic(cspace::Vector::new(x, y));
    let tooth = Part::new("tooth", vec![bar([0.0, -1.0, 4.0, 0.0])]).unwrap();
    for (depth, upper) in [(2.0, 2.5), (3.0, 2.5), (3.0, 2.5 - 1e-9), (3.0, 1.0)] {
        let lower = bar([4.5, -2.5, 4.5 + depth, 0.5]);
        let block = Part::new("block", vec![bar([4.5, 1.5, 6.5, 5.5]), lower]).unwrap();
        let along = slide(1.0, 0.0).within(-2.5, 5.5);
        let up = slide(0.0, 1.0).within(-4.5, upper);
        let space = FixedAxesSpace::compute(&tooth, along, &block, up).unwrap();
        assert_eq!(space.statistics().conflicts, 0);
        let [region] = space.regions()[..] else {
            panic!("{:?}", space.regions());
        };
        let beyond = region.u.1 - 0.5;
        assert!(beyond.abs() < 1e-6, "{depth} {upper}: {beyond:e}");
    }
}
