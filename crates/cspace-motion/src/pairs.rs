//! The pairs of a mechanism that can meet, with their configuration spaces.

use cspace::{
    Classification, Configuration, Coordinates, FeatureContact, FeatureId, Options, PairSpace,
    PatchId, Placement, Point, Progress, QueryError, Real, Relation, Rotation, contact_function,
    parallel, touching_place,
};
use cspace_model::{Compute, Mechanism, MechanismError, PairEntry, compute_anew};

use crate::system::{Placed, Row, System};

/// Tolerance of contacts that count as touching, relative to the size of the pair: a dozen times the resolution of a
/// space, so that rounding does not open a computed contact.
const TOUCHING: f64 = 1e-10;
/// Lower bound of the tolerance as a multiple of the pair's own resolution, which is larger where parts were moved to
/// break ties.
const RESOLUTIONS: f64 = 4.0;

/// Patches that end within this of an orientation are there, too (radians): critical orientations are known to that, and what
/// keeps two sides together turns by rounding alone.
const BESIDE: f64 = 2e-10;

/// A pair of parts that can meet.
#[derive(Debug)]
pub struct MovingPair {
    /// The index of the part in whose frame configurations are.
    pub fixed: usize,
    /// The index of the other.
    pub moving: usize,
    /// Configuration space of the pair.
    pub space: PairSpace,
    /// The parts touch if they are no farther apart, in the model's unit of length.
    pub touch: f64,
    /// The coefficient of friction between them.
    pub friction: f64,
    ranges: [Option<(f64, f64)>; 2],
    /// The orientations of interest, as those of the pair's entry.
    window: Option<(f64, f64)>,
    /// Index among all pairs.
    order: usize,
}

/// A contact of two features.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// The pair, as it is listed.
    pub pair: usize,
    /// Patch on which they touch.
    pub patch: PatchId,
    /// The features of the fixed and of the moving part.
    pub features: (FeatureId, FeatureId),
    contact: FeatureContact,
    /// State of friction, where it is known.
    pub(crate) grip: Grip,
}

/// State of friction at a closed contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Grip {
    /// No friction.
    #[default]
    Smooth,
    /// It keeps the features from sliding.
    Sticks,
    /// The features slide: forwards if the moving part goes to the left of the normal, which points from the fixed part to it.
    Slides {
        /// Whether they slide forwards.
        forward: bool,
    },
}

impl Touch {
    /// Copy of the contact with another grip.
    pub(crate) fn with(self, grip: Grip) -> Self {
        Self { grip, ..self }
    }

    /// The contact of the features, by which its function is evaluated.
    pub fn contact(&self) -> &FeatureContact {
        &self.contact
    }
}

/// The pairs of a mechanism.
#[derive(Debug)]
pub struct Pairs {
    list: Vec<MovingPair>,
    apart: Vec<(usize, usize)>,
    left_out: Vec<MovingPair>,
}

impl Pairs {
    /// No pairs.
    pub(crate) fn none() -> Self {
        Self {
            list: Vec::new(),
            apart: Vec::new(),
            left_out: Vec::new(),
        }
    }

    /// Computes the spaces of all pairs of a mechanism that are not connected by a joint, each once, in parallel. Pairs
    /// whose parts never meet are left out, and so are pairs whose parts both stand still.
    ///
    /// # Errors
    /// If a space cannot be computed.
    pub fn compute(mechanism: &Mechanism, progress: &dyn Progress) -> Result<Self, MechanismError> {
        Self::compute_by(mechanism, &compute_anew(progress))
    }

    /// As [`compute`](Self::compute), with the spaces from elsewhere.
    ///
    /// # Errors
    /// Errors that `compute` returns.
    pub fn compute_by(
        mechanism: &Mechanism,
        compute: &Compute<'_>,
    ) -> Result<Self, MechanismError> {
        let candidates = mechanism.pairs.iter().copied();
        let candidates: Vec<PairEntry> = candidates
            .filter(|pair| can_meet(mechanism, pair))
            .collect();
        let computed = parallel::map(&candidates, 1, |pair| {
            let space = mechanism.compute_by(pair, &Options::default(), compute)?;
            Ok((*pair, space))
        });
        let computed: Result<Vec<_>, MechanismError> = computed.into_iter().collect();
        Ok(Self::of(mechanism, computed?))
    }

