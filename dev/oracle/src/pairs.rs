//! Named pairs of parts: the easy, the degenerate and the large.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::{Configuration, Part};

use crate::shapes::*;

/// Two parts to try the library on.
#[derive(Debug, Clone)]
pub struct Pair {
    /// Name of the case.
    pub name: String,
    /// The fixed part.
    pub fixed: Part,
    /// The moving part.
    pub moving: Part,
    /// Configurations worth a look: in narrow pockets of free space, or at degenerate contact.
    pub notable: Vec<Configuration>,
}

/// Pairs for tests.
pub fn pairs() -> Vec<Pair> {
    let mut all = Vec::new();
    plain(&mut all);
    fits(&mut all);
    round(&mut all);
    pieces(&mut all);
    wheels(&mut all);
    scales(&mut all);
    random(&mut all);
    all
}

/// Pair with a given name.
///
/// # Panics
/// If there is none.
pub fn pair(name: &str) -> Pair {
    pairs()
        .into_iter()
        .find(|p| p.name == name)
        .unwrap_or_else(|| panic!("no pair is named {name}"))
}

fn at(x: f64, y: f64, theta: f64) -> Configuration {
    Configuration::new(x, y, theta)
}

fn add(all: &mut Vec<Pair>, name: &str, fixed: Part, moving: Part, notable: &[Configuration]) {
    all.push(Pair {
        name: name.to_owned(),
        fixed,
        moving,
        notable: notable.to_vec(),
    });
}

/// Polygons in the open.
fn plain(all: &mut Vec<Pair>) {
    let touching = [
        at(2.0, 0.0, 0.0),
        at(2.0, 2.0, 0.0),
        at(0.5, 2.0, FRAC_PI_2),
    ];
    add(all, "squares", square(2.0), square(2.0), &touching);
    add(
        all,
        "triangle and pentagon",
        regular_polygon(3, 1.0),
        regular_polygon(5, 0.7),
        &[],
    );
    add(
        all,
        "rectangle and 20-gon",
        rectangle(3.0, 0.4),
        regular_polygon(20, 1.0),
        &[],
    );
    add(
        all,
        "long bars",
        rectangle(10.0, 0.1),
        rectangle(8.0, 0.2),
        &[at(0.0, 0.15, 0.0)],
    );
    add(all, "mirrored pawls", pawl(), mirrored(&pawl()), &[]);
    add(
        all,
        "racks",
        rack(4, 1.0),
        turned(&rack(3, 1.0), PI),
        &[
            at(0.5 * PI, 0.0, 0.0),
            at(PI, 2.0, 0.0),
            at(1.5 * PI, 0.1, 0.0),
        ],
    );
}

/// Pegs, holes and corridors.
fn fits(all: &mut Vec<Pair>) {
    let quarter_turns = [0.0, 1.0, 2.0, 3.0].map(|k| at(0.0, 0.0, k * FRAC_PI_2));
    let hole = plate(4.0, &[&square(2.0)]);
    add(
        all,
        "square in its square hole",
        hole.clone(),
        square(2.0),
        &quarter_turns,
    );
    add(
        all,
        "square in a larger hole",
        hole.clone(),
        square(1.8),
        &quarter_turns,
    );
    add(
        all,
        "square in a much larger hole",
        hole,
        square(1.0),
        &quarter_turns,
    );
    add(
        all,
        "hexagon in a hexagonal hole",
        plate(4.0, &[&regular_polygon(6, 1.0)]),
        regular_polygon(6, 0.999),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, PI / 3.0)],
    );
    for (name, clearance) in [
        ("peg in hole, no clearance", 0.0),
        ("peg in hole, clearance 1e-3", 1e-3),
        ("peg in hole, clearance 1e-6", 1e-6),
    ] {
        let block = slotted_block(4.0, 1.0 + clearance, 2.0, 0.0);
        add(
            all,
            name,
            block,
            peg(1.0, 3.0),
            &[at(0.0, 1.5, 0.0), at(0.0, 1.0, 0.0), at(0.0, 3.0, 0.0)],
        );
    }
    let chamfered = slotted_block(4.0, 1.01, 2.0, 0.2);
    add(
        all,
        "peg in chamfered hole",
        chamfered.clone(),
        peg(1.0, 3.0),
        &[at(0.0, 1.5, 0.0), at(0.0, 2.9, 0.0)],
    );
    add(
        all,
        "rounded peg in hole",
        chamfered,
        rounded_peg(1.0, 3.0),
        &[at(0.0, 1.5, 0.0), at(0.0, 1.0, 0.0)],
    );
    add(
        all,
        "disc in maze",
        maze(),
        circle(0.45),
        &[at(1.5, 5.0, 0.0), at(4.5, 5.0, 0.0), at(7.5, 2.5, 0.0)],
    );
    add(
        all,
        "bar in maze",
        maze(),
        rectangle(0.9, 0.3),
        &[at(1.5, 5.0, 1.0), at(4.5, 5.0, 0.5), at(7.5, 2.5, 0.0)],
    );
    add(
        all,
        "ball caged in a C",
        c_shape(1.5, 1.0, 0.5),
        circle(0.6),
        &[at(0.0, 0.0, 0.0), at(0.3, 0.0, 0.0)],
    );
    add(
        all,
        "ball free to leave a C",
        c_shape(1.5, 1.0, 0.7),
        circle(0.5),
        &[at(0.0, 0.0, 0.0), at(1.2, 0.0, 0.0)],
    );
}

