//! Configurations and displacements as they are given on the command line, and in words.

use cspace::pair::PairContact;
use cspace::{
    Configuration, Coordinates, FeatureName, NearFeatures, PairClass, PairSpace, PatchId,
    QueryError,
};
use cspace_io::shown;

use super::Chosen;
use crate::angle;
use crate::failure::Failure;
use crate::wording::{degrees, length};

/// Features of the fixed and of the moving part that touch each other.
pub(crate) type FeaturePair = (FeatureName, FeatureName);

/// How much earlier than a contact is looked for what else touches, as a share of the motion: beyond a jam nothing does.
const BEFORE: f64 = 1e-9;

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
            return Err(Failure::input(format_args!(
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
                Failure::input(format_args!("{option}, {name}: {why}")).help(
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

    /// That a question has no answer.
    pub(crate) fn unanswered(&self, option: &str, error: &QueryError) -> Failure {
        let failure = Failure::input(format_args!("{option}: pair {}: {error}", self.names()));
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

/// The features of a patch.
fn features(space: &PairSpace, patch: PatchId) -> Result<FeaturePair, QueryError> {
    let (fixed, moving) = space.patch(patch)?.features()?;
    Ok((fixed.name, moving.name))
}

/// The features that are near each other, by name.
pub(crate) fn pair_of(near: &NearFeatures) -> FeaturePair {
    (near.fixed.name, near.moving.name)
}

/// What a pair of features is called.
pub(crate) fn texts(space: &PairSpace, (fixed, moving): FeaturePair) -> [String; 2] {
    [
        space.fixed().feature_text(fixed),
        space.moving().feature_text(moving),
    ]
}

/// How far a point of the moving part that may touch is from its origin, at most.
fn arm(space: &PairSpace) -> f64 {
    let drawn = space.moving().bounds();
    let corners = [drawn.min, drawn.max].map(|p| p.to_vector().length());
    corners[0].max(corners[1]) + space.fixed().size() + space.moving().size()
}

/// What touches where a motion from a configuration at constant rates has met a contact: the features of its patch first, then
/// those that a moment before are nearer than they come in it.
pub(crate) fn touching(
    space: &PairSpace,
    (from, rates): (Coordinates, Coordinates),
    contact: &PairContact,
) -> Result<Vec<FeaturePair>, QueryError> {
    let (before, within) = just_before(space, from, rates, contact.time);
    let mut all = vec![features(space, contact.patch)?];
    for near in space.near_features(before, within)? {
        let pair = pair_of(&near);
        if !all.contains(&pair) {
            all.push(pair);
        }
    }
    Ok(all)
}

/// The configuration a moment before a time of a motion, and how far features may be apart there that touch then: a point of the
/// moving part comes no farther in that moment, or in as little an orientation.
fn just_before(
    space: &PairSpace,
    from: Coordinates,
    rates: Coordinates,
    time: f64,
) -> (Coordinates, f64) {
    let t = (time - BEFORE).max(0.0);
    match (from, rates) {
        (Coordinates::Planar(c), Coordinates::Planar(d)) => {
            let at = Configuration::new(c.x + t * d.x, c.y + t * d.y, c.theta + t * d.theta);
            let arm = arm(space);
            let speed = d.x.hypot(d.y) + arm * d.theta.abs();
            let within = speed * (time - t) + arm * BEFORE + 4.0 * space.resolution();
            (Coordinates::Planar(at), within)
        }
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: du, v: dv }) => {
            let at = Coordinates::Axes {
                u: u + t * du,
                v: v + t * dv,
            };
            // A radian moves what is in reach of contact by no more than both parts together are large.
            let size = space.fixed().size() + space.moving().size();
            let moved = (du.abs() + dv.abs()) * size.max(1.0) * (time - t);
            (at, moved + 4.0 * space.resolution())
        }
        _ => (from, 0.0),
    }
}
