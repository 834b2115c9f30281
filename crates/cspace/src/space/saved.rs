//! Contact spaces as plain data, to be written and read.

use std::sync::Arc;

use crate::contact::{ContactFunction, Spiral, growths};
use crate::feature::{FeatureName, PairFrame};
use crate::geometry::Point;
use crate::part::{Part, PartError, Vertex};
use crate::slice::CurveGeometry;

use super::doubts::Doubts;
use super::graph::{ContactSpace, FeatureCounts, FreeRegion, SideLink, VerticalLink, Walk};
use super::options::Window;
use super::patch::{Boundary, Patch};
use super::stats::Statistics;
use super::symmetry::PairSymmetry;

mod fit;

/// The version of the format that this library writes, and the only one it reads.
pub const SAVED_VERSION: u32 = 1;

/// A part as it was given.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SavedPart {
    /// Its name.
    pub name: String,
    /// Its loops.
    pub loops: Vec<Vec<Vertex>>,
}

impl SavedPart {
    /// The part as plain data.
    pub(crate) fn of(part: &Part) -> Self {
        Self {
            name: part.name().to_owned(),
            loops: part.loops().iter().map(|l| l.vertices().to_vec()).collect(),
        }
    }

    /// The part that plain data describe.
    pub(crate) fn part(&self) -> Result<Part, SavedError> {
        let name = || self.name.clone();
        Part::new(name(), self.loops.clone()).map_err(|error| SavedError::Part {
            name: name(),
            error,
        })
    }
}

/// The frame in which patches are written: position p of the moving part is at scale · (p − `fixed_center` + `R_θ` `moving_center`).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SavedFrame {
    /// Centre of the fixed part, in its own frame.
    pub fixed_center: Point,
    /// Centre of the moving part, in its own frame.
    pub moving_center: Point,
    /// A power of two.
    pub scale: f64,
}

/// A contact space as plain data: everything that was computed, nothing that follows from it.
///
/// Written as JSON with `serde_json`, it is what `cspace export -o OUT.json` writes. The schema
/// `docs/contact-space.schema.json` in the project's repository describes every field and its unit.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// let saved = space.to_saved();
/// assert_eq!(ContactSpace::from_saved(saved.clone())?.to_saved(), saved);
/// let mut damaged = saved;
/// damaged.side_links[0].after = 1_000_000;
/// let error = ContactSpace::from_saved(damaged).unwrap_err();
/// assert_eq!(error.to_string(), "side link 0 is damaged: there is no such patch");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SavedSpace {
    /// Always `contact-space`.
    pub format: String,
    /// Version of the format.
    pub version: u32,
    /// The fixed part.
    pub fixed: SavedPart,
    /// The moving part.
    pub moving: SavedPart,
    /// Orientations covered.
    pub window: Window,
    /// The frame of the patches.
    pub frame: SavedFrame,
    /// Numbers of features.
    pub features: FeatureCounts,
    /// Orientations at which the structure of the slice changes.
    pub critical_orientations: Vec<f64>,
    /// The patches.
    pub patches: Vec<Patch>,
    /// Neighbours within bands.
    pub side_links: Vec<SideLink>,
    /// Neighbours across critical orientations.
    pub vertical_links: Vec<VerticalLink>,
    /// Connected components of free space.
    pub free_regions: Vec<FreeRegion>,
    /// The symmetry of the parts, and the slabs it made of the computation.
    #[cfg_attr(feature = "serde", serde(default))]
    pub symmetry: PairSymmetry,
    /// How many bands were computed; 0 where this is not known.
    #[cfg_attr(feature = "serde", serde(default))]
    pub computed_bands: u32,
    /// Intervals of orientation in which the patches are not relied upon alone.
    #[cfg_attr(feature = "serde", serde(default))]
    pub doubtful_orientations: Vec<(f64, f64)>,
    /// Counts and times of the computation.
    pub statistics: Statistics,
}

/// Why saved data are no contact space.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SavedError {
    /// Not a contact space at all.
    #[error("the format is {found:?}, not {wanted:?}")]
    Format {
        /// What it says.
        found: String,
        /// What it should say.
        wanted: &'static str,
    },
    /// Written by another version.
    #[error(
        "the format's version is {found}, this program reads version {SAVED_VERSION}; compute the space again"
    )]
    Version {
        /// What it says.
        found: u32,
    },
    /// A part is none.
    #[error("part {name:?}: {error}")]
    Part {
        /// Its name.
        name: String,
        /// What is wrong with it.
        error: PartError,
    },
    /// What a space has once is not as any computation leaves it.
    #[error("{what} is damaged: {why}")]
    Whole {
        /// Which field.
        what: &'static str,
        /// What is wrong.
        why: &'static str,
    },
    /// A link or patch refers to something that does not exist, or a number is not finite.
    #[error("{what} {index} is damaged: {why}")]
    Damaged {
        /// Which list.
        what: &'static str,
        /// Which entry.
        index: usize,
        /// What is wrong.
        why: &'static str,
    },
}