    /// The pairs with spaces that are known. Those that a joint connects are left out, and so are those whose parts both stand still.
    pub fn of(
        mechanism: &Mechanism,
        spaces: impl IntoIterator<Item = (PairEntry, PairSpace)>,
    ) -> Self {
        let known = spaces.into_iter();
        let known = known.filter(|(pair, _)| can_meet(mechanism, pair));
        let all = known.enumerate().map(|(order, (pair, space))| {
            let moving = MovingPair::of(mechanism, &pair, space);
            MovingPair { order, ..moving }
        });
        let mut pairs = Self {
            list: all.collect(),
            ..Self::none()
        };
        pairs.part();
        pairs
    }

    /// Moves pairs that never meet from the list to those that are apart.
    fn part(&mut self) {
        // A space without contact is free everywhere, or blocked everywhere: overlap, or an exact fit.
        let meet = |p: &MovingPair| p.space.patch_count() > 0 || p.space.region_count() == 0;
        let (list, apart): (Vec<_>, Vec<_>) =
            core::mem::take(&mut self.list).into_iter().partition(meet);
        self.list = list;
        self.apart.extend(apart.iter().map(|p| (p.fixed, p.moving)));
    }

    /// Computes the spaces of some parts again, which have other outlines in a mechanism, in parallel; friction stays.
    ///
    /// # Errors
    /// Errors that `compute` returns; then nothing is changed.
    pub(crate) fn reshape(
        &mut self,
        mechanism: &Mechanism,
        parts: &[usize],
        compute: &Compute<'_>,
    ) -> Result<(), MechanismError> {
        let mut all: Vec<&mut MovingPair> = (self.list.iter_mut().chain(&mut self.left_out))
            .filter(|pair| parts.contains(&pair.fixed) || parts.contains(&pair.moving))
            .collect();
        let entries: Vec<PairEntry> = all.iter().map(|pair| pair.entry()).collect();
        let computed = parallel::map(&entries, 1, |entry| {
            mechanism.compute_by(entry, &Options::default(), compute)
        });
        let computed: Result<Vec<_>, MechanismError> = computed.into_iter().collect();
        for ((pair, entry), space) in all.iter_mut().zip(entries).zip(computed?) {
            **pair = MovingPair {
                order: pair.order,
                friction: pair.friction,
                ..MovingPair::of(mechanism, &entry, space)
            };
        }
        self.part();
        Ok(())
    }

    /// Moves the pairs for which a function is true to those whose contacts are ignored, and all others back to the
    /// list.
    pub(crate) fn leave_out(&mut self, is_out: impl Fn(&MovingPair) -> bool) {
        let mut all = core::mem::take(&mut self.list);
        all.append(&mut self.left_out);
        all.sort_by_key(|pair| pair.order);
        (self.left_out, self.list) = all.into_iter().partition(is_out);
    }

    /// Removes the friction of all pairs.
    pub(crate) fn smooth(mut self) -> Self {
        for pair in &mut self.list {
            pair.friction = 0.0;
        }
        self
    }

    /// All pairs that can meet, also those whose contacts are ignored.
    pub(crate) fn all(&self) -> impl Iterator<Item = &MovingPair> {
        self.list.iter().chain(&self.left_out)
    }

    /// Pairs whose contacts are ignored.
    pub(crate) fn left_out(&self) -> &[MovingPair] {
        &self.left_out
    }

    /// Pairs that can meet.
    pub fn list(&self) -> &[MovingPair] {
        &self.list
    }

    /// The parts of those that never meet.
    pub fn apart(&self) -> &[(usize, usize)] {
        &self.apart
    }
}

/// Whether the parts of a pair can meet, as far as their motions and joints determine it.
fn can_meet(mechanism: &Mechanism, pair: &PairEntry) -> bool {
    let moves = |i: usize| {
        let part = mechanism.parts.get(i);
        part.is_some_and(|p| p.axis.is_none_or(|a| a.motion != cspace::AxisMotion::Fixed))
    };
    (moves(pair.fixed) || moves(pair.moving))
        && !matches!(mechanism.relation(pair), Relation::Joint(..))
}

