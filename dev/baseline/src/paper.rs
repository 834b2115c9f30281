//! Pairs of Figure 5 of Sacks (1999): their published numbers, and models of them.

/// A row of Figure 5.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PaperPair {
    /// Figure 5's name.
    pub name: &'static str,
    /// Features of both parts.
    pub features: u32,
    /// Slices of the general algorithm, 0.005 rad apart.
    pub old_slices: u32,
    /// Slices of the paper's algorithm.
    pub new_slices: u32,
    /// Slices without symmetry, in parentheses there; equal to the others where there is no symmetry.
    pub new_slices_without_symmetry: u32,
    /// Group in whose average it is included.
    pub group: Group,
    /// A model of it, as `models/paper` in the repository has it: a reconstruction, as the drawings are not public.
    pub model: &'static str,
}

/// The two groups of pairs whose averages section 4 gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Group {
    /// The nine representative engineering pairs.
    Engineering,
    /// The two human knee pairs.
    Knee,
}

impl Group {
    /// The paper's factor by which its algorithm reduces slices and time.
    pub const fn paper_factor(self) -> f64 {
        match self {
            Self::Engineering => 62.0,
            Self::Knee => 9.0,
        }
    }
}

macro_rules! pair {
    ($name:literal, $file:literal, $group:ident, $features:literal, $old:literal, $new:literal, $without:literal) => {
        PaperPair {
            name: $name,
            features: $features,
            old_slices: $old,
            new_slices: $new,
            new_slices_without_symmetry: $without,
            group: Group::$group,
            model: include_str!(concat!("../../../models/paper/", $file, ".toml")),
        }
    };
}

/// Figure 5, in its order.
pub const PAIRS: [PaperPair; 11] = [
    pair!("cam", "cam", Engineering, 16, 1265, 12, 12),
    pair!("fixture", "fixture", Engineering, 36, 1293, 72, 72),
    pair!("fastener", "fastener", Engineering, 32, 1265, 16, 16),
    pair!(
        "ratchet/pawl",
        "ratchet_pawl",
        Engineering,
        96,
        1434,
        17,
        325
    ),
    pair!("geneva", "geneva", Engineering, 61, 1394, 64, 256),
    pair!("film advance", "film_advance", Engineering, 53, 1261, 4, 13),
    pair!("crank/slider", "crank_slider", Engineering, 24, 1261, 5, 5),
    pair!("blocks", "blocks", Engineering, 20, 1261, 5, 5),
    pair!("chain gear", "chain_gear", Engineering, 166, 1262, 3, 42),
    pair!("tibia/femur", "tibia_femur", Knee, 52, 1366, 196, 196),
    pair!("patella/femur", "patella_femur", Knee, 24, 1321, 107, 107),
];
