//! Configurations close to contact, where mistakes show.

use core::f64::consts::PI;

use cspace::{Configuration, Point};
use rand::Rng;

use crate::{Oracle, Verdict};

/// A configuration a known way from contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearContact {
    /// The configuration.
    pub configuration: Configuration,
    /// Whether it is on the free side.
    pub free: bool,
    /// How far it was moved from contact, as a share of the pair's size: lengths over it, or radians. Its distance to
    /// contact is at most that.
    pub step: f64,
    /// Whether it was moved by turning alone.
    pub turned: bool,
    /// What the oracle says of it; certain.
    pub verdict: Verdict,
    /// The contact it was moved from, to about 1e-14 of the size: free itself.
    pub contact: Configuration,
}

/// The steps from contact, as shares of the pair's size.
const STEPS: [f64; 6] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// At least `n` configurations near contact, on both sides of it, at random places of contact space; fewer when the
/// pair has hardly any contact to be found.
pub fn near_contact(oracle: &Oracle, rng: &mut impl Rng, n: usize) -> Vec<NearContact> {
    near_contact_about(oracle, &[], rng, n)
}

/// As [`near_contact`], where half of the searches begin about the given configurations, as near as 1e-7 of the size: for pockets
/// of free space that would never be met by chance.
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
        let first = start(oracle, about, rng);
        let turning = rng.random_bool(0.3);
        let second = other(oracle, first, turning, rng);
        let overlaps = [first, second].map(|c| oracle.judge(c).overlap);
        let (blocked, free) = match overlaps {
            [true, false] => (first, second),
            [false, true] => (second, first),
            _ => continue,
        };
        step_off(oracle, blocked, free, &mut found);
    }
    found
}

/// The configuration a share of the way from one to another.
fn on_the_way(a: Configuration, b: Configuration, s: f64) -> Configuration {
    Configuration::new(
        a.x + s * (b.x - a.x),
        a.y + s * (b.y - a.y),
        a.theta + s * (b.theta - a.theta),
    )
}

/// A random configuration: anywhere the parts may meet, or about one of those given.
fn start(oracle: &Oracle, about: &[Configuration], rng: &mut impl Rng) -> Configuration {
    let size = oracle.size();
    if !about.is_empty() && rng.random_bool(0.5) {
        let c = about[rng.random_range(0..about.len())];
        let scale = 10f64.powf(rng.random_range(-7.0..0.0));
        let mut share = || scale * rng.random_range(-1.0..1.0);
        return Configuration::new(
            c.x + size * share(),
            c.y + size * share(),
            c.theta + share(),
        );
    }
    // Seen from its centre, so that parts drawn anywhere meet.
    let theta = rng.random_range(-PI..PI);
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(oracle.moving_center());
    let at: Point = oracle.fixed_center();
    Configuration::new(
        at.x - turned.x + size * rng.random_range(-1.0..1.0),
        at.y - turned.y + size * rng.random_range(-1.0..1.0),
        theta,
    )
}

/// Another configuration, near or far, of the same orientation, or of the same place when `turning`.
fn other(oracle: &Oracle, c: Configuration, turning: bool, rng: &mut impl Rng) -> Configuration {
    let scale = 10f64.powf(rng.random_range(-7.0..0.0));
    let direction = rng.random_range(-PI..PI);
    if turning {
        // About the moving part's centre, not its frame's origin.
        let q = c.fixed_from_moving(oracle.moving_center());
        let theta = c.theta + scale * direction;
        let p = Configuration::new(0.0, 0.0, theta).fixed_from_moving(oracle.moving_center());
        let moved = Configuration::new(q.x - p.x, q.y - p.y, theta);
        let far = oracle.moving_center().distance(Point::ORIGIN) > oracle.size();
        return if far {
            moved
        } else {
            Configuration::new(c.x, c.y, theta)
        };
    }
    let length = scale * oracle.size();
    Configuration::new(
        c.x + length * direction.cos(),
        c.y + length * direction.sin(),
        c.theta,
    )
}

fn step_off(
    oracle: &Oracle,
    mut blocked: Configuration,
    mut free: Configuration,
    found: &mut Vec<NearContact>,
) {
    let size = oracle.size();
    let (dx, dy, turn) = (
        free.x - blocked.x,
        free.y - blocked.y,
        free.theta - blocked.theta,
    );
    let length = (dx.hypot(dy) / size).max(turn.abs());
    let mut left = length;
    while left > 1e-15 {
        let middle = on_the_way(blocked, free, 0.5);
        if middle == blocked || middle == free {
            break;
        }
        if oracle.judge(middle).overlap {
            blocked = middle;
        } else {
            free = middle;
        }
        left *= 0.5;
    }
    for step in STEPS {
        for side in [step, -step] {
            let s = side / length;
            let c = Configuration::new(free.x + s * dx, free.y + s * dy, free.theta + s * turn);
            let verdict = oracle.judge(c);
            if verdict.margin > 1e-12 * size {
                found.push(NearContact {
                    configuration: c,
                    free: !verdict.overlap,
                    step,
                    turned: turn != 0.0,
                    verdict,
                    contact: free,
                });
            }
        }
    }
}
