//! The mass matrix of the outlines at unit density, and what dampers add.

use cspace::{AreaMoments, AxisMotion, Rotation};

use super::layout::PartCoordinates;
use crate::linear::Cholesky;

/// The mass matrix of the outlines with the resistance of dampers.
#[derive(Debug, Clone)]
pub(crate) struct Metric {
    /// Matrix of all coordinates, n × n by rows.
    pub(crate) matrix: Vec<f64>,
    /// Cholesky factor of the free coordinates' matrix.
    pub(crate) factor: Cholesky,
}

/// Adds the mass matrix of a part to that of the system, n × n by rows: half of v'ᵀ M v' is the kinetic energy of the outline
/// with one unit of mass on each unit of area.
pub(crate) fn add_outline(
    matrix: &mut [f64],
    n: usize,
    part: &PartCoordinates,
    moments: &AreaMoments,
    q: &[f64],
) {
    match *part {
        PartCoordinates::Fixed => {}
        PartCoordinates::Axis { first, motion, .. } => {
            matrix[first * n + first] += match motion {
                AxisMotion::Revolute { center } => moments.second_about(center),
                _ => moments.area,
            };
        }
        PartCoordinates::Planar { first, center } => {
            let turned = Rotation::by(q[first + 2]) * (moments.centroid - center);
            let (x, y, t) = (first, first + 1, first + 2);
            let area = moments.area;
            let mut add = |i: usize, j: usize, m: f64| {
                matrix[i * n + j] += m;
                if i != j {
                    matrix[j * n + i] += m;
                }
            };
            add(x, x, area);
            add(y, y, area);
            add(x, t, -area * turned.y);
            add(y, t, area * turned.x);
            add(t, t, moments.second + area * turned.length_squared());
        }
    }
}
