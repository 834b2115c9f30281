//! Tolerance of a parameter: its largest deviations, and its distribution.

use cspace_drawing::Unit;

use super::fit::Fit;
use super::keys::{Key, Keys};
use super::node::Node;
use super::scope::Result;
use super::suggest::did_you_mean;
use super::table::Table;
use super::value::Value;
use crate::shown::{self, quoted};

/// A parameter with its tolerance.
#[rustfmt::skip]
pub(super) const PARAMETER: Keys = Keys::new(
    "give it as { value = 6.0, tol = 0.02 }",
    &[
        Key::new("value", "value", "The value, or an expression of other parameters.").needed("value = 6.0"),
        Key::new("tol", "tolerance", "How far it may be below and above the value, or a tolerance class of ISO 286 for the value as nominal size, such as H7 or g6."),
        Key::new("plus", "signed_deviation", "How far it may be above the value; below it if negative. Default: 0, where `minus` is given."),
        Key::new("minus", "signed_deviation", "How far it may be below the value; above it if negative. Default: 0, where `plus` is given."),
        Key::new("limits", "bounds", "Its smallest and its largest value, in place of deviations."),
        Key::new("distribution", "distribution", "How likely it is where within its tolerance; a table has values and densities, linear between them. Default: uniform."),
        Key::new("sigma", "literal_positive", "Of a normal distribution: how many standard deviations half the width of the tolerance is. Default: 3."),
        Key::new("position", "literal_not_negative", "The diameter of the circle in which the point lies of which this is a coordinate.").like("position = 0.2, the diameter of a zone"),
        Key::new("with", "any_text", "Of a position: the parameter that is the other coordinate.").like("with = \"hole_y\", the parameter that is the other coordinate of the point"),
    ],
);

/// Default number of standard deviations in half the width of a tolerance, for a normal distribution.
const SIGMA: f64 = 3.0;

/// Distribution of a parameter within its tolerance.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Uniform distribution.
    Uniform,
    /// Normal, about the middle of the tolerance.
    Normal {
        /// Number of standard deviations in half the width of the tolerance.
        sigma: f64,
    },
    /// Most likely at the value, and linearly less towards the limits.
    Triangular,
    /// Values with relative densities, linear between them.
    Table(Vec<[f64; 2]>),
}

/// A diametral zone: two parameters are the coordinates of a point within a circle.
#[derive(Debug, Clone, PartialEq)]
pub struct Position {
    /// The parameter that is the other coordinate.
    pub with: String,
    /// The diameter of the zone (the model's unit of length).
    pub zone: f64,
}

/// Tolerance read from the table of a parameter.
pub(super) struct Tolerance {
    extent: Option<Extent>,
    /// The key that is given as an angle, if one is.
    angle: Option<&'static str>,
    pub(super) distribution: Option<Distribution>,
    pub(super) position: Option<Position>,
}

enum Extent {
    /// Largest deviations below and above the value.
    Deviations(f64, f64),
    /// Smallest and largest value.
    Limits(f64, f64),
    /// Deviations of a tolerance class, about the value as nominal size.
    Fit(Fit),
}

impl Tolerance {
    pub(super) fn read(table: &Table<'_>) -> Result<Self> {
        let extent = extent(table)?;
        let position = position(table)?;
        if let (Some(_), Some(position)) = (&extent, &position) {
            let with = quoted(&position.with);
            return Err(table
                .error("position", "`position` is given beside another tolerance")
                .with_help(format!(
                    "keep one of them: the zone is what the parameter and {with} may be off"
                )));
        }
        let distribution = distribution(table)?;
        if distribution.is_some() && extent.is_none() {
            let error = table.error("distribution", "the parameter has no tolerance");
            return Err(error.with_help("add tol = 0.02, plus and minus, or limits = [5.98, 6.02]"));
        }
        let is_angle = |key: &&str| match table.get(key).map(|value| value.node) {
            Some(Node::List(all)) => all.iter().any(|node| matches!(node, Node::Text(_))),
            node => matches!(node, Some(Node::Text(_))),
        };
        let angle = match extent {
            Some(Extent::Fit(_)) => None,
            _ => EXTENTS.into_iter().find(is_angle),
        };
        Ok(Self {
            extent,
            angle,
            distribution,
            position,
        })
    }

    /// Whether the limits are the same, whatever the value is set to.
    pub(super) fn has_limits(&self) -> bool {
        matches!(self.extent, Some(Extent::Limits(..)))
    }

