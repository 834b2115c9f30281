//! Where an outline is put that was drawn elsewhere.

use core::f64::consts::FRAC_PI_2;

use cspace::geometry::Rotation;
use cspace::{Part, PartError, Point, Real, Vector, Vertex};
use schemars::JsonSchema;
use serde::Deserialize;

/// The axis through the origin at which an outline is mirrored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Mirror {
    /// The x axis: y changes its sign.
    X,
    /// The y axis: x changes its sign.
    Y,
}

impl Mirror {
    /// Both, by their names.
    pub const ALL: [(&'static str, Self); 2] = [("x", Self::X), ("y", Self::Y)];

    /// The mirror image of a point.
    pub fn point<T: Real>(self, p: Point<T>) -> Point<T> {
        match self {
            Self::X => Point::new(p.x, -p.y),
            Self::Y => Point::new(-p.x, p.y),
        }
    }
}

/// Place of an outline: it is mirrored, then turned about the origin, then moved.
///
/// ```
/// use cspace::Part;
/// use cspace_drawing::{Mirror, Placement};
/// let part = Part::rectangle("lug", (2.0, 1.0), 4.0, 2.0)?; // x from 0 to 4, y from 0 to 2
/// let placement = Placement { at: [10.0, 0.0].into(), turn: core::f64::consts::FRAC_PI_2, mirror: Some(Mirror::Y) };
/// let placed = placement.part(&part)?;
/// assert_eq!((placed.bounds().min.x, placed.bounds().max.y), (8.0, 0.0));
/// # Ok::<(), cspace::PartError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement<T = f64> {
    /// Where the origin of the outline is moved to.
    pub at: Vector<T>,
    /// The turn about the origin, radians, counter-clockwise.
    pub turn: T,
    /// The axis at which it is mirrored first, if it is.
    pub mirror: Option<Mirror>,
}

impl<T: Real> Placement<T> {
    /// Leaves everything where it is.
    pub fn none() -> Self {
        let zero = T::constant(0.0);
        Self {
            at: Vector::new(zero, zero),
            turn: zero,
            mirror: None,
        }
    }

    /// Some loops, placed. Vertices keep their order; the bulges of mirrored arcs change their signs.
    pub fn loops(&self, loops: &[Vec<Vertex<T>>]) -> Vec<Vec<Vertex<T>>> {
        let rotation = rotation(self.turn);
        let place = |v: &Vertex<T>| {
            let (from, bulge) = match self.mirror {
                Some(mirror) => (mirror.point(v.point()), -v.bulge),
                None => (v.point(), v.bulge),
            };
            let at = rotation * (from - origin()) + self.at;
            Vertex::new(at.x, at.y, bulge)
        };
        let each = loops.iter();
        each.map(|l| l.iter().map(place).collect()).collect()
    }

    /// How placed vertices move with the numbers of the placement: what places them from where these numbers have their values to where
    /// they have others.
    #[must_use]
    pub fn beyond(&self) -> Self {
        let still = |x: T| T::constant(x.value());
        let turn = self.turn - still(self.turn);
        // Turned about where the origin was moved to, which is not that of the coordinates.
        let before = Vector::new(still(self.at.x), still(self.at.y));
        Self {
            at: self.at - rotation(turn) * before,
            turn,
            mirror: None,
        }
    }
}

impl Placement {
    /// A part, placed.
    ///
    /// # Errors
    /// If it is put so far from the origin that its details are lost.
    pub fn part(&self, part: &Part) -> Result<Part, PartError> {
        let loops = part.loops().iter().map(|l| l.vertices().to_vec());
        let loops: Vec<Vec<Vertex>> = loops.collect();
        part.redrawn(self.loops(&loops))
    }
}

fn origin<T: Real>() -> Point<T> {
    Point::new(T::constant(0.0), T::constant(0.0))
}

/// The rotation by an angle, whose sine and cosine are exact at quarter turns.
fn rotation<T: Real>(turn: T) -> Rotation<T> {
    let rotation = Rotation::by(turn);
    let quarters = turn.value() / FRAC_PI_2;
    if quarters.fract() != 0.0 || quarters == 0.0 {
        return rotation;
    }
    let whole = |x: T| x + T::constant(x.value().round() - x.value());
    Rotation {
        cos: whole(rotation.cos),
        sin: whole(rotation.sin),
    }
}
