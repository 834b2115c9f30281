//! The analysis of tolerances in words.

use std::fmt::{self, Write};

use cspace_api::Outcome as _;
use cspace_api::tolerances::Outcome;
use cspace_design::{Extreme, Linear, MonteCarlo, Tolerances, Value, Variations};
use cspace_model::Mechanism;
use cspace_model::model::{Dimension, Target};

use crate::subject::placed_by_name;
use crate::wording::{degrees, length};

/// A column of labels is so wide.
const LABEL: usize = 10;

/// Formats the numbers of a requirement: by its dimension, with the unit.
struct Words<'a> {
    model: &'a Mechanism,
    variations: &'a Variations,
    dimension: Dimension,
    unit: &'a str,
}

pub(super) fn described(
    model: &Mechanism,
    variations: &Variations,
    found: &[Tolerances],
    unit: &str,
) -> String {
    let mut text = String::new();
    for (i, of) in found.iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        let words = Words {
            model,
            variations,
            dimension: of.nominal.requirement.dimension,
            unit,
        };
        // Writing to text does not fail.
        let _ = words.requirement(&mut text, of);
    }
    text
}

/// Describes what derivatives as drawn say, while the rest is computed.
pub(super) fn at_once(variations: &Variations, known: &[Tolerances], unit: &str) -> String {
    let mut text = String::new();
    for of in known {
        let (Some(linear), name) = (&of.linear, &of.nominal.requirement.name) else {
            continue;
        };
        let dimension = of.nominal.requirement.dimension;
        let [worst, rss] = [linear.worst, linear.rss].map(|both| {
            let [lo, hi] = both.map(|x| number(dimension, unit, x));
            format!("{lo} to {hi}")
        });
        let _ = writeln!(text, "{name}: linear {worst}, rss {rss}");
    }
    let parameters = variations.len();
    let _ = write!(
        text,
        "extremes within the tolerances of {parameters} parameters are sought and proved; --no-proof finds them alone, Ctrl-C keeps what is known"
    );
    text
}

