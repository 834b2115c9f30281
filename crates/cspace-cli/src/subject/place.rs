//! Configurations and displacements as they are given on the command line, and in words.

use cspace::{Configuration, Coordinates, FeatureName, PairClass, Part, QueryError, RegionId};
use cspace_answers::place_on_part;
use cspace_design::FeaturePair;
use cspace_model::{Mechanism, shown};

use super::Chosen;
use crate::angle;
use crate::failure::Failure;
use crate::wording::{degrees, length};

impl Chosen<'_> {
    /// Whether a configuration of the pair is (u, v).
    pub(crate) fn is_on_axes(&self) -> bool {
        !self.is_planar() && self.class() == PairClass::FixedAxes
    }

    /// The configuration, or displacement, in text such as `10,0,18deg`, or `u,v` for a pair on fixed axes.
    pub(crate) fn coordinates(&self, option: &str, text: &str) -> Result<Coordinates, Failure> {
        let given: Vec<&str> = text.split(',').collect();
        let names: &[(&str, bool)] = if self.is_on_axes() {
            let (u, v) = self.turns();
            &[("u", u), ("v", v)]
        } else {
            &[("x", false), ("y", false), ("theta", true)]
        };
        let wanted: Vec<&str> = names.iter().map(|n| n.0).collect();
        if given.len() != names.len() {
            let class = self.class();
            let by_general = class == PairClass::FixedAxes && !self.is_on_axes();
            let method = if by_general {
                " by the general method"
            } else {
                ""
            };
            return Err(Failure::new(format_args!(
                "{option} {}: a {class} pair{method} takes {} numbers",
                shown::cut(text),
                names.len()
            ))
            .help(format_args!("give {option} {}", wanted.join(","))));
        }
        let mut numbers = [0.0; 3];
        for ((to, text), (name, is_angle)) in numbers.iter_mut().zip(&given).zip(names) {
            let number = if *is_angle {
                angle::parse(text)
            } else {
                (text.trim().parse::<f64>().ok().filter(|x| x.is_finite()))
                    .ok_or_else(|| format!("{} is no number", shown::quoted(text)))
            };
            *to = number.map_err(|why| {
                Failure::new(format_args!("{option}, {name}: {why}")).help(
                    "give a finite number; angles are in radians, or have a unit such as 18deg",
                )
            })?;
        }
        let [a, b, c] = numbers;
        Ok(if self.is_on_axes() {
            Coordinates::Axes { u: a, v: b }
        } else {
            Coordinates::Planar(Configuration::new(a, b, c))
        })
    }

    /// A configuration in words.
    pub(crate) fn place(&self, at: Coordinates) -> String {
        let unit = self.unit();
        match at {
            Coordinates::Planar(c) => format!(
                "x {}, y {}{unit}, theta {}",
                length(c.x),
                length(c.y),
                degrees(c.theta)
            ),
            Coordinates::Axes { u, v } => {
                let (u_turns, v_turns) = self.turns();
                let one = |t: f64, turns: bool| {
                    if turns {
                        degrees(t)
                    } else {
                        format!("{}{unit}", length(t))
                    }
                };
                format!("u {}, v {}", one(u, u_turns), one(v, v_turns))
            }
        }
    }

    /// Two features that touch, in words.
    pub(crate) fn touch(&self, (fixed, moving): FeaturePair) -> String {
        let (a, b) = (self.fixed(), self.moving());
        format!(
            "{} of {} touches {} of {}",
            a.feature_text(fixed),
            a.name(),
            b.feature_text(moving),
            b.name()
        )
    }

    /// As [`touch`](Self::touch), with where on the parts the features are.
    pub(crate) fn touches(&self, (fixed, moving): FeaturePair) -> String {
        let (a, b) = (self.fixed(), self.moving());
        format!("{} touches {}", placed(a, fixed), placed(b, moving))
    }

    /// Two features that are near each other, in words.
    pub(crate) fn beside(&self, (fixed, moving): FeaturePair) -> String {
        let (a, b) = (self.fixed(), self.moving());
        format!("{} and {}", placed(a, fixed), placed(b, moving))
    }

    /// The name of a free region: by the part's freedom and its number, or by its number alone on axes, where nothing is outside. The
    /// page calls regions the same.
    pub(crate) fn region(&self, region: RegionId) -> String {
        match region {
            _ if self.is_outside(region) => "outside".to_owned(),
            RegionId(i) if self.is_on_axes() => format!("region {i}"),
            RegionId(i) => format!("pocket {i}"),
        }
    }

    /// The description of a configuration in a free region.
    pub(crate) fn is_free(&self, region: RegionId) -> String {
        match self.is_outside(region) {
            true => "free, outside".to_owned(),
            false => format!("free, in {}", self.region(region)),
        }
    }

    /// Whether a region is the one that goes on without limit, which only planar pairs have, and have first.
    fn is_outside(&self, region: RegionId) -> bool {
        region == RegionId(0) && !self.is_on_axes()
    }

    /// The failure for a query that has no answer at the configuration given by `option`.
    pub(crate) fn unanswered(&self, option: &str, error: &QueryError) -> Failure {
        let failure = Failure::new(format_args!("{option}: pair {}: {error}", self.names()));
        match error {
            QueryError::Outside => {
                failure.help("choose a configuration within the window and the ranges of motion")
            }
            QueryError::Permanent => {
                failure.help("ask about a pair without a joint, or with --general")
            }
            _ => failure,
        }
    }
}

/// A feature of a part, with where on the part it is.
pub(crate) fn placed(part: &Part, feature: FeatureName) -> String {
    let name = format!("{} of {}", part.feature_text(feature), part.name());
    match place_on_part(part, feature) {
        Some(place) => format!("{name} ({place})"),
        None => name,
    }
}

/// A feature of a part, both by name, as [`placed`].
pub(crate) fn placed_by_name(model: &Mechanism, part: &str, feature: &str) -> String {
    let found = model.parts.iter().map(|entry| &entry.part);
    let found = { found }.find(|p| p.name() == part);
    let text = match found.and_then(|part| Some((part, part.feature_called(feature)?))) {
        Some((part, feature)) => placed(part, feature),
        None => format!("{feature} of {part}"),
    };
    shown::text(&text).into_owned()
}
