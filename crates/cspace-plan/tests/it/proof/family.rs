//! Every pair that is kept apart has a proof: outlines with arcs, thin walls, sharp tips, teeth and several loops.

use core::f64::consts::{PI, TAU};

use cspace::{Configuration, ContactSpace, Options, Part, Silent, Vertex};
use cspace_plan::proof::prove;

type Outline = Vec<Vertex>;

fn outline(corners: &[(f64, f64)]) -> Outline {
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

fn square(half: f64) -> Outline {
    outline(&[(-half, -half), (half, -half), (half, half), (-half, half)])
}

fn circle(radius: f64) -> Outline {
    vec![
        Vertex::new(-radius, 0.0, 1.0),
        Vertex::new(radius, 0.0, 1.0),
    ]
}

/// A C with radii 6 and 7, open to +x.
fn c(gap: f64) -> Outline {
    let half = 0.5 * gap;
    let at = |r: f64, angle: f64, bulge: f64| Vertex::new(r * angle.cos(), r * angle.sin(), bulge);
    let (outer, inner) = ((half / 7.0).asin(), (half / 6.0).asin());
    let (out, back) = ((0.25 * (PI - outer)).tan(), -(0.25 * (PI - inner)).tan());
    vec![
        at(7.0, outer, out),
        at(7.0, PI, out),
        at(7.0, -outer, 0.0),
        at(6.0, -inner, back),
        at(6.0, PI, back),
        at(6.0, inner, 0.0),
    ]
}

/// Teeth between two radii.
fn gear(teeth: u32, root: f64, tip: f64) -> Outline {
    let corner = |i: u32| {
        let share = [(0.0, root), (0.15, tip), (0.5, tip), (0.65, root)];
        share.map(|(f, r)| {
            let angle = TAU * (f64::from(i) + f) / f64::from(teeth);
            Vertex::line(r * angle.cos(), r * angle.sin())
        })
    };
    (0..teeth).flat_map(corner).collect()
}

fn ell() -> Outline {
    outline(&[
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 1.0),
        (1.0, 1.0),
        (1.0, 4.0),
        (0.0, 4.0),
    ])
}

/// A proof that the moving part does not come from its start to far away.
#[track_caller]
fn proved(name: &str, fixed: Vec<Outline>, moving: Vec<Outline>, start: [f64; 3]) {
    let parts = [("fixed", fixed), ("moving", moving)];
    let [fixed, moving] = parts.map(|(name, loops)| Part::new(name, loops).unwrap());
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let [x, y, theta] = start;
    let ends = [(x, y, theta), (60.0, 3.0, 1.0)].map(|(x, y, t)| Configuration::new(x, y, t));
    let begin = std::time::Instant::now();
    let proof = prove(&space, ends[0], ends[1], None, &Silent);
    let proof = proof.unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(proof.check(), Ok(()), "{name}");
    println!(
        "{name}: depth {:.5}, {} triangles, {:.2} s",
        proof.depth,
        proof.triangles.len(),
        begin.elapsed().as_secs_f64()
    );
}

#[test]
fn discs_and_others_in_cs() {
    for gap in [3.23, 3.0, 2.0, 1.0] {
        proved("disc in a C", vec![c(gap)], vec![circle(2.0)], [0.0; 3]);
    }
    let curved = vec![
        Vertex::new(-2.2, -2.0, 0.3),
        Vertex::line(2.0, -2.0),
        Vertex::new(2.1, 2.0, 0.2),
        Vertex::line(-2.0, 2.3),
    ];
    proved("arcs in a C", vec![c(3.2)], vec![curved.clone()], [0.0; 3]);
    proved("square in a C", vec![c(2.6)], vec![square(1.8)], [0.0; 3]);
    proved(
        "arcs in a frame",
        vec![square(8.0), square(4.0)],
        vec![curved.clone()],
        [0.0; 3],
    );
    // Bulged outwards and inwards.
    for bulge in [0.3, -0.3] {
        let mut hole = square(4.0);
        hole[0].bulge = bulge;
        let name = "arcs in a frame with an arc";
        proved(
            name,
            vec![square(8.0), hole],
            vec![curved.clone()],
            [0.0; 3],
        );
    }
}

