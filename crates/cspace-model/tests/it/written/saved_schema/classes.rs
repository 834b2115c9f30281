//! Lower pairs and pairs with fixed axes.

use std::collections::BTreeSet;

use cspace::fixed_axes::SAVED_AXES_VERSION;
use cspace::pair::Joint;
use cspace::space::SAVED_VERSION;
use cspace::{Axis, FixedAxesSpace, LowerPair, Options, PairClass, PairSpace, Point, Vector};
use cspace_model::{model, saved};
use cspace_oracle::Schema;
use cspace_oracle::shapes::mechanisms::mechanisms;
use cspace_oracle::shapes::{rectangle, square};
use serde_json::{Value, json};

use super::helpers::{ROOT, has_no_mark, objects, schema};

/// The saved form follows the schema, and is read again as the same.
fn follows(schema: Schema, name: &str, space: &PairSpace) -> Value {
    let text = saved::pair_to_json(space);
    let value: Value = serde_json::from_str(&text).unwrap();
    schema.takes(&value, name);
    has_no_mark(&value, name);
    let again = saved::pair_from_json(&value.to_string(), name).unwrap();
    assert_eq!(saved::pair_to_json(&again), text, "{name}");
    value
}

fn lower_pairs() -> Vec<PairSpace> {
    let at = Point::new(1.5, -0.25);
    let joints = [
        (Joint::Revolute { at }, None),
        (Joint::Revolute { at }, Some((-1.0, 2.5))),
        (
            Joint::Prismatic {
                direction: Vector::new(3.0, -4.0),
                at,
            },
            Some((0.0, 12.0)),
        ),
    ];
    joints
        .map(|(joint, limits)| {
            let pair = LowerPair::new(&square(3.0), &rectangle(2.0, 1.0), joint, limits);
            PairSpace::Lower(Box::new(pair))
        })
        .into()
}

fn fixed_axes(fixed: Axis, moving: Axis) -> PairSpace {
    let (a, b) = (square(3.0), rectangle(2.0, 1.0));
    let space = FixedAxesSpace::compute(&a, fixed, &b, moving).unwrap();
    PairSpace::FixedAxes(Box::new(space))
}

#[test]
fn schemas_name_format_and_version() {
    for (name, version) in [
        ("fixed-axes-space", SAVED_AXES_VERSION),
        ("lower-pair", SAVED_VERSION),
        ("contact-space", SAVED_VERSION),
    ] {
        let schema = schema(name);
        assert_eq!(schema["properties"]["format"]["const"], name);
        assert_eq!(schema["properties"]["version"]["const"], version);
        assert_eq!(schema["$id"], format!("urn:cspace:{name}:{version}"));
    }
}

#[test]
fn lower_pairs_follow_their_schema() {
    let schema = Schema::new("lower-pair");
    for space in lower_pairs() {
        follows(schema, "lower pair", &space);
    }
}

#[test]
fn shipped_models_and_mechanisms_follow_the_schema_of_fixed_axes() {
    let schema = Schema::new("fixed-axes-space");
    let mut kinds = BTreeSet::new();
    let mut check = |name: &str, space: &PairSpace| {
        let value = follows(schema, name, space);
        gather(&value, &mut kinds);
    };
    for name in ["cam_plate", "cam_tappet", "geneva", "ratchet_mechanism"] {
        let model = model::read(format!("{ROOT}/models/{name}.toml")).unwrap();
        let pair = (model.pairs.iter())
            .find(|p| model.pair_class(p) == PairClass::FixedAxes)
            .unwrap();
        let part = |i: usize| &model.parts[i].part;
        let (a, b) = (part(pair.fixed), part(pair.moving));
        let options = Options::default();
        let space = PairSpace::compute(a, b, model.relation(pair), &options).unwrap();
        check(name, &space);
    }
    for m in mechanisms() {
        let space = FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis);
        check(&m.name, &PairSpace::FixedAxes(Box::new(space.unwrap())));
    }
    let turning = Axis::revolute(Point::new(2.0, 0.0));
    let sliding = Axis::prismatic(Vector::new(0.0, 2.0));
    for moving in [
        Axis::FIXED,
        turning,
        turning.within(-1.0, 9.0),
        sliding,
        sliding.within(0.0, 1.0),
    ] {
        check("fixed", &fixed_axes(Axis::FIXED, moving));
        check("moving", &fixed_axes(moving, Axis::FIXED));
    }
    // All that the schema tells apart has been there.
    let words = [
        "fixed",
        "revolute",
        "prismatic",
        "v-of-u",
        "u-of-v",
        "Still",
        "Turn",
        "Slide",
        "Circle",
        "TurnLimits",
        "SlideLimits",
        "Open",
        "FirstLine",
        "SecondLine",
        "Circles",
        "Node",
        "Crossing",
        "Limit",
        "Same",
        "Turning",
        "FirstJoint",
        "SecondJoint",
        "JointLine",
        "LineJoint",
        "Vertices",
        "Lines",
    ];
    let missing: Vec<&str> = words.into_iter().filter(|w| !kinds.contains(*w)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Collects all keys, and all values that are text.
fn gather(value: &Value, all: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            all.extend(map.keys().filter(|k| *k != "fixed").cloned());
            map.values().for_each(|v| gather(v, all));
        }
        Value::Array(list) => list.iter().for_each(|v| gather(v, all)),
        Value::String(text) => drop(all.insert(text.clone())),
        _ => {}
    }
}

