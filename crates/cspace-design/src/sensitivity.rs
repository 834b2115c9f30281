//! Derivatives of quantities by the parameters of a model.
//!
//! A quantity ends where the contact function f of two features is 0 (or, of a clearance, is its value). With a parameter p, a coordinate e
//! at which f(e, p) = 0 moves by de/dp = −(∂f/∂p) / (∂f/∂e). ∂f/∂p is that by the vertices and axes of the drawing
//! ([`FeatureContact::by_drawing`]) times what the model makes of p ([`Template::slopes`]), both in dual numbers.

use cspace::{
    Axis, Ball, Configuration, Coordinates, Edge, FeatureContact, FeatureKind, FeatureName,
    PairSpace, Part, Point, Progress, QueryError,
};
use cspace_model::model::{
    Coordinate, OverRanges, PartSlopes, Quantity, Requirement, RequirementSlopes, Slopes, Subject,
    Template,
};
use cspace_model::{Compute, Host, Model};

use crate::check::{Checked, Interrupted, Spaces};
use crate::drawing::{Drawing, enclosed};
use crate::range::{numbers, unit};
use crate::touching::FeaturePair;
use crate::value::{Measured, Stop, Value};

/// The derivative of a quantity by a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The parameter.
    pub parameter: String,
    /// The derivatives for smaller and for larger values of the parameter, which differ where several contacts decide; or why there is
    /// none.
    pub derivative: Result<[f64; 2], String>,
}

/// As [`check`](crate::check), with the derivatives of every quantity by each parameter that the file gives as a number.
///
/// Quantities that are yes or no have none.
///
/// # Errors
/// If the progress ends the computation.
pub fn sensitivities(
    template: &Template,
    host: &Host<'_>,
    model: &Model,
    progress: &dyn Progress,
) -> Result<Vec<(Checked, Vec<Sensitivity>)>, Interrupted> {
    let spaces = Spaces::compute(model, progress)?;
    Ok(sensitivities_on(&spaces, template, host, model))
}

/// As [`sensitivities`], with the spaces from elsewhere.
///
/// # Errors
/// If the progress ends the computation.
pub fn sensitivities_by(
    template: &Template,
    host: &Host<'_>,
    model: &Model,
    compute: &Compute<'_>,
    progress: &dyn Progress,
) -> Result<Vec<(Checked, Vec<Sensitivity>)>, Interrupted> {
    let spaces = Spaces::compute_by(model, compute, progress)?;
    Ok(sensitivities_on(&spaces, template, host, model))
}

/// As [`sensitivities`], on spaces of the model that are known.
pub(crate) fn sensitivities_on(
    spaces: &Spaces,
    template: &Template,
    host: &Host<'_>,
    model: &Model,
) -> Vec<(Checked, Vec<Sensitivity>)> {
    // Derivatives by one that follows from others say nothing that those do not.
    let independent = model.parameters.iter().filter(|p| p.expression.is_none());
    let slopes: Vec<(&str, Result<Slopes, String>)> = (independent)
        .map(|p| {
            let slopes = template.slopes(host, model, &p.name);
            (p.name.as_str(), slopes.map_err(|e| e.message().to_owned()))
        })
        .collect();
    let all = model.requirements.iter().map(|requirement| {
        let checked = spaces.check(requirement);
        let Ok(measured) = checked.measured.clone() else {
            return (checked, Vec::new());
        };
        if measured.stops.is_empty() || matches!(measured.value, Value::Truth(_)) {
            return (checked, Vec::new());
        }
        let of = |(name, slopes): &(&str, Result<Slopes, String>)| Sensitivity {
            parameter: (*name).to_owned(),
            derivative: match requirement.subject {
                Subject::Pair(_, Quantity::Angle { .. }) => {
                    of_angle(template, host, model, requirement, name)
                }
                _ => (slopes.as_ref().map_err(String::clone))
                    .and_then(|slopes| derivative(spaces, requirement, &measured, slopes)),
            },
        };
        let found = slopes.iter().map(of).collect();
        (checked, found)
    });
    all.collect()
}

