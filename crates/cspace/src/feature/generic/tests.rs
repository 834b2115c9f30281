use super::*;
use core::f64::consts::{PI, TAU};

const WISH: f64 = 1e-12;

/// A loop as drawn: x, y, bulge, and whether it is smooth there.
type Drawn = Vec<(f64, f64, f64, bool)>;

fn exact(drawn: &Drawn) -> (Vec<Vertex<Dd>>, Vec<bool>) {
    let vertex =
        |v: &(f64, f64, f64, bool)| Vertex::new(Dd::from(v.0), Dd::from(v.1), Dd::from(v.2));
    let vertices = drawn.iter().map(vertex).collect();
    (vertices, drawn.iter().map(|v| v.3).collect())
}

/// The vector from one vertex to another.
fn between(from: &Vertex<Dd>, to: &Vertex<Dd>) -> Vector<Dd> {
    to.point() - from.point()
}

/// Pseudo-random numbers in (−1, 1).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + 0.5 * (hi - lo) * (self.next() + 1.0)
    }
}

fn wishes(n: usize, size: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut numbers = Numbers(seed);
    (0..n)
        .map(|_| [0; 3].map(|_| size * numbers.next()))
        .collect()
}

/// The loop with coordinates rounded to 9 decimals; bulges are unchanged.
fn rounded(drawn: Drawn) -> Drawn {
    let round = |x: f64| (x * 1e9).round() / 1e9;
    (drawn.into_iter())
        .map(|(x, y, b, s)| (round(x), round(y), b, s))
        .collect()
}

/// The loop turned and moved, so that no number is simple.
fn placed(drawn: Drawn, angle: f64) -> Drawn {
    let (sin, cos) = angle.sin_cos();
    (drawn.into_iter())
        .map(|(x, y, b, s)| {
            (
                x * cos - y * sin + 0.1234567,
                x * sin + y * cos - 0.0765,
                b,
                s,
            )
        })
        .collect()
}

/// A polygon all of whose corners are rounded with a radius each (0 leaves the corner).
fn filleted(corners: &[(f64, f64, f64)]) -> Drawn {
    let n = corners.len();
    let mut drawn = Vec::new();
    for i in 0..n {
        let at = |k: usize| Vector::new(corners[k % n].0, corners[k % n].1);
        let (p, q, r) = (at(i + n - 1), at(i), at(i + 1));
        let (d, e) = ((q - p).unit(), (r - q).unit());
        let turn = d.cross(e).atan2(d.dot(e));
        if corners[i].2 == 0.0 {
            drawn.push((q.x, q.y, 0.0, false));
            continue;
        }
        let back = corners[i].2 * (0.5 * turn.abs()).tan();
        let (a, b) = (q - d * back, q + e * back);
        drawn.push((a.x, a.y, (0.25 * turn).tan(), true));
        drawn.push((b.x, b.y, 0.0, true));
    }
    drawn
}

fn rounded_rectangle(width: f64, height: f64, radius: f64) -> Drawn {
    let (w, h) = (0.5 * width, 0.5 * height);
    filleted(&[(-w, -h), (w, -h), (w, h), (-w, h)].map(|(x, y)| (x, y, radius)))
}

/// Two half circles and two lines.
fn stadium(length: f64, radius: f64) -> Drawn {
    let l = 0.5 * length;
    vec![
        (-l, -radius, 0.0, true),
        (l, -radius, 1.0, true),
        (l, radius, 0.0, true),
        (-l, radius, 1.0, true),
    ]
}

fn backwards(drawn: &Drawn) -> Drawn {
    let n = drawn.len();
    (0..n)
        .map(|i| {
            let at = drawn[(n - i) % n];
            (at.0, at.1, -drawn[(2 * n - i - 1) % n].2, at.3)
        })
        .collect()
}

fn circle(arcs: usize, radius: f64) -> Drawn {
    let step = TAU / arcs as f64;
    (0..arcs)
        .map(|i| {
            let (sin, cos) = (step * (i as f64 + 0.3)).sin_cos();
            (radius * cos, radius * sin, (0.25 * step).tan(), true)
        })
        .collect()
}

