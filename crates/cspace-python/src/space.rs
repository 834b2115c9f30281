//! The configuration space of a pair.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use cspace::{
    Classification, Classifier, ContactSpace, Coordinates, LinkKind, Location, Options, PairSpace,
    QueryError, Relation, Vector,
};
use cspace_api::plan::Plan;
use cspace_api::{Answer, PairAnswer};
use cspace_design::{Motion, displace, free_range, pair_of, texts};
use cspace_model::model::Coordinate;
use cspace_model::write::mesh::{Mesh, MeshOptions};
use cspace_plan::{Clearance, Planner, Prefer, Wishes, fits_exactly, with_gap};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyUntypedArrayMethods};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::error::error;
use crate::nest::{Loops, loops};
use crate::part::Part;
use crate::plan::{Planned, Told};
use crate::rows::{Asked, asked, each, matrix, numbers, one, width};
use crate::work;

/// After so many questions a space is prepared for millions: that takes about as long as so many of them.
const SINGLE: u64 = 100;

/// Two parts, how they move, and what is computed of them.
#[derive(Clone)]
pub(crate) struct Pair {
    pub(crate) fixed: cspace::Part,
    pub(crate) moving: cspace::Part,
    pub(crate) relation: Relation,
    pub(crate) window: Option<(f64, f64)>,
}

/// A space, with what prepares it for many questions.
struct Known {
    space: Arc<PairSpace>,
    classifier: OnceLock<Classifier<Arc<ContactSpace>>>,
    asked: AtomicU64,
}

impl Known {
    fn new(space: PairSpace) -> Self {
        Self {
            space: Arc::new(space),
            classifier: OnceLock::new(),
            asked: AtomicU64::new(0),
        }
    }

    fn prepare(&self) {
        if let PairSpace::Planar(space) = &*self.space {
            (self.classifier).get_or_init(|| Classifier::new(Arc::clone(space)));
        }
    }

    fn classify(&self, at: Coordinates) -> Result<Classification, QueryError> {
        match (self.classifier.get(), at) {
            (Some(classifier), Coordinates::Planar(c)) => {
                classifier.classify(c).ok_or(QueryError::Outside)
            }
            _ => self.space.classify(at),
        }
    }
}

/// The configuration space of two parts: where the moving one is free, blocked or in contact.
#[pyclass(frozen, module = "cspace._rust", name = "ContactSpace")]
pub(crate) struct Space {
    pair: Pair,
    known: OnceLock<Known>,
    /// The space with the moving part smaller by a gap, for questions where the parts fit exactly, and the gap.
    roomy: OnceLock<Option<(Arc<PairSpace>, f64)>>,
}

fn code(class: Classification) -> u8 {
    match class {
        Classification::Free => 0,
        Classification::Blocked => 1,
        Classification::Contact => 2,
    }
}

/// Refuses a length that is none.
fn check(name: &str, length: f64) -> PyResult<()> {
    if length >= 0.0 && length.is_finite() {
        return Ok(());
    }
    Err(error(format_args!(
        "`{name}` is {length} where a length of 0 or more is expected"
    )))
}

impl Space {
    /// A space that is computed once it is asked.
    pub(crate) fn later(pair: Pair) -> Self {
        Self {
            pair,
            known: OnceLock::new(),
            roomy: OnceLock::new(),
        }
    }

    pub(crate) fn computed(py: Python<'_>, pair: Pair) -> PyResult<Self> {
        let this = Self::later(pair);
        this.known(py)?;
        Ok(this)
    }

    fn known(&self, py: Python<'_>) -> PyResult<&Known> {
        if let Some(known) = self.known.get() {
            return Ok(known);
        }
        let space = self.with_moving(py, self.pair.moving.clone())?;
        Ok(self.known.get_or_init(|| Known::new(space)))
    }

    /// The space with a moving part in place of the pair's.
    fn with_moving(&self, py: Python<'_>, moving: cspace::Part) -> PyResult<PairSpace> {
        let pair = self.pair.clone();
        work::run(py, move |progress| {
            let options = Options {
                window: pair.window,
                ..Options::default()
            };
            PairSpace::compute_with(&pair.fixed, &moving, pair.relation, &options, progress)
                .map_err(|e| e.to_string())
        })
    }

