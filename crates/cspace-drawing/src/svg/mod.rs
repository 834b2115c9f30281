//! Drawings in SVG.
//!
//! Elements are walked in document order with the transform from their coordinates to the drawing's, whose y axis points up
//! ([`walk`], [`frame`]). Shapes and paths become paths ([`shapes`], [`path`]): circular arcs stay arcs, elliptical ones and Béziers are
//! curves to fit. What is not drawn by its style is left out ([`style`]).

mod fill;
mod frame;
mod length;
mod path;
mod shapes;
mod style;
mod walk;
mod xml;

use roxmltree::Error;

use crate::drawing::Drawing;
use crate::error::DrawingError;
use crate::source::Source;

/// Reads the drawing in the bytes of a file; only the element of an id, or some layers, if requested.
pub(crate) fn read(bytes: &[u8], source: &Source) -> Result<Drawing, DrawingError> {
    let text = core::str::from_utf8(bytes).map_err(|e| {
        let message = format!("byte {} is no UTF-8", e.valid_up_to());
        DrawingError::file(message, "save the drawing again in UTF-8")
    })?;
    let text = text.trim_start_matches('\u{feff}');
    let (plain, whole);
    let mut text = text;
    let mut document = xml::parse(text);
    // Drawing programs write comments with two hyphens, and read them.
    if matches!(document, Err(Error::InvalidComment(_))) {
        plain = xml::with_plain_comments(text);
        text = &plain;
        document = xml::parse(text);
    }
    if matches!(document, Err(Error::UnknownNamespace(..))) {
        whole = xml::declared(text);
        document = xml::parse(whole.as_deref().unwrap_or(text));
    }
    let document = document.map_err(|e| DrawingError::File {
        line: Some(e.pos().row as usize),
        message: format!("the file is no XML: {e}"),
        help: "export the drawing again as SVG".to_owned(),
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let message = format!(
            "the file is XML, but of <{}>, not <svg>",
            root.tag_name().name()
        );
        return Err(DrawingError::file(message, "export the drawing as SVG"));
    }
    walk::walk(&document, source)
}
