//! Where a part goes in a container among parts that are placed: the lowest place over all orientations, and the tightest.
//!
//! *Lowest*: with a unit vector d, down by default, and a point q of the part,
//!
//! ```text
//! maximise d · (p + R_θ q) over the closure of free (p, θ), then d⊥ · (p + R_θ q), then −|θ|
//! ```
//!
//! where d⊥ is d turned to the right: of the lowest places the leftmost. The contact space knows it wherever there is room
//! ([`ContactSpace::farthest`](cspace::ContactSpace::farthest)). Places without room are those of exact fits, which [`NoFit`] knows at each
//! orientation; there edges lie flush, and so there are finitely many.
//!
//! *Tightest*: with the outlines ∂P of the part and ∂W of what is around it,
//!
//! ```text
//! maximise length(∂(R_θ P + p) ∩ ∂W), then as for the lowest
//! ```
//!
//! A length is shared only where edges lie flush. At each of these orientations it is greatest where the boundary of the positions has a
//! vertex, or a corner of the one is on a corner of the other: between these it changes evenly.
//!
//! ```
//! use cspace::{Part, Point, Silent, Vector};
//! use cspace_plan::nest::Nest;
//! // The last of four tiles fits exactly.
//! let tray = Part::rectangle("tray", (0.0, 0.0), 4.0, 2.0)?;
//! let tile = Part::rectangle("tile", (0.0, 0.0), 2.0, 1.0)?;
//! let at = |x, y| cspace::Configuration::new(x, y, 0.0);
//! let placed = [(&tile, at(-1.0, -0.5)), (&tile, at(1.0, -0.5)), (&tile, at(1.0, 0.5))];
//! let nest = Nest::new(&tray, &placed, &tile, None, &Silent)?;
//! let last = nest.lowest(Vector::new(0.0, -1.0), Point::ORIGIN).ok_or("it does not fit")?;
//! assert!((last.at.x + 1.0).abs() < 1e-9 && (last.at.y - 0.5).abs() < 1e-9);
//! assert!((last.length - 6.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod flush;
mod touching;
mod walls;

use std::sync::{Arc, OnceLock};

use core::f64::consts::TAU;

use cspace::{
    Configuration, Coordinates, CurveGeometry, Edge, FeatureName, NoFit, Options, PairError,
    PairSpace, Part, PartError, Point, Progress, QueryError, Relation, Slice, Vector,
};

use crate::exact_fit::touching_distance;

use flush::Flush;
use walls::Walls;

pub use walls::Owner;

/// Down.
const DOWN: Vector = Vector { x: 0.0, y: -1.0 };

/// Reasons for which nothing is known of a part in a container.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NestError {
    /// A placed part is not within the container.
    #[error("the placed part {number}, counted from 0, overlaps the outside of the container")]
    Outside {
        /// Its number.
        number: usize,
    },
    /// Two placed parts overlap.
    #[error("the placed parts {first} and {second} overlap, counted from 0")]
    Overlap {
        /// Number of the first of them.
        first: usize,
        /// Number of the second.
        second: usize,
    },
    /// A part is not flat.
    #[error("{part:?} has layers: give its outline at the height at which it is to be placed")]
    Layers {
        /// Its name.
        part: String,
    },
    /// The walls are no part.
    #[error(transparent)]
    Part(#[from] PartError),
    /// The space cannot be computed.
    #[error(transparent)]
    Space(#[from] PairError),
}

impl NestError {
    /// Two of the container and the placed parts overlap, which are numbered from 0 and from 1.
    fn overlap(first: usize, second: usize) -> Self {
        match first {
            0 => Self::Outside { number: second - 1 },
            _ => Self::Overlap {
                first: first - 1,
                second: second - 1,
            },
        }
    }
}

/// A place of the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// The configuration.
    pub at: Configuration,
    /// What touches: whose feature, its name there, and the feature of the part.
    pub touching: Vec<(Owner, FeatureName, FeatureName)>,
    /// The length of the part's outline that lies flush, in the model's unit.
    pub length: f64,
}

/// A part, and what it is to be placed among.
#[derive(Debug)]
pub struct Nest {
    space: Arc<PairSpace>,
    walls: Walls,
    /// The edges of the container and of the placed parts.
    edges: Vec<Edge>,
    /// Positions at single orientations, exact fits among them.
    no_fit: OnceLock<NoFit>,
    /// The orientations at which the part lies flush.
    flush: OnceLock<Vec<Flush>>,
    /// What is nearer touches, in the model's unit of length.
    touch: f64,
}

