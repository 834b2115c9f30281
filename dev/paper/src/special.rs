//! The time saved by the special methods: the survey's shares, with the times measured here.

use std::error::Error;

use cspace::{PairClass, PairError, PairSpace, Relation};
use cspace_baseline::survey::{MODELS, SURVEY, saving};
use cspace_model::model;
use serde::Serialize;

use crate::timing::{median, timed};

#[derive(Serialize)]
pub(crate) struct Survey {
    /// The survey's own figures, with their source.
    pub(crate) mechanisms: cspace_baseline::survey::Survey,
    /// Special pairs, by their own method and by the general one.
    pub(crate) special_pairs: Vec<Special>,
    /// Means over those that a joint connects.
    pub(crate) lower: Means,
    /// Means over those with fixed axes.
    pub(crate) fixed_axes: Means,
    /// Share of the survey's planar pairs that special methods cover, counting one pair of each mechanism that has only such.
    pub(crate) special_share: f64,
    /// Average saving over all pairs; the survey does not say how many special pairs are of which class.
    pub(crate) saving: Saving,
    pub(crate) paper_share: f64,
    pub(crate) paper_saving: f64,
}

/// Mean seconds over some special pairs.
#[derive(Serialize)]
pub(crate) struct Means {
    /// By their own method.
    pub(crate) seconds: f64,
    /// By the method for three degrees of freedom.
    pub(crate) general_seconds: f64,
}

#[derive(Serialize)]
pub(crate) struct Saving {
    /// Were all special pairs as those with fixed axes here.
    pub(crate) all_fixed_axes: f64,
    /// Were all as those that a joint connects.
    pub(crate) all_lower: f64,
}

#[derive(Serialize)]
pub(crate) struct Special {
    pub(crate) model: &'static str,
    pub(crate) pair: String,
    pub(crate) class: &'static str,
    pub(crate) seconds: f64,
    pub(crate) general_seconds: f64,
    #[serde(skip)]
    kind: PairClass,
}

pub(crate) fn survey(repeat: u16) -> Result<Survey, Box<dyn Error>> {
    let mut special_pairs = Vec::new();
    for (name, text) in MODELS {
        let model = model::from_toml(text, name)?;
        for pair in &model.pairs {
            let kind = model.pair_class(pair);
            if !matches!(kind, PairClass::Lower | PairClass::FixedAxes) {
                continue;
            }
            let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &model.parts[i].part);
            let [seconds, general_seconds] = [model.relation(pair), Relation::Planar].map(|r| {
                let runs = (0..repeat).map(|_| {
                    let options = cspace::Options::default();
                    let (seconds, space) = timed(|| PairSpace::compute(fixed, moving, r, &options));
                    space.map(|_| seconds)
                });
                runs.collect::<Result<Vec<f64>, PairError>>().map(median)
            });
            special_pairs.push(Special {
                model: name,
                pair: format!("{},{}", fixed.name(), moving.name()),
                class: kind.name(),
                seconds: seconds?,
                general_seconds: general_seconds?,
                kind,
            });
        }
    }
    let means = |kind: PairClass| {
        let mean = |of: fn(&Special) -> f64| {
            let members = special_pairs.iter().filter(|s| s.kind == kind).map(of);
            let (n, sum) = members.fold((0.0, 0.0), |(n, sum), s| (n + 1.0, sum + s));
            sum / n
        };
        Means {
            seconds: mean(|s| s.seconds),
            general_seconds: mean(|s| s.general_seconds),
        }
    };
    let [lower, fixed_axes] = [PairClass::Lower, PairClass::FixedAxes].map(means);
    let special_share = SURVEY.special_share(1.0);
    Ok(Survey {
        mechanisms: SURVEY,
        special_pairs,
        special_share,
        saving: Saving {
            all_fixed_axes: saving(
                special_share,
                fixed_axes.seconds,
                fixed_axes.general_seconds,
            ),
            all_lower: saving(special_share, lower.seconds, lower.general_seconds),
        },
        lower,
        fixed_axes,
        paper_share: SURVEY.paper_share,
        paper_saving: SURVEY.paper_saving,
    })
}
