//! Numbers in sentences.

use cspace_model::Mechanism;

/// An angle in degrees, to a thousandth.
pub(super) fn degrees(radians: f64) -> String {
    format!("{} deg", plain(radians.to_degrees(), 3))
}

/// A length to about a hundred-thousandth of the size of a part.
pub(super) fn length(mechanism: &Mechanism, x: f64, size: f64) -> String {
    with_unit(mechanism, &bare_length(x, size))
}

/// As `length`, without the unit.
pub(super) fn bare_length(x: f64, size: f64) -> String {
    let decimals = (4.0 - size.log10()).ceil().clamp(0.0, 12.0) as usize;
    plain(x, decimals)
}

pub(super) fn with_unit(mechanism: &Mechanism, number: &str) -> String {
    match &mechanism.unit {
        Some(unit) => format!("{number} {unit}"),
        None => number.to_owned(),
    }
}

/// A share as a whole number of percent; a share below 1 is shown as less than 100 %.
pub(super) fn percent(share: f64) -> String {
    /// Larger shares are 100 %, but for rounding.
    const ALL: f64 = 1.0 - 1e-9;
    let whole = (100.0 * share).round();
    let shown = match share {
        s if s >= ALL => 100.0,
        _ => whole.clamp(0.0, 99.0),
    };
    if shown < 1.0 && share > 0.0 {
        return "less than 1 %".to_owned();
    }
    format!("{shown:.0} %")
}

/// A number with `count` significant digits, without an exponent where it is not needed.
pub(super) fn digits(x: f64, count: i32) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let lead = x.abs().log10().floor() as i32;
    if (-4..9).contains(&lead) {
        plain(x, (count - 1 - lead).max(0) as usize)
    } else {
        format!("{x:.*e}", (count - 1).max(0) as usize)
    }
}

/// As `digits`, without trailing zeros.
pub(super) fn brief(x: f64, count: i32) -> String {
    let shown = digits(x, count);
    match shown.contains('.') && !shown.contains('e') {
        true => shown.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => shown,
    }
}

/// A number with `decimals` decimals; a zero has no sign.
pub(super) fn plain(x: f64, decimals: usize) -> String {
    let shown = format!("{x:.decimals$}");
    match shown.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.to_owned(),
        _ => shown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_sensible_digits() {
        assert_eq!(degrees(-1e-9), "0.000 deg");
        assert_eq!(bare_length(12.345_678, 50.0), "12.346");
        assert_eq!(bare_length(0.001_234_567, 0.01), "0.001235");
        assert_eq!(percent(0.999), "99 %");
        assert_eq!(percent(1.0 - 1e-12), "100 %");
        assert_eq!(percent(0.002), "less than 1 %");
        assert_eq!(digits(1234.567, 3), "1235");
        assert_eq!(digits(-0.012_345, 3), "-0.0123");
        assert_eq!(digits(1.5e12, 3), "1.50e12");
        assert_eq!(brief(-1.2, 7), "-1.2");
        assert_eq!(brief(100.0, 6), "100");
    }
}
