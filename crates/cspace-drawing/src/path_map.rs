//! Paths under affine maps.

use cspace::Edge;

use crate::affine::Affine;
use crate::curve::{Curve, EllipseArc};
use crate::drawing::{Path, Piece};

impl Path {
    /// The image under an affine map. Arcs stay arcs where circles stay circles, and become arcs of ellipses elsewhere.
    #[must_use]
    pub fn mapped(&self, map: &Affine) -> Self {
        if *map == Affine::IDENTITY {
            return self.clone();
        }
        let keeps_circles = map.is_similarity();
        let turn = map.determinant().signum();
        let mut from = self.start;
        let mut image = Self::from(map.point(from));
        image.closed = self.closed;
        image.pieces.reserve_exact(self.pieces.len());
        for piece in &self.pieces {
            let mapped = match piece {
                Piece::Edge { to, bulge } if keeps_circles || *bulge == 0.0 => Piece::Edge {
                    to: map.point(*to),
                    bulge: bulge * turn,
                },
                Piece::Edge { to, bulge } => {
                    let arc = Curve::Ellipse(circle_arc(&Edge::between(from, *to, *bulge)));
                    Piece::Curve(Box::new(arc.mapped(map)))
                }
                Piece::Curve(curve) => Piece::Curve(Box::new(curve.mapped(map))),
            };
            image.pieces.push(mapped);
            from = piece.end();
        }
        image
    }
}

/// The arc of a circle as an arc of an ellipse.
fn circle_arc(arc: &Edge) -> EllipseArc {
    let center = arc.center();
    let u = arc.start - center;
    EllipseArc {
        center,
        u,
        v: u.left(),
        from: 0.0,
        to: arc.sweep(),
    }
}
