//! The questions put to one contact space.

use core::f64::consts::{PI, TAU};

use cspace::{Configuration, ContactSpace, Edge, Part, Point, Slice, Slicer, Vector};
use cspace_oracle::{Case, Oracle, Verdict, near_contact_about};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::report::{Fault, Report, is_right};

/// Margin above which a verdict counts, as a share of the pair's size.
pub(crate) const CERTAIN: f64 = 1e-10;

/// Roundings of a configuration and of where the parts are drawn that may add up, as a share of their coordinates.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// Distances from contact, as shares of the size.
const STEPS: [f64; 6] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Positions asked at each orientation.
const POSITIONS: usize = 20;

/// Share of the configurations that are searched for along random motions, so that the space is not asked where contact
/// is.
const SEARCHED: f64 = 0.1;

/// Bands narrower than this (radians) are not sliced from scratch: slices see ties within their own rounding, and take the
/// slice a little above.
const NARROW: f64 = 1e-7;

/// Largest distance between the curves of a loop, as a share of the size: curves that nearly touch cross at a place
/// known only to the square root of the rounding, and the library's documented error is 1e-6.
const CLOSED: f64 = 1e-6;

/// One of so many configurations that the slice classifies correctly is also classified by the space, which makes a
/// slice of its own.
const CLASSIFIED: u64 = 8;

/// Configurations kept for further checks.
const KEPT: usize = 200;

/// Check of one contact space.
pub(crate) struct Trial<'a> {
    pub(crate) case: &'a Case,
    pub(crate) space: &'a ContactSpace,
    pub(crate) slicer: &'a Slicer,
    pub(crate) oracle: Oracle,
    pub(crate) rng: &'a mut ChaCha8Rng,
    pub(crate) report: &'a mut Report,
    pub(crate) kept: Vec<(Configuration, Verdict)>,
}

