//! The configuration space of a pair.

use std::collections::HashMap;
use std::fmt::Display;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use cspace::{
    Classification, Classifier, Configuration, ContactSpace, Coordinates, LinkKind, Location,
    Metric, NearFeatures, Options, PairSpace, QueryError, Relation, Vector, Window,
};
use cspace_api::plan::Plan;
use cspace_api::{Answer, PairAnswer};
use cspace_design::{FeaturePair, Motion, Unmeasured, displace, free_range, pair_of};
use cspace_model::model::Coordinate;
use cspace_model::saved::{self, SavedFile};
use cspace_model::write::mesh::{Mesh, MeshOptions};
use cspace_plan::{Clearance, Planner, Prefer, Wishes, fits_exactly, with_gap};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyUntypedArrayMethods};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::error::{error, of_model};
use crate::nest::{Loops, loops};
use crate::part::{Part, Told as ToldFeature, told};
use crate::plan::{Planned, Told};
use crate::rows::{
    self, Asked, asked, coordinates, each, each_of, matrix, numbers, one, patch_id, poses, width,
};
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
    /// The label of the unit of length, if the model has one.
    pub(crate) unit: Option<String>,
}

impl Pair {
    /// The pair of a space that was saved.
    fn of(space: &PairSpace, unit: Option<String>) -> Self {
        let (relation, window) = match space {
            PairSpace::Planar(space) => {
                let Window { lo, hi, full_turn } = space.window();
                (Relation::Planar, (!full_turn).then_some((lo, hi)))
            }
            PairSpace::FixedAxes(space) => {
                let (fixed, moving) = space.axes();
                (Relation::Axes { fixed, moving }, None)
            }
            PairSpace::Lower(pair) => (Relation::Joint(pair.joint(), pair.limits()), None),
        };
        Self {
            fixed: space.fixed().clone(),
            moving: space.moving().clone(),
            relation,
            window,
            unit,
        }
    }
}

/// Pairs of features, each once, and their numbers.
struct Pairs<'a> {
    pair: &'a Pair,
    all: Vec<FeaturePair>,
    numbers: HashMap<FeaturePair, usize>,
}

/// Features of the fixed and of the moving part, as Python reads them.
type ToldPairs = Vec<(ToldFeature, ToldFeature)>;

impl<'a> Pairs<'a> {
    fn of(pair: &'a Pair) -> Self {
        Self {
            pair,
            all: Vec::new(),
            numbers: HashMap::new(),
        }
    }

    fn numbers(&mut self, pairs: impl IntoIterator<Item = FeaturePair>) -> Vec<usize> {
        let all = &mut self.all;
        let mut number = |pair| {
            *self.numbers.entry(pair).or_insert_with(|| {
                all.push(pair);
                all.len() - 1
            })
        };
        pairs.into_iter().map(&mut number).collect()
    }

    fn told(self) -> ToldPairs {
        let Pair { fixed, moving, .. } = self.pair;
        let of = |(f, m): FeaturePair| (told(fixed, f), told(moving, m));
        self.all.into_iter().map(of).collect()
    }
}

/// A smaller moving part's space, and by how much it is smaller.
type Roomy = (Arc<PairSpace>, f64);

/// A space, with what prepares it for many questions.
struct Known {
    space: Arc<PairSpace>,
    classifier: OnceLock<Classifier<Arc<ContactSpace>>>,
    asked: AtomicU64,
}

