//! A quantity from the drawing alone: the first contacts of its motions, without a configuration space.
//!
//! A play is the time of two motions at rate 1 up to their first contacts; a position, or the angle at a contact, comes from one motion. The
//! time t of a contact follows from f(q(t), p) = 0, and dt/dp = −(∂f/∂p) / (∂f/∂t).

use crate::drawn::{
    Affine, DrawingNumber, DrawnContact, DrawnPair, Enclosure, Encounter, Encounters, Leg,
};
use cspace::{AxisMotion, Ball, Coordinates, Dual, Real, Relation};
use cspace_model::model::{
    Coordinate, PartSlopes, Quantity, Requirement, RequirementSlopes, Slopes, Subject,
};
use cspace_model::{Model, PairEntry};

use crate::range::{numbers, unit};

/// So many parameters are told apart in enclosures; what others do is added up.
pub(crate) const TOLD_APART: usize = 12;

/// An enclosure over a box of parameters.
pub(crate) type Enclosed = Affine<TOLD_APART>;

/// An enclosure with its derivative by one parameter.
pub(crate) type Slope = Dual<1, Enclosed>;

/// A number with its derivative by one parameter, as a template encloses it.
type Given = Dual<1, Ball>;

/// Quantities that first contacts decide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Form {
    /// From one contact to the other.
    Play(Coordinate),
    /// A coordinate at the contact.
    Position(Coordinate),
    /// Between the normal at the contact and the velocity of its point when a coordinate changes.
    Angle(Coordinate),
}

/// Drawing of a requirement: the pair, its motions, and when they reach the end of a range.
pub(crate) struct Drawing<T> {
    pub(crate) form: Form,
    pub(crate) pair: DrawnPair<T>,
    pub(crate) legs: Vec<Leg<T>>,
    /// When each leg leaves the range of a motion or the window of orientations.
    pub(crate) limits: Vec<Option<T>>,
    /// The motions of both parts, of which the second is the only one of a planar pair.
    motions: Option<[AxisMotion; 2]>,
    axes: [[T; 2]; 2],
}

/// The first contact of each motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Hits {
    pub(crate) contacts: Vec<DrawnContact>,
    pub(crate) times: Vec<f64>,
}

/// For each motion, the contacts that may come about before one that is certain.
pub(crate) type Contacts = Vec<Vec<Encounter>>;

/// Where a motion begins, and its rates.
type Motion = (Coordinates, Coordinates);

/// The motions of a requirement that first contacts decide: the pair, what is taken from them, and each from where at what rates.
fn motions(requirement: &Requirement) -> Option<(PairEntry, Form, Vec<Motion>)> {
    let Subject::Pair(pair, quantity) = requirement.subject else {
        return None;
    };
    let (form, legs) = match quantity {
        Quantity::Play { of, at } => (
            Form::Play(of),
            vec![(at, unit(of, -1.0)), (at, unit(of, 1.0))],
        ),
        Quantity::Position { from, along, of } => (Form::Position(of), vec![(from, along)]),
        Quantity::Angle {
            at,
            along: Some(along),
            of,
        } => (Form::Angle(of), vec![(at, along)]),
        _ => return None,
    };
    Some((pair, form, legs))
}

/// A number of the drawing of a pair: that of `slopes` where it varies.
fn number<T: Real>(pair: PairEntry, slopes: Option<&Slopes<T>>, of: DrawingNumber, x: f64) -> T {
    let of_part = |part: usize| slopes.map(|s| &s.parts[[pair.fixed, pair.moving][part]]);
    let known = match of {
        DrawingNumber::Vertex {
            part,
            loop_index,
            vertex,
            component,
        } => of_part(part).and_then(|s| Some(s.loops.get(loop_index)?.get(vertex)?[component])),
        DrawingNumber::Axis { part, component } => {
            of_part(part).and_then(|s| Some(s.axis?[component]))
        }
    };
    known.unwrap_or(T::constant(x))
}

/// A pair of a model as it is drawn, with the numbers of `slopes` where they vary; `None` of parts that a joint connects.
pub(crate) fn drawn_pair<T: Real>(
    model: &Model,
    pair: PairEntry,
    slopes: Option<&Slopes<T>>,
) -> Option<DrawnPair<T>> {
    let parts = [pair.fixed, pair.moving].map(|i| &model.mechanism.parts[i].part);
    let relation = model.mechanism.relation(&pair);
    DrawnPair::new(parts, relation, |of, x| number(pair, slopes, of, x))
}

