//! Two parts with their motions, to be asked for distances.

use cspace::{
    Axis, AxisMotion, Coordinates, FeatureName, PairSpace, Part, Point, QueryError, Rotation,
    Vector,
};

use super::about::{configuration_about, numbers_about};
use super::at::At;
use super::depth::{NORMALS, is_deep, overlaps_deeper};
use super::near::Near;
use super::overlap::overlap;
use super::pose::{Coords, Pose, origin};
use super::search::{Nearest, RELATIVE, Search};
use super::tree::Tree;

const UNLIMITED: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Two parts and how their coordinates move them.
#[derive(Debug, Clone)]
pub struct Scene {
    fixed: Tree,
    moving: Tree,
    motions: Option<(AxisMotion, AxisMotion)>,
    /// The point of a moving part in the plane that legs move straight, in its own frame.
    about: Vector,
    /// How far a point of the moving part moves at most, for a unit of each coordinate.
    levers: Coords,
    size: f64,
    parts: (Part, Part),
    /// Least and greatest of each coordinate.
    limits: [(f64, f64); 3],
}

impl Scene {
    /// The parts of a pair with the motions of its class, and their limits.
    ///
    /// # Errors
    /// For a lower pair, whose parts are in permanent contact.
    pub fn of(space: &PairSpace) -> Result<Self, QueryError> {
        match space {
            PairSpace::Lower(_) => Err(QueryError::Permanent),
            PairSpace::FixedAxes(space) => {
                Ok(Self::new(space.fixed(), space.moving(), Some(space.axes())))
            }
            PairSpace::Planar(space) => {
                let window = space.window();
                let scene = Self::new(space.fixed(), space.moving(), None);
                Ok(if window.full_turn {
                    scene
                } else {
                    scene.with_window((window.lo, window.hi))
                })
            }
        }
    }

    /// Two parts, the moving one planar, or each on an axis with its range.
    pub fn new(fixed: &Part, moving: &Part, axes: Option<(Axis, Axis)>) -> Self {
        let parts = (fixed.clone(), moving.clone());
        let motions = axes.map(|(a, b)| (a.motion, b.motion));
        let origins = origins(motions);
        let fixed = Tree::new(fixed, origins.0);
        let moving = Tree::new(moving, origins.1);
        let lever = |motion: AxisMotion, tree: &Tree| match motion {
            AxisMotion::Fixed => 0.0,
            AxisMotion::Revolute { .. } => reach(tree),
            AxisMotion::Prismatic { .. } => 1.0,
        };
        let levers = match motions {
            None => [1.0, 1.0, reach(&moving)],
            Some((a, b)) => [lever(a, &fixed), lever(b, &moving), 0.0],
        };
        let limits = match axes {
            None => [UNLIMITED; 3],
            Some((a, b)) => {
                let [a, b] = [a, b].map(|axis| match axis.motion {
                    AxisMotion::Fixed => (0.0, 0.0),
                    _ => axis.range.unwrap_or(UNLIMITED),
                });
                [a, b, (0.0, 0.0)]
            }
        };
        Self {
            size: fixed.extent().max(moving.extent()),
            fixed,
            moving,
            motions,
            levers,
            parts,
            limits,
            about: Vector::ZERO,
        }
    }

    /// As before, with legs that move a point of the moving part straight and turn it about that: x and y of its numbers are the place of
    /// the point, which is given in the part's frame. On axes nothing changes.
    #[must_use]
    pub fn with_about(mut self, about: Vector) -> Self {
        if self.motions.is_none() {
            self.about = about;
            self.moving = Tree::new(&self.parts.1, about);
            self.levers[2] = reach(&self.moving);
        }
        self
    }

    /// The point of the moving part that legs move straight, in its own frame.
    pub fn about(&self) -> Vector {
        self.about
    }

    /// Whether a coordinate is a length: x and y, or the motion of a part that slides.
    pub(crate) fn is_length(&self, k: usize) -> bool {
        let slides = |motion: AxisMotion| matches!(motion, AxisMotion::Prismatic { .. });
        match (self.motions, k) {
            (None, k) => k < 2,
            (Some((fixed, _)), 0) => slides(fixed),
            (Some((_, moving)), 1) => slides(moving),
            _ => false,
        }
    }

    /// As before, with orientations limited to the window from the first to the second, radians.
    #[must_use]
    pub fn with_window(mut self, window: (f64, f64)) -> Self {
        self.limits[2] = window;
        self
    }

    /// As before, with coordinates limited to these.
    #[must_use]
    pub(crate) fn with_limits(mut self, limits: [(f64, f64); 3]) -> Self {
        self.limits = limits;
        self
    }

