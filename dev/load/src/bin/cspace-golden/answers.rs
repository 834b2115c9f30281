//! Answers of the library for one pair.

use core::f64::consts::PI;

use cspace::{Configuration, Coordinates, Location, Options, PairSpace, PatchId, Slice};
use cspace_model::saved;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use serde_json::{Value, json};

use crate::items::{Asked, Item, Question};
use crate::motion::motion;
use crate::queries::queries;

/// Configurations that are classified of each pair.
const CONFIGURATIONS: usize = 50;
/// Slices of the space, and as many from scratch.
const SLICES: usize = 2;

/// Answers for one pair as one value.
pub(crate) struct Answers(pub(crate) Value);

impl Answers {
    pub(crate) fn to_json(&self) -> String {
        self.0.to_string()
    }
}

pub(crate) fn answers(item: &Item) -> Answers {
    let question = match &item.what {
        Ok(Asked::Pair(question)) => question,
        Ok(Asked::Motion(mechanism)) => return Answers(motion(mechanism)),
        Err(message) => return Answers(json!({ "refused": message })),
    };
    let options = Options {
        window: question.window,
        ..Options::default()
    };
    let computed = PairSpace::compute(
        &question.fixed,
        &question.moving,
        question.relation,
        &options,
    );
    Answers(match computed {
        Err(error) => json!({ "refused": error.to_string() }),
        Ok(space) => {
            let mut rng = ChaCha8Rng::seed_from_u64(item.seed);
            json!({
                "space": without_statistics(&space),
                "slices": slices(question, &space, &mut rng),
                "classes": classes(question, &space, &mut rng),
                "queries": queries(&space, &mut rng),
            })
        }
    })
}

/// Saved space without its statistics (seconds, and numbers of computations), and without the checksum, which depends
/// on these.
fn without_statistics(space: &PairSpace) -> Value {
    let mut value: Value = serde_json::from_str(&saved::pair_to_json(space)).unwrap_or(Value::Null);
    if let Some(fields) = value.as_object_mut() {
        fields.remove("statistics");
        fields.remove("checksum");
    }
    value
}

fn slices(question: &Question, space: &PairSpace, rng: &mut ChaCha8Rng) -> Value {
    let PairSpace::Planar(space) = space else {
        return Value::Null;
    };
    let window = space.window();
    let told = |slice: &Slice| {
        json!({
            "theta": slice.theta,
            "curves": slice.curves,
            "loops": slice.loops,
            "doubtful": slice.doubtful,
        })
    };
    let all = (0..SLICES).flat_map(|_| {
        let theta = rng.random_range(window.lo..window.hi);
        let scratch = Slice::compute(&question.fixed, &question.moving, theta);
        [told(&space.slice(theta)), told(&scratch)]
    });
    Value::Array(all.collect())
}

/// A letter for every configuration, and the free region.
fn classes(question: &Question, space: &PairSpace, rng: &mut ChaCha8Rng) -> Value {
    let size = question.fixed.size().max(question.moving.size());
    let mut all = Vec::new();
    for i in 0..CONFIGURATIONS {
        let (x, y) = (rng.random_range(-size..size), rng.random_range(-size..size));
        let theta = rng.random_range(-PI..PI);
        let location = match space {
            PairSpace::FixedAxes(space) => {
                // Every other one on a contact curve.
                let ends = space.branches().get(7 * i).map(|b| b.start);
                let (u, v) = ends.filter(|_| i % 2 == 0).unwrap_or((x, y));
                space.locate(u, v)
            }
            PairSpace::Planar(space) => {
                let on = space.patch(PatchId(7 * i as u32)).map(|p| {
                    let c = p.left().at(p.data().lo);
                    Configuration::new(c.x + 1e-6 * x, c.y + 1e-6 * y, c.theta)
                });
                let c = on.filter(|_| i % 2 == 0);
                let c = c.unwrap_or(Configuration::new(x, y, theta));
                space.locate(c)
            }
            PairSpace::Lower(_) => {
                let c = Coordinates::Planar(Configuration::new(x, y, theta));
                space.locate(c).unwrap_or(Location::Outside)
            }
        };
        all.push(json!([location.class(), location.region()]));
    }
    Value::Array(all)
}