/// Sets what a pointer points to, and asks whether that is refused.
fn refuses(schema: Schema, good: &Value, changes: &[(&str, Value)]) {
    schema.takes(good, "undamaged");
    for (pointer, to) in changes {
        let mut bad = good.clone();
        *bad.pointer_mut(pointer).unwrap() = to.clone();
        schema.refuses(&bad, pointer);
    }
}

/// Every key is needed, and there are no others except among the statistics.
fn wants_every_key(schema: Schema, good: &Value) {
    for at in objects(good) {
        let object = |value: &mut Value| -> serde_json::Map<String, Value> {
            value.pointer(&at).unwrap().as_object().unwrap().clone()
        };
        let with = |map: serde_json::Map<String, Value>, is_valid: bool, what: &str| {
            let mut changed = good.clone();
            *changed.pointer_mut(&at).unwrap() = Value::Object(map);
            schema.case(&changed, is_valid, what);
        };
        let whole = object(&mut good.clone());
        let mut more = whole.clone();
        more.insert("extra".into(), json!(1));
        with(more, at == "/statistics", &format!("{at}/extra"));
        for key in whole.keys() {
            let mut fewer = whole.clone();
            fewer.remove(key);
            with(fewer, false, &format!("without {at}/{key}"));
        }
    }
}

#[test]
fn the_schema_of_lower_pairs_refuses_what_is_damaged() {
    let schema = Schema::new("lower-pair");
    let saved = |space: &PairSpace| serde_json::to_value(space.data()).unwrap();
    let pairs = lower_pairs();
    for pair in &pairs {
        wants_every_key(schema, &saved(pair));
    }
    refuses(
        schema,
        &saved(&pairs[1]),
        &[
            ("/format", json!("lower")),
            ("/version", json!(SAVED_VERSION + 1)),
            ("/fixed/loops", json!([])),
            ("/joint/type", json!("planar")),
            ("/joint/at/x", Value::Null),
            ("/limits", json!([0.0])),
            ("/limits/0", json!("-1")),
            ("/contacts/0/kind", json!("arc-arc")),
            ("/contacts/0/permanent", json!(false)),
        ],
    );
}

#[test]
fn the_schema_of_fixed_axes_refuses_what_is_damaged() {
    let schema = Schema::new("fixed-axes-space");
    let space = fixed_axes(
        Axis::revolute(Point::ORIGIN),
        Axis::prismatic(Vector::new(1.0, 0.0)).within(-4.0, 4.0),
    );
    let good = serde_json::to_value(space.data()).unwrap();
    wants_every_key(schema, &good);
    refuses(
        schema,
        &good,
        &[
            ("/format", json!("contact-space")),
            ("/version", json!(SAVED_AXES_VERSION + 1)),
            ("/moving/loops/0", json!([])),
            ("/fixed_axis/motion/type", json!("planar")),
            ("/moving_axis/range", json!([1])),
            ("/patches/0/fixed/kind", json!("edge")),
            ("/patches/0/branches/start", json!(-1)),
            ("/patches/0/next", json!(0.5)),
            ("/branches/0/form", json!("w-of-u")),
            ("/branches/0/start", json!([0, 1, 2])),
            ("/free_regions/0/around_u", json!(1)),
            ("/map/x_unit", json!(0)),
            ("/x/kind", json!("circle")),
            ("/pairs/0", json!([0, 0])),
            ("/pairs/0/2", json!({ "Circles": {} })),
            ("/pieces/0/root", json!(2)),
            ("/pieces/0/start/key/name", json!("Joint")),
            ("/cells/0/from", Value::Null),
            ("/free/0", json!(1)),
            ("/bands", json!([])),
            ("/gaps/0/turns", json!([0])),
        ],
    );
}
