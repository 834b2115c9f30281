//! All data of a pair of parts that do not depend on the orientation.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use crate::feature::tolerance::{
    GROWTH, MOVED_IN_ROOM, MOVING_GROWTH, MOVING_PERTURBATION, PERTURBATION, ROOM,
};
use crate::feature::{Outline, PairFrame, Perturbation, inscribed_disc};
use crate::geometry::{Configuration, Point, Rotation};
use crate::part::{LoopImage, Part};

use crate::number::Dd;

use super::contacts::Contacts;
use super::crossing::Crossed;
use super::curve::Curve;
use super::cycle::Cycle;
use super::locus::Locus;
use super::orientation::Orientation;
use super::overlap::{Body, overlap};
use super::symmetry::{Period, Span, Steps};

/// A pair in its own frame: outlines, sheets, and the bodies for overlap tests.
#[derive(Debug)]
pub(crate) struct Geometry {
    pub(crate) frame: PairFrame,
    pub(crate) fixed: Arc<Outline>,
    pub(crate) moving: Arc<Outline>,
    pub(crate) contacts: Contacts,
    /// The layers of the two parts that meet in which the largest discs are.
    deep_layers: (usize, usize),
    /// A large disc inside these layers, centre and radius; `None` if none is found.
    pub(crate) fixed_disc: Option<(Point, f64)>,
    pub(crate) moving_disc: Option<(Point, f64)>,
    /// Folds of the parts about the origin, if they were made exactly symmetric.
    pub(crate) fixed_fold: u32,
    pub(crate) moving_fold: u32,
    /// Length by which the moving part is smaller than drawn.
    pub(crate) room: f64,
    fixed_body: Arc<Body>,
    moving_body: Arc<Body>,
    /// Loci of sheets in double-double, each computed when first needed.
    exact: Vec<OnceLock<Box<Locus<Dd>>>>,
}

/// Empty cells for the loci in double-double.
fn unmade(contacts: &Contacts) -> Vec<OnceLock<Box<Locus<Dd>>>> {
    contacts.sheets.iter().map(|_| OnceLock::new()).collect()
}

/// Numbers for orientations of events, and for decisions that f64 leaves open: double-double.
pub(crate) type Exact = Dd;

/// Numbers in which the loci of a pair are available: f64 and [`Exact`].
pub(crate) trait Precision: Crossed {
    /// The locus of a sheet.
    fn locus(geometry: &Geometry, sheet: u32) -> &Locus<Self>;
}

impl Precision for f64 {
    fn locus(geometry: &Geometry, sheet: u32) -> &Locus<Self> {
        &geometry.contacts.sheets[sheet as usize].locus
    }
}

impl Precision for Dd {
    fn locus(geometry: &Geometry, sheet: u32) -> &Locus<Self> {
        geometry.exact[sheet as usize].get_or_init(|| {
            let rough = &geometry.contacts.sheets[sheet as usize];
            Box::new(rough.exact(&geometry.fixed, &geometry.moving))
        })
    }
}

/// Change of the outlines of a pair that decides how exact fits count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fit {
    /// Both parts are grown: an exact fit is an overlap.
    Overlaps,
    /// The moving part is shrunk by [`ROOM`]: an exact fit has play.
    HasPlay,
}

/// A part as it is computed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<'a> {
    pub(crate) part: &'a Part,
    /// The point that becomes the origin of the pair's frame, in the part's frame.
    pub(crate) center: Point,
    /// The point that becomes the origin of the pair's frame, in the frame of the part as the user drew it.
    pub(crate) drawn_center: Point,
    /// Images of its loops under one step of its symmetry, if it is drawn in order of travel and about its centre.
    pub(crate) images: Option<&'a [LoopImage]>,
    /// The fold of that symmetry, or 1.
    pub(crate) fold: u32,
}

impl<'a> Placed<'a> {
    /// A part as drawn, about the centre of its box.
    pub(crate) fn as_drawn(part: &'a Part) -> Self {
        let center = PairFrame::center(part);
        Self {
            part,
            center,
            drawn_center: center,
            images: None,
            fold: 1,
        }
    }
}

impl Geometry {
    /// Prepares a pair. `window` of `None` is the full turn. If there are more than `most` sheets, not all are made.
    pub(crate) fn new(
        fixed: &Part,
        moving: &Part,
        window: Option<(f64, f64)>,
        most: usize,
    ) -> Self {
        Self::attempt(fixed, moving, (Fit::Overlaps, 0), window, most)
    }

