//! Files that are damaged, endless or made to harm: a message, in bounded time and memory.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cspace_drawing::{DrawingError, Outlines, Settings, Source, read};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn outlines(path: &Path) -> Result<Outlines, DrawingError> {
    read(path, &Source::default())?.outlines(&Settings::default())
}

/// Error message for a file of this name and content.
#[track_caller]
fn said(name: &str, content: impl AsRef<[u8]>) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, content).unwrap();
    let error = outlines(&path).unwrap_err();
    assert!(!error.help().is_empty(), "{error}");
    format!("{error} | {}", error.help())
}

#[track_caller]
fn says(name: &str, content: impl AsRef<[u8]>, words: &[&str]) {
    let said = said(name, content);
    for word in words {
        assert!(said.contains(word), "{word:?} is not in: {said}");
    }
}

fn entities(body: &str) -> String {
    format!("0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n")
}

fn with_blocks(blocks: &str, body: &str) -> String {
    format!(
        "0\nSECTION\n2\nBLOCKS\n{blocks}0\nENDSEC\n{}",
        entities(body)
    )
}

const CIRCLE: &str = "0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n1\n";

#[test]
fn what_is_no_dxf_is_told() {
    says("a.dxf", "", &["empty"]);
    says("a.dxf", "  \n\n", &["empty"]);
    says("a.dxf", "AC1032\0\0\0", &["DWG", "save"]);
    says("a.dxf", "<svg/>", &["line 1", "code of a group"]);
    says(
        "a.dxf",
        "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n",
        &["ENTITIES"],
    );
    says("a.dxf", b"\xff\xfe0\x00", &["UTF-16"]);
    says("a.dwg", "AC1032", &["DWG", "DXF"]);
    says("a.step", "AC1032", &["extension", ".dxf"]);
    says("a.dxf", entities(""), &["no closed outline"]);
    says(
        "a.dxf",
        entities("0\nTEXT\n8\n0\n1\nhello\n"),
        &["left out are 1 because: a text"],
    );
}

