//! A contact space computed with symmetry equals the one computed without.

use core::f64::consts::TAU;

use cspace::{
    BoundaryKind, Classification, Classifier, Configuration, ContactSpace, FeatureName, Options,
    Part, Patch, PatchId, RegionId, Symmetry, Vertex,
};
use cspace_oracle::shapes::*;
use cspace_oracle::{Oracle, effort, near_contact, pairs};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Tolerance of orientations, radians.
const SAME: f64 = 1e-9;

/// Tolerance where a pin fills its socket: quantities that grow with the square of the orientation are known to the root of the rounding.
const SAME_AT_TIES: f64 = 1e-7;

fn tolerance(name: &str) -> f64 {
    let tie = name.contains("pegs") || name.contains("equal radius");
    if tie { SAME_AT_TIES } else { SAME }
}

fn computed(fixed: &Part, moving: &Part, window: Option<(f64, f64)>) -> [ContactSpace; 2] {
    [Symmetry::Detect, Symmetry::Ignore].map(|symmetry| {
        let options = Options { window, symmetry };
        ContactSpace::compute(fixed, moving, &options).unwrap()
    })
}

/// Identity of a patch without its numbers: features, kinds of bounds, and whether it goes around the turn.
type Label = (FeatureName, FeatureName, BoundaryKind, BoundaryKind, bool);

fn label(space: &ContactSpace, i: PatchId) -> Label {
    let p = space.patch(i).unwrap();
    let Patch {
        fixed,
        moving,
        lo,
        hi,
        ..
    } = *p.data();
    let around = hi - lo > TAU - SAME;
    (fixed, moving, p.left().kind(), p.right().kind(), around)
}

/// For every patch of one space, the equal patch of the other.
///
/// Patches are equal if they have one label, over equal orientations up to whole turns, and their middles coincide.
fn matched(a: &ContactSpace, b: &ContactSpace, name: &str) -> Vec<PatchId> {
    let sorted = |space: &ContactSpace| {
        let mut all: Vec<(Label, PatchId)> = (0..space.patches().len() as u32)
            .map(PatchId)
            .map(|i| (label(space, i), i))
            .collect();
        all.sort_by_key(|x| format!("{:?}", x.0));
        all
    };
    let (left, right) = (sorted(a), sorted(b));
    let labels = |all: &[(Label, PatchId)]| all.iter().map(|x| x.0).collect::<Vec<_>>();
    assert_eq!(left.len(), right.len(), "{name}: numbers of patches");
    assert!(
        labels(&left) == labels(&right),
        "{name}: features of patches"
    );
    let known_to = tolerance(name);
    let size = a.fixed().size().max(a.moving().size());
    let middle = |space: &ContactSpace, i: PatchId, theta: f64| {
        let p = space.patch(i).unwrap();
        let (l, r) = (p.left().at(theta), p.right().at(theta));
        l.position().midpoint(r.position())
    };
    let mut to = vec![PatchId(u32::MAX); left.len()];
    for (of_a, of_b) in left
        .chunk_by(|x, y| x.0 == y.0)
        .zip(right.chunk_by(|x, y| x.0 == y.0))
    {
        let mut free: Vec<PatchId> = of_b.iter().map(|x| x.1).collect();
        for &(label, i) in of_a {
            let p = a.patches()[i.index()];
            let theta = 0.5 * (p.lo + p.hi);
            let same = |&j: &PatchId| {
                let q = b.patches()[j.index()];
                let off = |x: f64, y: f64| (x - y - TAU * ((x - y) / TAU).round()).abs();
                let times = label.4 || (off(p.lo, q.lo) <= known_to && off(p.hi, q.hi) <= known_to);
                // Curves that coincide at a critical orientation cross at small angles during such a patch.
                let known = 1e-8 + 1e-13 / (p.hi - p.lo);
                times && middle(a, i, theta).distance(middle(b, j, theta)) <= known * size
            };
            let k = free.iter().position(same);
            assert!(k.is_some(), "{name}: {label:?} {p:?} is missing");
            to[i.index()] = free.swap_remove(k.unwrap());
        }
    }
    to
}

