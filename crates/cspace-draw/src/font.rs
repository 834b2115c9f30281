//! The letters of pictures that cannot name a font: outlines and widths.

use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId, OutlineBuilder};

use crate::scene::{Anchor, Dot, Text};

/// Font families for SVG, the preferred one first.
pub(crate) const FAMILY: &str = "Ubuntu, Ubuntu Light, Helvetica, Arial, sans-serif";

static FACE: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::parse(epaint_default_fonts::UBUNTU_LIGHT, 0).ok());

/// The width of a text in dots, with letters of a size.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    laid_out(text, size).1
}

/// The width of the line along letters that have an edge: half of it is outside.
pub(crate) fn halo(size: f64) -> f64 {
    0.25 * size
}

/// Positions of the letters of a text.
pub(crate) struct Placed {
    at: Dot,
    left: f64,
    upwards: bool,
}

impl Placed {
    pub(crate) fn of(text: &Text) -> Self {
        let width = width(&text.text, text.size);
        Self {
            at: text.at,
            left: match text.anchor {
                Anchor::Start => 0.0,
                Anchor::Middle => -0.5 * width,
                Anchor::End => -width,
            },
            upwards: text.upwards,
        }
    }

    /// The place of a point of the text that begins at the origin.
    pub(crate) fn at(&self, x: f64, y: f64) -> Dot {
        let x = x + self.left;
        if self.upwards {
            self.at.moved(y, -x)
        } else {
            self.at.moved(x, y)
        }
    }
}

/// A step of a letter's outline: a line, or a curve with one control point or two.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Stroke {
    Move(f64, f64),
    Line(f64, f64),
    Quad(f64, f64, f64, f64),
    Cubic(f64, f64, f64, f64, f64, f64),
    Close,
}

/// The outlines of a text that begins at the origin, in dots, y downwards.
pub(crate) fn outlines(text: &str, size: f64) -> Vec<Stroke> {
    let Some(face) = FACE.as_ref() else {
        return Vec::new();
    };
    let scale = size / f64::from(face.units_per_em());
    let mut strokes = Vec::new();
    for (glyph, left) in laid_out(text, size).0 {
        face.outline_glyph(
            glyph,
            &mut Pen {
                strokes: &mut strokes,
                left,
                scale,
            },
        );
    }
    strokes
}

/// The letters and where each begins, and the width of all. A letter that the font lacks is the box it has for those.
fn laid_out(text: &str, size: f64) -> (Vec<(GlyphId, f64)>, f64) {
    let Some(face) = FACE.as_ref() else {
        return (Vec::new(), 0.0);
    };
    let scale = size / f64::from(face.units_per_em());
    let mut x = 0.0;
    let mut letters = Vec::new();
    for c in text.chars() {
        let glyph = face.glyph_index(c).unwrap_or(GlyphId(0));
        letters.push((glyph, x));
        x += scale * f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
    }
    (letters, x)
}

struct Pen<'a> {
    strokes: &'a mut Vec<Stroke>,
    left: f64,
    scale: f64,
}

impl Pen<'_> {
    fn at(&self, x: f32, y: f32) -> (f64, f64) {
        (
            self.left + self.scale * f64::from(x),
            -self.scale * f64::from(y),
        )
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.strokes.push(Stroke::Move(x, y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.strokes.push(Stroke::Line(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((a, b), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.strokes.push(Stroke::Quad(a, b, x, y));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((a, b), (c, d), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.strokes.push(Stroke::Cubic(a, b, c, d, x, y));
    }

    fn close(&mut self) {
        self.strokes.push(Stroke::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_what_pictures_say() {
        let face = FACE.as_ref().unwrap();
        for c in "θ°−·–×±|/,.()0123456789 µ".chars() {
            assert!(face.glyph_index(c).is_some(), "{c}");
        }
        assert!(width("MM", 10.0) > width("ii", 10.0));
        assert!(outlines("θ", 12.0).len() > 8);
    }
}