/// How far a place is, in the direction and to the right of it, and how little it is turned.
type Rank = [f64; 3];

impl Nest {
    /// A part in a container, beside parts that are placed by configurations and may touch; `window` limits its orientations.
    ///
    /// # Errors
    /// If parts overlap, stick out of the container, or have layers; and if the space cannot be computed.
    pub fn new(
        container: &Part,
        placed: &[(&Part, Configuration)],
        moving: &Part,
        window: Option<(f64, f64)>,
        progress: &dyn Progress,
    ) -> Result<Self, NestError> {
        let walls = Walls::new(container, placed, moving)?;
        let options = Options {
            window,
            ..Options::default()
        };
        let space =
            PairSpace::compute_with(&walls.part, moving, Relation::Planar, &options, progress)?;
        let touch = touching_distance(&walls.part, moving).max(2.0 * space.resolution());
        let edges = (walls.part.loops().iter().zip(0..))
            .filter(|(_, loop_index)| walls.has(*loop_index))
            .flat_map(|(of, _)| of.edges());
        Ok(Self {
            edges: edges.collect(),
            space: Arc::new(space),
            walls,
            no_fit: OnceLock::new(),
            flush: OnceLock::new(),
            touch,
        })
    }

    /// The space of the walls, the container's outside with a frame around it among them, and the part. Its caged regions are within the
    /// container.
    pub fn space(&self) -> &Arc<PairSpace> {
        &self.space
    }

    fn moving(&self) -> &Part {
        self.space.moving()
    }

    /// Whether the part fits somewhere, with room or exactly.
    pub fn fits(&self) -> bool {
        let has_room = self.space.regions().iter().any(|r| !r.unbounded);
        has_room || (self.exact()).any(|theta| !self.positions(theta).loops.is_empty())
    }

    /// The place at which a point of the part, in its frame, is farthest in a direction; `None` if it fits nowhere, or the direction has no
    /// length.
    pub fn lowest(&self, direction: Vector, about: Point) -> Option<Place> {
        let unit = direction.unit();
        if !unit.x.is_finite() || !unit.y.is_finite() || !about.is_finite() {
            return None;
        }
        let PairSpace::Planar(space) = &*self.space else {
            return None;
        };
        let roomy = space.farthest(unit, about).map(|f| f.configuration);
        let rank = |at: Configuration| rank(unit, about, at);
        // Flush orientations that the space knows to its resolution, and those of exact fits.
        let near = roomy.into_iter().flat_map(|roomy| {
            (self.flush().iter()).filter_map(move |flush| {
                let theta = flush.theta + TAU * ((roomy.theta - flush.theta) / TAU).round();
                let is_flush =
                    |p: &flush::Pair| (theta - roomy.theta).abs() * p.length() <= self.touch;
                flush.pairs.iter().any(is_flush).then_some(theta)
            })
        });
        let mut best: Option<(Rank, Configuration)> = None;
        for theta in near.filter_map(|t| self.in_window(t)).chain(self.exact()) {
            for at in places(&self.positions(theta), unit) {
                self.keep(&mut best, rank(at), at);
            }
        }
        // Where both are as far, that which is exact by name.
        if let Some(at) = roomy {
            let is_exact = best.is_some_and(|(known, _)| known[0] >= rank(at)[0] - self.touch);
            if !is_exact {
                best = Some((rank(at), at));
            }
        }
        best.map(|(_, at)| self.place(at))
    }

    /// The place at which the greatest length of the part's outline lies flush on the container and the placed parts; of several the
    /// lowest, then the leftmost, by the part's centroid. Where nothing can lie flush, the lowest place; `None` if the part fits nowhere.
    pub fn tightest(&self) -> Option<Place> {
        let about = self.moving().moments().centroid;
        let mut longest = 0.0;
        let mut best: Option<(Rank, Configuration)> = None;
        for flush in self.flush() {
            if flush.most() < longest - self.touch {
                break;
            }
            let Some(theta) = self.in_window(flush.theta) else {
                continue;
            };
            let positions = self.positions(theta);
            let corners = (flush.pairs.iter())
                .flat_map(|pair| pair.corners(theta))
                .filter(|&p| {
                    (positions.nearest(p)).is_some_and(|(_, q)| q.distance(p) <= self.touch)
                })
                .map(|p| Configuration::new(p.x, p.y, theta));
            for at in places(&positions, DOWN).chain(corners) {
                let length = touching::length(&self.edges, self.moving(), at, self.touch);
                if length > longest + self.touch {
                    (longest, best) = (length, None);
                }
                if length > 0.0 && length >= longest - self.touch {
                    self.keep(&mut best, rank(DOWN, about, at), at);
                }
            }
        }
        match best {
            Some((_, at)) => Some(self.place(at)),
            None => self.lowest(DOWN, about),
        }
    }

