//! `cspace export`.

use std::io::Write;
use std::path::{Path, PathBuf};

use core::f64::consts::TAU;

use clap::Args;
use cspace::{PairClass, PairSpace, Slice, Window};
use cspace_draw::{PictureFormat, Scene, SlicesPicture, plane, slices};
use cspace_model::shown;
use cspace_model::write::glb::{GlbError, glb};
use cspace_model::write::mesh::{Mesh, MeshOptions};
use cspace_model::write::obj::obj;
use cspace_model::write::ply::{Encoding, ply};
use cspace_model::write::stl::stl;

use super::page;
use crate::args::Common;
use crate::ask;
use crate::failure::Failure;
use crate::output;
use crate::picture::{self, PictureArgs, Plane};
use crate::wording::count;
use cspace_api::{Chosen, Which, given};

use crate::view::Page;

const HELP: &str = "\
Examples:
  cspace export models/ratchet_pawl.toml -o pawl.json
  cspace export models/ratchet_pawl.toml -o pawl.svg --slices 20
  cspace export models/snap_fastener.toml -o snap.ply --tolerance 1e-4
  cspace export models/ball_in_c.toml -o ball.stl
  cspace export models/knee.toml -o knee.glb
  cspace export pawl.json -o pawl.obj
  cspace export models/gears.toml -o gears.html

Formats, by the extension of OUT:
  .json   the whole configuration space; every command reads it in place of a
          model. The schemas are docs/contact-space.schema.json,
          docs/fixed-axes-space.schema.json and docs/lower-pair.schema.json.
          The model's `name` and `unit` are written with it
  .html   one page to look at and drag, with all pairs or that of --pair, which
          works without a network; --with adds what `cspace plan`, `disassemble`
          or `simulate` wrote with -o OUT.json, to be played
  .svg, .png, .pdf
          pictures of slices at even steps of orientation, free regions
          numbered, blocked space grey; of a pair with fixed axes of the plane
          of its two motions
  .ply    the contact surface as triangles: vertices (x, y, theta) on the exact
          surface, in double precision; triangles are counter-clockwise seen
          from free space and carry their `patch`
  .obj    the same as text, the triangles of a patch in a group, such as
          patch_7
  .stl    the same as loose triangles, in single precision, which is all the
          format has
  .glb    binary glTF 2.0: positions (x, y, theta) in single precision, which
          is all the format has; the attribute `_PATCH` of a triangle's
          vertices is its patch";

/// Arguments of `cspace export`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ExportArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) which: Which,
    /// Meshes: how far a triangle may be from the contact surface, as a share of the pair's size [default: 0.001]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) tolerance: Option<f64>,
    /// Meshes: what a radian of θ is as third coordinate, in the model's unit [default: 1 in PLY; else a turn is as tall as
    /// the surface is wide]
    #[arg(long, value_name = "S", value_parser = given::factor, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) theta_scale: Option<f64>,
    /// Meshes: write numbers as text where the format can have either
    #[arg(long, hide_short_help = true)]
    pub(crate) ascii: bool,
    /// Pictures: the number of slices, at even steps of orientation [default: 12]
    #[arg(long, value_name = "N", value_parser = given::whole::<u32>(1..=400), allow_negative_numbers = true)]
    pub(crate) slices: Option<u32>,
    /// Pages: an answer of `cspace plan`, `disassemble` or `simulate` in JSON, to be played; may be given several times
    #[arg(long, value_name = "RECORD.json")]
    pub(crate) with: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// A format of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Json,
    Page,
    Picture(PictureFormat),
    Ply,
    Obj,
    Stl,
    Glb,
}

impl Kind {
    fn is_mesh(self) -> bool {
        matches!(self, Self::Ply | Self::Obj | Self::Stl | Self::Glb)
    }
}

/// Slices of a picture, if the user does not say.
const SLICES: u32 = 12;

const EXTENSIONS: &str = ".json, .html, .svg, .png, .pdf, .ply, .obj, .stl or .glb";

