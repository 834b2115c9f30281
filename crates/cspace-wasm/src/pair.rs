//! A configuration space, as JavaScript asks it.

use cspace::fixed_axes::AxesData;
use cspace::{
    Axis, AxisMotion, Classification, ContactSpace, Coordinates, FeatureKind, FixedAxesSpace,
    Location, LowerPair, NearFeatures, PairClass, PairSpace, PatchId, QueryError, RegionId,
};
use cspace_api::place_on_part;
use cspace_plan::slide::{Slid, Slider};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::model::coordinates;
use crate::{drawn, fault, plain, plane, surface};

/// The configuration space of a pair.
#[wasm_bindgen]
pub struct Pair {
    space: PairSpace,
}

#[derive(Deserialize)]
struct Head {
    format: String,
}

/// A patch, without its geometry.
#[derive(Serialize)]
struct PatchInfo {
    fixed: String,
    moving: String,
    kind: &'static str,
    region: Option<RegionId>,
    orientations: Option<(f64, f64)>,
}

/// Two features that touch, or nearly.
#[derive(Serialize)]
struct Touch {
    fixed: String,
    moving: String,
    distance: f64,
    at: (f64, f64),
    normal: (f64, f64),
}

/// End of a motion.
#[derive(Serialize)]
struct Reached {
    at: Vec<f64>,
    stopped: Option<PatchId>,
}

/// Kind and range of a coordinate of a pair with fixed axes.
#[derive(Serialize)]
struct AxisInfo {
    kind: &'static str,
    lo: f64,
    hi: f64,
    round: bool,
}

#[wasm_bindgen]
impl Pair {
    /// Reads a space from its saved data; `own` says whether this module has computed it.
    ///
    /// Sines of other machines may differ in their last bit, which may exchange the order of two nearly equal roots:
    /// for a pair with fixed axes that was computed elsewhere, the partition is computed again. That takes less time
    /// than reading many other spaces.
    #[wasm_bindgen(constructor)]
    pub fn new(json: &str, own: bool) -> Result<Pair, JsError> {
        let head: Head = serde_json::from_str(json).map_err(fault)?;
        // It is of the page's own making: unlike a file, it is not computed again without a checksum.
        let space = match head.format.as_str() {
            "contact-space" => {
                let data = serde_json::from_str(json).map_err(fault)?;
                PairSpace::Planar(ContactSpace::from_data(data).map_err(fault)?.into())
            }
            "fixed-axes-space" => {
                let data: AxesData = serde_json::from_str(json).map_err(fault)?;
                let (fixed, moving) = (&data.fixed, &data.moving);
                let space = match own {
                    false => {
                        FixedAxesSpace::compute(fixed, data.fixed_axis, moving, data.moving_axis)
                            .map_err(fault)
                    }
                    true => FixedAxesSpace::from_data(data).map_err(fault),
                };
                PairSpace::FixedAxes(space?.into())
            }
            "lower-pair" => {
                let data = serde_json::from_str(json).map_err(fault)?;
                PairSpace::Lower(LowerPair::from_data(data).map_err(fault)?.into())
            }
            other => return Err(fault(format_args!("{other:?} is no configuration space"))),
        };
        Ok(Self { space })
    }

    /// The class: `lower`, `fixed-axes`, `symmetric` or `general`.
    #[wasm_bindgen(getter, unchecked_return_type = "PairClass")]
    pub fn class(&self) -> String {
        self.space.class().to_string()
    }

    /// The number of patches.
    #[wasm_bindgen(getter, js_name = patchCount)]
    pub fn patch_count(&self) -> usize {
        match &self.space {
            // Contacts that are permanent bound no free space.
            PairSpace::Lower(_) => 0,
            space => space.patch_count(),
        }
    }

