//! How much farther parts that have left go on, to where nothing that comes later meets them.
//!
//! A way ends where a line lies between what leaves and what stays. What leaves later may pass that place, and what has left as a group
//! needs room to be taken apart itself. So the last that leaves goes on until it is beside what is left, the one before it until it is
//! beside both, and so on; always away from that line, where nothing of what stays is met.

use cspace::{Axis, Configuration, Coordinates, Part, Point, Vector};

use crate::legs::{configuration_about, numbers_about};
use crate::out::exits;
use crate::route::along;

use super::answer::{Kind, Step, Tree};
use super::error::AssemblyError;
use super::units::{placed, together};

/// Each leg is looked at in so many places.
const PLACES: u32 = 16;
/// Parts that have left are apart from what comes later by this share of the extent of that: enough to see, and more than is lost between
/// the places of a leg that turns.
const BESIDE: f64 = 0.05;

/// Parts with the places where they are in the frame of those that stay, and their axes.
pub(super) struct Played<'a> {
    parts: &'a [Part],
    axes: Vec<Option<Axis>>,
    at: Vec<Configuration>,
}

impl<'a> Played<'a> {
    pub(super) fn new(parts: &'a [Part], axes: Vec<Option<Axis>>) -> Self {
        let at = vec![Configuration::IDENTITY; parts.len()];
        Self { parts, axes, at }
    }

    /// Tells of all steps in a tree how much farther the parts go; and the corners of boxes within which all stays that happens there, in
    /// the frame of what is taken apart.
    pub(super) fn tell(
        &mut self,
        tree: &Tree,
        steps: &mut [Step],
    ) -> Result<Vec<Point>, AssemblyError> {
        let (mut all, mut left) = (Vec::new(), Vec::new());
        for branch in &tree.out {
            for step in branch.room.iter().filter_map(|&i| steps.get(i)) {
                all.extend(self.go(step));
            }
            if let Some(step) = steps.get(branch.step) {
                let away = self.away(step)?;
                left.push((self.go(step), away));
            }
        }
        all.extend(self.corners(&tree.parts, |at| at));
        for (branch, (way, away)) in tree.out.iter().zip(left).rev() {
            let within = self.tell(&branch.tree, steps)?;
            let Some(step) = steps.get_mut(branch.step) else {
                continue;
            };
            let to = match step.path.configurations.last() {
                Some(Coordinates::Planar(to)) => *to,
                _ => Configuration::IDENTITY,
            };
            let there: Vec<Point> = within.iter().map(|&p| to.fixed_from_moving(p)).collect();
            let ((first, last), (lo, hi)) = (range(&there, away), range(&all, away));
            let beside = hi + BESIDE * (hi - lo).max(last - first);
            // Added to 0, no number is minus 0.
            step.onward = Vector::ZERO + away * (beside - first).max(0.0);
            all.extend(way);
            all.extend(there.iter().map(|&p| p + step.onward));
            all.extend(there);
        }
        Ok(all)
    }

    /// Where corners of the moving parts come in a step. What moves aside is there from then on.
    fn go(&mut self, step: &Step) -> Vec<Point> {
        let mut corners = Vec::new();
        let about = step.path.about;
        let axis = step.moving.first().and_then(|&i| self.axes[i]);
        for leg in step.path.configurations.windows(2) {
            for k in 0..=PLACES {
                let c = between(leg[0], leg[1], about, f64::from(k) / f64::from(PLACES));
                corners.extend(self.corners(&step.moving, |at| step.placed(c, axis, at)));
            }
        }
        if let (Kind::Moves, Some(&last)) = (step.kind, step.path.configurations.last()) {
            for &i in &step.moving {
                self.at[i] = step.placed(last, axis, self.at[i]);
            }
        }
        corners
    }

    /// Away from the line that lies between what has left and what stays.
    fn away(&self, step: &Step) -> Result<Vector, AssemblyError> {
        let part = |these: &[usize]| -> Result<Part, AssemblyError> {
            let mut there = self.parts.to_vec();
            for &i in these {
                there[i] = placed(&self.parts[i], self.at[i])?;
            }
            together(&there, these)
        };
        let Some(&Coordinates::Planar(to)) = step.path.configurations.last() else {
            return Ok(Vector::ZERO);
        };
        let exits = exits(&part(&step.staying)?, &part(&step.moving)?, to);
        Ok(exits.first().map_or(Vector::ZERO, |e| e.direction))
    }

    /// The corners of the boxes of some parts.
    fn corners(
        &self,
        parts: &[usize],
        place: impl Fn(Configuration) -> Configuration,
    ) -> Vec<Point> {
        (parts.iter())
            .flat_map(|&i| {
                let at = place(self.at[i]);
                (self.parts[i].bounds().corners()).map(|p| at.fixed_from_moving(p))
            })
            .collect()
    }
}

/// The coordinates at a share of a leg along which a point of the moving parts goes straight.
fn between(from: Coordinates, to: Coordinates, about: Vector, share: f64) -> Coordinates {
    match (from, to) {
        (Coordinates::Planar(a), Coordinates::Planar(b)) => {
            let [a, b] = [a, b].map(|c| numbers_about(c, about));
            Coordinates::Planar(configuration_about(along(a, b, share), about))
        }
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: p, v: q }) => {
            let [u, v, _] = along([u, v, 0.0], [p, q, 0.0], share);
            Coordinates::Axes { u, v }
        }
        _ => to,
    }
}

/// From where to where points lie in a direction.
fn range(points: &[Point], direction: Vector) -> (f64, f64) {
    (points.iter())
        .map(|p| p.to_vector().dot(direction))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
            (lo.min(x), hi.max(x))
        })
}
