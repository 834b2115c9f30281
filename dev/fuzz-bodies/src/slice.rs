//! Slices of random pairs.

use cspace::{Configuration, ContactSpace, Options, Slice, Slicer};
use cspace_oracle::{Case, Oracle};

use crate::draw::{Bytes, nearly_tied};
use crate::{Finding, area};

/// Largest product of the parts' numbers of edges; larger pairs take long and are left to other tests.
const MOST_EDGES: usize = 400;

/// A slice at a critical orientation is that a little above: 1e-7 rad beside a tangency. Nearer to contact than this share of
/// the size that may matter.
const CLEAR: f64 = 1e-6;

/// Largest distance between successive curves, as a share of the size: curves that nearly touch cross at a place known
/// only to the square root of the rounding.
const CLOSED: f64 = 1e-6;

/// Tolerance of areas, as a share of the square of the size: [`CLEAR`] times the boundary's length.
const SAME_AREA: f64 = 1e-4;

/// Half the width of the window (radians) of the contact space around the orientation.
const WINDOW: f64 = 0.02;

/// Number of positions asked beside curves, and anywhere.
const POSITIONS: usize = 12;

/// Distances from curves, as shares of the size.
const STEPS: [f64; 6] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 2e-6];

pub(crate) fn run(data: &[u8]) -> Result<u64, Finding> {
    let mut bytes = Bytes::new(data);
    let theta = bytes.orientation();
    let of_space = bytes.below(4) == 0;
    let Ok(case) = nearly_tied(&mut bytes) else {
        return Ok(0);
    };
    if case.fixed.edges().count() * case.moving.edges().count() > MOST_EDGES {
        return Ok(0);
    }
    let found = |said: String| Finding::new(said).about(&case.fixed, &case.moving, None);
    let slice = if of_space {
        let options = Options {
            window: Some((theta - WINDOW, theta + WINDOW)),
            ..Options::default()
        };
        let space = ContactSpace::compute(&case.fixed, &case.moving, &options)
            .map_err(|e| found(format!("no contact space about {theta:?}: {e}")))?;
        space.slice(theta)
    } else {
        Slicer::new(&case.fixed, &case.moving).slice(theta)
    };
    if slice.doubtful {
        return Ok(0);
    }
    let size = case.fixed.size().max(case.moving.size());
    closed(&slice, size)
        .and_then(|()| judge(&case, &slice, &mut bytes))
        .map_err(|said| {
            let of = if of_space {
                "of the space"
            } else {
                "from scratch"
            };
            found(format!("the slice {of} at {theta:?}: {said}"))
        })
}

/// Checks that every curve begins where the one before it ends.
fn closed(slice: &Slice, size: f64) -> Result<(), String> {
    for (i, curve) in slice.curves.iter().enumerate() {
        let Some(next) = slice.curves.get(curve.next as usize) else {
            return Err(format!("curve {i} is followed by none"));
        };
        let gap = curve.geometry.point(1.0).distance(next.geometry.point(0.0));
        if gap.is_nan() || gap > CLOSED * size {
            return Err(format!("curve {i} ends {gap:e} from where the next begins"));
        }
    }
    Ok(())
}

/// The area, and positions.
fn judge(case: &Case, slice: &Slice, bytes: &mut Bytes<'_>) -> Result<u64, String> {
    let oracle = Oracle::new(&case.fixed, &case.moving);
    let size = oracle.size();
    let area = area::blocked(slice, area::middle(&oracle, slice.theta));
    let (lo, hi) = area::bounds(&oracle, slice.theta);
    let slack = SAME_AREA * size * size;
    if area.is_nan() || area < lo - slack || area > hi + slack {
        return Err(format!(
            "the blocked area is {area:?}, it must be between {lo:?} and {hi:?}"
        ));
    }
    let mut judged = 2;
    for k in 0..POSITIONS {
        let p = if k % 3 < 2 && !slice.curves.is_empty() {
            let chosen = (bytes.share() * slice.curves.len() as f64) as usize;
            let curve = slice.curves[chosen.min(slice.curves.len() - 1)].geometry;
            let s = bytes.share();
            let step = bytes.one_of(&STEPS) * bytes.one_of(&[1.0, -1.0]);
            curve.point(s) + curve.free_normal(s) * (step * size)
        } else {
            let [dx, dy] = [0; 2].map(|_| size * (2.0 * bytes.share() - 1.0));
            area::middle(&oracle, slice.theta) + cspace::Vector::new(dx, dy)
        };
        if !p.is_finite() {
            return Err(format!("curve with a point {p:?}"));
        }
        let verdict = oracle.judge(Configuration::new(p.x, p.y, slice.theta));
        if verdict.margin <= CLEAR * size {
            continue;
        }
        judged += 1;
        if slice.is_free(p) == verdict.overlap {
            let right = if verdict.overlap { "blocked" } else { "free" };
            return Err(format!(
                "({:?}, {:?}) is {right} by {:e}",
                p.x, p.y, verdict.margin
            ));
        }
    }
    Ok(judged)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cspace::{Part, Vertex};

    #[test]
    fn wrong_slices_are_seen() {
        let square = |name: &str, r: f64| {
            let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
            Part::new(
                name,
                vec![corners.map(|(x, y)| Vertex::line(x, y)).to_vec()],
            )
            .unwrap()
        };
        let case = Case {
            fixed: square("fixed", 1.0),
            moving: square("moving", 0.5),
            window: None,
            notable: Vec::new(),
        };
        let judged = |slice: &Slice| judge(&case, slice, &mut Bytes::new(&[7; 400]));
        let right = Slice::compute(&case.fixed, &case.moving, 0.2);
        assert!(closed(&right, 2.0).is_ok());
        assert!(judged(&right).is_ok_and(|n| n > 4));
        let mut open = right.clone();
        open.curves[0].next = u32::MAX;
        assert!(closed(&open, 2.0).is_err());
        // A slice of a smaller moving part, and of another orientation.
        let smaller = Slice::compute(&case.fixed, &square("moving", 0.3), 0.2);
        assert!(judged(&smaller).is_err());
        let turned = Slice {
            theta: 0.2,
            ..Slice::compute(&case.fixed, &case.moving, 0.7)
        };
        assert!(judged(&turned).is_err());
    }
}
