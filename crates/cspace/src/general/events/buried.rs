//! Buried branches: crossings that are in blocked space from the cluster at which they begin to that at which they end.
//!
//! A cell that such a branch bounds is blocked, and so is what is beyond: without the branch the two are one blocked cell. Of parts with many
//! teeth most branches are buried where teeth overlap beside the two that touch. They are dropped before meetings of three sheets are looked
//! for, whose number grows with the square of the number of branches on a sheet.
//!
//! The proof is a disc inside each part. The positions at which the two discs overlap are a disc, too, whose boundary is a circle like that
//! of a contact curve. So the crossing leaves it only where three carriers meet: those of the two sheets, and this circle.

use crate::contact::{Cycle, Geometry, Sheet};
use crate::geometry::{Point, Rotation};
use crate::number::TrigPolynomial;
use crate::parallel;

use crate::general::broad::discs::{DiscPair, DiscTables};
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::events::passing::concurrency;
use crate::general::events::trace::{SheetMeeting, Traced};

/// Branches examined at a time by one thread.
const CHUNK: usize = 256;

/// Number of pairs of discs that are remembered, because they bury branches of the same sheet.
const REMEMBERED: usize = 4;

/// Number of pairs of discs whose proof may fail before a branch counts as not buried.
const MOST_FAILURES: u32 = 2;

/// Length by which a crossing has to be inside a disc: far above its rounding, which at a tangency is the square root of that of its
/// curves.
const MARGIN: f64 = 1.0 / (1u64 << 20) as f64;

/// Radius of contact curves (length) above which places at a tangency are not known to that.
const LARGEST: f64 = 4.0;

/// Drops branches that are certainly buried, and meetings of sheets that have no other branches.
pub(crate) fn drop_buried(
    geometry: &Geometry,
    clusters: &Clusters,
    tables: &DiscTables,
    traced: &mut Traced,
) {
    let found = parallel::chunks(&traced.branches, CHUNK, |_, branches| {
        let mut search = Search {
            geometry,
            clusters,
            tables,
            recent: [None; REMEMBERED],
        };
        let buried = branches.iter().map(|b| search.is_buried(b));
        buried.collect::<Vec<bool>>()
    });
    let mut buried = found.into_iter().flatten();
    let mut coincident: Vec<(u32, u32)> = (traced.coincidences.iter())
        .map(|c| (c.first, c.second))
        .collect();
    coincident.sort_unstable();
    let branches = core::mem::take(&mut traced.branches);
    // Branches and meetings are sorted alike, and each branch belongs to a meeting.
    let mut meetings = core::mem::take(&mut traced.meetings).into_iter().peekable();
    for both in branches.chunk_by(|a, b| (a.first, a.second) == (b.first, b.second)) {
        let pair = (both[0].first, both[0].second);
        let before = traced.branches.len();
        (traced.branches).extend(both.iter().zip(&mut buried).filter(|b| !b.1).map(|b| *b.0));
        // Where they coincide, the sheets share more than their crossings.
        let drops = traced.branches.len() == before && coincident.binary_search(&pair).is_err();
        while let Some(meeting) = meetings.next_if(|m| (m.first, m.second) <= pair) {
            let is_theirs = (meeting.first, meeting.second) == pair;
            if !(drops && is_theirs && covers(both, &meeting)) {
                traced.meetings.push(meeting);
            }
        }
    }
    traced.meetings.extend(meetings);
}

/// Whether branches exist at all times of a meeting: at others the sheets may touch without crossing.
fn covers(branches: &[Branch], meeting: &SheetMeeting) -> bool {
    let mut lives: Vec<(u32, u32)> = branches.iter().map(|b| (b.from, b.to)).collect();
    lives.sort_unstable();
    let until = lives.into_iter().fold(meeting.from, |until, (from, to)| {
        if from <= until { until.max(to) } else { until }
    });
    until >= meeting.to
}

/// The search for discs that bury branches.
struct Search<'a> {
    geometry: &'a Geometry,
    clusters: &'a Clusters,
    tables: &'a DiscTables,
    /// Discs that buried the last branches, the latest first.
    recent: [Option<DiscPair>; REMEMBERED],
}