/// The contact function of two features.
struct Gap<'a>(&'a FeatureContact);

impl Placed<1> for Gap<'_> {
    fn values<T: Real>(&self, a: &Placement<T>, b: &Placement<T>) -> [T; 1] {
        let real = |_, x| T::constant(x);
        let (fixed, moving) = (self.0.fixed.map(real), self.0.moving.map(real));
        [contact_function(&fixed, &moving, &a.inverse().compose(b))]
    }
}

/// Displacement of the moving part's point from the fixed part's, to the left of a normal that does not change.
struct Across {
    normal: [f64; 2],
    on_fixed: [f64; 2],
    on_moving: [f64; 2],
}

impl Placed<1> for Across {
    fn values<T: Real>(&self, a: &Placement<T>, b: &Placement<T>) -> [T; 1] {
        let n = self.normal.map(T::constant);
        let p = a.point(self.on_fixed.map(T::constant));
        let r = b.point(self.on_moving.map(T::constant));
        [(r[1] - p[1]) * n[0] - (r[0] - p[0]) * n[1]]
    }
}

impl MovingPair {
    fn of(mechanism: &Mechanism, pair: &PairEntry, space: PairSpace) -> Self {
        let size = space.fixed().size().max(space.moving().size());
        let ranges = match mechanism.relation(pair) {
            Relation::Axes { fixed, moving } => [fixed.range, moving.range],
            _ => [None, None],
        };
        Self {
            fixed: pair.fixed,
            moving: pair.moving,
            touch: (TOUCHING * size).max(RESOLUTIONS * space.resolution()),
            friction: (mechanism.dynamics).friction_between(pair.fixed, pair.moving),
            space,
            ranges,
            window: pair.window,
            order: 0,
        }
    }

    fn entry(&self) -> PairEntry {
        PairEntry {
            fixed: self.fixed,
            moving: self.moving,
            window: self.window,
        }
    }

    /// Configuration of the pair.
    ///
    /// A coordinate beyond the end of its range by no more than the contact tolerance is set to that end.
    pub fn coordinates(&self, system: &System, q: &[f64]) -> Coordinates {
        self.coordinates_within(system, q, self.touch)
    }

    /// As [`coordinates`](Self::coordinates), with another tolerance of the ends of ranges.
    fn coordinates_within(&self, system: &System, q: &[f64], slack: f64) -> Coordinates {
        let PairSpace::FixedAxes(_) = &self.space else {
            return Coordinates::Planar(system.relative(self.fixed, self.moving, q));
        };
        let along = |i: usize, range: Option<(f64, f64)>| {
            let t = system.parts()[i].indices().next().map_or(0.0, |k| q[k]);
            match range {
                Some((lo, _)) if t < lo && t > lo - slack => lo,
                Some((_, hi)) if t > hi && t < hi + slack => hi,
                _ => t,
            }
        };
        Coordinates::Axes {
            u: along(self.fixed, self.ranges[0]),
            v: along(self.moving, self.ranges[1]),
        }
    }

    /// Class of the pair's configuration: free, in contact or blocked.
    ///
    /// # Errors
    /// If the pair's space was not computed at this configuration.
    pub fn classify(&self, system: &System, q: &[f64]) -> Result<Classification, QueryError> {
        self.space.classify(self.coordinates(system, q))
    }

    /// Contacts within a tolerance, the nearest first, each pair of features once.
    ///
    /// # Errors
    /// If the pair's space was not computed at this configuration.
    pub fn touches(
        &self,
        index: usize,
        system: &System,
        q: &[f64],
        tolerance: f64,
    ) -> Result<Vec<Touch>, QueryError> {
        let at = self.coordinates(system, q);
        // A part that lies level on two others, one of which is lower by less than the tolerance, would touch the lower
        // one if turned by this angle.
        let level = tolerance.min(self.touch) / self.space.moving().size();
        self.touches_beside(index, at, tolerance, level.max(BESIDE))
    }