/// A comb with a bar below and teeth of one height, with rounded tips.
fn comb(teeth: usize, radius: f64) -> Drawn {
    let pitch = 1.0 / teeth as f64;
    let mut corners = vec![(0.0, -0.2, 0.0), (1.0, -0.2, 0.0)];
    for k in (0..teeth).rev() {
        let x = pitch * k as f64;
        corners.push((x + 0.6 * pitch, 0.0, radius));
        corners.push((x + 0.55 * pitch, 0.3, radius));
        corners.push((x + 0.05 * pitch, 0.3, radius));
        corners.push((x, 0.0, if k == 0 { 0.0 } else { radius }));
    }
    corners[2] = (1.0, 0.0, 0.0);
    filleted(&corners)
}

/// A closed curve of biarcs through points of r(φ) = 0.6 + Σ of waves.
fn biarcs(points: usize, waves: [f64; 4]) -> Drawn {
    let place = |phi: f64| {
        let mut r = (0.6, 0.0);
        for (k, wave) in waves.iter().enumerate() {
            let f = (k + 2) as f64;
            r.0 += wave * (f * phi + wave * 100.0).cos();
            r.1 -= wave * f * (f * phi + wave * 100.0).sin();
        }
        let u = Vector::from_angle(phi);
        (u * r.0, (u * r.1 + u.left() * r.0).unit())
    };
    let bulge = |direction: Vector, chord: Vector| {
        (0.5 * direction.cross(chord).atan2(direction.dot(chord))).tan()
    };
    let mut drawn = Vec::new();
    for i in 0..points {
        let step = TAU / points as f64;
        let ((p, t), (q, s)) = (place(step * i as f64), place(step * (i + 1) as f64));
        // Both arcs have tangents of length d, with |q − p − d (t + s)| = 2 d.
        let v = q - p;
        let (a, b, c) = (
            2.0 * (1.0 - t.dot(s)),
            2.0 * v.dot(t + s),
            v.length_squared(),
        );
        let d = 2.0 * c / (b + (b * b + 4.0 * a * c).sqrt());
        let joint = (p + q + (t - s) * d) * 0.5;
        drawn.push((p.x, p.y, bulge(t, joint - p), true));
        drawn.push((joint.x, joint.y, -bulge(-s, joint - q), true));
    }
    drawn
}

/// Distance of a place from the carrier of a drawn edge, from its centre and radius.
fn off(from: &Vertex<Dd>, to: &Vertex<Dd>, place: Point<Dd>) -> f64 {
    let chord = between(from, to);
    let to_place = place - Point::new(from.x, from.y);
    let b = from.bulge;
    if b.is_zero() {
        return (chord.cross(to_place) / chord.length()).to_f64().abs();
    }
    let up = (Dd::ONE - b * b) / b.scaled(4.0);
    let center = chord * Dd::from(0.5) + chord.left() * up;
    ((to_place - center).length() - center.length())
        .to_f64()
        .abs()
}

/// A point of an arc at a fraction of its length from its start.
fn place_on(from: &Vertex<Dd>, to: &Vertex<Dd>, fraction: f64) -> Point<Dd> {
    let chord = between(from, to);
    // tan of a fraction of half the sweep; position along the chord and rise above it, from the triangle with angles at both ends.
    let sweep = Dd::atan2(from.bulge, Dd::ONE) * 4.0;
    let (s, c) = (sweep * (0.5 * (1.0 - fraction))).sin_cos();
    let (first, _) = (sweep * (0.5 * fraction)).sin_cos();
    let (half, _) = (sweep * 0.5).sin_cos();
    let (along, rise) = (first * c / half, first * s / half);
    Point::new(from.x, from.y) + chord * along + chord.right() * rise
}

struct Told {
    residual: f64,
    /// Residual that rounding of coordinates may leave: for edges of length l, 2⁻¹⁰⁵ / l.
    rounding: f64,
    off: f64,
    slide: f64,
    steps: usize,
}

