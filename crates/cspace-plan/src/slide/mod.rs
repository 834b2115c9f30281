//! Motions that are led by contact: as far as the straight way is free, then along the surface, as near to a goal as it leads.
//!
//! A part that is dragged, by a pointer say, asks for many small motions; [`slide`] is one of them. Near is meant in coordinates of
//! which each counts alike:
//!
//! | class | weighted coordinates |
//! |---|---|
//! | general, symmetric | the position of the moving part's centre, and θ times the part's radius about it |
//! | fixed axes | u and v, lengths in units of the pair's size |
//!
//! Steps are found by contact functions and their gradients, and each is checked: none ends blocked. So what comes out is certain to be
//! free or in contact; that nothing nearer could be reached is not proved.

mod along;
mod axes;
mod ground;
mod joined;
mod landing;
mod planar;
mod step;
mod tolerance;
mod vector;
mod ways;

use cspace::{Classification, Configuration, Coordinates, PairSpace, PatchId, QueryError};

use along::slide_on;
use axes::OnAxes;
use ground::Ground;
use joined::along_joint;
use planar::Planar;

/// Where a motion got to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slid {
    /// The configuration.
    pub at: Coordinates,
    /// The patch that stopped it, if one did.
    pub stopped: Option<PatchId>,
}

/// Moves the parts of one pair, as they are dragged.
#[derive(Debug)]
pub struct Slider<'a> {
    space: &'a PairSpace,
    kind: Kind<'a>,
}

#[derive(Debug)]
enum Kind<'a> {
    Joined(&'a cspace::LowerPair),
    OnAxes(OnAxes<'a>),
    Planar(Planar<'a>),
}

/// The first contact on the straight way from one configuration to another: [`Slider::advance`].
///
/// # Errors
/// As [`Slider::advance`].
pub fn advance(space: &PairSpace, from: Coordinates, to: Coordinates) -> Result<Slid, QueryError> {
    Slider::new(space).advance(from, to)
}

/// From one configuration as near to another as contacts let the parts: [`Slider::slide`].
///
/// # Errors
/// As [`Slider::slide`].
///
/// ```
/// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
/// use cspace_plan::slide::slide;
/// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
/// let coin = Part::circle("coin", (0.0, 0.0), 1.0)?;
/// let space = PairSpace::compute(&table, &coin, Relation::Planar, &Options::default())?;
/// let at = |x, y| Coordinates::Planar(Configuration::new(x, y, 0.0));
/// // Down onto the table and along it: the coin cannot come nearer to where it is wanted than the table's side.
/// let slid = slide(&space, at(-1.0, 4.0), at(1.0, 2.0))?;
/// let Coordinates::Planar(end) = slid.at else {
///     return Err("it is a planar pair".into());
/// };
/// assert!((end.x - 1.0).abs() < 1e-2 && (end.y - 3.0).abs() < 1e-9);
/// assert!(slid.stopped.is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn slide(space: &PairSpace, from: Coordinates, to: Coordinates) -> Result<Slid, QueryError> {
    Slider::new(space).slide(from, to)
}

impl<'a> Slider<'a> {
    /// For one pair, with what is the same for all its motions.
    pub fn new(space: &'a PairSpace) -> Self {
        let kind = match space {
            PairSpace::Lower(pair) => Kind::Joined(pair),
            PairSpace::FixedAxes(space) => Kind::OnAxes(OnAxes::new(space)),
            PairSpace::Planar(space) => Kind::Planar(Planar::new(space)),
        };
        Self { space, kind }
    }

    /// The configuration asked for if it may be moved to; otherwise the first contact on the straight way, to within a resolution.
    ///
    /// A request beyond the window or a range of motion is brought to its end first. From blocked space any way leads, so that a
    /// part can be taken out. For a lower pair: the configuration of the joint that is as far along it as the one asked for.
    ///
    /// # Errors
    /// If a configuration is in the coordinates of another class or not finite, the motion begins outside the window or the ranges, or
    /// a part turns too far to tell.
    pub fn advance(&self, from: Coordinates, to: Coordinates) -> Result<Slid, QueryError> {
        self.moved(from, to, false)
    }

    /// As [`advance`](Self::advance), then on along the surface, by its contact functions, as near to `to` as it leads. Never blocked
    /// if `from` is not.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn slide(&self, from: Coordinates, to: Coordinates) -> Result<Slid, QueryError> {
        self.moved(from, to, true)
    }

    fn moved(&self, from: Coordinates, to: Coordinates, slides: bool) -> Result<Slid, QueryError> {
        // Out of blocked space any way leads.
        let leads_anywhere = self.space.classify(from)? == Classification::Blocked;
        match (&self.kind, from, to) {
            (Kind::Joined(pair), Coordinates::Planar(_), Coordinates::Planar(to)) => {
                finite([to.x, to.y, to.theta])?;
                let at = Coordinates::Planar(along_joint(pair, to));
                Ok(Slid { at, stopped: None })
            }
            (Kind::OnAxes(pair), Coordinates::Axes { u, v }, Coordinates::Axes { u: a, v: b }) => {
                finite([a, b, 0.0])?;
                let goal = pair.within([a, b]);
                let ([u, v], stopped) = match leads_anywhere {
                    true => (goal, None),
                    false => moved(pair, [u, v], goal, slides)?,
                };
                let at = Coordinates::Axes { u, v };
                Ok(Slid { at, stopped })
            }
            (Kind::Planar(pair), Coordinates::Planar(from), Coordinates::Planar(to)) => {
                finite([to.x, to.y, to.theta])?;
                let goal = pair.within(to);
                let (at, stopped) = match leads_anywhere {
                    true => (goal, None),
                    false => moved(pair, from, goal, slides)?,
                };
                let at = Coordinates::Planar(at);
                Ok(Slid { at, stopped })
            }
            (Kind::OnAxes(_), Coordinates::Axes { .. }, given)
            | (_, Coordinates::Planar(_), given)
            | (_, given, _) => Err(self.wrong(given)),
        }
    }

    /// Coordinates of another class than the pair's.
    fn wrong(&self, given: Coordinates) -> QueryError {
        let wanted = match self.kind {
            Kind::OnAxes(_) => Coordinates::Axes { u: 0.0, v: 0.0 },
            _ => Coordinates::Planar(Configuration::default()),
        };
        QueryError::Coordinates {
            class: self.space.class(),
            wanted: wanted.names(),
            given: given.names(),
        }
    }
}

/// Straight from a configuration that is not blocked to another, and if it slides on along the surface.
fn moved<G: Ground>(
    ground: &G,
    from: G::At,
    goal: G::At,
    slides: bool,
) -> Result<(G::At, Option<PatchId>), QueryError> {
    let first = ground.straight_to(from, goal)?;
    let Some(patch) = first.1.filter(|_| slides) else {
        return Ok(first);
    };
    let (at, to) = (ground.weighted(first.0), ground.weighted(goal));
    let found = slide_on(ground, at, to, patch)?;
    let at = found.stopped.map_or(goal, |_| ground.unweighted(found.at));
    Ok(match ground.is_blocked_at(at) {
        true => first,
        false => (at, found.stopped),
    })
}

/// Refuses what is not finite.
fn finite(numbers: [f64; 3]) -> Result<(), QueryError> {
    match numbers.iter().all(|n| n.is_finite()) {
        true => Ok(()),
        false => Err(QueryError::Outside),
    }
}
