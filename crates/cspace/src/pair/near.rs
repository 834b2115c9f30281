//! Features of two parts that touch or nearly touch: distances between the features themselves, without the space's patches.
//!
//! Two features are a pair where one line is at right angles to both, from a point of the one to a point of the other, and their outward
//! normals face each other along it: there their distance has a local minimum. A vertex has the normals between those of its two edges, so
//! that the distance of the parts is always among the pairs.

use core::f64::consts::TAU;

use crate::boxes::Boxes;
use crate::contact::{FeatureShape, Placement, Touching, touching_place};
use crate::feature::tolerance::{SMOOTH, STRAIGHT};
use crate::feature::{FeatureKind, FeatureName, PairFrame};
use crate::geometry::{Configuration, Point, Rotation, Vector};
use crate::part::{Bounds, Edge, LoopHeights, MeetingLoops, Part};
use crate::query::Classification;

use super::{Coordinates, FeatureId, PairSpace, QueryError};

/// Angle below which directions are equal (radians): edges that are drawn flush differ by the rounding of their coordinates and
/// orientation, some 1e-15, and more if they are short.
const ALIGNED: f64 = 1e-9;

/// Two features that touch or nearly touch, and their nearest points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearFeatures {
    /// The feature of the fixed part.
    pub fixed: FeatureId,
    /// The feature of the moving part.
    pub moving: FeatureId,
    /// Distance of the features, in the model's unit of length. Negative by the depth of overlap where the parts overlap, or touch within
    /// the resolution.
    pub distance: f64,
    /// The points of the two features that are nearest to each other, and the outward normal of the fixed part there.
    pub touching: Touching,
}

impl PairSpace {
    /// The pairs of features that face each other at a configuration with a distance, or a depth of overlap, of at most `within` (model
    /// length); the nearest first.
    ///
    /// While the parts do not overlap, the distance of the first pair is that of the parts ([`clearance`](Self::clearance)). Both points of
    /// a pair lie on its features: on line segments, arcs and convex vertices, not on their extensions. Patches are not used, so critical
    /// and doubtful orientations make no difference.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, or outside; and for lower pairs, which are in permanent contact.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
    /// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
    /// let coin = Part::circle("coin", (0.0, 0.0), 1.0)?;
    /// let space = PairSpace::compute(&table, &coin, Relation::Planar, &Options::default())?;
    /// // Beside the table's corner (2, 2): 5 − 1 from it, and beyond the ends of both sides.
    /// let near = space.near_features(Coordinates::Planar(Configuration::new(5.0, 6.0, 0.0)), 10.0)?;
    /// assert_eq!(near[0].fixed.name.to_string(), "vertex 2 of loop 0");
    /// assert!((near[0].distance - 4.0).abs() < 1e-12);
    /// assert!((near[0].touching.normal.x - 0.6).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn near_features(
        &self,
        at: Coordinates,
        within: f64,
    ) -> Result<Vec<NearFeatures>, QueryError> {
        let class = self.classify(at)?;
        self.refuse_lower()?;
        // Accuracy to which parts in contact are placed.
        let known = match class {
            Classification::Contact => self.resolution(),
            Classification::Free | Classification::Blocked => 0.0,
        };
        let (fixed, moving) = (self.fixed(), self.moving());
        let placed = self.by_class(at)?.placed();
        let frame = PairFrame::new(fixed, moving);
        let slack = rounding(&frame, placed);
        let beyond = known + slack;
        let deepest = match class {
            Classification::Blocked => within + slack,
            Classification::Contact | Classification::Free => beyond,
        };
        Ok(near_of((fixed, moving, placed), [within, deepest, beyond]))
    }
}

/// The features of two parts, the moving one placed by a configuration, that are no farther apart than a length or overlap by no more than
/// it: what touches. As of [`PairSpace::near_features`], without a space.
pub fn touching_features(
    fixed: &Part,
    moving: &Part,
    at: Configuration,
    within: f64,
) -> Vec<NearFeatures> {
    near_of((fixed, moving, at), [within; 3])
}

