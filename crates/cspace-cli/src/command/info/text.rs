//! The answer of `cspace info` as text.

use std::fmt::{self, Write};

use cspace_api::info::{Info, Motion, Parameter};
use cspace_model::shown;

use crate::wording::{angle, count, length, symmetry};

use super::dynamics::{forces, part, surface};

/// A line for each parameter: name, value, how it is written or how far it may vary, and what depends on it.
fn parameters(text: &mut String, all: &[Parameter]) -> fmt::Result {
    /// More users than these are counted.
    const SHOWN: usize = 4;
    if all.is_empty() {
        return Ok(());
    }
    writeln!(text, "\nparameters")?;
    let width = |of: &dyn Fn(&Parameter) -> usize| all.iter().map(of).max().unwrap_or(0);
    let named = width(&|p| p.name.chars().count());
    let values: Vec<String> = (all.iter())
        .map(|p| shown::number(p.value).to_string())
        .collect();
    let valued = values.iter().map(String::len).max().unwrap_or(0);
    for (p, value) in all.iter().zip(values) {
        write!(text, "  {:named$} = {value:valued$}", p.name)?;
        // Sums and differences of what is written, which are rounded.
        let shown = |x: f64| shown::number(digits(x));
        match p.deviations {
            Some([below, above]) if below == above => write!(text, " ± {}", shown(above))?,
            Some([below, above]) if below < 0.0 || above < 0.0 => write!(
                text,
                " within {} to {}",
                shown(p.value - below),
                shown(p.value + above)
            )?,
            Some([below, above]) => {
                write!(text, " +{} −{}", shown(above), shown(below))?;
            }
            None => {}
        }
        if let Some(expression) = &p.expression {
            write!(text, "  = {expression}")?;
        }
        if p.set {
            write!(text, "  set here")?;
        }
        let users = &p.used_by[..p.used_by.len().min(SHOWN)];
        let more = p.used_by.len() - users.len();
        match users {
            [] => write!(text, "  used by nothing")?,
            _ => write!(text, "  used by {}", users.join(", "))?,
        }
        if more > 0 {
            write!(text, " and {more} more")?;
        }
        writeln!(text)?;
    }
    Ok(())
}

pub(super) fn describe(text: &mut String, info: &Info) -> fmt::Result {
    let unit = info
        .unit
        .as_ref()
        .map_or(String::new(), |u| format!(" {u}"));
    writeln!(text, "{}", info.name)?;
    parameters(text, &info.parameters)?;
    writeln!(text, "\nparts")?;
    for p in &info.parts {
        writeln!(text, "  {}", p.name)?;
        let [x0, y0, x1, y1] = p.bounds.map(length);
        writeln!(
            text,
            "    box        x {x0} to {x1}, y {y0} to {y1}{unit}: {} by {}",
            length(p.bounds[2] - p.bounds[0]),
            length(p.bounds[3] - p.bounds[1])
        )?;
        let squared = match unit.is_empty() {
            true => String::new(),
            false => format!("{unit}²"),
        };
        writeln!(text, "    area       {}{squared}", length(p.area))?;
        writeln!(
            text,
            "    outline    {}{}, {}: {}, {}, {}",
            count(p.loops, "loop", "loops"),
            match p.holes {
                0 => String::new(),
                holes => format!(" ({})", count(holes, "hole", "holes")),
            },
            count(p.features.total, "feature", "features"),
            count(p.features.lines, "line", "lines"),
            count(p.features.arcs, "arc", "arcs"),
            count(p.features.vertices, "vertex", "vertices"),
        )?;
        for member in &p.members {
            let loops = match member.loops {
                [first, last] if first == last => format!("loop {first}"),
                [first, last] => format!("loops {first} to {last}"),
            };
            writeln!(
                text,
                "    made of    {}, {loops}",
                shown::text(&member.name)
            )?;
        }
        for (i, layer) in p.layers.iter().enumerate() {
            let z = match layer.z {
                Some([lo, hi]) => format!("z {} to {}{unit}", length(lo), length(hi)),
                None => "at every height".to_owned(),
            };
            writeln!(
                text,
                "    layer {i:<4} {z}: {}, area {}{squared}",
                count(layer.loops, "loop", "loops"),
                length(layer.area)
            )?;
        }
        if let Some((least, greatest)) = p.radii {
            writeln!(
                text,
                "    arcs       {} convex, {} concave, of radius {} to {}{unit}",
                p.convex_arcs,
                p.concave_arcs,
                length(least),
                length(greatest)
            )?;
        }
        write!(text, "    motion     ")?;
        describe_motion(text, &p.motion, &unit)?;
        part(text, &p.dynamics, &unit)?;
        if p.round || p.symmetry > 1 {
            writeln!(text, "    symmetry   {}", symmetry(p.symmetry, p.round))?;
        }
    }
    if !info.joints.is_empty() {
        writeln!(text, "\njoints")?;
    }
    for j in &info.joints {
        write!(
            text,
            "  {} of {} and {}",
            j.kind.name(),
            j.parts[0],
            j.parts[1]
        )?;
        write!(text, " at {}", place(j.at))?;
        if let Some(direction) = j.direction {
            write!(text, " along {}", place(direction))?;
        }
        writeln!(text)?;
    }
    writeln!(text, "\npairs")?;
    if info.pairs.is_empty() {
        writeln!(text, "  none: a pair takes two parts")?;
    }
    for p in &info.pairs {
        write!(
            text,
            "  {} (fixed), {} (moving): {}, {}",
            p.fixed,
            p.moving,
            p.class,
            count(p.features, "feature", "features")
        )?;
        if let Some((lo, hi)) = p.theta {
            write!(text, ", theta from {} to {}", angle(lo), angle(hi))?;
        }
        let own = surface(&p.surface);
        writeln!(text, "{own}")?;
    }
    forces(text, &info.forces, &unit)
}

/// A point or direction as given.
fn place([x, y]: [f64; 2]) -> String {
    format!("({}, {})", shown::number(x), shown::number(y))
}

fn describe_motion(text: &mut String, motion: &Motion, unit: &str) -> fmt::Result {
    match motion {
        Motion::Fixed => writeln!(text, "fixed"),
        Motion::Planar => writeln!(text, "planar"),
        Motion::Revolute { center, range } => {
            write!(text, "revolute about {}", place(*center))?;
            match range {
                Some((lo, hi)) => writeln!(text, ", from {} to {}", angle(*lo), angle(*hi)),
                None => writeln!(text),
            }
        }
        Motion::Prismatic { direction, range } => {
            write!(text, "prismatic along {}", place(*direction))?;
            match range {
                Some((lo, hi)) => {
                    let (lo, hi) = (shown::number(*lo), shown::number(*hi));
                    writeln!(text, ", from {lo} to {hi}{unit}")
                }
                None => writeln!(text),
            }
        }
    }
}

/// A number with twelve digits: what is beyond comes of adding.
fn digits(x: f64) -> f64 {
    format!("{x:.11e}").parse().unwrap_or(x)
}