impl<T: Real> Drawing<T> {
    /// The drawing of a requirement in a model, with the numbers of `slopes` where they vary; `None` of a quantity that first contacts do
    /// not decide.
    pub(crate) fn new(
        model: &Model,
        requirement: &Requirement,
        slopes: Option<&Slopes<T>>,
    ) -> Option<Self> {
        let (entry, form, legs) = motions(requirement)?;
        let relation = model.mechanism.relation(&entry);
        let indices = [entry.fixed, entry.moving];
        let of_part = |part: usize| slopes.map(|s| &s.parts[indices[part]]);
        let number = |of: DrawingNumber, x: f64| number(entry, slopes, of, x);
        let pair = drawn_pair(model, entry, slopes)?;
        let of = slopes.and_then(|s| s.requirements.get(&requirement.name));
        let is_play = matches!(form, Form::Play(_));
        let legs: Vec<Leg<T>> = (legs.iter())
            .map(|&(from, rates)| {
                let mut leg = Leg::new(numbers(from), numbers(rates));
                if let Some(of) = of {
                    for i in 0..3 {
                        leg.from[i] = of.at[i].unwrap_or(leg.from[i]);
                        if !is_play {
                            leg.rates[i] = of.along[i].unwrap_or(leg.rates[i]);
                        }
                    }
                }
                leg
            })
            .collect();
        let (motions, ranges) = match relation {
            Relation::Axes { fixed, moving } => (
                Some([fixed.motion, moving.motion]),
                [(0, fixed.range), (1, moving.range)],
            ),
            _ => (None, [(2, entry.window), (2, None)]),
        };
        let varied_range = |part: usize| of_part(part).and_then(|s| s.range);
        let limits = legs.iter().map(|leg| {
            let mut soonest: Option<T> = None;
            for (part, (k, range)) in ranges.iter().enumerate() {
                let rate = leg.rates[*k];
                if let Some((lo, hi)) = range.filter(|_| rate.value() != 0.0) {
                    let ends = match varied_range(part) {
                        Some(ends) if motions.is_some() => ends,
                        _ => [lo, hi].map(T::constant),
                    };
                    let end = ends[usize::from(rate.value() > 0.0)];
                    let time = (end - leg.from[*k]) / rate;
                    if soonest.is_none_or(|s| time.value() < s.value()) {
                        soonest = Some(time);
                    }
                }
            }
            soonest
        });
        let limits = limits.collect();
        let axes = [0, 1].map(|part| {
            let numbers = match motions.map(|m| m[part]) {
                Some(AxisMotion::Revolute { center }) => [center.x, center.y],
                Some(AxisMotion::Prismatic { direction }) => [direction.x, direction.y],
                _ => [0.0; 2],
            };
            [0, 1].map(|component| {
                number(DrawingNumber::Axis { part, component }, numbers[component])
            })
        });
        Some(Self {
            form,
            pair,
            legs,
            limits,
            motions,
            axes,
        })
    }

    pub(crate) fn map<U: Real>(&self, f: impl Fn(T) -> U + Copy) -> Drawing<U> {
        Drawing {
            form: self.form,
            pair: self.pair.map(f),
            legs: (self.legs.iter())
                .map(|leg| Leg {
                    from: leg.from.map(f),
                    rates: leg.rates.map(f),
                })
                .collect(),
            limits: self.limits.iter().map(|l| l.map(f)).collect(),
            motions: self.motions,
            axes: self.axes.map(|a| a.map(f)),
        }
    }

    /// The quantity where its motions meet contacts at some times.
    pub(crate) fn value(&self, contacts: &[DrawnContact], times: &[T]) -> T {
        match self.form {
            Form::Play(_) => times[0] + times[1],
            Form::Position(of) => self.legs[0].at(times[0])[of.index()],
            Form::Angle(of) => {
                let cosine = self.cosine(contacts[0], times[0], of.index());
                cosine.abs().acos()
            }
        }
    }