/// The pairs of features of a placed pair; `limits` are those of [`Sought`].
fn near_of(
    (fixed, moving, placed): (&Part, &Part, Configuration),
    [within, deepest, beyond]: [f64; 3],
) -> Vec<NearFeatures> {
    let frame = PairFrame::new(fixed, moving);
    let sought = Sought {
        meeting: MeetingLoops::of(&LoopHeights::of(fixed), &LoopHeights::of(moving)),
        within,
        deepest,
        beyond,
        slack: rounding(&frame, placed),
    };
    // Parts may be drawn far away: all is computed relative to the fixed part's centre.
    let center = frame.fixed_center.to_vector();
    let mut found = sought.among(
        &features(fixed, frame.fixed_center, Configuration::default()),
        &features(moving, frame.moving_center, about_centers(&frame, placed)),
    );
    for near in &mut found {
        near.touching.on_fixed += center;
        near.touching.on_moving += center;
    }
    found.sort_by(|a, b| {
        let nearer = a.distance.abs().total_cmp(&b.distance.abs());
        let names = |f: &NearFeatures| (f.fixed.name, f.moving.name);
        nearer.then(names(a).cmp(&names(b)))
    });
    found
}

/// Bound of the rounding error of points of the two parts, in the model's unit of length.
fn rounding(frame: &PairFrame, at: Configuration) -> f64 {
    /// Bound of the rounding error of the few sums in which the configuration's position enters, relative to its distance from the origin.
    const PLACED: f64 = 8.0 * f64::EPSILON;
    frame.outer_length(frame.rounding()) + PLACED * at.x.hypot(at.y)
}

/// Placement of the moving part about its centre, relative to the fixed part's centre.
fn about_centers(frame: &PairFrame, at: Configuration) -> Configuration {
    let turned = Rotation::by(at.theta) * frame.moving_center.to_vector();
    let position = (at.position() - frame.fixed_center) + turned;
    Configuration::new(position.x, position.y, at.theta)
}

/// A line, an arc or a convex vertex of a placed part, relative to the fixed part's centre.
struct PlacedFeature {
    name: FeatureName,
    shape: FeatureShape<f64>,
    /// The edge; `None` for a vertex.
    edge: Option<Edge>,
    /// The angle of the first of its outward normals, and how far the others turn from it counter-clockwise (radians).
    normals: (f64, f64),
    bounds: Bounds,
}

/// The features of a part, placed about its centre.
fn features(part: &Part, center: Point, at: Configuration) -> Vec<PlacedFeature> {
    let turn = Rotation::by(at.theta);
    let place = |p: Point| at.position() + turn * (p - center);
    let mut features = Vec::new();
    for (loop_index, outline) in (0u32..).zip(part.loops()) {
        let named = |kind, index: usize| FeatureName {
            kind,
            loop_index,
            index: index as u32,
        };
        let edges: Vec<Edge> = outline.edges().map(|e| e.placed(place)).collect();
        for (i, &edge) in edges.iter().enumerate() {
            let ends = [edge.start_direction(), edge.end_direction()];
            let first = ends[usize::from(edge.bulge < 0.0)];
            features.push(PlacedFeature {
                name: named(FeatureKind::of_bulge(edge.bulge), edge.index),
                shape: edge.into(),
                edge: Some(edge),
                normals: (first.right().angle(), edge.sweep().abs()),
                bounds: edge.bounds(),
            });
            let next = &edges[(i + 1) % edges.len()];
            let (before, after) = (ends[1], next.start_direction());
            let turns_by = before.cross(after).atan2(before.dot(after));
            let smooth = match edge.is_line() && next.is_line() {
                true => 2.0 * STRAIGHT,
                false => SMOOTH,
            };
            if turns_by > smooth {
                let at = edge.end;
                features.push(PlacedFeature {
                    name: named(FeatureKind::Vertex, outline.start_of(next.index)),
                    shape: FeatureShape::Vertex { at: [at.x, at.y] },
                    edge: None,
                    normals: (before.right().angle(), turns_by),
                    bounds: Bounds::of(at, at),
                });
            }
        }
    }
    features
}

impl PlacedFeature {
    /// Signed radius: 0 for a vertex, negative for a concave arc, infinite for a line.
    fn radius(&self) -> f64 {
        (self.edge).map_or(0.0, |e| e.radius() * if e.bulge < 0.0 { -1.0 } else { 1.0 })
    }

    /// Whether a direction is one of the outward normals.
    fn has_normal(&self, direction: Vector) -> bool {
        let (first, turn) = self.normals;
        let from_first = (direction.angle() - first + ALIGNED).rem_euclid(TAU);
        from_first <= turn + 2.0 * ALIGNED
    }

