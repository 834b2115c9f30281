//! The faces that sets of closed curves enclose, each set by its even-odd rule.
//!
//! Outside of everything no set encloses anything. From there on, whoever steps over a piece enters or leaves the sets of which an odd
//! number of edges run along it. No point is tested against curves, so that slivers and edges drawn twice are decided as all others.

use super::faces::Faces;

/// For each face whether one of the sets encloses it; `set_of` is the set of each edge. `None` if curves are so near each other that
/// stepping over different pieces leads to different answers.
pub(crate) fn enclosed(of: &Faces, set_of: &[u32]) -> Option<Vec<bool>> {
    let arrangement = &of.arrangement;
    let node = |half: usize| of.face_of[half].map_or(0, |face| face as usize + 1);
    let mut beside: Vec<Vec<usize>> = vec![Vec::new(); of.faces.len() + 1];
    for piece in 0..arrangement.pieces.len() {
        for half in [2 * piece, 2 * piece + 1] {
            beside[node(half)].push(half);
        }
    }
    let mut around: Vec<Option<Vec<u32>>> = vec![None; of.faces.len() + 1];
    around[0] = Some(Vec::new());
    let mut rest = vec![0];
    while let Some(here) = rest.pop() {
        let sets = around[here].clone().unwrap_or_default();
        for &half in &beside[here] {
            let mut there = sets.clone();
            for edge in arrangement.edges_along(&arrangement.pieces[half / 2]) {
                toggle(&mut there, set_of[edge as usize]);
            }
            let next = node(half ^ 1);
            match &around[next] {
                Some(known) if *known != there => return None,
                Some(_) => {}
                None => {
                    around[next] = Some(there);
                    rest.push(next);
                }
            }
        }
    }
    let faces = around.iter().skip(1);
    Some(
        faces
            .map(|sets| sets.as_ref().is_some_and(|s| !s.is_empty()))
            .collect(),
    )
}

/// Adds a set to those in order, or removes it if it is among them.
fn toggle(sets: &mut Vec<u32>, set: u32) {
    match sets.binary_search(&set) {
        Ok(at) => {
            sets.remove(at);
        }
        Err(at) => sets.insert(at, set),
    }
}
