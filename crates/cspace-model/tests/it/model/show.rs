//! First view of a model: `show`.

use cspace_model::{View, model};

use super::errors::{error, says};

/// A model of three parts, two of which are a pair, that begins with a `show`.
fn with(show: &str) -> String {
    let part = |name: &str| {
        format!("[[part]]\nname = \"{name}\"\nloops = [[[0, 0], [1, 0], [1, 1], [0, 1]]]\n")
    };
    let parts: String = ["a", "b", "c"].map(part).concat();
    format!("show = {show}\n{parts}[[pair]]\nfixed = \"b\"\nmoving = \"c\"\n")
}

#[test]
fn it_is_read_and_written_back() {
    for (show, pair, question, view) in [
        (
            r#"{ pair = ["b", "c"], question = "Does \"c\" turn?", view = "space" }"#,
            Some((1, 2)),
            Some("Does \"c\" turn?"),
            Some(View::Space),
        ),
        // The two parts in any order are the pair as it is listed.
        (r#"{ pair = ["c", "b"] }"#, Some((1, 2)), None, None),
        (r#"{ view = "slice" }"#, None, None, Some(View::Slice)),
        ("{}", None, None, None),
    ] {
        let read = model::from_toml(&with(show), "m.toml").unwrap();
        let given = &read.show;
        assert_eq!(
            (given.pair, given.question.as_deref(), given.view),
            (pair, question, view)
        );
        let written = model::to_toml(&read);
        assert_eq!(written.contains("show"), !given.is_none(), "{written}");
        assert_eq!(model::from_toml(&written, "again.toml").unwrap(), read);
        assert_eq!(
            model::from_json(&model::to_json(&read), "m.json").unwrap(),
            read
        );
    }
}

#[test]
fn what_cannot_be_shown_is_refused() {
    for (show, words) in [
        (
            r#"{ pair = ["b", "zebra"] }"#,
            &["m.toml:1", "\"zebra\"", "the parts are a, b, c"][..],
        ),
        (
            r#"{ pair = ["a", "b"] }"#,
            &["m.toml:1", "not a pair of the model", "[[pair]]"],
        ),
        (r#"{ pair = ["b", "b"] }"#, &["paired with itself"]),
        (r#"{ pair = "b" }"#, &["pair", "a list"]),
        (
            r#"{ view = "plane" }"#,
            &["unknown view \"plane\"", "parts, slice and space"],
        ),
        (r#"{ question = " " }"#, &["the question is empty"]),
        (r#"{ question = "a\nb" }"#, &["control character"]),
        (r#"{ quest = "a" }"#, &["quest", "question"]),
        (r#""a""#, &["table", "Which way"]),
    ] {
        says(&error(&with(show)), words);
    }
}
