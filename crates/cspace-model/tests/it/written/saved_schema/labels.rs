//! Labels that a saved space repeats from its model: its name, and its unit of length.

use cspace::{Options, PairSpace};
use cspace_model::{SavedFile, model, saved};
use cspace_oracle::Schema;
use serde_json::{Value, json};

use super::helpers::ROOT;

/// A space of each class, with the name of its format.
fn spaces() -> Vec<(&'static str, SavedFile)> {
    let model = model::read(format!("{ROOT}/models/ratchet_mechanism.toml")).unwrap();
    [
        ("lower-pair", 0),
        ("fixed-axes-space", 4),
        ("contact-space", 5),
    ]
    .map(|(format, i)| {
        let pair = &model.pairs[i];
        let part = |i: usize| &model.parts[i].part;
        let options = Options {
            window: Some((-0.1, 0.1)).filter(|_| format == "contact-space"),
            ..Options::default()
        };
        let (a, b) = (part(pair.fixed), part(pair.moving));
        let space = PairSpace::compute(a, b, model.relation(pair), &options).unwrap();
        let (name, unit) = (Some(model.name.clone()), model.unit.clone());
        (format, SavedFile { space, name, unit })
    })
    .into()
}

fn value(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn labels_follow_the_schema_and_are_read_again() {
    for (format, mut file) in spaces() {
        let schema = Schema::new(format);
        for (name, unit) in [
            (Some("ratchet mechanism"), Some("mm")),
            (Some("Räder & \"Klinke\" <1>"), None),
            (None, Some("µm")),
            (Some(""), Some("")),
            (None, None),
        ] {
            (file.name, file.unit) = (name.map(str::to_owned), unit.map(str::to_owned));
            let text = file.to_json();
            schema.takes(&value(&text), "labels");
            let again = SavedFile::from_json(&text, "space.json").unwrap();
            assert_eq!((again.name.as_deref(), again.unit.as_deref()), (name, unit));
            assert_eq!(again.to_json(), text, "{format}");
            // The labels are all there is to tell.
            let mut bare = value(&text);
            for key in ["name", "unit"] {
                let there = bare.as_object_mut().unwrap().remove(key).is_some();
                assert_eq!(there, [name, unit][usize::from(key == "unit")].is_some());
            }
            assert_eq!(bare, value(&saved::pair_to_json(&file.space)), "{format}");
        }
    }
}

#[test]
fn labels_and_names_are_plain_text() {
    for (format, file) in spaces() {
        let schema = Schema::new(format);
        let good = value(&file.to_json());
        for (pointer, to, words) in [
            (
                "/name",
                json!("a\u{1b}[31mb"),
                ["the name", r"a\u{1b}[31mb"],
            ),
            ("/unit", json!("m\nm"), ["the unit", r"m\nm"]),
            ("/fixed/name", json!("a\u{7f}"), ["fixed part", r"a\u{7f}"]),
            ("/moving/name", json!("\u{9b}"), ["moving part", r"\u{9b}"]),
            ("/name", json!(7), ["\"name\"", "no text"]),
            ("/unit", json!(["mm"]), ["\"unit\"", "no text"]),
        ] {
            let mut bad = good.clone();
            *bad.pointer_mut(pointer).unwrap() = to;
            schema.refuses(&bad, pointer);
            let error = SavedFile::from_json(&bad.to_string(), "space.json").unwrap_err();
            let said = error.to_string();
            assert!(words.iter().all(|w| said.contains(w)), "{pointer}: {said}");
            assert!(!said.contains(char::is_control), "{pointer}: {said:?}");
            assert!(error.help().unwrap().contains("cspace export"));
        }
    }
}

#[test]
fn orientations_far_from_0_are_refused() {
    for (_, file) in spaces() {
        let mut bad = value(&file.to_json());
        let pointers: &[&str] = match &file.space {
            PairSpace::Planar(_) => &["/window"],
            PairSpace::FixedAxes(_) => &["/moving_axis/range"],
            PairSpace::Lower(_) => &["/limits"],
        };
        for pointer in pointers {
            let place = bad.pointer_mut(pointer).unwrap();
            *place = match place {
                Value::Object(window) => {
                    window["lo"] = json!(1e9);
                    window["hi"] = json!(1e9 + 1.0);
                    window["full_turn"] = json!(true);
                    place.clone()
                }
                _ => json!([1e9, 1e9 + 1.0]),
            };
        }
        let error = SavedFile::from_json(&bad.to_string(), "space.json").unwrap_err();
        let said = error.to_string();
        assert!(
            said.contains("the angle 1000000000 rad is more than 1e6 rad from 0"),
            "{said}"
        );
    }
}
