//! Makes loops generic: smooth joints exactly smooth, and no coincidences with other loops.
//!
//! In a drawing, smooth joints are smooth up to the rounding of its numbers, and lengths are equal by design. [`made_generic`] moves the
//! vertices and arcs of a loop by requested lengths, and then by the smallest displacements that make its joints smooth in double-double.
//!
//! # Unknowns
//!
//! A smooth vertex moves by t along the direction of travel and by n to the left of it; any other vertex moves by (x, y).
//! With chord L, bulge b = tan(h/2) and half the sweep h, an edge bends by κ = 2 sin h / L. When its ends move by d₀ and d₁,
//! where it leaves along T₀ and arrives along T₁, its bulge changes by
//!
//! db = (b/L) (T₁·d₁ − T₀·d₀) + 2σ/L.
//!
//! So an edge whose ends slide along it stays on its carrier; the middle of one whose ends move by n₀ and n₁ moves by
//! (n₀ + n₁)/2 + σ, and σ is the third unknown of an arc. A line has none.
//!
//! # Equations
//!
//! The chord of edge i has direction θᵢ; the edge leaves along θᵢ − hᵢ and arrives along θᵢ + hᵢ. At a smooth joint the residual ρᵢ = (θᵢ −
//! hᵢ) − (θᵢ₋₁ + hᵢ₋₁) is zero. Sliding a vertex by t changes ρᵢ by (κᵢ − κᵢ₋₁) t, and no other residual: a kink δ of a line and an arc of
//! radius r needs a slide of r δ, which changes the outline by r δ²/2 only. A lateral displacement instead would change it by δ times the
//! length of an edge. Therefore slides are cheap.
//!
//! The smallest change is W Jᵀ λ with (J W Jᵀ) λ = −ρ, where J has the derivatives of ρ and W the weights. Joint i is coupled with joints i
//! ± 1 and i ± 2; in the order 0, n−1, 1, n−2, … a closed loop is a band of half width 4, which is factored as L D Lᵀ. Dependent rows are
//! left out: two arcs that make a circle are smooth at both joints or at neither.

mod least;
mod side;

use crate::feature::tolerance::{
    LARGEST_PART, MOST_WISHES, NEGLIGIBLE, SAGITTA_PART, STRAIGHT, WISHED_PART,
};
use crate::geometry::{Point, Vector};
use crate::number::Dd;
use crate::part::{Edge, Vertex};

use least::least_moves;
pub(crate) use side::edge_from;
use side::{Knot, Side, knots, sides, vector};

/// Residual below which a joint is smooth (2⁻⁹⁹ ≈ 1.6e-30), apart from the rounding of coordinates.
const RESIDUAL: f64 = 1.0 / (1u128 << 99) as f64;
/// The rounding of a coordinate, relative to the largest (2⁻¹⁰⁷).
const ROUNDING: f64 = 1.0 / (1u128 << 107) as f64;
/// Maximum number of steps of Newton's method.
const MOST_STEPS: usize = 16;

/// Moves a closed loop by a generic small amount so that its smooth joints are exactly smooth (in double-double).
///
/// `drawn[i]` is the start of edge i and its bulge; 0 for a line, which remains a line. `smooth[i]` states whether edges i − 1 and i meet
/// smoothly there. `wish[i]` has the requested displacements of vertex i (x, y) and of the sagitta of arc i; they are reduced for short
/// edges, and for arcs with little curvature.
///
/// `None` if the input is not a loop (fewer than two edges, or one without length), if no smooth loop is found nearby, if a vertex would
/// move by more than 1/32 of an edge, or if the outline would move laterally by more than admitted: four times the longest requested
/// displacement, 1.1e-13, the second-order change by sliding, and the deviation of the pieces of one line from it.
pub(crate) fn made_generic(
    drawn: &[Vertex<Dd>],
    smooth: &[bool],
    wish: &[[f64; 3]],
) -> Option<Vec<Vertex<Dd>>> {
    let n = drawn.len();
    if n < 2 || smooth.len() != n || wish.len() != n {
        return None;
    }
    let sides = sides(drawn)?;
    let knots = knots(&sides, smooth);
    let moved = moved(drawn, &sides, &knots, &lessened(wish, &sides, &knots));
    let (result, _) = smoothed(moved, smooth)?;
    is_near(drawn, &sides, &knots, &result, wish).then_some(result)
}

