//! The summary for people.

use std::fmt::{self, Write};

use cspace::pair::{Joint, PermanentContact, PermanentKind};
use cspace::{Axis, AxisMotion, PairClass, PairSpace, Part};
use cspace_api::Chosen;
use cspace_api::compute::{Counts, Freedom, Statistic, Summary};

use crate::wording::{angle, count, length, symmetry};

use super::answer;

/// The answer first, then counts; with `verbose` also the numbers that show how certain the structure is.
pub(super) fn describe(
    text: &mut String,
    pair: &Chosen<'_>,
    space: &PairSpace,
    s: &Summary,
    verbose: bool,
) -> fmt::Result {
    let unit = pair.unit();
    let (fixed, moving) = (pair.fixed().name(), pair.moving().name());
    writeln!(
        text,
        "{moving} relative to {fixed} ({fixed} is fixed, {moving} moves)"
    )?;
    if let Some(model) = &s.model {
        writeln!(text, "  model          {model}")?;
    }
    answer::describe(text, pair, space, s.drawn.as_ref())?;
    let class = pair.class();
    if pair.is_general() && class != PairClass::General {
        writeln!(
            text,
            "  method         {}: all of (x, y, theta), though the pair's class is {class}",
            s.class
        )?;
    } else if s.class == PairClass::Symmetric && s.slabs == 1 {
        writeln!(
            text,
            "  method         {}, but nothing is a copy: {}",
            s.class,
            if s.window.is_some_and(|w| !w.full_turn) {
                "the window is within one of the slabs that symmetry makes"
            } else {
                "circles that are touched are drawn in halves that symmetry does not map to each other"
            }
        )?;
    } else {
        writeln!(text, "  method         {}", s.class)?;
    }
    writeln!(
        text,
        "  features       {} + {} = {}",
        s.features.fixed, s.features.moving, s.features.total
    )?;
    if (s.symmetry.fixed, s.symmetry.moving) != (1, 1) {
        writeln!(
            text,
            "  symmetry       {}, {}",
            used_symmetry(pair.fixed(), s.symmetry.fixed),
            used_symmetry(pair.moving(), s.symmetry.moving)
        )?;
    }
    match &s.motion {
        Some(Freedom::Joint {
            joint,
            limits,
            permanent,
        }) => describe_joint(text, joint, *limits, permanent, &unit)?,
        Some(Freedom::Axes { fixed, moving }) => {
            describe_axes(text, s, (fixed, moving), verbose)?;
        }
        None => describe_planar(text, s, verbose)?,
    }
    writeln!(
        text,
        "  exact to       {:.1e}{unit}; a clearance below {:.1e}{unit} counts as none",
        s.resolution, s.least_clearance
    )?;
    let computed = match s.cached {
        true => " to read it: it was computed before",
        false => "",
    };
    writeln!(
        text,
        "  time           {:.6} s{computed}",
        s.seconds.total()
    )
}

/// The symmetry of a part, of which a fold of 1 says that none was found or none looked for.
fn used_symmetry(part: &Part, fold: u32) -> String {
    symmetry(fold, fold > 1 && part.symmetry().is_round())
}

fn describe_joint(
    text: &mut String,
    joint: &Joint,
    limits: Option<(f64, f64)>,
    permanent: &[PermanentContact],
    unit: &str,
) -> fmt::Result {
    let (what, turns) = match joint {
        Joint::Revolute { at } => (format!("revolute about {}", place((at.x, at.y))), true),
        Joint::Prismatic { direction, .. } => (
            format!("prismatic along {}", place((direction.x, direction.y))),
            false,
        ),
    };
    write!(text, "  joint          {what}")?;
    match limits {
        Some((lo, hi)) if turns => write!(text, ", from {} to {}", angle(lo), angle(hi))?,
        Some((lo, hi)) => write!(text, ", from {} to {}{unit}", length(lo), length(hi))?,
        None => {}
    }
    writeln!(text)?;
    let kinds: Vec<&str> = permanent
        .iter()
        .map(|p| match p.kind {
            PermanentKind::PointLine => "point/line",
            PermanentKind::PointArc => "point/arc",
        })
        .collect();
    writeln!(text, "  contact        permanent: {}", kinds.join(", "))
}