    /// The space in which a question about some configurations is answered, and the gap by which the moving part is smaller in it, where
    /// the parts fit exactly at one of them.
    fn with_room(
        &self,
        py: Python<'_>,
        at: impl IntoIterator<Item = Coordinates>,
    ) -> PyResult<(Arc<PairSpace>, Option<f64>)> {
        let space = &self.known(py)?.space;
        // What cannot be asked there is told where it is asked.
        let fits = |at: Coordinates| fits_exactly(space, at).unwrap_or(false);
        if !at.into_iter().any(fits) {
            return Ok((Arc::clone(space), None));
        }
        let roomy = match self.roomy.get() {
            Some(roomy) => roomy,
            None => {
                let roomy = match with_gap(&self.pair.fixed, &self.pair.moving) {
                    Some((smaller, gap)) => Some((Arc::new(self.with_moving(py, smaller)?), gap)),
                    None => None,
                };
                self.roomy.get_or_init(|| roomy)
            }
        };
        Ok(match roomy {
            Some((space, gap)) => (Arc::clone(space), Some(*gap)),
            None => (Arc::clone(space), None),
        })
    }

    /// The space itself.
    pub(crate) fn shared(&self, py: Python<'_>) -> PyResult<Arc<PairSpace>> {
        Ok(Arc::clone(&self.known(py)?.space))
    }

    /// The space, prepared for millions of questions once so many have been asked; these many follow.
    fn ready(&self, py: Python<'_>, questions: usize) -> PyResult<&Known> {
        let known = self.known(py)?;
        let before = known.asked.fetch_add(questions as u64, Ordering::Relaxed);
        if before <= SINGLE && before.saturating_add(questions as u64) > SINGLE {
            let pool = work::pool()?;
            work::here(py, || {
                pool.install(|| known.prepare());
                Ok(())
            })?;
        }
        Ok(known)
    }
}

#[pymethods]
impl Space {
    /// The pair of a sent space, which computes it when it is first asked.
    #[staticmethod]
    #[pyo3(signature = (fixed, moving, relation, window))]
    fn _restored(
        fixed: &Part,
        moving: &Part,
        relation: &str,
        window: Option<(f64, f64)>,
    ) -> PyResult<Self> {
        Ok(Self::later(Pair {
            fixed: fixed.part.clone(),
            moving: moving.part.clone(),
            relation: serde_json::from_str(relation).map_err(error)?,
            window,
        }))
    }

    fn _relation(&self) -> PyResult<String> {
        serde_json::to_string(&self.pair.relation).map_err(error)
    }

    #[getter]
    fn window(&self) -> Option<(f64, f64)> {
        self.pair.window
    }

    /// The fixed part.
    #[getter]
    fn fixed(&self) -> Part {
        let part = self.pair.fixed.clone();
        Part { part }
    }

    /// The moving part.
    #[getter]
    fn moving(&self) -> Part {
        let part = self.pair.moving.clone();
        Part { part }
    }

    /// The class of the pair: lower, fixed-axes, symmetric or general.
    #[getter]
    fn pair_class(&self, py: Python<'_>) -> PyResult<&'static str> {
        Ok(self.known(py)?.space.class().name())
    }

    /// Contacts are known to this, a length.
    #[getter]
    fn resolution(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.known(py)?.space.resolution())
    }