    /// Least and greatest of each coordinate: the window of orientations, the ranges of motion.
    pub fn limits(&self) -> [(f64, f64); 3] {
        self.limits
    }

    /// The nearest coordinates within the limits.
    pub fn within_limits(&self, at: Coords) -> Coords {
        core::array::from_fn(|k| at[k].clamp(self.limits[k].0, self.limits[k].1))
    }

    /// Whether the parts overlap at a configuration at which they do not just touch: their boundaries cross, or a loop of one is
    /// within the other.
    pub fn overlaps(&self, at: Coords) -> bool {
        let (a, b) = self.placed(at);
        overlap(&self.search(at, at), &a, &b)
    }

    /// Whether the parts overlap at a configuration, and at all others from which no point of them has moved farther than `depth`
    /// against the other. What overlaps five times as deep is always found,
    /// and most of what overlaps deeper.
    pub fn overlaps_deeply(&self, at: Coords, depth: f64) -> bool {
        let (a, b) = self.placed(at);
        let mut feet = Vec::new();
        (self.search(at, at)).within(NORMALS * depth, |near| feet.push(near));
        is_deep(&a, &b, &feet, depth)
    }

    /// Whether the parts touch at a configuration: they are nearer than a depth, and overlap by no more than it. What overlaps five times as
    /// deep is always found.
    pub fn touches(&self, at: Coords, depth: f64) -> bool {
        let (a, b) = self.placed(at);
        let search = self.search(at, at);
        search.at_below(0.0, depth).distance <= depth && !overlaps_deeper(&search, &a, &b, depth)
    }

    /// How far a point of a part moves at most, for a unit of each coordinate: lengths, in the model's unit.
    pub fn levers(&self) -> Coords {
        self.levers
    }

    /// How far the parts move on a leg, where each coordinate counts by its lever.
    pub(crate) fn long(&self, from: Coords, to: Coords) -> f64 {
        (0..3)
            .map(|k| ((to[k] - from[k]) * self.levers[k]).powi(2))
            .sum::<f64>()
            .sqrt()
    }

    /// The parts.
    pub fn parts(&self) -> (&Part, &Part) {
        (&self.parts.0, &self.parts.1)
    }

    /// How the coordinates of a pair with fixed axes move its parts.
    pub fn motions(&self) -> Option<(AxisMotion, AxisMotion)> {
        self.motions
    }

    /// The larger part's size, in the model's unit.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The coordinates of a pair's class as numbers: of a planar pair the place of the point that legs move straight, and θ.
    ///
    /// # Errors
    /// If they are those of another class.
    pub fn numbers(&self, at: Coordinates) -> Result<Coords, QueryError> {
        match (self.motions, at) {
            (None, Coordinates::Planar(c)) => Ok(numbers_about(c, self.about)),
            (Some(_), Coordinates::Axes { u, v }) => Ok([u, v, 0.0]),
            _ => Err(QueryError::Outside),
        }
    }

    /// Numbers as coordinates of the pair's class.
    pub fn coordinates(&self, at: Coords) -> Coordinates {
        match self.motions {
            None => Coordinates::Planar(configuration_about(at, self.about)),
            Some(_) => Coordinates::Axes { u: at[0], v: at[1] },
        }
    }

    /// A gradient by the coordinates of a pair's class, at a place, as one by its numbers.
    pub(crate) fn by_numbers(&self, gradient: Coords, at: Coords) -> Coords {
        if self.about == Vector::ZERO {
            return gradient;
        }
        // The position is that of the point, less R b.
        let by_turning = (Rotation::by(at[2]) * self.about).left();
        let [x, y, theta] = gradient;
        [x, y, theta - Vector::new(x, y).dot(by_turning)]
    }

    fn poses(&self, from: Coords, to: Coords) -> (Pose, Pose) {
        match self.motions {
            None => (Pose::STILL, Pose::planar(from, to)),
            Some((a, b)) => (
                Pose::on_axis(a, from[0], to[0]),
                Pose::on_axis(b, from[1], to[1]),
            ),
        }
    }

    /// Both parts at a configuration.
    fn placed(&self, at: Coords) -> (At<'_>, At<'_>) {
        let (a, b) = self.poses(at, at);
        let (origin_a, origin_b) = match self.motions {
            None => (Vector::ZERO, self.about),
            motions => origins(motions),
        };
        let placed = |part, pose: Pose, origin| At {
            part,
            placed: pose.at(0.0),
            origin,
        };
        (
            placed(&self.parts.0, a, origin_a),
            placed(&self.parts.1, b, origin_b),
        )
    }