    /// A patch.
    #[wasm_bindgen(unchecked_return_type = "PatchInfo")]
    pub fn patch(&self, index: u32) -> Result<JsValue, JsError> {
        if matches!(self.space, PairSpace::Lower(_)) {
            return Err(fault(format_args!(
                "there is no patch {index}: a joint has none"
            )));
        }
        let patch = self.space.patch(PatchId(index)).map_err(fault)?;
        let (fixed, moving) = patch.features().map_err(fault)?;
        plain(&PatchInfo {
            fixed: self.space.fixed().feature_text(fixed.name),
            moving: self.space.moving().feature_text(moving.name),
            kind: kind(fixed.name.kind, moving.name.kind),
            region: patch.region().map_err(fault)?,
            orientations: patch.orientations().ok(),
        })
    }

    /// Answer of `cspace classify`; nothing outside the window or the ranges of motion, and for numbers that are not
    /// finite.
    #[wasm_bindgen(unchecked_return_type = "Classification | undefined")]
    pub fn classify(&self, c: &[f64]) -> Result<Option<String>, JsError> {
        let class = self.space.classify(self.coordinates(c)?);
        Ok(class.ok().map(|class| said(class).to_owned()))
    }

    /// Whether the parts fit exactly at a configuration: they touch, and have no room to move.
    #[wasm_bindgen(js_name = fitsExactly)]
    pub fn fits_exactly(&self, c: &[f64]) -> Result<bool, JsError> {
        Ok(cspace_plan::fits_exactly(&self.space, self.coordinates(c)?).unwrap_or(false))
    }

    /// The free region of a free configuration.
    pub fn region(&self, c: &[f64]) -> Result<Option<u32>, JsError> {
        match self.space.locate(self.coordinates(c)?).map_err(fault)? {
            Location::Free(region) => Ok(Some(region.0)),
            _ => Ok(None),
        }
    }

    /// List of `cspace play`: features no farther apart than a distance (model unit; the resolution unless given),
    /// nearest first.
    #[wasm_bindgen(unchecked_return_type = "Touch[]")]
    pub fn touching(&self, c: &[f64], within: Option<f64>) -> Result<JsValue, JsError> {
        let at = self.coordinates(c)?;
        let near = self.near(at, within.unwrap_or(self.space.resolution()));
        let all: Vec<Touch> = near.iter().map(|n| self.touch(at, n)).collect();
        plain(&all)
    }

    /// Words for a feature that `touching` calls so: its name in the model, or where on the part it is, such as `bottom side`.
    pub fn words(&self, feature: &str, is_moving: bool) -> String {
        let part = if is_moving {
            self.space.moving()
        } else {
            self.space.fixed()
        };
        let unnamed = part
            .feature_called(feature)
            .filter(|f| f.to_string() == feature);
        let place = unnamed.and_then(|f| place_on_part(part, f));
        place.unwrap_or_else(|| feature.to_owned())
    }

    /// The first that it lists, however far they are apart; nothing outside the window or the ranges of motion.
    #[wasm_bindgen(unchecked_return_type = "Touch | null")]
    pub fn nearest(&self, c: &[f64]) -> Result<JsValue, JsError> {
        /// Margin beyond rounding, as a share.
        const MORE: f64 = 1e-6;
        /// First radius of the search for features of overlapping parts, as a share of their size; it then grows.
        const FIRST: f64 = 1.0 / 4096.0;
        let at = self.coordinates(c)?;
        let size = self.space.fixed().size().max(self.space.moving().size());
        let mut within = match self.space.clearance(at) {
            Ok(apart) => apart * (1.0 + MORE) + self.space.resolution(),
            Err(_) => size * FIRST,
        };
        let mut near = self.near(at, within);
        // No overlap is deeper than a part.
        while near.is_empty() && within < size {
            within *= 2.0;
            near = self.near(at, within);
        }
        plain(&near.first().map(|n| self.touch(at, n)))
    }

    /// Patches within the resolution.
    #[wasm_bindgen(js_name = patchesTouching)]
    pub fn patches_touching(&self, c: &[f64]) -> Result<Vec<u32>, JsError> {
        if matches!(self.space, PairSpace::Lower(_)) {
            return Ok(Vec::new());
        }
        let at = self.coordinates(c)?;
        let found = self.space.contacts(at, self.space.resolution());
        Ok(found
            .unwrap_or_default()
            .into_iter()
            .map(|(patch, _)| patch.0)
            .collect())
    }