/// Arcs.
fn round(all: &mut Vec<Pair>) {
    add(all, "discs", circle(1.0), circle(0.7), &[at(1.7, 0.0, 0.0)]);
    add(
        all,
        "pin in socket of equal radius",
        socket(1.0),
        circle(1.0),
        &[at(0.0, 0.0, 0.0), at(0.0, 1e-4, 1.0)],
    );
    add(
        all,
        "half disc in socket of equal radius",
        socket(1.0),
        half_disc(1.0),
        &[at(0.0, 0.0, PI), at(0.0, 1e-3, PI), at(0.0, 1e-2, 3.0)],
    );
    add(
        all,
        "lens and crescent",
        crescent(1.0, 1.0, 0.4),
        lens(0.8, 0.3),
        &[],
    );
    add(
        all,
        "crescents of equal arcs",
        crescent(1.0, 1.0, 0.5),
        crescent(1.0, 0.5, 0.2),
        &[at(0.0, 0.0, 0.0), at(-1e-3, 0.0, 0.0)],
    );
    add(
        all,
        "half discs",
        half_disc(1.0),
        half_disc(1.0),
        &[at(0.0, 0.0, PI), at(0.5, 0.0, PI)],
    );
    let nearly = |r: f64| flatted_disc(r, 350f64.to_radians());
    add(
        all,
        "nearly full arcs",
        nearly(1.0),
        nearly(0.8),
        &[at(1.8, 0.0, PI)],
    );
    add(
        all,
        "nearly full arc in a hole",
        plate(4.0, &[&circle(1.1)]),
        flatted_disc(1.1, 340f64.to_radians()),
        &[at(0.0, 0.0, 0.0), at(1e-3, 0.0, 0.0)],
    );
    add(
        all,
        "square in a nearly full hole",
        plate(4.0, &[&nearly(1.0)]),
        square(1.2),
        &[at(0.0, 0.0, 0.3)],
    );
    add(
        all,
        "disc in annulus",
        annulus(2.0, 1.5),
        circle(1.0),
        &[at(0.0, 0.0, 0.0), at(0.5, 0.0, 0.0)],
    );
    add(
        all,
        "disc in annulus of equal radius",
        annulus(2.0, 1.0),
        circle(1.0),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "annuli",
        annulus(2.0, 1.5),
        annulus(1.4, 1.2),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "disc that hides a ring",
        annulus(1.0, 0.8),
        circle(1.5),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "sector in a groove of the same arcs",
        plate(6.0, &[&circle(2.0), &circle(1.0)]),
        ring_sector(2.0, 1.0, -0.4, 0.4),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, 1.0)],
    );
    add(
        all,
        "sector in a wider groove",
        plate(6.0, &[&circle(2.01), &circle(0.99)]),
        ring_sector(2.0, 1.0, -0.4, 0.4),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, 1.0)],
    );
    add(
        all,
        "rounded rectangles",
        rounded_rectangle(2.0, 1.0, 0.25),
        rounded_rectangle(1.0, 1.0, 0.4),
        &[],
    );
    add(
        all,
        "rounded rectangle in a rounded hole",
        plate(4.0, &[&rounded_rectangle(2.01, 1.01, 0.25)]),
        rounded_rectangle(2.0, 1.0, 0.25),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, PI)],
    );
    add(
        all,
        "nearly straight arcs",
        lens(1.0, 1e-3),
        lens(1.2, 2e-3),
        &[at(0.0, 3.5e-3, 0.0)],
    );
}

