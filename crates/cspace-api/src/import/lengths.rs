//! The unit of a model that is made of drawings, and the factor of their lengths.

use std::path::Path;

use cspace_drawing::{Conversion, Drawing};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::host::Host;

/// How lengths of drawings become those of a model.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Lengths {
    /// Multiply all lengths by this; nothing else converts them then [default: from the drawing's unit to the model's]
    #[cfg_attr(feature = "command", arg(long, value_name = "F", value_parser = crate::given::factor, allow_negative_numbers = true))]
    pub scale: Option<f64>,
    /// The unit of length of the model: a drawing that names another is converted, one that names none is taken to be in it [default: that
    /// of the first drawing that names one]
    #[cfg_attr(feature = "command", arg(long, value_name = "LABEL"))]
    pub unit: Option<String>,
}

impl Lengths {
    /// The unit that the model names: as asked for, or that of the first drawing that names one.
    ///
    /// # Errors
    /// If two drawings in different units are multiplied by the same.
    pub fn unit<'a>(
        &self,
        drawings: impl IntoIterator<Item = &'a Drawing>,
        host: &dyn Host,
    ) -> Result<Option<String>, Error> {
        if self.unit.is_some() {
            return Ok(self.unit.clone());
        }
        let mut named = drawings.into_iter().filter_map(|d| d.unit);
        let first = named.next();
        let Some(scale) = self.scale else {
            return Ok(first.map(|u| u.label().to_owned()));
        };
        if let (Some(first), Some(other)) = (first, named.find(|u| Some(*u) != first)) {
            let option = host.option("scale");
            return Err(Error::new(format_args!(
                "one drawing is in {:?}, another in {:?}, and {option} multiplies both by the same",
                first.label(),
                other.label()
            ))
            .help(format_args!(
                "leave out {option} to have them converted, or name the unit of the result with {}",
                host.option("unit")
            )));
        }
        // What is scaled is no longer in the drawing's unit.
        let kept = first.filter(|_| scale == 1.0);
        Ok(kept.map(|u| u.label().to_owned()))
    }

    /// The factor of the lengths of a drawing for a model in a unit.
    pub fn factor(
        &self,
        path: &Path,
        drawing: &Drawing,
        unit: Option<&str>,
        host: &dyn Host,
    ) -> f64 {
        if let Some(scale) = self.scale {
            return scale;
        }
        let conversion = Conversion::new(drawing.unit, unit);
        if let Some(note) = conversion.note(&format!("{} 1", host.option("scale"))) {
            host.note(&format_args!("{}: {note}", path.display()));
        }
        conversion.factor()
    }
}
