//! Colours by which what is drawn is chosen.

use core::fmt;
use core::str::FromStr;

/// A colour of a drawing: as red, green and blue, as a number of AutoCAD's palette, or both.
///
/// ```
/// use cspace_drawing::Color;
/// let red: Color = "red".parse()?;
/// assert!(red.is("#f00".parse()?) && red.is("1".parse()?) && !red.is("blue".parse()?));
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Color {
    rgb: Option<[u8; 3]>,
    index: Option<u8>,
}

/// The colours of the palette that have names: those of a plotter's pens. White is black on paper.
const NAMED: [(&str, u8, [u8; 3]); 7] = [
    ("red", 1, [255, 0, 0]),
    ("yellow", 2, [255, 255, 0]),
    ("green", 3, [0, 255, 0]),
    ("cyan", 4, [0, 255, 255]),
    ("blue", 5, [0, 0, 255]),
    ("magenta", 6, [255, 0, 255]),
    ("white", 7, [255, 255, 255]),
];

impl Color {
    /// Red, green and blue.
    pub(crate) fn of_rgb(rgb: [u8; 3]) -> Self {
        let index = NAMED.iter().find(|n| n.2 == rgb).map(|n| n.1);
        Self {
            rgb: Some(rgb),
            index,
        }
    }

    /// A number of the palette, 1 to 255.
    pub(crate) fn of_index(index: u8) -> Self {
        let rgb = NAMED.iter().find(|n| n.1 == index).map(|n| n.2);
        Self {
            rgb,
            index: Some(index),
        }
    }

    /// The colour of an attribute of SVG; `None` if it is none, or is defined elsewhere.
    pub(crate) fn of_svg(text: &str) -> Option<Self> {
        let color = svgtypes::Color::from_str(text.trim()).ok()?;
        Some(Self::of_rgb([color.red, color.green, color.blue]))
    }

    /// Whether two are one colour.
    pub fn is(self, other: Self) -> bool {
        let same = |a: Option<[u8; 3]>, b| a.is_some() && a == b;
        same(self.rgb, other.rgb) || self.index.is_some() && self.index == other.index
    }
}

impl FromStr for Color {
    type Err = String;

    /// A name such as `red`, `#ff0000`, or a number of AutoCAD's palette from 1 to 255.
    fn from_str(text: &str) -> Result<Self, String> {
        if let Ok(index) = text.parse::<u8>()
            && index > 0
        {
            return Ok(Self::of_index(index));
        }
        let name = text.to_ascii_lowercase();
        if let Some(&(_, index, rgb)) = NAMED.iter().find(|n| n.0 == name) {
            // The green of the web is a darker one than that of the palette, of one name.
            let rgb = Self::of_svg(&name).and_then(|c| c.rgb).unwrap_or(rgb);
            return Ok(Self {
                rgb: Some(rgb),
                index: Some(index),
            });
        }
        Self::of_svg(&name).ok_or_else(|| {
            "give a colour such as red, #ff0000, or its number in AutoCAD's palette, 1 to 255"
                .to_owned()
        })
    }
}

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = NAMED.iter().find(|n| Some(n.1) == self.index);
        match (named, self.index, self.rgb) {
            (Some((name, ..)), ..) => f.write_str(name),
            (None, Some(index), _) => write!(f, "{index}"),
            (None, None, Some([r, g, b])) => write!(f, "#{r:02x}{g:02x}{b:02x}"),
            (None, None, None) => f.write_str("none"),
        }
    }
}
