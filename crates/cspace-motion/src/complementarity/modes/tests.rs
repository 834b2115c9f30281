use nalgebra::{DMatrix, DVector};

use super::{Bearing, Problem, Solution};
use crate::complementarity::numbers::Numbers;
use crate::complementarity::reduced::Reduced;
use crate::linear::{Cholesky, nonnegative};

fn bearing(normal: DVector<f64>, tangent: DVector<f64>, friction: f64) -> Bearing {
    Bearing {
        normal,
        tangent,
        b: 0.0,
        c: 0.0,
        friction,
        slides: None,
        lets_go: false,
    }
}

fn problem(mass: &DMatrix<f64>, h: DVector<f64>, bearings: Vec<Bearing>) -> Problem<'_> {
    Problem {
        mass,
        joints: DMatrix::zeros(0, h.len()),
        h,
        j: DVector::zeros(0),
        bearings,
        zero: 1e-9,
    }
}

fn pivoted(problem: &Problem) -> Vec<Solution> {
    Reduced::of(problem).map_or(Vec::new(), |reduced| problem.pivoted(&reduced))
}

fn enumerated(problem: &Problem) -> Vec<Solution> {
    Reduced::of(problem).map_or(Vec::new(), |reduced| problem.enumerated(&reduced))
}

/// The laws, from the numbers of the problem alone.
fn judge(problem: &Problem, s: &Solution) {
    let mut rest = problem.mass * &s.x - &problem.h;
    let mut force = problem.h.amax();
    let factor = problem.mass.clone().cholesky().unwrap();
    let mut rate = s.x.amax().max(factor.solve(&problem.h).amax());
    for (i, b) in problem.bearings.iter().enumerate() {
        rest -= &b.normal * s.normal[i] + &b.tangent * s.tangential[i];
        force = force.max(s.normal[i].abs()).max(s.tangential[i].abs());
        rate = rate.max(b.b.abs()).max(b.c.abs());
    }
    if problem.joints.nrows() > 0 {
        // The first are independent.
        let first = problem.joints.rows(0, problem.h.len() / 4);
        let gram = (first * first.transpose()).cholesky().unwrap();
        rest -= first.transpose() * gram.solve(&(first * &rest));
        let off = (&problem.joints * &s.x - &problem.j).amax();
        assert!(off < 1e-9 * (rate + problem.j.amax()), "joints {off}");
    }
    let (force, rate) = (1e-8 * force, 1e-8 * rate);
    assert!(rest.amax() < force, "{rest} {s:?}");
    for (i, b) in problem.bearings.iter().enumerate() {
        let (n, t) = (s.normal[i], s.tangential[i]);
        let a_n = b.normal.dot(&s.x) + b.b;
        let a_t = b.tangent.dot(&s.x) + b.c;
        assert!(
            n > -force && a_n > -rate && (n < force || a_n < rate),
            "{i} {s:?}"
        );
        assert!(t.abs() < b.friction * n + force, "{i} {s:?}");
        let direction = match b.slides {
            Some(s) => s,
            None if a_t.abs() > rate => a_t.signum(),
            None => continue,
        };
        assert!((t + direction * b.friction * n).abs() < force, "{i} {s:?}");
    }
}

/// A problem with as many coordinates, contacts and joints; joints may follow from each other.
fn random<'a>(numbers: &mut Numbers, mass: &'a DMatrix<f64>, contacts: usize) -> Problem<'a> {
    let n = mass.nrows();
    let independent = numbers.matrix(n / 4, n);
    let more = numbers.below(2);
    let joints = if independent.nrows() > 0 {
        let mix = numbers.matrix(more, independent.nrows());
        let rows = [independent.clone(), mix * independent];
        DMatrix::from_fn(rows[0].nrows() + more, n, |i, k| {
            let first = rows[0].nrows();
            if i < first {
                rows[0][(i, k)]
            } else {
                rows[1][(i - first, k)]
            }
        })
    } else {
        independent
    };
    let j = &joints * numbers.vector(n);
    let bearings = (0..contacts)
        .map(|_| {
            let frictionless = numbers.below(4) == 0;
            let slides = numbers.below(3) == 0;
            Bearing {
                normal: numbers.vector(n),
                tangent: numbers.vector(n),
                b: 0.3 * numbers.number(),
                c: 0.3 * numbers.number(),
                friction: if frictionless {
                    0.0
                } else {
                    0.5 * numbers.share()
                },
                slides: slides.then(|| numbers.number().signum()),
                lets_go: false,
            }
        })
        .collect();
    Problem {
        mass,
        h: numbers.vector(n) * 3.0,
        joints,
        j,
        bearings,
        zero: 1e-9,
    }
}

