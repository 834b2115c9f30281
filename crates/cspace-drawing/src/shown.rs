//! Numbers and texts in messages.

use cspace::Point;

/// A number to six digits, without zeros at its end.
pub(crate) fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    if !(1e-4..1e7).contains(&size) {
        return format!("{x:.3e}");
    }
    let before = size.log10().floor() as i32 + 1;
    let digits = usize::try_from(6 - before).unwrap_or(0);
    let text = format!("{x:.digits$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// A point to six digits.
pub(crate) fn point(p: Point) -> String {
    format!("({}, {})", number(p.x), number(p.y))
}

/// Beginning of a text, in quotes.
pub(crate) fn start(text: &str) -> String {
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn numbers_have_six_digits() {
        for (x, shown) in [
            (39.330_127_018_922_19, "39.3301"),
            (-0.5, "-0.5"),
            (0.0, "0"),
            (1234567.8, "1234568"),
            (1e-9, "1.000e-9"),
            (30.0, "30"),
            (0.001_234_567_8, "0.00123457"),
        ] {
            assert_eq!(super::number(x), shown);
        }
    }
}
