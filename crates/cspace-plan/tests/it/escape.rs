//! Escape energies against what is known by hand, and against brute force.

use core::f64::consts::PI;
use std::collections::BinaryHeap;

use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, Options, PairSpace, Part, Point, Relation,
    Vector, Vertex,
};
use cspace_oracle::effort;
use cspace_plan::escape::{Body, Escape, Escaped, Field, Held, Spring, Weight};
use cspace_plan::{Checked, Planner};

fn circle(x: f64, y: f64, r: f64) -> Vec<Vertex> {
    vec![Vertex::new(x - r, y, 1.0), Vertex::new(x + r, y, 1.0)]
}

fn disc(r: f64) -> Part {
    Part::new("disc", vec![circle(0.0, 0.0, r)]).unwrap()
}

fn pegs(half: f64, r: f64) -> Part {
    Part::new("pegs", vec![circle(-half, 0.0, r), circle(half, 0.0, r)]).unwrap()
}

fn at(x: f64, y: f64, theta: f64) -> Coordinates {
    Coordinates::Planar(Configuration::new(x, y, theta))
}

/// A weight of 1 at the moving part's origin.
fn weight() -> Field {
    Field {
        weights: vec![Weight {
            on: Body::Moving,
            at: Point::ORIGIN,
            force: Vector::new(0.0, -1.0),
        }],
        springs: Vec::new(),
    }
}

fn planar(fixed: &Part, moving: &Part) -> PairSpace {
    PairSpace::compute(fixed, moving, Relation::Planar, &Options::default()).unwrap()
}

fn escaped(
    space: &PairSpace,
    field: &Field,
    from: Coordinates,
    to: Option<Coordinates>,
) -> Escaped {
    let escape = Escape::new(space, field).unwrap();
    escape.from(from, to).unwrap()
}

/// The answer, whose path is free and stays below its bound.
fn held(space: &PairSpace, field: &Field, from: Coordinates, to: Option<Coordinates>) -> Held {
    let Escaped::Held(held) = escaped(space, field, from, to) else {
        panic!("it is held")
    };
    assert!(held.least <= held.most, "{} {}", held.least, held.most);
    let planner = Planner::new(space).unwrap();
    let checked = cspace_plan::check(planner.scene(), &held.path).unwrap();
    assert!(matches!(checked, Checked::Free(_)), "{checked:?}");
    for pair in held.path.windows(2) {
        for i in 0..=50 {
            let share = f64::from(i) / 50.0;
            let energy = energy(field, between(pair[0], pair[1], share)) - energy(field, from);
            assert!(energy <= held.most + 1e-9, "{energy} {}", held.most);
        }
    }
    held
}

fn between(a: Coordinates, b: Coordinates, share: f64) -> Coordinates {
    let mix = |a: f64, b: f64| a + (b - a) * share;
    match (a, b) {
        (Coordinates::Planar(a), Coordinates::Planar(b)) => {
            at(mix(a.x, b.x), mix(a.y, b.y), mix(a.theta, b.theta))
        }
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: s, v: t }) => Coordinates::Axes {
            u: mix(u, s),
            v: mix(v, t),
        },
        _ => panic!("of one class"),
    }
}

/// The energy of a planar pair, written once more.
fn energy(field: &Field, at: Coordinates) -> f64 {
    let Coordinates::Planar(c) = at else {
        return 0.0;
    };
    let place = |(on, q): (Body, Point)| match on {
        Body::Moving => c.fixed_from_moving(q),
        _ => q,
    };
    let weights = (field.weights.iter()).map(|w| -w.force.dot(place((w.on, w.at)).to_vector()));
    let springs = field.springs.iter().map(|s| {
        let stretch = place(s.ends[0]).distance(place(s.ends[1])) - s.length;
        0.5 * s.stiffness * stretch * stretch
    });
    weights.sum::<f64>() + springs.sum::<f64>()
}

/// A disc of radius R on two pegs of radius r, d half their distance: m g [(R + r) − √((R + r)² − d²)].
#[test]
fn a_disc_on_two_pegs() {
    for (big, small, half) in [
        (3.0, 1.0, 1.5),
        (2.0, 0.5, 1.0),
        (1.0, 0.3, 1.2),
        (5.0, 0.1, 4.9),
    ] {
        let sum: f64 = big + small;
        let rest = (sum * sum - half * half).sqrt();
        let space = planar(&pegs(half, small), &disc(big));
        let held = held(&space, &weight(), at(0.0, rest, 0.3), None);
        let energy = held.energy.unwrap();
        assert!(
            (energy - (sum - rest)).abs() < 1e-9 * sum,
            "{energy} {}",
            sum - rest
        );
        assert!(held.least <= energy && energy <= held.most);
        let Coordinates::Planar(pass) = held.passes[0].at else {
            panic!("planar")
        };
        assert!((pass.x.abs() - half).abs() < 1e-9 * sum && (pass.y - sum).abs() < 1e-9 * sum);
    }
}