fn share(text: &str) -> Result<f64, String> {
    let is_right = |x| (1e-6..=0.5).contains(&x);
    given::number(text, is_right, "give a number from 1e-6 to 0.5")
}

/// Writes the file, and gives the unit of length.
pub(crate) fn run(args: &ExportArgs) -> Result<Option<String>, Failure> {
    let common = &args.common;
    let Some(path) = common.result.output.as_deref() else {
        return Err(Failure::new("export needs a file to write")
            .help(format_args!("give -o OUT with an extension: {EXTENSIONS}")));
    };
    let kind = kind(path)?;
    refuse_unused(args, kind, path)?;
    if kind == Kind::Page {
        let page = page::bundled(Page::bundled())?;
        let (file, unit) = page::file(&page, common, &args.which, &args.with)?;
        output::write(Some(path), &file)?;
        return Ok(unit);
    }
    let (subject, host) = ask::open(common)?;
    let pair = subject.one_pair(&args.which, &host)?;
    let unit = subject.unit().map(str::to_owned);
    let mut said = None;
    let bytes = match kind {
        // Written above: it is of all pairs.
        Kind::Page => return Ok(unit),
        Kind::Json => pair.as_file()?.into_bytes(),
        Kind::Picture(format) => {
            let scene = picture(args, &pair)?;
            picture::write(Some(path), format, &scene)?;
            return Ok(unit);
        }
        Kind::Ply | Kind::Obj | Kind::Stl | Kind::Glb => {
            let options = MeshOptions {
                tolerance: (args.tolerance).unwrap_or(MeshOptions::default().tolerance),
            };
            let space = pair.contact_space("a surface")?;
            let mesh = Mesh::new(&space, &options).map_err(|e| {
                Failure::new(format_args!("{}: {e}", path.display()))
                    .help("give a larger --tolerance; of a saved space, compute it again")
            })?;
            let theta_scale = args.theta_scale.unwrap_or_else(|| match kind {
                Kind::Ply => 1.0,
                _ => mesh.turn_as_tall_as_wide(),
            });
            let mesh = mesh.with_theta_scale(theta_scale);
            let encoding = if args.ascii {
                Encoding::Ascii
            } else {
                Encoding::Binary
            };
            if kind == Kind::Stl && !mesh.fits_single_precision() {
                return Err(single(path, &GlbError::Coordinate));
            }
            said = Some(report(&mesh, path));
            match kind {
                Kind::Obj => obj(&mesh).into_bytes(),
                Kind::Stl => stl(&mesh, encoding),
                Kind::Glb => glb(&mesh).map_err(|e| single(path, &e))?,
                _ => ply(&mesh, encoding),
            }
        }
    };
    output::write(Some(path), &bytes)?;
    if let Some(said) = said {
        // Where nobody listens nothing is lost.
        let _ = writeln!(std::io::stderr(), "{said}");
    }
    Ok(unit)
}

/// Options that say nothing about what is written are a slip.
fn refuse_unused(args: &ExportArgs, kind: Kind, path: &Path) -> Result<(), Failure> {
    let is_mesh = kind.is_mesh();
    let is_picture = matches!(kind, Kind::Picture(_));
    let unused = [
        (
            "--tolerance",
            args.tolerance.is_some() && !is_mesh,
            "meshes",
        ),
        (
            "--theta-scale",
            args.theta_scale.is_some() && !is_mesh,
            "meshes",
        ),
        (
            "--ascii",
            args.ascii && !matches!(kind, Kind::Ply | Kind::Stl),
            ".ply and .stl",
        ),
        (
            "--with",
            !args.with.is_empty() && kind != Kind::Page,
            "pages",
        ),
        ("--slices", args.slices.is_some() && !is_picture, "pictures"),
        (
            args.picture.given().unwrap_or_default(),
            args.picture.given().is_some() && !is_picture,
            "pictures",
        ),
    ];
    match unused.into_iter().find(|u| u.1) {
        None => Ok(()),
        Some((option, _, what)) => Err(Failure::new(format_args!(
            "{}: {option} is about {what}",
            path.display()
        ))
        .help(format_args!("leave {option} out, or write another format"))),
    }
}

