//! Text and numbers as messages show them.
//!
//! Messages repeat text of files and users, and terminals obey control characters: an escape character in the name of a
//! part could hide the rest of a message, a line break could forge one.

use core::fmt;
use std::borrow::Cow;

/// The text with its control characters (U+0000 to U+001F, U+007F to U+009F) escaped as Rust writes them.
///
/// ```
/// use cspace_model::shown;
/// assert_eq!(shown::text("pawl"), "pawl");
/// assert_eq!(shown::text("pa\u{1b}[31mwl\n"), r"pa\u{1b}[31mwl\n");
/// ```
pub fn text(text: &str) -> Cow<'_, str> {
    if !text.contains(char::is_control) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        if c.is_control() {
            out.extend(c.escape_default());
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}

/// Largest number of repeated characters of a text from a file or a user: enough to find it.
const LONGEST: usize = 60;

/// The text, or its beginning if it is long.
///
/// ```
/// use cspace_model::shown;
/// assert_eq!(shown::cut("pawl"), "pawl");
/// assert_eq!(shown::cut(&"z".repeat(1000)), "z".repeat(60) + "…");
/// ```
pub fn cut(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

/// The text in quotes, as Rust writes it; its beginning if it is long.
///
/// ```
/// use cspace_model::shown;
/// assert_eq!(shown::quoted("pa\twl"), r#""pa\twl""#);
/// assert_eq!(shown::quoted(&"z".repeat(1000)), format!("{:?}…", "z".repeat(60)));
/// ```
pub fn quoted(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

/// The text as one word of a command: in quotes where a shell would not take it as it is.
///
/// ```
/// use cspace_model::shown;
/// assert_eq!(shown::word("parts/pawl.dxf"), "parts/pawl.dxf");
/// assert_eq!(shown::word(""), "''");
/// assert_eq!(shown::word("bar's end"), r"'bar'\''s end'");
/// ```
pub fn word(text: &str) -> Cow<'_, str> {
    let is_plain = |c: char| c.is_alphanumeric() || "._-/+".contains(c);
    match !text.is_empty() && text.chars().all(is_plain) {
        true => Cow::Borrowed(text),
        false => Cow::Owned(format!("'{}'", text.replace('\'', "'\\''"))),
    }
}

/// Formats a number with all its digits, but without long rows of zeros: from 10¹⁵ on, and below 10⁻⁵, with an
/// exponent.
///
/// A precision gives the number of decimals in either form.
///
/// ```
/// use cspace_model::shown;
/// assert_eq!(shown::number(-12.5).to_string(), "-12.5");
/// assert_eq!(shown::number(1e300).to_string(), "1e300");
/// assert_eq!(format!("{:.3}", shown::number(0.25)), "0.250");
/// assert_eq!(format!("{:.3}", shown::number(-1.5e200)), "-1.500e200");
/// ```
pub fn number(x: f64) -> Number {
    Number(x)
}

/// See [`number`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number(f64);

/// Smallest number shown with an exponent; below it neighbouring doubles are less than 1 apart, and every digit before
/// the point is significant.
const LONG: f64 = 1e15;

/// Below it a number is shown with an exponent, unless the digits after the point are counted.
const SHORT: f64 = 1e-5;

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let is_long = size >= LONG && size.is_finite();
        let is_short = size < SHORT && size > 0.0 && f.precision().is_none();
        if is_long || is_short {
            fmt::LowerExp::fmt(&self.0, f)
        } else {
            fmt::Display::fmt(&self.0, f)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{number, text};

    #[test]
    fn control_characters_and_no_others_are_escaped() {
        for c in (0..0x300).filter_map(char::from_u32) {
            let shown = text(c.encode_utf8(&mut [0; 4])).into_owned();
            let code = u32::from(c);
            let control = code < 0x20 || (0x7f..0xa0).contains(&code);
            assert_eq!(shown.starts_with('\\') && c != '\\', control, "{code:x}");
            assert!(!shown.contains(char::is_control), "{code:x}");
        }
    }

    #[test]
    fn numbers_are_short_and_are_read_back() {
        for x in [
            0.0,
            -0.5,
            1.0,
            123_456.789,
            1e14,
            1e15,
            -1e308,
            1e-5,
            5e-324,
        ] {
            let shown = number(x).to_string();
            assert!(shown.len() < 25, "{shown}");
            assert_eq!(shown.parse(), Ok(x));
        }
        assert_eq!(number(f64::NAN).to_string(), "NaN");
        assert_eq!(number(f64::INFINITY).to_string(), "inf");
        assert_eq!(format!("{:.2}", number(1e-300)), "0.00");
    }
}
