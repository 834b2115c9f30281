//! Lower pairs: two parts that a joint keeps in permanent contact.

use core::f64::consts::TAU;

use crate::contact::{ContactFunction, Spiral};
use crate::feature::tolerance::GROWTH;
use crate::fixed_axes::{Axis, AxisMotion};
use crate::geometry::{Configuration, Point, Rotation, Vector, wrap};
use crate::part::Part;
use crate::query::{Classification, Location};

/// A permanent connection of two parts. Both are drawn in the assembly's frame as they are at zero motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case", tag = "type"))]
pub enum Joint {
    /// The parts turn about a common point.
    Revolute {
        /// The point.
        at: Point,
    },
    /// The parts slide along each other.
    Prismatic {
        /// The direction; its length does not matter.
        direction: Vector,
        /// A point of the line of sliding. Any point will do: it changes what is drawn, not how the parts move.
        at: Point,
    },
}

/// A permanent contact that follows from a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PermanentContact {
    /// Kind of contact: a point of the moving part on a line or an arc of the fixed part.
    pub kind: PermanentKind,
    /// Its contact function at a position (x, y) and orientation; zero on all configurations of the joint.
    pub function: ContactFunction,
    /// Always true: the contact exists in every configuration, and is no boundary of free space.
    pub permanent: bool,
}

/// Kind of a permanent contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum PermanentKind {
    /// A point of the moving part on a line of the fixed part.
    PointLine,
    /// A point of the moving part on an arc of the fixed part: a pin in its bearing, both of radius 0.
    PointArc,
}

/// The configuration space of two parts that a joint connects: a curve, known without computation (section 3.2 of
/// Sacks 1999).
///
/// | joint | permanent contacts | configurations |
/// |---|---|---|
/// | revolute at c | point/arc | (c − `R_t` c, t) |
/// | prismatic along d | two of point/line | (t d / \|d\|, 0) |
///
/// ```
/// use cspace::{Configuration, Location, Part, Point, Vertex};
/// use cspace::pair::{Joint, LowerPair};
/// let bar = |name: &str| {
///     let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let at = Point::new(0.5, 0.5);
/// let hinge = LowerPair::new(&bar("frame")?, &bar("arm")?, Joint::Revolute { at }, Some((-1.0, 1.0)));
/// assert_eq!(hinge.locate(hinge.configuration(0.3)), Location::Contact);
/// assert_eq!(hinge.locate(hinge.configuration(1.2)), Location::Blocked);
/// assert_eq!(hinge.locate(Configuration::new(1.0, 0.0, 0.0)), Location::Blocked);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct LowerPair {
    fixed: Part,
    moving: Part,
    joint: Joint,
    limits: Option<(f64, f64)>,
    contacts: Vec<PermanentContact>,
}

impl LowerPair {
    /// The pair of two parts and their joint, with limits of the motion (radians or the model's unit of length) if it has
    /// any.
    pub fn new(fixed: &Part, moving: &Part, joint: Joint, limits: Option<(f64, f64)>) -> Self {
        Self {
            fixed: fixed.clone(),
            moving: moving.clone(),
            joint,
            limits,
            contacts: table(joint),
        }
    }

    /// The limits of a joint's motion that follow from the motions of both parts relative to the ground: if both move along the joint or
    /// not at all, they are those of the moving part's motion minus the fixed part's. `None` if there are no limits, or if the motions are
    /// not the joint's.
    pub fn limits_from_axes(joint: &Joint, fixed: &Axis, moving: &Axis) -> Option<(f64, f64)> {
        let along = |axis: &Axis| match (&axis.motion, joint) {
            (AxisMotion::Fixed, _) => Some((0.0, 0.0)),
            (AxisMotion::Revolute { center }, Joint::Revolute { at }) => {
                let size = 1.0 + at.to_vector().length();
                let same = center.distance(*at) <= SAME_AXIS * size;
                axis.range.filter(|_| same)
            }
            (AxisMotion::Prismatic { direction: d }, Joint::Prismatic { direction: e, .. }) => {
                let (d, e) = (d.unit(), e.unit());
                let same = d.cross(e).abs() <= SAME_AXIS;
                let (lo, hi) = axis.range.filter(|_| same)?;
                Some(if d.dot(e) > 0.0 { (lo, hi) } else { (-hi, -lo) })
            }
            _ => None,
        };
        let ((a, b), (c, d)) = (along(fixed)?, along(moving)?);
        let limits = (c - b, d - a);
        (limits != (0.0, 0.0)).then_some(limits)
    }

