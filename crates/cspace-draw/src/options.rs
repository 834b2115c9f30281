//! Options of all pictures.

/// Labels of a picture beside its axes and its title.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Labels {
    /// No labels.
    None,
    /// Labels that fit: no label lies on another.
    #[default]
    Auto,
    /// Labels that fit, and those of the features of parts, as answers call them, that fit.
    Features,
    /// All labels, and numbers of vertices and features.
    All,
}

/// Options for making a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PictureOptions {
    /// Width and height in dots; `None` for a size that fits the content.
    pub size: Option<(f64, f64)>,
    /// Title above the picture.
    pub title: String,
    /// The label of the unit of length.
    pub unit: Option<String>,
    /// Labels of the picture.
    pub labels: Labels,
    /// Range of the first coordinate in view: x in the unit of length, or u (radians if it is an angle); all if `None`.
    pub x: Option<(f64, f64)>,
    /// Range of the second coordinate in view.
    pub y: Option<(f64, f64)>,
}

impl PictureOptions {
    /// A length with its unit.
    pub(crate) fn length(&self, number: &str) -> String {
        match &self.unit {
            Some(unit) => format!("{number} {unit}"),
            None => number.to_owned(),
        }
    }

    /// The size, and of letters: as large as the picture allows that was designed for `usual`.
    pub(crate) fn sized(&self, usual: (f64, f64)) -> ((f64, f64), f64) {
        /// The size of letters in a picture of the usual size, and the least.
        const LETTERS: f64 = 13.0;
        const LEAST: f64 = 7.0;
        let size = self.size.unwrap_or(usual);
        let share = (size.0 / usual.0).min(size.1 / usual.1);
        (size, (LETTERS * share).max(LEAST))
    }
}
