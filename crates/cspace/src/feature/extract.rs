//! From a part's loops to features and joints.

use core::f64::consts::{PI, TAU};

use super::generic::{ExactVertex, made_generic};
use super::inscribed::inscribed_disc;
use super::perturbation::Perturbation;
use super::tolerance::{
    GROWTH, LARGEST_CIRCLE, MITRE, OVERSHOOT, OVERSHOOT_SEPARATION, SAME_CARRIER, SMOOTH, STRAIGHT,
};
use super::types::{
    ExactJoint, ExactRound, Feature, FeatureKind, FeatureName, Joint, Near, Outline, Shape,
};
use crate::geometry::{Point, Vector, unwrap_near};
use crate::number::Dd;
use crate::number::plane::{
    Xy, cross, dot, left, length, minus, negative, plus, right, rounded, times, turned,
};
use crate::part::{Edge, Part};

/// An edge in the pair's frame, on its way to becoming a feature.
struct Piece {
    edge: Edge,
    start: Xy<Dd>,
    end: Xy<Dd>,
    /// `None` for a line.
    arc: Option<(Xy<Dd>, Dd)>,
    /// Of a large arc.
    near: Option<Near>,
    start_direction: Xy<Dd>,
    end_direction: Xy<Dd>,
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
        Self::grown_by(part, center, scale, |_| growth, None)
    }

    /// The same, each loop grown by a length of its own, after the part was made generic.
    pub(crate) fn grown_by(
        part: &Part,
        center: Point,
        scale: f64,
        growth: impl Fn(u32) -> f64,
        perturbation: Option<&Perturbation<'_>>,
    ) -> Self {
        let mut outline = Self {
            features: Vec::new(),
            joints: Vec::new(),
            exact_features: Vec::new(),
            exact_joints: Vec::new(),
            feature_count: 0,
            disc: None,
        };
        let mut wishes = perturbation.map(|p| p.wishes(part)).unwrap_or_default();
        for (loop_index, boundary) in part.loops().iter().enumerate() {
            let mut pieces: Vec<Piece> = boundary
                .edges()
                .map(|e| Piece::new(&e, center, scale))
                .collect();
            if let Some(wishes) = wishes.get_mut(loop_index) {
                pieces = generic(&pieces, wishes).unwrap_or(pieces);
            }
            straightened(&mut pieces);
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
            let point = before.end;
            let (n1, n2) = (right(before.end_direction), right(after.start_direction));
            let grown = |normal: Xy<Dd>| plus(point, times(normal, Dd::from(growth)));
            match corner(before, after) {
                Corner::Smooth { beside } => {
                    let (point, normal) = tangency(before, after, beside);
                    let place = plus(point, times(normal, Dd::from(growth)));
                    let joint = self.add_joint(place, normal);
                    ends[i] = End {
                        joint,
                        extra_sweep: 0.0,
                    };
                    starts[j] = ends[i];
                }
                Corner::Convex { turn } => {
                    self.feature_count += 1;
                    let apex = mitre(before, after, n1, n2, growth);
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
                    ends[i] = self.carry_on(before, grown(n1), n1, growth, under(after));
                    starts[j] = self.carry_on(after, grown(n2), n2, growth, -under(before));
                }
            }
        }
        for (i, piece) in pieces.iter().enumerate() {
            self.add_edge(loop_index, piece, starts[i], ends[i], growth);
        }
        for (start, end, turn, index) in vertices {
            let lo = self.joints[start as usize].angle;
            let hi = unwrap_near(self.joints[end as usize].angle, lo + turn);
            self.exact_features.push(ExactRound {
                center: self.exact_joints[start as usize].point,
                radius: Dd::ZERO,
            });
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
        let exact = match piece.arc {
            None => ExactRound {
                center: (Dd::ZERO, Dd::ZERO),
                radius: Dd::ZERO,
            },
            Some((center, radius)) => ExactRound {
                center,
                radius: radius + growth,
            },
        };
        self.exact_features.push(exact);
        let (shape, kind, lo, hi) = if piece.arc.is_none() {
            // The joints of a line carry its normal, unless two lines meet smoothly; then the first one's rules.
            let normal = start_joint.normal;
            let angle = start_joint.angle;
            (Shape::Line { normal }, FeatureKind::Line, angle, angle)
        } else {
            let (x, y) = rounded(exact.center);
            let shape = Shape::Round {
                center: Point::new(x, y),
                radius: exact.radius.to_f64(),
            };
            let sweep = piece.sweep + (start.extra_sweep + end.extra_sweep) * piece.sweep.signum();
            let from = start_joint.angle;
            let to = unwrap_near(end_joint.angle, from + sweep);
            if piece.sweep > 0.0 {
                (shape, FeatureKind::ConvexArc, from, to)
            } else {
                // Travelled with decreasing normal: the canonical angle is the start's, the upper one.
                (shape, FeatureKind::ConcaveArc, to, from)
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

    fn add_joint(&mut self, point: Xy<Dd>, normal: Xy<Dd>) -> u32 {
        let angle = Dd::atan2(normal.1, normal.0);
        self.exact_joints.push(ExactJoint {
            point,
            normal,
            angle,
        });
        let ((x, y), (u, v)) = (rounded(point), rounded(normal));
        self.joints.push(Joint {
            point: Point::new(x, y),
            normal: Vector::new(u, v),
            angle: angle.to_f64(),
        });
        (self.joints.len() - 1) as u32
    }

    /// The end of an edge in a concave corner, `point` of it as grown, carried on by `further` (backwards when negative).
    fn carry_on(
        &mut self,
        piece: &Piece,
        point: Xy<Dd>,
        normal: Xy<Dd>,
        growth: f64,
        further: f64,
    ) -> End {
        match piece.arc {
            None => End {
                joint: self.add_joint(plus(point, times(left(normal), Dd::from(further))), normal),
                extra_sweep: 0.0,
            },
            Some((center, radius)) => {
                let radius = radius + growth;
                // Travel turns the normal by length / signed radius; never by more than what closes the circle.
                let room = 0.25 * (TAU - piece.sweep.abs()).max(0.0);
                let by = (further / radius.to_f64()).clamp(-room, room);
                let (sin, cos) = Dd::from(by).sin_cos();
                let turned = turned(normal, cos, sin);
                End {
                    joint: self.add_joint(plus(center, times(turned, radius)), turned),
                    extra_sweep: by.abs(),
                }
            }
        }
    }
}

impl Piece {
    fn new(edge: &Edge, center: Point, scale: f64) -> Self {
        let place = |p: Point| {
            let along = |x: f64, center: f64| (Dd::from(x) - center).scaled(scale);
            (along(p.x, center.x), along(p.y, center.y))
        };
        let near = |p: Point| Point::ORIGIN + (p - center) * scale;
        let (start, end) = (place(edge.start), place(edge.end));
        let mut edge = Edge {
            start: near(edge.start),
            end: near(edge.end),
            ..*edge
        };
        let sweep = edge.sweep();
        let height = 0.5 * edge.bulge.abs() * edge.start.distance(edge.end);
        if sweep.abs() < STRAIGHT || (sweep.abs() < SMOOTH && height < SAME_CARRIER) {
            edge.bulge = 0.0;
        }
        Self::of(edge, start, end, Dd::from(edge.bulge))
    }

    /// From its ends and its bulge in double-double; of the edge itself rough lengths are taken.
    fn of(edge: Edge, start: Xy<Dd>, end: Xy<Dd>, b: Dd) -> Self {
        let chord = minus(end, start);
        let span = length(chord);
        let (one, square) = (Dd::ONE, b * b);
        let arc = (!edge.is_line()).then(|| {
            let middle = times(plus(start, end), Dd::from(0.5));
            let up = (one - square) / (b * 4.0);
            (
                plus(middle, times(left(chord), up)),
                span * (one + square) / (b * 4.0),
            )
        });
        // With b = tan(sweep/4), cos(sweep/2) = (1 − b²)/(1 + b²) and sin(sweep/2) = 2b/(1 + b²).
        let (cos, sin) = ((one - square) / (one + square), b * 2.0 / (one + square));
        let direction = times(chord, one / span);
        let near = arc
            .filter(|a| a.1.to_f64().abs() > LARGEST_CIRCLE)
            .map(|_| {
                let chord = edge.end - edge.start;
                Near {
                    point: edge.start.midpoint(edge.end) + chord.right() * (0.5 * edge.bulge),
                    normal: chord.unit().right(),
                }
            });
        Self {
            edge,
            start,
            end,
            arc,
            near,
            start_direction: turned(direction, cos, -sin),
            end_direction: turned(direction, cos, sin),
            sweep: edge.sweep(),
        }
    }

    /// The normal with which this edge ends at a grown corner.
    fn normal_at(&self, apex: Xy<Dd>, normal: Xy<Dd>, growth: f64) -> Xy<Dd> {
        match self.arc {
            Some((center, radius)) if growth > 0.0 => {
                let v = minus(apex, center);
                let v = times(v, Dd::ONE / length(v));
                if radius.is_negative() { negative(v) } else { v }
            }
            _ => normal,
        }
    }

    /// How far a point is off the edge's line or circle as grown, outward, to first order; and the outward normal there.
    fn off(&self, p: Xy<Dd>, normal: Xy<Dd>, at: Xy<Dd>, growth: f64) -> (Dd, Xy<Dd>) {
        match self.arc {
            None => (dot(normal, minus(p, at)) - growth, normal),
            Some((center, radius)) => {
                let r = radius + growth;
                let v = minus(p, center);
                ((dot(v, v) - r * r) / (r * 2.0), times(v, Dd::ONE / r))
            }
        }
    }

    fn curvature(&self) -> f64 {
        self.arc.map_or(0.0, |(_, radius)| 1.0 / radius.to_f64())
    }
}

/// The edges of a loop moved a little, so that it is generic and its smooth joints are exactly so; `None` if that would take
/// more than a little.
fn generic(pieces: &[Piece], wishes: &[[f64; 3]]) -> Option<Vec<Piece>> {
    let n = pieces.len();
    let smooth: Vec<bool> = (0..n)
        .map(|i| {
            matches!(
                corner(&pieces[(i + n - 1) % n], &pieces[i]),
                Corner::Smooth { .. }
            )
        })
        .collect();
    let drawn: Vec<ExactVertex> = (pieces.iter())
        .map(|p| ExactVertex {
            x: p.start.0,
            y: p.start.1,
            bulge: Dd::from(p.edge.bulge),
        })
        .collect();
    let moved = made_generic(&drawn, &smooth, wishes)?;
    let place = |v: &ExactVertex| (v.x, v.y);
    let rough = |v: &ExactVertex| Point::new(v.x.to_f64(), v.y.to_f64());
    let pieces = pieces.iter().enumerate().map(|(i, p)| {
        let (start, end) = (&moved[i], &moved[(i + 1) % n]);
        let edge = Edge {
            start: rough(start),
            end: rough(end),
            bulge: start.bulge.to_f64(),
            index: p.edge.index,
        };
        Piece::of(edge, place(start), place(end), start.bulge)
    });
    Some(pieces.collect())
}

/// By how much travel turns to the left from one edge to the next.
fn turn(before: &Piece, after: &Piece) -> f64 {
    let (d1, d2) = (before.end_direction, after.start_direction);
    cross(d1, d2).to_f64().atan2(dot(d1, d2).to_f64())
}

/// Lines that follow each other smoothly are put on one line, from where the first starts to where the last ends: contacts of
/// each are then contacts of one line, as far as double-double tells, however short the pieces are.
fn straightened(pieces: &mut [Piece]) {
    let n = pieces.len();
    let goes_on: Vec<bool> = (0..n)
        .map(|i| {
            let (before, after) = (&pieces[i], &pieces[(i + 1) % n]);
            before.arc.is_none()
                && after.arc.is_none()
                && matches!(corner(before, after), Corner::Smooth { .. })
        })
        .collect();
    for first in 0..n {
        if goes_on[(first + n - 1) % n] {
            continue;
        }
        let count = (1..=n)
            .find(|k| !goes_on[(first + k - 1) % n])
            .unwrap_or_default();
        if count < 2 {
            continue;
        }
        let start = pieces[first].start;
        let chord = minus(pieces[(first + count - 1) % n].end, start);
        let direction = times(chord, Dd::ONE / length(chord));
        for k in 0..count {
            let i = (first + k) % n;
            pieces[i].start_direction = direction;
            pieces[i].end_direction = direction;
            if k + 1 < count {
                let along = dot(direction, minus(pieces[i].end, start));
                let joint = plus(start, times(direction, along));
                pieces[i].end = joint;
                pieces[(i + 1) % n].start = joint;
            }
        }
    }
}

fn corner(before: &Piece, after: &Piece) -> Corner {
    let turn = turn(before, after);
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
        (Some(_), Some((_, radius))) => radius.to_f64().abs(),
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
fn tangency(before: &Piece, after: &Piece, beside: bool) -> (Xy<Dd>, Xy<Dd>) {
    let vertex = before.end;
    let (d1, d2) = (before.end_direction, after.start_direction);
    let on_line = |(center, radius): (Xy<Dd>, Dd), direction: Xy<Dd>| {
        let normal = right(direction);
        if !beside {
            return (vertex, normal);
        }
        let at = plus(center, times(normal, radius));
        let along = dot(direction, minus(at, vertex));
        (plus(vertex, times(direction, along)), normal)
    };
    match (before.arc, after.arc) {
        (None, None) => (vertex, right(d1)),
        (None, Some(arc)) => on_line(arc, d1),
        (Some(arc), None) => on_line(arc, d2),
        (Some((c, r)), Some((d, s))) => {
            if !beside {
                return (vertex, right(d2));
            }
            // Normals that differ by a turn δ at the vertex agree δ / (κ₁ − κ₂) further on. The line of centres tells the same,
            // but nothing where both arcs are of one circle.
            let further = turn(before, after) / (before.curvature() - after.curvature());
            let (sin, cos) = Dd::from(before.curvature() * further).sin_cos();
            let normal = turned(right(d1), cos, sin);
            match (before.near, after.near) {
                (None, _) => (plus(c, times(normal, r)), normal),
                // The smaller one knows the place best; of large ones the normal hardly turns.
                (_, None) => (plus(d, times(normal, s)), normal),
                _ => (vertex, right(d2)),
            }
        }
    }
}

/// The corner of two edges that are both moved outward by `growth`: of lines, V + g (n₁ + n₂) / (1 + n₁·n₂); of arcs what
/// Newton's rule makes of that.
fn mitre(before: &Piece, after: &Piece, n1: Xy<Dd>, n2: Xy<Dd>, growth: f64) -> Xy<Dd> {
    let point = before.end;
    if growth == 0.0 {
        return point;
    }
    let reach = dot(n1, n2) + 1.0;
    // |n₁ + n₂|² = 2 (1 + n₁·n₂), so the mitre's length is g √(2 / reach).
    if 2.0 > MITRE * MITRE * reach.to_f64() {
        return plus(point, times(left(n1), Dd::from(growth * MITRE)));
    }
    let mut apex = plus(point, times(plus(n1, n2), Dd::from(growth) / reach));
    if before.arc.is_none() && after.arc.is_none() {
        return apex;
    }
    /// The first place is right to second order; each step squares what is left.
    const STEPS: usize = 2;
    for _ in 0..STEPS {
        let (h, m) = before.off(apex, n1, point, growth);
        let (k, n) = after.off(apex, n2, point, growth);
        let det = cross(m, n);
        let step = plus(times(left(n), h), times(right(m), k));
        let step = times(step, Dd::ONE / det);
        // The edges may go on into each other all but smoothly.
        let far = length(step).to_f64();
        if far.is_nan() || far >= growth {
            break;
        }
        apex = plus(apex, step);
    }
    apex
}
