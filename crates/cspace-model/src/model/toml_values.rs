//! Values as TOML writes them.

use std::fmt::Write as _;

use cspace::{Point, Vector};

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
