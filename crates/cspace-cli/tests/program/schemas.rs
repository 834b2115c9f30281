//! The output of `--json` conforms to the schemas in `docs/answers/`.

use cspace_oracle::Schema;
use serde_json::Value;

use crate::helpers::{cspace, framed, mechanism, model};

const ALLOCATION: Schema = Schema::new("answers/allocation");
const ALONG: Schema = Schema::new("answers/along");
const CHECK: Schema = Schema::new("answers/check");
const CLEARANCE: Schema = Schema::new("answers/clearance");
const CLASSIFY: Schema = Schema::new("answers/classify");
const COMPUTE: Schema = Schema::new("answers/compute");
const DISASSEMBLE: Schema = Schema::new("answers/disassemble");
const ENERGY: Schema = Schema::new("answers/energy");
const ERROR: Schema = Schema::new("answers/error");
const IMPORT: Schema = Schema::new("answers/import");
const INFO: Schema = Schema::new("answers/info");
const MODES: Schema = Schema::new("answers/modes");
const PLAN: Schema = Schema::new("answers/plan");
const PLAY: Schema = Schema::new("answers/play");
const SIMULATE: Schema = Schema::new("answers/simulate");
const SLICE: Schema = Schema::new("answers/slice");
const SWEEP: Schema = Schema::new("answers/sweep");
const TOLERANCES: Schema = Schema::new("answers/tolerances");
const WRITTEN: Schema = Schema::new("answers/written");
const ZONES: Schema = Schema::new("answers/zones");

/// An answer is as its schema says, and is not with a key renamed or left out, in its frame and in what is in that.
fn is_told(schema: Schema, answer: &Value) {
    schema.takes(answer, "answer");
    for (change, what) in [(rename as Change, "renamed"), (leave_out, "left out")] {
        let mut changed = answer.clone();
        change(changed.as_object_mut().unwrap());
        schema.refuses(&changed, what);
        for list in ["pairs", "requirements"] {
            let mut changed = answer.clone();
            if let Some(first) = changed[list].as_array_mut().and_then(|a| a.first_mut()) {
                change(first.as_object_mut().unwrap());
                schema.refuses(&changed, what);
            }
        }
    }
}

type Change = fn(&mut serde_json::Map<String, Value>);

fn rename(object: &mut serde_json::Map<String, Value>) {
    let (key, value) = object
        .iter()
        .next_back()
        .map(|(k, v)| (k.clone(), v.clone()))
        .unwrap();
    object.remove(&key);
    object.insert(format!("{key}_"), value);
}

fn leave_out(object: &mut serde_json::Map<String, Value>) {
    // A name may be missing; what the answer is about may not.
    let key = ["fixed", "outcome", "stations", "class", "error"]
        .into_iter()
        .find(|k| object.contains_key(*k));
    object.remove(key.unwrap());
}

