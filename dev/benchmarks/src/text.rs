//! The results for people.

use std::fmt::{self, Write};

use crate::stack::Tried;
use crate::{Results, checks, grids, memory, stack};

pub(crate) fn describe(results: &Results) -> Result<String, fmt::Error> {
    let mut text = String::new();
    if !results.stacks.is_empty() {
        stacks(&mut text, results)?;
        slices(&mut text, &results.stacks)?;
    }
    if !results.checks.is_empty() {
        checks(&mut text, &results.checks)?;
    }
    if !results.grids.is_empty() {
        grids(&mut text, &results.grids)?;
    }
    if !results.memory.is_empty() {
        memory(&mut text, &results.memory)?;
    }
    for why in &results.left_out {
        writeln!(text, "{why}")?;
    }
    Ok(text)
}

fn stacks(text: &mut String, results: &Results) -> fmt::Result {
    writeln!(
        text,
        "The whole space, one thread: seconds, and a stack of polygon Minkowski sums (arcs are chords within {:e} of the\n\
         size) refined until its regions are as many as the exact ones, it is right about the configuration in which the parts\n\
         work, and both stay so, under a limit of {} s\n",
        results.chord, results.limit
    )?;
    writeln!(
        text,
        "{:24}{:>8}{:>9}{:>10}   {:10}{:>8}{:>11}{:>9}   finest tried: slices, regions, working, seconds",
        "pair", "regions", "working", "cspace", "tool", "slices", "seconds", "ratio"
    )?;
    for row in &results.stacks {
        for tool in &row.tools {
            write!(
                text,
                "{:24}{:>8}{:>9}{:>10.4}   {:10}",
                row.pair,
                row.regions,
                row.working.word(),
                row.seconds,
                tool.tool
            )?;
            match tool.right {
                Some(Tried {
                    slices, seconds, ..
                }) => write!(
                    text,
                    "{slices:>8}{seconds:>11.2}{:>9.0}",
                    seconds / row.seconds
                )?,
                None => write!(text, "{:>8}{:>11}{:>9}", "never", "-", "-")?,
            }
            let doubt = match tool.right {
                Some(_) if !tool.confirmed => " (not confirmed by a finer one)",
                _ => "",
            };
            match tool.finest {
                Some(t) => writeln!(
                    text,
                    "   {} {} {} {:.2}{doubt}",
                    t.slices,
                    t.regions,
                    t.working.word(),
                    t.seconds
                )?,
                None => writeln!(text, "   none")?,
            }
        }
    }
    writeln!(text)
}

fn slices(text: &mut String, rows: &[stack::Row]) -> fmt::Result {
    writeln!(text, "One slice, one thread, milliseconds\n")?;
    writeln!(
        text,
        "{:24}{:>10}{:>24}   polygon kernels",
        "pair", "cspace", "general algorithm"
    )?;
    for row in rows {
        write!(
            text,
            "{:24}{:>10.4}{:>24.4}  ",
            row.pair,
            1e3 * row.slice_seconds,
            1e3 * row.old_slice_seconds
        )?;
        for tool in &row.tools {
            if let Some(seconds) = tool.slice_seconds {
                write!(text, " {} {:.2}", tool.tool, 1e3 * seconds)?;
            }
        }
        writeln!(text)?;
    }
    writeln!(text)
}

fn checks(text: &mut String, rows: &[checks::Row]) -> fmt::Result {
    writeln!(
        text,
        "Single configurations, one thread: thousands of checks a second at random and near contact, and wrong answers\n\
         at distances from contact given as shares of the size\n"
    )?;
    write!(
        text,
        "{:24}{:18}{:>12}{:>10}{:>10} ",
        "pair", "checker", "prepared ms", "random", "near"
    )?;
    for wrong in rows.first().map_or(&[][..], |r| &r.near) {
        write!(text, "{:>10}", format!("{:.0e}", wrong.distance))?;
    }
    writeln!(text)?;
    for row in rows {
        write!(
            text,
            "{:24}{:18}{:>12.2}{:>10.0}{:>10.0} ",
            row.pair,
            row.checker,
            1e3 * row.prepared_seconds,
            1e-3 * row.checks_per_second,
            1e-3 * row.checks_per_second_near
        )?;
        for wrong in &row.near {
            write!(
                text,
                "{:>10}",
                format!("{}/{}", wrong.wrong, wrong.configurations)
            )?;
        }
        writeln!(text)?;
    }
    writeln!(text)
}

fn grids(text: &mut String, rows: &[grids::Row]) -> fmt::Result {
    writeln!(
        text,
        "Pairs on fixed axes, milliseconds, and a grid of checks with parry2d; verdicts that differ, and how many of those asked\n\
         about are the grid's mistakes; what a cell does not see, what the space does not, and the moving part's play, both ways\n"
    )?;
    for row in rows {
        let (space, grid) = (1e3 * row.seconds_of_space, 1e3 * row.seconds_of_grid);
        let scaled = if row.every > 1 { " scaled" } else { "" };
        let [rows, columns] = row.cells;
        let play = (row.play.as_ref()).map_or_else(String::new, |p| {
            format!(
                "   at {:.4}: {:.6}, {:.6} on the grid",
                p.at, p.exact, p.seen
            )
        });
        writeln!(
            text,
            "{:34}{space:>9.3}{grid:>12.1} ({rows} x {columns}{scaled}){:>8.0} times{:>8}/{} differ, {}/{} wrong, {:.1e}, {:.1e}{play}",
            row.pair,
            grid / space,
            row.differ,
            row.compared,
            row.grid_wrong,
            row.certain,
            row.moved,
            row.resolution_of_space
        )?;
    }
    writeln!(text)
}

fn memory(text: &mut String, rows: &[memory::Row]) -> fmt::Result {
    writeln!(
        text,
        "Memory, megabytes: the most at once, and what is kept with the result (in parentheses without symmetry)\n"
    )?;
    writeln!(text, "{:16}{:>18}{:>18}", "pair", "peak", "result")?;
    for row in rows {
        let both = |a: u64, b: u64| format!("{:.2} ({:.2})", 1e-6 * a as f64, 1e-6 * b as f64);
        writeln!(
            text,
            "{:16}{:>18}{:>18}",
            row.pair,
            both(row.peak_bytes, row.peak_bytes_without_symmetry),
            both(row.result_bytes, row.result_bytes_without_symmetry)
        )?;
    }
    writeln!(text)
}
