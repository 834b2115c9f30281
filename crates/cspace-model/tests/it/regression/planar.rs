//! Expectations of contact spaces.

use core::f64::consts::TAU;

use cspace::{
    Classification, Classifier, Configuration, ContactSpace, Options, RegionId, Slice, Slicer,
};
use cspace_model::Mechanism;
use cspace_oracle::{Oracle, Verdict, effort, near_contact};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::regression::expectation::{Around, At, By, Planar, Saved, Sliced};

/// A space and all who say what is free.
struct Pair {
    space: ContactSpace,
    slicer: Slicer,
    oracle: Oracle,
}

fn class(free: bool) -> Option<Classification> {
    Some(if free {
        Classification::Free
    } else {
        Classification::Blocked
    })
}

/// The curves that no other follows.
fn open(slice: &Slice) -> usize {
    let len = slice.curves.len();
    let open = slice.curves.iter().filter(|c| c.next as usize >= len);
    open.count()
}

pub(crate) fn check(model: &Mechanism, e: &Planar) {
    let mut indices = [0, 1];
    if e.swapped {
        indices.reverse();
    }
    let [fixed, moving] = indices.map(|i| &model.parts[i].part);
    let options = Options {
        window: e.window,
        ..Options::default()
    };
    let space = ContactSpace::compute(fixed, moving, &options).unwrap();
    let is = |found: usize, expected: Option<usize>, what: &str| {
        assert!(expected.is_none_or(|e| found == e), "{what}: {found}");
    };
    let more = |found: usize, least: Option<usize>, what: &str| {
        assert!(least.is_none_or(|l| found > l), "{what}: {found}");
    };
    let regions = space.free_regions();
    let (patches, resolution) = (space.patches(), space.resolution());
    is(regions.len(), e.free_regions, "free regions");
    let caged = regions.iter().filter(|r| !r.unbounded).count();
    is(caged, e.caged_regions, "caged regions");
    let conflicts = space.statistics().conflicts as usize;
    is(conflicts, e.conflicts.map(|c| c as usize), "conflicts");
    let doubtful = space.doubtful_orientations().len();
    is(doubtful, e.doubtful_orientations, "doubtful orientations");
    more(patches.len(), e.patches_more_than, "patches");
    let outer = patches.iter().filter(|p| p.region == RegionId(0)).count();
    more(outer, e.outer_patches_more_than, "outer patches");
    if let Some((lo, hi)) = e.resolution {
        assert!((lo..hi).contains(&resolution), "{resolution:e}");
    }
    for theta in &e.critical_orientations {
        let mut off = (space.critical_orientations().iter()).map(|c| (c - theta).abs());
        assert!(off.any(|d| d < 1e-10), "{theta} is not critical");
    }
    if let Some(saved) = &e.saved {
        is_read_back(&space, saved);
    }
    let pair = Pair {
        space,
        slicer: Slicer::new(fixed, moving),
        oracle: Oracle::new(fixed, moving),
    };
    if e.slices_beside_contact {
        pair.slices_are_right();
    }
    if let Some(least) = e.beside_contact_more_than {
        let window = e.window.unwrap_or((-0.5 * TAU, 0.5 * TAU));
        let asked = effort(2_500, 10_000);
        let certain = pair.classified(asked, window);
        more(certain, Some(least * asked / 10_000), "certain");
    }
    if let Some(around) = &e.around_the_origin {
        pair.around(around);
    }
    if e.closed {
        for k in (0..360).step_by(effort(4, 1)) {
            let theta = (f64::from(k) + 0.4).to_radians();
            let [slice, scratch] = pair.both(theta);
            assert_eq!(open(&slice), 0, "open curves at {theta}");
            assert_eq!(slice.loops.len(), scratch.loops.len(), "loops at {theta}");
        }
    }
    for band in (pair.space.bands().iter()).filter(|_| e.loops_in_every_band) {
        let both = pair.both(0.5 * (band.lo + band.hi));
        assert!(both.iter().all(|s| !s.loops.is_empty()), "{band:?}");
    }
    for &theta in &e.no_open_curves_at {
        let counts = pair.both(theta).map(|s| open(&s));
        assert_eq!(counts, [0, 0], "open curves at {theta}");
    }
    e.at.iter().for_each(|at| pair.at(at));
    e.slice.iter().for_each(|sliced| pair.sliced(sliced));
}

