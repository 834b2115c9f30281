//! Contacts of neighbouring features, which touch each other by their making.
//!
//! Features a and a′ of the fixed part meet at a joint X with the normal ν, b and b′ of the moving part at a joint Y with the
//! normal n. Where these normals oppose each other, at one orientation θ₀, the contacts of a with b and of a′ with b′ go both
//! through X − R Y, with one normal. So their carriers touch there, and the ends that lie at the joints are on the other's
//! carrier. Neither is a sign of anything that changes from one side to the other: with signed radii a, a′, b, b′ each of
//! these conditions is, for two lengths p and q,
//!
//! ```text
//! |p ν − q R n|² − (p + q)² = −2 p q (1 + ν·R n)
//! ```
//!
//! and with a line something similar: it vanishes at θ₀ and nowhere else, with its slope. A double root is known to the square root of
//! the rounding, and the more radii there are to cancel, the worse; θ₀ is known from two angles, to the last bits.

use core::f64::consts::{PI, TAU};

use crate::feature::{Feature, Outline};
use crate::number::Event;

use super::sheet::Sheet;

/// Error of the orientation at which two normals oppose each other, radians.
pub(crate) const ALIGNMENT_ERROR: f64 = 16.0 * f64::EPSILON;

/// Error with which such a tangency is told, radians: about 3e-8.
///
/// Its orientation is known much better. But nearer to it than the square root of the rounding, places at which the two curves
/// cross cannot be told apart, and so nothing is to be looked at there.
const TIE_ERROR: f64 = 1.0 / (1u64 << 25) as f64;

/// The orientations at which two contacts touch by their making, each up to whole turns: none unless both features differ and
/// follow each other. Two loops of two features each have four.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ties {
    orientations: [f64; 4],
    count: usize,
}

impl Ties {
    /// Those of two sheets of a pair.
    pub(crate) fn new(fixed: &Outline, moving: &Outline, f: &Sheet, g: &Sheet) -> Self {
        let mut ties = Self {
            orientations: [0.0; 4],
            count: 0,
        };
        let joints = |outline: &Outline, i: u32, j: u32| -> [Option<f64>; 2] {
            let (a, b): (&Feature, &Feature) =
                (&outline.features[i as usize], &outline.features[j as usize]);
            let angle = |joint: u32| outline.joints[joint as usize].angle;
            let apart = i != j;
            [
                (apart && a.start == b.end).then(|| angle(a.start)),
                (apart && a.end == b.start).then(|| angle(a.end)),
            ]
        };
        let of_moving = joints(moving, f.moving, g.moving);
        for x in joints(fixed, f.fixed, g.fixed).into_iter().flatten() {
            for y in of_moving.into_iter().flatten() {
                ties.orientations[ties.count] = x - y - PI;
                ties.count += 1;
            }
        }
        ties
    }

    /// Those of them that are nearest to an orientation, of all their copies by whole turns.
    pub(crate) fn about(&self, mid: f64) -> impl Iterator<Item = f64> + '_ {
        let near = move |t: f64| t - TAU * ((t - mid) / TAU).round();
        self.orientations[..self.count]
            .iter()
            .map(move |&t| near(t))
    }

    /// The one that an event is, if it is one; itself up to whole turns.
    pub(crate) fn explain(&self, event: Event) -> Option<Event> {
        let slack = event.error + ALIGNMENT_ERROR;
        self.about(event.theta)
            .find(|t| (t - event.theta).abs() <= slack)
            .map(|theta| Event {
                theta,
                error: TIE_ERROR,
            })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::condition::conditions;
    use super::super::pair::Geometry;
    use super::*;
    use crate::geometry::Rotation;
    use crate::part::{Part, Vertex};

    /// A part of lines and of arcs that bulge either way, one of them of another radius than its neighbour goes on with.
    fn part(name: &str, size: f64, bulges: [f64; 5]) -> Part {
        let corners = [
            (-1.0, -1.0),
            (1.0, -0.9),
            (1.1, 1.0),
            (0.2, 1.3),
            (-0.9, 0.8),
        ];
        let vertex = |(&(x, y), &b): (&(f64, f64), &f64)| Vertex::new(x * size, y * size, b);
        let outline = corners.iter().zip(&bulges).map(vertex).collect();
        Part::new(name, vec![outline]).unwrap()
    }

    /// Conditions that touch zero where two joints say so: their value is none to both sides, to second order, and
    /// nowhere else; and no other condition of the pair is taken for one.
    #[test]
    fn conditions_of_neighbours_touch_where_normals_oppose() {
        let fixed = part("fixed", 1.0, [0.0, 0.3, -0.2, 0.0, 0.4]);
        let moving = part("moving", 0.6, [0.2, 0.0, -0.3, 0.1, 0.0]);
        let geometry = Geometry::new(&fixed, &moving, None, usize::MAX);
        let sheets = &geometry.contacts.sheets;
        let (mut explained, mut sloping) = (0, 0);
        for (i, f) in sheets.iter().enumerate() {
            for g in &sheets[..i] {
                let shared = f.shared_ends(g, geometry.contacts.first_vertex_name);
                if shared.tangent {
                    continue;
                }
                let ties = Ties::new(&geometry.fixed, &geometry.moving, f, g);
                let all: Vec<f64> = ties.about(0.0).collect();
                if f.fixed == g.fixed || f.moving == g.moving {
                    assert!(all.is_empty());
                }
                conditions(f, g, &shared, |t, _| {
                    let at = |theta: f64| {
                        let turn = Rotation::by(theta);
                        t.alpha * turn.cos + t.beta * turn.sin + t.gamma
                    };
                    let Some(tie) = t.touch().and_then(|e| ties.explain(e)) else {
                        // A simple root, or none.
                        sloping += usize::from(at(0.3) != 0.0);
                        return;
                    };
                    explained += 1;
                    let amplitude = t.alpha.hypot(t.beta);
                    let rounding = 1e-14 * t.scale;
                    assert!(at(tie.theta).abs() <= rounding, "{t:?}");
                    for d in [1e-3, 0.1, 1.0, 3.0] {
                        let expected = amplitude * (1.0 - f64::cos(d));
                        for side in [d, -d] {
                            let off = at(tie.theta + side).abs() - expected;
                            assert!(off.abs() <= rounding, "{t:?} {side} {off}");
                        }
                    }
                });
            }
        }
        assert!(explained > 50 && sloping > 1000, "{explained} {sloping}");
    }

    /// An orientation that only comes near is none of them.
    #[test]
    fn what_is_beside_is_not_explained() {
        let ties = Ties {
            orientations: [1.0, 0.0, 0.0, 0.0],
            count: 1,
        };
        let event = |theta, error| Event { theta, error };
        assert_eq!(ties.explain(event(1.0 + 2e-12, 1e-12)), None);
        let found = ties.explain(event(1.0 + TAU + 1e-12, 2e-12)).unwrap();
        assert!((found.theta - 1.0 - TAU).abs() < 1e-14);
        assert_eq!(found.error, TIE_ERROR);
        // Two angles tell an orientation to some last bits, however well the event is known.
        assert!(ties.explain(event(1.0 + 1e-15, 0.0)).is_some());
        let none = Ties { count: 0, ..ties };
        assert_eq!(none.explain(event(1.0, 1.0)), None);
    }
}
