//! Certainly blocked positions: those at which discs inside the two parts overlap.

use core::f64::consts::TAU;

use crate::contact::Geometry;
use crate::feature::{SHARES, inscribed_discs};
use crate::geometry::{Point, Rotation, Vector};
use crate::part::Part;

use crate::general::broad::disc::{Disc, LONG};
use crate::general::broad::disc_table::{DiscTable, PartDisc};
use crate::general::broad::grid::Grid;

/// Pairs of discs, one inside each part: a position p is blocked if |p − (a − R b)| is less than the sum of radii.
#[derive(Debug)]
pub(crate) struct Cores {
    pairs: Vec<DiscPair>,
    /// Tables of the discs of both parts, for large pairs; `None` for others.
    pub(crate) tables: Option<DiscTables>,
    /// Whether a part has so many edges that pieces of curves are looked up in the tables, too.
    looks_up: bool,
}

/// Tables of the discs of both parts, in which pairs of discs are found that overlap at one configuration.
#[derive(Debug)]
pub(crate) struct DiscTables {
    fixed: DiscTable,
    moving: DiscTable,
}

impl DiscTables {
    /// Pairs of discs that overlap at a position, with some discs of the part that has fewer.
    pub(crate) fn overlaps(&self, p: Point, turn: Rotation) -> impl Iterator<Item = DiscPair> {
        let by_fixed = self.fixed.size() < self.moving.size();
        let (of_fixed, of_moving) = if by_fixed { (PROBES, 0) } else { (0, PROBES) };
        let (fixed_from_moving, moving_from_fixed) = placings(p, turn);
        let by_moving = self
            .moving
            .overlaps(of_moving, &self.fixed, fixed_from_moving);
        let by_fixed = self
            .fixed
            .overlaps(of_fixed, &self.moving, moving_from_fixed);
        (by_moving.map(|(m, f)| DiscPair::new(f, m)))
            .chain(by_fixed.map(|(f, m)| DiscPair::new(f, m)))
    }

    /// Calls `take` with pairs of discs that overlap at a position, until it returns true, which is then returned. Some may be missed.
    pub(crate) fn any_overlap(
        &self,
        p: Point,
        turn: Rotation,
        mut take: impl FnMut(DiscPair) -> bool,
    ) -> bool {
        let Self { fixed, moving } = self;
        let (fixed_from_moving, moving_from_fixed) = placings(p, turn);
        moving.any_overlap(fixed, fixed_from_moving, |m, f| take(DiscPair::new(f, m)))
            || fixed.any_overlap(moving, moving_from_fixed, |f, m| take(DiscPair::new(f, m)))
    }
}

/// Maps of places of the moving part to those of the fixed part, and back.
fn placings(p: Point, turn: Rotation) -> (impl Fn(Point) -> Point, impl Fn(Point) -> Point) {
    let back = turn.inverse();
    (
        move |q: Point| turn * q + p.to_vector(),
        move |q: Point| Point::ORIGIN + back * (q - p),
    )
}

/// A disc inside each part.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DiscPair {
    fixed: Point,
    moving: Vector,
    reach: f64,
}

