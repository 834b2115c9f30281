//! A free interval of p and one of q over a slab of the swept coordinate s: the section between them, and where it changes.
//!
//! Between two critical values of s the section of a column consists of the same cells, each of them connected: a gap of the
//! plane (p, q) has monotone ends, so what a rectangle leaves of it is over one interval of p. Critical are the values of s at which
//! an end of the interval of p passes the end of a band, an end of that of q an end of a gap or an opening there, or a corner of the
//! rectangle a curve of the plane.

use core::f64::consts::TAU;

use crate::modes::graph::{Graph, Span};
use crate::modes::plane::{Opening, Plane};
use crate::modes::roots::{Corner, sign_change};
use crate::modes::section::{Interval, Place};

/// Values that are nearer to the one before than `near`, together: the first and the last of each cluster.
pub(crate) fn clusters(mut values: Vec<f64>, near: f64) -> Vec<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    let mut clusters: Vec<(f64, f64)> = Vec::new();
    for x in values {
        match clusters.last_mut() {
            Some(last) if x - last.1 < near => last.1 = x,
            _ => clusters.push((x, x)),
        }
    }
    clusters
}

/// A column over an interval of s.
#[derive(Clone, Copy)]
pub(crate) struct Column<'a> {
    /// The plane (p, q).
    pub(crate) plane: &'a Plane,
    /// The openings from each of its bands to the next one.
    pub(crate) openings: &'a [Vec<Opening>],
    /// The interval of p, by s; `None` of a full turn.
    pub(crate) p: Option<Span<'a>>,
    pub(crate) q: Option<Span<'a>>,
    /// Interval of s.
    pub(crate) slab: (f64, f64),
    pub(crate) narrowest: f64,
}

/// A connected piece of free space: a cell of the section, over an interval of s.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Layer {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    pub(crate) cells: Vec<Place>,
    /// Pairs of adjacent cells, with the turns of p and q by which the second has to be moved.
    pub(crate) beside: Vec<(usize, usize, [i32; 2])>,
}

/// The layers of a column, from the lowest.
pub(crate) struct Layers {
    pub(crate) layers: Vec<Layer>,
    /// Whether all critical values were separated.
    pub(crate) decided: bool,
}

impl<'a> Column<'a> {
    fn narrowed(&self) -> (Option<Span<'a>>, Option<Span<'a>>) {
        let (closed_p, closed_q) = (self.plane.x.opening, self.plane.y.opening);
        (
            self.p.map(|p| p.narrowed(closed_p)),
            self.q.map(|q| q.narrowed(closed_q)),
        )
    }

    /// Rectangle at a value of s, without intervals narrower than the openings.
    pub(crate) fn rectangle(&self, s: f64) -> (Interval, Interval) {
        let (p, q) = self.narrowed();
        (p.map(|p| p.at(s)), q.map(|q| q.at(s)))
    }

    pub(crate) fn layers(&self) -> Layers {
        let (p, q) = self.narrowed();
        let bands = self.plane.bands_over(p.map(|p| p.hull(self.slab)));
        let mut critical = Vec::new();
        if let Some(p) = p {
            self.passing(&[p.lower, p.upper], &self.ends_of(&bands), &mut critical);
        }
        if let Some(q) = q {
            let levels = self.levels(&bands, q.hull(self.slab));
            self.passing(&[q.lower, q.upper], &levels, &mut critical);
        }
        let mut decided = true;
        if let (Some(p), Some(q)) = (p, q) {
            let mut corners = Vec::new();
            for (lo, hi) in self.between(critical.clone()) {
                for end in [p.lower, p.upper] {
                    decided &= self.corners(end, q, (lo, hi), &mut corners);
                }
            }
            critical.extend(corners);
        }
        let intervals = self.between(critical).into_iter();
        let layers = intervals.map(|(lo, hi)| self.layer((lo, hi), &bands));
        Layers {
            layers: layers.collect(),
            decided,
        }
    }

    /// The slab cut at its critical values, those that are one in the middle of them.
    fn between(&self, critical: Vec<f64>) -> Vec<(f64, f64)> {
        let (lo, hi) = self.slab;
        let inside = critical.into_iter().filter(|s| (lo..=hi).contains(s));
        let clusters = clusters(inside.chain([lo, hi]).collect(), self.narrowest);
        let last = clusters.len() - 1;
        let cuts: Vec<f64> = (clusters.iter().enumerate())
            .map(|(k, c)| match k {
                0 => lo,
                k if k == last => hi,
                _ => 0.5 * (c.0 + c.1),
            })
            .collect();
        match cuts.len() {
            1 => vec![self.slab],
            _ => cuts.windows(2).map(|w| (w[0], w[1])).collect(),
        }
    }

    fn ends_of(&self, bands: &[(usize, i32)]) -> Vec<f64> {
        let both = bands.iter().flat_map(|&(b, turns)| {
            let (band, by) = (&self.plane.bands[b], TAU * f64::from(turns));
            [band.lo + by, band.hi + by]
        });
        let mut ends: Vec<f64> = both.collect();
        ends.dedup();
        ends
    }