/// Requested displacements as unknowns of the equations, limited by the lengths of the edges.
fn lessened(wish: &[[f64; 3]], sides: &[Side], knots: &[Knot]) -> Vec<[f64; 3]> {
    let part = |wished: f64, most: f64| {
        if wished > most { most / wished } else { 1.0 }
    };
    (wish.iter().zip(sides).zip(knots))
        .map(|((wish, side), knot)| {
            let by = Vector::new(wish[0], wish[1]);
            let most = WISHED_PART * knot.shortest;
            let by = by * (knot.opening * part(by.length(), most));
            let most = (WISHED_PART * side.chord).min(SAGITTA_PART * side.sagitta());
            let sagitta = wish[2] * part(wish[2].abs(), most);
            [by.dot(knot.axes[0]), by.dot(knot.axes[1]), sagitta]
        })
        .collect()
}

/// Vertices moved by the unknowns.
///
/// Sliding is along the carriers, to second order: a smooth vertex moves by t along a circle of the mean curvature, and the sweep of an
/// edge grows by κ times its growth in length; x = κ (T₁·d₁ − T₀·d₀) / 4 is added to a quarter of it: b' = (b + tan x) / (1 − b tan x).
fn moved(
    vertices: &[Vertex<Dd>],
    sides: &[Side],
    knots: &[Knot],
    moves: &[[f64; 3]],
) -> Vec<Vertex<Dd>> {
    let n = vertices.len();
    let by = |i: usize| knots[i].axes[0] * moves[i][0] + knots[i].axes[1] * moves[i][1];
    (0..n)
        .map(|i| {
            let (vertex, side, knot) = (&vertices[i], &sides[i], &knots[i]);
            let here = by(i);
            let bend = if knot.smooth {
                0.5 * knot.bend * moves[i][0] * moves[i][0]
            } else {
                0.0
            };
            let to = here + knot.axes[1] * bend;
            let bulge = if side.is_line() {
                vertex.bulge
            } else {
                let longer = side.arrive.dot(by((i + 1) % n)) - side.leave.dot(here);
                let tan = (0.25 * side.bend * longer).tan();
                let b = side.bulge;
                let slide = tan * (1.0 + b * b) / (1.0 - b * tan);
                vertex.bulge + slide + 2.0 * moves[i][2] / side.chord
            };
            Vertex::new(vertex.x + to.x, vertex.y + to.y, bulge)
        })
        .collect()
}

/// Makes the smooth joints of a loop exactly smooth, by Newton's method; also returns the number of steps.
fn smoothed(mut vertices: Vec<Vertex<Dd>>, smooth: &[bool]) -> Option<(Vec<Vertex<Dd>>, usize)> {
    /// Residual, in units of the admitted one, from which further steps gain nothing, because only rounding is left.
    const LEFT: f64 = 32.0;
    let size = vertices.iter().fold(0.0_f64, |size, v| {
        size.max(v.x.to_f64().abs()).max(v.y.to_f64().abs())
    });
    let mut before = f64::INFINITY;
    for steps in 0..MOST_STEPS {
        let sides = sides(&vertices)?;
        let knots = knots(&sides, smooth);
        let residuals = residuals(&sides, smooth)?;
        // The largest residual, in units of the admitted one.
        let worst = residuals.iter().zip(&knots).fold(0.0_f64, |worst, (r, k)| {
            worst.max(r.to_f64().abs() / (RESIDUAL + ROUNDING * size / k.shortest))
        });
        if worst <= 1.0 || (worst <= LEFT && worst > 0.25 * before) {
            return Some((vertices, steps));
        }
        before = worst;
        let moves = least_moves(&sides, &knots, &residuals);
        if moves.iter().flatten().any(|m| !m.is_finite()) {
            return None;
        }
        vertices = moved(&vertices, &sides, &knots, &moves);
    }
    None
}

/// The sine of the angle at every smooth joint, 0 at the others; `None` if one turns by more than a quarter turn.
fn residuals(sides: &[Side], smooth: &[bool]) -> Option<Vec<Dd>> {
    let n = sides.len();
    (0..n)
        .map(|i| {
            let (before, after) = (&sides[(i + n - 1) % n], &sides[i]);
            if !smooth[i] {
                return Some(Dd::ZERO);
            }
            if before.arrive.dot(after.leave) <= 0.0 {
                return None;
            }
            Some(before.exact_arrive.cross(after.exact_leave))
        })
        .collect()
}