    /// Contacts within a distance where the parts touch or overlap, including contacts at orientations that are as
    /// close; empty where the parts are apart. Ranges may be exceeded by that distance.
    ///
    /// # Errors
    /// If the pair's space was not computed at this configuration.
    pub(crate) fn overlaps(
        &self,
        index: usize,
        system: &System,
        q: &[f64],
        way: f64,
    ) -> Result<Vec<Touch>, QueryError> {
        let way = way.max(self.touch);
        let at = self.coordinates_within(system, q, way);
        if self.space.classify(at)? == Classification::Free {
            return Ok(Vec::new());
        }
        let turn = (way / self.space.moving().size()).max(BESIDE);
        self.touches_beside(index, at, way, turn)
    }

    /// Contacts within a tolerance at a configuration, and with the moving part turned by an angle about its middle in
    /// both directions.
    ///
    /// # Errors
    /// If the pair's space was not computed at this configuration.
    pub(crate) fn touches_beside(
        &self,
        index: usize,
        at: Coordinates,
        tolerance: f64,
        turn: f64,
    ) -> Result<Vec<Touch>, QueryError> {
        let mut near = self.space.contacts(at, tolerance)?;
        if let Coordinates::Planar(c) = at {
            // Where sides are parallel, patches end and others begin: both touch.
            let moving = self.space.moving();
            let within = tolerance + turn * moving.size();
            let middle = moving.bounds().center();
            let placed = c.fixed_from_moving(middle);
            for theta in [c.theta - turn, c.theta + turn] {
                // Turned about the middle of the part, so that nothing of it moves by more than that.
                let turned = Rotation::by(theta) * middle.to_vector();
                let beside = Configuration::new(placed.x - turned.x, placed.y - turned.y, theta);
                let beside = Coordinates::Planar(beside);
                // Beyond the window nothing touches.
                near.extend(self.space.contacts(beside, within).unwrap_or_default());
            }
        }
        let mut found: Vec<Touch> = Vec::new();
        for (id, _) in near {
            let touch = self.touch_of(index, id)?;
            if found.iter().all(|t| t.features != touch.features) {
                found.push(touch);
            }
        }
        Ok(found)
    }

    /// The contact of a patch.
    pub(crate) fn touch_of(&self, index: usize, patch: PatchId) -> Result<Touch, QueryError> {
        let of = self.space.patch(patch)?;
        Ok(Touch {
            pair: index,
            patch,
            features: of.features()?,
            contact: of.contact()?,
            grip: Grip::Smooth,
        })
    }

    /// Contact function and its derivatives by the coordinates of the system: 0 in contact, positive apart, in the
    /// model's unit of length.
    pub fn function(&self, touch: &Touch, system: &System, q: &[f64]) -> Row {
        system.row([self.fixed, self.moving], q, &Gap(&touch.contact))
    }

    /// Sliding velocity of two features that touch: t · (v_moving − v_fixed) of the points that touch, with the unit
    /// vector t to the left of the normal from the fixed to the moving part. It is given by the derivatives of a
    /// function that is 0 at the current configuration; in the model's unit of length.
    pub(crate) fn sliding(&self, touch: &Touch, system: &System, q: &[f64]) -> Row {
        let [a, b] = [self.fixed, self.moving].map(|i| system.placement(i, q));
        let place = touching_place(
            &touch.contact.fixed,
            &touch.contact.moving,
            &a.inverse().compose(&b),
        );
        let across = Across {
            normal: a.vector(place.normal),
            on_fixed: place.on_fixed,
            on_moving: b.inverse().point(a.point(place.on_moving)),
        };
        let row = system.row([self.fixed, self.moving], q, &across);
        row.plus(-1.0, &Row::new(row.value))
    }

    /// Point at which two features touch, in the assembly's frame.
    ///
    /// # Errors
    /// None, except for coordinates of another class, which this method itself provides.
    pub fn point(&self, touch: &Touch, system: &System, q: &[f64]) -> Result<Point, QueryError> {
        let place = touch.contact.touching(self.coordinates(system, q))?;
        let p = place.on_fixed.midpoint(place.on_moving);
        let [x, y] = system.placement(self.fixed, q).point([p.x, p.y]);
        Ok(Point::new(x, y))
    }
}
