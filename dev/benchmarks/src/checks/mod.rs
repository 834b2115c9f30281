//! Single configurations: how many a second, and how many answers near contact are wrong.

mod cavalier;
mod near;
pub(crate) mod parry;

use std::hint::black_box;
use std::time::Instant;

use cspace::{Classification, Classifier, Configuration, ContactSpace, Options};
use cspace_oracle::Oracle;
use serde::Serialize;

use crate::models::Pair;
use crate::{Failure, median};

/// Configurations at random whose checks are timed.
const TIMED: usize = 20_000;

/// A checker's answers.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) pair: &'static str,
    pub(crate) checker: &'static str,
    /// Time to prepare it: the contact space, its classifier, trees of boxes.
    pub(crate) prepared_seconds: f64,
    /// Checks per second at random configurations where the parts may meet.
    pub(crate) checks_per_second: f64,
    /// Checks per second at configurations within a hundred-thousandth of the size of contact.
    pub(crate) checks_per_second_near: f64,
    pub(crate) near: Vec<Wrong>,
}

/// Answers at one distance from contact.
#[derive(Serialize)]
pub(crate) struct Wrong {
    /// Share of the larger part's box diagonal.
    pub(crate) distance: f64,
    pub(crate) configurations: usize,
    pub(crate) wrong: usize,
}

/// Method to test whether the parts overlap.
struct Checker<'a> {
    name: &'static str,
    prepared_seconds: f64,
    /// Result; `None` if the method has no answer.
    overlaps: Box<dyn Fn(Configuration) -> Option<bool> + 'a>,
}

/// Measures all checkers on a pair.
pub(crate) fn measure(pair: &Pair) -> Result<Vec<Row>, Failure> {
    let oracle = Oracle::new(&pair.fixed, &pair.moving);
    let near = near::configurations(&oracle);
    let anywhere = near::anywhere(&oracle, TIMED);

    let begin = Instant::now();
    let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default())?;
    let of_space = begin.elapsed().as_secs_f64();
    let classifier = Classifier::new(&space);
    let of_classifier = begin.elapsed().as_secs_f64();
    let blocked = |class: Option<Classification>| match class? {
        Classification::Blocked => Some(true),
        Classification::Free => Some(false),
        Classification::Contact => None,
    };
    let checkers = [
        Checker {
            name: "cspace classifier",
            prepared_seconds: of_classifier,
            overlaps: Box::new(|c| blocked(classifier.classify(c))),
        },
        Checker {
            name: "cspace classify",
            prepared_seconds: of_space,
            overlaps: Box::new(|c| blocked(space.classify(c))),
        },
        parry::checker(pair),
        cavalier::checker(pair),
    ];
    let rate = |checker: &Checker<'_>, at: &[Configuration]| {
        let runs = (0..3).map(|_| {
            let begin = Instant::now();
            for &c in at {
                black_box((checker.overlaps)(black_box(c)));
            }
            at.len() as f64 / begin.elapsed().as_secs_f64()
        });
        median(runs.collect())
    };
    let close: Vec<Configuration> = (near.iter().filter(|n| n.distance <= 1e-5))
        .map(|n| n.configuration)
        .collect();
    let rows = checkers.iter().map(|checker| Row {
        pair: pair.name,
        checker: checker.name,
        prepared_seconds: checker.prepared_seconds,
        checks_per_second: rate(checker, &anywhere),
        checks_per_second_near: rate(checker, &close),
        near: (near::DISTANCES.iter())
            .map(|&distance| {
                let mut wrong = Wrong {
                    distance,
                    configurations: 0,
                    wrong: 0,
                };
                for n in near.iter().filter(|n| n.distance == distance) {
                    wrong.configurations += 1;
                    let answer = (checker.overlaps)(n.configuration);
                    wrong.wrong += usize::from(answer != Some(n.overlap));
                }
                wrong
            })
            .collect(),
    });
    Ok(rows.collect())
}
