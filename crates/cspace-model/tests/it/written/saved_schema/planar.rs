//! Contact spaces.

use cspace::space::SAVED_VERSION;
use cspace::{ContactSpace, Options};
use cspace_model::{model, saved};
use cspace_oracle::Schema;
use serde_json::{Value, json};

use super::helpers::{ROOT, has_no_mark, objects, schema};

const NAME: &str = "contact-space";
const SCHEMA: Schema = Schema::new(NAME);

fn space(model: &str, window: Option<(f64, f64)>) -> ContactSpace {
    let model = model::read(format!("{ROOT}/models/{model}.toml")).unwrap();
    let pair = &model.pairs[0];
    let part = |i: usize| &model.parts[i].part;
    let window = window.or(pair.window);
    ContactSpace::compute(
        part(pair.fixed),
        part(pair.moving),
        &Options {
            window,
            ..Options::default()
        },
    )
    .unwrap()
}

fn as_json(space: &ContactSpace) -> Value {
    serde_json::from_str(&saved::to_json(space)).unwrap()
}

#[test]
fn the_schema_names_format_and_version() {
    let schema = schema(NAME);
    assert_eq!(
        schema["properties"]["version"],
        json!({
            "description": "The version of the format. A program reads its own version only.",
            "const": SAVED_VERSION,
        })
    );
    assert_eq!(
        schema["properties"]["format"]["const"],
        space("ball_in_c", None).data().format
    );
}

#[test]
fn exports_of_shipped_models_and_of_hard_pairs_follow_the_schema() {
    let check = |name: &str, space: &ContactSpace| {
        let value = as_json(space);
        SCHEMA.takes(&value, name);
        has_no_mark(&value, name);
        // And they are read, as the same.
        let again = saved::from_json(&value.to_string(), name).unwrap();
        assert_eq!(again.data(), space.data(), "{name}");
    };
    for model in [
        "ball_in_c",
        "cam_follower",
        "fixture_plate",
        "geneva",
        "knee",
        "peg_hole",
        "ratchet_pawl",
        "snap_fastener",
    ] {
        check(model, &space(model, None));
    }
    for (lo, hi) in [(-0.3, 2.0), (100.0, 101.0), (-0.1, 0.1)] {
        check("window", &space("peg_hole", Some((lo, hi))));
    }
    let mut kinds = std::collections::BTreeSet::new();
    for pair in cspace_oracle::pairs()
        .into_iter()
        .step_by(cspace_oracle::effort(2, 1))
    {
        let size = |p: &cspace::Part| p.loops().iter().map(|l| l.vertices().len()).sum::<usize>();
        if size(&pair.fixed) * size(&pair.moving) > 1000 {
            continue;
        }
        let Ok(space) = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default())
        else {
            continue;
        };
        check(&pair.name, &space);
        for patch in as_json(&space)["patches"].as_array().unwrap() {
            kinds.insert(patch["function"]["kind"].to_string());
            kinds.insert(patch["left"]["kind"].to_string());
            kinds.insert(patch["fixed"]["kind"].to_string());
        }
    }
    // All that the schema tells apart has been there.
    assert_eq!(kinds.len(), 4 + 2 + 4, "{kinds:?}");
}

#[test]
fn the_schema_refuses_what_is_damaged() {
    let good = as_json(&space("ball_in_c", None));
    SCHEMA.takes(&good, "undamaged");
    let set = |pointer: &str, to: Value| {
        let mut bad = good.clone();
        *bad.pointer_mut(pointer).unwrap() = to;
        bad
    };
    for (pointer, to) in [
        ("/format", json!("contact_space")),
        ("/version", json!(SAVED_VERSION + 1)),
        ("/fixed/loops/0/0/x", json!("0")),
        ("/fixed/loops/0", json!([])),
        ("/moving/name", json!(7)),
        ("/window/full_turn", json!(1)),
        ("/frame/scale", json!(0)),
        ("/critical_orientations/0", Value::Null),
        ("/patches/0/fixed/kind", json!("edge")),
        ("/patches/0/fixed/index", json!(-1)),
        ("/patches/0/function/kind", json!("end")),
        ("/patches/0/lo", Value::Null),
        ("/patches/0/region", json!(0.5)),
        ("/side_links/0/before", json!(-1)),
        ("/vertical_links/0/overlap", json!({})),
        ("/free_regions/0/unbounded", json!("yes")),
        ("/statistics/cells", json!(-1)),
    ] {
        SCHEMA.refuses(&set(pointer, to), pointer);
    }
    // Every key is needed but those that files of earlier versions lack, and there are no others, except among the
    // statistics.
    const LATER: [&str; 5] = [
        "/checksum",
        "/symmetry",
        "/computed_bands",
        "/doubtful_orientations",
        "/statistics/decisions",
    ];
    let all = objects(&good);
    assert!(all.len() > 30);
    for at in all {
        let map = |value: &mut Value, f: &dyn Fn(&mut serde_json::Map<String, Value>)| {
            f(value.pointer_mut(&at).unwrap().as_object_mut().unwrap());
        };
        let mut more = good.clone();
        map(&mut more, &|m| drop(m.insert("extra".into(), json!(1))));
        SCHEMA.case(&more, at.starts_with("/statistics"), &format!("{at}/extra"));
        let keys: Vec<String> = (good.pointer(&at).unwrap().as_object().unwrap())
            .keys()
            .cloned()
            .collect();
        for key in keys {
            let mut fewer = good.clone();
            map(&mut fewer, &|m| drop(m.remove(&key)));
            let later = LATER.contains(&format!("{at}/{key}").as_str());
            SCHEMA.case(&fewer, later, &format!("without {at}/{key}"));
            if later {
                saved::from_json(&fewer.to_string(), "m.json").unwrap();
            }
        }
    }
}
