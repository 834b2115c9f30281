//! Pairs of sheets that may cross, with the orientations at which they may.
//!
//! Orientations are cut into intervals (slots) of equal width; their number grows with the number of sheets. In every interval each sheet
//! has boxes in the plane of positions; sheets whose boxes do not meet do not cross. Where inscribed discs of the parts overlap, positions
//! are certainly blocked, and pieces of a sheet's curves that lie there are left out: crossings in blocked space do not change free space.
//! They only divide gaps that are blocked on both sides of them.

use core::f64::consts::TAU;
use core::sync::atomic::{AtomicUsize, Ordering};

use crate::contact::{Curve, Cycle, Exact, Geometry, Sheet};
use crate::geometry::{Point, Rotation, Vector};
use crate::parallel;
use crate::part::Bounds;

use crate::general::broad::discs::{Cores, Layout};
use crate::general::broad::uncovered::{BlockedDiscs, Uncovered};
use crate::general::limits::{MOST_CROSSING, MOST_IN_SLOT, MOST_MEETINGS, MOST_SHEETS};

/// For n sheets a turn has `SLOTS_SCALE` n ^ `SLOTS_POWER` intervals: more intervals leave fewer crossings, but each costs as much as a
/// small pair.
const SLOTS_SCALE: f64 = 0.35;
/// The power of that formula.
const SLOTS_POWER: f64 = 0.75;

/// Minimum and maximum number of intervals per turn by that formula.
const SLOTS: (f64, f64) = (8.0, 300.0);

/// Number of intervals per mean duration of a sheet, used where sheets are many and short: then each sheet is examined in few intervals,
/// and the narrower these are the fewer boxes meet.
const SLOTS_IN_A_LIFE: f64 = 2.0;
/// Maximum number of intervals, given by the bits of the keys.
const MOST_SLOTS: f64 = ((1 << SLOT_BITS) - 2) as f64;

/// Number of intervals examined together first, for the sheets that are blocked in all of them.
const TOGETHER: usize = 4;

/// Number of such groups examined before, for the sheets that the largest disc alone covers: most of those covered at all.
const LARGE: usize = 4;

/// Two sheets that may cross at orientations from `lo` to `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PairRun {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) lo: Exact,
    pub(crate) hi: Exact,
}

/// An interval of orientations in which a sheet may be free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SheetRun {
    pub(crate) sheet: u32,
    pub(crate) lo: Exact,
    pub(crate) hi: Exact,
    /// Whether the run begins, or ends, because the sheet is blocked beyond.
    pub(crate) lo_blocked: bool,
    pub(crate) hi_blocked: bool,
}

/// Pairs of sheets that may cross, and the runs of orientation in which sheets are to be examined.
#[derive(Debug)]
pub(crate) struct Candidates {
    /// Bounds of the intervals of orientation (slots).
    pub(crate) slots: Vec<f64>,
    pub(crate) pairs: Vec<PairRun>,
    /// Sorted by sheet, then by orientation.
    pub(crate) sheets: Vec<SheetRun>,
    /// For every interval, the sheets not known to be blocked in it, ordered by the left side of their boxes.
    by_slot: Vec<Vec<Boxed>>,
}

/// A sheet and a box that contains it throughout an interval.
#[derive(Debug, Clone, Copy)]
struct Boxed {
    sheet: u32,
    /// Its corners, rounded outwards.
    lo: [f32; 2],
    hi: [f32; 2],
}

impl Boxed {
    fn new(sheet: u32, (lo, hi): (Point, Point)) -> Self {
        Self {
            sheet,
            lo: [lo.x, lo.y].map(|v| (v as f32).next_down()),
            hi: [hi.x, hi.y].map(|v| (v as f32).next_up()),
        }
    }

    fn meets(&self, lo: [f32; 2], hi: [f32; 2]) -> bool {
        (0..2).all(|k| self.lo[k] <= hi[k] && lo[k] <= self.hi[k])
    }
}

