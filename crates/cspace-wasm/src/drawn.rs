//! Slices and bounds of planar pairs, to be drawn.

use cspace::{ContactSpace, CurveGeometry, PatchId, RegionId};
use js_sys::{Array, Float64Array, Object, Reflect};
use wasm_bindgen::JsValue;

/// Largest number of pieces of an arc: enough for a picture.
const MOST_PIECES: f64 = 512.0;
/// A piece of an arc turns by no less than this (radians).
const NARROWEST: f64 = 1e-3;

/// The slice at an orientation: an array of `DrawnCurve`.
pub(crate) fn slice(space: &ContactSpace, theta: f64, deviation: f64) -> Array {
    let slice = space.slice(theta);
    (slice.curves.iter())
        .filter_map(|curve| {
            let patch = curve.patch?;
            let n = pieces(&curve.geometry, deviation);
            let points = (0..=n).flat_map(|k| {
                let p = curve.geometry.point(f64::from(k) / f64::from(n));
                [p.x, p.y]
            });
            let region = Some(space.patches()[patch.index()].region);
            Some(of_region(Some(patch), region, points))
        })
        .collect()
}

/// An object with a region, perhaps a patch, and points [x, y, x, y, ...].
pub(crate) fn of_region(
    patch: Option<PatchId>,
    region: Option<RegionId>,
    points: impl Iterator<Item = f64>,
) -> JsValue {
    let points: Vec<f64> = points.collect();
    let made = Object::new();
    let set = |key: &str, value: &JsValue| {
        // A property of a plain object can always be set.
        let _ = Reflect::set(&made, &key.into(), value);
    };
    if let Some(patch) = patch {
        set("patch", &patch.0.into());
    }
    set("region", &region.map_or(JsValue::NULL, |r| r.0.into()));
    set("points", &Float64Array::from(&points[..]));
    made.into()
}

/// The number of chords that stay within a deviation of a curve.
fn pieces(curve: &CurveGeometry, deviation: f64) -> u32 {
    let (radius, sweep) = match *curve {
        CurveGeometry::Segment { .. } => return 1,
        CurveGeometry::Arc { radius, sweep, .. } => (radius, sweep.abs()),
        CurveGeometry::FlatArc { start, end, bulge } => {
            let sweep = 4.0 * bulge.abs().atan();
            let half = (0.5 * sweep).sin();
            if half == 0.0 || start == end {
                return 1;
            }
            (0.5 * start.distance(end) / half, sweep)
        }
    };
    chords(radius, sweep, deviation)
}

/// The number of chords that stay within a deviation of an arc.
fn chords(radius: f64, sweep: f64, deviation: f64) -> u32 {
    let half = match deviation < radius {
        true => (1.0 - deviation / radius).acos(),
        false => core::f64::consts::FRAC_PI_2,
    };
    (sweep / (2.0 * half).max(NARROWEST))
        .ceil()
        .clamp(1.0, MOST_PIECES) as u32
}

/// Bounds of all positions in contact, as seen in slices: [x, y, x, y].
pub(crate) fn bounds(space: &ContactSpace) -> [f64; 4] {
    /// Positions between them are within a share of the picture that nobody sees.
    const SLICES: u32 = 96;
    let window = space.window();
    let mut all = [
        f64::INFINITY,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NEG_INFINITY,
    ];
    for k in 0..=SLICES {
        let share = f64::from(k) / f64::from(SLICES);
        let theta = (window.lo + (window.hi - window.lo) * share).min(window.hi);
        for curve in &space.slice(theta).curves {
            let n = pieces(&curve.geometry, f64::INFINITY);
            for i in 0..=n {
                let p = curve.geometry.point(f64::from(i) / f64::from(n));
                all = [
                    all[0].min(p.x),
                    all[1].min(p.y),
                    all[2].max(p.x),
                    all[3].max(p.y),
                ];
            }
        }
    }
    if all[0].is_finite() { all } else { [0.0; 4] }
}
