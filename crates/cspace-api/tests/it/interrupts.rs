//! Long work of a program that wants no more of it.

use std::fmt::Display;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use cspace::{ComputeError, Progress, Stage};
use cspace_api::{Error, Host, Question, Subject};
use cspace_model::model::Template;
use cspace_model::{Document, Host as ReadHost};
use serde_json::{Value, json};

/// A coin of a radius that varies, beside a table.
const TEXT: &str = r#"
[parameter]
r = 1
[[part]]
name = "table"
loops = [[[-2, -2], [2, -2], [2, 2], [-2, 2]]]
[[part]]
name = "coin"
loops = [{ circle = "r", at = [0, 0] }]
[[requirement]]
name = "apart"
measure = "clearance"
pair = ["table", "coin"]
at = { x = 9 }
"#;

/// A program that counts no pieces, and is patient so often.
struct Impatient(AtomicUsize);

impl Progress for &Impatient {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        let less = |n: usize| n.checked_sub(1);
        match (self.0).fetch_update(Ordering::Relaxed, Ordering::Relaxed, less) {
            Ok(_) => Ok(()),
            Err(_) => Err(ComputeError::Interrupted),
        }
    }
}

impl Host for Impatient {
    fn begin(&self, _: &str) -> Box<dyn Progress + '_> {
        Box::new(self)
    }

    fn note(&self, _: &dyn Display) {}

    fn warn(&self, _: &Error) {}

    fn option(&self, name: &str) -> String {
        name.to_owned()
    }
}

fn swept(patience: usize) -> Value {
    let template = Template::from_text(TEXT.to_owned(), "coin.toml").unwrap();
    let model = template.model(&ReadHost::default()).unwrap();
    let document = Document::Model(Box::new(model));
    let template = Some(Arc::new(template));
    let subject = Subject::of("coin.toml".into(), document, template, Vec::new());
    let vary = json!([{ "name": "r", "lo": 1.0, "hi": 2.0, "count": 1000 }]);
    let question = json!({ "question": "sweep", "vary": vary });
    let question: Question = serde_json::from_value(question).unwrap();
    let answer = question.ask(&subject, &Impatient(AtomicUsize::new(patience)));
    serde_json::to_value(answer.unwrap()).unwrap()
}

#[test]
fn rows_end_where_the_program_wants_no_more() {
    let whole = swept(usize::MAX);
    assert_eq!((&whole["outcome"], rows(&whole)), (&json!("done"), 1000));
    let cut = swept(2);
    let some = rows(&cut);
    assert_eq!(cut["outcome"], "interrupted");
    assert!((1..1000).contains(&some), "{some} rows");
    assert_eq!(cut["rows"][0], whole["rows"][0]);
}

fn rows(answer: &Value) -> usize {
    answer["rows"].as_array().unwrap().len()
}
