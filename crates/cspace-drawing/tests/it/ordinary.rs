//! Ordinary drawings that are easily read wrong: flats of traces, places far from the origin, sheets, centre lines, colours, fills,
//! clips, and decimal commas.

use core::f64::consts::{PI, TAU};

use cspace::{Part, Point};
use cspace_drawing::{Color, Drawing, Format, Outlines, Settings, Source, from_bytes, offset};

fn from_text(format: Format, text: &str, source: &Source) -> Drawing {
    from_bytes(text.as_bytes(), format, source).unwrap()
}

fn dxf(tables: &str, entities: &str) -> String {
    let tables =
        format!("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n{tables}0\nENDTAB\n0\nENDSEC\n");
    format!("{tables}0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n")
}

fn polyline(points: &[Point]) -> String {
    let each = points
        .iter()
        .map(|p| format!("10\n{:?}\n20\n{:?}\n", p.x, p.y));
    let points: String = each.collect();
    format!("0\nLWPOLYLINE\n8\n0\n70\n1\n{points}")
}

fn circle(more: &str, x: f64, radius: f64) -> String {
    format!("0\nCIRCLE\n8\n0\n{more}10\n{x}\n20\n0\n40\n{radius}\n")
}

fn svg(body: &str, source: &Source, settings: &Settings) -> Outlines {
    let text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"60mm\" viewBox=\"0 0 100 60\">{body}</svg>"
    );
    from_text(Format::Svg, &text, source)
        .outlines(settings)
        .unwrap()
}

fn areas(outlines: &Outlines) -> Vec<f64> {
    outlines.parts.iter().map(Part::area).collect()
}

#[track_caller]
fn are(found: &[f64], expected: &[f64]) {
    let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-6 * b;
    let same = found.len() == expected.len() && found.iter().zip(expected).all(near);
    assert!(same, "{found:?} for {expected:?}");
}

/// Points around a circle of 10, each moved onto a line where that cuts the circle off, and the ends of the line.
fn shaft(count: u32, flat: f64) -> Vec<Point> {
    let half = (flat / 10.0).acos();
    let corner = |side: f64| Point::new(side * 10.0 * half.sin(), flat);
    let mut points = vec![corner(1.0), corner(-1.0)];
    points.extend(
        (0..count)
            .map(|k| PI / 2.0 + TAU * f64::from(k) / f64::from(count))
            .filter(|t| {
                (t - PI / 2.0).rem_euclid(TAU) > half && (PI / 2.0 - t).rem_euclid(TAU) > half
            })
            .map(|t| Point::new(10.0 * t.cos(), 10.0 * t.sin())),
    );
    points
}

