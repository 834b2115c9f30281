//! Pieces that meet with kinks are made tangent, by the least change.
//!
//! A piece with the direction θ of its chord and half its sweep a starts in the direction θ − a and ends in θ + a. Pieces
//! are tangent where θ_j − θ_i = a_i + a_j. The unknowns are the a of arcs and the places of inner joints; Newton's method
//! takes the step of least weight that solves the linearized equations, J W⁻¹ Jᵀ λ = −c with x = W⁻¹ Jᵀ λ, by conjugate
//! gradients.

use core::f64::consts::{PI, TAU};

use cspace::{Point, Vector, Vertex};

use super::bulges::{Tested, allowed};
use super::deviation::range;
use super::divide::{Division, SMOOTH};
use super::fitted::Fitted;
use super::run::{Run, RunEnd};

/// Pieces made tangent, and how far the samples are from them: the least and the largest distance to the left.
#[derive(Debug, Clone)]
pub(super) struct Made {
    pub(super) fitted: Fitted,
    pub(super) range: [f64; 2],
}

/// Newton's method has then doubled its digits often enough, or never will.
const MOST_STEPS: usize = 12;

/// Cost of moving a joint along the curve, as a share of that of moving it across.
const ALONG: f64 = 0.05;

/// The pieces made tangent; with lines for arcs where the band allows, or with arcs alone. None if they cannot be.
pub(super) fn make(run: &Run, division: &Division, with_lines: bool) -> Option<Made> {
    let mut chain = Pieces::new(run, division, with_lines)?;
    for _ in 0..MOST_STEPS {
        let rows = chain.rows();
        if rows.iter().all(|r| r.error.abs() <= SMOOTH) {
            break;
        }
        chain.step(&rows)?;
    }
    let rows = chain.rows();
    let kink = rows.iter().map(|r| r.error.abs()).fold(0.0, f64::max);
    // Pieces that have not converged are no tangent chain.
    if kink.is_nan() || kink > 1e3 * SMOOTH {
        return None;
    }
    let vertices: Vec<Vertex> = (0..chain.half.len())
        .map(|i| {
            let p = chain.joints[i];
            Vertex::new(p.x, p.y, (chain.half[i] / 2.0).tan())
        })
        .collect();
    let end = if run.is_closed {
        chain.joints[0]
    } else {
        chain.joints[chain.half.len()]
    };
    let range = range(run, &division.joints, &vertices, end)?;
    Some(Made {
        fitted: Fitted {
            vertices,
            end,
            deviation: range[1].max(-range[0]),
            kink,
        },
        range,
    })
}

struct Pieces<'r> {
    run: &'r Run,
    /// Joints; for a closed run without the last.
    joints: Vec<Point>,
    /// The normals of the curve there.
    normals: Vec<Vector>,
    /// Half of each sweep.
    half: Vec<f64>,
    is_line: Vec<bool>,
}

/// Equation: its residual, and its coefficients.
struct Row {
    error: f64,
    /// Coefficients of the joints' positions.
    places: Vec<(usize, Vector)>,
    /// Coefficients of the half sweeps.
    halves: Vec<(usize, f64)>,
}

impl<'r> Pieces<'r> {
    fn new(run: &'r Run, division: &Division, with_lines: bool) -> Option<Self> {
        let n = division.bulges.len();
        let count = if run.is_closed { n } else { n + 1 };
        let at = &division.joints[..count];
        let width = run.band.width();
        let tested = Tested::new(run, 1);
        let is_line: Vec<bool> = (division.joints.windows(2))
            .map(|j| {
                with_lines
                    && allowed(run, &tested, j[0], j[1], width)
                        .is_some_and(|(lo, hi)| lo <= 0.0 && hi >= 0.0)
            })
            .collect();
        // Without a line there is nothing to try apart.
        if with_lines && !is_line.contains(&true) {
            return None;
        }
        let half = (division.bulges.iter().zip(&is_line))
            .map(|(b, &line)| if line { 0.0 } else { 2.0 * b.atan() })
            .collect();
        Some(Self {
            run,
            joints: at.iter().map(|&i| run.joint(i)).collect(),
            normals: at.iter().map(|&i| run.normal(i)).collect(),
            half,
            is_line,
        })
    }

    fn next(&self, joint: usize) -> usize {
        (joint + 1) % self.joints.len()
    }

    fn chord(&self, piece: usize) -> Vector {
        self.joints[self.next(piece)] - self.joints[piece]
    }

    /// The change of a chord's direction by its ends.
    fn turn(&self, piece: usize, sign: f64) -> [(usize, Vector); 2] {
        let chord = self.chord(piece);
        let across = chord.left() * (sign / chord.length_squared());
        [(self.next(piece), across), (piece, -across)]
    }

