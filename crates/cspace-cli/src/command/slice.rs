//! `cspace slice`.

use std::fmt::{self, Write};

use cspace::{
    Classification, Configuration, ContactSpace, Coordinates, CurveGeometry, Edge, FixedAxesSpace,
    PairClass, PairSpace, Point, Slice,
};
use cspace_answers::{Answer, Outcome};
use cspace_draw::{PictureFormat, SlicesPicture, slices};
use cspace_drawing::Drawn;

use super::draw::{at_configuration, check_version, write_outlines};
use serde::Serialize;

use crate::args::SliceArgs;
use crate::failure::Failure;
use crate::output;
use crate::picture::{self, Plane};
use crate::subject::{Chosen, Subject};
use crate::wording::{angle, count, length};

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
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, None)?;
    if !pair.is_planar() {
        return plane(args, &pair, format);
    }
    let Some(theta) = args.theta else {
        return Err(Failure::new("slice needs an orientation")
            .help("give --theta T, in radians or such as 18deg"));
    };
    let slice = pair.slice(theta, args.exact)?;
    if let Some(format) = format {
        picture(args, &pair, theta, format)?;
    } else if let Some(path) = output.filter(|path| output::ends_in(path, "dxf")) {
        let name = format!("{} about {}", pair.moving().name(), pair.fixed().name());
        let drawn = Drawn::slice(&name, &slice);
        write_outlines(Some(path), &[drawn], pair.unit_label(), args.dxf)?;
    }
    let answers = vec![pair.answer(Outcome::DONE, &slice)];
    let answer = Answer::of_pairs("slice", pair.unit_label(), answers);
    super::print(&common.result, &answer, |text| {
        describe(text, &pair, &slice)
    })
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
    let slice = if args.exact {
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

/// The space of a pair with fixed axes, which is that of its plane.
#[derive(Serialize)]
struct Whole<T> {
    space: T,
}

/// A pair with fixed axes has one plane, that of its motions.
fn plane(
    args: &SliceArgs,
    pair: &Chosen<'_>,
    format: Option<PictureFormat>,
) -> Result<(), Failure> {
    if args.theta.is_some() {
        let class = pair.class();
        return Err(Failure::new(format_args!(
            "--theta: orientation is no coordinate of the {class} pair {}",
            pair.names()
        ))
        .help(if class == PairClass::FixedAxes {
            "leave --theta out: the plane of the two motions is shown; or use --general with the model"
        } else {
            "use --general with the model, which computes it in x, y and theta"
        }));
    }
    if args.exact {
        return Err(
            Failure::new("--exact: the plane of two motions has no slices")
                .help("leave --exact out, or use --general with the model"),
        );
    }
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
    let space = pair.space()?;
    let PairSpace::FixedAxes(space) = &*space else {
        return Err(pair.no_orientation("a slice"));
    };
    if let Some(format) = format {
        let options = (args.picture).options(Plane::Motions, pair.title(), pair.unit_label())?;
        picture::write(output, format, &cspace_draw::plane(space, &options))?;
    }
    let content = Whole {
        space: space.data(),
    };
    let answers = vec![pair.answer(Outcome::DONE, content)];
    let answer = Answer::of_pairs("slice", pair.unit_label(), answers);
    super::print(&args.common.result, &answer, |text| {
        describe_plane(text, pair, space)
    })
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
