//! Mass, centre of mass and moment of inertia.

use cspace::geometry::Point;
use serde::{Deserialize, Serialize};

/// The mass of a part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mass {
    /// Total mass, in kg.
    Total(f64),
    /// Mass per unit of area, in kg per square of the model's unit of length.
    Density(f64),
}

/// The mass of a part and its distribution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MassProperties {
    /// The mass in kg.
    pub mass: f64,
    /// The centre of mass in the part's frame.
    pub center: Point,
    /// The moment of inertia about the centre of mass, kg·unit².
    pub inertia: f64,
}

impl MassProperties {
    /// Sum of the properties of several parts that move as one; `None` of none.
    pub fn sum(parts: &[Self]) -> Option<Self> {
        if let [one] = parts {
            return Some(*one);
        }
        let first = parts.first()?.center;
        let mass: f64 = parts.iter().map(|p| p.mass).sum();
        let center = (parts.iter()).fold(first, |c, p| c + (p.center - first) * (p.mass / mass));
        let inertia = parts.iter().map(|p| p.inertia_about(center)).sum();
        Some(Self {
            mass,
            center,
            inertia,
        })
    }

    /// The moment of inertia about another point p of the part's frame: J + m |p − c|², where c is the centre of mass.
    pub fn inertia_about(&self, p: Point) -> f64 {
        self.inertia + self.mass * (p - self.center).length_squared()
    }
}