impl Trial<'_> {
    /// Asks about `n` configurations.
    pub(crate) fn configurations(&mut self, n: usize) {
        let searched = (n as f64 * SEARCHED) as usize;
        let about = &self.case.notable;
        for near in near_contact_about(&self.oracle, about, self.rng, searched) {
            let c = near.configuration;
            let window = self.space.window();
            if window.full_turn || (window.lo..=window.hi).contains(&c.theta) {
                let slice = self.of_space(c.theta);
                self.judged(&slice, c, near.verdict, true);
            }
        }
        for i in 0..(n - searched).div_ceil(POSITIONS) {
            let theta = self.orientation(i);
            let slice = self.of_space(theta);
            for k in 0..POSITIONS {
                let (p, near) = match k % 5 {
                    0 | 1 => (self.beside_a_curve(&slice), true),
                    2 | 3 => (self.beside_a_contact(theta), true),
                    _ => (Some(self.anywhere(theta)), false),
                };
                self.ask(&slice, p, near);
            }
        }
    }

    /// Compares slices in the middle of bands with slices from scratch: their numbers of loops, and positions beside
    /// their curves.
    pub(crate) fn bands(&mut self, most: usize) {
        let bands = self.space.bands();
        let step = bands.len().div_ceil(most.max(1)).max(1);
        for band in bands
            .iter()
            .skip(self.rng.random_range(0..step))
            .step_by(step)
        {
            let (theta, width) = (0.5 * (band.lo + band.hi), band.hi - band.lo);
            if width < NARROW {
                continue;
            }
            self.report.bands += 1;
            let slice = self.of_space(theta);
            let scratch = self.slicer.slice(theta);
            // Where the space has lost a curve it is not asked beside its own.
            for _ in 0..POSITIONS {
                let p = self.beside_a_curve(&scratch);
                if let Some((at, verdict)) = self.ask(&slice, p, true)
                    && !scratch.doubtful
                    && verdict.margin > self.space.resolution()
                    && scratch.is_free(at.position()) == verdict.overlap
                {
                    self.report.faults.push(Fault::Scratch { at, verdict });
                }
            }
            if slice.doubtful || scratch.doubtful {
                self.report.doubtful_bands += 1;
            } else if slice.loops.len() != scratch.loops.len() {
                self.report.faults.push(Fault::Loops {
                    theta,
                    space: slice.loops.len(),
                    scratch: scratch.loops.len(),
                    width,
                });
            }
        }
    }

    /// The slice of the space, which must be closed.
    fn of_space(&mut self, theta: f64) -> Slice {
        let slice = self.space.slice(theta);
        self.report.slices += 1;
        self.report.doubtful_slices += u64::from(slice.doubtful);
        if !slice.doubtful {
            self.closed(&slice);
        }
        slice
    }

    fn closed(&mut self, slice: &Slice) {
        let gap = |c: &cspace::SliceCurve| {
            let next = slice.curves.get(c.next as usize);
            next.map_or(f64::INFINITY, |n| {
                c.geometry.point(1.0).distance(n.geometry.point(0.0))
            })
        };
        let gap = slice.curves.iter().map(gap).fold(0.0, f64::max) / self.oracle.size();
        let drawn = self.drawn() / self.oracle.size();
        if gap > CLOSED + ROUNDINGS * drawn {
            let theta = slice.theta;
            self.report.faults.push(Fault::Open { theta, gap });
        }
    }

    /// Distance of the parts from their origins.
    fn drawn(&self) -> f64 {
        let (f, m) = (self.oracle.fixed_center(), self.oracle.moving_center());
        f.to_vector().length() + m.to_vector().length()
    }

    /// Checks a position; returns the oracle's verdict, if that is certain.
    fn ask(
        &mut self,
        slice: &Slice,
        p: Option<Point>,
        near: bool,
    ) -> Option<(Configuration, Verdict)> {
        let p = p.filter(|p| p.is_finite())?;
        let c = Configuration::new(p.x, p.y, slice.theta);
        let verdict = self.oracle.judge(c);
        self.judged(slice, c, verdict, near).then_some((c, verdict))
    }

    /// Compares a verdict; returns whether it counts.
    fn judged(&mut self, slice: &Slice, c: Configuration, verdict: Verdict, near: bool) -> bool {
        self.report.asked += 1;
        let size = self.oracle.size();
        let rounding = ROUNDINGS * (c.x.abs() + c.y.abs() + self.drawn());
        if verdict.margin <= CERTAIN * size + rounding {
            return false;
        }
        self.report.certain += 1;
        self.report.near += u64::from(near);
        self.report.free += u64::from(!verdict.overlap);
        if self.kept.len() < KEPT && self.rng.random_bool(0.5) {
            self.kept.push((c, verdict));
        }
        let slice_right = slice.is_free(c.position()) != verdict.overlap;
        if slice_right && !self.report.certain.is_multiple_of(CLASSIFIED) {
            return true;
        }
        let right = is_right(self.space, c, verdict);
        if slice_right && right {
            return true;
        }
        if verdict.margin <= self.space.resolution() {
            self.report.within_resolution += 1;
        } else if !right || !slice.doubtful {
            self.report.faults.push(Fault::Wrong { at: c, verdict });
        } else {
            self.report.doubtful_wrong += 1;
        }
        true
    }

    /// Random orientation: anywhere, near critical ones, at multiples of 15°, or near notable configurations.
    fn orientation(&mut self, i: usize) -> f64 {
        let window = self.space.window();
        let criticals = self.space.critical_orientations();
        let theta = match i % 4 {
            1 if !criticals.is_empty() => {
                let about = criticals[self.rng.random_range(0..criticals.len())];
                about + 10f64.powf(self.rng.random_range(-9.0..-3.0)) * self.sign()
            }
            2 => {
                let tie = f64::from(self.rng.random_range(-12..=12)) * (PI / 12.0);
                let off = self.rng.random_bool(0.7);
                let by = 10f64.powf(self.rng.random_range(-9.0..-1.0)) * self.sign();
                tie + if off { by } else { 0.0 }
            }
            3 if !self.case.notable.is_empty() => {
                let n = self.rng.random_range(0..self.case.notable.len());
                let by = 10f64.powf(self.rng.random_range(-9.0..0.0)) * self.sign();
                self.case.notable[n].theta + by
            }
            _ => self.rng.random_range(window.lo..window.hi),
        };
        if window.full_turn || (window.lo..=window.hi).contains(&theta) {
            return theta;
        }
        let turned = window.lo + (theta - window.lo).rem_euclid(TAU);
        if turned <= window.hi {
            turned
        } else {
            self.rng.random_range(window.lo..window.hi)
        }
    }

    fn sign(&mut self) -> f64 {
        if self.rng.random_bool(0.5) { 1.0 } else { -1.0 }
    }

    fn step(&mut self) -> f64 {
        STEPS[self.rng.random_range(0..STEPS.len())] * self.sign() * self.oracle.size()
    }

    /// A position beside a curve of a slice.
    fn beside_a_curve(&mut self, slice: &Slice) -> Option<Point> {
        if slice.curves.is_empty() {
            return self.beside_a_contact(slice.theta);
        }
        let curve = slice.curves[self.rng.random_range(0..slice.curves.len())].geometry;
        let s = self.rng.random_range(0.0..1.0);
        Some(curve.point(s) + curve.free_normal(s) * self.step())
    }

    /// Position with a corner of one part beside an edge of the other, found without asking the space.
    fn beside_a_contact(&mut self, theta: f64) -> Option<Point> {
        let on_fixed = self.rng.random_bool(0.5);
        let s = self.rng.random_range(0.0..1.0);
        let (u, v) = if on_fixed { (s, 0.0) } else { (0.0, s) };
        let e = some_edge(&self.case.fixed, self.rng)?;
        let f = some_edge(&self.case.moving, self.rng)?;
        let touching = carrying(f.at(v), e.at(u), theta);
        let normal = if on_fixed {
            e.direction_at(u).right()
        } else {
            cspace::Rotation::by(theta) * f.direction_at(v).left()
        };
        Some(touching + normal * self.step())
    }

    fn anywhere(&mut self, theta: f64) -> Point {
        let size = self.oracle.size();
        let notable = &self.case.notable;
        let (about, reach) = if !notable.is_empty() && self.rng.random_bool(0.5) {
            let n = self.rng.random_range(0..notable.len());
            let reach = 10f64.powf(self.rng.random_range(-6.0..0.0));
            (notable[n].position(), reach)
        } else {
            let middle = carrying(
                self.oracle.moving_center(),
                self.oracle.fixed_center(),
                theta,
            );
            (middle, 1.0)
        };
        let mut share = || reach * size * self.rng.random_range(-1.0..1.0);
        about + Vector::new(share(), share())
    }
}

fn some_edge(part: &Part, rng: &mut ChaCha8Rng) -> Option<Edge> {
    let n = part.edges().count();
    part.edges().nth(rng.random_range(0..n))
}

/// The position that takes a point of the moving part to one of the fixed part.
fn carrying(q: Point, to: Point, theta: f64) -> Point {
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(q);
    Point::ORIGIN + (to - turned)
}
