//! Contact zones, in words, as JSON and as a picture.

use std::fmt::Write;

use crate::legacy::{Answer as Framed, Outcome, PairAnswer};
use cspace::{ContactSpace, Options, PairSpace, Slice};
use cspace_design::{Cell, Zones, area, zones};
use cspace_draw::{Nominal, PictureOptions, ZonesPicture};
use cspace_io::Model;
use cspace_io::model::{Coordinate, Requirement, Setting, Subject, Template};
use cspace_mechanism::PairEntry;
use serde::Serialize;

use crate::args::TolerancesArgs;
use crate::failure::Failure;
use crate::picture::Plane;
use crate::progress::Bar;

/// The zones of a pair.
#[derive(Debug, Serialize)]
struct Answer<'a> {
    /// The names of the coordinates.
    coordinates: [&'static str; 2],
    /// The orientation of a pair in the plane, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    theta: Option<f64>,
    window: Cell,
    /// Rectangles, each the ranges of both coordinates.
    free: &'a [Cell],
    blocked: &'a [Cell],
    bands: Vec<BandAnswer<'a>>,
}

#[derive(Debug, Serialize)]
struct BandAnswer<'a> {
    features: &'a [String; 2],
    cells: &'a [Cell],
}

/// The space of a pair as it is drawn, and what is shown of it.
enum Drawn {
    Plane(Box<cspace::FixedAxesSpace>),
    Slice(std::sync::Arc<ContactSpace>, Box<Slice>),
}

pub(super) fn run(
    args: &TolerancesArgs,
    set: &[Setting],
    (template, model): (&Template, &Model),
) -> Result<(), Failure> {
    let (requirement, pair) = about(args, model)?;
    let at = |of: Coordinate| match requirement.subject {
        Subject::Pair(_, mut quantity) => of.of(*quantity.at()),
        Subject::Motion(..) => None,
    };
    let output = args.result.output.as_deref();
    let format = crate::picture::format(output);
    let bar = Bar::new(model.mechanism.name.clone());
    let mechanism = &model.mechanism;
    let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &mechanism.parts[i].part);
    let relation = mechanism.relation(&pair);
    let options = Options {
        window: pair.window,
        ..Options::default()
    };
    let theta = args.at.or(at(Coordinate::Theta)).unwrap_or(0.0);
    let space = bar.watch(|bar| PairSpace::compute_with(fixed, moving, relation, &options, bar));
    let drawn = match space.map_err(Failure::new)? {
        PairSpace::FixedAxes(space) => Drawn::Plane(space),
        PairSpace::Planar(space) => {
            let slice = Box::new(space.slice(theta));
            Drawn::Slice(space, slice)
        }
        PairSpace::Lower(_) => {
            return Err(Failure::new(
                "--zones: the parts are connected by a joint, which has no tolerances",
            )
            .help("name a requirement of another pair: --requirement NAME"));
        }
    };
    let (nominal, plane, coordinates) = match &drawn {
        Drawn::Plane(space) => (
            Nominal::Plane(space),
            Plane::Motions,
            [Coordinate::U, Coordinate::V],
        ),
        Drawn::Slice(space, slice) => (
            Nominal::Slice(space, slice),
            Plane::Positions,
            [Coordinate::X, Coordinate::Y],
        ),
    };
    let unit = mechanism.unit.as_deref();
    let options: PictureOptions = args.picture.options(plane, mechanism.name.clone(), unit)?;
    let window = nominal.window(&options);
    let found = bar.watch(|bar| zones(template, set, model, (pair, window, theta), bar));
    let found = found.map_err(Failure::new)?;
    if let Some(format) = format {
        let bands = found.bands.iter();
        let bands = bands.map(|b| (b.features.join(", "), b.cells.as_slice()));
        let picture = ZonesPicture {
            nominal,
            free: &found.free,
            blocked: &found.blocked,
            bands: bands.collect(),
            mark: at(coordinates[0]).zip(at(coordinates[1])),
        };
        crate::picture::write(output, format, &cspace_draw::zones(&picture, &options))?;
    }
    if !args.zones {
        return Ok(());
    }
    let bands = found.bands.iter().map(|b| BandAnswer {
        features: &b.features,
        cells: &b.cells,
    });
    let answers = vec![PairAnswer {
        fixed: fixed.name().to_owned(),
        moving: moving.name().to_owned(),
        outcome: Outcome::DONE,
        content: Answer {
            coordinates: coordinates.map(Coordinate::name),
            theta: matches!(drawn, Drawn::Slice(..)).then_some(theta),
            window,
            free: &found.free,
            blocked: &found.blocked,
            bands: bands.collect(),
        },
    }];
    let answer = Framed::of_pairs("tolerances", unit, answers);
    super::super::print(&args.result, &answer, |written| {
        *written = text(&found, window, coordinates);
        Ok(())
    })
}

/// The requirement of which the pair is looked at: that of a name, or else the first about a pair.
fn about<'m>(
    args: &TolerancesArgs,
    model: &'m Model,
) -> Result<(&'m Requirement, PairEntry), Failure> {
    let mut pairs = model.requirements.iter().filter_map(|r| match r.subject {
        Subject::Pair(pair, _) => Some((r, pair)),
        Subject::Motion(..) => None,
    });
    pairs.next().ok_or_else(|| {
        Failure::new(format_args!(
            "{}: no requirement is about a pair of parts",
            args.file.display()
        ))
        .help("--zones shows the pair of a requirement such as play, position or clearance")
    })
}

fn text(found: &Zones, window: Cell, coordinates: [Coordinate; 2]) -> String {
    let whole = area(&[window]);
    let percent = |x: f64| format!("{:.3} %", 100.0 * x / whole + 0.0);
    let [a, b] = coordinates.map(Coordinate::name);
    let mut text = format!("of the window in {a} and {b}\n");
    let (free, blocked) = (area(&found.free), area(&found.blocked));
    // Writing to text does not fail.
    let _ = writeln!(text, "  {:>10}  free within all tolerances", percent(free));
    let _ = writeln!(
        text,
        "  {:>10}  blocked within all tolerances",
        percent(blocked)
    );
    let _ = writeln!(text, "  {:>10}  either", percent(whole - free - blocked));
    for band in &found.bands {
        let _ = writeln!(
            text,
            "  {:>10}  {}",
            percent(area(&band.cells)),
            band.features.join(", ")
        );
    }
    text
}