impl Candidates {
    /// Finds the candidates; `None` if more sheets may cross than the limit.
    pub(crate) fn find(geometry: &Geometry, cores: &Cores) -> Option<Self> {
        let span = geometry.contacts.span;
        let sheets = &geometry.contacts.sheets;
        let turns = (span.hi - span.lo) / TAU;
        let in_turn = SLOTS_SCALE * (sheets.len() as f64 / turns).powf(SLOTS_POWER);
        let lives: f64 = sheets.iter().map(|s| s.hi - s.lo).sum();
        let short_lived = SLOTS_IN_A_LIFE * TAU * sheets.len() as f64 / lives;
        let in_turn = (in_turn.clamp(SLOTS.0, SLOTS.1)).max(in_turn.min(short_lived));
        let count = (turns * in_turn.min(MOST_SLOTS))
            .ceil()
            .clamp(1.0, MOST_SLOTS) as usize;
        let width = (span.hi - span.lo) / count as f64;
        let mut slots: Vec<f64> = (0..count).map(|i| span.lo + width * i as f64).collect();
        slots.push(span.hi);
        let slot_of = |theta: f64| slots.partition_point(|&s| s <= theta).clamp(1, count) - 1;

        // Groups of intervals, by the first of each, with the sheets that exist there.
        let large = LARGE * TOGETHER;
        let mut in_slots: Vec<(usize, Vec<u32>)> =
            ((0..count).step_by(large).map(|first| (first, Vec::new()))).collect();
        for (i, sheet) in (0..).zip(sheets) {
            let (first, last) = (slot_of(sheet.lo) / large, slot_of(sheet.hi) / large);
            for (_, list) in &mut in_slots[first..=last] {
                list.push(i);
            }
        }
        let in_slots = parallel::map(&in_slots, 1, |(first, list)| {
            let (lo, hi) = (slots[*first], slots[(first + large).min(count)]);
            let mut list = list.clone();
            if count > TOGETHER {
                drop_covered(sheets, &cores.largest(), &mut list, (lo, hi));
            }
            (*first, list)
        });
        let together: Vec<(usize, &[u32])> = (in_slots.iter())
            .flat_map(|(first, list)| {
                let firsts = (*first..(first + large).min(count)).step_by(TOGETHER);
                firsts.map(|slot| (slot, &list[..]))
            })
            .collect();
        let meetings = AtomicUsize::new(0);
        let found = parallel::map(&together, 1, |(first, list)| {
            let last = (first + TOGETHER).min(count);
            let (lo, hi) = (slots[*first], slots[last]);
            let mut list: Vec<u32> = (list.iter().copied())
                .filter(|&i| {
                    let sheet = &sheets[i as usize];
                    slot_of(sheet.lo) < last && *first <= slot_of(sheet.hi)
                })
                .collect();
            if meetings.load(Ordering::Relaxed) > MOST_MEETINGS {
                list.clear();
            }
            let layout = cores.about(0.5 * (lo + hi));
            if count > 1 {
                drop_covered(sheets, &layout, &mut list, (lo, hi));
            }
            let look = |slot| {
                if meetings.load(Ordering::Relaxed) > MOST_MEETINGS {
                    return Default::default();
                }
                let slot = (slot, slots[slot], slots[slot + 1]);
                let found = look_at_slot(geometry, &layout, &list, slot);
                let is_too_many = found.0.len() > MOST_IN_SLOT;
                let count = if is_too_many {
                    MOST_MEETINGS + 1
                } else {
                    found.0.len()
                };
                meetings.fetch_add(count, Ordering::Relaxed);
                found
            };
            (*first..last).map(look).collect::<Vec<_>>()
        });
        // The count is that of all intervals, whichever was examined last.
        if meetings.into_inner() > MOST_MEETINGS {
            return None;
        }

        let (mut pairs, mut alive) = (Vec::new(), Vec::new());
        let mut by_slot = Vec::with_capacity(count);
        for (slot, (p, a)) in (0..).zip(found.into_iter().flatten()) {
            pairs.extend(p);
            alive.extend(a.iter().map(|b| u64::from(b.sheet) << SLOT_BITS | slot));
            by_slot.push(a);
        }
        // Sheets of several pieces occur several times.
        parallel::sort_unstable_by(&mut pairs, u64::cmp);
        pairs.dedup();
        parallel::sort_unstable_by(&mut alive, u64::cmp);
        alive.dedup();
        let clip = |lo: Exact, hi: Exact, sheet: &Sheet| {
            (
                if lo < sheet.from { sheet.from } else { lo },
                if hi < sheet.to { hi } else { sheet.to },
            )
        };
        let pairs: Vec<PairRun> = runs(&pairs)
            .filter_map(|(key, first_slot, last_slot)| {
                let (first, second) = ((key >> SHEET_BITS) as u32, (key & SHEET_MASK) as u32);
                let (lo, hi) = (
                    Exact::from(slots[first_slot]),
                    Exact::from(slots[last_slot + 1]),
                );
                let (f, g) = (&sheets[first as usize], &sheets[second as usize]);
                let (lo, hi) = clip(lo, hi, f);
                let (lo, hi) = clip(lo, hi, g);
                (lo < hi && geometry.contacts.may_cross(f, g)).then_some(PairRun {
                    first,
                    second,
                    lo,
                    hi,
                })
            })
            .collect();
        if pairs.len() > MOST_CROSSING {
            return None;
        }
        let sheet_runs = runs(&alive)
            .filter_map(|(key, first_slot, last_slot)| {
                let sheet = &sheets[key as usize];
                let slots = (
                    Exact::from(slots[first_slot]),
                    Exact::from(slots[last_slot + 1]),
                );
                let (lo, hi) = clip(slots.0, slots.1, sheet);
                (lo < hi).then_some(SheetRun {
                    sheet: key as u32,
                    lo,
                    hi,
                    lo_blocked: lo > sheet.from,
                    hi_blocked: hi < sheet.to,
                })
            })
            .collect();
        Some(Self {
            slots,
            pairs,
            sheets: sheet_runs,
            by_slot,
        })
    }

