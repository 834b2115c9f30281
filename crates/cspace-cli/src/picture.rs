//! Options of pictures, common to all commands that write them.

use std::path::Path;

use clap::{Args, ValueEnum};
use cspace_draw::{Labels, PictureFormat, PictureOptions, Scene};
use cspace_model::model::Dimension;

use crate::failure::Failure;
use crate::output;
use cspace_api::given;

/// Options of every picture.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Pictures (.svg, .png, .pdf)")]
pub(crate) struct SheetArgs {
    /// Width and height in dots
    #[arg(long, value_name = "WxH", value_parser = size, hide_short_help = true)]
    pub(crate) size: Option<(f64, f64)>,
    /// Title above the picture
    #[arg(long, value_name = "TEXT", hide_short_help = true)]
    pub(crate) title: Option<String>,
}

/// Options of pictures.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Pictures (.svg, .png, .pdf)")]
pub(crate) struct PictureArgs {
    #[command(flatten)]
    sheet: SheetArgs,
    /// Names and numbers in the picture [default: auto, those that fit]
    #[arg(long, value_enum, hide_short_help = true)]
    pub(crate) labels: Option<LabelChoice>,
    /// Range of x that is shown
    #[arg(long, value_name = "LO,HI", value_parser = range, allow_hyphen_values = true, hide_short_help = true)]
    pub(crate) x: Option<(f64, f64)>,
    /// Range of y that is shown
    #[arg(long, value_name = "LO,HI", value_parser = range, allow_hyphen_values = true, hide_short_help = true)]
    pub(crate) y: Option<(f64, f64)>,
    /// Fixed axes: range of u that is shown; angles in radians or such as 18deg
    #[arg(long, value_name = "LO,HI", value_parser = given::range, allow_hyphen_values = true, hide_short_help = true)]
    pub(crate) u: Option<(f64, f64)>,
    /// Fixed axes: range of v that is shown
    #[arg(long, value_name = "LO,HI", value_parser = given::range, allow_hyphen_values = true, hide_short_help = true)]
    pub(crate) v: Option<(f64, f64)>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LabelChoice {
    /// None
    None,
    /// Labels that fit
    Auto,
    /// Labels that fit, including those of features, named as in answers
    Features,
    /// All, and numbers of vertices
    All,
}

/// The label of a strip that plots a quantity: its name and unit.
pub(crate) fn strip_label(name: &str, dimension: Dimension, unit: Option<&str>) -> String {
    match (dimension, unit) {
        (Dimension::Angle, _) => format!("{name}, deg"),
        (Dimension::Time, _) => format!("{name}, s"),
        (Dimension::Truth, _) => format!("{name} (1 is yes)"),
        (Dimension::Length, Some(unit)) => format!("{name}, {unit}"),
        (Dimension::Length | Dimension::Number, _) => name.to_owned(),
    }
}

/// The coordinates of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Plane {
    /// x and y.
    Positions,
    /// u and v.
    Motions,
}

impl PictureArgs {
    /// The options of a picture in some coordinates.
    pub(crate) fn options(
        &self,
        plane: Plane,
        title: String,
        unit: Option<&str>,
    ) -> Result<PictureOptions, Failure> {
        let (seen, unused, wanted) = match plane {
            Plane::Positions => ((self.x, self.y), [self.u, self.v], "--x and --y"),
            Plane::Motions => ((self.u, self.v), [self.x, self.y], "--u and --v"),
        };
        if unused.iter().any(Option::is_some) {
            return Err(Failure::new(match plane {
                Plane::Positions => {
                    "--u and --v are about the plane of two motions, and this picture has x and y"
                }
                Plane::Motions => {
                    "--x and --y are about positions, and this picture has the motions u and v"
                }
            })
            .help(format_args!("give {wanted}")));
        }
        Ok(PictureOptions {
            size: self.sheet.size,
            title: self.sheet.title.clone().unwrap_or(title),
            unit: unit.map(str::to_owned),
            labels: match self.labels {
                None | Some(LabelChoice::Auto) => Labels::Auto,
                Some(LabelChoice::None) => Labels::None,
                Some(LabelChoice::Features) => Labels::Features,
                Some(LabelChoice::All) => Labels::All,
            },
            x: seen.0,
            y: seen.1,
        })
    }

    /// The first option that was given, if any: where no picture is written it says nothing.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let all = [
            ("--labels", self.labels.is_some()),
            ("--x", self.x.is_some()),
            ("--y", self.y.is_some()),
            ("--u", self.u.is_some()),
            ("--v", self.v.is_some()),
        ];
        let own = || all.into_iter().find(|o| o.1).map(|o| o.0);
        self.sheet.given().or_else(own)
    }

    /// Refuses options of pictures where none is written.
    pub(crate) fn refuse(&self) -> Result<(), Failure> {
        refuse(self.given())
    }
}

impl SheetArgs {
    fn given(&self) -> Option<&'static str> {
        let title = || self.title.as_ref().map(|_| "--title");
        self.size.map(|_| "--size").or_else(title)
    }

    /// Refuses options of pictures where none is written.
    pub(crate) fn refuse(&self) -> Result<(), Failure> {
        refuse(self.given())
    }
}

fn refuse(given: Option<&str>) -> Result<(), Failure> {
    match given {
        None => Ok(()),
        Some(option) => Err(Failure::new(format_args!("{option} is about pictures"))
            .help("let the name after -o end in .svg, .png or .pdf, or leave the option out")),
    }
}

/// The format of a picture that a file's extension names.
pub(crate) fn format(path: Option<&Path>) -> Option<PictureFormat> {
    PictureFormat::of_extension(&path?.extension()?.to_string_lossy())
}

/// Writes a picture.
pub(crate) fn write(
    path: Option<&Path>,
    format: PictureFormat,
    scene: &Scene,
) -> Result<(), Failure> {
    let bytes = (format.write(scene)).map_err(|e| {
        Failure::new(format_args!("--size: {e}")).help("give a smaller --size, or write .svg")
    })?;
    output::write(path, &bytes)
}

fn size(text: &str) -> Result<(f64, f64), String> {
    /// Accepted lengths of a side, in dots: from the smallest readable picture to more than any printer resolves.
    const SIDES: std::ops::RangeInclusive<f64> = 100.0..=50_000.0;
    let side = |text: &str| {
        text.trim()
            .parse::<f64>()
            .ok()
            .filter(|s| SIDES.contains(s))
    };
    (text.split_once(['x', 'X', '×']))
        .and_then(|(w, h)| Some((side(w)?, side(h)?)))
        .ok_or_else(|| {
            "give width x height in dots, such as 800x600, each from 100 to 50000".into()
        })
}

fn range(text: &str) -> Result<(f64, f64), String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    (text.split_once(','))
        .and_then(|(lo, hi)| Some((number(lo)?, number(hi)?)))
        .filter(|(lo, hi)| lo < hi)
        .ok_or_else(|| "give two numbers with a comma between, the smaller first".into())
}
