//! Loops whose smooth joints are exactly smooth, and which are like no other loop.
//!
//! A drawing has its smooth joints to the rounding of its numbers, and lengths that are equal by design. [`made_generic`]
//! moves the vertices and arcs of a loop by lengths that are asked for, and then by as little as makes its joints smooth to
//! double-double.
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
//! The chord of edge i has direction θᵢ; the edge leaves along θᵢ − hᵢ and arrives along θᵢ + hᵢ. At a smooth joint
//! ρᵢ = (θᵢ − hᵢ) − (θᵢ₋₁ + hᵢ₋₁) is none. Sliding a vertex by t turns ρᵢ by (κᵢ − κᵢ₋₁) t, and no other joint: what a kink δ
//! of a line and an arc of radius r needs is a slide of r δ, which changes the outline by r δ²/2 only. Moving across instead
//! would change it by δ times the length of an edge. Therefore slides are cheap.
//!
//! The smallest change is W Jᵀ λ with (J W Jᵀ) λ = −ρ, where J has the derivatives of ρ and W the weights. Joint i is coupled
//! with joints i ± 1 and i ± 2; in the order 0, n−1, 1, n−2, … a closed loop is a band of half width 4, which is factored as
//! L D Lᵀ. Rows that depend on others are left out: two arcs that make a circle are smooth at both joints or at none.
#![allow(dead_code)]

use super::tolerance::{GROWTH, SAME_CARRIER, STRAIGHT};
use crate::geometry::Vector;
use crate::number::Dd;

/// How much cheaper it is to slide a vertex by a length than to move it across by as much.
///
/// A kink δ where an arc of radius r meets an edge of length l is mended by a slide of r δ where l is more than r / SLIDE,
/// and by turning the edge, which moves its end by l δ, where it is less: that is at most r δ / SLIDE ≈ 1e-13, and the slide
/// at most SLIDE δ ≈ 1/500 of the edge.
const SLIDE: f64 = (1u32 << 17) as f64;
/// The part of a short edge by which its ends may be moved as easily as those of a long one. They are never moved by more than
/// twice as much.
const LARGEST_PART: f64 = 1.0 / 64.0;
/// The part of a short edge by which a wish moves its ends, at most.
const WISHED_PART: f64 = 1.0 / (1u32 << 16) as f64;
/// The part of an arc's sagitta by which a wish changes it, at most, and beyond which a change is not as easy.
const SAGITTA_PART: f64 = 1.0 / 1024.0;
/// Moves across of at most so many times the longest wish are wished for.
const MOST_WISHES: f64 = 4.0;
/// Residuals below this are none (2⁻⁹⁹ ≈ 1.6e-30), but for what the rounding of coordinates makes of them.
const RESIDUAL: f64 = 1.0 / (1u128 << 99) as f64;
/// The rounding of a coordinate, relative to the largest (2⁻¹⁰⁷).
const ROUNDING: f64 = 1.0 / (1u128 << 107) as f64;
/// Pivots that are this much smaller than the diagonal are of rows that depend on others.
const DEPENDENT: f64 = 1e-26;
/// Steps of Newton's rule.
const MOST_STEPS: usize = 16;

/// An edge of a loop in double-double: it starts here, and ends where the next one starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ExactVertex {
    /// Where the edge starts.
    pub(crate) x: Dd,
    /// Where the edge starts.
    pub(crate) y: Dd,
    /// tan(sweep / 4), positive counter-clockwise; 0 for a line.
    pub(crate) bulge: Dd,
}

