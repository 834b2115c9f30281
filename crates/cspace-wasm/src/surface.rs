//! A contact patch as triangles: at each orientation it is an arc or a segment between its two boundary curves.

use cspace::{
    Configuration, ContactSpace, Coordinates, CurveGeometry, PairSpace, PatchId, Point, QueryError,
};
use js_sys::{Float32Array, Object, Reflect, Uint32Array};
use wasm_bindgen::JsValue;

/// Largest number of columns of a patch: enough for a picture.
const MOST: f64 = 64.0;
/// Largest turn of a column (radians), even of a small arc, so that its shading looks round.
const WIDEST: f64 = 1.0;
/// Rows are halved at most so often.
const HALVINGS: u32 = 6;

/// A patch at one orientation.
#[derive(Clone, Copy)]
struct Row {
    theta: f64,
    curve: CurveGeometry,
}

impl Row {
    fn sweep(&self) -> f64 {
        match self.curve {
            CurveGeometry::Arc { sweep, .. } => sweep.abs(),
            _ => 0.0,
        }
    }

    fn at(&self, share: f64) -> Point {
        self.curve.point(share)
    }
}

/// The triangles of a patch, as `PatchSurface`.
pub(crate) fn of_patch(
    pair: &PairSpace,
    space: &ContactSpace,
    patch: PatchId,
    deviation: f64,
    per_radian: f64,
) -> Result<JsValue, QueryError> {
    let asked = pair.patch(patch)?;
    let (lo, hi) = asked.orientations()?;
    let row = |theta: f64| {
        let curve = space.curve_at(patch, theta).ok_or(QueryError::Outside)?;
        Ok(Row { theta, curve })
    };
    let rows = rows(&row, lo, hi, deviation)?;
    let columns = columns(&rows, deviation);
    let contact = asked.contact()?;
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    for row in &rows {
        for j in 0..=columns {
            let p = row.at(f64::from(j) / f64::from(columns));
            let at = Configuration::new(p.x, p.y, row.theta);
            let [x, y, theta] = contact.evaluate(Coordinates::Planar(at))?.gradient;
            let theta = theta / per_radian;
            let size = x.hypot(y).hypot(theta);
            positions.extend([p.x, p.y, row.theta].map(|c| c as f32));
            normals.extend([x, y, theta].map(|c| (c / size) as f32));
        }
    }
    let mut indices = Vec::new();
    for r in 1..rows.len() as u32 {
        for j in 0..columns {
            let a = (r - 1) * (columns + 1) + j;
            let c = a + columns + 1;
            // Travel × θ points to the right of travel, where free space is.
            indices.extend([a, a + 1, c, a + 1, c + 1, c]);
        }
    }
    let made = Object::new();
    let arrays: [(&str, JsValue); 3] = [
        ("positions", Float32Array::from(&positions[..]).into()),
        ("normals", Float32Array::from(&normals[..]).into()),
        ("indices", Uint32Array::from(&indices[..]).into()),
    ];
    for (key, array) in arrays {
        // A property of a plain object can always be set.
        let _ = Reflect::set(&made, &key.into(), &array);
    }
    Ok(made.into())
}

/// Orientations between which the patch is straight but for a deviation: where three points of it are.
fn rows(
    row: &impl Fn(f64) -> Result<Row, QueryError>,
    lo: f64,
    hi: f64,
    deviation: f64,
) -> Result<Vec<Row>, QueryError> {
    let straight = |a: &Row, m: &Row, b: &Row| {
        [0.0, 0.5, 1.0]
            .into_iter()
            .all(|s| a.at(s).lerp(b.at(s), 0.5).distance(m.at(s)) <= deviation)
    };
    let mut found = vec![row(lo)?];
    let mut ahead = vec![(row(hi)?, HALVINGS)];
    while let (Some(&a), Some((b, halvings))) = (found.last(), ahead.pop()) {
        let m = row(0.5 * (a.theta + b.theta))?;
        // The first halving is made at all events: a curve may swing out and back.
        if halvings > 0 && (halvings == HALVINGS || !straight(&a, &m, &b)) {
            ahead.push((b, halvings - 1));
            ahead.push((m, halvings - 1));
        } else {
            found.push(b);
        }
    }
    Ok(found)
}

/// Columns that keep all rows within a deviation of their arcs.
fn columns(rows: &[Row], deviation: f64) -> u32 {
    let mut most: f64 = 1.0;
    for row in rows {
        let rise = row.at(0.0).lerp(row.at(1.0), 0.5).distance(row.at(0.5));
        if rise > deviation {
            most = most.max((rise / deviation).sqrt().ceil());
        }
        most = most.max((row.sweep() / WIDEST).ceil());
    }
    most.min(MOST) as u32
}