    /// The values of q at which something ends where a band of the plane does.
    fn levels(&self, bands: &[(usize, i32)], q: (f64, f64)) -> Vec<f64> {
        let mut levels = Vec::new();
        let mut add = |value: f64| {
            for turns in self.plane.shifts((value, value), q) {
                levels.push(value + TAU * f64::from(turns));
            }
        };
        for &(b, _) in bands {
            let band = &self.plane.bands[b];
            for span in band.gaps.clone().filter_map(|g| self.plane.span(g)) {
                for x in [band.lo, band.hi] {
                    let (lo, hi) = span.at(x);
                    add(lo);
                    add(hi);
                }
            }
            for opening in &self.openings[b] {
                add(opening.lo);
                add(opening.hi);
            }
        }
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        levels
    }

    /// Critical values at which ends pass levels.
    fn passing(&self, ends: &[Graph<'_>], levels: &[f64], critical: &mut Vec<f64>) {
        for end in ends {
            let (a, b) = (end.at(self.slab.0), end.at(self.slab.1));
            for level in levels {
                if (a.min(b)..=a.max(b)).contains(level) {
                    critical.extend(sign_change(|s| end.at(s) - level, self.slab));
                }
            }
        }
    }

    /// Critical values at which corners of the rectangle, at an end of p, pass curves of the plane, over an interval of
    /// s in which that end stays in one band.
    fn corners(
        &self,
        end: Graph<'_>,
        q: Span<'_>,
        interval: (f64, f64),
        critical: &mut Vec<f64>,
    ) -> bool {
        let middle = 0.5 * (interval.0 + interval.1);
        let at = end.at(middle);
        let mut decided = true;
        for (b, p_turns) in self.plane.bands_over(Some((at, at.next_up()))) {
            for gap in self.plane.bands[b].gaps.clone() {
                let Some(span) = self.plane.span(gap) else {
                    continue;
                };
                for turns in self.plane.turns_of(b, gap, Some(q.hull(interval))) {
                    let span = span.turned(turns);
                    for (outer, level) in [(span.upper, q.lower), (span.lower, q.upper)] {
                        let corner = Corner {
                            outer,
                            shift: -TAU * f64::from(p_turns),
                            inner: end,
                            level,
                        };
                        decided &= corner.changes(interval, self.narrowest / 16.0, |s| {
                            critical.push(s);
                        });
                    }
                }
            }
        }
        decided
    }

    /// The cells over an interval of s in which none comes or goes.
    fn layer(&self, (lo, hi): (f64, f64), bands: &[(usize, i32)]) -> Layer {
        let (p, q) = self.rectangle(0.5 * (lo + hi));
        let mut cells = Vec::new();
        for &(b, p_turns) in bands {
            for gap in self.plane.bands[b].gaps.clone() {
                for q_turns in self.plane.turns_of(b, gap, q) {
                    let at = Place {
                        band: b as u32,
                        gap: gap as u32,
                        p_turns,
                        q_turns,
                    };
                    if self.plane.within(at, p, q).is_some() {
                        cells.push(at);
                    }
                }
            }
        }
        let beside = self.beside(&cells, p, q);
        Layer {
            lo,
            hi,
            cells,
            beside,
        }
    }

    /// Pairs of adjacent cells of a layer, where bands of the plane meet.
    fn beside(&self, cells: &[Place], p: Interval, q: Interval) -> Vec<(usize, usize, [i32; 2])> {
        let plane = self.plane;
        let mut beside = Vec::new();
        for (i, &a) in cells.iter().enumerate() {
            let last = a.band as usize + 1 == plane.bands.len();
            if last && !plane.x.circle {
                continue;
            }
            let end = plane.bands[a.band as usize].hi + TAU * f64::from(a.p_turns);
            if p.is_some_and(|(lo, hi)| !(lo < end && end < hi)) {
                continue;
            }
            let band = if last { 0 } else { a.band + 1 };
            let around = i32::from(last);
            // All bands of a full turn are in their own turn.
            let p_turns = if p.is_none() { 0 } else { a.p_turns + around };
            let whole_a = plane.span(a.gap as usize).is_none();
            let from = self.openings[a.band as usize].iter();
            for opening in from.filter(|o| o.from == a.gap as usize) {
                let whole_b = plane.span(opening.to).is_none();
                for (k, b) in cells.iter().enumerate() {
                    let is_there = b.band == band && b.p_turns == p_turns;
                    if !is_there || b.gap as usize != opening.to {
                        continue;
                    }
                    let turns = match (q, whole_a, whole_b) {
                        (None, ..) => opening.turns,
                        (Some(_), false, false) if b.q_turns != a.q_turns + opening.turns => {
                            continue;
                        }
                        _ => 0,
                    };
                    // Where the opening is, seen in the turn of the rectangle.
                    let by = match (whole_a, whole_b) {
                        (false, _) => a.q_turns..=a.q_turns,
                        (true, false) => {
                            let turns = b.q_turns - opening.turns;
                            turns..=turns
                        }
                        (true, true) => {
                            plane.shifts((opening.lo, opening.hi), q.unwrap_or((0.0, 0.0)))
                        }
                    };
                    let is_open = q.is_none_or(|(c, d)| {
                        by.into_iter().any(|turns| {
                            let by = TAU * f64::from(turns);
                            c.max(opening.lo + by) < d.min(opening.hi + by)
                        })
                    });
                    if is_open {
                        let turns = if p.is_none() {
                            [around, turns]
                        } else {
                            [0, turns]
                        };
                        beside.push((i, k, turns));
                    }
                }
            }
        }
        beside
    }
}
