//! Ranges of values of what is varied.

use core::str::FromStr;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::given::value;

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

impl FromStr for Vary {
    type Err = String;

    /// Reads text such as `play=0.05:0.3:26` or `u=0deg:360deg:361`.
    fn from_str(text: &str) -> Result<Self, String> {
        const HELP: &str = "give it as NAME=LO:HI:N, such as play=0.05:0.3:26 or u=0deg:360deg:361";
        let (name, range) = text.split_once('=').ok_or(HELP)?;
        let [lo, hi, count] = range.split(':').collect::<Vec<_>>()[..] else {
            return Err(HELP.to_owned());
        };
        let bound = |text: &str| value(text).ok_or(HELP);
        let count = (count.trim().parse::<usize>().ok()).filter(|n| (1..=1_000_000).contains(n));
        Ok(Self {
            name: name.trim().to_owned(),
            lo: bound(lo)?,
            hi: bound(hi)?,
            is_angle: [lo, hi]
                .iter()
                .any(|text| text.trim().parse::<f64>().is_err()),
            count: count.ok_or("N is a whole number from 1 to 1000000")?,
        })
    }
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
