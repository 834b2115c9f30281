//! Motions that are taken up where others have come to.

use cspace::Silent;
use cspace_motion::{Sample, Settings, SimulateError, Simulation, Status};

use crate::motion::helpers::{judge, model, near};

/// A sleeve wedged on its pole is at the last orientation at which it fits, or beyond it by rounding. A simulation can
/// be restarted from there, and goes on as if there had been no end; if the sleeve is turned farther it overlaps.
#[test]
fn a_wedged_part_is_taken_up() {
    let settings = Settings {
        time: 0.04,
        every: Some(0.04),
    };
    let fresh = Simulation::new(&model("woodpecker")).unwrap();
    let whole = fresh.follow_with(&settings, &Silent).unwrap();
    assert_eq!(whole.status, Status::Done);
    // While it is wedged the sleeve does not turn.
    let wedged = whole.trace.windows(2).filter(|w| {
        let turn = |s: &Sample| s.coordinates[2];
        (turn(&w[0]) - turn(&w[1])).abs() < 1e-12
    });
    assert!(wedged.count() > 50, "there is something to be seen");
    let mut simulation = fresh;
    for state in &whole.trace {
        simulation = (simulation.taken_up(state)).unwrap_or_else(|e| panic!("{}: {e}", state.t));
    }
    for state in whole.trace.iter().step_by(41).filter(|s| s.t < 0.039) {
        simulation = simulation.taken_up(state).unwrap();
        let rest = simulation.follow_with(&settings, &Silent).unwrap();
        assert_eq!(rest.status, Status::Done, "{}: {:?}", state.t, rest.reason);
        judge(&simulation, &rest);
        let [a, b] = [&whole, &rest].map(|r| r.last().unwrap());
        for (a, b) in a.coordinates.iter().zip(&b.coordinates) {
            near(&format!("from {} s", state.t), *a, *b, 1e-6);
        }
    }
    let mut turned = whole.trace[0].clone();
    turned.coordinates[2] -= 2e-3;
    let error = simulation.taken_up(&turned).unwrap_err();
    assert!(matches!(error, SimulateError::Overlap { .. }), "{error}");
}
