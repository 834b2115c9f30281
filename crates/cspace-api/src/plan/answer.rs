//! The answer to a question for a path, and the verdict on a path that is given.

use cspace::{Coordinates, PairSpace, Part, RegionId};
use cspace_check::Proof;
use cspace_design::FeaturePair;
use cspace_plan::legs::Scene;
use cspace_plan::{Answer, Blocked, Checked, Narrow, Path, Verdict};
use schemars::JsonSchema;
use serde::Serialize;

use crate::frame::Content;
use crate::leg::legs_in_words;
use crate::outcome::outcomes;
use crate::rest::Rest;
use crate::twin::Twin;

outcomes! {
    /// Whether there is a path.
    Outcome {
        /// There is a path; one that is given is free.
        Path = "path" is Yes,
        /// There is no path.
        NoPath = "no-path" is No,
        /// The path that is given meets a contact.
        Blocked = "blocked" is No,
        /// The parts overlap at the start.
        FromBlocked = "from-blocked" is No,
        /// The parts overlap at the goal.
        ToBlocked = "to-blocked" is No,
        /// Neither a path nor that there is none: at doubtful orientations, and where rounding hides a way.
        Unknown = "unknown" is Open,
    }
}

impl Content for Plan {
    const COMMAND: &'static str = "plan";
    type Outcome = Outcome;
}

/// A path, or why there is none.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Plan {
    /// How it came out, as `outcome`.
    pub verdict: Outcome,
    /// Whether the goal is where the part is out.
    #[serde(skip)]
    pub is_out: bool,
    /// Configurations joined by legs, from the start to the goal up to whole turns; empty if there is no path. On a leg the place of the
    /// point `about` of the moving part and the orientation have constant rates, or u and v. Angles go on beyond a turn.
    pub path: Vec<Coordinates>,
    /// x and y of the point of a planar part, in its frame, that legs move straight and about which they turn the part: its origin, the
    /// middle of a part that is drawn beside its origin, or what is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about: Option<[f64; 2]>,
    /// Description of each leg in words: right, up, left and down are directions of the fixed part's frame.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub words: Vec<String>,
    /// The parts and how legs move them, where there is a path.
    #[serde(skip)]
    pub scene: Option<Scene>,
    /// The gap by which the moving part is smaller all around, where the parts fit exactly at the start or the goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// The least distance of the parts along the path, in the model's unit; none without a path.
    pub clearance: Option<f64>,
    /// Where the path is narrowest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub narrowest: Option<Place>,
    /// The clearance of a path that starts or ends in contact, off these contacts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rest: Option<Rest>,
    /// Where the widest way is narrowest, if the widest is asked for, or more clearance than there is or was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bottleneck: Option<Bottleneck>,
    /// The free regions of start and goal.
    pub regions: Regions,
    /// The enclosure that keeps start and goal apart: the smaller of the two regions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosed: Option<Enclosed>,
    /// Where there is no path to the goal: a configuration to which there is one, and in which the moving part, which is symmetric, covers
    /// the same place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub twin: Option<Twin>,
    /// Overlap at the start or the goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked: Option<Overlap>,
    /// Where a path that is given meets a contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact>,
    /// Orientations at which the contact space is not relied upon, radians.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub doubtful: Vec<(f64, f64)>,
    /// The proof that there is no path, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<Proof>,
    /// Why there is no proof, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unproved: Option<String>,
    /// How long planning took, without the contact space (s).
    pub seconds: f64,
}

/// The free regions of start and goal, as `compute` lists them.
#[derive(Debug, Clone, Copy, Default, Serialize, JsonSchema)]
pub struct Regions {
    /// Region of the start; none where the parts overlap.
    pub from: Option<RegionId>,
    /// Region of the goal; none where the parts overlap.
    pub to: Option<RegionId>,
}

/// A configuration with what is nearest there.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Place {
    /// The configuration.
    pub at: Coordinates,
    /// Features of the fixed and of the moving part; none where there are none.
    pub touching: Option<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Option<FeaturePair>,
}

/// The widest way.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Bottleneck {
    /// The clearance of the widest way that was found.
    pub clearance: f64,
    /// No path has more than this; at least the clearance of the path. None where the path starts or ends in contact: by another leg off the
    /// contact there may be more.
    pub most: Option<f64>,
    /// Where that is.
    #[serde(flatten)]
    pub place: Place,
}

/// Why there is no path: a region that contacts enclose.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Enclosed {
    /// The region.
    pub region: RegionId,
    /// The number of contact patches that enclose it.
    pub patches: usize,
    /// The features of these patches, of the fixed and of the moving part.
    pub touching: Vec<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Vec<FeaturePair>,
}

/// Parts that overlap.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Overlap {
    /// How far it is to the nearest free configuration, in the model's unit; a radian counts the reach of the part that turns. None if there
    /// is none.
    pub depth: Option<f64>,
    /// The nearest free configuration, up to contact.
    pub nearest: Option<Coordinates>,
    /// Features of the fixed and of the moving part; none where there are none.
    pub touching: Option<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Option<FeaturePair>,
}

/// A contact on a path that is given.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Contact {
    /// The leg, counted from 0.
    pub leg: usize,
    /// How much of the leg is free, 0 to 1.
    pub fraction: f64,
    /// Where that is.
    #[serde(flatten)]
    pub place: Place,
}

/// The parts whose features have names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parts<'a> {
    pub(crate) fixed: &'a Part,
    pub(crate) moving: &'a Part,
}

impl<'a> Parts<'a> {
    pub(crate) fn of(space: &'a PairSpace) -> Self {
        Self {
            fixed: space.fixed(),
            moving: space.moving(),
        }
    }

