//! Errors of a stack and its surface relative to the exact contact space, and where they are wrong.

use core::f64::consts::TAU;

use cspace::{ContactSpace, PatchId, Slice};
use rayon::prelude::*;

use crate::{Layer, Stack, Surface};

/// Errors of a polyhedral surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// The largest gap, in the model's unit: half way between two consecutive slices, from the straight boundary line to the
    /// boundary curve of the patch it stands for. Only patches that exist over the whole layer count, so that the curve is there.
    ///
    /// It shrinks with the square of the separation where boundary curves are smooth, and with its root where two contact
    /// curves become tangent.
    pub largest_gap: f64,
    /// The orientation of the largest gap, radians.
    pub largest_gap_theta: f64,
    /// Number of boundary lines that were compared.
    pub boundary_lines: usize,
    /// Layers in which free and blocked configurations are joined: the surface has a hole there, or is torn between neighbours,
    /// or goes across what separates two pieces of contact. Every patch that begins or ends between two slices makes one.
    pub open_layers: usize,
    /// Curves joined to none, each with a hole beside it.
    pub left_open: usize,
    /// Joined curves that belong to different patches, of which the upper does not continue the lower between the two slices:
    /// the surface goes straight across free or blocked configurations between two separate pieces of contact.
    pub joined_across: usize,
    /// Curves whose patch is not known; 0 unless the slices are not of the same pair as the space.
    pub unknown: usize,
}

/// Compares a surface with the exact contact space of its pair, computed for the full turn.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// use cspace_baseline::{Stack, Surface, compare, with_bands};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let (table, block) = (square("table", 2.0)?, square("block", 1.0)?);
/// let space = ContactSpace::compute(&table, &block, &Options::default())?;
/// let stack = Stack::new(&table, &block, &with_bands(0.005, &space.bands())?);
/// let errors = compare::errors(&stack, &Surface::new(&stack, 0.01), &space);
/// // Corners of the block go around those of the table on circles of radius √2; a chord of 0.005 rad is r 0.005² / 8 off.
/// assert!((errors.largest_gap / (2f64.sqrt() * 0.005f64.powi(2) / 8.0) - 1.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn errors(stack: &Stack, surface: &Surface, space: &ContactSpace) -> Errors {
    let patches: Vec<Vec<Option<PatchId>>> = (stack.slices.par_iter())
        .map(|slice| patches_of(slice, space))
        .collect();
    let continued = Continued::new(space);
    let layers = surface.layers.par_iter().map(|layer| {
        let above = (layer.slice + 1) % stack.slices.len();
        let (lower, upper) = (&stack.slices[layer.slice], &stack.slices[above]);
        let patches = [&patches[layer.slice][..], &patches[above][..]];
        layer_errors(layer, [lower, upper], patches, space, &continued)
    });
    let layers: Vec<Errors> = layers.collect();
    layers.into_iter().fold(Errors::default(), |mut sum, e| {
        if e.largest_gap > sum.largest_gap {
            sum.largest_gap = e.largest_gap;
            sum.largest_gap_theta = e.largest_gap_theta;
        }
        sum.boundary_lines += e.boundary_lines;
        sum.open_layers += e.open_layers;
        sum.joined_across += e.joined_across;
        sum.left_open += e.left_open;
        sum.unknown += e.unknown;
        sum
    })
}

/// Number of bands of the exact space that contain none of the orientations (in radians, increasing, within one turn).
/// A stack of slices there cannot show the changes in such a band, and takes the changes at both its ends for one
/// change, or for none.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// assert_eq!(space.bands().len(), 4); // a quarter turn each
/// assert_eq!(cspace_baseline::compare::missed_bands(&space, &[-0.1, 0.1, 0.2]), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn missed_bands(space: &ContactSpace, orientations: &[f64]) -> usize {
    let has = |lo: f64, hi: f64| {
        let after = orientations.partition_point(|&t| t < lo);
        orientations.get(after).is_some_and(|&t| t <= hi)
    };
    (space.bands().iter())
        .filter(|b| {
            let turns = [-TAU, 0.0, TAU];
            !turns.iter().any(|turn| has(b.lo + turn, b.hi + turn))
        })
        .count()
}

/// The patch of each curve of a slice: of those in the exact slice with the same features, the one whose ends are nearest.
fn patches_of(slice: &Slice, space: &ContactSpace) -> Vec<Option<PatchId>> {
    let exact = space.slice(slice.theta);
    let patch = |curve: &cspace::SliceCurve| {
        let off = |other: &cspace::SliceCurve| {
            let at = |s: f64| curve.geometry.point(s).distance(other.geometry.point(s));
            at(0.0) + at(1.0)
        };
        (exact.curves.iter())
            .filter(|c| (c.fixed, c.moving) == (curve.fixed, curve.moving))
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .and_then(|c| c.patch)
    };
    slice.curves.iter().map(patch).collect()
}

/// For each patch the patches of the same features that continue it upwards, with the orientation.
struct Continued {
    above: Vec<Vec<(f64, PatchId)>>,
}

impl Continued {
    fn new(space: &ContactSpace) -> Self {
        let patches = space.patches();
        let mut above = vec![Vec::new(); patches.len()];
        for link in space.vertical_links() {
            let [a, b] = [link.lower, link.upper].map(|i| &patches[i.index()]);
            if (a.fixed, a.moving) == (b.fixed, b.moving) {
                above[link.lower.index()].push((link.theta, link.upper));
            }
        }
        Self { above }
    }

    /// Whether a patch is connected with another one by patches that continue it between two orientations.
    fn leads(&self, from: PatchId, to: PatchId, (lo, hi): (f64, f64)) -> bool {
        let mut open = vec![from];
        let mut seen = vec![from];
        while let Some(patch) = open.pop() {
            if patch == to {
                return true;
            }
            for &(theta, next) in &self.above[patch.index()] {
                let turned = theta + TAU * ((lo - theta) / TAU).ceil();
                if turned <= hi && !seen.contains(&next) {
                    seen.push(next);
                    open.push(next);
                }
            }
        }
        false
    }
}

fn layer_errors(
    layer: &Layer,
    slices: [&Slice; 2],
    patches: [&[Option<PatchId>]; 2],
    space: &ContactSpace,
    continued: &Continued,
) -> Errors {
    let middle = 0.5 * (layer.theta.0 + layer.theta.1);
    let mut errors = Errors {
        left_open: layer.open,
        ..Errors::default()
    };
    for &(i, j) in &layer.joined {
        let (Some(lower), Some(upper)) = (patches[0][i as usize], patches[1][j as usize]) else {
            errors.unknown += 1;
            continue;
        };
        if lower != upper {
            if !continued.leads(lower, upper, layer.theta) {
                errors.joined_across += 1;
            }
            continue;
        }
        let Some(patch) = space
            .patch(lower)
            .filter(|p| p.contains_orientation(middle))
        else {
            // One patch that ends and, nearly a turn later, begins.
            errors.joined_across += 1;
            continue;
        };
        let ends = [(0.0, patch.left()), (1.0, patch.right())];
        for (s, boundary) in ends {
            let [a, b] = [(slices[0], i), (slices[1], j)]
                .map(|(slice, k)| slice.curves[k as usize].geometry.point(s));
            let exact = boundary.at(middle).position();
            let gap = a.midpoint(b).distance(exact);
            errors.boundary_lines += 1;
            if gap > errors.largest_gap {
                errors.largest_gap = gap;
                errors.largest_gap_theta = middle;
            }
        }
    }
    errors.open_layers = usize::from(!layer.closed || errors.joined_across > 0);
    errors
}