/// Checks that links of one space are links of the other, between the same patches; those of patches that go around may be cut elsewhere.
fn same_links(a: &ContactSpace, b: &ContactSpace, to: &[PatchId], name: &str) {
    // Three contacts lie on one circle at a critical orientation: the links there depend on the growth of the parts.
    if name.starts_with("three pegs") {
        return;
    }
    let around = |space: &ContactSpace, i: PatchId| {
        let p = space.patches()[i.index()];
        p.hi - p.lo > TAU - SAME
    };
    let id = |i: PatchId| i;
    let image = |i: PatchId| to[i.index()];
    let side = |space: &ContactSpace, map: &dyn Fn(PatchId) -> PatchId| {
        let mut all: Vec<(PatchId, PatchId, i64)> = space
            .side_links()
            .iter()
            .filter(|l| !around(space, l.before))
            .map(|l| {
                let p = space.patches()[l.before.index()];
                let after = ((l.lo - p.lo) * 1e7).round() as i64;
                (map(l.before), map(l.after), after)
            })
            .collect();
        all.sort_unstable();
        all
    };
    same_within_one(&side(a, &image), &side(b, &id), &format!("{name}: side"));
    let vertical = |space: &ContactSpace, map: &dyn Fn(PatchId) -> PatchId| {
        let mut all: Vec<(PatchId, PatchId, i64)> = space
            .vertical_links()
            .iter()
            .map(|l| {
                let at = l.theta + 0.4;
                let at = at - TAU * (at / TAU).floor();
                (map(l.lower), map(l.upper), (at * 1e7).round() as i64)
            })
            .collect();
        all.sort_unstable();
        all
    };
    let (v, w) = (vertical(a, &image), vertical(b, &id));
    same_within_one(&v, &w, &format!("{name}: vertical"));
}

/// Checks that links are equal, except that orientations may differ by one unit.
fn same_within_one(a: &[(PatchId, PatchId, i64)], b: &[(PatchId, PatchId, i64)], name: &str) {
    assert_eq!(a.len(), b.len(), "{name} links");
    for (x, y) in a.iter().zip(b) {
        assert!(
            (x.0, x.1) == (y.0, y.1) && (x.2 - y.2).abs() <= 1,
            "{name} link {x:?}, {y:?}"
        );
    }
}

fn same_regions(a: &ContactSpace, b: &ContactSpace, to: &[PatchId], name: &str) {
    assert_eq!(
        a.free_regions().len(),
        b.free_regions().len(),
        "{name}: regions"
    );
    let mut image = vec![None; a.free_regions().len()];
    for (p, &j) in a.patches().iter().zip(to) {
        let region = &mut image[p.region.index()];
        let other = b.patches()[j.index()].region;
        assert!(region.is_none_or(|r| r == other), "{name}: regions");
        *region = Some(other);
    }
    let mut reached: Vec<RegionId> = image.iter().copied().flatten().collect();
    reached.sort_unstable();
    let all = reached.len();
    reached.dedup();
    assert_eq!(reached.len(), all, "{name}: regions");
    for (r, &s) in a.free_regions().iter().zip(&image) {
        assert_eq!(a.classify(r.sample), Some(Classification::Free), "{name}");
        assert_eq!(b.classify(r.sample), Some(Classification::Free), "{name}");
        if let Some(s) = s {
            let other = &b.free_regions()[s.index()];
            assert_eq!(
                (r.unbounded, r.patches),
                (other.unbounded, other.patches),
                "{name}"
            );
        }
    }
}

