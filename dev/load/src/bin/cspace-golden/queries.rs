//! Questions to a space beside classification: contacts, features, motions, projections, plans, and values of contact functions.

use core::f64::consts::PI;

use cspace::fixed_axes::BranchForm;
use cspace::{Configuration, Coordinates, Metric, PairPatch, PairSpace, PatchId};
use cspace_plan::{Planner, Wishes};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

/// Number of configurations for queries of contacts, features and projections.
const PLACES: usize = 8;
/// Patches that are projected on and whose contact functions are evaluated.
const PATCHES: usize = 8;
/// Motions of constant rates.
const MOTIONS: usize = 6;
/// Number of plans between two free configurations, which are searched among several drawn ones.
const PLANS: usize = 1;
const TRIES: usize = 40;
/// Contacts are those up to this share of the size off, features up to [`NEAR`].
const ON: f64 = 1e-6;
const NEAR: f64 = 0.2;

/// Draws coordinates of the class of a space.
struct Drawn<'a> {
    space: &'a PairSpace,
    size: f64,
    rng: &'a mut ChaCha8Rng,
}

impl Drawn<'_> {
    fn coordinates(&mut self) -> Coordinates {
        let size = self.size;
        let mut place = || self.rng.random_range(-size..size);
        let (x, y) = (place(), place());
        let theta = self.rng.random_range(-PI..PI);
        match self.space {
            PairSpace::FixedAxes(_) => Coordinates::Axes { u: x, v: y },
            _ => Coordinates::Planar(Configuration::new(x, y, theta)),
        }
    }

    /// A configuration in the middle of a patch.
    fn on(&self, patch: PatchId, metric: Metric) -> Option<Coordinates> {
        match self.space {
            PairSpace::Planar(space) => {
                let (lo, hi) = self.space.patch(patch).ok()?.orientations().ok()?;
                let theta = lo + 0.375 * (hi - lo);
                let of = space.patch(patch)?;
                let [a, b] = [of.left(), of.right()].map(|end| end.at(theta).position());
                let middle = a.midpoint(b);
                let middle = Configuration::new(middle.x, middle.y, theta);
                let found = self
                    .space
                    .project(Coordinates::Planar(middle), patch, metric);
                Some(found.ok()?.at)
            }
            PairSpace::FixedAxes(space) => {
                let branch = space.patches()[patch.index()].branches.start;
                let b = space.branches().get(branch as usize)?;
                let [from, to] = match b.form {
                    BranchForm::VOfU => [b.start.0, b.end.0],
                    BranchForm::UOfV => [b.start.1, b.end.1],
                };
                let ((u, v), _) = space.branch_at(branch as usize, from + 0.375 * (to - from))?;
                Some(Coordinates::Axes { u, v })
            }
            PairSpace::Lower(_) => None,
        }
    }
}

/// The answers as one value.
pub(crate) fn queries(space: &PairSpace, rng: &mut ChaCha8Rng) -> Value {
    if matches!(space, PairSpace::Lower(_)) {
        return Value::Null;
    }
    let size = space.fixed().size().max(space.moving().size());
    let metric = Metric {
        length_per_radian: 0.3 * size,
    };
    let mut drawn = Drawn { space, size, rng };
    let count = space.patch_count();
    let patches: Vec<PatchId> = (space.patches().map(|p| p.id()))
        .step_by(count.div_ceil(PATCHES).max(1))
        .collect();
    let on: Vec<(PatchId, Coordinates)> = (patches.iter())
        .filter_map(|&p| Some((p, drawn.on(p, metric)?)))
        .collect();
    let mut places: Vec<Coordinates> = (0..PLACES).map(|_| drawn.coordinates()).collect();
    places.extend(on.iter().map(|p| p.1));
    let of_places: Vec<Value> = (places.iter())
        .map(|&at| of_place(space, at, size, metric))
        .collect();
    let of_patches: Vec<Value> = (on.iter())
        .map(|&(patch, at)| of_patch(space, patch, at, places[0], metric))
        .collect();
    let motions: Vec<Value> = (0..MOTIONS)
        .map(|i| {
            // Through the middle of a patch, which no other ends at.
            let from = places[i];
            let rates = on
                .get(i)
                .map_or_else(|| drawn.coordinates(), |p| rates(from, p.1));
            json!({
                "crossings": said(space.crossings(from, rates, 1.5)),
                "first": said(space.first_contact(from, rates, 1.5)),
            })
        })
        .collect();
    json!({
        "places": of_places,
        "patches": of_patches,
        "motions": motions,
        "plans": plans(space, &mut drawn),
    })
}

