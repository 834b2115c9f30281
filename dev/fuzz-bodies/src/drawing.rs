//! Reading drawings: DXF, SVG and points.

use cspace::Part;
use cspace_drawing::{Drawn, DxfVersion, Format, Settings, Source, dxf, from_bytes};

use crate::Finding;
use crate::draw::Bytes;
use crate::reader::edit::edit_some;

/// Begins an input that is a list of edits of a drawing.
const EDITS: u8 = 0xff;

macro_rules! drawings {
    ($($name:literal),* $(,)?) => {
        [$(include_bytes!(concat!("../../../crates/cspace-drawing/tests/drawings/", $name))),*]
    };
}

pub(crate) fn dxf_reader(data: &[u8]) -> Result<u64, Finding> {
    let bases: [&[u8]; 8] = drawings!(
        "slot_r12_binary.dxf",
        "slot_r2000_binary.dxf",
        "slot_r12.dxf",
        "blocks.dxf",
        "polyline_r12.dxf",
        "spline_circle.dxf",
        "half_ellipse.dxf",
        "overlapping.dxf",
    );
    run(data, &bases, Format::Dxf)
}

pub(crate) fn svg_reader(data: &[u8]) -> Result<u64, Finding> {
    let bases: [&[u8]; 6] = drawings!(
        "shapes.svg",
        "path_arcs.svg",
        "transforms.svg",
        "used.svg",
        "styles.svg",
        "bezier_circle.svg",
    );
    run(data, &bases, Format::Svg)
}

pub(crate) fn points_reader(data: &[u8]) -> Result<u64, Finding> {
    let bases: [&[u8]; 4] = drawings!(
        "square_points.csv",
        "square_corners_missing.csv",
        "circle_points.csv",
        "square_of_four.csv",
    );
    run(data, &bases, Format::Points)
}

/// Bytes are read as they are; after [`EDITS`] come edits of a drawing.
fn run(data: &[u8], bases: &[&[u8]], format: Format) -> Result<u64, Finding> {
    match data {
        [EDITS, edits @ ..] => {
            let mut bytes = Bytes::new(edits);
            let mut text = bases[bytes.below(bases.len())].to_vec();
            edit_some(&mut text, &mut bytes);
            judge(&text, format)
        }
        _ => judge(data, format),
    }
}

/// Checks that messages are one line with advice, and that a part written as DXF is read back unchanged.
fn judge(bytes: &[u8], format: Format) -> Result<u64, Finding> {
    let finding =
        |said: String| Finding::new(format!("{said}, of\n{}", String::from_utf8_lossy(bytes)));
    let outlines = from_bytes(bytes, format, &Source::default())
        .and_then(|drawing| drawing.outlines(&Settings::default()));
    let outlines = match outlines {
        Ok(outlines) => outlines,
        Err(error) if error.help().is_empty() || error.to_string().is_empty() => {
            return Err(finding(format!("{error:?} says nothing")));
        }
        Err(_) => return Ok(1),
    };
    for part in &outlines.parts {
        written_and_read(part).map_err(finding)?;
    }
    Ok(1)
}

/// Twice the share of a drawing's size within which coordinates in files are rounded.
const THIN: f64 = 2e-9;

fn written_and_read(part: &Part) -> Result<(), String> {
    let text = dxf(&Drawn::part(part), None, DxfVersion::R2000);
    // By the word of the file alone: nothing is to be joined.
    let settings = Settings {
        one_part: Some(part.name().to_owned()),
        join: Some(f64::MIN_POSITIVE),
        ..Settings::default()
    };
    let again = from_bytes(text.as_bytes(), Format::Dxf, &Source::default())
        .and_then(|drawing| drawing.outlines(&settings));
    let again = match again {
        Ok(again) => again,
        // Points nearer than this share of the size are one place to the reader, and what is thinner is nothing.
        Err(_) if part.area() <= THIN * part.size().powi(2) => return Ok(()),
        Err(e) => {
            return Err(format!(
                "a part is refused when it is written and read again: {e}"
            ));
        }
    };
    if again.parts[0] == *part {
        Ok(())
    } else {
        Err(format!("a part is read otherwise, from\n{text}"))
    }
}