#[test]
fn cut_off_files_are_told() {
    let whole = with_blocks(
        "0\nBLOCK\n8\n0\n2\nB\n70\n0\n10\n0\n20\n0\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n1\n0\nENDBLK\n8\n0\n",
        "0\nINSERT\n8\n0\n2\nB\n10\n0\n20\n0\n",
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dxf");
    for end in 0..whole.len() {
        std::fs::write(&path, &whole[..end]).unwrap();
        match outlines(&path) {
            // Only line breaks at the end may be missing.
            Ok(_) => assert!(end >= whole.trim_end().len(), "{end}"),
            Err(error) => assert!(!error.help().is_empty()),
        }
    }
}

#[test]
fn numbers_that_are_none_are_told() {
    for bad in ["nan", "inf", "1e999", "x", ""] {
        let text = entities(&CIRCLE.replace("\n40\n1\n", &format!("\n40\n{bad}\n")));
        says("a.dxf", text, &["line ", "group 40", "finite number"]);
    }
    for far in ["1e300", "-1e300"] {
        let text = entities(&CIRCLE.replace("\n10\n0\n", &format!("\n10\n{far}\n")));
        said("a.dxf", text);
    }
    says(
        "a.dxf",
        entities(&CIRCLE.replace("\n40\n1\n", "\n40\n-1\n")),
        &["CIRCLE", "radius"],
    );
}

#[test]
fn blocks_in_themselves_are_told() {
    let block = |name: &str, inner: &str| {
        format!(
            "0\nBLOCK\n8\n0\n2\n{name}\n70\n0\n10\n0\n20\n0\n0\nINSERT\n8\n0\n5\n{name}1\n2\n{inner}\n0\nENDBLK\n8\n0\n"
        )
    };
    let blocks = block("A", "B") + &block("B", "A");
    says(
        "a.dxf",
        with_blocks(&blocks, "0\nINSERT\n8\n0\n2\nA\n"),
        &["INSERT B1", "\"A\" is inserted in itself"],
    );
    says(
        "a.dxf",
        with_blocks("", "0\nINSERT\n8\n0\n2\nNONE\n"),
        &["no block \"NONE\""],
    );
}

/// Blocks that insert the one before ten times, and rows without end.
#[test]
fn bombs_of_inserts_end() {
    let start = Instant::now();
    let mut blocks = format!("0\nBLOCK\n8\n0\n2\nB0\n70\n0\n{CIRCLE}0\nENDBLK\n8\n0\n");
    for k in 1..12 {
        let inserts = format!("0\nINSERT\n8\n0\n2\nB{}\n", k - 1).repeat(10);
        blocks += &format!("0\nBLOCK\n8\n0\n2\nB{k}\n70\n0\n{inserts}0\nENDBLK\n8\n0\n");
    }
    says(
        "a.dxf",
        with_blocks(&blocks, "0\nINSERT\n8\n0\n2\nB11\n"),
        &["2000000 entities"],
    );
    let rows = "0\nINSERT\n8\n0\n2\nB0\n70\n1000000000\n71\n1000000000\n44\n1\n45\n1\n";
    says("a.dxf", with_blocks(&blocks, rows), &["2000000 entities"]);
    let empty = "0\nBLOCK\n8\n0\n2\nE\n70\n0\n0\nENDBLK\n8\n0\n";
    let rows = rows.replace("B0", "E");
    says("a.dxf", with_blocks(empty, &rows), &["2000000 entities"]);
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

/// A million circles inserted at one place are one circle, or too many; many ends at one place are reported once.
#[test]
fn crowds_at_one_place_end() {
    let start = Instant::now();
    let block = format!("0\nBLOCK\n8\n0\n2\nB\n70\n0\n{CIRCLE}0\nENDBLK\n8\n0\n");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dxf");
    std::fs::write(
        &path,
        with_blocks(&block, "0\nINSERT\n8\n0\n2\nB\n70\n300\n71\n1000\n"),
    )
    .unwrap();
    let outlines = outlines(&path).unwrap();
    assert_eq!(outlines.parts.len(), 1);
    assert_eq!(outlines.duplicates, 2 * 299_999);
    let star: String = (0..50_000)
        .map(|k| {
            let (sin, cos) = (f64::from(k) * 1e-4).sin_cos();
            format!("0\nLINE\n8\n0\n10\n0\n20\n0\n11\n{cos}\n21\n{sin}\n")
        })
        .collect();
    says("a.dxf", entities(&star), &["ends meet here"]);
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

/// Circles around one another by the thousand are no part, and are not compared every two.
#[test]
fn rings_without_end_are_told() {
    let start = Instant::now();
    let rings = |count: u32| -> String {
        let ring = |k| format!("0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n{}\n", k + 1);
        (0..count).map(ring).collect()
    };
    says(
        "a.dxf",
        entities(&rings(20_000)),
        &["CIRCLE", "more than 256 outlines are around it"],
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dxf");
    std::fs::write(&path, entities(&rings(256))).unwrap();
    let outlines = outlines(&path).unwrap();
    assert_eq!(outlines.parts.len(), 128);
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

/// The line of an element is found without reading the file up to it: that takes minutes here.
#[test]
fn many_elements_of_svg_end() {
    let start = Instant::now();
    let squares: String = (0..100_000)
        .map(|k| format!("<path\n d=\"M{} {}h1v1h-1\"/>", k % 300 * 2, k / 300 * 2))
        .collect();
    says(
        "a.svg",
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{squares}<path d=\"M0 x\"/></svg>"),
        &["path (line 100001)"],
    );
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn what_is_no_svg_is_told() {
    says("a.svg", "", &["no XML"]);
    says("a.svg", "<html/>", &["<html>", "<svg>"]);
    says("a.svg", b"\xff\xfe<\x00", &["UTF-8"]);
    says(
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"/>",
        &["no closed outline"],
    );
    says(
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><path id=\"p\" d=\"M0 0L1 x\"/></svg>",
        &["path p", "line 1"],
    );
    says(
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0L1e999 0L0 1Z\"/></svg>",
        &["path"],
    );
    says(
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"50%\"/></svg>",
        &["circle", "r is"],
    );
    says(
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><g transform=\"scale(0)\"><circle r=\"5\"/></g></svg>",
        &["transform"],
    );
    says(
        "a.svg",
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><g style=\"transform: rotate(45deg)\"><circle r=\"5\"/></g></svg>",
        &["moved by a style sheet"],
    );
}

#[test]
fn bombs_in_xml_end() {
    let start = Instant::now();
    let mut entities = String::from("<!ENTITY a0 \"<circle r='1'/>\">");
    for k in 1..12 {
        entities += &format!("<!ENTITY a{k} \"{}\">", format!("&a{};", k - 1).repeat(10));
    }
    let text =
        format!("<!DOCTYPE svg [{entities}]><svg xmlns=\"http://www.w3.org/2000/svg\">&a11;</svg>");
    said("a.svg", text);
    let mut defs = String::from("<g id=\"b0\"><circle r=\"1\"/></g>");
    for k in 1..12 {
        let uses = format!("<use href=\"#b{}\"/>", k - 1).repeat(10);
        defs += &format!("<g id=\"b{k}\">{uses}</g>");
    }
    let text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><defs>{defs}</defs><use href=\"#b11\"/></svg>"
    );
    says("a.svg", text, &["elements are drawn"]);
    let round = "<svg xmlns=\"http://www.w3.org/2000/svg\"><defs><g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g></defs><use href=\"#a\"/></svg>";
    says("a.svg", round, &["deep"]);
    let deep = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\">{}{}</svg>",
        "<g>".repeat(100_000),
        "</g>".repeat(100_000)
    );
    said("a.svg", deep);
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn what_are_no_points_is_told() {
    says("a.csv", "", &["0 different points"]);
    says("a.csv", "x,y\n1,2\n1,2\n", &["1 different points"]);
    says("a.csv", "a,b\n1,2\n", &["line 1", "no columns x and y"]);
    says("a.csv", "x,y\n0,0\n1,0\n1,z\n", &["line 4", "1,z"]);
    says("a.csv", "x,y\n0,0\n1,0\n1,nan\n", &["line 4"]);
    said("a.csv", "0 0\n1e300 0\n0 1e300\n");
    says("a.csv", b"\xff\xfe0\x00", &["UTF-8"]);
}

/// Drawings with some bytes changed give parts or a message.
#[test]
fn damaged_drawings_are_read_or_refused() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/drawings");
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let scratch = tempfile::tempdir().unwrap();
    for name in [
        "blocks.dxf",
        "slot_r12_binary.dxf",
        "slot_r2000_binary.dxf",
        "spline_circle.dxf",
        "half_ellipse.dxf",
        "layers_of_inserts.dxf",
        "polyline_r12.dxf",
        "shapes.svg",
        "used.svg",
        "transforms.svg",
        "square_points.csv",
    ] {
        let whole = std::fs::read(folder.join(name)).unwrap();
        let path = scratch.path().join(name);
        for _ in 0..60 {
            let mut bytes = whole.clone();
            for _ in 0..random.random_range(1..6) {
                let at = random.random_range(0..bytes.len());
                match random.random_range(0..3) {
                    0 => bytes[at] = random.random(),
                    1 => bytes[at] = b"0123456789.-e\n"[random.random_range(0..14)],
                    _ => {
                        let end = (at + random.random_range(1..40)).min(bytes.len());
                        bytes.drain(at..end);
                    }
                }
            }
            std::fs::write(&path, &bytes).unwrap();
            if let Err(error) = outlines(&path) {
                assert!(!error.help().is_empty(), "{name}: {error}");
            }
        }
    }
}
