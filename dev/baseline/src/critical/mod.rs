//! The first step of the general algorithm: critical orientations from all combinations of contacts.
//!
//! As Sacks (1999) has it: the equations of all combinations of contacts are solved (section 2); each solution that cannot be realised
//! is pruned, which took most of the time there, and the rest are grouped by orientation (section 3.3).
//!
//! | contacts | critical where | equation |
//! |---|---|---|
//! | one | a normal that ends a feature opposes one of the other part | α = β + θ + π |
//! | two | the end of one contact curve is on the other's carrier, or both carriers are tangent | polynomial of degree 4 in tan(θ/2) |
//! | three | all carriers meet in one point | of degree 6 for three lines, 10 with circles |
//!
//! A line or circle of positions is k |p|² + a x + b y + c = 0 with a, b, c of the form c₀ + c₁ cos θ + c₂ sin θ
//! (equations 1 and 3). Differences of circles are lines, so three carriers are three lines, or two lines and a circle, and p is
//! eliminated by Cramer's rule. Roots are isolated by Descartes' rule of signs in Bernstein's basis (`bernstein`).
//!
//! A criticality is realisable if each contact is between the features themselves, and the parts do not overlap: tested by
//! brute force, every edge with every edge. Nothing is shared with the product's kernel but the outlines' edges.

mod bernstein;
mod body;
mod contact;
mod found;
mod grouped;
mod outline;
mod search;
mod single;
mod span;
mod tolerance;
mod triple;
mod twofold;

use cspace::Part;

use search::Search;

pub use found::{Criticalities, Known};

/// Searches the critical orientations of a pair over the whole turn, on all threads, as long as `go_on` returns true;
/// `None` if it returns false before the end.
///
/// The orientations are a superset of those at which the contact space changes, except for the tolerances: an overlap
/// shallower than 1e-6 of the size counts as contact, and so does a gap of that size at the end of a feature.
///
/// ```
/// use cspace::{Part, Vertex};
/// use cspace_baseline::critical::{Known, search};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let (table, block) = (square("table", 2.0)?, square("block", 1.0)?);
/// let found = search(&table, &block, Known::Skipped, &|| true).ok_or("stopped")?;
/// // Sides are parallel four times a turn.
/// assert_eq!(found.orientations.len(), 4);
/// assert!(search(&table, &block, Known::Skipped, &|| false).is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn search(
    fixed: &Part,
    moving: &Part,
    known: Known,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Option<Criticalities> {
    let mut search = Search::new(fixed, moving, known, go_on);
    single::search(&mut search)?;
    twofold::search(&mut search)?;
    triple::search(&mut search)?;
    Some(search.finish())
}
