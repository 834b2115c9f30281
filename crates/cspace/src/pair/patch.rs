//! Contact patches of pairs of any class, with their contact functions in the user's coordinates.

use crate::contact::{ContactValue, FeatureShape, Placement, Touching, contact_function, touching};
use crate::feature::{FeatureKind, FeatureName};
use crate::fixed_axes::AxisMotion;
use crate::ids::{PatchId, RegionId};
use crate::number::{Dual, Real, SecondOrder};
use crate::part::{Part, PartFeature};

use super::{Coordinates, FeatureId, PairClass, PairSpace, QueryError};

/// A contact patch of a pair's space, for evaluation.
#[derive(Debug, Clone, Copy)]
pub struct PairPatch<'a> {
    pub(super) space: &'a PairSpace,
    pub(super) id: PatchId,
}

/// The contact of two features: their outlines as drawn, and the motion of their parts.
///
/// Its function f is in the user's coordinates and in the model's unit of length: the distance of the features' lines and circles along
/// their common normal, 0 in contact and positive where they are apart. On the space's patch f is 0 up to the space's
/// [resolution](PairSpace::resolution): parts are grown a little before a space is computed, while f belongs to the parts as drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureContact {
    /// The feature of the fixed part.
    pub fixed: FeatureShape<f64>,
    /// The feature of the moving part.
    pub moving: FeatureShape<f64>,
    drawn: (Drawn, Drawn),
    motion: Motion,
}

/// The vertices that define a feature's outline.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Drawn {
    name: FeatureName,
    /// The vertex at the end of its edge.
    next: u32,
    /// Whether travel with material on the left is against the order of the drawing.
    reversed: bool,
}

/// Motion that the coordinates describe.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Motion {
    Planar,
    Axes(AxisMotion, AxisMotion),
}

/// The derivatives of a contact function by the numbers of the drawing, at one configuration.
#[derive(Debug, Clone, PartialEq)]
pub struct ByDrawing {
    /// By the vertices of the fixed part's feature.
    pub fixed: Vec<ByVertex>,
    /// By those of the moving part's.
    pub moving: Vec<ByVertex>,
    /// By the centre, or the direction, of the fixed part's axis; 0 if it has none.
    pub fixed_axis: [f64; 2],
    /// By the centre, or the direction, of the moving part's axis; 0 if it has none.
    pub moving_axis: [f64; 2],
}

/// The derivatives of a contact function by one vertex of a part, as it is given in [`Part::new`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ByVertex {
    /// The loop of the vertex.
    pub loop_index: u32,
    /// Its number in the loop.
    pub vertex: u32,
    /// By its coordinates x and y (length per length).
    pub by_position: [f64; 2],
    /// By its bulge (length), of the edge that leaves it.
    pub by_bulge: f64,
}