    /// Keeps the better of two places: the one that is farther, then farther to the right, then less turned.
    fn keep(&self, best: &mut Option<(Rank, Configuration)>, rank: Rank, at: Configuration) {
        let is_better = best.is_none_or(|(known, _)| {
            let more = (rank.iter().zip(known))
                .map(|(new, old)| new - old)
                .find(|more| more.abs() > self.touch);
            more.is_some_and(|more| more > 0.0)
        });
        if is_better {
            *best = Some((rank, at));
        }
    }

    fn place(&self, at: Configuration) -> Place {
        Place {
            at,
            touching: self.touching(at).unwrap_or_default(),
            length: touching::length(&self.edges, self.moving(), at, self.touch),
        }
    }

    fn touching(
        &self,
        at: Configuration,
    ) -> Result<Vec<(Owner, FeatureName, FeatureName)>, QueryError> {
        let near = (self.space).near_features(Coordinates::Planar(at), self.touch)?;
        let of = |n: &cspace::NearFeatures| {
            let (owner, wall) = self.walls.owner(n.fixed.name)?;
            Some((owner, wall, n.moving.name))
        };
        Ok(near.iter().filter_map(of).collect())
    }

    /// The orientations at which the part may fit exactly.
    fn exact(&self) -> impl Iterator<Item = f64> {
        let is_round = self.moving().symmetry().is_round();
        let flush = (self.flush().iter())
            .filter(move |flush| !is_round && flush.holds(self.touch))
            .map(|flush| flush.theta);
        let any = is_round.then_some(0.0).into_iter();
        any.chain(flush).filter_map(|theta| self.in_window(theta))
    }

    fn flush(&self) -> &[Flush] {
        (self.flush).get_or_init(|| Flush::all(&self.edges, self.moving(), self.touch))
    }

    /// The positions within the container at an orientation.
    fn positions(&self, theta: f64) -> Slice {
        let no_fit = (self.no_fit).get_or_init(|| NoFit::inside(self.space.fixed(), self.moving()));
        no_fit.at(theta)
    }

    /// The orientation by whole turns in the window; a round part has all of them.
    fn in_window(&self, theta: f64) -> Option<f64> {
        let PairSpace::Planar(space) = &*self.space else {
            return None;
        };
        let window = space.window();
        if window.full_turn {
            return Some(theta);
        }
        if self.moving().symmetry().is_round() {
            return Some(window.lo);
        }
        let theta = theta + TAU * ((window.lo - theta) / TAU).ceil();
        (theta <= window.hi).then_some(theta)
    }
}

fn rank(direction: Vector, about: Point, at: Configuration) -> Rank {
    let place = at.fixed_from_moving(about).to_vector();
    [
        direction.dot(place),
        direction.right().dot(place),
        -at.theta.abs(),
    ]
}

/// The places of a slice at which a point of the part may be farthest: where curves begin, and where they are across the direction.
fn places(slice: &Slice, direction: Vector) -> impl Iterator<Item = Configuration> {
    let theta = slice.theta;
    slice.curves.iter().flat_map(move |c| {
        let across = match c.geometry {
            CurveGeometry::Segment { .. } => None,
            CurveGeometry::Arc { center, radius, .. } => Some(center + direction * radius),
            CurveGeometry::FlatArc { start, end, bulge } => {
                let edge = Edge::between(start, end, bulge);
                Some(edge.center() + direction * edge.radius())
            }
        };
        let nearest = across.map(|p| c.geometry.nearest(p));
        let ends = [c.geometry.point(0.0), c.geometry.point(1.0)];
        ends.into_iter()
            .chain(nearest)
            .map(move |p| Configuration::new(p.x, p.y, theta))
    })
}