    /// The sheets that may pass within `reach` of a point at an orientation, without those known to be blocked there; some may not exist
    /// there.
    pub(crate) fn around(&self, theta: f64, p: Point, reach: f64) -> impl Iterator<Item = u32> {
        let slot = self.slots.partition_point(|&s| s <= theta);
        let corner = Vector::new(reach, reach);
        let near = Boxed::new(0, (p + -corner, p + corner));
        self.by_slot[slot.clamp(1, self.by_slot.len()) - 1]
            .iter()
            .take_while(move |b| b.lo[0] <= near.hi[0])
            .filter(move |b| near.meets(b.lo, b.hi))
            .map(|b| b.sheet)
    }
}

/// Bits of a sheet's number; two sheets and an interval make one sortable key.
const SHEET_BITS: u32 = 26;
const SHEET_MASK: u64 = (1 << SHEET_BITS) - 1;
const SLOT_BITS: u32 = 12;

// The keys have room for the largest number of sheets.
const _: () = assert!(MOST_SHEETS < 1 << SHEET_BITS);

/// Runs of consecutive intervals with one key: (key, first interval, last interval).
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

/// Drops the sheets that are certainly blocked wherever they exist between two orientations, except for short ones, which are examined only
/// once or twice more.
fn drop_covered(sheets: &[Sheet], layout: &Layout, list: &mut Vec<u32>, (from, to): (f64, f64)) {
    /// Share of the interval below which a sheet is short.
    const SHORT: f64 = 0.25;
    let discs = BlockedDiscs::new(layout, 0.5 * (from + to), 0.5 * (to - from));
    let mut work = Uncovered::default();
    list.retain(|&i| {
        let sheet = &sheets[i as usize];
        let (lo, hi) = (from.max(sheet.lo), to.min(sheet.hi));
        if hi - lo <= SHORT * (to - from) {
            return true;
        }
        discs.uncovered(sheet, lo, hi, &mut work);
        !work.open.is_empty()
    });
}

