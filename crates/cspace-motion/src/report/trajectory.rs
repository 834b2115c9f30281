//! Coordinates as functions of time, interpolated between the recorded moments.

use crate::record::{Record, Sample};

/// Motion as a function of time: through all recorded values, cubic between them by the rates (Hermite). An interval
/// ends where rates jump, so corners stay corners; with a traced motion the error is of fourth order in a step.
#[derive(Debug, Clone)]
pub struct Trajectory<'a> {
    /// Recorded samples in order of time; where rates jump there are two at one time.
    knots: Vec<&'a Sample>,
}

/// Moments nearer than this are one, relative to the duration: rounding.
const SAME: f64 = 1e-12;

impl<'a> Trajectory<'a> {
    /// Builds the trajectory of a recording from its trace and its samples.
    pub fn of(record: &'a Record) -> Self {
        let near = SAME * record.until;
        let trace = &record.trace;
        let is_traced = |s: &&Sample| {
            let after = trace.partition_point(|k| k.t < s.t - near);
            trace.get(after).is_some_and(|k| k.t <= s.t + near)
        };
        let mut knots: Vec<&Sample> = trace.iter().collect();
        knots.extend(record.samples.iter().filter(|s| !is_traced(s)));
        // Stable: of two traced moments of one time the first stays before the second.
        knots.sort_by(|a, b| a.t.total_cmp(&b.t));
        Self { knots }
    }

    /// The moments that are known.
    pub fn knots(&self) -> &[&'a Sample] {
        &self.knots
    }

    /// The times of the moments that are known up to one, the last first, less an amount.
    pub(super) fn back_from(&self, last: f64, less: f64) -> impl Iterator<Item = f64> + '_ {
        let end = self.knots.partition_point(|k| k.t - less <= last);
        self.knots[..end].iter().rev().map(move |k| k.t - less)
    }

    /// The first and the last time.
    pub fn span(&self) -> (f64, f64) {
        let time = |k: Option<&&Sample>| k.map_or(0.0, |s| s.t);
        (time(self.knots.first()), time(self.knots.last()))
    }

    /// The moment nearest to a time.
    pub fn nearest(&self, t: f64) -> Option<&'a Sample> {
        let after = self.knots.partition_point(|k| k.t < t);
        let around = after.saturating_sub(1)..(after + 1).min(self.knots.len());
        let near = |a: &&&Sample, b: &&&Sample| (a.t - t).abs().total_cmp(&(b.t - t).abs());
        self.knots[around].iter().min_by(near).copied()
    }

    /// A coordinate at a time; before the first moment and after the last as there.
    pub fn at(&self, t: f64, coordinate: usize) -> f64 {
        let after = self.knots.partition_point(|k| k.t < t);
        let value = |s: &Sample| s.coordinates[coordinate];
        let before = after.checked_sub(1).map(|i| self.knots[i]);
        match (before, self.knots.get(after).copied()) {
            (Some(a), Some(b)) => Piece::new(a, b, coordinate).value((t - a.t) / (b.t - a.t)),
            (None, Some(s)) | (Some(s), None) => value(s),
            (None, None) => 0.0,
        }
    }

    /// Values of all coordinates at a time.
    pub fn all_at(&self, t: f64) -> Vec<f64> {
        let count = self.knots.first().map_or(0, |k| k.coordinates.len());
        (0..count).map(|i| self.at(t, i)).collect()
    }

    /// The least and the greatest value of a coordinate between two times.
    pub fn extent(&self, coordinate: usize, from: f64, to: f64) -> (f64, f64) {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        let mut add = |x: f64| range = (range.0.min(x), range.1.max(x));
        add(self.at(from, coordinate));
        add(self.at(to, coordinate));
        let first = self.knots.partition_point(|k| k.t < from).saturating_sub(1);
        for pair in self.knots[first..].windows(2) {
            let (a, b) = (pair[0], pair[1]);
            if a.t > to {
                break;
            }
            let piece = Piece::new(a, b, coordinate);
            let inside = |s: f64| (from..=to).contains(&(a.t + s * (b.t - a.t)));
            let turns = piece.turns().into_iter().flatten();
            for s in [0.0, 1.0].into_iter().chain(turns).filter(|s| inside(*s)) {
                add(piece.value(s));
            }
        }
        range
    }

    /// Times and values of a coordinate, close enough to be joined by lines on a picture.
    pub fn curve(&self, coordinate: usize) -> Vec<(f64, f64)> {
        /// Chords per piece between two moments.
        const CHORDS: u32 = 4;
        let mut curve: Vec<(f64, f64)> = Vec::new();
        for pair in self.knots.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let piece = Piece::new(a, b, coordinate);
            let chords = if b.t > a.t { CHORDS } else { 1 };
            for k in 0..chords {
                let s = f64::from(k) / f64::from(chords);
                curve.push((a.t + s * (b.t - a.t), piece.value(s)));
            }
        }
        if let Some(last) = self.knots.last() {
            curve.push((last.t, last.coordinates[coordinate]));
        }
        curve
    }
}

