//! Contact spaces of parts with layers, compared with brute force on every two layers that meet.

use cspace::fixed_axes::AxisMotion;
use cspace::{
    Axis, Classification, ContactSpace, FixedAxesSpace, Options, Part, Point, Rotation, Vector,
    Vertex,
};
use cspace_oracle::shapes::{
    annulus, circle, random_part, random_ring, rectangle, regular_polygon, scaled, shifted, square,
};
use cspace_oracle::{Oracle, near_contact};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::cases;

type Outline = Vec<Vec<Vertex>>;

fn loops(part: &Part) -> Outline {
    part.loops().iter().map(|l| l.vertices().to_vec()).collect()
}

/// A stack of up to three layers between heights that are whole numbers, so that some only touch. Some layers have outlines, or a bore, of
/// those below them.
fn stack(rng: &mut ChaCha8Rng, size: f64) -> Part {
    let mut layers: Vec<(Option<[f64; 2]>, Outline)> = Vec::new();
    let mut height = f64::from(rng.random_range(0..4));
    let (plain, most) = (rng.random_bool(0.3), rng.random_range(2..5));
    for _ in 0..rng.random_range(1..most) {
        let top = height + f64::from(rng.random_range(1..3));
        let seed = rng.random_range(0..1_000_000);
        let (n, arcs) = (rng.random_range(3..8_usize), rng.random_range(0.0..1.0));
        let whole = |rng: &mut ChaCha8Rng| f64::from(rng.random_range(1..4)) * 0.5 * size;
        let outline = match (rng.random_range(0..5), layers.last()) {
            // Plates flush at several sides, and concentric discs, polygons and rings: symmetric stacks among them.
            (0..2, _) if plain => {
                let [w, h] = [0; 2].map(|_| whole(rng));
                loops(&shifted(&rectangle(w, h), 0.5 * w, 0.5 * h))
            }
            (2, _) if plain => loops(&circle(whole(rng))),
            (3, _) if plain => loops(&annulus(2.0 * size, whole(rng))),
            (_, _) if plain => loops(&regular_polygon(6, whole(rng))),
            (0, Some(below)) => below.1.clone(),
            // A plate as large as another, moved along one of its sides: the sides lie on one line.
            (1, _) => {
                let at = f64::from(rng.random_range(0..3));
                loops(&shifted(&square(1.5 * size), 0.25 * size * at, 0.0))
            }
            (2, _) => loops(&scaled(&random_ring(seed, n.max(5), arcs), size)),
            _ => loops(&scaled(&random_part(seed, n, arcs), size)),
        };
        layers.push((Some([height, top]), outline));
        height = top + f64::from(rng.random_range(0..2));
    }
    Part::layered("stack", layers).unwrap()
}

/// Brute force on every two layers that meet.
struct Oracles(Vec<Oracle>);

impl Oracles {
    fn new(fixed: &Part, moving: &Part) -> Self {
        let heights = |p: &Part| -> Vec<[f64; 2]> {
            let z = |l: &cspace::Layer| l.z().unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
            p.layers().iter().map(z).collect()
        };
        let plain = |p: &Part, i: usize| {
            let all = loops(p);
            Part::new("layer", all[p.layers()[i].loops()].to_vec()).unwrap()
        };
        let (of_fixed, of_moving) = (heights(fixed), heights(moving));
        let mut oracles = Vec::new();
        for (i, a) in of_fixed.iter().enumerate() {
            for (j, b) in of_moving.iter().enumerate() {
                if a[0].max(b[0]) < a[1].min(b[1]) {
                    oracles.push(Oracle::new(&plain(fixed, i), &plain(moving, j)));
                }
            }
        }
        Self(oracles)
    }

    /// Whether a configuration is free, and by which margin.
    fn judge(&self, c: cspace::Configuration) -> (bool, f64) {
        let verdicts = self.0.iter().map(|o| o.judge(c));
        verdicts.fold((true, f64::INFINITY), |(free, margin), v| {
            match (free, !v.overlap) {
                (true, true) => (true, margin.min(v.margin)),
                (true, false) => (false, v.margin),
                (false, true) => (false, margin),
                (false, false) => (false, margin.max(v.margin)),
            }
        })
    }
}

