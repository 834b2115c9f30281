//! Contact zones, in words and as a picture.

use std::fmt::Write;

use cspace::PairSpace;
use cspace_api::Subject;
use cspace_api::tolerances::zones::{Question, Zones};
use cspace_design::area;
use cspace_draw::{Nominal, PictureOptions, ZonesPicture};
use cspace_model::model::Coordinate;

use super::TolerancesArgs;
use crate::ask::Terminal;
use crate::failure::Failure;
use crate::picture::Plane;

pub(super) fn run(
    args: &TolerancesArgs,
    subject: &Subject,
    host: &Terminal,
) -> Result<(), Failure> {
    let question = Question {
        requirement: args.analysis.requirement.clone(),
        ..args.zone.clone()
    };
    let pair = question.pair(subject, host)?;
    let slice = match &pair.space {
        PairSpace::Planar(space) => Some(space.slice(pair.theta)),
        _ => None,
    };
    let (nominal, plane) = match (&pair.space, &slice) {
        (PairSpace::FixedAxes(space), _) => (Nominal::Plane(space), Plane::Motions),
        (PairSpace::Planar(space), Some(slice)) => (Nominal::Slice(space, slice), Plane::Positions),
        _ => return Ok(()),
    };
    let name = subject.name().unwrap_or_default().to_owned();
    let options: PictureOptions = args.picture.options(plane, name, subject.unit())?;
    let answer = pair.zones(nominal.window(&options), subject, host)?;
    let output = args.result.output.as_deref();
    if let (Some(format), Some(answer)) =
        (crate::picture::format(output), answer.content.pairs.first())
    {
        let found = &answer.content.found;
        let bands = found.bands.iter();
        let bands = bands.map(|b| (b.features.join(", "), b.cells.as_slice()));
        let [a, b] = pair.coordinates.map(|of| pair.measured_at(of));
        let picture = ZonesPicture {
            nominal,
            free: &found.free,
            blocked: &found.blocked,
            bands: bands.collect(),
            mark: a.zip(b),
        };
        crate::picture::write(output, format, &cspace_draw::zones(&picture, &options))?;
    }
    if !args.zones {
        return Ok(());
    }
    crate::command::tell(&args.result, &answer, |text, found| {
        let zones = found.pairs.iter().map(|pair| described(&pair.content));
        text.extend(zones);
        Ok(())
    })
}

fn described(zones: &Zones) -> String {
    let found = &zones.found;
    let whole = area(&[zones.window]);
    let percent = |x: f64| format!("{:.3} %", 100.0 * x / whole + 0.0);
    let [a, b] = zones.coordinates.map(Coordinate::name);
    let mut text = format!("of the window in {a} and {b}\n");
    let (free, blocked) = (area(&found.free), area(&found.blocked));
    // Writing to text does not fail.
    let _ = writeln!(text, "  {:>10}  free within all tolerances", percent(free));
    let _ = writeln!(
        text,
        "  {:>10}  blocked within all tolerances",
        percent(blocked)
    );
    let _ = writeln!(text, "  {:>10}  either", percent(whole - free - blocked));
    for band in &found.bands {
        let _ = writeln!(
            text,
            "  {:>10}  {}",
            percent(area(&band.cells)),
            band.features.join(", ")
        );
    }
    text
}