/// Whether a loop is no farther from the drawn one than admitted.
fn is_near(
    drawn: &[Vertex<Dd>],
    sides: &[Side],
    knots: &[Knot],
    result: &[Vertex<Dd>],
    wish: &[[f64; 3]],
) -> bool {
    let n = drawn.len();
    let longest = wish.iter().fold(0.0_f64, |longest, w| {
        longest.max(w[0].hypot(w[1])).max(w[2].abs())
    });
    let allowed = MOST_WISHES * longest + NEGLIGIBLE + bent_pieces(sides, knots);
    // Second-order change by sliding.
    let mut slides = vec![0.0; n];
    for i in 0..n {
        let (before, after, knot) = (&sides[(i + n - 1) % n], &sides[i], &knots[i]);
        let by = vector(result[i].point() - drawn[i].point());
        let off = if knot.smooth {
            let slide = by.dot(knot.axes[0]);
            slides[i] = knot.bends.abs() * slide * slide;
            if slide < 0.0 {
                off_circle(by, before.arrive, before.bend)
            } else {
                off_circle(by, after.leave, after.bend)
            }
        } else {
            by.length()
        };
        let is_little = by.length() <= 2.0 * LARGEST_PART * knot.shortest;
        let is_wished = off <= allowed + slides[i];
        if !(is_little && is_wished) {
            return false;
        }
    }
    (0..n).all(|i| {
        let j = (i + 1) % n;
        if sides[i].is_line() {
            return result[i].bulge.is_zero();
        }
        let allowed = allowed + slides[i].max(slides[j]);
        let [was, is] = [drawn, result].map(|vertices| inner_points(&edge_from(vertices, i)));
        drawn[i].bulge.is_negative() == result[i].bulge.is_negative()
            && (was.iter().zip(&is)).all(|((was, way), (is, _))| {
                off_circle(vector(*is - *was), *way, sides[i].bend) <= allowed
            })
    })
}

/// Distance from a circle of curvature κ of the point at v from a point on the circle, where the circle has the direction T: with f = T×v −
/// κ v²/2 it is 2 f / (1 + √(1 − 2 κ f)).
fn off_circle(v: Vector, way: Vector, bend: f64) -> f64 {
    let f = way.cross(v) - 0.5 * bend * v.length_squared();
    (2.0 * f / (1.0 + (1.0 - 2.0 * bend * f).max(0.0).sqrt())).abs()
}

/// Points of an arc at a quarter, half and three quarters of it, and the direction of travel there.
fn inner_points(arc: &Edge<Dd>) -> [(Point<Dd>, Vector); 3] {
    // Half an arc has the bulge b / (1 + √(1 + b²)).
    let (b, middle) = (arc.bulge, arc.middle());
    let halved = b / ((b * b + 1.0).sqrt() + 1.0);
    [
        Edge::between(arc.start, middle, halved),
        *arc,
        Edge::between(middle, arc.end, halved),
    ]
    .map(|e| (e.middle(), vector(e.end - e.start).unit()))
}

/// Upper bound of the distance of the pieces of one line from the line: they meet at angles below twice [`STRAIGHT`], and no slide makes
/// them straight. Pieces of one circle are treated alike.
///
/// A chain of length l with kinks δ is at most Σ δ l / 4 away from its chord.
fn bent_pieces(sides: &[Side], knots: &[Knot]) -> f64 {
    let n = sides.len();
    let long = |side: &Side| side.chord + 2.0 * side.sagitta();
    let kink = |i: usize| {
        let (before, after) = (&sides[(i + n - 1) % n], &sides[i]);
        before.exact_arrive.cross(after.exact_leave).to_f64().abs()
    };
    let alike: Vec<Option<f64>> = (0..n)
        .map(|i| {
            let kink = kink(i);
            let slides = knots[i].bends.abs() * LARGEST_PART * knots[i].shortest;
            (knots[i].smooth && kink <= 2.0 * STRAIGHT && slides <= kink).then_some(kink)
        })
        .collect();
    let first = alike.iter().position(Option::is_none).unwrap_or(0);
    let mut most = 0.0_f64;
    let (mut kinks, mut length) = (0.0, 0.0);
    for step in 0..n {
        let i = (first + step) % n;
        if let Some(kink) = alike[i] {
            kinks += kink;
            length += long(&sides[i]);
        } else {
            (kinks, length) = (0.0, long(&sides[i]));
        }
        most = most.max(0.25 * kinks * length);
    }
    most
}

#[cfg(test)]
mod tests;