impl PairPatch<'_> {
    /// Number of the patch.
    pub fn id(&self) -> PatchId {
        self.id
    }

    /// The features of the fixed and of the moving part that touch.
    ///
    /// # Errors
    /// If the pair is a lower pair: there the contact is between a point and a line, or two points, of the joint.
    pub fn features(&self) -> Result<(FeatureId, FeatureId), QueryError> {
        let (fixed, moving) = self.names()?;
        Ok((FeatureId::of_fixed(fixed), FeatureId::of_moving(moving)))
    }

    fn names(&self) -> Result<(FeatureName, FeatureName), QueryError> {
        let i = self.id.index();
        match self.space {
            PairSpace::Lower(_) => Err(QueryError::Permanent),
            PairSpace::FixedAxes(s) => Ok((s.patches()[i].fixed, s.patches()[i].moving)),
            PairSpace::Planar(s) => Ok((s.patches()[i].fixed, s.patches()[i].moving)),
        }
    }

    /// The free region it bounds.
    ///
    /// # Errors
    /// If the pair is a lower pair, which has no free regions.
    pub fn region(&self) -> Result<Option<RegionId>, QueryError> {
        match self.space {
            PairSpace::Lower(_) => Err(QueryError::Permanent),
            PairSpace::FixedAxes(space) => Ok(space.patches()[self.id.index()].region),
            PairSpace::Planar(space) => Ok(Some(space.patches()[self.id.index()].region)),
        }
    }

    /// The orientations at which it exists, first and last, in radians; the last may be beyond π.
    ///
    /// # Errors
    /// If the pair has no orientation as a coordinate: lower pairs and pairs with fixed axes.
    pub fn orientations(&self) -> Result<(f64, f64), QueryError> {
        let p = &self.space.oriented()?.patches()[self.id.index()];
        Ok((p.lo, p.hi))
    }

    /// The configurations at which the patch begins and ends in the direction of travel, with free space on its right, at an orientation;
    /// and their derivatives by the orientation (length per radian).
    ///
    /// The derivatives are not finite where the patch shrinks to a point.
    ///
    /// # Errors
    /// If the pair has no orientation as a coordinate, or `theta` is outside the patch's [orientations](Self::orientations).
    pub fn ends_at(&self, theta: f64) -> Result<[(Coordinates, [f64; 2]); 2], QueryError> {
        let patch = (self.space.oriented()?.patch(self.id)).ok_or(QueryError::Outside)?;
        if !patch.contains_orientation(theta) {
            return Err(QueryError::Outside);
        }
        Ok([patch.left(), patch.right()].map(|end| {
            let d = end.derivative(theta);
            (Coordinates::Planar(end.at(theta)), [d.x, d.y])
        }))
    }

    /// The contact of its features, by which contact functions are evaluated.
    ///
    /// # Errors
    /// If the pair is a lower pair.
    pub fn contact(&self) -> Result<FeatureContact, QueryError> {
        let (fixed, moving) = self.names()?;
        self.space.contact_of(fixed, moving)
    }
}

/// Contact patches.
impl PairSpace {
    /// The contact patches, in the order of their numbers; for a lower pair, its permanent contacts.
    pub fn patches(&self) -> impl Iterator<Item = PairPatch<'_>> {
        (0..self.patch_count() as u32).map(|i| PairPatch {
            space: self,
            id: PatchId(i),
        })
    }

    /// A patch.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn patch(&self, id: PatchId) -> Result<PairPatch<'_>, QueryError> {
        let count = self.patch_count();
        if id.index() >= count {
            return Err(QueryError::NoPatch {
                patch: id,
                last: PatchId((count as u32).saturating_sub(1)),
            });
        }
        Ok(PairPatch { space: self, id })
    }

    /// The contact of a feature of the fixed part with one of the moving part, whether or not they ever touch.
    ///
    /// # Errors
    /// If the pair is a lower pair, or a part has no such feature.
    pub fn contact_of(
        &self,
        fixed: FeatureName,
        moving: FeatureName,
    ) -> Result<FeatureContact, QueryError> {
        let shape = |part: &Part, name| part.feature_shape(name).ok_or(QueryError::Outside);
        let drawn = |part: &Part, name: FeatureName| {
            let outline = &part.loops()[name.loop_index as usize];
            Drawn {
                name,
                next: (name.index + 1) % outline.vertices().len() as u32,
                reversed: outline.is_reversed(),
            }
        };
        let motion = match self {
            Self::FixedAxes(space) => {
                let (a, b) = space.axes();
                Motion::Axes(a.motion, b.motion)
            }
            Self::Planar(_) => Motion::Planar,
            Self::Lower(_) => return Err(QueryError::Permanent),
        };
        Ok(FeatureContact {
            fixed: shape(self.fixed(), fixed)?,
            moving: shape(self.moving(), moving)?,
            drawn: (drawn(self.fixed(), fixed), drawn(self.moving(), moving)),
            motion,
        })
    }
}

