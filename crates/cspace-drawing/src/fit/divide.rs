//! The fewest pieces between samples.

use super::bulges::allowed;
use super::run::Run;

/// A run in pieces, each a line or an arc.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Division {
    /// The samples at which pieces meet, ends included; the last of a closed run is the first, a turn on.
    pub(super) joints: Vec<usize>,
    /// A bulge of each piece.
    pub(super) bulges: Vec<f64>,
    /// The half width of the band that it was made for.
    pub(super) width: f64,
}

impl Division {
    /// The number of pieces.
    pub(super) fn len(&self) -> usize {
        self.bulges.len()
    }
}

/// Divides a run from a sample on, each piece as long as it may be.
pub(super) fn fewest(run: &Run, start: usize, width: f64) -> Division {
    let end = start + run.len() - 1;
    let mut joints = vec![start];
    let mut bulges = Vec::new();
    let mut at = start;
    while at < end {
        let (next, bulge) = longest(run, at, end, width);
        joints.push(next);
        bulges.push(bulge);
        at = next;
    }
    // A closed run of one piece has no ends to lie between.
    if run.is_closed && bulges.len() < 2 {
        let half = start + (run.len() - 1) / 2;
        joints = vec![start, half, end];
        bulges = (joints.windows(2))
            .map(|j| allowed(run, j[0], j[1], width).map_or(0.0, |(lo, hi)| (lo + hi) / 2.0))
            .collect();
    }
    Division {
        joints,
        bulges,
        width,
    }
}

/// The farthest sample that one piece reaches, and a bulge of it: by steps that double, and then by halves.
fn longest(run: &Run, from: usize, end: usize, width: f64) -> (usize, f64) {
    let most = if run.is_closed { end.min(from + run.len() - 2) } else { end };
    let test = |to: usize| allowed(run, from, to, width).map(|(lo, hi)| (lo + hi) / 2.0);
    let mut reached = (from + 1, test(from + 1).unwrap_or(0.0));
    let mut step = 1;
    let mut beyond = loop {
        let to = (reached.0 + step).min(most);
        if to == reached.0 {
            return reached;
        }
        match test(to) {
            Some(bulge) => reached = (to, bulge),
            None => break to,
        }
        step *= 2;
    };
    while beyond > reached.0 + 1 {
        let middle = reached.0.midpoint(beyond);
        match test(middle) {
            Some(bulge) => reached = (middle, bulge),
            None => beyond = middle,
        }
    }
    reached
}

/// Samples to begin a closed run at: some of those along the first piece.
pub(super) fn starts(run: &Run) -> Vec<usize> {
    const TRIED: usize = 6;
    let first = longest(run, 0, run.len() - 1, run.band.width()).0;
    let mut starts: Vec<usize> = (0..TRIED).map(|k| k * first / TRIED).collect();
    starts.dedup();
    starts
}

/// How finely widths of bands are told apart, as a share.
const FINE: f64 = 0.01;

/// As many pieces, for the narrowest band: they deviate about alike.
pub(super) fn balance(run: &Run, division: &Division) -> Division {
    let mut best = division.clone();
    let mut low = 0.0;
    while best.width - low > FINE * best.width {
        let width = f64::midpoint(best.width, low);
        let tried = fewest(run, best.joints[0], width);
        if tried.len() <= best.len() {
            best = tried;
        } else {
            low = width;
        }
        if best.width < 1e-6 * division.width {
            break;
        }
    }
    best
}

/// At least one piece more, for the widest band that asks for it. None if no band does: every sample is a joint.
pub(super) fn more(run: &Run, division: &Division) -> Option<Division> {
    let start = division.joints[0];
    let mut width = division.width;
    let mut narrower = loop {
        width *= 0.8;
        let tried = fewest(run, start, width);
        if tried.len() > division.len() {
            break tried;
        }
        if width < 1e-9 * run.band.width() {
            return None;
        }
    };
    // From above, the widest.
    let mut wide = width / 0.8;
    while wide - narrower.width > FINE * wide {
        let middle = f64::midpoint(wide, narrower.width);
        let tried = fewest(run, start, middle);
        if tried.len() > division.len() {
            narrower = tried;
        } else {
            wide = middle;
        }
    }
    Some(narrower)
}