/// Parts of several loops.
fn pieces(all: &mut Vec<Pair>) {
    add(
        all,
        "three pegs in three holes",
        three_holes(1.0, 0.3),
        three_pegs(1.0, 0.25),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, PI)],
    );
    add(
        all,
        "three pegs that fill three holes",
        three_holes(1.0, 0.3),
        three_pegs(1.0, 0.3),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, PI)],
    );
    add(
        all,
        "island in a hole",
        plate(6.0, &[&square(4.0), &square(1.0)]),
        rectangle(1.2, 0.8),
        &[at(1.2, 0.0, FRAC_PI_2), at(0.0, 1.2, 0.0)],
    );
    add(
        all,
        "ring about an island",
        plate(6.0, &[&circle(2.5), &circle(0.5)]),
        annulus(1.5, 1.0),
        &[at(0.0, 0.0, 0.0)],
    );
    let two = together(
        "two squares",
        &[
            shifted(&square(1.0), -1.0, 0.0),
            shifted(&square(1.0), 1.0, 0.0),
        ],
    );
    add(
        all,
        "two squares and a bar",
        two.clone(),
        rectangle(0.9, 2.0),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "two squares and two squares",
        two.clone(),
        two,
        &[at(1.0, 0.0, 0.0), at(0.0, 0.0, FRAC_PI_2)],
    );
}

/// Gears, a rack, ratchets and pawls.
fn wheels(all: &mut Vec<Pair>) {
    add(
        all,
        "gears 10 and 9",
        gear(10, 1.0),
        gear(9, 1.0),
        &[at(9.5, 0.0, 0.0)],
    );
    add(
        all,
        "gears 26 and 24",
        gear(26, 1.0),
        gear(24, 1.0),
        &[at(25.0, 0.0, PI / 24.0)],
    );
    add(
        all,
        "gear in a ring of its tip circle",
        annulus(8.0, 5.5),
        gear(9, 1.0),
        &[at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.1)],
    );
    add(
        all,
        "rack and gear",
        rack(6, 1.0),
        gear(12, 1.0),
        &[at(0.5 * PI, 6.02, 0.0)],
    );
    add(
        all,
        "ratchet 20 and pawl",
        ratchet(20),
        pawl(),
        &[at(5.5465, -1.1207, 2.803)],
    );
    add(all, "ratchet 8 and pawl", ratchet(8), pawl(), &[]);
}

/// Shapes drawn small, or far away.
fn scales(all: &mut Vec<Pair>) {
    let far = |p: &Part, x: f64, y: f64| shifted(p, x, y);
    add(
        all,
        "squares drawn far away",
        far(&square(2.0), 1e6, -1e6),
        far(&square(1.0), 1e6, -1e6),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "random parts drawn far away",
        far(&random_part(101, 8, 0.5), 1e6, 2e6),
        far(&random_part(102, 8, 0.5), -1e6, 3e5),
        &[at(2e6, 1.7e6, 0.0)],
    );
    add(
        all,
        "peg in hole drawn far away",
        far(&slotted_block(4.0, 1.01, 2.0, 0.2), 1e6, 1e6),
        far(&peg(1.0, 3.0), 1e6, 1e6),
        &[at(0.0, 1.5, 0.0)],
    );
    add(
        all,
        "random parts 1e-6 in size",
        scaled(&random_part(103, 8, 0.5), 1e-6),
        scaled(&random_part(104, 8, 0.5), 1e-6),
        &[],
    );
    add(
        all,
        "gears 1e-6 in module",
        gear(10, 1e-6),
        gear(9, 1e-6),
        &[at(9.5e-6, 0.0, 0.0)],
    );
    add(
        all,
        "small disc and large plate",
        plate(100.0, &[&circle(0.6)]),
        circle(0.5),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "random parts 1e6 in size",
        scaled(&random_part(105, 8, 0.5), 1e6),
        scaled(&random_part(106, 8, 0.5), 1e6),
        &[],
    );
}

/// Parts drawn at random.
fn random(all: &mut Vec<Pair>) {
    for (i, (n, m, arcs)) in [
        (5, 4, 0.0),
        (8, 6, 0.0),
        (12, 9, 0.0),
        (4, 4, 1.0),
        (6, 5, 1.0),
        (10, 8, 1.0),
        (6, 6, 0.5),
        (8, 8, 0.5),
        (12, 12, 0.5),
        (16, 10, 0.5),
        (16, 16, 0.3),
    ]
    .into_iter()
    .enumerate()
    {
        let seed = 10 * i as u64;
        add(
            all,
            &format!("random {i}"),
            random_part(seed, n, arcs),
            scaled(&random_part(seed + 1, m, arcs), 0.8),
            &[],
        );
    }
    add(
        all,
        "random ring and random part",
        random_ring(201, 10, 0.5),
        scaled(&random_part(202, 6, 0.5), 0.3),
        &[at(0.0, 0.0, 0.0)],
    );
    add(
        all,
        "random rings",
        random_ring(203, 8, 0.5),
        scaled(&random_ring(204, 8, 0.5), 0.9),
        &[],
    );
    add(
        all,
        "random pieces and random part",
        random_pieces(205, 3, 5, 0.5),
        scaled(&random_part(206, 6, 0.5), 0.5),
        &[],
    );
    add(
        all,
        "random pieces and random ring",
        random_pieces(207, 2, 6, 0.5),
        scaled(&random_ring(208, 8, 0.5), 0.8),
        &[],
    );
}
