//! Blocks with a notch, what they may hook into, and the moving sofa in its corridor.
//!
//! Dimensions are in tenths, so that corners are on a grid and lengths of two parts are equal or are not.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::{Part, Point, Vertex};

use super::pen::{Pen, bulge_of, circle_loop, part, rectangle_loop};

fn tenths(n: i32) -> f64 {
    f64::from(n) / 10.0
}

/// A loop of lines by its corners in tenths.
fn corners(all: &[(i32, i32)]) -> Vec<Vertex> {
    all.iter()
        .map(|&(x, y)| Vertex::line(tenths(x), tenths(y)))
        .collect()
}

/// A block above the first axis, from −`half` to `half`, whose notch is the given corners from left to right.
fn notched(name: &str, half: i32, height: i32, notch: Vec<Vertex>) -> Part {
    let mut all = corners(&[(-half, 0)]);
    all.extend(notch);
    all.extend(corners(&[(half, 0), (half, height), (-half, height)]));
    part(name, vec![all])
}

/// A block with a half-round notch of `radius` in its lower side.
pub fn half_round_notch(radius: i32, half: i32, height: i32) -> Part {
    let r = tenths(radius);
    let notch = vec![Vertex::new(-r, 0.0, -1.0), Vertex::line(r, 0.0)];
    notched("half-round notch", half, height, notch)
}

/// A block with a notch in its lower side whose walls are straight for `depth` and whose end is half round.
pub fn u_notch(radius: i32, depth: i32, half: i32, height: i32) -> Part {
    let (r, d) = (tenths(radius), tenths(depth));
    let notch = vec![
        Vertex::line(-r, 0.0),
        Vertex::new(-r, d, -1.0),
        Vertex::line(r, d),
        Vertex::line(r, 0.0),
    ];
    notched("U notch", half, height, notch)
}

/// A block with a pointed notch in its lower side.
pub fn v_notch(mouth: i32, depth: i32, half: i32, height: i32) -> Part {
    let notch = corners(&[(-mouth, 0), (0, depth), (mouth, 0)]);
    notched("V notch", half, height, notch)
}

/// A block with a slot in its lower side that is wider inside: `mouth` and `head` are half widths, `neck` and `depth` where the
/// head begins and ends.
pub fn t_slot(mouth: i32, neck: i32, head: i32, depth: i32, half: i32, height: i32) -> Part {
    let notch = corners(&[
        (-mouth, 0),
        (-mouth, neck),
        (-head, neck),
        (-head, depth),
        (head, depth),
        (head, neck),
        (mouth, neck),
        (mouth, 0),
    ]);
    notched("T-slot", half, height, notch)
}

/// A block with a slot in its lower side that widens from the half width `mouth` to `head`.
pub fn dovetail(mouth: i32, head: i32, depth: i32, half: i32, height: i32) -> Part {
    let notch = corners(&[(-mouth, 0), (-head, depth), (head, depth), (mouth, 0)]);
    notched("dovetail", half, height, notch)
}

/// An L of two arms of width 1, each `arm` tenths long from the outer corner at the origin.
pub fn l_shape(arm: i32) -> Part {
    part("L", vec![l_loop(arm)])
}

fn l_loop(arm: i32) -> Vec<Vertex> {
    corners(&[(0, 0), (arm, 0), (arm, 10), (10, 10), (10, arm), (0, arm)])
}

/// A square block from which an L of two arms of width 1 is cut out, each `arm` tenths long from the outer corner at the origin.
pub fn corridor(arm: i32) -> Part {
    let (low, high) = (-1.0, tenths(arm) + 1.0);
    let block = rectangle_loop(Point::new(low, low), Point::new(high, high));
    part("corridor", vec![block, l_loop(arm)])
}

/// A U with a gap of `gap` tenths, walls 1 thick, 3 high.
pub fn u_shape(gap: i32) -> Part {
    let g = gap;
    let outline = [
        (0, 0),
        (g + 20, 0),
        (g + 20, 30),
        (g + 10, 30),
        (g + 10, 10),
        (10, 10),
        (10, 30),
        (0, 30),
    ];
    part("U", vec![corners(&outline)])
}

/// A T whose stem and head have these half widths in tenths; the head is `thick`, the stem 1 long.
pub fn t_shape(stem: i32, head: i32, thick: i32) -> Part {
    let outline = [
        (-stem, 0),
        (stem, 0),
        (stem, 10),
        (head, 10),
        (head, 10 + thick),
        (-head, 10 + thick),
        (-head, 10),
        (-stem, 10),
    ];
    part("T", vec![corners(&outline)])
}