/// Flats and chamfers of a trace stay, and what is printed is how far the whole outline is from the polygon.
#[test]
fn what_is_drawn_of_a_trace_stays() {
    let trace = |points: &[Point], fit: f64| {
        let text = dxf("", &polyline(points));
        let settings = Settings {
            trace: true,
            fit: Some(fit),
            ..Settings::default()
        };
        let drawing = from_text(Format::Dxf, &text, &Source::default());
        drawing.outlines(&settings).unwrap()
    };
    let is_off = |part: &Part, points: &[Point]| {
        // Places on the chords from the part, and on the part from the chords.
        let drawn = Part::new(
            "drawn",
            vec![
                points
                    .iter()
                    .map(|p| cspace::Vertex::line(p.x, p.y))
                    .collect(),
            ],
        );
        let drawn = drawn.unwrap();
        let off = |from: &Part, to: &Part| {
            let places = from
                .edges()
                .flat_map(|e| (0..50).map(move |k| e.at(f64::from(k) / 50.0)));
            places
                .map(|p| {
                    to.edges()
                        .map(|e| e.distance(p))
                        .fold(f64::INFINITY, f64::min)
                })
                .fold(0.0, f64::max)
        };
        off(part, &drawn).max(off(&drawn, part))
    };
    for (count, flat, fit) in [(72, 9.9, 0.02), (180, 9.95, 0.01), (90, 7.0, 0.02)] {
        let points = shaft(count, flat);
        let outlines = trace(&points, fit);
        let part = &outlines.parts[0];
        let is_flat = |e: &cspace::Edge| {
            e.is_line() && (e.start.y - flat).abs() < 1e-9 && (e.end.y - flat).abs() < 1e-9
        };
        assert!(
            part.edges().any(|e| is_flat(&e)),
            "{count} {flat}: {part:?}"
        );
        assert!(part.edges().count() <= 6, "{part:?}");
        let deviation = outlines.fitted.deviation;
        let off = is_off(part, &points);
        assert!(
            deviation <= fit && (off - deviation).abs() < 1e-3 * fit,
            "{off} {deviation}"
        );
    }
    // A square with chamfers, in a finely traced disc of which each quarter is a lobe.
    let mut gear = Vec::new();
    for tooth in 0..8 {
        let turn = TAU * f64::from(tooth) / 8.0;
        let at = |r: f64, t: f64| Point::new(r * (turn + t).cos(), r * (turn + t).sin());
        gear.extend((0..12).map(|k| at(20.0, 0.03 * f64::from(k))));
        gear.extend([at(23.0, 0.45), at(23.0, 0.55)]);
    }
    let outlines = trace(&gear, 0.01);
    let part = &outlines.parts[0];
    let off = is_off(part, &gear);
    assert!(
        off <= 0.01 && (off - outlines.fitted.deviation).abs() < 1e-5,
        "{off}"
    );
    let tips = part
        .edges()
        .filter(|e| e.is_line() && e.start.to_vector().length() > 22.9);
    assert!(tips.count() >= 8, "{part:?}");
}

#[test]
fn offsets_do_not_depend_on_the_place() {
    let at = |x: f64, y: f64| {
        let corners = [(0.0, 0.0), (40.0, 7.0), (13.0, 31.0)];
        let moved = corners.map(|(a, b)| (x + a, y + b));
        Part::polygon("triangle", &moved).unwrap()
    };
    for by in [1.0, 0.02, -0.5] {
        let here = offset(&at(0.0, 0.0), by, false).unwrap().part;
        for (x, y) in [(3e6, 3e6), (5e8, 4.65e9), (-1e7, 0.0)] {
            let there = offset(&at(x, y), by, false).unwrap().part;
            assert_eq!(there.edges().count(), here.edges().count());
            // Coordinates are rounded to an ulp of the place, along a perimeter of 120.
            let rounding = 240.0 * f64::EPSILON * x.abs().max(y.abs());
            assert!(
                (there.area() - here.area()).abs() <= rounding,
                "{by} {x} {y}"
            );
        }
    }
}

#[test]
fn the_sheet_around_parts_is_told_and_left_out() {
    let plates = r#"<g fill="none" stroke="red"><rect x="5" y="5" width="40" height="50"/>HOLE<rect x="55" y="5" width="40" height="50"/></g>"#;
    let sheet = r##"<rect width="100" height="60" fill="#faf8f4" stroke="#aaa"/>"##;
    let hole = r#"<circle cx="25" cy="30" r="5"/>"#;
    let (own, with_hole) = (Source::default(), 2000.0 - 25.0 * PI);
    for (hole, expected) in [(hole, with_hole), ("", 2000.0)] {
        let body = format!("{sheet}{}", plates.replace("HOLE", hole));
        let read = svg(&body, &own, &Settings::default());
        assert_eq!(
            read.sheet.as_ref().map(|o| o.kind.to_string()),
            Some("rect".to_owned())
        );
        let settings = Settings {
            without_sheet: true,
            ..Settings::default()
        };
        let read = svg(&body, &own, &settings);
        are(&areas(&read), &[expected, 2000.0]);
        assert!(
            read.sheet.is_none() && read.ignored.len() == 1,
            "{:?}",
            read.ignored
        );
        // By colour too.
        let red = Source {
            colors: vec!["#ff0000".parse().unwrap()],
            ..Source::default()
        };
        are(
            &areas(&svg(&body, &red, &Settings::default())),
            &[expected, 2000.0],
        );
    }
    // A plate with holes that is smaller than the page is no sheet.
    let plate = r#"<rect width="90" height="50"/><circle cx="20" cy="20" r="5"/><circle cx="60" cy="20" r="5"/>"#;
    let read = svg(plate, &own, &Settings::default());
    assert!(read.sheet.is_none());
    are(&areas(&read), &[4500.0 - 50.0 * PI]);
}