/// Checks that both spaces agree at random, and near contact with brute force.
fn same_answers(a: &ContactSpace, b: &ContactSpace, n: usize, name: &str) {
    let oracle = Oracle::new(a.fixed(), a.moving());
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let (one, other) = (Classifier::new(a), Classifier::new(b));
    let window = a.window();
    let inside = |theta: f64| window.full_turn || (window.lo..=window.hi).contains(&theta);
    for _ in 0..n / 2 {
        let theta = rng.random_range(window.lo..window.hi);
        let (at, drawn) = (oracle.fixed_center(), oracle.moving_center());
        let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(drawn);
        let mut share = || oracle.size() * rng.random_range(-1.0..1.0);
        let c = Configuration::new(at.x + share() - turned.x, at.y + share() - turned.y, theta);
        assert_eq!(one.classify(c), other.classify(c), "{name} {c:?}");
    }
    // A search for contact may end within the resolution; then free and blocked may both be contact.
    let mut touching = 0;
    for near in near_contact(&oracle, &mut rng, n / 2) {
        let c = near.configuration;
        if !inside(c.theta) {
            continue;
        }
        let expected = if near.verdict.overlap {
            Classification::Blocked
        } else {
            Classification::Free
        };
        for answer in [one.classify(c), other.classify(c)] {
            let contact = answer == Some(Classification::Contact);
            touching += usize::from(contact);
            assert!(
                contact || answer == Some(expected),
                "{name} {answer:?} {c:?}"
            );
        }
    }
    assert!(
        touching <= n / 50,
        "{name}: {touching} of {n} are told to touch"
    );
}

fn compare(name: &str, fixed: &Part, moving: &Part, window: Option<(f64, f64)>, slabs: u32) {
    let [a, b] = computed(fixed, moving, window);
    assert_eq!(a.symmetry().slabs, slabs, "{name}");
    assert_eq!(b.symmetry().slabs, 1, "{name}");
    same_spaces(&a, &b, name);
    same_answers(&a, &b, effort(400, 10_000), name);
}

fn same_spaces(a: &ContactSpace, b: &ContactSpace, name: &str) {
    assert_eq!(
        (a.statistics().conflicts, b.statistics().conflicts),
        (0, 0),
        "{name}"
    );
    assert_eq!(a.features(), b.features(), "{name}");
    let (c, d) = (a.critical_orientations(), b.critical_orientations());
    assert_eq!(c.len(), d.len(), "{name}: critical orientations");
    for (x, y) in c.iter().zip(d) {
        assert!(
            (x - y).abs() <= tolerance(name),
            "{name}: critical orientation {x} {y}"
        );
    }
    let to = matched(a, b, name);
    same_links(a, b, &to, name);
    same_regions(a, b, &to, name);
}

/// A disc with `n` slots from its rim, and a pin on an arm for it.
fn geneva(n: u32) -> (Part, Part) {
    let step = TAU / f64::from(n);
    let (rim, depth, half) = (5.0_f64, 2.0, 0.3);
    let corner = (half / rim).asin();
    let at = |i: u32, x: f64, y: f64| {
        let p = Configuration::new(0.0, 0.0, step * f64::from(i))
            .fixed_from_moving(cspace::Point::new(x, y));
        (p.x, p.y)
    };
    let outer = rim * corner.cos();
    let first = at(0, outer, half);
    let mut pen = Pen::at(first.0, first.1);
    for i in 0..n {
        let turned = [(outer, -half), (depth, -half), (depth, half), (outer, half)]
            .map(|(x, y)| at(i + 1, x, y));
        pen = pen.arc(turned[0].0, turned[0].1, bulge_of(step - 2.0 * corner));
        pen = pen.line(turned[1].0, turned[1].1);
        pen = pen.arc(turned[2].0, turned[2].1, -1.0);
        if i + 1 < n {
            pen = pen.line(turned[3].0, turned[3].1);
        }
    }
    let wheel = part("wheel", vec![pen.close()]);
    (wheel, flatted_disc(0.25, 5.0))
}

#[test]
fn the_ratchet_and_its_pawl() {
    compare("ratchet, pawl", &ratchet(20), &pawl(), None, 20);
    compare("pawl, ratchet", &pawl(), &ratchet(20), None, 20);
    compare("pawl, ratchet 7", &pawl(), &ratchet(7), None, 7);
    compare("ratchet 14, pawl", &ratchet(14), &pawl(), None, 14);
}

