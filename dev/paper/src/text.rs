//! The measurements as text.

use std::fmt::{self, Write};

use crate::averages::Average;
use crate::evaluation::Evaluation;
use crate::measure::Measured;
use crate::special::Survey;

pub(crate) fn described(evaluation: &Evaluation) -> Result<String, fmt::Error> {
    let mut text = String::new();
    slices(&mut text, evaluation)?;
    times(&mut text, evaluation)?;
    criticalities(&mut text, evaluation)?;
    errors(&mut text, evaluation)?;
    let averages = &evaluation.averages;
    average(
        &mut text,
        "engineering pairs",
        averages.engineering.as_ref(),
    )?;
    average(&mut text, "knee pairs", averages.knee.as_ref())?;
    survey(&mut text, &evaluation.survey)?;
    Ok(text)
}

/// With the number for the whole turn in parentheses where symmetry makes another, as in Figure 5.
fn with_turn(computed: impl Into<u64>, turn: impl Into<u64>) -> String {
    let (computed, turn) = (computed.into(), turn.into());
    if computed == turn {
        computed.to_string()
    } else {
        format!("{computed} ({turn})")
    }
}

fn slices(text: &mut String, evaluation: &Evaluation) -> fmt::Result {
    writeln!(
        text,
        "Slices (in parentheses without symmetry); the general algorithm's are {} rad apart\n",
        evaluation.separation
    )?;
    let head = ["features", "old", "new", "ratio"];
    writeln!(
        text,
        "{:14}{:>9}{:>7}{:>11}{:>8}   Figure 5:{:>7}{:>11}{:>8}",
        "pair", head[0], head[1], head[2], head[3], head[1], head[2], head[3]
    )?;
    for m in &evaluation.pairs {
        let paper = &m.paper;
        writeln!(
            text,
            "{:14}{:>9}{:>7}{:>11}{:>8.1}            {:>7}{:>11}{:>8.1}",
            m.pair,
            m.features,
            m.old_slices,
            with_turn(m.new_slices as u64, m.new_slices_without_symmetry as u64),
            m.slice_ratio,
            paper.old_slices,
            with_turn(paper.new_slices, paper.new_slices_without_symmetry),
            f64::from(paper.old_slices) / f64::from(paper.new_slices),
        )?;
    }
    Ok(())
}

fn times(text: &mut String, evaluation: &Evaluation) -> fmt::Result {
    writeln!(
        text,
        "\nMilliseconds of the processor, median of {}, one thread (in parentheses without symmetry)\n",
        evaluation.repeat
    )?;
    writeln!(
        text,
        "{:14}{:>10}{:>19}{:>8}{:>11}{:>10}   a slice: {:>7}{:>9}",
        "pair", "old", "new", "ratio", "patches", "links", "old", "1 thread"
    )?;
    for m in &evaluation.pairs {
        let [old, new, without] =
            [m.old_seconds, m.new_seconds, m.new_seconds_without_symmetry].map(|s| 1e3 * s);
        let new = if m.symmetry > 1 {
            format!("{new:.2} ({without:.2})")
        } else {
            format!("{new:.2}")
        };
        writeln!(
            text,
            "{:14}{old:>10.1}{new:>19}{:>8.1}{:>11}{:>10}            {:>7.4}{:>9.4}",
            m.pair,
            m.ratio,
            m.patches,
            m.links.side + m.links.vertical,
            1e3 * m.seconds_per_slice.old,
            1e3 * m.seconds_per_slice.product
        )?;
    }
    Ok(())
}

fn criticalities(text: &mut String, evaluation: &Evaluation) -> fmt::Result {
    writeln!(
        text,
        "\nCritical orientations: the general algorithm's search over all combinations of features, milliseconds of the\n\
         processor and solutions examined one by one, and the ratio of times with that; and the product's in the slices\n\
         computed, by what happens there (several can at once)\n"
    )?;
    writeln!(
        text,
        "{:14}{:>14}{:>14}{:>10}{:>8}{:>14}{:>9}{:>6}{:>9}{:>8}",
        "pair",
        "known skipped",
        "all examined",
        "examined",
        "ratio",
        "orientations",
        "aligned",
        "end",
        "tangent",
        "triple"
    )?;
    let limit = evaluation.criticality_limit;
    let seconds = |s: Option<f64>| match s {
        Some(s) => format!("{:.1}", 1e3 * s),
        None if limit == 0.0 => "-".into(),
        None => format!("> {limit} s"),
    };
    for m in &evaluation.pairs {
        let k = &m.critical;
        writeln!(
            text,
            "{:14}{:>14}{:>14}{:>10}{:>8}{:>14}{:>9}{:>6}{:>9}{:>8}",
            m.pair,
            seconds(m.criticality_seconds),
            seconds(m.criticality_seconds_without_skipping),
            m.criticality_search[1].map_or("-".into(), |s| s.examined.to_string()),
            with_criticalities(m, limit),
            k.orientations,
            k.aligned,
            k.end,
            k.tangent,
            k.triple
        )?;
    }
    Ok(())
}