/// Moves a closed loop by a generic small amount so that its smooth joints are exactly smooth (to double-double).
///
/// `drawn[i]` is the start of edge i and its bulge; 0 for a line, which stays a line. `smooth[i]` tells whether edges i − 1
/// and i meet smoothly there. `wish[i]` has lengths by which vertex i (x, y) and the sagitta of arc i should be moved; of edges
/// that are short, and of arcs that hardly bend, they are lessened.
///
/// `None` if that is no loop (fewer than two edges, or one without length), if no smooth loop is found beside it, if a vertex
/// would move by more than 1/32 of an edge, or if the outline would move across by more than wished: by four times the longest
/// wish, 1.1e-13, what sliding changes in the second order, and what pieces of one line are off it.
pub(crate) fn made_generic(
    drawn: &[ExactVertex],
    smooth: &[bool],
    wish: &[[f64; 3]],
) -> Option<Vec<ExactVertex>> {
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

/// A vector in double-double.
#[derive(Clone, Copy)]
struct Exact {
    x: Dd,
    y: Dd,
}

impl Exact {
    fn between(from: &ExactVertex, to: &ExactVertex) -> Self {
        Self {
            x: to.x - from.x,
            y: to.y - from.y,
        }
    }

    fn cross(self, o: Self) -> Dd {
        self.x * o.y - self.y * o.x
    }

    fn dot(self, o: Self) -> Dd {
        self.x * o.x + self.y * o.y
    }

    /// Turned counter-clockwise.
    fn turned(self, cos: Dd, sin: Dd) -> Self {
        Self {
            x: self.x * cos - self.y * sin,
            y: self.x * sin + self.y * cos,
        }
    }

    fn times(self, factor: Dd) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
        }
    }

    fn rough(self) -> Vector {
        Vector::new(self.x.to_f64(), self.y.to_f64())
    }
}

/// What the equations need of an edge.
struct Side {
    /// Unit directions of travel at both ends.
    exact_leave: Exact,
    exact_arrive: Exact,
    leave: Vector,
    arrive: Vector,
    /// Unit direction of the chord.
    along: Vector,
    chord: f64,
    bulge: f64,
    /// cos and sin of half the sweep.
    half: (f64, f64),
    /// Signed curvature, 2 sin h / L.
    bend: f64,
}

impl Side {
    /// `None` if the edge has no length.
    fn new(start: &ExactVertex, end: &ExactVertex) -> Option<Self> {
        let chord = Exact::between(start, end);
        let length = chord.dot(chord).sqrt();
        let long = length.to_f64();
        if !(long > 0.0 && long.is_finite() && start.bulge.to_f64().is_finite()) {
            return None;
        }
        let along = chord.times(Dd::ONE / length);
        let b = start.bulge;
        let square = b * b;
        let q = Dd::ONE / (square + 1.0);
        let (cos, sin) = ((Dd::ONE - square) * q, b.scaled(2.0) * q);
        let (exact_leave, exact_arrive) = if b.is_zero() {
            (along, along)
        } else {
            (along.turned(cos, -sin), along.turned(cos, sin))
        };
        let half = (cos.to_f64(), sin.to_f64());
        Some(Self {
            exact_leave,
            exact_arrive,
            leave: exact_leave.rough(),
            arrive: exact_arrive.rough(),
            along: along.rough(),
            chord: long,
            bulge: b.to_f64(),
            half,
            bend: 2.0 * half.1 / long,
        })
    }

    fn is_line(&self) -> bool {
        self.bulge == 0.0
    }

    /// Half the chord times |b|.
    fn sagitta(&self) -> f64 {
        0.5 * self.chord * self.bulge.abs()
    }

    /// How far the ends of an arc of almost the whole circle may be moved, when by 1 those of a lesser one: the arc moves
    /// sideways by as much as they move across, over sin h.
    fn opening(&self) -> f64 {
        if self.half.0 < 0.0 {
            (2.0 * self.half.1.abs()).min(1.0)
        } else {
            1.0
        }
    }
}

/// The edges of a loop.
fn sides(vertices: &[ExactVertex]) -> Option<Vec<Side>> {
    let n = vertices.len();
    (0..n)
        .map(|i| Side::new(&vertices[i], &vertices[(i + 1) % n]))
        .collect()
}

/// What the equations need of a vertex.
struct Knot {
    smooth: bool,
    /// Directions of its two unknowns: those of travel and to the left of it where it is smooth, of x and y elsewhere.
    axes: [Vector; 2],
    weights: [f64; 2],
    /// Of the arc that starts here; 0 of a line.
    sagitta_weight: f64,
    /// The shorter chord of its edges.
    shortest: f64,
    /// The lesser opening of its edges.
    opening: f64,
    /// The mean of the curvatures of its edges, and their difference.
    bend: f64,
    bends: f64,
}

