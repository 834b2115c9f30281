//! Which sheets can cross, and when.
//!
//! Orientations are cut into slots of equal width. In every slot each sheet has a box in the plane of positions;
//! sheets whose boxes do not meet do not cross. Where the inscribed discs of the parts overlap, a sheet is in blocked
//! space for certain and is left out.

use rayon::prelude::*;

use crate::contact::{CurveShape, Geometry, Sheet};
use crate::geometry::{Point, Rotation, Vector};

use super::core::Cores;

/// Widest slot, radians: two degrees.
const WIDEST_SLOT: f64 = core::f64::consts::PI / 90.0;

/// Two sheets that may cross at orientations from `lo` to `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PairRun {
    pub(super) first: u32,
    pub(super) second: u32,
    pub(super) lo: f64,
    pub(super) hi: f64,
}

/// An interval of orientations in which a sheet is not known to be blocked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SheetRun {
    pub(super) sheet: u32,
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Whether the run ends there because the sheet is blocked beyond.
    pub(super) lo_blocked: bool,
    pub(super) hi_blocked: bool,
}

/// What is to be looked at.
#[derive(Debug)]
pub(super) struct Candidates {
    /// Bounds of the slots.
    pub(super) slots: Vec<f64>,
    pub(super) pairs: Vec<PairRun>,
    /// Sorted by sheet, then by orientation.
    pub(super) sheets: Vec<SheetRun>,
    /// For every slot the sheets that are not known to be blocked in it, the leftmost box first.
    by_slot: Vec<Vec<Boxed>>,
}

/// A sheet and a box that it does not leave in a slot.
#[derive(Debug, Clone, Copy)]
struct Boxed {
    sheet: u32,
    lo: Point,
    hi: Point,
}

impl Candidates {
    pub(super) fn find(geometry: &Geometry, cores: &Cores) -> Self {
        let span = geometry.contacts.span;
        let sheets = &geometry.contacts.sheets;
        let count = ((span.hi - span.lo) / WIDEST_SLOT).ceil().max(1.0) as usize;
        let width = (span.hi - span.lo) / count as f64;
        let mut slots: Vec<f64> = (0..count).map(|i| span.lo + width * i as f64).collect();
        slots.push(span.hi);
        let slot_of = |theta: f64| slots.partition_point(|&s| s <= theta).clamp(1, count) - 1;

        let mut in_slot: Vec<Vec<u32>> = vec![Vec::new(); count];
        for (i, sheet) in (0..).zip(sheets) {
            let (first, last) = (slot_of(sheet.lo), slot_of(sheet.hi));
            for list in &mut in_slot[first..=last] {
                list.push(i);
            }
        }
        let per_slot: Vec<(Vec<u64>, Vec<Boxed>)> = in_slot
            .par_iter()
            .enumerate()
            .map(|(slot, list)| {
                look_at_slot(geometry, cores, list, slot, slots[slot], slots[slot + 1])
            })
            .collect();

        let (mut pairs, mut alive) = (Vec::new(), Vec::new());
        let mut by_slot = Vec::with_capacity(count);
        for (slot, (p, a)) in (0..).zip(per_slot) {
            pairs.extend(p);
            alive.extend(a.iter().map(|b| u64::from(b.sheet) << SLOT_BITS | slot));
            by_slot.push(a);
        }
        pairs.par_sort_unstable();
        alive.par_sort_unstable();
        let clip = |lo: f64, hi: f64, sheet: &Sheet| (lo.max(sheet.lo), hi.min(sheet.hi));
        let pairs = runs(&pairs)
            .filter_map(|(key, first_slot, last_slot)| {
                let (first, second) = ((key >> SHEET_BITS) as u32, (key & SHEET_MASK) as u32);
                let (lo, hi) = (slots[first_slot], slots[last_slot + 1]);
                let (lo, hi) = clip(lo, hi, &sheets[first as usize]);
                let (lo, hi) = clip(lo, hi, &sheets[second as usize]);
                (lo < hi).then_some(PairRun {
                    first,
                    second,
                    lo,
                    hi,
                })
            })
            .collect();
        let sheet_runs = runs(&alive)
            .filter_map(|(key, first_slot, last_slot)| {
                let sheet = &sheets[key as usize];
                let (lo, hi) = clip(slots[first_slot], slots[last_slot + 1], sheet);
                (lo < hi).then_some(SheetRun {
                    sheet: key as u32,
                    lo,
                    hi,
                    lo_blocked: lo > sheet.lo,
                    hi_blocked: hi < sheet.hi,
                })
            })
            .collect();
        Self {
            slots,
            pairs,
            sheets: sheet_runs,
            by_slot,
        }
    }

