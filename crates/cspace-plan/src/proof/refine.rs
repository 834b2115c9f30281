//! Triangles split until each has a witness.

use core::f64::consts::TAU;

use cspace::{Configuration, Coordinates, PairSpace, PatchId, Touching};
use cspace_model::write::mesh::Mesh;

use crate::proof::barrier::{Barrier, MOST_TRIANGLES};
use crate::proof::complex::{Complex, Triangle};
use crate::proof::error::ProofError;
use crate::proof::witness::{Corners, Materials, Witness};

/// Triangles are not split below this share of the depth: discs much larger than they overlap there, or none do.
const SMALLEST: f64 = 1e-3;
/// Number of a patch's last witnesses that are tried before others are searched.
const REMEMBERED: usize = 8;

/// The triangles of a mesh that are of a region. At a full turn's ends the same vertices come in the same order: they are one.
pub(crate) fn complex(
    mesh: &Mesh,
    full_turn: bool,
    of_region: impl Fn(PatchId) -> bool,
) -> Complex {
    let mut complex = Complex::default();
    let (lo, hi) = mesh.ends;
    let at = |theta: f64| {
        (mesh.vertices.iter().enumerate())
            .filter(move |(_, v)| v.theta == theta)
            .map(|(i, _)| i as u32)
    };
    let mut same: Vec<(u32, i32)> = (0..mesh.vertices.len() as u32).map(|v| (v, 0)).collect();
    if full_turn {
        for (first, last) in at(lo).zip(at(hi)) {
            same[last as usize] = (first, 1);
        }
    }
    // The number of each vertex that is used.
    let mut numbers: Vec<Option<u32>> = vec![None; mesh.vertices.len()];
    for t in mesh.triangles.iter().filter(|t| of_region(t.patch)) {
        let corners = t.vertices.map(|v| same[v as usize]);
        let vertices = corners.map(|(v, _)| {
            *numbers[v as usize].get_or_insert_with(|| {
                let c = mesh.vertices[v as usize];
                complex.vertices.push([c.x, c.y, c.theta]);
                complex.vertices.len() as u32 - 1
            })
        });
        complex.add(Triangle {
            vertices,
            turns: corners.map(|(_, turns)| turns),
            patch: t.patch,
            witness: None,
        });
    }
    complex
}

/// Gives every triangle a witness.
pub(crate) fn refine(
    complex: &mut Complex,
    barrier: &Barrier,
    materials: &Materials<'_>,
    lever: f64,
) -> Result<Vec<Witness>, ProofError> {
    let space = &barrier.space;
    let mut witnesses: Vec<Witness> = Vec::new();
    let mut known: Vec<Vec<u32>> = vec![Vec::new(); space.patch_count()];
    let mut open: Vec<u32> = (0..complex.triangles.len() as u32).rev().collect();
    while let Some(number) = open.pop() {
        let t = complex.triangles[number as usize];
        let corners = Corners::new(complex.corners(&t));
        let holds = |w: u32| materials.is_enough(corners.overlap(&witnesses[w as usize]));
        let known = &mut known[t.patch.index()];
        let tried = t.witness.iter().chain(known.iter().rev()).copied();
        let mut found = tried.into_iter().find(|&w| holds(w));
        if found.is_none() {
            let touching = touching(space, t.patch, corners.middle())?;
            if let Some(witness) = materials.best(&corners, &touching, lever) {
                found = Some(witnesses.len() as u32);
                known.push(witnesses.len() as u32);
                witnesses.push(witness);
                if known.len() > REMEMBERED {
                    known.remove(0);
                }
            }
        }
        complex.triangles[number as usize].witness = found;
        if found.is_none() {
            if corners.extent(lever) < SMALLEST * materials.depth {
                let at = corners.middle();
                return Err(ProofError::NoWitness { at });
            }
            if complex.triangles.len() >= MOST_TRIANGLES {
                return Err(barrier.too_many_triangles());
            }
            open.push(number);
            open.extend(complex.halve(number, lever));
        }
    }
    Ok(witnesses)
}

/// Points at which the features of a patch touch, or would touch, at a configuration.
fn touching(
    space: &PairSpace,
    patch: PatchId,
    [x, y, theta]: [f64; 3],
) -> Result<Touching, ProofError> {
    let theta = theta - TAU * (theta / TAU).round();
    let at = Coordinates::Planar(Configuration::new(x, y, theta));
    Ok(space.patch(patch)?.contact()?.touching(at)?)
}