/// A comb with teeth 2 long, `tooth` tenths wide and `gap` tenths apart.
pub fn comb(teeth: i32, tooth: i32, gap: i32) -> Part {
    let step = tooth + gap;
    let width = teeth * step - gap;
    let mut outline = vec![(width, 0), (width, 10), (0, 10)];
    for i in 0..teeth {
        let (left, right) = (i * step, i * step + tooth);
        outline.extend([(left, 0), (left, -20), (right, -20), (right, 0)]);
    }
    // The first tooth's left and the last one's right side go on from the back's.
    outline.retain(|&c| c != (0, 0) && c != (width, 0));
    part("comb", vec![corners(&outline)])
}

/// Hammersley's sofa for a corner of width 1, enlarged by `scale`: at 1 it touches both inner and outer walls during
/// the whole turn.
pub fn sofa(scale: f64) -> Part {
    let hollow = scale * 2.0 / PI;
    let quarter = bulge_of(FRAC_PI_2);
    part(
        "sofa",
        vec![
            Pen::at(-scale - hollow, 0.0)
                .line(-hollow, 0.0)
                .arc(hollow, 0.0, -1.0)
                .line(hollow + scale, 0.0)
                .arc(hollow, scale, quarter)
                .line(-hollow, scale)
                .close_arc(quarter),
        ],
    )
}

/// An aluminium profile 20 by 20 with a V-slot in each side and a hole in the middle, corners rounded.
pub fn v_slot_profile() -> Part {
    const HALF: f64 = 10.0;
    // From the lower corner of the right side up, and what each is rounded by.
    let slot = [
        (HALF, -HALF, 1.5),
        (HALF, -4.58, 0.2),
        (8.545, -3.125, 0.15),
        (8.2, -3.125, 0.15),
        (8.2, -5.5, 0.3),
        (6.56, -5.5, 0.3),
        (3.9, -2.84, 0.5),
        (3.9, 2.84, 0.5),
        (6.56, 5.5, 0.3),
        (8.2, 5.5, 0.3),
        (8.2, 3.125, 0.15),
        (8.545, 3.125, 0.15),
        (HALF, 4.58, 0.2),
    ];
    let turned = |(x, y): (f64, f64), quarters: usize| match quarters {
        0 => (x, y),
        1 => (-y, x),
        2 => (-x, -y),
        _ => (y, -x),
    };
    let (outline, radii): (Vec<Vertex>, Vec<f64>) = (0..4)
        .flat_map(|quarters| {
            slot.map(|(x, y, radius)| {
                let (x, y) = turned((x, y), quarters);
                (Vertex::line(x, y), radius)
            })
        })
        .unzip();
    let outline = rounded_corners(&outline, |i| radii[i]);
    part(
        "V-slot profile",
        vec![outline, circle_loop(Point::ORIGIN, 2.1)],
    )
}

/// The part whose corners between lines are arcs of `radius`, or of less where a line is too short.
#[must_use]
pub fn filleted(of: &Part, radius: f64) -> Part {
    let loops = of.loops().iter();
    let rounded = loops.map(|l| rounded_corners(l.vertices(), |_| radius));
    part(of.name(), rounded.collect())
}

/// A loop whose corners between lines are arcs, each of at most its own radius.
fn rounded_corners(outline: &[Vertex], radius: impl Fn(usize) -> f64) -> Vec<Vertex> {
    /// Largest share of a line that an arc may take at each of its ends.
    const SHARE: f64 = 0.4;
    let n = outline.len();
    let mut all = Vec::with_capacity(2 * n);
    for (i, &vertex) in outline.iter().enumerate() {
        let (before, after) = (outline[(i + n - 1) % n], outline[(i + 1) % n]);
        if before.bulge != 0.0 || vertex.bulge != 0.0 {
            all.push(vertex);
            continue;
        }
        let corner = vertex.point();
        let (come, go) = (corner - before.point(), after.point() - corner);
        let turn = come.cross(go).atan2(come.dot(go));
        let tangent = (0.5 * turn).tan().abs();
        let (coming, going) = (come.length(), go.length());
        let cut = (radius(i) * tangent).min(SHARE * coming.min(going));
        let (from, to) = (corner - come * (cut / coming), corner + go * (cut / going));
        all.push(Vertex::new(from.x, from.y, bulge_of(turn)));
        all.push(Vertex::line(to.x, to.y));
    }
    all
}
