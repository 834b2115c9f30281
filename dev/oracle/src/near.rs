//! Configurations close to contact, where mistakes show.

use core::f64::consts::PI;

use cspace::{Configuration, Point, Vector};
use rand::Rng;

use crate::{Oracle, Verdict};

/// Configuration at a known distance from contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearContact {
    /// The configuration.
    pub configuration: Configuration,
    /// Whether it is on the free side.
    pub free: bool,
    /// Displacement from contact: a length as a share of the pair's size, or an angle in radians. The nearest contact
    /// is no farther than that, but may be nearer.
    pub step: f64,
    /// Whether it was moved by turning alone: in θ only, or about its own centre if drawn far from its origin.
    pub turned: bool,
    /// Verdict of the oracle on it; certain.
    pub verdict: Verdict,
    /// The contact it was moved from, to about 1e-14 of the size: free itself.
    pub contact: Configuration,
}

/// The steps from contact, as shares of the pair's size.
const STEPS: [f64; 6] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// About `n` configurations near contact, on both sides of it, four at each of several random places of contact space;
/// fewer if the pair has hardly any contacts.
pub fn near_contact(oracle: &Oracle, rng: &mut impl Rng, n: usize) -> Vec<NearContact> {
    near_contact_about(oracle, &[], rng, n)
}

/// As [`near_contact`], with half of the searches beginning near the given configurations, as near as 1e-7 of the size:
/// for pockets of free space that would never be met by chance.
pub fn near_contact_about(
    oracle: &Oracle,
    about: &[Configuration],
    rng: &mut impl Rng,
    n: usize,
) -> Vec<NearContact> {
    let mut found = Vec::new();
    for _ in 0..20 * n + 1000 {
        if found.len() >= n {
            break;
        }
        let pivot = pivot(oracle);
        // How near the two ends of a search may be, as a power of ten.
        let (first, nearest) = if !about.is_empty() && rng.random_bool(0.5) {
            let c = about[rng.random_range(0..about.len())];
            (near(oracle, c, rng), -7.0)
        } else {
            (anywhere(oracle, rng), -2.0)
        };
        let path = Path::random(oracle, pivot, first, nearest, rng);
        let overlaps = [0.0, 1.0].map(|s| oracle.judge(path.at(s)).overlap);
        if overlaps[0] != overlaps[1] {
            step_off(oracle, &path, overlaps[0], rng, &mut found);
        }
    }
    found
}

/// The point of the moving part to turn about: its frame's origin, so that turning changes θ alone, unless the part is
/// drawn far from there.
fn pivot(oracle: &Oracle) -> Point {
    let center = oracle.moving_center();
    if center.distance(Point::ORIGIN) > oracle.size() {
        center
    } else {
        Point::ORIGIN
    }
}

/// A configuration at random anywhere the parts may meet.
fn anywhere(oracle: &Oracle, rng: &mut impl Rng) -> Configuration {
    let (at, size) = (oracle.fixed_center(), oracle.size());
    let mut share = || size * rng.random_range(-1.0..1.0);
    let at = Point::new(at.x + share(), at.y + share());
    carrying(oracle.moving_center(), at, rng.random_range(-PI..PI))
}

/// A configuration at random about another.
fn near(oracle: &Oracle, c: Configuration, rng: &mut impl Rng) -> Configuration {
    let scale = 10f64.powf(rng.random_range(-7.0..0.0));
    let mut share = || scale * rng.random_range(-1.0..1.0);
    let (dx, dy, turn) = (share(), share(), share());
    let size = oracle.size();
    Configuration::new(c.x + size * dx, c.y + size * dy, c.theta + turn)
}

/// The configuration of the given orientation that takes a point of the moving part to one of the fixed part.
fn carrying(q: Point, to: Point, theta: f64) -> Configuration {
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(q);
    Configuration::new(to.x - turned.x, to.y - turned.y, theta)
}

/// A motion along which a point of the moving part goes straight, or stays while the part turns about it.
struct Path {
    pivot: Point,
    from: Point,
    by: Vector,
    theta: f64,
    turn: f64,
    /// Length of the displacement, as a share of the pair's size, or its angle.
    length: f64,
}

impl Path {
    fn random(
        oracle: &Oracle,
        pivot: Point,
        first: Configuration,
        nearest: f64,
        rng: &mut impl Rng,
    ) -> Self {
        let length = 10f64.powf(rng.random_range(nearest..0.0));
        let turns = rng.random_bool(0.4);
        let direction = rng.random_range(-PI..PI);
        let (by, turn) = if turns {
            (Vector::ZERO, length * direction.signum())
        } else {
            (
                Vector::from_angle(direction) * (length * oracle.size()),
                0.0,
            )
        };
        Self {
            pivot,
            from: first.fixed_from_moving(pivot),
            by,
            theta: first.theta,
            turn,
            length,
        }
    }

    fn at(&self, s: f64) -> Configuration {
        carrying(
            self.pivot,
            self.from + self.by * s,
            self.theta + s * self.turn,
        )
    }
}

/// Finds contact on a path whose ends are classified differently, and configurations near it.
fn step_off(
    oracle: &Oracle,
    path: &Path,
    begins_blocked: bool,
    rng: &mut impl Rng,
    found: &mut Vec<NearContact>,
) {
    let (mut blocked, mut free) = if begins_blocked {
        (0.0, 1.0)
    } else {
        (1.0, 0.0)
    };
    while f64::abs(free - blocked) * path.length > 1e-15 {
        let middle = 0.5 * (blocked + free);
        if middle == blocked || middle == free {
            break;
        }
        if oracle.judge(path.at(middle)).overlap {
            blocked = middle;
        } else {
            free = middle;
        }
    }
    for _ in 0..2 {
        let step = STEPS[rng.random_range(0..STEPS.len())];
        for side in [step, -step] {
            let c = path.at(free + side / path.length);
            let verdict = oracle.judge(c);
            if verdict.margin > 1e-12 * oracle.size() {
                found.push(NearContact {
                    configuration: c,
                    free: !verdict.overlap,
                    step,
                    turned: path.turn != 0.0,
                    verdict,
                    contact: path.at(free),
                });
            }
        }
    }
}
