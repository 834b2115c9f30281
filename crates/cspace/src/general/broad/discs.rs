//! Certainly blocked positions: those at which discs inside the two parts overlap.

use core::f64::consts::TAU;

use crate::contact::Geometry;
use crate::feature::{Plenty, inscribed_discs};
use crate::geometry::{Point, Rotation, Vector};
use crate::part::Part;

use crate::general::broad::disc::{Disc, LONG};
use crate::general::broad::disc_table::Anchors;
use crate::general::broad::grid::Grid;

/// Pairs of discs, one inside each part: a position p is blocked if |p − (a − R b)| is less than the sum of radii.
#[derive(Debug)]
pub(crate) struct Cores {
    pairs: Vec<DiscPair>,
    /// Table for large pairs; `None` for others.
    anchors: Option<Anchors>,
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct DiscPair {
    fixed: Point,
    moving: Vector,
    reach: f64,
}

impl Cores {
    pub(crate) fn new(geometry: &Geometry) -> Self {
        let contacts = &geometry.contacts;
        let plenty = if contacts.sheets.len() > MANY_SHEETS {
            Plenty::Many
        } else {
            Plenty::Few
        };
        let turns = (contacts.span.hi - contacts.span.lo) / TAU;
        let in_turn = contacts.sheets.len() as f64 / turns;
        let most = 1 + (in_turn / SHEETS_PER_DISC) as usize;
        type Discs = Vec<(Point, f64)>;
        let all = |part: &Part, center: Point, disc: Option<(Point, f64)>, fold: u32| -> Discs {
            // For small pairs only one disc of each part is kept.
            if most == 1 && disc.is_some() {
                return disc.into_iter().collect();
            }
            let discs = inscribed_discs(part, center, geometry.frame.scale, disc, fold, plenty);
            let less = |(c, r): (Point, f64)| (c, r - geometry.room);
            discs.into_iter().map(less).filter(|d| d.1 > 0.0).collect()
        };
        let fixed = all(
            geometry.fixed_part(),
            geometry.fixed_center(),
            geometry.fixed_disc,
            geometry.fixed_fold,
        );
        let moving = all(
            geometry.moving_part(),
            geometry.moving_center(),
            geometry.moving_disc,
            geometry.moving_fold,
        );
        let mut pairs = Vec::new();
        for a in &fixed {
            for b in &moving {
                pairs.push(DiscPair::new(*a, *b));
            }
        }
        pairs.sort_by(|a, b| b.reach.total_cmp(&a.reach));
        pairs.truncate(most);
        let many = plenty == Plenty::Many;
        Self {
            pairs,
            anchors: many
                .then(|| Anchors::new(geometry, &fixed, &moving))
                .flatten(),
        }
    }

    /// Only the largest disc of each part.
    pub(crate) fn single(geometry: &Geometry) -> Self {
        let both = geometry.fixed_disc.zip(geometry.moving_disc);
        Self {
            pairs: both.map(|(a, b)| DiscPair::new(a, b)).into_iter().collect(),
            anchors: None,
        }
    }

    /// Layout of the largest pair of discs alone, which is cheap to test.
    pub(crate) fn largest(&self) -> Layout<'_> {
        Layout {
            largest: self.pairs.first().copied(),
            others: Vec::new(),
            grid: None,
            anchors: None,
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
            anchors: self.anchors.as_ref(),
        }
    }
}

impl DiscPair {
    /// Pair of a disc in each part, given by centres and radii.
    fn new(fixed: (Point, f64), moving: (Point, f64)) -> Self {
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
    pub(crate) anchors: Option<&'a Anchors>,
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