fn planar_agree(count: u64) {
    let mut judged = 0;
    cases(count, |rng| {
        let size = rng.random_range(0.2..1.5);
        let (fixed, moving) = (stack(rng, 1.0), stack(rng, size));
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let oracles = Oracles::new(&fixed, &moving);
        for oracle in &oracles.0 {
            for near in near_contact(oracle, rng, 60) {
                let c = near.configuration;
                let (free, margin) = oracles.judge(c);
                if margin > 1e-10 * oracle.size() {
                    judged += 1;
                    assert_eq!(space.slice(c.theta).is_free(c.position()), free, "{near:?}");
                }
            }
        }
        if oracles.0.is_empty() {
            assert_eq!(space.patches().len(), 0);
        }
    });
    assert!(judged > 20 * count, "{judged}");
}

#[test]
fn stacks_agree_with_brute_force() {
    planar_agree(24);
}

#[test]
#[ignore = "long: minutes"]
fn many_stacks_agree_with_brute_force() {
    planar_agree(3000);
}

fn on_axes_agree(count: u64) {
    let mut judged = 0;
    cases(count, |rng| {
        let size = rng.random_range(0.3..1.2);
        let (fixed, moving) = (stack(rng, 1.0), stack(rng, size));
        let moving_center = Vector::new(rng.random_range(0.6..2.0), 0.0);
        let moving = shifted_layers(&moving, moving_center);
        let axis = |center: Point, rng: &mut ChaCha8Rng| Axis {
            motion: if rng.random_bool(0.7) {
                AxisMotion::Revolute { center }
            } else {
                let direction = Vector::from_angle(rng.random_range(0.0..6.0));
                AxisMotion::Prismatic { direction }
            },
            range: Some((-1.5, 1.5)),
        };
        let axes = (
            axis(Point::ORIGIN, rng),
            axis(Point::ORIGIN + moving_center, rng),
        );
        let space = FixedAxesSpace::compute(&fixed, axes.0, &moving, axes.1).unwrap();
        let oracles = Oracles::new(&fixed, &moving);
        for _ in 0..200 {
            let [u, v] = [0; 2].map(|_| rng.random_range(-1.5..1.5));
            let Some(class) = space.classify(u, v) else {
                continue;
            };
            let (free, margin) = oracles.judge(relative(axes, u, v));
            if margin > 1e-9 {
                judged += 1;
                let told = class == Classification::Free;
                assert_eq!(told, free, "at {u}, {v}");
            }
        }
    });
    assert!(judged > 100 * count, "{judged}");
}

fn shifted_layers(part: &Part, by: Vector) -> Part {
    let moved = |v: &Vertex| Vertex::new(v.x + by.x, v.y + by.y, v.bulge);
    let all = loops(part);
    part.redrawn(all.iter().map(|l| l.iter().map(moved).collect()).collect())
        .unwrap()
}

/// The configuration of the second part relative to the first one.
fn relative((a, b): (Axis, Axis), u: f64, v: f64) -> cspace::Configuration {
    let place = |axis: Axis, t: f64| match axis.motion {
        AxisMotion::Fixed => (0.0, Vector::ZERO),
        AxisMotion::Revolute { center } => {
            let c = center.to_vector();
            (t, c - Rotation::by(t) * c)
        }
        AxisMotion::Prismatic { direction } => (0.0, direction.unit() * t),
    };
    let ((turn, shift), (other_turn, other_shift)) = (place(a, u), place(b, v));
    let back = Rotation::by(-turn) * (other_shift - shift);
    cspace::Configuration::new(back.x, back.y, other_turn - turn)
}

#[test]
fn stacks_on_axes_agree_with_brute_force() {
    on_axes_agree(60);
}

#[test]
#[ignore = "long: minutes"]
fn many_stacks_on_axes_agree_with_brute_force() {
    on_axes_agree(5000);
}