/// The largest sine at a smooth joint and the largest deviation.
fn told(drawn: &Drawn, result: &[Vertex<Dd>], wish: &[[f64; 3]]) -> Told {
    let (vertices, smooth) = exact(drawn);
    let n = vertices.len();
    let sides = sides(result).unwrap();
    let residual = (residuals(&sides, &smooth).unwrap().iter())
        .fold(0.0_f64, |most, r| most.max(r.to_f64().abs()));
    let mut told = Told {
        residual,
        rounding: sides
            .iter()
            .fold(0.0, |most, s| most.max(4.0 * ROUNDING / s.chord)),
        off: 0.0,
        slide: 0.0,
        steps: 0,
    };
    for i in 0..n {
        let (h, j) = ((i + n - 1) % n, (i + 1) % n);
        let place = Point::new(result[i].x, result[i].y);
        let least =
            off(&vertices[h], &vertices[i], place).min(off(&vertices[i], &vertices[j], place));
        told.off = told.off.max(least);
        let by = vector(between(&vertices[i], &result[i])).length();
        let edge = |i: usize, j: usize| vector(between(&vertices[i], &vertices[j])).length();
        told.slide = told.slide.max(by / edge(h, i).min(edge(i, j)));
        if vertices[i].bulge.is_zero() {
            assert!(result[i].bulge.is_zero());
        } else {
            for fraction in [0.25, 0.5, 0.75] {
                let place = place_on(&result[i], &result[j], fraction);
                told.off = told.off.max(off(&vertices[i], &vertices[j], place));
            }
        }
    }
    let start_sides = super::sides(&vertices).unwrap();
    let knots = knots(&start_sides, &smooth);
    let moved = moved(
        &vertices,
        &start_sides,
        &knots,
        &lessened(wish, &start_sides, &knots),
    );
    told.steps = smoothed(moved, &smooth).unwrap().1;
    told
}

/// Moves a loop, checks that it is smooth and near the drawn one, and returns it.
#[track_caller]
fn checked(name: &str, drawn: &Drawn, seed: u64, most_off: f64) -> Vec<Vertex<Dd>> {
    let (vertices, smooth) = exact(drawn);
    let wish = wishes(vertices.len(), WISH, seed);
    let result = made_generic(&vertices, &smooth, &wish);
    if result.is_none() {
        let sides = sides(&vertices).unwrap();
        let knots = knots(&sides, &smooth);
        let moved = moved(&vertices, &sides, &knots, &lessened(&wish, &sides, &knots));
        let (result, steps) = smoothed(moved, &smooth).expect(name);
        let told = told(drawn, &result, &wish);
        panic!(
            "{name}: {steps} steps, off {:e}, slide {:e} of an edge",
            told.off, told.slide
        );
    }
    let result = result.unwrap();
    let told = told(drawn, &result, &wish);
    assert!(told.steps <= 4, "{name}: {} steps", told.steps);
    let none = 1e-29_f64.max(told.rounding);
    assert!(told.residual < none, "{name}: {:e}", told.residual);
    assert!(told.off < most_off, "{name}: {:e}", told.off);
    result
}

/// The sine between the chords of two edges.
fn sine(result: &[Vertex<Dd>], i: usize, j: usize) -> f64 {
    let n = result.len();
    let unit = |k: usize| {
        let v = between(&result[k], &result[(k + 1) % n]);
        v * (Dd::ONE / v.length())
    };
    unit(i).cross(unit(j)).to_f64().abs()
}

#[test]
fn opposite_sides_of_a_rounded_rectangle_are_no_longer_parallel() {
    for radius in [0.3, 0.1, 1e-3, 1e-6] {
        for angle in [0.0, 0.4] {
            let drawn = placed(rounded_rectangle(1.2, 0.8, radius), angle);
            let result = checked("rectangle", &drawn, 1, 4.0 * WISH);
            // Lines have odd numbers; no two arcs have equal radii.
            assert!(sine(&result, 1, 5) > 1e-14 && sine(&result, 3, 7) > 1e-14);
            let radii = [0, 2, 4, 6].map(|i| 1.0 / sides(&result).unwrap()[i].bend);
            for (k, r) in radii.iter().enumerate() {
                assert!(radii[..k].iter().all(|q| (q - r).abs() > 1e-14));
            }
            let back = backwards(&drawn);
            let result = checked("backwards", &back, 2, 4.0 * WISH);
            assert!(sine(&result, 0, 4) > 1e-14 && sine(&result, 2, 6) > 1e-14);
        }
    }
}