fn knots(sides: &[Side], smooth: &[bool]) -> Vec<Knot> {
    let n = sides.len();
    (0..n)
        .map(|i| {
            let (before, after) = (&sides[(i + n - 1) % n], &sides[i]);
            let shortest = before.chord.min(after.chord);
            let opening = before.opening().min(after.opening());
            let room = shortest * (LARGEST_PART / GROWTH);
            let across = room.min(1.0) * opening;
            let along = if smooth[i] { room.min(SLIDE) } else { across };
            let travel = (before.arrive + after.leave).unit();
            let axes = if smooth[i] {
                [travel, travel.left()]
            } else {
                [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)]
            };
            let sagitta = (after.sagitta() * (SAGITTA_PART / GROWTH)).min(1.0);
            Knot {
                smooth: smooth[i],
                axes,
                weights: [along * along, across * across],
                sagitta_weight: sagitta * sagitta,
                shortest,
                opening,
                bend: 0.5 * (before.bend + after.bend),
                bends: after.bend - before.bend,
            }
        })
        .collect()
}

/// Wishes as unknowns of the equations, none of them too long for its edges.
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

/// Vertices moved by unknowns.
///
/// Sliding is along the carriers, to the second order: a smooth vertex moves by t along a circle of the mean curvature, and
/// the sweep of an edge grows by κ times the length it grows by, x = κ (T₁·d₁ − T₀·d₀) / 4 being what is added to a fourth of
/// it: b' = (b + tan x) / (1 − b tan x).
fn moved(
    vertices: &[ExactVertex],
    sides: &[Side],
    knots: &[Knot],
    moves: &[[f64; 3]],
) -> Vec<ExactVertex> {
    let n = vertices.len();
    let by = |i: usize| knots[i].axes[0] * moves[i][0] + knots[i].axes[1] * moves[i][1];
    (0..n)
        .map(|i| {
            let (vertex, side, knot) = (&vertices[i], &sides[i], &knots[i]);
            let here = by(i);
            let bow = if knot.smooth {
                0.5 * knot.bend * moves[i][0] * moves[i][0]
            } else {
                0.0
            };
            let to = here + knot.axes[1] * bow;
            let bulge = if side.is_line() {
                vertex.bulge
            } else {
                let longer = side.arrive.dot(by((i + 1) % n)) - side.leave.dot(here);
                let tan = (0.25 * side.bend * longer).tan();
                let b = side.bulge;
                let slide = tan * (1.0 + b * b) / (1.0 - b * tan);
                vertex.bulge + slide + 2.0 * moves[i][2] / side.chord
            };
            ExactVertex {
                x: vertex.x + to.x,
                y: vertex.y + to.y,
                bulge,
            }
        })
        .collect()
}

