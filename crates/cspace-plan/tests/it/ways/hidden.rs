//! A way that rounding hides, which the moving part grown shows.

use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, Vertex};
use cspace_plan::{Clearance, Planner, Verdict, Wishes};

fn part(name: &str, vertices: &[(f64, f64, f64)]) -> Part {
    let vertices = vertices.iter().map(|&(x, y, b)| Vertex::new(x, y, b));
    Part::new(name, vec![vertices.collect()]).unwrap()
}

#[test]
fn it_has_a_clearance_and_a_bound() {
    let stud = part(
        "stud",
        &[
            (0.001515812374197222, 0.000531823484245275, 0.0),
            (0.0008607587350721611, 0.0010736206624506778, 0.0),
            (-0.002470598336657685, -0.0007539057695814127, 0.0),
            (
                -0.0009852890375437145,
                -0.0028301817191107984,
                -0.6737909978803873,
            ),
        ],
    );
    // A spiral of walls 0.0016 thick, with the stud within it.
    let walls = [
        (0.007002887403633813, 0.000778098600403757),
        (0.007002887403633813, 0.010893380405652598),
        (-0.007002887403633813, 0.010893380405652598),
        (-0.007002887403633813, -0.007002887403633813),
        (0.014783873407671384, -0.007002887403633813),
        (0.014783873407671384, 0.019452465010093924),
        (0.016340070608478897, 0.019452465010093924),
        (0.016340070608478897, -0.008559084604441327),
        (-0.008559084604441327, -0.008559084604441327),
        (-0.008559084604441327, 0.012449577606460111),
        (0.008559084604441327, 0.012449577606460111),
        (0.008559084604441327, -0.000778098600403757),
        (0.0, -0.000778098600403757),
        (0.0, 0.000778098600403757),
    ];
    let spiral = part("spiral", &walls.map(|(x, y)| (x, y, 0.0)));
    let space = PairSpace::compute(&stud, &spiral, Relation::Planar, &Options::default()).unwrap();
    let planner = Planner::new(&space).unwrap();
    let from = [
        0.0020822320918306284,
        -0.004031167173046642,
        -2.379888045091297,
    ];
    let to = [
        0.07150494541677696,
        -0.037822765326841506,
        2.9319870656084577,
    ];
    let at = |[x, y, theta]: [f64; 3]| Coordinates::Planar(Configuration::new(x, y, theta));
    for clearance in [Clearance::Widest, Clearance::Half] {
        let wishes = Wishes {
            clearance,
            ..Wishes::default()
        };
        let answer = planner.plan(at(from), at(to), &wishes).unwrap();
        let Verdict::Path(path) = answer.verdict else {
            panic!("{answer:?}");
        };
        // It is narrowest at its start.
        let most = planner.scene().clearance(from);
        let found = path.narrowest.clearance;
        match clearance {
            Clearance::Widest => {
                let bottleneck = answer.bottleneck.unwrap();
                assert!((found - most).abs() < 1e-5 * most, "{found} of {most}");
                assert!(
                    (bottleneck.most.unwrap() - most).abs() < 1e-9,
                    "{bottleneck:?}"
                );
            }
            _ => assert!(found >= 0.499 * most, "{found} of {most}"),
        }
    }
}
