//! Positions with exact fits, judged by brute force, over outlines that favour ties and families that run into the degenerate.

use core::f64::consts::PI;

use cspace::{Configuration, NoFit, Point, Slice};
use cspace_load::Source;
use cspace_oracle::{Case, Oracle};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// Margin above which a verdict counts, as a share of the pair's size: parts that overlap by less than 9e-10 of the
/// larger one's radius are taken to fit.
const CERTAIN: f64 = 4e-9;

/// Curves are known to this, as a share of the pair's size, unless they are tangent to others.
const EXACT: f64 = 1e-11;

/// Curves that are tangent to the next end at a place that is known to this, as a share of the pair's size.
const TANGENT: f64 = 1e-6;

#[derive(Default)]
struct Counts {
    slices: u32,
    doubtful: u32,
    asked: u32,
    points: u32,
    /// Places of curves that are farther from contact than [`EXACT`].
    off: u32,
    parts: u32,
    /// Number of parts that are not found to fit into a frame of their own shape.
    missed: u32,
    wrong: Vec<String>,
}

fn check(number: u64, case: &Case, rng: &mut ChaCha8Rng, counts: &mut Counts) {
    let (fixed, moving) = (&case.fixed, &case.moving);
    let oracle = Oracle::new(fixed, moving);
    let size = oracle.size();
    let no_fit = NoFit::new(fixed, moving);
    for k in 0..4 {
        let theta = match k {
            0 => 0.0,
            1 => f64::from(rng.random_range(-12..=12)) * (PI / 12.0),
            2 if !case.notable.is_empty() => case.notable[0].theta,
            _ => rng.random_range(-PI..PI),
        };
        let slice = no_fit.at(theta);
        counts.slices += 1;
        counts.doubtful += u32::from(slice.doubtful);
        if slice.doubtful {
            continue;
        }
        let ask = |p: Point, counts: &mut Counts| {
            let c = Configuration::new(p.x, p.y, theta);
            let verdict = oracle.judge(c);
            if verdict.margin > CERTAIN * size {
                counts.asked += 1;
                if slice.is_free(p) == verdict.overlap {
                    counts
                        .wrong
                        .push(format!("pair {number} at {c}: {verdict:?}"));
                }
            }
        };
        for c in slice.curves.iter().take(40) {
            let s = rng.random_range(0.0..1.0);
            let (on, normal) = (c.geometry.point(s), c.geometry.free_normal(s));
            // In contact, wherever it is: nothing overlaps on the boundary, slits and points among it.
            let at = Configuration::new(on.x, on.y, theta);
            let verdict = oracle.judge(at);
            counts.points += u32::from(c.geometry.length() == 0.0);
            if verdict.margin > TANGENT * size {
                counts
                    .wrong
                    .push(format!("pair {number} at {at}, a curve: {verdict:?}"));
            }
            counts.off += u32::from(verdict.margin > EXACT * size);
            for step in [1e-7, 1e-5, 1e-3] {
                let step = step * size;
                ask(on + normal * step, counts);
                ask(on + -(normal * step), counts);
            }
        }
        for _ in 0..20 {
            let mut coordinate = || rng.random_range(-1.0..1.0) * size;
            let by = cspace::Vector::new(coordinate(), coordinate());
            let turned = cspace::Rotation::by(theta) * oracle.moving_center().to_vector();
            ask(oracle.fixed_center() + by + -turned, counts);
        }
    }
}

/// Tests a part in a frame of its own shape, which fits where it was drawn, in as many places at once as it has loops:
/// this is sometimes missed where the contacts of several loops coincide.
fn fits_itself(number: u64, case: &Case, counts: &mut Counts) {
    let part = &case.moving;
    let fits: Slice = NoFit::within(part, part).at(0.0);
    let near = fits.nearest(Point::ORIGIN);
    counts.parts += 1;
    match near.map(|n| n.1.distance(Point::ORIGIN)) {
        None => counts.missed += 1,
        // Not drawn again, and said to be doubtful.
        Some(_) if fits.doubtful => counts.missed += 1,
        Some(d) if d > 1e-10 * part.size() => {
            counts.wrong.push(format!("part {number} fits at {d}"));
        }
        Some(_) => {}
    }
}

#[test]
fn positions_are_judged() {
    let number =
        |name: &str, default: u64| std::env::var(name).map_or(default, |n| n.parse().unwrap());
    let (seed, pairs) = (number("CSPACE_SEED", 1), number("CSPACE_PAIRS", 100));
    let source = Source::new(seed, None).unwrap();
    let mut counts = Counts::default();
    for k in 0..pairs {
        let mut drawn = source.draw(k);
        let Ok(case) = drawn.case else { continue };
        // Parts of thousands of edges are for the kernel's own tests.
        if case.fixed.edges().count() * case.moving.edges().count() > 4000 {
            continue;
        }
        check(k, &case, &mut drawn.rng, &mut counts);
        fits_itself(k, &case, &mut counts);
    }
    let Counts {
        slices,
        doubtful,
        asked,
        points,
        off,
        parts,
        missed,
        wrong,
    } = counts;
    println!(
        "{slices} slices, {doubtful} doubtful; {asked} positions asked, {points} exact fits, {off} places off by more than {EXACT}"
    );
    println!("{parts} parts, {missed} not found to fit into themselves");
    for w in wrong.iter().take(20) {
        println!("{w}");
    }
    assert!(wrong.is_empty() && asked > 100 * pairs as u32);
    assert!(doubtful * 50 < slices && off * 1000 < asked && missed * 12 < parts);
}