#[test]
fn polygons() {
    for (n, m) in [(3, 5), (4, 4), (5, 3), (6, 4), (7, 2), (12, 9)] {
        let fixed = regular_polygon(n, 2.0);
        let hole = plate(10.0, &[&regular_polygon(n, 3.0)]);
        let moving = match m {
            2 => rectangle(1.0, 0.6),
            m => regular_polygon(m, 1.1),
        };
        let slabs = |a: usize, b: usize| (1..).find(|l| l % a == 0 && l % b == 0).unwrap() as u32;
        compare("polygons", &fixed, &moving, None, slabs(n, m));
        let fold = (1..=4).rev().find(|k| 4 % k == 0 && n % k == 0).unwrap();
        compare("polygon in a polygon", &hole, &moving, None, slabs(fold, m));
    }
}

#[test]
fn parts_off_the_origin() {
    let wheel = shifted(&turned(&ratchet(9), 0.4), 12.0, -30.0);
    let other = shifted(&backwards(&regular_polygon(5, 1.0)), -3.0, 20.0);
    compare("wheel, pentagon", &wheel, &other, None, 45);
    compare("pentagon, wheel", &other, &wheel, None, 45);
    let pawl = shifted(&pawl(), 100.0, 40.0);
    compare("pawl, wheel", &pawl, &wheel, None, 9);
    compare("wheel, pawl", &wheel, &pawl, None, 9);
}

#[test]
fn gears_in_both_orders() {
    compare("gears 8, 6", &gear(8, 1.0), &gear(6, 1.0), None, 24);
    compare("gears 6, 8", &gear(6, 1.0), &gear(8, 1.0), None, 24);
    compare("gear and rack", &gear(10, 1.0), &rack(3, 1.0), None, 10);
}

#[test]
fn geneva_wheels() {
    let (wheel, pin) = geneva(6);
    compare("geneva, pin", &wheel, &pin, None, 6);
    compare("pin, geneva", &pin, &wheel, None, 6);
}

#[test]
fn wheels_with_bores_and_holes() {
    let holed = |holes: &[Part]| {
        let mut all = vec![ratchet(12)];
        all.extend_from_slice(holes);
        together("wheel", &all)
    };
    // No part enters the holes, so it does not matter how they are drawn.
    let bore = turned(&circle(0.3), 0.7);
    let ring: Vec<Part> = (0..6)
        .map(|i| {
            let at = polar(cspace::Point::ORIGIN, 0.8, TAU * f64::from(i) / 6.0);
            shifted(&circle(0.15), at.x, at.y)
        })
        .collect();
    compare(
        "bored",
        &holed(core::slice::from_ref(&bore)),
        &pawl(),
        None,
        12,
    );
    compare("pawl, bored", &pawl(), &holed(&[bore]), None, 12);
    compare("holed", &holed(&ring), &pawl(), None, 6);
    // A pin enters: then the circle is left as drawn.
    let wheel = holed(&[circle(0.9)]);
    compare("pin in a bore", &wheel, &rectangle(0.4, 0.3), None, 2);
}

#[test]
fn windows() {
    let (wheel, pawl) = (ratchet(10), pawl());
    let slab = TAU / 10.0;
    let all = [
        (0.1, 0.5 * slab, 1),
        (0.1, 1.5 * slab, 10),
        (50.0, 2.0, 10),
        (2.0, 3.3, 10),
        (-3.0, 6.0, 10),
    ];
    for (lo, length, slabs) in all.into_iter().take(effort(3, 5)) {
        let window = Some((lo, lo + length));
        compare("wheel, pawl", &wheel, &pawl, window, slabs);
        compare("pawl, wheel", &pawl, &wheel, window, slabs);
    }
    let hole = plate(8.0, &[&regular_polygon(3, 3.0)]);
    compare("in a triangle", &hole, &square(1.0), Some((1.0, 4.0)), 4);
    // A circular corner turns in a circular one: patches go around the turn.
    compare(
        "discs",
        &rounded_rectangle(2.0, 1.0, 0.4),
        &lens(1.0, 0.3),
        Some((-2.0, 3.0)),
        2,
    );
}