/// As above, held down by a spring to a point below: the path leads over the peg where it is farthest from there.
#[test]
fn a_disc_on_two_pegs_held_by_a_spring() {
    let (big, small, half, below, stiffness) = (2.0, 0.5, 1.0, 30.0, 3.0);
    let field = Field {
        weights: Vec::new(),
        springs: vec![Spring {
            ends: [
                (Body::Ground, Point::new(0.0, -below)),
                (Body::Moving, Point::ORIGIN),
            ],
            stiffness,
            length: 0.0,
        }],
    };
    let sum: f64 = big + small;
    let rest = (sum * sum - half * half).sqrt();
    let space = planar(&pegs(half, small), &disc(big));
    let held = held(&space, &field, at(0.0, rest, 0.0), None);
    let farthest = half.hypot(below) + sum;
    let known = 0.5 * stiffness * (farthest * farthest - (rest + below) * (rest + below));
    let energy = held.energy.unwrap();
    assert!((energy - known).abs() < 1e-9 * known, "{energy} {known}");
}

/// The centre of a rectangle is never nearer to the edge of a wall than half its width, and has to pass above it.
#[test]
fn a_rectangle_in_a_trough_is_lifted_over_the_wall() {
    let troughs = [(1.0, 1.0, 1.5, 0.7), (3.0, 1.0, 4.0, 0.5)];
    for (length, height, width, wall) in troughs.into_iter().take(effort(1, 2)) {
        let (a, b) = (width / 2.0, width / 2.0 + 1.0);
        let trough = Part::polygon(
            "trough",
            &[
                (-b, -1.0),
                (b, -1.0),
                (b, wall),
                (a, wall),
                (a, 0.0),
                (-a, 0.0),
                (-a, wall),
                (-b, wall),
            ],
        );
        let block = Part::rectangle("block", (0.0, 0.0), length, height).unwrap();
        let space = planar(&trough.unwrap(), &block);
        let held = held(&space, &weight(), at(0.0, height / 2.0, 0.0), None);
        assert!(held.least <= wall && wall <= held.most, "{held:?}");
        assert!(held.most - held.least < 0.2 * wall, "{held:?}");
        if let Some(energy) = held.energy {
            assert!((energy - wall).abs() < 1e-9, "{energy}");
        }
    }
}

#[test]
fn what_is_caged_needs_more_than_any_energy() {
    // A disc that is wider than the opening of a box.
    let fixed = Part::polygon(
        "box",
        &[
            (-4.0, -4.0),
            (4.0, -4.0),
            (4.0, 4.0),
            (1.5, 4.0),
            (1.5, 3.0),
            (3.0, 3.0),
            (3.0, -3.0),
            (-3.0, -3.0),
            (-3.0, 3.0),
            (-1.5, 3.0),
            (-1.5, 4.0),
            (-4.0, 4.0),
        ],
    )
    .unwrap();
    let space = planar(&fixed, &disc(1.6));
    assert!(matches!(
        escaped(&space, &weight(), at(0.0, -1.0, 0.0), None),
        Escaped::Caged(_)
    ));
    let inside = escaped(
        &space,
        &weight(),
        at(0.0, -1.0, 0.0),
        Some(at(0.5, 0.0, 1.0)),
    );
    assert!(matches!(inside, Escaped::Held(_)));
    // A narrower one is lifted until its widest place is through.
    let space = planar(&fixed, &disc(1.4));
    let out = held(&space, &weight(), at(0.0, -1.6, 0.0), None);
    assert!(out.least > 5.0 && out.most < 7.5, "{out:?}");
    assert!(matches!(
        escaped(&space, &weight(), at(0.0, -2.9, 0.0), None),
        Escaped::FromBlocked(_)
    ));
}

#[test]
fn downhill_costs_nothing() {
    let space = planar(&disc(2.0), &disc(1.0));
    for angle in [0.1, 1.0, 1.5] {
        let (sin, cos) = f64::sin_cos(angle);
        let held = held(&space, &weight(), at(3.0 * cos, 3.0 * sin, 0.0), None);
        assert_eq!(held.least, 0.0);
        assert!(held.energy.unwrap().abs() < 1e-12, "{held:?}");
    }
}

