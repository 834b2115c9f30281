//! Tolerance of a parameter: its largest deviations, and its distribution.

use cspace_drawing::Unit;

use super::fit::Fit;
use super::node::Node;
use super::suggest::nearest;
use super::table::{Result, Table, angle_of, number};
use crate::shown::{self, quoted};

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
    pub(super) const KEYS: [&'static str; 9] = [
        "value",
        "tol",
        "plus",
        "minus",
        "limits",
        "distribution",
        "sigma",
        "position",
        "with",
    ];

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
        let is_angle = |key: &&str| match table.get(key) {
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
    pub(super) fn deviations(&self, table: &Table<'_>, of: Written) -> Result<Option<(f64, f64)>> {
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

/// Value of a parameter, as read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Written {
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
fn of_fit(fit: &Fit, table: &Table<'_>, of: Written) -> Result<(f64, f64)> {
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
        let Some(node) = table.get(key) else {
            return Ok(None);
        };
        let help = match key {
            "tol" => {
                "give how far the parameter may be from its value, 0.02 or \"0.5deg\", or a tolerance class, \"H7\""
            }
            _ => "give how far the parameter may be from its value: 0.02, or \"0.5deg\"",
        };
        match angle_of(node).filter(|x| *x >= least) {
            Some(value) if value.abs() <= LARGEST => Ok(Some(value)),
            Some(_) => Err(table
                .error(key, format!("`{key}` is more than {LARGEST:e}"))
                .with_help(help)),
            None => Err(table.wrong(key, node, expected, help)),
        }
    };
    let (above, below) = {
        let signed = |key| of(key, f64::NEG_INFINITY, "a number or an angle");
        (signed("plus")?, signed("minus")?)
    };
    let fit = match table.get("tol") {
        Some(Node::Text(text)) => Fit::parse(text),
        _ => None,
    };
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
    let Some(node) = table.get("limits") else {
        return Ok(None);
    };
    let help =
        "give the smallest and the largest value: limits = [5.98, 6.02], or [\"29deg\", \"31deg\"]";
    let both = match node {
        Node::List(both) if both.len() == 2 => angle_of(&both[0]).zip(angle_of(&both[1])),
        _ => None,
    };
    match both.filter(|(lo, hi)| lo.is_finite() && hi.is_finite()) {
        Some((lo, hi)) if lo > hi => Err(table
            .error("limits", "the first limit is larger than the second")
            .with_help(help)),
        Some(both) => Ok(Some(both)),
        None => Err(table.wrong("limits", node, "a list of two numbers, or two angles", help)),
    }
}

fn position(table: &Table<'_>) -> Result<Option<Position>> {
    let zone = table.number::<f64>("position")?;
    let with = table.text("with")?;
    match (zone, with) {
        (None, None) => Ok(None),
        (None, Some(_)) => Err(table.missing("position", "position = 0.2, the diameter of a zone")),
        (Some(_), None) => Err(table.missing(
            "with",
            "with = \"hole_y\", the parameter that is the other coordinate of the point",
        )),
        (Some(zone), _) if zone < 0.0 => Err(table
            .error("position", "the diameter of the zone is negative")
            .with_help("give the diameter of the circle in which the point lies")),
        (Some(zone), Some(with)) => Ok(Some(Position {
            with: with.to_owned(),
            zone,
        })),
    }
}

fn distribution(table: &Table<'_>) -> Result<Option<Distribution>> {
    const NAMES: [&str; 3] = ["uniform", "normal", "triangular"];
    const HELP: &str = "give \"uniform\", \"normal\", \"triangular\", or a table of values and densities: [[5.98, 1], [6.0, 4], [6.02, 1]]";
    let sigma = table.number::<f64>("sigma")?;
    let found = match table.get("distribution") {
        None => sigma.map(|_| Distribution::Normal { sigma: SIGMA }),
        Some(Node::Text(name)) => Some(match &**name {
            "uniform" => Distribution::Uniform,
            "normal" => Distribution::Normal { sigma: SIGMA },
            "triangular" => Distribution::Triangular,
            other => {
                let message = format!("unknown distribution {}", quoted(other));
                let error = table.error("distribution", message);
                return Err(match nearest(other, NAMES) {
                    Some(meant) => error.with_help(format!("did you mean `{meant}`?")),
                    None => error.with_help(HELP),
                });
            }
        }),
        Some(node @ Node::List(rows)) => {
            let row = |row: &Node| match row {
                Node::List(both) if both.len() == 2 => {
                    let [value, density] = [angle_of(&both[0])?, number(&both[1])?];
                    (value.is_finite() && density.is_finite() && density >= 0.0)
                        .then_some([value, density])
                }
                _ => None,
            };
            let mut read: Vec<[f64; 2]> = Vec::new();
            for (i, node) in rows.iter().enumerate() {
                let wrong = |what: &str| {
                    let message = format!("entry {i} of the distribution {what}");
                    table.error("distribution", message).with_help(HELP)
                };
                let Some(row) = row(node) else {
                    return Err(wrong("is not a value with a density of 0 or more"));
                };
                if read.last().is_some_and(|last| last[0] >= row[0]) {
                    return Err(wrong("has a value that is not larger than the one before"));
                }
                read.push(row);
            }
            if read.len() < 2 || read.iter().all(|row| row[1] == 0.0) {
                let expected = "two or more values, of which one has a density above 0,";
                return Err(table.wrong("distribution", node, expected, HELP));
            }
            Some(Distribution::Table(read))
        }
        Some(node) => return Err(table.wrong("distribution", node, "a distribution", HELP)),
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
