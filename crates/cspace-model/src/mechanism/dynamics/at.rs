//! Checks of single values of an item.

use cspace::fixed_axes::{Axis, AxisMotion};

use super::fault::{DynamicsError, DynamicsFault, DynamicsItem};

pub(super) type Checked = Result<(), DynamicsError>;

/// Whether a part cannot move at all.
pub(super) fn stands_still(axis: Option<Axis>) -> bool {
    axis.is_some_and(|x| x.motion == AxisMotion::Fixed)
}

/// Item that is checked.
#[derive(Clone, Copy)]
pub(super) struct At(pub(super) DynamicsItem);

impl At {
    pub(super) fn fails(self, key: &'static str, fault: DynamicsFault) -> Checked {
        Err(DynamicsError {
            item: self.0,
            key,
            fault,
        })
    }

    pub(super) fn finite(self, key: &'static str, values: &[f64]) -> Checked {
        if values.iter().all(|x| x.is_finite()) {
            Ok(())
        } else {
            self.fails(key, DynamicsFault::NotFinite)
        }
    }

    pub(super) fn positive(self, key: &'static str, value: f64) -> Checked {
        self.finite(key, &[value])?;
        if value > 0.0 {
            Ok(())
        } else {
            self.fails(key, DynamicsFault::NotPositive(value))
        }
    }

    pub(super) fn not_negative(self, key: &'static str, value: f64) -> Checked {
        self.finite(key, &[value])?;
        if value >= 0.0 {
            Ok(())
        } else {
            self.fails(key, DynamicsFault::Negative(value))
        }
    }

    pub(super) fn up_to_one(self, key: &'static str, value: f64) -> Checked {
        self.finite(key, &[value])?;
        if (0.0..=1.0).contains(&value) {
            Ok(())
        } else {
            self.fails(key, DynamicsFault::NotUpToOne(value))
        }
    }

    pub(super) fn known(self, key: &'static str, part: usize, parts: usize) -> Checked {
        if part < parts {
            Ok(())
        } else {
            self.fails(key, DynamicsFault::NoSuchPart { part, parts })
        }
    }

    /// Checks that a part moves in the plane, or along an axis.
    pub(super) fn moves_as(
        self,
        key: &'static str,
        axis: Option<Axis>,
        in_the_plane: bool,
    ) -> Checked {
        if stands_still(axis) {
            self.fails(key, DynamicsFault::StandsStill)
        } else if in_the_plane && axis.is_some() {
            self.fails(key, DynamicsFault::OnAnAxis)
        } else if !in_the_plane && axis.is_none() {
            self.fails(key, DynamicsFault::InThePlane)
        } else {
            Ok(())
        }
    }

    pub(super) fn in_range(self, key: &'static str, value: f64, axis: Option<Axis>) -> Checked {
        match axis.and_then(|x| x.range) {
            Some((lo, hi)) if !(lo <= value && value <= hi) => {
                self.fails(key, DynamicsFault::OutOfRange { value, lo, hi })
            }
            _ => Ok(()),
        }
    }
}
