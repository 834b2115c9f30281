//! Choice of the touching contacts that hold as the motion goes on.
//!
//! Contacts at different places are all constraints: the velocity is the nearest one at which no contact function
//! decreases. Where two features touch at a corner, the features beside them touch there, too, and not all of them are
//! constraints: past a convex corner only one needs to be. So the nearest velocities that some of the contacts allow
//! are tried, the nearest first, and the first that leads to a configuration without overlap is taken.

use cspace::Point;

use crate::contact::{Bound, SAME_PLACE, Watch, brakes};
use crate::linear::length;
use crate::pairs::Pairs;
use crate::system::{Law, Row, System};

use super::balance::Closed;
use super::check::goes_on;
use super::flow::{Arrived, Flow};
use super::friction::{combinations, cones, let_go};
use super::holding::{Holding, friction};
use super::resisted::Closing;
use super::velocity::{Held, Local, Nearest};

/// Largest number of contacts of which all subsets are tried; of more, all of them and all but one are tried.
const MOST_CONTACTS: usize = 10;
/// Lengths of trials, relative to the size of the mechanism: beyond the error of contacts, and shorter than the
/// distance to the next event. A shorter one is used where another event follows at once.
const TRIALS: [f64; 4] = [1e-6, 1e-7, 1e-8, 3e-9];
/// Largest ratio of a trial's actual length to the intended one.
const MOST_FARTHER: f64 = 10.0;
/// Factor by which the duration of a trial that is too long is shortened, repeatedly down to rounding.
const SHORTER: f64 = 0.1;
const MOST_SHORTER: i32 = 16;
/// Steps of a trial whose first is too short to tell, each longer than the one before by this factor, if its error allows it.
const MOST_STEPS: usize = 1000;
const LONGER: f64 = 1.5;
/// A contact that pulls by more than this share of the speed is not tried.
const ROUGHLY: f64 = 1e-6;

/// Continuation of the motion at a configuration.
#[derive(Debug)]
pub(crate) enum Choice<'a> {
    /// The motion goes on with these contacts.
    On {
        /// Motion with these contacts.
        flow: Flow<'a>,
        /// Configuration a very little later.
        next: Vec<f64>,
    },
    /// No velocity is allowed: the forbidding bounds, each with its multiplier.
    Jammed(Vec<(Bound, f64)>),
    /// No allowed velocity leads to a further configuration.
    Undetermined,
}

/// Chooses among bounds that are reached; brakes hold unless drives do not allow it.
pub(crate) fn choose<'a>(
    system: &'a System,
    pairs: &'a Pairs,
    bounds: &[Bound],
    time: f64,
    q: &[f64],
    longest: f64,
) -> Choice<'a> {
    let Some(local) = Local::at(system, q, time) else {
        return Choice::Undetermined;
    };
    if local.is_stuck() {
        return Choice::Jammed(Vec::new());
    }
    let brakes = brakes(system, q);
    let bounds: Vec<Bound> = bounds.iter().filter(|b| !b.is_brake()).copied().collect();
    let rubs = bounds.iter().any(|b| friction(pairs, b) > 0.0);
    let choice = |brakes: &[Bound]| {
        if rubs {
            return rubbing(system, pairs, &local, [&bounds, brakes], time, q, longest);
        }
        let bounds = [&bounds[..], brakes].concat();
        among(system, pairs, &local, &bounds, time, q, longest)
    };
    if !brakes.is_empty() {
        let choice = choice(&brakes);
        if let Choice::On { .. } = choice {
            return choice;
        }
    }
    choice(&[])
}

/// As [`among`], with friction.
fn rubbing<'a>(
    system: &'a System,
    pairs: &'a Pairs,
    local: &Local<'a>,
    [bounds, brakes]: [&[Bound]; 2],
    time: f64,
    q: &[f64],
    longest: f64,
) -> Choice<'a> {
    let near = SAME_PLACE * system.size();
    // Where edges join smoothly, both touch at one place and push alike.
    let alike = |a: &Bound, b: &Bound| {
        let (Bound::Contact(s), Bound::Contact(t)) = (a, b) else {
            return false;
        };
        let places = [a, b].map(|bound| bound.place(system, pairs, q));
        let close = |(p, r): (Point, Point)| p.distance(r) <= near;
        s.pair == t.pair && places[0].zip(places[1]).is_some_and(close) && {
            let [a, b] = [a, b].map(|bound| local.reduced(&bound.function(system, pairs, q)).0);
            let apart: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
            length(&apart) <= SAME_PLACE * length(&a)
        }
    };
    let mut groups: Vec<Vec<Bound>> = Vec::new();
    for bound in bounds {
        match groups.iter_mut().find(|group| alike(&group[0], bound)) {
            Some(group) => group.push(*bound),
            None => groups.push(vec![*bound]),
        }
    }
    let closing = Closing {
        system,
        pairs,
        groups: &groups,
        brakes,
        q,
        time,
    };
    let is_possible = |held: &Vec<Bound>| is_possible(system, pairs, held, local, q);
    let goes_on = |held: &[Bound], scale: f64| {
        let (flow, next) = tries(system, pairs, held.to_vec(), time, q, scale, longest)?;
        Some(Choice::On { flow, next })
    };
    let mut possible: Vec<Vec<Bound>> = Vec::new();
    let mut leads_on = |set: &[Bound]| {
        let held = [set, brakes].concat();
        let choice = is_possible(&held).then(|| goes_on(&held, TRIALS[0]))?;
        if choice.is_none() {
            possible.push(held);
        }
        choice
    };
    let mut solved: Vec<Vec<Bound>> = Vec::new();
    for set in closing.sets() {
        if let Some(choice) = leads_on(&set) {
            return choice;
        }
        solved.push(set);
    }
    let rest = combinations(pairs, &groups).into_iter();
    for set in rest.chain(solved.iter().flat_map(|set| let_go(set))) {
        if let Some(choice) = leads_on(&set) {
            return choice;
        }
    }
    for scale in &TRIALS[1..] {
        if let Some(choice) = possible.iter().find_map(|held| goes_on(held, *scale)) {
            return choice;
        }
    }
    match withstood(system, pairs, local, bounds, q) {
        Some(obstacles) => Choice::Jammed(obstacles),
        None => Choice::Undetermined,
    }
}

