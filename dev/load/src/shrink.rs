//! A smaller pair with the same fault.

use cspace::{Part, Vertex};
use cspace_oracle::Case;

use crate::outline::Loops;

/// Removes loops, vertices and bulges of a pair as long as it `still` has the fault.
///
/// Each of the remaining elements is needed for the fault; the pair need not be the smallest possible.
pub fn shrink(case: &Case, still: &dyn Fn(&Case) -> bool) -> Case {
    let mut best = case.clone();
    while let Some(smaller) = smaller(&best).into_iter().find(|c| still(c)) {
        best = smaller;
    }
    best
}

/// The pairs with one thing less, those that lose most first.
fn smaller(case: &Case) -> Vec<Case> {
    let loops = [&case.fixed, &case.moving]
        .map(|p: &Part| -> Loops { p.loops().iter().map(|l| l.vertices().to_vec()).collect() });
    let mut all = Vec::new();
    let edits: [fn(&Loops) -> Vec<Loops>; 3] = [without_a_loop, without_a_vertex, without_a_bulge];
    for edit in edits {
        for (which, loops) in loops.iter().enumerate() {
            for loops in edit(loops) {
                let part = [&case.fixed, &case.moving][which];
                if let Ok(part) = Part::new(part.name(), loops) {
                    let mut case = case.clone();
                    *[&mut case.fixed, &mut case.moving][which] = part;
                    all.push(case);
                }
            }
        }
    }
    all
}

fn without_a_loop(loops: &Loops) -> Vec<Loops> {
    let without = |i: usize| {
        let mut rest = loops.clone();
        rest.remove(i);
        rest
    };
    (0..loops.len()).map(without).collect()
}

fn each_vertex(loops: &Loops, edit: impl Fn(&mut Vec<Vertex>, usize) -> bool) -> Vec<Loops> {
    let mut all = Vec::new();
    for (i, vertices) in loops.iter().enumerate() {
        for k in 0..vertices.len() {
            let mut edited = loops.clone();
            if edit(&mut edited[i], k) {
                all.push(edited);
            }
        }
    }
    all
}

fn without_a_vertex(loops: &Loops) -> Vec<Loops> {
    each_vertex(loops, |vertices, k| {
        vertices.remove(k);
        true
    })
}

fn without_a_bulge(loops: &Loops) -> Vec<Loops> {
    each_vertex(loops, |vertices, k| {
        core::mem::take(&mut vertices[k].bulge) != 0.0
    })
}
