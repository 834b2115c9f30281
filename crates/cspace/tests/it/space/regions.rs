//! Free regions compared with a flood fill of (x, y, θ) in boxes that brute force proves to be free or blocked (`cspace_oracle::fill`).

use cspace::{ContactSpace, Options, Window};
use cspace_oracle::{Case, Fill, effort, families, is_long, pairs};
use rayon::prelude::*;

/// Number of times that boxes are halved: to 64 along x, y and θ, and to 256 where that is enough to determine the number of regions. To 32
/// in families beyond their first values, where the clearance is less than any box anyway, and of which not all are taken.
const DEPTH: u32 = 6;
const FINE_DEPTH: u32 = 8;
const ROUGH_DEPTH: u32 = 5;
/// By default boxes are halved less often, and those of [`WIDE`] once less: these then need not determine the number.
const ROUGHEST_DEPTH: u32 = 4;

/// Pairs whose number of regions is determined by the boxes.
const WIDE: [(&str, usize); 8] = [
    ("annuli", 2),
    ("ball caged in a C", 2),
    ("disc in a hole, clearance 0.1", 2),
    ("disc in annulus", 2),
    ("peg over a plate with holes, holes a side 1", 2),
    ("plate with a hole and a smaller part, ratio 1", 2),
    ("ring about an island", 2),
    ("square in a nearly full hole", 2),
];

/// Number of edges above which the oracle takes too long.
const MOST_EDGES: usize = 24;

/// Errors, and the number of configurations compared.
fn compare(name: &str, case: &Case, depth: u32) -> (Vec<String>, usize) {
    let options = Options {
        window: case.window,
        ..Options::default()
    };
    let space = ContactSpace::compute(&case.fixed, &case.moving, &options).unwrap();
    let wide = WIDE.iter().find(|w| w.0 == name);
    let depth = if wide.is_some() {
        effort(FINE_DEPTH - 2, FINE_DEPTH)
    } else {
        depth.min(effort(ROUGHEST_DEPTH, DEPTH))
    };
    let Window { lo, hi, full_turn } = space.window();
    let fill = Fill::new(case, (lo, hi), full_turn, depth);
    let regions = space.free_regions().len();
    let compared = fill.compare(regions, |c| Some(space.locate(c).region()?.0));
    let known = compared.known;
    let mut wrong: Vec<String> = (compared.wrong.iter())
        .map(|w| format!("{name}: {w}"))
        .collect();
    if let Some(&(_, expected)) = wide
        && (regions != expected || is_long() && known != expected)
    {
        wrong.push(format!(
            "{name}: {regions} regions, and {known} by the boxes, instead of {expected}"
        ));
    }
    (wrong, compared.configurations)
}

/// Single pairs, and values of all families.
fn cases() -> Vec<(String, Case, u32)> {
    let named = pairs().into_iter().map(|p| {
        let case = Case {
            fixed: p.fixed,
            moving: p.moving,
            window: None,
            notable: Vec::new(),
        };
        (p.name, case, DEPTH)
    });
    let of_families = families().into_iter().flat_map(|f| {
        let values = f
            .values
            .clone()
            .into_iter()
            .enumerate()
            .step_by(effort(96, 3));
        values.filter_map(move |(i, value)| {
            let depth = if i == 0 { DEPTH } else { ROUGH_DEPTH };
            Some((format!("{} {value}", f.name), f.build(value).ok()?, depth))
        })
    });
    // Fewer edges by default, but for those whose number is known.
    let most = effort(12, MOST_EDGES);
    named
        .chain(of_families)
        .filter(move |(name, c, _)| {
            let is_wide = WIDE.iter().any(|w| w.0 == *name);
            is_wide || c.fixed.edges().count() + c.moving.edges().count() <= most
        })
        .collect()
}

#[test]
fn free_regions_agree_with_a_flood_fill() {
    let cases = cases();
    for (name, _) in WIDE {
        assert!(cases.iter().any(|c| c.0 == name), "no pair is named {name}");
    }
    let compared: Vec<(Vec<String>, usize)> = cases
        .par_iter()
        .map(|(name, case, depth)| compare(name, case, *depth))
        .collect();
    let wrong: Vec<&String> = compared.iter().flat_map(|c| c.0.iter().take(3)).collect();
    let asked: usize = compared.iter().map(|c| c.1).sum();
    println!("{} pairs, {asked} configurations", cases.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
    let least = effort((50, 1_000), (300, 20_000));
    let count = cases.len();
    assert!(count > least.0 && asked > least.1, "{count}, {asked}");
}
