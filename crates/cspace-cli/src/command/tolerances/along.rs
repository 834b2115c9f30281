//! Bands along a motion, in words, as JSON and as a picture.

use std::fmt::Write;

use crate::legacy::{Answer, Outcome};
use cspace_design::{Band, Extreme, Station, ToleranceOptions, Variations, Varied, along};
use cspace_draw::{Curve, CurveStrip, CurvesPicture, Scene};
use cspace_io::Model;
use cspace_io::model::{Dimension, Setting, Template};
use serde::Serialize;

use super::answer::{End, end};
use super::text::number;
use crate::args::{TolerancesArgs, Vary};
use crate::failure::Failure;
use crate::picture::{Plane, strip_label};
use crate::progress::Bar;
use crate::wording::{degrees, length};

/// A requirement along a motion.
#[derive(Debug, Serialize)]
struct Row<'a> {
    requirement: &'a str,
    measure: &'static str,
    /// The name of the coordinate.
    along: &'a str,
    stations: Vec<At>,
}

/// A requirement where the coordinate has a value.
#[derive(Debug, Serialize)]
struct At {
    /// In the model's unit or radians.
    at: f64,
    nominal: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    lo: End,
    hi: End,
}

pub(super) fn run(
    args: &TolerancesArgs,
    set: &[Setting],
    vary: &Vary,
    (template, model, variations): (&Template, &Model, &Variations),
    options: &ToleranceOptions,
) -> Result<(), Failure> {
    let name = &vary.name;
    let Some(Varied::Coordinate(coordinate)) = Varied::named(name, model) else {
        return Err(Failure::new(format_args!(
            "--along {name}: a motion goes along a coordinate"
        ))
        .help("give one of x, y, theta, u, v, such as --along u=0deg:360deg:73"));
    };
    let values: Vec<f64> = (0..vary.count).map(|i| vary.value(i)).collect();
    let bar = Bar::new(model.mechanism.name.clone());
    let bands = bar
        .watch(|bar| along(template, set, model, options, (coordinate, &values), bar))
        .map_err(Failure::new)?;
    if bands.is_empty() {
        return Err(Failure::new(format_args!(
            "{}: no number is measured at a configuration with the coordinate {name}",
            args.file.display()
        ))
        .help("vary a coordinate of the pair that is measured"));
    }
    let output = args.result.output.as_deref();
    if let Some(format) = crate::picture::format(output) {
        let picture = drawn(args, vary, model, &bands)?;
        crate::picture::write(output, format, &picture)?;
    }
    let unit = model.mechanism.unit.as_deref();
    let requirements = rows(vary, variations, &bands);
    let answer = Answer::new(
        "tolerances",
        unit,
        Outcome::DONE,
        crate::command::Requirements { requirements },
    );
    super::super::print(&args.result, &answer, |written| {
        let unit = unit.map_or(String::new(), |u| format!(" {u}"));
        *written = text(vary, &bands, &unit);
        Ok(())
    })
}

fn rows<'a>(vary: &'a Vary, variations: &Variations, bands: &'a [Band]) -> Vec<Row<'a>> {
    let at = |s: &Station| {
        let [lo, hi] = &s.exact;
        At {
            at: s.at,
            nominal: s.nominal.as_ref().ok().copied(),
            failure: s.nominal.as_ref().err().cloned(),
            lo: end(variations, lo),
            hi: end(variations, hi),
        }
    };
    let row = |band: &'a Band| Row {
        requirement: &band.requirement.name,
        measure: band.requirement.subject.name(),
        along: &vary.name,
        stations: band.stations.iter().map(at).collect(),
    };
    bands.iter().map(row).collect()
}

