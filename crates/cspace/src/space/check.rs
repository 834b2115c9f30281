//! Checks that data read from a file can be those of a contact space.

use crate::contact::{Carrier, ContactFunction, SheetKind, Spiral};
use crate::feature::FeatureName;
use crate::geometry::Point;
use crate::ids::PatchId;
use crate::part::Part;
use crate::slice::CurveGeometry;

use super::data::{FORMAT, SAVED_VERSION, SpaceData};
use super::fit::{Check, check_ends, check_frame, check_link, ensure};
use super::options::Window;
use super::patch::{Boundary, Patch};

/// Reasons for which data read from a file are rejected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DataError {
    /// The data are not a contact space.
    #[error("the format is {found:?}, not {wanted:?}")]
    Format {
        /// Format name found in the data.
        found: String,
        /// Format name expected.
        wanted: &'static str,
    },
    /// The data were written by another version.
    #[error(
        "the format's version is {found}, this program reads version {SAVED_VERSION}; compute the space again"
    )]
    Version {
        /// Version found in the data.
        found: u32,
    },
    /// A field that a space has once has a value that no computation gives.
    #[error("{what} is damaged: {why}")]
    Whole {
        /// Name of the field.
        what: &'static str,
        /// Reason for the rejection.
        why: &'static str,
    },
    /// A link or patch refers to something that does not exist, or a number is not finite.
    #[error("{what} {index} is damaged: {why}")]
    Damaged {
        /// Name of the list.
        what: &'static str,
        /// Index of the entry.
        index: usize,
        /// Reason for the rejection.
        why: &'static str,
    },
}

/// Checks that data have the expected format and the supported version.
pub(crate) fn check_head(
    format: &str,
    wanted: &'static str,
    version: u32,
) -> Result<(), DataError> {
    if format != wanted {
        return Err(DataError::Format {
            found: format.to_owned(),
            wanted,
        });
    }
    if version != SAVED_VERSION {
        return Err(DataError::Version { found: version });
    }
    Ok(())
}

/// Bound on lengths in the pair's frame, in which the parts have size 1.
const LARGEST_LENGTH: f64 = 1e6;

/// Tolerance of orientations at the ends of the window, in radians, and of the length of unit vectors.
const SLACK: f64 = 1e-6;

/// Checks that the data have this format, refer only to existing entries, and fit the parts.
pub(super) fn check(data: &SpaceData) -> Result<(), DataError> {
    check_head(&data.format, FORMAT, data.version)?;
    check_references(data)?;
    check_frame(data).map_err(|why| DataError::Whole {
        what: "the frame",
        why,
    })?;
    let reach = data.frame.reach(&data.fixed, &data.moving);
    each("patch", &data.patches, |p| check_ends(p, reach))?;
    each("side link", &data.side_links, |l| {
        check_link(&data.patches, l)
    })
}

/// Checks that every reference is to an existing entry, and that every number is one that a computation can have given.
fn check_references(data: &SpaceData) -> Result<(), DataError> {
    check_whole(data).map_err(|(what, why)| DataError::Whole { what, why })?;
    each("patch", &data.patches, |p| check_patch(data, p))?;
    let patches = data.patches.len();
    let is_patch = |i: PatchId| i.index() < patches;
    each("side link", &data.side_links, |l| {
        ensure(
            is_patch(l.before) && is_patch(l.after),
            "there is no such patch",
        )?;
        ensure(is_interval(l.lo, l.hi), "its orientations are no interval")
    })?;
    each("vertical link", &data.vertical_links, |l| {
        ensure(
            is_patch(l.lower) && is_patch(l.upper),
            "there is no such patch",
        )?;
        ensure(l.theta.is_finite(), "its orientation is no number")?;
        ensure(is_curve(&l.overlap), "its overlap is no curve")
    })?;
    each("free region", &data.free_regions, |r| {
        let c = r.sample;
        ensure(
            [c.x, c.y, c.theta].iter().all(|x| x.is_finite()),
            "its sample is no configuration",
        )?;
        ensure(
            r.patches as usize <= patches,
            "it has more patches than there are",
        )
    })
}

fn each<T>(what: &'static str, list: &[T], check: impl Fn(&T) -> Check) -> Result<(), DataError> {
    list.iter().enumerate().try_for_each(|(index, item)| {
        check(item).map_err(|why| DataError::Damaged { what, index, why })
    })
}

