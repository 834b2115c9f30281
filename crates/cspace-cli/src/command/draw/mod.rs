//! `cspace draw`.

mod drawing;
mod outlines;

use clap::Args;
use cspace::{
    Axis, Configuration, Coordinates, FeatureName, Layer, Location, PairSpace, Part, Point,
    QueryError, Rotation, Vector,
};
pub(crate) use outlines::{check_version, is_dxf, write as write_outlines};

use cspace_draw::{
    ContactMark, PartsPicture, PictureFormat, PictureOptions, PlacedPart, Scene, parts,
};

use cspace_plan::fits_exactly;

use crate::args::{Common, DxfChoice};
use crate::ask;
use crate::failure::Failure;
use crate::output;
use crate::picture::{self, PictureArgs, Plane};
use crate::subject::InWords;
use crate::wording::EXACT_FIT;
use cspace_api::{Chosen, Given, Host, Named, Subject};
use cspace_design::pair_of;

const HELP: &str = "\
Examples:
  cspace draw models/ratchet_mechanism.toml -o mechanism.svg
  cspace draw models/ratchet_pawl.toml --labels all -o pawl.pdf
  cspace draw models/gears_on_shafts.toml --at 5deg,-7deg -o gears.png

All parts are drawn as they are in the file; with --pair or --at, the two parts
of the pair at the configuration, and the features that touch there are marked
by a point and the normal of the fixed part. A cross with a long and a short
arm is the x and y axis of a part's frame, a ring the pivot of a part that
turns, a double arrow the direction of one that slides. With --labels all
vertices are numbered as in the file, loop and index from 0. With --height
layers that are not there are thin outlines, or left out of DXF. Without -o the
picture is SVG on standard output.

FILE may be a drawing too: what of it makes no part is red. An output that ends
in .dxf has the outlines alone, arcs as arcs, each part on a layer of its name;
so has SVG with --outlines.";

/// Arguments of `cspace draw`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct DrawArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) named: Named,
    /// Write SVG of the outlines alone, to scale
    #[arg(long)]
    pub(crate) outlines: bool,
    /// The version of DXF
    #[arg(long, value_enum, value_name = "VERSION", hide_short_help = true)]
    pub(crate) dxf: Option<DxfChoice>,
    /// The configuration of the pair: x,y,theta, or u,v on fixed axes; what touches there is marked [default: as drawn]
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub(crate) at: Option<Given>,
    /// Draw what is at this height alone, of parts with layers
    #[arg(long, value_name = "Z", allow_hyphen_values = true)]
    pub(crate) height: Option<f64>,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// Writes the picture, and gives the unit of length.
pub(crate) fn run(args: &DrawArgs) -> Result<Option<String>, Failure> {
    let common = &args.common;
    let output = common.result.output.as_deref();
    let is_drawing = cspace_drawing::is_drawing(&common.file);
    check_version(args.dxf, output)?;
    if is_dxf(output) || args.outlines {
        check_outlines(args, is_drawing)?;
        return outlines::of_model(args);
    }
    let format = match (output, picture::format(output)) {
        (_, Some(format)) => format,
        // Standard output takes the format that is text.
        (Some(path), None) if path.as_os_str() == "-" => PictureFormat::Svg,
        (None, None) => PictureFormat::Svg,
        (Some(path), None) => {
            return Err(Failure::new(format_args!(
                "{}: the extension names no known format",
                path.display()
            ))
            .help("let the name end in .svg, .png or .pdf, or in .dxf for the outlines alone"));
        }
    };
    if is_drawing {
        if args.height.is_some() {
            return Err(Failure::new("--height is about the layers of a model")
                .help("leave the option out: a drawing is flat"));
        }
        output::check(output)?;
        return drawing::run(args, format);
    }
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    let sheet = |title| (args.picture).options(Plane::Positions, title, subject.unit());
    let shown = Shown {
        named: &args.named,
        at: args.at.as_ref(),
        height: args.height,
    };
    picture::write(output, format, &scene(&subject, &host, shown, sheet)?)?;
    Ok(subject.unit().map(str::to_owned))
}

/// Choice of what is drawn of a model.
pub(crate) struct Shown<'a> {
    /// The pair.
    pub(crate) named: &'a Named,
    /// Its configuration.
    pub(crate) at: Option<&'a Given>,
    /// The height alone that is drawn in full.
    pub(crate) height: Option<f64>,
}

/// The parts of a model as they are drawn, or a pair at a configuration if one of the two is given, on a sheet with a title.
pub(crate) fn scene(
    subject: &Subject,
    host: &dyn Host,
    shown: Shown<'_>,
    sheet: impl FnOnce(String) -> Result<PictureOptions, Failure>,
) -> Result<Scene, Failure> {
    let one = shown.named.pair.is_some() || shown.at.is_some();
    let pair;
    let (mut drawn, title) = match subject {
        Subject::Model(file) if !one => {
            let model = &file.model.mechanism;
            (assembly(model), model.name.clone())
        }
        _ => {
            pair = subject.one_pair(&shown.named.clone().into(), host)?;
            let at = match shown.at {
                Some(at) => pair.coordinates("at", at)?,
                None => as_drawn(&pair),
            };
            let mut drawn = at_configuration(&pair, at);
            mark_contacts(&mut drawn, &pair, at, shown.height)?;
            (drawn, pair.title())
        }
    };
    at_height(&mut drawn, shown.height, subject.unit())?;
    Ok(parts(&drawn, &sheet(title)?))
}

