//! From a question to an answer.

use core::f64::consts::TAU;
use cspace::{
    ComputeError, Coordinates, Location, PairError, PairSpace, Part, Point, Progress, QueryError,
    Silent, Vector,
};

use crate::answer::{Answer, Bottleneck, Path, Verdict};
use crate::apart::{blocked, enclosed};
use crate::centers::{fitting_centers, still_point};
use crate::ends::{ENOUGH, End, FARTHEST, Tip, end, home, is_far, turned};
use crate::legs::{Coords, Scene};
use crate::off_contact::off_contacts;
use crate::path::{Legs, MOST_LEGS, Outside, Prefer, divided};
use crate::route::{Effort, Gaps, Piece, Planar, join};
use crate::widest::{Between, Until, Wider, widen};

/// Why a question has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// The start cannot be asked about.
    #[error("the start: {0}")]
    From(#[source] QueryError),
    /// The goal cannot be asked about.
    #[error("the goal: {0}")]
    To(#[source] QueryError),
    /// The pair cannot be asked.
    #[error(transparent)]
    Pair(QueryError),
    /// The pair with the moving part grown cannot be computed, or the computation was interrupted.
    #[error("the pair with the moving part grown: {0}")]
    Grown(#[from] PairError),
    /// A configuration is so far away that it is not known where the parts are to each other.
    #[error(
        "{place} is farther away than {FARTHEST:e} sizes of the parts: rounding leaves nothing of the parts there"
    )]
    TooFar {
        /// Start, goal, or a place of a path that is judged.
        place: &'static str,
    },
    /// Nothing is out on fixed axes.
    #[error("on fixed axes no configuration is out: say to which it is to escape")]
    NoGoal,
    /// No force acts.
    #[error("no force acts on the parts: every way costs nothing")]
    NoForce,
    /// The computation was interrupted.
    #[error(transparent)]
    Stopped(ComputeError),
    /// The legs are to be so short that they are too many.
    #[error("the legs of the path would be more than {0}: let each be longer")]
    TooManyLegs(f64),
}

/// How much clearance a path is to have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clearance {
    /// As much as is found without growing the moving part: often half of what is possible, or more.
    Quick,
    /// At least half of what is possible.
    Half,
    /// At least so much, in the model's unit of length.
    AtLeast(f64),
    /// As much as is possible.
    Widest,
}

impl Clearance {
    /// When a way is wide enough; none if it need not be wide.
    fn until(self) -> Option<Until> {
        match self {
            Self::Quick => None,
            Self::Half => Some(Until::Half),
            Self::AtLeast(least) => Some(Until::AtLeast(least)),
            Self::Widest => Some(Until::Widest),
        }
    }
}

/// Requirements on a path beside being free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wishes {
    /// How much clearance it has.
    pub clearance: Clearance,
    /// No leg changes a coordinate by more: x, y and θ, or u, v and nothing; infinite for no limit.
    pub steps: [f64; 3],
    /// Criterion for choosing among paths with that clearance.
    pub prefer: Prefer,
}

impl Default for Wishes {
    fn default() -> Self {
        Self {
            clearance: Clearance::Half,
            steps: [f64::INFINITY; 3],
            prefer: Prefer::Legs,
        }
    }
}

/// A pair prepared for questions for ways.
///
/// ```
/// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
/// use cspace_plan::{Planner, Verdict, Wishes};
/// // A block in a box with an opening, which is wider than the block is high.
/// let fixed = Part::polygon("box", &[
///     (-5.0, -5.0), (5.0, -5.0), (5.0, -1.5), (4.0, -1.5), (4.0, -4.0), (-4.0, -4.0),
///     (-4.0, 4.0), (4.0, 4.0), (4.0, 1.5), (5.0, 1.5), (5.0, 5.0), (-5.0, 5.0),
/// ])?;
/// let block = Part::rectangle("block", (0.0, 0.0), 4.0, 2.0)?;
/// let space = PairSpace::compute(&fixed, &block, Relation::Planar, &Options::default())?;
/// let planner = Planner::new(&space)?;
/// let at = |x, theta| Coordinates::Planar(Configuration::new(x, 0.0, theta));
/// let answer = planner.plan(at(0.0, 1.5), at(12.0, 1.5), &Wishes::default())?;
/// let Verdict::Path(path) = answer.verdict else { return Err("it goes out".into()) };
/// assert!(path.narrowest.clearance > 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Planner<'a> {
    space: &'a PairSpace,
    scene: Scene,
    ways: Ways<'a>,
    /// Whether legs may be about any point.
    takes_any: bool,
    effort: Effort,
}

