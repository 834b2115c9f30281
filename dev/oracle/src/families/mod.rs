//! Families of pairs with a parameter that runs into the degenerate.
//!
//! Named pairs ([`pairs`](crate::pairs())) are one drawing each. A family is a drawing with a number in it, and a list of
//! values at which to try it: a clearance of 1e-1, 1e-2, … 1e-15 and 0, say. A mistake at a tie shows at some of them. The
//! number may also be drawn at random between those values.

mod clearance;
mod concentric;
mod joints;
mod many;
mod meeting;
mod orientation;
mod outline;
mod parallel;
mod place;
mod radii;
mod symmetric;

use cspace::{Configuration, Part, PartError};
use rand::Rng;

pub use outline::{Loops, loops_of};

/// Two parts to try the library on, and over which orientations.
#[derive(Debug, Clone)]
pub struct Case {
    /// The fixed part.
    pub fixed: Part,
    /// The moving part.
    pub moving: Part,
    /// The orientations to compute, radians; `None` is the full turn.
    pub window: Option<(f64, f64)>,
    /// Configurations worth a look.
    pub notable: Vec<Configuration>,
}

impl Case {
    /// Case of two outlines over the full turn.
    ///
    /// # Errors
    /// If one of them is no part.
    pub fn new(fixed: Loops, moving: Loops) -> Result<Self, PartError> {
        Ok(Self {
            fixed: Part::new("fixed", fixed)?,
            moving: Part::new("moving", moving)?,
            window: None,
            notable: Vec::new(),
        })
    }

    /// Copy with additional configurations worth a look.
    #[must_use]
    pub fn about(mut self, notable: &[(f64, f64, f64)]) -> Self {
        let all = notable.iter();
        self.notable
            .extend(all.map(|&(x, y, theta)| Configuration::new(x, y, theta)));
        self
    }

    /// Copy over a window of orientations.
    #[must_use]
    pub fn within(mut self, lo: f64, hi: f64) -> Self {
        self.window = Some((lo, hi));
        self
    }
}

/// A drawing of two parts with a number in it.
#[derive(Debug, Clone)]
pub struct Family {
    /// Description of the drawing and of the number.
    pub name: &'static str,
    /// The numbers to try, running into the degenerate.
    pub values: Vec<f64>,
    /// Whether the number is a count: then only the listed values are used.
    pub counts: bool,
    build: fn(f64) -> Result<Case, PartError>,
}

impl Family {
    /// The pair at a value of the number.
    ///
    /// # Errors
    /// If [`Part::new`] refuses an outline that has run too far into the degenerate.
    pub fn build(&self, value: f64) -> Result<Case, PartError> {
        (self.build)(value)
    }

    /// A number at random: one of the values, or any between the least and the largest of one sign, evenly over their
    /// powers of ten.
    pub fn draw(&self, rng: &mut impl Rng) -> f64 {
        let value = self.values[rng.random_range(0..self.values.len())];
        if self.counts || value == 0.0 || rng.random_bool(0.3) {
            return value;
        }
        let same = |v: &&f64| v.signum() == value.signum() && **v != 0.0;
        let powers = || self.values.iter().filter(same).map(|v| v.abs().log10());
        let (lo, hi) = (
            powers().fold(f64::INFINITY, f64::min),
            powers().fold(f64::NEG_INFINITY, f64::max),
        );
        value.signum() * 10f64.powf(lo + (hi - lo) * rng.random_range(0.0..1.0))
    }
}

/// Families of pairs that approach degenerate cases.
///
/// ```
/// for family in cspace_oracle::families() {
///     match family.build(family.values[0]) {
///         Ok(case) => assert!(case.fixed.edges().count() > 1),
///         Err(refused) => println!("{}: {refused}", family.name),
///     }
/// }
/// ```
pub fn families() -> Vec<Family> {
    let mut all = Vec::new();
    clearance::add(&mut all);
    joints::add(&mut all);
    radii::add(&mut all);
    concentric::add(&mut all);
    parallel::add(&mut all);
    symmetric::add(&mut all);
    many::add(&mut all);
    place::add(&mut all);
    meeting::add(&mut all);
    orientation::add(&mut all);
    all
}

fn family(
    name: &'static str,
    values: impl IntoIterator<Item = f64>,
    build: fn(f64) -> Result<Case, PartError>,
) -> Family {
    Family {
        name,
        values: values.into_iter().collect(),
        counts: false,
        build,
    }
}

fn counting(
    name: &'static str,
    values: &[u32],
    build: fn(f64) -> Result<Case, PartError>,
) -> Family {
    Family {
        counts: true,
        ..family(name, values.iter().copied().map(f64::from), build)
    }
}

/// 10^first, …, 10^last, where first may be the larger.
fn powers(first: i32, last: i32) -> Vec<f64> {
    let step = (last - first).signum();
    (0..=(last - first).abs())
        .map(|k| 10f64.powi(first + step * k))
        .collect()
}

/// 1e-1, …, 1e-15 and 0.
fn vanishing() -> Vec<f64> {
    let mut all = powers(-1, -15);
    all.push(0.0);
    all
}
