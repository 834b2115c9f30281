//! A proof that is not one is refused, whatever is wrong with it.

use cspace::{Configuration, ContactSpace, Options, Part, Silent, Vertex};
use cspace_check::Proof;
use cspace_plan::proof::prove;

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
pub(crate) fn python(proof: &Proof, name: &str) -> Option<String> {
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

/// A triangle bends by |q| Δθ²/8 and not by less: a witness that overlaps at the corners, but not by all of that, is none.
#[test]
fn a_witness_overlaps_by_the_bend_of_its_triangle() {
    let p = proof();
    // The bend, and the radius of the moving disc without which the discs do not meet at a corner.
    let of = |t: &[i64; 7]| {
        let [qx, qy, _, cx, cy, s] = p.witnesses[t[6] as usize];
        let [qx, qy] = [qx - p.pivot[0], qy - p.pivot[1]];
        let (mut far, mut lo, mut hi) = (0.0_f64, f64::INFINITY, f64::NEG_INFINITY);
        for k in 0..3 {
            let [x, y, theta] = p.vertices[t[k] as usize];
            let (sin, cos) = theta.sin_cos();
            far = far.max((x + cos * qx - sin * qy - cx).hypot(y + sin * qx + cos * qy - cy));
            let theta = theta + core::f64::consts::TAU * t[k + 3] as f64;
            (lo, hi) = (lo.min(theta), hi.max(theta));
        }
        (qx.hypot(qy) * (hi - lo).powi(2) / 8.0, far - s)
    };
    let all = p.triangles.iter().map(of).enumerate();
    let (i, (bend, least)) = all
        .filter(|(_, (bend, least))| least + 0.9 * bend > 0.0)
        .max_by(|a, b| a.1.0.total_cmp(&b.1.0))
        .unwrap();
    assert!(bend > 1e-6, "{bend}");
    for (share, is_enough) in [(0.9, false), (1.0001, true)] {
        let mut changed = p.clone();
        let mut witness = p.witnesses[p.triangles[i][6] as usize];
        witness[2] = least + share * bend;
        changed.triangles[i][6] = changed.witnesses.len() as i64;
        changed.witnesses.push(witness);
        assert_eq!(
            changed.check().is_ok(),
            is_enough,
            "{share} {:?}",
            changed.check()
        );
    }
}

/// With a window the surface is open at its ends, not beside them.
#[test]
fn a_hole_at_the_end_of_a_window_is_a_hole() {
    let frame = Part::new("box", vec![square(4.0), square(2.0)]).unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 1.0).unwrap();
    let window = Some((0.0, 1.0));
    let options = Options {
        window,
        ..Options::default()
    };
    let space = ContactSpace::compute(&frame, &block, &options).unwrap();
    let at = |x: f64| Configuration::new(x, 0.0, 0.5);
    let whole = prove(&space, at(0.0), at(9.0), None, &Silent).unwrap();
    let lo = whole.window.unwrap()[0];
    // A triangle with one side in the end: its other two sides are then open.
    let is_there = |t: &[i64; 7]| {
        let ends = t[..3]
            .iter()
            .filter(|&&v| whole.vertices[v as usize][2] <= lo);
        ends.count() == 2
    };
    let hole = whole.triangles.iter().position(is_there).unwrap();
    let mut torn = whole.clone();
    torn.triangles.remove(hole);
    assert!(torn.check().unwrap_err().contains("is open"));
}
