//! Phase of an event in words: the angle of the evenly driven part, or the time.

use core::f64::consts::TAU;

use super::number::plain;
use crate::system::{PartCoordinates, System};
use cspace::AxisMotion;

/// Clock of the report: the angle of a part that is driven evenly, or the time.
pub(super) struct Clock<'a> {
    system: &'a System,
    /// The part that turns evenly, its coordinate and its drive.
    driver: Option<(usize, usize)>,
}

impl<'a> Clock<'a> {
    /// The first part that is driven to turn at a constant rate, or else time.
    pub(super) fn of(system: &'a System) -> Self {
        let even = system.drives().iter().find_map(|(i, curve)| {
            let part = system.parts().iter().position(|p| {
                let turns = matches!(
                    p,
                    PartCoordinates::Axis {
                        motion: AxisMotion::Revolute { .. },
                        ..
                    }
                );
                turns && p.indices().start == *i
            })?;
            curve.even_rate().filter(|r| *r != 0.0).map(|_| (part, *i))
        });
        Self {
            system,
            driver: even,
        }
    }

    /// The index of the part that turns evenly.
    pub(super) fn driver(&self) -> Option<usize> {
        self.driver.map(|d| d.0)
    }

    /// Name of the driven part.
    pub(super) fn name(&self) -> Option<&'a str> {
        let part = self.driver()?;
        Some(self.system.mechanism().parts[part].part.name())
    }

    /// Whether the driven part has a range.
    fn has_range(&self) -> bool {
        let part = self.driver().map(|i| &self.system.mechanism().parts[i]);
        part.and_then(|p| p.axis)
            .is_some_and(|axis| axis.range.is_some())
    }

    /// A time as a number.
    fn number(&self, t: f64) -> String {
        let curve = self.driver.and_then(|(_, i)| {
            let mut drives = self.system.drives().iter();
            drives.find(|d| d.0 == i).map(|d| &d.1)
        });
        match curve {
            Some(curve) => {
                let turned = curve.at(t).value;
                // An angle of a part that does not turn all around is that of its range.
                let turned = match self.has_range() {
                    true => turned.to_degrees(),
                    false => turned.rem_euclid(TAU).to_degrees(),
                };
                let shown = plain(turned, 1);
                // A turn but for rounding is none.
                if shown == "360.0" {
                    "0.0".to_owned()
                } else {
                    shown
                }
            }
            None => plain(t, 3),
        }
    }

    fn unit(&self) -> String {
        match self.name() {
            Some(name) => format!("deg of the {name}"),
            None => "s".to_owned(),
        }
    }

    /// `201.3 deg of the driver`.
    pub(super) fn at(&self, t: f64) -> String {
        format!("{} {}", self.number(t), self.unit())
    }

    /// As above, for a second time in the same sentence: the part that turns is not named again.
    pub(super) fn again(&self, t: f64) -> String {
        let unit = if self.driver.is_some() { "deg" } else { "s" };
        format!("{} {unit}", self.number(t))
    }

    /// `from 10.0 to 20.0 and from 30.0 to 40.0 deg of the driver`.
    pub(super) fn spans(&self, spans: &[(f64, f64)]) -> String {
        let each: Vec<String> = (spans.iter())
            .map(|(a, b)| format!("from {} to {}", self.number(*a), self.number(*b)))
            .collect();
        format!("{} {}", each.join(" and "), self.unit())
    }
}
