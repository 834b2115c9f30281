//! The name somebody probably meant.

/// Names longer than this are not compared: the cost is the product of the lengths.
const LONGEST: usize = 64;

/// Advice on a name that is none of the candidates: the one that was probably meant, else something else.
pub(super) fn did_you_mean<'a>(
    typed: &str,
    candidates: impl IntoIterator<Item = &'a str>,
    otherwise: impl FnOnce() -> String,
) -> String {
    let meant = nearest(typed, candidates);
    meant.map_or_else(otherwise, |meant| format!("did you mean `{meant}`?"))
}

/// The candidate nearest to `typed` by Damerau-Levenshtein distance, case ignored, if it is near
/// enough to be a slip: at most a third of the letters, and at least one, wrong; the first of equals.
fn nearest<'a>(typed: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if typed.len() > LONGEST {
        return None;
    }
    let typed = typed.to_lowercase();
    (candidates.into_iter())
        .filter(|candidate| candidate.len() <= LONGEST)
        .map(|candidate| {
            let distance = strsim::damerau_levenshtein(&typed, &candidate.to_lowercase());
            (distance, candidate)
        })
        .filter(|(distance, candidate)| *distance <= (candidate.chars().count() / 3).max(1))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn slips_are_found_and_other_words_are_not() {
        let keys = ["name", "loops", "motion", "symmetry"];
        assert_eq!(nearest("loop", keys), Some("loops"));
        assert_eq!(nearest("Motoin", keys), Some("motion"));
        assert_eq!(nearest("symetry", keys), Some("symmetry"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest(&"n".repeat(1000), keys), None);
    }
}
