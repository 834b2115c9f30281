//! Forces as columns of a table.

use cspace::Mechanism;
use cspace_motion::{ContactForce, DriveForce, Forces, What};

/// A column: its name, and its number.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Column {
    /// The force with which two parts press on each other, and that of friction: sums over their contacts.
    Pair {
        parts: [String; 2],
        tangential: bool,
    },
    /// The force at the ends of a part's range.
    Limit { part: String },
    /// The force or torque of a drive, and its power.
    Drive { part: String, power: bool },
}

/// The columns of a mechanism: of each pair that can meet, of each part with a range, of each drive.
pub(super) fn columns(model: &Mechanism, pairs: &[[usize; 2]]) -> Vec<Column> {
    let name = |i: usize| model.parts[i].part.name().to_owned();
    let mut all = Vec::new();
    for pair in pairs {
        let parts = pair.map(name);
        all.extend([false, true].map(|tangential| Column::Pair {
            parts: parts.clone(),
            tangential,
        }));
    }
    for (i, entry) in model.parts.iter().enumerate() {
        if entry.axis.is_some_and(|a| a.range.is_some()) {
            all.push(Column::Limit { part: name(i) });
        }
    }
    for drive in &model.dynamics.drives {
        all.extend([false, true].map(|power| Column::Drive {
            part: name(drive.part),
            power,
        }));
    }
    all
}

impl Column {
    pub(super) fn name(&self) -> String {
        match self {
            Self::Pair {
                parts: [a, b],
                tangential,
            } => {
                let which = if *tangential { "tangential" } else { "normal" };
                format!("{a}-{b}.{which}")
            }
            Self::Limit { part } => format!("{part}.limit"),
            Self::Drive { part, power } => {
                let which = if *power { "power" } else { "force" };
                format!("{part}.{which}")
            }
        }
    }

    /// Its number at a time; 0 where nothing touches.
    pub(super) fn value(&self, forces: &Forces) -> f64 {
        let contacts = |is: &dyn Fn(&What) -> bool, of: fn(&ContactForce) -> f64| -> f64 {
            let those = forces.contacts.iter().filter(|c| is(&c.what));
            those.map(of).fold(0.0, |sum, x| sum + x)
        };
        match self {
            Self::Pair {
                parts: [a, b],
                tangential,
            } => contacts(
                &|what| matches!(what, What::Contact { fixed, moving, .. } if fixed == a && moving == b),
                match tangential {
                    true => |c| c.tangential,
                    false => |c| c.normal,
                },
            ),
            Self::Limit { part } => contacts(
                &|what| matches!(what, What::Limit { part: p, .. } if p == part),
                |c| c.normal,
            ),
            Self::Drive { part, power } => {
                let drive = forces.drives.iter().find(|d| d.part == *part);
                let of = |d: &DriveForce| if *power { d.power } else { d.force };
                drive.map_or(0.0, of)
            }
        }
    }
}
