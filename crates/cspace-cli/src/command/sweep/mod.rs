//! `cspace sweep`.

mod picture;
mod rows;
mod table;

use std::path::Path;

use cspace_design::{Change, Sweep, Varied};
use cspace_io::{Model, shown};

use crate::args::{SweepArgs, TableFormat};
use crate::failure::Failure;
use crate::input;
use crate::interrupt::{catch_interrupts, is_interrupted, watched};
use crate::output;
use crate::progress::Steps;
use crate::subject::set_threads;
use crate::wording::count;

use picture::drawn;
use rows::all;
use table::{Kept, Table, csv_of, grid, json_of, kept, rows_of};

pub(crate) fn run(args: &SweepArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (template, model) = input::template(&args.file, &args.values)?;
    let table = match &args.rows {
        Some(file) => rows_of(file)?,
        None => grid(&args.vary)?,
    };
    let varied = varied(&table.names, &model, args)?;
    let measures = measures(&model, args)?;
    if let Some(name) = measures.iter().find(|m| table.names.contains(m)) {
        return Err(Failure::input(format_args!(
            "{} is both a requirement and what is varied: the table would have two such columns",
            shown::quoted(name)
        ))
        .help("give the requirement another name"));
    }
    for (name, of) in table.names.iter().zip(&varied) {
        if !of.is_of(&measures, &model) {
            return Err(Failure::input(format_args!(
                "{}: nothing is measured at a configuration with the coordinate {name}",
                args.file.display()
            ))
            .help("vary a parameter, or a coordinate of the pair that is measured"));
        }
    }
    let sweep = Sweep::new(&template, &args.values.set, &varied, &measures);
    let is_json = (args.output.as_deref().and_then(Path::extension))
        .is_some_and(|e| e.eq_ignore_ascii_case("json"));
    let format = args.format.unwrap_or(if is_json {
        TableFormat::Json
    } else {
        TableFormat::Csv
    });
    let line = args.vary.last().map_or(1, |v| v.count);
    if let Some(format) = crate::picture::format(output) {
        if args.format.is_some() {
            return Err(Failure::input(
                "--format is about tables, and the name after -o that of a picture",
            )
            .help("leave --format out"));
        }
        let drawn = drawn(args, &model, &sweep, &table, line)?;
        return crate::picture::write(output, format, &drawn);
    }
    args.picture.refuse()?;
    let extension = output.and_then(Path::extension);
    if let Some(other) = extension.map(|e| e.to_string_lossy().to_ascii_lowercase())
        && matches!(
            other.as_str(),
            "gif" | "jpg" | "jpeg" | "bmp" | "tif" | "tiff" | "webp" | "html"
        )
    {
        return Err(
            Failure::input(format_args!("-o: no files in .{other} are written"))
                .help("pictures are written in .svg, .png and .pdf, tables in .csv and .json"),
        );
    }
    if args.changes {
        return changes(&sweep, &table, line, format, output);
    }
    let kept = match output {
        _ if !args.resume => Kept::default(),
        Some(path) if format == TableFormat::Csv => kept(path, &table, &measures)?,
        _ => {
            return Err(
                Failure::input("--resume goes on with a table in CSV").help("name it: -o OUT.csv")
            );
        }
    };
    let done = watched(|| all(&sweep, &table.rows[kept.count()..]));
    let bytes = match format {
        TableFormat::Csv => csv_of(&table, &measures, (&kept, &done))?,
        TableFormat::Json => json_of(&table, &measures, &done)?,
    };
    output::write(output, &bytes)?;
    let done = kept.count() + done.len();
    if done < table.rows.len() {
        return Err(Failure::work(format_args!(
            "interrupted: {done} of {} are done and written",
            count(table.rows.len(), "row", "rows")
        ))
        .help("go on with --resume"));
    }
    Ok(())
}

/// Writes where something changes along lines of so many rows.
fn changes(
    sweep: &Sweep<'_>,
    table: &Table,
    line: usize,
    format: TableFormat,
    output: Option<&Path>,
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
    let bytes = match format {
        TableFormat::Csv => {
            let mut writer = csv::Writer::from_writer(Vec::new());
            let failed = |e: csv::Error| Failure::work(e);
            let header = table.names.iter().map(String::as_str).chain(words);
            writer.write_record(header).map_err(failed)?;
            for c in &found {
                let values = c.values.iter().map(|x| format!("{x:?}"));
                let told = [&c.measure, &c.before, &c.after].map(String::clone);
                writer.write_record(values.chain(told)).map_err(failed)?;
            }
            writer
                .into_inner()
                .map_err(|e| Failure::work(e.to_string()))?
        }
        TableFormat::Json => {
            let object = |c: &Change| {
                let values = table.names.iter().zip(&c.values);
                let mut object: serde_json::Map<String, serde_json::Value> = values
                    .map(|(name, x)| (name.clone(), (*x).into()))
                    .collect();
                let told = [&c.measure, &c.before, &c.after].map(String::clone);
                for (word, text) in words.into_iter().zip(told) {
                    object.insert(word.to_owned(), text.into());
                }
                object
            };
            super::json(&found.iter().map(object).collect::<Vec<_>>())?
        }
    };
    output::write(output, &bytes)?;
    if is_whole {
        Ok(())
    } else {
        Err(Failure::work(
            "interrupted: the changes that were found are written",
        ))
    }
}

fn varied(names: &[String], model: &Model, args: &SweepArgs) -> Result<Vec<Varied>, Failure> {
    let mut all = Vec::with_capacity(names.len());
    for (i, name) in names.iter().enumerate() {
        let Some(varied) = Varied::named(name, model) else {
            return Err(Failure::input(format_args!(
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
        return Err(Failure::input(format_args!(
            "{}: the model has no requirements",
            args.file.display()
        ))
        .help("say what is measured in [[requirement]] tables: see docs/design.md"));
    }
    if let Some(unknown) = args.measure.iter().find(|m| !known.contains(m)) {
        return Err(Failure::input(format_args!(
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
