//! A pair in words: its configurations, regions and features.

use cspace::{AxisMotion, Configuration, Coordinates, FeatureName, Part, RegionId};
use cspace_api::{Chosen, place_on_part};
use cspace_design::FeaturePair;
use cspace_model::{Mechanism, shown};

use crate::wording::{degrees, length};

/// A pair in words.
pub(crate) trait InWords {
    /// A configuration in words.
    fn place(&self, at: Coordinates) -> String;

    /// Two features that touch, in words.
    fn touch(&self, features: FeaturePair) -> String;

    /// As [`touch`](Self::touch), with where on the parts the features are.
    fn touches(&self, features: FeaturePair) -> String;

    /// Two features that are near each other, in words.
    fn beside(&self, features: FeaturePair) -> String;

    /// The name of a free region: by the part's freedom and its number, or by its number alone on axes, where nothing is outside. The
    /// page calls regions the same.
    fn region(&self, region: RegionId) -> String;

    /// The description of a configuration in a free region.
    fn is_free(&self, region: RegionId) -> String;

    /// As above, with how far the parts are apart; not of parts at different heights.
    fn is_free_by(&self, region: RegionId, apart: Option<f64>) -> String;

    /// Whether a region is the one that goes on without limit, which only planar pairs have, and have first.
    fn is_outside(&self, region: RegionId) -> bool;

    /// A line that says by which gap the moving part is smaller.
    fn gap_in_words(&self, gap: f64) -> String;
}

impl InWords for Chosen<'_> {
    fn place(&self, at: Coordinates) -> String {
        let unit = self.unit();
        match at {
            Coordinates::Planar(c) => planar(c, &unit),
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

    fn touch(&self, (fixed, moving): FeaturePair) -> String {
        let (a, b) = (self.fixed(), self.moving());
        format!(
            "{} of {} touches {} of {}",
            a.feature_text(fixed),
            a.name(),
            b.feature_text(moving),
            b.name()
        )
    }

    fn touches(&self, (fixed, moving): FeaturePair) -> String {
        let (a, b) = (self.fixed(), self.moving());
        format!("{} touches {}", placed(a, fixed), placed(b, moving))
    }

    fn beside(&self, (fixed, moving): FeaturePair) -> String {
        let (a, b) = (self.fixed(), self.moving());
        format!("{} and {}", placed(a, fixed), placed(b, moving))
    }

    fn region(&self, region: RegionId) -> String {
        match region {
            _ if self.is_outside(region) => "outside".to_owned(),
            RegionId(i) if self.is_on_axes() => format!("region {i}"),
            RegionId(i) => format!("pocket {i}"),
        }
    }

    fn is_free(&self, region: RegionId) -> String {
        match self.is_outside(region) {
            true => "free, outside".to_owned(),
            false => format!("free, in {}", self.region(region)),
        }
    }

    fn is_free_by(&self, region: RegionId, apart: Option<f64>) -> String {
        match apart.filter(|apart| apart.is_finite()) {
            Some(apart) => {
                let (is, apart) = (self.is_free(region), length(apart));
                format!("{is}, {apart}{} apart", self.unit())
            }
            None => "free: the parts are at different heights, and never touch".to_owned(),
        }
    }

    fn is_outside(&self, region: RegionId) -> bool {
        region == RegionId(0) && !self.is_on_axes()
    }

    fn gap_in_words(&self, gap: f64) -> String {
        format!(
            "gap {:.1e}{}: the parts fit exactly, and {} is smaller by it all around",
            gap,
            self.unit(),
            shown::text(self.moving().name())
        )
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

/// A configuration of a planar pair.
fn planar(c: Configuration, unit: &str) -> String {
    let (x, y, theta) = (length(c.x), length(c.y), degrees(c.theta));
    format!("x {x}, y {y}{unit}, theta {theta}")
}

/// A configuration of a pair: on axes the motions of the parts that move, `arm 12.0000 deg`.
pub(crate) fn motions(model: &Mechanism, names: [&str; 2], at: Coordinates, unit: &str) -> String {
    let (u, v) = match at {
        Coordinates::Planar(c) => return planar(c, unit),
        Coordinates::Axes { u, v } => (u, v),
    };
    let of = |(name, t): (&str, f64)| {
        let part = model.parts.iter().find(|p| p.part.name() == name)?;
        let shown = match part.axis?.motion {
            AxisMotion::Fixed => return None,
            AxisMotion::Revolute { .. } => degrees(t),
            AxisMotion::Prismatic { .. } => format!("{}{unit}", length(t)),
        };
        Some(format!("{} {shown}", shown::text(name)))
    };
    let all: Vec<String> = (names.into_iter().zip([u, v])).filter_map(of).collect();
    all.join(", ")
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
