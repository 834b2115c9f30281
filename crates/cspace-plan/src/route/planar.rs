//! Ways in the contact space of a planar pair.

use core::f64::consts::TAU;

use cspace::{Configuration, ContactSpace};

use crate::legs::{Coords, Scene};

use super::piece::{Piece, Station, along, share_of};

/// A planar contact space with the connected components of its surface.
#[derive(Debug)]
pub(crate) struct Planar<'a> {
    space: &'a ContactSpace,
    pub(super) scene: &'a Scene,
    /// Of each patch.
    component: Vec<u32>,
}

impl<'a> Planar<'a> {
    pub(crate) fn new(space: &'a ContactSpace, scene: &'a Scene) -> Self {
        let mut root: Vec<u32> = (0..space.patches().len() as u32).collect();
        fn find(root: &mut [u32], mut i: u32) -> u32 {
            while root[i as usize] != i {
                root[i as usize] = root[root[i as usize] as usize];
                i = root[i as usize];
            }
            i
        }
        let side = space.side_links().iter().map(|l| (l.before, l.after));
        let vertical = space.vertical_links().iter().map(|l| (l.lower, l.upper));
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

    /// A way from one free configuration to another of the same region: straight pieces, and pieces along patches between them.
    /// Its end differs from `to` by whole turns. `None` where the surface is not as it should be.
    pub(crate) fn way(&'a self, from: Coords, to: Coords) -> Option<Vec<Piece<'a>>> {
        let rates: Coords = core::array::from_fn(|k| to[k] - from[k]);
        let start = Configuration::new(from[0], from[1], from[2]);
        let crossings = self.space.crossings(start, rates, 1.0).ok()?;
        let mut pieces = Vec::new();
        let (mut time, mut turn) = (0.0, 0.0);
        let at = |t: f64, turn: f64| {
            let mut c = along(from, to, t);
            c[2] += turn;
            c
        };
        let mut next = 0;
        while let Some((k, &(hit, patch, _))) = (crossings.iter().enumerate().skip(next))
            .find(|(_, c)| c.2)
        {
            let surface = self.component[patch as usize];
            let (last, &(leaves, exit, _)) = (crossings.iter().enumerate().skip(k + 1))
                .rfind(|(_, c)| !c.2 && self.component[c.1 as usize] == surface)?;
            pieces.push(Piece::Straight {
                from: at(time, turn),
                to: at(hit, turn),
            });
            let entry = self.on(patch, at(hit, 0.0));
            let goal = self.on(exit, at(leaves, 0.0));
            let walk = self.walk((patch, entry.0, entry.1 + turn), (exit, goal.0))?;
            // The walk may have gone around: orientations go on from where it ends.
            turn = walk.last()?.turn - goal.1;
            pieces.extend(walk.into_iter().map(|across| Piece::Above {
                planar: self,
                across,
            }));
            time = leaves;
            next = last + 1;
        }
        pieces.push(Piece::Straight {
            from: at(time, turn),
            to: at(1.0, turn),
        });
        Some(pieces)
    }

    /// Where a configuration is on a patch, and by how much its orientation is more than the patch counts it.
    fn on(&self, patch: u32, at: Coords) -> (Station, f64) {
        let theta = self.brought(patch, at[2]);
        let share = self
            .curve(patch, theta)
            .map_or(0.5, |c| share_of(&c, cspace::Point::new(at[0], at[1])));
        (Station { theta, share }, at[2] - theta)
    }

    /// An orientation in the numbering of a patch, brought within it if rounding has put it outside.
    pub(super) fn brought(&self, patch: u32, theta: f64) -> f64 {
        let p = &self.space.patches()[patch as usize];
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
