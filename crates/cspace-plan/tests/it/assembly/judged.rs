//! Steps judged without contact spaces.

use cspace::{Axis, Configuration, Coordinates, Part, Point, Rotation, Vector};
use cspace_model::{Mechanism, PartEntry};
use cspace_oracle::Oracle;
use cspace_plan::assembly::{Assembly, Kind, Step, TakenApart};

use crate::assembly::played::play;

/// Along each leg brute force looks at so many places.
const PLACES: usize = 300;
/// Gap, as a share of the parts' size, at which a part counts as out.
const APART: f64 = 0.05;

pub(crate) fn polygon(name: &str, corners: &[(f64, f64)]) -> Part {
    Part::polygon(name, corners).unwrap()
}

pub(crate) fn mechanism(fixed: &[Part], planar: &[Part]) -> Mechanism {
    let mut mechanism = Mechanism::new("test");
    mechanism.parts = (fixed.iter().cloned().map(PartEntry::fixed))
        .chain(planar.iter().cloned().map(PartEntry::planar))
        .collect();
    mechanism
}

/// Takes it apart, and judges what is said.
pub(crate) fn asked(mechanism: &Mechanism) -> TakenApart {
    let assembly = Assembly::new(mechanism, None).unwrap();
    let apart = assembly.take_apart().unwrap();
    let mut at = vec![Configuration::default(); mechanism.parts.len()];
    for step in &apart.steps {
        judge(mechanism, assembly.parts(), step, &mut at);
    }
    play(mechanism, assembly.parts(), &apart);
    apart
}

/// Where the moving parts are along a step, each as often as brute force looks, to where they are before it; of a part on an axis to
/// where it is drawn.
pub(crate) fn places(step: &Step, axis: Option<Axis>) -> Vec<Configuration> {
    let about = step.path.about;
    let mut places = Vec::new();
    for leg in step.path.configurations.windows(2) {
        for i in 0..=PLACES {
            let t = i as f64 / PLACES as f64;
            let between = |a: f64, b: f64| a + (b - a) * t;
            places.push(match (leg[0], leg[1]) {
                (Coordinates::Planar(a), Coordinates::Planar(b)) => {
                    // The point that legs are about goes straight.
                    let point = |c: Configuration| c.position() + Rotation::by(c.theta) * about;
                    let (p, q) = (point(a), point(b));
                    let theta = between(a.theta, b.theta);
                    let p = Point::new(between(p.x, q.x), between(p.y, q.y));
                    let p = p - Rotation::by(theta) * about;
                    Configuration::new(p.x, p.y, theta)
                }
                (Coordinates::Axes { v, .. }, Coordinates::Axes { v: w, .. }) => {
                    axis.unwrap().configuration(between(v, w))
                }
                _ => panic!("coordinates of one kind"),
            });
        }
    }
    places
}

fn judge(mechanism: &Mechanism, parts: &[Part], step: &Step, at: &mut [Configuration]) {
    let on_axis = matches!(step.path.configurations[0], Coordinates::Axes { .. });
    let axis = mechanism.parts[step.moving[0]].axis;
    let places = places(step, axis);
    if on_axis {
        let (from, (lo, hi)) = (at[step.moving[0]], axis.unwrap().range.unwrap());
        assert!(from.position().distance(places[0].position()) < 1e-12);
        for c in &step.path.configurations {
            assert!(matches!(c, Coordinates::Axes { v, .. } if (lo..=hi).contains(v)));
        }
    } else {
        assert_eq!(places[0], Configuration::default());
    }
    let then = |c: Configuration, m: usize| if on_axis { c } else { c.compose(at[m]) };
    for &m in &step.moving {
        for &s in &step.staying {
            let oracle = Oracle::new(&parts[s], &parts[m]);
            for &c in &places {
                let relative = at[s].inverse().compose(then(c, m));
                assert!(!oracle.judge(relative).overlap, "{m} from {s} at {c:?}");
            }
        }
    }
    let last = places[places.len() - 1];
    if step.kind == Kind::Moves {
        assert_eq!(step.moving.len(), 1);
        at[step.moving[0]] = then(last, step.moving[0]);
        return;
    }
    // The way ends as soon as both are apart along an axis, and ends with both apart.
    let points = |which: &[usize], by: Configuration| -> Vec<Point> {
        (which.iter())
            .flat_map(|&i| {
                let c = by.compose(at[i]);
                points(&parts[i])
                    .into_iter()
                    .map(move |p| c.fixed_from_moving(p))
            })
            .collect()
    };
    let size = |p: &[Point]| {
        let spread = |d: Vector| extent(p, d).1 - extent(p, d).0;
        spread(Vector::new(1.0, 0.0)).hypot(spread(Vector::new(0.0, 1.0)))
    };
    let staying = points(&step.staying, Configuration::default());
    let least = APART * size(&staying).max(size(&points(&step.moving, places[0])));
    let gap = |c: Configuration, directions: usize| {
        let moving = points(&step.moving, c);
        (0..directions)
            .map(|k| {
                let angle = core::f64::consts::TAU * k as f64 / directions as f64;
                let d = Rotation::by(angle) * Vector::new(1.0, 0.0);
                extent(&moving, d).0 - extent(&staying, d).1
            })
            .fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(gap(last, 720) > 0.0, "it is out");
    for &c in places.iter().filter(|c| **c != last).step_by(7) {
        // Distances are rounded up by less than as much again.
        assert!(gap(c, 4) < 2.001 * least, "it was out before");
    }
}

/// Least and greatest p · d.
fn extent(points: &[Point], d: Vector) -> (f64, f64) {
    (points.iter().map(|p| p.to_vector().dot(d)))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
            (a.min(x), b.max(x))
        })
}

/// Points all along the boundary.
fn points(part: &Part) -> Vec<Point> {
    (part.edges())
        .flat_map(|e| (0..64).map(move |k| e.at(f64::from(k) / 64.0)))
        .collect()
}
