//! Interface between the integrator and a mechanism: coordinates with masses and forces, constraints, and contacts that
//! open and close.

use nalgebra::{DMatrix, DVector};

use crate::complementarity::{Bearing, Mode, Solution};

/// A contact as a function of the coordinates, at one configuration and time.
#[derive(Debug, Clone)]
pub struct Touch {
    /// Distance of the features along their common normal.
    pub gap: f64,
    /// ∂gap/∂q: the rate of the gap is `normal · v + drift[0]`.
    pub normal: DVector<f64>,
    /// The rate at which the features slide past each other is `tangent · v + drift[1]`.
    pub tangent: DVector<f64>,
    /// Rates of gap and sliding where no coordinate changes: contributions of driven parts.
    pub drift: [f64; 2],
}

impl Touch {
    /// The rate of the gap.
    pub fn opening(&self, v: &DVector<f64>) -> f64 {
        self.normal.dot(v) + self.drift[0]
    }

    /// The rate of sliding.
    pub fn sliding(&self, v: &DVector<f64>) -> f64 {
        self.tangent.dot(v) + self.drift[1]
    }

    /// The contact in a problem of impulses, for a rate at which it opens before them: Newton's law, u_N' + e min(u_N, 0) ≥ 0.
    pub(super) fn struck(self, rate: f64, surface: Surface) -> Bearing {
        Bearing {
            b: self.drift[0] + surface.restitution * rate.min(0.0),
            c: self.drift[1],
            normal: self.normal,
            tangent: self.tangent,
            friction: surface.friction,
            slides: None,
            lets_go: false,
        }
    }
}

/// A step of the motion, as it is judged by a [`World`].
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// State at the beginning.
    pub from: &'a State,
    /// State at the end.
    pub to: &'a State,
    /// Contacts that bear during the whole step.
    pub bearing: &'a [usize],
}

/// Function whose change of sign shows an event: positive before, negative after.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sought {
    /// Gap of a contact.
    Gap(usize),
    /// Distance of a contact from the end of one of its features.
    End(usize, usize),
}

/// Displacement for the differences of directions, as a share of the size: their error is its square.
const WAY: f64 = 1e-5;

/// A mechanical system with contacts:
///
/// ```text
/// M v̇ = h(t, q, v) + Jᵀ μ + Σ λ_N n + Σ λ_T τ,   q̇ = v
/// ```
///
/// M is constant and has an inverse; contacts are numbered and keep their numbers.
pub trait World {
    /// The mass matrix M.
    fn mass(&self) -> &DMatrix<f64>;

    /// The forces h.
    fn force(&self, state: &State) -> DVector<f64>;

    /// Constraints that hold always: the values that are 0, their rows J by the coordinates, and the rates that J v has, which are 0
    /// unless a constraint depends on time. None unless a world has some.
    fn joints(&self, _t: f64, q: &DVector<f64>) -> Joints {
        Joints::none(q.len())
    }

    /// Right-hand side of the joints' accelerations, J v̇: −J̇ v plus the derivatives of the rates prescribed for J v.
    /// Default: finite differences along v.
    fn joint_bends(&self, state: &State) -> DVector<f64> {
        let here = self.joints(state.t, &state.q);
        let along = |k: usize| {
            -change(self, state, |t, q| {
                let there = self.joints(t, q);
                there.rows.row(k).transpose().dot(&state.v) - there.rates[k]
            })
        };
        DVector::from_fn(here.values.len(), |k, _| along(k))
    }

    /// The contacts whose gaps are looked at in every step.
    fn watched(&self) -> Vec<usize>;

    /// A contact at a configuration.
    fn touch(&self, contact: usize, t: f64, q: &DVector<f64>) -> Touch;

    /// State of some contacts at one configuration.
    fn touches(&self, contacts: &[usize], t: f64, q: &DVector<f64>) -> Vec<Touch> {
        contacts.iter().map(|&i| self.touch(i, t, q)).collect()
    }

