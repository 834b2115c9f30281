//! Ways in a contact space: straight, and along the surfaces that are in the way.

use cspace::Coordinates;

use crate::legs::Coords;

use super::above::Above;
use super::piece::{Piece, Straight, along};
use super::planar::Planar;

impl Planar<'_> {
    /// A way from one free configuration to another of the same region: straight pieces, and pieces along patches between them.
    /// Its end differs from `to` by whole turns. `None` where the surface is not as it should be.
    pub(crate) fn way(&self, from: Coords, to: Coords) -> Option<Vec<Box<dyn Piece + '_>>> {
        let rates: Coords = core::array::from_fn(|k| to[k] - from[k]);
        let Coordinates::Planar(start) = self.scene.coordinates(from) else {
            return None;
        };
        let crossings = (self.space())
            .crossings_about(start, rates, self.scene.about(), 1.0)
            .ok()?;
        let mut pieces: Vec<Box<dyn Piece + '_>> = Vec::new();
        let (mut time, mut turn) = (0.0, 0.0);
        let at = |t: f64, turn: f64| {
            let mut c = along(from, to, t);
            c[2] += turn;
            c
        };
        let mut next = 0;
        while let Some((k, &(hit, patch, _))) =
            (crossings.iter().enumerate().skip(next)).find(|(_, c)| c.2)
        {
            let surface = self.component[patch.index()];
            let (last, &(leaves, exit, _)) = (crossings.iter().enumerate().skip(k + 1))
                .rfind(|(_, c)| !c.2 && self.component[c.1.index()] == surface)?;
            pieces.push(Box::new(Straight {
                from: at(time, turn),
                to: at(hit, turn),
            }));
            let entry = self.on(patch, at(hit, 0.0));
            let goal = self.on(exit, at(leaves, 0.0));
            let walk = self.walk((patch, entry.0, entry.1 + turn), (exit, goal.0))?;
            // The walk may have gone around: orientations go on from where it ends.
            turn = walk.last()?.turn - goal.1;
            for across in walk {
                pieces.push(Box::new(Above {
                    planar: self,
                    across,
                }));
            }
            time = leaves;
            next = last + 1;
        }
        pieces.push(Box::new(Straight {
            from: at(time, turn),
            to: at(1.0, turn),
        }));
        Some(pieces)
    }
}
