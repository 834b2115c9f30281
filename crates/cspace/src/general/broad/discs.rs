//! Where positions are blocked for certain: discs inside the two parts overlap.

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
    /// Only of large pairs.
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
            // Of small pairs one disc of each part is all that is kept.
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

    /// The largest disc of each part alone.
    pub(crate) fn single(geometry: &Geometry) -> Self {
        let both = geometry.fixed_disc.zip(geometry.moving_disc);
        Self {
            pairs: both.map(|(a, b)| DiscPair::new(a, b)).into_iter().collect(),
            anchors: None,
        }
    }

    /// The largest of them alone, which costs little to ask.
    pub(crate) fn largest(&self) -> Layout<'_> {
        Layout {
            largest: self.pairs.first().copied(),
            others: Vec::new(),
            grid: None,
            anchors: None,
        }
    }

    /// Where they are about an orientation.
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

/// One more disc for so many sheets in a turn: asking more costs small pairs more than they save.
const SHEETS_PER_DISC: f64 = 64.0;

/// With more sheets than this the time goes into crossings in blocked space, and many discs save more than they cost.
const MANY_SHEETS: usize = 8192;

/// So many discs are asked one by one faster than they are put into a grid.
const FEW: usize = 16;

/// The discs in a grid, as they are about some orientation: it tells which of them are worth a look.
#[derive(Debug)]
pub(crate) struct Layout<'a> {
    /// The largest, which covers most that is covered at all.
    pub(crate) largest: Option<DiscPair>,
    /// The others, each with a disc about what it has outside the largest.
    pub(crate) others: Vec<(DiscPair, (Point, f64))>,
    /// Unless they are few.
    grid: Option<Grid>,
    pub(crate) anchors: Option<&'a Anchors>,
}

impl Layout<'_> {
    /// Which of the other discs may cover some of a curve that lies within `reach` of a place.
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
