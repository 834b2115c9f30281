//! Times at which features may touch along a motion, for all drawings that the numbers enclose.

use cspace::{Dual, Real};

use super::disc::Disc;
use super::{DrawnContact, DrawnPair, Enclosure};

/// Maximum number of evaluations of contact functions for a motion: above it, parts slide along each other all the time.
const MOST: usize = 200_000;

/// Number of times that the end of the motion is halved to get the first interval that is searched.
const DOUBLINGS: i32 = 10;

/// Times closer together than this, relative to the motion's end, are not separated.
const NARROWEST: f64 = 1e-14;

/// A motion of constant rates from a configuration: (x, y, θ), or (u, v, 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg<T> {
    /// Configuration at the start.
    pub from: [T; 3],
    /// Rates of the coordinates, per unit of time.
    pub rates: [T; 3],
}

impl<T: Real> Leg<T> {
    /// A motion without uncertainty.
    pub fn new(from: [f64; 3], rates: [f64; 3]) -> Self {
        Self {
            from: from.map(T::constant),
            rates: rates.map(T::constant),
        }
    }

    /// The configuration at a time.
    pub fn at(&self, time: T) -> [T; 3] {
        core::array::from_fn(|i| self.from[i] + time * self.rates[i])
    }
}

/// Interval of time within which a contact may begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Encounter {
    /// Features of the contact.
    pub contact: DrawnContact,
    /// The first time.
    pub lo: f64,
    /// The last time.
    pub hi: f64,
    /// Whether the features approach each other during the whole interval, so that every drawing has at most one contact in it.
    pub approaching: bool,
    /// Whether the features touch in the interval, at a place that lies on both, in every drawing in which the parts do not overlap where
    /// the motion begins.
    pub certain: bool,
}

impl Encounter {
    /// A contact about which nothing is known until a time.
    pub fn unknown(contact: DrawnContact, until: f64) -> Self {
        Self {
            contact,
            lo: 0.0,
            hi: until,
            approaching: false,
            certain: false,
        }
    }
}

/// All encounters of a motion, up to the first certain one.
#[derive(Debug, Clone, PartialEq)]
pub struct Encounters {
    /// Encounters in the order of their first times.
    pub list: Vec<Encounter>,
    /// Whether the list is complete: otherwise the search was stopped because it took too long.
    pub complete: bool,
}

impl<T: Enclosure> DrawnPair<T> {
    /// Times at which the features of the parts may touch along a motion up to a time, for all enclosed drawings: outside the encounters no
    /// two boundaries touch. The search ends where a contact is certain. If `among` is given, only its contacts are searched, within its
    /// times: they must be those of a larger set of drawings, in the order of their first times.
    pub fn encounters(&self, leg: &Leg<T>, until: f64, among: Option<&[Encounter]>) -> Encounters {
        let mut search = Search {
            pair: self,
            leg,
            until,
            end: until,
            narrowest: NARROWEST * until,
            found: Vec::new(),
            left: MOST,
        };
        if let Some(known) = among {
            for of in known {
                search.contact(of.contact, of.lo, of.hi.min(until));
            }
            search.merge();
        } else {
            let discs = self.discs();
            // The beginning comes first: a certain contact ends the search.
            let mut from = 0.0;
            for doublings in (0..=DOUBLINGS).rev() {
                let to = until * 0.5_f64.powi(doublings);
                for (i, fixed) in (0u32..).zip(&discs[0]) {
                    for (j, moving) in (0u32..).zip(&discs[1]) {
                        search.edges((i, fixed), (j, moving), from, to);
                    }
                }
                from = to;
            }
            search.merge();
        }
        let (mut list, end) = (search.found, search.end);
        list.retain(|e| e.lo <= end);
        list.sort_by(|a, b| a.lo.total_cmp(&b.lo).then(a.contact.cmp(&b.contact)));
        Encounters {
            list,
            complete: search.left > 0,
        }
    }
}

struct Search<'a, T> {
    pair: &'a DrawnPair<T>,
    leg: &'a Leg<T>,
    /// The end of the motion.
    until: f64,
    /// Time after which no contact is needed.
    end: f64,
    narrowest: f64,
    found: Vec<Encounter>,
    /// Remaining number of evaluations.
    left: usize,
}