const FORMAT: &str = "contact-space";

impl ContactSpace {
    /// The space as plain data.
    pub fn to_saved(&self) -> SavedSpace {
        SavedSpace {
            format: FORMAT.to_owned(),
            version: SAVED_VERSION,
            fixed: SavedPart::of(&self.fixed),
            moving: SavedPart::of(&self.moving),
            window: self.window,
            frame: SavedFrame {
                fixed_center: self.frame.fixed_center,
                moving_center: self.frame.moving_center,
                scale: self.frame.scale,
            },
            features: self.features,
            critical_orientations: self.critical_orientations.clone(),
            patches: self.patches.clone(),
            side_links: self.side_links.clone(),
            vertical_links: self.vertical_links.clone(),
            free_regions: self.regions.clone(),
            symmetry: self.symmetry,
            computed_bands: self.computed_bands,
            doubtful_orientations: self.doubts.intervals().to_vec(),
            statistics: self.statistics,
        }
    }

    /// The space that plain data describe; nothing is computed again.
    ///
    /// # Errors
    /// If the data are of another format or version, refer to what is not there, or do not fit the parts.
    pub fn from_saved(saved: SavedSpace) -> Result<Self, SavedError> {
        check_head(&saved.format, FORMAT, saved.version)?;
        let (fixed, moving) = (saved.fixed.part()?, saved.moving.part()?);
        check(&saved)?;
        fit::check_frame(&saved, &fixed, &moving).map_err(|why| SavedError::Whole {
            what: "the frame",
            why,
        })?;
        let frame = PairFrame {
            fixed_center: saved.frame.fixed_center,
            moving_center: saved.frame.moving_center,
            scale: saved.frame.scale,
        };
        let reach = frame.reach(&fixed, &moving);
        each("patch", &saved.patches, |p| fit::check_ends(p, reach))?;
        each("side link", &saved.side_links, |l| {
            fit::check_link(&saved.patches, l)
        })?;
        let walk = Walk::new(
            saved.patches.len(),
            &saved.side_links,
            &saved.vertical_links,
        );
        let growths = growths(&fixed, &moving);
        let grown = frame.grown((&fixed, growths.0), (&moving, growths.1));
        Ok(Self {
            fixed,
            moving,
            window: saved.window,
            frame,
            critical_orientations: saved.critical_orientations,
            patches: saved.patches,
            side_links: saved.side_links,
            vertical_links: saved.vertical_links,
            regions: saved.free_regions,
            features: saved.features,
            symmetry: saved.symmetry,
            computed_bands: saved.computed_bands,
            statistics: saved.statistics,
            walk,
            doubts: Doubts::known(saved.doubtful_orientations, saved.window),
            grown,
            bodies: Arc::default(),
            places: Arc::default(),
        })
    }
}

/// That data are of the format and version that is read.
pub(crate) fn check_head(
    format: &str,
    wanted: &'static str,
    version: u32,
) -> Result<(), SavedError> {
    if format != wanted {
        return Err(SavedError::Format {
            found: format.to_owned(),
            wanted,
        });
    }
    if version != SAVED_VERSION {
        return Err(SavedError::Version { found: version });
    }
    Ok(())
}

/// Lengths of the pair's frame, in which the parts have size 1, are far below this.
const LARGEST_LENGTH: f64 = 1e6;

/// Orientations may be off the window by this much, in radians, and unit vectors off their length.
const SLACK: f64 = 1e-6;