/// The failure of a mesh that does not fit into the GLB format.
fn single(path: &Path, error: &GlbError) -> Failure {
    Failure::new(format_args!("{}: {error}", path.display()))
        .help("write .ply, which has double precision and is as long as need be")
}

fn kind(path: &Path) -> Result<Kind, Failure> {
    if let Some(format) = picture::format(Some(path)) {
        return Ok(Kind::Picture(format));
    }
    let extension = path
        .extension()
        .map(|e| e.to_string_lossy().to_ascii_lowercase());
    match extension.as_deref() {
        Some("json") => Ok(Kind::Json),
        Some("html") => Ok(Kind::Page),
        Some("ply") => Ok(Kind::Ply),
        Some("obj") => Ok(Kind::Obj),
        Some("stl") => Ok(Kind::Stl),
        Some("glb") => Ok(Kind::Glb),
        _ => Err(Failure::new(format_args!(
            "{}: the extension names no known format",
            path.display()
        ))
        .help(format_args!("let the name end in {EXTENSIONS}"))),
    }
}

/// Slices at even steps of orientation, or the plane of two motions.
fn picture(args: &ExportArgs, pair: &Chosen<'_>) -> Result<Scene, Failure> {
    let options = |plane| (args.picture).options(plane, pair.title(), pair.unit_label());
    if pair.class() == PairClass::FixedAxes && !pair.is_planar() {
        if args.slices.is_some() {
            return Err(
                Failure::new("--slices: a pair with fixed axes has one plane")
                    .help("leave --slices out, or use --general with the model"),
            );
        }
        let options = options(Plane::Motions)?;
        return match &*pair.space()? {
            PairSpace::FixedAxes(space) => Ok(plane(space, &options)),
            _ => Err(pair.no_orientation("a picture").into()),
        };
    }
    let options = options(Plane::Positions)?;
    let space = pair.contact_space("a picture")?;
    let orientations = even(space.window(), args.slices.unwrap_or(SLICES));
    let drawn: Vec<Slice> = orientations.iter().map(|&t| space.slice(t)).collect();
    let shown = SlicesPicture {
        space: &space,
        slices: &drawn,
        parts: None,
    };
    Ok(slices(&shown, &options))
}

/// Orientations at even steps: of a full turn multiples of a share of it, 0 among them; of a window from its first to its
/// last, or its middle alone.
fn even(window: Window, count: u32) -> Vec<f64> {
    let n = i64::from(count);
    let share = |k: i64, of: i64| k as f64 / of as f64;
    (0..n)
        .map(|k| {
            if window.full_turn {
                TAU * share(k - n / 2, n)
            } else if n == 1 {
                0.5 * (window.lo + window.hi)
            } else {
                window.lo + (window.hi - window.lo) * share(k, n - 1)
            }
        })
        .collect()
}

/// The summary of a mesh: its size, its error, and whether it is closed.
fn report(mesh: &Mesh, path: &Path) -> String {
    let openings = mesh.openings();
    format!(
        "{}: {}, {}, at most {:.2e} from the surface, {}{}",
        shown::text(&path.to_string_lossy()),
        count(mesh.vertices.len(), "vertex", "vertices"),
        count(mesh.triangles.len(), "triangle", "triangles"),
        mesh.deviation,
        match openings.elsewhere {
            0 => "closed".to_owned(),
            n => format!(
                "{} of {}",
                count(n, "open edge", "open edges"),
                openings.edges
            ),
        },
        if mesh.theta_scale == 1.0 {
            String::new()
        } else {
            format!(
                "; a radian is {:.6} of the third coordinate",
                mesh.theta_scale
            )
        }
    )
}