impl Cores {
    pub(crate) fn new(geometry: &Geometry) -> Self {
        let contacts = &geometry.contacts;
        let many = contacts.sheets.len() > MANY_SHEETS;
        let turns = (contacts.span.hi - contacts.span.lo) / TAU;
        let in_turn = contacts.sheets.len() as f64 / turns;
        let most = 1 + (in_turn / SHEETS_PER_DISC) as usize;
        let (fixed_part, moving_part) = geometry.deep_layers();
        let fixed = PartDiscs::new(
            &fixed_part,
            (geometry.fixed_center(), geometry.frame.scale),
            geometry.fixed_disc,
            geometry.fixed_fold,
            (most, many),
        );
        let moving = PartDiscs::new(
            &moving_part,
            (geometry.moving_center(), geometry.frame.scale),
            geometry.moving_disc,
            geometry.moving_fold,
            (most, many),
        );
        // The moving part may be smaller than drawn; then vertices are outside.
        let less = |(c, r): PartDisc| (r >= geometry.room).then_some((c, r - geometry.room));
        let mut pairs = Vec::new();
        for a in fixed.paired.iter().copied().filter_map(less) {
            for b in moving.paired.iter().copied().filter_map(less) {
                pairs.push(DiscPair::new(a, b));
            }
        }
        pairs.sort_by(|a, b| b.reach.total_cmp(&a.reach));
        pairs.truncate(most);
        let table = |of: PartDiscs| {
            let [probes, listed] =
                [of.probes, of.listed].map(|discs| discs.into_iter().filter_map(less).collect());
            DiscTable::new(probes, listed)
        };
        let tables = many.then(|| table(fixed).zip(table(moving))).flatten();
        let tables = tables.map(|(fixed, moving)| DiscTables { fixed, moving });
        let parts = [&fixed_part, &moving_part];
        Self {
            pairs,
            tables,
            looks_up: parts.iter().any(|p| p.edges().count() > FEW_EDGES),
        }
    }

    /// Only the largest disc of each part.
    pub(crate) fn single(geometry: &Geometry) -> Self {
        let both = geometry.fixed_disc.zip(geometry.moving_disc);
        Self {
            pairs: both.map(|(a, b)| DiscPair::new(a, b)).into_iter().collect(),
            tables: None,
            looks_up: false,
        }
    }

    /// Layout of the largest pair of discs alone, which is cheap to test.
    pub(crate) fn largest(&self) -> Layout<'_> {
        Layout {
            largest: self.pairs.first().copied(),
            others: Vec::new(),
            grid: None,
            tables: None,
        }
    }

    /// Layout of all pairs of discs about an orientation.
    pub(crate) fn about(&self, theta: f64) -> Layout<'_> {
        let turn = Rotation::by(theta);
        let mut pairs = self.pairs.iter();
        let largest = pairs.next().copied();
        let place = |p: &DiscPair| {
            let disc = p.at(turn);
            largest.map_or(Some((disc.center, disc.reach)), |l| {
                disc.outside(&l.at(turn))
            })
        };
        let others: Vec<_> = pairs
            .filter_map(|p| place(p).map(|rough| (*p, rough)))
            .collect();
        Layout {
            largest,
            grid: (others.len() > FEW).then(|| Grid::new(others.iter().map(|o| o.1), LONG)),
            others,
            tables: self.tables.as_ref().filter(|_| self.looks_up),
        }
    }
}

/// Discs inside one part.
struct PartDiscs {
    /// Discs of which every pair is tried.
    paired: Vec<PartDisc>,
    /// For large pairs, those that are looked up in the other part's table, and those in the table. Vertices are discs of radius 0: they
    /// reach farthest into the other part.
    probes: Vec<PartDisc>,
    listed: Vec<PartDisc>,
}