    /// n·w / |w| of the normal n at a contact and the velocity w of its point when a coordinate changes.
    fn cosine(&self, contact: DrawnContact, time: T, k: usize) -> T {
        type Lifted<T> = Dual<1, T>;
        let at = self.legs[0].at(time);
        let lift = |x: T| Lifted::<T> {
            value: x,
            slope: [T::constant(0.0)],
        };
        let mut lifted = at.map(lift);
        lifted[k].slope = [T::constant(1.0)];
        let normal = self.pair.gap(contact, lifted, lift).slope[0];
        let [on_fixed, on_moving] = self.pair.touching(contact, at);
        let apart = |p: [T; 2], q: [T; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        match self.motions {
            None if k == 2 => normal / apart(on_moving, [at[0], at[1]]),
            None => normal,
            Some(motions) => match motions[k] {
                AxisMotion::Revolute { .. } => {
                    // In the frame of the ground.
                    let place = match motions[0] {
                        AxisMotion::Fixed => cspace::Placement::identity(),
                        AxisMotion::Revolute { .. } => cspace::Placement::turn(self.axes[0], at[0]),
                        AxisMotion::Prismatic { .. } => {
                            cspace::Placement::slide(self.axes[0], at[0])
                        }
                    };
                    normal / apart(place.point(on_fixed), self.axes[k])
                }
                _ => normal,
            },
        }
    }
}

impl<T: Enclosure> Drawing<T> {
    /// Where each motion may meet contacts, until some times; among those that are known of a larger set of drawings.
    pub(crate) fn encounters(&self, until: &[f64], known: Option<&Contacts>) -> Vec<Encounters> {
        let legs = self.legs.iter().zip(until).enumerate();
        legs.map(|(i, (leg, &until))| {
            let among = known.map(|known| known[i].as_slice());
            self.pair.encounters(leg, until, among)
        })
        .collect()
    }

    /// Whether another contact comes together with the first of a motion.
    pub(crate) fn tie(&self, encounters: &[Encounters], hits: &Hits) -> bool {
        let mut motions = encounters.iter().zip(&hits.contacts).zip(&hits.times);
        motions.any(|((found, contact), time)| {
            let others = found.list.iter().filter(|e| e.contact != *contact);
            let mut near = others.filter(|e| e.lo <= time + NEAR * time.abs());
            near.next().is_some()
        })
    }

    /// The first contact of each motion of a drawing without uncertainty; `None` where it is in doubt, or the end of a range comes first.
    pub(crate) fn hits(&self, encounters: &[Encounters]) -> Option<Hits> {
        let mut hits = Hits::default();
        for (found, limit) in encounters.iter().zip(&self.limits) {
            let certain = found.list.iter().filter(|e| e.certain);
            let first = certain.min_by(|a, b| a.hi.total_cmp(&b.hi))?;
            // What comes about together with the first, but for rounding, changes nothing: ends of edges that lie on each other.
            let doubtful = |e: &Encounter| !e.certain && e.lo < first.lo * (1.0 - TOGETHER);
            if !found.complete || found.list.iter().any(doubtful) {
                return None;
            }
            let time = 0.5 * (first.lo + first.hi);
            if limit.is_some_and(|l| l.ball().ends()[0] <= time + NEAR * time.abs()) {
                return None;
            }
            hits.contacts.push(first.contact);
            hits.times.push(time);
        }
        Some(hits)
    }
}

/// Contacts that come about together but for this, relative to the time, are one event.
const TOGETHER: f64 = 1e-10;

/// Ends of features and of ranges count as passed where they are farther off than this, relative to them.
const NEAR: f64 = 1e-9;

/// When a contact comes about.
enum Root {
    At(f64),
    /// It does not, or beyond the ends of a feature.
    None,
    /// If it does, not before a time.
    Doubtful(f64),
}

impl Drawing<f64> {
    /// The first contact of each motion, where those that may come first, and when, are known for a box of drawings with this among them;
    /// `None` where it is in doubt.
    pub(crate) fn hits_among(&self, known: &Contacts) -> Option<Hits> {
        let mut hits = Hits::default();
        for (leg, list) in known.iter().enumerate() {
            let mut first: Option<(f64, DrawnContact)> = None;
            let mut doubtful = f64::INFINITY;
            // Those that come about once at most tell until when the others matter.
            let once = list.iter().filter(|e| e.approaching);
            for encounter in once.chain(list.iter().filter(|e| !e.approaching)) {
                if first.is_some_and(|f| f.0 < encounter.lo) {
                    continue;
                }
                let from = self.legs[leg].from;
                if encounter.lo <= 0.0 && self.pair.may_overlap_unseen(encounter.contact, from) {
                    return None;
                }
                let time = if encounter.approaching {
                    self.only_root(leg, encounter)
                } else {
                    let until = first.map_or(f64::INFINITY, |f| f.0 * (1.0 - TOGETHER));
                    self.first_root(leg, encounter, until)
                };
                match time {
                    Root::At(time) if first.is_none_or(|f| time < f.0) => {
                        first = Some((time, encounter.contact));
                    }
                    Root::At(_) | Root::None => {}
                    Root::Doubtful(from) => doubtful = doubtful.min(from),
                }
            }
            let (time, contact) = first?;
            // What comes about together with the first changes nothing.
            if doubtful < time * (1.0 - TOGETHER) {
                return None;
            }
            if self.limits[leg].is_some_and(|l| l <= time + NEAR * time.abs()) {
                return None;
            }
            hits.contacts.push(contact);
            hits.times.push(time);
        }
        Some(hits)
    }