/// Outlines are those of models, and written as SVG or DXF.
fn check_outlines(args: &DrawArgs, is_drawing: bool) -> Result<(), Failure> {
    let output = args.common.result.output.as_deref();
    if is_drawing {
        return Err(
            Failure::new("the outlines of a drawing are those of the model made of it")
                .help("make the model with `cspace import`, and draw that"),
        );
    }
    let is_svg = picture::format(output) == Some(PictureFormat::Svg);
    if args.outlines && !is_svg && output.is_some_and(|p| p.as_os_str() != "-") {
        return Err(Failure::new("--outlines is about SVG")
            .help("let the name after -o end in .svg, or in .dxf without --outlines"));
    }
    Ok(())
}

/// Has a picture drawn at a height, if one is asked for, which must be within the stack of the parts.
pub(super) fn at_height(
    picture: &mut PartsPicture<'_>,
    height: Option<f64>,
    unit: Option<&str>,
) -> Result<(), Failure> {
    let Some(z) = height else { return Ok(()) };
    let layers = picture.parts.iter().flat_map(|p| p.part.layers());
    let stack = layers
        .filter_map(Layer::z)
        .reduce(|[lo, hi], [a, b]| [lo.min(a), hi.max(b)]);
    let Some([lo, hi]) = stack else {
        return Err(
            Failure::new("--height is about layers, and no part has any")
                .help("leave the option out, or give the parts `z` or `layers`"),
        );
    };
    if !(lo <= z && z < hi) {
        let unit = unit.map(|u| format!(" {u}")).unwrap_or_default();
        return Err(
            Failure::new(format_args!("--height {z}: no layer is there")).help(format_args!(
                "heights are from {lo} to less than {hi}{unit}"
            )),
        );
    }
    picture.height = Some(z);
    Ok(())
}

/// All parts as they are drawn.
pub(super) fn assembly(model: &cspace_model::Mechanism) -> PartsPicture<'_> {
    PartsPicture {
        parts: (model.parts.iter().enumerate())
            .map(|(number, entry)| PlacedPart {
                part: &entry.part,
                assembly_from_part: Configuration::default(),
                axis: entry.axis,
                number,
            })
            .collect(),
        joints: model.joints.clone(),
        ..PartsPicture::default()
    }
}

/// The configuration of a pair in which its parts are drawn.
pub(crate) fn as_drawn(pair: &Chosen<'_>) -> Coordinates {
    match pair.is_on_axes() {
        true => Coordinates::Axes { u: 0.0, v: 0.0 },
        false => Coordinates::Planar(Configuration::default()),
    }
}

/// The two parts of a pair at a configuration.
pub(super) fn at_configuration<'a>(pair: &'a Chosen<'_>, at: Coordinates) -> PartsPicture<'a> {
    let axes = pair.axes().filter(|_| pair.is_on_axes());
    let [fixed, moving] = placed(axes, at);
    let entry = |part, assembly_from_part, axis, number| PlacedPart {
        part,
        assembly_from_part,
        axis,
        number,
    };
    let axis = |of: fn((Axis, Axis)) -> Axis| axes.map(of);
    // A part that another is drawn relative to stands still.
    let still = axis(|a| a.0).or(Some(Axis::FIXED));
    PartsPicture {
        parts: vec![
            entry(pair.fixed(), fixed, still, 0),
            entry(pair.moving(), moving, axis(|a| a.1), 1),
        ],
        ..PartsPicture::default()
    }
}

/// Where the fixed and the moving part are in the assembly, or in the fixed part's frame.
fn placed(axes: Option<(Axis, Axis)>, at: Coordinates) -> [Configuration; 2] {
    match (axes, at) {
        (Some((fixed, moving)), Coordinates::Axes { u, v }) => {
            [fixed.configuration(u), moving.configuration(v)]
        }
        (_, Coordinates::Planar(c)) => [Configuration::default(), c],
        _ => [Configuration::default(); 2],
    }
}

/// Says where the configuration is, and marks what touches there, at a height or at any.
fn mark_contacts(
    drawn: &mut PartsPicture<'_>,
    pair: &Chosen<'_>,
    at: Coordinates,
    height: Option<f64>,
) -> Result<(), Failure> {
    let space = pair.space()?;
    let unanswered = |e: QueryError| pair.unanswered("--at", &e);
    let is = match space.locate(at) {
        Ok(Location::Free(region)) => {
            let apart = space.clearance(at).map_err(unanswered)?;
            pair.is_free_by(region, Some(apart))
        }
        Ok(Location::Contact) => "in contact".to_owned(),
        Ok(Location::Blocked) if fits_exactly(&space, at).unwrap_or(false) => EXACT_FIT.to_owned(),
        Ok(Location::Blocked) => "blocked: the parts overlap".to_owned(),
        Ok(Location::Outside) => return Err(unanswered(QueryError::Outside).into()),
        Err(_) => "joined".to_owned(),
    };
    drawn.remarks.push(format!("{}: {is}", pair.place(at)));
    if matches!(*space, PairSpace::Lower(_)) {
        return Ok(());
    }
    let assembly_from_fixed = drawn.parts[0].assembly_from_part;
    for near in (space.near_features(at, space.resolution())).map_err(unanswered)? {
        let is_there = |part: &Part, feature: FeatureName| {
            height.is_none_or(|z| part.bounds_at(feature.loop_index as usize, z))
        };
        if !is_there(pair.fixed(), near.fixed.name) || !is_there(pair.moving(), near.moving.name) {
            continue;
        }
        let touching = near.touching;
        let (p, n): (Point, Vector) = (touching.on_fixed, touching.normal);
        drawn.contacts.push(ContactMark {
            at: assembly_from_fixed.fixed_from_moving(p),
            normal: Rotation::by(assembly_from_fixed.theta) * n,
            label: pair.touch(pair_of(&near)),
        });
    }
    Ok(())
}
