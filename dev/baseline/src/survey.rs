//! The survey of 2500 mechanisms in section 4 of Sacks (1999), and what special methods save by it.

/// Shares of the kinds of mechanisms.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Survey {
    /// Source of the figures.
    pub source: &'static str,
    /// Mechanisms that are a single pair.
    pub pairs: f64,
    /// Share of them that are planar.
    pub planar_pairs: f64,
    /// Share of the planar pairs that are special: lower pairs, or higher pairs with two degrees of freedom.
    pub special_pairs: f64,
    /// Mechanisms of several pairs.
    pub mechanisms: f64,
    /// Share of them that are planar.
    pub planar_mechanisms: f64,
    /// Share of the planar mechanisms that consist of special pairs alone.
    pub special_mechanisms: f64,
    /// General pairs of a planar mechanism that has any, on average.
    pub general_of_mixed: f64,
    /// Special pairs of such a mechanism, on average.
    pub special_of_mixed: f64,
    /// Conclusion of the paper: the share of pairs that special methods cover.
    pub paper_share: f64,
    /// Conclusion of the paper: the share by which they shorten the average time.
    pub paper_saving: f64,
}

/// Section 4, third paragraph; the abstract repeats the last two.
pub const SURVEY: Survey = Survey {
    source: "Sacks 1999, section 4, third paragraph",
    pairs: 559.0,
    planar_pairs: 0.72,
    special_pairs: 0.92,
    mechanisms: 1912.0,
    planar_mechanisms: 0.85,
    special_mechanisms: 0.71,
    general_of_mixed: 1.0,
    special_of_mixed: 6.0,
    paper_share: 0.9,
    paper_saving: 10.0,
};

macro_rules! model {
    ($name:literal) => {
        (
            $name,
            include_str!(concat!("../../../models/", $name, ".toml")),
        )
    };
}

/// Models whose pairs are special, by name, from `models` in the repository: they show the savings by special methods.
pub const MODELS: [(&str, &str); 7] = [
    model!("cam_plate"),
    model!("cam_tappet"),
    model!("escapement"),
    model!("gears_on_shafts"),
    model!("geneva"),
    model!("rack_pinion"),
    model!("ratchet_mechanism"),
];

impl Survey {
    /// Share of planar pairs that need no general method.
    ///
    /// The survey does not give the number of pairs of mechanisms with special pairs alone: `pairs_of_special`. With 1,
    /// the smallest possible, the share is the paper's 90 %; it grows with the number.
    ///
    /// ```
    /// use cspace_baseline::survey::SURVEY;
    /// assert_eq!((100.0 * SURVEY.special_share(1.0)).round(), 90.0);
    /// assert_eq!((100.0 * SURVEY.special_share(7.0)).round(), 96.0);
    /// ```
    pub fn special_share(&self, pairs_of_special: f64) -> f64 {
        let single = self.pairs * self.planar_pairs;
        let planar = self.mechanisms * self.planar_mechanisms;
        let mixed = planar * (1.0 - self.special_mechanisms);
        let general = single * (1.0 - self.special_pairs) + mixed * self.general_of_mixed;
        let special = single * self.special_pairs
            + mixed * self.special_of_mixed
            + planar * self.special_mechanisms * pairs_of_special;
        special / (general + special)
    }
}

/// The average saving when a share of all pairs takes `special` seconds instead of the `general` seconds of all others:
/// g / (s p + g (1 − p)). With s = 0 and p = 0.9 it is the paper's 10.
///
/// ```
/// assert!((cspace_baseline::survey::saving(0.9, 0.0, 1.0) - 10.0).abs() < 1e-12);
/// ```
pub fn saving(share: f64, special: f64, general: f64) -> f64 {
    general / (special * share + general * (1.0 - share))
}