    fn search(&self, from: Coords, to: Coords) -> Search<'_> {
        Search::new(&self.fixed, &self.moving, self.poses(from, to), self.size)
    }

    /// The least distance of the boundaries at a configuration, in the model's unit of length; where they cross, how far some vertex
    /// or normal is from doing so.
    pub fn clearance(&self, at: Coords) -> f64 {
        self.search(at, at).at(0.0).distance
    }

    /// Nearest edges of the boundaries at a configuration, with their distance.
    pub fn nearest(&self, at: Coords) -> Nearest {
        self.search(at, at).at(0.0)
    }

    /// The nearest edges but for two that are passed over.
    pub(crate) fn nearest_but(
        &self,
        at: Coords,
        passed: Option<(FeatureName, FeatureName)>,
    ) -> Nearest {
        self.search(at, at).at_but(0.0, passed)
    }

    /// The features that are nearest, of the fixed and of the moving part, and their nearest points in the frame of the assembly.
    pub fn nearest_places(
        &self,
        at: Coords,
    ) -> Option<((FeatureName, FeatureName), (Point, Point))> {
        self.search(at, at).nearest()
    }

    /// The least distance of the boundaries along a leg, right to a millionth; where that would take long, as of arcs that turn about
    /// arcs at little distance, to no more than a tenth.
    pub fn least(&self, from: Coords, to: Coords) -> Nearest {
        self.search(from, to).least(RELATIVE)
    }

    /// As above, within a hundredth.
    pub(crate) fn least_roughly(&self, from: Coords, to: Coords) -> Nearest {
        const ROUGHLY: f64 = 1e-2;
        self.search(from, to).least(ROUGHLY)
    }

    /// The least distance of the boundaries along a leg if it is less than a limit; else infinite.
    pub(crate) fn least_below(&self, from: Coords, to: Coords, limit: f64) -> Nearest {
        self.search(from, to).least_below(limit)
    }

    /// How much distances on a leg are rounded, at most: parts far from their origins lose digits.
    pub fn rounding(&self, from: Coords, to: Coords) -> f64 {
        /// Distances are rounded by this share of how far from their origins the parts are.
        const ROUNDED: f64 = 1e-14;
        let far: f64 = (0..2)
            .map(|k| from[k].abs().max(to[k].abs()) * self.levers[k])
            .sum();
        ROUNDED * (far + self.levers[2] + self.size)
    }

    /// Whether the boundaries are farther apart than a distance all along a leg.
    pub fn is_apart(&self, from: Coords, to: Coords, distance: f64) -> bool {
        self.search(from, to).is_apart(distance, u32::MAX)
    }

    /// Whether the boundaries are farther apart than a distance all along a leg, and that is found at little cost: what is nearer to it
    /// than a part in a hundred, and turns, may take long to tell.
    pub(crate) fn is_clearly_apart(&self, from: Coords, to: Coords, distance: f64) -> bool {
        /// So many pairs of discs and pieces for each edge of the parts, and at least.
        const EACH: usize = 16;
        const LEAST: usize = 2_000;
        let edges = self.fixed.pieces.len() + self.moving.pieces.len();
        let effort = u32::try_from(LEAST + EACH * edges).unwrap_or(u32::MAX);
        self.search(from, to).is_apart(distance, effort)
    }

    /// The pieces nearer than a distance at a configuration: their distances, with the gradients by the coordinates.
    pub fn near(&self, at: Coords, within: f64) -> Vec<Near> {
        let still = self.search(at, at);
        let mut found = Vec::new();
        still.within(within, |near| found.push(near));
        // The rates of the distances when one coordinate goes on alone.
        let coordinates = if self.motions.is_some() { 2 } else { 3 };
        for k in 0..coordinates {
            let mut to = at;
            to[k] += 1.0;
            let (a, b) = self.poses(at, to);
            for near in &mut found {
                near.gradient[k] = near.rate((&a, &b));
            }
        }
        found
    }
}

/// How far a part reaches from the origin of its placed frame.
fn reach(tree: &Tree) -> f64 {
    (tree.pieces.iter())
        .map(|p| p.middle.distance(Point::ORIGIN) + p.reach)
        .fold(0.0, f64::max)
}

/// The points of the two parts that are the origins of their placed frames.
fn origins(motions: Option<(AxisMotion, AxisMotion)>) -> (Vector, Vector) {
    motions.map_or((Vector::ZERO, Vector::ZERO), |(a, b)| {
        (origin(a), origin(b))
    })
}
