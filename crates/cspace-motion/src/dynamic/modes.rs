//! Which contacts bear, stick and slide: one problem for accelerations and for impacts.
//!
//! Sought are x (accelerations, or velocities after an impact), forces λ_N, λ_T of the contacts and μ of the joints with
//!
//! ```text
//! M x = h + Jᵀ μ + Σ λ_N n + Σ λ_T τ,   J x = j
//! λ_N ≥ 0,   a_N = n · x + b ≥ 0,   λ_N a_N = 0
//! |λ_T| ≤ f λ_N;   λ_T = −f λ_N s where it slides, or begins to slide, in direction s = ±1, and 0 = a_T = τ · x + c where it sticks
//! ```
//!
//! Each contact is in one of four modes, and in each combination of modes the equations are linear. All combinations are tried, those
//! whose inequalities hold are solutions: there may be none, one or several. Forces of contacts that support each other are the least
//! that do it (least squares).

use nalgebra::{DMatrix, DVector};

/// What a contact does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mode {
    /// It bears nothing.
    Open,
    /// It bears, and does not slide.
    Stick,
    /// It bears, and slides in the direction of its tangent.
    Forward,
    /// It bears, and slides against it.
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
pub(super) struct Bearing {
    pub(super) normal: DVector<f64>,
    pub(super) tangent: DVector<f64>,
    /// a_N = n · x + b.
    pub(super) b: f64,
    /// a_T = τ · x + c.
    pub(super) c: f64,
    pub(super) friction: f64,
    /// The direction in which it slides already.
    pub(super) slides: Option<f64>,
}

/// The problem.
#[derive(Debug, Clone)]
pub(super) struct Problem<'a> {
    pub(super) mass: &'a DMatrix<f64>,
    pub(super) h: DVector<f64>,
    pub(super) joints: DMatrix<f64>,
    pub(super) j: DVector<f64>,
    pub(super) bearings: Vec<Bearing>,
    /// What is less than this share of the largest term is 0.
    pub(super) zero: f64,
}

/// A solution.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    pub(super) x: DVector<f64>,
    pub(super) modes: Vec<Mode>,
    /// λ_N of each contact.
    pub(super) normal: Vec<f64>,
    /// λ_T.
    pub(super) tangential: Vec<f64>,
    /// μ of each row of the joints.
    pub(super) joints: DVector<f64>,
    /// a_N and a_T.
    pub(super) rates: Vec<(f64, f64)>,
}

/// More contacts at once than this are not gone through: 4⁷ combinations take some hundredths of a second.
pub(super) const MOST: usize = 7;

