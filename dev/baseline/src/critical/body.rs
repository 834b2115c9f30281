//! Test of whether two parts overlap at one configuration by more than a contact allows.

use core::f64::consts::TAU;

use cspace::{Edge, Point, Rotation, Vector};

use super::outline::Outline;
use super::tolerance::DEPTH;

/// Edge with cached data.
#[derive(Debug, Clone, Copy)]
struct Curve {
    start: Point,
    end: Point,
    /// Data of an arc: centre, radius, direction to the start, angle travelled.
    arc: Option<(Point, f64, f64, f64)>,
    low: Point,
    high: Point,
}

/// The boundary of a part.
#[derive(Debug, Clone)]
pub(super) struct Body {
    curves: Vec<Curve>,
    /// The middle and the start of each edge.
    points: Vec<Point>,
}

impl Curve {
    fn new(e: &Edge) -> Self {
        let arc = (!e.is_line()).then(|| {
            let c = e.center();
            (c, e.radius(), (e.start - c).angle(), e.sweep())
        });
        let mut curve = Self {
            start: e.start,
            end: e.end,
            arc,
            low: Point::new(e.start.x.min(e.end.x), e.start.y.min(e.end.y)),
            high: Point::new(e.start.x.max(e.end.x), e.start.y.max(e.end.y)),
        };
        curve.widen();
        curve
    }

    /// Makes the box large enough for an arc.
    fn widen(&mut self) {
        let Some((c, r, _, _)) = self.arc else { return };
        let axes = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        for direction in axes.map(|(x, y)| Vector::new(x, y)) {
            if self.place_on_arc(direction.angle()).is_some() {
                let p = c + direction * r;
                self.low = Point::new(self.low.x.min(p.x), self.low.y.min(p.y));
                self.high = Point::new(self.high.x.max(p.x), self.high.y.max(p.y));
            }
        }
    }

    /// Fraction of the arc at which it has a direction from its centre.
    fn place_on_arc(&self, angle: f64) -> Option<f64> {
        let (_, _, from, sweep) = self.arc?;
        let turned = (angle - from) * sweep.signum();
        let turned = turned - TAU * (turned / TAU).floor();
        (turned <= sweep.abs()).then(|| turned / sweep.abs())
    }

    fn point(&self, s: f64) -> Point {
        match self.arc {
            Some((c, r, from, sweep)) => c + Vector::from_angle(from + s * sweep) * r,
            None => self.start.lerp(self.end, s),
        }
    }

    fn placed(&self, turn: Rotation, angle: f64, by: Vector) -> Self {
        let place = |p: Point| Point::ORIGIN + turn * p.to_vector() + by;
        let (start, end) = (place(self.start), place(self.end));
        let mut curve = Self {
            start,
            end,
            arc: self
                .arc
                .map(|(c, r, from, s)| (place(c), r, from + angle, s)),
            low: Point::new(start.x.min(end.x), start.y.min(end.y)),
            high: Point::new(start.x.max(end.x), start.y.max(end.y)),
        };
        curve.widen();
        curve
    }

    fn is_near(&self, other: &Self) -> bool {
        let gap = DEPTH;
        self.low.x <= other.high.x + gap
            && other.low.x <= self.high.x + gap
            && self.low.y <= other.high.y + gap
            && other.low.y <= self.high.y + gap
    }

    fn distance(&self, p: Point) -> f64 {
        match self.arc {
            Some((c, r, _, _)) if self.place_on_arc((p - c).angle()).is_some() => {
                (p.distance(c) - r).abs()
            }
            Some(_) => p.distance(self.start).min(p.distance(self.end)),
            None => {
                let v = self.end - self.start;
                let s = ((p - self.start).dot(v) / v.length_squared()).clamp(0.0, 1.0);
                p.distance(self.start.lerp(self.end, s))
            }
        }
    }

    /// Parity of the crossings of a ray from p to +x with the curve.
    fn crosses_ray(&self, p: Point) -> bool {
        let Some((c, r, _, _)) = self.arc else {
            let (a, b) = (self.start, self.end);
            return (a.y > p.y) != (b.y > p.y)
                && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x;
        };
        if p.y < self.low.y || p.y > self.high.y || p.x > self.high.x {
            return false;
        }
        let dy = p.y - c.y;
        let half = ((r - dy) * (r + dy)).max(0.0).sqrt();
        let meets =
            |dx: f64| c.x + dx > p.x && self.place_on_arc(Vector::new(dx, dy).angle()).is_some();
        meets(half) != meets(-half)
    }

