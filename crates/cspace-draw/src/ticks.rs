//! Round numbers along an axis.

/// Quantity of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// Lengths, shown as they are.
    Length,
    /// Angles in radians, shown in degrees.
    Angle,
}

/// Positions and labels of the ticks of a range, at most `most`.
pub(crate) fn ticks(range: (f64, f64), most: f64, quantity: Quantity) -> Vec<(f64, String)> {
    let unit = match quantity {
        Quantity::Length => 1.0,
        Quantity::Angle => 1f64.to_radians(),
    };
    let (lo, hi) = (range.0 / unit, range.1 / unit);
    let step = step((hi - lo) / most.max(1.0), quantity);
    if !(step > 0.0 && step.is_finite() && (hi - lo) / step < 1e4) {
        return Vec::new();
    }
    let decimals = (-step.log10() - 1e-9).ceil().clamp(0.0, 17.0) as usize;
    // An end that is a tick but for rounding is one.
    let slack = 1e-9 * (hi - lo) / step;
    let (first, last) = ((lo / step - slack).ceil(), (hi / step + slack).floor());
    (0..=((last - first).max(-1.0) + 0.5) as usize)
        .take_while(|_| last >= first)
        .map(|i| {
            let at = (first + i as f64) * step;
            (at * unit, number(at, decimals))
        })
        .collect()
}

/// The least round number that is not below `wanted`.
pub(crate) fn step(wanted: f64, quantity: Quantity) -> f64 {
    if quantity == Quantity::Angle && wanted > 5.0 {
        let round = [10.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0];
        if let Some(step) = round.into_iter().find(|s| *s >= wanted) {
            return step;
        }
        return 360.0 * step(wanted / 360.0, Quantity::Length);
    }
    let decade = 10f64.powf(wanted.log10().floor());
    let round = [1.0, 2.0, 5.0, 10.0].map(|s| s * decade);
    // A tenth may be a little less than what it was computed from.
    (round.into_iter().find(|s| *s >= wanted * (1.0 - 1e-12))).unwrap_or(10.0 * decade)
}

/// A number with a minus sign, not a hyphen.
pub(crate) fn number(x: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", x + 0.0);
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// A number to a few decimals, without zeros that say nothing.
pub(crate) fn brief(x: f64) -> String {
    /// Places after the point.
    const DECIMALS: usize = 4;
    let text = number(x, DECIMALS);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    fn texts(range: (f64, f64), most: f64, quantity: Quantity) -> Vec<String> {
        ticks(range, most, quantity)
            .into_iter()
            .map(|t| t.1)
            .collect()
    }

    #[test]
    fn numbers_are_round() {
        assert_eq!(
            texts((-PI, PI), 8.0, Quantity::Angle),
            ["−180", "−135", "−90", "−45", "0", "45", "90", "135", "180"]
        );
        assert_eq!(
            texts((-1.0, 1.2), 5.0, Quantity::Length),
            ["−1.0", "−0.5", "0.0", "0.5", "1.0"]
        );
        assert_eq!(
            texts((3e-7, 5e-7), 3.0, Quantity::Length),
            ["0.0000003", "0.0000004", "0.0000005"][..]
        );
        assert_eq!(
            texts((0.0, 43.0), 5.0, Quantity::Length),
            ["0", "10", "20", "30", "40"]
        );
    }

    /// Whatever the range, there are some ticks and not too many, all inside.
    #[test]
    fn every_range_has_ticks() {
        for k in 0..400 {
            let width = 10f64.powf(-9.0 + 0.05 * f64::from(k));
            for lo in [0.0, -0.3 * width, 17.0 * width] {
                for quantity in [Quantity::Length, Quantity::Angle] {
                    let all = ticks((lo, lo + width), 8.0, quantity);
                    assert!((2..=10).contains(&all.len()), "{lo} {width}: {}", all.len());
                    let inside = |t: f64| t >= lo - 1e-6 * width && t <= lo + width * 1.000_001;
                    assert!(all.iter().all(|t| inside(t.0)));
                }
            }
        }
    }
}
