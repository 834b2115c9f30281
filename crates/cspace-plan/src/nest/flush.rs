//! Orientations at which a part lies flush: an edge of it on one of the walls, line on line or arc in an arc of the same radius.

use core::f64::consts::{PI, TAU};

use cspace::{Edge, Part, Point, Rotation, Vector};

/// An edge of the part and one of the walls that lie on each other at an orientation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    pub(super) theta: f64,
    /// The edges, as drawn.
    pub(super) own: Edge,
    pub(super) wall: Edge,
    /// The number of the own edge.
    pub(super) number: usize,
}

/// Edges that lie flush at one orientation.
#[derive(Debug)]
pub(super) struct Flush {
    pub(super) theta: f64,
    pub(super) pairs: Vec<Pair>,
}

impl Pair {
    /// The length that can lie flush at most.
    pub(super) fn length(&self) -> f64 {
        self.own.length().min(self.wall.length())
    }

    /// Positions at which a corner of the one is on a corner of the other; between two of them nothing else changes than how much lies
    /// flush.
    pub(super) fn corners(&self, theta: f64) -> Vec<Point> {
        let turn = Rotation::by(theta);
        let on = |wall: Point, own: Point| wall - (turn * own).to_vector();
        match self.own.is_line() {
            true => vec![
                on(self.wall.end, self.own.start),
                on(self.wall.start, self.own.end),
            ],
            false => vec![on(self.wall.center(), self.own.center())],
        }
    }

    /// The position's coordinate along the outward normal of the wall, of lines.
    fn offset(&self, normal: Vector, theta: f64) -> f64 {
        let own = Rotation::by(theta) * self.own.start;
        normal.dot(self.wall.start - own)
    }
}

impl Flush {
    /// All orientations in (−π, π] at which edges lie flush, to a touching distance, those with the longest edges first.
    pub(super) fn all(walls: &[Edge], moving: &Part, touch: f64) -> Vec<Self> {
        let mut pairs: Vec<Pair> = Vec::new();
        for (number, own) in moving.edges().enumerate() {
            for &wall in walls {
                for theta in orientations(own, wall, touch) {
                    pairs.push(Pair {
                        theta: theta - TAU * (theta / TAU).round(),
                        own,
                        wall,
                        number,
                    });
                }
            }
        }
        pairs.sort_by(|a, b| a.theta.total_cmp(&b.theta));
        let same = touch / moving.size();
        let mut all: Vec<Self> = pairs
            .chunk_by(|a, b| b.theta - a.theta <= same)
            .map(|pairs| {
                // Of the longest edges, which say it best.
                let longest = pairs
                    .iter()
                    .max_by(|a, b| a.length().total_cmp(&b.length()));
                Self {
                    theta: longest.map_or(0.0, |p| p.theta),
                    pairs: pairs.to_vec(),
                }
            })
            .collect();
        all.sort_by(|a, b| {
            b.most()
                .total_cmp(&a.most())
                .then(a.theta.total_cmp(&b.theta))
        });
        all
    }

    /// The orientation, by whole turns, if it is one with another: an edge that lies flush does so at the other, to a touching distance.
    pub(super) fn beside(&self, theta: f64, touch: f64) -> Option<f64> {
        let near = self.theta + TAU * ((theta - self.theta) / TAU).round();
        let off = (near - theta).abs();
        let is_one = |p: &Pair| off * p.length() <= touch;
        self.pairs.iter().any(is_one).then_some(near)
    }

    /// The length that can lie flush at most: each edge on walls as long as it.
    pub(super) fn most(&self) -> f64 {
        let mut pairs: Vec<&Pair> = self.pairs.iter().collect();
        pairs.sort_by_key(|p| p.number);
        let of_edge = |pairs: &[&Pair]| -> f64 {
            let walls: f64 = pairs.iter().map(|p| p.wall.length()).sum();
            pairs.first().map_or(0.0, |p| p.own.length().min(walls))
        };
        pairs
            .chunk_by(|a, b| a.number == b.number)
            .map(of_edge)
            .sum()
    }

    /// Whether the part may fit exactly, without room to both sides: an arc fills an arc, two opposite edges are as far apart as their
    /// walls, or edges of which no two are opposite face all ways.
    pub(super) fn holds(&self, touch: f64) -> bool {
        let lines: Vec<(Vector, &Pair)> = (self.pairs.iter())
            .filter(|p| p.own.is_line())
            .map(|p| ((p.wall.end - p.wall.start).unit().right(), p))
            .collect();
        if lines.len() < self.pairs.len() {
            return true;
        }
        let mut is_between = false;
        for (i, &(n, p)) in lines.iter().enumerate() {
            for &(m, q) in &lines[..i] {
                if n.dot(m) < 0.0 && n.cross(m).abs() * p.length().min(q.length()) <= touch {
                    if (p.offset(n, self.theta) - q.offset(n, self.theta)).abs() <= touch {
                        return true;
                    }
                    is_between = true;
                }
            }
        }
        let mut sides: Vec<f64> = lines.iter().map(|(n, _)| n.angle()).collect();
        sides.sort_by(f64::total_cmp);
        let next = sides
            .iter()
            .copied()
            .skip(1)
            .chain(sides.first().map(|s| s + TAU));
        let widest = sides
            .iter()
            .zip(next)
            .map(|(a, b)| b - a)
            .fold(0.0, f64::max);
        !is_between && widest < PI
    }
}

/// Orientations at which two edges lie on each other: of lines one, of arcs those at which they begin together or end together.
fn orientations(own: Edge, wall: Edge, touch: f64) -> Vec<f64> {
    if own.is_line() != wall.is_line() {
        return Vec::new();
    }
    if own.is_line() {
        let (own, wall) = (own.end - own.start, wall.start - wall.end);
        return vec![wall.angle() - own.angle()];
    }
    if (own.signed_radius() + wall.signed_radius()).abs() > touch {
        return Vec::new();
    }
    let from = |edge: Edge, p: Point| (p - edge.center()).angle();
    vec![
        from(wall, wall.end) - from(own, own.start),
        from(wall, wall.start) - from(own, own.end),
    ]
}
