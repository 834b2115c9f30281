//! A model made of drawings.

mod lengths;
mod place;
mod refusal;
mod report;

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use cspace::Part;
use cspace_drawing::{Drawing, FitSide, Ignored, Outlines, Pick, Settings};
use cspace_model::model::MOST_PARTS;
use cspace_model::shown::quoted;
use cspace_model::{Mechanism, PartEntry};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::frame::Answer;
use crate::host::Host;
use crate::outcome::Done;

pub use lengths::Lengths;
pub use place::Place;
pub use refusal::Refusal;
pub use report::{Apart, Entity, Fitted, Gap, Imported, PartReport, Removed};

/// How outlines are found in drawings.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Finding {
    /// Leave out a rectangle around everything, such as the sheet of material.
    #[cfg_attr(feature = "command", arg(long))]
    pub without_sheet: bool,
    /// How lengths of drawings become those of the model.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub lengths: Lengths,
    /// Ends nearer than this are one, after scaling [default: 1e-5 of the drawing's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::length, allow_negative_numbers = true))]
    pub join: Option<f64>,
    /// How far lines and arcs may be from curves and points that they are fitted to, after scaling [default: 1e-4 of the drawing's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::length, allow_negative_numbers = true))]
    pub fit: Option<f64>,
}

/// How parts are made of drawings.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The name of the model.
    #[cfg_attr(feature = "command", arg(skip))]
    pub name: String,
    /// How outlines are found.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub finding: Finding,
    /// Fit lines and arcs to loops of 64 edges and more, too: they are traces of something smooth.
    #[cfg_attr(feature = "command", arg(long))]
    pub trace: bool,
    /// On which side of a curve they may be, seen from the material.
    #[cfg_attr(feature = "command", arg(long, value_name = "SIDE", value_parser = crate::command::words::<FitSide>(), default_value = "both"))]
    pub fit_side: FitSide,
    /// Make every part larger by this all around, or smaller if it is below 0, after scaling and fitting.
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::offset, allow_negative_numbers = true))]
    pub offset: Option<f64>,
    /// Let the offset divide a part: every piece is one.
    #[cfg_attr(feature = "command", arg(long, requires = "offset"))]
    pub split: bool,
    /// Put every part elsewhere, as in at=10,5,turn=30deg,mirror=x
    ///
    /// After scaling and fitting it is mirrored at an axis (x turns y around, y turns x around), then turned about the origin, then moved. Each may be
    /// left out.
    #[cfg_attr(feature = "command", arg(long, value_name = "PLACE", value_parser = place::place, allow_hyphen_values = true))]
    pub place: Option<Place>,
    /// Make one part of this name of all loops.
    #[cfg_attr(feature = "command", arg(long, value_name = "NAME"))]
    pub part: Option<String>,
    /// Make one part of all outlines of each layer (DXF).
    #[cfg_attr(feature = "command", arg(long, conflicts_with_all = ["part", "pick"]))]
    pub by_layer: bool,
    /// Leave out what cannot be used, and list it.
    #[cfg_attr(feature = "command", arg(long))]
    pub partial: bool,
    /// Make a part of the face at a point, with its holes, after scaling; several points of one part are joined by `;`, and a part is given
    /// its name as NAME=X,Y. May be given several times.
    #[cfg_attr(feature = "command", arg(long, value_name = "X,Y", value_parser = pick, allow_hyphen_values = true, conflicts_with_all = ["part", "partial", "trace"]))]
    pub pick: Vec<Pick>,
}

/// Reads the points of faces, and the name of their part, such as `pin=12.5,-3;20,0`.
#[cfg(feature = "command")]
fn pick(text: &str) -> Result<Pick, String> {
    let (name, points) = match text.rsplit_once('=') {
        Some((name, points)) if name.trim().is_empty() => {
            return Err(format!("give a name before `={points}`"));
        }
        Some((name, points)) => (Some(name.trim().to_owned()), points),
        None => (None, text),
    };
    let at = points
        .split(';')
        .map(|point| crate::given::two(point).map(cspace::Point::from));
    match at.collect() {
        Some(at) => Ok(Pick { name, at }),
        None => Err("give a point as X,Y, such as 12.5,-3, and several joined by `;`".to_owned()),
    }
}