/// A coordinate between two moments, by the share s of the time: a + s (r + s (c + s d)).
struct Piece {
    start: f64,
    end: f64,
    a: f64,
    r: f64,
    c: f64,
    d: f64,
}

impl Piece {
    fn new(from: &Sample, to: &Sample, i: usize) -> Self {
        let h = to.t - from.t;
        let (start, end) = (from.coordinates[i], to.coordinates[i]);
        let rate = |s: &Sample| h * s.rates.get(i).copied().unwrap_or(0.0);
        let (r0, r1) = (rate(from), rate(to));
        let rise = end - start;
        Self {
            start,
            end,
            a: start,
            r: r0,
            c: 3.0 * rise - 2.0 * r0 - r1,
            d: r0 + r1 - 2.0 * rise,
        }
    }

    fn value(&self, s: f64) -> f64 {
        if s <= 0.0 {
            self.start
        } else if s >= 1.0 {
            self.end
        } else {
            self.a + s * (self.r + s * (self.c + s * self.d))
        }
    }

    /// The shares at which its rate vanishes.
    fn turns(&self) -> [Option<f64>; 2] {
        // r + 2 c s + 3 d s², without cancellation.
        let disc = self.c * self.c - 3.0 * self.d * self.r;
        if disc < 0.0 {
            return [None, None];
        }
        let q = -(self.c + self.c.signum() * disc.sqrt());
        let within = |s: f64| (s > 0.0 && s < 1.0).then_some(s);
        [within(self.r / q), within(q / (3.0 * self.d))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(t: f64, u: f64, du: f64) -> Sample {
        Sample {
            t,
            coordinates: vec![u],
            rates: vec![du],
            forces: None,
        }
    }

    /// A cubic is met to rounding, with the places at which it turns.
    #[test]
    fn cubics_are_met() {
        let f = |t: f64| t * t * t - 3.0 * t;
        let df = |t: f64| 3.0 * t * t - 3.0;
        let samples: Vec<Sample> = [-3.0, -1.7, 0.4, 2.0]
            .map(|t| sample(t, f(t), df(t)))
            .into();
        let trajectory = Trajectory {
            knots: samples.iter().collect(),
        };
        for t in [-2.9, -1.0, 0.0, 1.9] {
            assert!((trajectory.at(t, 0) - f(t)).abs() < 1e-13);
        }
        let (lo, hi) = trajectory.extent(0, -1.5, 1.8);
        assert!((lo + 2.0).abs() < 1e-13 && (hi - 2.0).abs() < 1e-13);
        assert_eq!(trajectory.at(9.0, 0), f(2.0));
    }

    /// Both sides of a jump of rates count.
    #[test]
    fn corners_stay() {
        let samples = [
            sample(0.0, 0.0, 1.0),
            sample(1.0, 1.0, 1.0),
            sample(1.0, 1.0, -2.0),
            sample(2.0, -1.0, -2.0),
        ];
        let trajectory = Trajectory {
            knots: samples.iter().collect(),
        };
        assert!((trajectory.at(0.5, 0) - 0.5).abs() < 1e-15);
        assert!(trajectory.at(1.5, 0).abs() < 1e-15);
        assert_eq!(trajectory.extent(0, 0.0, 2.0), (-1.0, 1.0));
    }
}
