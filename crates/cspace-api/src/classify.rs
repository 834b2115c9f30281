//! Configurations, one after the other: whether each is free, in which region, how far from contact, and what touches.

use core::f64::consts::TAU;
use std::collections::BTreeMap;

use cspace::{
    Classification, Classifier, Configuration, Coordinates, PairSpace, QueryError, RegionId,
    parallel,
};
use cspace_design::{pair_of, texts};
use cspace_model::shown;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content, Pairs};
use crate::host::Host;
use crate::outcome::Done;
use crate::subject::{Chosen, Which};

/// From so many rows on it pays to prepare the space for them: that takes about as long as so many rows without.
const MANY: usize = 4096;

/// Which configurations are classified, and what is asked about them.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The pair; that of the model without.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub which: Which,
    /// The configurations.
    #[cfg_attr(feature = "command", arg(skip))]
    pub rows: Vec<Given>,
    /// Where the rows are from, for messages.
    #[cfg_attr(feature = "command", arg(skip))]
    pub source: Option<String>,
    /// Columns added to each row, in this order.
    #[cfg_attr(feature = "command", arg(long, value_name = "NAMES", value_parser = crate::command::words::<Column>(), value_delimiter = ',', default_value = "class", hide_short_help = true))]
    pub columns: Vec<Column>,
    /// How far apart features may be that touch, in the model's unit [default: the resolution]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true, hide_short_help = true))]
    pub touch: Option<f64>,
}

impl Default for Question {
    fn default() -> Self {
        Self {
            which: Which::default(),
            rows: Vec::new(),
            source: None,
            columns: vec![Column::Class],
            touch: None,
        }
    }
}

/// A configuration, and what is given with it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
pub struct Given {
    /// The configuration: x, y and theta, or u and v of a pair on fixed axes.
    pub at: Coordinates,
    /// Columns by name that the answer repeats.
    #[serde(default)]
    pub columns: BTreeMap<String, Cell>,
    /// The line of the source, for messages.
    #[serde(default)]
    pub line: Option<u64>,
}

/// A value of a column that is given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// Any other text.
    Text(String),
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Self::Number(number),
            _ => Self::Text(text.to_owned()),
        }
    }
}

/// A property of a configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Column {
    /// free, blocked or contact.
    Class,
    /// The number of the free region: 0 for `outside`, 1 for `pocket 1`.
    Region,
    /// How far the moving part moves to the nearest contact.
    Distance,
    /// The features that touch.
    Touching,
}

impl Column {
    /// As in the answer.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Class => "class",
            Self::Region => "region",
            Self::Distance => "distance",
            Self::Touching => "touching",
        }
    }
}

/// The configurations, classified.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Rows {
    /// The rows as given, with the columns that are asked for.
    pub rows: Vec<Row>,
}

impl Content for Rows {
    const COMMAND: &'static str = "classify";
    type Outcome = Done;
}

/// A configuration, classified. Columns that are not asked for are left out.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Row {
    /// The columns that are given.
    #[serde(flatten)]
    pub given: BTreeMap<String, Cell>,
    /// Whether it is free, blocked or in contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub class: Option<Classification>,
    /// The number of the free region; null where it is not free.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Option<u32>>")]
    pub region: Option<Option<RegionId>>,
    /// How far the moving part moves to the nearest contact; null where it is blocked, or nothing can be touched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<Option<f64>>,
    /// Features of the fixed and of the moving part that touch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub touching: Option<Vec<[String; 2]>>,
}

impl Row {
    /// Adds a column at a configuration whose class is known.
    fn add(
        &mut self,
        column: Column,
        space: &PairSpace,
        (at, class): (Coordinates, Classification),
        touch: f64,
    ) -> Result<(), QueryError> {
        match column {
            Column::Class => self.class = Some(class),
            Column::Region => {
                self.region = Some(match class {
                    Classification::Free => region(space, at)?,
                    Classification::Contact | Classification::Blocked => None,
                });
            }
            Column::Distance => {
                self.distance = Some(match class {
                    Classification::Blocked => None,
                    // Within the resolution.
                    Classification::Contact if !matches!(space, PairSpace::Lower(_)) => Some(0.0),
                    _ => space.nearest_contact(at)?.map(|n| n.distance),
                });
            }
            Column::Touching => {
                let near = space.near_features(at, touch)?;
                let touching = near.iter().map(|near| texts(space, pair_of(near)));
                self.touching = Some(touching.collect());
            }
        }
        Ok(())
    }
}

/// The region of a free configuration.
fn region(space: &PairSpace, at: Coordinates) -> Result<Option<RegionId>, QueryError> {
    Ok(match space.region_count() {
        1 => Some(RegionId(0)),
        _ => space.locate(at)?.region(),
    })
}

