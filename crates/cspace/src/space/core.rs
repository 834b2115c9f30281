//! Where a sheet is in blocked space for certain: discs inside the two parts overlap.

use crate::contact::{Geometry, Sheet};
use crate::feature::inscribed_discs;
use crate::geometry::{Point, Rotation};

/// Pairs of discs, one inside each part: a position p is blocked if |p − (a − R b)| is less than the sum of radii.
#[derive(Debug)]
pub(super) struct Cores {
    pairs: Vec<DiscPair>,
}

#[derive(Debug, Clone, Copy)]
struct DiscPair {
    fixed: Point,
    moving: Point,
    reach: f64,
}

impl Cores {
    pub(super) fn new(geometry: &Geometry) -> Self {
        /// Up to this many pairs, all are used; beyond, those with the largest disc of either part.
        const ALL_PAIRS: usize = 100;
        let frame = &geometry.frame;
        let fixed = inscribed_discs(
            geometry.fixed_part(),
            geometry.fixed_center(),
            frame.scale,
            geometry.fixed.disc,
            geometry.fixed_fold,
        );
        let moving = inscribed_discs(
            geometry.moving_part(),
            geometry.moving_center(),
            frame.scale,
            geometry.moving.disc,
            geometry.moving_fold,
        );
        let all = fixed.len() * moving.len() <= ALL_PAIRS;
        let mut pairs = Vec::new();
        for (i, a) in fixed.iter().enumerate() {
            for (j, b) in moving.iter().enumerate() {
                if all || i == 0 || j == 0 {
                    pairs.push(DiscPair {
                        fixed: a.0,
                        moving: b.0,
                        reach: a.1 + b.1,
                    });
                }
            }
        }
        pairs.retain(|p| p.reach > 0.0);
        pairs.sort_by(|a, b| b.reach.total_cmp(&a.reach));
        Self { pairs }
    }

    /// Whether the whole sheet is blocked at all orientations within `half` of the middle one.
    pub(super) fn cover(&self, sheet: &Sheet, mid: f64, turn: Rotation, half: f64) -> bool {
        let (start, end) = (sheet.start.at(turn), sheet.end.at(turn));
        // On an arc, the furthest point from anywhere is at most the sagitta further than the ends.
        let bulge = if sheet.is_circle() {
            let spread = 0.5 * (sheet.end_angle.at(mid) - sheet.start_angle.at(mid)).abs() + half;
            sheet.radius.abs() * (1.0 - spread.min(core::f64::consts::PI).cos())
        } else {
            0.0
        };
        self.pairs.iter().any(|pair| {
            let center = pair.fixed + (-(turn * pair.moving.to_vector()));
            // Relative to the discs the ends move by R (w + b).
            let reach = |end: Point, w: crate::Vector| {
                let room = pair.reach - bulge - (w + pair.moving.to_vector()).length() * half;
                room > 0.0 && (end - center).length_squared() < room * room
            };
            reach(start, sheet.start.w) && reach(end, sheet.end.w)
        })
    }
}
