//! Sharp turns of a curve: cusps, and turns that are nearly cusps.

use super::Curve;

/// Turning by more than that within a short length, in radians, is sharp: less does not show beside a tolerance of a
/// multiple of the length.
const SHARP: f64 = 0.35;

/// Intervals that a span is first looked at in: within each a span of the usual degrees turns by less than half a turn, but
/// for sharp turns. The middle, where the cusps of symmetric curves are, is the end of none.
const INTERVALS: usize = 17;

/// A speed below that share of another is 0, but for rounding.
const STILL: f64 = 1e-9;

/// Halvings of an interval until its ends are one number.
const HALVINGS: usize = 52;

impl Curve {
    /// The intervals of a span, as fractions of it, in which it turns sharply within a length, in order. A cusp that is met
    /// exactly is an interval of one fraction.
    pub(crate) fn sharp_turns(&self, span: usize, within: f64) -> Vec<[f64; 2]> {
        let mut found: Vec<[f64; 2]> = Vec::new();
        for i in 0..INTERVALS {
            let interval = [i, i + 1].map(|i| i as f64 / INTERVALS as f64);
            self.search(span, interval, within, HALVINGS, &mut found);
        }
        // A turn that continues in the next interval is one turn.
        found.dedup_by(|next, before| {
            let goes_on = next[0] <= before[1];
            if goes_on {
                before[1] = before[1].max(next[1]);
            }
            goes_on
        });
        found
    }

    fn search(
        &self,
        span: usize,
        [from, to]: [f64; 2],
        within: f64,
        halvings: usize,
        found: &mut Vec<[f64; 2]>,
    ) {
        if self.turn(span, from, to).abs() <= SHARP {
            return;
        }
        let middle = f64::midpoint(from, to);
        let [first, between, last] = [from, middle, to].map(|s| self.at(span, s).1.length());
        let speed = first.max(between).max(last);
        if speed * (to - from) <= within || halvings == 0 {
            found.push([from, to]);
        } else if between <= STILL * speed {
            found.push([middle; 2]);
        } else {
            for half in [[from, middle], [middle, to]] {
                self.search(span, half, within, halvings - 1, found);
            }
        }
    }

    /// The angle between the directions at two fractions of a span; 0 where one has none.
    fn turn(&self, span: usize, from: f64, to: f64) -> f64 {
        let (a, b) = (self.at(span, from).1, self.at(span, to).1);
        let (slower, faster) = (a.length().min(b.length()), a.length().max(b.length()));
        if slower <= STILL * faster {
            return 0.0;
        }
        a.cross(b).atan2(a.dot(b))
    }
}