/// Checks the fields that a space has once: window, frame, and so on.
fn check_whole(data: &SpaceData) -> Result<(), (&'static str, &'static str)> {
    let w = data.window;
    if !(is_interval(w.lo, w.hi) && w.lo < w.hi) {
        return Err(("the window", "its orientations are no interval"));
    }
    let f = data.frame;
    if !(is_place(f.fixed_center) && is_place(f.moving_center)) {
        return Err(("the frame", "a centre is no point"));
    }
    if !(f.scale.is_normal() && f.scale > 0.0) {
        return Err(("the frame", "the scale is not positive"));
    }
    // A loop of n vertices has at most n edges and n corners.
    let most = |p: &Part| 2 * p.edges().count();
    let counts = data.features;
    if counts.fixed as usize > most(&data.fixed) || counts.moving as usize > most(&data.moving) {
        return Err((
            "the number of features",
            "there are more than the parts can have",
        ));
    }
    let s = data.symmetry;
    if s.fixed == 0 || s.moving == 0 || s.slabs == 0 {
        return Err(("the symmetry", "a fold is not positive"));
    }
    if !(s.deviation.is_finite() && s.deviation >= 0.0) {
        return Err(("the symmetry", "the deviation is no length"));
    }
    let c = &data.critical_orientations;
    let (lo, hi) = orientations(w);
    if !c.iter().all(|&t| (lo..=hi).contains(&t)) {
        return Err((
            "the list of critical orientations",
            "one is outside the window",
        ));
    }
    if !c.is_sorted() {
        return Err(("the list of critical orientations", "they are not in order"));
    }
    let d = &data.doubtful_orientations;
    if !d.iter().all(|&(a, b)| lo <= a && a <= b && b <= hi) {
        return Err((
            "the list of doubtful orientations",
            "one is no interval of the window",
        ));
    }
    if !d.windows(2).all(|w| w[0].1 < w[1].0) {
        return Err(("the list of doubtful orientations", "they are not in order"));
    }
    Ok(())
}

/// Interval in which orientations of events may lie: the window; for a full turn always −π to π, wherever the turn was cut.
fn orientations(window: Window) -> (f64, f64) {
    use core::f64::consts::PI;
    if window.full_turn {
        (-PI - SLACK, PI + SLACK)
    } else {
        (window.lo - SLACK, window.hi + SLACK)
    }
}

fn check_patch(data: &SpaceData, p: &Patch) -> Check {
    ensure(
        p.region.index() < data.free_regions.len(),
        "there is no such free region",
    )?;
    ensure(is_interval(p.lo, p.hi), "its orientations are no interval")?;
    let (lo, hi) = orientations(data.window);
    ensure(
        (lo..=hi).contains(&p.lo) && (data.window.full_turn || p.hi <= hi),
        "its orientations are outside the window",
    )?;
    let is_feature = |part: &Part, name: FeatureName| {
        let of = part.loops().get(name.loop_index as usize);
        of.is_some_and(|l| (name.index as usize) < l.vertices().len())
    };
    ensure(
        is_feature(&data.fixed, p.fixed) && is_feature(&data.moving, p.moving),
        "a part has no such feature",
    )?;
    ensure(is_function(&p.function), "its contact function is none")?;
    for boundary in [&p.left, &p.right] {
        let is_boundary = match boundary {
            Boundary::End { spiral } => is_spiral(spiral),
            Boundary::Crossing { with, root } => is_function(with) && *root <= 1,
        };
        ensure(is_boundary, "a boundary curve is none")?;
    }
    Ok(())
}

/// Whether `lo` and `hi` are an interval of orientations of at most a turn.
fn is_interval(lo: f64, hi: f64) -> bool {
    lo.is_finite() && hi.is_finite() && lo <= hi && hi - lo <= core::f64::consts::TAU + SLACK
}

fn is_place(p: Point) -> bool {
    p.x.is_finite() && p.y.is_finite()
}

fn is_inner(x: f64) -> bool {
    x.abs() <= LARGEST_LENGTH
}

/// Whether a number can be a radius. Radii may exceed the bound on lengths: arcs with a still larger radius are replaced by their chords.
fn is_radius(x: f64) -> bool {
    x.abs() <= LARGEST_LENGTH * LARGEST_LENGTH
}

fn is_spiral(s: &Spiral) -> bool {
    let arm = s.swing.arm;
    let near = [s.u.x, s.u.y, s.w.x, s.w.y].into_iter().all(is_inner);
    near && is_radius(arm.x) && is_radius(arm.y) && s.swing.rest.is_finite()
}

fn is_function(function: &ContactFunction) -> bool {
    let Carrier {
        kind,
        through,
        normal,
        radius,
    } = function.carrier();
    let is_unit = (normal.length() - 1.0).abs() <= SLACK;
    is_spiral(&through)
        && match kind {
            SheetKind::LineRound | SheetKind::RoundLine => is_unit,
            SheetKind::RoundRound => is_inner(radius),
            SheetKind::FixedFlatArc | SheetKind::MovingFlatArc => {
                is_unit && is_radius(radius) && radius != 0.0
            }
        }
}

fn is_curve(curve: &CurveGeometry) -> bool {
    match *curve {
        CurveGeometry::Segment { start, end } => is_place(start) && is_place(end),
        CurveGeometry::FlatArc { start, end, bulge } => {
            is_place(start) && is_place(end) && bulge.abs() <= 1.0
        }
        CurveGeometry::Arc {
            center,
            radius,
            start_angle,
            sweep,
        } => {
            is_place(center)
                && radius.is_finite()
                && radius >= 0.0
                && start_angle.is_finite()
                && sweep.abs() <= core::f64::consts::TAU + SLACK
        }
    }
}