    /// Largest deviations of the parameter below and above its value.
    pub(super) fn deviations(&self, table: &Table<'_>, of: Nominal) -> Result<Option<(f64, f64)>> {
        let value = of.value;
        if let Some(key) = self.angle.filter(|_| !of.may_be_angle) {
            let message = format!(
                "`{key}` is an angle, but the value {} is a number",
                shown::number(value)
            );
            let help = "give both with a unit of angle, value = \"30deg\", or none";
            return Err(table.error(key, message).with_help(help));
        }
        // The value may be outside, as a shaft's nominal size often is: one of the two is below 0 then.
        let (below, above) = match &self.extent {
            None => return Ok(None),
            Some(Extent::Deviations(below, above)) => (*below, *above),
            Some(Extent::Limits(lo, hi)) => (value - lo, hi - value),
            Some(Extent::Fit(fit)) => of_fit(fit, table, of)?,
        };
        if let Some(Distribution::Table(rows)) = self.distribution.as_ref().filter(|_| !of.is_set) {
            let beyond = |x: f64| {
                let slack = ROUNDING * (value.abs() + below + above);
                x < value - below - slack || x > value + above + slack
            };
            if let Some(row) = rows.iter().find(|row| beyond(row[0])) {
                let message = format!(
                    "the distribution has the value {}, which is outside the tolerance, {} to {}",
                    shown::number(row[0]),
                    shown::number(value - below),
                    shown::number(value + above)
                );
                let help = "give values within the tolerance, or a wider tolerance";
                return Err(table.error("distribution", message).with_help(help));
            }
        }
        Ok(Some((below, above)))
    }
}

/// Value of a parameter, about which its tolerance is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nominal {
    pub(super) value: f64,
    /// Whether it was set from outside, in place of the value in the file.
    pub(super) is_set: bool,
    /// Whether the file has an angle, or an expression.
    pub(super) may_be_angle: bool,
    /// Whether the value is an angle.
    pub(super) is_angle: bool,
    /// The model's unit of length, if it is a known one.
    pub(super) unit: Option<Unit>,
}

/// Keys that say how far a parameter may be from its value.
const EXTENTS: [&str; 4] = ["tol", "plus", "minus", "limits"];

/// Tolerances beyond this are no dimension's (the unit of the parameter).
pub(super) const LARGEST: f64 = 1e12;

/// Values that differ by less, relative to them, are one.
const ROUNDING: f64 = 1e-12;

/// The deviations of a tolerance class, in the model's unit.
fn of_fit(fit: &Fit, table: &Table<'_>, of: Nominal) -> Result<(f64, f64)> {
    if of.is_angle {
        let error = table.error(
            "tol",
            "a tolerance class is of lengths, and the value is an angle",
        );
        return Err(error.with_help("give how far the angle may be off: \"0.5deg\""));
    }
    let Some(unit) = of.unit else {
        return Err(table
            .error("tol", "a tolerance class needs the model's unit of length")
            .with_help(
                "say unit = \"mm\" at the top of the file, or another unit, or give plus and minus",
            ));
    };
    let millimetres = unit.ratio(Unit::Millimetre);
    let Some([lower, upper]) = fit.deviations(of.value * millimetres) else {
        let message = format!(
            "ISO 286 has no such class for the size {} mm",
            shown::number(of.value * millimetres)
        );
        let help = "give another class, or plus and minus: sizes go to 500 mm, and classes that are not in use have no deviations";
        return Err(table.error("tol", message).with_help(help));
    };
    // No zero is negative.
    Ok((0.0 - lower / millimetres, 0.0 + upper / millimetres))
}

fn extent(table: &Table<'_>) -> Result<Option<Extent>> {
    let of = |key: &str, least: f64, expected: &str| {
        let Some(value) = table.get(key) else {
            return Ok(None);
        };
        let help = match key {
            "tol" => {
                "give how far the parameter may be from its value, 0.02 or \"0.5deg\", or a tolerance class, \"H7\""
            }
            _ => "give how far the parameter may be from its value: 0.02, or \"0.5deg\"",
        };
        match value.angle()?.filter(|x| *x >= least) {
            Some(by) if by.abs() <= LARGEST => Ok(Some(by)),
            Some(_) => Err(table
                .error(key, format!("`{key}` is more than {LARGEST:e}"))
                .with_help(help)),
            None => Err(table.wrong(key, value.node, expected, help)),
        }
    };
    let (above, below) = {
        let signed = |key| of(key, f64::NEG_INFINITY, "a number or an angle");
        (signed("plus")?, signed("minus")?)
    };
    let fit = (table.get("tol")).and_then(|tol| Fit::parse(tol.node.text()?));
    let both = match &fit {
        Some(_) => None,
        None => of(
            "tol",
            0.0,
            "a number of 0 or more, an angle, or a tolerance class",
        )?,
    };
    let limits = limits(table)?;
    let one_sided = above.is_some() || below.is_some();
    if one_sided && -below.unwrap_or(0.0) > above.unwrap_or(0.0) {
        return Err(table
            .error("minus", "`minus` and `plus` leave nothing between them")
            .with_help("`minus` counts downwards, and each is 0 where it is left out: limits of -0.007 and -0.020 are plus = -0.007, minus = 0.020"));
    }
    match (both.is_some() || fit.is_some(), limits) {
        (true, _) if one_sided => Err(table
            .error("tol", "`tol` is given beside `plus` or `minus`")
            .with_help("keep `tol`, or `plus` and `minus`")),
        (has_tol, Some(_)) if one_sided || has_tol => Err(table
            .error("limits", "`limits` are given beside another tolerance")
            .with_help("keep `limits`, or `tol`, or `plus` and `minus`")),
        (_, Some((lo, hi))) => Ok(Some(Extent::Limits(lo, hi))),
        (_, None) if fit.is_some() => Ok(fit.map(Extent::Fit)),
        (_, None) if both.is_some() => Ok(both.map(|tol| Extent::Deviations(tol, tol))),
        (_, None) => {
            Ok(one_sided.then(|| Extent::Deviations(below.unwrap_or(0.0), above.unwrap_or(0.0))))
        }
    }
}

