//! Drawings from files.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::drawing::Drawing;
use crate::dxf::DxfError;
use crate::error::DrawingError;
use crate::source::Source;
use crate::{dxf, points, svg};

/// The largest file read, in bytes: some millions of entities.
const LARGEST: u64 = 512 << 20;

/// Whether a file's extension is that of a drawing.
pub fn is_drawing(path: &Path) -> bool {
    Format::of_extension(path).is_some()
}

fn extension(path: &Path) -> String {
    let extension = path.extension().unwrap_or_default();
    extension.to_string_lossy().to_ascii_lowercase()
}

/// Formats of drawings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// DXF, text or binary.
    Dxf,
    /// SVG.
    Svg,
    /// Points in text.
    Points,
}

impl Format {
    /// The format that a file's extension names: dxf, svg, or csv, txt or dat of points.
    pub fn of_extension(path: &Path) -> Option<Self> {
        Some(match extension(path).as_str() {
            "dxf" => Self::Dxf,
            "svg" => Self::Svg,
            "csv" | "txt" | "dat" => Self::Points,
            _ => return None,
        })
    }
}

/// Reads a drawing; its extension determines the format.
///
/// # Errors
/// If the file cannot be read, or is no drawing. Entities that cannot be used are reported by [`Drawing::outlines`].
pub fn read(path: impl AsRef<Path>, source: &Source) -> Result<Drawing, DrawingError> {
    let path = path.as_ref();
    // A file of another kind is refused before it is read.
    format_of(path)?;
    named(path, &bytes(path)?, source)
}

/// Reads the bytes of a drawing's file, for [`named`].
///
/// # Errors
/// If the extension is not that of a drawing, or the file cannot be read.
pub fn bytes_of(path: impl AsRef<Path>) -> Result<Vec<u8>, DrawingError> {
    let path = path.as_ref();
    format_of(path)?;
    bytes(path)
}

/// Reads the drawing in the bytes of a file of this name, whose extension determines the format: as [`read`], without
/// the disk.
///
/// ```
/// use cspace_drawing::{Source, named};
/// let text = br#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="2"/></svg>"#;
/// let drawing = named("coin.svg", text, &Source::default())?;
/// assert_eq!((drawing.name.as_str(), drawing.entities.len()), ("coin", 1));
/// assert!(named("coin.dwg", text, &Source::default()).is_err());
/// # Ok::<(), cspace_drawing::DrawingError>(())
/// ```
///
/// # Errors
/// If the extension is not that of a drawing, or the bytes are no drawing of the format.
pub fn named(
    file: impl AsRef<Path>,
    bytes: &[u8],
    source: &Source,
) -> Result<Drawing, DrawingError> {
    let file = file.as_ref();
    let mut drawing = from_bytes(bytes, format_of(file)?, source)?;
    drawing.name = (file.file_stem())
        .map(|s| s.to_string_lossy().into_owned())
        .unwrap_or_default();
    Ok(drawing)
}

/// The format that a file's extension names.
fn format_of(path: &Path) -> Result<Format, DrawingError> {
    if let Some(format) = Format::of_extension(path) {
        return Ok(format);
    }
    let extension = extension(path);
    if extension == "dwg" {
        let help = "save the drawing as DXF in the program that made it";
        return Err(DrawingError::file("DWG files are not read", help));
    }
    let message = format!("the extension {extension:?} is not that of a drawing");
    Err(DrawingError::file(
        message,
        "drawings end in .dxf, .svg, or .csv, .txt or .dat of points",
    ))
}

/// Reads the drawing in the bytes of a file; it has no name.
///
/// # Errors
/// If the bytes are no drawing of the format.
pub fn from_bytes(bytes: &[u8], format: Format, source: &Source) -> Result<Drawing, DrawingError> {
    match format {
        Format::Dxf => dxf::read(bytes, source).map_err(|e| match dxf::is_binary(bytes) {
            _ if e.line == DxfError::WHOLE => DrawingError::file(e.message, e.help),
            true => DrawingError::file(format!("byte {}: {}", e.line, e.message), e.help),
            false => DrawingError::File {
                line: Some(e.line),
                message: e.message,
                help: e.help,
            },
        }),
        Format::Svg => svg::read(bytes, source),
        Format::Points => points::read(bytes),
    }
}

/// The bytes of a regular file: a pipe might never say anything, a device might never end.
fn bytes(path: &Path) -> Result<Vec<u8>, DrawingError> {
    let unreadable =
        |e: std::io::Error| DrawingError::file(format!("it cannot be read: {e}"), "check the path");
    let meta = std::fs::metadata(path).map_err(unreadable)?;
    if !meta.is_file() {
        return Err(DrawingError::file("it is no regular file", "give a file"));
    }
    let too_large = || {
        let message = format!("it is too large: at most {LARGEST} bytes are read");
        DrawingError::file(message, "remove what is no outline, or split the drawing")
    };
    if meta.len() > LARGEST {
        return Err(too_large());
    }
    let mut bytes = Vec::with_capacity(meta.len() as usize);
    let file = File::open(path).map_err(unreadable)?;
    file.take(LARGEST + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if bytes.len() as u64 > LARGEST {
        return Err(too_large());
    }
    Ok(bytes)
}
