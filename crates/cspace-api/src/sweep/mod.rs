//! Requirements measured over many values of parameters and coordinates, and where something changes.

mod table;

use cspace::parallel;
use cspace_design::{Change, Row as Measured, Sweep, Varied};
use cspace_model::Model;
use cspace_model::shown::quoted;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::frame::Answer;
use crate::host::Host;
use crate::subject::{ModelFile, Subject, parameters_of, requirements_of, varied_twice};
use crate::vary::Vary;

pub use table::{Cell, Outcome, Row, Rows, Values};

/// The values that vary, and the requirements that are measured.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// A parameter, or a coordinate (x, y, theta, u, v) of the configurations at which is measured, from LO to HI in N values; of several
    /// every combination.
    #[cfg_attr(
        feature = "command",
        arg(long, value_name = "NAME=LO:HI:N", allow_hyphen_values = true)
    )]
    pub vary: Vec<Vary>,
    /// Rows of values in place of `vary`.
    #[cfg_attr(feature = "command", arg(skip))]
    pub rows: Option<Values>,
    /// A requirement that is measured; may be given several times [default: all]
    #[cfg_attr(feature = "command", arg(long, value_name = "NAME"))]
    pub measure: Vec<String>,
    /// Report in place of the rows where the structure changes as the name that is varied last goes through its range: features that touch,
    /// free regions, whether there is a value; located to 1e-9 of the range.
    #[cfg_attr(feature = "command", arg(long))]
    pub changes: bool,
    /// The first rows as they are known, each with a value for each column: they are not computed again.
    #[cfg_attr(feature = "command", arg(skip))]
    pub known: Vec<Vec<Cell>>,
}

/// A question whose rows and measures are known to be those of the model.
pub struct Table {
    /// The values of what is varied.
    pub values: Values,
    /// The names of what is measured.
    pub measures: Vec<String>,
    varied: Vec<Varied>,
    /// So many rows differ in what is varied last alone.
    line: usize,
}

impl Question {
    /// The table of the question.
    ///
    /// # Errors
    /// If the model does not have what is named, or nothing is varied.
    pub fn table(&self, subject: &Subject, host: &dyn Host) -> Result<Table, Error> {
        let file = subject.model("its requirements are measured")?;
        let model = &file.model;
        let values = match &self.rows {
            Some(rows) => rows.clone(),
            None => Values::grid(&self.vary, host)?,
        };
        values.check()?;
        let varied = varied(&values.names, file)?;
        let measures = self.measures(file, host)?;
        if let Some(name) = measures.iter().find(|m| values.names.contains(m)) {
            return Err(Error::new(format_args!(
                "{} is both a requirement and what is varied: the table would have two such columns",
                quoted(name)
            ))
            .help("give the requirement another name"));
        }
        for (name, of) in values.names.iter().zip(&varied) {
            if !of.is_of(&measures, model) {
                let what = format_args!(
                    "nothing is measured at a configuration with the coordinate {name}"
                );
                return Err(file
                    .error(what)
                    .help("vary a parameter, or a coordinate of the pair that is measured"));
            }
        }
        Ok(Table {
            values,
            measures,
            varied,
            line: self.vary.last().map_or(1, |v| v.count.max(1)),
        })
    }

    /// The names of the requirements that are measured.
    fn measures(&self, file: &ModelFile, host: &dyn Host) -> Result<Vec<String>, Error> {
        let all = file.model.requirements.iter().map(|r| r.name.clone());
        let known: Vec<String> = all.collect();
        if known.is_empty() {
            return Err(file
                .error("the model has no requirements")
                .help("say what is measured in [[requirement]] tables: see docs/design.md"));
        }
        if let Some(unknown) = self.measure.iter().find(|m| !known.contains(m)) {
            return Err(Error::new(format_args!(
                "{} {}: the model has no such requirement",
                host.option("measure"),
                quoted(unknown)
            ))
            .help(requirements_of(&file.model)));
        }
        Ok(match self.measure.is_empty() {
            true => known,
            false => self.measure.clone(),
        })
    }

    /// The rows of the question's table, or where something changes along it.
    ///
    /// # Errors
    /// If there is no such table, or the model is not one that can be read again.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Rows>, Error> {
        let table = self.table(subject, host)?;
        match self.changes {
            true => table.changes(subject, host),
            false => table.rows(subject, host, &self.known),
        }
    }
}

