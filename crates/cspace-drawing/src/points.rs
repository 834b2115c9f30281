//! Measured profiles: points in CSV.

use std::sync::Arc;

use cspace::Point;

use crate::drawing::{Drawing, Entity, Origin, Path};
use crate::error::DrawingError;
use crate::unit::Unit;

/// The most points of a profile.
const MOST_POINTS: usize = 1_000_000;

/// The closed profile through the points of a file: rows of x and y, divided by semicolons, tabs, commas or blanks; decimals have a point,
/// or a comma where commas do not divide. The first row may name the columns, with their unit, and others than x and y are passed over; a row
/// without numbers before it is a title.
pub(crate) fn read(bytes: &[u8]) -> Result<Drawing, DrawingError> {
    let wrong = |line: u64, message: String, help: &str| DrawingError::File {
        line: Some(line as usize),
        message,
        help: help.to_owned(),
    };
    let text = core::str::from_utf8(bytes).map_err(|e| {
        let message = format!("byte {} is no UTF-8", e.valid_up_to());
        DrawingError::file(message, "save the points again as text")
    })?;
    let text = text.trim_start_matches('\u{feff}');
    let divides = delimiter(text);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .delimiter(divides)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut columns: Option<[usize; 2]> = None;
    let mut unit: Option<Unit> = None;
    let mut has_title = false;
    let mut points: Vec<Point> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| {
            let line = e.position().map_or(0, csv::Position::line);
            wrong(
                line,
                e.to_string(),
                "write each point as x,y in a row of its own",
            )
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        // Blanks may be several.
        let fields: Vec<&str> = record.iter().filter(|f| !f.is_empty()).collect();
        if fields.is_empty() {
            continue;
        }
        let number = |column: usize| {
            let field = *fields.get(column)?;
            match divides != b',' && field.contains(',') {
                true => field.replace(',', ".").parse::<f64>().ok(),
                false => field.parse::<f64>().ok(),
            }
        };
        let columns = match columns {
            Some(columns) => columns,
            None => {
                let named = |name: &str| fields.iter().position(|f| column_name(f) == name);
                let found = match (named("x"), named("y")) {
                    (Some(x), Some(y)) => Some([x, y]),
                    _ => None,
                };
                unit = found.and_then(|[x, _]| column_unit(fields[x])).or(unit);
                let is_title = divides == b' ' || fields.len() == 1;
                let is_data = number(0).is_some() && number(1).is_some();
                match (found, is_data) {
                    (Some(found), _) => {
                        columns = Some(found);
                        continue;
                    }
                    (None, true) => *columns.insert([0, 1]),
                    (None, false) if is_title && !has_title => {
                        has_title = true;
                        continue;
                    }
                    (None, false) => {
                        let message = "the first row names no columns x and y".to_owned();
                        return Err(wrong(
                            line,
                            message,
                            "begin the file with a row x,y, or with the first point",
                        ));
                    }
                }
            }
        };
        let [x, y] = columns.map(number);
        let (Some(x), Some(y)) = (x.filter(|x| x.is_finite()), y.filter(|y| y.is_finite())) else {
            let shown: String = fields.join(",").chars().take(40).collect();
            let message = format!("{shown:?} where a point x,y is expected");
            return Err(wrong(line, message, "give two finite numbers in each row"));
        };
        points.push(Point::new(x, y));
        if points.len() > MOST_POINTS {
            let message = format!("more than {MOST_POINTS} points");
            return Err(wrong(line, message, "leave points out"));
        }
    }
    points.dedup();
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    if points.len() < 3 {
        let message = format!("{} different points make no profile", points.len());
        return Err(DrawingError::file(
            message,
            "give three or more points around the part",
        ));
    }
    Ok(Drawing {
        unit,
        ..drawing(&points)
    })
}

/// The name of a column without its unit: `x` of `X [mm]`, `x_mm` or `x/mm`.
fn column_name(title: &str) -> String {
    let end = title.find(|c: char| !c.is_alphabetic());
    title[..end.unwrap_or(title.len())].to_ascii_lowercase()
}

/// The unit in the name of a column.
fn column_unit(title: &str) -> Option<Unit> {
    let rest = title.trim_start_matches(char::is_alphabetic);
    Unit::of_label(rest.trim_matches(|c: char| !c.is_alphabetic()))
}

/// The character that divides columns in the first row of numbers, or else in the first row.
fn delimiter(text: &str) -> u8 {
    let rows = text.lines().map(str::trim);
    let mut rows = rows.filter(|l| !l.is_empty() && !l.starts_with('#'));
    let is_numbers =
        |row: &&str| row.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let first = rows.next().unwrap_or_default();
    let first = [first]
        .into_iter()
        .chain(rows)
        .find(is_numbers)
        .unwrap_or(first);
    // Commas may be those of decimals, where something else divides.
    ([b';', b'\t', b','].into_iter())
        .find(|d| first.as_bytes().contains(d))
        .unwrap_or(b' ')
}

fn drawing(points: &[Point]) -> Drawing {
    let mut path = Path::from(points[0]);
    for p in &points[1..] {
        path.edge_to(*p, 0.0);
    }
    path.edge_to(points[0], 0.0);
    path.closed = true;
    let origin = Origin {
        kind: Arc::from("points"),
        ..Origin::default()
    };
    Drawing {
        entities: vec![Entity { origin, path }],
        is_measured: true,
        ..Drawing::default()
    }
}
