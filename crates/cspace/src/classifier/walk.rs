//! Classification of a position by following a ray from cell to cell.

use crate::geometry::{Point, Rotation};
use crate::query::classify::END_ERROR;
use crate::space::ContactSpace;

use super::grid::Grid;
use super::ray::{AxisDirection, Local, Meeting, may_meet};

/// Content of a cell over the orientations of its interval.
#[derive(Debug, Clone, Copy)]
pub(super) enum Content<'a> {
    /// No contact: all of the cell is free, or all is blocked.
    Pure { free: bool },
    /// Patches that may reach the cell.
    Mixed(&'a [u32]),
}

/// Whether a position is free at an orientation of an interval: follows a ray along an axis to the first contact, or to a pure cell.
///
/// The list of a cell has all patches that reach it, so the nearest contact met within the cell is the first. `None` if something is too
/// close to the ray to be sure.
pub(super) fn is_free<'a>(
    space: &ContactSpace,
    grid: &Grid,
    (p, theta, turn): (Point, f64, Rotation),
    direction: AxisDirection,
    content: impl Fn(usize, usize) -> Content<'a>,
) -> Option<bool> {
    let start = (grid.index(p.x)?, grid.index(p.y)?);
    from_cell(space, grid, start, (p, theta, turn), direction, content)
}

/// Whether a position is free, given the cell in which, or on whose edge, it is.
pub(super) fn from_cell<'a>(
    space: &ContactSpace,
    grid: &Grid,
    (mut column, mut row): (usize, usize),
    (p, theta, turn): (Point, f64, Rotation),
    direction: AxisDirection,
    content: impl Fn(usize, usize) -> Content<'a>,
) -> Option<bool> {
    let surface = space.surface();
    loop {
        let patches = match content(column, row) {
            Content::Pure { free } => return Some(free),
            Content::Mixed(patches) => patches,
        };
        let wall = match direction {
            AxisDirection::Right => grid.line(column + 1) - p.x,
            AxisDirection::Up => grid.line(row + 1) - p.y,
            AxisDirection::Left => p.x - grid.line(column),
            AxisDirection::Down => p.y - grid.line(row),
        };
        let mut first: Option<(f64, bool)> = None;
        // Distance of the nearest contact met from the other side than the first contact.
        let mut other = f64::INFINITY;
        for &i in patches {
            let patch = &space.patches()[i as usize];
            if surface.alive(patch, theta).is_none() || !may_meet(patch, turn, p, direction, wall) {
                continue;
            }
            match Local::new(patch, turn, p).meet(direction) {
                Meeting::Nothing => {}
                Meeting::Unclear => return None,
                Meeting::Curve {
                    distance,
                    from_free,
                } => match first {
                    Some((d, f)) if distance >= d => {
                        if from_free != f {
                            other = other.min(distance);
                        }
                    }
                    _ => {
                        if let Some((d, f)) = first
                            && f != from_free
                        {
                            other = d;
                        }
                        first = Some((distance, from_free));
                    }
                },
            }
        }
        if let Some((distance, from_free)) = first
            && distance <= wall
        {
            return (other - distance >= END_ERROR).then_some(from_free);
        }
        let at_edge = match direction {
            AxisDirection::Right => column + 1 == grid.side,
            AxisDirection::Up => row + 1 == grid.side,
            AxisDirection::Left => column == 0,
            AxisDirection::Down => row == 0,
        };
        if at_edge {
            // All is free beyond the square.
            return Some(true);
        }
        match direction {
            AxisDirection::Right => column += 1,
            AxisDirection::Up => row += 1,
            AxisDirection::Left => column -= 1,
            AxisDirection::Down => row -= 1,
        }
    }
}
