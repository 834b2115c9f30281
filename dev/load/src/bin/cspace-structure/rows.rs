//! The rows of the table.

use cspace_load::structure::{Flood, Outcome, Specimen};

/// The width of the first two columns together.
pub(crate) const TITLE: usize = 64;

/// Title of a row.
pub(crate) fn titled(specimen: &Specimen) -> String {
    format!("{}: {}", specimen.family, specimen.title())
}

/// Heading of the columns.
pub(crate) fn heading() -> String {
    format!(
        "{:TITLE$} features regions expected conflicts runs patches   doubtful narrow   seconds",
        "pair"
    )
}

/// A specimen and how it went.
pub(crate) fn row(specimen: &Specimen, outcome: &Outcome) -> String {
    let title = titled(specimen);
    let m = match outcome {
        Outcome::Measured(m) => m,
        Outcome::Refused(why) => return format!("{title:TITLE$} no part: {why}"),
        Outcome::GivenUp(why) => return format!("{title:TITLE$} no space: {why}"),
        Outcome::Panicked(why) => return format!("{title:TITLE$} panic: {why}"),
    };
    let features = format!("{}+{}", m.features.0, m.features.1);
    let expected = match specimen.expected {
        Some(n) => n.to_string(),
        None => "-".to_owned(),
    };
    let doubtful = match m.doubtful {
        0.0 => "0".to_owned(),
        radians => format!("{radians:.2e}"),
    };
    let mut row = format!(
        "{title:TITLE$} {features:>8} {:7} {expected:>8} {:9} {:4} {:7} {doubtful:>10} {:6} {:9.3}",
        m.regions, m.conflicts, m.runs, m.patches, m.narrow, m.seconds
    );
    if specimen.expected.is_some_and(|n| n != m.regions) {
        row += "  WRONG";
    }
    if let Some(n) = m.inverse.filter(|&n| n != m.regions) {
        row += &format!("  UNEQUAL: {n} the other way round");
    }
    match &m.flood {
        Some(Flood::Agrees(n)) => row += &format!("  flood: {n}"),
        Some(Flood::Fewer(n)) => {
            row += &format!("  flood: {n}, but for pockets smaller than a box");
        }
        Some(Flood::CannotTell(n)) => row += &format!("  flood: {n} or more"),
        Some(Flood::Wrong(why)) => {
            let first = why.first().map_or("", String::as_str);
            row += &format!("  FLOOD: {first} ({} in all)", why.len());
        }
        None => {}
    }
    row
}