/// The rates of a motion that comes from one configuration to another in 0.75 units of time.
fn rates(from: Coordinates, to: Coordinates) -> Coordinates {
    let rate = |from: f64, to: f64| (to - from) / 0.75;
    match (from, to) {
        (Coordinates::Planar(a), Coordinates::Planar(b)) => Coordinates::Planar(
            Configuration::new(rate(a.x, b.x), rate(a.y, b.y), rate(a.theta, b.theta)),
        ),
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: w, v: z }) => Coordinates::Axes {
            u: rate(u, w),
            v: rate(v, z),
        },
        _ => to,
    }
}

/// Serialized result, or the message of an error.
pub(crate) fn said<T: serde::Serialize, E: core::fmt::Display>(result: Result<T, E>) -> Value {
    match result {
        Ok(value) => serde_json::to_value(value).unwrap_or(Value::Null),
        Err(error) => json!({ "refused": error.to_string() }),
    }
}

fn of_place(space: &PairSpace, at: Coordinates, size: f64, metric: Metric) -> Value {
    let contacts = space.contacts(at, ON * size).map(|mut all| {
        all.sort_by_key(|c| c.0);
        all
    });
    let features = space.near_features(at, NEAR * size).map(|mut all| {
        all.sort_by_key(|f| (f.fixed.name, f.moving.name));
        let each = all.iter().map(|f| {
            let (p, q, n) = (f.touching.on_fixed, f.touching.on_moving, f.touching.normal);
            let names = [f.fixed.name.to_string(), f.moving.name.to_string()];
            json!([names, f.distance, [p.x, p.y], [q.x, q.y], [n.x, n.y]])
        });
        each.collect::<Vec<Value>>()
    });
    json!({
        "contacts": said(contacts),
        "features": said(features),
        "nearest": said(space.nearest_contact(at)),
        "nearest_patch": said(space.nearest_patch(at, metric).map(|found| {
            found.map(|(patch, projection)| json!([patch, projected(projection)]))
        })),
    })
}

fn projected(p: cspace::Projection) -> Value {
    json!([p.at, p.distance])
}

fn of_patch(
    space: &PairSpace,
    patch: PatchId,
    on: Coordinates,
    off: Coordinates,
    metric: Metric,
) -> Value {
    let values = |p: &PairPatch<'_>, at: Coordinates| -> Value {
        let Ok(contact) = p.contact() else {
            return Value::Null;
        };
        let value = contact
            .evaluate(at)
            .map(|f| json!([f.value, f.gradient, f.hessian]));
        let touching = contact.touching(at).map(|t| {
            let (p, q, n) = (t.on_fixed, t.on_moving, t.normal);
            json!([[p.x, p.y], [q.x, q.y], [n.x, n.y]])
        });
        let by_drawing = contact.by_drawing(at).map(|b| {
            let all = |side: &[cspace::ByVertex]| -> Vec<Value> {
                let each = |v: &cspace::ByVertex| json!([v.vertex, v.by_position, v.by_bulge]);
                side.iter().map(each).collect()
            };
            json!([all(&b.fixed), all(&b.moving), b.fixed_axis, b.moving_axis])
        });
        json!([said(value), said(touching), said(by_drawing)])
    };
    let Ok(p) = space.patch(patch) else {
        return Value::Null;
    };
    json!({
        "on": values(&p, on),
        "off": values(&p, off),
        "value": said(p.contact().and_then(|c| c.value(off))),
        "projection": said(space.project(off, patch, metric).map(projected)),
    })
}

/// Plans between configurations that are free.
fn plans(space: &PairSpace, drawn: &mut Drawn<'_>) -> Value {
    let planner = match Planner::new(space) {
        Ok(planner) => planner,
        Err(error) => return json!({ "refused": error.to_string() }),
    };
    let free: Vec<Coordinates> = (0..TRIES)
        .map(|_| drawn.coordinates())
        .filter(|&at| space.classify(at) == Ok(cspace::Classification::Free))
        .take(2 * PLANS)
        .collect();
    let each = free
        .chunks_exact(2)
        .map(|ends| said(planner.plan(ends[0], ends[1], &Wishes::default())));
    Value::Array(each.collect())
}
