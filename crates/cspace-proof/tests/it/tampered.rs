//! A proof that is not one is refused, whatever is wrong with it.

use cspace::{Configuration, ContactSpace, Options, Part, Silent, Vertex};
use cspace_check::Proof;
use cspace_proof::prove;

fn square(half: f64) -> Vec<Vertex> {
    [(-half, -half), (half, -half), (half, half), (-half, half)]
        .map(|(x, y)| Vertex::line(x, y))
        .to_vec()
}

/// A block kept in a box.
fn proof() -> Proof {
    let frame = Part::new("box", vec![square(4.0), square(2.0)]).unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 1.0).unwrap();
    let space = ContactSpace::compute(&frame, &block, &Options::default()).unwrap();
    let (from, to) = (
        Configuration::new(0.0, 0.0, 0.0),
        Configuration::new(9.0, 0.0, 1.0),
    );
    prove(&space, from, to, None, &Silent).unwrap()
}

/// Error of the checker for a proof that was changed.
#[track_caller]
fn refused(word: &str, change: impl FnOnce(&mut Proof)) {
    let mut changed = proof();
    assert_eq!(changed.check(), Ok(()));
    change(&mut changed);
    let error = changed.check().unwrap_err();
    assert!(error.contains(word), "{error}");
}

#[test]
fn surfaces_with_holes() {
    refused("open", |p| {
        p.triangles.pop();
    });
    refused("open", |p| p.triangles[7].swap(0, 1));
    refused("open", |p| {
        // A copy of a vertex is another vertex.
        let v = p.triangles[5][0] as usize;
        let copy = p.vertices[v];
        p.vertices.push(copy);
        p.triangles[5][0] = p.vertices.len() as i64 - 1;
    });
    refused("turns", |p| p.triangles[3][4] += 1);
}

#[test]
fn witnesses_that_are_none() {
    refused("within block", |p| p.witnesses[0][2] *= 2.0);
    refused("within box", |p| p.witnesses[0][5] *= 2.0);
    refused("within box", |p| p.witnesses[0][3] += 20.0);
    refused("within", |p| p.witnesses[0][2] = 0.0);
    refused("within", |p| p.witnesses[0][5] *= -1.0);
    refused("overlap", |p| p.witnesses[0][2] = f64::MIN_POSITIVE);
    refused("overlap", |p| p.witnesses[0][2] *= 0.01);
    refused("overlap", |p| {
        let far = p.triangles.len() / 2;
        p.triangles[0][6] = p.triangles[far][6];
    });
    refused("triangle", |p| p.triangles[0][6] = 1_000_000);
    refused("triangle", |p| p.triangles[0][0] = -1);
}

#[test]
fn surfaces_that_do_not_come_between() {
    refused("winds", |p| p.goal = [0.1, 0.0, 0.1]);
    refused("winds", |p| p.start = [-9.0, 0.0, 0.0]);
    refused("winds", |p| p.triangles.clear());
}

#[test]
fn surfaces_elsewhere_and_parts_of_other_shapes() {
    refused("overlap", |p| p.vertices[0][0] += 1.0);
    // An opening in the box: its material is not where discs are.
    refused("within box", |p| {
        p.fixed.loops[1][1] = [4.5, -2.0, 0.0];
        p.fixed.loops[1][2] = [4.5, 2.0, 0.0];
    });
    refused("within block", |p| p.moving.loops[0][0] = [0.4, 0.2, 0.0]);
    refused("finite", |p| p.vertices[0][2] = f64::NAN);
    refused("version", |p| p.version = 2);
}

/// Output of the program in Python for a proof; `None` where Python is not installed.
fn python(proof: &Proof, name: &str) -> Option<String> {
    let path = std::env::temp_dir().join(format!("cspace-{name}-{}.json", std::process::id()));
    std::fs::write(&path, serde_json::to_vec(proof).unwrap()).unwrap();
    let script = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../cspace-check/examples/check.py"
    );
    let output = std::process::Command::new("python3")
        .args([std::path::Path::new(script), &path])
        .output();
    std::fs::remove_file(&path).unwrap();
    let output = output.ok()?;
    let all = [output.stdout, output.stderr].concat();
    Some(String::from_utf8(all).unwrap())
}

#[test]
fn both_checkers_count_windows_and_turns_alike() {
    let frame = Part::new("box", vec![square(4.0), square(2.0)]).unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 1.0).unwrap();
    let options = Options {
        window: Some((0.0, 1.0)),
        ..Options::default()
    };
    let space = ContactSpace::compute(&frame, &block, &options).unwrap();
    let at = |x: f64, theta: f64| Configuration::new(x, 0.0, theta);
    let within = prove(&space, at(0.0, 0.5), at(9.0, 0.5), None, &Silent).unwrap();
    let mut outside = within.clone();
    outside.start[2] = 5.05;
    let error = outside.check().unwrap_err();
    assert_eq!(error, "the start is not in the window");
    // A copy by whole turns is the same configuration, however many: in a window and without.
    let mut turned = within.clone();
    turned.start[2] += 1000.0 * core::f64::consts::TAU;
    assert_eq!(turned.check(), Ok(()));
    let mut far = proof();
    far.start[2] = 1e4;
    assert_eq!(far.check(), Ok(()));
    let begin = std::time::Instant::now();
    let cases = [
        (within, "proved"),
        (outside, "the start is not in the window"),
        (turned, "proved"),
        (far, "proved"),
    ];
    for (i, (proof, word)) in cases.iter().enumerate() {
        if let Some(said) = python(proof, &format!("turns-{i}")) {
            assert!(said.contains(word), "{said}");
        }
    }
    // Far from minutes, which it takes with rays that are not certain.
    assert!(begin.elapsed().as_secs() < 60);
}

#[test]
fn a_file_is_read_back_as_the_same_numbers() {
    let proof = proof();
    let json = serde_json::to_vec(&proof).unwrap();
    assert_eq!(cspace_check::read(&json).unwrap(), proof);
    let answer = serde_json::json!({ "verdict": "no-path", "proof": proof });
    let json = serde_json::to_vec(&answer).unwrap();
    assert_eq!(cspace_check::read(&json).unwrap(), proof);
    assert!(cspace_check::read(b"{}").is_err());
    assert!(cspace_check::read(b"[1, 2").is_err());
}
