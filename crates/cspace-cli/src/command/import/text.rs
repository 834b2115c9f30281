//! The report of an import in words.

use std::collections::BTreeMap;
use std::fmt::{self, Write};
use std::path::PathBuf;

use cspace_api::import::{Entity, Imported};

use crate::wording::{count, length};

pub(super) fn describe(text: &mut String, drawings: &[PathBuf], made: &Imported) -> fmt::Result {
    let files: Vec<String> = drawings.iter().map(|d| d.display().to_string()).collect();
    writeln!(text, "{}", cspace_io::shown::text(&files.join(", ")))?;
    let unit = made
        .unit
        .as_ref()
        .map_or(String::new(), |u| format!(" {u}"));
    writeln!(text, "\nparts")?;
    for p in &made.parts {
        let [x0, y0, x1, y1] = p.bounds.map(length);
        writeln!(text, "  {}", p.name)?;
        writeln!(
            text,
            "    outline    {}: {}, {}",
            count(p.loops, "loop", "loops"),
            count(p.lines, "line", "lines"),
            count(p.arcs, "arc", "arcs")
        )?;
        let squared = if unit.is_empty() {
            String::new()
        } else {
            format!("{unit}²")
        };
        writeln!(text, "    area       {}{squared}", length(p.area))?;
        writeln!(text, "    box        x {x0} to {x1}, y {y0} to {y1}{unit}")?;
    }
    let used: Vec<String> = made.used.iter().map(|(k, n)| format!("{n} {k}")).collect();
    writeln!(text, "\nused         {}", used.join(", "))?;
    for (at, apart) in made.apart.iter().enumerate() {
        let head = if at == 0 { "apart" } else { "" };
        let (on, option) = match &*apart.layer {
            "" => (String::new(), "--part NAME"),
            layer => (format!(" on layer {layer:?}"), "--by-layer"),
        };
        writeln!(
            text,
            "{head:<13}{} outlines{on} are a part each; {option} makes one part of them",
            apart.parts.len()
        )?;
    }
    for (head, ignored) in [
        ("left out", &made.ignored),
        ("unfollowed", &made.unfollowed),
    ] {
        write_kinds(text, head, ignored)?;
    }
    if let Some(widest) = made.joined.iter().max_by(|a, b| a.gap.total_cmp(&b.gap)) {
        writeln!(
            text,
            "joined       {}, the widest {:.3e}{unit} at ({}, {})",
            count(made.joined.len(), "gap", "gaps"),
            widest.gap,
            length(widest.at[0]),
            length(widest.at[1])
        )?;
    }
    let removed = [
        (made.removed.duplicates, "drawn twice"),
        (made.removed.overlaps, "merged with what they overlapped"),
        (made.removed.tiny, "without length"),
    ];
    let removed: Vec<String> = (removed.iter().filter(|(n, _)| *n > 0))
        .map(|(n, what)| format!("{n} {what}"))
        .collect();
    if !removed.is_empty() {
        writeln!(text, "removed      {}", removed.join(", "))?;
    }
    if made.fitted.curves > 0 {
        writeln!(
            text,
            "fitted       {} by {}, within {:.3e}{unit}, the largest kink {:.1e} rad",
            count(made.fitted.curves, "curve", "curves"),
            count(made.fitted.pieces, "line or arc", "lines and arcs"),
            made.fitted.deviation,
            made.fitted.kink
        )?;
    }
    Ok(())
}

/// Each kind once, however many there are; the layers of each.
fn write_kinds(text: &mut String, what: &str, ignored: &[Entity]) -> fmt::Result {
    let mut kinds: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for i in ignored {
        let kind = kinds.entry((&i.r#type, &i.reason)).or_default();
        kind.push(&i.layer);
    }
    for (at, ((kind, reason), mut layers)) in kinds.into_iter().enumerate() {
        let head = if at == 0 { what } else { "" };
        let n = layers.len();
        layers.sort_unstable();
        layers.dedup();
        let on = match layers[..] {
            [""] => String::new(),
            [layer] => format!(" on layer {layer:?}"),
            _ => format!(" on {} layers", layers.len()),
        };
        writeln!(text, "{head:<13}{n} {kind}{on}: {reason}")?;
    }
    Ok(())
}
