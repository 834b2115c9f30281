//! A picture of a path: the parts at start and goal, the swept part at steps, where it is narrowest.

use cspace::{Configuration, Coordinates};
use cspace_api::Chosen;
use cspace_api::plan::{Place, Plan, Question};
use cspace_draw::{ContactMark, PartsPicture, PictureFormat, parts};
use cspace_plan::legs::Scene;

use super::PlanArgs;
use crate::command::draw::at_configuration;
use crate::failure::Failure;
use crate::picture::{self, Plane};
use crate::subject::InWords;
use crate::wording::length;

/// So many outlines are shown along a path.
const STEPS: usize = 40;

pub(super) fn write(
    args: &PlanArgs,
    question: &Question,
    pair: &Chosen<'_>,
    plan: &Plan,
    format: PictureFormat,
) -> Result<(), Failure> {
    let axes = if pair.is_on_axes() { pair.axes() } else { None };
    let scene = Scene::new(pair.fixed(), pair.moving(), axes);
    let mut drawn = PartsPicture::default();
    let ends = [plan.path.first(), plan.path.last()];
    let shown: Vec<Coordinates> = if let [Some(&from), Some(&to)] = ends {
        vec![from, to]
    } else {
        // Without a path, what was asked about.
        let from = (args.verify.is_none())
            .then(|| question.start(pair))
            .transpose()?;
        from.into_iter().chain(question.goal(pair)?).collect()
    };
    for (k, &at) in shown.iter().enumerate() {
        let [fixed, moving] = &at_configuration(pair, at).parts[..] else {
            continue;
        };
        // A part that stands still is drawn once.
        if k == 0 || fixed.assembly_from_part != Configuration::default() {
            drawn.parts.push(*fixed);
        }
        drawn.parts.push(*moving);
    }
    for at in steps(&scene, &plan.path) {
        for part in at_configuration(pair, at).parts {
            let stands = part.number == 0 && part.assembly_from_part == Configuration::default();
            if !stands {
                drawn.swept.push(part);
            }
        }
    }
    let narrow = (plan.narrowest.as_ref().zip(plan.clearance))
        .map(|(place, clearance)| (place, format!("clearance {}", length(clearance))));
    let hit = (plan.contact.as_ref()).map(|hit| (&hit.place, "contact".to_owned()));
    if let Some((place, label)) = narrow.or(hit) {
        mark(&mut drawn, pair, &scene, place, label)?;
    }
    let options = (args.picture).options(Plane::Positions, pair.title(), pair.unit_label())?;
    let output = args.common.result.output.as_deref();
    picture::write(output, format, &parts(&drawn, &options))
}

/// The parts where the path is narrowest, and the points that are nearest there.
fn mark<'a>(
    drawn: &mut PartsPicture<'a>,
    pair: &'a Chosen<'_>,
    scene: &Scene,
    place: &Place,
    label: String,
) -> Result<(), Failure> {
    drawn.swept.extend(at_configuration(pair, place.at).parts);
    let numbers = (scene.numbers(place.at)).map_err(|e| pair.unanswered("the path", &e))?;
    if let Some((_, (on_fixed, on_moving))) = scene.nearest_places(numbers) {
        drawn.contacts.push(ContactMark {
            at: on_fixed,
            normal: on_moving - on_fixed,
            label,
        });
    }
    drawn
        .remarks
        .push(format!("narrowest at {}", pair.place(place.at)));
    Ok(())
}

/// Configurations along a path, evenly by how far its points move.
pub(crate) fn steps(scene: &Scene, path: &[Coordinates]) -> Vec<Coordinates> {
    let places: Vec<[f64; 3]> = path
        .iter()
        .filter_map(|&at| scene.numbers(at).ok())
        .collect();
    let levers = scene.levers();
    let long = |leg: &[[f64; 3]]| -> f64 {
        (0..3)
            .map(|k| (levers[k] * (leg[1][k] - leg[0][k])).powi(2))
            .sum::<f64>()
            .sqrt()
    };
    let whole: f64 = places.windows(2).map(long).sum();
    let mut found = Vec::new();
    for leg in places.windows(2) {
        let count = (STEPS as f64 * long(leg) / whole).ceil().max(1.0) as usize;
        for i in 0..count {
            let s = i as f64 / count as f64;
            let at = core::array::from_fn(|k| leg[0][k] + (leg[1][k] - leg[0][k]) * s);
            found.push(scene.coordinates(at));
        }
    }
    found
}
