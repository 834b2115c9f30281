//! Pictures of the plane of motions of a pair with fixed axes.

use std::fmt::Write;

use cspace::{FeatureKind, FeatureName, FixedAxesSpace};

use super::svg::{BLOCKED, opened, rounded};

/// Width and height of the plane, in pixels.
const SIDE: f64 = 720.0;
/// Room for title, axes and captions.
const MARGIN: f64 = 48.0;
/// Points to a side of a free area, and to a branch of a contact curve.
const AREA_POINTS: usize = 16;
const CURVE_POINTS: usize = 48;
const CURVE: &str = "#1f6fb4";

/// A picture of the plane (u, v): free space white, blocked space grey, every contact curve labelled by its features. The
/// fixed part's feature comes first; `L`, `A`, `a` and `V` are a line, a convex arc, a concave arc and a vertex, with loop
/// and index; the whole label is also the curve's tooltip.
pub fn plane(title: &str, space: &FixedAxesSpace) -> String {
    let [u, v] = space.extent();
    let view = View { u, v };
    let (width, height) = (SIDE + 2.0 * MARGIN, SIDE + 2.0 * MARGIN);
    let mut out = opened(title, width, height, MARGIN);
    let _ = writeln!(
        out,
        r#"<clipPath id="plane"><rect x="{MARGIN}" y="{MARGIN}" width="{SIDE}" height="{SIDE}"/></clipPath>"#
    );
    let _ = writeln!(
        out,
        r##"<g clip-path="url(#plane)"><rect x="{MARGIN}" y="{MARGIN}" width="{SIDE}" height="{SIDE}" fill="{BLOCKED}"/>"##
    );
    for area in space.free_areas(AREA_POINTS) {
        let _ = writeln!(
            out,
            r#"<path d="{}Z" fill="white" stroke="white" stroke-width="0.4"/>"#,
            view.path(area.into_iter())
        );
    }
    let mut labels = String::new();
    for patch in space.patches() {
        let name = format!("{} / {}", label(patch.fixed), label(patch.moving));
        let (from, to) = (patch.branches.start as usize, patch.branches.end as usize);
        for i in from..to {
            let points = branch(space, i);
            let _ = writeln!(
                out,
                r#"<path d="{}" stroke="{CURVE}" stroke-width="1.2"><title>{name}</title></path>"#,
                view.path(points.into_iter())
            );
        }
        let middle = branch(space, usize::midpoint(from, to - 1));
        let (x, y) = view.place(middle[middle.len() / 2]);
        let _ = writeln!(
            labels,
            r##"<text x="{x}" y="{y}" font-size="8" fill="#444">{name}</text>"##
        );
    }
    out.push_str(&labels);
    out.push_str("</g>\n");
    let _ = writeln!(
        out,
        r##"<rect x="{MARGIN}" y="{MARGIN}" width="{SIDE}" height="{SIDE}" stroke="#222"/>"##
    );
    let (bottom, right) = (MARGIN + SIDE, MARGIN + SIDE);
    for (x, y, anchor, text) in [
        (MARGIN, bottom + 16.0, "start", format!("{:.4}", u.0)),
        (right, bottom + 16.0, "end", format!("{:.4}", u.1)),
        (0.5 * width, bottom + 16.0, "middle", "u".to_owned()),
        (MARGIN - 4.0, bottom, "end", format!("{:.3}", v.0)),
        (MARGIN - 4.0, MARGIN + 10.0, "end", format!("{:.3}", v.1)),
        (MARGIN - 8.0, 0.5 * height, "end", "v".to_owned()),
    ] {
        let _ = writeln!(
            out,
            r##"<text x="{x}" y="{y}" font-size="11" text-anchor="{anchor}" fill="#222">{text}</text>"##
        );
    }
    out.push_str("</svg>\n");
    out
}

/// A branch as points (u, v).
fn branch(space: &FixedAxesSpace, index: usize) -> Vec<(f64, f64)> {
    let b = &space.branches()[index];
    let (from, to) = match b.form {
        cspace::fixed_axes::BranchForm::VOfU => (b.start.0, b.end.0),
        cspace::fixed_axes::BranchForm::UOfV => (b.start.1, b.end.1),
    };
    (0..=CURVE_POINTS)
        .filter_map(|k| {
            let t = from + (to - from) * k as f64 / CURVE_POINTS as f64;
            space.branch_at(index, t).map(|(point, _)| point)
        })
        .collect()
}

fn label(name: FeatureName) -> String {
    let kind = match name.kind {
        FeatureKind::Line => "L",
        FeatureKind::ConvexArc => "A",
        FeatureKind::ConcaveArc => "a",
        FeatureKind::Vertex => "V",
    };
    format!("{kind}{}.{}", name.loop_index, name.index)
}

/// From the plane of motions to the picture: v points up in the one and down in the other.
struct View {
    u: (f64, f64),
    v: (f64, f64),
}

impl View {
    fn place(&self, (u, v): (f64, f64)) -> (f64, f64) {
        let share = |t: f64, (lo, hi): (f64, f64)| (t - lo) / (hi - lo);
        (
            rounded(MARGIN + SIDE * share(u, self.u)),
            rounded(MARGIN + SIDE * (1.0 - share(v, self.v))),
        )
    }

    fn path(&self, points: impl Iterator<Item = (f64, f64)>) -> String {
        let mut path = String::new();
        for (i, p) in points.enumerate() {
            let (x, y) = self.place(p);
            let _ = write!(path, "{}{x} {y}", if i == 0 { "M" } else { "L" });
        }
        path
    }
}
