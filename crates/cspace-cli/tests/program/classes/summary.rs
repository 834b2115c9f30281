//! The answers of `info` and `compute` for every class of pairs.

use serde_json::{Value, json as value};

use crate::helpers::{PAIRS, cspace, json, mechanism, model, printed, unframed};

#[test]
fn every_pair_of_the_mechanism_has_its_class() {
    let file = mechanism();
    let info = json(&["info", &file]);
    let all = json(&["compute", &file]);
    for (list, what) in [(&info["pairs"], "info"), (&all, "compute")] {
        let found: Vec<(String, &str)> = (list.as_array().unwrap().iter())
            .map(|p| {
                let name = |key: &str| p[key].as_str().unwrap();
                (
                    format!("{},{}", name("fixed"), name("moving")),
                    name("class"),
                )
            })
            .collect();
        let found: Vec<(&str, &str)> = found.iter().map(|(n, c)| (n.as_str(), *c)).collect();
        assert_eq!(found, PAIRS, "{what}");
    }
    assert_eq!(info["joints"].as_array().unwrap().len(), 4);
}

/// The keys of the contract are there for pairs of every class, and mean what they should.
#[test]
fn compute_has_the_keys_of_the_contract_for_every_class() {
    let all = json(&["compute", &mechanism()]);
    for pair in all.as_array().unwrap() {
        let name = &pair["moving"];
        for key in ["fixed", "moving", "class"] {
            assert!(pair[key].is_string(), "{name}: {key}");
        }
        let critical = pair["critical_orientations"].as_array().unwrap().len();
        let counts = [
            "/features/fixed",
            "/features/moving",
            "/features/total",
            "/symmetry/fixed",
            "/symmetry/moving",
            "/bands",
            "/slices",
            "/patches",
            "/links/side",
            "/links/vertical",
            "/free_regions",
        ]
        .map(|key| pair.pointer(key).and_then(Value::as_u64).expect(key));
        let [
            fixed,
            moving,
            total,
            _,
            _,
            bands,
            slices,
            patches,
            side,
            vertical,
            regions,
        ] = counts;
        assert_eq!(fixed + moving, total);
        assert!(pair["seconds"]["total"].as_f64().unwrap() > 0.0);
        match pair["class"].as_str().unwrap() {
            "lower" => {
                assert_eq!((critical, bands, slices, patches), (0, 1, 0, 1), "{name}");
                assert_eq!((side, vertical, regions), (0, 0, 0), "{name}");
                let permanent = &pair["motion"]["permanent"][0];
                assert_eq!(permanent["permanent"], true);
                assert_eq!(permanent["kind"], "point-arc");
            }
            "fixed-axes" => {
                // The fork touches the eccentric on either side, in front of its middle and behind: closed curves.
                assert_eq!((critical, bands, slices, vertical), (0, 1, 1, 0));
                assert_eq!((patches, side, regions), (4, 4, 1));
            }
            "symmetric" => {
                assert_eq!(bands, 20 * slices, "one slab of twenty was computed");
                assert_eq!(bands as usize, critical);
                assert_eq!(pair["symmetry"], value!({ "fixed": 20, "moving": 1 }));
                assert_eq!((side > 0, vertical > 0, regions), (true, true, 1));
            }
            other => panic!("{other}"),
        }
    }
}

#[test]
fn the_general_method_can_be_asked_for_whatever_the_class() {
    let file = mechanism();
    for (pair, class) in PAIRS {
        let args = [&file, "--pair", pair, "--general"];
        let info = json(&[&["info"], &args[..]].concat());
        assert_eq!(info["pairs"][0]["class"], "general", "{pair}");
        if pair == "frame,ratchet" {
            continue; // As the others, and the slowest of them.
        }
        let general = json(&[&["compute"], &args[..]].concat());
        assert_eq!(general[0]["class"], "general", "{pair}");
        assert_eq!(general[0]["slices"], general[0]["bands"]);
        let text = printed(&[&["compute"], &args[..]].concat());
        assert_eq!(
            text.contains(&format!("the pair's class is {class}")),
            class != "symmetric",
            "{text}"
        );
    }
}

#[test]
fn the_models_on_fixed_axes_have_the_regions_that_their_readme_tells() {
    for (name, regions, around) in [
        ("cam_tappet", 1, true),
        ("cam_plate", 1, false),
        ("escapement", 1, true),
        ("geneva", 1, true),
        ("rack_pinion", 12, false),
        ("gears_on_shafts", 2, true),
    ] {
        let pair = &json(&["compute", &model(name)])[0];
        assert_eq!(pair["class"], "fixed-axes", "{name}");
        assert_eq!(pair["free_regions"], regions, "{name}");
        let list = pair["regions"].as_array().unwrap();
        assert_eq!(list.len(), regions, "{name}");
        assert!(list.iter().all(|r| r["around_u"] == around), "{name}");
    }
}

