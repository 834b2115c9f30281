//! Answer of `cspace plan`: its schema is `docs/answers/plan.schema.json`.

use cspace::{Coordinates, FeatureName, PairSpace, Part, RegionId};
use cspace_check::Proof;
use cspace_plan::legs::Scene;
use cspace_plan::{Answer, Blocked, Checked, Narrow, Path, Verdict};
use serde::Serialize;

use crate::leg::legs_in_words;
use crate::rest::Rest;
use crate::twin::Twin;

/// A feature of the fixed part and one of the moving part.
pub type FeaturePair = (FeatureName, FeatureName);

/// The whole answer.
#[derive(Debug, Serialize)]
pub struct Told {
    /// Kind of the answer.
    pub verdict: Name,
    /// Whether the goal is where the part is out.
    #[serde(skip)]
    pub is_out: bool,
    /// Configurations; empty if there is no path.
    pub path: Vec<Coordinates>,
    /// The point of a planar part, in its frame, that legs move straight and turn the part about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about: Option<[f64; 2]>,
    /// Description of each leg, in words.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub words: Vec<String>,
    /// The gap by which the moving part is smaller, where the parts fit exactly at the start or the goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// The clearance of the path.
    pub clearance: Option<f64>,
    /// Where the path is narrowest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub narrowest: Option<Place>,
    /// The clearance off the contacts that the path starts or ends in, if it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rest: Option<Rest>,
    /// The clearance of the widest way, if it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bottleneck: Option<Bottleneck>,
    /// The free regions of start and goal.
    pub regions: Regions,
    /// Enclosure of start or goal, if that is why there is no path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosed: Option<Enclosed>,
    /// A configuration to which there is a path, and in which the moving part looks as at the goal, to which there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub twin: Option<Twin>,
    /// Overlap at start or goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked: Option<Overlap>,
    /// Where a path that is judged meets a contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact>,
    /// Orientations that are not relied upon.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub doubtful: Vec<(f64, f64)>,
    /// The proof that there is no path, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<Proof>,
    /// Why there is no proof, if one is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unproved: Option<String>,
    /// How long it took.
    pub seconds: f64,
}

/// Kind of an answer to a question for a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Name {
    /// A path.
    Path,
    /// No path.
    NoPath,
    /// The given path meets a contact.
    Blocked,
    /// The parts overlap at the start.
    FromBlocked,
    /// The parts overlap at the goal.
    ToBlocked,
    /// Neither a path nor that there is none.
    Unknown,
}

/// Free regions.
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub struct Regions {
    /// Region of the start.
    pub from: Option<RegionId>,
    /// Region of the goal.
    pub to: Option<RegionId>,
}

/// A configuration with what is nearest there.
#[derive(Debug, Serialize)]
pub struct Place {
    /// The configuration.
    pub at: Coordinates,
    /// Features of the fixed and of the moving part.
    pub touching: Option<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Option<FeaturePair>,
}

/// The widest way.
#[derive(Debug, Serialize)]
pub struct Bottleneck {
    /// The clearance of the widest way there.
    pub clearance: f64,
    /// No path has more; none for a path that starts or ends in contact, where another leg off it may leave more.
    pub most: Option<f64>,
    /// Where that is.
    #[serde(flatten)]
    pub place: Place,
}

/// Why there is no path: a region that contacts enclose.
#[derive(Debug, Serialize)]
pub struct Enclosed {
    /// The region.
    pub region: RegionId,
    /// The number of patches about it.
    pub patches: usize,
    /// Features whose contacts enclose it.
    pub touching: Vec<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Vec<FeaturePair>,
}

/// Parts that overlap.
#[derive(Debug, Serialize)]
pub struct Overlap {
    /// How far it is to the nearest free configuration.
    pub depth: Option<f64>,
    /// Nearest free configuration.
    pub nearest: Option<Coordinates>,
    /// Features that overlap.
    pub touching: Option<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Option<FeaturePair>,
}

/// A contact on a path that is judged.
#[derive(Debug, Serialize)]
pub struct Contact {
    /// The leg, counted from 0.
    pub leg: usize,
    /// How much of the leg is free.
    pub fraction: f64,
    /// Where that is.
    #[serde(flatten)]
    pub place: Place,
}

/// Context in which legs are described: the scene of the planner or of the judge, and the unit of length.
pub type Legs<'a> = (&'a Scene, Option<&'a str>);

/// The parts whose features have names.
#[derive(Debug, Clone, Copy)]
pub struct Parts<'a> {
    /// The fixed part.
    pub fixed: &'a Part,
    /// The moving part.
    pub moving: &'a Part,
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
            is_out: false,
            path: Vec::new(),
            about: None,
            words: Vec::new(),
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
        (scene, unit): Legs<'_>,
        path: Vec<Coordinates>,
        narrow: &Narrow,
    ) {
        self.about = about(scene);
        self.rest = Rest::of(scene, &path);
        self.words = legs_in_words(scene, &path, unit);
        self.path = path;
        self.clearance = Some(narrow.clearance).filter(|c| c.is_finite());
        self.narrowest = Some(parts.place(narrow.at, narrow.features));
    }

    /// The answer of a planner to a question for a path to a goal, or to where the part is out.
    pub fn planned(
        space: &PairSpace,
        legs: Legs<'_>,
        goal: Option<Coordinates>,
        answer: Answer,
        seconds: f64,
    ) -> Self {
        let parts = Parts {
            fixed: space.fixed(),
            moving: space.moving(),
        };
        let mut told = Self::new(name(&answer.verdict), seconds);
        told.is_out = goal.is_none();
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
                about,
            }) => {
                let scene = legs.0.clone().with_about(about);
                told.free(parts, (&scene, legs.1), configurations, &narrowest);
            }
            Verdict::NoPath(enclosed) => {
                told.twin = (told.regions.from.zip(goal))
                    .and_then(|(region, goal)| Twin::in_region(space, region, goal));
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
            Verdict::Unknown(doubtful) => {
                told.about = about(legs.0);
                told.doubtful = doubtful;
            }
            Verdict::TooNarrow => {}
        }
        told
    }

    /// The verdict of the judge of a given path.
    pub fn checked(
        parts: Parts<'_>,
        legs: Legs<'_>,
        path: Vec<Coordinates>,
        checked: &Checked,
        seconds: f64,
    ) -> Self {
        let verdict = match checked {
            Checked::Free(_) => Name::Path,
            Checked::FromBlocked => Name::FromBlocked,
            Checked::ToBlocked => Name::ToBlocked,
            Checked::Meets(_) => Name::Blocked,
        };
        let mut told = Self::new(verdict, seconds);
        let overlap = |at: Option<&Coordinates>| {
            let features = (at.and_then(|&at| legs.0.numbers(at).ok()))
                .and_then(|at| legs.0.nearest(at).features);
            Overlap {
                depth: None,
                nearest: None,
                touching: features.map(|f| parts.texts(f)),
                features,
            }
        };
        match checked {
            Checked::Free(narrow) => told.free(parts, legs, path, narrow),
            Checked::Meets(hit) => {
                told.contact = Some(Contact {
                    leg: hit.leg,
                    fraction: hit.fraction,
                    place: parts.place(hit.at, hit.features),
                });
            }
            Checked::FromBlocked => told.blocked = Some(overlap(path.first())),
            Checked::ToBlocked => told.blocked = Some(overlap(path.last())),
        }
        told
    }
}

/// The point that legs of a planar part are about.
fn about(scene: &Scene) -> Option<[f64; 2]> {
    let about = scene.about();
    scene.motions().is_none().then_some([about.x, about.y])
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
