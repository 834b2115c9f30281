//! From a part's loops to features and joints.

use core::f64::consts::{PI, TAU};

use super::inscribed::inscribed_disc;
use super::outline::{Feature, FeatureKind, FeatureName, Joint, Near, Outline, Shape};
use super::tolerance::{
    GROWTH, LARGEST_CIRCLE, MITRE, OVERSHOOT, OVERSHOOT_SEPARATION, SAME_CARRIER, SMOOTH, STRAIGHT,
};
use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Edge, Part};

/// An edge in the pair's frame, on its way to becoming a feature.
struct Piece {
    edge: Edge,
    /// `None` for a line.
    arc: Option<(Point, f64)>,
    /// Of a large arc.
    near: Option<Near>,
    start_direction: Vector,
    end_direction: Vector,
    sweep: f64,
}

/// How two consecutive edges meet.
enum Corner {
    /// Tangent, by the drawing or by what rounding can tell; then it may be beside the vertex where they are.
    Smooth {
        beside: bool,
    },
    Convex {
        turn: f64,
    },
    Concave {
        turn: f64,
    },
}

/// One end of an edge after growth: its joint and, for an arc, how far its sweep was lengthened.
#[derive(Clone, Copy)]
struct End {
    joint: u32,
    extra_sweep: f64,
}

impl Outline {
    /// Features of a part, about `center` and scaled, then grown.
    pub(crate) fn new(part: &Part, center: Point, scale: f64, growth: f64) -> Self {
        Self::grown_by(part, center, scale, |_| growth)
    }

    /// The same, each loop grown by a length of its own.
    pub(crate) fn grown_by(
        part: &Part,
        center: Point,
        scale: f64,
        growth: impl Fn(u32) -> f64,
    ) -> Self {
        let mut outline = Self {
            features: Vec::new(),
            joints: Vec::new(),
            feature_count: 0,
            disc: None,
        };
        for (loop_index, boundary) in part.loops().iter().enumerate() {
            let mut pieces: Vec<Piece> = boundary
                .edges()
                .map(|e| Piece::new(&e, center, scale))
                .collect();
            share_direction_along_lines(&mut pieces);
            let loop_index = loop_index as u32;
            let growth = growth(loop_index);
            outline.add_loop(loop_index, &pieces, boundary.is_reversed(), growth);
        }
        outline.disc = inscribed_disc(part, center, scale);
        outline
    }

    /// By how much a part's sharpest corner sticks out for each unit that its sides are grown by.
    pub(crate) fn longest_mitre(part: &Part, center: Point, scale: f64) -> f64 {
        let mut longest = 1.0_f64;
        for boundary in part.loops() {
            let pieces: Vec<Piece> = boundary
                .edges()
                .map(|e| Piece::new(&e, center, scale))
                .collect();
            for (i, before) in pieces.iter().enumerate() {
                if let Corner::Convex { turn } = corner(before, &pieces[(i + 1) % pieces.len()]) {
                    longest = longest.max(1.0 / (0.5 * turn).cos().max(1.0 / MITRE));
                }
            }
        }
        longest
    }

