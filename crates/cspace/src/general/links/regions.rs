//! Free regions: the connected components of free space.
//!
//! Patches that are linked bound one region. Shells that are not linked bound one region if one lies within the other in some slice. A
//! slice through each shell decides this: on a ray to the right from the rightmost point of a loop that has its free space outside, the
//! next contact curve bounds the same free space; if there is none, this is the unbounded region.

use std::collections::BTreeMap;

use crate::contact::Steps;
use crate::feature::PairFrame;
use crate::feature::tolerance::JOINT;
use crate::geometry::{Configuration, Point, Vector};
use crate::ids::{PatchId, RegionId};
use crate::slice::{CurveGeometry, Slice, is_on_arc};
use crate::union_find::UnionFind;

use crate::general::links::copies::normalized;
use crate::space::{FreeRegion, Surface, VerticalLink};

/// Relation of the patches of a space as copies of each other.
pub(crate) enum Copying {
    /// Patches are not copies; but those of one shell are connected, and this is each patch's shell where it is known.
    None { shells: Vec<Option<u32>> },
    /// Every patch has one copy in every period, and the copies of one patch have consecutive numbers.
    Slabs(Steps),
    /// Some copies are cut off.
    Some,
}

impl Copying {
    /// Number of periods by which the whole can be shifted.
    fn shifts(&self) -> u32 {
        match self {
            Self::Slabs(steps) => steps.slabs,
            Self::None { .. } | Self::Some => 1,
        }
    }

    /// The copy of a patch some periods further; the member for the unbounded region is its own copy.
    fn copy(&self, patch: u32, slabs: u32, far: u32) -> u32 {
        let n = self.shifts();
        if patch == far {
            return far;
        }
        patch - patch % n + (patch % n + slabs) % n
    }

    /// A configuration shifted by some periods.
    fn configuration(&self, frame: &PairFrame, c: Configuration, slabs: u32) -> Configuration {
        match self {
            Self::Slabs(steps) if slabs > 0 => {
                let slabs = i64::from(slabs);
                let p = steps.motion(slabs).point(frame.inner_from_outer(c));
                let theta = normalized(c.theta + steps.period(slabs));
                frame.outer_from_inner(p, theta)
            }
            _ => c,
        }
    }
}

/// Number of shells up to which each gets a slice of its own.
const FEW_SHELLS: usize = 64;

/// Distance of a slice from the ends of a patch, as a share of the patch's orientations, that is enough to represent its shell.
const WELL_AWAY: f64 = 0.25;

/// The free regions that a surface bounds.
pub(crate) struct Regions {
    /// The regions, the unbounded one first.
    pub(crate) regions: Vec<FreeRegion>,
    /// The region of each patch.
    pub(crate) of_patches: Vec<RegionId>,
}

/// Numbers the regions, and assigns one to each patch.
pub(crate) fn find_regions(
    surface: &Surface<'_>,
    vertical_links: &[VerticalLink],
    copying: &Copying,
) -> Regions {
    let n = surface.patches.len();
    // One additional member represents the unbounded region.
    let far = n as u32;
    let joint = surface.frame.outer_length(JOINT);
    let mut sets = UnionFind::new(n + 1);
    for l in surface.side_links {
        sets.union(l.before.0, l.after.0);
    }
    for l in vertical_links {
        sets.union(l.lower.0, l.upper.0);
    }
    if let Copying::None { shells } = copying {
        let mut first_of_shell = BTreeMap::new();
        for (i, &shell) in (0u32..).zip(shells) {
            if let Some(shell) = shell {
                let &mut first = first_of_shell.entry(shell).or_insert(i);
                sets.union(first, i);
            }
        }
    }
    // One slice through each shell, at the middle of its longest patch; shells that are copies use copies of one slice.
    const NONE: u32 = u32::MAX;
    let life = |i: u32| surface.patches[i as usize].hi - surface.patches[i as usize].lo;
    let shell: Vec<u32> = (0..n as u32).map(|i| sets.find(i)).collect();
    let mut longest = vec![NONE; n];
    for (i, &s) in (0u32..).zip(&shell) {
        let best = &mut longest[s as usize];
        // Copies have equal durations, up to rounding.
        if *best == NONE || life(i) > life(*best) * (1.0 + 1e-9) {
            *best = i;
        }
    }
    let mut samples: Vec<(u32, Configuration)> = Vec::new();
    let mut done = vec![false; n];
    // If there are many shells, those that a slice passes well away from their ends need no slice of their own.
    let shared = longest.iter().filter(|&&i| i != NONE).count() > FEW_SHELLS;
    let mut passed: Vec<Option<(u32, Configuration)>> = vec![None; if shared { n } else { 0 }];
    let mut take = |i: u32, inside: Configuration, done: &mut [bool]| {
        for slabs in 0..copying.shifts() {
            let copy = copying.copy(i, slabs, far);
            let seen = &mut done[shell[copy as usize] as usize];
            if !core::mem::replace(seen, true) {
                samples.push((copy, copying.configuration(surface.frame, inside, slabs)));
            }
        }
    };
    for s in 0..n {
        let i = longest[s];
        if i == NONE || done[s] {
            continue;
        }
        if let Some(&Some((i, inside))) = passed.get(s) {
            take(i, inside, &mut done);
            continue;
        }
        let p = &surface.patches[i as usize];
        let slice = surface.slice(0.5 * (p.lo + p.hi));
        let mut together: Vec<(u32, u32)> = Vec::new();
        for l in &slice.loops {
            for w in l.windows(2) {
                if let [Some(a), Some(b)] = [w[0], w[1]].map(|c| slice.curves[c as usize].patch) {
                    together.push((a.0, b.0));
                }
            }
        }
        nest(&slice, far, joint, |a, b| together.push((a, b)));
        for slabs in 0..copying.shifts() {
            for &(a, b) in &together {
                sets.union(copying.copy(a, slabs, far), copying.copy(b, slabs, far));
            }
        }
        take(i, sample(&slice, i, joint), &mut done);
        if !shared {
            continue;
        }
        for j in slice.curves.iter().filter_map(|c| Some(c.patch?.0)) {
            let (p, s) = (&surface.patches[j as usize], shell[j as usize] as usize);
            let margin = (slice.theta - p.lo).min(p.hi - slice.theta);
            if !done[s] && passed[s].is_none() && margin > WELL_AWAY * (p.hi - p.lo) {
                passed[s] = Some((j, sample(&slice, j, joint)));
            }
        }
    }
    let mut regions: Vec<FreeRegion> = Vec::new();
    let mut number = vec![NONE; n + 1];
    number[sets.find(far) as usize] = 0;
    let far_sample = (surface.frame).outer_from_inner(Point::new(8.0, 0.0), surface.window.lo);
    regions.push(FreeRegion {
        unbounded: true,
        sample: far_sample,
        patches: 0,
    });
    for (i, sample) in samples {
        let region = &mut number[sets.find(i) as usize];
        if *region == NONE {
            *region = regions.len() as u32;
            regions.push(FreeRegion {
                unbounded: false,
                sample,
                patches: 0,
            });
        }
    }
    let mut of_patches = Vec::with_capacity(n);
    for i in 0..n as u32 {
        // Every patch is in a shell with a slice, and so has a number.
        let region = match number[sets.find(i) as usize] {
            NONE => 0,
            region => region,
        };
        of_patches.push(RegionId(region));
        regions[region as usize].patches += 1;
    }
    Regions {
        regions,
        of_patches,
    }
}