#[test]
fn an_ell_in_a_pocket_and_behind_a_wall_with_a_slit() {
    let pocket = outline(&[
        (-0.4, -0.4),
        (4.4, -0.4),
        (4.4, 1.4),
        (1.4, 1.4),
        (1.4, 4.4),
        (-0.4, 4.4),
    ]);
    proved(
        "ell in a pocket",
        vec![square(9.0), pocket],
        vec![ell()],
        [0.0; 3],
    );
    let rooms = outline(&[
        (-10.0, -10.0),
        (10.0, -10.0),
        (10.0, 10.0),
        (0.3, 10.0),
        (0.3, 0.5),
        (-0.3, 0.5),
        (-0.3, 10.0),
        (-10.0, 10.0),
    ]);
    proved(
        "ell in rooms",
        vec![square(11.0), rooms],
        vec![ell()],
        [-2.0, -7.0, 0.0],
    );
}

#[test]
fn thin_walls_and_sharp_tips() {
    for wall in [0.1, 0.002] {
        let frame = vec![square(4.0 + wall), square(4.0)];
        proved("square in a thin frame", frame, vec![square(2.0)], [0.0; 3]);
    }
    proved(
        "thin frame in a frame",
        vec![square(8.0), square(4.0)],
        vec![square(2.0), square(1.9)],
        [0.0; 3],
    );
    for half in [0.3, 0.02] {
        let tips = outline(&[
            (-6.0, -6.0),
            (-half, -6.0),
            (0.0, -3.0),
            (half, -6.0),
            (6.0, -6.0),
            (6.0, -half),
            (3.0, 0.0),
            (6.0, half),
            (6.0, 6.0),
            (-6.0, 6.0),
        ]);
        let name = "square beside needles";
        proved(
            name,
            vec![square(9.0), tips],
            vec![square(1.5)],
            [-1.0, 1.0, 0.0],
        );
    }
    let needle = outline(&[(-3.0, -0.5), (3.0, 0.0), (-3.0, 0.5)]);
    proved(
        "needle",
        vec![square(9.0), square(6.0)],
        vec![needle],
        [0.0; 3],
    );
    let lens = vec![Vertex::new(-3.0, 0.0, 0.2), Vertex::new(3.0, 0.0, 0.2)];
    proved("lens", vec![square(9.0), square(6.0)], vec![lens], [0.0; 3]);
}

#[test]
fn teeth_and_rings() {
    let internal = vec![circle(12.0), gear(9, 8.0, 7.0)];
    proved(
        "gear in a ring gear",
        internal,
        vec![gear(8, 5.5, 6.3)],
        [0.0; 3],
    );
    let ring = vec![circle(5.0), square(2.5)];
    proved(
        "ring on a post",
        vec![circle(2.0), circle(1.0)],
        ring,
        [0.0; 3],
    );
}

/// Outlines around the origin, drawn by chance: half of their edges are arcs, inwards or outwards.
struct Chance(u64);

impl Chance {
    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.0 = (self.0.wrapping_mul(6_364_136_223_846_793_005))
            .wrapping_add(1_442_695_040_888_963_407);
        least + (most - least) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn outline(&mut self, corners: u32, least: f64, most: f64) -> Outline {
        let corner = |i: u32| {
            let angle = TAU * (f64::from(i) + self.between(-0.3, 0.3)) / f64::from(corners);
            let (r, bulge) = (self.between(least, most), self.between(-1.0, 1.0));
            let bulge = if bulge.abs() > 0.5 { 0.0 } else { bulge };
            Vertex::new(r * angle.cos(), r * angle.sin(), bulge)
        };
        (0..corners).map(corner).collect()
    }
}

#[test]
fn outlines_drawn_by_chance() {
    let mut chance = Chance(1);
    let mut kept = 0;
    for _ in 0..cspace_oracle::effort(16, 40) {
        let hole = chance.outline(8, 4.0, 7.0);
        let corners = chance.between(3.0, 7.0) as u32;
        let moving = chance.outline(corners, 0.8, 2.0);
        // Loops that cross are no part.
        let loops = vec![circle(12.0), hole.clone()];
        let (Ok(fixed), Ok(part)) = (
            Part::new("f", loops.clone()),
            Part::new("m", vec![moving.clone()]),
        ) else {
            continue;
        };
        let space = ContactSpace::compute(&fixed, &part, &Options::default()).unwrap();
        let start = Configuration::new(0.0, 0.0, 0.0);
        if space.locate(start).region().is_none() {
            continue;
        }
        kept += 1;
        proved("by chance", loops, vec![moving], [0.0; 3]);
    }
    assert!(kept >= cspace_oracle::effort(6, 15), "{kept}");
}
