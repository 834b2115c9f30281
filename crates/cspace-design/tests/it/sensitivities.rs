//! Derivatives of quantities by parameters, against differences of quantities.

use std::path::Path;

use cspace::Silent;
use cspace_design::{Checked, Sensitivity, Value, check, sensitivities};
use cspace_model::model::{Setting, Template};
use cspace_model::{Host, Model};

use crate::common::template;

fn set(values: &[(&str, f64)]) -> Vec<Setting> {
    let of = |&(name, value): &(&str, f64)| Setting::number(name, value);
    values.iter().map(of).collect()
}

fn number(checked: &Checked) -> Option<f64> {
    match checked.measured.as_ref().ok()?.value {
        Value::Number(x) => Some(x),
        Value::Truth(_) => None,
    }
}

struct Design {
    template: Template,
    model: Model,
    found: Vec<(Checked, Vec<Sensitivity>)>,
}

fn design(template: Template, values: &[(&str, f64)]) -> Design {
    let given = set(values);
    let host = Host {
        set: &given,
        ..Host::default()
    };
    let model = template.model(&host).unwrap();
    let found = sensitivities(&template, &host, &model, &Silent).unwrap();
    Design {
        template,
        model,
        found,
    }
}

fn text(text: &str, values: &[(&str, f64)]) -> Design {
    design(template(text), values)
}

impl Design {
    /// All quantities with a parameter changed by a step.
    fn changed(&self, values: &[(&str, f64)], name: &str, step: f64) -> Vec<Checked> {
        let value = self
            .model
            .parameters
            .iter()
            .find(|p| p.name == name)
            .unwrap()
            .value;
        let mut given = set(values);
        given.extend(set(&[(name, value + step)]));
        let host = Host {
            set: &given,
            ..Host::default()
        };
        check(&self.template.model(&host).unwrap())
    }

    /// Compares all derivatives with one-sided differences of second order; returns how many there are that are not 0, and how many that
    /// differ on both sides.
    fn agrees(&self, values: &[(&str, f64)]) -> (usize, usize) {
        let (mut some, mut kinks) = (0, 0);
        for p in self
            .model
            .parameters
            .iter()
            .filter(|p| p.expression.is_none())
        {
            let counts = |s: &Sensitivity| {
                s.parameter == p.name && s.derivative.as_ref().is_err_and(|e| e.contains("a count"))
            };
            if self.found.iter().any(|(_, all)| all.iter().any(counts)) {
                continue;
            }
            let h = 1e-4 * p.value.abs().max(0.1);
            let side = |sign: f64| [1.0, 2.0].map(|n| self.changed(values, &p.name, sign * n * h));
            let sides = [side(-1.0), side(1.0)];
            for (i, (checked, all)) in self.found.iter().enumerate() {
                let Some(here) = number(checked) else {
                    continue;
                };
                let of = all.iter().find(|s| s.parameter == p.name).unwrap();
                let derivative = *of.derivative.as_ref().unwrap();
                for ((sign, [one, two]), found) in
                    [-1.0, 1.0].into_iter().zip(&sides).zip(derivative)
                {
                    let (one, two) = (number(&one[i]).unwrap(), number(&two[i]).unwrap());
                    let expected = sign * (4.0 * one - two - 3.0 * here) / (2.0 * h);
                    let near = 1e-6 * expected.abs().max(1.0);
                    assert!(
                        (found - expected).abs() < near,
                        "{} by {}: {found} {expected}",
                        checked.requirement.name,
                        p.name
                    );
                }
                some += usize::from(derivative != [0.0; 2]);
                kinks += usize::from(derivative[0] != derivative[1]);
            }
        }
        (some, kinks)
    }
}