    /// Calls `take` with fractions of the curve at which it meets another, and more where they nearly coincide.
    fn meetings(&self, other: &Self, mut take: impl FnMut(f64)) {
        let ends = [other.start, other.end];
        match (self.arc, other.arc) {
            (None, None) => {
                let (v, w) = (self.end - self.start, other.end - other.start);
                let across = v.cross(w);
                let s = (other.start - self.start).cross(w) / across;
                if s.is_finite() {
                    take(s);
                }
                // Nearly parallel sides: where the other begins and ends.
                for p in ends {
                    take((p - self.start).dot(v) / v.length_squared());
                }
            }
            (None, Some((c, r, _, _))) => {
                let v = self.end - self.start;
                let foot = (c - self.start).dot(v) / v.length_squared();
                let off = self.start.lerp(self.end, foot).distance(c);
                let half = ((r - off) * (r + off)).max(0.0).sqrt() / v.length();
                take(foot - half);
                take(foot + half);
            }
            (Some((c, _, _, _)), None) => {
                let w = other.end - other.start;
                let foot = (c - other.start).dot(w) / w.length_squared();
                let near = other.start.lerp(other.end, foot);
                self.chord(near - c, w.unit(), &mut take);
            }
            (Some((c, r, _, _)), Some((d, q, _, _))) => {
                let v = d - c;
                let along = 0.5 * (v.length() + (r - q) * (r + q) / v.length());
                if along.is_finite() {
                    self.chord(v.unit() * along, v.unit().left(), &mut take);
                }
                for p in ends {
                    take_some(self.place_on_arc((p - c).angle()), &mut take);
                }
            }
        }
    }

    /// The arc's places on a line by its foot, from the centre, and its direction.
    fn chord(&self, foot: Vector, direction: Vector, take: &mut impl FnMut(f64)) {
        let Some((_, r, _, _)) = self.arc else { return };
        let half = (r * r - foot.length_squared()).max(0.0).sqrt();
        for h in [half, -half] {
            take_some(
                self.place_on_arc((foot + direction * h).angle()),
                &mut *take,
            );
        }
    }
}

fn take_some(place: Option<f64>, take: &mut impl FnMut(f64)) {
    if let Some(s) = place {
        take(s);
    }
}

impl Body {
    pub(super) fn new(outline: &Outline) -> Self {
        let curves: Vec<Curve> = outline.edges.iter().map(Curve::new).collect();
        let points = (curves.iter()).flat_map(|c| [c.start, c.point(0.5)]);
        Self {
            points: points.collect(),
            curves,
        }
    }

    /// Whether a point is inside, by more than the depth of touching.
    fn holds(&self, p: Point) -> bool {
        let inside = self.curves.iter().filter(|c| c.crosses_ray(p)).count() % 2 == 1;
        inside && self.curves.iter().all(|c| c.distance(p) > DEPTH)
    }

    /// Whether this part overlaps another, placed at p and turned: a point of either boundary is deep inside the other
    /// part.
    ///
    /// The other's edges are cut where they meet this boundary; each piece is inside or outside as a whole, which its
    /// middle determines. If none is inside, this part may be within the other.
    pub(super) fn overlaps(&self, other: &Self, p: Point, theta: f64, turn: Rotation) -> bool {
        let back = turn.inverse();
        let within = |q: &Point| other.holds(Point::ORIGIN + back * (*q - p));
        if self.points.iter().any(within) {
            return true;
        }
        let mut cuts = Vec::new();
        for curve in &other.curves {
            let curve = curve.placed(turn, theta, p.to_vector());
            cuts.clear();
            cuts.extend([0.0, 1.0]);
            for own in self.curves.iter().filter(|own| own.is_near(&curve)) {
                curve.meetings(own, |s| {
                    if (0.0..=1.0).contains(&s) {
                        cuts.push(s);
                    }
                });
            }
            cuts.sort_by(f64::total_cmp);
            let inside = |w: &[f64]| w[1] > w[0] && self.holds(curve.point(0.5 * (w[0] + w[1])));
            if cuts.windows(2).any(inside) {
                return true;
            }
        }
        false
    }
}