    /// A contact, and what its rates of opening and of sliding change by where no rate does: ṅ · v, τ̇ · v and the derivatives of the
    /// drift. By differences along v unless a world knows better.
    fn bends(&self, contact: usize, state: &State) -> (Touch, [f64; 2]) {
        let touch = self.touch(contact, state.t, &state.q);
        let of = |rate: fn(&Touch, &DVector<f64>) -> f64| {
            change(self, state, |t, q| {
                rate(&self.touch(contact, t, q), &state.v)
            })
        };
        (touch, [of(Touch::opening), of(Touch::sliding)])
    }

    /// Coefficients of the accelerations at a state, with some contacts.
    fn equations(&self, state: &State, contacts: &[usize]) -> Equations {
        Equations {
            force: self.force(state),
            joints: self.joints(state.t, &state.q).rows,
            joint_bends: self.joint_bends(state),
            contacts: contacts.iter().map(|&i| self.bends(i, state)).collect(),
        }
    }

    /// The contacts that are closed: those that are watched, with no gap but [`CLOSED`](super::CLOSED) of the size.
    fn closed(&self, t: f64, q: &DVector<f64>) -> Vec<usize> {
        let limit = super::CLOSED * self.size();
        let mut closed = self.watched();
        closed.retain(|&i| self.touch(i, t, q).gap <= limit);
        closed
    }

    /// Contacts with gap ≤ 0 and penetration ≤ `_way` at a configuration that may overlap: those that keep it from
    /// overlapping more. `None` if they cannot be determined there. Default: the closed contacts.
    fn overlapping(&self, t: f64, q: &DVector<f64>, _way: f64) -> Option<Vec<usize>> {
        Some(self.closed(t, q))
    }

    /// Alternative sets of closed contacts, one of which holds from now on; the first that leads on is taken. Default:
    /// all of them. Several sets exist if contacts that take each other's place are among them.
    fn alternatives(&self, closed: &[usize], _t: f64, _q: &DVector<f64>) -> Vec<Vec<usize>> {
        vec![closed.to_vec()]
    }

    /// Whether a contact with gap 0 is between the ends of its features.
    fn is_there(&self, _contact: usize, _t: f64, _q: &DVector<f64>) -> bool {
        true
    }

    /// Whether two contacts take each other's place at a configuration.
    fn is_same(&self, a: usize, b: usize, _t: f64, _q: &DVector<f64>) -> bool {
        a == b
    }

    /// The gap at which a contact is held that is closed with some gap: parts that touch as well as contacts are known are level as they
    /// are. `None` if the gap is larger, and has yet to close; 0 if parts overlap by more. 0 of all gaps unless a world knows better.
    fn seat(&self, _contact: usize, _gap: f64) -> Option<f64> {
        Some(0.0)
    }

    /// Whether parts are apart where either of two contacts at one place is open: true at convex corners.
    fn one_is_enough(&self, _a: usize, _b: usize) -> bool {
        false
    }

    /// Whether one contact may take another's place where parts overlap by `_way`: as one that passes from feature to
    /// feature.
    fn passes(&self, a: usize, b: usize, t: f64, q: &DVector<f64>, _way: f64) -> bool {
        self.is_same(a, b, t, q)
    }

    /// Whether a step met something that no watched contact shows.
    fn met(&self, _step: Step<'_>) -> bool {
        false
    }

    /// Event functions of which at least one changes sign in a step that begins before an event and ends after it. Gaps
    /// are accurate to ± `near`.
    fn sought(&self, _step: Step<'_>, _near: f64) -> Vec<Sought> {
        Vec::new()
    }

    /// The value of one of them.
    fn value(&self, sought: Sought, t: f64, q: &DVector<f64>) -> f64 {
        match sought {
            Sought::Gap(contact) => self.touch(contact, t, q).gap,
            Sought::End(..) => 1.0,
        }
    }

    /// Power of the drives, and losses by friction at contacts and by dampers, per second. With impulses for forces and
    /// the mean of the rates before and after for the rates it is the work in an impact.
    fn powers(&self, _state: &State, _acting: &Acting<'_>) -> [f64; 2] {
        [0.0; 2]
    }

    /// The kinetic energy of all that moves.
    fn kinetic(&self, state: &State) -> f64 {
        0.5 * state.v.dot(&(self.mass() * &state.v))
    }