fn limits(table: &Table<'_>) -> Result<Option<(f64, f64)>> {
    let Some(value) = table.get("limits") else {
        return Ok(None);
    };
    let help =
        "give the smallest and the largest value: limits = [5.98, 6.02], or [\"29deg\", \"31deg\"]";
    let both = match value.items().as_deref() {
        Some([lo, hi]) => lo.angle()?.zip(hi.angle()?),
        _ => None,
    };
    match both.filter(|(lo, hi)| lo.is_finite() && hi.is_finite()) {
        Some((lo, hi)) if lo > hi => Err(table
            .error("limits", "the first limit is larger than the second")
            .with_help(help)),
        Some(both) => Ok(Some(both)),
        None => Err(table.wrong(
            "limits",
            value.node,
            "a list of two numbers, or two angles",
            help,
        )),
    }
}

fn position(table: &Table<'_>) -> Result<Option<Position>> {
    let zone = table.number::<f64>("position")?;
    let with = table.text("with")?;
    match (zone, with) {
        (None, None) => Ok(None),
        (None, Some(_)) => Err(table.missing("position")),
        (Some(_), None) => Err(table.missing("with")),
        (Some(zone), _) if zone < 0.0 => Err(table
            .error("position", "the diameter of the zone is negative")
            .with_help("give the diameter of the circle in which the point lies")),
        (Some(zone), Some(with)) => Ok(Some(Position {
            with: with.to_owned(),
            zone,
        })),
    }
}

/// How distributions are written.
const HELP: &str = "give \"uniform\", \"normal\", \"triangular\", or a table of values and densities: [[5.98, 1], [6.0, 4], [6.02, 1]]";

/// Values with their densities.
fn densities(table: &Table<'_>, rows: &[Value<'_>]) -> Result<Vec<[f64; 2]>> {
    let mut read: Vec<[f64; 2]> = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let wrong = |what: &str| {
            let message = format!("entry {i} of the distribution {what}");
            Err(table.error("distribution", message).with_help(HELP))
        };
        let both = match row.items().as_deref() {
            Some([value, density]) => value.angle()?.zip(density.number()?),
            _ => None,
        };
        let is_row = |row: &(f64, f64)| row.0.is_finite() && row.1.is_finite() && row.1 >= 0.0;
        let Some((value, density)) = both.filter(is_row) else {
            return wrong("is not a value with a density of 0 or more");
        };
        if read.last().is_some_and(|last| last[0] >= value) {
            return wrong("has a value that is not larger than the one before");
        }
        read.push([value, density]);
    }
    Ok(read)
}

fn distribution(table: &Table<'_>) -> Result<Option<Distribution>> {
    const NAMES: [&str; 3] = ["uniform", "normal", "triangular"];
    let sigma = table.number::<f64>("sigma")?;
    let normal = || Distribution::Normal { sigma: SIGMA };
    let found = match table.get("distribution") {
        None => sigma.map(|_| normal()),
        Some(value) => Some(match (value.node, value.items()) {
            (Node::Text(name), _) => match &**name {
                "uniform" => Distribution::Uniform,
                "normal" => normal(),
                "triangular" => Distribution::Triangular,
                other => {
                    let message = format!("unknown distribution {}", quoted(other));
                    let error = value.error(message);
                    return Err(error.with_help(did_you_mean(other, NAMES, || HELP.to_owned())));
                }
            },
            (node, Some(rows)) => {
                let rows = densities(table, &rows)?;
                if rows.len() < 2 || rows.iter().all(|row| row[1] == 0.0) {
                    let expected = "two or more values, of which one has a density above 0,";
                    return Err(table.wrong("distribution", node, expected, HELP));
                }
                Distribution::Table(rows)
            }
            (node, None) => return Err(table.wrong("distribution", node, "a distribution", HELP)),
        }),
    };
    match (found, sigma) {
        (Some(Distribution::Normal { .. }), Some(sigma)) if sigma > 0.0 => {
            Ok(Some(Distribution::Normal { sigma }))
        }
        (Some(Distribution::Normal { .. }), Some(_)) => Err(table
            .error("sigma", "`sigma` is not positive")
            .with_help("give how many standard deviations half the tolerance is, such as 3")),
        (_, Some(_)) => Err(table
            .error(
                "sigma",
                "`sigma` is given of a distribution that is not normal",
            )
            .with_help("remove `sigma`, or give distribution = \"normal\"")),
        (found, None) => Ok(found),
    }
}