/// The derivatives of a requirement's quantity, measured on a space, for smaller and for larger values of a parameter; or why there are
/// none.
pub(crate) fn derivative(
    spaces: &Spaces,
    requirement: &Requirement,
    measured: &Measured,
    slopes: &Slopes,
) -> Result<Sides, String> {
    let (Some(space), Subject::Pair(pair, quantity)) =
        (spaces.of(requirement), requirement.subject)
    else {
        return Err("no contact function decides a quantity of a motion".to_owned());
    };
    let of = slopes.requirements.get(&requirement.name);
    let varied = Varied {
        space,
        parts: [pair.fixed, pair.moving].map(|i| &slopes.parts[i]),
        of: of.copied().unwrap_or_default(),
    };
    match varied.derivative(quantity, measured) {
        Ok(Some(sides)) => Ok(sides),
        Ok(None) if measured.stops.iter().all(|s| s.features.is_empty()) => {
            Err("nothing touches, so that no contact function decides the value".to_owned())
        }
        Ok(None) => Err(SEVERAL.to_owned()),
        Err(error) => Err(error.to_string()),
    }
}

/// The derivatives of an angle at the contact that a motion meets first, by a parameter.
fn of_angle(
    template: &Template,
    host: &Host<'_>,
    model: &Model,
    requirement: &Requirement,
    parameter: &str,
) -> Result<Sides, String> {
    let none = || "no first contact decides the angle".to_owned();
    let plain = Drawing::<Ball>::new(model, requirement, None).ok_or_else(none)?;
    let found = plain.encounters(&[1.0], None);
    let hits = plain.hits(&found).ok_or_else(none)?;
    if plain.tie(&found, &hits) {
        return Err(SEVERAL.to_owned());
    }
    let given = template.enclosures(host, model, parameter, &[]);
    let given = [given.map_err(|e| e.message().to_owned())?];
    let slopes = enclosed(&given[0], &given, &[0.0]);
    let drawing = slopes.first();
    let drawing = drawing.and_then(|slopes| Drawing::new(model, requirement, Some(slopes)));
    let slope = drawing.ok_or_else(none)?.derivative(&hits);
    if slope.is_finite() {
        Ok([slope; 2])
    } else {
        Err(none())
    }
}

/// Why there is no derivative where more than one contact decides.
const SEVERAL: &str = "several contacts take over from each other there, as where two corners meet";

/// A pair with the derivatives of its parts, and of one requirement, by a parameter.
struct Varied<'a> {
    space: &'a PairSpace,
    parts: [&'a PartSlopes; 2],
    of: RequirementSlopes,
}

/// Derivatives for smaller and for larger values of the parameter.
type Sides = [f64; 2];

