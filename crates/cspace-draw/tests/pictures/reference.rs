//! Pictures equal those kept in `tests/reference/`, except for invisible differences.
//!
//! To change pictures, `CSPACE_PICTURES=write cargo test -p cspace-draw` writes the new ones, which are then to be
//! inspected.

use std::path::Path;

use cspace_draw::svg;

use crate::scenes::all;

/// Largest difference of numbers in a picture, in dots: they are rounded to a hundredth.
const SAME: f64 = 0.03;

#[test]
fn pictures_are_those_that_are_kept() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference");
    for (name, scene) in all() {
        let file = folder.join(format!("{name}.svg"));
        let picture = svg(&scene);
        if std::env::var("CSPACE_PICTURES").is_ok_and(|v| v == "write") {
            std::fs::write(&file, &picture).unwrap();
            continue;
        }
        let kept = std::fs::read_to_string(&file).unwrap();
        let (a, b) = (words(&picture), words(&kept));
        assert_eq!(a.len(), b.len(), "{name}: {} differs", file.display());
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            let same = match (a.parse::<f64>(), b.parse::<f64>()) {
                (Ok(x), Ok(y)) => (x - y).abs() <= SAME,
                _ => a == b,
            };
            assert!(same, "{name}: word {i} is {a}, kept is {b}");
        }
    }
}

/// Numbers and what is between them.
fn words(picture: &str) -> Vec<String> {
    let mut all = vec![String::new()];
    let mut in_number = false;
    for c in picture.chars() {
        let numeric = c.is_ascii_digit() || c == '.' || c == '-';
        // A sign, and a second point, begin another number.
        let begins = c == '-' || (c == '.' && all.last().is_some_and(|w| w.contains('.')));
        if numeric != in_number || (numeric && begins) {
            all.push(String::new());
        }
        in_number = numeric;
        all.last_mut().unwrap().push(c);
    }
    all
}
