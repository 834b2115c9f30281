//! A way out: until a line lies between the convex hulls of the parts, on whose far side the moving part can go away for ever.
//!
//! A designer expects a straight way where there is one: the directions of the parts' lines and of the axes are tried first, the shortest
//! first. Otherwise a way is planned to the nearest place that is out, and made of few legs to where the part is out in any of them.

use cspace::pair::PairMotion;
use cspace::{
    Configuration, Coordinates, Edge, Location, PairSpace, Part, Progress, Rotation, Vector,
};

use crate::answer::{Answer, Verdict};
use crate::farthest::farthest;
use crate::planner::{Clearance, PlanError, Planner, Wishes};

/// So many directions are tried for straight ways, those of the longest lines first.
const MOST: usize = 64;
/// It may be out in so many of these directions.
const EXITS: usize = 16;
/// Directions that differ by less are the same: sines of angles.
const SAME: f64 = 1e-9;
/// The hulls are apart by this share of the parts' size, and by less than twice as much: distances have few digits.
const APART: f64 = 0.05;

/// A direction in the fixed part's frame, and how far it is in it until the hulls are apart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exit {
    pub(crate) direction: Vector,
    pub(crate) distance: f64,
}

impl Planner<'_> {
    /// A way from a configuration to one that is out, which is chosen and told: there a line lies between the convex hulls of the parts.
    /// On the way the orientation changes only where it must, and at the end it is that of the start, but for whole turns.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, Silent};
    /// use cspace_plan::{Planner, Verdict, Wishes};
    /// // A block in a trough, which is open above.
    /// let trough = Part::polygon("trough", &[
    ///     (-4.0, -3.0), (4.0, -3.0), (4.0, 3.0), (3.0, 3.0), (3.0, -2.0), (-3.0, -2.0), (-3.0, 3.0), (-4.0, 3.0),
    /// ])?;
    /// let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0)?;
    /// let space = PairSpace::compute(&trough, &block, Relation::Planar, &Options::default())?;
    /// let from = Coordinates::Planar(Configuration::new(1.0, 0.0, 0.0));
    /// let (to, answer) = Planner::new(&space)?.plan_out(from, &Wishes::default(), &Silent)?;
    /// let (Verdict::Path(path), Coordinates::Planar(to)) = (answer.verdict, to) else { return Err("it comes out".into()) };
    /// assert!(to.x == 1.0 && to.y > 4.0 && to.theta == 0.0);
    /// assert!(path.narrowest.clearance > 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`plan`](Self::plan); of a pair on fixed axes, on which no configuration is out; and what `progress` returns.
    pub fn plan_out(
        &self,
        from: Coordinates,
        wishes: &Wishes,
        progress: &dyn Progress,
    ) -> Result<(Coordinates, Answer), PlanError> {
        let plan = |planner: &Self| planner.out(from, wishes, progress);
        self.about_any(plan, |out| &out.1, wishes)
    }

    /// As above, by legs about one point.
    fn out(
        &self,
        from: Coordinates,
        wishes: &Wishes,
        progress: &dyn Progress,
    ) -> Result<(Coordinates, Answer), PlanError> {
        let PairSpace::Planar(space) = self.space() else {
            return Err(PlanError::NoGoal);
        };
        let location = self.space().locate(from).map_err(PlanError::From)?;
        let Coordinates::Planar(at) = from else {
            return Err(PlanError::NoGoal);
        };
        // What is out is so far away that the parts can have the requested clearance there.
        let room = match wishes.clearance {
            Clearance::AtLeast(least) => least,
            Clearance::Widest => {
                (self.scene().numbers(from)).map_or(0.0, |at| self.scene().clearance(at))
            }
            Clearance::Half | Clearance::Quick => 0.0,
        };
        let (fixed, moving) = (space.fixed(), space.moving());
        let apart = apart(fixed, moving).max(room);
        let exits = exits_by(fixed, moving, at, apart);
        let goal = |exit: &Exit| {
            let by = exit.direction * exit.distance;
            Coordinates::Planar(Configuration::new(at.x + by.x, at.y + by.y, at.theta))
        };
        let Some(nearest) = exits.first().map(goal) else {
            return Err(PlanError::NoGoal);
        };
        let to = |goal: Coordinates| {
            let answer = self.plan_to((from, goal), None, wishes, progress)?;
            Ok((goal, answer))
        };
        if let Location::Free(region) = location
            && !(self.space().regions().get(region.index())).is_some_and(|r| r.unbounded)
        {
            return to(nearest);
        }
        let is_straight = |exit: &&Exit| {
            let by = exit.direction * exit.distance;
            let rates = Coordinates::Planar(Configuration::new(by.x, by.y, 0.0));
            matches!(
                self.space().first_contact(from, rates, 1.0),
                Ok(PairMotion::Free)
            )
        };
        // A part in contact would go along it.
        if location != Location::Contact
            && let Some(exit) = exits.iter().find(is_straight)
        {
            return to(goal(exit));
        }
        // To the nearest exit, and on the simplest way to where it is out anywhere.
        let about = self.scene().about();
        let lines = directions(fixed, moving, Rotation::by(at.theta));
        let still: Vec<(Vector, f64)> = (lines.into_iter().take(EXITS))
            .map(|d| (d, farthest(fixed, d) + apart))
            .collect();
        let outside = |angle: f64| {
            let turn = Rotation::by(angle);
            let back = |d: Vector| turn.inverse() * -d;
            (still.iter())
                .map(|&(d, last)| (d, last + farthest(moving, back(d)) - back(d).dot(about)))
                .collect()
        };
        let answer = self.plan_to((from, nearest), Some(&outside), wishes, progress)?;
        let last = match &answer.verdict {
            Verdict::Path(path) => path.configurations.last().copied(),
            _ => None,
        };
        Ok((last.unwrap_or(nearest), answer))
    }
}