impl Varied<'_> {
    fn derivative(
        &self,
        quantity: Quantity,
        measured: &Measured,
    ) -> Result<Option<Sides>, QueryError> {
        match (quantity, &measured.stops[..]) {
            (Quantity::Play { of, .. }, [below, above]) => {
                // The other coordinates are held where they are measured.
                let (mut held, _) = self.moved();
                held[of.index()] = 0.0;
                let mut ends = [None; 2];
                for ((end, stop), way) in ends.iter_mut().zip([below, above]).zip([-1.0, 1.0]) {
                    let range = match of {
                        Coordinate::U => self.parts[0].range,
                        _ => self.parts[1].range,
                    };
                    *end = if stop.features.is_empty() {
                        Some([range.unwrap_or_default()[usize::from(way > 0.0)]; 2])
                    } else {
                        let rates = numbers(unit(of, way));
                        self.first(stop, rates, way, |f, gradient| {
                            sum(&[-f, -dot(gradient, held)]) / gradient[of.index()]
                        })?
                    };
                }
                let [lower, upper] = ends;
                Ok(lower
                    .zip(upper)
                    .map(|(a, b)| [0, 1].map(|i| sum(&[b[i], -a[i]]))))
            }
            (Quantity::Position { from, along, of }, [stop]) => {
                let (from, along, at) = (numbers(from), numbers(along), numbers(stop.at));
                let k = of.index();
                let gone = [0, 1, 2].map(|i| at[i] - from[i]);
                let time = dot(gone, along) / dot(along, along);
                let (of_at, of_along) = self.moved();
                let moved = [0, 1, 2].map(|i| of_at[i] + time * of_along[i]);
                self.first(stop, along, along[k], |f, gradient| {
                    let later = sum(&[-f, -dot(gradient, moved)]) / dot(gradient, along);
                    sum(&[moved[k], later * along[k]])
                })
            }
            (Quantity::Clearance { .. }, [stop]) => {
                self.first(stop, [0.0; 3], 1.0, |f, gradient| {
                    sum(&[f, dot(gradient, self.moved().0)])
                })
            }
            (
                Quantity::Ranges {
                    what: OverRanges::Clearance,
                    ..
                },
                [stop],
            ) => {
                // Parts that touch somewhere do so with other values, too.
                if measured.value == Value::Number(0.0) {
                    return Ok(Some([0.0; 2]));
                }
                // Where the gap is smallest it is as small beside that: what moves the place does not change it, but at an end of a range.
                let moved = self.moved_end(stop.at);
                self.first(stop, [0.0; 3], 1.0, |f, gradient| {
                    sum(&[f, dot(gradient, moved)])
                })
            }
            _ => Ok(None),
        }
    }

    /// The derivatives of a place that is an extreme over ranges: it stays at the end of a range.
    fn moved_end(&self, at: Coordinates) -> [f64; 3] {
        /// Radians, or shares of the parts' size, within which a place is at the end.
        const AT_END: f64 = 1e-9;
        let mut moved = [0.0; 3];
        if let PairSpace::FixedAxes(axes) = self.space {
            let (fixed, moving) = axes.axes();
            let near = AT_END * self.space.fixed().size().max(1.0);
            for (k, axis) in [fixed, moving].iter().enumerate() {
                let is_at = |end: f64| (numbers(at)[k] - end).abs() <= near;
                let [of_lo, of_hi] = self.parts[k].range.unwrap_or_default();
                moved[k] = match axis.range {
                    Some((lo, _)) if is_at(lo) => of_lo,
                    Some((_, hi)) if is_at(hi) => of_hi,
                    _ => 0.0,
                };
            }
        }
        moved
    }

    /// The derivatives of the configuration at which the quantity is measured, and of the displacement of its motion.
    fn moved(&self) -> ([f64; 3], [f64; 3]) {
        let RequirementSlopes { at, along } = self.of;
        (
            at.map(Option::unwrap_or_default),
            along.map(Option::unwrap_or_default),
        )
    }

    /// The derivatives of what is the first of several contacts to be reached, where `sign` is that of its change along the way: by each
    /// contact they are given by ∂f/∂p and the gradient by the coordinates. With a motion, contacts count that it comes nearer to.
    fn first(
        &self,
        stop: &Stop,
        rates: [f64; 3],
        sign: f64,
        by: impl Fn(f64, [f64; 3]) -> f64,
    ) -> Result<Option<Sides>, QueryError> {
        /// Derivatives that differ by less, relative to the larger, are one: contacts that follow each other smoothly.
        const ONE: f64 = 1e-9;
        /// Smaller derivatives are rounding.
        const NOTHING: f64 = 1e-14;
        let is_motion = rates != [0.0; 3];
        let mut found: Vec<f64> = Vec::new();
        for &(fixed, moving) in &stop.features {
            if fixed.kind == FeatureKind::Line && moving.kind == FeatureKind::Line {
                continue;
            }
            let contact = self.space.contact_of(fixed, moving)?;
            if self.is_between_corners(&contact, (fixed, moving), stop.at)? {
                return Ok(None);
            }
            let value = contact.evaluate(stop.at)?;
            if is_motion && dot(value.gradient, rates) >= 0.0 {
                continue;
            }
            let derivative = by(self.by_parameter(&contact, stop.at)?, value.gradient);
            if derivative.is_finite() {
                found.push(derivative);
            }
        }
        let Some(&first) = found.first() else {
            return Ok(None);
        };
        let (lo, hi) = found
            .iter()
            .fold((first, first), |(lo, hi), x| (lo.min(*x), hi.max(*x)));
        let largest = lo.abs().max(hi.abs());
        Ok(Some(if largest <= NOTHING {
            [0.0; 2]
        } else if hi - lo <= ONE * largest {
            [first; 2]
        } else if sign > 0.0 {
            // The smallest of several: for a larger parameter that which grows least.
            [hi, lo]
        } else {
            [lo, hi]
        }))
    }

    /// Whether two features touch at a corner of each part. Beside such a place each corner slides along a side of the other, and which it
    /// is depends on the direction of the change.
    fn is_between_corners(
        &self,
        contact: &FeatureContact,
        (fixed, moving): FeaturePair,
        at: Coordinates,
    ) -> Result<bool, QueryError> {
        /// How near to a corner a place is one with it, relative to the size of the parts; and the sine of the angle of a corner.
        const NEAR: f64 = 1e-9;
        let place = contact.touching(at)?;
        let fixed_from_moving = match (self.space, at) {
            (PairSpace::FixedAxes(axes), Coordinates::Axes { u, v }) => {
                let (a, b): (Axis, Axis) = axes.axes();
                a.configuration(u).inverse().compose(b.configuration(v))
            }
            (_, Coordinates::Planar(c)) => c,
            _ => return Ok(false),
        };
        let near = NEAR * (self.space.fixed().size() + self.space.moving().size());
        let is_corner = |part: &Part, feature: FeatureName, from_part: Configuration, at: Point| {
            let Some(outline) = part.loops().get(feature.loop_index as usize) else {
                return false;
            };
            let corners = outline.vertices();
            let n = corners.len();
            let here = feature.index as usize;
            let ends = match feature.kind {
                FeatureKind::Vertex => [here; 2],
                _ => [here, (here + 1) % n],
            };
            let turns = |k: usize| {
                let edge = |index: usize| {
                    let (v, w) = (corners[index], corners[(index + 1) % n]);
                    Edge {
                        start: v.point(),
                        end: w.point(),
                        bulge: v.bulge,
                        index,
                    }
                };
                let (before, after) = (edge((k + n - 1) % n), edge(k));
                let (a, b) = (before.end_direction(), after.start_direction());
                a.cross(b).abs() > NEAR || a.dot(b) < 0.0
            };
            ends.into_iter().any(|k| {
                let corner = from_part.fixed_from_moving(corners[k].point());
                corner.distance(at) <= near && turns(k)
            })
        };
        let origin = Configuration::default();
        Ok(is_corner(self.space.fixed(), fixed, origin, place.on_fixed)
            && is_corner(
                self.space.moving(),
                moving,
                fixed_from_moving,
                place.on_moving,
            ))
    }

    /// ∂f/∂p of a contact at a configuration.
    fn by_parameter(&self, contact: &FeatureContact, at: Coordinates) -> Result<f64, QueryError> {
        let by = contact.by_drawing(at)?;
        let mut terms = Vec::new();
        for ((vertices, axis), part) in [(&by.fixed, by.fixed_axis), (&by.moving, by.moving_axis)]
            .into_iter()
            .zip(self.parts)
        {
            for v in vertices {
                let outline = part.loops.get(v.loop_index as usize);
                let [x, y, bulge] = (outline.and_then(|l| l.get(v.vertex as usize)))
                    .copied()
                    .unwrap_or_default();
                terms.extend([
                    v.by_position[0] * x,
                    v.by_position[1] * y,
                    v.by_bulge * bulge,
                ]);
            }
            let by_axis = part.axis.unwrap_or_default();
            terms.extend([axis[0] * by_axis[0], axis[1] * by_axis[1]]);
        }
        Ok(sum(&terms))
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The sum of terms, 0 where all but rounding cancels.
fn sum(terms: &[f64]) -> f64 {
    /// Rounding of derivatives, relative to the terms they are sums of.
    const ROUNDING: f64 = 1e-12;
    let sum: f64 = terms.iter().sum();
    let size: f64 = terms.iter().map(|x| x.abs()).sum();
    if sum.abs() <= ROUNDING * size {
        0.0
    } else {
        sum
    }
}
