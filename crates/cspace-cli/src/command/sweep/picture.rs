//! The picture of a sweep.

use cspace_api::sweep::{Cell, Outcome, Row, Rows, Table};
use cspace_api::{Answer, Subject};
use cspace_draw::{Curve, CurveStrip, CurvesPicture, Scene};
use cspace_model::model::{Dimension, Target};
use cspace_model::shown;

use super::SweepArgs;
use crate::failure::Failure;
use crate::picture::{Plane, strip_label};

/// Refuses a picture of which the curves could not be distinguished.
pub(super) fn check(args: &SweepArgs, table: &Table) -> Result<(), Failure> {
    /// Maximum number of curves in one strip.
    const MOST: usize = 12;
    if args.question.vary.is_empty() {
        return Err(
            Failure::new("a picture needs --vary, and the rows are those of a file")
                .help("write CSV or JSON, or give --vary NAME=LO:HI:N"),
        );
    }
    let lines = table.lines().len();
    if lines > MOST {
        return Err(Failure::new(format_args!(
            "a picture has a curve for each combination of all but the last --vary, and these are {lines}"
        ))
        .help(format_args!("vary at most {MOST} combinations, or write CSV")));
    }
    Ok(())
}

/// A picture of the rows: a strip for each measure over what is varied last, with a curve for each combination of the others, and marks
/// where something changes.
pub(super) fn drawn(
    args: &SweepArgs,
    subject: &Subject,
    table: &Table,
    (rows, changes): (&Answer<Rows>, Option<&Rows>),
) -> Result<Scene, Failure> {
    let file = subject.model("its requirements are drawn")?;
    let model = &file.model;
    if rows.outcome == Outcome::Interrupted {
        return Err(Failure::new("interrupted: a picture needs all rows"));
    }
    let Some(across) = args.question.vary.last() else {
        return Err(Failure::new("nothing is varied"));
    };
    let names = &table.values.names;
    let changes = changes.map_or(&[][..], |changes| &changes.rows);
    let marks = changes
        .iter()
        .filter_map(|row| match row.cells[names.len() - 1] {
            Cell::Number(x) => Some(x),
            _ => None,
        });
    let unit = subject.unit();
    let strips = table.measures.iter().enumerate().map(|(m, name)| {
        let requirement = model.requirements.iter().find(|r| r.name == *name);
        let dimension = requirement.map_or(Dimension::Number, |r| r.dimension);
        let curves = table
            .lines()
            .zip(rows.content.rows.chunks(table.line()))
            .map(|(values, rows)| {
                let others = values[0].iter().zip(names).take(names.len() - 1);
                let label: Vec<String> = others
                    .map(|(x, name)| format!("{name} = {}", shown::number(*x)))
                    .collect();
                let value = |row: &Row| match row.cells[names.len() + m] {
                    Cell::Number(x) => Some(x),
                    Cell::Truth(is) => Some(f64::from(u8::from(is))),
                    Cell::None | Cell::Text(_) => None,
                };
                let at = values.iter().map(|r| r.last().copied().unwrap_or_default());
                Curve {
                    label: label.join(", "),
                    points: at.zip(rows.iter().map(value)).collect(),
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
        marks: marks.collect(),
    };
    let name = model.mechanism.name.clone();
    let options = args.picture.options(Plane::Positions, name, unit)?;
    Ok(cspace_draw::curves(&picture, &options))
}
