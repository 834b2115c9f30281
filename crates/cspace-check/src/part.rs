//! A part, and certain tests of whether a disc lies within its material.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::interval::{I, exact};

/// A part: closed loops of vertices x, y, bulge; the material is their even-odd inside, or that of the loops of each layer at its heights.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Part {
    /// Name of the part.
    pub name: String,
    /// The bulge tan(sweep/4) is of the edge that leaves the vertex; 0 for a line.
    pub loops: Vec<Vec<[f64; 3]>>,
    /// The layers, which have all loops one after another; none of a part that is one outline at every height.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
}

/// A layer of a part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Layer {
    /// The lowest and the highest place; none for every height.
    pub z: Option<[f64; 2]>,
    /// How many loops it has.
    pub loops: usize,
}

impl Layer {
    /// Whether two layers overlap in height by more than nothing.
    pub fn meets(&self, other: &Self) -> bool {
        match (self.z, other.z) {
            (Some([a, b]), Some([c, d])) => a.max(c) < b.min(d),
            _ => true,
        }
    }
}

type P = [I; 2];

pub(crate) fn sub(a: P, b: P) -> P {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn norm(a: P) -> I {
    (a[0].square() + a[1].square()).sqrt()
}

fn cross(a: P, b: P) -> I {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: P, b: P) -> I {
    a[0] * b[0] + a[1] * b[1]
}

/// A number that the distance from a point to an edge is not less than.
fn distance(p: P, [ax, ay, bulge]: [f64; 3], [bx, by, _]: [f64; 3]) -> f64 {
    let (a, b) = ([exact(ax), exact(ay)], [exact(bx), exact(by)]);
    let (chord, to) = (sub(b, a), sub(p, a));
    let along = dot(chord, to);
    let line = if along.hi < 0.0 {
        norm(to).lo
    } else if (along - dot(chord, chord)).lo > 0.0 {
        norm(sub(p, b)).lo
    } else {
        (cross(chord, to).abs() * norm(chord).recip()).lo
    };
    if bulge == 0.0 {
        return line;
    }
    // An arc is nowhere farther from its chord than in its middle: |bulge| chord / 2. It also lies on its circle.
    let k = exact(bulge);
    let beside = (exact(line) - k.abs() * norm(chord) * exact(0.5)).lo;
    let lift = (exact(1.0) - k.square()) * (exact(4.0) * k).recip();
    let half = exact(0.5);
    let center = [
        (a[0] + b[0]) * half - chord[1] * lift,
        (a[1] + b[1]) * half + chord[0] * lift,
    ];
    let radius = norm(chord) * (exact(1.0) + k.square()) * (exact(4.0) * k.abs()).recip();
    let (from, reach) = (sub(p, center), norm(sub(p, center)));
    let scale = radius * reach.recip();
    let nearest = [center[0] + from[0] * scale, center[1] + from[1] * scale];
    let circle = if (cross(chord, sub(nearest, a)) * k).sign() == Some(true) {
        // The circle's nearest point is on the other side of the chord.
        norm(to).lo.min(norm(sub(p, b)).lo)
    } else {
        (reach - radius).abs().lo
    };
    beside.max(circle)
}

/// Whether a half line from the point to +x crosses an edge, with its arc replaced by chords closer to it than `near`.
fn crosses(p: [f64; 2], a: [f64; 3], b: [f64; 3], near: f64) -> Option<bool> {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    if a[2].abs() * dx.hypot(dy) > near {
        // The two halves: the middle lies on the right of the chord by bulge · chord / 2.
        let half = a[2] / (1.0 + (1.0 + a[2] * a[2]).sqrt());
        let (x, y) = (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
        let middle = [x + 0.5 * a[2] * dy, y - 0.5 * a[2] * dx, half];
        let halves = (
            crosses(p, [a[0], a[1], half], middle, near)?,
            crosses(p, middle, b, near)?,
        );
        return Some(halves.0 ^ halves.1);
    }
    if (a[1] > p[1]) == (b[1] > p[1]) {
        return Some(false);
    }
    let [a, b, p] = [[a[0], a[1]], [b[0], b[1]], p].map(|c| c.map(exact));
    Some(cross(sub(b, a), sub(p, a)).sign()? == (b[1].lo > a[1].lo))
}

impl Part {
    /// The layers, with the numbers of their loops; one at every height where none are given.
    ///
    /// # Errors
    /// If they have not as many loops as the part.
    pub fn stack(&self) -> Result<Vec<(Layer, Range<usize>)>, String> {
        let (z, loops) = (None, self.loops.len());
        let whole = [Layer { z, loops }];
        let layers = match self.layers[..] {
            [] => &whole,
            _ => &self.layers[..],
        };
        let mut stack = Vec::with_capacity(layers.len());
        let mut first = 0_usize;
        for layer in layers {
            let end = first.checked_add(layer.loops).filter(|&end| end <= loops);
            let end = end.ok_or_else(|| self.wrong_layers())?;
            stack.push((*layer, first..end));
            first = end;
        }
        (first == loops)
            .then_some(stack)
            .ok_or_else(|| self.wrong_layers())
    }

    fn wrong_layers(&self) -> String {
        format!(
            "the layers of {} have not as many loops as it has",
            self.name
        )
    }

    /// Radius of a disc about a point that certainly lies within the material of some of the loops, about as large as possible; 0 if there
    /// is none.
    ///
    /// No edge is nearer to the centre than the radius. So an odd-even count with chords within half a radius of the
    /// arcs determines whether the centre is inside: between the arcs and these chords no loop passes the centre.
    pub fn room(&self, loops: Range<usize>, center: [f64; 2]) -> f64 {
        /// Smallest radius that is tried, as a share of the part's extent: chords are rounded.
        const LEAST: f64 = 1e-12;
        let vertices = self.loops.iter().flatten();
        let extent = vertices.fold(0.0_f64, |m, v| m.max(v[0].abs() + v[1].abs()));
        let edges = || {
            let of = |l: &'_ [[f64; 3]], i: usize| (l[i], l[(i + 1) % l.len()]);
            (self.loops[loops.clone()].iter())
                .flat_map(move |l| (0..l.len()).map(move |i| of(l, i)))
        };
        let apart = edges().map(|(a, b)| distance(center.map(exact), a, b));
        // A result that is not a number is kept.
        let least = |m: f64, d: f64| if m.is_nan() || m <= d { m } else { d };
        let room = apart.fold(f64::INFINITY, least);
        if !(room > LEAST * extent && room.is_finite()) {
            return 0.0;
        }
        let mut inside = false;
        for (a, b) in edges() {
            match crosses(center, a, b, 0.5 * room) {
                Some(odd) => inside ^= odd,
                None => return 0.0,
            }
        }
        if inside { room } else { 0.0 }
    }
}
