//! The curve that sheets share at one orientation, and cells on it.

use core::f64::consts::PI;

use crate::contact::{Carrier, FlatArc, Sheet};
use crate::feature::tolerance::SHORTEST_OVERLAP;
use crate::geometry::{Point, Rotation, Vector, wrap};

use crate::general::broad::covering::Covering;

/// The common curve: a line through a point, or a circle; with the coordinate along it. A large circle is told by a point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Track {
    Line {
        normal: Vector,
    },
    Circle {
        center: Point,
        radius: f64,
        zero: f64,
    },
    FlatArc(FlatArc<f64>),
}

/// A cell that touches the level, as a range of the coordinate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) cell: u32,
    pub(crate) mid: f64,
    pub(crate) half: f64,
    /// Errors of its ends, in the order of the coordinate.
    pub(crate) errors: (f64, f64),
    /// Whether its free side is that of the track.
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
    pub(crate) fn new(track: &Track, on: Point, coordinate: f64) -> Self {
        let point = track.point(on, coordinate);
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

    /// Whether it covers a place with more to spare than its errors.
    pub(crate) fn certainly_covers(&self, track: &Track, place: f64) -> bool {
        let off = track.difference(place, self.mid);
        off - self.errors.0 > -self.half && off + self.errors.1 < self.half
    }
}

impl Track {
    /// The curve of a sheet at an orientation, all of the line or circle.
    pub(crate) fn of(sheet: &Sheet, turn: Rotation) -> Self {
        match sheet.carrier(turn.cos, turn.sin) {
            Carrier::Line { normal, .. } => Self::Line {
                normal: Vector::new(normal.0, normal.1),
            },
            Carrier::Circle { center, radius } => {
                let center = Point::new(center.0, center.1);
                Self::Circle {
                    center,
                    radius,
                    zero: (sheet.start.at(turn) - center).angle(),
                }
            }
            Carrier::FlatArc(arc) => Self::FlatArc(arc),
        }
    }

    /// The coordinates at which a circle is cut open, where they jump.
    pub(crate) fn cuts(&self) -> Option<[f64; 2]> {
        match *self {
            Self::Line { .. } | Self::FlatArc(_) => None,
            Self::Circle { radius, .. } => {
                let half_turn = PI * radius.abs();
                Some([-half_turn, half_turn])
            }
        }
    }

    /// Of a sheet on it with a normal at a point: whether its free side is that of the track, and whether its travel goes
    /// with the coordinate. On a line that does if the normals agree, on a circle if the radius is positive.
    pub(crate) fn ways(&self, sheet: &Sheet, normal: Vector, p: Point) -> (bool, bool) {
        match *self {
            Self::Line { .. } | Self::FlatArc(_) => {
                let along = self.normal(p).dot(normal) > 0.0;
                (along, along)
            }
            Self::Circle { radius, .. } => {
                let forward = sheet.radius > 0.0;
                (forward == (radius > 0.0), forward)
            }
        }
    }

    pub(crate) fn coordinate(&self, p: Point) -> f64 {
        match *self {
            Self::Line { normal } => normal.left().dot(p - Point::ORIGIN),
            Self::Circle {
                center,
                radius,
                zero,
            } => wrap((p - center).angle() - zero) * radius.abs(),
            Self::FlatArc(arc) => arc.place(p),
        }
    }

    /// The point at a coordinate, given one of a line.
    pub(crate) fn point(&self, on: Point, coordinate: f64) -> Point {
        match *self {
            Self::Line { normal } => {
                let along = normal.left();
                on + along * (coordinate - along.dot(on - Point::ORIGIN))
            }
            Self::Circle {
                center,
                radius,
                zero,
            } => center + Vector::from_angle(zero + coordinate / radius.abs()) * radius.abs(),
            Self::FlatArc(arc) => arc.point(coordinate),
        }
    }

    /// The normal at a point of it.
    pub(crate) fn normal(&self, p: Point) -> Vector {
        match *self {
            Self::Line { normal } => normal,
            Self::Circle { center, radius, .. } => (p - center) * (1.0 / radius),
            Self::FlatArc(arc) => arc.normal_at(p),
        }
    }

    /// Which pieces may cover a place. One that reaches over the place where a circle is cut open may cover any.
    pub(crate) fn covering(&self, pieces: &[Piece]) -> Covering {
        /// Rounding of an end, of a piece or of the circle: pieces cover a little less than this makes them.
        const SLACK: f64 = SHORTEST_OVERLAP;
        let (lowest, highest) = match *self {
            Self::Line { .. } | Self::FlatArc(_) => (f64::NEG_INFINITY, f64::INFINITY),
            Self::Circle { radius, .. } => {
                let half_turn = PI * radius.abs() - SLACK;
                (-half_turn, half_turn)
            }
        };
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
        match *self {
            Self::Line { .. } | Self::FlatArc(_) => a - b,
            Self::Circle { radius, .. } => wrap((a - b) / radius.abs()) * radius.abs(),
        }
    }
}
