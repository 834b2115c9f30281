//! `cspace sweep`.

mod picture;
mod rows;
mod table;

use crate::legacy::{Answer, Outcome};
use cspace_design::{Change, Sweep, Varied};
use cspace_io::{Model, shown};
use serde_json::{Map, Value};

use crate::args::{Format, SweepArgs};
use crate::ask::set_threads;
use crate::failure::Failure;
use crate::input;
use crate::interrupt::{catch_interrupts, is_interrupted, watched};
use crate::output;
use crate::progress::Steps;
use crate::wording::count;

use picture::drawn;
use rows::all;
use table::{Kept, Table, csv_of, grid, kept, objects, read};

pub(crate) fn run(args: &SweepArgs) -> Result<(), Failure> {
    let output = (args.result).artefact(&["csv", "json", "svg", "png", "pdf"])?;
    let picture = crate::picture::format(output);
    if picture.is_none() {
        args.picture.refuse()?;
    }
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (template, model) = input::template(&args.file, &args.values)?;
    let table = match &args.rows {
        Some(file) => read(file)?,
        None => grid(&args.vary)?,
    };
    let varied = varied(&table.names, &model, args)?;
    let measures = measures(&model, args)?;
    if let Some(name) = measures.iter().find(|m| table.names.contains(m)) {
        return Err(Failure::new(format_args!(
            "{} is both a requirement and what is varied: the table would have two such columns",
            shown::quoted(name)
        ))
        .help("give the requirement another name"));
    }
    for (name, of) in table.names.iter().zip(&varied) {
        if !of.is_of(&measures, &model) {
            return Err(Failure::new(format_args!(
                "{}: nothing is measured at a configuration with the coordinate {name}",
                args.file.display()
            ))
            .help("vary a parameter, or a coordinate of the pair that is measured"));
        }
    }
    let sweep = Sweep::new(&template, &args.values.set, &varied, &measures);
    let unit = model.mechanism.unit.as_deref();
    let line = args.vary.last().map_or(1, |v| v.count);
    if let Some(format) = picture {
        let drawn = drawn(args, &model, &sweep, &table, line)?;
        crate::picture::write(output, format, &drawn)?;
    }
    if args.changes {
        return changes(args, unit, &sweep, &table, line);
    }
    let kept = match output {
        _ if !args.resume => Kept::default(),
        Some(path) if output::ends_in(path, "csv") => kept(path, &table, &measures)?,
        _ => {
            return Err(
                Failure::new("--resume goes on with a table in CSV").help("name it: -o OUT.csv")
            );
        }
    };
    let done = watched(|| all(&sweep, &table.rows[kept.count()..]));
    let csv = csv_of(&table, &measures, (&kept, &done))?;
    let rows = || objects(&table, &measures, (&kept, &done));
    let count_done = kept.count() + done.len();
    let is_whole = count_done == table.rows.len();
    written(args, unit, &csv, is_whole, rows)?;
    if !is_whole {
        let interrupted = Failure::new(format_args!(
            "interrupted: {count_done} of {} are done",
            count(table.rows.len(), "row", "rows")
        ));
        return Err(match output {
            Some(path) if output::ends_in(path, "csv") => interrupted.help(format_args!(
                "they are in {}: go on with --resume",
                path.display()
            )),
            _ => interrupted.help("with -o OUT.csv they are kept, and --resume goes on"),
        });
    }
    Ok(())
}

/// Prints a table, and writes it to the file that is asked for beside it.
fn written(
    args: &SweepArgs,
    unit: Option<&str>,
    csv: &[u8],
    is_whole: bool,
    rows: impl FnOnce() -> Vec<Map<String, Value>>,
) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        output::write(Some(path), csv)?;
    }
    let is_json = output.is_some_and(|path| output::ends_in(path, "json"));
    if args.result.format() == Format::Text && !is_json {
        return output::write(None, csv);
    }
    let outcome = match is_whole {
        true => Outcome::DONE,
        false => Outcome::open("interrupted"),
    };
    let answer = Answer::new("sweep", unit, outcome, super::Rows { rows: rows() });
    let printed = super::print(&args.result, &answer, |text| {
        text.push_str(&String::from_utf8_lossy(csv));
        Ok(())
    });
    // Where it is interrupted the failure says so.
    match is_whole {
        true => printed,
        false => Ok(()),
    }
}

/// Prints where something changes along lines of so many rows.
fn changes(
    args: &SweepArgs,
    unit: Option<&str>,
    sweep: &Sweep<'_>,
    table: &Table,
    line: usize,
) -> Result<(), Failure> {
    let steps = Steps::new(table.rows.len());
    let mut found: Vec<Change> = Vec::new();
    let is_whole = watched(|| {
        for rows in table.rows.chunks(line.max(1)) {
            if is_interrupted() {
                return false;
            }
            found.extend(steps.steps(rows.len() as u64, || sweep.changes(rows)));
        }
        true
    });
    let words = ["measure", "before", "after"];
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |e: csv::Error| Failure::new(e);
    let header = table.names.iter().map(String::as_str).chain(words);
    writer.write_record(header).map_err(failed)?;
    for c in &found {
        let values = c.values.iter().map(|x| format!("{x:?}"));
        let told = [&c.measure, &c.before, &c.after].map(String::clone);
        writer.write_record(values.chain(told)).map_err(failed)?;
    }
    let csv = (writer.into_inner()).map_err(|e| Failure::new(e.to_string()))?;
    let object = |c: &Change| {
        let values = table.names.iter().zip(&c.values);
        let values = values.map(|(name, x)| (name.clone(), (*x).into()));
        let told = [&c.measure, &c.before, &c.after].map(|text| text.as_str().into());
        values
            .chain(words.map(str::to_owned).into_iter().zip(told))
            .collect()
    };
    written(args, unit, &csv, is_whole, || {
        found.iter().map(object).collect()
    })?;
    if is_whole {
        Ok(())
    } else {
        Err(Failure::new(
            "interrupted: the changes that were found are written",
        ))
    }
}

fn varied(names: &[String], model: &Model, args: &SweepArgs) -> Result<Vec<Varied>, Failure> {
    let mut all = Vec::with_capacity(names.len());
    for (i, name) in names.iter().enumerate() {
        let Some(varied) = Varied::named(name, model) else {
            return Err(Failure::new(format_args!(
                "{}: there is no parameter or coordinate {}",
                args.file.display(),
                shown::quoted(name)
            ))
            .help(super::parameters_of(model)));
        };
        if names[..i].contains(name) {
            return Err(super::varied_twice(name));
        }
        all.push(varied);
    }
    Ok(all)
}

/// The requirements that are measured.
fn measures(model: &Model, args: &SweepArgs) -> Result<Vec<String>, Failure> {
    let known: Vec<String> = model.requirements.iter().map(|r| r.name.clone()).collect();
    if known.is_empty() {
        return Err(Failure::new(format_args!(
            "{}: the model has no requirements",
            args.file.display()
        ))
        .help("say what is measured in [[requirement]] tables: see docs/design.md"));
    }
    if let Some(unknown) = args.measure.iter().find(|m| !known.contains(m)) {
        return Err(Failure::new(format_args!(
            "--measure {}: the model has no such requirement",
            shown::quoted(unknown)
        ))
        .help(super::requirements_of(model)));
    }
    Ok(if args.measure.is_empty() {
        known
    } else {
        args.measure.clone()
    })
}
