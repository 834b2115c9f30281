//! Values that the schemas in `docs/` take, and values that they refuse.
//!
//! A validator of JSON Schema is a tenth of all that would be compiled for the tests, so these only collect what is to be
//! asked; `.ci/others` asks it. Each test has a file of its own, with a line for each case.

use std::cell::RefCell;
use std::fs::File;
use std::io::{BufWriter, Write};

use serde_json::{Value, json};

use crate::kept;

thread_local! {
    /// File of the test that this thread runs, open from its first case on.
    static CASES: RefCell<Option<BufWriter<File>>> = const { RefCell::new(None) };
}

/// Schema of `docs/`.
#[derive(Clone, Copy, Debug)]
pub struct Schema {
    path: &'static str,
}

impl Schema {
    /// Schema with a path from `docs/`, without `.schema.json`: `answers/plan`.
    #[must_use]
    pub const fn new(path: &'static str) -> Self {
        Self { path }
    }

    /// A value that it takes.
    pub fn takes(self, value: &Value, what: &str) {
        self.case(value, true, what);
    }

    /// A value that it refuses.
    pub fn refuses(self, value: &Value, what: &str) {
        self.case(value, false, what);
    }

    /// A value that it takes or not.
    pub fn case(self, value: &Value, is_valid: bool, what: &str) {
        let line = json!({"schema": self.path, "valid": is_valid, "what": what, "value": value});
        CASES.with_borrow_mut(|cases| {
            let file = cases.get_or_insert_with(|| BufWriter::new(opened()));
            if let Err(error) = writeln!(file, "{line}") {
                panic!("a case of {} cannot be kept: {error}", self.path);
            }
        });
    }
}

/// New file of the test that this thread runs, which has the test's name.
fn opened() -> File {
    let open = || {
        let folder = kept::folder("schemas")?;
        let program = std::env::current_exe()?;
        let thread = std::thread::current();
        let test = thread.name().unwrap_or("main").replace("::", ".");
        // What stands behind the last hyphen differs from build to build.
        let stem = program.file_stem().unwrap_or_default().to_string_lossy();
        let suite = stem.rsplit_once('-').map_or(&*stem, |(name, _)| name);
        File::create(folder.join(format!("{suite}.{test}.jsonl")))
    };
    open()
        .unwrap_or_else(|error: std::io::Error| panic!("cases of schemas cannot be kept: {error}"))
}
