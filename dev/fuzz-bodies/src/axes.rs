//! Random pairs on fixed axes.

use cspace::fixed_axes::AxesError;
use cspace::{
    Axis, AxisMotion, Classification, Configuration, FixedAxesSpace, Point, Rotation, Vector,
};
use cspace_oracle::{Case, Oracle};

use crate::Finding;
use crate::draw::Bytes;

/// Number of positions asked of each space.
const POSITIONS: usize = 40;

/// Nearer to contact than this share of the size an answer does not count: the parts are turned about pivots some sizes
/// away, and a tie of critical values is known to its root only.
const CERTAIN: f64 = 1e-7;

/// A motion that favours ties: pivots on a lattice or at a vertex, directions at multiples of 15°, ranges or none.
fn axis(bytes: &mut Bytes<'_>, case: &Case) -> Axis {
    let axis = match bytes.below(8) {
        7 => return Axis::FIXED,
        0..=2 => Axis::prismatic(Vector::from_angle(bytes.orientation())),
        3 => {
            let part = if bytes.below(2) == 0 {
                &case.fixed
            } else {
                &case.moving
            };
            let corners: Vec<Point> = part.edges().map(|e| e.start).collect();
            let p = corners[bytes.below(corners.len())];
            Axis::revolute(Point::new(bytes.nudged(p.x), bytes.nudged(p.y)))
        }
        _ => Axis::revolute(Point::new(4.0 * bytes.unit(), 4.0 * bytes.unit())),
    };
    if bytes.below(3) > 0 {
        return axis;
    }
    let lo = bytes.orientation();
    axis.within(lo, lo + bytes.one_of(&[0.5, 1.0, 2.0, 3.0]))
}

/// Placement of a part after a motion: a turn and a shift.
fn place(axis: &Axis, t: f64) -> (f64, Vector) {
    match axis.motion {
        AxisMotion::Fixed => (0.0, Vector::ZERO),
        AxisMotion::Revolute { center } => {
            let c = center.to_vector();
            (t, c - Rotation::by(t) * c)
        }
        AxisMotion::Prismatic { direction } => (0.0, direction.unit() * t),
    }
}

/// The moving part's place in the fixed part's frame.
fn relative(axes: &[Axis; 2], [u, v]: [f64; 2]) -> Configuration {
    let (a, b) = (place(&axes[0], u), place(&axes[1], v));
    let shift = Rotation::by(-a.0) * (b.1 - a.1);
    Configuration::new(shift.x, shift.y, b.0 - a.0)
}

/// A motion in the range, or near what matters of it.
fn within(axis: &Axis, bytes: &mut Bytes<'_>, size: f64) -> f64 {
    let (lo, hi) = axis.range.unwrap_or(match axis.motion {
        AxisMotion::Prismatic { .. } => (-2.0 * size, 2.0 * size),
        AxisMotion::Revolute { .. } => (-3.2, 3.2),
        AxisMotion::Fixed => return 0.0,
    });
    lo + (hi - lo) * bytes.share()
}

/// Computes the space of the pair on random axes, and asks it.
pub(crate) fn run(case: &Case, bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let axes = [axis(bytes, case), axis(bytes, case)];
    let found = |said: String| {
        Finding::new(format!("{axes:?}: {said}")).about(&case.fixed, &case.moving, None)
    };
    let space = match FixedAxesSpace::compute(&case.fixed, axes[0], &case.moving, axes[1]) {
        Ok(space) => space,
        Err(AxesError::TooFar { .. } | AxesError::NearlyParallel { .. }) => return Ok(0),
        Err(error) => return Err(found(format!("no space: {error}"))),
    };
    let oracle = Oracle::new(&case.fixed, &case.moving);
    let mut judged = 0;
    for _ in 0..POSITIONS {
        let at = [&axes[0], &axes[1]].map(|a| within(a, bytes, oracle.size()));
        let verdict = oracle.judge(relative(&axes, at));
        if verdict.margin <= CERTAIN * oracle.size() {
            continue;
        }
        judged += 1;
        let expected = if verdict.overlap {
            Classification::Blocked
        } else {
            Classification::Free
        };
        match space.classify(at[0], at[1]) {
            Some(answer) if answer == expected => {}
            answer => {
                return Err(found(format!(
                    "{at:?} is {expected:?} by {:e}, not {answer:?}; {:?}",
                    verdict.margin,
                    space.statistics()
                )));
            }
        }
    }
    Ok(judged)
}
