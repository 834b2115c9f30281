//! Table of discs inside the part with more edges, for pairs so large that this pays.
//!
//! A disc inside one part and a disc inside the other block positions, and a few discs of each part exclude most of what is blocked. For a
//! part with thousands of edges a few discs are not enough. The table has, for every square of a grid over the part, a disc of its material
//! near the middle of the square: about the middle if that is inside, otherwise the nearest place of the boundary, a disc of radius 0. For
//! a disc of the other part, wherever it is, the table then has the disc that overlaps it most, approximately.

use crate::parallel::prelude::*;

use crate::contact::Geometry;
use crate::feature::Material;
use crate::geometry::{Point, Rotation, Vector};
use crate::part::Bounds;

use crate::general::broad::disc::Disc;

/// The table, and the discs of the other part that are looked up in it.
#[derive(Debug)]
pub(crate) struct Anchors {
    /// Whether the table is for the moving part.
    of_moving: bool,
    /// Discs of the other part, the largest first.
    others: Vec<(Point, f64)>,
    corner: Point,
    /// Squares per unit of length; columns and rows of the table.
    scale: f64,
    columns: usize,
    rows: usize,
    /// Centres and radii, row by row.
    table: Vec<(Point, f64)>,
}

/// Number of squares per sheet, and maximum: the saving of a lookup grows with the number of sheets. At the maximum the table takes 6 MB
/// and some tenths of a second.
const SQUARES_PER_SHEET: usize = 4;
const MOST_SQUARES: usize = 1 << 18;

/// Number of discs of the other part that are looked up: smaller ones add little.
const OTHERS: usize = 24;

/// Lower bound of the ratio of the smallest distance to that of the place found: the search for the nearest place is approximate.
const NEARLY: f64 = 0.95;

/// Length by which discs are shrunk: far above rounding, in the pair's frame.
const ALLOWANCE: f64 = 1e-9;

impl Anchors {
    /// Anchors on the part with more edges, for `fixed` and `moving` discs inside the parts, the largest first.
    pub(crate) fn new(
        geometry: &Geometry,
        fixed: &[(Point, f64)],
        moving: &[(Point, f64)],
    ) -> Option<Self> {
        let of_moving =
            geometry.moving_part().edges().count() > geometry.fixed_part().edges().count();
        let (part, center, others) = if of_moving {
            (geometry.moving_part(), geometry.moving_center(), fixed)
        } else {
            (geometry.fixed_part(), geometry.fixed_center(), moving)
        };
        others.first()?;
        let material = Material::new(part, center, geometry.frame.scale);
        let squares = geometry
            .contacts
            .sheets
            .len()
            .saturating_mul(SQUARES_PER_SHEET);
        let mut this = Self::over(material.bounds(), squares.min(MOST_SQUARES));
        let (columns, step) = (this.columns, 1.0 / this.scale);
        this.table = (0..this.rows)
            .into_par_iter()
            .flat_map_iter(|row| {
                let middle = |column: usize| {
                    this.corner
                        + Vector::new((column as f64 + 0.5) * step, (row as f64 + 0.5) * step)
                };
                // A point nearer than the boundary is on the same side of it.
                let (mut beside, mut inside, mut nearest) = (0.0, false, None);
                let mut line = Vec::with_capacity(columns);
                for p in (0..columns).map(middle) {
                    /// The boundary is within the unit disc, and so is the square: no distance exceeds this.
                    const FARTHEST: f64 = 4.0;
                    let within = nearest.map_or(FARTHEST, |d: f64| (d + 2.0 * step) / NEARLY);
                    let closest = material.closest(p, within, NEARLY);
                    nearest = closest.map(|c| c.1);
                    // A disc at an undefined place overlaps nothing.
                    let nowhere = (Point::new(f64::NAN, f64::NAN), 0.0);
                    let (q, distance) = closest.unwrap_or(nowhere);
                    if beside * NEARLY <= step + ALLOWANCE {
                        inside = material.contains(p);
                    }
                    beside = distance;
                    line.push(if inside && distance * NEARLY > ALLOWANCE {
                        (p, distance * NEARLY - ALLOWANCE)
                    } else {
                        (q, 0.0)
                    });
                }
                line
            })
            .collect();
        this.of_moving = of_moving;
        this.others = others.iter().take(OTHERS).copied().collect();
        Some(this)
    }

    /// An empty table of about `squares` squares over a box.
    fn over(bounds: Bounds, squares: usize) -> Self {
        let (width, height) = (bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y);
        // Limits the aspect ratio, so that one side does not have more squares than requested.
        let longer = width.max(height).max(f64::MIN_POSITIVE);
        let thin = longer / squares as f64;
        let scale = (squares as f64 / (width.max(thin) * height.max(thin))).sqrt();
        let along = |length: f64| ((length * scale).ceil() as usize).max(1);
        Self {
            of_moving: false,
            others: Vec::new(),
            corner: bounds.min,
            scale,
            columns: along(width),
            rows: along(height),
            table: Vec::new(),
        }
    }

    /// The pairs of discs that overlap at a position, according to the table: one for each disc of the other part.
    pub(crate) fn at(&self, p: Point, turn: Rotation) -> impl Iterator<Item = Disc> + '_ {
        let back = turn.inverse();
        (self.others.iter()).filter_map(move |&(center, radius)| {
            let disc = if self.of_moving {
                let (q, r) = self.near(Point::ORIGIN + back * (center - p));
                Disc {
                    center: center + (-(turn * q.to_vector())),
                    moving: q.to_vector(),
                    reach: radius + r,
                }
            } else {
                let moving = center.to_vector();
                let (q, r) = self.near(p + turn * moving);
                Disc {
                    center: q + (-(turn * moving)),
                    moving,
                    reach: radius + r,
                }
            };
            ((p - disc.center).length_squared() < disc.reach * disc.reach).then_some(disc)
        })
    }

    /// The table's disc near a place; for places beyond the grid, that of the nearest square.
    fn near(&self, p: Point) -> (Point, f64) {
        let v = (p - self.corner) * self.scale;
        // Negative coordinates become 0.
        let (column, row) = (v.x as usize, v.y as usize);
        self.table[row.min(self.rows - 1) * self.columns + column.min(self.columns - 1)]
    }
}
