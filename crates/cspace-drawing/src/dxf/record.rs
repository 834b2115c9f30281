//! The groups of one entity, by code.

use cspace::Point;

use super::error::Result;
use super::groups::Group;
use super::item::What;
use crate::affine::Affine;
use crate::drawing::Path;

/// The groups of an entity.
pub(super) struct Record<'g, 'a> {
    pub(super) groups: &'g [Group<'a>],
}

impl<'g, 'a> Record<'g, 'a> {
    pub(super) fn new(groups: &'g [Group<'a>]) -> Self {
        Self { groups }
    }

    fn find(&self, code: i32) -> Option<&'g Group<'a>> {
        self.groups.iter().find(|g| g.code == code)
    }

    pub(super) fn text(&self, code: i32) -> &'a [u8] {
        self.find(code).map_or(b"", Group::text)
    }

    pub(super) fn real(&self, code: i32) -> Result<Option<f64>> {
        self.find(code).map(Group::real).transpose()
    }

    pub(super) fn integer(&self, code: i32) -> Result<Option<i64>> {
        self.find(code).map(Group::integer).transpose()
    }

    /// The point of groups `code` and `code` + 10; the third coordinate apart.
    pub(super) fn point(&self, code: i32) -> Result<(Point, f64)> {
        let [x, y, z] = [0, 10, 20].map(|c| self.real(code + c));
        Ok((
            Point::new(x?.unwrap_or(0.0), y?.unwrap_or(0.0)),
            z?.unwrap_or(0.0),
        ))
    }

    /// Whether the entity's plane is seen from behind; `None` if it is not parallel to the drawing's.
    pub(super) fn is_from_behind(&self) -> Result<Option<bool>> {
        if self.find(210).is_none() && self.find(230).is_none() {
            return Ok(Some(false));
        }
        /// Rounding of a unit vector in a file.
        const ROUND: f64 = 1e-9;
        let (side, z) = self.point(210)?;
        let is_upright = side.to_vector().length() <= ROUND * z.abs();
        Ok((is_upright && z != 0.0).then_some(z < 0.0))
    }
}

/// Problem: the entity's plane is not the plane of the drawing.
pub(super) fn tilted(at: Point) -> What {
    What::problem(
        Some(at),
        "it is not in the plane of the drawing: its extrusion direction is tilted",
        "flatten the drawing to two dimensions before it is exported",
    )
}

/// Problem: the entity is not flat.
pub(super) fn not_flat(at: Point) -> What {
    What::problem(
        Some(at),
        "it is not flat: its z coordinates differ",
        "flatten the drawing to two dimensions before it is exported",
    )
}

/// Whether heights differ by more than rounding.
pub(super) fn heights_differ(heights: impl IntoIterator<Item = f64>) -> bool {
    /// Rounding of coordinates in files, as a share of the height.
    const ROUND: f64 = 1e-6;
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for z in heights {
        range = [range[0].min(z), range[1].max(z)];
    }
    range[1] - range[0] > ROUND * range[1].abs().max(range[0].abs()).max(1e-3)
}

/// The path in the coordinates around the entity's plane, whose first axis points left if it is seen from behind.
pub(super) fn faced(path: Path, from_behind: bool) -> What {
    What::Path(if from_behind {
        path.mapped(&Affine::MIRROR_X)
    } else {
        path
    })
}