#[test]
fn centre_lines_and_hidden_edges_are_no_outlines() {
    let layers = "0\nLAYER\n2\nAXES\n70\n0\n62\n5\n6\nCENTER2\n0\nLAYER\n2\n0\n70\n0\n62\n7\n6\nCONTINUOUS\n";
    let washer = circle("", 0.0, 10.0) + &circle("6\nBYLAYER\n", 0.0, 4.0);
    let line = |more: &str| format!("0\nLINE\n{more}10\n-15\n20\n0\n11\n15\n21\n0\n");
    let area = 84.0 * PI;
    for more in [
        "8\nAXES\n",
        "8\n0\n6\nHIDDEN\n",
        "8\n0\n6\nacad_iso04w100\n",
        "8\n0\n6\nPhantomX2\n",
    ] {
        let text = dxf(layers, &(washer.clone() + &line(more)));
        let read = from_text(Format::Dxf, &text, &Source::default());
        let outlines = read.outlines(&Settings::default()).unwrap();
        are(&areas(&outlines), &[area]);
        assert!(
            outlines.ignored[0].reason.contains("line type"),
            "{:?}",
            outlines.ignored
        );
    }
    // The layer's line type is not that of an entity with its own.
    let text = dxf(layers, &(washer + &line("8\nAXES\n6\nCONTINUOUS\n")));
    let outlines = (from_text(Format::Dxf, &text, &Source::default()))
        .outlines(&Settings::default())
        .unwrap();
    are(&areas(&outlines), &[area]);
    let reason = &outlines.ignored[0].reason;
    assert!(reason.contains("centre line"), "{reason}");
    let hidden = circle("6\nHIDDEN\n", 0.0, 2.0) + &circle("", 0.0, 10.0);
    let asked = Source {
        linetypes: vec!["hidden".to_owned()],
        ..Source::default()
    };
    let read = from_text(Format::Dxf, &dxf(layers, &hidden), &asked);
    are(
        &areas(&read.outlines(&Settings::default()).unwrap()),
        &[4.0 * PI],
    );
}

#[test]
fn colours_choose_what_is_read() {
    let layers = "0\nLAYER\n2\n0\n70\n0\n62\n3\n";
    let all =
        circle("62\n1\n", 0.0, 1.0) + &circle("420\n255\n", 10.0, 2.0) + &circle("", 20.0, 3.0);
    for (color, radius) in [
        ("red", 1.0),
        ("1", 1.0),
        ("blue", 2.0),
        ("#0000ff", 2.0),
        ("5", 2.0),
        ("green", 3.0),
        ("3", 3.0),
    ] {
        let source = Source {
            colors: vec![color.parse::<Color>().unwrap()],
            ..Source::default()
        };
        let outlines =
            from_text(Format::Dxf, &dxf(layers, &all), &source).outlines(&Settings::default());
        are(&areas(&outlines.unwrap()), &[PI * radius * radius]);
    }
    assert!("reddish".parse::<Color>().is_err() && "0".parse::<Color>().is_err());
}