impl Table {
    /// The names of the columns: what is varied, what is measured, and why there is no value.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        table::columns(&self.values.names, &self.measures)
    }

    /// The rows of values in lines, in which what is varied last goes through its range.
    pub fn lines(&self) -> impl ExactSizeIterator<Item = &[Vec<f64>]> {
        self.values.rows.chunks(self.line)
    }

    /// The number of rows in a line.
    pub fn line(&self) -> usize {
        self.line
    }

    fn sweep<'a>(&'a self, subject: &'a Subject) -> Result<Sweep<'a>, Error> {
        let file = subject.model("its requirements are measured")?;
        let (template, _) = file.template()?;
        Ok(Sweep::new(
            template,
            &file.set,
            &self.varied,
            &self.measures,
        ))
    }

    /// The rows with what is measured in each; of an interrupted question the first ones. The rows that are `known` are not computed again.
    ///
    /// # Errors
    /// If the model is not one that can be read again.
    pub fn rows(
        &self,
        subject: &Subject,
        host: &dyn Host,
        known: &[Vec<Cell>],
    ) -> Result<Answer<Rows>, Error> {
        let sweep = self.sweep(subject)?;
        let mut rows = Rows::new(self.columns().map(str::to_owned));
        let all = &self.values.rows;
        known.iter().for_each(|cells| rows.push(cells.clone()));
        let missing = all.get(known.len()..).unwrap_or_default();
        for (values, row) in missing.iter().zip(measured(&sweep, missing, host)) {
            rows.push(table::cells(values, &self.measures, &row));
        }
        let has_value = |row: &Row| {
            let measured = row.cells.iter().skip(self.values.names.len());
            (measured.take(self.measures.len())).any(|cell| *cell != Cell::None)
        };
        let outcome = match rows.rows.len() < all.len() {
            true => Outcome::Interrupted,
            false if all.is_empty() || rows.rows.iter().any(has_value) => Outcome::Done,
            false => Outcome::None,
        };
        Ok(Answer::new(subject.unit(), outcome, rows))
    }

    /// Where the structure changes along each line.
    ///
    /// # Errors
    /// If the model is not one that can be read again.
    pub fn changes(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Rows>, Error> {
        let sweep = self.sweep(subject)?;
        let words = ["measure", "before", "after"].map(str::to_owned);
        let mut rows = Rows::new(self.values.names.iter().cloned().chain(words));
        let pieces = host.begin_pieces(self.values.rows.len());
        let mut outcome = Outcome::Done;
        for line in self.lines() {
            if pieces.is_interrupted() {
                outcome = Outcome::Interrupted;
                break;
            }
            for change in sweep.changes(line) {
                rows.push(change_cells(change));
            }
            pieces.done(line.len());
        }
        // A line without a change is everywhere as its first row is.
        if rows.rows.is_empty() && outcome == Outcome::Done {
            let first = self.lines().filter_map(|line| line.first().cloned());
            let found = sweep.rows(&first.collect::<Vec<_>>());
            let mut measured = found.iter().flat_map(|row| &row.measured);
            if let Some(Err(reason)) = measured.clone().next()
                && measured.all(Result::is_err)
            {
                host.note(&format_args!("nothing is measured anywhere: {reason}"));
                outcome = Outcome::None;
            }
        }
        Ok(Answer::new(subject.unit(), outcome, rows))
    }
}

fn change_cells(change: Change) -> Vec<Cell> {
    let values = change.values.into_iter().map(Cell::Number);
    let words = [change.measure, change.before, change.after].map(Cell::Text);
    values.chain(words).collect()
}

/// The rows in order, until an interrupt.
fn measured(sweep: &Sweep<'_>, rows: &[Vec<f64>], host: &dyn Host) -> Vec<Measured> {
    /// Rows are done together that take about so many seconds: an interrupt waits for them.
    const TOGETHER: f64 = 0.05;
    let pieces = host.begin_pieces(rows.len());
    let mut done = Vec::with_capacity(rows.len());
    let least = parallel::threads();
    let mut together = least;
    while done.len() < rows.len() && !pieces.is_interrupted() {
        let next = &rows[done.len()..rows.len().min(done.len() + together)];
        let begin = pieces.seconds();
        done.extend(sweep.rows(next));
        pieces.done(next.len());
        let took = pieces.seconds() - begin;
        if took < TOGETHER {
            together *= 2;
        } else if took > 2.0 * TOGETHER {
            together = (together / 2).max(least);
        }
    }
    done
}

fn varied(names: &[String], file: &ModelFile) -> Result<Vec<Varied>, Error> {
    let model: &Model = &file.model;
    let mut all = Vec::with_capacity(names.len());
    for (i, name) in names.iter().enumerate() {
        let Some(varied) = Varied::named(name, model) else {
            let what = format_args!("there is no parameter or coordinate {}", quoted(name));
            return Err(file.error(what).help(parameters_of(model)));
        };
        if names[..i].contains(name) {
            return Err(varied_twice(name));
        }
        all.push(varied);
    }
    Ok(all)
}
