//! The pairs.

use core::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

use cspace::{Part, Point, Vertex};
use cspace_oracle::shapes::{Pen, bulge_of, part, polar};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::ways::hook;

use super::fit::{Fit, Place};

/// Half an opening for what is so wide: more by the play, or less.
fn half(wide: f64, play: f64, opens: bool) -> f64 {
    0.5 * (wide + if opens { play } else { -play })
}

/// Anywhere above y = 4, where nothing is.
fn outside(rng: &mut ChaCha8Rng) -> Place {
    (
        rng.random_range(-4.0..4.0),
        rng.random_range(7.0..9.0),
        rng.random_range(-PI..PI),
    )
}

/// The plane below y = 0, but for what is cut out from its upper side, drawn from the right to the left.
fn ground(cut: &[Vertex]) -> Part {
    let mut outline = vec![
        Vertex::line(-9.0, 0.0),
        Vertex::line(-9.0, -9.0),
        Vertex::line(9.0, -9.0),
        Vertex::line(9.0, 0.0),
    ];
    outline.extend_from_slice(cut);
    part("ground", vec![outline])
}

fn lines(corners: &[(f64, f64)]) -> Vec<Vertex> {
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

/// The right half of what is symmetric, from above, and then the left one.
fn both_sides(right: &[(f64, f64)]) -> Vec<Vertex> {
    let left = right.iter().rev().map(|&(x, y)| (-x, y));
    lines(&right.iter().copied().chain(left).collect::<Vec<_>>())
}

/// A peg comes through a throat, into a chamber in which it may turn.
pub(super) fn peg(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let wide = rng.random_range(0.6..1.2);
    let (long, chamfer) = (rng.random_range(1.6..2.4), rng.random_range(0.05..0.2));
    let (throat, depth) = (half(wide, play, opens), rng.random_range(0.5..1.5));
    let fixed = ground(&both_sides(&[
        (throat + chamfer, 0.0),
        (throat, -chamfer),
        (throat, -depth),
        (2.0, -depth),
        (2.0, -depth - 4.0),
    ]));
    let (w, l) = (0.5 * wide, 0.5 * long);
    let moving = both_sides(&[(w, l), (w, chamfer - l), (w - chamfer, -l)]);
    let within = (
        rng.random_range(-0.4..0.4),
        -depth - rng.random_range(1.7..2.3),
        rng.random_range(-PI..PI),
    );
    let moving = part("peg", vec![moving.into_iter().rev().collect()]);
    Fit::new((fixed, moving), outside(rng), within, 0.5 * play)
}

/// A key with round ends is in a round hole, and has to be turned to leave by a slot.
pub(super) fn key(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let (wide, radius) = (rng.random_range(0.6..1.0), rng.random_range(1.5..2.0));
    let slot = half(wide, play, opens);
    let bottom = -rng.random_range(0.5..2.0);
    // The hole's centre, below the mouth of the slot.
    let center = bottom - (radius * radius - slot * slot).sqrt();
    let sweep = TAU - 2.0 * (slot / radius).asin();
    let fixed = ground(&[
        Vertex::line(slot, 0.0),
        Vertex::new(slot, bottom, -bulge_of(sweep)),
        Vertex::line(-slot, bottom),
        Vertex::line(-slot, 0.0),
    ]);
    let (w, l) = (
        0.5 * wide,
        rng.random_range(0.2..1.0) * (radius - 0.5 * wide - 0.05),
    );
    let moving = Pen::at(-l, -w)
        .line(l, -w)
        .arc(l, w, 1.0)
        .line(-l, w)
        .close_arc(1.0);
    let within = (0.0, center, rng.random_range(-PI..PI));
    Fit::new(
        (fixed, part("key", vec![moving])),
        within,
        outside(rng),
        0.5 * play,
    )
}

/// A tenon in a groove with slanting sides: parallel ones let it go along them, a dovetail does not.
pub(super) fn dovetail(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    // The tenon contains a disc that is wider than the mouth: its depth is more, and so is the disc that touches bottom and sides.
    let (mouth, slant) = (rng.random_range(0.8..1.2), rng.random_range(0.25..0.6_f64));
    let deep = mouth * rng.random_range(1.2..1.6);
    let shift = deep * slant.tan();
    let side = if opens { -1.0 } else { 1.0 };
    let tenon = [
        (0.5 * mouth, 0.0),
        (-0.5 * mouth, 0.0),
        (-0.5 * mouth - side * shift, -deep),
        (0.5 * mouth + shift, -deep),
    ];
    // Sides farther out by half the play, measured across them; they go on to the bottom, which is lower by it.
    let out = 0.5 * play / slant.cos();
    let more = 0.5 * play * slant.tan();
    let bottom = -deep - 0.5 * play;
    let groove = lines(&[
        (0.5 * mouth + out, 0.0),
        (0.5 * mouth + shift + out + more, bottom),
        (-0.5 * mouth - side * (shift + more) - out, bottom),
        (-0.5 * mouth - out, 0.0),
    ]);
    let moving = part("tenon", vec![lines(&tenon)]);
    Fit::new(
        (ground(&groove), moving),
        (0.0, 0.0, 0.0),
        outside(rng),
        0.5 * play,
    )
}

/// A T with its head in a chamber, and its stem in the neck. The head is higher than wide.
pub(super) fn tee(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let wide = rng.random_range(0.8..1.2);
    let high = wide * rng.random_range(1.05..1.5);
    let stem = wide * rng.random_range(0.2..0.4);
    let (neck, depth) = (half(wide, play, opens), rng.random_range(0.5..1.5));
    let chamber = 0.5 * wide + rng.random_range(0.05..0.5);
    let fixed = ground(&both_sides(&[
        (neck, 0.0),
        (neck, -depth),
        (chamber, -depth),
        (chamber, -depth - high - play),
    ]));
    let (w, top) = (0.5 * wide, rng.random_range(0.5..1.0) + depth);
    let moving = both_sides(&[(stem, top), (stem, 0.0), (w, 0.0), (w, -high)]);
    let moving = part("T", vec![moving.into_iter().rev().collect()]);
    let seat = (0.0, -depth - 0.5 * play, 0.0);
    Fit::new((fixed, moving), seat, outside(rng), 0.5 * play)
}

/// A block goes along a channel and up through a neck, without turning. It is higher than wide.
pub(super) fn block(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let wide = rng.random_range(0.8..1.2);
    let high = wide * rng.random_range(1.05..1.5);
    let (neck, depth) = (half(wide, play, opens), rng.random_range(0.3..1.0));
    let end = -neck - rng.random_range(1.2..2.0);
    let low = -depth - high - play;
    let cut = lines(&[
        (neck, 0.0),
        (neck, low),
        (end, low),
        (end, -depth),
        (-neck, -depth),
        (-neck, 0.0),
    ]);
    let moving = Part::rectangle("block", (0.0, 0.0), wide, high).unwrap();
    let seat = (end + 0.5 * (wide + play), -depth - 0.5 * (high + play), 0.0);
    Fit::new((ground(&cut), moving), seat, outside(rng), 0.5 * play)
}

/// A sector of a ring in an annular slot, which it leaves by turning about the centre of its arcs. A lip may close the mouth.
pub(super) fn arc(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let (thick, inner) = (rng.random_range(0.4..0.8), rng.random_range(1.0..2.0));
    let (sweep, beyond) = (rng.random_range(0.8..2.2), rng.random_range(0.2..0.6));
    let outer = inner + thick;
    let (r, s) = (inner - 0.5 * play, outer + 0.5 * play);
    let end = -sweep - beyond;
    let at = |radius: f64, angle: f64| polar(Point::ORIGIN, radius, angle);
    let vertex = |p: Point, bulge: f64| Vertex::new(p.x, p.y, bulge);
    let mut cut = Vec::new();
    let from = if opens {
        0.0
    } else {
        // Twice as far into the slot as the play is wide.
        let lip = -0.5 * beyond;
        let narrow = s - 2.0 * play;
        cut.push(vertex(at(narrow, 0.0), bulge_of(lip)));
        cut.push(vertex(at(narrow, lip), 0.0));
        lip
    };
    cut.extend([
        vertex(at(s, from), bulge_of(end - from)),
        vertex(at(s, end), 0.0),
        vertex(at(r, end), bulge_of(-end)),
        vertex(at(r, 0.0), 0.0),
    ]);
    let turn = end + 0.1 * beyond;
    let corners = [
        at(outer, 0.0),
        at(outer, sweep),
        at(inner, sweep),
        at(inner, 0.0),
    ];
    let bulges = [bulge_of(sweep), 0.0, -bulge_of(sweep), 0.0];
    let sector = corners.iter().zip(bulges).map(|(&p, b)| vertex(p, b));
    let moving = part("sector", vec![sector.collect()]);
    Fit::new(
        (ground(&cut), moving),
        (0.0, 0.0, turn),
        outside(rng),
        0.5 * play,
    )
}

/// A ball in a socket that is more than half round: its mouth is a little wider than the ball, or narrower.
pub(super) fn ball(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let radius = rng.random_range(0.8..1.5);
    let mouth = half(2.0 * radius, 0.5 * play, opens);
    let socket = radius + 0.5 * play;
    let center = -(socket * socket - mouth * mouth).sqrt();
    let sweep = TAU - 2.0 * (mouth / socket).asin();
    let fixed = ground(&[
        Vertex::new(mouth, 0.0, -bulge_of(sweep)),
        Vertex::line(-mouth, 0.0),
    ]);
    let handle = radius * rng.random_range(0.2..0.6);
    let root = (radius * radius - handle * handle).sqrt();
    let rest = TAU - 2.0 * (handle / radius).asin();
    let end = radius + rng.random_range(0.5..2.0);
    let moving = Pen::at(-handle, root)
        .arc(handle, root, bulge_of(rest))
        .line(handle, end)
        .line(-handle, end)
        .close();
    let moving = part("ball", vec![moving]);
    Fit::new(
        (fixed, moving),
        (0.0, center, 0.0),
        outside(rng),
        0.25 * play,
    )
}

/// A cross in a hole of its shape: it moves as much as the play lets it, and does not turn by a quarter.
pub(super) fn cross(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let (wide, long) = (rng.random_range(0.3..0.6), rng.random_range(1.5..2.5));
    let outline = |more: f64| {
        let (w, l) = (wide + more, long + more);
        let quarter = [(w, -w), (l, -w), (l, w)];
        let turned = |k: i32| {
            let (sin, cos) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][k as usize];
            quarter.map(|(x, y)| (cos * x - sin * y, sin * x + cos * y))
        };
        lines(&(0..4).flat_map(turned).collect::<Vec<_>>())
    };
    let plate = lines(&[(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)]);
    let fixed = part("plate", vec![plate, outline(0.5 * play)]);
    let moving = part("cross", vec![outline(0.0)]);
    // So far that each of the two leaves less than the play to the other.
    let mut within = || {
        let mut any = |most: f64| rng.random_range(-most..most);
        (any(0.24 * play), any(0.24 * play), any(0.2 * play / long))
    };
    let (from, mut to) = (within(), within());
    if !opens {
        to.2 += FRAC_PI_2;
    }
    Fit::new((fixed, moving), from, to, 0.5 * play)
}

/// A hook with a round bend, whose thickness is about the gap of an eye.
pub(super) fn hook(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let (thick, lip) = (rng.random_range(0.6..1.0), rng.random_range(0.3..0.6));
    let inner = lip + rng.random_range(0.1..0.5);
    let gap = 2.0 * half(thick, play, opens);
    let [from, to] = hook::ENDS;
    let parts = (hook::eye(gap, lip), hook::hook(thick, inner));
    Fit::new(parts, from, to, 0.5 * play)
}

/// A hook with a sharp notch.
pub(super) fn notch(rng: &mut ChaCha8Rng, play: f64, opens: bool) -> Fit {
    let (thick, lip) = (rng.random_range(0.6..1.0), rng.random_range(0.3..0.6));
    let gap = 2.0 * half(thick, play, opens) + (SQRT_2 - 1.0) * lip;
    let [from, to] = hook::ENDS;
    let parts = (hook::eye(gap, lip), hook::hook(thick, 0.0));
    Fit::new(parts, from, to, play / (SQRT_2 + 1.0))
}
