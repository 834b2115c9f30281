//! The answers that the summary begins with, against arithmetic done by hand.

use crate::helpers::{model, printed};

fn text_of(model: &str, more: &[&str]) -> String {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("m.toml");
    std::fs::write(&path, model).unwrap();
    printed(&[&["compute", path.to_str().unwrap()], more].concat())
}

/// A square ring, 6 wide outside and 4 inside, and a block of 2.
const RING: &str = "unit = \"mm\"\n[[part]]\nname = \"ring\"\n\
    loops = [[[-3, -3], [3, -3], [3, 3], [-3, 3]], [[-2, -2], [2, -2], [2, 2], [-2, 2]]]\n\
    [[part]]\nname = \"block\"\nloops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]\n";

#[test]
fn caged_regions_have_their_orientations() {
    // The block's diagonal, 2.83, is shorter than the hole is wide: it turns within.
    let text = text_of(RING, &[]);
    let has = |words: &str| assert!(text.contains(words), "{words}: {text}");
    has("block relative to ring");
    has("as drawn       free, in pocket 1, 1.000000 mm apart");
    has("2 connected regions, 1 caged");
    has("caged: block cannot leave it, at all orientations");
    // Nothing touches the four inner corners.
    has("may touch      12 of 16 features of ring, 8 of 8 of block: 48 pairs");
    // A block of 3.6 turns as far as cos t + sin t = 4 / 3.6 lets it: by asin(4 / 3.6 / √2) − 45°.
    let large = RING.replace(
        "[-1, -1], [1, -1], [1, 1], [-1, 1]",
        "[-1.8, -1.8], [1.8, -1.8], [1.8, 1.8], [-1.8, 1.8]",
    );
    let text = text_of(&large, &["--window=-40deg,40deg"]);
    let t = (4.0_f64 / 3.6 / 2.0_f64.sqrt()).asin().to_degrees() - 45.0;
    let words = format!("theta from {:.4} deg to {t:.4} deg", -t);
    assert!(text.contains(&words), "{words}: {text}");
    // One that overlaps as drawn.
    let moved = RING.replace(
        "[-1, -1], [1, -1], [1, 1], [-1, 1]",
        "[0, -1], [2.5, -1], [2.5, 1], [0, 1]",
    );
    assert!(text_of(&moved, &[]).contains("as drawn       blocked"));
}

#[test]
fn parts_that_always_overlap_are_said_to() {
    let disc = |name: &str, x: f64, range: &str| {
        format!(
            "[[part]]\nname = \"{name}\"\nloops = [[[{}, 0, 1], [{}, 0, 1]]]\n\
             motion = {{ type = \"revolute\", center = [{x}, 0]{range} }}\n",
            x - 2.0,
            x + 2.0
        )
    };
    let text = text_of(&(disc("a", 0.0, "") + &disc("b", 1.0, "")), &[]);
    assert!(
        text.contains("no free configuration: the parts overlap or fit exactly in each"),
        "{text}"
    );
    let text = text_of(&(disc("a", 0.0, "") + &disc("b", 9.0, "")), &[]);
    assert!(
        text.contains("u (a) and v (b) turn together for ever") && text.contains("5.000000 apart"),
        "{text}"
    );
}

#[test]
fn limits_that_are_reached_are_named() {
    // A slider of half width 1 before a wall whose face is at 1: it comes as near as 2, and as far as its range.
    let square = |name: &str, x: f64, motion: &str| {
        let (a, b) = (x - 1.0, x + 1.0);
        format!(
            "[[part]]\nname = \"{name}\"\nloops = [[[{a}, -1], [{b}, -1], [{b}, 1], [{a}, 1]]]\nmotion = {motion}\n"
        )
    };
    let text = text_of(
        &(square("wall", 0.0, "{ type = \"fixed\" }")
            + &square(
                "slider",
                5.0,
                "{ type = \"prismatic\", direction = [1, 0], range = [-8, 4] }",
            )),
        &[],
    );
    for words in [
        "as drawn       free, in region 1, 3.000000 apart",
        "v (slider) from -3.000000 to 4.000000, its limit",
        "v (slider) from -8.000000, its limit, to -7.000000",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[test]
fn how_certain_the_structure_is_is_told_when_asked() {
    let plain = printed(&["compute", &model("knee")]);
    let verbose = printed(&["compute", &model("knee"), "--verbose"]);
    assert!(
        !plain.contains("certainty") && verbose.contains("  certainty "),
        "{verbose}"
    );
}
