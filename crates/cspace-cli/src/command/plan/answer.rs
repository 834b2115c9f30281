//! What `cspace plan` answers, as JSON.

use cspace::{Coordinates, PairSpace, Part, RegionId};
use cspace_check::Proof;
use cspace_plan::{Answer, Blocked, Checked, Narrow, Path, Verdict};
use serde::Serialize;

use crate::subject::FeaturePair;

/// The whole answer.
#[derive(Debug, Serialize)]
pub(super) struct Told {
    pub(super) verdict: Name,
    /// Configurations; empty if there is no path.
    pub(super) path: Vec<Coordinates>,
    pub(super) clearance: Option<f64>,
    /// Where the path is narrowest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) narrowest: Option<Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) bottleneck: Option<Bottleneck>,
    pub(super) regions: Regions,
    /// What encloses start or goal, if that is why there is no path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) enclosed: Option<Enclosed>,
    /// What overlaps at start or goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) blocked: Option<Overlap>,
    /// Where a path that is judged meets a contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) contact: Option<Contact>,
    /// Orientations that are not relied upon.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) doubtful: Vec<(f64, f64)>,
    /// The proof that there is no path, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) proof: Option<Proof>,
    /// Why there is no proof, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) unproved: Option<String>,
    pub(super) seconds: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Name {
    Path,
    NoPath,
    FromBlocked,
    ToBlocked,
    Unknown,
}

#[derive(Debug, Clone, Copy, Default, Serialize)]
pub(super) struct Regions {
    pub(super) from: Option<RegionId>,
    pub(super) to: Option<RegionId>,
}

#[derive(Debug, Serialize)]
pub(super) struct Place {
    pub(super) at: Coordinates,
    /// Features of the fixed and of the moving part.
    pub(super) touching: Option<[String; 2]>,
    #[serde(skip)]
    pub(super) features: Option<FeaturePair>,
}

#[derive(Debug, Serialize)]
pub(super) struct Bottleneck {
    /// The clearance of the widest way there.
    pub(super) clearance: f64,
    /// No way has more.
    pub(super) most: f64,
    #[serde(flatten)]
    pub(super) place: Place,
}

#[derive(Debug, Serialize)]
pub(super) struct Enclosed {
    pub(super) region: RegionId,
    pub(super) patches: usize,
    pub(super) touching: Vec<[String; 2]>,
    #[serde(skip)]
    pub(super) features: Vec<FeaturePair>,
}

#[derive(Debug, Serialize)]
pub(super) struct Overlap {
    /// How far it is to the nearest free configuration.
    pub(super) depth: Option<f64>,
    pub(super) nearest: Option<Coordinates>,
    pub(super) touching: Option<[String; 2]>,
    #[serde(skip)]
    pub(super) features: Option<FeaturePair>,
}

#[derive(Debug, Serialize)]
pub(super) struct Contact {
    /// The leg, counted from 0.
    pub(super) leg: usize,
    /// How much of the leg is free.
    pub(super) fraction: f64,
    #[serde(flatten)]
    pub(super) place: Place,
}

/// The parts whose features have names.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts<'a> {
    pub(super) fixed: &'a Part,
    pub(super) moving: &'a Part,
}

impl Parts<'_> {
    fn texts(self, (fixed, moving): FeaturePair) -> [String; 2] {
        [
            self.fixed.feature_text(fixed),
            self.moving.feature_text(moving),
        ]
    }

    fn place(self, at: Coordinates, features: Option<FeaturePair>) -> Place {
        Place {
            at,
            touching: features.map(|f| self.texts(f)),
            features,
        }
    }
}

impl Told {
    fn new(verdict: Name, seconds: f64) -> Self {
        Self {
            verdict,
            path: Vec::new(),
            clearance: None,
            narrowest: None,
            bottleneck: None,
            regions: Regions::default(),
            enclosed: None,
            blocked: None,
            contact: None,
            doubtful: Vec::new(),
            proof: None,
            unproved: None,
            seconds,
        }
    }

    fn free(&mut self, parts: Parts<'_>, narrow: &Narrow) {
        self.clearance = Some(narrow.clearance).filter(|c| c.is_finite());
        self.narrowest = Some(parts.place(narrow.at, narrow.features));
    }

    /// Of a question for a path.
    pub(super) fn planned(space: &PairSpace, answer: Answer, seconds: f64) -> Self {
        let parts = Parts {
            fixed: space.fixed(),
            moving: space.moving(),
        };
        let mut told = Self::new(name(&answer.verdict), seconds);
        told.regions = Regions {
            from: answer.regions.0,
            to: answer.regions.1,
        };
        told.bottleneck = answer.bottleneck.map(|b| Bottleneck {
            clearance: b.narrow.clearance,
            most: b.most,
            place: parts.place(b.narrow.at, b.narrow.features),
        });
        match answer.verdict {
            Verdict::Path(Path {
                configurations,
                narrowest,
            }) => {
                told.path = configurations;
                told.free(parts, &narrowest);
            }
            Verdict::NoPath(enclosed) => {
                told.enclosed = Some(Enclosed {
                    region: enclosed.region,
                    patches: enclosed.patches,
                    touching: enclosed.features.iter().map(|&f| parts.texts(f)).collect(),
                    features: enclosed.features,
                });
            }
            Verdict::FromBlocked(blocked) | Verdict::ToBlocked(blocked) => {
                told.blocked = Some(overlap(parts, &blocked));
            }
            Verdict::Unknown(doubtful) => told.doubtful = doubtful,
            Verdict::TooNarrow => {}
        }
        told
    }

    /// Of a path that is judged.
    pub(super) fn checked(
        parts: Parts<'_>,
        path: Vec<Coordinates>,
        checked: &Checked,
        seconds: f64,
    ) -> Self {
        let verdict = match checked {
            Checked::Free(_) => Name::Path,
            Checked::FromBlocked => Name::FromBlocked,
            Checked::ToBlocked => Name::ToBlocked,
            Checked::Meets(_) => Name::NoPath,
        };
        let mut told = Self::new(verdict, seconds);
        match checked {
            Checked::Free(narrow) => {
                told.path = path;
                told.free(parts, narrow);
            }
            Checked::Meets(hit) => {
                told.contact = Some(Contact {
                    leg: hit.leg,
                    fraction: hit.fraction,
                    place: parts.place(hit.at, hit.features),
                });
            }
            Checked::FromBlocked | Checked::ToBlocked => {}
        }
        told
    }
}

fn name(verdict: &Verdict) -> Name {
    match verdict {
        Verdict::Path(_) => Name::Path,
        Verdict::NoPath(_) | Verdict::TooNarrow => Name::NoPath,
        Verdict::FromBlocked(_) => Name::FromBlocked,
        Verdict::ToBlocked(_) => Name::ToBlocked,
        Verdict::Unknown(_) => Name::Unknown,
    }
}

fn overlap(parts: Parts<'_>, blocked: &Blocked) -> Overlap {
    Overlap {
        depth: Some(blocked.depth).filter(|d| d.is_finite()),
        nearest: blocked.nearest,
        touching: blocked.features.map(|f| parts.texts(f)),
        features: blocked.features,
    }
}