impl Question {
    /// Refuses columns that do not belong together.
    ///
    /// # Errors
    /// If one is asked for twice, or a distance is given for one that is not.
    pub fn check(&self, host: &dyn Host) -> Result<(), Error> {
        let asked = &self.columns;
        let option = host.option("columns");
        if let Some(twice) = (1..asked.len()).find(|&i| asked[..i].contains(&asked[i])) {
            let name = asked[twice].name();
            return Err(
                Error::new(format_args!("{option}: {name} is asked for twice"))
                    .help("name every column once"),
            );
        }
        if self.touch.is_some() && !asked.contains(&Column::Touching) {
            return Err(Error::new(format_args!(
                "{} is about the column `touching`, which is not asked for",
                host.option("touch")
            ))
            .help(format_args!("add it, as in {option} class,touching")));
        }
        Ok(())
    }

    /// Classifies the configurations. Orientations are brought into the window by adding whole turns.
    ///
    /// # Errors
    /// If the pair cannot be computed, a configuration is outside of what was computed, or a column has no meaning for the pair.
    pub fn ask(self, pair: &Chosen<'_>) -> Result<Answer<Pairs<Rows>>, Error> {
        self.check(pair.host())?;
        let space = pair.space()?;
        let touch = self.touch.unwrap_or_else(|| space.resolution());
        let rows = rows(&space, &self.rows, &self.columns, touch);
        let source = self.source.as_deref();
        let rows = (rows.into_iter().zip(self.rows).enumerate())
            .map(|(i, (row, given))| match row {
                Ok(row) => Ok(Row {
                    given: given.columns,
                    ..row
                }),
                Err(QueryError::Permanent) => {
                    Err(pair.unanswered(&pair.option("columns"), &QueryError::Permanent))
                }
                Err(error) => {
                    let why = beyond_range(pair, given.at).unwrap_or(error.to_string());
                    let place = match (source, given.line) {
                        (Some(source), Some(line)) => format!("{source}, line {line}"),
                        _ => format!("row {}", i + 1),
                    };
                    Err(Error::new(format_args!("{place}: {why}"))
                        .help("leave the row out, or widen the `range` of the motion in the model"))
                }
            })
            .collect::<Result<_, Error>>()?;
        let answers = vec![pair.answer(Done::Done, Rows { rows })];
        Ok(Answer::of_pairs(pair.unit_label(), answers))
    }
}

/// The columns that are asked for, of all rows.
fn rows(
    space: &PairSpace,
    given: &[Given],
    columns: &[Column],
    touch: f64,
) -> Vec<Result<Row, QueryError>> {
    let classifier = match space {
        PairSpace::Planar(space) if given.len() >= MANY => Some(Classifier::new(&**space)),
        _ => None,
    };
    let window = match space {
        PairSpace::Planar(space) => Some(space.window()).filter(|w| !w.full_turn),
        _ => None,
    };
    let turned = |at: Coordinates| match (window, at) {
        (Some(w), Coordinates::Planar(c)) => {
            let turned = c.theta + TAU * ((w.lo - c.theta) / TAU).ceil();
            // Rounding may leave it just below.
            Coordinates::Planar(Configuration::new(c.x, c.y, turned.clamp(w.lo, w.hi)))
        }
        _ => at,
    };
    let one = |given: &Given| {
        let at = turned(given.at);
        let class = match (at, &classifier) {
            (Coordinates::Planar(c), Some(classifier)) => {
                classifier.classify(c).ok_or(QueryError::Outside)
            }
            _ => space.classify(at),
        }?;
        let mut row = Row::default();
        for &column in columns {
            row.add(column, space, (at, class), touch)?;
        }
        Ok(row)
    };
    parallel::map(given, 1, one)
}

/// Which coordinate is beyond the range of its motion, if one is.
fn beyond_range(pair: &Chosen<'_>, at: Coordinates) -> Option<String> {
    let (Some(axes), Coordinates::Axes { u, v }) = (pair.axes(), at) else {
        return None;
    };
    [
        ("u", u, axes.0, pair.fixed()),
        ("v", v, axes.1, pair.moving()),
    ]
    .into_iter()
    .find_map(|(name, t, axis, part)| {
        let (lo, hi) = axis.range?;
        let beyond = !(lo..=hi).contains(&t);
        beyond.then(|| {
            let part = part.name();
            let [t, lo, hi] = [t, lo, hi].map(shown::number);
            format!("{name} {t} is outside the range from {lo} to {hi} of the motion of {part}")
        })
    })
}
