//! Which parts the drives move through joints alone, and which joints and drives say where.

use nalgebra::DMatrix;

use crate::system::{PartCoordinates, System};

/// Parts that joints and drives determine together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Linkage {
    /// Their numbers.
    pub(super) parts: Vec<usize>,
    /// Their coordinates, in order.
    pub(super) unknown: Vec<usize>,
    /// The joints that say where they are, by their numbers in the system.
    pub(super) joints: Vec<usize>,
    /// The driven parts that these joints connect to them.
    pub(super) driven: Vec<usize>,
}

/// An eigenvalue of JᵀJ is 0 below this share of the largest: a singular value of J below a millionth.
const NONE: f64 = 1e-12;
/// A part is free to move if it has more than this share in a motion that joints allow.
const SHARE: f64 = 1e-6;

/// The linkages at a configuration at which all joints hold. Parts that can still move while the drives stand are in none.
pub(super) fn linkages(system: &System, q: &[f64]) -> Vec<Linkage> {
    let parts = system.parts();
    let is_driven = |i: usize| {
        let own = parts[i].indices();
        system.drives().iter().any(|d| own.contains(&d.0))
    };
    let mut carried: Vec<bool> = (0..parts.len())
        .map(|i| parts[i] != PartCoordinates::Fixed && !is_driven(i))
        .collect();
    loop {
        let found = components(system, &carried, is_driven);
        let mut is_done = true;
        for linkage in &found {
            for part in loose(system, linkage, q) {
                carried[part] = false;
                is_done = false;
            }
        }
        if is_done {
            return found;
        }
    }
}

/// Carried parts that joints connect, without a way through parts that stand or are driven.
fn components(
    system: &System,
    carried: &[bool],
    is_driven: impl Fn(usize) -> bool,
) -> Vec<Linkage> {
    let parts = system.parts();
    let entries = system.joint_entries();
    let mut of: Vec<usize> = (0..parts.len()).collect();
    for entry in entries {
        let (a, b) = entry.parts;
        if carried[a] && carried[b] {
            let (one, other) = (of[a], of[b]);
            for number in &mut of {
                if *number == other {
                    *number = one;
                }
            }
        }
    }
    let mut found: Vec<Linkage> = Vec::new();
    for root in 0..parts.len() {
        let own: Vec<usize> = (0..parts.len())
            .filter(|&i| carried[i] && of[i] == root)
            .collect();
        let is_own = |i: usize| carried[i] && of[i] == root;
        let is_known = |i: usize| is_own(i) || is_driven(i) || parts[i] == PartCoordinates::Fixed;
        let joints: Vec<usize> = (0..entries.len())
            .filter(|&k| {
                let (a, b) = entries[k].parts;
                (is_own(a) || is_own(b)) && is_known(a) && is_known(b)
            })
            .collect();
        if own.is_empty() || joints.is_empty() {
            continue;
        }
        let mut driven: Vec<usize> = (joints.iter())
            .flat_map(|&k| [entries[k].parts.0, entries[k].parts.1])
            .filter(|&i| is_driven(i))
            .collect();
        driven.sort_unstable();
        driven.dedup();
        found.push(Linkage {
            unknown: own.iter().flat_map(|&i| parts[i].indices()).collect(),
            parts: own,
            joints,
            driven,
        });
    }
    found
}

/// The parts of a linkage that its joints let move while the drives stand.
fn loose(system: &System, linkage: &Linkage, q: &[f64]) -> Vec<usize> {
    let n = linkage.unknown.len();
    let rows = system.joints_of(&linkage.joints, q);
    let mut jacobian = DMatrix::<f64>::zeros(rows.len(), n);
    for (r, row) in rows.iter().enumerate() {
        for &(i, d) in row.entries() {
            if let Ok(k) = linkage.unknown.binary_search(&i) {
                jacobian[(r, k)] = d / system.lengths()[i];
            }
        }
    }
    let eigen = (jacobian.transpose() * jacobian).symmetric_eigen();
    let largest = eigen.eigenvalues.max();
    let moves = |i: usize| {
        (0..n)
            .filter(|&k| eigen.eigenvalues[k] <= NONE * largest)
            .any(|k| {
                let of = system.parts()[i].indices();
                of.filter_map(|c| linkage.unknown.binary_search(&c).ok())
                    .any(|row| eigen.eigenvectors[(row, k)].abs() > SHARE)
            })
    };
    let parts = linkage.parts.iter().copied();
    parts.filter(|&i| moves(i)).collect()
}
