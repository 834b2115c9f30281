//! Motions whose events are known by hand or from the literature.

use cspace_motion::dynamic::{
    Ended, EventKind, Mode, Motion, Observer, Options, State, Surface, Touch, World, run,
};
use nalgebra::{DMatrix, DVector};

/// A system written down by functions.
struct Written {
    mass: DMatrix<f64>,
    force: fn(&DVector<f64>, &DVector<f64>) -> DVector<f64>,
    touches: Vec<fn(&DVector<f64>) -> Touch>,
    surfaces: Vec<Surface>,
    size: f64,
}

impl World for Written {
    fn mass(&self) -> &DMatrix<f64> {
        &self.mass
    }
    fn force(&self, state: &State) -> DVector<f64> {
        (self.force)(&state.q, &state.v)
    }
    fn watched(&self) -> Vec<usize> {
        (0..self.touches.len()).collect()
    }
    fn touch(&self, contact: usize, _: f64, q: &DVector<f64>) -> Touch {
        (self.touches[contact])(q)
    }
    fn surface(&self, contact: usize) -> Surface {
        self.surfaces[contact]
    }
    fn size(&self) -> f64 {
        self.size
    }
}

/// The states at the ends of steps.
#[derive(Default)]
struct Steps(Vec<State>);

impl Observer for Steps {
    fn step(&mut self, state: &State) {
        self.0.push(state.clone());
    }
}

fn surface(friction: f64, restitution: f64) -> Surface {
    Surface {
        friction,
        restitution,
    }
}

fn at(q: DVector<f64>, v: DVector<f64>) -> State {
    State { t: 0.0, q, v }
}

fn moved(world: &Written, start: State, until: f64) -> Motion {
    followed(world, start, until, false)
}

fn followed(world: &Written, start: State, until: f64, strict: bool) -> Motion {
    let longest = until;
    let options = Options {
        until,
        longest,
        strict,
    };
    run(world, start, &options, &mut ())
}

fn times(motion: &Motion, kind: EventKind) -> Vec<f64> {
    motion
        .events
        .iter()
        .filter(|e| e.kind == kind)
        .map(|e| e.t)
        .collect()
}

fn ball(restitution: f64) -> Written {
    Written {
        mass: DMatrix::from_row_slice(1, 1, &[2.0]),
        force: |_, _| DVector::from_vec(vec![-2.0 * 9.81]),
        touches: vec![|q| Touch {
            gap: q[0],
            normal: DVector::from_vec(vec![1.0]),
            tangent: DVector::from_vec(vec![0.0]),
            drift: [0.0; 2],
        }],
        surfaces: vec![surface(0.0, restitution)],
        size: 1.0,
    }
}

/// √(2h/g) (1 + e) / (1 − e).
#[test]
fn a_bouncing_ball_comes_to_rest() {
    for e in [0.0, 0.3, 0.5, 0.8, 0.9] {
        let motion = moved(
            &ball(e),
            at(DVector::from_vec(vec![1.0]), DVector::from_vec(vec![0.0])),
            10.0,
        );
        assert_eq!(motion.ended, Ended::Done);
        let first = f64::sqrt(2.0 / 9.81);
        let impacts = times(&motion, EventKind::Impact);
        assert!((impacts[0] - first).abs() < 1e-13, "{}", impacts[0] - first);
        if e == 0.0 {
            assert_eq!(impacts.len(), 1);
            continue;
        }
        assert!((impacts[1] - first * (1.0 + 2.0 * e)).abs() < 1e-12);
        let rest = times(&motion, EventKind::Rest)[0];
        let known = first * (1.0 + e) / (1.0 - e);
        assert!((rest - known).abs() < 1e-9, "{e} {rest} {known}");
        assert!(motion.last.q[0].abs() < 1e-9 && motion.last.v[0].abs() < 1e-12);
    }
}

