//! `cspace mcp`: a client that asks every tool, with right input and with wrong.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use base64::Engine as _;
use serde_json::{Value, json};

/// The most bytes of an answer that is not asked for in detail.
const SHORT: usize = 4096;

/// An assistant's side of the protocol, line by line.
struct Client {
    server: Child,
    to: Option<ChildStdin>,
    from: BufReader<ChildStdout>,
    asked: u64,
}

impl Client {
    fn new(root: &Path) -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_cspace"))
            .args(["mcp", "--root", root.to_str().unwrap()])
            .env("CSPACE_CACHE", "off")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (to, from) = (server.stdin.take(), server.stdout.take().unwrap());
        let mut client = Self {
            server,
            to,
            from: BufReader::new(from),
            asked: 0,
        };
        let hello = json!({
            "protocolVersion": "2025-06-18",
            "capabilities": {},
            "clientInfo": { "name": "test", "version": "1" },
        });
        let answer = client.ask("initialize", &hello);
        assert_eq!(answer["result"]["serverInfo"]["name"], "cspace");
        let ready = json!({ "jsonrpc": "2.0", "method": "notifications/initialized" });
        client.send(&ready);
        client
    }

    fn send(&mut self, message: &Value) {
        let to = self.to.as_mut().unwrap();
        writeln!(to, "{message}").unwrap();
        to.flush().unwrap();
    }

    fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.asked += 1;
        let id = self.asked;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let mut line = String::new();
            assert!(
                self.from.read_line(&mut line).unwrap() > 0,
                "the server ended"
            );
            let message: Value = serde_json::from_str(&line).unwrap();
            if message["id"] == id {
                return message;
            }
        }
    }

    /// Whether a call is answered, and what is said.
    fn call(&mut self, tool: &str, arguments: &Value) -> (bool, Vec<Value>) {
        let params = json!({ "name": tool, "arguments": arguments });
        let answer = self.ask("tools/call", &params);
        let result = &answer["result"];
        let said = result["content"]
            .as_array()
            .unwrap_or_else(|| panic!("{answer}"));
        (result["isError"] != true, said.clone())
    }

    /// The answer of a call as JSON.
    #[track_caller]
    fn answer(&mut self, tool: &str, arguments: &Value) -> Value {
        let (is_answered, said) = self.call(tool, arguments);
        assert!(is_answered, "{tool} {arguments}: {said:?}");
        let text = said[0]["text"].as_str().unwrap();
        let is_long = arguments["detail"] == true;
        assert!(is_long || text.len() <= SHORT, "{tool}: {}", text.len());
        serde_json::from_str(text).unwrap()
    }

    /// Whether a call is refused with these words, and says what to do.
    #[track_caller]
    fn refuses(&mut self, tool: &str, arguments: &Value, words: &[&str]) {
        let (is_answered, said) = self.call(tool, arguments);
        assert!(!is_answered, "{tool} {arguments}: {said:?}");
        let error: Value = serde_json::from_str(said[0]["text"].as_str().unwrap()).unwrap();
        let told = error.to_string();
        for word in words {
            assert!(told.contains(word), "no {word} in {told}");
        }
        assert!(error["error"]["help"].is_string(), "{told}");
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        // It ends where its input does.
        self.to = None;
        let _ = self.server.wait();
    }
}

fn models() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../models"))
}

const PLATE: &str = r#"
unit = "mm"
[parameter]
gap = { value = 0.2, tol = 0.1 }
[[part]]
name = "plate"
motion = { type = "fixed" }
loops = [[[-20, -8], [20, -8], [20, 8], [-20, 8]], { circle = "3 + gap", at = [0, 0] }]
[[part]]
name = "pin"
loops = [{ circle = 3, at = [0, 0] }]
[[requirement]]
name = "room"
measure = "clearance"
limits = [0.05, 1]
"#;

