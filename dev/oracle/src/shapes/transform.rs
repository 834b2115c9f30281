//! Parts made from parts.

use cspace::{Part, Rotation, Vector, Vertex};

use super::pen::part;

/// The part drawn elsewhere.
pub fn shifted(p: &Part, dx: f64, dy: f64) -> Part {
    mapped(p, |v| {
        let q = v.point() + Vector::new(dx, dy);
        Vertex::new(q.x, q.y, v.bulge)
    })
}

/// The part turned about its frame's origin by `angle` radians.
pub fn turned(p: &Part, angle: f64) -> Part {
    let turn = Rotation::by(angle);
    mapped(p, |v| {
        let q = turn * v.point();
        Vertex::new(q.x, q.y, v.bulge)
    })
}

/// The part `factor` times as large, about its frame's origin.
pub fn scaled(p: &Part, factor: f64) -> Part {
    mapped(p, |v| Vertex::new(factor * v.x, factor * v.y, v.bulge))
}

/// The part mirrored in the second axis: x becomes −x.
pub fn mirrored(p: &Part) -> Part {
    mapped(p, |v| Vertex::new(-v.x, v.y, -v.bulge))
}

/// Copy of a part with its loops drawn in the other direction.
pub fn backwards(p: &Part) -> Part {
    let loops = p.loops().iter().map(|l| {
        let v = l.vertices();
        let n = v.len();
        (0..n)
            .rev()
            .map(|i| Vertex::new(v[(i + 1) % n].x, v[(i + 1) % n].y, -v[i].bulge))
            .collect()
    });
    part(p.name(), loops.collect())
}

/// Part made of the loops of several.
pub fn together(name: &str, parts: &[Part]) -> Part {
    let loops = parts.iter().flat_map(Part::loops);
    part(name, loops.map(|l| l.vertices().to_vec()).collect())
}

fn mapped(p: &Part, f: impl Fn(&Vertex) -> Vertex) -> Part {
    let loops = p.loops().iter();
    part(
        p.name(),
        loops
            .map(|l| l.vertices().iter().map(&f).collect())
            .collect(),
    )
}
