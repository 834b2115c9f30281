//! Checker of proofs that there is no path between two configurations of planar parts.
//!
//! A [`Proof`] is a surface of triangles in (x, y, θ). [`Proof::check`] verifies, by interval arithmetic and from the file alone:
//!
//! 1. Each *witness*, a disc in the moving part's frame and one in the fixed part's, lies within the parts' material, in layers that overlap
//!    in height.
//! 2. At **every** configuration of a triangle the two discs of its witness overlap, and so do the parts. With q the moving disc's
//!    centre from the pivot and c the other's, the vector v = (x, y) + `R_θ` q − c differs by at most |q| Δθ²/8 from its linear
//!    interpolation between the corners, Δθ the range of θ in the triangle, because |d²v/dθ²| = |q|. So |v| is at most its greatest
//!    value at the corners plus |q| Δθ²/8, and that has to be less than the sum of the radii.
//! 3. The surface is *closed*: each edge is traversed equally often in both directions.
//! 4. Its *winding numbers* around the start and around the goal differ: signed crossings of a ray are counted.
//!
//! Then every motion from start to goal passes the surface, because H₂(R²×S¹) = 0: a closed surface bounds a chain of solids, and how
//! often it covers a configuration changes only at the surface. With a window of orientations [a, b] the surface may be open at its
//! ends; H₂(R²×[a, b], R²×{a, b}) = 0, and the same holds for motions within the window.

mod interval;
mod part;

use std::collections::HashMap;
use std::ops::Range;

use interval::{I, PI, exact};
use part::norm;
pub use part::{Layer, Part};
use serde::{Deserialize, Serialize};

/// A proof that no motion leads from start to goal. Angles are in radians.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Proof {
    /// The version of the format: 1.
    #[cfg_attr(feature = "schema", schemars(extend("const" = 1)))]
    pub version: u32,
    /// The label of the unit of length.
    pub unit: Option<String>,
    /// The fixed part.
    pub fixed: Part,
    /// The moving part: at (x, y, θ) its point q is at (x, y) + `R_θ` q.
    pub moving: Part,
    /// First and last orientation; none for all.
    pub window: Option<[f64; 2]>,
    /// Start configuration x, y, θ.
    pub start: [f64; 3],
    /// Goal configuration x, y, θ.
    pub goal: [f64; 3],
    /// Approximate penetration of the parts on the surface; stated, not checked.
    pub depth: f64,
    /// A point of the moving part, in its frame.
    pub pivot: [f64; 2],
    /// Position of the pivot, and θ.
    pub vertices: Vec<[f64; 3]>,
    /// Three vertices, the turns added to the θ of each, and a witness.
    pub triangles: Vec<[i64; 7]>,
    /// Centre and radius of a disc of the moving part's material, in its frame, and of one of the fixed part's.
    pub witnesses: Vec<[f64; 6]>,
}

/// Reads a proof from JSON: what `cspace plan --proof` writes, or the key `proof` of the pair in an answer of `cspace plan`.
///
/// # Errors
/// If the JSON is not a proof.
pub fn read(json: &[u8]) -> Result<Proof, String> {
    let mut value: serde_json::Value = serde_json::from_slice(json).map_err(|e| e.to_string())?;
    if let Some(answer) = value.pointer_mut("/pairs/0") {
        value = answer.take();
    }
    let inner = value.get_mut("proof").map(serde_json::Value::take);
    if let (None, Some(verdict)) = (&inner, value["verdict"].as_str()) {
        let why = value["unproved"].as_str().map(|why| format!(" ({why})"));
        let why = why.unwrap_or_default();
        return Err(format!(
            "this answer holds no proof: its verdict is {verdict}{why}"
        ));
    }
    serde_json::from_value(inner.unwrap_or(value)).map_err(|e| e.to_string())
}

/// A vertex with what does not depend on turns.
struct Corner {
    at: [I; 2],
    theta: f64,
    turn: (I, I),
}

fn rotated((sin, cos): (I, I), q: [I; 2]) -> [I; 2] {
    [cos * q[0] - sin * q[1], sin * q[0] + cos * q[1]]
}

fn turned(theta: f64, turns: i64) -> I {
    if turns == 0 {
        return exact(theta);
    }
    exact(theta) + PI * exact(2.0 * turns as f64)
}

