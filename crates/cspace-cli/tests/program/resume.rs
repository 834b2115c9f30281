//! `cspace simulate --resume`: motions that go on where a record ends.

use serde_json::Value;

use crate::helpers::{cspace, fails, model, printed};

/// A motion that is taken up where a record ends goes on as if there had been no end; records may be compressed.
#[test]
fn a_record_is_taken_up() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (half, whole, both) = (path("half.json.gz"), path("whole.json"), path("both.json"));
    for (name, mode) in [
        ("ratchet_mechanism", "kinematic"),
        ("gears_backlash", "dynamic"),
    ] {
        let model = model(name);
        let simulate = |time: &str, more: &[&str]| {
            let args = [
                "simulate", &model, "--mode", mode, "--every", "0.01", "--forces", "--time", time,
            ];
            printed(&[&args[..], more].concat());
        };
        simulate("0.615", &["-o", &half]);
        simulate("1.3", &["-o", &whole]);
        simulate("1.3", &["--resume", &half, "-o", &both]);
        assert!(std::fs::read(&half).unwrap().starts_with(&[0x1f, 0x8b]));
        let [whole, both] = [&whole, &both].map(|path| -> Value {
            serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
        });
        let list = |value: &Value, key: &str| value[key].as_array().unwrap().clone();
        let (samples, again) = (list(&whole, "samples"), list(&both, "samples"));
        assert_eq!(samples.len(), 131, "{name}");
        assert_eq!(again.len(), 131, "{name}");
        let part = whole["parts"][0].as_str().unwrap();
        for (a, b) in samples.iter().zip(&again) {
            assert_eq!(a["t"], b["t"]);
            let (u, v) = (a[part].as_f64().unwrap(), b[part].as_f64().unwrap());
            assert!((u - v).abs() < 1e-7, "{name} {}: {u} {v}", a["t"]);
            assert!(b["forces"].is_object());
        }
        let (events, again) = (list(&whole, "events"), list(&both, "events"));
        assert_eq!(events.len(), again.len(), "{name}");
        for (a, b) in events.iter().zip(&again) {
            assert_eq!(
                (&a["kind"], &a["features"]),
                (&b["kind"], &b["features"]),
                "{name}"
            );
            assert!((a["t"].as_f64().unwrap() - b["t"].as_f64().unwrap()).abs() < 1e-7);
        }
        // States are those of all samples, and more; of each the time, and coordinates with their rates.
        let states = list(&both, "states");
        assert!(states.len() > samples.len(), "{name}");
        let times: Vec<f64> = states.iter().map(|s| s[0].as_f64().unwrap()).collect();
        assert!(times.is_sorted(), "{name}");
        let along = ["clearance", &model, "--along", &half];
        let said = cspace(&along).output().unwrap();
        assert!(said.status.code().unwrap() < 2, "{said:?}");
        // What is printed has no states; those are for the file.
        let printed: Value = crate::helpers::json(&[
            "simulate", &model, "--mode", mode, "--every", "0.01", "--time", "0.1",
        ]);
        assert!(printed.get("states").is_none() && printed["samples"].is_array());
    }
    let geneva = model("geneva");
    let of_other = ["simulate", &geneva, "--time", "2", "--resume", &both];
    fails(
        cspace(&of_other),
        2,
        &["both.json", "gear", "of the same model"],
    );
    let model = model("gears_backlash");
    let shorter = ["simulate", &model, "--time", "1", "--resume", &both];
    fails(cspace(&shorter), 2, &["has come to 1.3 s", "longer --time"]);
    let whole = std::fs::read_to_string(&both).unwrap();
    std::fs::write(&both, whole.replace("\"states\"", "\"stat\"")).unwrap();
    let without = ["simulate", &model, "--time", "2", "--resume", &both];
    fails(cspace(&without), 2, &["it has no states"]);
    std::fs::write(&both, [0x1f, 0x8b, 1, 2, 3]).unwrap();
    fails(cspace(&without), 2, &["both.json", "compressed"]);
}

