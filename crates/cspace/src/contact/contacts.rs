//! All sheets of a pair of parts, and the ends that they share.

use crate::feature::Outline;
use crate::feature::tolerance::NARROWEST_BAND;

use super::build::sheets;
use super::end_names::EndNames;
use super::sheet::{Seam, Sheet};
use super::symmetry::{Period, Span};

/// The sheets, indexed by their ends.
#[derive(Debug)]
pub(crate) struct Contacts {
    pub(crate) sheets: Vec<Sheet>,
    pub(crate) span: Span,
    /// Smallest name of an end that belongs to two vertices.
    pub(crate) first_vertex_name: u32,
    /// For every end name, the sheets that end there and the sheets that start there; sorted by name.
    ends: Vec<(u32, u32)>,
    starts: Vec<(u32, u32)>,
    /// Permutation of the features from period to period.
    pub(crate) period: Period,
    names: EndNames,
}

impl Contacts {
    /// The name of the corresponding end one period lower.
    pub(crate) fn name_below(&self, name: u32) -> u32 {
        self.names.name_below(name, &self.period)
    }

    /// The corresponding feature pair one period lower.
    pub(crate) fn pair_below(&self, fixed: u32, moving: u32) -> (u32, u32) {
        (
            self.period.fixed_back.features[fixed as usize],
            self.period.moving_back.features[moving as usize],
        )
    }

    /// The sheets that end at a name.
    pub(crate) fn ending_at(&self, name: u32) -> impl Iterator<Item = u32> + '_ {
        run(&self.ends, name)
    }

    /// The sheets that start at a name.
    pub(crate) fn starting_at(&self, name: u32) -> impl Iterator<Item = u32> + '_ {
        run(&self.starts, name)
    }

    /// Whether a circle lies between the curves of two lines wherever both exist, tangent to both.
    ///
    /// It turns by less than half a turn, so that the lines cross at a distance ρ tan(φ/2) beyond its ends: the curves do not cross. That
    /// distance vanishes to first order where the circle begins, and the height of an end over the other line to second order, so that a
    /// computation would decide little.
    fn bridged(&self, f: &Sheet, g: &Sheet) -> bool {
        let lines = f.is_line() && g.is_line() && f.locus.carrier.kind != g.locus.carrier.kind;
        let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
        let bridge = |before: &Sheet, after: &Sheet| {
            self.starting_at(before.end.name).any(|c| {
                let c = &self.sheets[c as usize];
                !c.is_line()
                    && c.end.name == after.start.name
                    && c.lo <= lo + NARROWEST_BAND
                    && c.hi >= hi - NARROWEST_BAND
            })
        };
        lines && (bridge(f, g) || bridge(g, f))
    }

    /// Whether two sheets must be searched for crossings: they are not known to be tangent, or one, by construction.
    pub(crate) fn may_cross(&self, f: &Sheet, g: &Sheet) -> bool {
        !f.shared_ends(g, self.first_vertex_name).tangent && !self.bridged(f, g)
    }

    /// Finds the sheets of the pair in the window. Stops after about `most` sheets; the result is then incomplete.
    pub(crate) fn new(
        fixed: &Outline,
        moving: &Outline,
        span: Span,
        period: Period,
        most: usize,
    ) -> Self {
        let names = EndNames::new(fixed, moving);
        let sheets = sheets(fixed, moving, span, &period, most);
        Self::of(sheets, span, period, names)
    }

    /// Contacts within a part of the window; `sheets` must include all sheets that exist there.
    pub(crate) fn within(&self, span: Span, sheets: &[u32]) -> Self {
        let window = || Seam::Window;
        let sheets = (sheets.iter().map(|&i| &self.sheets[i as usize]))
            .filter(|s| s.lo < span.hi && span.lo < s.hi)
            .filter_map(|s| s.cut(span, window, window))
            .collect();
        Self::of(sheets, span, self.period.clone(), self.names)
    }

    fn of(sheets: Vec<Sheet>, span: Span, period: Period, names: EndNames) -> Self {
        let index = |name: fn(&Sheet) -> u32| {
            let mut list: Vec<(u32, u32)> = (0..).zip(&sheets).map(|(i, s)| (name(s), i)).collect();
            list.sort_unstable();
            list
        };
        let (starts, ends) = (index(|s| s.start.name), index(|s| s.end.name));
        Self {
            sheets,
            span,
            first_vertex_name: names.first_vertex(),
            ends,
            starts,
            period,
            names,
        }
    }
}

fn run(list: &[(u32, u32)], name: u32) -> impl Iterator<Item = u32> + '_ {
    let from = list.partition_point(|e| e.0 < name);
    list[from..]
        .iter()
        .take_while(move |e| e.0 == name)
        .map(|e| e.1)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