impl Search<'_> {
    /// Whether a branch is certainly buried.
    fn is_buried(&mut self, branch: &Branch) -> bool {
        let sheets = &self.geometry.contacts.sheets;
        let [f, g] = [branch.first, branch.second].map(|s| &sheets[s as usize]);
        let is_large =
            |s: &Sheet| s.is_flat() || s.is_circle() && s.locus.carrier.radius.abs() > LARGEST;
        // In a cluster a crossing that begins or ends at a tangency moves by about the square root of the width.
        let is_wide = |cluster| self.clusters.width(cluster).sqrt() > 0.125 * MARGIN;
        if is_large(f) || is_large(g) || is_wide(branch.from) || is_wide(branch.to) {
            return false;
        }
        let (lo, hi) = self.clusters.exactly_between(branch.from, branch.to);
        let crossing = Crossing::new([f, g], branch.root, lo.to_f64(), hi.to_f64());
        for k in 0..REMEMBERED {
            if self.recent[k].is_some_and(|pair| crossing.may_be_in(&pair) && crossing.is_in(&pair))
            {
                self.recent[..=k].rotate_right(1);
                return true;
            }
        }
        let mut failures = 0;
        let mut found = None;
        let mut take = |pair: DiscPair| {
            if crossing.may_be_in(&pair) {
                if crossing.is_in(&pair) {
                    found = Some(pair);
                } else {
                    failures += 1;
                }
            }
            found.is_some() || failures >= MOST_FAILURES
        };
        let (p, turn) = crossing.samples[0];
        self.tables.any_overlap(p, turn, &mut take);
        if found.is_some() {
            self.recent.rotate_right(1);
            self.recent[0] = found;
        }
        found.is_some()
    }
}

/// A crossing of two sheets over an interval of orientations.
struct Crossing<'a> {
    sheets: [&'a Sheet; 2],
    root: u8,
    lo: f64,
    hi: f64,
    /// Its place in the middle of the interval and at the ends, with the orientations.
    samples: [(Point, Rotation); 3],
}

