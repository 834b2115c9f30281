//! Open chains whose missing piece is on another layer: it is named, and following the advice closes the chain.

use cspace_drawing::{Drawing, DrawingError, Format, Problem, Settings, Source, from_bytes};

/// A line with a handle on a layer.
fn line(handle: &str, layer: &str, [x0, y0, x1, y1]: [f64; 4]) -> String {
    format!("0\nLINE\n5\n{handle}\n8\n{layer}\n10\n{x0}\n20\n{y0}\n11\n{x1}\n21\n{y1}\n")
}

/// Three sides of a square on a layer.
fn three_sides(layer: &str) -> String {
    [
        ("A1", [10.0, 0.0, 0.0, 0.0]),
        ("A2", [0.0, 0.0, 0.0, 10.0]),
        ("A3", [0.0, 10.0, 10.0, 10.0]),
    ]
    .map(|(handle, ends)| line(handle, layer, ends))
    .concat()
}

fn drawing(tables: &str, body: &str, layers: &[&str]) -> Drawing {
    let text = format!("{tables}0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n");
    let source = Source {
        layers: layers.iter().map(|&l| l.to_owned()).collect(),
        ..Source::default()
    };
    from_bytes(text.as_bytes(), Format::Dxf, &source).unwrap()
}

/// The problems of a drawing; none if it makes parts.
fn problems(drawing: &Drawing, settings: &Settings) -> Vec<Problem> {
    match drawing.outlines(settings) {
        Ok(_) => Vec::new(),
        Err(DrawingError::Entities(problems)) => problems,
        Err(error) => panic!("{error}"),
    }
}

#[track_caller]
fn has(problem: &Problem, reason: &[&str], help: &str) {
    for words in reason {
        assert!(problem.reason.contains(words), "{words}: {problem}");
    }
    assert!(problem.help.contains(help), "{help}: {}", problem.help);
}

#[test]
fn the_layer_that_closes_a_chain_is_named() {
    let body = three_sides("part") + &line("B7", "0", [10.0, 0.0, 10.0, 10.0]);
    let told = problems(&drawing("", &body, &["part"]), &Settings::default());
    assert_eq!(told.len(), 1);
    has(
        &told[0],
        &[
            "the gap from (10, 0) to (10, 10) is closed by LINE B7 on layer \"0\" (line",
            "whose layer was not asked for",
        ],
        "add --layer \"0\" (in a model: layer = [\"part\", \"0\"])",
    );
    // In lengths of the model.
    let scaled = Settings {
        scale: 2.0,
        ..Settings::default()
    };
    let told = problems(&drawing("", &body, &["part"]), &scaled);
    has(&told[0], &["from (20, 0) to (20, 20)"], "--layer");
    // What is told closes it.
    let both = drawing("", &body, &["part", "0"]).outlines(&Settings::default());
    assert!((both.unwrap().parts[0].area() - 100.0).abs() < 1e-12);
}

#[test]
fn several_pieces_and_chains_are_told() {
    // Two sides apart, each of the two gaps closed by two lines of other layers.
    let body = [
        ("A1", "part", [0.0, 0.0, 0.0, 10.0]),
        ("A2", "part", [10.0, 0.0, 10.0, 10.0]),
        ("B1", "low", [0.0, 0.0, 5.0, 0.0]),
        ("B2", "low", [10.0, 0.0, 5.0, 0.0]),
        ("C1", "left", [0.0, 10.0, 5.0, 12.0]),
        ("C2", "right", [5.0, 12.0, 10.0, 10.0]),
        ("D1", "left", [0.0, 10.0, -20.0, 10.0]),
    ]
    .map(|(handle, layer, ends)| line(handle, layer, ends))
    .concat();
    let told = problems(&drawing("", &body, &["part"]), &Settings::default());
    assert_eq!(told.len(), 2);
    for problem in &told {
        let gaps = problem.reason.matches("the gap from").count();
        assert_eq!(gaps, 2, "{problem}");
        has(problem, &["B1", "B2", "C1", "C2"], "--layer \"right\"");
        assert!(!problem.reason.contains("D1"), "{problem}");
    }
}

#[test]
fn hidden_layers_and_other_outlines_are_told() {
    let side = [10.0, 0.0, 10.0, 10.0];
    let table = |flags: i32, colour: i32| {
        format!(
            "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nX\n70\n{flags}\n62\n{colour}\n0\nENDTAB\n0\nENDSEC\n"
        )
    };
    for (tables, help) in [
        (table(1, 7), "thaw layer \"X\""),
        (table(0, -7), "switch layer \"X\" on"),
    ] {
        let body = three_sides("part") + &line("B7", "X", side);
        let told = problems(&drawing(&tables, &body, &[]), &Settings::default());
        has(&told[0], &["LINE B7 on layer \"X\""], help);
    }
    // A square beside it that is closed, and has the missing side.
    let beside = [
        ("B1", side),
        ("B2", [10.0, 10.0, 20.0, 10.0]),
        ("B3", [20.0, 10.0, 20.0, 0.0]),
        ("B4", [20.0, 0.0, 10.0, 0.0]),
    ];
    let square = |layer: &str| beside.map(|(h, ends)| line(h, layer, ends)).concat();
    let closed = |layer: &str| {
        format!(
            "0\nLWPOLYLINE\n5\nB9\n8\n{layer}\n70\n1\n10\n10\n20\n0\n10\n10\n20\n10\n10\n20\n20\n10\n10\n20\n20\n0\n"
        )
    };
    let body = three_sides("part") + &closed("other");
    let told = problems(&drawing("", &body, &[]), &Settings::default());
    has(
        &told[0],
        &["LWPOLYLINE B9 on layer \"other\"", "another outline"],
        "on layer \"part\" too",
    );
    // Of one layer it is not told: nothing is wrong with the square.
    let body = three_sides("part") + &closed("part");
    let told = problems(&drawing("", &body, &[]), &Settings::default());
    assert!(!told[0].reason.contains("the gap"), "{}", told[0]);
    // Lines that are asked for and meet in threes are told as that.
    let body = three_sides("part") + &square("other");
    let told = problems(&drawing("", &body, &[]), &Settings::default());
    assert!(told.iter().all(|p| p.reason.contains("ends meet here")));
}

/// The directions of short lines beside each other differ by less than they are known to, far from the drawing's middle: none of them is
/// taken to overlap another.
#[test]
fn a_circle_of_very_many_lines_is_one_loop() {
    const LINES: u32 = 100_000;
    let corner = |i: u32| {
        let angle = core::f64::consts::TAU * f64::from(i % LINES) / f64::from(LINES);
        (100.0 * angle.cos(), 100.0 * angle.sin())
    };
    let sides = (0..LINES).map(|i| {
        let ((x0, y0), (x1, y1)) = (corner(i), corner(i + 1));
        format!("0\nLINE\n8\nA\n10\n{x0:.6}\n20\n{y0:.6}\n11\n{x1:.6}\n21\n{y1:.6}\n")
    });
    let body: String = sides.collect();
    let outlines = (drawing("", &body, &["A"]).outlines(&Settings::default())).unwrap();
    assert_eq!(
        (outlines.parts.len(), outlines.parts[0].loops().len()),
        (1, 1)
    );
    assert_eq!(outlines.parts[0].edges().count(), LINES as usize);
}
