//! Extracts features and joints from a part's loops.

use core::f64::consts::TAU;

use super::framed_edge::FramedEdge;
use super::generic::{edge_from, made_generic};
use super::joining::{Corner, corner, mitre, straightened, tangency};
use super::perturbation::Perturbation;
use super::tolerance::{
    CONTACT, GROWTH, LAYER_STEP, MITRE, MOVING_GROWTH, OVERSHOOT, OVERSHOOT_SEPARATION,
};
use super::types::{Feature, FeatureKind, FeatureName, Joint, Near, Outline};
use crate::geometry::{Point, Rotation, Vector, unwrap_near};
use crate::number::Dd;
use crate::part::{Edge, Loop, LoopHeights, Part, Vertex};

/// One end of an edge after growth: its joint and, for an arc, the angle by which its sweep was extended.
type End = (u32, f64);

impl Outline {
    /// Features of a part, about `center` and scaled, then grown: each layer by a step more than the one before it.
    pub(crate) fn new(part: &Part, center: Point, scale: f64, (growth, step): (f64, f64)) -> Self {
        Self::made(part, center, scale, (growth, step), None)
    }

    /// As [`new`](Self::new), after the part was made generic.
    pub(crate) fn perturbed(
        part: &Part,
        center: Point,
        scale: f64,
        growth: f64,
        perturbation: &Perturbation<'_>,
    ) -> Self {
        let step = layer_step(part.layers().len(), growth, perturbation);
        let apart = match part.layers() {
            [_] => *perturbation,
            _ => perturbation.within(step),
        };
        Self::made(part, center, scale, (growth, step), Some(&apart))
    }

    fn made(
        part: &Part,
        center: Point,
        scale: f64,
        (growth, step): (f64, f64),
        perturbation: Option<&Perturbation<'_>>,
    ) -> Self {
        let mut outline = Self {
            features: Vec::new(),
            joints: Vec::new(),
            exact_features: Vec::new(),
            exact_joints: Vec::new(),
            heights: LoopHeights::of(part),
            feature_count: 0,
        };
        let mut wishes = perturbation.map(|p| p.wishes(part)).unwrap_or_default();
        for (loop_index, boundary) in part.loops().iter().enumerate() {
            let growth = growth + step * part.layer_of(loop_index) as f64;
            let mut pieces: Vec<FramedEdge> = boundary
                .edges()
                .map(|e| FramedEdge::new(&e, center, scale))
                .collect();
            if let Some(wishes) = wishes.get_mut(loop_index) {
                pieces = generic(&pieces, wishes).unwrap_or(pieces);
            }
            straightened(&mut pieces);
            outline.add_loop((loop_index as u32, boundary), &pieces, growth);
        }
        outline
    }

    /// Displacement of a part's sharpest corner per unit of growth of its sides.
    pub(crate) fn longest_mitre(part: &Part, center: Point, scale: f64) -> f64 {
        let mut longest = 1.0_f64;
        // Layers are grown more, by a unit each if they are few.
        let step = most_layer_step(part.layers().len()).min(1.0);
        for (loop_index, boundary) in part.loops().iter().enumerate() {
            let growth = 1.0 + step * part.layer_of(loop_index) as f64;
            let pieces: Vec<FramedEdge> = boundary
                .edges()
                .map(|e| FramedEdge::new(&e, center, scale))
                .collect();
            for (i, before) in pieces.iter().enumerate() {
                if let Corner::Convex { turn } = corner(before, &pieces[(i + 1) % pieces.len()]) {
                    longest = longest.max(growth / (0.5 * turn).cos().max(1.0 / MITRE));
                }
            }
        }
        longest
    }

