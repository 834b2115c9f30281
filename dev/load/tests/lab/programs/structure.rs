//! The specimens of `cspace-structure`, and the command.

use std::collections::BTreeSet;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use cspace_load::structure::{
    Change, Effort, Flood, Outcome, Specimen, TABLE, Totals, files, measure, specimens,
};

fn command(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cspace-structure"));
    command.args(args).stdin(Stdio::null()).output().unwrap()
}

fn find(all: &[Specimen], name: &str) -> Specimen {
    all.iter().find(|s| s.title() == name).unwrap().clone()
}

#[test]
fn specimens_have_names_of_their_own_and_the_drawn_ones_are_parts() {
    let all = specimens(1, 2);
    let titles: BTreeSet<String> = all.iter().map(Specimen::title).collect();
    assert_eq!(titles.len(), all.len());
    for s in &all {
        let small = match s.change {
            Change::None | Change::Filleted => true,
            Change::Noise(power, _) => power >= 4,
            Change::Rounded(decimals) => decimals >= 4,
        };
        if let (true, Err(error)) = (small, s.case()) {
            panic!("{}: {error}", s.title());
        }
    }
}

#[test]
fn noise_is_as_large_as_it_says_and_depends_on_the_seed_alone() {
    let [first, again, other] = [1, 1, 2].map(|seed| specimens(seed, 1));
    let plain = find(&first, "dovetail 3 and comb");
    let noisy = find(&first, "dovetail 3 and comb, noise 1e-04");
    assert_eq!(
        noisy.fixed,
        find(&again, "dovetail 3 and comb, noise 1e-04").fixed
    );
    assert_ne!(
        noisy.fixed,
        find(&other, "dovetail 3 and comb, noise 1e-04").fixed
    );
    // The comb is 7 wide.
    let moved = plain.fixed[0].iter().zip(&noisy.fixed[0]);
    let most = moved.map(|(a, b)| (a.x - b.x).abs().max((a.y - b.y).abs()));
    let most = most.fold(0.0, f64::max);
    assert!(most > 1e-4 && most <= 7e-4, "{most}");
}

#[test]
#[ignore = "long: minutes"]
fn a_flood_fill_tells_the_regions_of_a_sofa_that_cannot_turn() {
    let sofa = find(&specimens(1, 1), "sofa 0.7 in its corridor");
    assert_eq!((sofa.family, sofa.expected), (TABLE, Some(4)));
    let effort = Effort {
        flood: Some(7),
        inverse: true,
        patience: Duration::from_secs(600),
    };
    let outcome = measure(&sofa, effort);
    let Outcome::Measured(measured) = &outcome else {
        panic!("{outcome:?}");
    };
    assert_eq!(measured.flood, Some(Flood::Agrees(4)));
    assert_eq!((measured.regions, measured.inverse), (4, Some(4)));
    let mut totals = Totals::default();
    totals.count(&sofa, &outcome);
    assert_eq!((totals.pairs, totals.expected, totals.wrong), (1, 1, 0));
}

#[test]
fn a_file_is_a_specimen_with_as_many_regions_as_are_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("two.toml");
    let model = r#"
        [[part]]
        name = "plate"
        loops = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [3, 1], [3, 3], [1, 3]]]
        [[part]]
        name = "pin"
        loops = [[[6, 0, 1], [7, 0, 1]]]
        "#;
    std::fs::write(&path, model).unwrap();
    let path = path.to_str().unwrap();
    let specimen = files::specimen(&format!("{path}=3")).unwrap();
    assert_eq!(
        (specimen.title().as_str(), specimen.expected),
        ("two", Some(3))
    );
    assert_eq!(files::specimen(path).unwrap().expected, None);

    let output = command(&["--family", "files", &format!("{path}=3")]);
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let row = said.lines().find(|l| l.starts_with("files: two")).unwrap();
    assert!(row.ends_with("WRONG"), "{row}");
    assert!(said.contains("1/1"), "{said}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (args, word) in [
        (&["--family", "nothing"][..], "no such family"),
        (&["nowhere.toml"], "nowhere.toml"),
        (&["--threads", "-1"], "1024"),
        (&["--depth", "30"], "1..=9"),
        (&["--table", "--family", "sofa"], "cannot be used"),
    ] {
        let output = command(args);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(word), "no {word:?} in: {said}");
    }
}

#[test]
fn chosen_pairs_are_counted_by_family_and_by_change() {
    let args = ["--limit", "1", "--only", "V notch", "--totals"];
    let output = command(&args);
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{said}");
    // As drawn, eleven sizes of noise, fillets, seven roundings.
    let line = said.lines().find(|l| l.starts_with("V notch")).unwrap();
    let count = |k: usize| {
        line[24..]
            .split_whitespace()
            .nth(k)
            .unwrap()
            .parse::<u32>()
            .unwrap()
    };
    assert_eq!(count(0) + count(8), 20, "{said}");
    assert!(!said.lines().any(|l| l.starts_with("V notch: ")), "{said}");
}
