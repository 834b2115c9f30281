//! Mass, centre of mass and moment of inertia.

use crate::geometry::Point;

/// How much mass a part has.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Mass {
    /// All of it, in kg.
    Total(f64),
    /// So much on a unit of area, in kg per square of the model's unit of length.
    Density(f64),
}

/// The mass of a part and how it is spread.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MassProperties {
    /// The mass in kg.
    pub mass: f64,
    /// The centre of mass in the part's frame.
    pub center: Point,
    /// The moment of inertia about the centre of mass, kg·unit².
    pub inertia: f64,
}

impl MassProperties {
    /// The moment of inertia about another point p of the part's frame: J + m |p − c|², c the centre of mass.
    pub fn inertia_about(&self, p: Point) -> f64 {
        self.inertia + self.mass * (p - self.center).length_squared()
    }
}