impl FeatureContact {
    /// Placement of the moving part in the fixed part's frame, for coordinates and axes in numbers of any kind.
    fn placement<T: Real>(
        &self,
        at: Coordinates,
        variable: impl Fn(f64, usize) -> T,
        axis: impl Fn(f64, usize) -> T,
    ) -> Result<Placement<T>, QueryError> {
        let placed = |motion: AxisMotion, by: T, first: usize| match motion {
            AxisMotion::Fixed => Placement::identity(),
            AxisMotion::Revolute { center } => {
                Placement::turn([axis(center.x, first), axis(center.y, first + 1)], by)
            }
            AxisMotion::Prismatic { direction } => {
                Placement::slide([axis(direction.x, first), axis(direction.y, first + 1)], by)
            }
        };
        match (self.motion, at) {
            (Motion::Planar, Coordinates::Planar(c)) => Ok(Placement::new(
                [variable(c.x, 0), variable(c.y, 1)],
                variable(c.theta, 2),
            )),
            (Motion::Axes(a, b), Coordinates::Axes { u, v }) => {
                let ground_from_fixed = placed(a, variable(u, 0), 0);
                let ground_from_moving = placed(b, variable(v, 1), 2);
                Ok(ground_from_fixed.inverse().compose(&ground_from_moving))
            }
            (Motion::Planar, Coordinates::Axes { .. }) => {
                Err(QueryError::coordinates(PairClass::General, at))
            }
            (Motion::Axes(..), Coordinates::Planar(_)) => {
                Err(QueryError::coordinates(PairClass::FixedAxes, at))
            }
        }
    }

    fn plainly(&self, at: Coordinates) -> Result<Placement<f64>, QueryError> {
        self.placement(at, |x, _| x, |x, _| x)
    }

    /// The contact function f at a configuration, in the model's unit of length.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    pub fn value(&self, at: Coordinates) -> Result<f64, QueryError> {
        Ok(contact_function(
            &self.fixed,
            &self.moving,
            &self.plainly(at)?,
        ))
    }

    /// The contact function with its gradient and Hessian by the coordinates: by x, y and θ, or by u and v.
    ///
    /// For a planar configuration, the first two components of the gradient are the outward unit normal of the fixed part at the contact.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, Vertex};
    /// let disc = |r: f64| Part::new("disc", vec![vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)]]);
    /// let space = PairSpace::compute(&disc(2.0)?, &disc(1.0)?, Relation::Planar, &Options::default())?;
    /// let patch = space.patches().next().ok_or("discs touch")?;
    /// let f = patch.contact()?.evaluate(Coordinates::Planar(Configuration::new(5.0, 0.0, 0.2)))?;
    /// assert!((f.value - 2.0).abs() < 1e-12);
    /// assert!((f.gradient[0] - 1.0).abs() < 1e-12);
    /// // Curves of equal distance about the fixed disc are circles: along y it bends by 1/5.
    /// assert!((f.hessian[1][1] - 0.2).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluate(&self, at: Coordinates) -> Result<ContactValue, QueryError> {
        type S = SecondOrder<3>;
        let placed = self.placement(at, S::variable, |x, _| S::constant(x))?;
        let real = |_, x| S::constant(x);
        let f = contact_function(&self.fixed.map(real), &self.moving.map(real), &placed);
        Ok(ContactValue {
            value: f.value,
            gradient: f.gradient,
            hessian: f.hessian,
        })
    }

    /// The points where the features touch, or would touch along their common normal, in the fixed part's frame.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    pub fn touching(&self, at: Coordinates) -> Result<Touching, QueryError> {
        Ok(touching(&self.fixed, &self.moving, &self.plainly(at)?))
    }

    /// The derivatives of the contact function by the numbers of the drawing: vertices, bulges and axes.
    ///
    /// They are the sensitivities of tolerance analysis: a displacement δ of a vertex moves the contact by −∂f/∂(vertex)·δ along its
    /// normal.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    pub fn by_drawing(&self, at: Coordinates) -> Result<ByDrawing, QueryError> {
        /// Number of parameters of a feature, and of all features and axes.
        const FEATURE: usize = 5;
        const ALL: usize = 2 * FEATURE + 4;
        type D = Dual<ALL>;
        let placed = self.placement(
            at,
            |x, _| D::constant(x),
            |x, i| D::variable(x, 2 * FEATURE + i),
        )?;
        let fixed = self.fixed.map(|i, x| D::variable(x, i));
        let moving = self.moving.map(|i, x| D::variable(x, FEATURE + i));
        let slope = contact_function(&fixed, &moving, &placed).slope;
        let of = |first: usize| -> [f64; FEATURE] { core::array::from_fn(|i| slope[first + i]) };
        let axis = |first: usize| [slope[2 * FEATURE + first], slope[2 * FEATURE + first + 1]];
        Ok(ByDrawing {
            fixed: by_vertices(self.drawn.0, of(0)),
            moving: by_vertices(self.drawn.1, of(FEATURE)),
            fixed_axis: axis(0),
            moving_axis: axis(2),
        })
    }
}