fn text(vary: &Vary, bands: &[Band], unit: &str) -> String {
    let mut text = String::new();
    let at = |x: f64| if vary.is_angle { degrees(x) } else { length(x) };
    for (i, band) in bands.iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        let value = |x: f64| number(band.requirement.dimension, unit, x);
        // Writing to text does not fail.
        let _ = writeln!(text, "{} along {}", band.requirement.name, vary.name);
        let _ = writeln!(
            text,
            "  {:>14}  {:>16}  {:>16}  {:>16}",
            vary.name, "nominal", "smallest", "largest"
        );
        for s in &band.stations {
            let shown = |x: Option<f64>| x.map_or("none".to_owned(), value);
            let [lo, hi] = &s.exact;
            let of = |e: &Extreme| shown(e.value.as_ref().ok().copied());
            let (nominal, reason) = match &s.nominal {
                Ok(x) => (Some(*x), lo.value.as_ref().err()),
                Err(reason) => (None, Some(reason)),
            };
            let _ = write!(
                text,
                "  {:>14}  {:>16}  {:>16}  {:>16}",
                at(s.at),
                shown(nominal),
                of(lo),
                of(hi)
            );
            let gaps = s.exact.iter().filter(|e| e.value.is_ok() && !e.certified);
            let gaps: Vec<Option<f64>> = gaps.map(|e| e.gap).collect();
            let most = gaps
                .iter()
                .try_fold(0.0_f64, |most, gap| Some(most.max((*gap)?)));
            let _ = match (reason, most) {
                (Some(reason), _) => writeln!(text, "  {reason}"),
                (None, _) if gaps.is_empty() => writeln!(text),
                (None, Some(most)) => writeln!(text, "  or beyond by at most {}", value(most)),
                (None, None) => writeln!(text, "  not proved"),
            };
        }
        let worst = |what: &str, of: &dyn Fn(&Station) -> Option<f64>, sign: f64| {
            let all = band.stations.iter().filter_map(|s| Some((of(s)?, s.at)));
            // The first of equals.
            let most = all.min_by(|a, b| (sign * b.0).total_cmp(&(sign * a.0)));
            most.map_or(String::new(), |(x, place)| {
                format!(
                    "  {what:10} {} at {} = {}\n",
                    value(x),
                    vary.name,
                    at(place)
                )
            })
        };
        text += &worst("smallest", &|s| s.exact[0].value.clone().ok(), -1.0);
        text += &worst("largest", &|s| s.exact[1].value.clone().ok(), 1.0);
        text += &worst("widest", &Station::width, 1.0);
    }
    text
}

/// A strip for each requirement, with its nominal value and its extremes.
fn drawn(
    args: &TolerancesArgs,
    vary: &Vary,
    model: &Model,
    bands: &[Band],
) -> Result<Scene, Failure> {
    let unit = model.mechanism.unit.as_deref();
    let strip = |band: &Band| {
        let curve = |label: &str, of: &dyn Fn(&Station) -> Option<f64>| Curve {
            label: label.to_owned(),
            points: band.stations.iter().map(|s| (s.at, of(s))).collect(),
        };
        let (name, dimension) = (&band.requirement.name, band.requirement.dimension);
        CurveStrip {
            label: strip_label(name, dimension, unit),
            is_angle: dimension == Dimension::Angle,
            limits: band.requirement.limits().map(|[lo, hi]| (lo, hi)),
            seen: None,
            curves: vec![
                curve("", &|s| s.nominal.clone().ok()),
                curve("", &|s| s.exact[0].value.clone().ok()),
                curve("", &|s| s.exact[1].value.clone().ok()),
            ],
        }
    };
    // How far the extremes are off is seen in a strip of its own.
    let off = |band: &Band| {
        let curve = |label: &str, i: usize| {
            let of = |s: &Station| Some(s.exact[i].value.clone().ok()? - s.nominal.clone().ok()?);
            Curve {
                label: label.to_owned(),
                points: band.stations.iter().map(|s| (s.at, of(s))).collect(),
            }
        };
        let value = strip(band);
        CurveStrip {
            label: format!("off by, {}", value.label),
            limits: None,
            curves: vec![curve("smallest", 0), curve("largest", 1)],
            ..value
        }
    };
    let picture = CurvesPicture {
        across: if vary.is_angle {
            format!("{}, deg", vary.name)
        } else {
            vary.name.clone()
        },
        is_angle: vary.is_angle,
        strips: bands.iter().flat_map(|b| [strip(b), off(b)]).collect(),
        marks: Vec::new(),
    };
    let options = (args.picture).options(Plane::Positions, model.mechanism.name.clone(), unit)?;
    Ok(cspace_draw::curves(&picture, &options))
}
