//! `cspace slice`.

use std::fmt::{self, Write};

use cspace::{CurveGeometry, FixedAxesSpace, PairClass, PairSpace, Slice};
use cspace_io::write::{svg, svg_axes};

use crate::args::{Format, SliceArgs};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, Subject};
use crate::wording::{angle, count, length};

pub(crate) fn run(args: &SliceArgs) -> Result<(), Failure> {
    let common = &args.common;
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, None)?;
    let is_picture = (common.result.output.as_deref())
        .and_then(|o| o.extension())
        .is_some_and(|e| e.eq_ignore_ascii_case("svg"));
    if !pair.is_planar() {
        return plane(args, &pair, is_picture);
    }
    let Some(theta) = args.theta else {
        return Err(Failure::input("slice needs an orientation")
            .help("give --theta T, in radians or such as 18deg"));
    };
    let slice = pair.slice(theta)?;
    let bytes = if is_picture {
        svg::slices(&svg::Page {
            title: pair.title(),
            size: pair.fixed().size().max(pair.moving().size()),
            slices: std::slice::from_ref(&slice),
        })
        .into_bytes()
    } else {
        match common.result.format {
            Format::Json => super::json(&slice)?,
            Format::Text => {
                let mut text = String::new();
                describe(&mut text, &pair, &slice).map_err(Failure::work)?;
                text.into_bytes()
            }
        }
    };
    output::write(common.result.output.as_deref(), &bytes)
}

/// A pair with fixed axes has one plane, that of its motions.
fn plane(args: &SliceArgs, pair: &Chosen<'_>, is_picture: bool) -> Result<(), Failure> {
    if args.theta.is_some() {
        let class = pair.class();
        return Err(Failure::input(format_args!(
            "--theta: orientation is no coordinate of the {class} pair {}",
            pair.names()
        ))
        .help(if class == PairClass::FixedAxes {
            "leave --theta out: the plane of the two motions is shown; or use --general with the model"
        } else {
            "use --general with the model, which computes it in x, y and theta"
        }));
    }
    let space = pair.space()?;
    let PairSpace::FixedAxes(space) = &*space else {
        return Err(pair.no_orientation("a slice"));
    };
    let bytes = if is_picture {
        svg_axes::plane(&pair.title(), space).into_bytes()
    } else {
        match args.common.result.format {
            Format::Json => super::json(space.data())?,
            Format::Text => {
                let mut text = String::new();
                describe_plane(&mut text, pair, space).map_err(Failure::work)?;
                text.into_bytes()
            }
        }
    };
    output::write(args.common.result.output.as_deref(), &bytes)
}

fn describe_plane(text: &mut String, pair: &Chosen<'_>, space: &FixedAxesSpace) -> fmt::Result {
    let curves = space.patches();
    writeln!(
        text,
        "{} (fixed, u), {} (moving, v): {}",
        pair.fixed().name(),
        pair.moving().name(),
        count(curves.len(), "contact curve", "contact curves")
    )?;
    for (i, curve) in curves.iter().enumerate() {
        writeln!(
            text,
            "\ncurve {i}: {} of {} on {} of {}",
            curve.moving,
            pair.moving().name(),
            curve.fixed,
            pair.fixed().name()
        )?;
        let (from, to) = (curve.branches.start as usize, curve.branches.end as usize);
        for b in &space.branches()[from..to] {
            writeln!(
                text,
                "  ({}, {}) to ({}, {})",
                length(b.start.0),
                length(b.start.1),
                length(b.end.0),
                length(b.end.1)
            )?;
        }
    }
    Ok(())
}

fn describe(text: &mut String, pair: &Chosen<'_>, slice: &Slice) -> fmt::Result {
    writeln!(
        text,
        "{} (fixed), {} (moving) at theta = {}: {}, {}",
        pair.fixed().name(),
        pair.moving().name(),
        angle(slice.theta),
        count(slice.loops.len(), "loop", "loops"),
        count(slice.curves.len(), "curve", "curves")
    )?;
    if slice.doubtful {
        writeln!(text, "doubtful: curves may be missing, or not there")?;
    }
    for (i, l) in slice.loops.iter().enumerate() {
        writeln!(text, "\nloop {i}: {}", count(l.len(), "curve", "curves"))?;
        for &c in l {
            let curve = &slice.curves[c as usize];
            let (start, end) = (curve.geometry.point(0.0), curve.geometry.point(1.0));
            write!(
                text,
                "  ({}, {}) to ({}, {})",
                length(start.x),
                length(start.y),
                length(end.x),
                length(end.y)
            )?;
            if let CurveGeometry::Arc {
                center,
                radius,
                sweep,
                ..
            } = curve.geometry
            {
                write!(
                    text,
                    ", arc about ({}, {}) of radius {} by {:.4} deg",
                    length(center.x),
                    length(center.y),
                    length(radius),
                    sweep.to_degrees()
                )?;
            }
            if let CurveGeometry::FlatArc { start, end, bulge } = curve.geometry {
                let chord = start.distance(end);
                write!(
                    text,
                    ", arc of radius {}, {} high",
                    length(chord * (1.0 + bulge * bulge) / (4.0 * bulge.abs())),
                    length(0.5 * chord * bulge.abs())
                )?;
            }
            writeln!(
                text,
                ": {} of {} on {} of {}",
                curve.moving,
                pair.moving().name(),
                curve.fixed,
                pair.fixed().name()
            )?;
        }
    }
    Ok(())
}