#[test]
fn every_tool_is_listed_with_what_it_takes() {
    let mut client = Client::new(models());
    let listed = client.ask("tools/list", &json!({}));
    let tools = listed["result"]["tools"].as_array().unwrap();
    let names: Vec<&str> = tools.iter().map(|t| t["name"].as_str().unwrap()).collect();
    assert_eq!(
        names,
        [
            "model_info",
            "space",
            "play",
            "plan",
            "clearance",
            "check",
            "solve",
            "tolerances",
            "simulate",
            "draw",
            "import_drawing",
            "reference"
        ]
    );
    for tool in tools {
        let schema = &tool["inputSchema"];
        assert_eq!(schema["type"], "object");
        assert!(tool["description"].as_str().unwrap().len() > 40);
        for (key, value) in schema["properties"].as_object().unwrap() {
            assert!(value["description"].is_string(), "{}: {key}", tool["name"]);
        }
        assert!(!tool.to_string().contains("$ref"), "{}", tool["name"]);
    }
}

#[test]
fn every_tool_answers() {
    let mut client = Client::new(models());
    let plate = |more: &Value| {
        let mut all = json!({ "model": PLATE });
        for (key, value) in more.as_object().unwrap() {
            all[key] = value.clone();
        }
        all
    };
    let info = client.answer("model_info", &plate(&json!({})));
    assert_eq!(info["parts"][1]["name"], "pin");
    assert_eq!(info["units"]["length"], "mm");
    let space = client.answer("space", &plate(&json!({})));
    assert_eq!(space["pairs"][0]["drawn"]["outcome"], "free");
    let play = client.answer("play", &plate(&json!({ "at": "0,0,0" })));
    assert!((play["pairs"][0]["clearance"].as_f64().unwrap() - 0.2).abs() < 1e-9);
    let play = client.answer(
        "play",
        &plate(&json!({ "set": { "gap": 0.3 }, "at": [0, 0, 0] })),
    );
    assert!((play["pairs"][0]["clearance"].as_f64().unwrap() - 0.3).abs() < 1e-9);
    let plan = client.answer("plan", &plate(&json!({ "from": "0,0,0", "to": "40,0,0" })));
    assert_eq!(plan["outcome"], "no-path");
    let gate = json!({ "model": "layers/gate.toml" });
    let clearance = client.answer("clearance", &gate);
    assert_eq!(clearance["outcome"], "stopped");
    let check = client.answer("check", &plate(&json!({})));
    assert_eq!(check["outcome"], "met");
    let gap = json!([{ "parameter": "gap", "lo": 0.05, "hi": 0.5 }]);
    let goal = json!({ "requirement": "room", "relation": "equal", "value": 0.4 });
    let solve = plate(&json!({ "vary": gap, "so_that": goal }));
    let solved = client.answer("solve", &solve);
    assert!(
        (solved["solutions"][0]["gap"].as_f64().unwrap() - 0.4).abs() < 1e-6,
        "{solved}"
    );
    let tolerances = client.answer("tolerances", &plate(&json!({})));
    assert_eq!(tolerances["outcome"], "holds", "{tolerances}");
    let simulated = client.answer("simulate", &json!({ "model": "geneva.toml", "time": 1 }));
    assert_eq!(simulated["outcome"], "done");
    assert!(simulated["shortened"]["lists"].as_u64().unwrap() > 0);
    let whole = json!({ "model": "geneva.toml", "time": 1, "detail": true });
    let whole = client.answer("simulate", &whole);
    assert!(whole["samples"].as_array().unwrap().len() > 100 && whole["shortened"].is_null());
    let (is_answered, said) = client.call("draw", &plate(&json!({ "at": "0.2,0,0" })));
    assert!(is_answered, "{said:?}");
    let png = base64::engine::general_purpose::STANDARD.decode(said[0]["data"].as_str().unwrap());
    assert!(png.unwrap().starts_with(b"\x89PNG"));
    for topic in [
        json!({}),
        json!({ "topic": "part" }),
        json!({ "topic": "model latch" }),
    ] {
        let (is_answered, said) = client.call("reference", &topic);
        assert!(
            is_answered && said[0]["text"].as_str().unwrap().len() > 500,
            "{said:?}"
        );
    }
}