#[test]
fn slots_and_stadiums_stay_smooth() {
    for (length, radius) in [
        (1.0, 0.2),
        (0.1, 0.5),
        (1e-3, 0.5),
        (1e-6, 0.5),
        (1.0, 1e-6),
    ] {
        let drawn = placed(stadium(length, radius), 0.3);
        checked("stadium", &drawn, 3, 4.0 * WISH);
        let result = checked("slot", &backwards(&drawn), 4, 4.0 * WISH);
        assert!(sine(&result, 1, 3) > 1e-14);
    }
}

#[test]
fn circles_stay_tangent_arcs() {
    for arcs in [2, 3, 4, 5, 6, 12, 100, 2001] {
        for radius in [1.0, 0.01] {
            let mut drawn = circle(arcs, radius);
            if arcs == 2 {
                for v in &mut drawn {
                    v.2 = 1.0;
                }
            }
            let result = checked("circle", &drawn, 5 + arcs as u64, 4.0 * WISH);
            checked("hole", &backwards(&drawn), 5 + arcs as u64, 4.0 * WISH);
            // Three circles that touch each other inside at three places are one; four or more make an oval.
            let sides = sides(&result).unwrap();
            let ratio = (sides[0].bend / sides[1].bend - 1.0).abs();
            assert!(if arcs > 3 {
                ratio > 1e-14
            } else {
                ratio < 1e-15
            });
        }
    }
    // A circle as one half and two quarters, a small remainder, and as drawn with bulges that do not add up.
    let quarter = (PI / 8.0).tan();
    let drawn = vec![
        (1.0, 0.0, 1.0, true),
        (-1.0, 0.0, quarter, true),
        (0.0, -1.0, quarter, true),
    ];
    checked("three arcs", &drawn, 8, 4.0 * WISH);
    let drawn = vec![(1.0, 0.0, 1.0 + 1e-9, true), (-1.0, 0.0, 1.0 - 1e-9, true)];
    checked("halves", &drawn, 9, 2e-9);
}

#[test]
fn a_circle_of_which_almost_all_is_one_arc_stays_near() {
    for rest in [0.1, 1e-3, 1e-5_f64] {
        let place = |angle: f64| (0.7 * angle.cos(), 0.7 * angle.sin());
        let ((x, y), (u, v)) = (place(0.0), place(rest));
        let drawn = vec![
            (x, y, (0.25 * rest).tan(), true),
            (u, v, (0.25 * (TAU - rest)).tan(), true),
        ];
        checked("two parts", &drawn, 10, 1e-11);
        // A keyhole: it is not smooth where the line begins.
        let drawn = vec![
            (u, v, (0.25 * (TAU - rest)).tan(), false),
            (x, y, 0.0, false),
            (x + 0.3, y, 0.0, false),
            (u + 0.3, v, 0.0, false),
        ];
        checked("keyhole", &drawn, 11, 4.0 * WISH);
    }
}

#[test]
fn tops_of_a_comb_are_no_longer_on_one_line() {
    let drawn = placed(comb(4, 0.02), 0.2);
    let result = checked("comb", &drawn, 12, 4.0 * WISH);
    // Tops are lines of the drawn height: those whose direction is opposite to that of the bar.
    let n = drawn.len();
    let tops: Vec<usize> = (0..n)
        .filter(|&i| {
            let (a, b) = (drawn[i], drawn[(i + 1) % n]);
            let d = Vector::new(b.0 - a.0, b.1 - a.1).unit();
            let up = (a.1 + 0.0765) * 0.2f64.cos() - (a.0 - 0.1234567) * 0.2f64.sin();
            a.2 == 0.0 && d.cross(Vector::from_angle(0.2)).abs() < 1e-9 && (up - 0.3).abs() < 1e-9
        })
        .collect();
    assert_eq!(tops.len(), 4);
    for (k, &i) in tops.iter().enumerate() {
        for &j in &tops[..k] {
            assert!(sine(&result, i, j) > 1e-14);
            let place = Point::new(result[j].x, result[j].y);
            let from = Vertex {
                bulge: Dd::ZERO,
                ..result[i]
            };
            assert!(off(&from, &result[i + 1], place) > 1e-14);
        }
    }
}

