//! Three parts with one coordinate each, and their pairs; and what of that holds for any number of parts.

use cspace::fixed_axes::Role;
use cspace::{Axis, AxisMotion, FixedAxesSpace, Options, PairError, PairSpace};
use cspace_model::{Mechanism, MechanismError, PairEntry};

use crate::modes::error::ModesError;

/// The coordinates of each pair among the three: u and v, v and w, u and w.
pub const PAIRS: [[usize; 2]; 3] = [[0, 1], [1, 2], [0, 2]];

/// Two of the parts.
#[derive(Debug)]
pub struct TrioPair {
    /// Coordinates of the pair, among those of all: its u and its v.
    pub coordinates: [usize; 2],
    /// Configuration space of the two parts; `None` if the model has no such pair, which then constrains nothing.
    pub space: Option<FixedAxesSpace>,
}

/// Three parts on axes.
#[derive(Debug)]
pub(crate) struct Trio {
    pub(crate) parts: [usize; 3],
    pub(crate) names: [String; 3],
    pub(crate) axes: [Axis; 3],
    /// The pairs in the order of [`PAIRS`].
    pub(crate) pairs: [TrioPair; 3],
}

/// Parts of a model that turn or slide on an axis, if there are three or more.
///
/// # Errors
/// If there are fewer.
///
/// ```
/// use cspace::Part;
/// use cspace_model::{Mechanism, PartEntry};
/// let mut lock = Mechanism::new("lock");
/// for (name, x) in [("bolt", 0.0), ("plunger", 4.0), ("slide", 8.0)] {
///     let part = Part::rectangle(name, (x, 0.0), 2.0, 2.0)?;
///     lock.parts.push(PartEntry::prismatic(part, (0.0, 1.0)));
/// }
/// lock.parts.push(PartEntry::fixed(Part::rectangle("case", (20.0, 0.0), 2.0, 2.0)?));
/// assert_eq!(cspace_plan::modes::moving_parts(&lock), Ok(vec![0, 1, 2]));
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn moving_parts(mechanism: &Mechanism) -> Result<Vec<usize>, ModesError> {
    let moves = |axis: &Axis| axis.motion != AxisMotion::Fixed;
    let all: Vec<usize> = (0..mechanism.parts.len())
        .filter(|&i| mechanism.parts[i].axis.as_ref().is_some_and(moves))
        .collect();
    match all.len() {
        0..=2 => Err(ModesError::NotThree {
            parts: all.into_iter().map(|i| name(mechanism, i)).collect(),
        }),
        _ => Ok(all),
    }
}

pub(crate) fn name(mechanism: &Mechanism, part: usize) -> String {
    mechanism.parts[part].part.name().to_owned()
}

impl Trio {
    pub(crate) fn of(mechanism: &Mechanism, parts: [usize; 3]) -> Result<Self, ModesError> {
        let axes = [0, 1, 2].map(|k| axis(mechanism, parts[k]));
        let [a, b, c] = axes;
        let axes = [a?, b?, c?];
        let names = parts.map(|i| name(mechanism, i));
        for [a, b] in PAIRS {
            if parts[a] == parts[b] {
                let part = names[a].clone();
                return Err(ModesError::Twice { part });
            }
        }
        check_joints(mechanism, &parts, &names)?;
        let entries = PAIRS.map(|pair| entry(mechanism, &parts, pair));
        for (coordinates, _) in entries.iter().flatten() {
            check_slides(coordinates.map(|k| (&names[k], &axes[k])))?;
        }
        let [ab, bc, ac] = [0, 1, 2].map(|k| TrioPair::of(mechanism, PAIRS[k], entries[k]));
        Ok(Self {
            parts,
            names,
            axes,
            pairs: [ab?, bc?, ac?],
        })
    }

    /// The axes with limits for slides that have none.
    pub(crate) fn limited_axes(&self) -> [Axis; 3] {
        [0, 1, 2].map(|k| limited(k, &self.axes, &self.pairs))
    }

    /// Whether a coordinate is unbounded.
    pub(crate) fn is_open(&self, k: usize) -> bool {
        is_open(&self.axes[k])
    }

    /// Whether a coordinate repeats after a turn.
    pub(crate) fn is_circle(&self, k: usize) -> bool {
        is_circle(&self.axes[k])
    }
}

/// The axis of a coordinate with limits if it is a slide that has none: beyond them nothing touches.
pub(crate) fn limited(k: usize, axes: &[Axis], pairs: &[TrioPair]) -> Axis {
    let axis = axes[k];
    if !is_open(&axis) {
        return axis;
    }
    // Something to be between where the part meets no other.
    let (mut lo, mut hi) = (-1.0_f64, 1.0_f64);
    for pair in pairs {
        let at = pair.coordinates.iter().position(|&c| c == k);
        if let (Some(at), Some(space)) = (at, &pair.space) {
            let extent = space.extent()[at];
            (lo, hi) = (lo.min(extent.0), hi.max(extent.1));
        }
    }
    axis.within(lo, hi)
}

/// Whether the coordinate of an axis is unbounded.
pub(crate) fn is_open(axis: &Axis) -> bool {
    matches!(axis.motion, AxisMotion::Prismatic { .. }) && axis.range.is_none()
}

