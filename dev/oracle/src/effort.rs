//! How much a test tries: few cases by default, many in the long tier.

/// Whether the tests of this run are those of the long tier: `CSPACE_LONG=1`.
#[must_use]
pub fn is_long() -> bool {
    std::env::var("CSPACE_LONG").is_ok_and(|v| v == "1")
}

/// Number of cases that a test tries: `usual`, or `long` in the long tier.
#[must_use]
pub fn effort<T>(usual: T, long: T) -> T {
    if is_long() { long } else { usual }
}