/// Amount of work, counted and not timed: one of k periods has a k-th of the cells and branches, plus those added by its cuts. Of pairs with
/// more contacts, the last one, a whole turn has fewer branches, because those in blocked space are dropped.
#[test]
fn a_slab_is_a_share_of_the_work() {
    for (fixed, moving, drops) in [
        (ratchet(20), pawl(), false),
        (pawl(), ratchet(40), false),
        (gear(8, 1.0), gear(7, 1.0), false),
        (gear(10, 1.0), gear(9, 1.0), true),
    ] {
        let [a, b] = computed(&fixed, &moving, None);
        let slabs = u64::from(a.symmetry().slabs);
        let (s, t) = (a.statistics(), b.statistics());
        for (slab, turn) in [
            (s.cells, t.cells),
            (s.pairs, t.pairs),
            (s.branches, t.branches),
        ][..if drops { 2 } else { 3 }]
            .iter()
            .copied()
        {
            assert!(slab * slabs <= 3 * turn, "{slab} × {slabs}, {turn}");
        }
        let bands = a.bands().len();
        assert_eq!(a.computed_bands() * slabs as usize, bands);
        assert_eq!(b.computed_bands(), bands);
    }
}

/// Arcs of nearly a turn touch others over more than a turn of orientations.
#[test]
fn long_arcs() {
    let ring = c_shape(2.0, 1.5, 0.2);
    let other = rounded_rectangle(1.0, 0.6, 0.25);
    compare("ring, other", &ring, &other, None, 2);
    compare("other, ring", &other, &ring, None, 2);
    compare("ring, other", &ring, &other, Some((0.3, 6.0)), 2);
    compare("other, ring", &other, &ring, Some((-5.0, 1.2)), 2);
}

/// Coordinates written with nine decimals: the nearest symmetric wheel is computed, and its deviation reported.
#[test]
fn rounded_drawings() {
    let drawn = ratchet(20);
    let round = |x: f64| (x * 1e9).round() / 1e9;
    let loops = drawn
        .loops()
        .iter()
        .map(|l| {
            let place = |v: &Vertex| Vertex::new(round(v.x), round(v.y), v.bulge);
            l.vertices().iter().map(place).collect()
        })
        .collect();
    let wheel = Part::new("rounded", loops).unwrap();
    let [a, b] = computed(&wheel, &pawl(), None);
    let s = a.symmetry();
    assert_eq!((s.fixed, s.slabs), (20, 20));
    assert!((1e-11..1e-9).contains(&s.deviation));
    assert!(a.resolution() > s.deviation && b.resolution() < s.deviation);
    assert_eq!(a.statistics().conflicts, 0);
    let oracle = Oracle::new(&wheel, &pawl());
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let classifier = Classifier::new(&a);
    for near in near_contact(&oracle, &mut rng, 2000) {
        let expected = if near.verdict.overlap {
            Classification::Blocked
        } else {
            Classification::Free
        };
        let answer = classifier.classify(near.configuration);
        let told = answer == Some(Classification::Contact) || answer == Some(expected);
        assert!(told, "{near:?}");
    }
}

/// All pairs that have some symmetry, also the degenerate ones.
#[test]
fn all_symmetric_pairs() {
    let large = ["gears 26 and 24"];
    pairs()
        .into_par_iter()
        .step_by(effort(2, 1))
        .filter(|p| !large.contains(&p.name.as_str()))
        .for_each(|p| {
            let [a, b] = computed(&p.fixed, &p.moving, None);
            if a.symmetry().slabs > 1 {
                same_spaces(&a, &b, &p.name);
            }
        });
}