#[derive(Debug)]
enum Ways<'a> {
    Planar(Box<Planar<'a>>),
    Axes(Gaps<'a>),
}

/// A way with as much clearance as is asked for, or possible, has that but for rounding,
const ROUNDED: f64 = 1.0 - 1e-6;
/// and a widest way this share of it: where it passes the last thousandth would take legs of a thousandth.
const WIDEST: f64 = 0.999;
/// A leg is taken for one that rounding hid if it has clearance of this share of the parts' size.
const HIDDEN: f64 = 1e-9;

impl<'a> Planner<'a> {
    /// Prepares a pair. Legs move a point of the moving part straight and turn the part about it: the origin of its frame if the part is
    /// around that, otherwise the middle of the part's bounds. Where that takes many legs, the centres of arcs that fit arcs of the
    /// other part are tried: a curved key turns about the centre of its groove. [`Path::about`] is the point that is taken, and
    /// [`Scene::with_about`] gives the scene in which the path's legs are straight.
    ///
    /// # Errors
    /// For a lower pair, whose parts are in permanent contact.
    pub fn new(space: &'a PairSpace) -> Result<Self, PlanError> {
        let mut planner = Self::with_about(space, middle_if_far(space.moving()))?;
        if matches!(space, PairSpace::Planar(_)) {
            planner.takes_any = true;
        }
        Ok(planner)
    }

    /// Prepares a pair for legs that move a point of the moving part straight, given in its frame, and turn it about that. On axes it
    /// says nothing.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_about(space: &'a PairSpace, about: Vector) -> Result<Self, PlanError> {
        let scene = Scene::of(space).map_err(PlanError::Pair)?.with_about(about);
        let ways = match space {
            PairSpace::Planar(space) => Ways::Planar(Box::new(Planar::new(space, scene.clone()))),
            PairSpace::FixedAxes(space) => Ways::Axes(Gaps::new(space, &scene)),
            PairSpace::Lower(_) => return Err(PlanError::Pair(QueryError::Permanent)),
        };
        Ok(Self {
            space,
            scene,
            ways,
            takes_any: false,
            effort: Effort::Full,
        })
    }

    /// The two parts with their motions.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The space.
    pub fn space(&self) -> &'a PairSpace {
        self.space
    }

    /// A path from one configuration to another, or that there is none.
    ///
    /// # Errors
    /// If a configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion; if legs
    /// are to be so short that they are too many.
    pub fn plan(
        &self,
        from: Coordinates,
        to: Coordinates,
        wishes: &Wishes,
    ) -> Result<Answer, PlanError> {
        self.plan_with(from, to, wishes, &Silent)
    }

    /// As [`plan`](Self::plan), telling `progress` of the computations with the moving part grown.
    ///
    /// # Errors
    /// As [`plan`](Self::plan); and what `progress` returns.
    pub fn plan_with(
        &self,
        from: Coordinates,
        to: Coordinates,
        wishes: &Wishes,
        progress: &dyn Progress,
    ) -> Result<Answer, PlanError> {
        let plan = |planner: &Self| planner.plan_to((from, to), None, wishes, progress);
        let mut answer = self.about_any(plan, |answer| answer, wishes)?;
        let clearance = match (&answer.verdict, wishes.clearance) {
            (Verdict::Path(path), _) if path.configurations.len() > 2 => {
                path.narrowest.clearance * WIDEST
            }
            (Verdict::Unknown(_), Clearance::AtLeast(least)) => least,
            (Verdict::Unknown(_), _) => HIDDEN * self.scene.size(),
            _ => return Ok(answer),
        };
        if wishes.prefer == Prefer::Legs
            && let Some(path) = self.direct(from, to, clearance, wishes)?
        {
            if let Some(bottleneck) = &mut answer.bottleneck
                && bottleneck.narrow.clearance < path.narrowest.clearance
            {
                bottleneck.narrow = path.narrowest;
            }
            answer.verdict = Verdict::Path(path);
        }
        Ok(answer)
    }

    /// The path of one leg with a clearance, if there is one: by a turn to either side, about the usual point or about the one that is at
    /// the same place at both ends.
    fn direct(
        &self,
        from: Coordinates,
        to: Coordinates,
        clearance: f64,
        wishes: &Wishes,
    ) -> Result<Option<Path>, PlanError> {
        let (Coordinates::Planar(a), Coordinates::Planar(b)) = (from, to) else {
            return Ok(None);
        };
        if clearance <= 0.0 {
            return Ok(None);
        }
        // Unless a point is asked for.
        let still = match self.takes_any {
            true => still_point(self.space.moving(), a, b),
            false => None,
        };
        let about_it = (still.map(|about| Self::with_about(self.space, about))).transpose()?;
        let ahead = ((a.theta - b.theta) / TAU).round();
        let (lo, hi) = self.scene.limits()[2];
        for planner in core::iter::once(self).chain(&about_it) {
            let from = planner.scene.numbers(from).map_err(PlanError::From)?;
            let goal = planner.scene.numbers(to).map_err(PlanError::To)?;
            let nearer = if a.theta > b.theta + TAU * ahead {
                -1.0
            } else {
                1.0
            };
            for turns in [ahead, ahead - nearer, ahead + nearer] {
                let to = [goal[0], goal[1], goal[2] + TAU * turns];
                let is_turn = to[2] != from[2] || turns == ahead;
                if !is_turn || !(lo..=hi).contains(&to[2]) {
                    continue;
                }
                if planner.scene.is_clearly_apart(from, to, clearance) {
                    let legs = Legs::new(&planner.scene, vec![from, to]);
                    let mut path = planner.told(&legs, wishes)?;
                    let ends = (Coordinates::Planar(a), Some(Coordinates::Planar(b)));
                    exact_ends(&mut path.configurations, ends);
                    return Ok(Some(path));
                }
            }
        }
        Ok(None)
    }

    /// An answer by legs about the usual point, or about the centre of an arc if that takes fewer legs where there are many.
    pub(crate) fn about_any<T>(
        &self,
        plan: impl Fn(&Self) -> Result<T, PlanError>,
        answer: impl Fn(&T) -> &Answer,
        wishes: &Wishes,
    ) -> Result<T, PlanError> {
        /// So many legs are few.
        const FEW: usize = 6;
        // Off contacts, of paths that begin or end there.
        let path = |answer: &Answer| match (&answer.verdict, &answer.bottleneck) {
            (Verdict::Unknown(_), _) => Some((usize::MAX, 0.0)),
            (Verdict::Path(path), Some(widest)) => {
                Some((path.configurations.len() - 1, widest.narrow.clearance))
            }
            (Verdict::Path(path), None) => {
                Some((path.configurations.len() - 1, path.narrowest.clearance))
            }
            _ => None,
        };
        let mut best = plan(self)?;
        let many = |answer: &Answer| path(answer).filter(|p| p.0 > FEW);
        if !self.takes_any || many(answer(&best)).is_none() {
            return Ok(best);
        }
        for about in fitting_centers(self.space.fixed(), self.space.moving()) {
            let Some((legs, clearance)) = many(answer(&best)) else {
                break;
            };
            let other = plan(&Self::with_about(self.space, about)?)?;
            let is_wide = |c: f64| wishes.clearance != Clearance::Widest || c >= clearance * WIDEST;
            if path(answer(&other)).is_some_and(|(n, c)| n < legs && is_wide(c)) {
                best = other;
            }
        }
        Ok(best)
    }

    /// A path to a configuration, or to where the part is out if that is given: then the configuration is one that is.
    pub(crate) fn plan_to(
        &self,
        (from, to): (Coordinates, Coordinates),
        outside: Option<&Outside<'_>>,
        wishes: &Wishes,
        progress: &dyn Progress,
    ) -> Result<Answer, PlanError> {
        // In a window by its own numbers.
        let asked = (from, to);
        let (turns, from) = home(self.space, &self.scene, from);
        let (_, to) = home(self.space, &self.scene, to);
        for (at, place) in [(from, "the start"), (to, "the goal")] {
            if self.scene.numbers(at).is_ok_and(|c| is_far(&self.scene, c)) {
                return Err(PlanError::TooFar { place });
            }
        }
        // Off a contact there is at least the clearance that is requested.
        let enough = match wishes.clearance {
            Clearance::AtLeast(least) => least.max(ENOUGH * self.scene.size()),
            Clearance::Quick | Clearance::Half | Clearance::Widest => ENOUGH * self.scene.size(),
        };
        let end = |at| end(self.space, &self.scene, at, enough);
        let start = end(from).map_err(PlanError::From)?;
        let goal = end(to).map_err(PlanError::To)?;
        let region = |end: &End| match end {
            End::Free { region, .. } => Some(*region),
            End::Blocked => None,
        };
        let mut answer = Answer {
            verdict: Verdict::TooNarrow,
            regions: (region(&start), region(&goal)),
            bottleneck: None,
        };
        answer.verdict = match (start, goal) {
            (End::Blocked, _) => Verdict::FromBlocked(
                blocked(self.space, &self.scene, from).map_err(PlanError::From)?,
            ),
            (_, End::Blocked) => {
                Verdict::ToBlocked(blocked(self.space, &self.scene, to).map_err(PlanError::To)?)
            }
            (End::Free { region: a, .. }, End::Free { region: b, .. }) if a != b => {
                Verdict::NoPath(enclosed(self.space, a, b).map_err(PlanError::Pair)?)
            }
            (start @ End::Free { .. }, goal @ End::Free { .. }) => {
                let [a, b] = [from, to].map(|at| self.scene.numbers(at));
                let (a, b) = (a.map_err(PlanError::From)?, b.map_err(PlanError::To)?);
                let tips = [Tip::of(start, a), Tip::of(goal, b)];
                let found = match a == b {
                    true => self.stays(&tips[0], wishes, &mut answer),
                    false => {
                        self.found(tips, (enough, outside), wishes, (&mut answer, progress))?
                    }
                };
                let Some(legs) = found else {
                    return Ok(answer);
                };
                let mut path = self.told(&legs, wishes)?;
                for at in &mut path.configurations {
                    *at = turned(*at, -turns);
                }
                let last = outside.is_none().then_some(asked.1);
                exact_ends(&mut path.configurations, (asked.0, last));
                Verdict::Path(path)
            }
        };
        Ok(answer)
    }

    /// The path without a leg from a configuration to itself; none if it has less clearance there than is asked for, which the answer has.
    fn stays(&self, tip: &Tip<'_>, wishes: &Wishes, answer: &mut Answer) -> Option<Legs<'_>> {
        let legs = Legs::new(&self.scene, vec![tip.at]);
        let Clearance::AtLeast(least) = wishes.clearance else {
            return Some(legs);
        };
        let narrow = legs.narrow();
        // On a contact nothing is between leaving it and coming to it.
        if tip.contacts.is_some() || narrow.clearance >= least {
            return Some(legs);
        }
        let most = Some(narrow.clearance);
        answer.bottleneck = Some(Bottleneck { narrow, most });
        None
    }

    /// The legs of a path between two configurations in the same region; none if that is the answer, which has why.
    fn found(
        &self,
        [mut from, mut to]: [Tip<'_>; 2],
        (mut enough, outside): (f64, Option<&Outside<'_>>),
        wishes: &Wishes,
        (answer, progress): (&mut Answer, &dyn Progress),
    ) -> Result<Option<Legs<'_>>, PlanError> {
        /// A path with this share of the clearance at an end is limited by that end.
        const LIMITED: f64 = 0.99;
        let is_bounded = from.contacts.is_none() && to.contacts.is_none();
        let wider = |from: &Tip<'_>, to: &Tip<'_>| {
            self.wider(from.near, to.near, wishes.clearance, progress)
        };
        let Some(mut widest) = wider(&from, &to)? else {
            answer.verdict = Verdict::Unknown(self.doubtful());
            return Ok(None);
        };
        while !is_bounded && wishes.clearance == Clearance::Widest && enough < self.scene.size() {
            let clearance = |tip: &Tip<'_>| self.scene.clearance(tip.near);
            let ends = clearance(&from).min(clearance(&to));
            enough *= 2.0;
            let before = (from.near, to.near);
            if widest.clearance < LIMITED * ends
                || !(from.go_on(self.space, enough) | to.go_on(self.space, enough))
            {
                break;
            }
            let Some(found) = wider(&from, &to)? else {
                // The path that is known begins and ends at the places before.
                (from.near, to.near) = before;
                break;
            };
            widest = found;
        }
        let wider = widest;
        let bottleneck = |wider: &Wider| Bottleneck {
            narrow: Legs::new(&self.scene, wider.places.clone()).narrow(),
            most: is_bounded.then_some(wider.most),
        };
        if let Clearance::AtLeast(least) = wishes.clearance
            && wider.clearance < least
        {
            answer.bottleneck = Some(bottleneck(&wider));
            if !is_bounded || wider.most >= least {
                answer.verdict = Verdict::Unknown(self.doubtful());
            }
            return Ok(None);
        }
        let kept = match wishes.clearance {
            Clearance::AtLeast(least) => least,
            Clearance::Widest => wider.clearance * WIDEST,
            Clearance::Half => wider.clearance.min(0.5 * wider.most) * ROUNDED,
            Clearance::Quick => 0.0,
        };
        // No farther off the contacts than takes that clearance.
        let mut places = wider.places.clone();
        let last = to.near;
        if from.come_back(self.space, kept) {
            places.insert(0, from.near);
        }
        if to.come_back(self.space, kept) {
            let end = places.last().copied().unwrap_or(last);
            places.push(core::array::from_fn(|k| to.near[k] + (end[k] - last[k])));
        }
        let legs = Legs::new(&self.scene, places);
        let simple = legs.simple(kept, wider.most, outside).unwound(kept);
        let legs = match wishes.prefer {
            Prefer::Legs => simple.tidy(kept, outside),
            Prefer::Clearance => legs.clear(kept).or_wider(simple),
            // Out is where the simple path ends.
            Prefer::Length if outside.is_some() => simple.short(kept),
            Prefer::Length => legs.short(kept).or_shorter(simple.short(kept)),
        };
        let legs = self.with_ends(&legs, (&from, &to), (kept, wishes.prefer));
        if wishes.clearance == Clearance::Widest {
            // Fewer legs may have more clearance.
            let touches = (from.contacts.is_some(), to.contacts.is_some());
            let rest = off_contacts(&self.scene, legs.places(), touches);
            let shorter = wider.with(&self.scene, rest);
            answer.bottleneck = Some(bottleneck(&shorter));
        }
        Ok(Some(legs))
    }

    /// A way between two free configurations in the same region, as wide as is asked for or can be; `None` if none is found.
    fn wider(
        &self,
        first: Coords,
        last: Coords,
        clearance: Clearance,
        progress: &dyn Progress,
    ) -> Result<Option<Wider>, PlanError> {
        /// Where rounding hides the way, a part this much larger, as a share of the size, may show it.
        const GROWN: [f64; 3] = [1e-9, 1e-8, 1e-7];
        let in_grown = |space: &PairSpace, effort: Effort| {
            let Ok(mut planner) = Planner::with_about(space, self.scene.about()) else {
                return Between::Hidden;
            };
            planner.effort = effort;
            let region = |at: Coords| match space.locate(planner.scene.coordinates(at)) {
                Ok(Location::Free(region)) => Some(region),
                _ => None,
            };
            match (region(first), region(last)) {
                (Some(a), Some(b)) if a == b => {
                    (planner.raised(first, last)).map_or(Between::Hidden, Between::Way)
                }
                _ => Between::None,
            }
        };
        let until = |until: Until, known: Wider| {
            // A requested clearance is had by any path, also one that is hard to find.
            let effort = match until {
                Until::AtLeast(_) => Effort::Full,
                Until::Half | Until::Widest => Effort::Less,
            };
            let between = |space: &PairSpace| in_grown(space, effort);
            widen(self.space, &self.scene, known, until, progress, between)
        };
        let mut known = Wider::unknown(&self.scene, [first, last]);
        if let Some(ways) = self.raised(first, last) {
            known = known.with(&self.scene, ways);
        }
        for share in GROWN {
            if known.places.is_empty() {
                known = until(Until::AtLeast(share * self.scene.size()), known)?;
            }
        }
        if known.places.is_empty() {
            return Ok(None);
        }
        if let Some(wide) = clearance.until() {
            known = until(wide, known)?;
            // Then how much there is.
            if let Until::AtLeast(least) = wide
                && known.clearance < least
            {
                known = until(Until::Widest, known)?;
            }
        }
        Ok(Some(known))
    }

    /// A path with the legs that leave and come to contacts, and come from far away. Legs beside them that they can replace go, if few
    /// legs or a short path is preferred.
    fn with_ends(
        &self,
        legs: &Legs<'_>,
        (from, to): (&Tip<'_>, &Tip<'_>),
        (clearance, prefer): (f64, Prefer),
    ) -> Legs<'_> {
        /// Shorter legs, in shares of the parts' size, are rounding.
        const STILL: f64 = 1e-12;
        let mut places = legs.places().to_vec();
        let end = places.last().copied().unwrap_or(to.near);
        let clearance = (prefer != Prefer::Clearance).then_some(clearance);
        from.join(&mut places, from.at, clearance);
        // The goal as often around as the place before it.
        let goal = core::array::from_fn(|k| to.at[k] + (end[k] - to.near[k]));
        places.reverse();
        to.join(&mut places, goal, clearance);
        places.reverse();
        places.dedup_by(|b, a| self.scene.long(*a, *b) <= STILL * self.scene.size());
        Legs::new(&self.scene, places)
    }

    /// A way between two free configurations, moved to where it has more clearance.
    fn raised(&self, first: Coords, last: Coords) -> Option<Vec<Coords>> {
        /// Places are moved so often for more clearance, by a share that is worth a move.
        const ROUNDS: usize = 10;
        const GAIN: f64 = 0.05;
        let mut legs = Legs::new(&self.scene, self.between(first, last)?);
        legs.raise(ROUNDS, GAIN);
        Some(legs.places().to_vec())
    }

    /// The configurations of a path from one free configuration to another in the same region.
    fn between(&self, from: Coords, to: Coords) -> Option<Vec<Coords>> {
        match &self.ways {
            Ways::Axes(gaps) => self.joined(&gaps.way(from, to)?, to),
            Ways::Planar(planar) => {
                let (lo, hi) = self.scene.limits()[2];
                let turned = |theta: f64, by: f64| if by == 0.0 { theta } else { theta + TAU * by };
                // In a window by its own numbers, else the nearer way around.
                let (shift, ahead) = if lo.is_finite() {
                    let into = |theta: f64| ((lo - theta) / TAU).ceil();
                    let inside = |theta: f64| {
                        if theta >= lo && theta <= hi {
                            0.0
                        } else {
                            into(theta)
                        }
                    };
                    (inside(from[2]), inside(to[2]))
                } else {
                    (0.0, ((from[2] - to[2]) / TAU).round())
                };
                let from = [from[0], from[1], turned(from[2], shift)];
                let to = [to[0], to[1], turned(to[2], ahead)];
                let mut path = self.joined(&planar.way(from, to)?, to)?;
                for place in &mut path {
                    place[2] = turned(place[2], -shift);
                }
                Some(path)
            }
        }
    }

    /// Legs along a way, which end at the goal itself, up to whole turns.
    fn joined(&self, way: &[Box<dyn Piece + '_>], to: Coords) -> Option<Vec<Coords>> {
        let mut path = join(&self.scene, way, self.effort)?;
        if let Some(last) = path.last_mut() {
            *last = core::array::from_fn(|k| to[k] + TAU * ((last[k] - to[k]) / TAU).round());
        }
        Some(path)
    }

    fn told(&self, legs: &Legs<'_>, wishes: &Wishes) -> Result<Path, PlanError> {
        let at = |c: Coords| self.scene.coordinates(c);
        let places =
            divided(legs.places(), wishes.steps).ok_or(PlanError::TooManyLegs(MOST_LEGS))?;
        Ok(Path {
            configurations: places.into_iter().map(at).collect(),
            about: self.scene.about(),
            narrowest: legs.narrow(),
        })
    }

    fn doubtful(&self) -> Vec<(f64, f64)> {
        match self.space {
            PairSpace::Planar(space) => space.doubtful_orientations().to_vec(),
            _ => Vec::new(),
        }
    }
}

/// The origin of a part's frame if it is within the part's bounds; otherwise their middle.
fn middle_if_far(part: &Part) -> Vector {
    let bounds = part.bounds();
    if bounds.contains(Point::ORIGIN) {
        Vector::ZERO
    } else {
        bounds.center().to_vector()
    }
}

/// Puts the ends of a path where they were asked for: numbers of a point of the part and back are rounded.
fn exact_ends(path: &mut [Coordinates], (from, to): (Coordinates, Option<Coordinates>)) {
    let exact = |told: &mut Coordinates, asked: Coordinates| {
        if let (Coordinates::Planar(told), Coordinates::Planar(asked)) = (told, asked) {
            let turns = ((told.theta - asked.theta) / TAU).round();
            (told.x, told.y) = (asked.x, asked.y);
            told.theta = if turns == 0.0 {
                asked.theta
            } else {
                asked.theta + TAU * turns
            };
        }
    };
    if let Some(first) = path.first_mut() {
        exact(first, from);
    }
    if let (Some(last), Some(to)) = (path.last_mut(), to) {
        exact(last, to);
    }
}
