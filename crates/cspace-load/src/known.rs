//! Families that are known to go wrong, and from which value on.

/// What is known to be wrong, by family and by the magnitude of its number, from the first to the last.
///
/// An entry allows faults, it does not demand them. `tests/regression.rs` of `cspace-io` has the smallest pair of each sort.
const KNOWN: [(&str, f64, f64, &str); 3] = [
    (
        "combs, teeth",
        8.0,
        12.0,
        "all teeth meet all gaps at one orientation",
    ),
    (
        "plate with a hole and a smaller part, ratio",
        0.0,
        1e-7,
        "slices from scratch of the small part have loops that are not there: its curves are placed to less than their lengths",
    ),
    (
        "small part and a larger one around it, ratio",
        1e7,
        1e9,
        "the same",
    ),
];

/// Why the pair of a family may be wrong at this value, if it is known.
///
/// ```
/// assert!(cspace_load::known("combs, teeth", 12.0).is_some());
/// assert!(cspace_load::known("combs, teeth", 3.0).is_none());
/// ```
pub fn known(family: &str, value: f64) -> Option<&'static str> {
    KNOWN
        .iter()
        .find(|&&(name, from, to, _)| name == family && (from..=to).contains(&value.abs()))
        .map(|&(_, _, _, why)| why)
}