/// Bounds of which forces within the cones of friction withstand the drives, however large they have to be, each with its multiplier.
fn withstood(
    system: &System,
    pairs: &Pairs,
    local: &Local<'_>,
    bounds: &[Bound],
    q: &[f64],
) -> Option<Vec<(Bound, f64)>> {
    let cones = cones(system, pairs, bounds, q);
    let rows: Vec<Row> = cones.iter().map(|cone| cone.1).collect();
    let Nearest::None { multipliers } = local.nearest(&rows) else {
        return None;
    };
    let mut obstacles: Vec<(Bound, f64)> = Vec::new();
    for ((bound, _), m) in cones.iter().zip(multipliers).filter(|(_, m)| *m > 0.0) {
        match obstacles.iter_mut().find(|o| o.0.is_same(bound)) {
            Some(obstacle) => obstacle.1 += m,
            None => obstacles.push((*bound, m)),
        }
    }
    Some(obstacles)
}

/// As [`withstood`], where the motion makes no progress in time: each step closes what the one before has left out.
pub(crate) fn wedged(
    system: &System,
    pairs: &Pairs,
    bounds: &[Bound],
    time: f64,
    q: &[f64],
) -> Option<Vec<(Bound, f64)>> {
    let bounds: Vec<Bound> = bounds.iter().filter(|b| !b.is_brake()).copied().collect();
    withstood(system, pairs, &Local::at(system, q, time)?, &bounds, q)
}

/// Whether bounds can hold at a configuration: forces are within cones of friction, and balanced if required.
fn is_possible(
    system: &System,
    pairs: &Pairs,
    held: &[Bound],
    local: &Local<'_>,
    q: &[f64],
) -> bool {
    let Some(moved) = local.held(&Holding::of(system, pairs, held, q)) else {
        return false;
    };
    let pulls = |v: &Held, k: usize| v.pushes[k] < -ROUGHLY * v.speed;
    let all = || (0..held.len()).filter(|&k| !held[k].is_brake());
    match system.law() {
        Law::Speeds { .. } => all().all(|k| !pulls(&moved, k)),
        Law::Balance => {
            let closed = Closed {
                system,
                pairs,
                bounds: held,
                q,
            };
            // A contact that only begins to be pressed is pressed by rounding, with either sign.
            closed
                .kept_by(local)
                .is_some_and(|kept| all().all(|k| !pulls(&kept, k) || !pulls(&moved, k)))
        }
    }
}

