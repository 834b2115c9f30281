//! The surface between start and goal: the boundary of a region of the pair with its moving part shrunk.

use cspace::{
    ComputeError, Configuration, ContactSpace, Coordinates, Location, Options, PairError,
    PairSpace, Part, PatchId, Point, Progress, RegionId, Relation, Vertex,
};
use cspace_model::write::mesh::{Mesh, MeshOptions};

use crate::proof::error::ProofError;
use crate::widest::shrunk;

/// A proof of more is a file of some hundred megabytes.
pub(crate) const MOST_TRIANGLES: usize = 1_000_000;
/// The largest depth that is tried, as a share of the moving part's size.
const LARGEST: f64 = 0.25;
/// The least, as a share of it: well above what is resolved.
const LEAST: f64 = 1e-7;
/// Largest distance of the triangles from the surface, as a share of the depth.
const OFF: f64 = 0.25;

/// Factor on the deepest of the halves, which is tried once.
const DEEPER: f64 = 1.5;

/// The pair with its moving part shrunk and drawn about the pivot.
pub(crate) struct Barrier {
    pub(crate) space: PairSpace,
    pub(crate) depth: f64,
    /// Whether the depth was given by the caller.
    given: bool,
    /// The region that is enclosed.
    region: RegionId,
}

fn is_interrupted(error: &ProofError) -> bool {
    matches!(
        error,
        ProofError::Pair(PairError::Compute(ComputeError::Interrupted))
    )
}

/// The middle of the part's box: triangles that say where it is bend least with the orientation.
pub(crate) fn pivot(part: &Part) -> Point {
    part.bounds().center()
}

/// Position of a point of the moving part, and its orientation.
fn about(at: Configuration, pivot: Point) -> Configuration {
    let p = at.fixed_from_moving(pivot);
    Configuration::new(p.x, p.y, at.theta)
}

fn centered(part: &Part, pivot: Point) -> Result<Part, cspace::PartError> {
    let loops = (part.loops().iter())
        .map(|l| {
            (l.vertices().iter())
                .map(|v| Vertex::new(v.x - pivot.x, v.y - pivot.y, v.bulge))
                .collect()
        })
        .collect();
    part.redrawn(loops)
}

impl Barrier {
    /// Finds a barrier as deep as start and goal are separated: at a given depth or its half, quarter and so on;
    /// without one, at about the largest.
    pub(crate) fn find(
        space: &ContactSpace,
        ends: [Configuration; 2],
        depth: Option<f64>,
        progress: &dyn Progress,
    ) -> Result<Self, ProofError> {
        let size = space.moving().size();
        let finest = LEAST * size;
        let mut tried = match depth {
            Some(depth) if !(depth > 0.0 && depth.is_finite()) => {
                return Err(ProofError::Depth(depth));
            }
            Some(depth) if depth < finest => return Err(ProofError::TooFine { depth, finest }),
            Some(depth) => depth,
            None => LARGEST * size,
        };
        let mut failed = None;
        while tried >= finest {
            match Self::at(space, ends, tried, progress) {
                Ok(Some(mut barrier)) => {
                    barrier.given = depth.is_some();
                    // Between this depth and its double, with which start and goal are in one region: fewer triangles.
                    let may_be_deeper = depth.is_none() && tried < LARGEST * size;
                    if !may_be_deeper {
                        return Ok(barrier);
                    }
                    return match Self::at(space, ends, DEEPER * tried, progress) {
                        Ok(Some(deeper)) => Ok(deeper),
                        Err(error) if is_interrupted(&error) => Err(error),
                        _ => Ok(barrier),
                    };
                }
                Ok(None) => {}
                Err(error) if is_interrupted(&error) => return Err(error),
                // At another depth the part may shrink to another shape.
                Err(error) => failed = Some(error),
            }
            tried *= 0.5;
        }
        let least = 2.0 * tried;
        Err(failed.unwrap_or(ProofError::TooShallow { least }))
    }

    /// Barrier for the moving part shrunk by a depth; `None` if start and goal are not separated then, or nothing is
    /// left of the part.
    fn at(
        space: &ContactSpace,
        ends: [Configuration; 2],
        depth: f64,
        progress: &dyn Progress,
    ) -> Result<Option<Self>, ProofError> {
        let window = space.window();
        let options = Options {
            window: (!window.full_turn).then_some((window.lo, window.hi)),
            ..Options::default()
        };
        let pivot = pivot(space.moving());
        let failed = |error| ProofError::Part { depth, error };
        let Some(part) = shrunk(space.moving(), depth).map_err(failed)? else {
            return Ok(None);
        };
        let moving = centered(&part, pivot).map_err(failed)?;
        let fixed = space.fixed();
        let space = PairSpace::compute_with(fixed, &moving, Relation::Planar, &options, progress)?;
        let region = between(&space, ends.map(|c| about(c, pivot)))?;
        Ok(region.map(|region| Self {
            space,
            depth,
            given: false,
            region,
        }))
    }

    pub(crate) fn too_many_triangles(&self) -> ProofError {
        ProofError::TooManyTriangles {
            limit: MOST_TRIANGLES,
            depth: self.depth,
            given: self.given,
        }
    }

    /// The surface of the enclosed region: its mesh, and whether a triangle is of it.
    pub(crate) fn mesh(&self) -> Result<(Mesh, impl Fn(PatchId) -> bool + '_), ProofError> {
        let PairSpace::Planar(space) = &self.space else {
            return Err(ProofError::NotPlanar);
        };
        let size = space.fixed().size().max(space.moving().size());
        let tolerance = OFF * self.depth / size;
        let mesh =
            Mesh::new(space, &MeshOptions { tolerance }).map_err(|_| self.too_many_triangles())?;
        let of_region = |patch| {
            let patch = self.space.patch(patch);
            patch.is_ok_and(|p| p.region().is_ok_and(|r| r == Some(self.region)))
        };
        Ok((mesh, of_region))
    }
}

/// The region of start or goal that is enclosed; none if they are in one.
fn between(space: &PairSpace, ends: [Configuration; 2]) -> Result<Option<RegionId>, ProofError> {
    let mut regions = Vec::new();
    for mut end in ends {
        if let PairSpace::Planar(space) = space
            && !space.window().full_turn
        {
            // By the window's own numbers.
            let window = space.window();
            let turns = (0.5 * (window.lo + window.hi) - end.theta) / core::f64::consts::TAU;
            end.theta += core::f64::consts::TAU * turns.round();
            end.theta = end.theta.clamp(window.lo, window.hi);
        }
        match space.locate(Coordinates::Planar(end))? {
            Location::Free(region) => regions.push(region),
            _ => return Ok(None),
        }
    }
    if regions[0] == regions[1] {
        return Ok(None);
    }
    let all = space.regions();
    let patches = |r: &RegionId| {
        let is_of = |p: &cspace::PairPatch<'_>| p.region().is_ok_and(|of| of == Some(*r));
        space.patches().filter(is_of).count()
    };
    regions.sort_by_key(|r| (all.get(r.index()).is_none_or(|r| r.unbounded), patches(r)));
    Ok(regions.first().copied())
}