/// That everything referred to is there, and that every number is one that a computation can have given.
fn check(saved: &SavedSpace) -> Result<(), SavedError> {
    check_whole(saved).map_err(|(what, why)| SavedError::Whole { what, why })?;
    each("patch", &saved.patches, |p| check_patch(saved, p))?;
    let patches = saved.patches.len();
    let is_patch = |i: u32| (i as usize) < patches;
    each("side link", &saved.side_links, |l| {
        ensure(
            is_patch(l.before) && is_patch(l.after),
            "there is no such patch",
        )?;
        ensure(is_interval(l.lo, l.hi), "its orientations are no interval")
    })?;
    each("vertical link", &saved.vertical_links, |l| {
        ensure(
            is_patch(l.lower) && is_patch(l.upper),
            "there is no such patch",
        )?;
        ensure(l.theta.is_finite(), "its orientation is no number")?;
        ensure(is_curve(&l.overlap), "its overlap is no curve")
    })?;
    each("free region", &saved.free_regions, |r| {
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

type Check = Result<(), &'static str>;

fn ensure(holds: bool, why: &'static str) -> Check {
    if holds { Ok(()) } else { Err(why) }
}

fn each<T>(what: &'static str, list: &[T], check: impl Fn(&T) -> Check) -> Result<(), SavedError> {
    list.iter().enumerate().try_for_each(|(index, item)| {
        check(item).map_err(|why| SavedError::Damaged { what, index, why })
    })
}

/// What is there once.
fn check_whole(saved: &SavedSpace) -> Result<(), (&'static str, &'static str)> {
    let w = saved.window;
    if !(is_interval(w.lo, w.hi) && w.lo < w.hi) {
        return Err(("the window", "its orientations are no interval"));
    }
    let f = saved.frame;
    if !(is_place(f.fixed_center) && is_place(f.moving_center)) {
        return Err(("the frame", "a centre is no point"));
    }
    if !(f.scale.is_normal() && f.scale > 0.0) {
        return Err(("the frame", "the scale is not positive"));
    }
    // A loop of n vertices has at most n edges and n corners.
    let most = |p: &SavedPart| 2 * p.loops.iter().map(Vec::len).sum::<usize>();
    let counts = saved.features;
    if counts.fixed as usize > most(&saved.fixed) || counts.moving as usize > most(&saved.moving) {
        return Err((
            "the number of features",
            "there are more than the parts can have",
        ));
    }
    let s = saved.symmetry;
    if s.fixed == 0 || s.moving == 0 || s.slabs == 0 {
        return Err(("the symmetry", "a fold is not positive"));
    }
    if !(s.deviation.is_finite() && s.deviation >= 0.0) {
        return Err(("the symmetry", "the deviation is no length"));
    }
    let c = &saved.critical_orientations;
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
    let d = &saved.doubtful_orientations;
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

/// Where things may begin: the window, but a full turn counts from −π, wherever it was begun.
fn orientations(window: Window) -> (f64, f64) {
    use core::f64::consts::PI;
    if window.full_turn {
        (-PI - SLACK, PI + SLACK)
    } else {
        (window.lo - SLACK, window.hi + SLACK)
    }
}

fn check_patch(saved: &SavedSpace, p: &Patch) -> Check {
    ensure(
        (p.region as usize) < saved.free_regions.len(),
        "there is no such free region",
    )?;
    ensure(is_interval(p.lo, p.hi), "its orientations are no interval")?;
    let (lo, hi) = orientations(saved.window);
    ensure(
        (lo..=hi).contains(&p.lo) && (saved.window.full_turn || p.hi <= hi),
        "its orientations are outside the window",
    )?;
    let is_feature = |part: &SavedPart, name: FeatureName| {
        (part.loops.get(name.loop_index as usize)).is_some_and(|l| (name.index as usize) < l.len())
    };
    ensure(
        is_feature(&saved.fixed, p.fixed) && is_feature(&saved.moving, p.moving),
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

/// Orientations from `lo` to `hi`, at most a turn apart.
fn is_interval(lo: f64, hi: f64) -> bool {
    lo.is_finite() && hi.is_finite() && lo <= hi && hi - lo <= core::f64::consts::TAU + SLACK
}

fn is_place(p: Point) -> bool {
    p.x.is_finite() && p.y.is_finite()
}

fn is_inner(x: f64) -> bool {
    x.abs() <= LARGEST_LENGTH
}

/// Radii may be larger: an arc is taken for its chord beyond.
fn is_radius(x: f64) -> bool {
    x.abs() <= LARGEST_LENGTH * LARGEST_LENGTH
}

fn is_spiral(s: &Spiral) -> bool {
    let arm = s.swing.arm;
    let near = [s.u.x, s.u.y, s.w.x, s.w.y].into_iter().all(is_inner);
    near && is_radius(arm.x) && is_radius(arm.y) && s.swing.rest.is_finite()
}

fn is_function(function: &ContactFunction) -> bool {
    match function {
        ContactFunction::FixedLine { normal, through }
        | ContactFunction::MovingLine { normal, through } => {
            (normal.length() - 1.0).abs() <= SLACK && is_spiral(through)
        }
        ContactFunction::Circle { center, radius } => is_spiral(center) && is_inner(*radius),
        ContactFunction::FlatCircle {
            through,
            normal,
            radius,
            ..
        } => {
            (normal.length() - 1.0).abs() <= SLACK
                && is_spiral(through)
                && is_radius(*radius)
                && *radius != 0.0
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