fn mass(numbers: &mut Numbers, n: usize) -> DMatrix<f64> {
    let a = numbers.matrix(n, n);
    &a * a.transpose() + DMatrix::identity(n, n) * 0.3
}

/// Lemke's method finds the solution where the combinations of modes have one, none where they have none, and one of
/// them where they have several.
#[test]
fn both_ways_agree() {
    let mut numbers = Numbers::of(1);
    let (mut one, mut missed) = (0, 0);
    for round in 0..600 {
        let n = 3 + numbers.below(7);
        let mass = mass(&mut numbers, n);
        let problem = random(&mut numbers, &mass, 1 + round % 6);
        let all = enumerated(&problem);
        let found = pivoted(&problem);
        for solution in all.iter().chain(&found) {
            judge(&problem, solution);
        }
        for solution in &found {
            let near = |s: &Solution| (&s.x - &solution.x).amax() < 1e-10 * (1.0 + s.x.amax());
            assert!(all.iter().any(near), "{round}");
        }
        one += usize::from(all.len() == 1);
        missed += usize::from(!all.is_empty() && found.is_empty());
    }
    assert!(one > 400);
    assert_eq!(missed, 0);
}

/// A block 2 wide and 1 high, its centre the origin, on points of the floor evenly from −1 to 1.
fn on_floor(points: usize, friction: f64) -> Vec<Bearing> {
    (0..points)
        .map(|k| {
            let x = -1.0 + 2.0 * k as f64 / (points - 1) as f64;
            bearing(
                DVector::from_vec(vec![0.0, 1.0, x]),
                DVector::from_vec(vec![1.0, 0.0, 0.5]),
                friction,
            )
        })
        .collect()
}

/// As above, for points of the body's left side at a wall, from −0.5 to 0.5.
fn at_wall(points: usize, friction: f64) -> Vec<Bearing> {
    (0..points)
        .map(|k| {
            let y = -0.5 + k as f64 / (points - 1) as f64;
            bearing(
                DVector::from_vec(vec![1.0, 0.0, -y]),
                DVector::from_vec(vec![0.0, 1.0, -1.0]),
                friction,
            )
        })
        .collect()
}

fn one(problem: &Problem) -> Solution {
    let mut found = problem.solutions();
    assert_eq!(found.len(), 1, "{found:?}");
    judge(problem, &found[0]);
    found.remove(0)
}

const GRAVITY: f64 = 9.81;

#[test]
fn a_block_on_many_points() {
    let m = 3.0;
    let mass = DMatrix::from_diagonal(&DVector::from_vec(vec![m, m, m * (4.0 + 1.0) / 12.0]));
    let weight = m * GRAVITY;
    for points in [2, 20, 40] {
        for friction in [0.0, 0.2, 0.6] {
            for push in [0.0, 0.1, 0.19, 0.3, 0.7] {
                // Through the centre: it tilts only with a push of twice the weight.
                let h = DVector::from_vec(vec![push * weight, -weight, 0.0]);
                let problem = problem(&mass, h, on_floor(points, friction));
                let solution = one(&problem);
                let known = (push - friction).max(0.0) * GRAVITY;
                let off = (&solution.x - DVector::from_vec(vec![known, 0.0, 0.0])).amax();
                assert!(off < 1e-12, "{points} {friction} {push} {off}");
                let borne: f64 = solution.normal.iter().sum();
                assert!((borne - weight).abs() < 1e-11 * weight);
            }
        }
        // With a torque it tilts, about its corner, where it sticks: as with two points.
        let h = DVector::from_vec(vec![0.0, -weight, 1.5 * weight]);
        let tilted = one(&problem(&mass, h.clone(), on_floor(points, 1.0)));
        let about = m * (4.0 + 1.0) / 12.0 + m * 1.25;
        let known = 0.5 * weight / about;
        assert!(
            (tilted.x[2] - known).abs() < 1e-11,
            "{points} {}",
            tilted.x[2]
        );
    }
}

