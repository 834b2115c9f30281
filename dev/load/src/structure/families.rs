//! Notches and slots with parts that may hook into them, drawn on a grid, and variants with noise or with rounded
//! fillets.

use std::fmt;

use cspace::{Part, Vertex};
use cspace_oracle::shapes::notches::{
    comb, dovetail, filleted, half_round_notch, l_shape, t_shape, t_slot, u_notch, u_shape, v_notch,
};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{Loops, Specimen};

/// Noise is ten to the power of minus one of these, of the size.
pub(super) const POWERS: std::ops::RangeInclusive<i32> = 2..=12;

/// Coordinates and bulges of fillets are rounded to one of these numbers of decimals.
const DECIMALS: std::ops::RangeInclusive<i32> = 3..=9;

/// Radius of fillets.
const FILLET: f64 = 0.1;

/// Change of a specimen relative to its drawing on a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Change {
    /// No change.
    None,
    /// All vertices are moved by up to 10⁻ⁿ of the size, with the first number n. The second number distinguishes
    /// different displacements.
    Noise(i32, u32),
    /// Corners are arcs.
    Filleted,
    /// Corners are arcs, and numbers are rounded to a number of decimals: joints are not quite smooth.
    Rounded(i32),
}

impl Change {
    /// Kind of the change: all noise of one size is one kind.
    pub fn kind(self) -> Self {
        match self {
            Self::Noise(power, _) => Self::Noise(power, 0),
            other => other,
        }
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.pad("as drawn"),
            Self::Noise(power, 0) => f.pad(&format!("noise 1e-{power:02}")),
            Self::Noise(power, k) => f.pad(&format!("noise 1e-{power:02} #{k}")),
            Self::Filleted => f.pad("fillets"),
            Self::Rounded(decimals) => f.pad(&format!("fillets, {decimals} decimals")),
        }
    }
}

