//! Forces, masses and rates that no part has: an answer or a reason, soon.

use std::time::{Duration, Instant};

use cspace_motion::{Settings, Simulation, Status};
use cspace_oracle::effort;

use crate::motion::helpers::{judge, thrown};

/// A motion that cannot be followed is given up within this, whatever else the machine does.
const SOON: Duration = Duration::from_secs(20);

/// A wheel that turns, and a block that is free to move.
fn scene(whole: &str, block: &str, drive: &str, rest: &str) -> String {
    format!(
        "{whole}\n[[part]]\nname = \"wheel\"\nmotion = {{ type = \"revolute\", center = [0, 0] }}\nloops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]\n[[part]]\nname = \"block\"\nloops = [ [[5, -1], [7, -1], [7, 1], [5, 1]] ]\n{block}\n[[drive]]\npart = \"wheel\"\n{drive}\n{rest}"
    )
}

#[test]
fn what_cannot_be_followed_is_given_up() {
    let mut all = Vec::new();
    for number in ["1e12", "1e30", "1e100", "1e300"] {
        all.push(scene(
            &format!("gravity = [0, {number}]"),
            "mass = 1",
            "rate = 1",
            "",
        ));
        all.push(scene(
            &format!("gravity = [-{number}, 0]"),
            "mass = 1",
            "rate = 1",
            "",
        ));
        for sign in ["-", ""] {
            all.push(scene(
                "",
                &format!("mass = 1\nrate = [{sign}{number}, 0, 0]"),
                "rate = 1",
                "",
            ));
        }
        all.push(scene("", "mass = 1", &format!("rate = {number}"), ""));
        let spring = |kind: &str| {
            format!(
                "[[spring]]\nparts = [\"block\"]\nat = [[6, 0], [9, 0]]\nlength = 1\n{kind} = {number}\n"
            )
        };
        all.push(scene("", "mass = 1", "rate = 1", &spring("stiffness")));
        all.push(scene(
            "",
            "mass = 1\nrate = [1, 0, 0]",
            "rate = 1",
            &spring("stiffness = 1\ndamping"),
        ));
        let load = format!("[[load]]\npart = \"block\"\nforce = [-{number}, 0]\n");
        all.push(scene("", "mass = 1", "rate = 1", &load));
        all.push(scene(
            "friction = 0.3\nrestitution = 1",
            "mass = 1",
            "rate = 1",
            &load,
        ));
        all.push(scene(
            &format!("friction = {number}"),
            "mass = 1\nrate = [-3, 0, 0]",
            "rate = 1",
            "",
        ));
    }
    let load = "[[load]]\npart = \"block\"\nforce = [-1, 0]\n";
    for number in ["1e-12", "1e-30", "1e-300", "1e-320", "1e12", "1e300"] {
        all.push(scene("", &format!("mass = {number}"), "rate = 1", load));
        all.push(scene(
            "",
            &format!("mass = 1\ninertia = {number}"),
            "rate = 1",
            load,
        ));
    }
    all.push(scene(
        "",
        "mass = 1",
        "table = [[0, 0], [1, 0], [1.000000001, 1]]",
        "",
    ));
    all.push(scene(
        "",
        "mass = 1\nrate = [-3, 0, 0]",
        "table = [[0, 0], [1e-9, 1e6]]",
        "",
    ));
    for text in all.iter().step_by(effort(9, 1)) {
        let begun = Instant::now();
        let Ok(mechanism) = cspace_model::model::from_toml(text, "m.toml") else {
            continue;
        };
        let Ok(simulation) = Simulation::new(&mechanism) else {
            continue;
        };
        let settings = Settings {
            time: 2.0,
            every: None,
        };
        let record = simulation.dynamic(&settings).unwrap();
        let took = begun.elapsed();
        assert!(took < SOON, "{took:?}: {text}");
        assert!(
            record.status == Status::Done || record.reason.is_some(),
            "{text}"
        );
        let finite = |c: &[f64]| c.iter().all(|c| c.is_finite());
        assert!(
            record.samples.iter().all(|s| finite(&s.coordinates)),
            "{:?}: {text}",
            record.status
        );
    }
}

/// A disc that is larger than a gap by any amount stays on its side of it, whatever pushes.
#[test]
fn what_is_too_large_never_passes() {
    for larger in [1e-9, 1e-7, 1e-5, 1e-3] {
        for force in [1.0, 1e4, 1e8] {
            for friction in [0.0, 0.3] {
                let r = 1.0 + larger;
                let text = format!(
                    "friction = {friction}\n[[part]]\nname = \"wall\"\nmotion = {{ type = \"fixed\" }}\nloops = [ [[-0.5, 1], [0.5, 1], [0.5, 6], [-0.5, 6]], [[-0.5, -6], [0.5, -6], [0.5, -1], [-0.5, -1]] ]\n[[part]]\nname = \"disc\"\nloops = [ [[-{r}, 0, 1], [{r}, 0, 1]] ]\nstart = [-3, 0.01, 0]\nmass = 1\ninertia = 0.5\n[[load]]\npart = \"disc\"\nforce = [{force}, 0]\n"
                );
                let time = 20.0 / f64::sqrt(force);
                let (simulation, record) = thrown(&text, time, time / 300.0);
                let what = format!(
                    "{larger} {force} {friction}: {:?} {:?}",
                    record.status, record.reason
                );
                judge(&simulation, &record);
                for sample in &record.samples {
                    assert!(sample.coordinates[0] < 0.0, "{what} at {}", sample.t);
                }
                // Wedged between two corners it may not be told how it goes on; then the reason names both.
                let told = record.reason.as_ref().is_some_and(|r| r.contains("wall"));
                assert!(record.status == Status::Done || told, "{what}");
            }
        }
    }
}
