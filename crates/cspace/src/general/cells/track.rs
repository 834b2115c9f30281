//! The curve that sheets share at one orientation, and cells on it.

use core::f64::consts::PI;

use crate::contact::{Cycle, Sheet};
use crate::feature::tolerance::SHORTEST_OVERLAP;
use crate::geometry::{Point, Rotation, Vector, wrap};

use crate::general::broad::covering::Covering;

/// The common line or circle, with the coordinate along it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Track {
    cycle: Cycle,
    /// Direction of the coordinate 0 from the centre, radians; only for a circle given by its centre.
    zero: f64,
}

/// A cell that touches the level, as a range of the coordinate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) cell: u32,
    pub(crate) mid: f64,
    pub(crate) half: f64,
    /// Errors of its ends, in the order of the coordinate.
    pub(crate) errors: (f64, f64),
    /// Whether its free side is the track's.
    pub(crate) along: bool,
}

/// A place on a track.
pub(crate) struct Place {
    pub(crate) coordinate: f64,
    pub(crate) point: Point,
    /// The track's normal there.
    pub(crate) normal: Vector,
}

impl Place {
    pub(crate) fn new(track: &Track, coordinate: f64) -> Self {
        let point = track.point(coordinate);
        Self {
            coordinate,
            point,
            normal: track.normal(point),
        }
    }
}

impl Piece {
    pub(crate) fn covers(&self, track: &Track, place: f64) -> bool {
        track.difference(place, self.mid).abs() < self.half
    }

    /// Whether it covers a place with a margin above the errors of its ends.
    pub(crate) fn certainly_covers(&self, track: &Track, place: f64) -> bool {
        let off = track.difference(place, self.mid);
        off - self.errors.0 > -self.half && off + self.errors.1 < self.half
    }
}

impl Track {
    /// The curve of a sheet at an orientation, all of the line or circle.
    pub(crate) fn of(sheet: &Sheet, turn: Rotation) -> Self {
        let cycle: Cycle = sheet.cycle(turn);
        if cycle.is_line() {
            // Lines through different points of one line get the same coordinates.
            let foot = Point::ORIGIN + cycle.normal * -cycle.level(Point::ORIGIN);
            return Self {
                cycle: Cycle::line(foot, cycle.normal),
                zero: 0.0,
            };
        }
        let zero = (sheet.locus.start.at(turn) - cycle.through).angle();
        Self { cycle, zero }
    }

    /// Half the length of a circle given by its centre; infinite for an open curve.
    fn half(&self) -> f64 {
        if self.cycle.is_centred() {
            PI * self.cycle.size
        } else {
            f64::INFINITY
        }
    }

    /// The coordinates at which a circle is cut, where they jump.
    pub(crate) fn cuts(&self) -> Option<[f64; 2]> {
        let half = self.half();
        half.is_finite().then_some([-half, half])
    }

    /// Two flags for a sheet on the track with a given normal at a point: whether its free side is the track's, and whether its direction
    /// of travel is that of the coordinate. On a line, both hold if the normals agree; on a circle, the second if the radius is positive.
    pub(crate) fn ways(&self, sheet: &Sheet, normal: Vector, p: Point) -> (bool, bool) {
        if self.cycle.is_centred() {
            let forward = sheet.locus.carrier.radius > 0.0;
            return (forward == (self.cycle.weight > 0.0), forward);
        }
        let along = self.normal(p).dot(normal) > 0.0;
        (along, along)
    }

    pub(crate) fn coordinate(&self, p: Point) -> f64 {
        if self.cycle.is_centred() {
            return wrap((p - self.cycle.through).angle() - self.zero) * self.cycle.size;
        }
        self.cycle.place(p).x
    }

    /// The point at a coordinate.
    pub(crate) fn point(&self, coordinate: f64) -> Point {
        if self.cycle.is_centred() {
            let angle = self.zero + coordinate / self.cycle.size;
            return self.cycle.through + Vector::from_angle(angle) * self.cycle.size;
        }
        self.cycle.at(Vector::new(coordinate, 0.0))
    }

    /// The normal at a point of it.
    pub(crate) fn normal(&self, p: Point) -> Vector {
        self.cycle.normal_at(p)
    }

    /// Index of the pieces that may cover a place. A piece across the cut of a circle may cover any place.
    pub(crate) fn covering(&self, pieces: &[Piece]) -> Covering {
        /// Rounding of an end of a piece or of the circle: pieces are extended by this.
        const SLACK: f64 = SHORTEST_OVERLAP;
        let highest = self.half() - SLACK;
        let lowest = -highest;
        Covering::new(pieces.iter().map(|p| {
            let mid = self.difference(p.mid, 0.0);
            let (from, to) = (mid - p.half - SLACK, mid + p.half + SLACK);
            if lowest < from && to < highest {
                (from, to)
            } else {
                (f64::NEG_INFINITY, f64::INFINITY)
            }
        }))
    }

    pub(crate) fn difference(&self, a: f64, b: f64) -> f64 {
        if self.cycle.is_centred() {
            return wrap((a - b) / self.cycle.size) * self.cycle.size;
        }
        a - b
    }
}