/// The ratio of times with the search of critical orientations, or what it is more than.
fn with_criticalities(m: &Measured, limit: f64) -> String {
    match m.criticality_seconds_without_skipping {
        Some(_) => format!("{:.0}", m.ratio_with_criticalities),
        None if limit == 0.0 => "-".into(),
        None => format!("> {:.0}", m.ratio_with_criticalities),
    }
}

fn errors(text: &mut String, evaluation: &Evaluation) -> fmt::Result {
    writeln!(
        text,
        "\nErrors of the general algorithm: largest gap at straight boundary lines with critical orientations given;\n\
         without them bands that no slice falls in, spaces between slices where free and blocked are joined,\n\
         curves there that nothing continues, and curves continued by another piece of contact\n"
    )?;
    writeln!(
        text,
        "{:14}{:>18}{:>10}{:>14}{:>15}{:>10}{:>10}",
        "pair", "gap", "of size", "missed bands", "wrongly joined", "open", "across"
    )?;
    for m in &evaluation.pairs {
        writeln!(
            text,
            "{:14}{:>18}{:>9.4}%{:>14}{:>15}{:>10}{:>10}",
            m.pair,
            gap(m),
            100.0 * m.largest_gap_share,
            m.missed_bands,
            m.wrongly_joined,
            m.curves_left_open,
            m.curves_joined_across
        )?;
    }
    Ok(())
}

fn gap(m: &Measured) -> String {
    match &m.unit {
        Some(unit) => format!("{:.6} {unit}", m.largest_gap),
        None => format!("{:.6}", m.largest_gap),
    }
}

fn average(text: &mut String, what: &str, average: Option<&Average>) -> fmt::Result {
    let Some(a) = average else {
        return Ok(());
    };
    writeln!(
        text,
        "\n{} {what}: the paper has a factor of {}",
        a.pairs, a.paper_factor
    )?;
    for (name, r) in [
        ("slices", a.slices),
        ("slices, Figure 5", a.paper_slices),
        ("seconds", a.seconds),
    ] {
        writeln!(
            text,
            "  {name:18}{:>8.1} mean of ratios, {:>8.1} geometric mean, {:>8.1} ratio of totals",
            r.mean, r.geometric_mean, r.of_totals
        )?;
    }
    let more = if a.criticalities_unfinished > 0 {
        "more than "
    } else {
        ""
    };
    writeln!(
        text,
        "  seconds with the general algorithm's search of critical orientations: {more}{:.1} geometric mean\n  \
         seconds without symmetry: {:.1} geometric mean",
        a.seconds_with_criticalities, a.seconds_without_symmetry
    )
}

fn survey(text: &mut String, s: &Survey) -> fmt::Result {
    writeln!(text, "\nSpecial pairs, milliseconds\n")?;
    writeln!(
        text,
        "{:20}{:24}{:12}{:>10}{:>10}",
        "model", "pair", "class", "special", "general"
    )?;
    for pair in &s.special_pairs {
        writeln!(
            text,
            "{:20}{:24}{:12}{:>10.3}{:>10.2}",
            pair.model,
            pair.pair,
            pair.class,
            1e3 * pair.seconds,
            1e3 * pair.general_seconds
        )?;
    }
    let m = &s.mechanisms;
    writeln!(
        text,
        "\nSurvey ({}): {} single pairs, {:.0} % planar, {:.0} % of these special; {} mechanisms, {:.0} % planar,\n\
         {:.0} % of these of special pairs alone, the others with {} general pair for {} special ones on average",
        m.source,
        m.pairs,
        100.0 * m.planar_pairs,
        100.0 * m.special_pairs,
        m.mechanisms,
        100.0 * m.planar_mechanisms,
        100.0 * m.special_mechanisms,
        m.general_of_mixed,
        m.special_of_mixed
    )?;
    writeln!(
        text,
        "Survey of 2500 mechanisms: special methods cover {:.1} % of planar pairs (the paper: {:.0} %)\n\
         and save a factor of {:.1} on average if all are as those with fixed axes here, {:.1} if all are as those\n\
         with joints (the paper: {:.0})",
        100.0 * s.special_share,
        100.0 * s.paper_share,
        s.saving.all_fixed_axes,
        s.saving.all_lower,
        s.paper_saving
    )
}
