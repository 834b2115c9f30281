//! Values as TOML writes them.

use std::fmt::Write as _;

use cspace::{Point, Vector};

/// The lines of the keys that are given.
pub(super) fn lines<const N: usize>(keys: [(&str, Option<String>); N]) -> String {
    let given = keys
        .into_iter()
        .filter_map(|(key, value)| Some(format!("{key} = {}\n", value?)));
    given.collect()
}

pub(super) fn list(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    format!("[{}]", items.join(", "))
}

pub(super) fn point(p: Point) -> String {
    two((p.x, p.y))
}

pub(super) fn vector(v: Vector) -> String {
    two((v.x, v.y))
}

/// Debug prints the fewest digits that are read back as the same number, and a point or exponent.
pub(super) fn two((a, b): (f64, f64)) -> String {
    format!("[{a:?}, {b:?}]")
}

/// A basic string of TOML: quotes, backslashes and control characters escaped.
pub(super) fn text(value: &str) -> String {
    let mut out = String::from('"');
    for c in value.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