    pub(crate) fn texts(self, (fixed, moving): FeaturePair) -> [String; 2] {
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

impl Enclosed {
    pub(crate) fn of(parts: Parts<'_>, enclosed: cspace_plan::Enclosed) -> Self {
        Self {
            region: enclosed.region,
            patches: enclosed.patches,
            touching: enclosed.features.iter().map(|&f| parts.texts(f)).collect(),
            features: enclosed.features,
        }
    }
}

impl Overlap {
    pub(crate) fn of(parts: Parts<'_>, blocked: &Blocked) -> Self {
        Self {
            depth: Some(blocked.depth).filter(|d| d.is_finite()),
            nearest: blocked.nearest,
            touching: blocked.features.map(|f| parts.texts(f)),
            features: blocked.features,
        }
    }
}

impl Plan {
    fn new(verdict: Outcome, seconds: f64) -> Self {
        Self {
            verdict,
            is_out: false,
            path: Vec::new(),
            about: None,
            words: Vec::new(),
            scene: None,
            gap: None,
            clearance: None,
            narrowest: None,
            rest: None,
            bottleneck: None,
            regions: Regions::default(),
            enclosed: None,
            twin: None,
            blocked: None,
            contact: None,
            doubtful: Vec::new(),
            proof: None,
            unproved: None,
            seconds,
        }
    }

    fn free(
        &mut self,
        parts: Parts<'_>,
        (scene, unit): (Scene, Option<&str>),
        path: Vec<Coordinates>,
        narrow: &Narrow,
    ) {
        self.about = about(&scene);
        self.rest = Rest::of(&scene, &path);
        self.words = legs_in_words(&scene, &path, unit);
        self.path = path;
        self.clearance = Some(narrow.clearance).filter(|c| c.is_finite());
        self.narrowest = Some(parts.place(narrow.at, narrow.features));
        self.scene = Some(scene);
    }

    /// The answer of a planner to a question for a path to a goal, or to where the part is out. Legs are described by the planner's scene, in
    /// the unit of length.
    pub fn planned(
        space: &PairSpace,
        (scene, unit): (&Scene, Option<&str>),
        goal: Option<Coordinates>,
        answer: Answer,
        seconds: f64,
    ) -> Self {
        let parts = Parts::of(space);
        let mut plan = Self::new(outcome(&answer.verdict), seconds);
        plan.is_out = goal.is_none();
        plan.regions = Regions {
            from: answer.regions.0,
            to: answer.regions.1,
        };
        plan.bottleneck = answer.bottleneck.map(|b| Bottleneck {
            clearance: b.narrow.clearance,
            most: b.most,
            place: parts.place(b.narrow.at, b.narrow.features),
        });
        match answer.verdict {
            Verdict::Path(Path {
                configurations,
                narrowest,
                about,
            }) => {
                let scene = scene.clone().with_about(about);
                plan.free(parts, (scene, unit), configurations, &narrowest);
            }
            Verdict::NoPath(enclosed) => {
                plan.twin = (plan.regions.from.zip(goal))
                    .and_then(|(region, goal)| Twin::in_region(space, region, goal));
                plan.enclosed = Some(Enclosed::of(parts, enclosed));
            }
            Verdict::FromBlocked(blocked) | Verdict::ToBlocked(blocked) => {
                plan.blocked = Some(Overlap::of(parts, &blocked));
            }
            Verdict::Unknown(doubtful) => {
                plan.about = about(scene);
                plan.doubtful = doubtful;
            }
            Verdict::TooNarrow => {}
        }
        plan
    }

    /// The verdict on a path that is given.
    pub(super) fn judged(
        parts: Parts<'_>,
        (scene, unit): (Scene, Option<&str>),
        path: Vec<Coordinates>,
        checked: &Checked,
        seconds: f64,
    ) -> Self {
        let verdict = match checked {
            Checked::Free(_) => Outcome::Path,
            Checked::FromBlocked => Outcome::FromBlocked,
            Checked::ToBlocked => Outcome::ToBlocked,
            Checked::Meets(_) => Outcome::Blocked,
        };
        let mut plan = Self::new(verdict, seconds);
        let overlap = |at: Option<&Coordinates>| {
            let features = (at.and_then(|&at| scene.numbers(at).ok()))
                .and_then(|at| scene.nearest(at).features);
            Overlap {
                depth: None,
                nearest: None,
                touching: features.map(|f| parts.texts(f)),
                features,
            }
        };
        match checked {
            Checked::Free(narrow) => plan.free(parts, (scene, unit), path, narrow),
            Checked::Meets(hit) => {
                plan.contact = Some(Contact {
                    leg: hit.leg,
                    fraction: hit.fraction,
                    place: parts.place(hit.at, hit.features),
                });
            }
            Checked::FromBlocked => plan.blocked = Some(overlap(path.first())),
            Checked::ToBlocked => plan.blocked = Some(overlap(path.last())),
        }
        plan
    }
}

/// The point that legs of a planar part are about.
fn about(scene: &Scene) -> Option<[f64; 2]> {
    let about = scene.about();
    scene.motions().is_none().then_some([about.x, about.y])
}

fn outcome(verdict: &Verdict) -> Outcome {
    match verdict {
        Verdict::Path(_) => Outcome::Path,
        Verdict::NoPath(_) | Verdict::TooNarrow => Outcome::NoPath,
        Verdict::FromBlocked(_) => Outcome::FromBlocked,
        Verdict::ToBlocked(_) => Outcome::ToBlocked,
        Verdict::Unknown(_) => Outcome::Unknown,
    }
}