/// An interrupt keeps what is done.
#[cfg(unix)]
#[test]
fn an_interrupted_motion_keeps_what_is_done() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.json");
    let out = path.to_str().unwrap();
    let model = model("ratchet_mechanism");
    let args = ["simulate", &model, "--time", "1000", "-o", out];
    let child = std::process::Command::new(env!("CARGO_BIN_EXE_cspace"))
        .args(args)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    let pid = child.id().to_string();
    let kill = std::process::Command::new("kill")
        .args(["-INT", &pid])
        .status();
    assert!(kill.unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(told.starts_with("interrupted at "), "{told}");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        said.contains("interrupted at") && said.contains("--resume"),
        "{said}"
    );
    let record: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    assert_eq!(record["status"], "interrupted");
    assert_eq!(record["outcome"], "interrupted");
    let until = record["until"].as_f64().unwrap();
    assert!(until > 0.0, "{until}");
    let longer = (until + 0.2).to_string();
    let text = printed(&["simulate", &model, "--time", &longer, "--resume", out]);
    assert!(text.starts_with("done: "), "{text}");
}

/// A record goes on with what it was made of alone: of everything that the motion depends on another value is told, and neither the
/// name nor the unit. Without hashes a record is taken as it is.
#[test]
fn a_record_of_another_model_is_rejected() {
    const MODEL: &str = r#"
name = "sledge on a slope"
unit = "mm"
gravity = [0, -9810]
friction = 0.1

[[part]]
name = "slope"
motion = { type = "fixed" }
loops = [[[-50, -10], [50, -10], [50, 0], [-50, 0]]]

[[part]]
name = "sledge"
density = 1e-5
loops = [[[-2, 0.5], [2, 0.5], [2, 4], [-2, 4]]]

[[part]]
name = "wheel"
motion = { type = "revolute", center = [0, 40] }
mass = 0.1
inertia = 3.0
loops = [[[-5, 40, 1], [5, 40, 1]]]

[[pair]]
fixed = "slope"
moving = "sledge"

[[load]]
part = "sledge"
force = [0.2, 0]

[[spring]]
parts = ["slope", "sledge"]
at = [[30, 2], [2, 2]]
stiffness = 50

[[drive]]
part = "wheel"
rate = 1
"#;
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (file, record, longer) = (path("model.toml"), path("half.json"), path("longer.json"));
    let resumed = |text: &str| {
        std::fs::write(&file, text).unwrap();
        cspace(&[
            "simulate", &file, "--time", "0.1", "--resume", &record, "-o", &longer,
        ])
    };
    std::fs::write(&file, MODEL).unwrap();
    printed(&["simulate", &file, "--time", "0.05", "-o", &record]);
    let others = [
        ("[-2, 4]]", "[-2, 4.1]]", "outlines or axes of parts"),
        ("[0, 40] }", "[0, 40.1] }", "outlines or axes of parts"),
        ("1e-5", "2e-5", "masses, starts or rates of parts"),
        ("-9810", "-1620", "gravity"),
        (
            "friction = 0.1",
            "friction = 0.2",
            "friction or restitution",
        ),
        ("rate = 1", "rate = 2", "drives"),
        ("[0.2, 0]", "[0.3, 0]", "loads"),
        ("stiffness = 50", "stiffness = 60", "springs"),
        (
            "\"sledge\"\n\n[[load]]",
            "\"sledge\"\ntheta = [\"-10deg\", \"10deg\"]\n\n[[load]]",
            "pairs",
        ),
    ];
    for (this, that, told) in others {
        let text = MODEL.replace(this, that);
        assert_ne!(text, MODEL, "{told}");
        let said = format!("half.json: it was made with other {told}\n");
        fails(resumed(&text), 2, &[&said, "of the same model"]);
    }
    resumed(
        &MODEL
            .replace("slope\"\nunit", "hill\"\nunit")
            .replace("mm", "mil"),
    )
    .assert()
    .success();
    std::fs::write(&file, MODEL).unwrap();
    let kinematic = [
        "simulate",
        &file,
        "--mode",
        "kinematic",
        "--time",
        "1",
        "--resume",
        &record,
    ];
    fails(
        cspace(&kinematic),
        2,
        &["its motion is dynamic", "--mode dynamic"],
    );
    let mut before: Value = serde_json::from_slice(&std::fs::read(&record).unwrap()).unwrap();
    before.as_object_mut().unwrap().remove("model").unwrap();
    std::fs::write(&record, before.to_string()).unwrap();
    resumed(&MODEL.replace("rate = 1", "rate = 2"))
        .assert()
        .success();
}
