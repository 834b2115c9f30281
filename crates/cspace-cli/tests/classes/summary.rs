//! What `info` and `compute` say of every class.

use serde_json::{Value, json as value};

use crate::helpers::{PAIRS, json, mechanism, model, printed};

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