    /// The point of the feature that corresponds to a point on its line or circle; `None` if that is more than `most` beyond its ends.
    fn onto(&self, p: Point, most: f64) -> Option<Point> {
        let Some(edge) = &self.edge else {
            return Some(self.bounds.center());
        };
        if edge.covers(p) {
            return Some(p);
        }
        let ends = [edge.start, edge.end].map(|end| (end, end.distance(p)));
        let (end, beyond) = if ends[0].1 < ends[1].1 {
            ends[0]
        } else {
            ends[1]
        };
        (beyond <= most).then_some(end)
    }

    /// The point of the feature with a given outward normal.
    fn at_normal(&self, normal: Vector) -> Point {
        let Some(edge) = &self.edge else {
            return self.bounds.center();
        };
        let to = normal.left();
        match edge.fraction_heading(to) {
            Some(u) => edge.at(u),
            // The normal is outside by rounding: the point is the nearer end.
            None if edge.start_direction().dot(to) > edge.end_direction().dot(to) => edge.start,
            None => edge.end,
        }
    }
}

/// Limits of a search for near features.
struct Sought {
    meeting: MeetingLoops,
    within: f64,
    /// Maximum overlap of two features.
    deepest: f64,
    /// Maximum distance of a touching place beyond the end of a feature: a part in a concave corner may overlap one side of it by as much.
    beyond: f64,
    /// Distance below which two points count as one.
    slack: f64,
}

impl Sought {
    fn among(&self, fixed: &[PlacedFeature], moving: &[PlacedFeature]) -> Vec<NearFeatures> {
        let boxes = Boxes::new(fixed.iter().map(|f| f.bounds));
        let mut found = Vec::new();
        for g in moving {
            let reaches = |b: &Bounds| !b.is_apart(g.bounds, self.within + self.beyond);
            boxes.any(reaches, |i| {
                let f = &fixed[i as usize];
                if self.meeting.hold(f.name.loop_index, g.name.loop_index) {
                    found.extend(self.pair(f, g));
                }
                false
            });
        }
        found
    }

    /// Two features, if they face each other and are near enough.
    fn pair(&self, f: &PlacedFeature, g: &PlacedFeature) -> Option<NearFeatures> {
        // Parallel lines are represented by their ends, and a concave arc is touched only by features of smaller radius.
        let sum = f.radius() + g.radius();
        let rolls = match (f.name.kind, g.name.kind) {
            (FeatureKind::Line, FeatureKind::Line) => false,
            (FeatureKind::ConcaveArc, _) | (_, FeatureKind::ConcaveArc) => sum < 0.0,
            _ => true,
        };
        if !rolls {
            return None;
        }
        let place = touching_place(&f.shape, &g.shape, &Placement::identity());
        let point = |[x, y]: [f64; 2]| Point::new(x, y);
        let normal = Vector::new(place.normal[0], place.normal[1]);
        // Distance of the centres of circles and vertices.
        let apart = if sum.is_finite() {
            (place.gap + sum).abs()
        } else {
            f64::INFINITY
        };
        let (normal, on_fixed, on_moving) = if apart > self.slack {
            let on_fixed = f.onto(point(place.on_fixed), self.beyond)?;
            let on_moving = g.onto(point(place.on_moving), self.beyond)?;
            (normal, on_fixed, on_moving)
        } else {
            // Concentric circles are equally near in every direction.
            let normal = common_normal(f, g)?;
            (normal, f.at_normal(normal), g.at_normal(-normal))
        };
        if !(f.has_normal(normal) && g.has_normal(-normal)) {
            return None;
        }
        let distance = (on_moving - on_fixed).dot(normal);
        let near = (-self.deepest..=self.within).contains(&distance);
        near.then_some(NearFeatures {
            fixed: FeatureId::of_fixed(f.name),
            moving: FeatureId::of_moving(g.name),
            distance,
            touching: Touching {
                on_fixed,
                on_moving,
                normal,
            },
        })
    }
}

/// An outward normal of one feature whose opposite is one of the other.
fn common_normal(f: &PlacedFeature, g: &PlacedFeature) -> Option<Vector> {
    let ends = |(first, turn): (f64, f64)| [first, first + 0.5 * turn, first + turn];
    let of_f = ends(f.normals).map(Vector::from_angle);
    let of_g = ends(g.normals).map(|angle| -Vector::from_angle(angle));
    (of_f.into_iter().chain(of_g)).find(|&n| f.has_normal(n) && g.has_normal(-n))
}
