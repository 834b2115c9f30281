//! A piece of a way: straight through free space, or along a patch, at some height above it.

use cspace::CurveGeometry;

use crate::legs::Coords;

use super::planar::Planar;

/// A place on a patch: its orientation, in the numbering of the patch, and the share of its contact curve, 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Station {
    pub(crate) theta: f64,
    pub(crate) share: f64,
}

/// A way across a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Across {
    pub(crate) patch: u32,
    /// What is added to the patch's orientations along the way: whole turns.
    pub(crate) turn: f64,
    pub(crate) entry: Station,
    pub(crate) exit: Station,
}

/// A piece of a way, run through by a parameter from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Piece<'a> {
    /// Straight.
    Straight { from: Coords, to: Coords },
    /// Above a patch.
    Above {
        planar: &'a Planar<'a>,
        across: Across,
    },
    /// Between the curves that bound a gap of a pair with fixed axes.
    Gap(super::gaps::Through<'a>),
}

impl Piece<'_> {
    /// The configuration at a parameter, at a share of the height that a patch allows.
    pub(crate) fn at(&self, s: f64, height: f64) -> Coords {
        match self {
            Self::Straight { from, to } => along(*from, *to, s),
            Self::Above { planar, across } => {
                let station = across.station(planar, s);
                planar.lifted(across, station, height)
            }
            Self::Gap(gap) => gap.at(s),
        }
    }
}

/// The configuration at a share of a leg.
pub(crate) fn along(from: Coords, to: Coords, s: f64) -> Coords {
    core::array::from_fn(|k| from[k] + (to[k] - from[k]) * s)
}

impl Across {
    /// From the entry to the middle of the patch and to the exit: the edges of a patch are places where little is free.
    fn station(&self, planar: &Planar<'_>, s: f64) -> Station {
        /// The middle keeps this share of the orientations away from both ends.
        const MARGIN: f64 = 0.1;
        let patch = &planar.space().patches()[self.patch as usize];
        let margin = MARGIN * (patch.hi - patch.lo);
        let middle = Station {
            theta: (0.5 * (self.entry.theta + self.exit.theta))
                .clamp(patch.lo + margin, patch.hi - margin),
            share: 0.5,
        };
        let (a, b, t) = if s <= 0.5 {
            (self.entry, middle, 2.0 * s)
        } else {
            (middle, self.exit, 2.0 * s - 1.0)
        };
        Station {
            theta: a.theta + (b.theta - a.theta) * t,
            share: a.share + (b.share - a.share) * t,
        }
    }
}

/// The share of a curve at which it is nearest to a point of it.
pub(crate) fn share_of(curve: &CurveGeometry, at: cspace::Point) -> f64 {
    use core::f64::consts::TAU;
    let on_chord = |start: cspace::Point, end: cspace::Point| {
        let way = end - start;
        let share = (at - start).dot(way) / way.length_squared();
        if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
    };
    match *curve {
        CurveGeometry::Arc {
            center,
            start_angle,
            sweep,
            ..
        } => {
            let turned = ((at - center).angle() - start_angle) * sweep.signum();
            let turned = turned - TAU * (turned / TAU).floor();
            let whole = sweep.abs();
            if turned <= whole {
                turned / whole
            } else if turned - whole < TAU - turned {
                1.0
            } else {
                0.0
            }
        }
        CurveGeometry::Segment { start, end } | CurveGeometry::FlatArc { start, end, .. } => {
            on_chord(start, end)
        }
    }
}