/// Makes the smooth joints of a loop exactly smooth, by Newton's rule; and how many steps that takes.
fn smoothed(mut vertices: Vec<ExactVertex>, smooth: &[bool]) -> Option<(Vec<ExactVertex>, usize)> {
    // More steps gain nothing where rounding is all that is left.
    const LEFT: f64 = 32.0;
    let size = vertices.iter().fold(0.0_f64, |size, v| {
        size.max(v.x.to_f64().abs()).max(v.y.to_f64().abs())
    });
    let mut before = f64::INFINITY;
    for steps in 0..MOST_STEPS {
        let sides = sides(&vertices)?;
        let knots = knots(&sides, smooth);
        let residuals = residuals(&sides, smooth)?;
        // The largest, in units of what is none.
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

/// The sine of the angle at every smooth joint, 0 at the others; `None` if one is turned around.
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

/// Derivatives of the directions in which an edge leaves and arrives.
struct Slopes {
    /// By the move of its start and of its end.
    leave: [Vector; 2],
    arrive: [Vector; 2],
    /// By its sagitta; the other way for leaving.
    sagitta: f64,
}

impl Slopes {
    /// dθ = left(u)·(d₁ − d₀) / L and dh = 2 db / (1 + b²), where 2 (b/L) / (1 + b²) = sin h / L.
    fn new(side: &Side) -> Self {
        let turn = side.along.left() * (1.0 / side.chord);
        let sin = side.half.1 / side.chord;
        let (start, end) = (side.leave * -sin, side.arrive * sin);
        let square = side.bulge * side.bulge;
        Self {
            leave: [-turn - start, turn - end],
            arrive: [start - turn, end + turn],
            sagitta: if side.is_line() {
                0.0
            } else {
                4.0 / (side.chord * (1.0 + square))
            },
        }
    }
}

/// How the residuals of some joints depend on one unknown.
struct Column<const N: usize> {
    joints: [usize; N],
    slopes: [f64; N],
    weight: f64,
}

/// The columns of the Jacobian: two of each vertex, and one of each sagitta.
fn columns(slopes: &[Slopes], knots: &[Knot]) -> impl Iterator<Item = ([Column<3>; 2], Column<2>)> {
    let n = knots.len();
    (0..n).map(move |i| {
        let (previous, next) = ((i + n - 1) % n, (i + 1) % n);
        let (before, after, knot) = (&slopes[previous], &slopes[i], &knots[i]);
        let joints = [previous, i, next];
        let held = joints.map(|j| if knots[j].smooth { 1.0 } else { 0.0 });
        let by = [
            before.leave[1] * held[0],
            (after.leave[0] - before.arrive[1]) * held[1],
            -after.arrive[0] * held[2],
        ];
        let column = |k: usize| Column {
            joints,
            slopes: by.map(|v| v.dot(knot.axes[k])),
            weight: knot.weights[k],
        };
        let sagitta = Column {
            joints: [i, next],
            slopes: [-after.sagitta * held[1], -after.sagitta * held[2]],
            weight: knot.sagitta_weight,
        };
        ([column(0), column(1)], sagitta)
    })
}

impl<const N: usize> Column<N> {
    fn add_to(&self, band: &mut Band) {
        for (p, &j) in self.joints.iter().enumerate() {
            let weighted = Dd::from(self.slopes[p]) * self.weight;
            for (q, &k) in self.joints.iter().enumerate() {
                band.add(j, k, weighted * self.slopes[q]);
            }
        }
    }

    /// The change of the unknown.
    fn change(&self, multipliers: &[Dd]) -> f64 {
        let mut sum = Dd::ZERO;
        for (&j, &slope) in self.joints.iter().zip(&self.slopes) {
            sum = sum + multipliers[j] * slope;
        }
        (sum * self.weight).to_f64()
    }
}

/// W Jᵀ λ with (J W Jᵀ) λ = −ρ.
fn least_moves(sides: &[Side], knots: &[Knot], residuals: &[Dd]) -> Vec<[f64; 3]> {
    let slopes: Vec<Slopes> = sides.iter().map(Slopes::new).collect();
    let mut band = Band::new(sides.len());
    for ([x, y], sagitta) in columns(&slopes, knots) {
        x.add_to(&mut band);
        y.add_to(&mut band);
        sagitta.add_to(&mut band);
    }
    let wanted: Vec<Dd> = residuals.iter().map(|&r| -r).collect();
    let multipliers = band.solved(&wanted);
    columns(&slopes, knots)
        .map(|([x, y], sagitta)| {
            [
                x.change(&multipliers),
                y.change(&multipliers),
                sagitta.change(&multipliers),
            ]
        })
        .collect()
}

/// A symmetric matrix that couples each of a closed chain of n unknowns with two on either side.
///
/// It is in double-double, since a line of many pieces makes it as ill-conditioned as the fourth power of their number.
struct Band {
    /// Row p, column p − HALF + k is at `[p][k]`.
    rows: Vec<[Dd; HALF + 1]>,
}

/// The half width of the folded band.
const HALF: usize = 4;

impl Band {
    fn new(n: usize) -> Self {
        Self {
            rows: vec![[Dd::ZERO; HALF + 1]; n],
        }
    }

    /// The place of an unknown in the order 0, n−1, 1, n−2, …
    fn place(&self, i: usize) -> usize {
        let n = self.rows.len();
        if 2 * i < n {
            2 * i
        } else {
            2 * (n - 1 - i) + 1
        }
    }

    /// Adds to row j, column k; what is above the diagonal is left out.
    fn add(&mut self, j: usize, k: usize, value: Dd) {
        let (p, q) = (self.place(j), self.place(k));
        if q <= p {
            let entry = &mut self.rows[p][HALF + q - p];
            *entry = *entry + value;
        }
    }

    /// The solution of a consistent system; 0 for unknowns whose rows depend on those before.
    fn solved(mut self, right: &[Dd]) -> Vec<Dd> {
        let n = self.rows.len();
        // 1/D, with 0 of dependent rows.
        let mut inverse = vec![Dd::ZERO; n];
        for p in 0..n {
            let first = p.saturating_sub(HALF);
            let mut row = self.rows[p];
            let mut pivot = row[HALF];
            for q in first..p {
                let mut sum = row[HALF + q - p];
                for m in first.max(q.saturating_sub(HALF))..q {
                    // row[m] is still L D there.
                    sum = sum - row[HALF + m - p] * self.rows[q][HALF + m - q];
                }
                row[HALF + q - p] = sum;
            }
            for q in first..p {
                let entry = row[HALF + q - p];
                let factor = entry * inverse[q];
                pivot = pivot - entry * factor;
                row[HALF + q - p] = factor;
            }
            if pivot.to_f64() > DEPENDENT * row[HALF].to_f64() {
                inverse[p] = Dd::ONE / pivot;
            } else {
                row = [Dd::ZERO; HALF + 1];
            }
            self.rows[p] = row;
        }
        let mut solution = vec![Dd::ZERO; n];
        for (i, &value) in right.iter().enumerate() {
            solution[self.place(i)] = value;
        }
        for p in 0..n {
            for q in p.saturating_sub(HALF)..p {
                solution[p] = solution[p] - self.rows[p][HALF + q - p] * solution[q];
            }
        }
        for (value, &inverse) in solution.iter_mut().zip(&inverse) {
            *value = *value * inverse;
        }
        for p in (0..n).rev() {
            for q in p.saturating_sub(HALF)..p {
                solution[q] = solution[q] - self.rows[p][HALF + q - p] * solution[p];
            }
        }
        (0..n).map(|i| solution[self.place(i)]).collect()
    }
}

/// Whether a loop is no farther from the drawn one than wished.
fn is_near(
    drawn: &[ExactVertex],
    sides: &[Side],
    knots: &[Knot],
    result: &[ExactVertex],
    wish: &[[f64; 3]],
) -> bool {
    let n = drawn.len();
    let longest = wish.iter().fold(0.0_f64, |longest, w| {
        longest.max(w[0].hypot(w[1])).max(w[2].abs())
    });
    let allowed = MOST_WISHES * longest + SAME_CARRIER + bent_pieces(sides, knots);
    // What sliding changes in the second order.
    let mut slides = vec![0.0; n];
    for i in 0..n {
        let (before, after, knot) = (&sides[(i + n - 1) % n], &sides[i], &knots[i]);
        let by = Exact::between(&drawn[i], &result[i]).rough();
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
        let was = inner_points(&drawn[i], &drawn[j]);
        let is = inner_points(&result[i], &result[j]);
        drawn[i].bulge.is_negative() == result[i].bulge.is_negative()
            && (was.iter().zip(&is)).all(|((was, way), (is, _))| {
                off_circle(Exact::between(was, is).rough(), *way, sides[i].bend) <= allowed
            })
    })
}

/// How far off a circle of curvature κ is what is at v from a point on it, where it runs along T: with
/// f = T×v − κ v²/2 that is 2 f / (1 + √(1 − 2 κ f)).
fn off_circle(v: Vector, way: Vector, bend: f64) -> f64 {
    let f = way.cross(v) - 0.5 * bend * v.length_squared();
    (2.0 * f / (1.0 + (1.0 - 2.0 * bend * f).max(0.0).sqrt())).abs()
}

/// Points of an arc at a fourth, half and three fourths of it, and the direction of travel there.
fn inner_points(start: &ExactVertex, end: &ExactVertex) -> [(ExactVertex, Vector); 3] {
    // Half an arc has the bulge b / (1 + √(1 + b²)).
    let halved = |b: Dd| b / ((b * b + 1.0).sqrt() + 1.0);
    let middle = |start: &ExactVertex, end: &ExactVertex, b: Dd| {
        let chord = Exact::between(start, end);
        let rise = b.scaled(0.5);
        let middle = ExactVertex {
            x: start.x + chord.x.scaled(0.5) + chord.y * rise,
            y: start.y + chord.y.scaled(0.5) - chord.x * rise,
            bulge: Dd::ZERO,
        };
        (middle, chord.rough().unit())
    };
    let b = halved(start.bulge);
    let half = middle(start, end, start.bulge);
    [middle(start, &half.0, b), half, middle(&half.0, end, b)]
}

/// How far the pieces of one line are off the line, at most: they meet at angles below twice [`STRAIGHT`], and no slide makes
/// them straight. Pieces of one circle are alike.
///
/// A chain of length l with kinks δ is off its chord by at most Σ δ l / 4.
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
