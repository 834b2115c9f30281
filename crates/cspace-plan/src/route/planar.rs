//! A contact space with the connected components of its surface.

use core::f64::consts::TAU;

use cspace::{ContactSpace, CurveGeometry, FeatureName, PatchId, Point, Rotation};

use crate::legs::{Coords, Scene};

use super::station::{Station, share_of};

/// A contact space with the connected components of its surface.
#[derive(Debug)]
pub(crate) struct Planar<'a> {
    space: &'a ContactSpace,
    pub(super) scene: Scene,
    /// Component of each patch.
    pub(super) component: Vec<u32>,
}

impl<'a> Planar<'a> {
    pub(crate) fn new(space: &'a ContactSpace, scene: Scene) -> Self {
        let mut root: Vec<u32> = (0..space.patches().len() as u32).collect();
        fn find(root: &mut [u32], mut i: u32) -> u32 {
            while root[i as usize] != i {
                root[i as usize] = root[root[i as usize] as usize];
                i = root[i as usize];
            }
            i
        }
        let side = space.side_links().iter().map(|l| (l.before.0, l.after.0));
        let vertical = space
            .vertical_links()
            .iter()
            .map(|l| (l.lower.0, l.upper.0));
        for (a, b) in side.chain(vertical) {
            let (a, b) = (find(&mut root, a), find(&mut root, b));
            root[a.max(b) as usize] = a.min(b);
        }
        let component = (0..root.len() as u32).map(|i| find(&mut root, i)).collect();
        Self {
            space,
            scene,
            component,
        }
    }

    pub(super) fn space(&self) -> &'a ContactSpace {
        self.space
    }

    /// The features of a patch, of the fixed and of the moving part.
    pub(super) fn features(&self, patch: PatchId) -> Option<(FeatureName, FeatureName)> {
        let p = self.space.patches().get(patch.index())?;
        Some((p.fixed, p.moving))
    }

    /// Where a configuration is on a patch, and by how much its orientation is more than the patch counts it.
    pub(super) fn on(&self, patch: PatchId, at: Coords) -> (Station, f64) {
        let theta = self.brought(patch, at[2]);
        let share = self
            .curve(patch, theta)
            .map_or(0.5, |c| share_of(&c, self.position(at)));
        (Station { theta, share }, at[2] - theta)
    }

    /// The position of a configuration, which is where contact curves are.
    fn position(&self, at: Coords) -> Point {
        Point::new(at[0], at[1]) - Rotation::by(at[2]) * self.scene.about()
    }

    /// The numbers of a configuration with a position on a contact curve.
    pub(super) fn numbers(&self, position: Point, theta: f64) -> Coords {
        let at = position + Rotation::by(theta) * self.scene.about();
        [at.x, at.y, theta]
    }

    /// The contact curve of a patch at an orientation in its numbering.
    pub(super) fn curve(&self, patch: PatchId, theta: f64) -> Option<CurveGeometry> {
        self.space().curve_at(patch, theta)
    }

    /// An orientation in the numbering of a patch, brought within it if rounding has put it outside.
    pub(super) fn brought(&self, patch: PatchId, theta: f64) -> f64 {
        let p = &self.space.patches()[patch.index()];
        let turned = theta - TAU * ((theta - p.lo) / TAU).floor();
        if turned <= p.hi {
            turned
        } else if turned - p.hi < p.lo + TAU - turned {
            p.hi
        } else {
            p.lo
        }
    }
}
