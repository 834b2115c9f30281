//! Two parts at one place.

use crate::legs::{Between, Body, Coords};

use super::depth::{Separated, separated};
use super::{Clash, State};

/// Two parts that are asked about.
pub(super) struct Pair<'a> {
    /// Their numbers.
    pub(super) parts: [usize; 2],
    pub(super) bodies: [&'a Body<'a>; 2],
    /// Parts nearer than this touch.
    pub(super) touch: f64,
}

impl<'a> Pair<'a> {
    /// The two during a motion of constant rates.
    pub(super) fn between(&self, from: [Coords; 2], to: [Coords; 2]) -> Between<'a> {
        Between {
            bodies: self.bodies,
            from,
            to,
        }
    }

    /// What the two are to each other at a place; none if they are clear by `within` or more.
    pub(super) fn there(&self, at: [Coords; 2], within: f64) -> Option<Clash> {
        let between = self.between(at, at);
        let nearest = between.distance_below(within.max(self.touch));
        let is_near = nearest.distance <= self.touch;
        // Parts that are in each other may have boundaries that are far apart.
        if is_near || self.boxes_meet(at) && between.overlaps() {
            return Some(self.met(at, !is_near));
        }
        (nearest.distance < within).then(|| Clash {
            gap: Some(nearest.distance),
            features: nearest.features.map(|(a, b)| [a, b]),
            points: between.nearest_points(),
            ..self.clash(State::Clear)
        })
    }

    /// What parts are to each other that touch or overlap; `overlaps` if it is known that they overlap.
    fn met(&self, at: [Coords; 2], overlaps: bool) -> Clash {
        let [a, b] = [0, 1].map(|i| self.bodies[i].configuration(at[i]));
        let parts = [self.bodies[0].part(), self.bodies[1].part()];
        match separated(parts, [a, b]) {
            Some(Separated {
                depth,
                points,
                features,
            }) => {
                let is_overlap = depth > self.touch;
                Clash {
                    gap: (!is_overlap).then_some(0.0),
                    depth: is_overlap.then_some(depth),
                    points: Some(points),
                    features: Some(features),
                    ..self.clash(if is_overlap {
                        State::Overlap
                    } else {
                        State::Touching
                    })
                }
            }
            None if overlaps || self.between(at, at).overlaps() => self.clash(State::Overlap),
            None => Clash {
                gap: Some(0.0),
                ..self.clash(State::Touching)
            },
        }
    }

    pub(super) fn clash(&self, state: State) -> Clash {
        Clash {
            parts: self.parts,
            state,
            gap: None,
            depth: None,
            points: None,
            features: None,
            time: None,
        }
    }

    /// Whether boxes around the parts meet.
    fn boxes_meet(&self, at: [Coords; 2]) -> bool {
        let [a, b] = self.bodies;
        let is_drawn = at == [[0.0; 3]; 2];
        let around = |body: &Body<'_>, at: Coords| match is_drawn {
            true => body.part().bounds(),
            false => body.around(at),
        };
        !around(a, at[0]).is_apart(around(b, at[1]), 0.0)
    }
}
