//! Units in which text and pictures show forces and what is made of them.
//!
//! Models, tables and JSON have kg, the model's unit of length, and s. An engineer reads newtons.

use cspace_drawing::Unit;

/// Kind of a number of a mechanism in which forces act.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// kg·unit/s².
    Force,
    /// kg·unit²/s².
    Torque,
    /// kg·unit²/s².
    Energy,
    /// kg·unit²/s³.
    Power,
    /// Force per length, kg/s².
    Stiffness,
    /// Force per rate, kg/s.
    Damping,
    /// Torque per radian, kg·unit²/s².
    TorsionStiffness,
    /// Torque per rad/s, kg·unit²/s.
    TorsionDamping,
}

/// A unit that text and pictures name.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// Numbers of the model are multiplied by it.
    pub factor: f64,
    /// Its name; that of an unknown unit of length is as the model has it.
    pub name: String,
}

/// Units by their size in SI, the smallest first.
type Ladder = [(f64, &'static str)];

/// In N.
const FORCES: &Ladder = &[
    (1e-9, "nN"),
    (1e-6, "µN"),
    (1e-3, "mN"),
    (1.0, "N"),
    (1e3, "kN"),
    (1e6, "MN"),
];
/// In N·m. Below 1 N·m designers of mechanisms say N·mm, in models of any unit.
const TORQUES: &Ladder = &[
    (1e-9, "µN·mm"),
    (1e-6, "mN·mm"),
    (1e-3, "N·mm"),
    (1.0, "N·m"),
    (1e3, "kN·m"),
    (1e6, "MN·m"),
];
/// In J.
const ENERGIES: &Ladder = &[
    (1e-9, "nJ"),
    (1e-6, "µJ"),
    (1e-3, "mJ"),
    (1.0, "J"),
    (1e3, "kJ"),
    (1e6, "MJ"),
];
/// In W.
const POWERS: &Ladder = &[
    (1e-9, "nW"),
    (1e-6, "µW"),
    (1e-3, "mW"),
    (1.0, "W"),
    (1e3, "kW"),
    (1e6, "MW"),
];
/// In N/m.
const STIFFNESSES: &Ladder = &[(1e-3, "mN/m"), (1.0, "N/m"), (1e3, "N/mm"), (1e6, "kN/mm")];
/// In N·s/m.
const DAMPINGS: &Ladder = &[(1e-3, "mN·s/m"), (1.0, "N·s/m"), (1e3, "N·s/mm")];

impl Quantity {
    /// The unit in which numbers of the model are shown of which this one is the largest: the largest of newtons, watts and so on, with
    /// their prefixes, in which it is at least 1. Where lengths have no unit that is known, the model's own.
    ///
    /// ```
    /// use cspace_model::Quantity;
    /// let torque = Quantity::Torque.shown(Some("mm"), 30_000.0);
    /// assert_eq!((torque.factor * 30_000.0, &torque.name[..]), (30.0, "N·mm"));
    /// assert_eq!(Quantity::Force.shown(None, 3.0).name, "kg·unit/s²");
    /// ```
    pub fn shown(self, length: Option<&str>, largest: f64) -> Shown {
        let Some(unit) = length.and_then(Unit::of_label) else {
            return Shown {
                factor: 1.0,
                name: self.own(length.unwrap_or("unit")),
            };
        };
        let (ladder, power, after) = match self {
            Self::Force => (FORCES, 1, ""),
            Self::Torque => (TORQUES, 2, ""),
            Self::Energy => (ENERGIES, 2, ""),
            Self::Power => (POWERS, 2, ""),
            Self::Stiffness => (STIFFNESSES, 0, ""),
            Self::Damping => (DAMPINGS, 0, ""),
            Self::TorsionStiffness => (TORQUES, 2, "/rad"),
            Self::TorsionDamping => (TORQUES, 2, "·s/rad"),
        };
        // The length of a unit in metres, and of a step in units: of the two one is a whole number, and divides without another rounding.
        let [per_metre, metres] = [Unit::Metre.ratio(unit), unit.ratio(Unit::Metre)];
        let factor = |size: f64| match per_metre >= 1.0 {
            true => (per_metre.powi(power) * size).recip(),
            false => metres.powi(power) / size,
        };
        let size = |&(size, _): &(f64, &str)| factor(size) * largest.abs() >= 1.0;
        let (size, name) = match largest == 0.0 {
            true => (ladder.iter()).find(|step| step.0 == 1.0),
            false => ladder.iter().rev().find(|step| size(step)),
        }
        .unwrap_or(&ladder[0]);
        Shown {
            factor: factor(*size),
            name: format!("{name}{after}"),
        }
    }

    /// The unit of the numbers of a model in which lengths have this unit.
    fn own(self, length: &str) -> String {
        match self {
            Self::Force => format!("kg·{length}/s²"),
            Self::Torque | Self::Energy => format!("kg·{length}²/s²"),
            Self::Power => format!("kg·{length}²/s³"),
            Self::Stiffness => "kg/s²".to_owned(),
            Self::Damping => "kg/s".to_owned(),
            Self::TorsionStiffness => format!("kg·{length}²/s² per rad"),
            Self::TorsionDamping => format!("kg·{length}²/s"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Quantity;

    /// Numbers of models in several units, against the definitions of the units.
    #[test]
    fn numbers_are_those_of_the_definitions() {
        for (quantity, unit, number, shown, name) in [
            (Quantity::Force, "mm", 10_328.0, 10.328, "N"),
            (Quantity::Force, "mm", -1.0, -1.0, "mN"),
            (Quantity::Force, "m", 9.81, 9.81, "N"),
            (Quantity::Force, "cm", 100.0, 1.0, "N"),
            // An inch is 0.0254 m by definition.
            (Quantity::Force, "in", 1000.0, 25.4, "N"),
            (Quantity::Force, "km", 5.0, 5.0, "kN"),
            (Quantity::Force, "nm", 1e-3, 1e-3, "nN"),
            (Quantity::Torque, "mm", 188_496.0, 188.496, "N·mm"),
            (Quantity::Torque, "mm", 2.5e6, 2.5, "N·m"),
            (Quantity::Torque, "m", 0.25, 250.0, "N·mm"),
            (Quantity::Energy, "mm", 572.709, 572.709, "µJ"),
            (Quantity::Energy, "ft", 1e4, 0.3048 * 0.3048 * 1e4, "J"),
            (Quantity::Power, "mm", 194_301.0, 194.301, "mW"),
            (Quantity::Power, "mm", 2e9, 2.0, "kW"),
            (Quantity::Stiffness, "mm", 8025.0, 8.025, "N/mm"),
            (Quantity::Stiffness, "in", 12.0, 12.0, "N/m"),
            (Quantity::Damping, "mm", 16.05, 16.05, "N·s/m"),
            (Quantity::TorsionStiffness, "mm", 5000.0, 5.0, "N·mm/rad"),
            (Quantity::TorsionDamping, "m", 3.0, 3.0, "N·m·s/rad"),
        ] {
            let found = quantity.shown(Some(unit), number);
            let rounding = 4.0 * f64::EPSILON * f64::abs(shown);
            assert!(
                (found.factor * number - shown).abs() <= rounding,
                "{number} {unit}: {found:?}"
            );
            assert_eq!(found.name, name, "{number} {unit}");
        }
    }

    #[test]
    fn zero_and_unknown_units_have_names() {
        assert_eq!(Quantity::Power.shown(Some("mm"), 0.0).name, "W");
        for (quantity, name) in [
            (Quantity::Force, "kg·furlong/s²"),
            (Quantity::Torque, "kg·furlong²/s²"),
            (Quantity::Power, "kg·furlong²/s³"),
            (Quantity::Stiffness, "kg/s²"),
        ] {
            let found = quantity.shown(Some("furlong"), 1e6);
            assert_eq!((found.factor, &found.name[..]), (1.0, name));
        }
    }
}