/// Plates on a grid of whole numbers, so that most of their sides are flush with others, at several heights.
fn plates(rng: &mut ChaCha8Rng) -> Part {
    let mut layers: Vec<(Option<[f64; 2]>, Outline)> = Vec::new();
    for _ in 0..rng.random_range(1..5) {
        let [x, y] = [0; 2].map(|_| f64::from(rng.random_range(-3..3)));
        let [w, h] = [0; 2].map(|_| f64::from(rng.random_range(1..5)));
        let low = f64::from(rng.random_range(-2..3));
        let high = low + f64::from(rng.random_range(1..4));
        let plate = shifted(&rectangle(w, h), x + 0.5 * w, y + 0.5 * h);
        layers.push((Some([low, high]), loops(&plate)));
    }
    Part::layered("plates", layers).unwrap()
}

/// Flush sides of layers are told apart: no cell of the plane is in doubt, and brute force agrees.
#[test]
fn flush_layers_on_axes_are_told_apart() {
    let mut met = 0;
    cases(80, |rng| {
        let fixed = plates(rng);
        let moving = shifted_layers(&plates(rng), Vector::new(4.5, 0.5));
        let slide = |x: f64, y: f64| Axis {
            motion: AxisMotion::Prismatic {
                direction: Vector::new(x, y),
            },
            range: Some((-5.7, 5.7)),
        };
        let turn = Axis {
            motion: AxisMotion::Revolute {
                center: Point::new(4.5, 0.5),
            },
            range: None,
        };
        for axes in [(slide(1.0, 0.0), slide(0.0, 1.0)), (slide(1.0, 0.0), turn)] {
            let space = FixedAxesSpace::compute(&fixed, axes.0, &moving, axes.1).unwrap();
            assert_eq!(space.statistics().conflicts, 0);
            let oracles = Oracles::new(&fixed, &moving);
            met += usize::from(!oracles.0.is_empty());
            for _ in 0..50 {
                let [u, v] = [0; 2].map(|_| rng.random_range(-3.1..3.1));
                let (free, margin) = oracles.judge(relative(axes, u, v));
                if margin > 1e-8 {
                    let told = space.classify(u, v) == Some(Classification::Free);
                    assert_eq!(told, free, "at {u}, {v}");
                }
            }
        }
    });
    assert!(met > 100, "{met}");
}

/// A part split into layers of one outline has the space of the part.
#[test]
fn layers_of_one_outline_are_the_part() {
    cases(12, |rng| {
        let fixed = random_ring(rng.random_range(0..1_000_000), 6, 0.5);
        let moving = scaled(&random_part(rng.random_range(0..1_000_000), 5, 0.5), 0.4);
        let z = [0.0, 1.0, 4.0];
        let layer = |i: usize| (Some([z[i], z[i + 1]]), loops(&fixed));
        let split = Part::layered("split", vec![layer(0), layer(1)]).unwrap();
        let options = Options::default();
        let whole = ContactSpace::compute(&fixed, &moving, &options).unwrap();
        let space = ContactSpace::compute(&split, &moving, &options).unwrap();
        assert_eq!(space.patches().len(), whole.patches().len());
        assert_eq!(space.side_links().len(), whole.side_links().len());
        assert_eq!(space.free_regions().len(), whole.free_regions().len());
    });
}

/// Faces that only touch in height do not meet, and a part without heights meets every layer.
#[test]
fn heights_decide_who_meets() {
    let at = |z: Option<[f64; 2]>| Part::layered("plate", vec![(z, loops(&square(1.0)))]).unwrap();
    let patches = |a: &Part, b: &Part| {
        let space = ContactSpace::compute(a, b, &Options::default()).unwrap();
        space.patches().len()
    };
    let low = at(Some([0.0, 1.0]));
    assert_eq!(patches(&low, &at(Some([1.0, 2.0]))), 0);
    assert!(patches(&low, &at(Some([0.999, 2.0]))) > 0);
    assert!(patches(&low, &at(None)) > 0);
}