/// How far the hulls are apart where a part is out.
fn apart(fixed: &Part, moving: &Part) -> f64 {
    APART * fixed.size().max(moving.size())
}

/// The directions of the axes and of the lines of both parts, and across them, by how far it is until the parts are apart.
pub(crate) fn exits(fixed: &Part, moving: &Part, at: Configuration) -> Vec<Exit> {
    exits_by(fixed, moving, at, apart(fixed, moving))
}

/// As [`exits`], by a distance between the hulls.
fn exits_by(fixed: &Part, moving: &Part, at: Configuration, apart: f64) -> Vec<Exit> {
    let turn = Rotation::by(at.theta);
    let mut exits: Vec<Exit> = (directions(fixed, moving, turn).into_iter())
        .map(|direction| {
            let to = Vector::new(at.x, at.y).dot(direction);
            let last = farthest(fixed, direction);
            // The moving part's last point is the farthest in the opposite direction.
            let first = to - farthest(moving, turn.inverse() * -direction);
            Exit {
                direction,
                distance: few_digits(last - first + apart, apart).max(0.0),
            }
        })
        .collect();
    exits.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    exits
}

/// A length rounded up to a number with few digits: by less than another.
fn few_digits(length: f64, less_than: f64) -> f64 {
    let step = 10f64.powf(less_than.log10().floor());
    (length / step).ceil() * step
}

fn directions(fixed: &Part, moving: &Part, turn: Rotation) -> Vec<Vector> {
    let of = |edge: Edge, turn: Rotation| {
        let chord = edge.end - edge.start;
        (chord.length(), turn * chord.unit())
    };
    let still = Rotation::by(0.0);
    let lines = fixed.edges().map(|e| (e, still));
    let mut lines: Vec<(f64, Vector)> = (lines.chain(moving.edges().map(|e| (e, turn))))
        .filter(|(e, _)| e.is_line())
        .map(|(e, turn)| of(e, turn))
        .collect();
    lines.sort_by(|a, b| b.0.total_cmp(&a.0));
    let axes = [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)];
    let mut found: Vec<Vector> = Vec::new();
    for direction in axes.into_iter().chain(lines.into_iter().map(|l| l.1)) {
        for d in [direction, -direction, direction.left(), -direction.left()] {
            let known = |f: &Vector| f.cross(d).abs() < SAME && f.dot(d) > 0.0;
            if found.len() < MOST && !found.iter().any(known) {
                found.push(d);
            }
        }
    }
    found
}
