//! `cspace-paper`, as a developer runs it.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::process::{Command, Output};

use serde_json::Value;

fn paper(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cspace-paper"));
    command.args(args).output().unwrap()
}

fn printed(args: &[&str]) -> String {
    let output = paper(args);
    assert!(output.status.success(), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&printed(&[args, &["--json"]].concat())).unwrap()
}

#[test]
fn json_has_the_fields_of_the_contract() {
    // Names as in Figure 5 or as the models' files, in any order; the answer is in Figure 5's.
    let answer = json(&["--pairs", "patella_femur,Blocks", "--repeat", "1"]);
    let pairs = answer["pairs"].as_array().unwrap();
    let names: Vec<&str> = pairs.iter().map(|p| p["pair"].as_str().unwrap()).collect();
    assert_eq!(names, ["blocks", "patella/femur"]);
    for pair in pairs {
        for field in [
            "old_slices",
            "new_slices",
            "new_slices_without_symmetry",
            "patches",
        ] {
            assert!(pair[field].as_u64().unwrap() > 0, "{field}");
        }
        for field in ["old_seconds", "new_seconds", "ratio", "largest_gap"] {
            assert!(pair[field].as_f64().unwrap() > 0.0, "{field}");
        }
        assert!(pair["links"]["side"].as_u64().unwrap() > 0);
        assert!(pair["links"]["vertical"].as_u64().unwrap() > 0);
        assert_eq!(pair["features"], pair["paper"]["features"]);
        for field in [
            "criticality_seconds",
            "criticality_seconds_without_skipping",
        ] {
            assert!(pair[field].as_f64().unwrap() > 0.0, "{field}");
        }
        // The search examines fewer where it skips what is known, and finds the same.
        let [skipped, examined] = &pair["criticality_search"].as_array().unwrap()[..] else {
            panic!("two searches");
        };
        let of = |search: &Value, field: &str| search[field].as_u64().unwrap();
        assert!(of(skipped, "examined") < of(examined, "examined"));
        assert_eq!(of(examined, "examined"), of(examined, "solutions"));
        assert!(of(examined, "overlap_tests") > 0);
        assert_eq!(skipped["orientations"], examined["orientations"]);
        let with = pair["ratio_with_criticalities"].as_f64().unwrap();
        assert!(with > pair["ratio"].as_f64().unwrap());
        // Each critical orientation of the slices computed has a kind.
        let critical = &pair["critical"];
        let count = |field: &str| critical[field].as_u64().unwrap();
        assert_eq!(count("orientations"), pair["new_slices"].as_u64().unwrap());
        let kinds = ["aligned", "end", "tangent", "triple"].map(count);
        assert!(kinds[0] > 0 && kinds.iter().sum::<u64>() >= count("orientations"));
        // A change is in a layer, or between two; each missed band shares its layer with another.
        let [joined, missed] =
            ["wrongly_joined", "missed_bands"].map(|f| pair[f].as_u64().unwrap());
        let changes = pair["new_slices_without_symmetry"].as_u64().unwrap();
        assert!(
            0 < joined && joined + missed <= 2 * changes,
            "{joined} {missed}"
        );
        // Bands of width w take ⌈w / 0.005⌉ slices.
        let (old, bands) = [&pair["old_slices"], &pair["new_slices_without_symmetry"]]
            .map(|n| n.as_u64().unwrap())
            .into();
        assert!((1257..=1257 + bands).contains(&old), "{old} {bands}");
        let ratio = pair["old_seconds"].as_f64().unwrap() / pair["new_seconds"].as_f64().unwrap();
        assert!((pair["ratio"].as_f64().unwrap() / ratio - 1.0).abs() < 1e-9);
    }
    assert_eq!(pairs[1]["paper"]["new_slices"], 107);
    for group in ["engineering", "knee"] {
        let average = &answer["averages"][group];
        assert_eq!(average["pairs"], 1);
        // Of one pair all averages are its ratio.
        let slices = &average["slices"];
        let [mean, geometric] = ["mean", "geometric_mean"].map(|f| slices[f].as_f64().unwrap());
        assert!((mean / geometric - 1.0).abs() < 1e-9);
    }
    let survey = &answer["survey"];
    assert_eq!(survey["paper_saving"], 10.0);
    assert_eq!(survey["mechanisms"]["special_mechanisms"], 0.71);
    assert!(
        survey["mechanisms"]["source"]
            .as_str()
            .unwrap()
            .contains("section 4")
    );
    let share = survey["special_share"].as_f64().unwrap();
    for saving in ["all_fixed_axes", "all_lower"] {
        let saving = survey["saving"][saving].as_f64().unwrap();
        assert!(0.0 < saving && saving < 1.0 / (1.0 - share), "{saving}");
    }
    let classes: Vec<&str> = (survey["special_pairs"].as_array().unwrap().iter())
        .map(|p| p["class"].as_str().unwrap())
        .collect();
    for class in ["lower", "fixed-axes"] {
        assert!(classes.contains(&class));
    }
}

#[test]
#[ignore = "long: seconds"]
fn a_search_that_does_not_end_in_time_has_no_seconds() {
    let args = ["--pairs", "ratchet/pawl", "--repeat", "1"];
    let limited = [args.as_slice(), &["--criticality-limit", "0.01"]].concat();
    let pair = &json(&limited)["pairs"][0];
    for field in [
        "criticality_seconds",
        "criticality_seconds_without_skipping",
    ] {
        assert!(pair[field].is_null(), "{field}");
    }
    // What is known of the ratio counts the limit.
    let [with, old, new] = ["ratio_with_criticalities", "old_seconds", "new_seconds"]
        .map(|f| pair[f].as_f64().unwrap());
    assert!((with * new / (old + 0.01) - 1.0).abs() < 1e-9);
    // Of one tooth, as many as slices are computed.
    assert_eq!(pair["critical"]["orientations"], pair["new_slices"]);
    let text = printed(&limited);
    assert!(text.contains("> 0.01 s"), "{text}");
}

#[test]
fn a_group_without_pairs_has_no_average() {
    let answer = json(&["--pairs", "cam", "--repeat", "1"]);
    assert!(answer["averages"]["knee"].is_null());
}

#[test]
fn text_shows_figure_5_beside_what_was_measured() {
    let text = printed(&["--pairs", "blocks", "--repeat", "1"]);
    for words in [
        "Figure 5",
        "1261",
        "blocks",
        "Survey of 2500 mechanisms",
        "the paper: 90 %",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[test]
fn wrong_usage_is_told() {
    for (args, words) in [
        (["--pairs", "cam,whisk"], ["'whisk'", "tibia/femur"]),
        (["--repeat", "0"], ["--repeat", "0"]),
        (
            ["--criticality-limit=-1", "--json"],
            ["--criticality-limit", "seconds"],
        ),
    ] {
        let output = paper(&args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(output.stdout.is_empty());
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(words.iter().all(|w| told.contains(w)), "{args:?}: {told}");
    }
}