    fn add_loop(&mut self, loop_index: u32, pieces: &[Piece], reversed: bool, growth: f64) {
        let n = pieces.len();
        self.feature_count += n;
        let mut starts = vec![
            End {
                joint: 0,
                extra_sweep: 0.0
            };
            n
        ];
        let mut ends = starts.clone();
        let mut vertices = Vec::new();
        for i in 0..n {
            let j = (i + 1) % n;
            let (before, after) = (&pieces[i], &pieces[j]);
            let point = before.edge.end;
            let (n1, n2) = (before.end_direction.right(), after.start_direction.right());
            match corner(before, after) {
                Corner::Smooth { beside } => {
                    let (point, normal) = tangency(before, after, beside);
                    let joint = self.add_joint(point + normal * growth, normal);
                    ends[i] = End {
                        joint,
                        extra_sweep: 0.0,
                    };
                    starts[j] = ends[i];
                }
                Corner::Convex { turn } => {
                    self.feature_count += 1;
                    let apex = mitre(point, n1, n2, growth);
                    let first = self.add_joint(apex, before.normal_at(apex, n1, growth));
                    let second = self.add_joint(apex, after.normal_at(apex, n2, growth));
                    ends[i] = End {
                        joint: first,
                        extra_sweep: 0.0,
                    };
                    starts[j] = End {
                        joint: second,
                        extra_sweep: 0.0,
                    };
                    // The vertex is the one `after` leaves as given, or `before` if travelled backwards.
                    let index = if reversed { before } else { after }.edge.index as u32;
                    vertices.push((first, second, turn, index));
                }
                Corner::Concave { turn } => {
                    self.feature_count += 1;
                    let further = OVERSHOOT * GROWTH + OVERSHOOT_SEPARATION / turn.abs().min(1.0);
                    // Not beyond the middle of the other edge, under which it runs.
                    let under = |other: &Piece| further.min(0.5 * other.edge.length());
                    ends[i] = self.carry_on(before, point, n1, growth, under(after));
                    starts[j] = self.carry_on(after, point, n2, growth, -under(before));
                }
            }
        }
        for (i, piece) in pieces.iter().enumerate() {
            self.add_edge(loop_index, piece, starts[i], ends[i], growth);
        }
        for (start, end, turn, index) in vertices {
            let lo = self.joints[start as usize].angle;
            let hi = unwrap_near(self.joints[end as usize].angle, lo + turn);
            self.features.push(Feature {
                shape: Shape::Round {
                    center: self.joints[start as usize].point,
                    radius: 0.0,
                },
                near: None,
                lo,
                hi: hi.max(lo),
                start,
                end,
                name: FeatureName {
                    kind: FeatureKind::Vertex,
                    loop_index,
                    index,
                },
            });
        }
    }

    fn add_edge(&mut self, loop_index: u32, piece: &Piece, start: End, end: End, growth: f64) {
        let start_joint = self.joints[start.joint as usize];
        let end_joint = self.joints[end.joint as usize];
        let (shape, kind, lo, hi) = match piece.arc {
            None => {
                // The joints of a line carry its normal, unless two lines meet smoothly; then the first one's rules.
                let normal = start_joint.normal;
                let angle = start_joint.angle;
                (Shape::Line { normal }, FeatureKind::Line, angle, angle)
            }
            Some((center, radius)) => {
                let radius = radius + growth;
                let shape = Shape::Round { center, radius };
                let sweep =
                    piece.sweep + (start.extra_sweep + end.extra_sweep) * piece.sweep.signum();
                let from = start_joint.angle;
                let to = unwrap_near(end_joint.angle, from + sweep);
                if piece.sweep > 0.0 {
                    (shape, FeatureKind::ConvexArc, from, to)
                } else {
                    // Travelled with decreasing normal: the canonical angle is the start's, the upper one.
                    (shape, FeatureKind::ConcaveArc, to, from)
                }
            }
        };
        let near = piece.near.map(|n| Near {
            point: n.point + n.normal * growth,
            ..n
        });
        self.features.push(Feature {
            shape,
            near,
            lo,
            hi,
            start: start.joint,
            end: end.joint,
            name: FeatureName {
                kind,
                loop_index,
                index: piece.edge.index as u32,
            },
        });
    }

    fn add_joint(&mut self, point: Point, normal: Vector) -> u32 {
        let angle = normal.angle();
        self.joints.push(Joint {
            point,
            normal,
            angle,
        });
        (self.joints.len() - 1) as u32
    }

