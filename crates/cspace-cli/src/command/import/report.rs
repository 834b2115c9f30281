//! The report of an import: the parts made, and the entities used, ignored, joined and fitted.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

use cspace::Part;
use cspace_drawing::{Ignored, Origin, Outlines};
use cspace_model::Mechanism;
use serde::Serialize;

use crate::wording::{count, length};

#[derive(Serialize)]
pub(super) struct Report {
    parts: Vec<PartReport>,
    apart: Vec<ApartReport>,
    used: BTreeMap<String, usize>,
    ignored: Vec<IgnoredReport>,
    unfollowed: Vec<IgnoredReport>,
    sheets: Vec<IgnoredReport>,
    joined: Vec<Gap>,
    fitted: Fitted,
    removed: Removed,
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
}

#[derive(Serialize)]
struct PartReport {
    name: String,
    loops: usize,
    lines: usize,
    arcs: usize,
    area: f64,
    perimeter: f64,
    bounds: [f64; 4],
}

#[derive(Serialize)]
struct ApartReport {
    layer: String,
    parts: Vec<String>,
}

#[derive(Serialize)]
struct IgnoredReport {
    r#type: String,
    layer: String,
    handle: String,
    reason: String,
}

impl IgnoredReport {
    fn of(ignored: &Ignored) -> Self {
        Self::new(&ignored.origin, &ignored.reason)
    }

    fn new(origin: &Origin, reason: &str) -> Self {
        Self {
            r#type: origin.kind.to_string(),
            layer: origin.layer.to_string(),
            handle: origin.handle.to_string(),
            reason: reason.to_owned(),
        }
    }
}

#[derive(Serialize)]
struct Gap {
    gap: f64,
    at: [f64; 2],
}

#[derive(Serialize)]
struct Fitted {
    curves: usize,
    pieces: usize,
    deviation: f64,
    kink: f64,
}

#[derive(Serialize)]
struct Removed {
    duplicates: usize,
    overlaps: usize,
    tiny: usize,
}

impl Report {
    pub(super) fn new(mechanism: &Mechanism, imported: &[Outlines]) -> Self {
        let sum = |of: fn(&Outlines) -> usize| imported.iter().map(of).sum();
        let most = |of: fn(&Outlines) -> f64| imported.iter().map(of).fold(0.0, f64::max);
        let mut used = BTreeMap::new();
        for (kind, n) in imported.iter().flat_map(|o| &o.used) {
            *used.entry(kind.clone()).or_default() += n;
        }
        Self {
            parts: mechanism.parts.iter().map(|p| of_part(&p.part)).collect(),
            apart: (imported.iter().flat_map(|o| &o.apart))
                .map(|a| ApartReport {
                    layer: a.layer.to_string(),
                    parts: a.parts.clone(),
                })
                .collect(),
            used,
            ignored: (imported
                .iter()
                .flat_map(|o| &o.ignored)
                .map(IgnoredReport::of))
            .collect(),
            unfollowed: (imported.iter().flat_map(|o| &o.unfollowed))
                .map(IgnoredReport::of)
                .collect(),
            sheets: (imported.iter().filter_map(|o| o.sheet.as_ref()))
                .map(|sheet| {
                    IgnoredReport::new(
                        sheet,
                        "if it is the sheet, leave it out with --without-sheet",
                    )
                })
                .collect(),
            joined: (imported.iter().flat_map(|o| &o.joined))
                .map(|&(gap, at)| Gap {
                    gap,
                    at: [at.x, at.y],
                })
                .collect(),
            fitted: Fitted {
                curves: sum(|o| o.fitted.curves),
                pieces: sum(|o| o.fitted.pieces),
                deviation: most(|o| o.fitted.deviation),
                kink: most(|o| o.fitted.kink),
            },
            removed: Removed {
                duplicates: sum(|o| o.duplicates),
                overlaps: sum(|o| o.merged),
                tiny: sum(|o| o.tiny),
            },
            unit: mechanism.unit.clone(),
        }
    }

    /// The report as text.
    pub(super) fn text(&self, drawings: &[PathBuf], imported: &[Outlines]) -> String {
        let mut text = String::new();
        // A String takes everything.
        let _ = self.write(&mut text, drawings, imported);
        text
    }

    fn write(
        &self,
        text: &mut String,
        drawings: &[PathBuf],
        imported: &[Outlines],
    ) -> std::fmt::Result {
        let files: Vec<String> = drawings.iter().map(|d| d.display().to_string()).collect();
        writeln!(text, "{}", cspace_model::shown::text(&files.join(", ")))?;
        let unit = self
            .unit
            .as_ref()
            .map_or(String::new(), |u| format!(" {u}"));
        writeln!(text, "\nparts")?;
        for p in &self.parts {
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
        let used: Vec<String> = self.used.iter().map(|(k, n)| format!("{n} {k}")).collect();
        writeln!(text, "\nused         {}", used.join(", "))?;
        for (at, apart) in self.apart.iter().enumerate() {
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
            ("left out", &self.ignored),
            ("unfollowed", &self.unfollowed),
        ] {
            write_kinds(text, head, ignored)?;
        }
        if let Some(widest) = self.joined.iter().max_by(|a, b| a.gap.total_cmp(&b.gap)) {
            writeln!(
                text,
                "joined       {}, the widest {:.3e}{unit} at ({}, {})",
                count(self.joined.len(), "gap", "gaps"),
                widest.gap,
                length(widest.at[0]),
                length(widest.at[1])
            )?;
        }
        let removed = [
            (self.removed.duplicates, "drawn twice"),
            (self.removed.overlaps, "merged with what they overlapped"),
            (self.removed.tiny, "without length"),
        ];
        let removed: Vec<String> = (removed.iter().filter(|(n, _)| *n > 0))
            .map(|(n, what)| format!("{n} {what}"))
            .collect();
        if !removed.is_empty() {
            writeln!(text, "removed      {}", removed.join(", "))?;
        }
        if imported.iter().any(|o| o.fitted.curves > 0) {
            writeln!(
                text,
                "fitted       {} by {}, within {:.3e}{unit}, the largest kink {:.1e} rad",
                count(self.fitted.curves, "curve", "curves"),
                count(self.fitted.pieces, "line or arc", "lines and arcs"),
                self.fitted.deviation,
                self.fitted.kink
            )?;
        }
        Ok(())
    }
}

/// Each kind once, however many there are; the layers of each.
fn write_kinds(text: &mut String, what: &str, ignored: &[IgnoredReport]) -> std::fmt::Result {
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

fn of_part(part: &Part) -> PartReport {
    let bounds = part.bounds();
    let lines = part.edges().filter(|e| e.is_line()).count();
    let edges = part.edges().count();
    let perimeter = part
        .edges()
        .map(|e| {
            let chord = e.start.distance(e.end);
            match e.is_line() {
                true => chord,
                false => (e.radius() * e.sweep()).abs(),
            }
        })
        .sum();
    PartReport {
        name: part.name().to_owned(),
        loops: part.loops().len(),
        lines,
        arcs: edges - lines,
        area: part.area(),
        perimeter,
        bounds: [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y],
    }
}