/// Joins every loop with free space outside to the region that surrounds it.
fn nest(slice: &Slice, far: u32, joint: f64, mut join: impl FnMut(u32, u32)) {
    for l in &slice.loops {
        // The rightmost point of the loop is on the curve that extends furthest right.
        let Some((curve, p)) = l
            .iter()
            .map(|&c| (c, rightmost(&slice.curves[c as usize].geometry)))
            .max_by(|a, b| a.1.x.total_cmp(&b.1.x))
        else {
            continue;
        };
        if signed_area(slice, l) <= 0.0 {
            continue;
        }
        let Some(PatchId(own)) = slice.curves[curve as usize].patch else {
            continue;
        };
        let right = Vector::new(1.0, 0.0);
        let hit = (0u32..)
            .zip(&slice.curves)
            .filter(|(c, _)| !l.contains(c))
            .filter_map(|(c, g)| g.geometry.met(p, right, joint).map(|t| (t, c)))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        match hit {
            None => join(own, far),
            Some((_, c)) => {
                if let Some(other) = slice.curves[c as usize].patch {
                    join(own, other.0);
                }
            }
        }
    }
}

fn rightmost(g: &CurveGeometry) -> Point {
    let (s, e) = (g.point(0.0), g.point(1.0));
    let end = if s.x > e.x { s } else { e };
    if let CurveGeometry::Arc {
        center,
        radius,
        start_angle,
        sweep,
    } = *g
        && is_on_arc(start_angle, sweep, 0.0)
    {
        return Point::new(center.x + radius, center.y);
    }
    if let Some(e) = g.edge() {
        // For a large arc, points at which it heads up or down.
        let headings = [Vector::new(0.0, 1.0), Vector::new(0.0, -1.0)];
        let turning = headings.iter().filter_map(|&h| e.fraction_heading(h));
        return turning
            .map(|u| e.at(u))
            .fold(end, |a, b| if b.x > a.x { b } else { a });
    }
    end
}

/// Twice the signed area of a loop, positive if counter-clockwise.
fn signed_area(slice: &Slice, l: &[u32]) -> f64 {
    let Some(&first) = l.first() else { return 0.0 };
    let origin = slice.curves[first as usize].geometry.point(0.0);
    l.iter()
        .map(|&c| {
            let g = &slice.curves[c as usize].geometry;
            let chord = (g.point(0.0) - origin).cross(g.point(1.0) - origin);
            let bulge = match *g {
                CurveGeometry::Segment { .. } => 0.0,
                CurveGeometry::Arc { radius, sweep, .. } => radius * radius * (sweep - sweep.sin()),
                CurveGeometry::FlatArc { .. } => g.edge().map_or(0.0, |e| 2.0 * e.segment_area()),
            };
            chord + bulge
        })
        .sum()
}

/// A free configuration beside a patch: half way from the middle of its curve to the next contact.
fn sample(slice: &Slice, patch: u32, joint: f64) -> Configuration {
    let Some(curve) = slice
        .curves
        .iter()
        .find(|c| c.patch == Some(PatchId(patch)))
    else {
        return Configuration::default();
    };
    let p = curve.geometry.point(0.5);
    let n = curve.geometry.free_normal(0.5);
    let reach = curve.geometry.length();
    let start = p + n * (1e-9 * reach);
    let distance = slice
        .curves
        .iter()
        .filter_map(|c| c.geometry.met(start, n, joint))
        .fold(reach, f64::min);
    let q = p + n * (0.5 * distance);
    Configuration::new(q.x, q.y, slice.theta)
}
