//! The picture of a sweep.

use cspace_design::{Row, Sweep, Value};
use cspace_draw::{Curve, CurveStrip, CurvesPicture, Scene};
use cspace_model::model::{Dimension, Target};
use cspace_model::{Model, shown};

use super::rows::all;
use super::table::Table;
use crate::args::SweepArgs;
use crate::failure::Failure;
use crate::interrupt::watched;
use crate::picture::{Plane, strip_label};

/// A picture of the rows: a strip for each measure over what is varied last, with a curve for each combination of the others.
pub(super) fn drawn(
    args: &SweepArgs,
    model: &Model,
    sweep: &Sweep<'_>,
    table: &Table,
    line: usize,
) -> Result<Scene, Failure> {
    /// Maximum number of curves in one strip: more are not distinguishable.
    const MOST: usize = 12;
    let Some(across) = args.vary.last() else {
        return Err(
            Failure::new("a picture needs --vary, and the rows are those of a file")
                .help("write CSV or JSON, or give --vary NAME=LO:HI:N"),
        );
    };
    let lines: Vec<&[Vec<f64>]> = table.rows.chunks(line.max(1)).collect();
    if lines.len() > MOST {
        return Err(Failure::new(format_args!(
            "a picture has a curve for each combination of all but the last --vary, and these are {}",
            lines.len()
        ))
        .help(format_args!("vary at most {MOST} combinations, or write CSV")));
    }
    let done = watched(|| all(sweep, &table.rows));
    if done.len() < table.rows.len() {
        return Err(Failure::new("interrupted: a picture needs all rows"));
    }
    let mut marks = Vec::new();
    if args.changes {
        for rows in &lines {
            let found = watched(|| sweep.changes(rows));
            marks.extend(found.iter().filter_map(|c| c.values.last().copied()));
        }
    }
    let unit = model.mechanism.unit.as_deref();
    let strips = sweep.measures().iter().enumerate().map(|(m, name)| {
        let requirement = model.requirements.iter().find(|r| r.name == *name);
        let dimension = requirement.map_or(Dimension::Number, |r| r.dimension);
        let curves = lines
            .iter()
            .zip(done.chunks(line.max(1)))
            .map(|(rows, done)| {
                let others = rows[0].iter().zip(&table.names).take(table.names.len() - 1);
                let label: Vec<String> = others
                    .map(|(x, name)| format!("{name} = {}", shown::number(*x)))
                    .collect();
                let value = |row: &Row| match row.measured[m] {
                    Ok(Value::Number(x)) => Some(x),
                    Ok(Value::Truth(b)) => Some(f64::from(u8::from(b))),
                    Err(_) => None,
                };
                let at = rows.iter().map(|r| r.last().copied().unwrap_or_default());
                Curve {
                    label: label.join(", "),
                    points: at.zip(done.iter().map(value)).collect(),
                }
            });
        CurveStrip {
            label: strip_label(name, dimension, unit),
            is_angle: dimension == Dimension::Angle,
            limits: match requirement.and_then(|r| r.target) {
                Some(Target::Limits(lo, hi)) => Some((lo, hi)),
                _ => None,
            },
            seen: (dimension == Dimension::Truth).then_some((-0.1, 1.1)),
            curves: curves.collect(),
        }
    });
    let picture = CurvesPicture {
        across: if across.is_angle {
            format!("{}, deg", across.name)
        } else {
            across.name.clone()
        },
        is_angle: across.is_angle,
        strips: strips.collect(),
        marks,
    };
    let options = args
        .picture
        .options(Plane::Positions, model.mechanism.name.clone(), unit)?;
    Ok(cspace_draw::curves(&picture, &options))
}