#[test]
fn a_block_in_a_corner() {
    let m = 3.0;
    let mass = DMatrix::from_diagonal(&DVector::from_vec(vec![m, m, m * 5.0 / 12.0]));
    let weight = m * GRAVITY;
    for friction in [0.0, 0.3] {
        for points in [4, 20] {
            let mut bearings = on_floor(points, friction);
            bearings.extend(at_wall(points, friction));
            // Into the corner: at rest.
            let h = DVector::from_vec(vec![-weight, -weight, 0.1 * weight]);
            let rest = one(&problem(&mass, h, bearings.clone()));
            assert!(rest.x.amax() < 1e-12, "{}", rest.x);
            // Out of it along the floor: the wall bears nothing.
            let h = DVector::from_vec(vec![0.5 * weight, -weight, 0.0]);
            let out = one(&problem(&mass, h, bearings.clone()));
            let known = (0.5 - friction) * GRAVITY;
            assert!((out.x[0] - known).abs() < 1e-12 && out.x[1].abs() < 1e-12);
            // Up along the wall, that it is pressed against.
            let h = DVector::from_vec(vec![-weight, weight, 0.0]);
            let up = one(&problem(&mass, h, bearings.clone()));
            let known = (1.0 - friction) * GRAVITY;
            assert!((up.x[1] - known).abs() < 1e-12 && up.x[0].abs() < 1e-12);
        }
    }
}

/// Discs of radius 1 and mass 1 in a column between walls, each against one of them in turn: the line from one to the next leans by an
/// angle from the vertical.
fn column(discs: usize, lean: f64, friction: f64) -> (DMatrix<f64>, DVector<f64>, Vec<Bearing>) {
    let n = 3 * discs;
    let mass = DMatrix::from_fn(n, n, |i, k| match (i == k, i % 3) {
        (false, _) => 0.0,
        (true, 2) => 0.5,
        (true, _) => 1.0,
    });
    let h = DVector::from_fn(n, |i, _| if i % 3 == 1 { -GRAVITY } else { 0.0 });
    // A contact of a disc with what is fixed in a direction from its centre, or with another disc there.
    let touch = |disc: usize, (x, y): (f64, f64), other: Option<usize>| {
        let mut normal = DVector::zeros(n);
        let mut tangent = DVector::zeros(n);
        for (i, sign) in [(Some(disc), 1.0), (other, -1.0)] {
            let Some(i) = i else { continue };
            normal[3 * i] = -x * sign;
            normal[3 * i + 1] = -y * sign;
            tangent[3 * i] = -y * sign;
            tangent[3 * i + 1] = x * sign;
            tangent[3 * i + 2] = 1.0;
        }
        bearing(normal, tangent, friction)
    };
    let mut bearings = vec![touch(0, (0.0, -1.0), None)];
    for i in 0..discs {
        let side = if i % 2 == 0 { -1.0 } else { 1.0 };
        bearings.push(touch(i, (side, 0.0), None));
        if lean == 0.0 {
            bearings.push(touch(i, (-side, 0.0), None));
        }
        if i + 1 < discs {
            bearings.push(touch(i, (-side * lean.sin(), lean.cos()), Some(i + 1)));
        }
    }
    (mass, h, bearings)
}

#[test]
fn ten_discs_in_a_column() {
    for lean in [0.0, 0.4] {
        for friction in [0.0, 0.3] {
            let (mass, h, bearings) = column(10, lean, friction);
            let problem = problem(&mass, h, bearings);
            let rest = one(&problem);
            assert!(rest.x.amax() < 1e-10, "{lean} {friction} {}", rest.x);
            if friction == 0.0 && lean > 0.0 {
                // The floor bears all, the wall at the lowest disc what leans on it.
                assert!((rest.normal[0] - 10.0 * GRAVITY).abs() < 1e-10);
                let pushed = 9.0 * GRAVITY * lean.tan();
                assert!((rest.normal[1] - pushed).abs() < 1e-10);
            }
        }
        // Without friction and without a floor it falls as a whole.
        let (mass, h, mut bearings) = column(10, 0.0, 0.0);
        bearings.remove(0);
        let falls = one(&problem(&mass, h, bearings));
        for i in 0..10 {
            assert!((falls.x[3 * i + 1] + GRAVITY).abs() < 1e-11);
        }
    }
}