fn is_read_back(space: &ContactSpace, expected: &Saved) {
    let saved = space.data();
    let text = serde_json::to_string(&saved).unwrap();
    let has = |word: &String| text.contains(word);
    assert!(expected.contains.iter().all(has) && !expected.lacks.iter().any(has));
    let read = serde_json::from_str(&text).unwrap();
    assert_eq!(ContactSpace::from_data(read).unwrap().data(), saved);
}

impl Pair {
    /// The slice of the space and that from scratch.
    fn both(&self, theta: f64) -> [Slice; 2] {
        [self.space.slice(theta), self.slicer.slice(theta)]
    }

    /// Margin above which a verdict is certain.
    fn least(&self) -> f64 {
        self.space.resolution().max(1e-10 * self.oracle.size())
    }

    fn slices_are_right(&self) {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for near in near_contact(&self.oracle, &mut rng, effort(400, 1000)) {
            let c = near.configuration;
            let free = self.space.slice(c.theta).is_free(c.position());
            let unsure = near.verdict.margin <= self.least();
            assert!(unsure || free == near.free, "the slice is wrong at {c:?}");
        }
    }

    /// Fails if the verdict is certain and the class differs; returns whether it is certain.
    fn agrees(&self, c: Configuration, verdict: Verdict, least: f64) -> bool {
        let right = self.space.classify(c) == class(!verdict.overlap);
        let certain = verdict.margin > least;
        assert!(right || !certain, "{c:?} is classified wrongly");
        certain
    }

    fn classified(&self, asked: usize, (lo, hi): (f64, f64)) -> usize {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let near = near_contact(&self.oracle, &mut rng, asked).into_iter();
        near.filter(|near| {
            let mut c = near.configuration;
            c.theta = lo + (hi - lo) * (c.theta / TAU).rem_euclid(1.0);
            self.agrees(c, self.oracle.judge(c), self.least())
        })
        .count()
    }

    fn around(&self, e: &Around) {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut free = 0;
        for _ in 0..3000 {
            let mut within = |w: f64| rng.random_range(-w..w);
            let c = Configuration::new(within(e.shift), within(e.shift), within(e.turn));
            let verdict = self.oracle.judge(c);
            free += usize::from(self.agrees(c, verdict, 1e-9) && !verdict.overlap);
        }
        assert!(free > e.free_more_than, "{free} are free");
    }

    fn told(&self, by: By, c: Configuration) -> Option<Classification> {
        match by {
            By::Space => self.space.classify(c),
            By::Classifier => Classifier::new(&self.space).classify(c),
            By::Slice | By::SliceUnlessDoubtful => {
                class(self.space.slice(c.theta).is_free(c.position()))
            }
            By::Scratch => class(self.slicer.slice(c.theta).is_free(c.position())),
            By::Oracle => class(!self.oracle.judge(c).overlap),
        }
    }

    fn at(&self, at: &At) {
        let all_say = |&[x, y, theta]: &[f64; 3], expected| {
            let c = Configuration::new(x, y, theta);
            for &by in &at.by {
                let excused = by == By::SliceUnlessDoubtful && self.space.slice(c.theta).doubtful;
                let told = self.told(by, c);
                assert!(excused || told == expected, "{by:?} says {told:?} of {c:?}");
            }
        };
        at.free.iter().for_each(|c| all_say(c, class(true)));
        at.blocked.iter().for_each(|c| all_say(c, class(false)));
        for row @ &[x, y, theta] in &at.judged {
            let c = Configuration::new(x, y, theta);
            let verdict = self.oracle.judge(c);
            let least = at.margin.unwrap_or(1e-10 * self.oracle.size());
            assert!(verdict.margin > least, "{c:?}: {verdict:?}");
            let open = at.margin.is_none() && verdict.margin <= self.space.resolution();
            let expected = if open {
                self.space.classify(c)
            } else {
                class(!verdict.overlap)
            };
            all_say(row, expected);
        }
    }

    fn sliced(&self, e: &Sliced) {
        for (&by, &theta) in
            e.of.iter()
                .flat_map(|b| e.theta.iter().map(move |t| (b, t)))
        {
            let slice = match by {
                By::Scratch => self.slicer.slice(theta),
                _ => self.space.slice(theta),
            };
            let length: f64 = slice.curves.iter().map(|c| c.geometry.length()).sum();
            let right = e.loops.is_none_or(|n| slice.loops.len() == n)
                && e.curves.is_none_or(|n| slice.curves.len() == n)
                && e.doubtful.is_none_or(|d| slice.doubtful == d)
                && e.length.is_none_or(|l| (length - l).abs() < 1e-8)
                && !(e.closed && open(&slice) > 0);
            assert!(right, "{by:?} at {theta}: {slice:?}");
        }
    }
}
