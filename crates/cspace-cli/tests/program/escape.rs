//! `cspace plan --energy`: energies known by hand, cages, and what cannot be asked.

use std::fs;

use tempfile::TempDir;

use crate::helpers::{cspace, fails, framed, json, model, printed, unframed};

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
    let asked = ["plan", "--energy", file, "--from", &from];
    let answer = json(&asked);
    assert_eq!(answer["outcome"], "escapes");
    let number = |key: &str| answer[key].as_f64().unwrap();
    assert_eq!(answer["verdict"], "escapes");
    assert!((number("energy") - known).abs() < 1e-9 * known, "{answer}");
    assert!(number("least") <= known && known <= number("most"));
    assert_eq!(answer["unit_mass"], false);
    assert_eq!(answer["passes"][0]["touching"].as_array().unwrap().len(), 1);
    // Threads change nothing, and half the gravity is half the energy.
    let one = json(&[&asked[..], &["--threads", "1"]].concat());
    assert_eq!(one["path"], answer["path"]);
    let half = json(&[&asked[..], &["--gravity", "0,-4905"]].concat());
    assert!((half["energy"].as_f64().unwrap() - 0.5 * known).abs() < 1e-9 * known);
    // On the other side it goes down.
    let over = json(&[&asked[..], &["--to=60,0,0"]].concat());
    assert!((over["energy"].as_f64().unwrap() - known).abs() < 1e-9 * known);
    assert!(printed(&asked).starts_with("escapes with 572.7093 µJ\n"));
    cspace(&asked).assert().code(0);
    // Nearer bounds enclose it, too.
    let near = json(&[&asked[..], &["--accuracy", "1"]].concat());
    let [least, most] = ["least", "most"].map(|key| near[key].as_f64().unwrap());
    assert!(
        least <= known && known <= most && most - least <= 1.0,
        "{near}"
    );
    // The file has what is printed, but for the time.
    let out = folder.path().join("out.json");
    let told = framed(&[&asked[..], &["-o", out.to_str().unwrap()]].concat());
    let written: serde_json::Value = serde_json::from_slice(&fs::read(out).unwrap()).unwrap();
    assert_eq!(told, written);
    let written = unframed("plan", written);
    assert_eq!(written["path"], answer["path"]);
}

#[test]
fn a_ball_in_a_c_is_caged() {
    let ball = model("ball_in_c");
    let asked = [
        "plan",
        &ball,
        "--energy",
        "--from",
        "0,0,0",
        "--gravity",
        "0,-1",
    ];
    cspace(&asked).assert().code(1);
    assert_eq!(framed(&asked)["outcome"], "cage");
    let answer = json(&asked);
    assert_eq!(answer["verdict"], "cage");
    assert!(answer["energy"].is_null());
    assert_eq!(answer["unit_mass"], true);
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let folder = TempDir::new().unwrap();
    let file = &written(&folder, PEGS);
    let ball = model("ball_in_c");
    let run = |args: &[&str]| cspace(&[&["plan", "--energy"], args].concat());
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
        run(&[file, "--from", "0,50,0", "--accuracy", "0"]),
        2,
        &["positive energy"],
    );
    let geneva = model("geneva");
    fails(
        run(&[&geneva, "--from", "0,0", "--gravity", "0,-1"]),
        2,
        &["--to"],
    );
    let blocked = ["plan", "--energy", file, "--from", "15,0,0"];
    cspace(&blocked).assert().code(1);
    let blocked = json(&blocked);
    assert_eq!(blocked["verdict"], "from-blocked");
    assert_eq!(blocked["outcome"], "from-blocked");
    // What is about energies is so alone, and there is no picture of one.
    for option in ["--accuracy=1", "--gravity=0,-1"] {
        let plain = cspace(&["plan", file, "--from", "0,50,0", option]);
        fails(plain, 2, &["--energy"]);
    }
    for name in ["a.csv", "a.svg", "a.png", "a.pdf"] {
        let out = folder.path().join(name);
        let args = [file, "--from", "0,50,0", "-o", out.to_str().unwrap()];
        fails(run(&args), 2, &["--energy", ".json"]);
        assert!(!out.exists());
    }
    for more in [
        &["--widest"][..],
        &["--proof", "p.json"],
        &["--verify", "p.csv"],
    ] {
        let args = [&[file.as_str(), "--energy"], more].concat();
        fails(
            cspace(&[&["plan"], &args[..]].concat()),
            2,
            &["--energy", more[0]],
        );
    }
    let torque = format!("{PEGS}\n[[load]]\npart = \"disc\"\ntorque = 1\n");
    let file = &written(&folder, &torque);
    fails(run(&[file, "--from", "0,50,0"]), 2, &["disc", "turns"]);
}
