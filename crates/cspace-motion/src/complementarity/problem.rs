//! The problem of contacts with Coulomb's friction, as data.

use nalgebra::{DMatrix, DVector};

/// Mode of a contact: open, sticking or sliding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mode {
    /// The contact bears no force.
    Open,
    /// The contact bears a force and does not slide.
    Stick,
    /// The contact bears a force and slides in the direction of its tangent.
    Forward,
    /// The contact bears a force and slides against its tangent.
    Backward,
}

impl Mode {
    /// The sign of sliding: 1, −1, or 0.
    pub fn direction(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Backward => -1.0,
            Self::Open | Self::Stick => 0.0,
        }
    }
}

/// A contact in the problem.
#[derive(Debug, Clone)]
pub(crate) struct Bearing {
    pub(crate) normal: DVector<f64>,
    pub(crate) tangent: DVector<f64>,
    /// a_N = n · x + b.
    pub(crate) b: f64,
    /// a_T = τ · x + c.
    pub(crate) c: f64,
    pub(crate) friction: f64,
    /// The direction in which it slides already.
    pub(crate) slides: Option<f64>,
    /// Whether the contact has reached the end of its sticking: then sticking is tried last among modes with equal
    /// accelerations.
    pub(crate) lets_go: bool,
}

impl Bearing {
    /// The modes in which it may be.
    pub(crate) fn choices(&self) -> &'static [Mode] {
        match self.slides {
            Some(s) if s > 0.0 => &[Mode::Open, Mode::Forward],
            Some(_) => &[Mode::Open, Mode::Backward],
            // Without friction sticking and sliding are the same.
            None if self.friction == 0.0 => &[Mode::Open, Mode::Forward],
            None if self.lets_go => &[Mode::Open, Mode::Forward, Mode::Backward, Mode::Stick],
            None => &[Mode::Open, Mode::Stick, Mode::Forward, Mode::Backward],
        }
    }
}

/// The problem.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'a> {
    /// Symmetric and positive definite.
    pub(crate) mass: &'a DMatrix<f64>,
    pub(crate) h: DVector<f64>,
    pub(crate) joints: DMatrix<f64>,
    pub(crate) j: DVector<f64>,
    pub(crate) bearings: Vec<Bearing>,
    /// Rounding threshold: values below this share of the largest term count as 0.
    pub(crate) zero: f64,
}

/// A solution.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    pub(crate) x: DVector<f64>,
    pub(crate) modes: Vec<Mode>,
    /// λ_N of each contact.
    pub(crate) normal: Vec<f64>,
    /// λ_T.
    pub(crate) tangential: Vec<f64>,
    /// μ of each row of the joints.
    pub(crate) joints: DVector<f64>,
    /// a_N and a_T.
    pub(crate) rates: Vec<(f64, f64)>,
}

/// Rates carry rounding of this share of their terms, at most: terms that cancel are not seen in a solution at rest.
const ROUNDING: f64 = 1e-12;

impl Problem<'_> {
    /// Scale of the rates: the largest sum of the magnitudes of one rate's terms.
    pub(crate) fn terms(&self, solution: &Solution) -> f64 {
        (self.bearings.iter())
            .map(|b| {
                let x = solution.x.iter().zip(b.normal.iter());
                x.map(|(x, n)| (x * n).abs()).sum::<f64>() + b.b.abs() + b.c.abs()
            })
            .fold(f64::MIN_POSITIVE, f64::max)
    }

    /// The forces, and the rates, that are 0. `terms` is the largest sum of the sizes of terms of a rate.
    fn nothing(&self, solution: &Solution, terms: f64) -> (f64, f64) {
        let forces = solution.normal.iter().chain(&solution.tangential);
        let force = forces.fold(self.h.amax(), |m, f| m.max(f.abs()));
        let rate = self.terms(solution);
        (force * self.zero, (rate * self.zero).max(terms * ROUNDING))
    }

    /// Whether a contact has neither a force nor an acceleration.
    pub(crate) fn is_tied(&self, s: &Solution) -> bool {
        // The rates that forces other than those of contacts would give, were there no contacts.
        let free = |b: &Bearing| -> f64 {
            let terms = b.normal.iter().zip(self.h.iter()).enumerate();
            terms
                .map(|(k, (n, h))| (n * h / self.mass[(k, k)]).abs())
                .sum()
        };
        let terms = self.bearings.iter().map(free).fold(0.0, f64::max);
        let (force, rate) = self.nothing(s, terms);
        let mut each = s.normal.iter().zip(&s.rates);
        each.any(|(normal, (a_n, _))| normal.abs() <= force && a_n.abs() <= rate)
    }

    /// Whether a solution satisfies the inequalities of its modes.
    pub(crate) fn holds(&self, s: &Solution, terms: f64) -> bool {
        let (force, rate) = self.nothing(s, terms);
        (0..s.modes.len()).all(|i| {
            let bearing = &self.bearings[i];
            let (a_n, a_t) = s.rates[i];
            let slides_on = bearing.slides.is_some() || bearing.friction == 0.0;
            match s.modes[i] {
                Mode::Open => a_n >= -rate,
                Mode::Stick => {
                    s.normal[i] >= -force
                        && s.tangential[i].abs() <= bearing.friction * s.normal[i] + force
                }
                Mode::Forward => s.normal[i] >= -force && (slides_on || a_t >= -rate),
                Mode::Backward => s.normal[i] >= -force && (slides_on || a_t <= rate),
            }
        })
    }

    /// Whether a solution that was not computed from the equations of its modes satisfies them.
    pub(crate) fn agrees(&self, s: &Solution, terms: f64) -> bool {
        let (force, rate) = self.nothing(s, terms);
        (0..s.modes.len()).all(|i| {
            let (normal, tangential) = (s.normal[i], s.tangential[i]);
            let (a_n, a_t) = s.rates[i];
            let drag = -s.modes[i].direction() * self.bearings[i].friction * normal;
            match s.modes[i] {
                Mode::Open => normal.abs() <= force && tangential.abs() <= force,
                Mode::Stick => a_n.abs() <= rate && a_t.abs() <= rate,
                Mode::Forward | Mode::Backward => {
                    a_n.abs() <= rate && (tangential - drag).abs() <= force
                }
            }
        })
    }
}
