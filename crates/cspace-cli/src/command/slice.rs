//! `cspace slice`.

use std::fmt::{self, Write};

use clap::Args;
use cspace::{
    Classification, Configuration, ContactSpace, Coordinates, CurveGeometry, Edge, FixedAxesSpace,
    PairSpace, Point, Slice,
};
use cspace_api::slice::{Question, Sliced};
use cspace_api::{Chosen, given};
use cspace_draw::{PictureFormat, SlicesPicture, slices};
use cspace_drawing::Drawn;

use super::draw::{at_configuration, check_version, write_outlines};
use crate::args::{Common, DxfChoice};
use crate::ask;
use crate::failure::Failure;
use crate::output;
use crate::picture::{self, PictureArgs, Plane};
use crate::wording::{angle, count, length};

const HELP: &str = "\
Examples:
  cspace slice models/ratchet_pawl.toml --theta 5deg
  cspace slice models/ratchet_mechanism.toml --pair driver,link -o rocking.svg
  cspace slice models/snap_fastener.toml --theta=-0.02 --json
  cspace slice models/ratchet_pawl.toml --theta 0 -o slice.svg

Each loop is one closed piece of the boundary of free space: blocked space on
the left of travel, free space on the right. Features are named by the loop and
vertex of the part as given, counted from 0. At a critical orientation the
slice just above it is shown. A pair with fixed axes has no orientation to
choose: the plane of its two motions (u, v) is shown. -o OUT.svg, .png or .pdf
is a picture, with the parts beside it to scale at the position --at; .dxf the
loops as lines and arcs, .json the answer.";

/// Arguments of `cspace slice`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct SliceArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) question: Question,
    /// Pictures: the position x,y at which the parts are shown beside the slice [default: as drawn, or the nearest contact]
    #[arg(long, value_name = "X,Y", value_parser = position, allow_hyphen_values = true)]
    pub(crate) at: Option<(f64, f64)>,
    /// The version of DXF, where the name after -o ends in .dxf
    #[arg(long, value_enum, value_name = "VERSION", hide_short_help = true)]
    pub(crate) dxf: Option<DxfChoice>,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

fn position(text: &str) -> Result<(f64, f64), String> {
    let advice = "give two numbers with a comma between, such as 10,-2.5";
    given::two(text).ok_or_else(|| advice.to_owned())
}

pub(crate) fn run(args: &SliceArgs) -> Result<(), Failure> {
    let common = &args.common;
    let output = common.result.output.as_deref();
    let format = picture::format(output);
    check_version(args.dxf, output)?;
    common
        .result
        .artefact(&["svg", "png", "pdf", "dxf", "json"])?;
    let is_picture = format.is_some();
    if !is_picture {
        args.picture.refuse()?;
        if args.at.is_some() {
            return Err(Failure::new("--at is about pictures").help(
                "let the name after -o end in .svg, .png or .pdf; `cspace classify` shows whether a position is free",
            ));
        }
    }
    let (subject, host) = ask::open(common)?;
    let question = &args.question;
    let pair = subject.one_pair(&question.named.clone().into(), &host)?;
    question.check(&pair)?;
    if !pair.is_planar() {
        check_plane(args, &pair)?;
    }
    let answer = question.ask(&pair)?;
    for sliced in answer.content.pairs.iter().map(|pair| &pair.content) {
        draw(args, &pair, sliced, format)?;
    }
    super::tell(&common.result, &answer, |text, found| {
        for sliced in found.pairs.iter().map(|pair| &pair.content) {
            match sliced {
                Sliced::Positions { slice } => describe(text, &pair, slice)?,
                Sliced::Plane { space } => {
                    if let PairSpace::FixedAxes(space) = &**space {
                        describe_plane(text, &pair, space)?;
                    }
                }
            }
        }
        Ok(())
    })
}