    /// The end of an edge in a concave corner, carried on by `further` (backwards when negative).
    fn carry_on(
        &mut self,
        piece: &Piece,
        point: Point,
        normal: Vector,
        growth: f64,
        further: f64,
    ) -> End {
        match piece.arc {
            None => End {
                joint: self.add_joint(point + normal * growth + normal.left() * further, normal),
                extra_sweep: 0.0,
            },
            Some((center, radius)) => {
                let radius = radius + growth;
                // Travel turns the normal by length / signed radius; never by more than what closes the circle.
                let room = 0.25 * (TAU - piece.sweep.abs()).max(0.0);
                let by = (further / radius).clamp(-room, room);
                let turned = Rotation::by(by) * normal;
                let end = if piece.near.is_some() {
                    let (sin, half) = (by.sin(), (0.5 * by).sin());
                    let way = normal.left() * sin + normal * (-2.0 * half * half);
                    point + normal * growth + way * radius
                } else {
                    center + turned * radius
                };
                End {
                    joint: self.add_joint(end, turned),
                    extra_sweep: by.abs(),
                }
            }
        }
    }
}

impl Piece {
    fn new(edge: &Edge, center: Point, scale: f64) -> Self {
        let place = |p: Point| Point::ORIGIN + (p - center) * scale;
        let mut edge = Edge {
            start: place(edge.start),
            end: place(edge.end),
            ..*edge
        };
        let sweep = edge.sweep();
        let height = 0.5 * edge.bulge.abs() * edge.start.distance(edge.end);
        if sweep.abs() < STRAIGHT || (sweep.abs() < SMOOTH && height < SAME_CARRIER) {
            edge.bulge = 0.0;
        }
        let arc = (!edge.is_line()).then(|| (edge.center(), edge.radius() * edge.bulge.signum()));
        let near = arc.filter(|a| a.1.abs() > LARGEST_CIRCLE).map(|_| {
            let chord = edge.end - edge.start;
            Near {
                point: edge.start.midpoint(edge.end) + chord.right() * (0.5 * edge.bulge),
                normal: chord.unit().right(),
            }
        });
        Self {
            edge,
            arc,
            near,
            start_direction: edge.start_direction(),
            end_direction: edge.end_direction(),
            sweep: edge.sweep(),
        }
    }

    /// The normal with which this edge ends at a grown corner.
    fn normal_at(&self, apex: Point, normal: Vector, growth: f64) -> Vector {
        match (self.arc, self.near) {
            (Some((_, radius)), Some(_)) => {
                // From the end of the edge along its tangent: little, but for the mitre of a sharp corner.
                let ends = [self.edge.start, self.edge.end];
                let near = |p: &Point| p.distance(apex);
                let end = if near(&ends[0]) < near(&ends[1]) {
                    ends[0]
                } else {
                    ends[1]
                };
                let along = normal.left();
                (normal + along * (along.dot(apex - end) / radius)).unit()
            }
            (Some((center, radius)), None) if growth > 0.0 => {
                (apex - center).unit() * radius.signum()
            }
            _ => normal,
        }
    }

    fn curvature(&self) -> f64 {
        self.arc.map_or(0.0, |(_, radius)| 1.0 / radius)
    }
}

/// Lines that follow each other smoothly share one direction, that of the first.
fn share_direction_along_lines(pieces: &mut [Piece]) {
    let n = pieces.len();
    let smooth_lines = |before: &Piece, after: &Piece| {
        before.arc.is_none()
            && after.arc.is_none()
            && matches!(corner(before, after), Corner::Smooth { .. })
    };
    let Some(first) = (0..n).find(|&i| !smooth_lines(&pieces[(i + n - 1) % n], &pieces[i])) else {
        return;
    };
    for step in 1..n {
        let (i, j) = ((first + step - 1) % n, (first + step) % n);
        if smooth_lines(&pieces[i], &pieces[j]) {
            let direction = pieces[i].end_direction;
            pieces[j].start_direction = direction;
            pieces[j].end_direction = direction;
        }
    }
}

fn corner(before: &Piece, after: &Piece) -> Corner {
    let (d1, d2) = (before.end_direction, after.start_direction);
    let turn = d1.cross(d2).atan2(d1.dot(d2));
    let beside = run_alike(before, after, turn);
    if beside || turn.abs() < smooth(before, after) {
        return Corner::Smooth { beside };
    }
    if turn.abs() > PI - SMOOTH {
        // A cusp: material lies between the edges if the one arriving, seen backwards, bends further left.
        return if -before.curvature() > after.curvature() {
            Corner::Convex { turn: PI }
        } else {
            Corner::Concave { turn: -PI }
        };
    }
    if turn > 0.0 {
        Corner::Convex { turn }
    } else {
        Corner::Concave { turn }
    }
}