/// A window is for the pairs that have orientations; the others are as they are, and a note tells it.
#[test]
fn a_window_passes_over_pairs_without_orientations() {
    let file = mechanism();
    let run = |args: &[&str]| {
        let args = [args, &["--format", "json"]].concat();
        let output = cspace(&args).assert().success().get_output().clone();
        let said = String::from_utf8(output.stderr).unwrap();
        (
            unframed(args[0], serde_json::from_slice(&output.stdout).unwrap()),
            said,
        )
    };
    let (all, said) = run(&["compute", &file, "--window=-0.1,0.1"]);
    assert_eq!(said.lines().count(), 1, "{said}");
    for (pair, class) in &PAIRS[..5] {
        assert!(said.contains(&format!("{pair} ({class})")), "{said}");
    }
    assert!(said.starts_with("note: --window is not used") && !said.contains("ratchet,pawl"));
    let plain = json(&["compute", &file]);
    for i in 0..6 {
        let timeless = |value: &Value| {
            let mut pair = value[i].clone();
            pair["seconds"] = Value::Null;
            pair
        };
        assert_eq!(timeless(&all) == timeless(&plain), i < 5, "{i}");
    }
    assert_eq!(all[5]["window"]["lo"], -0.1);
    // `info` shows the window that would be used, and where.
    let (info, told) = run(&["info", &file, "--window=-0.1,0.1"]);
    assert_eq!(told, said);
    for i in 0..6 {
        let theta = &info["pairs"][i]["theta"];
        let expected = if i < 5 {
            Value::Null
        } else {
            value!([-0.1, 0.1])
        };
        assert_eq!(theta, &expected, "{i}");
    }
    // All have orientations by the general method.
    let (general, told) = run(&["info", &file, "--window=-0.1,0.1", "--general"]);
    assert_eq!(
        (told.as_str(), &general["pairs"][0]["theta"]),
        ("", &value!([-0.1, 0.1]))
    );
    let text = printed(&["info", &model("ratchet_pawl"), "--window=-0.1,0.1"]);
    assert!(
        text.contains("theta from -0.100000 rad (-5.7296 deg) to 0.100000 rad"),
        "{text}"
    );
}

/// `info` and `compute` say the same of a part's symmetry.
#[test]
fn symmetry_is_told_in_the_same_words() {
    let mut round = 0;
    for (name, pair) in [
        ("ball_in_c", 0),
        ("gears_on_shafts", 0),
        ("geneva", 0),
        ("ratchet_mechanism", 4),
        ("ratchet_mechanism", 5),
        ("ratchet_pawl", 0),
    ] {
        let file = model(name);
        let pair = &json(&["info", &file])["pairs"][pair];
        let (fixed, moving) = (
            pair["fixed"].as_str().unwrap(),
            pair["moving"].as_str().unwrap(),
        );
        let info = printed(&["info", &file]);
        let told = |part: &str| {
            let from = info.find(&format!("\n  {part}\n")).unwrap();
            let lines = info[from..]
                .lines()
                .skip(2)
                .take_while(|l| l.starts_with("    "));
            let words = lines.filter_map(|l| l.strip_prefix("    symmetry   "));
            words.last().unwrap_or("none").to_owned()
        };
        let expected = format!("  symmetry       {}, {}\n", told(fixed), told(moving));
        let text = printed(&["compute", &file, "--pair", &format!("{fixed},{moving}")]);
        assert!(
            text.contains(&expected),
            "{name}: no {expected:?} in {text}"
        );
        round += expected.matches("round").count();
    }
    assert_eq!(round, 2);
}

/// Missing values are null or left out, never the sentinel numbers that mark them in memory.
#[test]
fn no_output_has_a_mark_for_none() {
    for (name, pair, theta) in [
        ("ratchet_mechanism", "ratchet,pawl", true),
        ("ratchet_mechanism", "driver,link", false),
        ("cam_plate", "plate,pin", false),
        ("peg_hole", "block,peg", true),
    ] {
        let pair = [model(name), "--pair".to_owned(), pair.to_owned()];
        let [file, flag, names] = pair.each_ref().map(String::as_str);
        let slice = ["slice", file, flag, names, "--theta", "0.3"];
        let slice = if theta { &slice[..] } else { &slice[..4] };
        for args in [
            &["info", file, flag, names][..],
            &["compute", file, flag, names],
            slice,
        ] {
            let text = json(args).to_string();
            assert!(!text.contains("4294967295") && !text.contains("18446744073709551615"));
        }
    }
}

/// The class is told by the parts: `info` and `compute` say the same, also where symmetry saves no work.
#[test]
fn a_symmetric_pair_is_one_also_where_nothing_is_copied() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("pins.toml");
    // Three pins as circles are drawn: their halves meet on the right and on the left of each.
    let pins = (0..3)
        .map(|i| {
            let (y, x) = (f64::from(i) * std::f64::consts::TAU / 3.0).sin_cos();
            format!("[[{}, {y}, 1], [{}, {y}, 1]]", x + 0.2, x - 0.2)
        })
        .collect::<Vec<_>>()
        .join(", ");
    let text = format!(
        "[[part]]\nname = 'pins'\nloops = [{pins}]\n\
         [[part]]\nname = 'tooth'\nloops = [[[0, 0], [0.3, 0], [0, 0.2]]]\n"
    );
    std::fs::write(&file, text).unwrap();
    let pins = file.to_str().unwrap();
    for (args, why) in [
        (vec![pins], "are drawn in halves"),
        (
            vec![&*model("ratchet_pawl"), "--window", "0,0.1"],
            "the window is within one",
        ),
    ] {
        let info = json(&[&["info"], &args[..]].concat());
        assert_eq!(info["pairs"][0]["class"], "symmetric", "{args:?}");
        let all = json(&[&["compute"], &args[..]].concat());
        assert_eq!(all[0]["class"], "symmetric", "{args:?}");
        assert_eq!(all[0]["slices"], all[0]["bands"], "{args:?}");
        let text = printed(&[&["compute"], &args[..]].concat());
        assert!(text.contains("symmetric, but nothing is a copy"), "{text}");
        assert!(text.contains(why), "{text}");
    }
}
