//! `cspace escape`: energies known by hand, cages, and what cannot be asked.

use std::fs;

use tempfile::TempDir;

use crate::helpers::{cspace, fails, json, model, printed};

const PEGS: &str = r#"
name = "disc on two pegs"
unit = "mm"
gravity = [0, -9810]

[[part]]
name = "pegs"
motion = { type = "fixed" }
loops = [{ circle = 10, at = [-15, 0] }, { circle = 10, at = [15, 0] }]

[[part]]
name = "disc"
loops = [{ circle = 30, at = [0, 0] }]
mass = 0.02
"#;

fn written(folder: &TempDir, text: &str) -> String {
    let path = folder.path().join("model.toml");
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// The disc at rest on both pegs.
const REST: f64 = 37.08099243547832;

#[test]
fn a_disc_leaves_two_pegs_over_one_of_them() {
    let folder = TempDir::new().unwrap();
    let file = &written(&folder, PEGS);
    let from = format!("0,{REST},0");
    let known = 0.02 * 9810.0 * (40.0 - REST);
    let answer = json(&["escape", file, "--from", &from]);
    let number = |key: &str| answer[key].as_f64().unwrap();
    assert_eq!(answer["verdict"], "escapes");
    assert!((number("energy") - known).abs() < 1e-9 * known, "{answer}");
    assert!(number("least") <= known && known <= number("most"));
    assert_eq!(answer["unit_mass"], false);
    assert_eq!(answer["passes"][0]["touching"].as_array().unwrap().len(), 1);
    // Threads change nothing, and half the gravity is half the energy.
    let one = json(&["escape", file, "--from", &from, "--threads", "1"]);
    assert_eq!(one["path"], answer["path"]);
    let half = json(&["escape", file, "--from", &from, "--gravity", "0,-4905"]);
    assert!((half["energy"].as_f64().unwrap() - 0.5 * known).abs() < 1e-9 * known);
    // On the other side it goes down.
    let over = json(&["escape", file, "--from", &from, "--to=60,0,0"]);
    assert!((over["energy"].as_f64().unwrap() - known).abs() < 1e-9 * known);
    assert!(printed(&["escape", file, "--from", &from]).starts_with("escapes with 572.709284"));
}

#[test]
fn a_ball_in_a_c_is_caged() {
    let ball = model("ball_in_c");
    let answer = json(&["escape", &ball, "--from", "0,0,0", "--gravity", "0,-1"]);
    assert_eq!(answer["verdict"], "cage");
    assert!(answer["energy"].is_null());
    assert_eq!(answer["unit_mass"], true);
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let folder = TempDir::new().unwrap();
    let file = &written(&folder, PEGS);
    let ball = model("ball_in_c");
    let run = |args: &[&str]| cspace(&[&["escape"], args].concat());
    fails(
        run(&[&ball, "--from", "0,0,0"]),
        2,
        &["no force", "--gravity"],
    );
    fails(run(&[file, "--from", "0,0"]), 2, &["--from"]);
    fails(
        run(&[file, "--from", "0,50,0", "--gravity", "1"]),
        2,
        &["two numbers"],
    );
    fails(
        run(&[file, "--from", "0,50,0", "--within", "0"]),
        2,
        &["positive energy"],
    );
    let geneva = model("geneva");
    fails(
        run(&[&geneva, "--from", "0,0", "--gravity", "0,-1"]),
        2,
        &["--to"],
    );
    let blocked = json(&["escape", file, "--from", "15,0,0"]);
    assert_eq!(blocked["verdict"], "from-blocked");
    let torque = format!("{PEGS}\n[[load]]\npart = \"disc\"\ntorque = 1\n");
    let file = &written(&folder, &torque);
    fails(run(&[file, "--from", "0,50,0"]), 2, &["disc", "turns"]);
}
