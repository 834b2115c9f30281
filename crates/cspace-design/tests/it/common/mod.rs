//! Helpers that tests of designs share.

use cspace_design::{Checked, Value};
use cspace_model::model::{Setting, Template};
use cspace_model::{Document, Host, Model, read_from_hosted};

/// The template in the text of a model.
pub(crate) fn template(text: &str) -> Template {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("m.toml");
    std::fs::write(&file, text).unwrap();
    Template::read(&file, &Host::default()).unwrap()
}

/// The model in a text, with some values set.
pub(crate) fn model(text: &str, set: &[(&str, String)]) -> Model {
    let set: Vec<Setting> = (set.iter())
        .map(|(name, value)| Setting {
            name: (*name).into(),
            value: value.clone(),
        })
        .collect();
    let host = Host {
        set: &set,
        ..Host::default()
    };
    match read_from_hosted(text.as_bytes(), "m.toml", &host).unwrap() {
        Document::Model(model) => *model,
        Document::Space(_) => panic!("it is a model"),
    }
}

/// The number that is measured.
#[track_caller]
pub(crate) fn number(checked: &Checked) -> f64 {
    match checked.measured.as_ref().unwrap().value {
        Value::Number(x) => x,
        Value::Truth(_) => panic!("{checked:?}"),
    }
}
