//! Structural changes within tolerances: contacts that take over, jams, regions; and how far tolerances may be scaled until a failure.

use crate::drawn::{DrawnContact, Encounter};
use cspace::{Ball, Real};
use cspace_model::model::{Subject, Target};
use schemars::JsonSchema;
use serde::Serialize;

use super::extremes::Summit;
use super::study::Study;
use super::vary::middle_and_half;
use crate::drawing::{Drawing, Enclosed, Hits, Slope};

/// Tolerances are scaled by at most this in the search for what fails.
pub const LARGEST_FACTOR: f64 = 16.0;

/// Shares of the tolerances are found to this, relative to them.
const RESOLUTION: f64 = 1e-12;

/// Contacts that come together but for this, relative to the time or the value, tie.
const TIE: f64 = 1e-9;

/// A change is looked for so much beyond its share: where it begins both are so.
const BEYOND: f64 = 1e-6;

/// Kind of a change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ChangeKind {
    /// Another contact decides the value.
    Contact,
    /// The parts overlap where it is measured.
    Jam,
    /// The value of yes or no changes, or there is none any more.
    Region,
}

impl ChangeKind {
    /// In a word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::Jam => "jam",
            Self::Region => "region",
        }
    }
}

/// Something that changes within the tolerances, or beyond them.
#[derive(Debug, Clone, PartialEq)]
pub struct Structural {
    /// Kind of the change.
    pub kind: ChangeKind,
    /// New state, in words.
    pub what: String,
    /// The features that touch, of the fixed and of the moving part, as messages call them.
    pub features: Vec<[String; 2]>,
    /// The deviations at which it first happens, in the order of the variations.
    pub at: Vec<f64>,
    /// How many times the tolerances that is.
    pub share: f64,
}

/// How far all tolerances may be scaled.
#[derive(Debug, Clone, PartialEq)]
pub struct Margin {
    /// By this; none if nothing fails up to [`LARGEST_FACTOR`].
    pub factor: Option<f64>,
    /// Failure there, in words.
    pub what: String,
}

/// A contact, with the share of the tolerances and the deviations at which it comes about.
type Sudden = (DrawnContact, f64, Vec<f64>);

/// A value with its derivatives by the parameters.
type Sloping = (f64, Vec<f64>);

