//! Construction of a proof for two configurations.

use cspace::{Configuration, ContactSpace, Part, Progress};
use cspace_check::Proof;

use crate::proof::barrier::{Barrier, pivot};
use crate::proof::error::ProofError;
use crate::proof::refine::{complex, refine};
use crate::proof::witness::Materials;

fn written(part: &Part) -> cspace_check::Part {
    let vertices = |l: &cspace::Loop| l.vertices().iter().map(|v| [v.x, v.y, v.bulge]).collect();
    let layer = |l: &cspace::Layer| cspace_check::Layer {
        z: l.z(),
        loops: l.loops().len(),
    };
    cspace_check::Part {
        name: part.name().to_owned(),
        loops: part.loops().iter().map(vertices).collect(),
        layers: match part.has_heights() {
            true => part.layers().iter().map(layer).collect(),
            false => Vec::new(),
        },
    }
}

/// Proves that no motion leads from one configuration to another, which are in different free regions.
///
/// The surface lies about `depth` deep in blocked space, in the model's unit of length; half, a quarter and so on as
/// deep if start and goal are not separated at that depth. Without `depth` it is as deep as possible, which needs the
/// fewest triangles. The proof has been checked.
///
/// # Errors
/// If there is no proof, or it would exceed the limits; and errors returned by `progress`.
///
/// ```
/// use cspace::{Configuration, ContactSpace, Options, Part, Vertex};
/// let square = |r: f64| [(-r, -r), (r, -r), (r, r), (-r, r)].map(|(x, y)| Vertex::line(x, y)).to_vec();
/// let frame = Part::new("frame", vec![square(4.0), square(2.0)])?;
/// let block = Part::rectangle("block", (0.0, 0.0), 2.0, 1.0)?;
/// let space = ContactSpace::compute(&frame, &block, &Options::default())?;
/// let (inside, outside) = (Configuration::new(0.0, 0.0, 0.0), Configuration::new(9.0, 0.0, 0.0));
/// let proof = cspace_plan::proof::prove(&space, inside, outside, None, &cspace::Silent)?;
/// assert_eq!(proof.check(), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn prove(
    space: &ContactSpace,
    from: Configuration,
    to: Configuration,
    depth: Option<f64>,
    progress: &dyn Progress,
) -> Result<Proof, ProofError> {
    let barrier = Barrier::find(space, [from, to], depth, progress)?;
    let window = space.window();
    let (mesh, of_region) = barrier.mesh()?;
    let mut complex = complex(&mesh, window.full_turn, of_region);
    let pivot = pivot(space.moving());
    let parts = [space.fixed(), space.moving()];
    let [fixed, moving] = parts.map(written);
    let layers = parts[0].meeting(parts[1]);
    let materials = Materials::new(&layers, written, pivot, barrier.depth);
    let lever = 0.5 * space.moving().size();
    let witnesses = refine(&mut complex, &barrier, &materials, lever)?;
    let triangle = |t: &crate::proof::complex::Triangle| {
        let ([a, b, c], [i, j, k]) = (t.vertices.map(i64::from), t.turns.map(i64::from));
        [a, b, c, i, j, k, t.witness.map_or(-1, i64::from)]
    };
    let proof = Proof {
        version: 1,
        unit: None,
        fixed,
        moving,
        window: (!window.full_turn).then_some([window.lo, window.hi]),
        start: [from.x, from.y, from.theta],
        goal: [to.x, to.y, to.theta],
        depth: barrier.depth,
        pivot: [pivot.x, pivot.y],
        vertices: complex.vertices.clone(),
        triangles: complex.triangles.iter().map(triangle).collect(),
        witnesses: (witnesses.iter())
            .map(|w| {
                let (q, c) = (pivot + w.moving.0, w.fixed.0);
                [q.x, q.y, w.moving.1, c.x, c.y, w.fixed.1]
            })
            .collect(),
    };
    proof.check().map_err(ProofError::Unsound)?;
    Ok(proof)
}