/// The kinds of notches, each in twelve dimensions.
fn notches() -> [(&'static str, Vec<Part>); 5] {
    // Radius, half width, height.
    let half_round = [
        (2, 5, 5),
        (3, 5, 5),
        (4, 5, 10),
        (5, 10, 10),
        (2, 10, 5),
        (5, 15, 10),
        (10, 15, 15),
        (5, 10, 20),
        (4, 6, 8),
        (5, 6, 7),
        (3, 10, 6),
        (1, 2, 2),
    ];
    // Radius, straight depth, half width, height.
    let u = [
        (5, 5, 10, 15),
        (5, 10, 10, 20),
        (5, 10, 15, 20),
        (5, 15, 15, 30),
        (4, 6, 10, 15),
        (6, 10, 10, 20),
        (10, 10, 20, 30),
        (10, 20, 20, 40),
        (3, 3, 5, 10),
        (5, 7, 8, 15),
        (2, 10, 5, 20),
        (6, 20, 16, 36),
    ];
    // Half mouth, depth, half width, height.
    let v = [
        (5, 5, 10, 10),
        (5, 10, 10, 20),
        (10, 10, 15, 20),
        (10, 5, 15, 10),
        (10, 20, 20, 30),
        (3, 4, 5, 10),
        (5, 12, 10, 20),
        (8, 6, 10, 10),
        (20, 20, 30, 30),
        (6, 8, 10, 15),
        (5, 20, 10, 30),
        (9, 10, 10, 20),
    ];
    // Half mouth, neck, half head, depth, half width, height.
    let t = [
        (5, 10, 10, 20, 20, 30),
        (5, 5, 10, 10, 15, 15),
        (4, 10, 10, 15, 20, 30),
        (5, 10, 11, 16, 20, 30),
        (6, 10, 12, 20, 20, 30),
        (4, 8, 12, 16, 20, 20),
        (5, 10, 15, 25, 20, 40),
        (10, 10, 15, 20, 20, 30),
        (5, 5, 15, 15, 20, 20),
        (5, 8, 12, 20, 20, 25),
        (3, 5, 8, 12, 15, 16),
        (6, 12, 18, 30, 30, 40),
    ];
    // Half mouth, half head, depth, half width, height.
    let dovetails = [
        (5, 10, 10, 20, 20),
        (5, 8, 10, 15, 20),
        (5, 10, 5, 15, 10),
        (10, 15, 10, 20, 20),
        (4, 10, 8, 15, 15),
        (6, 12, 8, 20, 15),
        (5, 15, 10, 20, 20),
        (5, 6, 10, 10, 20),
        (10, 20, 20, 30, 30),
        (3, 9, 8, 12, 12),
        (10, 12, 20, 20, 30),
        (8, 14, 8, 20, 16),
    ];
    let u = u.map(|(r, d, w, h)| u_notch(r, d, w, h));
    let v = v.map(|(m, d, w, h)| v_notch(m, d, w, h));
    let t = t.map(|(m, n, b, d, w, h)| t_slot(m, n, b, d, w, h));
    let half_round = half_round.map(|(r, w, h)| half_round_notch(r, w, h));
    let dovetails = dovetails.map(|(m, b, d, w, h)| dovetail(m, b, d, w, h));
    [
        ("half-round notch", half_round.to_vec()),
        ("U notch", u.to_vec()),
        ("V notch", v.to_vec()),
        ("T-slot", t.to_vec()),
        ("dovetail", dovetails.to_vec()),
    ]
}

/// Adds all notches with an L, a U, a T, a comb and themselves: as drawn, with noise of all sizes `times` times each,
/// and with exact and rounded fillets.
pub(super) fn add(all: &mut Vec<Specimen>, seed: u64, times: u32) {
    let others = [
        ("L", l_shape(40)),
        ("U", u_shape(10)),
        ("T", t_shape(4, 10, 5)),
        ("comb", comb(4, 10, 10)),
    ];
    let mut drawn = Vec::new();
    let mut rounded = Vec::new();
    for (family, notches) in notches() {
        for (i, notch) in (1..).zip(&notches) {
            let against = others.iter().map(|(name, part)| (*name, part));
            for (name, fixed) in against.chain([("itself", notch)]) {
                let name = format!("{family} {i} and {name}");
                drawn.push(Specimen::new(family, &name, fixed, notch));
                let [fixed, moving] = [fixed, notch].map(|p| filleted(p, FILLET));
                rounded.push(Specimen {
                    change: Change::Filleted,
                    ..Specimen::new(family, &name, &fixed, &moving)
                });
            }
        }
    }
    all.extend(drawn.iter().cloned());
    for power in POWERS {
        for k in 0..times {
            all.extend(
                drawn
                    .iter()
                    .map(|s| noisy(s, Change::Noise(power, k), seed)),
            );
        }
    }
    all.extend(rounded.iter().cloned());
    for decimals in DECIMALS {
        all.extend(rounded.iter().map(|s| cut(s, decimals)));
    }
}

/// Specimen with all vertices moved; deterministic for a seed, independent of other specimens.
pub(super) fn noisy(of: &Specimen, change: Change, seed: u64) -> Specimen {
    let Change::Noise(power, k) = change else {
        return of.clone();
    };
    let named = format!("{} {power} {k}", of.name);
    let mut rng = ChaCha8Rng::seed_from_u64(seed ^ hash(&named));
    let mut moved = |loops: &Loops| -> Loops {
        let by = 10f64.powi(-power) * size(loops);
        let mut step = || by * rng.random_range(-1.0..=1.0);
        let vertex = |v: &Vertex| Vertex::new(v.x + step(), v.y + step(), v.bulge);
        mapped(loops, vertex)
    };
    Specimen {
        fixed: moved(&of.fixed),
        moving: moved(&of.moving),
        change,
        ..of.clone()
    }
}

/// The specimen with all numbers rounded.
fn cut(of: &Specimen, decimals: i32) -> Specimen {
    let unit = 10f64.powi(decimals);
    let round = |x: f64| (x * unit).round() / unit;
    let vertex = |v: &Vertex| Vertex::new(round(v.x), round(v.y), round(v.bulge));
    Specimen {
        fixed: mapped(&of.fixed, vertex),
        moving: mapped(&of.moving, vertex),
        change: Change::Rounded(decimals),
        ..of.clone()
    }
}

fn mapped(loops: &Loops, mut f: impl FnMut(&Vertex) -> Vertex) -> Loops {
    let mut one = |l: &Vec<Vertex>| l.iter().map(&mut f).collect();
    loops.iter().map(&mut one).collect()
}

/// The longer side of the box about the vertices.
fn size(loops: &Loops) -> f64 {
    let side = |coordinate: fn(&Vertex) -> f64| {
        let all = || loops.iter().flatten().map(coordinate);
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    };
    side(|v| v.x).max(side(|v| v.y))
}

/// The 64-bit FNV-1a hash: the same on all machines and in all versions.
fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| {
        (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3)
    })
}