/// The answer of a run that may print notes to stderr.
fn beside_notes(args: &[&str]) -> Value {
    let output = cspace(&[args, &["--json"]].concat()).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
#[ignore = "for another program: `.ci/run` lets `.ci/others` judge"]
fn answers_are_as_their_schemas_say() {
    let models = [
        "ratchet_pawl",
        "gears_on_shafts",
        "snap_fastener",
        "cam_tappet",
        "fixture_plate",
    ];
    let files = models.map(model).into_iter().chain([mechanism()]);
    for file in files {
        is_told(COMPUTE, &framed(&["compute", &file]));
        is_told(INFO, &framed(&["info", &file]));
        is_told(PLAY, &framed(&["play", &file]));
    }
    is_told(CHECK, &framed(&["check", &model("ratchet_pawl")]));
    let lock = model("tolerances/geneva_lock");
    is_told(
        TOLERANCES,
        &framed(&["tolerances", &lock, "--samples", "100"]),
    );
    is_told(ALONG, &framed(&["tolerances", &lock, "--along", "u=0:1:2"]));
    let zones = framed(&["tolerances", &lock, "--zones"]);
    is_told(ZONES, &zones);
    let allocated = framed(&["tolerances", &lock, "--allocate", "worst"]);
    is_told(ALLOCATION, &allocated);
    let dir = tempfile::tempdir().unwrap();
    let moving = dir.path().join("moving.toml");
    std::fs::write(&moving, crate::info::MODEL).unwrap();
    is_told(INFO, &framed(&["info", moving.to_str().unwrap()]));
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../cspace-drawing/tests/drawings"
    );
    for name in ["small_gaps.dxf", "texts_and_dimensions.dxf", "shapes.svg"] {
        is_told(IMPORT, &framed(&["import", &format!("{folder}/{name}")]));
    }
    let (planar, axes) = (model("ratchet_pawl"), model("gears_on_shafts"));
    is_told(SLICE, &framed(&["slice", &planar, "--theta", "0.2"]));
    is_told(COMPUTE, &framed(&["compute", &planar, "--window=-0.1,0.1"]));
    for at in ["0,0,0", "90,0,0", "41,56,0.05"] {
        let args = ["play", &planar, "--at", at, "--touch", "20"];
        is_told(PLAY, &framed(&args));
        is_told(PLAY, &framed(&[&args[..], &["--by=-50,0,0"]].concat()));
    }
    for at in ["0,0", "0,0.1"] {
        let args = ["play", &axes, "--at", at, "--touch", "1", "--by=0,1"];
        is_told(PLAY, &framed(&args));
    }
    is_told(SLICE, &framed(&["slice", &axes]));
    let tip = ["sweep", &planar, "--vary", "tip=49:50:2"];
    is_told(SWEEP, &framed(&tip));
    is_told(SWEEP, &framed(&[&tip[..], &["--changes"]].concat()));
    let columns = "class,region,distance,touching";
    let args = ["classify", &axes, "--json", "--columns", columns];
    let output = cspace(&args)
        .write_stdin("u,v\n0,0\n0,0.3\n")
        .output()
        .unwrap();
    is_told(CLASSIFY, &serde_json::from_slice(&output.stdout).unwrap());
    let output = cspace(&["info", "nothing.toml", "--json"])
        .output()
        .unwrap();
    is_told(ERROR, &serde_json::from_slice(&output.stdout).unwrap());
    is_told(INFO, &framed(&["info", &planar, &axes]));
    is_told(COMPUTE, &framed(&["compute", &planar, &axes]));
    let (peg, ball) = (model("peg_hole"), model("ball_in_c"));
    let plan = |file: &str, from: &str, to: &str, more: &[&str]| {
        let args = ["plan", file, "--from", from, "--to", to];
        is_told(PLAN, &framed(&[&args[..], more].concat()));
    };
    plan(&peg, "40,30,90deg", "0,2,0", &[]);
    plan(&peg, "40,30,90deg", "0,2,0", &["--widest"]);
    plan(&peg, "40,30,90deg", "0,2,0", &["--clearance", "1"]);
    plan(&peg, "40,30,90deg", "0,-10,0", &[]);
    plan(&ball, "0,0,0", "60,0,0", &[]);
    plan(&ball, "0,0,0", "60,0,0", &["--depth", "1"]);
    plan(
        &ball,
        "0,0,0",
        "60,0,0",
        &["--window", "0,1", "--depth", "1"],
    );
    plan(&axes, "0,0", "30deg,-36deg", &[]);
    plan(&axes, "0,0", "75deg,18deg", &["--depth", "1"]);
    let gravity = ["--gravity", "0,-1"];
    let escape = |file: &str, from: &str| {
        let args = ["plan", file, "--energy", "--from", from];
        is_told(ENERGY, &framed(&[&args[..], &gravity].concat()));
    };
    escape(&ball, "0,0,0");
    escape(&ball, "60,0,0");
    escape(&peg, "0,-10,0");
    let driven = ["geneva", "ratchet_mechanism"].map(model);
    for file in &driven {
        is_told(SIMULATE, &framed(&["simulate", file, "--time", "1"]));
    }
    let jam = dir.path().join("jam.toml");
    std::fs::write(&jam, crate::simulate::JAM).unwrap();
    let jam = jam.to_str().unwrap();
    is_told(
        SIMULATE,
        &framed(&["simulate", jam, "--time", "9", "--rates"]),
    );
    for name in ["latch_box", "ratchet_mechanism"] {
        is_told(CLEARANCE, &beside_notes(&["clearance", &model(name)]));
    }
    let record = dir.path().join("record.json");
    let record = record.to_str().unwrap();
    let drawing = dir.path().join("drawing.svg");
    let drawn = ["draw", &planar, "-o", drawing.to_str().unwrap()];
    is_told(WRITTEN, &framed(&drawn));
    cspace(&["simulate", &driven[0], "--time", "0.2", "-o", record])
        .assert()
        .success();
    let bytes = std::fs::read(record).unwrap();
    is_told(SIMULATE, &serde_json::from_slice(&bytes).unwrap());
    is_told(
        CLEARANCE,
        &framed(&["clearance", &driven[0], "--along", record, "--within", "9"]),
    );
    let interlock = model("shift_interlock");
    for at in ["u=0", "u=8,w=8"] {
        is_told(MODES, &framed(&["modes", &interlock, "--at", at]));
    }
    is_told(MODES, &framed(&["modes", &model("ratchet_mechanism")]));
    for name in ["latch_box", "fixture_plate"] {
        is_told(DISASSEMBLE, &framed(&["disassemble", &model(name)]));
    }
}

/// The schemas in `docs/answers` are those of the types; with `CSPACE_DOCS=write` they are written.
#[test]
fn schemas_are_made_of_the_types() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/answers");
    for (name, schema) in cspace_api::schemas::schemas() {
        let path = format!("{folder}/{name}.schema.json");
        let text = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        if std::env::var("CSPACE_DOCS").is_ok_and(|v| v == "write") {
            std::fs::write(path, text).unwrap();
        } else {
            let kept = std::fs::read_to_string(&path).unwrap_or_default();
            assert!(
                kept == text,
                "{path} is not that of the types: CSPACE_DOCS=write writes it"
            );
        }
    }
}
