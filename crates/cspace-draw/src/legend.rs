//! Legend: lines below a picture that explain its colours.

use crate::colour::INK;
use crate::font;
use crate::plot::text;
use crate::scene::{Anchor, Area, Colour, Dot, Item, Path, Stroke};

/// Sign before an entry.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Sign {
    /// A line.
    Line(Colour),
    /// A field with an outline.
    Field(Colour, Colour),
    /// A round mark.
    Mark(Colour),
}

/// Entries in lines of a width.
pub(crate) struct Legend {
    lines: Vec<Vec<(f64, Sign, String)>>,
    /// The size of letters.
    pub(crate) em: f64,
}

impl Legend {
    /// Lays entries out, as many in a line as fit.
    pub(crate) fn new(entries: Vec<(Sign, String)>, width: f64, em: f64) -> Self {
        let mut lines: Vec<Vec<(f64, Sign, String)>> = Vec::new();
        let mut x = f64::INFINITY;
        for (sign, said) in entries {
            let wide = 2.2 * em + font::width(&said, 0.9 * em);
            if x + wide > width || lines.is_empty() {
                lines.push(Vec::new());
                x = 0.0;
            }
            if let Some(line) = lines.last_mut() {
                line.push((x, sign, said));
            }
            x += wide + 1.6 * em;
        }
        Self { lines, em }
    }

    /// Height of the legend.
    pub(crate) fn height(&self) -> f64 {
        1.5 * self.em * self.lines.len() as f64
    }

    /// Draws the legend with its upper left corner at a place.
    pub(crate) fn draw(self, items: &mut Vec<Item>, at: Dot) {
        let em = self.em;
        for (i, line) in self.lines.into_iter().enumerate() {
            let y = at.y + 1.5 * em * (i as f64 + 0.7);
            for (x, sign, said) in line {
                let x = at.x + x;
                let middle = y - 0.32 * em;
                items.push(match sign {
                    Sign::Line(colour) => {
                        let ends = [Dot::new(x, middle), Dot::new(x + 1.6 * em, middle)];
                        Item::drawn(Path::through(ends), colour, 0.22 * em)
                    }
                    Sign::Field(fill, edge) => Item::Shape {
                        path: Path::rectangle(Area::new(x, middle - 0.5 * em, 1.6 * em, em)),
                        fill: Some(fill),
                        stroke: Some(Stroke {
                            colour: edge,
                            width: 0.08 * em,
                        }),
                        title: None,
                    },
                    Sign::Mark(colour) => {
                        let center = Dot::new(x + 0.8 * em, middle);
                        Item::filled(Path::circle(center, 0.35 * em), colour)
                    }
                });
                let beside = Dot::new(x + 2.2 * em, y);
                items.push(text(said, beside, 0.9 * em, Anchor::Start, INK));
            }
        }
    }
}