impl Words<'_> {
    fn number(&self, x: f64) -> String {
        number(self.dimension, self.unit, x)
    }

    fn requirement(&self, text: &mut String, of: &Tolerances) -> fmt::Result {
        let requirement = &of.nominal.requirement;
        writeln!(text, "{}: {}", requirement.name, self.summary(of))?;
        let nominal = match &of.nominal.measured {
            Ok(measured) => match measured.value {
                Value::Number(x) => self.number(x),
                Value::Truth(true) => "yes".to_owned(),
                Value::Truth(false) => "no".to_owned(),
            },
            Err(error) => format!("none: {error}"),
        };
        writeln!(text, "  {:LABEL$} {nominal}", "nominal")?;
        let name = |i: usize| self.model.parts[i].part.name();
        for ([a, b], parts) in (of.nominal.touching.iter()).zip(of.nominal.parts.iter().cycle()) {
            let [fixed, moving] = parts.map(name);
            let a = placed_by_name(self.model, fixed, a);
            let b = placed_by_name(self.model, moving, b);
            writeln!(text, "  {:LABEL$} {a}, {b}", "touching")?;
        }
        match requirement.target {
            Some(Target::Limits(lo, hi)) => {
                let (lo, hi) = (self.number(lo), self.number(hi));
                writeln!(text, "  {:LABEL$} {lo} to {hi}", "limits")?;
            }
            Some(Target::Equals(wanted)) => {
                let wanted = if wanted { "yes" } else { "no" };
                writeln!(text, "  {:LABEL$} {wanted}", "required")?;
            }
            None => {}
        }
        if let Some(linear) = &of.linear {
            self.linear(text, linear)?;
        }
        if let Some([lo, hi]) = &of.exact {
            self.extreme(text, "smallest", lo)?;
            self.extreme(text, "largest", hi)?;
        }
        for change in &of.structure {
            let beyond = if change.share > 1.0 + 1e-9 {
                ", beyond the tolerances"
            } else {
                ""
            };
            writeln!(
                text,
                "  {:LABEL$} at {} times the tolerances{beyond}: {}",
                change.kind.name(),
                share(change.share),
                change.what
            )?;
            for [a, b] in &change.features {
                writeln!(text, "  {:LABEL$} {a}, {b}", "")?;
            }
            writeln!(text, "  {:LABEL$} {}", "", self.place(&change.at))?;
        }
        let margin = match of.margin.factor {
            Some(factor) => format!("{} times the tolerances: {}", share(factor), of.margin.what),
            None => of.margin.what.clone(),
        };
        writeln!(text, "  {:LABEL$} {margin}", "margin")?;
        if let Some(samples) = &of.monte_carlo {
            self.samples(text, samples)?;
        }
        Ok(())
    }

    /// The first line: whether the requirement holds within the tolerances, and the parameter that matters most.
    fn summary(&self, of: &Tolerances) -> String {
        let outcome = Outcome::of(of);
        let word = outcome.word();
        let fails = match (outcome, of.margin.factor) {
            (Outcome::Fails | Outcome::Jams, Some(factor)) => format!(
                "{word} within the tolerances, from {} times them on",
                share(factor)
            ),
            (Outcome::NotMet, _) => format!("{word} as drawn"),
            (Outcome::Holds, Some(_)) => format!("{word} within the tolerances"),
            (Outcome::Holds, None) => format!("{word}, nothing fails"),
            _ => word.to_owned(),
        };
        let parameters = of.linear.iter().flat_map(|l| &l.parameters);
        let most = parameters.max_by(|a, b| a.worst_share.total_cmp(&b.worst_share));
        match most.filter(|p| p.worst_share > 0.0) {
            Some(p) => format!(
                "{fails}; {} matters most, {} of the worst case",
                p.parameter,
                percent(p.worst_share)
            ),
            None => fails,
        }
    }

    fn linear(&self, text: &mut String, linear: &Linear) -> fmt::Result {
        let names = linear
            .parameters
            .iter()
            .map(|p| p.parameter.chars().count());
        let wide = names.max().unwrap_or(0).max("parameter".len());
        writeln!(
            text,
            "  {:LABEL$} {:wide$}  {:>12}  {:>20}  {:>15}  {:>8}  {:>8}",
            "", "parameter", "value", "tolerance", "derivative", "worst", "variance"
        )?;
        let mut order: Vec<usize> = (0..linear.parameters.len()).collect();
        order.sort_by(|&a, &b| {
            let share = |i: usize| linear.parameters[i].worst_share;
            share(b).total_cmp(&share(a)).then(a.cmp(&b))
        });
        for i in order {
            let (p, v) = (&linear.parameters[i], &self.variations.list[i]);
            let tolerance = tolerance(self.variations, i);
            let [down, up] = p.derivative;
            let one_sided = if down == up {
                String::new()
            } else {
                format!("  ({} for smaller values)", self.derivative(down))
            };
            writeln!(
                text,
                "  {:LABEL$} {:wide$}  {:>12}  {tolerance:>20}  {:>15}  {:>8}  {:>8}{one_sided}",
                "",
                p.parameter,
                given(self.variations, i, v.parameter.value),
                self.derivative(up),
                percent(p.worst_share),
                percent(p.variance_share),
            )?;
        }
        for (label, [lo, hi]) in [("linear", linear.worst), ("rss", linear.rss)] {
            let half = self.number(0.5 * (hi - lo));
            let (lo, hi) = (self.number(lo), self.number(hi));
            writeln!(text, "  {label:LABEL$} {lo} to {hi} (±{half})")?;
        }
        Ok(())
    }

    fn derivative(&self, x: f64) -> String {
        let (x, unit) = match self.dimension {
            Dimension::Angle => (x.to_degrees() + 0.0, " deg"),
            _ => (x + 0.0, ""),
        };
        if x == 0.0 || x.abs() >= 1e-3 {
            format!("{x:.6}{unit}")
        } else {
            format!("{x:.3e}{unit}")
        }
    }

    fn extreme(&self, text: &mut String, label: &str, of: &Extreme) -> fmt::Result {
        let value = match &of.value {
            Ok(value) => {
                let certain = match (of.certified, of.gap) {
                    (true, _) => ", proved".to_owned(),
                    (false, Some(gap)) if self.number(gap) == self.number(0.0) => {
                        ", found; it may be beyond by less than is shown".to_owned()
                    }
                    (false, Some(gap)) => {
                        format!(", found; it may be beyond by {}", self.number(gap))
                    }
                    (false, None) => ", found, not proved".to_owned(),
                };
                let jumps = if of.jumps { ", where it jumps" } else { "" };
                format!("{}{certain}{jumps}", self.number(*value))
            }
            Err(failure) => format!("none: {failure}"),
        };
        writeln!(text, "  {label:LABEL$} {value}")?;
        writeln!(text, "  {:LABEL$} at {}", "", self.place(&of.at))
    }

    /// The values of the parameters at deviations.
    fn place(&self, deviations: &[f64]) -> String {
        /// More are in the answer as JSON.
        const MOST: usize = 8;
        let all = self.variations.list.iter().enumerate().zip(deviations);
        let moved = all.filter(|(_, by)| **by != 0.0);
        let mut values: Vec<String> = moved
            .map(|((i, v), by)| {
                let value = given(self.variations, i, v.parameter.value + by);
                format!("{} = {value}", v.parameter.name)
            })
            .collect();
        let more = values.len().saturating_sub(MOST);
        values.truncate(MOST);
        match (values.is_empty(), more) {
            (true, _) => "the values as drawn".to_owned(),
            (false, 0) => values.join(", "),
            (false, more) => format!("{} and {more} more", values.join(", ")),
        }
    }

    fn samples(&self, text: &mut String, of: &MonteCarlo) -> fmt::Result {
        let ppm = |x: f64| format!("{:.0} ppm", x * 1e6);
        // Where none of n samples fails, at most 3/n do, with 95 % certainty.
        let rare = format!("{:.0} ppm", 3e6 / of.samples as f64);
        let of_all = match of.met {
            1.0 => format!("100 %; at most {rare} fail, with 95 % certainty"),
            0.0 => format!("0 %; at most {rare} hold, with 95 % certainty"),
            met => format!("{} ± {}", fine_percent(met), fine_percent(of.error)),
        };
        writeln!(
            text,
            "  {:LABEL$} {} samples: {of_all}",
            "yield", of.samples
        )?;
        let [below, above] = of.outside;
        if below + above > 0.0 {
            writeln!(text, "  {:LABEL$} {}", "below", ppm(below))?;
            writeln!(text, "  {:LABEL$} {}", "above", ppm(above))?;
        }
        for (kind, share) in &of.failures {
            writeln!(text, "  {:LABEL$} {}", kind, ppm(*share))?;
        }
        let [mean, sigma, skewness, kurtosis] = of.moments;
        if mean.is_finite() && self.dimension != Dimension::Truth {
            let (mean, sigma) = (self.number(mean), self.number(sigma));
            writeln!(text, "  {:LABEL$} {mean}, sigma {sigma}", "mean")?;
            writeln!(
                text,
                "  {:LABEL$} {skewness:.4}, excess kurtosis {kurtosis:.4}",
                "skewness"
            )?;
        }
        if of.computed > 0.0 {
            let share = fine_percent(of.computed);
            writeln!(
                text,
                "  {:LABEL$} {share} of them by a space of their own",
                ""
            )?;
        }
        Ok(())
    }
}