    /// The fixed part.
    pub fn fixed(&self) -> &Part {
        &self.fixed
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        &self.moving
    }

    /// The joint.
    pub fn joint(&self) -> Joint {
        self.joint
    }

    /// Smallest and largest motion of the joint, radians or the model's unit of length; `None` if it has no limits.
    pub fn limits(&self) -> Option<(f64, f64)> {
        self.limits
    }

    /// The permanent contacts.
    pub fn contacts(&self) -> &[PermanentContact] {
        &self.contacts
    }

    /// The resolution in the model's unit of length: a configuration closer to the joint's than this is on it.
    pub fn resolution(&self) -> f64 {
        8.0 * GROWTH * self.size()
    }

    fn size(&self) -> f64 {
        let of_joint = match self.joint {
            Joint::Revolute { at } => at.to_vector().length(),
            _ => 0.0,
        };
        self.fixed.size().max(self.moving.size()).max(of_joint)
    }

    /// The configuration of the joint after a motion by `t`: an angle in radians for a revolute joint, a length for a
    /// prismatic one.
    pub fn configuration(&self, t: f64) -> Configuration {
        match self.joint {
            Joint::Revolute { at } => {
                let p = at.to_vector() - Rotation::by(t) * at.to_vector();
                Configuration::new(p.x, p.y, t)
            }
            Joint::Prismatic { direction, .. } => {
                let p = direction.unit() * t;
                Configuration::new(p.x, p.y, 0.0)
            }
        }
    }

    /// Classifies a configuration; `None` if it is not finite.
    pub fn classify(&self, c: Configuration) -> Option<Classification> {
        self.locate(c).class()
    }

    /// Location of a configuration: contact on the joint and within its limits, otherwise blocked; a lower pair has no free configurations.
    /// Outside if it is not finite.
    pub fn locate(&self, c: Configuration) -> Location {
        if !(c.position().is_finite() && c.theta.is_finite()) {
            return Location::Outside;
        }
        let resolution = self.resolution();
        let angular = resolution / self.size();
        let on_joint = self.motion_of(c).is_some_and(|t| {
            let nearest = self.configuration(t);
            // On a hinge, the place that belongs to the orientation itself.
            let there = match self.joint {
                Joint::Revolute { .. } => self.configuration(c.theta),
                _ => nearest,
            };
            let turned = wrap(c.theta - nearest.theta);
            // The orientation is checked first, because its error displaces the position, too.
            turned.abs() <= angular && there.position().distance(c.position()) <= resolution
        });
        match on_joint {
            true => Location::Contact,
            false => Location::Blocked,
        }
    }

    /// The motion of the joint nearest to a configuration, within its limits; `None` beyond them.
    fn motion_of(&self, c: Configuration) -> Option<f64> {
        let (t, period, slack) = match self.joint {
            Joint::Revolute { .. } => (c.theta, TAU, self.resolution() / self.size()),
            Joint::Prismatic { direction, .. } => {
                let t = direction.unit().dot(c.position().to_vector());
                (t, 0.0, self.resolution())
            }
        };
        let Some((lo, hi)) = self.limits else {
            return Some(t);
        };
        let t = if period > 0.0 {
            t + period * ((lo - slack - t) / period).ceil()
        } else {
            t
        };
        (lo - slack <= t && t <= hi + slack).then(|| t.clamp(lo, hi))
    }
}

/// Relative tolerance within which directions and centres are one axis.
const SAME_AXIS: f64 = 1e-9;

/// The table of permanent contacts.
fn table(joint: Joint) -> Vec<PermanentContact> {
    let permanent = |kind, function| PermanentContact {
        kind,
        function,
        permanent: true,
    };
    let point_arc = |at: Point| {
        let center = Spiral::new(at, -at.to_vector());
        permanent(
            PermanentKind::PointArc,
            ContactFunction::Circle {
                center,
                radius: 0.0,
            },
        )
    };
    // n·(p + R q − a), with q a point of the moving part and a one of the fixed line.
    let point_line = |normal: Vector, on_line: Point, point: Point| {
        let through = Spiral::new(on_line, -point.to_vector());
        permanent(
            PermanentKind::PointLine,
            ContactFunction::FixedLine { normal, through },
        )
    };
    match joint {
        Joint::Revolute { at } => vec![point_arc(at)],
        Joint::Prismatic { direction, at } => {
            let along = direction.unit();
            let normal = -along.left();
            vec![
                point_line(normal, at, at),
                point_line(normal, at, at + along),
            ]
        }
    }
}