/// Six times the volume of a tetrahedron: positive if the last sees the others counter-clockwise or clockwise, always the same.
fn volume(a: [I; 3], b: [I; 3], c: [I; 3], d: [I; 3]) -> I {
    let [u, v, w] = [a, b, c].map(|p| [0, 1, 2].map(|k| p[k] - d[k]));
    u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
}

impl Proof {
    /// Checks the proof.
    ///
    /// # Errors
    /// Describes the error, and the triangle, vertex or witness concerned, counted from 0.
    pub fn check(&self) -> Result<(), String> {
        let finite = |x: &f64| x.is_finite() && x.abs() < 1e100;
        let loops = self.fixed.loops.iter().chain(&self.moving.loops);
        let points = loops.flatten().chain(&self.vertices);
        let mut numbers = (points.chain([&self.start, &self.goal]).flatten())
            .chain(self.witnesses.iter().flatten())
            .chain(self.pivot.iter().chain(self.window.iter().flatten()));
        if self.version != 1 || !numbers.all(finite) {
            return Err("version 1 with finite numbers is what can be checked".into());
        }
        for (i, t) in self.triangles.iter().enumerate() {
            let known = |v: i64, n: usize| usize::try_from(v).is_ok_and(|v| v < n);
            let vertices = t[..3].iter().all(|&v| known(v, self.vertices.len()));
            let turns = t[3..6].iter().all(|k| (-999..1000).contains(k));
            let flat = self.window.is_none() || t[3..6] == [0; 3];
            if !(vertices && turns && flat && known(t[6], self.witnesses.len())) {
                return Err(format!("triangle {i} names what there is not"));
            }
        }
        let (fixed, moving) = (self.fixed.stack()?, self.moving.stack()?);
        for (i, &[qx, qy, r, cx, cy, s]) in self.witnesses.iter().enumerate() {
            // The layers that each disc is within.
            let hold = |part: &Part, stack: &[(Layer, Range<usize>)], center, radius: f64| {
                let within = |(_, loops): &&(Layer, Range<usize>)| {
                    radius > 0.0 && radius <= part.room(loops.clone(), center)
                };
                let found: Vec<Layer> = stack.iter().filter(within).map(|l| l.0).collect();
                match found[..] {
                    [] => Err(format!("witness {i}: its disc is not within {}", part.name)),
                    _ => Ok(found),
                }
            };
            let of_moving = hold(&self.moving, &moving, [qx, qy], r)?;
            let of_fixed = hold(&self.fixed, &fixed, [cx, cy], s)?;
            if !(of_fixed.iter()).any(|f| of_moving.iter().any(|m| f.meets(m))) {
                return Err(format!("witness {i}: its discs are at different heights"));
            }
        }
        let corners: Vec<Corner> = (self.vertices.iter())
            .map(|&[x, y, theta]| Corner {
                at: [exact(x), exact(y)],
                theta,
                turn: I::sin_cos(theta),
            })
            .collect();
        self.overlaps(&corners)?;
        self.closed()?;
        let [start, goal] = [("start", self.start), ("goal", self.goal)]
            .map(|(name, at)| self.winding(name, at, &corners));
        let (start, goal) = (start?, goal?);
        if start == goal {
            return Err(format!(
                "the surface winds {start} times around both start and goal"
            ));
        }
        Ok(())
    }

    fn overlaps(&self, corners: &[Corner]) -> Result<(), String> {
        for (i, t) in self.triangles.iter().enumerate() {
            let [qx, qy, r, cx, cy, s] = self.witnesses[t[6] as usize].map(exact);
            let q = [qx - exact(self.pivot[0]), qy - exact(self.pivot[1])];
            let mut farthest = 0.0_f64;
            let mut range = (f64::INFINITY, f64::NEG_INFINITY);
            for k in 0..3 {
                let corner = &corners[t[k] as usize];
                let q = rotated(corner.turn, q);
                let v = [corner.at[0] + q[0] - cx, corner.at[1] + q[1] - cy];
                farthest = farthest.max(norm(v).hi);
                let theta = turned(corner.theta, t[k + 3]);
                range = (range.0.min(theta.lo), range.1.max(theta.hi));
            }
            if range.1 - range.0 > 3.0 {
                return Err(format!("triangle {i} turns too far"));
            }
            let bend = norm(q) * (exact(range.1) - exact(range.0)).square() * exact(0.125);
            if (exact(farthest) + bend - r - s).sign() != Some(false) {
                return Err(format!(
                    "triangle {i}: its witness does not overlap in all of it"
                ));
            }
        }
        Ok(())
    }