    /// Prepares a pair as [`new`](Self::new), with a choice of how exact fits count, and with another perturbation for each attempt.
    pub(crate) fn attempt(
        fixed: &Part,
        moving: &Part,
        (fit, attempt): (Fit, u64),
        window: Option<(f64, f64)>,
        most: usize,
    ) -> Self {
        let (fixed, moving) = (Placed::as_drawn(fixed), Placed::as_drawn(moving));
        let outlines = Outlines::new(fixed, moving, fit, attempt);
        let period = Period::none(&outlines.fixed, &outlines.moving);
        let span = match window {
            Some((lo, hi)) => Span {
                lo,
                hi,
                full: false,
            },
            None => Span::slab(&outlines.fixed, &outlines.moving, 1),
        };
        outlines.sheets(span, period, most)
    }

    /// Prepares one period of a symmetric pair, with another perturbation for each attempt. `None` if features do not correspond under the symmetry.
    pub(crate) fn slab(
        fixed: Placed<'_>,
        moving: Placed<'_>,
        steps: Steps,
        most: usize,
        attempt: u64,
    ) -> Option<Self> {
        let outlines = Outlines::new(fixed, moving, Fit::Overlaps, attempt);
        let period = Period::new(
            steps,
            (&outlines.fixed, fixed.images),
            (&outlines.moving, moving.images),
        )?;
        let span = Span::slab(&outlines.fixed, &outlines.moving, steps.slabs);
        Some(outlines.sheets(span, period, most))
    }

    /// The whole line or circle of a sheet at an orientation.
    pub(crate) fn cycle<T: Precision>(&self, sheet: u32, turn: Rotation<T>) -> Cycle<T> {
        T::locus(self, sheet).carrier.cycle(turn)
    }

    /// The curve of a sheet at an orientation.
    pub(crate) fn curve<T: Precision>(&self, sheet: u32, at: &Orientation<T>) -> Curve<T> {
        self.contacts.sheets[sheet as usize].curve_on(T::locus(self, sheet), at)
    }

    /// The curve of a sheet in f64, with the rotation in f64.
    ///
    /// Ends that turn about a far centre are lost in the rounding of their orientations to f64, by an error proportional to the distance of
    /// the centre: where a flat arc is involved, the curve is computed in double-double and rounded, so that places measured from its
    /// middle are right.
    pub(crate) fn rounded_curve(&self, sheet: u32, theta: Dd, turn: Rotation) -> Curve {
        let of = &self.contacts.sheets[sheet as usize];
        if of.is_flat() {
            return self.curve(sheet, &Orientation::by(theta)).rounded();
        }
        of.curve(theta.to_f64(), turn)
    }

    /// The pair restricted to an interval of orientations; `sheets` must include all sheets that exist there.
    pub(crate) fn within(&self, (lo, hi): (f64, f64), sheets: &[u32]) -> Self {
        let full = false;
        let contacts = self.contacts.within(Span { lo, hi, full }, sheets);
        Self {
            exact: unmade(&contacts),
            contacts,
            fixed: self.fixed.clone(),
            moving: self.moving.clone(),
            fixed_body: self.fixed_body.clone(),
            moving_body: self.moving_body.clone(),
            ..*self
        }
    }

    /// A layer of each part that meets the other: where discs inside them overlap, the parts do.
    pub(crate) fn deep_layers(&self) -> (Cow<'_, Part>, Cow<'_, Part>) {
        let (fixed, moving) = self.deep_layers;
        (
            self.fixed_body.part().layer(fixed),
            self.moving_body.part().layer(moving),
        )
    }

    /// The point of the fixed part, as computed, that is the origin.
    pub(crate) fn fixed_center(&self) -> Point {
        self.fixed_body.center()
    }

    /// The point of the moving part, as computed, that is the origin.
    pub(crate) fn moving_center(&self) -> Point {
        self.moving_body.center()
    }

    /// Whether the parts overlap with the moving part at `p` in the pair's frame.
    pub(crate) fn overlaps(&self, p: Point, theta: f64) -> bool {
        overlap(&self.fixed_body, &self.moving_body, p, theta)
    }
}

/// The parts of a pair prepared for overlap tests only.
#[derive(Debug)]
pub(crate) struct Bodies {
    frame: PairFrame,
    fixed: Body,
    moving: Body,
}