impl<'a> Crossing<'a> {
    fn new(sheets: [&'a Sheet; 2], root: u8, lo: f64, hi: f64) -> Self {
        let at = |theta| place(sheets, root, theta);
        Self {
            sheets,
            root,
            lo,
            hi,
            samples: [0.5 * (lo + hi), lo, hi].map(at),
        }
    }

    /// Whether the samples are at positions at which the two discs overlap.
    fn may_be_in(&self, pair: &DiscPair) -> bool {
        self.samples.iter().all(|s| is_in(pair, *s))
    }

    /// Whether all places are, if the samples are, at positions at which the two discs overlap.
    fn is_in(&self, pair: &DiscPair) -> bool {
        /// Share of the interval down to which it is halved.
        const NARROWEST: f64 = 1.0 / 1024.0;
        let [f, g] = self.sheets;
        let meeting = TrigPolynomial::sampled(|turn: Rotation| {
            let disc = pair.at(turn);
            let circle = Cycle::round(disc.center, disc.reach - MARGIN);
            concurrency([circle, f.cycle(turn), g.cycle(turn)])
        });
        // Where the polynomial changes its sign once, one of the two crossings of the carriers passes the circle: not this one, if it is
        // inside before and after.
        let inside = |theta| is_in(pair, place(self.sheets, self.root, theta));
        let narrowest = NARROWEST * (self.hi - self.lo);
        meeting.changes_sign_only(self.lo, self.hi, narrowest, &|from, to| {
            inside(from) && inside(to)
        })
    }
}

/// The place of a crossing at an orientation.
fn place([f, g]: [&Sheet; 2], root: u8, theta: f64) -> (Point, Rotation) {
    let turn = Rotation::by(theta);
    let (cycle, other) = (f.cycle(turn), g.cycle(turn));
    (cycle.at(cycle.root(&other, root, false)), turn)
}

/// Whether two discs overlap at a place; false if there is none.
fn is_in(pair: &DiscPair, (place, turn): (Point, Rotation)) -> bool {
    let disc = pair.at(turn);
    let reach = disc.reach - MARGIN;
    reach > 0.0 && (place - disc.center).length_squared() < reach * reach
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::general::broad::candidates::Candidates;
    use crate::general::broad::discs::Cores;
    use crate::general::events::clusters::Moment;
    use crate::general::events::coming::pair_events;
    use crate::general::events::trace::branches;
    use crate::part::{Part, Vertex};

    /// A wheel with uneven teeth, with round or straight flanks.
    fn wheel(teeth: u32, bulge: f64, rng: &mut ChaCha8Rng) -> Part {
        let step = core::f64::consts::TAU / f64::from(teeth);
        let outline = (0..teeth).flat_map(|k| {
            let depth: f64 = rng.random_range(0.15..0.25);
            [
                (0.0, 1.0, 0.1),
                (0.4, 1.0, bulge),
                (0.5, 1.0 - depth, 0.0),
                (0.9, 1.0 - depth, bulge),
            ]
            .map(|(share, r, bulge)| {
                let angle = step * (f64::from(k) + share);
                Vertex::new(r * angle.cos(), r * angle.sin(), bulge)
            })
        });
        Part::new("wheel", vec![outline.collect()]).unwrap()
    }

    /// Crossings of buried branches are in the disc that proves it, which is blocked by brute force; and many branches are buried. Meetings
    /// are left for those that are not.
    #[test]
    fn buried_branches_are_blocked() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for bulge in [0.0, 0.2, -0.2] {
            let [a, b] = [24, 17].map(|teeth| wheel(teeth, bulge, &mut rng));
            let geometry = Geometry::new(&a, &b, None, usize::MAX);
            let cores = Cores::new(&geometry);
            let candidates = Candidates::find(&geometry, &cores).unwrap();
            let events = pair_events(&geometry, &candidates.pairs);
            let sheets = &geometry.contacts.sheets;
            let known = (sheets.iter().flat_map(|s| [s.from, s.to]))
                .chain(candidates.slots.iter().map(|s| (*s).into()));
            let known = known.map(|theta| Moment {
                theta,
                error: 1e-30,
            });
            let clusters = Clusters::new(events.events.iter().copied().chain(known));
            let mut traced = branches(&geometry, &candidates.pairs, &events, &clusters);
            let (all, meetings) = (traced.branches.clone(), traced.meetings.clone());
            let tables = cores.tables.as_ref().unwrap();
            drop_buried(&geometry, &clusters, tables, &mut traced);
            let mut kept = traced.branches.iter().peekable();
            let buried: Vec<&Branch> = (all.iter())
                .filter(|b| kept.next_if_eq(b).is_none())
                .collect();
            assert!(kept.next().is_none());
            assert!(
                3 * buried.len() > all.len(),
                "{} of {}",
                buried.len(),
                all.len()
            );
            let mut search = Search {
                geometry: &geometry,
                clusters: &clusters,
                tables,
                recent: [None; REMEMBERED],
            };
            let (mut proved, count) = (0, buried.len());
            for b in buried {
                // Other discs may have been found first: those of branches of the sheet before.
                if !search.is_buried(b) {
                    continue;
                }
                proved += 1;
                let pair = search.recent[0].unwrap();
                let (lo, hi) = clusters.exactly_between(b.from, b.to);
                let [f, g] = [b.first, b.second].map(|s| &sheets[s as usize]);
                for k in 0..=50 {
                    let theta = lo.to_f64() + (hi - lo).to_f64() * f64::from(k) / 50.0;
                    let (at, turn) = place([f, g], b.root, theta);
                    let disc = pair.at(turn);
                    assert!(at.distance(disc.center) < disc.reach, "{b:?} at {theta}");
                }
                let theta = lo.to_f64() + (hi - lo).to_f64() * rng.random_range(0.0..1.0);
                let (at, _) = place([f, g], b.root, theta);
                assert!(geometry.overlaps(at, theta), "{b:?} at {theta}");
            }
            assert!(10 * proved > 9 * count, "{proved} of {count}");
            assert!(traced.meetings.len() < meetings.len());
            let mut left = meetings.iter();
            assert!(traced.meetings.iter().all(|m| left.any(|n| n == m)));
            for b in &traced.branches {
                let of = |m: &&SheetMeeting| (m.first, m.second) == (b.first, b.second);
                assert!(
                    traced
                        .meetings
                        .iter()
                        .any(|m| of(&m) && m.from <= b.from && b.to <= m.to)
                );
            }
        }
    }

    /// A meeting is dropped only if there is no time in it without a branch.
    #[test]
    fn a_gap_between_branches_is_not_covered() {
        let branch = |root, from, to| Branch {
            first: 1,
            second: 2,
            root,
            enters: true,
            from,
            to,
        };
        let meeting = |from, to| SheetMeeting {
            first: 1,
            second: 2,
            from,
            to,
        };
        let both = [branch(0, 5, 8), branch(1, 1, 3)];
        assert!(!covers(&both, &meeting(1, 8)));
        assert!(covers(&both[1..], &meeting(1, 3)));
        assert!(!covers(&both[1..], &meeting(0, 3)) && !covers(&both[1..], &meeting(1, 4)));
        assert!(covers(&[both[0], both[1], branch(1, 3, 5)], &meeting(1, 8)));
        assert!(covers(&[both[0], branch(1, 2, 6)], &meeting(2, 8)));
    }
}