impl PartDiscs {
    /// Discs of a part, the largest of which is known: that one alone if there is to be `most` one pair.
    fn new(
        part: &Part,
        (center, scale): (Point, f64),
        largest: Option<PartDisc>,
        fold: u32,
        (most, many): (usize, bool),
    ) -> Self {
        /// Share of its radius by which a disc mostly lies within another.
        const MOSTLY: f64 = 0.7;
        /// As above, for discs that are hardly others: a disc that touches a corner beside a larger one is another.
        const HARDLY: f64 = 0.995;
        let edges = part.edges().count();
        if most == 1 && largest.is_some() || !many && edges > FEW_EDGES {
            return Self {
                paired: largest.into_iter().collect(),
                probes: Vec::new(),
                listed: Vec::new(),
            };
        }
        let shares = |discs: usize| (discs / edges).min(SHARES.len());
        let (paired, listed) = if many {
            (shares(MOST_PAIRED).max(1), shares(LISTED).max(1))
        } else {
            (1, 1)
        };
        let discs = inscribed_discs(part, center, scale, fold, listed);
        // Discs of which no such share is within one before.
        let apart = |discs: &[Vec<PartDisc>], share: f64, most: usize| {
            let mut apart: Vec<PartDisc> = largest.into_iter().collect();
            for d in discs.iter().flatten() {
                if apart.len() < most
                    && !apart.iter().any(|o| o.0.distance(d.0) + share * d.1 < o.1)
                {
                    apart.push(*d);
                }
            }
            apart
        };
        let with_vertices = |mut discs: Vec<PartDisc>| {
            let place = |p: Point| Point::ORIGIN + (p - center) * scale;
            if many {
                discs.extend(part.edges().map(|e| (place(e.start), 0.0)));
            }
            discs
        };
        Self {
            paired: apart(&discs[..paired], MOSTLY, MOST_PAIRED),
            probes: with_vertices(apart(&discs[..1], MOSTLY, MOST_LISTED)),
            listed: with_vertices(apart(&discs, HARDLY, MOST_LISTED)),
        }
    }
}

impl DiscPair {
    /// Pair of a disc in each part, given by centres and radii.
    pub(crate) fn new(fixed: PartDisc, moving: PartDisc) -> Self {
        Self {
            fixed: fixed.0,
            moving: moving.0.to_vector(),
            reach: fixed.1 + moving.1,
        }
    }

    pub(crate) fn at(&self, turn: Rotation) -> Disc {
        Disc {
            center: self.fixed + (-(turn * self.moving)),
            moving: self.moving,
            reach: self.reach,
        }
    }
}

/// Number of sheets in a turn per additional disc: for small pairs, testing more discs costs more than it saves.
const SHEETS_PER_DISC: f64 = 64.0;

/// Number of sheets above which crossings in blocked space dominate, so that many discs save more than they cost.
const MANY_SHEETS: usize = 8192;

/// Number of discs of a part above which they cost more than they save where curves are looked for that they cover.
const MOST_PAIRED: usize = 64;

/// Number of discs of each part that are looked up for a piece of a curve: smaller ones add little.
const PROBES: usize = 24;

/// Number of discs of a part about which those in the table are to be.
const LISTED: usize = 1024;

/// Number of discs that touch edges of a part above which others are left out.
const MOST_LISTED: usize = 4096;

/// Number of edges above which a part has only its largest disc in small pairs, and discs are looked up for pieces of curves in large ones.
const FEW_EDGES: usize = 400;

/// Number of discs up to which they are tested one by one, which is faster than a grid.
const FEW: usize = 16;

/// The discs near some orientation, in a grid that finds those worth testing.
#[derive(Debug)]
pub(crate) struct Layout<'a> {
    /// The largest disc, which covers most of what is covered at all.
    pub(crate) largest: Option<DiscPair>,
    /// The other discs, each with a disc that contains its part outside the largest one.
    pub(crate) others: Vec<(DiscPair, (Point, f64))>,
    /// Grid of the other discs, unless they are few.
    grid: Option<Grid>,
    /// Tables of the discs of both parts, if the pairs of discs are too few to cover what is blocked.
    pub(crate) tables: Option<&'a DiscTables>,
}

impl Layout<'_> {
    /// The other discs that may cover a piece of a curve that lies within `reach` of a place.
    pub(crate) fn near(&self, middle: Point, reach: f64) -> impl Iterator<Item = usize> + '_ {
        let close = move |i: &usize| {
            let (center, radius) = self.others[*i].1;
            let sum = radius + reach;
            (middle - center).length_squared() < sum * sum
        };
        let (few, near) = match &self.grid {
            None => (0..self.others.len(), [].as_slice()),
            Some(grid) => (0..0, grid.near(middle)),
        };
        few.chain(near.iter().map(|&i| i as usize)).filter(close)
    }
}