impl Bodies {
    /// Prepares a pair as drawn.
    pub(crate) fn new(fixed: &Part, moving: &Part, fit: Fit) -> Self {
        let outlines = Outlines::new(Placed::as_drawn(fixed), Placed::as_drawn(moving), fit, 0);
        Self {
            frame: outlines.frame,
            fixed: outlines.fixed_body,
            moving: outlines.moving_body,
        }
    }

    /// Whether the parts overlap at a configuration.
    pub(crate) fn overlap(&self, c: Configuration) -> bool {
        overlap(
            &self.fixed,
            &self.moving,
            self.frame.inner_from_outer(c),
            c.theta,
        )
    }
}

/// A pair before its sheets are made.
struct Outlines {
    frame: PairFrame,
    fixed: Outline,
    moving: Outline,
    fixed_fold: u32,
    moving_fold: u32,
    room: f64,
    fixed_body: Body,
    moving_body: Body,
}

impl Outlines {
    /// Outlines with the perturbation of one of several attempts.
    fn new(fixed: Placed<'_>, moving: Placed<'_>, fit: Fit, attempt: u64) -> Self {
        let scale = PairFrame::scale_of([(fixed.part, fixed.center), (moving.part, moving.center)]);
        let (room, moved) = match fit {
            Fit::Overlaps => (0.0, MOVING_PERTURBATION),
            Fit::HasPlay => (ROOM, MOVED_IN_ROOM),
        };
        let outline = |p: Placed<'_>, growth: f64, seed: u64, size: f64| {
            let perturbation = Perturbation {
                size,
                seed,
                images: p.images,
                fold: p.fold,
            };
            Outline::perturbed(p.part, p.center, scale, growth, &perturbation)
        };
        let seed = 2 * attempt + 1;
        let a = outline(fixed, GROWTH, seed, PERTURBATION);
        let b = outline(moving, MOVING_GROWTH - room, seed + 1, moved);
        Self {
            room,
            frame: PairFrame {
                fixed_center: fixed.drawn_center,
                moving_center: moving.drawn_center,
                scale,
            },
            fixed_fold: fixed.fold,
            moving_fold: moving.fold,
            fixed_body: Body::new(&a, fixed.part, fixed.center, scale, room),
            moving_body: Body::new(&b, moving.part, moving.center, scale, room),
            fixed: a,
            moving: b,
        }
    }

    fn sheets(self, span: Span, period: Period, most: usize) -> Geometry {
        let contacts = Contacts::new(&self.fixed, &self.moving, span, period, most);
        let scale = self.frame.scale;
        let discs = |body: &Body| -> Vec<Option<(Point, f64)>> {
            let part = body.part();
            let disc = |layer| {
                let (center, radius) = inscribed_disc(&part.layer(layer), body.center(), scale)?;
                (radius > self.room).then_some((center, radius - self.room))
            };
            (0..part.layers().len()).map(disc).collect()
        };
        let (fixed_discs, moving_discs) = (discs(&self.fixed_body), discs(&self.moving_body));
        let sum = |&(i, j): &(usize, usize)| {
            let radius = |disc: Option<(Point, f64)>| disc.map_or(0.0, |d| d.1);
            radius(fixed_discs[i]) + radius(moving_discs[j])
        };
        let layers = (self.fixed_body.part()).meeting_layers(self.moving_body.part());
        let deepest = (layers.into_iter()).max_by(|a, b| sum(a).total_cmp(&sum(b)));
        Geometry {
            exact: (contacts.sheets.iter()).map(|_| OnceLock::new()).collect(),
            frame: self.frame,
            deep_layers: deepest.unwrap_or_default(),
            fixed_disc: deepest.and_then(|(i, _)| fixed_discs[i]),
            moving_disc: deepest.and_then(|(_, j)| moving_discs[j]),
            fixed: Arc::new(self.fixed),
            moving: Arc::new(self.moving),
            contacts,
            fixed_fold: self.fixed_fold,
            moving_fold: self.moving_fold,
            room: self.room,
            fixed_body: Arc::new(self.fixed_body),
            moving_body: Arc::new(self.moving_body),
        }
    }
}

/// Whether two parts, as drawn, overlap at a configuration. For parts that touch the result is undefined.
pub fn overlap_as_drawn(fixed: &Part, moving: &Part, fixed_from_moving: Configuration) -> bool {
    Bodies::new(fixed, moving, Fit::HasPlay).overlap(fixed_from_moving)
}
