//! Numbers as they are said.

/// A number with four digits, and no more decimals than it has.
pub(crate) fn rounded(x: f64) -> String {
    let digits = if x == 0.0 {
        0
    } else {
        (3 - x.abs().log10().floor() as i32).clamp(0, 12)
    };
    let text = format!("{x:.*}", digits as usize);
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    match text {
        "-0" => "0".to_owned(),
        text => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_have_four_digits() {
        let told = [0.0, -1e-17, 12.0, -2.5, 0.123_456, -98_765.4].map(rounded);
        assert_eq!(told, ["0", "0", "12", "-2.5", "0.1235", "-98765"]);
    }
}