/// A weighted lever that a block keeps from swinging through below has to go over the top.
#[test]
fn a_lever_over_its_pivot() {
    let lever = Part::rectangle("lever", (2.0, 0.0), 5.0, 0.5).unwrap();
    let block = Part::rectangle("block", (0.0, -3.0), 0.5, 1.0).unwrap();
    let axis = |motion| Axis {
        motion,
        range: None,
    };
    let axes = (
        axis(AxisMotion::Fixed),
        axis(AxisMotion::Revolute {
            center: Point::ORIGIN,
        }),
    );
    let space = PairSpace::compute(
        &block,
        &lever,
        Relation::Axes {
            fixed: axes.0,
            moving: axes.1,
        },
        &Options::default(),
    )
    .unwrap();
    let field = Field {
        weights: vec![Weight {
            on: Body::Moving,
            at: Point::new(2.0, 0.0),
            force: Vector::new(0.0, -1.5),
        }],
        springs: Vec::new(),
    };
    let axes = |v| Coordinates::Axes { u: 0.0, v };
    let Escaped::Held(held) = escaped(&space, &field, axes(-0.3), Some(axes(PI + 0.2))) else {
        panic!("it is held")
    };
    let known = 2.0 * 1.5 * (1.0 + f64::sin(0.3));
    let energy = held.energy.unwrap();
    assert!((energy - known).abs() < 1e-9, "{energy} {known} {held:?}");
    assert!(held.least <= known && known <= held.most);
    // Without a goal nothing is out.
    let escape = Escape::new(&space, &field).unwrap();
    assert!(escape.from(axes(-0.3), None).is_err());
}

/// A bar on two pegs against brute force on a grid of configurations.
#[test]
#[ignore = "long: seconds"]
fn a_bar_on_two_pegs_agrees_with_brute_force() {
    let fixed = pegs(1.0, 0.4);
    let bar = Part::polygon("bent", &[(-1.6, 0.0), (0.0, -1.2), (1.6, 0.0), (0.0, -0.6)]).unwrap();
    let space = planar(&fixed, &bar);
    let planner = Planner::new(&space).unwrap();
    let scene = planner.scene();
    // At rest it hangs between the pegs.
    let start = [0.0, 1.0, 0.0];
    assert!(!scene.overlaps(start));
    let out = held(&space, &weight(), at(start[0], start[1], start[2]), None);
    let (nx, ny, nt) = (61, 61, 60);
    let place = |i: usize, j: usize, k: usize| {
        [
            -3.0 + 6.0 * i as f64 / (nx - 1) as f64,
            -1.0 + 4.0 * j as f64 / (ny - 1) as f64,
            2.0 * PI * k as f64 / nt as f64,
        ]
    };
    let index = |i: usize, j: usize, k: usize| (i * ny + j) * nt + k;
    let mut seen = vec![false; nx * ny * nt];
    let mut heap = BinaryHeap::new();
    let key = |y: f64| -(y * 1e9) as i64;
    heap.push((key(1.0), 30, 30, 0));
    let mut found = None;
    while let Some((energy, i, j, k)) = heap.pop() {
        if core::mem::replace(&mut seen[index(i, j, k)], true) {
            continue;
        }
        let at = place(i, j, k);
        if at[1] <= -0.99 {
            found = Some(-(energy as f64) / 1e9 - 1.0);
            break;
        }
        let sides: [(i64, i64, i64); 6] = [
            (1, 0, 0),
            (-1, 0, 0),
            (0, 1, 0),
            (0, -1, 0),
            (0, 0, 1),
            (0, 0, -1),
        ];
        for (a, b, c) in sides {
            let (i, j) = (i as i64 + a, j as i64 + b);
            let k = (k as i64 + c).rem_euclid(nt as i64) as usize;
            if !(0..nx as i64).contains(&i) || !(0..ny as i64).contains(&j) {
                continue;
            }
            let (i, j) = (i as usize, j as usize);
            if !seen[index(i, j, k)] && !scene.overlaps(place(i, j, k)) {
                heap.push((energy.min(key(place(i, j, k)[1])), i, j, k));
            }
        }
    }
    let found = found.unwrap();
    // The grid finds a way of its own, which is higher by what the grid cuts off.
    assert!(found >= out.least - 1e-9, "{found} {out:?}");
    assert!(found <= out.most + 0.2, "{found} {out:?}");
}

/// A start that is a little off its contacts, and a part that is drawn far from its origin, are held as any other.
#[test]
fn a_start_beside_contact_and_a_part_far_from_its_origin() {
    let rest = (1600.0_f64 - 225.0).sqrt();
    for (far, above) in [(0.0, 1e-7), (0.0, 1e-4), (1e2, 1e-7), (1e5, 1e-4)] {
        let disc = Part::new("disc", vec![circle(far, -far, 30.0)]).unwrap();
        let field = Field {
            weights: vec![Weight {
                on: Body::Moving,
                at: Point::new(far, -far),
                force: Vector::new(0.0, -1.0),
            }],
            springs: Vec::new(),
        };
        let space = planar(&pegs(15.0, 10.0), &disc);
        let held = held(&space, &field, at(-far, far + rest + above, 0.0), None);
        let known = 40.0 - rest - above;
        let energy = held.energy.unwrap();
        assert!(
            (energy - known).abs() < 1e-9 * (1.0 + far),
            "{energy} {known}"
        );
    }
}
