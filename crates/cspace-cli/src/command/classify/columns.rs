//! The columns that are added to a row.

use cspace::{Classification, Coordinates, PairSpace, QueryError};
use serde_json::{Value, json};

use crate::args::Column;
use cspace_design::{pair_of, texts};

impl Column {
    /// As it is asked for, and as it heads its column.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Class => "class",
            Self::Region => "region",
            Self::Distance => "distance",
            Self::Touching => "touching",
        }
    }

    /// The column's value at a configuration whose class is known.
    ///
    /// # Errors
    /// If it has no meaning for the pair.
    pub(super) fn of(
        self,
        space: &PairSpace,
        at: Coordinates,
        class: Classification,
        touch: f64,
    ) -> Result<Answer, QueryError> {
        Ok(match self {
            Self::Class => Answer::Class(class),
            Self::Region => Answer::Region(match class {
                Classification::Free => region(space, at),
                Classification::Contact | Classification::Blocked => None,
            }),
            Self::Distance => Answer::Distance(match class {
                Classification::Blocked => None,
                // Within the resolution.
                Classification::Contact if !matches!(space, PairSpace::Lower(_)) => Some(0.0),
                _ => space.nearest_contact(at)?.map(|n| n.distance),
            }),
            Self::Touching => Answer::Touching(
                (space.near_features(at, touch)?.iter())
                    .map(|near| texts(space, pair_of(near)))
                    .collect(),
            ),
        })
    }
}

/// The region of a free configuration.
fn region(space: &PairSpace, at: Coordinates) -> Option<u32> {
    match (space, at) {
        (_, _) if space.region_count() == 1 => Some(0),
        (PairSpace::Planar(space), Coordinates::Planar(c)) => space.region_at(c),
        (PairSpace::FixedAxes(space), Coordinates::Axes { u, v }) => space.region_at(u, v),
        _ => None,
    }
}

/// The value of a column in a row.
#[derive(Debug, Clone)]
pub(super) enum Answer {
    Class(Classification),
    Region(Option<u32>),
    Distance(Option<f64>),
    /// Features of the fixed and of the moving part.
    Touching(Vec<[String; 2]>),
}

impl Answer {
    /// As in a table; empty where there is none.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Class(Classification::Free) => "free".to_owned(),
            Self::Class(Classification::Blocked) => "blocked".to_owned(),
            Self::Class(Classification::Contact) => "contact".to_owned(),
            Self::Region(region) => region.map_or(String::new(), |r| r.to_string()),
            Self::Distance(distance) => distance.map_or(String::new(), |d| d.to_string()),
            Self::Touching(pairs) => {
                let pairs: Vec<String> = pairs.iter().map(|p| p.join("|")).collect();
                pairs.join(";")
            }
        }
    }

    /// As in JSON; null where there is none.
    pub(super) fn json(&self) -> Value {
        match self {
            Self::Class(class) => json!(class),
            Self::Region(region) => json!(region),
            Self::Distance(distance) => json!(distance),
            Self::Touching(pairs) => json!(pairs),
        }
    }
}
