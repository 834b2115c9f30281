//! First view of a model: `show`.

use super::keys::{Key, Keys};
use super::requirements::two_parts;
use super::scope::Result;
use super::table::Table;
use super::toml_values::{list, text};
use crate::mechanism::{Mechanism, Show, View};

/// Names of the views.
const VIEWS: [(&str, View); 3] = [
    ("parts", View::Parts),
    ("slice", View::Slice),
    ("space", View::Space),
];

#[rustfmt::skip]
pub(super) const SHOW: Keys = Keys::new(
    "`show` is a table such as { pair = [\"ratchet\", \"pawl\"], question = \"Which way does it turn?\", view = \"parts\" }",
    &[
        Key::new("pair", "two_names", "The two parts of the pair that is shown first, one of the model's pairs. Default: one that has something to tell."),
        Key::new("question", "part_name", "The question that the pair answers, in one line. Default: none."),
        Key::new("view", "parts|slice|space", "What is large: parts, the parts; slice, the slice or plane beside them; space, the surface of the space, too. Default: parts."),
    ],
);

/// The file's `show`; its pair is one of the mechanism's.
pub(super) fn read_show(root: &Table<'_>, mechanism: &Mechanism) -> Result<Show> {
    let Some(value) = root.get("show") else {
        return Ok(Show::default());
    };
    let table = Table::new(value, &SHOW)?;
    let pair = match two_parts(&table, mechanism)? {
        None => None,
        Some([a, b]) => {
            let listed = mechanism.pairs.iter().find(|p| {
                let two = (p.fixed, p.moving);
                two == (a, b) || two == (b, a)
            });
            let Some(pair) = listed else {
                let error = table.error("pair", "the two parts are not a pair of the model");
                let help = "name the parts of one of its [[pair]] tables, or add one for them";
                return Err(error.with_help(help));
            };
            Some((pair.fixed, pair.moving))
        }
    };
    let question = table.text("question")?;
    if question.is_some_and(|q| q.trim().is_empty()) {
        let error = table.error("question", "the question is empty");
        return Err(error.with_help("ask what the pair answers, or leave `question` out"));
    }
    let help = "the views are parts, slice and space";
    Ok(Show {
        pair,
        question: question.map(str::to_owned),
        view: table.choice("view", "view", &VIEWS, help)?,
    })
}

/// The table as TOML; none if it says nothing.
pub(super) fn show_to_toml(show: &Show, name: &dyn Fn(usize) -> String) -> Option<String> {
    let view = |view| VIEWS.iter().find(|v| v.1 == view).map(|v| text(v.0));
    let keys = [
        ("pair", show.pair.map(|(a, b)| list([name(a), name(b)]))),
        ("question", show.question.as_deref().map(text)),
        ("view", show.view.and_then(view)),
    ];
    let given = keys
        .into_iter()
        .filter_map(|(key, value)| Some(format!("{key} = {}", value?)));
    let given: Vec<String> = given.collect();
    (!given.is_empty()).then(|| format!("{{ {} }}", given.join(", ")))
}
