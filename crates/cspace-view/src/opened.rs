//! What a page shows: a model, or a saved space.

use cspace::pair::Joint;
use cspace::{
    Axis, Mechanism, Options, PairClass, PairEntry, PairError, PairSpace, PartEntry, Progress,
    Relation, Symmetry,
};
use cspace_io::SavedFile;

use crate::scene::{Scene, ScenePair, SceneRecord};

/// A mechanism, and which of its pairs are shown.
#[derive(Debug)]
pub struct Opened {
    /// The mechanism. Of a saved space it has its two parts, related as they are there.
    pub model: Mechanism,
    /// The pairs that are shown, in their windows.
    pub pairs: Vec<PairEntry>,
    /// Whether the general method is used whatever the class.
    pub general: bool,
    /// The space of the one pair, if it was read.
    pub saved: Option<PairSpace>,
    /// What is to be played.
    pub records: Vec<SceneRecord>,
}

impl Opened {
    /// A model with these of its pairs.
    pub fn model(model: Mechanism, pairs: Vec<PairEntry>, general: bool) -> Self {
        Self {
            model,
            pairs,
            general,
            saved: None,
            records: Vec::new(),
        }
    }

    /// A saved space.
    pub fn saved(file: SavedFile) -> Self {
        let space = file.space;
        let (fixed, moving) = (space.fixed(), space.moving());
        let both = || format!("{} and {}", fixed.name(), moving.name());
        let mut model = Mechanism::new(file.name.unwrap_or_else(both));
        model.unit = file.unit;
        let parts = [fixed, moving].map(Clone::clone);
        model.parts = (parts.into_iter().zip(axes(&space)))
            .map(|(part, axis)| PartEntry {
                axis,
                ..PartEntry::planar(part)
            })
            .collect();
        if let PairSpace::Lower(pair) = &space {
            model.joints.push(cspace::JointEntry {
                joint: pair.joint(),
                parts: (0, 1),
            });
        }
        let window = match &space {
            PairSpace::Planar(space) if !space.window().full_turn => {
                let window = space.window();
                Some((window.lo, window.hi))
            }
            _ => None,
        };
        let pair = PairEntry {
            fixed: 0,
            moving: 1,
            window,
        };
        model.pairs = vec![pair];
        Self {
            model,
            pairs: vec![pair],
            // What was computed without symmetry is computed without it again.
            general: space.class() == PairClass::General,
            saved: Some(space),
            records: Vec::new(),
        }
    }

    /// The scene, without the spaces of its pairs.
    pub fn scene(&self) -> Scene {
        let pairs = self.pairs.iter().map(|p| self.unknown(p)).collect();
        Scene::of(&self.model, pairs, self.records.clone())
    }

    /// A pair without its space.
    pub fn unknown(&self, pair: &PairEntry) -> ScenePair {
        let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &self.model.parts[i].part);
        let class = match &self.saved {
            Some(space) => space.class(),
            None if self.general => PairClass::General,
            None => self.model.pair_class(pair),
        };
        ScenePair::unknown(pair, class, fixed, moving)
    }

    /// Computes the space of a pair of a mechanism that has the same parts, perhaps with other outlines and motions.
    pub(crate) fn compute(
        &self,
        model: &Mechanism,
        pair: &PairEntry,
        progress: &dyn Progress,
    ) -> Result<PairSpace, PairError> {
        let relation = if self.general {
            Relation::Planar
        } else {
            model.relation(pair)
        };
        let options = Options {
            window: pair.window,
            symmetry: if self.general {
                Symmetry::Ignore
            } else {
                Symmetry::Detect
            },
        };
        let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &model.parts[i].part);
        PairSpace::compute_with(fixed, moving, relation, &options, progress)
    }
}

/// How the parts of a saved space move relative to the ground, as far as it says so.
fn axes(space: &PairSpace) -> [Option<Axis>; 2] {
    match space {
        PairSpace::FixedAxes(space) => {
            let (fixed, moving) = space.axes();
            [Some(fixed), Some(moving)]
        }
        // The limits of a joint are those of axes.
        PairSpace::Lower(pair) => {
            let axis = match pair.joint() {
                Joint::Revolute { at } => Axis::revolute(at),
                Joint::Prismatic { direction, .. } => Axis::prismatic(direction),
                Joint::Rigid => return [None; 2],
            };
            match pair.limits() {
                Some((lo, hi)) => [Some(Axis::FIXED), Some(axis.within(lo, hi))],
                None => [None; 2],
            }
        }
        PairSpace::Planar(_) => [None; 2],
    }
}
