//! Impacts that accumulate: their times come nearer to each other as a geometric series, and have a limit.

/// The series is closed when its remaining duration is less than this share of the simulated time.
const LEFT: f64 = 1e-10;
/// The series is also closed when the displacement between impacts is shorter than this share of the size: rounding
/// leaves little of it.
const WAY: f64 = 1e-12;
/// And its remaining duration is no longer than this multiple of its last interval: a limit that is farther off is not told by rounding.
const FAR: f64 = 64.0;
/// Intervals are compared with those this many impacts before: two feet of a block strike in turn.
const TURNS: usize = 2;

/// The times of impacts, the last ones.
#[derive(Debug, Clone, Default)]
pub(super) struct Impacts {
    times: Vec<f64>,
    /// Times of the latest impacts, the last first.
    recent: std::collections::VecDeque<f64>,
}

impl Impacts {
    pub(super) fn add(&mut self, t: f64) {
        /// Largest number of impacts that are compared.
        const KEPT: usize = 8;
        self.times.push(t);
        self.recent.push_front(t);
        if self.times.len() > KEPT {
            self.times.remove(0);
        }
    }

    /// Whether the last `many` impacts came within a time.
    pub(super) fn is_crowded(&mut self, time: f64, many: usize) -> bool {
        self.recent.truncate(many);
        match (self.recent.front(), self.recent.back()) {
            (Some(last), Some(first)) => self.recent.len() == many && last - first < time,
            _ => false,
        }
    }

    /// Time until all impacts to come are over, if they accumulate and are nearly over: with intervals d, r d, r² d …
    /// this is d r / (1 − r) after the last.
    ///
    /// `way` is the distance by which the contacts open in a unit of time after the last impact, as a share of the
    /// size.
    pub(super) fn rest(&self, span: f64, way: f64) -> Option<f64> {
        let d: Vec<f64> = self.times.windows(2).map(|w| w[1] - w[0]).collect();
        let n = d.len();
        if n < 2 * TURNS + 1 {
            return None;
        }
        let sum = |i: usize| d[i + 1 - TURNS..=i].iter().sum::<f64>();
        let (last, before, first) = (sum(n - 1), sum(n - 1 - TURNS), sum(n - 2));
        let ratio = last / before;
        // Each of those that strike in turn has its own intervals.
        let falls = (n - TURNS..n).all(|i| d[i] < d[i - TURNS]);
        let left = last * ratio / (1.0 - ratio);
        let is_over = left < LEFT * span || (way * last < WAY && left < FAR * last);
        // Contacts that do not separate do not strike again.
        (way > 0.0 && ratio < 1.0 && first > last && falls && is_over).then_some(left)
    }
}

#[cfg(test)]
mod tests {
    use super::Impacts;

    /// The rest of a series whose intervals begin with 1e-8 and fall by a ratio, in 1 s, between which contacts hardly open.
    fn rest(ratio: f64) -> Option<f64> {
        let (mut impacts, mut t, mut interval) = (Impacts::default(), 0.0, 1e-8);
        for _ in 0..9 {
            impacts.add(t);
            t += interval;
            interval *= ratio;
        }
        impacts.rest(1.0, 1e-6)
    }

    #[test]
    fn a_series_is_closed_only_near_its_limit() {
        assert!(rest(0.5).is_some_and(|left| left < 1e-9));
        assert!(rest(0.9).is_some_and(|left| left < 1e-6));
        assert_eq!(rest(1.0 - 1e-7), None);
    }
}
