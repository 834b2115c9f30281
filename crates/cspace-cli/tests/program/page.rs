//! The page, as a file and served.
//!
//! A program that was built without its page, as debug builds are, says so, and is not asked for more then. With
//! `CSPACE_PAGE=build` it has to have one.

use std::path::Path;
use std::sync::OnceLock;

use serde_json::Value;

use crate::helpers::{PAIRS, cspace, fails, mechanism, model, printed};

/// Words of a program without its page.
pub(crate) const WITHOUT: &[&str] = &["built without its page: ", "help: ", "build"];

/// Whether the program has its page; if not, what it says is checked.
pub(crate) fn is_bundled() -> bool {
    static BUNDLED: OnceLock<bool> = OnceLock::new();
    *BUNDLED.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("a.html");
        let args = ["export", &model("knee"), "-o", out.to_str().unwrap()];
        let done = cspace(&args).output().unwrap().status.success();
        if !done {
            for args in [&args[..], &["view", &model("knee"), "--no-open"]] {
                fails(cspace(args), 2, WITHOUT);
            }
            assert!(!out.exists());
            let is_wanted = std::env::var("CSPACE_PAGE").is_ok_and(|v| v == "build");
            assert!(!is_wanted, "CSPACE_PAGE=build: the program has no page");
        }
        done
    })
}

