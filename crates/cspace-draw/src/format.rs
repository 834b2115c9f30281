//! The formats of pictures.

use crate::error::PictureError;
use crate::pdf::pdf;
use crate::png::png;
use crate::scene::Scene;
use crate::svg::svg;

/// A format of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// Scalable, for pages and editors.
    Svg,
    /// Raster image.
    Png,
    /// Scalable, for print.
    Pdf,
}

impl PictureFormat {
    /// The format that a file's extension names, in small or capital letters.
    ///
    /// ```
    /// use cspace_draw::PictureFormat;
    /// assert_eq!(PictureFormat::of_extension("PNG"), Some(PictureFormat::Png));
    /// assert_eq!(PictureFormat::of_extension("jpg"), None);
    /// ```
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "svg" => Some(Self::Svg),
            "png" => Some(Self::Png),
            "pdf" => Some(Self::Pdf),
            _ => None,
        }
    }

    /// Writes the picture in this format.
    ///
    /// # Errors
    /// If the format does not allow the picture's size; only PNG has limits.
    pub fn write(self, scene: &Scene) -> Result<Vec<u8>, PictureError> {
        match self {
            Self::Svg => Ok(svg(scene).into_bytes()),
            Self::Png => png(scene),
            Self::Pdf => Ok(pdf(scene)),
        }
    }
}
