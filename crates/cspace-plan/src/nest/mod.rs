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
//! use cspace_plan::nest::{Nest, Orientations};
//! // The last of four tiles fits exactly.
//! let tray = Part::rectangle("tray", (0.0, 0.0), 4.0, 2.0)?;
//! let tile = Part::rectangle("tile", (0.0, 0.0), 2.0, 1.0)?;
//! let at = |x, y| cspace::Configuration::new(x, y, 0.0);
//! let placed = [(&tile, at(-1.0, -0.5)), (&tile, at(1.0, -0.5)), (&tile, at(1.0, 0.5))];
//! let nest = Nest::new(&tray, &placed, &tile, Orientations::All, &Silent)?;
//! let last = nest.lowest(Vector::new(0.0, -1.0), Point::ORIGIN).ok_or("it does not fit")?;
//! assert!((last.at.x + 1.0).abs() < 1e-9 && (last.at.y - 0.5).abs() < 1e-9);
//! assert!((last.length - 6.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod flush;
mod touching;
mod walls;

use std::sync::{Arc, OnceLock};

use core::f64::consts::TAU;

use cspace::pair::touching_features;
use cspace::{
    Configuration, CurveGeometry, Edge, FeatureName, NoFit, Options, PairSpace, Part, Point,
    Progress, Relation, Slice, Vector,
};

use crate::exact_fit::touching_distance;
use crate::legs::Scene;

use flush::Flush;
use walls::{CLOSE, Walls};

pub use error::NestError;
pub use walls::Owner;

/// Down.
const DOWN: Vector = Vector { x: 0.0, y: -1.0 };

/// A place of the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// The configuration.
    pub at: Configuration,
    /// Contacts: whose feature touches, its name there, and the feature of the part.
    pub touching: Vec<(Owner, FeatureName, FeatureName)>,
    /// The length of the part's outline that lies flush, in the model's unit.
    pub length: f64,
}

/// The orientations that a part may have, in radians.
#[derive(Debug, Clone, PartialEq)]
pub enum Orientations {
    /// All of a turn.
    All,
    /// A window from the first to the second.
    Window(f64, f64),
    /// These alone: no contact space is computed.
    These(Vec<f64>),
}

/// A part, and what it is to be placed among.
#[derive(Debug)]
pub struct Nest {
    walls: Walls,
    moving: Part,
    orientations: Orientations,
    /// The space of the walls and the part, unless single orientations were asked for.
    space: Option<Arc<PairSpace>>,
    /// The edges of the container and of the placed parts.
    edges: Vec<Edge>,
    /// Positions at single orientations, exact fits among them.
    no_fit: OnceLock<NoFit>,
    /// The orientations at which the part lies flush.
    flush: OnceLock<Vec<Flush>>,
    scene: OnceLock<Scene>,
    /// Distance within which features touch, in the model's unit of length.
    touch: f64,
}

/// How far a place is, in the direction and to the right of it, and how little it is turned.
type Rank = [f64; 3];

impl Nest {
    /// A part in a container, beside parts that are placed by configurations and may touch.
    ///
    /// # Errors
    /// If parts overlap, stick out of the container, or have layers; and if the space cannot be computed.
    pub fn new(
        container: &Part,
        placed: &[(&Part, Configuration)],
        moving: &Part,
        orientations: Orientations,
        progress: &dyn Progress,
    ) -> Result<Self, NestError> {
        let walls = Walls::new(container, placed, moving)?;
        let mut touch = touching_distance(&walls.part, moving);
        let mut space = None;
        if !matches!(orientations, Orientations::These(_)) {
            let window = match orientations {
                Orientations::Window(lo, hi) => Some((lo, hi)),
                _ => None,
            };
            let options = Options {
                window,
                ..Options::default()
            };
            let relation = Relation::Planar;
            let computed =
                PairSpace::compute_with(&walls.part, moving, relation, &options, progress)?;
            // Contacts at sharp corners are known to less.
            touch = touch.max(2.0 * computed.resolution());
            space = Some(Arc::new(computed));
        }
        let loops = walls.part.loops().iter().enumerate();
        let edges = loops
            .filter(|(loop_index, _)| walls.has(*loop_index))
            .flat_map(|(_, of)| of.edges());
        Ok(Self {
            edges: edges.collect(),
            space,
            walls,
            moving: moving.clone(),
            orientations,
            no_fit: OnceLock::new(),
            flush: OnceLock::new(),
            scene: OnceLock::new(),
            touch,
        })
    }

    /// The space of the walls, the container's outside with a frame around it among them, and the part; its caged regions are within the
    /// container. `None` where single orientations were asked for.
    pub fn space(&self) -> Option<&Arc<PairSpace>> {
        self.space.as_ref()
    }

    /// The part.
    pub fn moving(&self) -> &Part {
        &self.moving
    }

    /// Whether the part fits somewhere, with room or exactly.
    pub fn fits(&self) -> bool {
        let regions = self.space.iter().flat_map(|space| space.regions());
        regions.into_iter().any(|r| !r.unbounded)
            || (self.exact().into_iter()).any(|theta| !self.positions(theta).loops.is_empty())
    }