    /// When a contact comes about that has one root at most.
    fn only_root(&self, leg: usize, encounter: &Encounter) -> Root {
        let Some(time) = self.root(leg, encounter) else {
            return Root::None;
        };
        let within = self.pair.within(encounter.contact, self.legs[leg].at(time));
        let least = within.into_iter().flatten().fold(f64::INFINITY, f64::min);
        if least > NEAR {
            Root::At(time)
        } else if least < -NEAR {
            Root::None
        } else {
            Root::Doubtful(time)
        }
    }

    /// As [`only_root`](Self::only_root), of a contact that may have several, before a time.
    fn first_root(&self, leg: usize, encounter: &Encounter, until: f64) -> Root {
        let enclosed = self.map(Ball::constant);
        let of = &enclosed.legs[leg];
        let found = enclosed
            .pair
            .encounters(of, encounter.hi.min(until), Some(&[*encounter]));
        match found.list.first() {
            _ if !found.complete => Root::Doubtful(encounter.lo),
            None => Root::None,
            Some(first) if first.certain => Root::At(0.5 * (first.lo + first.hi)),
            Some(first) => Root::Doubtful(first.lo),
        }
    }

    /// As [`root`](Self::root); or the end of the times beyond which it is.
    pub(crate) fn root_or_end(&self, leg: usize, encounter: &Encounter) -> f64 {
        let at = self.legs[leg].at(encounter.lo);
        let is_past = self.pair.gap(encounter.contact, at, |x| x) <= 0.0;
        let end = if is_past { encounter.lo } else { encounter.hi };
        self.root(leg, encounter).unwrap_or(end)
    }

    /// When the lines and circles of a contact touch, within the times of an encounter in which they approach each other.
    pub(crate) fn root(&self, leg: usize, encounter: &Encounter) -> Option<f64> {
        const STEPS: usize = 200;
        let gap = |t: f64| {
            let at = self.legs[leg].at(t);
            self.pair.gap(encounter.contact, at, |x| x)
        };
        // Enclosures of times are rounded outwards.
        let slack = 1e-12 * encounter.hi.abs();
        let (mut lo, mut hi) = (encounter.lo - slack, encounter.hi + slack);
        let (mut above, mut below) = (gap(lo), gap(hi));
        if !(above >= 0.0 && below <= 0.0) {
            return None;
        }
        // The secant; and the middle where that does not halve.
        for _ in 0..STEPS {
            let width = hi - lo;
            let secant = lo + width * (above / (above - below));
            for t in [secant, 0.5 * (lo + hi)] {
                // Beside the ends the secant is as good as there.
                let t = t.clamp(lo.next_up(), hi.next_down());
                if !(lo < t && t < hi) {
                    return Some(t);
                }
                match gap(t) {
                    g if g > 0.0 => (lo, above) = (t, g),
                    g if g < 0.0 => (hi, below) = (t, g),
                    _ => return Some(t),
                }
                if hi - lo <= 0.5 * width {
                    break;
                }
            }
            if hi - lo <= 4.0 * f64::EPSILON * hi.abs() {
                break;
            }
        }
        Some(0.5 * (lo + hi))
    }
}

impl Drawing<Slope> {
    /// The derivative of the quantity by the parameter, where these contacts decide it.
    pub(crate) fn derivative(&self, hits: &Hits) -> f64 {
        let times: Vec<Slope> = (0..)
            .zip(&hits.contacts)
            .zip(&hits.times)
            .map(|((leg, &contact), &t)| self.time(leg, contact, Enclosed::constant(t)))
            .collect();
        self.value(&hits.contacts, &times).slope[0].mid
    }

