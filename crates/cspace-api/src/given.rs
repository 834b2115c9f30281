//! Numbers as they are given: angles with a unit, ranges, configurations.

use core::convert::Infallible;
use core::fmt::Display;
#[cfg(feature = "command")]
use core::ops::RangeInclusive;
use core::str::FromStr;

use cspace_model::{LARGEST_ANGLE, shown};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::host::Host;

/// A configuration or displacement as it is given: text such as `10,0,18deg`, or numbers, angles in radians. Which coordinates it has is
/// known where the pair is.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Given {
    /// With commas between.
    Text(String),
    /// As numbers.
    Numbers(Vec<f64>),
}

impl Given {
    /// The text of each number.
    pub(crate) fn texts(&self) -> Vec<String> {
        match self {
            Self::Text(text) => text.split(',').map(str::to_owned).collect(),
            Self::Numbers(all) => all.iter().map(|x| format!("{x:?}")).collect(),
        }
    }
}

impl FromStr for Given {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(Self::Text(text.to_owned()))
    }
}

/// An error for the value of an option; `wanted` is what to give in its place.
pub(crate) fn refused(host: &dyn Host, option: &str, value: impl Display, wanted: &str) -> Error {
    let option = host.option(option);
    Error::new(format_args!(
        "{option} is {value} where {wanted} is expected"
    ))
    .help(format_args!("give {wanted}"))
}

/// Refuses a length, or another size, that is given and is not a finite number of 0 or more.
pub(crate) fn size(host: &dyn Host, option: &str, value: Option<f64>) -> Result<(), Error> {
    match value {
        Some(x) if !(x.is_finite() && x >= 0.0) => {
            Err(refused(host, option, x, "a finite number of 0 or more"))
        }
        _ => Ok(()),
    }
}

/// An angle in radians from text such as `0.3`, `18deg`, `-10°`, `0.5turn`; finite, and at most [`LARGEST_ANGLE`] from 0.
///
/// # Errors
/// If it is none; the message says what to give.
pub fn angle(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let angle = text
        .parse::<f64>()
        .ok()
        .or_else(|| cspace_model::parse_angle(text))
        .filter(|a| a.is_finite())
        .ok_or_else(|| {
            format!(
                "{} is no angle: give radians, or a number with a unit such as 18deg",
                shown::quoted(text)
            )
        })?;
    if angle.abs() > LARGEST_ANGLE {
        return Err(format!(
            "the angle {} rad is more than {LARGEST_ANGLE:e} rad from 0, too far to tell where it is on the circle: take off whole turns",
            shown::number(angle)
        ));
    }
    Ok(angle)
}

/// Two angles, or two lengths, from text such as `-10deg,10deg` or `0,25`, the smaller first.
///
/// # Errors
/// If it is none; the message says what to give.
pub fn range(text: &str) -> Result<(f64, f64), String> {
    let (lo, hi) = (text.split_once(','))
        .ok_or("give two numbers with a comma between, such as -10deg,10deg")?;
    let (lo, hi) = (angle(lo)?, angle(hi)?);
    if lo < hi {
        Ok((lo, hi))
    } else {
        Err("the first number must be the smaller one".to_owned())
    }
}

/// A window of orientations from text such as `-10deg,10deg`.
///
/// # Errors
/// If it is none; the message says what to give.
pub fn window(text: &str) -> Result<(f64, f64), String> {
    let Some((lo, hi)) = text.split_once(',') else {
        return Err("give two angles with a comma between, such as -10deg,10deg".to_owned());
    };
    let (lo, hi) = (angle(lo)?, angle(hi)?);
    if lo >= hi {
        return Err("the first angle must be the smaller one".to_owned());
    }
    if hi - lo > cspace::LONGEST_WINDOW {
        return Err(
            "the angles are more than a turn apart; leave --window out for all orientations"
                .to_owned(),
        );
    }
    Ok((lo, hi))
}

/// A finite number of which something is true, from text.
///
/// # Errors
/// If it is none; the message is the advice.
pub fn number(text: &str, is_right: impl Fn(f64) -> bool, advice: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    let right = number.filter(|&x| x.is_finite() && is_right(x));
    right.ok_or_else(|| advice.to_owned())
}

/// Reads whole numbers of a range.
#[cfg(feature = "command")]
pub fn whole<T>(
    range: RangeInclusive<u64>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static
where
    T: TryFrom<u64> + 'static,
{
    move |text| {
        let number = text.parse().ok().filter(|n| range.contains(n));
        let number = number.and_then(|n| T::try_from(n).ok());
        let (least, most) = (range.start(), range.end());
        number.ok_or_else(|| format!("give a whole number from {least} to {most}"))
    }
}

/// A factor of lengths, from text.
///
/// # Errors
/// If it is none; the message says what to give.
pub fn factor(text: &str) -> Result<f64, String> {
    let is_right = |x| (1e-9..=1e9).contains(&x);
    number(text, is_right, "give a number from 1e-9 to 1e9")
}

/// Two finite numbers with a comma between.
pub fn two(text: &str) -> Option<(f64, f64)> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let (x, y) = text.split_once(',')?;
    Some((number(x)?, number(y)?))
}

/// A number, or an angle with its unit in radians, from text.
pub(crate) fn value(text: &str) -> Option<f64> {
    let number = text.trim().parse::<f64>().ok();
    let number = number.or_else(|| cspace_model::parse_angle(text.trim()));
    number.filter(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::{angle, window};
    use core::f64::consts::{FRAC_PI_4, PI};

    #[test]
    fn units_are_understood() {
        for (text, wanted) in [
            ("0.3", 0.3),
            ("45deg", FRAC_PI_4),
            ("-180 °", -PI),
            ("0.5turn", PI),
            ("1e-3rad", 1e-3),
            ("-.5", -0.5),
        ] {
            assert_eq!(angle(text), Ok(wanted), "{text}");
        }
        for text in ["", "deg", "x", "nan", "inf", "1,5"] {
            assert!(angle(text).is_err(), "{text}");
        }
    }

    #[test]
    fn angles_far_from_0_are_refused() {
        for text in ["1e6", "-1e6", "159154turn", "5.7e7deg"] {
            assert!(angle(text).is_ok(), "{text}");
        }
        for text in ["1000000.1", "-1e9", "1e300", "1e300turn", "159155turn"] {
            let error = angle(text).unwrap_err();
            assert!(error.len() < 200, "{error}");
        }
        assert!(angle("1e15").unwrap_err().contains("angle 1e15 rad"));
        assert!(window("1e6,1000001").is_err());
    }

    #[test]
    fn windows_go_upwards() {
        assert_eq!(window("-0.5,0.5"), Ok((-0.5, 0.5)));
        assert!(window("-180deg,180deg").is_ok());
        for text in ["1", "1,1", "2,1", "0,7", "a,1"] {
            assert!(window(text).is_err(), "{text}");
        }
    }
}