/// A block on an incline: along it and off it are the coordinates.
#[test]
fn a_block_slides_down_and_sticks() {
    let slope = 0.3_f64;
    let incline = |friction: f64| Written {
        mass: DMatrix::from_row_slice(2, 2, &[1.5, 0.0, 0.0, 1.5]),
        force: |_, _| DVector::from_vec(vec![-f64::sin(0.3), -f64::cos(0.3)]) * (1.5 * 9.81),
        touches: vec![|q| Touch {
            gap: q[1],
            normal: DVector::from_vec(vec![0.0, 1.0]),
            tangent: DVector::from_vec(vec![1.0, 0.0]),
            drift: [0.0; 2],
        }],
        surfaces: vec![surface(friction, 0.0)],
        size: 1.0,
    };
    // Pushed up, it comes to a stop after v / g (sin + μ cos), and stays if μ > tan.
    for friction in [0.2, 0.5] {
        let motion = moved(
            &incline(friction),
            at(
                DVector::from_vec(vec![0.0, 0.0]),
                DVector::from_vec(vec![2.0, 0.0]),
            ),
            3.0,
        );
        assert_eq!(motion.ended, Ended::Done);
        let up = 9.81 * (slope.sin() + friction * slope.cos());
        let stop = 2.0 / up;
        if friction > slope.tan() {
            assert!((times(&motion, EventKind::Stick)[0] - stop).abs() < 1e-12);
            assert!((motion.last.q[0] - 2.0 * stop / 2.0).abs() < 1e-12);
            assert!(motion.last.v[0].abs() < 1e-12);
        } else {
            let down = 9.81 * (slope.sin() - friction * slope.cos());
            let left = 3.0 - stop;
            let known = 0.5 * up * stop * stop - 0.5 * down * left * left;
            assert!(
                (motion.last.q[0] - known).abs() < 1e-11,
                "{}",
                motion.last.q[0] - known
            );
        }
    }
}

/// Housner's block, of half width b and half height h: ω⁺/ω⁻ = 1 − 1.5 sin²α, tan α = b/h.
#[test]
fn a_rocking_block_loses_housner_s_share() {
    const B: f64 = 0.2;
    const H: f64 = 0.5;
    fn left(q: &DVector<f64>) -> Touch {
        touch(q, -1.0)
    }
    fn right(q: &DVector<f64>) -> Touch {
        touch(q, 1.0)
    }
    fn touch(q: &DVector<f64>, side: f64) -> Touch {
        let (sin, cos) = q[2].sin_cos();
        let (x, y) = (side * B, -H);
        Touch {
            gap: q[1] + sin * x + cos * y,
            normal: DVector::from_vec(vec![0.0, 1.0, cos * x - sin * y]),
            tangent: DVector::from_vec(vec![1.0, 0.0, -sin * x - cos * y]),
            drift: [0.0; 2],
        }
    }
    let m = 3.0;
    let block = Written {
        mass: DMatrix::from_diagonal(&DVector::from_vec(vec![m, m, m * (B * B + H * H) / 3.0])),
        force: |_, _| DVector::from_vec(vec![0.0, -3.0 * 9.81, 0.0]),
        touches: vec![left, right],
        surfaces: vec![surface(10.0, 0.0); 2],
        size: 1.0,
    };
    // Tilted about its left corner.
    let tilt = 0.1_f64;
    let (sin, cos) = tilt.sin_cos();
    let q = DVector::from_vec(vec![B * cos - H * sin, B * sin + H * cos, tilt]);
    let mut steps = Steps::default();
    let motion = run(
        &block,
        at(q, DVector::zeros(3)),
        &Options {
            until: 1.0,
            longest: 0.01,
            strict: false,
        },
        &mut steps,
    );
    assert_eq!(motion.ended, Ended::Done);
    let rates: Vec<(f64, f64)> = steps.0.iter().map(|s| (s.t, s.v[2])).collect();
    let first = times(&motion, EventKind::Impact)[0];
    let before = rates.iter().rev().find(|r| r.0 <= first).unwrap().1;
    // Angular momentum about the right corner: the energy on the way there gives the rate before.
    let alpha = f64::atan2(B, H);
    let ratio = 1.0 - 1.5 * alpha.sin() * alpha.sin();
    let inertia = 4.0 / 3.0 * (B * B + H * H);
    let height = f64::hypot(B, H) * ((alpha - tilt).cos() - alpha.cos());
    let known = -(2.0 * 9.81 * height / inertia).sqrt();
    assert!((before - known).abs() < 1e-9, "{before} {known}");
    let second = rates
        .iter()
        .filter(|r| r.0 > first)
        .map(|r| r.1.abs())
        .fold(0.0, f64::max);
    assert!(
        (second / before.abs() - ratio).abs() < 1e-6,
        "{} {ratio}",
        second / before.abs()
    );
}