/// Painlevé's rod, pressed down while it slides against its lean, with so many open contacts beside it that
/// combinations of modes are not tried.
#[test]
fn a_paradox_is_told_beside_other_contacts() {
    let mass = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 1.0, 1.0 / 3.0, 1.0]));
    let theta = 1.0_f64;
    let (sin, cos) = theta.sin_cos();
    for (friction, slides) in [(1.0, -1.0), (3.0, -1.0), (3.0, 1.0)] {
        let mut end = bearing(
            DVector::from_vec(vec![0.0, 1.0, -cos, 0.0]),
            DVector::from_vec(vec![1.0, 0.0, sin, 0.0]),
            friction,
        );
        end.slides = Some(slides);
        let mut bearings = vec![end];
        for _ in 0..12 {
            bearings.push(bearing(
                DVector::from_vec(vec![0.0, 0.0, 0.0, 1.0]),
                DVector::zeros(4),
                0.0,
            ));
        }
        let h = DVector::from_vec(vec![0.0, -GRAVITY, 0.0, 0.5]);
        let found = problem(&mass, h, bearings).solutions();
        let paradox = 1.0 + 3.0 * cos * (cos + slides * friction * sin) < 0.0;
        assert_eq!(found.is_empty(), paradox, "{friction} {slides}");
    }
}

/// Without friction the solution is a projection on a cone, which nonnegative least squares confirm.
#[test]
fn without_friction_it_is_a_projection() {
    let mut numbers = Numbers::of(5);
    let mut borne = 0;
    for round in 0..60 {
        let n = 4 + numbers.below(12);
        let mass = mass(&mut numbers, n);
        let h = numbers.vector(n);
        let bearings: Vec<Bearing> = (0..30)
            .map(|_| bearing(numbers.vector(n), numbers.vector(n), 0.0))
            .collect();
        let factor = Cholesky::of(mass.as_slice(), n).unwrap();
        let mut free = h.as_slice().to_vec();
        factor.forward(&mut free);
        let columns: Vec<Vec<f64>> = (bearings.iter())
            .map(|b| {
                let mut k = b.normal.as_slice().to_vec();
                factor.forward(&mut k);
                let long = crate::linear::length(&k);
                k.iter().map(|x| x / long).collect()
            })
            .collect();
        let against: Vec<f64> = free.iter().map(|x| -x).collect();
        let mut known: Vec<f64> = (nonnegative(&columns, &against).residual.iter())
            .map(|x| -x)
            .collect();
        factor.backward(&mut known);
        let solution = one(&problem(&mass, h, bearings));
        let off = (&solution.x - DVector::from_vec(known)).amax();
        assert!(off < 1e-11, "{round} {off}");
        borne += solution.normal.iter().filter(|f| **f > 0.0).count();
    }
    assert!(borne > 60);
}

/// Non-finite numbers, rows of zeros, invalid masses: no solution, or a correct one, and always an end.
#[test]
fn hostile_numbers_come_to_an_end() {
    let mut numbers = Numbers::of(11);
    for round in 0..400 {
        let n = 3;
        let mut mass = mass(&mut numbers, n);
        let bad = [f64::NAN, f64::INFINITY, 0.0, -1e300, 1e-300][round % 5];
        let place = (round / 5) % 8;
        if place == 0 {
            mass[(1, 1)] = bad;
        }
        let mut problem = random(&mut numbers, &mass, 2 + 6 * (round % 2));
        match place {
            1 => problem.h[0] = bad,
            2 => problem.bearings[0].normal.fill(bad),
            3 => problem.bearings[1].tangent.fill(bad),
            4 => problem.bearings[1].b = bad,
            5 => problem.bearings[0].c = bad,
            6 => problem.bearings[0].friction = bad.abs(),
            7 => problem.bearings.iter_mut().for_each(|b| b.normal.fill(bad)),
            _ => {}
        }
        let found = [problem.solutions(), enumerated(&problem), pivoted(&problem)].concat();
        let numbers = |s: &Solution| s.x.iter().chain(&s.normal).all(|x| x.is_finite());
        assert!(found.iter().all(numbers), "{round}");
    }
}