/// The model that the reference shows, and those of its topics, are models.
#[test]
fn the_models_of_the_reference_are_right() {
    let mut client = Client::new(models());
    let (_, said) = client.call("reference", &json!({}));
    let text = said[0]["text"].as_str().unwrap();
    let model = &text[text.find("unit = ").unwrap()..];
    let checked = client.answer("check", &json!({ "model": model }));
    assert_eq!(checked["outcome"], "met");
    for name in ["latch", "cam", "gears", "geneva", "ratchet", "peg"] {
        let (_, said) = client.call("reference", &json!({ "topic": format!("model {name}") }));
        let info = client.answer("model_info", &json!({ "model": said[0]["text"] }));
        assert_eq!(info["outcome"], "done");
    }
}

#[test]
fn drawings_are_imported_below_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"2\"/></svg>";
    std::fs::write(folder.path().join("coin.svg"), svg).unwrap();
    let mut client = Client::new(folder.path());
    let drawn = json!({ "drawings": ["coin.svg"], "unit": "mm" });
    let (is_answered, said) = client.call("import_drawing", &drawn);
    assert!(is_answered, "{said:?}");
    assert!(said[1]["text"].as_str().unwrap().contains("[[part]]"));
    let drawn = json!({ "drawings": ["coin.svg"], "unit": "mm", "output": "coin.toml" });
    client.answer("import_drawing", &drawn);
    let info = client.answer("model_info", &json!({ "model": "coin.toml" }));
    assert_eq!(info["parts"].as_array().unwrap().len(), 1);
    for output in ["../coin.toml", "/tmp/coin.toml", "nowhere/coin.toml"] {
        let drawn = json!({ "drawings": ["coin.svg"], "output": output });
        client.refuses("import_drawing", &drawn, &["not below"]);
    }
    client.refuses("import_drawing", &json!({ "drawings": [] }), &["no file"]);
    let named = json!({ "drawings": ["coin.svg"], "name": "penny" });
    client.refuses("import_drawing", &named, &["no argument", "name"]);
}

#[test]
fn what_is_wrong_is_told() {
    let mut client = Client::new(models());
    client.refuses("play", &json!({}), &["model", "reference"]);
    client.refuses("play", &json!({ "model": "none.toml" }), &["none.toml"]);
    for path in ["../README.md", "/etc/passwd", "../models/../README.md"] {
        client.refuses("play", &json!({ "model": path }), &["not below"]);
    }
    client.refuses(
        "play",
        &json!({ "model": PLATE, "att": "0,0,0" }),
        &["att", "about"],
    );
    client.refuses("nothing", &json!({}), &["nothing", "model_info"]);
    client.refuses("simulate", &json!({ "model": "geneva.toml" }), &["time"]);
    client.refuses(
        "reference",
        &json!({ "topic": "x" }),
        &["topics are", "part"],
    );
    client.refuses("space", &json!({ "model": PLATE, "set": 3 }), &["`set`"]);
    client.refuses(
        "space",
        &json!({ "model": PLATE, "set": { "gp": 1 } }),
        &["gp", "gap"],
    );
    client.refuses(
        "space",
        &json!({ "model": "ratchet_pawl.toml", "pair": "a,b" }),
        &["the parts are ratchet, pawl"],
    );
    // A drawing that a model names is read below the folder only.
    let outside = "[[part]]\nname = \"a\"\ndxf = \"../docs/none.dxf\"\n";
    client.refuses("model_info", &json!({ "model": outside }), &["not below"]);
    let wrong = "[[part]]\nname = \"a\"\nlops = [[[0, 0], [1, 0], [0, 1]]]\n";
    client.refuses(
        "model_info",
        &json!({ "model": wrong }),
        &["lops", "\"line\":3"],
    );
}

#[test]
fn a_root_that_is_no_folder_is_refused() {
    crate::helpers::fails(
        crate::helpers::cspace(&["mcp", "--root", "nowhere"]),
        2,
        &["--root nowhere", "a folder that is there"],
    );
}