/// The scene in a page.
fn scene(html: &str) -> Value {
    let (_, rest) = html
        .split_once(r#"<script type="application/json" id="scene">"#)
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

fn exported(args: &[&str], out: &Path) -> Value {
    let said = printed(&[&["export"], args, &["-o", out.to_str().unwrap()]].concat());
    assert_eq!(said, "");
    scene(&std::fs::read_to_string(out).unwrap())
}

/// The saved space of a pair of a scene, which is a text there.
fn space_of(pair: &Value) -> Value {
    serde_json::from_str(pair["space"].as_str().unwrap()).unwrap()
}

#[test]
fn a_page_has_all_pairs_or_the_one_that_is_named() {
    if !is_bundled() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("a.HTML");
    let all = exported(&[&mechanism()], &out);
    let pairs = all["pairs"].as_array().unwrap();
    let name = |pair: &Value, key: &str| {
        let index = pair[key].as_u64().unwrap() as usize;
        all["parts"][index]["name"].as_str().unwrap().to_owned()
    };
    let told: Vec<_> = (pairs.iter())
        .map(|p| {
            (
                format!("{},{}", name(p, "fixed"), name(p, "moving")),
                p["class"].as_str().unwrap(),
            )
        })
        .collect();
    let told: Vec<_> = told
        .iter()
        .map(|(names, class)| (names.as_str(), *class))
        .collect();
    assert_eq!(told, PAIRS);
    // Each has what is saved of it.
    let saved = folder.path().join("a.json");
    for (pair, (names, _)) in pairs.iter().zip(PAIRS) {
        printed(&[
            "export",
            &mechanism(),
            "--pair",
            names,
            "-o",
            saved.to_str().unwrap(),
        ]);
        let text = std::fs::read_to_string(&saved).unwrap();
        let mut file: Value = serde_json::from_str(&text).unwrap();
        let object = file.as_object_mut().unwrap();
        object.remove("name");
        object.remove("unit");
        object.remove("checksum");
        let mut space = space_of(pair);
        for space in [&mut file, &mut space] {
            if let Some(statistics) = space["statistics"].as_object_mut() {
                statistics.remove("seconds");
            }
        }
        assert!(space == file, "{names}");
    }
    let one = exported(&[&mechanism(), "--pair", "driver,link"], &out);
    assert_eq!(
        (
            one["pairs"].as_array().unwrap().len(),
            one["parts"].as_array().unwrap().len()
        ),
        (1, 5)
    );
    let general = exported(
        &[
            &mechanism(),
            "--pair",
            "driver,link",
            "--general",
            "--window=-0.1,0.1",
        ],
        &out,
    );
    let window = &space_of(&general["pairs"][0])["window"];
    assert_eq!(general["pairs"][0]["class"], "general");
    assert_eq!(
        (&window["lo"], &window["hi"]),
        (&Value::from(-0.1), &Value::from(0.1))
    );
}

#[test]
fn saved_spaces_have_pages() {
    if !is_bundled() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let saved = folder.path().join("a.json");
    let saved = saved.to_str().unwrap();
    let out = folder.path().join("a.html");
    for (names, class) in PAIRS {
        printed(&["export", &mechanism(), "--pair", names, "-o", saved]);
        let page = exported(&[saved], &out);
        assert_eq!(page["pairs"][0]["class"], class);
        assert_eq!(page["name"], "ratchet mechanism");
        assert!(space_of(&page["pairs"][0])["format"].is_string());
    }
}

#[test]
fn records_are_in_the_page() {
    if !is_bundled() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (run, way, out) = (
        place("run.json"),
        place("way.json"),
        folder.path().join("a.html"),
    );
    printed(&["simulate", &model("geneva"), "--time", "0.1", "-o", &run]);
    let plan = [
        "plan",
        &model("peg_hole"),
        "--from",
        "40,30,0",
        "--to",
        "0,2,0",
        "-o",
        &way,
    ];
    assert!(cspace(&plan).output().unwrap().status.success());
    let read = |path: &str| -> Value {
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    };
    let page = exported(&[&model("geneva"), "--with", &run, "--with", &way], &out);
    assert_eq!(page["records"][0]["name"], "run.json");
    assert_eq!(page["records"][0]["record"], read(&run));
    assert_eq!(page["records"][1]["record"], read(&way));
    let (latch, apart) = (model("latch_box"), place("apart.json"));
    printed(&["disassemble", &latch, "-o", &apart]);
    let page = exported(&[&latch, "--with", &apart], &out);
    assert_eq!(page["records"][0]["record"], read(&apart));

    std::fs::remove_file(&out).unwrap();
    let html = out.to_str().unwrap();
    let write = |name: &str, text: &str| {
        std::fs::write(place(name), text).unwrap();
        place(name)
    };
    let geneva = model("geneva");
    for (record, words) in [
        (place("none.json"), &["none.json", "cannot be read"][..]),
        (
            folder.path().to_str().unwrap().to_owned(),
            &["no regular file"],
        ),
        (write("bad.json", "{"), &["bad.json", "no JSON"]),
        (
            write("list.json", "[]"),
            &[
                "list.json",
                "no answer of `plan`, `disassemble` or `simulate`",
            ],
        ),
        (write("half.json", r#"{"verdict": "path"}"#), &["no answer"]),
        (apart, &["\"box\"", "same model"]),
        (
            write(
                "other.json",
                r#"{"status": "done", "samples": [], "parts": ["flag"]}"#,
            ),
            &["\"flag\"", "same model"],
        ),
    ] {
        fails(
            cspace(&["export", &geneva, "--with", &record, "-o", html]),
            2,
            words,
        );
        fails(
            cspace(&["view", &geneva, "--with", &record, "--no-open"]),
            2,
            words,
        );
        assert!(!out.exists());
    }
    // A record is not written over.
    let page = write("page.html", &std::fs::read_to_string(&run).unwrap());
    fails(
        cspace(&["export", &geneva, "--with", &page, "-o", &page]),
        2,
        &["the file that is read"],
    );
    assert_eq!(read(&page), read(&run));
    fails(
        cspace(&["export", &geneva, "--with", &run, "-o", &place("a.json")]),
        2,
        &["--with is about pages"],
    );
    fails(
        cspace(&["export", &geneva, "--slices=3", "-o", html]),
        2,
        &["--slices is about pictures"],
    );
}

/// Two discs, and a third that slides nowhere.
const HALF: &str = r#"
[[part]]
name = "a"
loops = [[[0, 0, 1], [1, 0, 1]]]
[[part]]
name = "b"
loops = [[[5, 0, 1], [6, 0, 1]]]
motion = { type = "fixed" }
[[part]]
name = "c"
loops = [[[8, 0, 1], [9, 0, 1]]]
motion = { type = "revolute", center = [1e7, 0] }
"#;

#[test]
fn a_pair_that_cannot_be_computed_does_not_keep_the_others_back() {
    if !is_bundled() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (file, out) = (folder.path().join("m.toml"), folder.path().join("a.html"));
    std::fs::write(&file, HALF).unwrap();
    let args = [
        "export",
        file.to_str().unwrap(),
        "-o",
        out.to_str().unwrap(),
    ];
    let output = cspace(&args).assert().success().get_output().clone();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.contains("warning:") && said.contains("pair b,c"),
        "{said}"
    );
    let page = scene(&std::fs::read_to_string(&out).unwrap());
    let errors: Vec<bool> = page["pairs"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| p["error"].is_string())
        .collect();
    assert_eq!(errors, [false, false, true]);
    assert!(page["pairs"][2]["space"].is_null() && page["pairs"][0]["space"].is_string());

    std::fs::remove_file(&out).unwrap();
    let alone = [&args[..], &["--pair", "b,c"]].concat();
    fails(cspace(&alone), 2, &["pair b,c"]);
    assert!(!out.exists());
}

#[test]
fn what_has_no_page_is_refused() {
    if !is_bundled() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let single = place("single.toml");
    std::fs::write(
        &single,
        "[[part]]\nname = \"a\"\nloops = [[[0, 0, 1], [1, 0, 1]]]\n",
    )
    .unwrap();
    let out = place("a.html");
    let geneva = model("geneva");
    let pairs = "crank,star";
    for (args, code, words) in [
        (&[single.as_str()][..], 2, &["one part"][..]),
        (&["no_such.toml"], 2, &["no_such.toml", "cannot be read"]),
        (&[&geneva, "--pair", pairs], 2, &["no part"]),
        (&[&geneva, "--window=1,0"], 2, &["--window"]),
    ] {
        fails(
            cspace(&[&["export"], args, &["-o", &out]].concat()),
            code,
            words,
        );
        fails(
            cspace(&[&["view", "--no-open"], args].concat()),
            code,
            words,
        );
    }
    let drawing = folder.path().join("plate.dxf");
    let circle =
        "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n5\n0\nENDSEC\n0\nEOF\n";
    std::fs::write(&drawing, circle).unwrap();
    let points = folder.path().join("points.csv");
    std::fs::write(&points, "0,0\n1,0\n1,1\n0,1\n").unwrap();
    let [drawing, points] = [&drawing, &points].map(|p| p.to_str().unwrap());
    for (args, words) in [
        (&[drawing, "--pair", "a,b"][..], &["--pair", "drawing"][..]),
        (&[drawing, "--general"], &["--general", "drawing"]),
        (&[drawing, "--layer", "none"], &["plate.dxf", "layer"]),
        (&[points], &["points.csv", "measured points"]),
        (&[&geneva, "--layer", "0"], &["--layer", "drawings"]),
        (&[&geneva, "--scale", "2"], &["--scale", "drawings"]),
        (&["no_such.svg"], &["no_such.svg"]),
        (&["--pair", "a,b"], &["--pair", "name the file"]),
        (&["--scale", "2"], &["--scale", "name the file"]),
    ] {
        fails(cspace(&[&["view", "--no-open"], args].concat()), 2, words);
    }
    for port in ["-1", "65536", "x"] {
        fails(cspace(&["view", &geneva, "--port", port]), 2, &["--port"]);
    }
    let taken = std::net::TcpListener::bind(("127.0.0.1", 0)).unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    fails(
        cspace(&["view", &geneva, "--no-open", "--port", &port]),
        2,
        &[&port, "in use", "another --port"],
    );
    assert!(!Path::new(&out).exists());
}

/// The address comes first; Ctrl-C is how it ends.
#[cfg(unix)]
#[test]
fn it_is_served_until_it_is_interrupted() {
    use std::io::{BufRead, BufReader, Read, Write};
    use std::process::{Command, Stdio};
    if !is_bundled() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let saved = folder.path().join("a.json");
    let saved = saved.to_str().unwrap();
    printed(&[
        "export",
        &mechanism(),
        "--pair",
        "ratchet,pawl",
        "-o",
        saved,
    ]);
    for (file, parts, pairs) in [
        (Some(mechanism().as_str()), 5, 6),
        (Some(saved), 2, 1),
        (None, 0, 0),
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_cspace"))
            .env("CSPACE_CACHE", "off")
            .args(["view", "--no-open"])
            .args(file)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap());
        let mut url = String::new();
        lines.read_line(&mut url).unwrap();
        let (host, path) = url
            .trim_end()
            .strip_prefix("http://")
            .unwrap()
            .split_once('/')
            .unwrap();
        let mut stream = std::net::TcpStream::connect(host).unwrap();
        write!(
            stream,
            "GET /{path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"
        )
        .unwrap();
        let mut page = String::new();
        stream.read_to_string(&mut page).unwrap();
        let scene = scene(&page);
        let count = |what: &str| scene[what].as_array().unwrap().len();
        assert_eq!((count("parts"), count("pairs")), (parts, pairs), "{file:?}");
        let pid = child.id().to_string();
        assert!(
            Command::new("kill")
                .args(["-INT", &pid])
                .status()
                .unwrap()
                .success()
        );
        assert_eq!(child.wait().unwrap().code(), Some(0));
        let mut rest = String::new();
        lines.read_to_string(&mut rest).unwrap();
        assert_eq!(rest, "", "the address is all that is printed");
    }
}

/// More connections than there may be open files, one with half of a request: when they are gone, the page is answered.
#[cfg(unix)]
#[test]
fn idle_connections_do_not_end_the_view() {
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::process::{Command, Stdio};
    if !is_bundled() {
        return;
    }
    let program = env!("CARGO_BIN_EXE_cspace");
    let mut child = Command::new("sh")
        .env("CSPACE_CACHE", "off")
        .args(["-c", "ulimit -n 40; exec \"$0\" view \"$1\" --no-open"])
        .arg(program)
        .arg(model("knee"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut url = String::new();
    let mut lines = BufReader::new(child.stdout.take().unwrap());
    lines.read_line(&mut url).unwrap();
    let (host, path) = url.trim()["http://".len()..].split_once('/').unwrap();
    let mut idle: Vec<TcpStream> = (0..60).map(|_| TcpStream::connect(host).unwrap()).collect();
    idle[0].write_all(b"GET / HT").unwrap();
    // One that the system has not given to the server yet is answered once the others are gone.
    let mut asking = TcpStream::connect(host).unwrap();
    let request = format!("GET /{path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
    asking.write_all(request.as_bytes()).unwrap();
    drop(idle);
    let mut answer = String::new();
    asking.read_to_string(&mut answer).unwrap();
    assert!(answer.starts_with("HTTP/1.1 200 OK"), "{answer}");
    assert!(child.try_wait().unwrap().is_none());
    child.kill().unwrap();
    child.wait().unwrap();
}