/// Converts derivatives by the numbers of a feature's outline to derivatives by the vertices of the part.
fn by_vertices(drawn: Drawn, slope: [f64; 5]) -> Vec<ByVertex> {
    let Drawn {
        name,
        next,
        reversed,
    } = drawn;
    let by = |vertex: u32, by_position: [f64; 2], by_bulge: f64| ByVertex {
        loop_index: name.loop_index,
        vertex,
        by_position,
        by_bulge,
    };
    let [a, b, c, d, bulge] = slope;
    if name.kind == FeatureKind::Vertex {
        vec![by(name.index, [a, b], 0.0)]
    } else if reversed {
        vec![by(name.index, [c, d], -bulge), by(next, [a, b], 0.0)]
    } else {
        vec![by(name.index, [a, b], bulge), by(next, [c, d], 0.0)]
    }
}

impl Part {
    /// Text for one of the part's features: the name that the part gives it, or its kind and place, such as `line 3 of loop 0`.
    pub fn feature_text(&self, name: FeatureName) -> String {
        let (loop_index, index) = (name.loop_index, name.index);
        let feature = match name.kind {
            FeatureKind::Vertex => PartFeature::Vertex { loop_index, index },
            _ => PartFeature::Edge { loop_index, index },
        };
        match self.feature_name(feature) {
            Some(given) => given.to_owned(),
            None => name.to_string(),
        }
    }

    /// The feature that is called so, as [`feature_text`](Self::feature_text) does; `None` if there is none.
    pub fn feature_called(&self, text: &str) -> Option<FeatureName> {
        const KINDS: [FeatureKind; 4] = [
            FeatureKind::Vertex,
            FeatureKind::Line,
            FeatureKind::ConvexArc,
            FeatureKind::ConcaveArc,
        ];
        let places = (0..).zip(self.loops());
        let places =
            places.flat_map(|(l, outline)| (0..).zip(outline.vertices()).map(move |(i, _)| (l, i)));
        let mut all = places.flat_map(|(loop_index, index)| {
            KINDS.map(|kind| FeatureName {
                kind,
                loop_index,
                index,
            })
        });
        all.find(|&name| self.feature_text(name) == text)
    }

    /// The outline of one of its features in its own frame, with material on the left; `None` if it has no such feature.
    pub fn feature_shape(&self, name: FeatureName) -> Option<FeatureShape<f64>> {
        let outline = self.loops().get(name.loop_index as usize)?;
        let index = name.index as usize;
        if name.kind == FeatureKind::Vertex {
            let v = outline.vertices().get(index)?;
            return Some(FeatureShape::Vertex { at: [v.x, v.y] });
        }
        outline.edge(index).map(FeatureShape::from)
    }
}
