//! Test of whether loops of lines make a part.

use cspace::part::tolerance::RESOLUTION;
use cspace::{Part, PartError, Point, Vertex};

use crate::Finding;
use crate::draw::Bytes;
use crate::exact::Dyadic;

/// Multiples of the limit between which either verdict is right, due to rounding of distances.
const CERTAINLY_NEAR: f64 = 0.99;
const CERTAINLY_APART: f64 = 1.01;

/// An edge, exactly: where it starts and ends, in which loop, and after which vertex.
#[derive(Clone)]
struct Line {
    from: [Dyadic; 2],
    to: [Dyadic; 2],
    place: (usize, usize),
    next: (usize, usize),
}

fn minus(a: &[Dyadic; 2], b: &[Dyadic; 2]) -> [Dyadic; 2] {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

fn cross(a: &[Dyadic; 2], b: &[Dyadic; 2]) -> Dyadic {
    &(&a[0] * &b[1]) - &(&a[1] * &b[0])
}

fn dot(a: &[Dyadic; 2], b: &[Dyadic; 2]) -> Dyadic {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

/// Whether a point is nearer than `limit` to a line: |c × q|² < limit² |c|² beside it, or near an end.
fn is_near(p: &[Dyadic; 2], line: &Line, limit: &Dyadic) -> bool {
    let (c, q) = (minus(&line.to, &line.from), minus(p, &line.from));
    let (along, square) = (dot(&c, &q), dot(&c, &c));
    let limit = limit.square();
    if along.sign() > 0 && along < square {
        return cross(&c, &q).square() < &limit * &square;
    }
    let r = minus(p, &line.to);
    dot(&q, &q) < limit || dot(&r, &r) < limit
}

/// Whether two lines cross: the ends of each are strictly on different sides of the other.
fn cross_clearly(a: &Line, b: &Line) -> bool {
    let apart = |a: &Line, b: &Line| {
        let c = minus(&a.to, &a.from);
        let [s, t] = [&b.from, &b.to].map(|p| cross(&c, &minus(p, &a.from)).sign());
        s * t < 0
    };
    apart(a, b) && apart(b, a)
}

/// Whether two lines are nearer than a limit or cross.
fn meet(a: &Line, b: &Line, limit: &Dyadic) -> bool {
    cross_clearly(a, b)
        || [&a.from, &a.to].iter().any(|p| is_near(p, b, limit))
        || [&b.from, &b.to].iter().any(|p| is_near(p, a, limit))
}

fn lines(loops: &[Vec<Vertex>]) -> Vec<Line> {
    let at = |v: &Vertex| [Dyadic::of(v.x), Dyadic::of(v.y)];
    let mut all = Vec::new();
    for (i, l) in loops.iter().enumerate() {
        for (k, v) in l.iter().enumerate() {
            let next = (k + 1) % l.len();
            all.push(Line {
                from: at(v),
                to: at(&l[next]),
                place: (i, k),
                next: (i, next),
            });
        }
    }
    all
}

/// Loops on a coarse lattice, some vertices nearly on another edge or vertex.
fn drawn(bytes: &mut Bytes<'_>) -> Vec<Vec<Vertex>> {
    let count = 1 + usize::from(bytes.below(4) == 0);
    let mut before: Vec<Vertex> = Vec::new();
    let mut loops = Vec::new();
    for _ in 0..count {
        let n = 3 + bytes.below(6);
        let mut vertices = Vec::new();
        for _ in 0..n {
            let fresh = Vertex::line(bytes.unit(), bytes.unit());
            let v = match (bytes.below(6), before.len()) {
                // On the line through two vertices.
                (0, 2..) => {
                    let (a, b) = (
                        before[bytes.below(before.len())],
                        before[bytes.below(before.len())],
                    );
                    let p = a
                        .point()
                        .lerp(b.point(), bytes.one_of(&[0.5, 0.25, 1.0, 2.0]));
                    Vertex::line(bytes.nudged(p.x), bytes.nudged(p.y))
                }
                _ => fresh,
            };
            before.push(v);
            vertices.push(v);
        }
        loops.push(vertices);
    }
    loops
}

pub(super) fn run(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let loops = drawn(bytes);
    let lines = lines(&loops);
    let size = size(&loops);
    let found = Part::new("part", loops.clone());
    let finding = |said: &str| Finding::new(format!("{said}: {found:?} of {loops:?}"));
    let near = Dyadic::of(CERTAINLY_NEAR * RESOLUTION * size);
    let apart = Dyadic::of(CERTAINLY_APART * RESOLUTION * size);
    let named = |place: (usize, usize)| lines.iter().find(|l| l.place == place);
    match &found {
        Ok(part) => {
            for (i, a) in lines.iter().enumerate() {
                for b in &lines[..i] {
                    let follow = a.next == b.place || b.next == a.place;
                    if !follow && meet(a, b, &near) {
                        let places = (a.place, b.place);
                        return Err(finding(&format!("accepted, but {places:?} meet")));
                    }
                    if a.next == b.place && is_spike(a, b, CERTAINLY_NEAR)
                        || b.next == a.place && is_spike(b, a, CERTAINLY_NEAR)
                    {
                        return Err(finding("accepted with a spike"));
                    }
                }
            }
            return holds(part, &lines, bytes).map_err(|said| finding(&said));
        }
        &Err(
            PartError::Crossing {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                ..
            }
            | PartError::Touching {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                ..
            },
        ) => {
            let two = (
                named((loop_index, edge_index)),
                named((other_loop, other_edge)),
            );
            let (Some(a), Some(b)) = two else {
                return Err(finding("there are no such edges"));
            };
            if !meet(a, b, &apart) {
                return Err(finding("the edges do not meet"));
            }
        }
        &Err(PartError::Spike {
            loop_index,
            vertex_index,
        }) => {
            let Some(after) = named((loop_index, vertex_index)) else {
                return Err(finding("there is no such vertex"));
            };
            let before = lines.iter().find(|l| l.next == after.place);
            if before.is_none_or(|b| !is_spike(b, after, CERTAINLY_APART)) {
                return Err(finding("it is no spike"));
            }
        }
        &Err(PartError::CoincidentVertices {
            loop_index,
            vertex_index,
            ..
        }) => {
            let Some(line) = named((loop_index, vertex_index)) else {
                return Err(finding("there is no such vertex"));
            };
            let c = minus(&line.to, &line.from);
            if dot(&c, &c) > apart.square() {
                return Err(finding("the vertices are apart"));
            }
        }
        Err(_) => {}
    }
    Ok(1)
}

/// Whether two lines leave their common vertex within some multiple of the finest angle of each other.
fn is_spike(arriving: &Line, leaving: &Line, factor: f64) -> bool {
    let (back, on) = (
        minus(&arriving.from, &arriving.to),
        minus(&leaving.to, &leaving.from),
    );
    let limit = Dyadic::of(factor * RESOLUTION).square();
    dot(&back, &on).sign() > 0
        && cross(&back, &on).square() < &(&limit * &dot(&back, &back)) * &dot(&on, &on)
}

/// The diagonal of the box about all vertices.
fn size(loops: &[Vec<Vertex>]) -> f64 {
    let all = || loops.iter().flatten();
    let extent = |of: fn(&Vertex) -> f64| {
        let lo = all().map(of).fold(f64::INFINITY, f64::min);
        let hi = all().map(of).fold(f64::NEG_INFINITY, f64::max);
        hi - lo
    };
    extent(|v| v.x).hypot(extent(|v| v.y))
}

/// Asks an accepted part for its area and for points in it.
///
/// Twice the area is a sum of cross products, of each loop with the sign that makes it positive, less that of a hole;
/// whether a point is inside is the parity of the edges that a ray to the right meets.
fn holds(part: &Part, lines: &[Line], bytes: &mut Bytes<'_>) -> Result<u64, String> {
    let inside = |p: &[Dyadic; 2], but: Option<usize>| {
        let meets = |l: &&Line| {
            let (below, above) = if l.from[1] <= l.to[1] {
                (&l.from, &l.to)
            } else {
                (&l.to, &l.from)
            };
            below[1] <= p[1]
                && p[1] < above[1]
                && cross(&minus(above, below), &minus(p, below)).sign() > 0
        };
        let counted = lines.iter().filter(|l| Some(l.place.0) != but);
        counted.filter(meets).count() % 2 == 1
    };
    let mut twice = Dyadic::zero();
    for i in 0..part.loops().len() {
        let of_loop = || lines.iter().filter(|l| l.place.0 == i);
        let sum = of_loop().fold(Dyadic::zero(), |sum, l| &sum + &cross(&l.from, &l.to));
        let hole = of_loop().next().is_some_and(|l| inside(&l.from, Some(i)));
        twice = if hole {
            &twice - &sum.abs()
        } else {
            &twice + &sum.abs()
        };
    }
    let (area, exact) = (part.area(), 0.5 * twice.near());
    if (area - exact).abs() > 1e-14 * part.size() * part.size() {
        return Err(format!("the area is {exact:?}, not {area:?}"));
    }
    let mut judged = 2;
    for _ in 0..4 {
        let (x, y) = (bytes.unit(), bytes.unit());
        let p = [Dyadic::of(x), Dyadic::of(y)];
        let on_the_boundary = Dyadic::of(1e-14 * part.size());
        if lines.iter().any(|l| is_near(&p, l, &on_the_boundary)) {
            continue;
        }
        judged += 1;
        let expected = inside(&p, None);
        if part.contains(Point::new(x, y)) != expected {
            return Err(format!("({x:?}, {y:?}) inside: {expected}, it is said not"));
        }
    }
    Ok(judged)
}
