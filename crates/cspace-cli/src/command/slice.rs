//! `cspace slice`.

use std::fmt::{self, Write};

use cspace::{CurveGeometry, Slice};
use cspace_io::write::svg;

use crate::args::{Format, SliceArgs};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, Subject};
use crate::wording::{angle, count, feature};

pub(crate) fn run(args: &SliceArgs) -> Result<(), Failure> {
    let common = &args.common;
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, None)?;
    let slice = pair.slice(args.theta)?;
    let is_picture = (common.output.as_deref())
        .and_then(|o| o.extension())
        .is_some_and(|e| e.eq_ignore_ascii_case("svg"));
    let bytes = if is_picture {
        svg::slices(&svg::Page {
            title: format!("{} in {}", pair.moving().name(), pair.fixed().name()),
            size: pair.fixed().size().max(pair.moving().size()),
            slices: std::slice::from_ref(&slice),
        })
        .into_bytes()
    } else {
        match common.format {
            Format::Json => super::json(&slice)?,
            Format::Text => {
                let mut text = String::new();
                describe(&mut text, &pair, &slice).map_err(Failure::work)?;
                text.into_bytes()
            }
        }
    };
    output::write(common.output.as_deref(), &bytes)
}

fn describe(text: &mut String, pair: &Chosen<'_>, slice: &Slice) -> fmt::Result {
    writeln!(
        text,
        "{} (fixed), {} (moving) at theta = {}: {}, {}",
        pair.fixed().name(),
        pair.moving().name(),
        angle(slice.theta),
        count(slice.loops.len(), "loop", "loops"),
        count(slice.curves.len(), "curve", "curves")
    )?;
    for (i, l) in slice.loops.iter().enumerate() {
        writeln!(text, "\nloop {i}: {}", count(l.len(), "curve", "curves"))?;
        for &c in l {
            let curve = &slice.curves[c as usize];
            let (start, end) = (curve.geometry.point(0.0), curve.geometry.point(1.0));
            write!(
                text,
                "  ({:.6}, {:.6}) to ({:.6}, {:.6})",
                start.x, start.y, end.x, end.y
            )?;
            if let CurveGeometry::Arc {
                center,
                radius,
                sweep,
                ..
            } = curve.geometry
            {
                write!(
                    text,
                    ", arc about ({:.6}, {:.6}) of radius {radius:.6} by {:.4} deg",
                    center.x,
                    center.y,
                    sweep.to_degrees()
                )?;
            }
            writeln!(
                text,
                ": {} of {} on {} of {}",
                feature(curve.moving),
                pair.moving().name(),
                feature(curve.fixed),
                pair.fixed().name()
            )?;
        }
    }
    Ok(())
}
