//! Triangles that know their neighbours, with vertices on the circle of orientations.

use std::collections::HashMap;

use core::f64::consts::TAU;

use cspace::PatchId;

/// A triangle: its vertices, the turns added to the orientation of each, the patch it comes from, and its witness.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Triangle {
    pub(crate) vertices: [u32; 3],
    pub(crate) turns: [i32; 3],
    pub(crate) patch: PatchId,
    pub(crate) witness: Option<u32>,
}

/// Edge, common to all its triangles: two vertices, and the turns of the second relative to the first.
type Edge = (u32, u32, i32);

/// A surface of triangles.
#[derive(Debug, Default)]
pub(crate) struct Complex {
    /// x, y, θ.
    pub(crate) vertices: Vec<[f64; 3]>,
    pub(crate) triangles: Vec<Triangle>,
    edges: HashMap<Edge, Vec<u32>>,
}

impl Triangle {
    fn edge(&self, k: usize) -> Edge {
        let (a, b) = (k, (k + 1) % 3);
        let turns = self.turns[b] - self.turns[a];
        let (v, w) = (self.vertices[a], self.vertices[b]);
        if (v, 0) < (w, turns) {
            (v, w, turns)
        } else {
            (w, v, -turns)
        }
    }
}

impl Complex {
    /// Adds a triangle; one without extent is left out.
    pub(crate) fn add(&mut self, t: Triangle) {
        let corner = |k: usize| (t.vertices[k], t.turns[k]);
        if corner(0) == corner(1) || corner(1) == corner(2) || corner(2) == corner(0) {
            return;
        }
        let number = self.triangles.len() as u32;
        self.triangles.push(t);
        self.enter(number);
    }

    fn enter(&mut self, number: u32) {
        for k in 0..3 {
            let edge = self.triangles[number as usize].edge(k);
            self.edges.entry(edge).or_default().push(number);
        }
    }

    fn leave(&mut self, number: u32) {
        for k in 0..3 {
            let edge = self.triangles[number as usize].edge(k);
            if let Some(of) = self.edges.get_mut(&edge) {
                of.retain(|&t| t != number);
                if of.is_empty() {
                    self.edges.remove(&edge);
                }
            }
        }
    }

    /// The corners, orientations unrolled.
    pub(crate) fn corners(&self, t: &Triangle) -> [[f64; 3]; 3] {
        core::array::from_fn(|k| {
            let [x, y, theta] = self.vertices[t.vertices[k] as usize];
            [x, y, theta + TAU * f64::from(t.turns[k])]
        })
    }

    /// The length of an edge, a radian as long as `lever`.
    fn length(&self, (a, b, turns): Edge, lever: f64) -> f64 {
        let [p, q] = [a, b].map(|v| self.vertices[v as usize]);
        let turn = q[2] - p[2] + TAU * f64::from(turns);
        (p[0] - q[0]).hypot(p[1] - q[1]).hypot(turn * lever)
    }

    fn longest(&self, number: u32, lever: f64) -> (Edge, f64) {
        let t = self.triangles[number as usize];
        let edges = [0, 1, 2].map(|k| (t.edge(k), self.length(t.edge(k), lever)));
        let [a, b, c] = edges;
        let more = if b.1 > a.1 { b } else { a };
        if c.1 > more.1 { c } else { more }
    }

    /// Bisects an edge and all triangles at it, as part of bisecting a triangle at its longest edge: a neighbour with a
    /// longer one comes first, so that triangles do not become ever narrower (Rivara). Returns the numbers of these and
    /// the new triangles.
    pub(crate) fn halve(&mut self, number: u32, lever: f64) -> Vec<u32> {
        let (mut edge, mut length) = self.longest(number, lever);
        while let Some(longer) = (self.edges.get(&edge).into_iter().flatten())
            .map(|&t| self.longest(t, lever))
            .find(|&(_, l)| l > length)
        {
            (edge, length) = longer;
        }
        let (a, b, turns) = edge;
        let [p, q] = [a, b].map(|v| self.vertices[v as usize]);
        let middle = self.vertices.len() as u32;
        let theta = if turns == 0 {
            0.5 * (p[2] + q[2])
        } else {
            0.5 * (p[2] + q[2] + TAU * f64::from(turns))
        };
        self.vertices
            .push([0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), theta]);
        let mut touched = self.edges.get(&edge).cloned().unwrap_or_default();
        for i in 0..touched.len() {
            let number = touched[i];
            self.leave(number);
            let t = self.triangles[number as usize];
            // The corner before the edge's first end, in the order of the triangle.
            let Some(k) = (0..3).find(|&k| t.edge(k) == edge) else {
                continue;
            };
            let l = (k + 1) % 3;
            // The middle has the turns of the edge's first vertex.
            let base =
                if (t.vertices[k], t.turns[l] - t.turns[k]) == (a, turns) && t.vertices[l] == b {
                    t.turns[k]
                } else {
                    t.turns[l]
                };
            let (mut first, mut second) = (t, t);
            (first.vertices[l], first.turns[l]) = (middle, base);
            (second.vertices[k], second.turns[k]) = (middle, base);
            self.triangles[number as usize] = first;
            self.enter(number);
            touched.push(self.triangles.len() as u32);
            self.triangles.push(second);
            self.enter(self.triangles.len() as u32 - 1);
        }
        touched
    }
}
