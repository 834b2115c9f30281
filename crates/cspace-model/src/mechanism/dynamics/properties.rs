//! Mass properties of parts: as given, or computed from the outline.

use cspace::geometry::Point;
use cspace::part::Part;

use super::data::PartDynamics;
use super::mass::{Mass, MassProperties};
use crate::mechanism::entries::Mechanism;

impl PartDynamics {
    /// Mass, centre of mass and inertia of a part; `None` for a part without mass.
    ///
    /// Values that are not given follow from the outline, as if the mass were spread over it evenly: with the area A, the centroid g and
    /// the polar second moment I about it ([`Part::moments`]),
    ///
    /// - a density ρ makes the mass m = ρ A,
    /// - the centre of mass is c = g,
    /// - the inertia about c is m (I / A + |c − g|²), also where another c is given.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::{Mass, PartDynamics};
    /// let disc = Part::circle("disc", (3.0, 0.0), 2.0)?;
    /// let heavy = PartDynamics { mass: Some(Mass::Total(0.5)), ..PartDynamics::default() };
    /// let properties = heavy.mass_properties(&disc).ok_or("it has a mass")?;
    /// assert!((properties.center.x - 3.0).abs() < 1e-15);
    /// assert!((properties.inertia - 0.5 * 0.5 * 4.0).abs() < 1e-15); // m r² / 2
    /// assert_eq!(PartDynamics::default().mass_properties(&disc), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mass_properties(&self, part: &Part) -> Option<MassProperties> {
        let moments = part.moments();
        let mass = match self.mass? {
            Mass::Total(mass) => mass,
            Mass::Density(density) => density * moments.area,
        };
        let center = self.center_of_mass.unwrap_or(moments.centroid);
        let inertia =
            (self.inertia).unwrap_or_else(|| mass * (moments.second_about(center) / moments.area));
        Some(MassProperties {
            mass,
            center,
            inertia,
        })
    }

    /// Copy of the data with what follows from the outline said in numbers, for a part of another outline.
    #[must_use]
    pub fn of_outline(&self, part: &Part) -> Self {
        match self.mass_properties(part) {
            Some(of) => Self {
                mass: Some(Mass::Total(of.mass)),
                inertia: Some(of.inertia),
                center_of_mass: Some(of.center),
                ..*self
            },
            None => *self,
        }
    }

    /// The centre of mass in the part's frame: as given, or the centroid of the outline. It is also defined for parts without mass: a load
    /// without a point acts there.
    pub fn center_of_mass(&self, part: &Part) -> Point {
        (self.center_of_mass).unwrap_or_else(|| part.moments().centroid)
    }
}

impl Mechanism {
    /// Mass, centre of mass and inertia of a part; `None` for a part without mass, and if no part has this index.
    pub fn mass_properties(&self, part: usize) -> Option<MassProperties> {
        let entry = self.parts.get(part)?;
        self.dynamics.part(part).mass_properties(&entry.part)
    }

    /// The mechanism with another outline of a part, which keeps the mass, the centre of mass and the inertia that it has.
    ///
    /// # Panics
    /// If no part has this index.
    #[must_use]
    pub fn with_outline(mut self, part: usize, outline: Part) -> Self {
        let kept = self.dynamics.part_mut(part);
        let drawn = &self.parts[part].part;
        *kept = kept.of_outline(drawn);
        // A load without a point acts at the centre of mass, also of a part without mass.
        kept.center_of_mass = Some(kept.center_of_mass(drawn));
        let entry = &mut self.parts[part];
        // What is declared was checked of the outline as drawn; it is detected of this one.
        entry.symmetry = None;
        entry.part = outline;
        self
    }
}
