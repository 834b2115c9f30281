//! The bridges of a motion: how many there are, and how many in a row.

/// Bridges are in a row if between two of them the motion comes no farther than this multiple of the first one's time.
const FARTHER: f64 = 100.0;
/// There are no more bridges than that in a motion.
const MOST: usize = 50_000;
/// Each time that there are so many more, it is asked whether [`MOST`] would reach the end.
const ASKED: usize = 64;

/// Bridges so far.
#[derive(Debug)]
pub(super) struct Bridges {
    /// Number of all.
    all: usize,
    /// Number of those in a row, between which the motion did not come much farther than by them.
    in_a_row: usize,
    /// The time of the last one.
    last: [f64; 2],
    /// The time at which it was last asked whether they would reach the end.
    asked: f64,
}

impl Bridges {
    pub(super) fn from(t: f64) -> Self {
        Self {
            all: 0,
            in_a_row: 0,
            last: [t, t],
            asked: t,
        }
    }

    /// Begins a bridge at a time, with some time left; returns how many there are before it in its row. `None` if there are too many, or
    /// would be.
    pub(super) fn next(&mut self, t: f64, left: f64) -> Option<usize> {
        let [begin, end] = self.last;
        if t > end + FARTHER * (end - begin) {
            self.in_a_row = 0;
        }
        let before = self.in_a_row;
        self.in_a_row += 1;
        self.all += 1;
        let mut reach = true;
        if self.all.is_multiple_of(ASKED) {
            reach = (t - self.asked) * ((MOST - self.all.min(MOST)) / ASKED) as f64 >= left;
            self.asked = t;
        }
        reach.then_some(before)
    }

    /// Ends the bridge.
    pub(super) fn ended(&mut self, from: f64, until: f64) {
        self.last = [from, until];
    }
}