    /// Notifies the world that a step was taken.
    fn taken(&self, _step: Step<'_>) {}

    /// The coefficients of friction and of restitution of a contact.
    fn surface(&self, contact: usize) -> Surface;

    /// Unit of length: contacts are closed to [`CLOSED`](super::CLOSED) times this.
    fn size(&self) -> f64;

    /// The thinnest thing there is: what moves farther in a step may come through it unseen. Default: none is thin.
    fn thinnest(&self) -> f64 {
        f64::INFINITY
    }

    /// How far things are apart that may meet, at a configuration. Default: not at all.
    fn clearance(&self, _t: f64, _q: &DVector<f64>) -> f64 {
        0.0
    }

    /// Largest displacement by a change of the coordinates, or by their rates; angles may count by lengths.
    fn reach(&self, change: &DVector<f64>) -> f64 {
        change.amax()
    }

    /// Largest speed of a point, driven parts included.
    fn speed(&self, state: &State) -> f64 {
        self.reach(&state.v)
    }

    /// The longest step from a state, s.
    fn longest(&self, _state: &State) -> f64 {
        f64::INFINITY
    }
}

/// The forces of contacts and joints at a time, or the impulses of an impact.
#[derive(Debug, Clone)]
pub struct Acting<'a> {
    /// The accelerations; `None` in an impact.
    pub accelerations: Option<&'a DVector<f64>>,
    /// The contacts that bear, with λ_N and λ_T.
    pub contacts: Vec<(usize, f64, f64)>,
    /// μ, of the constraints.
    pub joints: &'a DVector<f64>,
}

impl<'a> Acting<'a> {
    pub(super) fn of(solution: &'a Solution, bearings: &[(usize, Mode)]) -> Self {
        let contacts = bearings.iter().enumerate();
        Self {
            accelerations: Some(&solution.x),
            contacts: contacts
                .map(|(k, b)| (b.0, solution.normal[k], solution.tangential[k]))
                .collect(),
            joints: &solution.joints,
        }
    }
}

/// Coefficients of the equations of motion at one state.
#[derive(Debug, Clone)]
pub struct Equations {
    /// The forces h.
    pub force: DVector<f64>,
    /// J.
    pub joints: DMatrix<f64>,
    /// Right-hand side of the joints' accelerations, J v̇.
    pub joint_bends: DVector<f64>,
    /// Contacts, with the values of [`World::bends`].
    pub contacts: Vec<(Touch, [f64; 2])>,
}

/// Constraints at a configuration.
#[derive(Debug, Clone)]
pub struct Joints {
    /// 0 where they hold.
    pub values: DVector<f64>,
    /// J, their derivatives by the coordinates.
    pub rows: DMatrix<f64>,
    /// The rates that J v has.
    pub rates: DVector<f64>,
}

impl Joints {
    /// Creates an empty set of equations for a number of coordinates.
    pub fn none(count: usize) -> Self {
        Self {
            values: DVector::zeros(0),
            rows: DMatrix::zeros(0, count),
            rates: DVector::zeros(0),
        }
    }
}

/// Rate of a function of time and coordinates along the motion.
fn change<W: World + ?Sized>(
    world: &W,
    state: &State,
    of: impl Fn(f64, &DVector<f64>) -> f64,
) -> f64 {
    let State { t, q, v } = state;
    let speed = world.reach(v);
    if speed == 0.0 {
        return 0.0;
    }
    let ahead = WAY * world.size() / speed;
    (of(t + ahead, &(q + v * ahead)) - of(t - ahead, &(q - v * ahead))) / (2.0 * ahead)
}

/// Friction and restitution between two surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Coulomb's coefficient of friction.
    pub friction: f64,
    /// Newton's coefficient of restitution.
    pub restitution: f64,
}

impl Surface {
    /// Neither friction nor restitution.
    pub(super) const DEAD: Self = Self {
        friction: 0.0,
        restitution: 0.0,
    };
}

/// Time, coordinates and rates.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// s.
    pub t: f64,
    /// Coordinates.
    pub q: DVector<f64>,
    /// Rates of the coordinates.
    pub v: DVector<f64>,
}