    fn rows(&self) -> Vec<Row> {
        let n = self.half.len();
        let mut rows = Vec::with_capacity(n + 1);
        let inner = if self.run.is_closed { 0..n } else { 1..n };
        for j in inner {
            let i = (j + n - 1) % n;
            let (before, after) = (self.chord(i), self.chord(j));
            let bend = before.cross(after).atan2(before.dot(after));
            let error = bend - self.half[i] - self.half[j];
            let mut places = self.turn(j, 1.0).to_vec();
            places.extend(self.turn(i, -1.0));
            rows.push(Row {
                error: error - TAU * (error / TAU).round(),
                places,
                halves: vec![(i, -1.0), (j, -1.0)],
            });
        }
        if self.run.is_closed {
            return rows;
        }
        for (end, piece, sign) in [(0, 0, -1.0), (1, n - 1, 1.0)] {
            let RunEnd::Along(direction) = self.run.ends[end] else {
                continue;
            };
            let chord = self.chord(piece);
            let bend = direction.cross(chord).atan2(direction.dot(chord));
            rows.push(Row {
                error: bend + sign * self.half[piece],
                places: self.turn(piece, 1.0).to_vec(),
                halves: vec![(piece, sign)],
            });
        }
        rows
    }

    /// Displacement of a joint for a given correction, weighted along and across the curve; 0 at ends.
    fn place_change(&self, joint: usize, by: Vector) -> Vector {
        let is_end = !self.run.is_closed && (joint == 0 || joint + 1 == self.joints.len());
        if is_end {
            return Vector::ZERO;
        }
        let n = self.normals[joint];
        n * n.dot(by) + n.right() * (n.right().dot(by) / ALONG)
    }

    /// As above, for half a sweep, weighted so that the middle of an arc moves as far as its ends.
    fn half_change(&self, piece: usize, by: f64) -> f64 {
        if self.is_line[piece] {
            return 0.0;
        }
        16.0 / self.chord(piece).length_squared() * by
    }

    /// W⁻¹ Jᵀ λ.
    fn change(&self, rows: &[Row], factors: &[f64]) -> (Vec<Vector>, Vec<f64>) {
        let mut places = vec![Vector::ZERO; self.joints.len()];
        let mut halves = vec![0.0; self.half.len()];
        for (row, &factor) in rows.iter().zip(factors) {
            for &(joint, by) in &row.places {
                places[joint] = places[joint] + by * factor;
            }
            for &(piece, by) in &row.halves {
                halves[piece] += by * factor;
            }
        }
        for (joint, by) in places.iter_mut().enumerate() {
            *by = self.place_change(joint, *by);
        }
        for (piece, by) in halves.iter_mut().enumerate() {
            *by = self.half_change(piece, *by);
        }
        (places, halves)
    }

    /// J W⁻¹ Jᵀ λ.
    fn product(&self, rows: &[Row], factors: &[f64]) -> Vec<f64> {
        let (places, halves) = self.change(rows, factors);
        (rows.iter())
            .map(|row| {
                let by_places: f64 = row.places.iter().map(|&(j, v)| v.dot(places[j])).sum();
                let by_halves: f64 = row.halves.iter().map(|&(p, h)| h * halves[p]).sum();
                by_places + by_halves
            })
            .collect()
    }

    fn step(&mut self, rows: &[Row]) -> Option<()> {
        let factors = self.solve(rows);
        let (places, halves) = self.change(rows, &factors);
        // A step is no more than pieces are long.
        let shortest = (0..self.half.len())
            .map(|i| self.chord(i).length())
            .fold(f64::INFINITY, f64::min);
        let longest = places.iter().map(|v| v.length()).fold(0.0, f64::max);
        let most = halves.iter().map(|h| h.abs()).fold(0.0, f64::max);
        let share = (0.4 * shortest / longest).min(0.5 / most).min(1.0);
        if !share.is_finite() || longest.is_nan() {
            return None;
        }
        for (joint, by) in self.joints.iter_mut().zip(places) {
            *joint += by * share;
        }
        for (half, by) in self.half.iter_mut().zip(halves) {
            *half += by * share;
        }
        (self.half.iter().all(|h| h.abs() < PI)).then_some(())
    }

    /// λ of J W⁻¹ Jᵀ λ = −c, scaled by its diagonal.
    fn solve(&self, rows: &[Row]) -> Vec<f64> {
        let n = rows.len();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let diagonal: Vec<f64> = (rows.iter())
            .map(|row| {
                let places: f64 = (row.places.iter())
                    .map(|&(j, v)| v.dot(self.place_change(j, v)))
                    .sum();
                let halves: f64 = row
                    .halves
                    .iter()
                    .map(|&(p, h)| h * self.half_change(p, h))
                    .sum();
                (places + halves).max(f64::MIN_POSITIVE)
            })
            .collect();
        let scaled = |r: &[f64]| {
            r.iter()
                .zip(&diagonal)
                .map(|(r, d)| r / d)
                .collect::<Vec<f64>>()
        };
        let mut factors = vec![0.0; n];
        let mut rest: Vec<f64> = rows.iter().map(|r| -r.error).collect();
        let mut search = scaled(&rest);
        let mut now = dot(&rest, &search);
        let goal = 1e-28 * now;
        for _ in 0..4 * n + 10 {
            if now.is_nan() || now <= goal {
                break;
            }
            let image = self.product(rows, &search);
            let curvature = dot(&search, &image);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let length = now / curvature;
            for i in 0..n {
                factors[i] += length * search[i];
                rest[i] -= length * image[i];
            }
            let next = scaled(&rest);
            let then = dot(&rest, &next);
            for i in 0..n {
                search[i] = next[i] + then / now * search[i];
            }
            now = then;
        }
        factors
    }
}