impl Question {
    /// The model of drawings, each with where it was read from, for messages.
    ///
    /// # Errors
    /// If something of a drawing cannot be used, or the parts are no model.
    pub fn ask(
        &self,
        drawings: &[(PathBuf, Drawing)],
        host: &dyn Host,
    ) -> Result<Answer<Imported>, Box<Refusal>> {
        let unit = (self.finding.lengths).unit(drawings.iter().map(|d| &d.1), host)?;
        let mut imported = Vec::with_capacity(drawings.len());
        for (path, drawing) in drawings {
            imported.push(self.outlines(path, drawing, unit.as_deref(), host)?);
        }
        let count: usize = imported.iter().map(|o| o.parts.len()).sum();
        if count > MOST_PARTS {
            let error = Error::new(format_args!(
                "{count} outlines make as many parts, more than {MOST_PARTS}"
            ));
            return Err(error
                .help(format_args!(
                    "read some layers alone with {}, or make one part of all with {} NAME",
                    host.option("layer"),
                    host.option("part")
                ))
                .into());
        }
        let mut mechanism = Mechanism {
            name: self.name.clone(),
            unit,
            parts: parts(&mut imported)?,
            ..Mechanism::default()
        };
        mechanism.pairs = mechanism.every_two();
        let unit = mechanism.unit.clone();
        let imported = Imported::of(mechanism, imported, &host.option("without-sheet"));
        Ok(Answer::new(unit.as_deref(), Done::Done, imported))
    }

    /// The parts of one drawing.
    fn outlines(
        &self,
        path: &Path,
        drawing: &Drawing,
        unit: Option<&str>,
        host: &dyn Host,
    ) -> Result<Outlines, Box<Refusal>> {
        let file = path.display();
        let settings = self.settings(self.finding.lengths.factor(path, drawing, unit, host));
        let reading = (drawing.reading(&settings))
            .map_err(|e| Error::new(format_args!("{file}: {e}")).help(e.help()))?;
        let mut outlines = reading.outlines().map_err(|error| {
            let chosen = refusal::Chosen {
                is_partial: self.partial,
                is_picked: !self.pick.is_empty(),
            };
            Refusal::of(path, &error, (drawing, &reading), chosen, host)
        })?;
        let is_sheet = |i: &Ignored| i.reason == cspace_drawing::SHEET;
        if self.finding.without_sheet && !outlines.ignored.iter().any(is_sheet) {
            host.note(&format_args!(
                "{file}: {} leaves nothing out: no upright rectangle is around everything",
                host.option("without-sheet")
            ));
        }
        if let Some(closed) = outlines.gaps_closed() {
            host.note(&format_args!("{file}: {closed}"));
        }
        if let Some(note) = outlines.short_pieces(&settings) {
            let join = host.option("join");
            host.warn(
                &Error::new(format_args!("{file}: {note}")).help(format_args!(
                    "if they matter, give a smaller {join}, such as {join} {:.0e}",
                    0.1 * outlines.largest_removed
                )),
            );
        }
        if let Some(by) = self.offset {
            self.offset(path, &mut outlines, by, host)?;
        }
        if let Some(place) = self.place {
            place.put(path, &mut outlines)?;
        }
        Ok(outlines)
    }

    /// How drawings are joined and fitted, whose lengths are multiplied by `scale`.
    fn settings(&self, scale: f64) -> Settings {
        Settings {
            scale,
            join: self.finding.join,
            fit: self.finding.fit,
            side: self.fit_side,
            partial: self.partial,
            one_part: self.part.clone(),
            by_layer: self.by_layer,
            without_sheet: self.finding.without_sheet,
            trace: self.trace,
            picks: self.pick.clone(),
        }
    }

    /// Replaces the parts by those at a distance; of one that is divided every piece is a part, unless all of a layer or drawing are to be one.
    fn offset(
        &self,
        path: &Path,
        outlines: &mut Outlines,
        by: f64,
        host: &dyn Host,
    ) -> Result<(), Error> {
        let file = path.display();
        let mut parts = Vec::with_capacity(outlines.parts.len());
        for part in &outlines.parts {
            let name = quoted(part.name());
            let made = cspace_drawing::offset(part, by, self.split)
                .map_err(|e| Error::new(format_args!("{file}: part {name}: {e}")).help(e.help()))?;
            for change in &made.changes {
                host.note(&format_args!(
                    "{file}: part {name}: with the offset, {change}"
                ));
            }
            if self.part.is_some() || self.by_layer {
                parts.push(made.part);
            } else {
                parts.extend(made.pieces().map_err(Error::new)?);
            }
        }
        outlines.parts = parts;
        Ok(())
    }
}

/// All parts; where two drawings call theirs the same, with the drawing's number.
fn parts(imported: &mut [Outlines]) -> Result<Vec<PartEntry>, Error> {
    let mut taken: HashSet<String> = HashSet::new();
    let mut parts = Vec::new();
    for outlines in imported {
        for part in &mut outlines.parts {
            if !taken.insert(part.name().to_owned()) {
                *part = renamed(part, &taken)?;
                taken.insert(part.name().to_owned());
            }
            parts.push(PartEntry::planar(part.clone()));
        }
    }
    Ok(parts)
}

fn renamed(part: &Part, taken: &HashSet<String>) -> Result<Part, Error> {
    let name = (2..)
        .map(|n| format!("{} {n}", part.name()))
        .find(|name| !taken.contains(name))
        .unwrap_or_default();
    let loops = (part.loops().iter())
        .map(|l| l.vertices().to_vec())
        .collect();
    Part::new(name, loops).map_err(Error::new)
}
