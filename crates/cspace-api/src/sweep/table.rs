//! The table of a sweep: what is varied, and what is measured.

use std::collections::BTreeMap;
use std::sync::Arc;

use cspace_design::{Row as Measured, Value};
use schemars::JsonSchema;
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};

use crate::error::Error;
use crate::frame::Content;
use crate::host::Host;
use crate::outcome::outcomes;
use crate::vary::Vary;

/// The most rows.
const MOST: usize = 10_000_000;

/// The last column, which says why values are missing.
const FAILURE: &str = "failure";

/// Values of what is varied, row by row.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Values {
    /// Names of parameters and coordinates.
    pub names: Vec<String>,
    /// A value for each of them in each row, in the model's unit or radians.
    pub rows: Vec<Vec<f64>>,
}

impl Values {
    /// Every combination of values, the last of them changing first.
    pub(super) fn grid(vary: &[Vary], host: &dyn Host) -> Result<Self, Error> {
        if vary.is_empty() {
            return Err(Error::new("nothing is varied").help(format_args!(
                "give {} NAME=LO:HI:N, or {} FILE.csv",
                host.option("vary"),
                host.option("rows")
            )));
        }
        let total = vary.iter().try_fold(1_usize, |n, v| n.checked_mul(v.count));
        let Some(total) = total.filter(|n| *n <= MOST) else {
            return Err(Error::new(format_args!("more than {MOST} rows"))
                .help("give smaller numbers of values"));
        };
        let row = |k: usize| {
            let mut rest = k;
            let mut values: Vec<f64> = (vary.iter().rev())
                .map(|v| {
                    let i = rest % v.count;
                    rest /= v.count;
                    v.value(i)
                })
                .collect();
            values.reverse();
            values
        };
        Ok(Self {
            names: vary.iter().map(|v| v.name.clone()).collect(),
            rows: (0..total).map(row).collect(),
        })
    }

    /// Refuses rows that do not have a value for each name.
    pub(super) fn check(&self) -> Result<(), Error> {
        match self.rows.iter().position(|r| r.len() != self.names.len()) {
            Some(i) => Err(Error::new(format_args!(
                "row {i} has {} values, and {} names are varied",
                self.rows[i].len(),
                self.names.len()
            ))
            .help("give a value for each name in each row")),
            None => Ok(()),
        }
    }
}

outcomes! {
    /// How far the table has come, and whether it has values.
    Outcome {
        /// All rows are there, and something is measured somewhere.
        Done = "done" is Yes,
        /// All rows are there, and nothing has a value in any of them.
        None = "none" is No,
        /// It was interrupted: the first rows are there.
        Interrupted = "interrupted" is Open,
    }
}

/// The rows of a table.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Rows {
    /// The names of the columns.
    #[serde(skip)]
    pub columns: Arc<[String]>,
    /// Values of what is varied and of what is measured, and `failure` where there is none; or where something changes, with the measure
    /// and what is so `before` and `after`: the value of each column, by its name.
    #[schemars(with = "Vec<BTreeMap<String, Cell>>")]
    pub rows: Vec<Row>,
}

impl Content for Rows {
    const COMMAND: &'static str = "sweep";
    type Outcome = Outcome;
}

/// A row of a table.
#[derive(Debug)]
pub struct Row {
    columns: Arc<[String]>,
    /// The value of each column.
    pub cells: Vec<Cell>,
}

/// The value of a column in a row.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Cell {
    /// There is none.
    None,
    /// In the model's unit, or radians.
    Number(f64),
    /// Yes or no.
    Truth(bool),
    /// Words.
    Text(String),
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, cell) in self.columns.iter().zip(&self.cells) {
            if name != FAILURE || *cell != Cell::None {
                map.serialize_entry(name, cell)?;
            }
        }
        map.end()
    }
}

impl Rows {
    /// No rows yet, with columns of these names.
    pub(super) fn new(columns: impl Iterator<Item = String>) -> Self {
        Self {
            columns: columns.collect(),
            rows: Vec::new(),
        }
    }

    pub(super) fn push(&mut self, cells: Vec<Cell>) {
        self.rows.push(Row {
            columns: Arc::clone(&self.columns),
            cells,
        });
    }
}

/// The names of the columns: what is varied, what is measured, and why there is no value.
pub(super) fn columns<'a>(
    names: &'a [String],
    measures: &'a [String],
) -> impl Iterator<Item = &'a str> {
    let header = names.iter().chain(measures).map(String::as_str);
    header.chain([FAILURE])
}

/// A row of values, and what is measured there.
pub(super) fn cells(values: &[f64], measures: &[String], row: &Measured) -> Vec<Cell> {
    let values = values.iter().map(|x| Cell::Number(*x));
    let measured = row.measured.iter().map(|m| match m {
        Ok(Value::Number(x)) => Cell::Number(*x),
        Ok(Value::Truth(is)) => Cell::Truth(*is),
        Err(_) => Cell::None,
    });
    let failure = match failure(measures, row) {
        reasons if reasons.is_empty() => Cell::None,
        reasons => Cell::Text(reasons),
    };
    values.chain(measured).chain([failure]).collect()
}

/// The reasons for the measures that a row lacks.
fn failure(measures: &[String], row: &Measured) -> String {
    let missing = measures.iter().zip(&row.measured);
    let reasons: Vec<String> = missing
        .filter_map(|(name, measured)| {
            let reason = measured.as_ref().err()?;
            Some(format!("{name}: {reason}"))
        })
        .collect();
    reasons.join("; ")
}