    fn closed(&self) -> Result<(), String> {
        let mut edges: HashMap<(i64, i64, i64), (i64, usize)> = HashMap::new();
        for (i, t) in self.triangles.iter().enumerate() {
            for (j, k) in [(0, 1), (1, 2), (2, 0)] {
                let (a, b, turns) = (t[j], t[k], t[k + 3] - t[j + 3]);
                let (key, way) = match (a, 0).cmp(&(b, turns)) {
                    core::cmp::Ordering::Less => ((a, b, turns), 1),
                    core::cmp::Ordering::Equal => continue,
                    core::cmp::Ordering::Greater => ((b, a, -turns), -1),
                };
                let entry = edges.entry(key).or_insert((0, i));
                entry.0 += way;
            }
        }
        for ((a, b, _), (sum, i)) in edges {
            let theta = |v: i64| self.vertices[v as usize][2];
            let at_end = self.window.is_some_and(|[lo, hi]| {
                theta(a).max(theta(b)) <= lo || theta(a).min(theta(b)) >= hi
            });
            if sum != 0 && !at_end {
                return Err(format!(
                    "triangle {i}: its edge from vertex {a} to {b} is open"
                ));
            }
        }
        Ok(())
    }

    /// Winding number of the surface around a configuration.
    fn winding(&self, name: &str, at: [f64; 3], corners: &[Corner]) -> Result<i64, String> {
        let arm = rotated(I::sin_cos(at[2]), self.pivot.map(exact));
        let middle = self.window.map_or(at[2], |[lo, hi]| 0.5 * (lo + hi));
        let turns = ((middle - at[2]) / core::f64::consts::TAU).round() as i64;
        let theta = turned(at[2], turns);
        if (self.window).is_some_and(|[lo, hi]| theta.hi < lo || theta.lo > hi) {
            return Err(format!("the {name} is not in the window"));
        }
        let from = [exact(at[0]) + arm[0], exact(at[1]) + arm[1], theta];
        let reach = (self.vertices.iter()).fold(from[0].abs().hi + from[1].abs().hi, |m, v| {
            m.max(v[0].abs() + v[1].abs())
        });
        for ray in 0..64 {
            let (sin, cos) = (2.4 * f64::from(ray) + 0.3).sin_cos();
            let mut end = theta.lo + 0.2 * (1.7 * f64::from(ray) + 1.0).sin();
            if let Some([lo, hi]) = self.window {
                end = end.max(lo).min(hi);
            }
            let to = [4.0 * reach * cos, 4.0 * reach * sin, end].map(exact);
            if let Some(crossings) = self.crossings(from, to, corners) {
                return Ok(crossings);
            }
        }
        Err(format!("the {name} is on the surface, or too near to it"))
    }

    /// Signed crossings of a segment with the surface and its copies by whole turns; none if one is not certain.
    fn crossings(&self, from: [I; 3], to: [I; 3], corners: &[Corner]) -> Option<i64> {
        let (low, high) = (from[2].lo.min(to[2].lo), from[2].hi.max(to[2].hi));
        let mut sum = 0;
        for t in &self.triangles {
            let height =
                |k: usize, more: i64| turned(corners[t[k] as usize].theta, t[k + 3] + more);
            let nearest = ((low - height(0, 0).lo) / core::f64::consts::TAU).round() as i64;
            let copies = if self.window.is_some() {
                0..=0
            } else {
                nearest - 1..=nearest + 1
            };
            for more in copies {
                let p = [0, 1, 2].map(|k| {
                    let [x, y] = corners[t[k] as usize].at;
                    [x, y, height(k, more)]
                });
                if p.iter().all(|p| p[2].hi < low) || p.iter().all(|p| p[2].lo > high) {
                    continue;
                }
                let sides =
                    [(0, 1), (1, 2), (2, 0)].map(|(j, k)| volume(from, to, p[j], p[k]).sign());
                let ends = [from, to].map(|end| volume(p[0], p[1], p[2], end).sign());
                let both = |s: &[Option<bool>]| s.contains(&Some(true)) && s.contains(&Some(false));
                if both(&sides) || (ends[0].is_some() && ends[0] == ends[1]) {
                    continue;
                }
                if sides.contains(&None) || ends.contains(&None) {
                    return None;
                }
                sum += if ends[0] == Some(true) { 1 } else { -1 };
            }
        }
        Some(sum)
    }
}
