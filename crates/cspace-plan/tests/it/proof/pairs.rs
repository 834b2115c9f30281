//! Proofs of pairs of all kinds pass the checker, which knows nothing of how they were made.

use core::f64::consts::{FRAC_PI_2, SQRT_2, TAU};

use cspace::{Configuration, ContactSpace, Options, Part, Silent, Vertex};
use cspace_check::Proof;
use cspace_plan::proof::{ProofError, prove};

fn at(x: f64, y: f64, theta: f64) -> Configuration {
    Configuration::new(x, y, theta)
}

fn outline(corners: &[(f64, f64)]) -> Vec<Vertex> {
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

fn square(half: f64) -> Vec<Vertex> {
    outline(&[(-half, -half), (half, -half), (half, half), (-half, half)])
}

fn asked(
    (fixed, moving): (&Part, &Part),
    window: Option<(f64, f64)>,
    [from, to]: [Configuration; 2],
    depth: Option<f64>,
) -> Result<Proof, ProofError> {
    let options = Options {
        window,
        ..Options::default()
    };
    let space = ContactSpace::compute(fixed, moving, &options).unwrap();
    let begin = std::time::Instant::now();
    let proof = prove(&space, from, to, depth, &Silent);
    if let Ok(p) = &proof {
        println!(
            "{} in {}: depth {:.5}, {} triangles, {} witnesses, {:.3} s, {} bytes",
            moving.name(),
            fixed.name(),
            p.depth,
            p.triangles.len(),
            p.witnesses.len(),
            begin.elapsed().as_secs_f64(),
            serde_json::to_vec(p).unwrap().len()
        );
    }
    proof
}

/// The corridor of a rod: one wide, around a corner, closed at its ends.
fn corridor() -> Part {
    let frame = outline(&[(-9.0, -9.0), (3.0, -9.0), (3.0, 3.0), (-9.0, 3.0)]);
    let inside = outline(&[
        (-8.0, 0.0),
        (0.0, 0.0),
        (0.0, -8.0),
        (1.0, -8.0),
        (1.0, 1.0),
        (-8.0, 1.0),
    ]);
    Part::new("corridor", vec![frame, inside]).unwrap()
}

#[test]
fn a_block_kept_in_a_box() {
    let frame = Part::new("box", vec![square(4.0), square(2.0)]).unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 1.0).unwrap();
    let ends = [at(0.0, 0.0, 0.0), at(9.0, 0.0, 1.0)];
    for depth in [None, Some(0.1), Some(0.02)] {
        let proof = asked((&frame, &block), None, ends, depth).unwrap();
        assert_eq!(proof.check(), Ok(()));
        assert!(depth.is_none_or(|d| proof.depth == d));
    }
    // From outside to inside as well.
    asked((&frame, &block), None, [ends[1], ends[0]], None).unwrap();
}

#[test]
fn a_part_drawn_far_from_its_origin() {
    let frame = Part::new("box", vec![square(4.0), square(2.0)]).unwrap();
    let block = Part::rectangle("block", (50.0, -30.0), 2.0, 1.0).unwrap();
    let ends = [at(-50.0, 30.0, 0.0), at(9.0, 0.0, 0.0)];
    asked((&frame, &block), None, ends, None).unwrap();
}

#[test]
fn a_rod_too_long_for_a_corner() {
    let ends = [at(-5.0, 0.5, 0.0), at(0.5, -5.0, -FRAC_PI_2)];
    for longer in [1.2, 1.05] {
        let length = 2.0 * (SQRT_2 - 0.2) * longer;
        let rod = Part::rectangle("rod", (0.0, 0.0), length, 0.2).unwrap();
        asked((&corridor(), &rod), None, ends, None).unwrap();
    }
}

#[test]
fn a_window_is_open_at_its_ends() {
    // A block that would leave by turning may not turn so far: through an opening 3 wide it goes lengthwise alone.
    let fixed = Part::polygon(
        "box",
        &[
            (-5.0, -5.0),
            (5.0, -5.0),
            (5.0, -1.5),
            (4.0, -1.5),
            (4.0, -4.0),
            (-4.0, -4.0),
            (-4.0, 4.0),
            (4.0, 4.0),
            (4.0, 1.5),
            (5.0, 1.5),
            (5.0, 5.0),
            (-5.0, 5.0),
        ],
    )
    .unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 4.0, 2.0).unwrap();
    let ends = [at(0.0, 0.0, 1.5), at(12.0, 0.0, 1.5 + TAU)];
    let proof = asked((&fixed, &block), Some((1.0, 2.0)), ends, None).unwrap();
    assert_eq!(proof.window, Some([1.0, 2.0]));
}

#[test]
fn a_ball_in_a_c() {
    let model = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/ball_in_c.toml");
    let model = cspace_model::model::read(model).unwrap();
    let part = |i: usize| &model.parts[i].part;
    let ends = [at(0.0, 0.0, 0.0), at(60.0, 0.0, 0.0)];
    for depth in [None, Some(0.2)] {
        asked((part(0), part(1)), None, ends, depth).unwrap();
    }
}

#[test]
fn a_hook_in_its_catch() {
    let model = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../models/snap_fastener.toml"
    );
    let model = cspace_model::model::read(model).unwrap();
    let part = |i: usize| &model.parts[i].part;
    let ends = [at(0.0, 0.05, 0.0), at(0.0, 60.0, 0.0)];
    asked((part(0), part(1)), None, ends, None).unwrap();
}

#[test]
fn what_is_not_enclosed_has_no_proof() {
    let frame = Part::rectangle("post", (0.0, 0.0), 1.0, 1.0).unwrap();
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 1.0).unwrap();
    let ends = [at(-5.0, 0.0, 0.0), at(9.0, 0.0, 0.0)];
    let none = asked((&frame, &block), None, ends, None);
    assert!(
        matches!(none, Err(ProofError::TooShallow { .. })),
        "{none:?}"
    );
    let none = asked((&frame, &block), None, ends, Some(-1.0));
    assert_eq!(none, Err(ProofError::Depth(-1.0)));
    // Too fine to be resolved, which is another reason.
    let none = asked((&frame, &block), None, ends, Some(1e-300)).unwrap_err();
    let told = none.to_string();
    assert!(matches!(none, ProofError::TooFine { .. }), "{told}");
    assert!(told.contains("1e-300") && told.len() < 200, "{told}");
}
