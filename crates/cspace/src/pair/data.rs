//! Configuration spaces of pairs of any class as plain data.

use crate::fixed_axes::AxesData;
use crate::part::Part;
use crate::space::{DataError, SAVED_VERSION, SpaceData, check_head};

use super::lower::{Joint, LowerPair, PermanentContact};

const FORMAT: &str = "lower-pair";

/// A lower pair as plain data.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LowerData {
    /// Always `lower-pair`.
    pub format: String,
    /// Version of the format.
    pub version: u32,
    /// The fixed part.
    pub fixed: Part,
    /// The moving part.
    pub moving: Part,
    /// The joint.
    pub joint: Joint,
    /// Least and largest motion, radians or the model's unit of length.
    pub limits: Option<(f64, f64)>,
    /// Permanent contacts. They follow from the joint, and are ignored on reading.
    pub contacts: Vec<PermanentContact>,
}

/// All of a configuration space as plain data; `format` identifies the class.
///
/// The schemas in the folder `docs` of the project's repository describe every field and its unit.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(untagged))]
pub enum PairData<'a> {
    /// Data of a general or symmetric pair; the format is `contact-space`.
    Planar(&'a SpaceData),
    /// Data of a pair with fixed axes; the format is `fixed-axes-space`.
    FixedAxes(&'a AxesData),
    /// Data of a lower pair; the format is `lower-pair`.
    Lower(Box<LowerData>),
}

impl LowerPair {
    /// The pair as plain data.
    pub fn data(&self) -> LowerData {
        LowerData {
            format: FORMAT.to_owned(),
            version: SAVED_VERSION,
            fixed: self.fixed().clone(),
            moving: self.moving().clone(),
            joint: self.joint(),
            limits: self.limits(),
            contacts: self.contacts().to_vec(),
        }
    }

    /// The pair from plain data.
    ///
    /// # Errors
    /// If the format or its version differs, a part is invalid, or a number is not finite or out of order.
    pub fn from_data(data: LowerData) -> Result<Self, DataError> {
        check_head(&data.format, FORMAT, data.version)?;
        let whole = |what, why| Err(DataError::Whole { what, why });
        let sound = match data.joint {
            Joint::Revolute { at } => at.is_finite(),
            Joint::Prismatic { direction, at } => {
                let unit = direction.unit();
                at.is_finite() && (unit.length() - 1.0).abs() < 1e-9
            }
        };
        if !sound {
            return whole(
                "the joint",
                "it has a number that is not finite, or no direction",
            );
        }
        if data
            .limits
            .is_some_and(|(lo, hi)| !(lo.is_finite() && hi.is_finite() && lo <= hi))
        {
            return whole("the limits", "they are not finite, or in the wrong order");
        }
        Ok(Self::new(
            &data.fixed,
            &data.moving,
            data.joint,
            data.limits,
        ))
    }
}
