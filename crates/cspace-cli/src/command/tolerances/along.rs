//! Bands along a motion, in words and as a picture.

use std::fmt::{self, Write};

use cspace_api::tolerances::Extreme;
use cspace_api::tolerances::along::{Band, Bands, Question, Station};
use cspace_api::{Subject, Vary};
use cspace_draw::{Curve, CurveStrip, CurvesPicture, Scene};
use cspace_model::model::Dimension;

use super::TolerancesArgs;
use super::text::number;
use crate::ask::Terminal;
use crate::failure::Failure;
use crate::picture::{Plane, strip_label};
use crate::wording::{degrees, length};

pub(super) fn run(
    args: &TolerancesArgs,
    bands: &Question,
    subject: &Subject,
    host: &Terminal,
) -> Result<(), Failure> {
    let question = Question {
        requirement: args.analysis.requirement.clone(),
        ..bands.clone()
    };
    let vary = &question.along;
    let answer = question.ask(subject, host)?;
    let output = args.result.output.as_deref();
    if let Some(format) = crate::picture::format(output) {
        let picture = drawn(args, vary, &answer.content)?;
        crate::picture::write(output, format, &picture)?;
    }
    crate::command::tell(&args.result, &answer, |text, found| {
        let unit = subject.unit().map_or(String::new(), |u| format!(" {u}"));
        describe(text, vary, &found.requirements, &unit)
    })
}

fn describe(text: &mut String, vary: &Vary, bands: &[Band], unit: &str) -> fmt::Result {
    let at = |x: f64| if vary.is_angle { degrees(x) } else { length(x) };
    for (i, band) in bands.iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        let value = |x: f64| number(band.dimension, unit, x);
        writeln!(text, "{} along {}", band.requirement, vary.name)?;
        writeln!(
            text,
            "  {:>14}  {:>16}  {:>16}  {:>16}",
            vary.name, "nominal", "smallest", "largest"
        )?;
        for s in &band.stations {
            let shown = |x: Option<f64>| x.map_or("none".to_owned(), value);
            let reason = match s.nominal {
                Some(_) => &s.lo.failure,
                None => &s.failure,
            };
            write!(
                text,
                "  {:>14}  {:>16}  {:>16}  {:>16}",
                at(s.at),
                shown(s.nominal),
                shown(s.lo.value),
                shown(s.hi.value)
            )?;
            let open = |e: &&Extreme| e.value.is_some() && !e.certified;
            let gaps = [&s.lo, &s.hi].into_iter().filter(open);
            let gaps: Vec<Option<f64>> = gaps.map(|e| e.gap).collect();
            let most = gaps
                .iter()
                .try_fold(0.0_f64, |most, gap| Some(most.max((*gap)?)));
            match (reason, most) {
                (Some(reason), _) => writeln!(text, "  {reason}")?,
                (None, _) if gaps.is_empty() => writeln!(text)?,
                (None, Some(most)) => writeln!(text, "  or beyond by at most {}", value(most))?,
                (None, None) => writeln!(text, "  not proved")?,
            }
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
        *text += &worst("smallest", &|s| s.lo.value, -1.0);
        *text += &worst("largest", &|s| s.hi.value, 1.0);
        *text += &worst("widest", &Station::width, 1.0);
    }
    Ok(())
}

/// A strip for each requirement, with its nominal value and its extremes.
fn drawn(args: &TolerancesArgs, vary: &Vary, found: &Bands) -> Result<Scene, Failure> {
    let (mechanism, bands) = (&found.nominal.model.mechanism, &found.requirements);
    let unit = mechanism.unit.as_deref();
    let strip = |band: &Band| {
        let curve = |label: &str, of: &dyn Fn(&Station) -> Option<f64>| Curve {
            label: label.to_owned(),
            points: band.stations.iter().map(|s| (s.at, of(s))).collect(),
        };
        let (name, dimension) = (&band.requirement, band.dimension);
        CurveStrip {
            label: strip_label(name, dimension, unit),
            is_angle: dimension == Dimension::Angle,
            limits: band.limits.map(|[lo, hi]| (lo, hi)),
            seen: None,
            curves: vec![
                curve("", &|s| s.nominal),
                curve("", &|s| s.lo.value),
                curve("", &|s| s.hi.value),
            ],
        }
    };
    // How far the extremes are off is seen in a strip of its own.
    let off = |band: &Band| {
        let curve = |label: &str, end: fn(&Station) -> &Extreme| {
            let of = |s: &Station| Some(end(s).value? - s.nominal?);
            Curve {
                label: label.to_owned(),
                points: band.stations.iter().map(|s| (s.at, of(s))).collect(),
            }
        };
        let value = strip(band);
        CurveStrip {
            label: format!("off by, {}", value.label),
            limits: None,
            curves: vec![curve("smallest", |s| &s.lo), curve("largest", |s| &s.hi)],
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
    let options = (args.picture).options(Plane::Positions, mechanism.name.clone(), unit)?;
    Ok(cspace_draw::curves(&picture, &options))
}