#[test]
fn fills_are_as_they_are_drawn() {
    let path =
        |rule: &str, inner: &str| format!(r#"<path {rule} d="M10 10 H60 V50 H10 Z {inner}"/>"#);
    // Both the same way around, and the inner one the other way.
    let [same, other] = ["M20 20 H30 V30 H20 Z", "M20 20 V30 H30 V20 Z"];
    let sheet = r#"<style>path.hole { fill-rule: evenodd }</style>"#;
    for (body, expected) in [
        (path("", same), 2000.0),
        (path("", other), 1900.0),
        (path("fill-rule=\"evenodd\"", same), 1900.0),
        (path("style=\"fill-rule: evenodd\"", same), 1900.0),
        (path("class=\"hole\"", same), 1900.0),
        // Lines are outlines whatever they would fill.
        (path("fill=\"none\" stroke=\"black\"", same), 1900.0),
    ] {
        let read = svg(
            &format!("{sheet}{body}"),
            &Source::default(),
            &Settings::default(),
        );
        are(&areas(&read), &[expected]);
        assert_eq!(
            read.ignored.len(),
            usize::from(expected == 2000.0),
            "{body}"
        );
    }
}

#[test]
fn what_is_not_followed_is_listed() {
    let told = |body: &str| {
        let read = svg(body, &Source::default(), &Settings::default());
        read.unfollowed
            .iter()
            .map(|u| u.reason.to_string())
            .collect::<Vec<_>>()
    };
    let clip = r#"<clipPath id="c"><rect width="50" height="50"/></clipPath>"#;
    for body in [
        format!(r#"{clip}<circle clip-path="url(#c)" cx="50" cy="50" r="20"/>"#),
        format!(r#"{clip}<g style="clip-path: url(#c)"><circle cx="50" cy="50" r="20"/></g>"#),
    ] {
        assert!(told(&body)[0].contains("clip path"), "{:?}", told(&body));
    }
    let styled = |rule: &str| {
        format!(
            "<style>{rule}</style><circle id=\"a\" r=\"2\"/><circle class=\"b\" cx=\"9\" r=\"3\"/>"
        )
    };
    assert_eq!(told(&styled("g > circle { fill: none }")).len(), 1);
    assert!(told(&styled("g > circle { cursor: help }")).is_empty());
    let read = svg(
        &styled("#a, circle.c { display: none }"),
        &Source::default(),
        &Settings::default(),
    );
    are(&areas(&read), &[9.0 * PI]);
    // A ring of AutoCAD's command DONUT: its middle is read, and its width told.
    let donut = "0\nLWPOLYLINE\n8\n0\n70\n1\n43\n4\n10\n-5\n20\n0\n42\n1\n10\n5\n20\n0\n42\n1\n";
    let drawing = from_text(Format::Dxf, &dxf("", donut), &Source::default());
    let outlines = drawing.outlines(&Settings::default()).unwrap();
    are(&areas(&outlines), &[25.0 * PI]);
    assert!(outlines.unfollowed[0].reason.contains("width"));
}

#[test]
fn points_are_written_in_many_ways() {
    let ellipse = |row: &dyn Fn(f64, f64) -> String| -> String {
        let turns = (0..360).map(|k| TAU * f64::from(k) / 360.0);
        turns
            .map(|t| row(30.0 * t.cos(), 20.0 * t.sin()) + "\n")
            .collect()
    };
    let comma = |x: f64| format!("{x:.4}").replace('.', ",");
    for text in [
        "x;y\n".to_owned() + &ellipse(&|x, y| format!("{};{}", comma(x), comma(y))),
        ellipse(&|x, y| format!("{}\t{}", comma(x), comma(y))),
        "X [mm], Y [mm]\n".to_owned() + &ellipse(&|x, y| format!("{x:.4},{y:.4}")),
        "a section\n".to_owned() + &ellipse(&|x, y| format!("  {x:.4}   {y:.4}")),
    ] {
        let drawing = from_text(Format::Points, &text, &Source::default());
        let is_mm = text.starts_with('X');
        assert_eq!(drawing.unit.map(|u| u.label()), is_mm.then_some("mm"));
        let area = areas(&drawing.outlines(&Settings::default()).unwrap())[0];
        assert!((area / (600.0 * PI) - 1.0).abs() < 1e-3, "{area}");
    }
    for name in ["a.txt", "a.dat", "a.CSV"] {
        assert_eq!(Format::of_extension(name.as_ref()), Some(Format::Points));
    }
}

#[test]
fn hyphens_in_comments_do_no_harm() {
    let text = "<svg xmlns=\"http://www.w3.org/2000/svg\">\n<!-- a -- b ---><rect id=\"a--b\" width=\"5\" height=\"5\"/></svg>";
    let drawing = from_text(Format::Svg, text, &Source::default());
    are(
        &areas(&drawing.outlines(&Settings::default()).unwrap()),
        &[25.0],
    );
    assert_eq!(&*drawing.entities[0].origin.handle, "a--b");
    assert_eq!(drawing.entities[0].origin.line, 2);
}

/// The corners of a square of 10 with gaps of so many thousandths.
fn square_with_gaps(scale: f64) -> Drawing {
    let lines: String = [
        [0.0, 0.0, 10.0, 3.0 * scale],
        [10.0, 0.0, 10.0 + 2.0 * scale, 10.0],
        [10.0 - 4.0 * scale, 10.0, 0.0, 10.0 + scale],
        [0.0, 10.0, scale, scale],
    ]
    .map(|[a, b, c, d]| format!("0\nLINE\n8\n0\n10\n{a}\n20\n{b}\n11\n{c}\n21\n{d}\n"))
    .concat();
    from_text(Format::Dxf, &dxf("", &lines), &Source::default())
}

#[test]
fn one_join_closes_all_gaps() {
    let drawing = square_with_gaps(0.01);
    let error = drawing.outlines(&Settings::default()).unwrap_err();
    let cspace_drawing::DrawingError::Entities(problems) = error else {
        panic!("{error}");
    };
    assert_eq!(problems.len(), 4);
    let given = |help: &str| {
        let after = help.split("--join ").nth(1).unwrap();
        after.split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    let joins: Vec<f64> = problems.iter().map(|p| given(&p.help)).collect();
    assert!(joins.iter().all(|j| *j == joins[0]), "{joins:?}");
    let settings = Settings {
        join: Some(joins[0]),
        ..Settings::default()
    };
    let area = areas(&drawing.outlines(&settings).unwrap())[0];
    assert!((area - 100.0).abs() < 1.0, "{area}");
}

/// Gaps of less than a thousandth of the drawing are closed where each end has one partner, and told; an end with two is an error.
#[test]
fn small_gaps_with_one_partner_are_closed() {
    let drawing = square_with_gaps(0.001);
    let outlines = drawing.outlines(&Settings::default()).unwrap();
    let area = areas(&outlines)[0];
    assert!((area - 100.0).abs() < 0.1, "{area}");
    assert_eq!(outlines.joined.len(), 4);
    assert!(outlines.gaps_closed().unwrap().starts_with("4 small gaps"));
    // As before with a distance that is given.
    let settings = Settings {
        join: Some(1e-4),
        ..Settings::default()
    };
    assert!(drawing.outlines(&settings).is_err());
    let mut three = square_with_gaps(0.001);
    let stub = three.entities[0].clone();
    let mut path = cspace_drawing::Path::from(Point::new(0.002, -0.001));
    path.edge_to(Point::new(-3.0, -3.0), 0.0);
    three.entities.push(cspace_drawing::Entity { path, ..stub });
    assert!(three.outlines(&Settings::default()).is_err());
}

/// A plate of 40 × 20 with a hole of radius 4 about (10, 10), and lines.
fn plate(lines: &[[f64; 4]]) -> Drawing {
    let mut entities = "0\nCIRCLE\n8\n0\n10\n10\n20\n10\n40\n4\n".to_owned();
    let sides = [
        [0.0, 0.0, 40.0, 0.0],
        [40.0, 0.0, 40.0, 20.0],
        [40.0, 20.0, 0.0, 20.0],
        [0.0, 20.0, 0.0, 0.0],
    ];
    for [a, b, c, d] in sides.iter().chain(lines) {
        entities += &format!("0\nLINE\n8\n0\n10\n{a}\n20\n{b}\n11\n{c}\n21\n{d}\n");
    }
    from_text(Format::Dxf, &dxf("", &entities), &Source::default())
}

#[test]
fn centre_lines_are_left_out() {
    let cross = [[4.0, 10.0, 16.0, 10.0], [10.0, 4.0, 10.0, 16.0]];
    let through = [[-5.0, 10.0, 45.0, 10.0]];
    let slanted = [[7.0, 6.0, 16.0, 18.0]];
    for lines in [&cross[..], &through, &slanted] {
        let read = plate(lines).outlines(&Settings::default()).unwrap();
        are(&areas(&read), &[800.0 - 16.0 * PI]);
        assert!(read.centre_lines().unwrap().contains("left out"));
        let left_out = read
            .ignored
            .iter()
            .filter(|i| i.reason.contains("centre line"));
        assert_eq!(left_out.count(), lines.len());
    }
    // A rib, the sides of a slot, a rectangle with rounded corners without its arcs, an outline that lacks a side, a stub, a line beside
    // the centre, and one that ends there.
    let rib = [[20.0, 0.0, 20.0, 20.0]];
    let slot = [[20.0, 4.0, 36.0, 4.0], [20.0, 8.0, 36.0, 8.0]];
    let round = [
        [22.0, 5.0, 34.0, 5.0],
        [36.0, 7.0, 36.0, 13.0],
        [34.0, 15.0, 22.0, 15.0],
        [20.0, 13.0, 20.0, 7.0],
    ];
    let open = [
        [20.0, 4.0, 36.0, 4.0],
        [36.0, 4.0, 36.0, 16.0],
        [36.0, 16.0, 20.0, 16.0],
    ];
    let stub = [[0.0, 20.0, 0.0, 28.0]];
    let beside = [[4.0, 10.1, 16.0, 10.1]];
    let ends = [[10.0, 10.0, 30.0, 10.0]];
    for lines in [&rib[..], &slot, &round, &open, &stub, &beside, &ends] {
        assert!(
            plate(lines).outlines(&Settings::default()).is_err(),
            "{lines:?}"
        );
    }
    // A circle that a line divides, and circles at the sides of a square that is not finished.
    let divided = [[6.0, 10.0, 14.0, 10.0]];
    assert!(plate(&divided).outlines(&Settings::default()).is_err());
    for corner in [0.0, 1.0] {
        let mut entities = String::new();
        let half = 20.0;
        for [x, y] in [[0.0, -half], [half, 0.0], [0.0, half], [-half, 0.0]] {
            entities += &format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n3\n");
            let side = half + 1.0 - 2.0 * corner;
            let [a, b, c, d] = match x == 0.0 {
                true => [-side, y, side, y],
                false => [x, -side, x, side],
            };
            entities += &format!("0\nLINE\n8\n0\n10\n{a}\n20\n{b}\n11\n{c}\n21\n{d}\n");
        }
        let square = from_text(Format::Dxf, &dxf("", &entities), &Source::default());
        assert!(square.outlines(&Settings::default()).is_err(), "{corner}");
    }
    // The sides of a plate with round corners, whose arcs are missing, around a hole.
    let mut entities = "0\nCIRCLE\n8\n0\n10\n20\n20\n15\n40\n4\n".to_owned();
    for [a, b, c, d] in [
        [6, 0, 34, 0],
        [40, 6, 40, 24],
        [34, 30, 6, 30],
        [0, 24, 0, 6],
    ] {
        entities += &format!("0\nLINE\n8\n0\n10\n{a}\n20\n{b}\n11\n{c}\n21\n{d}\n");
    }
    let open = from_text(Format::Dxf, &dxf("", &entities), &Source::default());
    assert!(open.outlines(&Settings::default()).is_err());
}

/// A circle in a square of its diameter touches it, wherever it is begun: that is no hole, and no part within another.
#[test]
fn a_hole_that_touches_its_outline_is_refused() {
    let square = "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n20\n20\n0\n10\n20\n20\n20\n10\n0\n20\n20\n";
    for (x, y, radius) in [(10, 10, 10), (5, 10, 5), (10, 16, 4)] {
        let circle = format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n{radius}\n");
        let drawing = from_text(
            Format::Dxf,
            &dxf("", &(square.to_owned() + &circle)),
            &Source::default(),
        );
        let error = drawing.outlines(&Settings::default()).unwrap_err();
        assert!(error.to_string().contains("touch"), "{error}");
    }
}
