//! Two parts at one place.

use crate::assembly::inset;
use crate::legs::{Between, Body, Coords};

use super::answer::{Clash, State};
use super::depth::separated;

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

    /// State of the two parts at given places; none if they are clear by `within` or more.
    pub(super) fn there(&self, at: [Coords; 2], within: f64) -> Option<Clash> {
        let between = self.between(at, at);
        let nearest = between.distance_below(within.max(self.touch));
        let is_near = nearest.distance <= self.touch;
        if self.overlaps(at, is_near) {
            return Some(self.overlap(at));
        }
        (is_near || nearest.distance < within).then(|| {
            let (features, points) = between.nearest().unzip();
            Clash {
                gap: Some(nearest.distance),
                features,
                points,
                ..self.clash(if is_near {
                    State::Touching
                } else {
                    State::Clear
                })
            }
        })
    }

    /// Whether the parts overlap, given whether their boundaries touch.
    fn overlaps(&self, at: [Coords; 2], is_near: bool) -> bool {
        let between = self.between(at, at);
        if is_near {
            between.overlaps_deeper(self.touch)
        } else {
            // Parts that are in each other may have boundaries that are far apart.
            self.boxes_meet(at) && between.overlaps()
        }
    }

    /// The least inset of the second part with which two parts that overlap do not, to a billionth of it; none if the part has no inset
    /// that is as large. By bisection: a part overlaps with what each smaller one does.
    pub(super) fn offset(&self, at: [Coords; 2]) -> Option<f64> {
        const EXACT: f64 = 1e-9;
        let [first, second] = self.bodies;
        let clears = |by: f64| {
            let smaller = inset(second.part(), by).ok().flatten()?;
            let body = second.with(&smaller);
            let pair = Pair {
                bodies: [first, &body],
                ..*self
            };
            let near = pair.between(at, at).distance_below(self.touch).distance;
            Some(!pair.overlaps(at, near <= self.touch))
        };
        let (mut lo, mut hi) = (0.0, self.touch);
        while !clears(hi)? {
            (lo, hi) = (hi, 2.0 * hi);
        }
        while hi - lo > EXACT * hi {
            let middle = 0.5 * (lo + hi);
            match clears(middle)? {
                true => hi = middle,
                false => lo = middle,
            }
        }
        Some(hi)
    }

    /// How deep two parts overlap at a place at which they do.
    fn overlap(&self, at: [Coords; 2]) -> Clash {
        let [a, b] = [0, 1].map(|i| self.bodies[i].configuration(at[i]));
        let parts = self.bodies.map(Body::part);
        let found = separated(parts, [a, b]);
        Clash {
            depth: found.as_ref().map(|s| s.depth),
            points: found.as_ref().map(|s| s.points),
            features: found.as_ref().map(|s| s.features),
            ..self.clash(State::Overlap)
        }
    }

    pub(super) fn clash(&self, state: State) -> Clash {
        Clash {
            parts: self.parts,
            state,
            gap: None,
            depth: None,
            offset: None,
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
