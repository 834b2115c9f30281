//! Two parts with their motions, to be asked for distances.

use cspace::{AxisMotion, Coordinates, Part, Point, QueryError, PairSpace, Vector, Configuration};

use super::pose::Pose;
use super::search::{Nearest, Search};
use super::shape::Piece;
use super::tree::Tree;

/// Coordinates as numbers: x, y and θ, or u, v and 0.
pub type Coords = [f64; 3];

/// Two parts and how their coordinates move them.
#[derive(Debug, Clone)]
pub struct Scene {
    fixed: Tree,
    moving: Tree,
    motions: Option<(AxisMotion, AxisMotion)>,
    /// How far a point of the moving part moves at most, for a unit of each coordinate.
    levers: Coords,
    size: f64,
}

impl Scene {
    /// The parts of a pair with the motions of its class.
    pub fn of(space: &PairSpace) -> Self {
        match space {
            PairSpace::FixedAxes(space) => {
                let (a, b) = space.axes();
                Self::new(space.fixed(), space.moving(), Some((a.motion, b.motion)))
            }
            _ => Self::new(space.fixed(), space.moving(), None),
        }
    }

    /// Two parts, the moving one planar, or each on an axis.
    pub fn new(fixed: &Part, moving: &Part, motions: Option<(AxisMotion, AxisMotion)>) -> Self {
        let origin = |motion: AxisMotion| match motion {
            AxisMotion::Revolute { center } => center.to_vector(),
            _ => Vector::ZERO,
        };
        let origins = motions.map_or((Vector::ZERO, Vector::ZERO), |(a, b)| (origin(a), origin(b)));
        let fixed = Tree::new(Piece::all(fixed, origins.0));
        let moving = Tree::new(Piece::all(moving, origins.1));
        let reach = |tree: &Tree| {
            (tree.pieces.iter())
                .map(|p| p.middle.distance(Point::ORIGIN) + p.reach)
                .fold(0.0, f64::max)
        };
        let lever = |motion: AxisMotion, tree: &Tree| match motion {
            AxisMotion::Fixed => 0.0,
            AxisMotion::Revolute { .. } => reach(tree),
            AxisMotion::Prismatic { .. } => 1.0,
        };
        let levers = match motions {
            None => [1.0, 1.0, reach(&moving)],
            Some((a, b)) => [lever(a, &fixed), lever(b, &moving), 0.0],
        };
        let extent = |tree: &Tree| tree.nodes.last().map_or(0.0, |n| 2.0 * n.reach);
        Self {
            size: extent(&fixed).max(extent(&moving)),
            fixed,
            moving,
            motions,
            levers,
        }
    }

    /// How far a point of a part moves at most, for a unit of each coordinate: lengths, in the model's unit.
    pub fn levers(&self) -> Coords {
        self.levers
    }

    /// The larger part's size, in the model's unit.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The coordinates of a pair's class as numbers.
    ///
    /// # Errors
    /// If they are those of another class.
    pub fn numbers(&self, at: Coordinates) -> Result<Coords, QueryError> {
        match (self.motions, at) {
            (None, Coordinates::Planar(c)) => Ok([c.x, c.y, c.theta]),
            (Some(_), Coordinates::Axes { u, v }) => Ok([u, v, 0.0]),
            _ => Err(QueryError::Outside),
        }
    }

    /// Numbers as coordinates of the pair's class.
    pub fn coordinates(&self, at: Coords) -> Coordinates {
        match self.motions {
            None => Coordinates::Planar(Configuration::new(at[0], at[1], at[2])),
            Some(_) => Coordinates::Axes { u: at[0], v: at[1] },
        }
    }

    fn poses(&self, from: Coords, to: Coords) -> (Pose, Pose) {
        let still = Pose {
            from: Point::ORIGIN,
            velocity: Vector::ZERO,
            angle: 0.0,
            turning: 0.0,
        };
        let Some((a, b)) = self.motions else {
            let moving = Pose {
                from: Point::new(from[0], from[1]),
                velocity: Vector::new(to[0] - from[0], to[1] - from[1]),
                angle: from[2],
                turning: to[2] - from[2],
            };
            return (still, moving);
        };
        let along = |motion: AxisMotion, s: f64, t: f64| match motion {
            AxisMotion::Fixed => still,
            AxisMotion::Revolute { center } => Pose {
                from: center,
                angle: s,
                turning: t - s,
                ..still
            },
            AxisMotion::Prismatic { direction } => {
                let d = direction.unit();
                Pose {
                    from: Point::ORIGIN + d * s,
                    velocity: d * (t - s),
                    ..still
                }
            }
        };
        (along(a, from[0], to[0]), along(b, from[1], to[1]))
    }

    fn search(&self, from: Coords, to: Coords) -> Search<'_> {
        Search::new(&self.fixed, &self.moving, self.poses(from, to), self.size)
    }

    /// The least distance of the boundaries at a configuration, in the model's unit of length.
    pub fn clearance(&self, at: Coords) -> f64 {
        self.search(at, at).at(0.0).distance
    }

    /// The same, with the edges that are nearest.
    pub fn nearest(&self, at: Coords) -> Nearest {
        self.search(at, at).at(0.0)
    }

    /// The least distance of the boundaries along a leg, right to a billionth.
    pub fn least(&self, from: Coords, to: Coords) -> Nearest {
        self.search(from, to).least()
    }

    /// Whether the boundaries are farther apart than a distance all along a leg.
    pub fn is_apart(&self, from: Coords, to: Coords, distance: f64) -> bool {
        self.search(from, to).is_apart(distance)
    }

    /// The pieces nearer than a distance at a configuration: their distances, with the gradients by the coordinates.
    pub fn near(&self, at: Coords, within: f64) -> Vec<Near> {
        let still = self.search(at, at);
        let mut found = Vec::new();
        still.within(within, |near| found.push(near));
        // The rates of the distances when one coordinate goes on alone.
        for (k, share) in [0, 1, 2].into_iter().map(|k| (k, 1.0)) {
            if self.motions.is_some() && k == 2 {
                continue;
            }
            let mut to = at;
            to[k] += share;
            let (a, b) = self.poses(at, to);
            for near in &mut found {
                near.gradient[k] = near.rate(&self.fixed, &self.moving, (&a, &b));
            }
        }
        found
    }
}

/// Two pieces that are near each other.
#[derive(Debug, Clone, Copy)]
pub struct Near {
    /// Their distance along the common normal.
    pub distance: f64,
    /// How it changes with each coordinate.
    pub gradient: Coords,
    pub(super) pieces: (u32, u32),
    /// The nearest points, each in its part's own frame.
    pub(super) points: (Point, Point),
    /// From the one on the fixed part to the other, of unit length.
    pub(super) direction: Vector,
}

impl Near {
    fn rate(&self, _: &Tree, _: &Tree, poses: (&Pose, &Pose)) -> f64 {
        let (a, b) = (poses.0.at(0.0), poses.1.at(0.0));
        let relative = b.point(self.points.1).velocity - a.point(self.points.0).velocity;
        self.direction.dot(relative)
    }

    /// The edges of the fixed and of the moving part, counted through all loops; of a vertex that which begins there.
    pub fn pieces(&self) -> (u32, u32) {
        self.pieces
    }
}
