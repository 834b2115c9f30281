//! Ranges of values of what is varied.

use schemars::JsonSchema;
use serde::Deserialize;

/// A parameter or a coordinate, with values evenly over a range.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Vary {
    /// The name of the parameter, or x, y, theta, u or v.
    pub name: String,
    /// The first value, in the model's unit or radians.
    pub lo: f64,
    /// The last value.
    pub hi: f64,
    /// The number of values.
    pub count: usize,
    /// Whether the values are angles, which text and pictures have in degrees.
    #[serde(default)]
    pub is_angle: bool,
}

impl Vary {
    /// The value number `i`.
    ///
    /// ```
    /// use cspace_api::Vary;
    /// let play = Vary { name: "play".to_owned(), lo: 1.0, hi: 2.0, count: 3, is_angle: false };
    /// assert_eq!([0, 1, 2].map(|i| play.value(i)), [1.0, 1.5, 2.0]);
    /// ```
    pub fn value(&self, i: usize) -> f64 {
        match self.count {
            1 => self.lo,
            n if i + 1 == n => self.hi,
            n => self.lo + (self.hi - self.lo) * (i as f64 / (n as f64 - 1.0)),
        }
    }
}
