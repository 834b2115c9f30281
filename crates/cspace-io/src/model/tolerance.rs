//! How far a parameter may be from its value, and how likely it is where.

use super::node::Node;
use super::suggest::nearest;
use super::table::{Result, Table, angle_of, number};
use crate::shown::{self, quoted};

/// Half the width of a tolerance is so many standard deviations of a normal distribution, if nothing is said.
const SIGMA: f64 = 3.0;

/// How likely a parameter is where within its tolerance.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Everywhere alike.
    Uniform,
    /// Normal, about the middle of the tolerance.
    Normal {
        /// How many standard deviations half the width of the tolerance is.
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

/// What the table of a parameter says of its tolerance.
pub(super) struct Tolerance {
    extent: Option<Extent>,
    pub(super) distribution: Option<Distribution>,
    pub(super) position: Option<Position>,
}

enum Extent {
    /// How far it may be below and above the value.
    Deviations(f64, f64),
    /// Its smallest and its largest value.
    Limits(f64, f64),
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
        Ok(Self {
            extent,
            distribution,
            position,
        })
    }

    /// How far the parameter may be below and above its value.
    pub(super) fn deviations(
        &self,
        table: &Table<'_>,
        value: f64,
        is_set: bool,
    ) -> Result<Option<(f64, f64)>> {
        match self.extent {
            None => Ok(None),
            Some(Extent::Deviations(below, above)) => Ok(Some((below, above))),
            Some(Extent::Limits(lo, hi)) if is_set || (lo..=hi).contains(&value) => {
                Ok(Some((value - lo, hi - value)))
            }
            Some(Extent::Limits(..)) => {
                let message = format!("the value {} is outside the limits", shown::number(value));
                let error = table.error("limits", message);
                Err(error.with_help("give limits that contain the value"))
            }
        }
    }
}

fn extent(table: &Table<'_>) -> Result<Option<Extent>> {
    let of = |key: &str| {
        let Some(node) = table.get(key) else {
            return Ok(None);
        };
        match angle_of(node).filter(|x| x.is_finite() && *x >= 0.0) {
            Some(value) => Ok(Some(value)),
            None => {
                let help = "give how far the parameter may be from its value: 0.02, or \"0.5deg\"";
                Err(table.wrong(key, node, "a number that is not negative", help))
            }
        }
    };
    let both = of("tol")?;
    let (above, below) = (of("plus")?, of("minus")?);
    let limits = table.interval("limits", true)?;
    let one_sided = above.is_some() || below.is_some();
    match (both, limits) {
        (Some(_), _) if one_sided => Err(table
            .error("tol", "`tol` is given beside `plus` or `minus`")
            .with_help("keep `tol`, or `plus` and `minus`")),
        (_, Some(_)) if one_sided || both.is_some() => Err(table
            .error("limits", "`limits` are given beside another tolerance")
            .with_help("keep `limits`, or `tol`, or `plus` and `minus`")),
        (Some(tol), _) => Ok(Some(Extent::Deviations(tol, tol))),
        (None, Some((lo, hi))) => Ok(Some(Extent::Limits(lo, hi))),
        (None, None) => {
            Ok(one_sided.then(|| Extent::Deviations(below.unwrap_or(0.0), above.unwrap_or(0.0))))
        }
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
                    let [value, density] = [number(&both[0])?, number(&both[1])?];
                    (value.is_finite() && density.is_finite() && density >= 0.0)
                        .then_some([value, density])
                }
                _ => None,
            };
            let rows: Option<Vec<[f64; 2]>> = rows.iter().map(row).collect();
            let rising = |rows: &Vec<[f64; 2]>| {
                rows.len() >= 2
                    && rows.windows(2).all(|w| w[0][0] < w[1][0])
                    && rows.iter().any(|r| r[1] > 0.0)
            };
            match rows.filter(rising) {
                Some(rows) => Some(Distribution::Table(rows)),
                None => {
                    let expected =
                        "two or more values that rise, with densities that are not negative";
                    return Err(table.wrong("distribution", node, expected, HELP));
                }
            }
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
