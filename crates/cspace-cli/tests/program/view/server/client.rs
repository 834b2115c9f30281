//! A server of small parts, and requests to it.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use cspace::{Classification, Configuration, Coordinates, Part};
use cspace_api::scene::Opened;
use cspace_cli::view::{Page, Server};
use cspace_model::{Mechanism, PartEntry, SavedFile};
use serde_json::Value;

pub(crate) const TEMPLATE: &str =
    "<!doctype html><head><!--style--></head><body><!--scene--><!--script--></body>";

/// A running server.
pub(crate) struct Client {
    pub(crate) port: u16,
    /// The path of the page, with the token.
    pub(crate) root: String,
}

/// Answer of the server.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: String,
}

impl Answer {
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap()
    }

    /// The value of a header.
    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        let lines = self.head.lines().skip(1);
        let mut found = lines
            .filter_map(|l| l.split_once(": "))
            .filter(|h| h.0.eq_ignore_ascii_case(name));
        let value = found.next().map(|h| h.1);
        assert!(found.next().is_none(), "{name} is there twice");
        value
    }

    /// Checks that the answer is an error with this status and words.
    #[track_caller]
    pub(crate) fn fails(&self, status: u16, words: &[&str]) {
        assert_eq!(self.status, status, "{self:?}");
        assert_eq!(self.header("content-type"), Some("application/json"));
        let answer = self.json();
        let error = answer["error"].as_str().unwrap();
        for word in words {
            assert!(error.contains(word), "no {word:?} in {error}");
        }
    }
}

/// A square table 4 wide, which does not move, a coin of radius 1 that moves freely, and a lid that turns on the table.
pub(crate) fn mechanism() -> Mechanism {
    let mut model = Mechanism::new("table and coin");
    model.unit = Some("mm".into());
    let part = |x: f64, y: f64, name: &str| Part::rectangle(name, (x, y), 4.0, 4.0).unwrap();
    model.parts.push(PartEntry::fixed(part(0.0, 0.0, "table")));
    model.parts.push(PartEntry::planar(
        Part::circle("coin", (0.0, 0.0), 1.0).unwrap(),
    ));
    model
        .parts
        .push(PartEntry::revolute(part(6.0, 0.0, "lid"), (6.0, 0.0)));
    model.pairs = model.every_two();
    model
}

pub(crate) fn page() -> Page {
    Page::new(TEMPLATE, "body{}", "console.log(1)").unwrap()
}

impl Client {
    pub(crate) fn new() -> Self {
        let model = mechanism();
        let pairs = model.pairs.clone();
        Self::of(Opened::model(model, pairs, false))
    }

    pub(crate) fn of(opened: Opened) -> Self {
        Self::serving(Server::bind(opened, &page(), 0).unwrap())
    }

    pub(crate) fn serving(server: Server) -> Self {
        let url = server.url();
        std::thread::spawn(move || server.run().unwrap());
        let (port, path) = url
            .strip_prefix("http://127.0.0.1:")
            .unwrap()
            .split_once('/')
            .unwrap();
        Self {
            port: port.parse().unwrap(),
            root: format!("/{path}"),
        }
    }

    /// Sends bytes and reads what comes until the server closes the connection.
    pub(crate) fn send(&self, request: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_secs(120)))
            .unwrap();
        // It may answer and close before all of a long body is sent.
        let _ = stream.write_all(request);
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let text = String::from_utf8(bytes).unwrap();
        let (head, body) = text
            .split_once("\r\n\r\n")
            .unwrap_or_else(|| panic!("{text:?}"));
        Answer {
            status: head.split(' ').nth(1).unwrap().parse().unwrap(),
            head: head.to_owned(),
            body: body.to_owned(),
        }
    }

    /// A request with these lines in its head after the host.
    pub(crate) fn ask(&self, method: &str, path: &str, more: &str, body: &str) -> Answer {
        let request = format!(
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n{more}Content-Length: {}\r\n\r\n{body}",
            self.port,
            body.len()
        );
        self.send(request.as_bytes())
    }

    /// Gets what is below the token.
    pub(crate) fn get(&self, path: &str) -> Answer {
        self.ask("GET", &format!("{}{path}", self.root), "", "")
    }

    pub(crate) fn post(&self, path: &str, body: &Value) -> Answer {
        let path = format!("{}{path}", self.root);
        self.ask(
            "POST",
            &path,
            "Content-Type: application/json\r\n",
            &body.to_string(),
        )
    }
}

/// Class of the moving part at (x, 0, 0) in a pair's space.
pub(crate) fn class_at(pair: &Value, x: f64) -> Classification {
    let file = SavedFile::from_json(pair["space"].as_str().unwrap(), "space.json").unwrap();
    let at = Coordinates::Planar(Configuration::new(x, 0.0, 0.0));
    file.space.classify(at).unwrap()
}