    /// 0 where the configuration is free, 1 where the parts overlap, 2 in contact: an integer for one configuration, an array of uint8 for
    /// rows.
    fn classify<'py>(&self, py: Python<'py>, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        match asked(q, &self.known(py)?.space)? {
            Asked::One(at) => {
                let known = self.ready(py, 1)?;
                code(known.classify(at).map_err(error)?).into_bound_py_any(py)
            }
            Asked::Many(rows) => {
                let known = self.ready(py, rows.shape()[0])?;
                let found = each(py, &rows, |at| known.classify(at).map(code))?;
                Ok(found.into_pyarray(py).into_any())
            }
        }
    }

    /// The smallest distance of the parts: 0 in contact, nan where they overlap.
    fn clearance<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let space = &self.known(py)?.space;
        let answer = |at| match space.clearance(at) {
            Err(QueryError::Blocked) => Ok(f64::NAN),
            found => found,
        };
        match asked(q, space)? {
            Asked::One(at) => answer(at).map_err(error)?.into_bound_py_any(py),
            Asked::Many(rows) => Ok(each(py, &rows, answer)?.into_pyarray(py).into_any()),
        }
    }

    /// The number of the free region; where the configuration is not free None of one, and -1 of many.
    fn region<'py>(&self, py: Python<'py>, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let space = &self.known(py)?.space;
        let answer = |at| {
            Ok(match space.locate(at)? {
                Location::Free(region) => region.index() as i64,
                Location::Contact | Location::Blocked => -1,
                Location::Outside => return Err(QueryError::Outside),
            })
        };
        match asked(q, space)? {
            Asked::One(at) => {
                let region = answer(at).map_err(error)?;
                (region >= 0).then_some(region).into_bound_py_any(py)
            }
            Asked::Many(rows) => Ok(each(py, &rows, answer)?.into_pyarray(py).into_any()),
        }
    }

    /// The free regions: for each a free configuration, and whether it is caged, that is, ends everywhere.
    fn _regions(&self, py: Python<'_>) -> PyResult<Vec<(Vec<f64>, bool)>> {
        let regions = self.known(py)?.space.regions();
        let of = |r: cspace::PairRegion| (numbers(r.sample), !r.unbounded);
        Ok(regions.into_iter().map(of).collect())
    }

    /// The contact patches: features of the fixed and of the moving part, the region and the orientations they bound, if any.
    #[expect(clippy::type_complexity, reason = "Python makes records of it")]
    fn _patches(
        &self,
        py: Python<'_>,
    ) -> PyResult<Vec<(String, String, Option<usize>, Option<(f64, f64)>)>> {
        let space = &self.known(py)?.space;
        let of = |patch: cspace::PairPatch<'_>| {
            let (fixed, moving) = patch.features()?;
            let [fixed, moving] = texts(space, (fixed.name, moving.name));
            let region = patch.region()?.map(cspace::RegionId::index);
            Ok((fixed, moving, region, patch.orientations().ok()))
        };
        let all: Result<Vec<_>, QueryError> = space.patches().map(of).collect();
        all.map_err(error)
    }

    /// Links between patches as arrays: first patch, second patch, and the smallest and largest orientation of the link (nan on fixed
    /// axes).
    #[expect(clippy::type_complexity, reason = "four arrays")]
    fn links<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(
        Bound<'py, PyArray1<i64>>,
        Bound<'py, PyArray1<i64>>,
        Bound<'py, PyArray1<f64>>,
        Bound<'py, PyArray1<f64>>,
    )> {
        let links = self.known(py)?.space.links();
        let ends = |kind: &LinkKind| match *kind {
            LinkKind::Side => (f64::NAN, f64::NAN),
            LinkKind::SideOver { lo, hi } => (lo, hi),
            LinkKind::Vertical { theta } => (theta, theta),
        };
        let column =
            |of: &dyn Fn(&cspace::PairLink) -> i64| -> Vec<i64> { links.iter().map(of).collect() };
        let (lo, hi): (Vec<f64>, Vec<f64>) = links.iter().map(|l| ends(&l.kind)).unzip();
        Ok((
            column(&|l| l.first.index() as i64).into_pyarray(py),
            column(&|l| l.second.index() as i64).into_pyarray(py),
            lo.into_pyarray(py),
            hi.into_pyarray(py),
        ))
    }

    /// The patches no farther than `tolerance` from a configuration, with the distances.
    #[pyo3(signature = (q, tolerance=None))]
    fn contacts(
        &self,
        py: Python<'_>,
        q: &Bound<'_, PyAny>,
        tolerance: Option<f64>,
    ) -> PyResult<Vec<(usize, f64)>> {
        let space = &self.known(py)?.space;
        let at = one(q, space, "q")?;
        let tolerance = tolerance.unwrap_or_else(|| space.resolution());
        check("tolerance", tolerance)?;
        let found = space.contacts(at, tolerance).map_err(error)?;
        Ok(found.into_iter().map(|(p, off)| (p.index(), off)).collect())
    }

    /// The nearest configuration in contact: its patch, the configuration, and how far it is.
    fn _nearest(
        &self,
        py: Python<'_>,
        q: &Bound<'_, PyAny>,
    ) -> PyResult<Option<(usize, Vec<f64>, f64)>> {
        let space = Arc::clone(&self.known(py)?.space);
        let at = one(q, &space, "q")?;
        let found = work::run(py, move |_| {
            space.nearest_contact(at).map_err(|e| e.to_string())
        })?;
        Ok(found.map(|n| (n.patch.index(), numbers(n.at), n.distance)))
    }

    /// The features that touch, or are no farther than `within` apart: names on the fixed and the moving part, and their distance.
    fn near_features(
        &self,
        py: Python<'_>,
        q: &Bound<'_, PyAny>,
        within: f64,
    ) -> PyResult<Vec<(String, String, f64)>> {
        let space = &self.known(py)?.space;
        let at = one(q, space, "q")?;
        check("within", within)?;
        let near = space.near_features(at, within).map_err(error)?;
        let of = |n: &cspace::pair::NearFeatures| {
            let [fixed, moving] = texts(space, pair_of(n));
            (fixed, moving, n.distance)
        };
        Ok(near.iter().map(of).collect())
    }

    /// A motion of constant rates from `start` by the displacement `by`: what becomes of it, how much of it is done, where it ends, and
    /// what touches there, and the gap that was taken.
    #[expect(clippy::type_complexity, reason = "Python makes a record of it")]
    fn _move(
        &self,
        py: Python<'_>,
        start: &Bound<'_, PyAny>,
        by: &Bound<'_, PyAny>,
        about: (f64, f64),
    ) -> PyResult<(&'static str, f64, Vec<f64>, Vec<[String; 2]>, Option<f64>)> {
        let space = &self.known(py)?.space;
        let (from, by) = (one(start, space, "start")?, one(by, space, "by")?);
        let (space, gap) = self.with_room(py, [from])?;
        let about = Vector::new(about.0, about.1);
        let done = displace(&space, &Motion::new(from, by).about(about)).map_err(error)?;
        let touching = done.features.into_iter().map(|p| texts(&space, p));
        Ok((
            done.outcome.name(),
            done.fraction,
            numbers(done.at),
            touching.collect(),
            gap,
        ))
    }

    /// For each coordinate how far it goes down and up from a free configuration when it alone changes, and what touches at the two ends;
    /// infinite where nothing stops it. With the gap that was taken.
    #[expect(clippy::type_complexity, reason = "Python makes records of it")]
    fn _play(
        &self,
        py: Python<'_>,
        q: &Bound<'_, PyAny>,
    ) -> PyResult<(
        Vec<(&'static str, [f64; 2], [Vec<[String; 2]>; 2])>,
        Option<f64>,
    )> {
        let at = one(q, &self.known(py)?.space, "q")?;
        let (space, gap) = self.with_room(py, [at])?;
        let found = work::run(py, move |_| {
            let all: &[Coordinate] = match width(&space) {
                2 => &[Coordinate::U, Coordinate::V],
                _ => &[Coordinate::X, Coordinate::Y, Coordinate::Theta],
            };
            let of = |of: &Coordinate| {
                let ends = free_range(&space, *of, at).map_err(|e| e.to_string())?;
                let mut found = [f64::NEG_INFINITY, f64::INFINITY];
                let mut features = [Vec::new(), Vec::new()];
                for ((end, names), stop) in found.iter_mut().zip(&mut features).zip(ends) {
                    if let Some((value, stop)) = stop {
                        *end = value;
                        names.extend(stop.features.into_iter().map(|p| texts(&space, p)));
                    }
                }
                Ok((of.name(), found, features))
            };
            all.iter().map(of).collect()
        })?;
        Ok((found, gap))
    }

    /// A path from `start` to `goal` through free space, or out where there is none, or that there is none: the answer, and the rows of the
    /// path. An infinite clearance asks for the widest path.
    #[pyo3(signature = (start, goal=None, clearance=None, about=None, prefer="legs"))]
    fn _plan<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        goal: Option<&Bound<'py, PyAny>>,
        clearance: Option<f64>,
        about: Option<(f64, f64)>,
        prefer: &str,
    ) -> PyResult<Told<'py>> {
        let space = &self.known(py)?.space;
        let from = one(start, space, "start")?;
        let to = goal.map(|goal| one(goal, space, "goal")).transpose()?;
        let (space, gap) = self.with_room(py, [from].into_iter().chain(to))?;
        if let Some(least) = clearance.filter(|c| *c != f64::INFINITY) {
            check("clearance", least)?;
        }
        let wishes = Wishes {
            clearance: match clearance {
                Some(f64::INFINITY) => Clearance::Widest,
                Some(least) => Clearance::AtLeast(least),
                None => Clearance::Half,
            },
            prefer: match prefer {
                "legs" => Prefer::Legs,
                "clearance" => Prefer::Clearance,
                "length" => Prefer::Length,
                _ => {
                    return Err(error(
                        "`prefer` is none of \"legs\", \"clearance\" and \"length\"",
                    ));
                }
            },
            ..Wishes::default()
        };
        let about = about.map(|(x, y)| Vector::new(x, y));
        let planned = work::run(py, move |progress| {
            let begin = progress.seconds();
            let planner = match about {
                Some(about) => Planner::with_about(&space, about),
                None => Planner::new(&space),
            };
            let planner = planner.map_err(|e| e.to_string())?;
            let answer = match to {
                Some(to) => planner.plan_with(from, to, &wishes, progress),
                None => (planner.plan_out(from, &wishes, progress)).map(|out| out.1),
            };
            let answer = answer.map_err(|e| e.to_string())?;
            let seconds = progress.seconds() - begin;
            let mut plan = Plan::planned(&space, (planner.scene(), None), to, answer, seconds);
            plan.gap = gap;
            let pair = PairAnswer {
                fixed: space.fixed().name().to_owned(),
                moving: space.moving().name().to_owned(),
                outcome: plan.verdict,
                content: plan,
            };
            Planned::new(Answer::of_pairs(None, vec![pair]))
        })?;
        planned.told(py)
    }

    /// The boundary of free space at an orientation, as loops of (x, y, bulge), and whether it is in doubt.
    fn slice(&self, py: Python<'_>, theta: f64) -> PyResult<(Loops, bool)> {
        let space = Arc::clone(&self.known(py)?.space);
        let PairSpace::Planar(space) = &*space else {
            return Err(error(format_args!(
                "a {} pair has no slices",
                space.class()
            )));
        };
        let window = space.window();
        if !(theta.is_finite() && (window.full_turn || (window.lo..=window.hi).contains(&theta))) {
            return Err(error(
                "`theta` is not finite, or outside the window of orientations",
            ));
        }
        let (space, pool) = (Arc::clone(space), work::pool()?);
        work::here(py, || Ok(pool.install(|| loops(&space.slice(theta)))))
    }

    /// The contact surface as triangles: vertices n×3 (x, y, theta), faces m×3, and the patch of each face.
    #[pyo3(signature = (tolerance=1e-3))]
    #[expect(clippy::type_complexity, reason = "three arrays")]
    fn mesh<'py>(
        &self,
        py: Python<'py>,
        tolerance: f64,
    ) -> PyResult<(
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<i64>>,
        Bound<'py, PyArray1<i64>>,
    )> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(error("`tolerance` is not a positive number"));
        }
        let space = Arc::clone(&self.known(py)?.space);
        let mesh = work::run(py, move |_| {
            let PairSpace::Planar(space) = &*space else {
                return Err(format!(
                    "a {} pair has no surface in x, y and theta",
                    space.class()
                ));
            };
            Mesh::new(space, &MeshOptions { tolerance }).map_err(|e| e.to_string())
        })?;
        let vertices = (mesh.vertices.iter()).map(|c| vec![c.x, c.y, c.theta]);
        let faces = (mesh.triangles.iter()).map(|t| t.vertices.map(i64::from).to_vec());
        let patches: Vec<i64> = mesh
            .triangles
            .iter()
            .map(|t| i64::from(t.patch.0))
            .collect();
        Ok((
            matrix(py, vertices.collect())?,
            matrix(py, faces.collect())?,
            patches.into_pyarray(py),
        ))
    }

    /// The space as the JSON that the command saves and reads.
    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        let space = Arc::clone(&self.known(py)?.space);
        work::run(py, move |_| Ok(cspace_model::saved::pair_to_json(&space)))
    }

    fn __repr__(&self) -> String {
        let (fixed, moving) = (self.pair.fixed.name(), self.pair.moving.name());
        match self.known.get() {
            None => format!("ContactSpace({fixed:?}, {moving:?}, not computed yet)"),
            Some(known) => format!(
                "ContactSpace({fixed:?}, {moving:?}, {}, {} patches, {} free regions)",
                known.space.class(),
                known.space.patch_count(),
                known.space.region_count()
            ),
        }
    }
}
