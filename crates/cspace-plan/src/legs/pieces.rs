//! How far two pieces are apart over an interval of time: a lower bound, and the distance in the middle.
//!
//! The distance along a common normal is a smooth function of time. With its value and slope in the middle and a bound on its
//! second derivative, Taylor's theorem bounds it over the interval; the bound is off by the square of the interval.

use cspace::{Point, Vector};

use super::apart::{Apart, ROUNDING};
use super::flat::Flat;
use super::flats::flats;
use super::pose::{Mover, Placed};
use super::shape::{Shape, beyond};

/// A point for which |n − k w| is less is nearer to the centre of a flat arc than this share of its radius.
const LEAST_STRETCH: f64 = 0.25;

/// The distance of two moving points: its value, and bounds on what it can be.
struct Between {
    direction: Vector,
    value: f64,
    least: f64,
    most: f64,
    /// By how much the direction turns at most, radians.
    turns: f64,
}

fn between(a: Mover, b: Mover, half: f64) -> Between {
    let way = b.at - a.at;
    let value = way.length();
    let direction = if value > 0.0 {
        way * (1.0 / value)
    } else {
        Vector::ZERO
    };
    let relative = b.velocity - a.velocity;
    let bend = a.bend + b.bend;
    let slope = direction.dot(relative).abs();
    let speed = relative.length() + bend * half;
    let shortest = value - speed * half;
    // The second derivative is |D'⊥|² / |D| + u·D'', of which the first is not negative.
    let least = shortest.max(value - (slope + 0.5 * bend * half) * half);
    let (most, turns) = if shortest > 0.0 {
        let curve = bend + speed * speed / shortest;
        let most = (slope + 0.5 * curve * half).min(speed) * half;
        (value + most, speed * half / shortest)
    } else {
        (value + speed * half, f64::INFINITY)
    };
    Between {
        direction,
        value,
        least,
        most,
        turns,
    }
}

/// A bound on the distance of two discs.
pub(super) fn discs(
    (a, p, r): (&Placed, Point, f64),
    (b, q, s): (&Placed, Point, f64),
    half: f64,
) -> f64 {
    between(a.point(p), b.point(q), half).least - r - s
}

/// How far two pieces are apart.
pub(super) fn pieces(a: (&Placed, &Shape), b: (&Placed, &Shape), half: f64) -> Apart {
    match (a.1, b.1) {
        (Shape::Circle { .. }, Shape::Circle { .. }) => circles(a, b, half),
        (Shape::Circle { .. }, Shape::Flat(flat)) => circle_and_flat(a, (b.0, flat), half),
        (Shape::Flat(flat), Shape::Circle { .. }) => circle_and_flat(b, (a.0, flat), half),
        (Shape::Flat(first), Shape::Flat(second)) => flats((a.0, first), (b.0, second), half),
    }
}

/// Whether a normal meets an arc: surely not within the interval, and whether it does in the middle.
fn misses(from: f64, sweep: f64, direction: f64, turns: f64) -> (bool, bool) {
    let off = beyond(from, sweep, direction);
    (off > turns + ROUNDING, off <= ROUNDING)
}

fn circles(a: (&Placed, &Shape), b: (&Placed, &Shape), half: f64) -> Apart {
    let (
        Shape::Circle {
            center: p,
            radius: r,
            from: from_a,
            sweep: sweep_a,
        },
        Shape::Circle {
            center: q,
            radius: s,
            from: from_b,
            sweep: sweep_b,
        },
    ) = (*a.1, *b.1)
    else {
        return Apart::NONE;
    };
    let d = between(a.0.point(p), b.0.point(q), half);
    let angle = d.direction.angle();
    let sides =
        |radius: f64| -> &'static [f64] { if radius > 0.0 { &[1.0, -1.0] } else { &[1.0] } };
    let mut all = Apart::NONE;
    for &i in sides(r) {
        // The first circle is met in direction i·u from its centre, the second in −j·u.
        let heading = |sign: f64| {
            if sign > 0.0 {
                angle
            } else {
                angle + core::f64::consts::PI
            }
        };
        let (never_a, now_a) = if r > 0.0 {
            misses(
                from_a,
                sweep_a,
                heading(i) - a.0.angle,
                d.turns + a.0.turning.abs() * half,
            )
        } else {
            (false, true)
        };
        if never_a {
            continue;
        }
        for &j in sides(s) {
            let (never_b, now_b) = if s > 0.0 {
                misses(
                    from_b,
                    sweep_b,
                    heading(-j) - b.0.angle,
                    d.turns + b.0.turning.abs() * half,
                )
            } else {
                (false, true)
            };
            if never_b {
                continue;
            }
            let off = i * r + j * s;
            let least = (d.least - off).max(off - d.most).max(0.0);
            let here = if now_a && now_b {
                (d.value - off).abs()
            } else {
                f64::INFINITY
            };
            all = all.and(Apart { least, here });
        }
    }
    all
}

/// A flat arc told by its centre.
fn whole(flat: &Flat) -> Shape {
    let (n, k) = (flat.along.left(), flat.curvature);
    let turn = flat.turn();
    Shape::Circle {
        center: flat.middle + n * (1.0 / k),
        radius: 1.0 / k.abs(),
        from: (n * -k.signum()).angle() - turn,
        sweep: 2.0 * turn,
    }
}

fn circle_and_flat(
    circle: (&Placed, &Shape),
    (placed, flat): (&Placed, &Flat),
    half: f64,
) -> Apart {
    let Shape::Circle {
        center,
        radius,
        from,
        sweep,
    } = *circle.1
    else {
        return Apart::NONE;
    };
    let c = placed.seen(circle.0.point(center), half);
    let at = flat.seen(c.at);
    let speed = c.velocity.length() + c.bend * half;
    let k = flat.curvature.abs();
    // While the centre moves it does not come near that of the arc.
    let stretch = at.stretch - k * speed * half;
    if stretch < LEAST_STRETCH {
        // The circle is as large as that of the arc, or far away: from centre to centre.
        return circles(circle, (placed, &whole(flat)), half);
    }
    let far = (c.at - flat.middle).length() + speed * half;
    let reach = speed * half * (1.0 + k * far) / (stretch * stretch) + ROUNDING * flat.half;
    if at.foot.abs() > flat.half + reach {
        return Apart::NONE;
    }
    let within = flat.has(at.foot, ROUNDING);
    // The height has slope 1 across the arc, and bends with it.
    let bend = c.bend + k * speed * speed / stretch;
    let rise = (c.velocity.dot(at.up).abs() + 0.5 * bend * half).min(speed) * half;
    let one = |side: f64| {
        // The circle is met at center − side · radius · up.
        let (never, now) = if radius > 0.0 {
            let heading = (at.up * -side).angle() + placed.angle - circle.0.angle;
            let turns =
                (placed.turning - circle.0.turning).abs() * half + k * speed * half / stretch;
            misses(from, sweep, heading, turns)
        } else {
            (false, true)
        };
        if never {
            return Apart::NONE;
        }
        let value = at.height - side * radius;
        Apart {
            least: (value.abs() - rise).max(0.0),
            here: if now && within {
                value.abs()
            } else {
                f64::INFINITY
            },
        }
    };
    let first = one(1.0);
    if radius > 0.0 {
        first.and(one(-1.0))
    } else {
        first
    }
}