    /// When a leg meets a contact, with the derivative by the parameter: within the times of an encounter.
    pub(crate) fn time(&self, leg: usize, contact: DrawnContact, time: Enclosed) -> Slope {
        type Timed = Dual<1, Slope>;
        let lift = |x: Slope| Timed {
            value: x,
            slope: [Slope::constant(0.0)],
        };
        let of = Leg {
            from: self.legs[leg].from.map(lift),
            rates: self.legs[leg].rates.map(lift),
        };
        let t = Slope {
            value: time,
            slope: [Enclosed::constant(0.0)],
        };
        let f = self.pair.gap(contact, of.at(Timed::variable(t, 0)), lift);
        let (by_parameter, by_time) = (f.value.slope[0], f.slope[0].value);
        Slope {
            value: time,
            slope: [-(by_parameter / by_time)],
        }
    }
}

/// The numbers of a model over a box of parameters, with their derivatives by each of these: by the mean value theorem, those at the middle
/// plus the derivatives anywhere in the box times what parameters are off it.
pub(crate) fn enclosed(
    middle: &Slopes<Given>,
    by: &[Slopes<Given>],
    half: &[f64],
) -> Vec<Slopes<Slope>> {
    let number = |at: Given, slopes: &dyn Fn(usize) -> Option<Given>| {
        let mut value = Enclosed::about(at.value.mid, at.value.radius);
        for (k, &half) in half.iter().enumerate() {
            if half > 0.0
                && let Some(given) = slopes(k)
                && given.slope[0] != Ball::constant(0.0)
            {
                let slope = given.slope[0];
                value = value
                    + Enclosed::variable(0.0, slope.mid.abs() * half, k)
                        * Enclosed::constant(slope.mid.signum())
                    + Enclosed::about(0.0, slope.radius * half);
            }
        }
        value
    };
    let with = |value: Enclosed, slope: Option<Given>| Slope {
        value,
        slope: [slope.map_or(Enclosed::constant(0.0), |s| {
            Enclosed::about(s.slope[0].mid, s.slope[0].radius)
        })],
    };
    (0..by.len())
        .map(|own| {
            let parts = middle.parts.iter().enumerate().map(|(p, part)| {
                let pair =
                    |at: Option<[Given; 2]>,
                     of: &dyn Fn(&PartSlopes<Given>) -> Option<[Given; 2]>| {
                        at.map(|at| {
                            core::array::from_fn(|i| {
                                let slopes = |k: usize| of(&by[k].parts[p]).map(|x| x[i]);
                                with(number(at[i], &slopes), slopes(own))
                            })
                        })
                    };
                PartSlopes {
                    loops: (part.loops.iter().enumerate())
                        .map(|(l, outline)| {
                            let vertices = outline.iter().enumerate();
                            vertices
                                .map(|(v, at)| {
                                    core::array::from_fn(|i| {
                                        let slopes = |k: usize| {
                                            Some(by[k].parts[p].loops.get(l)?.get(v)?[i])
                                        };
                                        with(number(at[i], &slopes), slopes(own))
                                    })
                                })
                                .collect()
                        })
                        .collect(),
                    axis: pair(part.axis, &|p| p.axis),
                    range: pair(part.range, &|p| p.range),
                }
            });
            let requirements = middle.requirements.iter().map(|(name, at)| {
                let three = |at: [Option<Given>; 3],
                             of: &dyn Fn(&RequirementSlopes<Given>) -> [Option<Given>; 3]| {
                    core::array::from_fn(|i| {
                        let slopes = |k: usize| of(by[k].requirements.get(name)?)[i];
                        at[i].map(|at| with(number(at, &slopes), slopes(own)))
                    })
                };
                let slopes = RequirementSlopes {
                    at: three(at.at, &|r| r.at),
                    along: three(at.along, &|r| r.along),
                };
                (name.clone(), slopes)
            });
            Slopes {
                parts: parts.collect(),
                requirements: requirements.collect(),
            }
        })
        .collect()
}
