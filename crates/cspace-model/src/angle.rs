//! Angles with a unit, such as `"18deg"`.

/// Units of angle, each with its size as a fraction of a turn; radians are handled apart.
const UNITS: [(&str, f64); 3] = [("deg", 1.0 / 360.0), ("°", 1.0 / 360.0), ("turn", 1.0)];

/// The angle in radians that `text` means, or nothing if it is not a number followed by `deg`, `°`,
/// `rad`, or `turn`. Not finite if the number is not.
///
/// A number alone is no text with a unit: in a model file it stands without quotes.
///
/// ```
/// use cspace_model::parse_angle;
/// assert_eq!(parse_angle("180deg"), Some(core::f64::consts::PI));
/// assert_eq!(parse_angle("-0.25 turn"), Some(-core::f64::consts::FRAC_PI_2));
/// assert_eq!(parse_angle("0.3rad"), Some(0.3));
/// assert_eq!(parse_angle("0.3"), None);
/// ```
pub fn parse_angle(text: &str) -> Option<f64> {
    let text = text.trim();
    if let Some(number) = text.strip_suffix("rad") {
        return number.trim_end().parse().ok();
    }
    let (number, per_turn) = UNITS.iter().find_map(|(unit, per_turn)| {
        let number = text.strip_suffix(unit)?.trim_end();
        Some((number.parse::<f64>().ok()?, *per_turn))
    })?;
    Some(if per_turn == 1.0 {
        number * core::f64::consts::TAU
    } else {
        number.to_radians()
    })
}

#[cfg(test)]
mod tests {
    use super::parse_angle;
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};

    #[test]
    fn common_angles_are_read() {
        for (text, angle) in [
            ("30deg", FRAC_PI_6),
            ("45deg", FRAC_PI_4),
            ("60 deg", FRAC_PI_3),
            ("-90°", -FRAC_PI_2),
            ("180deg", PI),
            ("360deg", TAU),
            ("0.5turn", PI),
            (" 1 turn ", TAU),
            ("0.3rad", 0.3),
            ("-1e-3rad", -1e-3),
        ] {
            let parsed = parse_angle(text).unwrap();
            assert!(
                (parsed - angle).abs() <= 2.0 * f64::EPSILON * angle.abs(),
                "{text}"
            );
        }
    }

    #[test]
    fn other_text_is_no_angle() {
        for text in [
            "",
            "deg",
            "18",
            "18grad",
            "eighteen deg",
            "1,5deg",
            "18 degrees",
        ] {
            assert_eq!(parse_angle(text), None, "{text}");
        }
        assert_eq!(parse_angle("infdeg"), Some(f64::INFINITY));
    }
}
