//! Steps judged without contact spaces.

use cspace::{Configuration, Coordinates, Mechanism, Part, mechanism::PartEntry};
use cspace_oracle::Oracle;
use cspace_plan::assembly::{Assembly, Step, TakenApart};
use cspace_plan::legs::Scene;
use cspace_plan::{Checked, check};

/// Along each leg brute force looks at so many places.
const PLACES: usize = 300;

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
    for step in &apart.steps {
        judge(assembly.parts(), step);
    }
    apart
}

fn judge(parts: &[Part], step: &Step) {
    let path = &step.path.configurations;
    let places: Vec<Configuration> = (path.iter())
        .map(|at| match at {
            Coordinates::Planar(c) => *c,
            Coordinates::Axes { .. } => panic!("planar parts"),
        })
        .collect();
    assert_eq!(places[0], Configuration::default());
    for &m in &step.moving {
        for &s in &step.staying {
            let scene = Scene::new(&parts[s], &parts[m], None);
            assert!(matches!(check(&scene, path).unwrap(), Checked::Free(_)));
            let oracle = Oracle::new(&parts[s], &parts[m]);
            for leg in places.windows(2) {
                for i in 0..=PLACES {
                    let t = i as f64 / PLACES as f64;
                    let between = |a: f64, b: f64| a + (b - a) * t;
                    let c = Configuration::new(
                        between(leg[0].x, leg[1].x),
                        between(leg[0].y, leg[1].y),
                        between(leg[0].theta, leg[1].theta),
                    );
                    assert!(!oracle.judge(c).overlap, "{m} from {s} at {c:?}");
                }
            }
            let end = oracle.judge(places[places.len() - 1]);
            assert!(end.clearance > 0.05 * oracle.size() / 10.0, "it is away");
        }
    }
}