/// Glocker's woodpecker (ASME DETC2001/VIB-21608): a sleeve on a bar with a bird on a spring.
#[test]
fn the_woodpecker_pecks() {
    const M: (f64, f64) = (0.0003, 0.0045);
    const J: (f64, f64) = (5e-9, 7e-7);
    const L: (f64, f64, f64) = (0.01, 0.015, 0.0201);
    const R: (f64, f64) = (0.0025, 0.0031);
    const HIGH: (f64, f64) = (0.0058, 0.02);
    let woodpecker = Written {
        mass: DMatrix::from_row_slice(
            3,
            3,
            &[
                M.0 + M.1,
                M.1 * L.0,
                M.1 * L.1,
                M.1 * L.0,
                J.0 + M.1 * L.0 * L.0,
                M.1 * L.0 * L.1,
                M.1 * L.1,
                M.1 * L.0 * L.1,
                J.1 + M.1 * L.1 * L.1,
            ],
        ),
        force: |q, _| {
            let (g, c) = (9.81, 0.0056);
            DVector::from_vec(vec![
                -(M.0 + M.1) * g,
                -c * (q[1] - q[2]) - M.1 * L.0 * g,
                -c * (q[2] - q[1]) - M.1 * L.1 * g,
            ])
        },
        touches: vec![
            |q| Touch {
                gap: L.0 + L.1 - L.2 - R.0 - HIGH.1 * q[2],
                normal: DVector::from_vec(vec![0.0, 0.0, -HIGH.1]),
                tangent: DVector::from_vec(vec![1.0, L.0, L.1 - L.2]),
                drift: [0.0; 2],
            },
            |q| Touch {
                gap: R.1 - R.0 + HIGH.0 * q[1],
                normal: DVector::from_vec(vec![0.0, HIGH.0, 0.0]),
                tangent: DVector::from_vec(vec![1.0, R.1, 0.0]),
                drift: [0.0; 2],
            },
            |q| Touch {
                gap: R.1 - R.0 - HIGH.0 * q[1],
                normal: DVector::from_vec(vec![0.0, -HIGH.0, 0.0]),
                tangent: DVector::from_vec(vec![1.0, R.1, 0.0]),
                drift: [0.0; 2],
            },
        ],
        surfaces: vec![surface(0.3, 0.5), surface(0.3, 0.0), surface(0.3, 0.0)],
        size: 0.02,
    };
    let start = at(
        DVector::from_vec(vec![0.0, -0.0006 / 0.0058, -0.2788]),
        DVector::from_vec(vec![-0.3411, 0.0, -7.4583]),
    );
    let mut steps = Steps::default();
    let options = Options {
        until: 3.5,
        longest: 1.0,
        strict: false,
    };
    let motion = run(&woodpecker, start, &options, &mut steps);
    let heights: Vec<(f64, f64)> = steps.0.iter().map(|s| (s.t, s.q[0])).collect();
    assert_eq!(motion.ended, Ended::Done);
    let impacts = times(&motion, EventKind::Impact);
    let known = [0.077_877_992, 0.080_988_805, 0.081_575_329, 0.118_675_113];
    for (known, found) in known.iter().zip(&impacts) {
        assert!((known - found).abs() < 1e-8, "{known} {found}");
    }
    // The beak strikes once in a cycle.
    let pecks: Vec<f64> = (motion.events.iter())
        .filter(|e| e.contact == 0 && e.kind == EventKind::Impact)
        .map(|e| e.t)
        .collect();
    // Its cycles tend to one as a geometric series, whose limit is Aitken's.
    let limit = |of: &dyn Fn(f64) -> f64| {
        let of: Vec<f64> = pecks.iter().map(|&t| of(t)).collect();
        let each: Vec<f64> = of.windows(2).map(|w| w[1] - w[0]).collect();
        let [.., a, b, c] = each.as_slice() else {
            panic!("{pecks:?}");
        };
        c - (c - b) * (c - b) / ((c - b) - (b - a))
    };
    let period = limit(&|t| t);
    assert!((period - 0.145_976_065).abs() < 1e-8, "{period}");
    let drop = limit(&|t| heights.iter().find(|h| h.0 == t).unwrap().1);
    assert!((drop + 19.445_379e-3).abs() < 1e-8, "{drop}");
}