impl Known {
    fn new(space: Arc<PairSpace>) -> Self {
        Self {
            space,
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
    roomy: OnceLock<Option<Roomy>>,
}

fn code(class: Classification) -> u8 {
    match class {
        Classification::Free => 0,
        Classification::Blocked => 1,
        Classification::Contact => 2,
    }
}

/// Whether the parts fit exactly at a configuration; what cannot be asked there is told where it is asked.
fn fits(space: &PairSpace, at: Coordinates) -> bool {
    fits_exactly(space, at).unwrap_or(false)
}

/// How far each coordinate goes from a configuration when it alone changes, and what touches at the two ends.
type Ranges = Vec<([f64; 2], [Vec<FeaturePair>; 2])>;

/// The coordinates of a space.
fn names(space: &PairSpace) -> &'static [Coordinate] {
    match width(space) {
        2 => &[Coordinate::U, Coordinate::V],
        _ => &[Coordinate::X, Coordinate::Y, Coordinate::Theta],
    }
}

fn ranges(space: &PairSpace, at: Coordinates) -> Result<Ranges, Unmeasured> {
    let of = |of: &Coordinate| {
        let mut found = [f64::NEG_INFINITY, f64::INFINITY];
        let mut features = [Vec::new(), Vec::new()];
        let ends = free_range(space, *of, at)?;
        for ((end, touching), stop) in found.iter_mut().zip(&mut features).zip(ends) {
            if let Some((value, stop)) = stop {
                *end = value;
                *touching = stop.features;
            }
        }
        Ok((found, features))
    };
    names(space).iter().map(of).collect()
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

    /// A space that is computed already.
    pub(crate) fn of(space: Arc<PairSpace>, unit: Option<String>) -> Self {
        Self {
            pair: Pair::of(&space, unit),
            known: OnceLock::from(Known::new(space)),
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
        Ok(self.known.get_or_init(|| Known::new(Arc::new(space))))
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
        let fits = at.into_iter().any(|at| fits(space, at));
        Ok(match self.roomy(py, fits)? {
            Some((space, gap)) => (Arc::clone(space), Some(*gap)),
            None => (Arc::clone(space), None),
        })
    }

    /// The space with room, if it is needed and there is one.
    fn roomy(&self, py: Python<'_>, is_needed: bool) -> PyResult<Option<&Roomy>> {
        if !is_needed {
            return Ok(None);
        }
        if self.roomy.get().is_none() {
            let roomy = match with_gap(&self.pair.fixed, &self.pair.moving) {
                Some((smaller, gap)) => Some((Arc::new(self.with_moving(py, smaller)?), gap)),
                None => None,
            };
            self.roomy.get_or_init(|| roomy);
        }
        Ok(self.roomy.get().and_then(Option::as_ref))
    }

    /// Answers about rows of numbers that begin with a configuration, each in the space that has room there, with the gap.
    fn in_rooms<T: Send, E: Display + Send>(
        &self,
        py: Python<'_>,
        (numbers, width): (&[f64], usize),
        answer: impl Fn(&PairSpace, &[f64]) -> Result<T, E> + Sync + Send,
    ) -> PyResult<Vec<(T, f64)>> {
        let space = &self.known(py)?.space;
        let start = |row: &[f64]| coordinates(&row[..rows::width(space)]);
        let is_needed = each_of(py, numbers, width, |row| {
            Ok::<_, E>(fits(space, start(row)))
        })?;
        let roomy = self.roomy(py, is_needed.contains(&true))?;
        each_of(py, numbers, width, |row| match roomy {
            Some((roomy, gap)) if fits(space, start(row)) => answer(roomy, row).map(|a| (a, *gap)),
            _ => answer(space, row).map(|a| (a, f64::NAN)),
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
    #[pyo3(signature = (fixed, moving, relation, window, unit))]
    fn _restored(
        fixed: &Part,
        moving: &Part,
        relation: &str,
        window: Option<(f64, f64)>,
        unit: Option<String>,
    ) -> PyResult<Self> {
        Ok(Self::later(Pair {
            fixed: fixed.part.clone(),
            moving: moving.part.clone(),
            relation: serde_json::from_str(relation).map_err(error)?,
            window,
            unit,
        }))
    }

    /// The space in a text that was saved; `file` is its name in errors.
    #[staticmethod]
    fn _loaded(py: Python<'_>, text: String, file: String) -> PyResult<Self> {
        let saved = work::run(py, move |_| {
            Ok(SavedFile::from_json(&text, &file).map_err(|e| of_model(&e)))
        })??;
        Ok(Self::of(Arc::new(saved.space), saved.unit))
    }

    fn _relation(&self) -> PyResult<String> {
        serde_json::to_string(&self.pair.relation).map_err(error)
    }

    #[getter]
    fn window(&self) -> Option<(f64, f64)> {
        self.pair.window
    }

    /// The label of the unit of length, if the model has one.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.pair.unit.as_deref()
    }

    /// Where the fixed and the moving part are at configurations: rows (x, y, theta) for each.
    #[expect(clippy::type_complexity, reason = "two arrays")]
    fn _poses<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<(Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>)> {
        let all = match asked(q, &self.known(py)?.space)? {
            Asked::One(at) => vec![at],
            Asked::Many(rows) => (rows.as_slice()?)
                .chunks_exact(rows.shape()[1])
                .map(coordinates)
                .collect(),
        };
        let pose = |at: Coordinates| match (at, self.pair.relation) {
            (Coordinates::Axes { u, v }, Relation::Axes { fixed, moving }) => {
                (fixed.configuration(u), moving.configuration(v))
            }
            (Coordinates::Planar(c), _) => (Configuration::default(), c),
            (Coordinates::Axes { .. }, _) => Default::default(),
        };
        Ok((
            poses(py, &all, |at| pose(at).0)?,
            poses(py, &all, |at| pose(at).1)?,
        ))
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

    /// The contact patches: pairs of features, and for each patch the number of its pair, the region and the orientations it bounds, if
    /// any.
    #[expect(clippy::type_complexity, reason = "Python makes records of it")]
    fn _patches(
        &self,
        py: Python<'_>,
    ) -> PyResult<(ToldPairs, Vec<(usize, Option<usize>, Option<(f64, f64)>)>)> {
        let space = &self.known(py)?.space;
        let mut pairs = Pairs::of(&self.pair);
        let mut of = |patch: cspace::PairPatch<'_>| {
            let (fixed, moving) = patch.features()?;
            let number = pairs.numbers([(fixed.name, moving.name)])[0];
            let region = patch.region()?.map(cspace::RegionId::index);
            Ok((number, region, patch.orientations().ok()))
        };
        let all: Result<Vec<_>, QueryError> = space.patches().map(&mut of).collect();
        Ok((pairs.told(), all.map_err(error)?))
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

    /// The patches no farther than `tolerance` from configurations: of one their numbers and distances, of many arrays of the rows, the
    /// numbers and the distances.
    #[pyo3(signature = (q, tolerance=None))]
    fn contacts<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        tolerance: Option<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let space = &self.known(py)?.space;
        let tolerance = tolerance.unwrap_or_else(|| space.resolution());
        check("tolerance", tolerance)?;
        let answer = |at| space.contacts(at, tolerance);
        let rows = match asked(q, space)? {
            Asked::One(at) => {
                let found = answer(at).map_err(error)?.into_iter();
                let found: Vec<_> = found.map(|(p, off)| (p.index(), off)).collect();
                return found.into_bound_py_any(py);
            }
            Asked::Many(rows) => each(py, &rows, answer)?,
        };
        let mut columns = (Vec::new(), Vec::new(), Vec::new());
        for (row, found) in (0_i64..).zip(rows) {
            for (patch, off) in found {
                columns.0.push(row);
                columns.1.push(patch.index() as i64);
                columns.2.push(off);
            }
        }
        let (rows, patches, offs) = columns;
        (
            rows.into_pyarray(py),
            patches.into_pyarray(py),
            offs.into_pyarray(py),
        )
            .into_bound_py_any(py)
    }

    /// The nearest configurations in contact, of a patch or of any, at the same orientation or with a radian that counts as a length:
    /// arrays of the patches, -1 where there is none, of the configurations, and how far they are. And whether one was asked about.
    #[pyo3(signature = (q, length_per_radian, patch))]
    #[expect(clippy::type_complexity, reason = "three arrays")]
    fn _nearest<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
        length_per_radian: Option<f64>,
        patch: Option<i64>,
    ) -> PyResult<(
        (
            Bound<'py, PyArray1<i64>>,
            Bound<'py, PyArray2<f64>>,
            Bound<'py, PyArray1<f64>>,
        ),
        bool,
    )> {
        let space = &self.known(py)?.space;
        let onto = patch.map(|p| patch_id(space, p)).transpose()?;
        let answer = move |space: &PairSpace, at: Coordinates| {
            let Some(length_per_radian) = length_per_radian else {
                let found = space.nearest_contact(at)?;
                return Ok(found.map(|n| (n.patch, n.at, n.distance)));
            };
            let metric = Metric { length_per_radian };
            let found = match onto {
                Some(onto) => Some((onto, space.project(at, onto, metric)?)),
                None => space.nearest_patch(at, metric)?,
            };
            Ok::<_, QueryError>(found.map(|(patch, p)| (patch, p.at, p.distance)))
        };
        let asked = asked(q, space)?;
        let is_one = matches!(asked, Asked::One(_));
        let all = match asked {
            Asked::One(at) => {
                let space = Arc::clone(space);
                let found = work::run(py, move |_| answer(&space, at).map_err(|e| e.to_string()))?;
                vec![found]
            }
            Asked::Many(rows) => each(py, &rows, |at| answer(space, at))?,
        };
        let nowhere = || vec![f64::NAN; width(space)];
        let patches = (all.iter()).map(|n| n.map_or(-1, |n| n.0.index() as i64));
        let places = all.iter().map(|n| n.map_or_else(nowhere, |n| numbers(n.1)));
        let distances = all.iter().map(|n| n.map_or(f64::INFINITY, |n| n.2));
        let found = (
            patches.collect::<Vec<_>>().into_pyarray(py),
            matrix(py, places.collect())?,
            distances.collect::<Vec<_>>().into_pyarray(py),
        );
        Ok((found, is_one))
    }

    /// The features that touch, or are no farther than `within` apart: pairs of features, and of each its number and the distance.
    fn _features_within(
        &self,
        py: Python<'_>,
        q: &Bound<'_, PyAny>,
        within: f64,
    ) -> PyResult<(ToldPairs, Vec<f64>)> {
        let space = &self.known(py)?.space;
        let at = one(q, space, "q")?;
        check("within", within)?;
        let near = space.near_features(at, within).map_err(error)?;
        let Pair { fixed, moving, .. } = &self.pair;
        let of = |n: &NearFeatures| {
            let (f, m) = pair_of(n);
            ((told(fixed, f), told(moving, m)), n.distance)
        };
        Ok(near.iter().map(of).unzip())
    }

    /// Motions of constant rates from `start` by the displacements `by`, of which one may go with many: arrays of what becomes of them, how
    /// much of it is done, where they end, and the gaps that were taken, nan without; pairs of features, and the numbers of those that touch
    /// there. And whether one was asked about.
    #[expect(clippy::type_complexity, reason = "Python makes a record of it")]
    fn _move<'py>(
        &self,
        py: Python<'py>,
        start: &Bound<'py, PyAny>,
        by: &Bound<'py, PyAny>,
        about: (f64, f64),
    ) -> PyResult<(
        (
            Vec<&'static str>,
            Bound<'py, PyArray1<f64>>,
            Bound<'py, PyArray2<f64>>,
            Bound<'py, PyArray1<f64>>,
        ),
        (ToldPairs, Vec<Vec<usize>>),
        bool,
    )> {
        let space = &self.known(py)?.space;
        let width = width(space);
        let (start, by) = (asked(start, space)?, asked(by, space)?);
        let is_one = matches!((&start, &by), (Asked::One(_), Asked::One(_)));
        let [start, by] = [start.numbers()?, by.numbers()?];
        let (from, to) = (start.len() / width, by.len() / width);
        if from != to && from != 1 && to != 1 {
            return Err(error(format_args!(
                "`start` has {from} rows and `by` {to}: give as many, or one of either"
            )));
        }
        let row = |all: &[f64], i: usize| all[i * width % all.len()..][..width].to_vec();
        let count = if from.min(to) == 0 { 0 } else { from.max(to) };
        let both: Vec<f64> = (0..count)
            .flat_map(|i| [row(&start, i), row(&by, i)].concat())
            .collect();
        let about = Vector::new(about.0, about.1);
        let answer = |space: &PairSpace, row: &[f64]| {
            let (from, by) = row.split_at(width);
            let motion = Motion::new(coordinates(from), coordinates(by)).about(about);
            displace(space, &motion)
        };
        let all = match is_one {
            true => {
                let (space, gap) = self.with_room(py, [coordinates(&both[..width])])?;
                let done = work::here(py, || answer(&space, &both).map_err(error))?;
                vec![(done, gap.unwrap_or(f64::NAN))]
            }
            false => self.in_rooms(py, (&both, 2 * width), answer)?,
        };
        let mut pairs = Pairs::of(&self.pair);
        let touching = (all.iter()).map(|(d, _)| pairs.numbers(d.features.iter().copied()));
        let touching = touching.collect();
        let fractions: Vec<f64> = all.iter().map(|(d, _)| d.fraction).collect();
        let gaps: Vec<f64> = all.iter().map(|(_, gap)| *gap).collect();
        let places = all.iter().map(|(d, _)| numbers(d.at)).collect();
        Ok((
            (
                all.iter().map(|(d, _)| d.outcome.name()).collect(),
                fractions.into_pyarray(py),
                matrix(py, places)?,
                gaps.into_pyarray(py),
            ),
            (pairs.told(), touching),
            is_one,
        ))
    }

    /// For each coordinate how far it goes down and up from free configurations when it alone changes, infinite where nothing stops it, nan
    /// where of many one is not free, as arrays n×2, and for each row the numbers of the pairs that touch at the two ends. With the gaps
    /// that were taken, nan without, the pairs of features, and whether one was asked about.
    #[expect(clippy::type_complexity, reason = "Python makes records of it")]
    fn _play<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'py, PyAny>,
    ) -> PyResult<(
        Vec<(
            &'static str,
            Bound<'py, PyArray2<f64>>,
            Vec<[Vec<usize>; 2]>,
        )>,
        Bound<'py, PyArray1<f64>>,
        ToldPairs,
        bool,
    )> {
        let space = &self.known(py)?.space;
        let asked = asked(q, space)?;
        let is_one = matches!(asked, Asked::One(_));
        let all = match asked {
            Asked::One(at) => {
                let (space, gap) = self.with_room(py, [at])?;
                let found = work::run(py, move |_| ranges(&space, at).map_err(|e| e.to_string()))?;
                vec![(Some(found), gap.unwrap_or(f64::NAN))]
            }
            Asked::Many(rows) => {
                let answer = |space: &PairSpace, row: &[f64]| match ranges(space, coordinates(row))
                {
                    Err(Unmeasured::Blocked) => Ok(None),
                    found => found.map(Some),
                };
                self.in_rooms(py, (rows.as_slice()?, width(space)), answer)?
            }
        };
        let mut pairs = Pairs::of(&self.pair);
        let mut of = |(k, of): (usize, &Coordinate)| {
            let (mut ends, mut touching) = (Vec::new(), Vec::new());
            for (found, _) in &all {
                let (end, features) = match found {
                    Some(found) => (found[k].0, found[k].1.clone()),
                    None => ([f64::NAN; 2], Default::default()),
                };
                ends.push(end.to_vec());
                touching.push(features.map(|all| pairs.numbers(all)));
            }
            Ok((of.name(), matrix(py, ends)?, touching))
        };
        let found: PyResult<Vec<_>> = names(space).iter().enumerate().map(&mut of).collect();
        let gaps: Vec<f64> = all.iter().map(|(_, gap)| *gap).collect();
        Ok((found?, gaps.into_pyarray(py), pairs.told(), is_one))
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
        let unit = self.pair.unit.clone();
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
            Planned::new(Answer::of_pairs(unit.as_deref(), vec![pair]))
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
        let (space, unit) = (Arc::clone(&self.known(py)?.space), self.pair.unit.clone());
        work::run(py, move |_| {
            Ok(saved::with_labels(&space, None, unit.as_deref()))
        })
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
