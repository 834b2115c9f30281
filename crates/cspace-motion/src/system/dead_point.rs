//! Parts in line at a dead point.

use cspace::pair::Joint;
use cspace::{AxisMotion, Point, Vector};
use cspace_model::shown::text;
use nalgebra::{DMatrix, SVD};

use super::System;
use super::layout::PartCoordinates;

/// A force is none below this share of the largest, and two directions are one within this angle: dead points are located to some 1e-7.
const SMALL: f64 = 1e-3;

impl System {
    /// Sentence about a dead point, or a change point: the parts that are in line, where driven parts are, and how it goes on.
    pub(crate) fn dead_point(&self, q: &[f64], dead: bool) -> String {
        let name = |i: usize| text(self.mechanism().parts[i].part.name()).to_string();
        let driven = |(i, part): (usize, &PartCoordinates)| {
            let (k, _) = self
                .drives()
                .iter()
                .find(|d| part.indices().contains(&d.0))?;
            // Rounded first, so that nothing is shown as less than 0.
            let rounded = |x: f64, decimals: f64| (x * decimals).round() / decimals + 0.0;
            Some(match part.orientation() == Some(*k) {
                true => format!(
                    "{} is at {:.4} deg",
                    name(i),
                    rounded(q[*k].to_degrees(), 1e4)
                ),
                false => format!("{} is at {:.6}", name(i), rounded(q[*k], 1e6)),
            })
        };
        let drives: Vec<String> = self.parts().iter().enumerate().filter_map(driven).collect();
        let pairs = self.in_line(q).into_iter();
        let lines: Vec<String> = pairs
            .map(|(a, b)| format!("{} and {} are in line", name(a), name(b)))
            .collect();
        let kind = match dead {
            true => "a dead point",
            false => "a change point",
        };
        let what = match lines.is_empty() {
            true => format!("the joints are at {kind}"),
            false => format!("{}, {kind}", lines.join(", ")),
        };
        let place = match drives.is_empty() {
            true => what,
            false => format!("{what}, where {}", drives.join(" and ")),
        };
        match dead {
            true => format!("{place}: what is driven can go no farther; its range ends here"),
            false => {
                format!("{place}: from there parts can go on in more than one way; begin beside it")
            }
        }
    }

    /// Pairs of parts that a dead point has in line.
    ///
    /// At a dead point the joints withstand the drives by forces that do nothing to the free coordinates: Σ λ ∇f = 0 on these. A part on
    /// which they act at two places alone, joints or its axis, is pulled along the line through both. Two such parts at one joint
    /// are in line.
    fn in_line(&self, q: &[f64]) -> Vec<(usize, usize)> {
        let Some(forces) = self.withstanding(q) else {
            return Vec::new();
        };
        let largest = forces.iter().map(|f| f.1.length()).fold(0.0, f64::max);
        let acting = |k: &usize| forces[*k].1.length() > SMALL * largest;
        let at = |part: usize| -> Vec<Point> {
            let joints = (0..forces.len()).filter(acting);
            let own = joints.filter(|&k| <[usize; 2]>::from(self.joint(k).parts).contains(&part));
            let axis = match self.parts()[part] {
                PartCoordinates::Axis {
                    motion: AxisMotion::Revolute { center },
                    ..
                } => Some(center),
                _ => None,
            };
            own.map(|k| forces[k].0).chain(axis).collect()
        };
        let line = |part: usize| match at(part)[..] {
            [p, q] if p != q => Some((q - p).unit()),
            _ => None,
        };
        let is_pair = |k: &usize| {
            let (a, b) = self.joint(*k).parts;
            let lines = line(a).zip(line(b));
            lines.is_some_and(|(a, b)| a.cross(b).abs() < SMALL)
        };
        let pairs = (0..forces.len()).filter(acting).filter(is_pair);
        pairs.map(|k| self.joint(k).parts).collect()
    }

    /// Place of each joint and its force, of the forces that do nothing to the free coordinates. `None` if joints other than revolute ones
    /// are among them, or there are more equations than coordinates.
    fn withstanding(&self, q: &[f64]) -> Option<Vec<(Point, Vector)>> {
        let (rows, free) = (self.joints(q), self.free());
        if rows.is_empty() || rows.len() > free.len() {
            return None;
        }
        let mut matrix = DMatrix::zeros(rows.len(), free.len());
        for (i, row) in rows.iter().enumerate() {
            for &(coordinate, derivative) in row.entries() {
                if let Ok(k) = free.binary_search(&coordinate) {
                    matrix[(i, k)] = derivative / self.lengths()[coordinate];
                }
            }
        }
        let found = SVD::try_new(matrix, true, false, f64::EPSILON, 0)?;
        let (least, _) = found.singular_values.argmin();
        let force = found.u?.column(least).into_owned();
        let one = |k: usize| {
            let entry = self.joint(k);
            let Joint::Revolute { at } = entry.joint else {
                return None;
            };
            let placement = self.parts()[entry.parts.0].placement(|i| q[i]);
            let [x, y] = placement.point([at.x, at.y]);
            // A revolute joint has two equations, along x and along y.
            Some((
                Point::new(x, y),
                Vector::new(force[2 * k], force[2 * k + 1]),
            ))
        };
        (0..self.joint_count()).map(one).collect()
    }
}
