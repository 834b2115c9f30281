//! SVG of outlines alone, to scale.

use core::f64::consts::PI;
use std::fmt::Write as _;

use cspace::{Point, Vertex};

use super::{Drawn, edges};
use crate::unit::Unit;

/// Outlines as an SVG drawing: each a `path` of its name, its arcs as arcs, in the model's unit, the y axis pointing up.
///
/// Reading it gives the same loops but for rounding: a bulge is written as a radius.
///
/// ```
/// use cspace::Part;
/// use cspace_drawing::{Drawn, Unit, svg};
/// let disc = Part::circle("disc", (0.0, 0.0), 2.5)?;
/// let text = svg(&Drawn::part(&disc), Some(Unit::Millimetre));
/// assert!(text.contains("mm\"") && text.contains("A2.5 2.5 0 0 0"));
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn svg(drawn: &[Drawn], unit: Option<Unit>) -> String {
    let [lo, hi] = Drawn::extent(drawn);
    // Room for strokes; and the page does not begin at the origin, from which it is read again.
    let margin = 0.01 * (hi.x - lo.x).max(hi.y - lo.y).max(f64::MIN_POSITIVE);
    let (lo, hi) = (
        Point::new(lo.x - margin, lo.y - margin),
        Point::new(hi.x + margin, hi.y + margin),
    );
    let (width, height) = (hi.x - lo.x, hi.y - lo.y);
    // SVG knows these alone.
    const KNOWN: [Unit; 4] = [Unit::Millimetre, Unit::Centimetre, Unit::Inch, Unit::Pixel];
    let label = unit.filter(|u| KNOWN.contains(u));
    let label = label.map_or("", Unit::label);
    let mut out = String::new();
    // A String takes everything. The y axis of SVG points down.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}{label}\" height=\"{height}{label}\" viewBox=\"{} {} {width} {height}\">",
        lo.x, -hi.y
    );
    let stroke = width.hypot(height) / 500.0;
    for outline in drawn {
        let id = escaped(&outline.name);
        let _ = write!(
            out,
            "<path id=\"{id}\" fill=\"#ddd\" fill-rule=\"evenodd\" stroke=\"#222\" stroke-width=\"{stroke:.4}\" d=\""
        );
        for vertices in &outline.loops {
            data(&mut out, vertices);
        }
        out.push_str("\"/>\n");
    }
    out.push_str("</svg>\n");
    out
}

fn data(out: &mut String, vertices: &[Vertex]) {
    let Some(first) = vertices.first() else {
        return;
    };
    let _ = write!(out, "M{} {}", first.x, -first.y);
    for edge in edges(vertices) {
        let q = edge.end;
        if edge.is_line() {
            let _ = write!(out, "L{} {}", q.x, -q.y);
            continue;
        }
        let (radius, sweep) = (edge.radius(), edge.sweep());
        let large = u8::from(sweep.abs() > PI);
        // Counter-clockwise with y up is the negative direction with y down.
        let sweep = u8::from(sweep < 0.0);
        let _ = write!(out, "A{radius} {radius} 0 {large} {sweep} {} {}", q.x, -q.y);
    }
    out.push('Z');
}

/// Escapes text for an attribute, without characters that XML does not allow.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => {}
            c => out.push(c),
        }
    }
    out
}