/// Below which angle two edges are joined smoothly: what that changes is of the second order, times the radius; of two lines
/// it is of the first, times their length.
fn smooth(before: &Piece, after: &Piece) -> f64 {
    if before.arc.is_none() && after.arc.is_none() {
        return 2.0 * STRAIGHT;
    }
    let radius = |p: &Piece| match (p.near, p.arc) {
        (Some(_), Some((_, radius))) => radius.abs(),
        _ => 1.0,
    };
    SMOOTH / radius(before).max(radius(after)).sqrt()
}

/// Whether nothing is lost by taking two carriers that meet at a small angle to meet smoothly where they run alike.
///
/// Curvatures that differ by κ run alike δ/κ beside a corner that turns by δ, where they are δ²/2κ off each other, and cross
/// again twice as far away. Less than [`SAME_CARRIER`] is no corner: rounding would not tell one crossing from the other.
fn run_alike(before: &Piece, after: &Piece, turn: f64) -> bool {
    /// The largest part of an edge by which its end may be moved.
    const LARGEST_PART: f64 = 1.0 / 1024.0;
    let bend = (after.curvature() - before.curvature()).abs();
    let along = turn.abs() / bend;
    let shortest = before.edge.length().min(after.edge.length());
    0.5 * turn.abs() * along <= SAME_CARRIER && along <= LARGEST_PART * shortest
}

/// Where two edges that meet smoothly are tangent, and the normal there: the line's, if there is one, or that of both arcs.
///
/// Where a drawing was rounded that is `beside` the vertex, and it is the place at which contact curves of both edges end.
fn tangency(before: &Piece, after: &Piece, beside: bool) -> (Point, Vector) {
    let vertex = before.edge.end;
    let (d1, d2) = (before.end_direction, after.start_direction);
    let on_line = |arc: &Piece, (center, radius): (Point, f64), direction: Vector| {
        let normal = direction.right();
        if !beside {
            return (vertex, normal);
        }
        let at = match arc.near {
            Some(near) => near.point + (normal - near.normal) * radius,
            None => center + normal * radius,
        };
        (vertex + direction * direction.dot(at - vertex), normal)
    };
    match (before.arc, after.arc) {
        (None, None) => (vertex, d1.right()),
        (None, Some(arc)) => on_line(after, arc, d1),
        (Some(arc), None) => on_line(before, arc, d2),
        (Some((c, r)), Some((d, s))) => {
            if !beside {
                return (vertex, d2.right());
            }
            // Normals that differ by a turn δ at the vertex agree δ / (κ₁ − κ₂) further on. The line of centres tells the same,
            // but nothing where both arcs are of one circle.
            let turn = d1.cross(d2).atan2(d1.dot(d2));
            let further = turn / (before.curvature() - after.curvature());
            let normal = Rotation::by(before.curvature() * further) * d1.right();
            match (before.near, after.near) {
                (None, _) => (c + normal * r, normal),
                // The smaller one knows the place best; of large ones the normal hardly turns.
                (_, None) => (d + normal * s, normal),
                _ => (vertex, d2.right()),
            }
        }
    }
}

/// The corner of two carriers that are both moved outward by `growth`: V + g (n₁ + n₂) / (1 + n₁·n₂).
fn mitre(point: Point, n1: Vector, n2: Vector, growth: f64) -> Point {
    if growth == 0.0 {
        return point;
    }
    let sum = n1 + n2;
    let reach = 1.0 + n1.dot(n2);
    // |n₁ + n₂|² = 2 (1 + n₁·n₂), so the mitre's length is g √(2 / reach).
    if 2.0 > MITRE * MITRE * reach {
        return point + n1.left() * (growth * MITRE);
    }
    point + sum * (growth / reach)
}

/// The angle that differs from `angle` by whole turns and is nearest to `near`.
pub(crate) fn unwrap_near(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}