    /// The sheets that may pass within `reach` of a point at an orientation, but for those known to be blocked there; some
    /// may not exist there.
    pub(super) fn around(&self, theta: f64, p: Point, reach: f64) -> impl Iterator<Item = u32> {
        let slot = self.slots.partition_point(|&s| s <= theta);
        self.by_slot[slot.clamp(1, self.by_slot.len()) - 1]
            .iter()
            .take_while(move |b| b.lo.x <= p.x + reach)
            .filter(move |b| {
                b.hi.x >= p.x - reach && b.hi.y >= p.y - reach && b.lo.y <= p.y + reach
            })
            .map(|b| b.sheet)
    }
}

/// Bits of a sheet's number, and of a slot's: two sheets and a slot make one sortable key.
const SHEET_BITS: u32 = 26;
const SHEET_MASK: u64 = (1 << SHEET_BITS) - 1;
const SLOT_BITS: u32 = 12;

/// The largest number of sheets the keys have room for.
pub(super) const MAX_SHEETS: usize = 1 << SHEET_BITS;

/// Runs of consecutive slots with one key: (key, first slot, last slot).
fn runs(sorted: &[u64]) -> impl Iterator<Item = (u64, usize, usize)> + '_ {
    let mut at = 0;
    core::iter::from_fn(move || {
        let first = *sorted.get(at)?;
        let from = at;
        at += 1;
        while at < sorted.len()
            && sorted[at] == sorted[at - 1] + 1
            && sorted[at] >> SLOT_BITS == first >> SLOT_BITS
        {
            at += 1;
        }
        let slot = (first & ((1 << SLOT_BITS) - 1)) as usize;
        Some((first >> SLOT_BITS, slot, slot + at - 1 - from))
    })
}

fn look_at_slot(
    geometry: &Geometry,
    cores: &Cores,
    list: &[u32],
    slot: usize,
    slot_lo: f64,
    slot_hi: f64,
) -> (Vec<u64>, Vec<Boxed>) {
    let contacts = &geometry.contacts;
    let mut boxes: Vec<Boxed> = Vec::with_capacity(list.len());
    for &i in list {
        let sheet = &contacts.sheets[i as usize];
        let (lo, hi) = (slot_lo.max(sheet.lo), slot_hi.min(sheet.hi));
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let turn = Rotation::by(mid);
        if cores.cover(sheet, mid, turn, half) {
            continue;
        }
        let (box_lo, box_hi) = sheet_box(sheet, mid, turn, half);
        boxes.push(Boxed {
            sheet: i,
            lo: box_lo,
            hi: box_hi,
        });
    }
    boxes.sort_unstable_by(|a, b| a.lo.x.total_cmp(&b.lo.x).then(a.sheet.cmp(&b.sheet)));
    let mut pairs = Vec::new();
    for (n, b) in boxes.iter().enumerate() {
        for c in &boxes[n + 1..] {
            if c.lo.x > b.hi.x {
                break;
            }
            if c.lo.y <= b.hi.y && b.lo.y <= c.hi.y {
                let (f, g) = (b.sheet.min(c.sheet), b.sheet.max(c.sheet));
                let (fs, gs) = (&contacts.sheets[f as usize], &contacts.sheets[g as usize]);
                if fs.lo < gs.hi
                    && gs.lo < fs.hi
                    && !fs.shared_ends(gs, contacts.first_vertex_name).tangent
                {
                    pairs.push(
                        (u64::from(f) << SHEET_BITS | u64::from(g)) << SLOT_BITS | slot as u64,
                    );
                }
            }
        }
    }
    (pairs, boxes)
}

/// A box that contains the sheet's curves at all orientations within `half` of the middle one.
fn sheet_box(sheet: &Sheet, mid: f64, turn: Rotation, half: f64) -> (Point, Point) {
    let mut curve = sheet.curve(mid, turn);
    // |R w − R₀ w| along an axis is at most the velocity's share times h, plus |w| h² / 2.
    let grow = |w: Vector| {
        let v = (turn * w).left();
        let bend = 0.5 * w.length() * half * half;
        Vector::new(v.x.abs() * half + bend, v.y.abs() * half + bend)
    };
    let (g, h) = (grow(sheet.start.w), grow(sheet.end.w));
    let (s, e) = (curve.start, curve.end);
    let mut lo = Point::new((s.x - g.x).min(e.x - h.x), (s.y - g.y).min(e.y - h.y));
    let mut hi = Point::new((s.x + g.x).max(e.x + h.x), (s.y + g.y).max(e.y + h.y));
    if let CurveShape::Circle { half: spread, .. } = &mut curve.shape {
        // The circle's own extremes: with normals as far as they come, about a centre that moves.
        *spread += half;
        let g = grow(sheet.center().w);
        let (l, h) = curve.bounds();
        lo = Point::new(lo.x.min(l.x - g.x), lo.y.min(l.y - g.y));
        hi = Point::new(hi.x.max(h.x + g.x), hi.y.max(h.y + g.y));
    }
    // Rounding is far below this.
    const MARGIN: f64 = 1e-10;
    let margin = Vector::new(MARGIN, MARGIN);
    (lo + (-margin), hi + margin)
}