fn among<'a>(
    system: &'a System,
    pairs: &'a Pairs,
    local: &Local<'a>,
    bounds: &[Bound],
    time: f64,
    q: &[f64],
    longest: f64,
) -> Choice<'a> {
    let rows: Vec<Row> = bounds
        .iter()
        .map(|b| b.function(system, pairs, q))
        .collect();
    // Where forces balance, what is pushed off the end of its range may be carried by either.
    let balances = system.law() == Law::Balance;
    let contacts: Vec<usize> = (0..bounds.len())
        .filter(|&i| match bounds[i] {
            Bound::Contact(_) => true,
            Bound::Limit { .. } => balances,
            Bound::Brake { .. } => false,
        })
        .collect();
    let places: Vec<Option<Point>> = (contacts.iter())
        .map(|&i| bounds[i].place(system, pairs, q))
        .collect();
    let near = SAME_PLACE * system.size();
    let has_other = |k: usize, left_out: &[usize]| {
        (0..contacts.len()).any(|other| {
            let same_pair = match (&bounds[contacts[k]], &bounds[contacts[other]]) {
                (Bound::Contact(a), Bound::Contact(b)) => a.pair == b.pair,
                _ => false,
            };
            let close = |(p, q): (Point, Point)| p.distance(q) <= near;
            same_pair
                && !left_out.contains(&other)
                && places[k].zip(places[other]).is_some_and(close)
        })
    };
    // First only those are left out that have another at the same place; then any.
    let sets = left_out(contacts.len());
    let (fair, other): (Vec<_>, Vec<_>) = sets
        .into_iter()
        .partition(|set| set.iter().all(|&k| has_other(k, set)));
    let mut tried: Vec<Vec<usize>> = Vec::new();
    for sets in [fair, other] {
        let mut candidates: Vec<(Vec<usize>, f64)> = Vec::new();
        for left_out in sets {
            let inside: Vec<usize> = (0..bounds.len())
                .filter(|i| !left_out.iter().any(|&k| contacts[k] == *i))
                .collect();
            let chosen: Vec<Row> = inside.iter().map(|&i| rows[i]).collect();
            let nearest = match system.law() {
                Law::Speeds { .. } => {
                    let kept = (0..inside.len()).filter(|&k| bounds[inside[k]].is_brake());
                    Some(local.nearest_with(&chosen, &kept.collect::<Vec<_>>()))
                }
                Law::Balance => {
                    let bounds: Vec<Bound> = inside.iter().map(|&i| bounds[i]).collect();
                    let closed = Closed {
                        system,
                        pairs,
                        bounds: &bounds,
                        q,
                    };
                    closed.nearest(local)
                }
            };
            if let Some(Nearest::Held { held, distance }) = nearest {
                let held: Vec<usize> = held.into_iter().map(|k| inside[k]).collect();
                if !tried.contains(&held) {
                    tried.push(held.clone());
                    candidates.push((held, distance));
                }
            }
        }
        // Candidates at equal distances stay in order: those with more contacts come first.
        candidates.sort_by(|a, b| a.1.total_cmp(&b.1));
        for scale in TRIALS {
            for (held, _) in &candidates {
                let held: Vec<Bound> = held.iter().map(|&i| bounds[i]).collect();
                if let Some((flow, next)) = tries(system, pairs, held, time, q, scale, longest) {
                    return Choice::On { flow, next };
                }
            }
        }
    }
    match local.nearest(&rows) {
        Nearest::None { multipliers } => Choice::Jammed(
            (bounds.iter().copied().zip(multipliers))
                .filter(|(_, m)| *m > 0.0)
                .collect(),
        ),
        Nearest::Held { .. } => Choice::Undetermined,
    }
}

/// Sets of contacts to be left out, by index, the smaller sets first.
fn left_out(contacts: usize) -> Vec<Vec<usize>> {
    if contacts > MOST_CONTACTS {
        let none = core::iter::once(Vec::new());
        return none.chain((0..contacts).map(|i| vec![i])).collect();
    }
    let set = |bits: usize| (0..contacts).filter(|i| bits >> i & 1 == 1).collect();
    let mut all: Vec<Vec<usize>> = (0..1_usize << contacts).map(set).collect();
    all.sort_by_key(Vec::len);
    all
}

/// The motion with some bounds held, if it leads on, and where it then is.
fn tries<'a>(
    system: &'a System,
    pairs: &'a Pairs,
    held: Vec<Bound>,
    time: f64,
    q: &[f64],
    scale: f64,
    longest: f64,
) -> Option<(Flow<'a>, Vec<f64>)> {
    let flow = Flow::new(system, pairs, held, time, q)?;
    let far = scale * system.size();
    let moved = |to: &Arrived| system.moved(&flow.q, &to.q) / far;
    let trial = |h: f64| {
        let is_right = |to: &Arrived| moved(to) <= MOST_FARTHER && to.excess(system) <= 1.0;
        Some((h, flow.after(h).filter(is_right)?))
    };
    let by_speed = far / system.speed(&flow.velocity.rates);
    let shorter = (0..MOST_SHORTER).map(|k| SHORTER.powi(k));
    let (h, to) = if by_speed <= longest {
        shorter.clone().map(|s| s * by_speed).find_map(trial)
    } else {
        // A motion that begins at rest cannot be judged by its speed, nor by where it comes to: it may come back.
        let longer = shorter
            .clone()
            .rev()
            .map(|s| trial(s * longest))
            .map_while(|t| t);
        let mut last = None;
        for (h, to) in longer {
            let is_far = moved(&to) >= SHORTER;
            last = Some((h, to));
            if is_far {
                break;
            }
        }
        last
    }?;
    let mut watch = Watch::new(system, pairs);
    let (mut at, mut h, mut to) = (flow.clone(), h, to);
    for _ in 0..MOST_STEPS {
        if !goes_on(&mut watch, &at, h, &to) {
            return None;
        }
        // An unstable balance is left so slowly that one step of the allowed error is too short to tell.
        if moved(&to) >= SHORTER || by_speed > longest {
            break;
        }
        at.time += h;
        (at.q, at.velocity) = (to.q, to.velocity);
        h *= LONGER;
        to = shorter.clone().find_map(|s| {
            let arrived = at.after(s * h).filter(|to| to.excess(system) <= 1.0)?;
            h *= s;
            Some(arrived)
        })?;
    }
    Some((flow, to.q))
}