    fn add_loop(
        &mut self,
        (loop_index, boundary): (u32, &Loop),
        pieces: &[FramedEdge],
        growth: f64,
    ) {
        let n = pieces.len();
        self.feature_count += n;
        let (mut starts, mut ends) = (vec![(0, 0.0); n], vec![(0, 0.0); n]);
        let mut vertices = Vec::new();
        for i in 0..n {
            let j = (i + 1) % n;
            let (before, after) = (&pieces[i], &pieces[j]);
            let point = before.edge.end;
            let (n1, n2) = (before.end_direction.right(), after.start_direction.right());
            let grown = |normal: Vector<Dd>| point + normal * Dd::from(growth);
            match corner(before, after) {
                Corner::Smooth { beside } => {
                    let (point, normal) = tangency(before, after, beside);
                    let place = point + normal * Dd::from(growth);
                    ends[i] = (self.add_joint(place, normal), 0.0);
                    starts[j] = ends[i];
                }
                Corner::Convex { turn } => {
                    self.feature_count += 1;
                    let apex = mitre(before, after, n1, n2, growth);
                    let first = self.add_joint(apex, before.normal_at(apex, n1, growth));
                    let second = self.add_joint(apex, after.normal_at(apex, n2, growth));
                    (ends[i], starts[j]) = ((first, 0.0), (second, 0.0));
                    let index = boundary.start_of(after.edge.index);
                    vertices.push((first, second, turn, index as u32));
                }
                Corner::Concave { turn } => {
                    self.feature_count += 1;
                    // Edges that are moved into the material separate, and meet again further on.
                    let parted = (-growth).max(0.0) * (0.5 * turn.abs()).tan();
                    let further =
                        OVERSHOOT * GROWTH + OVERSHOOT_SEPARATION / turn.abs().min(1.0) + parted;
                    // Not beyond the middle of the other edge, below which the extension runs.
                    let under = |other: &FramedEdge| further.min(0.5 * other.rough.length());
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
            self.add_feature(Feature {
                center: self.exact_joints[start as usize].point,
                radius: Dd::ZERO,
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

    fn add_edge(
        &mut self,
        loop_index: u32,
        piece: &FramedEdge,
        (start, started): End,
        (end, ended): End,
        growth: f64,
    ) {
        let [from, to] = [start, end].map(|joint| self.joints[joint as usize].angle);
        let origin = Point::ORIGIN.map(Dd::from);
        let (center, radius, lo, hi) = match piece.arc {
            // The joints of a line have its normal, unless two lines meet smoothly; then the normal of the first one is used.
            None => (origin, Dd::ZERO, from, from),
            Some((center, radius)) => {
                let sweep = piece.rough.sweep();
                let extra = (started + ended) * sweep.signum();
                let to = unwrap_near(to, from + (sweep + extra));
                // A concave arc is traversed with decreasing normal: the canonical angle is the start's, the upper one.
                let (lo, hi) = if sweep > 0.0 { (from, to) } else { (to, from) };
                (center, radius + growth, lo, hi)
            }
        };
        let near = piece.near.map(|n| Near {
            point: n.point + n.normal * growth,
            ..n
        });
        self.add_feature(Feature {
            center,
            radius,
            near,
            lo,
            hi,
            start,
            end,
            name: FeatureName {
                kind: FeatureKind::of_bulge(piece.rough.bulge),
                loop_index,
                index: piece.edge.index as u32,
            },
        });
    }

    fn add_feature(&mut self, feature: Feature<Dd>) {
        self.features.push(feature.rounded());
        self.exact_features.push(feature);
    }

    fn add_joint(&mut self, point: Point<Dd>, normal: Vector<Dd>) -> u32 {
        let joint = Joint {
            point,
            normal,
            angle: Dd::atan2(normal.y, normal.x),
        };
        self.joints.push(joint.rounded());
        self.exact_joints.push(joint);
        (self.joints.len() - 1) as u32
    }

    /// The end of an edge in a concave corner, with `point` on the grown edge, extended by `further` (backwards when negative).
    fn carry_on(
        &mut self,
        piece: &FramedEdge,
        point: Point<Dd>,
        normal: Vector<Dd>,
        growth: f64,
        further: f64,
    ) -> End {
        match piece.arc {
            None => {
                let place = point + normal.left() * Dd::from(further);
                (self.add_joint(place, normal), 0.0)
            }
            Some((center, radius)) => {
                let radius = radius + growth;
                // The extension turns the normal by length / signed radius; never by more than what closes the circle.
                let room = 0.25 * (TAU - piece.rough.sweep().abs()).max(0.0);
                let by = (further / radius.to_f64()).clamp(-room, room);
                let turned = Rotation::by(Dd::from(by)) * normal;
                let place = center + turned * radius;
                (self.add_joint(place, turned), by.abs())
            }
        }
    }
}

/// How much more each layer of a part is grown than the one before it, so that where their outlines are flush one covers the other.
///
/// For both parts together, the growth of the last layers stays below the resolution of contacts.
fn layer_step(layers: usize, growth: f64, perturbation: &Perturbation<'_>) -> f64 {
    let most = match growth < 0.0 {
        true => -0.5 / layers as f64,
        false => most_layer_step(layers),
    };
    (LAYER_STEP * perturbation.size).min(most * growth)
}

/// How much more each of some layers may be grown than the one before it, in units of the growth of the first.
fn most_layer_step(layers: usize) -> f64 {
    (CONTACT / (GROWTH + MOVING_GROWTH) - 1.0) / layers as f64
}

/// The edges of a loop moved slightly, so that it is generic and its smooth joints are exactly smooth; `None` if that requires larger
/// displacements.
fn generic(pieces: &[FramedEdge], wishes: &[[f64; 3]]) -> Option<Vec<FramedEdge>> {
    let n = pieces.len();
    let smooth: Vec<bool> = (0..n)
        .map(|i| {
            matches!(
                corner(&pieces[(i + n - 1) % n], &pieces[i]),
                Corner::Smooth { .. }
            )
        })
        .collect();
    let drawn: Vec<Vertex<Dd>> = (pieces.iter().map(|p| p.edge))
        .map(|e| Vertex::new(e.start.x, e.start.y, e.bulge))
        .collect();
    let moved = made_generic(&drawn, &smooth, wishes)?;
    let pieces = pieces.iter().enumerate().map(|(i, p)| {
        let index = p.edge.index;
        let edge = edge_from(&moved, i);
        FramedEdge::of(Edge { index, ..edge }, p.drawn)
    });
    Some(pieces.collect())
}
