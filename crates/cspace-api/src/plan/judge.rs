//! Whether a path that is given is free.

use std::time::Instant;

use cspace::Coordinates;
use cspace_plan::legs::Scene;
use cspace_plan::{Checked, PlanError, check, touching_distance};
use schemars::JsonSchema;
use serde::Deserialize;

use super::answer::{Parts, Plan};
use crate::error::Error;
use crate::frame::{Answer, Pairs};
use crate::subject::{Chosen, about};

/// Which path is judged. No contact space is computed for it.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct Judge {
    /// Configurations of the pair, from the start to the goal.
    pub path: Vec<Coordinates>,
    /// Name of the path in messages, such as its file.
    pub source: String,
    /// The point of the moving part, in its frame, that legs move straight and about which they turn the part; its origin without.
    #[serde(default)]
    pub about: Option<[f64; 2]>,
}

impl Judge {
    /// The verdict on the path of each of these pairs.
    ///
    /// # Errors
    /// If the path is too far from the parts, or no path of the pair.
    pub fn ask(&self, pairs: &[Chosen<'_>]) -> Result<Answer<Pairs<Plan>>, Error> {
        about(pairs, |pair| {
            let plan = self.of(pair)?;
            Ok(pair.answer(plan.verdict, plan))
        })
    }

    fn of(&self, pair: &Chosen<'_>) -> Result<Plan, Error> {
        pair.check_window()?;
        let axes = if pair.is_on_axes() { pair.axes() } else { None };
        let scene_of = |moving| {
            let scene = Scene::new(pair.fixed(), moving, axes);
            match pair.window() {
                Some(window) => scene.with_window(window),
                None => scene,
            }
        };
        let mut scene = scene_of(pair.moving());
        if let Some(about) = pair.about(self.about)? {
            scene = scene.with_about(about);
        }
        let begin = Instant::now();
        let judged = |scene: &Scene| {
            check(scene, &self.path).map_err(|error| match &error {
                PlanError::Pair(e) => pair.unanswered(&self.source, e),
                _ => Error::new(format_args!("{}: {error}", self.source))
                    .help("let the path stay nearer to the parts"),
            })
        };
        let mut found = judged(&scene)?;
        // A path from an exact fit was found with a gap, and is judged with it.
        let mut gap = None;
        let ends = [self.path.first(), self.path.last()];
        let touches = |at: &Coordinates| {
            let distance = touching_distance(pair.fixed(), pair.moving());
            (scene.numbers(*at)).is_ok_and(|numbers| scene.touches(numbers, distance))
        };
        if !matches!(found, Checked::Free(_))
            && ends.into_iter().flatten().any(touches)
            && let Some((smaller, by)) = cspace_plan::with_gap(pair.fixed(), pair.moving())
        {
            let narrower = scene_of(&smaller).with_about(scene.about());
            (found, gap) = (judged(&narrower)?, Some(by));
            scene = narrower;
        }
        let parts = Parts {
            fixed: pair.fixed(),
            moving: pair.moving(),
        };
        let seconds = begin.elapsed().as_secs_f64();
        let legs = (scene, pair.unit_label());
        let mut plan = Plan::judged(parts, legs, self.path.clone(), &found, seconds);
        plan.gap = gap;
        Ok(plan)
    }
}
