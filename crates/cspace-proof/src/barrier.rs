//! The surface between start and goal: the boundary of a region of the pair with its moving part shrunk.

use cspace::{
    Configuration, ContactSpace, Coordinates, Location, Options, PairError, PairSpace, Part,
    PatchId, Point, Progress, RegionId, Relation, Vertex,
};
use cspace_io::write::mesh::{Mesh, MeshOptions};
use cspace_plan::shrunk;

use crate::error::ProofError;

/// The largest depth that is tried, as a share of the moving part's size.
const LARGEST: f64 = 0.25;
/// The least, as a share of it: well above what is resolved.
const LEAST: f64 = 1e-7;
/// How far the triangles may be from the surface, as a share of the depth.
const OFF: f64 = 0.25;

/// The pair with its moving part shrunk and drawn about the pivot.
pub(crate) struct Barrier {
    pub(crate) space: PairSpace,
    pub(crate) depth: f64,
    /// The region that is enclosed.
    region: RegionId,
}

/// The middle of the part's box: triangles that say where it is bend least with the orientation.
pub(crate) fn pivot(part: &Part) -> Point {
    part.bounds().center()
}

/// Where a point of the moving part is, and its orientation.
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
    Part::new(part.name(), loops)
}

impl Barrier {
    /// As deep as start and goal are apart, from a given depth downwards by halves.
    pub(crate) fn find(
        space: &ContactSpace,
        [from, to]: [Configuration; 2],
        depth: Option<f64>,
        progress: &dyn Progress,
    ) -> Result<Self, ProofError> {
        let size = space.moving().size();
        let mut depth = match depth {
            Some(depth) if !(depth > 0.0 && depth.is_finite()) => {
                return Err(ProofError::Depth(depth));
            }
            Some(depth) => depth,
            None => LARGEST * size,
        };
        let window = space.window();
        let options = Options {
            window: (!window.full_turn).then_some((window.lo, window.hi)),
            ..Options::default()
        };
        let pivot = pivot(space.moving());
        let mut least = depth;
        while depth >= LEAST * size {
            let failed = |error| ProofError::Part { depth, error };
            if let Some(part) = shrunk(space.moving(), depth).map_err(failed)? {
                let moving = centered(&part, pivot).map_err(failed)?;
                let fixed = space.fixed();
                let computed =
                    PairSpace::compute_with(fixed, &moving, Relation::Planar, &options, progress);
                if let Some(region) =
                    between(computed.as_ref(), [from, to].map(|c| about(c, pivot)))?
                {
                    return Ok(Self {
                        space: computed?,
                        depth,
                        region,
                    });
                }
            }
            least = depth;
            depth *= 0.5;
        }
        Err(ProofError::TooShallow { least })
    }

    /// The surface of the enclosed region: its mesh, and whether a triangle is of it.
    pub(crate) fn mesh(&self) -> Result<(Mesh, impl Fn(u32) -> bool + '_), ProofError> {
        let PairSpace::Planar(space) = &self.space else {
            return Err(ProofError::NotPlanar);
        };
        let size = space.fixed().size().max(space.moving().size());
        let tolerance = OFF * self.depth / size;
        let mesh = Mesh::new(space, &MeshOptions { tolerance }).map_err(|_| {
            ProofError::TooManyTriangles {
                limit: crate::refine::MOST_TRIANGLES,
                left: crate::refine::MOST_TRIANGLES,
                depth: self.depth,
            }
        })?;
        let of_region = |patch| {
            let patch = self.space.patch(PatchId(patch));
            patch.is_ok_and(|p| p.region().is_ok_and(|r| r == Some(self.region)))
        };
        Ok((mesh, of_region))
    }
}

/// The region of start or goal that is enclosed; none if they are in one.
fn between(
    space: Result<&PairSpace, &PairError>,
    ends: [Configuration; 2],
) -> Result<Option<RegionId>, ProofError> {
    let space = space.map_err(Clone::clone)?;
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
