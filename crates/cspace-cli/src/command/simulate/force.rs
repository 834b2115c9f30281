//! Forces as columns of a table.

use cspace_model::Mechanism;
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

#[cfg(test)]
mod tests {
    use super::*;
    use cspace::Part;
    use cspace_model::{Drive, DriveMotion, PartEntry};

    /// The forces of a pair are added up, a part's range and its drive have columns of their own.
    #[test]
    fn columns_hold_sums() {
        let block = |name: &str, x: f64| Part::rectangle(name, (x, 0.0), 2.0, 2.0).unwrap();
        let mut model = Mechanism::new("blocks");
        let slide = cspace::Axis::prismatic(cspace::Vector::new(1.0, 0.0)).within(0.0, 9.0);
        (model.parts).push(PartEntry::prismatic(block("a", 0.0), (1.0, 0.0)));
        (model.parts).push(PartEntry::prismatic(block("b", 4.0), (1.0, 0.0)));
        model.parts[1].axis = Some(slide);
        let motion = DriveMotion::Rate(1.0);
        model.dynamics.drives.push(Drive { part: 0, motion });
        let all = columns(&model, &[[0, 1]]);
        let names: Vec<String> = all.iter().map(Column::name).collect();
        let expected = [
            "a-b.normal",
            "a-b.tangential",
            "b.limit",
            "a.force",
            "a.power",
        ];
        assert_eq!(names, expected);
        let contact = |fixed: &str, normal, tangential| ContactForce {
            what: What::Contact {
                fixed: fixed.to_owned(),
                moving: "b".to_owned(),
                features: ["".to_owned(), "".to_owned()],
            },
            at: None,
            normal,
            tangential,
        };
        let limit = ContactForce {
            what: What::Limit {
                part: "b".to_owned(),
                limit: cspace_motion::End::Upper,
            },
            at: None,
            normal: 7.0,
            tangential: 0.0,
        };
        let forces = Forces {
            contacts: vec![
                contact("a", 1.0, 0.5),
                contact("a", 2.0, -0.25),
                contact("c", 9.0, 9.0),
                limit,
            ],
            joints: Vec::new(),
            drives: vec![DriveForce {
                part: "a".to_owned(),
                force: 3.0,
                power: 4.0,
            }],
        };
        let values: Vec<f64> = all.iter().map(|c| c.value(&forces)).collect();
        assert_eq!(values, [3.0, 0.25, 7.0, 3.0, 4.0]);
        assert!(all.iter().all(|c| c.value(&Forces::default()) == 0.0));
    }
}
