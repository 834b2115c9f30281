//! Format of `NAME.expect.toml`, the expectations for the pair in `NAME.toml` or `NAME.json`. Angles are in radians.

use serde::Deserialize;

/// Expectations of one file: of contact spaces of the pair, or of its space on fixed axes, or a test of its own.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Expectation {
    /// Expectations for contact spaces, each of which is computed.
    #[serde(default)]
    pub(crate) planar: Vec<Planar>,
    pub(crate) axes: Option<Axes>,
    /// The function in `named.rs` that tests what has no key here.
    pub(crate) named_test: Option<String>,
}

/// Expectations for a contact space.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Planar {
    /// Orientations computed; the whole turn if none is given.
    pub(crate) window: Option<(f64, f64)>,
    /// The moving part is the fixed one.
    #[serde(default)]
    pub(crate) swapped: bool,
    pub(crate) free_regions: Option<usize>,
    /// Free regions that are bounded.
    pub(crate) caged_regions: Option<usize>,
    pub(crate) conflicts: Option<u64>,
    pub(crate) doubtful_orientations: Option<usize>,
    /// Range of the resolution.
    pub(crate) resolution: Option<(f64, f64)>,
    pub(crate) patches_more_than: Option<usize>,
    /// Patches of the outermost region.
    pub(crate) outer_patches_more_than: Option<usize>,
    /// Critical orientations: one is within 1e-10 of each of these.
    #[serde(default)]
    pub(crate) critical_orientations: Vec<f64>,
    pub(crate) saved: Option<Saved>,
    /// Slices at random orientations are right beside contact.
    #[serde(default)]
    pub(crate) slices_beside_contact: bool,
    /// 10 000 random configurations beside contact, or by default a quarter of them, are classified correctly, and more than this many of
    /// 10 000 are certain.
    pub(crate) beside_contact_more_than: Option<usize>,
    pub(crate) around_the_origin: Option<Around>,
    /// Slices at evenly spaced orientations are made of closed loops, as many as those from scratch.
    #[serde(default)]
    pub(crate) closed: bool,
    /// Both slices in the middle of every band have loops.
    #[serde(default)]
    pub(crate) loops_in_every_band: bool,
    /// Both slices at these orientations are closed.
    #[serde(default)]
    pub(crate) no_open_curves_at: Vec<f64>,
    #[serde(default)]
    pub(crate) at: Vec<At>,
    #[serde(default)]
    pub(crate) slice: Vec<Sliced>,
}

/// The space is read back from its text, which has some words and lacks others.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Saved {
    #[serde(default)]
    pub(crate) contains: Vec<String>,
    #[serde(default)]
    pub(crate) lacks: Vec<String>,
}

/// 3000 random configurations whose coordinates are at most so large are classified rightly.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Around {
    pub(crate) shift: f64,
    pub(crate) turn: f64,
    /// Minimum number of free configurations among the certain ones.
    pub(crate) free_more_than: usize,
}

/// Method that classifies a configuration.
#[derive(Deserialize, Debug, Clone, Copy, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum By {
    Space,
    Classifier,
    /// The slice of the space.
    Slice,
    /// The slice of the space; a doubtful one may give any answer.
    SliceUnlessDoubtful,
    /// The slice from scratch.
    Scratch,
    /// Brute force.
    Oracle,
}

/// Configurations x, y, θ.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct At {
    /// Methods, all of which must agree.
    pub(crate) by: Vec<By>,
    #[serde(default)]
    pub(crate) free: Vec<[f64; 3]>,
    #[serde(default)]
    pub(crate) blocked: Vec<[f64; 3]>,
    /// Configurations classified by brute force, which must be certain.
    #[serde(default)]
    pub(crate) judged: Vec<[f64; 3]>,
    /// Certain by more than this. If it is missing, by more than 1e-10 of the size, and within the resolution of the space any
    /// answer is right that the space gives.
    pub(crate) margin: Option<f64>,
}

/// Slices at some orientations.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sliced {
    /// `slice` or `scratch`.
    pub(crate) of: Vec<By>,
    pub(crate) theta: Vec<f64>,
    pub(crate) loops: Option<usize>,
    pub(crate) curves: Option<usize>,
    /// The length of all curves, to 1e-8.
    pub(crate) length: Option<f64>,
    pub(crate) doubtful: Option<bool>,
    /// Every curve is followed by another.
    #[serde(default)]
    pub(crate) closed: bool,
}

/// Expectations for a space on fixed axes; positions are u, v.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Axes {
    pub(crate) regions: Option<usize>,
    pub(crate) conflicts: Option<usize>,
    /// Range of the resolution.
    pub(crate) resolution: Option<(f64, f64)>,
    /// Resolution as a share of the parts' size.
    pub(crate) resolution_of_size: Option<(f64, f64)>,
    /// These and a thousand random positions are classified correctly.
    pub(crate) positions: Option<Vec<(f64, f64)>>,
    /// Minimum number of certain ones among them; 900 if it is missing.
    pub(crate) certain_more_than: Option<usize>,
    /// Random positions beyond the resolution are all blocked, and are more than this many of a thousand.
    pub(crate) only_blocked_more_than: Option<usize>,
    /// The parts touch.
    #[serde(default)]
    pub(crate) contact: Vec<(f64, f64)>,
    /// Positions of which no two are in one region.
    #[serde(default)]
    pub(crate) regions_of_their_own: Vec<(f64, f64)>,
    /// Regions are free where they say, patches lead on within a region, and what is saved and read is the same.
    #[serde(default)]
    pub(crate) whole: bool,
}