fn place((x, y): (f64, f64)) -> String {
    format!("({}, {})", length(x), length(y))
}

fn describe_axes(
    text: &mut String,
    s: &Summary,
    axes: (&Axis, &Axis),
    verbose: bool,
) -> fmt::Result {
    for (name, axis) in [("u", axes.0), ("v", axes.1)] {
        let what = match axis.motion {
            AxisMotion::Fixed => "does not move".to_owned(),
            AxisMotion::Revolute { center } => {
                format!("turns about {}", place((center.x, center.y)))
            }
            AxisMotion::Prismatic { direction } => {
                format!("slides along {}", place((direction.x, direction.y)))
            }
        };
        write!(text, "  {name}              {what}")?;
        match (axis.range, axis.motion) {
            (Some((lo, hi)), AxisMotion::Revolute { .. }) => {
                write!(text, ", from {} to {}", angle(lo), angle(hi))?;
            }
            (Some((lo, hi)), _) => write!(text, ", from {} to {}", length(lo), length(hi))?,
            _ => {}
        }
        writeln!(text)?;
    }
    writeln!(
        text,
        "  contact        {}, {}",
        count(s.patches, "contact curve", "contact curves"),
        count(s.links.side, "link", "links")
    )?;
    if let Some(Statistic::Axes(counts)) = &s.statistics
        && (verbose || counts.conflicts > 0)
    {
        writeln!(
            text,
            "  certainty      {}, {}, {}",
            count(counts.crossings, "crossing", "crossings"),
            count(counts.tests, "test of overlap", "tests of overlap"),
            count(counts.conflicts, "conflict", "conflicts")
        )?;
    }
    Ok(())
}

/// How many decisions were certain at once, and how the others were made.
fn describe_certainty(text: &mut String, counts: &Counts) -> fmt::Result {
    let d = &counts.decisions;
    let at_once =
        (d.passings - d.passings_by_places) + d.orientations + (d.overlaps - d.overlaps_uncertain);
    writeln!(
        text,
        "  certainty      {at_once} decisions at once, {} by enclosures, {} by tests of overlap, {} left to the resolution, {}",
        d.passings_by_places,
        d.shells,
        d.overlaps_uncertain,
        count(counts.conflicts as usize, "conflict", "conflicts")
    )
}

/// At how many orientations the patches are not relied upon alone, if there are any.
fn describe_doubt(text: &mut String, doubtful: &[(f64, f64)]) -> fmt::Result {
    if doubtful.is_empty() {
        return Ok(());
    }
    let radians: f64 = doubtful.iter().map(|(lo, hi)| hi - lo).sum();
    writeln!(
        text,
        "  doubtful       {} of orientation, {radians:.1e} rad in all",
        count(doubtful.len(), "interval", "intervals")
    )
}

fn describe_planar(text: &mut String, s: &Summary, verbose: bool) -> fmt::Result {
    match s.window {
        Some(w) if !w.full_turn => writeln!(
            text,
            "  orientations   from {} to {}",
            angle(w.lo),
            angle(w.hi)
        )?,
        _ => writeln!(text, "  orientations   all")?,
    }
    writeln!(
        text,
        "  structure      {}, {}{}",
        count(
            s.critical_orientations.len(),
            "critical orientation",
            "critical orientations"
        ),
        count(s.bands, "band", "bands"),
        if s.slices < s.bands {
            format!(" of which {} were computed", s.slices)
        } else {
            String::new()
        }
    )?;
    writeln!(
        text,
        "  contact        {}, {}, {}",
        count(s.patches, "patch", "patches"),
        count(s.links.side, "side link", "side links"),
        count(s.links.vertical, "vertical link", "vertical links")
    )?;
    if let Some(Statistic::General(counts)) = &s.statistics
        && (verbose || counts.conflicts > 0)
    {
        describe_certainty(text, counts)?;
        describe_doubt(text, s.doubtful_orientations.as_deref().unwrap_or_default())?;
    }
    Ok(())
}
