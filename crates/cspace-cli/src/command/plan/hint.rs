//! Hints for a request that has no path.

use std::fmt::{self, Write};

use cspace::Vector;
use cspace_api::Chosen;
use cspace_api::plan::{Outcome, Plan};
use cspace_model::shown;

use crate::subject::InWords;
use crate::wording::{degrees, length};

/// A point that legs are about is far from a part if it is so many of the part's sizes from its middle: a turn by a quarter of a radian
/// then moves the part by more than its size.
const FAR: f64 = 4.0;

pub(super) fn write(text: &mut String, pair: &Chosen<'_>, plan: &Plan) -> fmt::Result {
    let moving = pair.moving();
    let name = shown::text(moving.name());
    if let Some(twin) = &plan.twin {
        writeln!(
            text,
            "hint: {name} looks the same turned by {}, and there is a path to that: {}",
            degrees(twin.turn),
            pair.place(twin.at)
        )?;
    }
    if let (Outcome::Unknown, Some([x, y])) = (plan.verdict, plan.about) {
        let middle = moving.bounds().center();
        let about = Vector::new(x, y);
        if (about - middle.to_vector()).length() > FAR * moving.size() {
            let point = |x: f64, y: f64| format!("{},{}", length(x), length(y));
            writeln!(
                text,
                "hint: legs turn {name} about {}, far from it; leave out --about, or give its middle: --about={}",
                point(x, y),
                point(middle.x, middle.y)
            )?;
        }
    }
    Ok(())
}
