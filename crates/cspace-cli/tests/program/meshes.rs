//! Meshes open in the programs that people look at them with, where these are installed:
//! `pip install trimesh meshio pygltflib`. `CSPACE_OTHERS=require` makes it a failure that they are not, for `.ci/run`.

use std::process::Command;

use crate::helpers::{cspace, model};

/// Says why nothing is tested.
fn skip(why: &str) {
    let is_required = std::env::var("CSPACE_OTHERS").is_ok_and(|v| v == "require");
    assert!(!is_required, "meshes cannot be opened: {why}");
    println!("skipped: {why}");
}

#[test]
fn meshes_open_in_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let names = ["binary.ply", "ascii.ply", "m.obj", "m.stl", "m.glb"];
    let places = names.map(|n| folder.path().join(n).to_str().unwrap().to_owned());
    for out in &places {
        let model = model("ratchet_pawl");
        let mut args = vec!["export", &model, "-o", out, "--tolerance", "0.01"];
        if out.ends_with("ascii.ply") {
            args.push("--ascii");
        }
        cspace(&args).assert().success();
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/meshes.py");
    let Ok(output) = Command::new("python3").arg(script).args(&places).output() else {
        return skip("there is no python3");
    };
    let said = String::from_utf8_lossy(&output.stdout);
    match output.status.code() {
        Some(0) => assert_eq!(said.lines().count(), 9, "{said}"),
        Some(77) => skip(&said),
        _ => panic!("{said}{}", String::from_utf8_lossy(&output.stderr)),
    }
}