impl Problem<'_> {
    fn choices(&self, i: usize) -> Vec<Mode> {
        let bearing = &self.bearings[i];
        match bearing.slides {
            Some(s) if s > 0.0 => vec![Mode::Open, Mode::Forward],
            Some(_) => vec![Mode::Open, Mode::Backward],
            // Without friction sticking and sliding are the same.
            None if bearing.friction == 0.0 => vec![Mode::Open, Mode::Forward],
            None => vec![Mode::Open, Mode::Stick, Mode::Forward, Mode::Backward],
        }
    }

    /// All solutions that differ in x; of more than [`MOST`] contacts none.
    pub(super) fn solutions(&self) -> Vec<Solution> {
        let mut found: Vec<Solution> = Vec::new();
        if self.bearings.len() > MOST {
            return found;
        }
        let choices: Vec<Vec<Mode>> = (0..self.bearings.len()).map(|i| self.choices(i)).collect();
        let mut odometer = vec![0; choices.len()];
        loop {
            let modes: Vec<Mode> = odometer.iter().zip(&choices).map(|(&k, c)| c[k]).collect();
            if let Some(solution) = self.within(&modes)
                && self.holds(&solution)
                && found.iter().all(|other| self.differs(other, &solution))
            {
                found.push(solution);
            }
            let Some(i) = (0..odometer.len()).find(|&i| odometer[i] + 1 < choices[i].len()) else {
                return found;
            };
            odometer[..i].fill(0);
            odometer[i] += 1;
        }
    }

    /// The solution of the linear equations of some modes, whether its inequalities hold or not; `None` if they have none.
    pub(super) fn within(&self, modes: &[Mode]) -> Option<Solution> {
        let n = self.h.len();
        let joints = self.joints.nrows();
        let bears: Vec<usize> = (0..modes.len())
            .filter(|&i| modes[i] != Mode::Open)
            .collect();
        let sticks: Vec<usize> = (0..modes.len())
            .filter(|&i| modes[i] == Mode::Stick)
            .collect();
        let count = n + joints + bears.len() + sticks.len();
        let mut matrix = DMatrix::zeros(count, count);
        let mut right = DVector::zeros(count);
        matrix.view_mut((0, 0), (n, n)).copy_from(self.mass);
        right.rows_mut(0, n).copy_from(&self.h);
        for k in 0..joints {
            for r in 0..n {
                matrix[(r, n + k)] = -self.joints[(k, r)];
                matrix[(n + k, r)] = self.joints[(k, r)];
            }
            right[n + k] = self.j[k];
        }
        for (k, &i) in bears.iter().enumerate() {
            let (b, at) = (&self.bearings[i], n + joints + k);
            let drag = -modes[i].direction() * b.friction;
            for r in 0..n {
                matrix[(r, at)] = -b.normal[r] - drag * b.tangent[r];
                matrix[(at, r)] = b.normal[r];
            }
            right[at] = -b.b;
        }
        for (k, &i) in sticks.iter().enumerate() {
            let (b, at) = (&self.bearings[i], n + joints + bears.len() + k);
            for r in 0..n {
                matrix[(r, at)] = -b.tangent[r];
                matrix[(at, r)] = b.tangent[r];
            }
            right[at] = -b.c;
        }
        let found = solved(matrix, &right)?;
        let mut solution = Solution {
            x: found.rows(0, n).into_owned(),
            modes: modes.to_vec(),
            normal: vec![0.0; modes.len()],
            tangential: vec![0.0; modes.len()],
            joints: found.rows(n, joints).into_owned(),
            rates: Vec::new(),
        };
        for (k, &i) in bears.iter().enumerate() {
            let force = found[n + joints + k];
            solution.normal[i] = force;
            solution.tangential[i] = -modes[i].direction() * self.bearings[i].friction * force;
        }
        for (k, &i) in sticks.iter().enumerate() {
            solution.tangential[i] = found[n + joints + bears.len() + k];
        }
        solution.rates = (self.bearings.iter())
            .map(|b| {
                (
                    b.normal.dot(&solution.x) + b.b,
                    b.tangent.dot(&solution.x) + b.c,
                )
            })
            .collect();
        Some(solution)
    }

    /// What counts as a force, and as an acceleration.
    fn scales(&self, solution: &Solution) -> (f64, f64) {
        let forces = solution.normal.iter().chain(&solution.tangential);
        let force = forces.fold(self.h.amax(), |m, f| m.max(f.abs()));
        let rate = (self.bearings.iter())
            .map(|b| {
                let x = solution.x.iter().zip(b.normal.iter());
                x.map(|(x, n)| (x * n).abs()).sum::<f64>() + b.b.abs() + b.c.abs()
            })
            .fold(f64::MIN_POSITIVE, f64::max);
        (force, rate)
    }

    fn holds(&self, s: &Solution) -> bool {
        let (force, rate) = self.scales(s);
        let (force, rate) = (force * self.zero, rate * self.zero);
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

    fn differs(&self, a: &Solution, b: &Solution) -> bool {
        /// Solutions differ by more than rounding.
        const MORE: f64 = 1e3;
        let scale = a.x.amax().max(b.x.amax());
        (&a.x - &b.x).amax() > MORE * self.zero * scale
    }
}

/// The least solution of linear equations that have one.
fn solved(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    /// Singular values below this share of the largest are none.
    const RANK: f64 = 1e-12;
    /// Equations hold to this share of their terms.
    const HOLDS: f64 = 1e-9;
    if matrix.iter().chain(right.iter()).any(|x| !x.is_finite()) {
        return None;
    }
    // Rows and columns of like size, so that lengths, angles and masses do not hide each other.
    let n = matrix.nrows();
    let scale = |m: &DMatrix<f64>, i: usize| {
        let largest = m.row(i).amax().max(m.column(i).amax());
        if largest > 0.0 {
            largest.sqrt().recip()
        } else {
            1.0
        }
    };
    let scales = DVector::from_fn(n, |i, _| scale(&matrix, i));
    let scaled = DMatrix::from_fn(n, n, |i, k| matrix[(i, k)] * scales[i] * scales[k]);
    let target = DVector::from_fn(n, |i, _| right[i] * scales[i]);
    let found = match scaled.clone().full_piv_lu() {
        lu if lu.is_invertible() && well(&lu) => lu.solve(&target)?,
        _ => {
            let svd = scaled
                .clone()
                .try_svd(true, true, 5.0 * f64::EPSILON, 500)?;
            let least = RANK * svd.singular_values.max();
            svd.solve(&target, least).ok()?
        }
    };
    let off = (&scaled * &found - &target).amax();
    let terms = (scaled.abs() * found.abs()).amax().max(target.amax());
    (off <= HOLDS * terms).then(|| DVector::from_fn(n, |i, _| found[i] * scales[i]))
}

/// Whether the pivots of a decomposition are of like size.
fn well(lu: &nalgebra::FullPivLU<f64, nalgebra::Dyn, nalgebra::Dyn>) -> bool {
    const LIKE: f64 = 1e-11;
    let pivots = lu.u().diagonal().abs();
    pivots.min() > LIKE * pivots.max()
}