impl<T: Enclosure> Search<'_, T> {
    /// Searches for contacts of two edges between two times.
    fn edges(&mut self, fixed: (u32, &Disc<T>), moving: (u32, &Disc<T>), lo: f64, hi: f64) {
        let hi = hi.min(self.end);
        if lo > hi || self.left == 0 {
            return;
        }
        self.left -= 1;
        let time = T::from_to(lo, hi);
        let apart = fixed
            .1
            .apart(moving.1, &self.pair.facing(self.leg.at(time)));
        if apart.is_certain() {
            return;
        }
        let mid = 0.5 * (lo + hi);
        if apart.is_vague() && self.can_halve(lo, mid, hi) {
            self.edges(fixed, moving, lo, mid);
            self.edges(fixed, moving, mid, hi);
            return;
        }
        for contact in self.pair.contacts(fixed.0, moving.0) {
            self.contact(contact, lo, hi);
        }
    }

    fn can_halve(&self, lo: f64, mid: f64, hi: f64) -> bool {
        hi - lo > self.narrowest && lo < mid && mid < hi
    }

    /// The contact function, and its derivative by time.
    fn function(&mut self, contact: DrawnContact, time: T) -> (T, T) {
        self.left = self.left.saturating_sub(1);
        let constant = |x: T| Dual {
            value: x,
            slope: [T::constant(0.0)],
        };
        let leg = Leg {
            from: self.leg.from.map(constant),
            rates: self.leg.rates.map(constant),
        };
        let at = leg.at(Dual::variable(time, 0));
        let gap: Dual<1, T> = self.pair.gap(contact, at, constant);
        (gap.value, gap.slope[0])
    }

    /// Whether the features, if they touch at a time, touch within their ends: 1 certainly, −1 never, otherwise 0.
    fn on_both(&self, contact: DrawnContact, time: T) -> i8 {
        let at = self.leg.at(time);
        let within = self.pair.within(contact, at);
        let signs = within.into_iter().flatten().map(|x| x.ball().sign());
        signs.min().unwrap_or(0)
    }

    /// Searches for a contact of two features between two times.
    fn contact(&mut self, contact: DrawnContact, lo: f64, hi: f64) {
        let hi = hi.min(self.end);
        if lo > hi || self.left == 0 {
            return;
        }
        if lo == 0.0 && self.pair.may_overlap_unseen(contact, self.leg.from) {
            self.found.push(Encounter::unknown(contact, 0.0));
        }
        let within = T::from_to(lo, hi);
        let (value, slope) = self.function(contact, within);
        let (value, slope) = (value.ball(), slope.ball());
        if value.sign() != 0 {
            return;
        }
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let at = self.function(contact, T::constant(mid)).0.ball();
        // By the mean value theorem, f is within |f′| · half of its value in the middle.
        let rise = (slope.mid.abs() + slope.radius) * half;
        if at.mid.abs() > (at.radius + rise) * (1.0 + 1e-9) || self.on_both(contact, within) < 0 {
            return;
        }
        match slope.sign() {
            -1 => self.alone(contact, lo, hi),
            // Features that part from each other overlapped before: the contact began elsewhere.
            1 => {}
            // Where the drawings differ by more than the times, halving the times is useless, unless features that slide along each other
            // come to touch within their ends.
            _ if self.can_halve(lo, mid, hi)
                && (value.radius > 2.0 * at.radius
                    || [lo, mid]
                        .iter()
                        .any(|t| self.on_both(contact, T::constant(*t)) < 0)) =>
            {
                self.contact(contact, lo, mid);
                self.contact(contact, mid, hi);
            }
            _ => self.found.push(Encounter {
                contact,
                lo,
                hi,
                approaching: false,
                certain: false,
            }),
        }
    }

    /// Joins consecutive intervals of time within which nothing is known of a contact.
    fn merge(&mut self) {
        self.found
            .sort_by(|a, b| a.contact.cmp(&b.contact).then(a.lo.total_cmp(&b.lo)));
        self.found.dedup_by(|next, last| {
            let follows = last.contact == next.contact && next.lo <= last.hi;
            let joins =
                follows && (last.approaching && next.approaching || !next.certain && !last.certain);
            if joins {
                last.hi = last.hi.max(next.hi);
                last.approaching &= next.approaching;
                last.certain |= next.certain;
            }
            joins
        });
    }

    /// Narrows down the times of the only possible contact, by Newton's method with enclosures: a root of f is within t − f(t) / f′ for
    /// every t, and every drawing has one if all of that enclosure lies within the times.
    fn alone(&mut self, contact: DrawnContact, mut lo: f64, mut hi: f64) {
        const STEPS: usize = 60;
        // An encounter that begins within these times may end after them.
        let later = (2.0 * hi).min(self.until);
        if self
            .function(contact, T::from_to(lo, later))
            .1
            .ball()
            .sign()
            < 0
        {
            hi = later;
        }
        let (mut exists, mut root) = (false, T::from_to(lo, hi));
        let sign_at = |search: &mut Self, t: f64| {
            let f = search.function(contact, T::constant(t)).0;
            f.ball().sign()
        };
        // Parts that do not overlap where the motion begins are apart there.
        let mut is_before = lo == 0.0 || sign_at(self, lo) > 0;
        let mut is_after = sign_at(self, hi) < 0;
        for _ in 0..STEPS {
            let mid = 0.5 * (lo + hi);
            let slope = self.function(contact, T::from_to(lo, hi)).1;
            let at = self.function(contact, T::constant(mid)).0;
            // This enclosure contains the dependence of the time on the drawing.
            let newton = T::constant(mid) - at / slope;
            let [from, to] = newton.ball().ends();
            if from.is_nan() || to.is_nan() {
                break;
            }
            if from > hi || to < lo {
                return;
            }
            exists |= from > lo && to < hi;
            root = newton;
            let width = hi - lo;
            (lo, hi) = (lo.max(from), hi.min(to));
            if self.left == 0 {
                break;
            }
            if hi - lo > 0.75 * width {
                // Where the derivative varies much, the sign in the middle decides more, if it is known.
                match at.ball().sign() {
                    1 => (lo, is_before) = (lo.max(mid), true),
                    -1 => (hi, is_after) = (hi.min(mid), true),
                    _ => break,
                }
            }
        }
        let on = self.on_both(contact, root);
        if on < 0 {
            return;
        }
        let certain = (exists || is_before && is_after) && on > 0;
        self.found.push(Encounter {
            contact,
            lo,
            hi,
            approaching: true,
            certain,
        });
        if certain {
            self.end = self.end.min(hi);
        }
    }
}