/// Whether the coordinate of an axis repeats after a turn.
pub(crate) fn is_circle(axis: &Axis) -> bool {
    matches!(axis.motion, AxisMotion::Revolute { .. }) && axis.range.is_none()
}

impl TrioPair {
    pub(crate) fn of(
        mechanism: &Mechanism,
        pair: [usize; 2],
        entry: Option<([usize; 2], PairEntry)>,
    ) -> Result<Self, ModesError> {
        let Some((coordinates, entry)) = entry else {
            let space = None;
            return Ok(Self {
                coordinates: pair,
                space,
            });
        };
        match mechanism.compute(&entry, &Options::default())? {
            PairSpace::FixedAxes(space) => Ok(Self {
                coordinates,
                space: Some(*space),
            }),
            _ => Err(ModesError::Planar {
                part: name(mechanism, entry.moving),
            }),
        }
    }

    /// Whether the pair constrains its coordinates.
    pub(crate) fn is_bound(&self) -> bool {
        (self.space.as_ref()).is_some_and(|s| !s.patches().is_empty() || s.regions().is_empty())
    }

    /// Role of a coordinate in the pair, if it is one of the pair's.
    pub(crate) fn role(&self, coordinate: usize) -> Option<Role> {
        match self.coordinates {
            [u, _] if u == coordinate => Some(Role::Fixed),
            [_, v] if v == coordinate => Some(Role::Moving),
            _ => None,
        }
    }
}

pub(crate) fn axis(mechanism: &Mechanism, part: usize) -> Result<Axis, ModesError> {
    let Some(entry) = mechanism.parts.get(part) else {
        return Err(ModesError::NoSuchPart {
            part,
            parts: mechanism.parts.len(),
        });
    };
    match entry.axis {
        None => Err(ModesError::Planar {
            part: name(mechanism, part),
        }),
        Some(axis) if axis.motion == AxisMotion::Fixed => Err(ModesError::Still {
            part: name(mechanism, part),
        }),
        Some(axis) => Ok(axis),
    }
}

/// The pair of two of the parts, if the model has it, with which coordinates are its u and v.
pub(crate) fn entry(
    mechanism: &Mechanism,
    parts: &[usize],
    [a, b]: [usize; 2],
) -> Option<([usize; 2], PairEntry)> {
    mechanism.pairs.iter().find_map(|pair| {
        let is = |x: usize, y: usize| (pair.fixed, pair.moving) == (parts[x], parts[y]);
        let entry = PairEntry {
            window: None,
            ..*pair
        };
        if is(a, b) {
            Some(([a, b], entry))
        } else {
            is(b, a).then_some(([b, a], entry))
        }
    })
}

/// Checks that no joint, or chain of joints, connects two of the parts.
pub(crate) fn check_joints(
    mechanism: &Mechanism,
    parts: &[usize],
    names: &[String],
) -> Result<(), ModesError> {
    for a in 0..parts.len() {
        let mut reached = vec![parts[a]];
        let mut next = 0;
        while let Some(&part) = reached.get(next) {
            next += 1;
            for joint in &mechanism.joints {
                let other = match joint.parts {
                    (p, q) if p == part => q,
                    (p, q) if q == part => p,
                    _ => continue,
                };
                // A part that does not move connects nothing.
                let still = |i: usize| {
                    let axis = mechanism.parts.get(i).and_then(|p| p.axis);
                    axis.is_some_and(|a| a.motion == AxisMotion::Fixed)
                };
                if !reached.contains(&other) && !still(other) {
                    reached.push(other);
                }
            }
        }
        if let Some(b) = (a + 1..parts.len()).find(|&b| reached.contains(&parts[b])) {
            let direct = |p: (usize, usize)| p == (parts[a], parts[b]) || p == (parts[b], parts[a]);
            return Err(ModesError::Joined {
                first: names[a].clone(),
                second: names[b].clone(),
                direct: mechanism.joints.iter().any(|j| direct(j.parts)),
            });
        }
    }
    Ok(())
}

/// Checks that two parts do not slide side by side without limits.
pub(crate) fn check_slides(pair: [(&String, &Axis); 2]) -> Result<(), ModesError> {
    /// The sine of the angle between directions of sliding below which they are one: a pair's space takes them so.
    const PARALLEL: f64 = 1e-9;
    let [(first, a), (second, b)] = pair;
    let direction = |axis: &Axis| match (axis.motion, axis.range) {
        (AxisMotion::Prismatic { direction }, None) => Some(direction.unit()),
        _ => None,
    };
    match (direction(a), direction(b)) {
        (Some(d), Some(e)) if d.cross(e).abs() < PARALLEL => Err(ModesError::Unlimited {
            first: first.clone(),
            second: second.clone(),
        }),
        _ => Ok(()),
    }
}

/// An error of a pair of two of the parts.
pub(crate) fn failed(names: [&str; 2], error: cspace::AxesError) -> ModesError {
    ModesError::Pair(MechanismError::Pair {
        fixed: names[0].to_owned(),
        moving: names[1].to_owned(),
        error: PairError::Axes(error),
    })
}