/// A value of a requirement.
pub(super) fn number(dimension: Dimension, unit: &str, x: f64) -> String {
    match dimension {
        Dimension::Angle => degrees(x),
        Dimension::Time => format!("{} s", length(x)),
        Dimension::Number | Dimension::Truth => length(x),
        Dimension::Length => format!("{}{unit}", length(x)),
    }
}

/// A value of a parameter, or a deviation.
fn given(variations: &Variations, i: usize, x: f64) -> String {
    if variations.list[i].parameter.is_angle {
        degrees(x)
    } else {
        length(x)
    }
}

/// How far a parameter may be from its value.
pub(super) fn tolerance(variations: &Variations, i: usize) -> String {
    let [below, above] = variations.list[i].deviations;
    match variations.zone_of(i) {
        Some(zone) => format!("zone {}", length(2.0 * zone.radius)),
        None if (below + above).abs() <= 1e-9 * (above - below) => {
            format!("±{}", given(variations, i, above))
        }
        None => {
            let [below, above] = [-below, above].map(|x| given(variations, i, x));
            format!("-{below} +{above}")
        }
    }
}

fn share(x: f64) -> String {
    if 0.0 < x && x < 1e-4 {
        return format!("{x:.3e}");
    }
    length(x)
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

fn percent(x: f64) -> String {
    format!("{:.2} %", 100.0 * x)
}

fn fine_percent(x: f64) -> String {
    format!("{:.4} %", 100.0 * x)
}