/// Writes the picture or the outlines that are asked for.
fn draw(
    args: &SliceArgs,
    pair: &Chosen<'_>,
    sliced: &Sliced<'_>,
    format: Option<PictureFormat>,
) -> Result<(), Failure> {
    let output = args.common.result.output.as_deref();
    match (sliced, format) {
        (Sliced::Positions { slice }, Some(format)) => picture(
            args,
            pair,
            args.question.theta.unwrap_or(slice.theta),
            format,
        ),
        (Sliced::Positions { slice }, None) => {
            let Some(path) = output.filter(|path| output::ends_in(path, "dxf")) else {
                return Ok(());
            };
            let name = format!("{} about {}", pair.moving().name(), pair.fixed().name());
            let drawn = Drawn::slice(&name, slice);
            write_outlines(Some(path), &[drawn], pair.unit_label(), args.dxf)
        }
        (Sliced::Plane { space }, Some(format)) => {
            let options =
                (args.picture).options(Plane::Motions, pair.title(), pair.unit_label())?;
            match &**space {
                PairSpace::FixedAxes(space) => {
                    picture::write(output, format, &cspace_draw::plane(space, &options))
                }
                _ => Ok(()),
            }
        }
        (Sliced::Plane { .. }, None) => Ok(()),
    }
}

/// The slice, its regions numbered as `compute` lists them, and the parts beside it.
fn picture(
    args: &SliceArgs,
    pair: &Chosen<'_>,
    theta: f64,
    format: PictureFormat,
) -> Result<(), Failure> {
    // Refuses what is outside of the window before anything is computed.
    pair.check_orientation(theta)?;
    let options = (args.picture).options(Plane::Positions, pair.title(), pair.unit_label())?;
    let space = pair.contact_space("a slice")?;
    let (x, y) = args.at.unwrap_or_else(|| beside(&space, theta));
    let at = Coordinates::Planar(Configuration::new(x, y, theta));
    let parts = at_configuration(pair, at);
    let slice = if args.question.exact {
        pair.slice(theta, true)?
    } else {
        space.slice(theta)
    };
    let scene = slices(
        &SlicesPicture {
            space: &space,
            slices: &[slice],
            parts: Some((parts, Point::new(x, y))),
        },
        &options,
    );
    picture::write(args.common.result.output.as_deref(), format, &scene)
}

/// Where the parts are shown if the user does not say: as drawn, but turned, or in the nearest contact if they overlap there.
fn beside(space: &ContactSpace, theta: f64) -> (f64, f64) {
    let drawn = Configuration::new(0.0, 0.0, theta);
    let nearest = match space.classify(drawn) {
        Some(Classification::Blocked) => space.nearest_contact(drawn),
        _ => None,
    };
    let at = nearest.map_or(drawn, |n| n.configuration);
    (at.x, at.y)
}

/// A pair with fixed axes has one plane, that of its motions.
fn check_plane(args: &SliceArgs, pair: &Chosen<'_>) -> Result<(), Failure> {
    if args.at.is_some() {
        return Err(
            Failure::new("--at: the plane of two motions is shown without parts")
                .help("`cspace draw --at u,v` shows the parts"),
        );
    }
    let output = args.common.result.output.as_deref();
    if output.is_some_and(|path| output::ends_in(path, "dxf")) {
        return Err(Failure::new(format_args!(
            "the plane of two motions, of the pair {}, has curves that are no arcs",
            pair.names()
        ))
        .help("write it as a picture: let the name after -o end in .svg, .png or .pdf"));
    }
    Ok(())
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
            pair.moving().feature_text(curve.moving),
            pair.moving().name(),
            pair.fixed().feature_text(curve.fixed),
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
                let arc = Edge::between(start, end, bulge);
                write!(
                    text,
                    ", arc of radius {}, {} high",
                    length(arc.radius()),
                    length(0.5 * start.distance(end) * bulge.abs())
                )?;
            }
            writeln!(
                text,
                ": {} of {} on {} of {}",
                pair.moving().feature_text(curve.moving),
                pair.moving().name(),
                pair.fixed().feature_text(curve.fixed),
                pair.fixed().name()
            )?;
        }
    }
    Ok(())
}