    /// Advances on a straight line: to `to` if the motion is free; otherwise to the first contact.
    #[wasm_bindgen(unchecked_return_type = "Reached")]
    pub fn advance(&self, from: &[f64], to: &[f64]) -> Result<JsValue, JsError> {
        let (from, to) = (self.coordinates(from)?, self.coordinates(to)?);
        reached(from, Slider::new(&self.space).advance(from, to))
    }

    /// As `advance`, then slides on along the surface, as near to `to` as possible. Never blocked if `from` is not.
    #[wasm_bindgen(unchecked_return_type = "Reached")]
    pub fn slide(&self, from: &[f64], to: &[f64]) -> Result<JsValue, JsError> {
        let (from, to) = (self.coordinates(from)?, self.coordinates(to)?);
        reached(from, Slider::new(&self.space).slide(from, to))
    }

    /// The orientations of a planar pair: from, to, and whether they are a full turn.
    #[wasm_bindgen(unchecked_return_type = "{ lo: number; hi: number; fullTurn: boolean }")]
    pub fn window(&self) -> Result<JsValue, JsError> {
        #[derive(Serialize)]
        #[serde(rename_all = "camelCase")]
        struct Window {
            lo: f64,
            hi: f64,
            full_turn: bool,
        }
        let window = self.planar()?.window();
        plain(&Window {
            lo: window.lo,
            hi: window.hi,
            full_turn: window.full_turn,
        })
    }

    /// The critical orientations of a planar pair.
    #[wasm_bindgen(js_name = criticalOrientations)]
    pub fn critical_orientations(&self) -> Result<Vec<f64>, JsError> {
        Ok(self.planar()?.critical_orientations().to_vec())
    }

    /// The bands of a planar pair: [lo, hi, lo, hi, ...].
    pub fn bands(&self) -> Result<Vec<f64>, JsError> {
        let bands = self.planar()?.bands();
        Ok(bands.iter().flat_map(|b| [b.lo, b.hi]).collect())
    }

    /// The slice of a planar pair at an orientation, as points within a deviation (model unit) of its curves.
    #[wasm_bindgen(unchecked_return_type = "DrawnCurve[]")]
    pub fn slice(&self, theta: f64, deviation: f64) -> Result<JsValue, JsError> {
        Ok(drawn::slice(self.planar()?, theta, deviation).into())
    }

    /// Bounds of all positions in contact of a planar pair: [x, y, x, y] (model unit).
    pub fn bounds(&self) -> Result<Vec<f64>, JsError> {
        Ok(drawn::bounds(self.planar()?).to_vec())
    }

    /// A patch of a planar pair as triangles, within a deviation.
    #[wasm_bindgen(unchecked_return_type = "PatchSurface")]
    pub fn surface(&self, patch: u32, deviation: f64, per_radian: f64) -> Result<JsValue, JsError> {
        let made = surface::of_patch(
            &self.space,
            self.planar()?,
            PatchId(patch),
            deviation,
            per_radian,
        );
        made.map_err(fault)
    }

    /// Kinds and ranges of u and v of a pair with fixed axes.
    #[wasm_bindgen(unchecked_return_type = "[AxisInfo, AxisInfo]")]
    pub fn axes(&self) -> Result<JsValue, JsError> {
        let space = self.on_axes()?;
        let (fixed, moving) = space.axes();
        let [u, v] = space.extent();
        plain(&[info(fixed, u), info(moving, v)])
    }

    /// The contact curves of a pair with fixed axes, as points within a deviation.
    #[wasm_bindgen(unchecked_return_type = "DrawnCurve[]")]
    pub fn curves(&self, deviation: f64) -> Result<JsValue, JsError> {
        Ok(plane::curves(self.on_axes()?, deviation).into())
    }