    /// The place at which a point of the part, in its frame, is farthest in a direction; `None` if it fits nowhere, or the direction has no
    /// length.
    pub fn lowest(&self, direction: Vector, about: Point) -> Option<Place> {
        let unit = direction.unit();
        if !unit.x.is_finite() || !unit.y.is_finite() || !about.is_finite() {
            return None;
        }
        let roomy = match self.space.as_deref() {
            Some(PairSpace::Planar(space)) => space.farthest(unit, about),
            _ => None,
        };
        let roomy = roomy
            .map(|f| f.configuration)
            .filter(|at| self.touches(*at));
        let mut thetas = self.exact();
        thetas.extend(
            roomy
                .into_iter()
                .flat_map(|roomy| self.flush_at(roomy.theta)),
        );
        let rank = |at: Configuration| rank(unit, about, at);
        let mut best: Option<(Rank, Configuration)> = None;
        for theta in thetas {
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
    /// lowest of a point of the part, in its frame, then the leftmost. Where nothing can lie flush, the lowest place; `None` if the part
    /// fits nowhere.
    pub fn tightest(&self, about: Point) -> Option<Place> {
        let mut longest = 0.0;
        let mut best: Option<(Rank, Configuration)> = None;
        for flush in self.flush() {
            if flush.most() < longest - self.touch {
                break;
            }
            let Some(theta) = self.allowed(flush) else {
                continue;
            };
            let positions = self.positions(theta);
            let is_place = |&p: &Point| {
                (positions.nearest(p)).is_some_and(|(_, q)| q.distance(p) <= self.touch)
            };
            let corners = (flush.pairs.iter().flat_map(|pair| pair.corners(theta)))
                .filter(is_place)
                .map(|p| Configuration::new(p.x, p.y, theta));
            for at in places(&positions, DOWN).chain(corners) {
                let length = touching::length(&self.edges, &self.moving, at, self.touch);
                let rank = rank(DOWN, about, at);
                if length > longest + self.touch && self.touches(at) {
                    (longest, best) = (length, Some((rank, at)));
                } else if length > 0.0 && length >= longest - self.touch {
                    self.keep(&mut best, rank, at);
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
        if is_better && self.touches(at) {
            *best = Some((rank, at));
        }
    }

    /// Whether the part touches walls at a configuration and overlaps none: slices that are in doubt may have other places.
    fn touches(&self, at: Configuration) -> bool {
        let scene = (self.scene).get_or_init(|| Scene::new(&self.walls.part, &self.moving, None));
        let depth = CLOSE * self.walls.part.size().max(self.moving.size());
        scene.touches([at.x, at.y, at.theta], depth)
    }

    fn place(&self, at: Configuration) -> Place {
        let near = touching_features(&self.walls.part, &self.moving, at, self.touch);
        let touching = near.iter().filter_map(|n| {
            let (owner, wall) = self.walls.owner(n.fixed.name)?;
            Some((owner, wall, n.moving.name))
        });
        Place {
            at,
            touching: touching.collect(),
            length: touching::length(&self.edges, &self.moving, at, self.touch),
        }
    }

    /// The orientations that are looked at whether or not there is room: those at which the part may fit exactly, or that alone it may
    /// have.
    fn exact(&self) -> Vec<f64> {
        let is_round = self.moving.symmetry().is_round();
        match &self.orientations {
            Orientations::These(thetas) => thetas.clone(),
            Orientations::Window(lo, _) if is_round => vec![*lo],
            Orientations::All if is_round => vec![0.0],
            _ => (self.flush().iter())
                .filter(|flush| flush.holds(self.touch))
                .filter_map(|flush| self.allowed(flush))
                .collect(),
        }
    }

    fn flush(&self) -> &[Flush] {
        (self.flush).get_or_init(|| Flush::all(&self.edges, &self.moving, self.touch))
    }

    /// The flush orientations that are one with an orientation.
    fn flush_at(&self, theta: f64) -> impl Iterator<Item = f64> {
        let touch = self.touch;
        (self.flush().iter()).filter_map(move |flush| flush.beside(theta, touch))
    }

    /// The positions within the container at an orientation.
    fn positions(&self, theta: f64) -> Slice {
        let no_fit = (self.no_fit).get_or_init(|| NoFit::inside(&self.walls.part, &self.moving));
        no_fit.at(theta)
    }

    /// A flush orientation as one that the part may have.
    fn allowed(&self, flush: &Flush) -> Option<f64> {
        match &self.orientations {
            Orientations::All => Some(flush.theta),
            Orientations::Window(lo, hi) => {
                let theta = flush.theta + TAU * ((lo - flush.theta) / TAU).ceil();
                (theta <= *hi).then_some(theta)
            }
            Orientations::These(thetas) => {
                (thetas.iter().copied()).find(|&theta| flush.beside(theta, self.touch).is_some())
            }
        }
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