impl Study<'_> {
    /// Names of a contact's features in a model.
    fn texts<T: Real>(&self, drawing: &Drawing<T>, contact: DrawnContact) -> Vec<[String; 2]> {
        let Subject::Pair(pair, _) = self.requirement_of(self.nominal).subject else {
            return Vec::new();
        };
        let [fixed, moving] = drawing.pair.names(contact);
        let part = |i: usize| &self.nominal.mechanism.parts[i].part;
        vec![[
            part(pair.fixed).feature_text(fixed),
            part(pair.moving).feature_text(moving),
        ]]
    }

    /// All changes, within tolerances that are doubled until something fails.
    pub(super) fn all_changes(&self) -> Vec<Structural> {
        let mut factor = 1.0;
        loop {
            let changes = self.changes(factor);
            let fails = changes.iter().any(|c| c.kind != ChangeKind::Contact);
            if fails || factor >= LARGEST_FACTOR {
                return changes;
            }
            factor *= 2.0;
        }
    }

    /// All changes within the tolerances by a factor, those that happen first before others.
    fn changes(&self, factor: f64) -> Vec<Structural> {
        let mut all = if self.is_drawn() {
            self.drawn_changes(factor)
        } else {
            Vec::new()
        };
        if !all.iter().any(|c| c.kind == ChangeKind::Jam) {
            all.extend(self.first_other_state(factor));
        }
        all.sort_by(|a, b| a.share.total_cmp(&b.share));
        all
    }

    /// Contacts that take over, and jams, of a quantity that first contacts decide.
    fn drawn_changes(&self, factor: f64) -> Vec<Structural> {
        let (middle, half) = middle_and_half(&self.variations.scaled(factor));
        let Some(drawings) = self.by_parameters(&middle, Some(&half)) else {
            return Vec::new();
        };
        let Some(first) = drawings.first() else {
            return Vec::new();
        };
        let plain: Drawing<Enclosed> = first.map(|x| x.value);
        let zero = vec![0.0; self.variations.len()];
        let Some(nominal) = self.at(&zero).hits else {
            return Vec::new();
        };
        let found = plain.encounters(&self.until, None);
        let mut all: Vec<Structural> = Vec::new();
        for (leg, encounters) in found.iter().enumerate() {
            for encounter in &encounters.list {
                let contact = encounter.contact;
                if contact != nominal.contacts[leg] {
                    let later = |x: &[f64]| self.later(x, leg, contact, &nominal.contacts);
                    if let Some((share, at)) = self.first_where(&later, factor)
                        && let Some(hits) = self.at(&scaled(&at, 1.0 + BEYOND)).hits
                        && hits.contacts[leg] == contact
                    {
                        all.push(Structural {
                            kind: ChangeKind::Contact,
                            what: "another contact decides the value".to_owned(),
                            features: self.texts(&plain, contact),
                            at,
                            share,
                        });
                    }
                }
                if encounter.lo <= 0.0 {
                    let depth = |x: &[f64]| self.depth(x, leg, contact);
                    if let Some((share, at)) = self.first_where(&depth, factor)
                        && let Err(failure) = self.at(&scaled(&at, 1.0 + BEYOND)).value
                        && failure.kind == "jam"
                    {
                        all.push(Structural {
                            kind: ChangeKind::Jam,
                            what: failure.reason,
                            features: self.texts(&plain, contact),
                            at,
                            share,
                        });
                    }
                }
            }
        }
        for (contact, share, at) in self.sudden_contacts(&nominal.contacts) {
            let features = self.texts(&plain, contact);
            if !all
                .iter()
                .any(|c| c.kind == ChangeKind::Contact && c.features == features)
            {
                let what = "another contact decides the value, which jumps".to_owned();
                all.push(Structural {
                    kind: ChangeKind::Contact,
                    what,
                    features,
                    at,
                    share,
                });
            }
        }
        all.sort_by(|a, b| a.share.total_cmp(&b.share));
        // Of jams only the first, with all features that overlap then; of others those within the tolerances.
        let mut distinct: Vec<Structural> = Vec::new();
        for change in all {
            let is_one = |c: &&mut Structural| {
                let jams = c.kind == ChangeKind::Jam && change.kind == ChangeKind::Jam;
                jams || c.kind == change.kind && c.features == change.features
            };
            match distinct.iter_mut().find(is_one) {
                Some(known) if change.share <= known.share * (1.0 + BEYOND) => {
                    for features in change.features {
                        if !known.features.contains(&features) {
                            known.features.push(features);
                        }
                    }
                }
                Some(_) => {}
                None if change.kind == ChangeKind::Contact && change.share > 1.0 => {}
                None => distinct.push(change),
            }
        }
        distinct
    }

    /// Contacts that there are not as drawn, and that come before the nominal ones towards a corner of the tolerances: of each the smallest share
    /// towards any corner.
    fn sudden_contacts(&self, nominal: &[DrawnContact]) -> Vec<Sudden> {
        let mut found: Vec<Sudden> = Vec::new();
        for corner in self.corners(1.0) {
            for leg in 0..nominal.len() {
                let Some(contact) = self.other_first(&corner, leg, nominal) else {
                    continue;
                };
                let (mut lo, mut hi) = (0.0, 1.0);
                while hi - lo > RESOLUTION * hi {
                    let share = 0.5 * (lo + hi);
                    if self.is_other(&scaled(&corner, share), leg, nominal) {
                        hi = share;
                    } else {
                        lo = share;
                    }
                }
                let is_same = |f: &&mut Sudden| f.0 == contact;
                match found.iter_mut().find(is_same) {
                    Some(known) if known.1 <= hi => {}
                    Some(known) => (known.1, known.2) = (hi, scaled(&corner, hi)),
                    None => found.push((contact, hi, scaled(&corner, hi))),
                }
            }
        }
        found
    }

    /// The first contact of a motion, if it is not the nominal one and that comes later, or not at all.
    fn other_first(&self, x: &[f64], leg: usize, nominal: &[DrawnContact]) -> Option<DrawnContact> {
        self.other_of(x, self.at(x).hits.as_ref()?, leg, nominal)
    }

    /// As above, for first contacts that are known.
    fn other_of(
        &self,
        x: &[f64],
        hits: &Hits,
        leg: usize,
        nominal: &[DrawnContact],
    ) -> Option<DrawnContact> {
        let (contact, time) = (hits.contacts[leg], hits.times[leg]);
        let own = self.nominal_times(x, nominal)?[leg];
        let is_other = own.is_none_or(|own| own > time * (1.0 + TIE));
        (contact != nominal[leg] && is_other).then_some(contact)
    }

    /// Whether another contact than the nominal ones decides the value at a point.
    fn is_other(&self, x: &[f64], leg: usize, nominal: &[DrawnContact]) -> bool {
        let point = self.at(x);
        if let Some(hits) = &point.hits {
            return self.other_of(x, hits, leg, nominal).is_some();
        }
        // First contacts are in doubt, as where one has only just come about.
        let (Ok(value), Some(times)) = (point.value, self.nominal_times(x, nominal)) else {
            return false;
        };
        let Some(times) = times.into_iter().collect::<Option<Vec<f64>>>() else {
            return true;
        };
        let expected = self.model(x).ok().and_then(|model| {
            let drawing = Drawing::<f64>::new(&model, self.requirement_of(&model), None)?;
            Some(drawing.value(nominal, &times))
        });
        expected.is_none_or(|e| (value - e).abs() > TIE * e.abs())
    }

    /// When the nominal contacts come about at a point, whether or not others are before them.
    fn nominal_times(&self, x: &[f64], nominal: &[DrawnContact]) -> Option<Vec<Option<f64>>> {
        let model = self.model(x).ok()?;
        let drawing = Drawing::<f64>::new(&model, self.requirement_of(&model), None)?;
        let enclosed = drawing.map(Ball::constant);
        let time = |(leg, contact): (usize, &DrawnContact)| {
            let motion = &enclosed.legs[leg];
            let until = self.until[leg];
            let sought = [Encounter::unknown(*contact, until)];
            let found = enclosed.pair.encounters(motion, until, Some(&sought));
            found.list.first().map(|e| 0.5 * (e.lo + e.hi))
        };
        Some(nominal.iter().enumerate().map(time).collect())
    }

    /// By how much a contact comes before that which decides the value nominally, with the derivatives.
    fn later(
        &self,
        x: &[f64],
        leg: usize,
        contact: DrawnContact,
        nominal: &[DrawnContact],
    ) -> Option<Sloping> {
        let model = self.model(x).ok()?;
        let drawing = Drawing::<f64>::new(&model, self.requirement_of(&model), None)?;
        let enclosed = drawing.map(Ball::constant);
        let time = |contact: DrawnContact| {
            let (motion, until) = (&enclosed.legs[leg], self.until[leg]);
            let sought = [Encounter::unknown(contact, until)];
            let found = enclosed.pair.encounters(motion, until, Some(&sought));
            let first = found.list.into_iter().find(|e| e.approaching)?;
            drawing.root(leg, &first)
        };
        let (other, own) = (time(contact)?, time(nominal[leg])?);
        let drawings = self.by_parameters(x, None)?;
        let slope = |d: &Drawing<Slope>| {
            let at = |contact, t| d.time(leg, contact, Enclosed::constant(t)).slope[0].mid;
            at(nominal[leg], own) - at(contact, other)
        };
        Some((own - other, drawings.iter().map(slope).collect()))
    }

    /// How deep the features of a contact overlap where a motion begins, with the derivatives; infinitely less than 0 where they do not face
    /// each other within their ends.
    fn depth(&self, x: &[f64], leg: usize, contact: DrawnContact) -> Option<(f64, Vec<f64>)> {
        let drawings = self.by_parameters(x, None)?;
        let gaps: Vec<Slope> = (drawings.iter())
            .map(|d| d.pair.gap(contact, d.legs[leg].from, |x| x))
            .collect();
        let first = drawings.first()?;
        let within = first.pair.within(contact, first.legs[leg].from);
        let is_beyond = within.iter().flatten().any(|w| w.value.mid < 0.0);
        let depth = if is_beyond {
            f64::NEG_INFINITY
        } else {
            -gaps.first()?.value.mid
        };
        Some((depth, gaps.iter().map(|g| -g.slope[0].mid).collect()))
    }

    /// The smallest share of the tolerances at which a function becomes 0 somewhere, and where: its largest value within each share is
    /// at the point to which its derivatives show.
    fn first_where(
        &self,
        function: &dyn Fn(&[f64]) -> Option<Sloping>,
        factor: f64,
    ) -> Option<(f64, Vec<f64>)> {
        const ROUNDS: usize = 6;
        // The largest value within a share.
        let largest = |share: f64, from: &[f64]| -> Option<(f64, Vec<f64>)> {
            let mut at = from.to_vec();
            let mut found = function(&at)?;
            for _ in 0..ROUNDS {
                let next = self.variations.farthest(&found.1, share);
                if next == at {
                    break;
                }
                let there = function(&next)?;
                if there.0 <= found.0 {
                    break;
                }
                (at, found) = (next, there);
            }
            Some((found.0, at))
        };
        let zero = vec![0.0; self.variations.len()];
        if function(&zero)?.0 >= 0.0 {
            return None;
        }
        // As drawn there may be no derivatives: circles may have one centre.
        let starts = self.corners(1.0);
        let (mut lo, mut hi, mut top) = growing(factor).find_map(|[lo, hi]| {
            let tops = starts.iter().filter_map(|to| largest(hi, &scaled(to, hi)));
            let (most, top) = tops.max_by(|a, b| a.0.total_cmp(&b.0))?;
            (most >= 0.0).then_some((lo, hi, top))
        })?;
        while hi - lo > RESOLUTION * hi {
            let share = 0.5 * (lo + hi);
            let from = scaled(
                &top,
                share / self.variations.share(&top).max(f64::MIN_POSITIVE),
            );
            match largest(share, &from) {
                Some((value, at)) if value >= 0.0 => (hi, top) = (share, at),
                _ => lo = share,
            }
        }
        Some((hi, top))
    }

    /// The smallest share of the tolerances towards a corner at which there is no value, or yes becomes no.
    fn first_other_state(&self, factor: f64) -> Option<Structural> {
        let zero = vec![0.0; self.variations.len()];
        let is_truth =
            self.requirement_of(self.nominal).dimension == cspace_model::model::Dimension::Truth;
        let state = |x: &[f64]| match self.at(x).value {
            Ok(value) if is_truth => (Some(value), String::new()),
            Ok(_) => (None, String::new()),
            Err(failure) => (None, failure.kind.to_owned()),
        };
        let nominal = state(&zero);
        let mut first: Option<(f64, Vec<f64>)> = None;
        for corner in self.corners(1.0) {
            let most = first.as_ref().map_or(factor, |f| f.0);
            let other = |share: &f64| state(&scaled(&corner, *share)) != nominal;
            let Some([mut lo, mut hi]) = growing(most).find(|[_, hi]| other(hi)) else {
                continue;
            };
            while hi - lo > RESOLUTION * hi {
                let share = 0.5 * (lo + hi);
                if state(&scaled(&corner, share)) == nominal {
                    lo = share;
                } else {
                    hi = share;
                }
            }
            first = Some((hi, scaled(&corner, hi)));
        }
        let (share, at) = first?;
        let point = self.at(&scaled(&at, 1.0 + BEYOND));
        let name = self.requirement_of(self.nominal).subject.name();
        let (kind, what) = match &point.value {
            Err(failure) if failure.kind == "jam" => (ChangeKind::Jam, failure.reason.clone()),
            Err(failure) => (ChangeKind::Region, failure.reason.clone()),
            Ok(1.0) if is_truth => (ChangeKind::Region, format!("{name} becomes yes")),
            Ok(_) if is_truth => (ChangeKind::Region, format!("{name} becomes no")),
            Ok(_) => (ChangeKind::Region, "there is no value".to_owned()),
        };
        Some(Structural {
            kind,
            what,
            features: Vec::new(),
            at,
            share,
        })
    }

    /// The factor on all tolerances at which the requirement is first not met, or the structure fails.
    pub(super) fn margin(&self, ends: [Option<&Summit>; 2], changes: &[Structural]) -> Margin {
        let requirement = self.requirement_of(self.nominal);
        let mut first = (f64::INFINITY, String::new());
        for change in changes.iter().filter(|c| c.kind != ChangeKind::Contact) {
            if change.share < first.0 {
                first = (change.share, change.what.clone());
            }
        }
        let zero = vec![0.0; self.variations.len()];
        let value = self.at(&zero).value;
        if let (Some(Target::Equals(wanted)), Ok(value)) = (requirement.target, &value)
            && (*value == 1.0) != wanted
        {
            return Margin {
                factor: Some(0.0),
                what: "it is not met as drawn".to_owned(),
            };
        }
        if let (Some(Target::Limits(lo, hi)), Ok(nominal)) = (requirement.target, value) {
            if !(lo..=hi).contains(&nominal) {
                return Margin {
                    factor: Some(0.0),
                    what: "the nominal value is outside the limits".to_owned(),
                };
            }
            for ((limit, sign), end) in [(lo, -1.0), (hi, 1.0)].into_iter().zip(ends) {
                if let Some(end) = end
                    && let Some(factor) = self.reaches(end, limit, sign, first.0)
                    && factor < first.0
                {
                    let which = if sign > 0.0 { "upper" } else { "lower" };
                    first = (factor, format!("the {which} limit is passed"));
                }
            }
        }
        if first.0.is_finite() {
            Margin {
                factor: Some(first.0),
                what: first.1,
            }
        } else {
            Margin {
                factor: None,
                what: format!("nothing fails up to {LARGEST_FACTOR} times the tolerances"),
            }
        }
    }

    /// The factor at which the extreme passes a limit.
    fn reaches(&self, end: &Summit, limit: f64, sign: f64, most: f64) -> Option<f64> {
        let share = self.variations.share(&end.at);
        let is_past = |factor: f64| {
            let mut starts = vec![vec![0.0; end.at.len()]];
            if share > 0.0 {
                starts.push(scaled(&end.at, factor / share));
            }
            let climbed = starts
                .iter()
                .filter_map(|from| self.climb(from, sign, factor));
            climbed
                .map(|found| sign * (found.value - limit))
                .any(|d| d > 0.0)
        };
        // Where parts begin to jam there is no value.
        let most = (most * (1.0 - TIE)).min(LARGEST_FACTOR);
        let within = sign * (end.value - limit) <= 0.0;
        let least = if within { most.min(1.0) } else { 0.0 };
        let mut spans = growing(most).filter(|span| span[1] > least);
        let [mut lo, mut hi] = spans.find(|span| is_past(span[1]))?;
        while hi - lo > RESOLUTION * hi {
            let factor = 0.5 * (lo + hi);
            if is_past(factor) {
                hi = factor;
            } else {
                lo = factor;
            }
        }
        Some(hi)
    }
}

/// Spans of shares that follow each other up to a factor, each as long as all before it: what fails far beyond may be right again.
fn growing(factor: f64) -> impl Iterator<Item = [f64; 2]> {
    const DOUBLINGS: i32 = 14;
    let at = move |k: i32| factor * 0.5_f64.powi(k);
    (0..=DOUBLINGS).rev().map(move |k| {
        let lo = if k == DOUBLINGS { 0.0 } else { at(k + 1) };
        [lo, at(k)]
    })
}

fn scaled(x: &[f64], by: f64) -> Vec<f64> {
    x.iter().map(|x| x * by).collect()
}