fn look_at_slot(
    geometry: &Geometry,
    layout: &Layout,
    list: &[u32],
    (slot, slot_lo, slot_hi): (usize, f64, f64),
) -> (Vec<u64>, Vec<Boxed>) {
    let contacts = &geometry.contacts;
    let discs = BlockedDiscs::new(layout, 0.5 * (slot_lo + slot_hi), 0.5 * (slot_hi - slot_lo));
    let mut boxes: Vec<Boxed> = Vec::with_capacity(list.len());
    let mut work = Uncovered::default();
    for &i in list {
        let sheet = &contacts.sheets[i as usize];
        let (lo, hi) = (slot_lo.max(sheet.lo), slot_hi.min(sheet.hi));
        if lo > hi {
            continue;
        }
        discs.uncovered(sheet, lo, hi, &mut work);
        if work.open.is_empty() {
            continue;
        }
        let whole = sheet.lo <= slot_lo && slot_hi <= sheet.hi;
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let turn = if whole { discs.turn } else { Rotation::by(mid) };
        boxes.extend(
            work.open
                .iter()
                .map(|&(from, to)| Boxed::new(i, piece_box(sheet, turn, half, from, to))),
        );
    }
    boxes.sort_unstable_by(|a, b| a.lo[0].total_cmp(&b.lo[0]).then(a.sheet.cmp(&b.sheet)));
    let mut pairs = Vec::new();
    for (n, b) in boxes.iter().enumerate() {
        if pairs.len() > MOST_IN_SLOT {
            break;
        }
        for c in &boxes[n + 1..] {
            if c.lo[0] > b.hi[0] {
                break;
            }
            if c.lo[1] <= b.hi[1] && b.lo[1] <= c.hi[1] {
                let (f, g) = (b.sheet.min(c.sheet), b.sheet.max(c.sheet));
                let (fs, gs) = (&contacts.sheets[f as usize], &contacts.sheets[g as usize]);
                if f != g && fs.from < gs.to && gs.from < fs.to {
                    pairs.push(
                        (u64::from(f) << SHEET_BITS | u64::from(g)) << SLOT_BITS | slot as u64,
                    );
                }
            }
        }
    }
    (pairs, boxes)
}

/// A box that contains a range of the sheet's curves at all orientations within `half` of the middle one.
fn piece_box(sheet: &Sheet, turn: Rotation, half: f64, from: f64, to: f64) -> (Point, Point) {
    /// A length far above rounding, in the pair's frame.
    const MARGIN: f64 = 1e-10;
    // |R w − R₀ w| along an axis is at most the velocity's share times h, plus |w| h² / 2.
    let grow = |w: Vector| {
        let v = (turn * w).left();
        let bend = 0.5 * w.length() * half * half + MARGIN;
        Vector::new(v.x.abs() * half + bend, v.y.abs() * half + bend)
    };
    if sheet.is_circle() {
        let center = sheet.locus.carrier.through;
        let at =
            |angle: f64| center.at(turn) + Vector::from_angle(angle) * sheet.locus.carrier.radius;
        let circle = Cycle::round(center.at(turn), sheet.locus.carrier.radius);
        let arc = Curve::new(circle, [at(from), at(to)], [from, to]);
        let Bounds { min: lo, max: hi } = arc.bounds();
        let g = grow(center.w);
        return (lo + (-g), hi + g);
    }
    if sheet.is_flat() {
        // A curve is within its height of its chord, and moves no faster than its ends do.
        let (start, end) = (sheet.locus.start.at(turn), sheet.locus.end.at(turn));
        let (s, e) = (start.lerp(end, from), start.lerp(end, to));
        let (g, h) = (
            grow(sheet.locus.start.turning()),
            grow(sheet.locus.end.turning()),
        );
        let off = MARGIN + 2.0 * sheet.height();
        let off = Vector::new(off + g.x.max(h.x), off + g.y.max(h.y));
        return (
            Point::new(s.x.min(e.x), s.y.min(e.y)) + -off,
            Point::new(s.x.max(e.x), s.y.max(e.y)) + off,
        );
    }
    let at = |t: f64| {
        let w = sheet.locus.start.w + (sheet.locus.end.w - sheet.locus.start.w) * t;
        let u = sheet.locus.start.u + (sheet.locus.end.u - sheet.locus.start.u) * t;
        (u + turn * w, grow(w))
    };
    let ((s, g), (e, h)) = (at(from), at(to));
    (
        Point::new((s.x - g.x).min(e.x - h.x), (s.y - g.y).min(e.y - h.y)),
        Point::new((s.x + g.x).max(e.x + h.x), (s.y + g.y).max(e.y + h.y)),
    )
}