#[test]
fn chains_of_biarcs_stay_smooth() {
    for points in [3, 7, 20, 150] {
        let drawn = biarcs(points, [0.05, 0.02, -0.03, 0.01]);
        checked("biarcs", &drawn, 13, 4.0 * WISH);
        checked("backwards", &backwards(&drawn), 14, 4.0 * WISH);
    }
}

#[test]
fn a_loop_of_corners_is_only_moved() {
    let drawn = placed(
        vec![
            (0.0, 0.0, 0.0, false),
            (1.0, 0.0, 0.3, false),
            (1.0, 1.0, 0.0, false),
            (0.0, 1.0, -0.2, false),
        ],
        0.1,
    );
    let (vertices, smooth) = exact(&drawn);
    let wish = wishes(4, WISH, 15);
    let result = made_generic(&vertices, &smooth, &wish).unwrap();
    for i in 0..4 {
        let by = vector(between(&vertices[i], &result[i]));
        assert!((by.x - wish[i][0]).abs() < 1e-24 && (by.y - wish[i][1]).abs() < 1e-24);
    }
    checked("corners", &drawn, 15, 4.0 * WISH);
    // Without a request nothing is changed.
    let none = vec![[0.0; 3]; 4];
    assert_eq!(made_generic(&vertices, &smooth, &none), Some(vertices));
}

#[test]
fn rounded_drawings_are_mended_by_sliding() {
    for (k, radius) in [0.3, 0.1, 0.03].into_iter().enumerate() {
        for turn in 0..8 {
            let angle = 0.1 + 0.2 * f64::from(turn);
            let drawn = rounded(placed(rounded_rectangle(1.2, 0.8, radius), angle));
            checked("rounded rectangle", &drawn, k as u64, 4.0 * WISH);
            let drawn = rounded(placed(stadium(0.9, 0.3), angle));
            checked("rounded stadium", &drawn, k as u64, 4.0 * WISH);
            let drawn = rounded(placed(comb(3, 0.05), angle));
            checked("rounded comb", &drawn, k as u64, 4.0 * WISH);
        }
    }
    for points in [5, 9, 20] {
        // Curvatures of neighbours differ little at some joints.
        let drawn = rounded(biarcs(points, [0.05, 0.02, -0.03, 0.01]));
        checked("rounded biarcs", &drawn, 16, 4.0 * WISH);
    }
}

#[test]
fn kinks_of_short_edges_turn_them() {
    // Fillets whose ends are displaced along a circle, so that they have kinks of 1e-8 at both ends.
    for radius in [0.3, 1e-2, 1e-4, 1e-6, 1e-8, 2e-9] {
        let mut drawn = rounded_rectangle(1.2, 0.8, radius);
        let mut numbers = Numbers(17);
        for v in &mut drawn {
            v.0 += 1e-8 * radius * numbers.next();
            v.1 += 1e-8 * radius * numbers.next();
        }
        checked("kinked fillets", &drawn, 18, 4.0 * WISH);
    }
    // Short lines between arcs of radius 1/2.
    for length in [1e-2, 1e-4, 1e-5, 1e-6] {
        let mut drawn = stadium(length, 0.5);
        drawn[1].0 += 2e-9;
        drawn[3].1 += 1e-8 * length;
        checked("kinked stadium", &drawn, 19, 4.0 * WISH);
    }
}

#[test]
fn pieces_of_one_line_stay_on_one_line() {
    for pieces in [2, 3, 10, 300, 2000] {
        let mut drawn = rounded_rectangle(1.2, 0.8, 0.1);
        let mut numbers = Numbers(20);
        // The first line is in pieces, some of them short, that meet at up to 3e-10.
        let (from, to) = (drawn[1], drawn[2]);
        for k in 1..pieces {
            let s = (k as f64 + 0.4 * numbers.next()) / pieces as f64;
            let (x, y) = (from.0 + s * (to.0 - from.0), from.1 + s * (to.1 - from.1));
            let off = 1e-10 / pieces as f64 * numbers.next();
            drawn.insert(1 + k, (x, y + off, 0.0, true));
        }
        checked("pieces", &placed(drawn, 0.3), 21, 1e-10 + 4.0 * WISH);
    }
}