    /// Free space of a pair with fixed axes, as polygons that do not overlap.
    #[wasm_bindgen(js_name = freePolygons, unchecked_return_type = "FreePolygon[]")]
    pub fn free_polygons(&self, deviation: f64) -> Result<JsValue, JsError> {
        Ok(plane::free(self.on_axes()?, deviation).into())
    }
}

impl Pair {
    fn planar(&self) -> Result<&ContactSpace, JsError> {
        match &self.space {
            PairSpace::Planar(space) => Ok(space),
            _ => Err(fault("the pair has no orientation as a coordinate")),
        }
    }

    fn on_axes(&self) -> Result<&FixedAxesSpace, JsError> {
        match &self.space {
            PairSpace::FixedAxes(space) => Ok(space),
            _ => Err(fault("the pair has no fixed axes")),
        }
    }

    /// (x, y, θ), or (u, v) of a pair with fixed axes.
    fn coordinates(&self, c: &[f64]) -> Result<Coordinates, JsError> {
        let at = coordinates(c)?;
        let on_axes = self.space.class() == PairClass::FixedAxes;
        match (on_axes, at) {
            (true, Coordinates::Axes { .. }) | (false, Coordinates::Planar(_)) => Ok(at),
            (true, _) => Err(fault("a configuration of this pair is [u, v]")),
            (false, _) => Err(fault("a configuration of this pair is [x, y, theta]")),
        }
    }

    /// Features near a configuration; none for lower pairs, and outside of the space.
    fn near(&self, at: Coordinates, within: f64) -> Vec<NearFeatures> {
        self.space.near_features(at, within).unwrap_or_default()
    }

    /// Contact of two features: in the assembly's frame for a pair with fixed axes, otherwise in the fixed part's
    /// frame.
    fn touch(&self, at: Coordinates, near: &NearFeatures) -> Touch {
        let place = match (&self.space, at) {
            (PairSpace::FixedAxes(space), Coordinates::Axes { u, .. }) => {
                space.axes().0.configuration(u)
            }
            _ => cspace::Configuration::default(),
        };
        let turn = cspace::Rotation::by(place.theta);
        let point = place.position() + turn * near.touching.on_fixed.to_vector();
        let normal = turn * near.touching.normal;
        Touch {
            fixed: self.space.fixed().feature_text(near.fixed.name),
            moving: self.space.moving().feature_text(near.moving.name),
            distance: near.distance,
            at: (point.x, point.y),
            normal: (normal.x, normal.y),
        }
    }
}

/// A motion that cannot be followed does not begin.
fn reached(from: Coordinates, slid: Result<Slid, QueryError>) -> Result<JsValue, JsError> {
    let slid = slid.unwrap_or(Slid {
        at: from,
        stopped: None,
    });
    plain(&Reached {
        at: match slid.at {
            Coordinates::Planar(c) => vec![c.x, c.y, c.theta],
            Coordinates::Axes { u, v } => vec![u, v],
        },
        stopped: slid.stopped,
    })
}

fn info(axis: Axis, (lo, hi): (f64, f64)) -> AxisInfo {
    let (kind, round) = match axis.motion {
        AxisMotion::Fixed => ("still", false),
        AxisMotion::Revolute { .. } => ("angle", axis.range.is_none()),
        AxisMotion::Prismatic { .. } => ("length", false),
    };
    AxisInfo {
        kind,
        lo: lo.min(hi),
        hi: lo.max(hi),
        round,
    }
}

fn said(class: Classification) -> &'static str {
    match class {
        Classification::Free => "free",
        Classification::Blocked => "blocked",
        Classification::Contact => "contact",
    }
}

/// The kind of a contact, whichever feature is the fixed part's.
fn kind(fixed: FeatureKind, moving: FeatureKind) -> &'static str {
    use FeatureKind::{Line, Vertex};
    match (fixed, moving) {
        (Line, Vertex) | (Vertex, Line) => "line-vertex",
        (Line, _) | (_, Line) => "line-arc",
        (Vertex, _) | (_, Vertex) => "arc-vertex",
        _ => "arc-arc",
    }
}