/// Painlevé's rod, whose lower end slides over the ground: without solution where 1 + 3 cos θ (cos θ − μ sin θ) < 0 and the end is
/// pressed down, with several where it would lift off.
#[test]
fn painleve_s_rod_is_told() {
    // Half a length of 1: I = m / 3; the middle is at x, y, and the rod leans by θ from the ground.
    fn end(q: &DVector<f64>) -> Touch {
        let (sin, cos) = q[2].sin_cos();
        Touch {
            gap: q[1] - sin,
            normal: DVector::from_vec(vec![0.0, 1.0, -cos]),
            tangent: DVector::from_vec(vec![1.0, 0.0, sin]),
            drift: [0.0; 2],
        }
    }
    for (theta, friction, omega) in [
        (1.0, 1.0, 0.0),
        (1.0, 3.0, 0.0),
        (1.2, 3.5, 0.0),
        (1.0, 3.0, 6.0),
    ] {
        let rod = Written {
            mass: DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 1.0, 1.0 / 3.0])),
            force: |_, _| DVector::from_vec(vec![0.0, -9.81, 0.0]),
            touches: vec![end],
            surfaces: vec![surface(friction, 0.0)],
            size: 2.0,
        };
        let (sin, cos) = f64::sin_cos(theta);
        // The end slides one way or the other: the rod leans against its way in one of them.
        for way in [1.0, -1.0] {
            let start = at(
                DVector::from_vec(vec![0.0, sin, theta]),
                DVector::from_vec(vec![way * 5.0 - sin * omega, cos * omega, omega]),
            );
            let motion = followed(&rod, start.clone(), 1e-4, true);
            let paradox = 1.0 + 3.0 * cos * (cos + way * friction * sin) < 0.0;
            // What the end does without force: −g + ω² sin θ.
            let lifts = omega * omega * sin > 9.81;
            let contacts = vec![0];
            let known = match (paradox, lifts) {
                (false, _) => Ended::Done,
                (true, false) => Ended::Inconsistent { contacts },
                (true, true) => Ended::Undetermined { contacts },
            };
            assert_eq!(motion.ended, known, "{theta} {friction} {omega} {way}");
            // Of several motions one is taken: the end lifts, which changes nothing by force.
            let motion = moved(&rod, start, 1e-4);
            if let Ended::Undetermined { .. } = known {
                assert_eq!(motion.ended, Ended::Done);
                let choice = motion.events[0].choice.clone().unwrap();
                assert_eq!(motion.events[0].kind, EventKind::Choice);
                assert_eq!(choice.taken, [Mode::Open], "{choice:?}");
                assert!(!choice.others.is_empty(), "{choice:?}");
                let gap = motion.last.q[1] - motion.last.q[2].sin();
                assert!(gap > 0.0, "{motion:?}");
            } else {
                assert_eq!(motion.ended, known);
            }
        }
    }
}

/// A disc that slides over the ground rolls after v / 3 μ g, with two thirds of its rate.
#[test]
fn a_disc_slides_then_rolls() {
    let disc = Written {
        mass: DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 2.0, 0.5 * 2.0 * 0.3 * 0.3])),
        force: |_, _| DVector::from_vec(vec![0.0, -2.0 * 9.81, 0.0]),
        touches: vec![|q| Touch {
            gap: q[1] - 0.3,
            normal: DVector::from_vec(vec![0.0, 1.0, 0.0]),
            tangent: DVector::from_vec(vec![1.0, 0.0, 0.3]),
            drift: [0.0; 2],
        }],
        surfaces: vec![surface(0.25, 0.0)],
        size: 0.6,
    };
    let start = at(
        DVector::from_vec(vec![0.0, 0.3, 0.0]),
        DVector::from_vec(vec![4.0, 0.0, 0.0]),
    );
    let motion = moved(&disc, start, 5.0);
    assert_eq!(motion.ended, Ended::Done);
    let rolls = times(&motion, EventKind::Stick)[0];
    assert!((rolls - 4.0 / (3.0 * 0.25 * 9.81)).abs() < 1e-12, "{rolls}");
    assert!((motion.last.v[0] - 8.0 / 3.0).abs() < 1e-11);
    assert!((motion.last.v[2] * 0.3 + 8.0 / 3.0).abs() < 1e-11);
}