#[test]
fn what_cannot_be_mended_is_told() {
    // Invalid input: no loop, no length, or lists of different lengths.
    let (vertices, smooth) = exact(&circle(3, 1.0));
    let wish = wishes(3, WISH, 22);
    assert!(made_generic(&vertices[..1], &smooth[..1], &wish[..1]).is_none());
    assert!(made_generic(&vertices, &smooth[..2], &wish).is_none());
    assert!(made_generic(&vertices, &smooth, &wish[..2]).is_none());
    let twice = [vertices[0], vertices[0], vertices[2]];
    assert!(made_generic(&twice, &smooth, &wish).is_none());
    // Corners that are marked as smooth: a square of lines, a half disc, and a cusp.
    let square = vec![
        (0.0, 0.0, 0.0, true),
        (1.0, 0.0, 0.0, true),
        (1.0, 1.0, 0.0, true),
        (0.0, 1.0, 0.0, true),
    ];
    let half = vec![(0.0, 0.0, 0.0, true), (1.0, 0.0, 1.0, true)];
    let cusp = vec![
        (0.0, 0.0, 0.0, false),
        (1.0, 0.0, 0.0, true),
        (0.5, 0.0, 0.1, false),
    ];
    // Arcs of a circle with a kink of 1e-6.
    let mut kinked = circle(3, 1.0);
    kinked[1].0 += 1e-6;
    for drawn in [square, half, cusp, kinked] {
        let (vertices, smooth) = exact(&drawn);
        let wish = wishes(vertices.len(), WISH, 23);
        assert!(made_generic(&vertices, &smooth, &wish).is_none());
    }
}

#[test]
fn large_loops_take_few_steps() {
    for n in [2000, 20_000] {
        checked(
            "biarcs",
            &biarcs(n / 2, [0.05, 0.02, -0.03, 0.01]),
            24,
            4.0 * WISH,
        );
        checked("circle", &circle(n, 0.8), 25, 4.0 * WISH);
        let teeth = n / 8;
        checked("comb", &comb(teeth, 0.02 / teeth as f64), 26, 4.0 * WISH);
    }
}

/// The result depends only on the input.
#[test]
fn the_same_drawing_gives_the_same_loop() {
    let (vertices, smooth) = exact(&biarcs(9, [0.05, 0.02, -0.03, 0.01]));
    let wish = wishes(vertices.len(), WISH, 27);
    let once = made_generic(&vertices, &smooth, &wish);
    assert!(once.is_some() && once == made_generic(&vertices, &smooth, &wish));
}

/// Number of random loops of each kind.
const CASES: u64 = 256;

#[test]
fn filleted_polygons_become_smooth() {
    for seed in 0..CASES {
        let mut numbers = Numbers(seed.wrapping_mul(0x5851_f42d_4c95_7f2d));
        let n = numbers.between(3.0, 12.0) as usize;
        let mut corners: Vec<(f64, f64, f64)> = (0..n)
            .map(|i| {
                let (r, s) = (numbers.between(0.3, 1.0), numbers.between(0.2, 0.9));
                let v = Vector::from_angle(TAU * (i as f64 + 0.3 * s) / n as f64) * r;
                (v.x, v.y, 0.05 * s / n as f64)
            })
            .collect();
        let (sharp, round) = (numbers.between(0.0, 12.0) as usize, numbers.next() < 0.0);
        if !round {
            corners[0].2 *= 10f64.powf(numbers.between(-8.0, -1.0));
        }
        if let Some(corner) = corners.get_mut(sharp) {
            corner.2 = 0.0;
        }
        let drawn = filleted(&corners);
        // For the shortest edges, rounding would make kinks larger than those of smooth joints.
        let shortest = sides(&exact(&drawn).0)
            .unwrap()
            .iter()
            .fold(1.0, |l, s| s.chord.min(l));
        let drawn = if round && shortest > 1e-3 {
            rounded(drawn)
        } else {
            drawn
        };
        checked("polygon", &drawn, seed, 4.0 * WISH);
    }
}

#[test]
fn biarcs_become_smooth() {
    for seed in 0..CASES {
        let mut numbers = Numbers(seed.wrapping_mul(0x1405_7b7e_f767_814f));
        let points = numbers.between(5.0, 30.0) as usize;
        let waves = [0; 4].map(|_| numbers.between(-0.04, 0.04));
        checked("biarcs", &biarcs(points, waves), seed, 4.0 * WISH);
    }
}