/// Derivatives of every construction of an outline, an axis, a range and a configuration by a parameter.
#[test]
fn derivatives_are_those_of_differences() {
    let wheel = r#"
[parameter]
rim = 20.0
depth = 3.0
round = 0.4
bow = 15.0
tip = 1.5
away = 27.0
start = 0.03
slope = 0.2
from = -0.3

[[part]]
name = "wheel"
motion = { type = "revolute", center = ["0.01*away", 0.1] }
loops = [[{ repeat = 10, about = [0, 0], path = [
    ["rim", 0], { fillet = "round" },
    { arc_to = ["(rim - depth)*cos(10deg)", "(rim - depth)*sin(10deg)"], radius = "bow" }, { fillet = "round/2" },
    { arc_to = ["rim*cos(20deg)", "rim*sin(20deg)"], through = ["(rim + 0.1)*cos(16deg)", "(rim - 0.4)*sin(16deg)"] },
] }]]

[[part]]
name = "pawl"
motion = { type = "prismatic", direction = [-1, "slope"], range = ["-30 + from", "20 + 2*from"] }
loops = [[["away", "-tip"], ["away + 12", "-tip"], { fillet = "tip/3" }, ["away + 12", "tip"], { arc_to = ["away", "tip"], center = ["away + 6", "tip + 3*from"], direction = "ccw" }]]

[[requirement]]
name = "reach"
measure = "position"
at = { u = "start", v = "from" }
along = [0.01, "60 + from"]
of = "v"

[[requirement]]
name = "turned"
measure = "position"
at = { u = "start", v = "from" }
along = [0.01, "60 + from"]
of = "u"

[[requirement]]
name = "slack"
measure = "play"
of = "v"
at = { u = "start", v = "from" }

[[requirement]]
name = "gap"
measure = "clearance"
at = { u = "2*start", v = "from" }
"#;
    let (some, _) = text(wheel, &[]).agrees(&[]);
    assert!(some >= 25, "{some}");
}

/// A peg in a slot: both corners of a side touch at once.
#[test]
fn at_a_change_of_contacts_derivatives_differ_on_both_sides() {
    let peg = r#"
[parameter]
slot = 10.1
lean = 0.0
deep = -15.0

[[part]]
name = "slot"
loops = [[{ mirror = "y", path = [[0, -35], [30, -35], [30, 0], ["slot/2", 0], ["slot/2", -30]] }]]

[[part]]
name = "peg"
loops = [[[-5, -9], [5, -9], ["5 + lean", 9], [-5, 9]]]

[[requirement]]
name = "sideways"
measure = "play"
of = "x"
at = { y = "deep" }

[[requirement]]
name = "tilt"
measure = "play"
of = "theta"
at = { y = "deep" }

[[requirement]]
name = "depth"
measure = "position"
at = { y = 20 }
along = [0, "3*deep", 0]
"#;
    let design = text(peg, &[]);
    let (some, kinks) = design.agrees(&[]);
    assert!(some >= 4 && kinks >= 1, "{some} {kinks}");
    let sideways = &design.found[0].1;
    let lean = sideways.iter().find(|s| s.parameter == "lean").unwrap();
    // A side that leans outwards takes play, one that leans inwards gives none.
    let [below, above] = *lean.derivative.as_ref().unwrap();
    assert!(
        below.abs() < 1e-12 && (above + 1.0).abs() < 1e-12,
        "{lean:?}"
    );
}

/// The models that are shipped.
#[test]
fn shipped_models_have_the_derivatives_of_differences() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mut parametric = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let template = Template::read(&path, &Host::default()).unwrap();
        let model = template.model(&Host::default()).unwrap();
        if !model.requirements.is_empty() {
            let (some, _) = design(template, &[]).agrees(&[]);
            assert!(some > 0, "{}", path.display());
            parametric += 1;
        }
    }
    assert!(parametric > 0);
}

/// The tip of a pin on the apex of a roof slides down on either side: which contact decides depends on the direction.
#[test]
fn between_two_corners_there_is_no_derivative() {
    let roof = r#"
[parameter]
p = 0.0

[[part]]
name = "roof"
loops = [[[-10, -20], [10, -20], ["p", -10]]]

[[part]]
name = "pin"
loops = [[[0, 0], [1, 5], [-1, 5]]]

[[requirement]]
name = "drop"
measure = "position"
along = [0, -30, 0]
"#;
    let of = |p: f64| text(roof, &[("p", p)]).found[0].1[0].derivative.clone();
    assert!(of(0.0).unwrap_err().contains("two corners"));
    // Beside the apex the tip is on a side, through (±10, -20): y = -20 + 10 (10 - |x|) / (10 - |p|).
    let [below, above] = of(1.0).unwrap();
    assert!(
        (below - above).abs() < 1e-12 && (above + 10.0 * 10.0 / 121.0).abs() < 1e-9,
        "{above}"
    );
}
