//! Enclosures: every result of members is a member of the result.

use cspace::fuzzing::{
    Enclosure, Operation, enclose, enclose_cos_sin, enclose_interval, enclose_jet, sign,
};

use crate::Finding;
use crate::draw::Bytes;
use crate::exact::{ANGLE_ERROR, Dyadic, cos_sin};

const OPERATIONS: [Operation; 5] = [
    Operation::Add,
    Operation::Sub,
    Operation::Mul,
    Operation::Over,
    Operation::Root,
];

/// The largest power of ten of a number: squares stay finite.
const LARGEST: usize = 140;

/// A number of any size.
fn number(bytes: &mut Bytes<'_>) -> f64 {
    let x = bytes.unit();
    match bytes.below(4) {
        0 => {
            let power = bytes.below(2 * LARGEST + 1) as i32 - LARGEST as i32;
            x * 10f64.powi(power)
        }
        // Numbers too small to be rounded to full precision.
        1 => match bytes.below(8) {
            0 => x * 1e-300 * 1e-15,
            _ => x,
        },
        _ => x,
    }
}

fn ball(bytes: &mut Bytes<'_>) -> Enclosure {
    if bytes.below(16) == 0 {
        let unknown = f64::INFINITY;
        return bytes.one_of(&[(0.0, unknown), (unknown, unknown), (f64::NAN, f64::NAN)]);
    }
    let mid = number(bytes);
    let radius = match bytes.below(4) {
        0 => 0.0,
        1 => mid.abs() * bytes.one_of(&[1.0, 1.0 - f64::EPSILON, f64::EPSILON, 0.5]),
        2 => number(bytes).abs(),
        _ => mid.abs() * 1e-10,
    };
    if bytes.below(8) == 0 {
        return enclose_interval(mid - radius, mid + radius);
    }
    (mid, radius)
}

/// Whether every real is a member, as after a quotient by zero, or where numbers became too large. Such a ball has no
/// sign.
fn is_everything((mid, radius): Enclosure) -> bool {
    !mid.is_finite() || !radius.is_finite()
}

/// A member: an end, the middle, or one between.
fn member((mid, radius): Enclosure, bytes: &mut Bytes<'_>) -> Dyadic {
    if is_everything((mid, radius)) {
        return Dyadic::of(number(bytes));
    }
    let k = bytes.one_of(&[8.0, -8.0, 0.0, 1.0, -7.0]);
    &Dyadic::of(mid) + &(&Dyadic::of(radius) * &Dyadic::of(0.125 * k))
}

/// A fraction, exactly; its denominator is not 0.
#[derive(Clone)]
struct Fraction {
    over: Dyadic,
    under: Dyadic,
}

impl Fraction {
    fn whole(over: Dyadic) -> Self {
        Self {
            over,
            under: Dyadic::of(1.0),
        }
    }

    /// Whether the fraction is certainly not in the ball: |n − d mid| > |d| radius.
    fn is_outside(&self, (mid, radius): Enclosure) -> bool {
        if is_everything((mid, radius)) {
            return false;
        }
        let off = (&self.over - &(&self.under * &Dyadic::of(mid))).abs();
        off > &self.under.abs() * &Dyadic::of(radius)
    }
}

/// Whether √x is certainly not in the ball: it is below or above all members.
fn root_is_outside(x: &Dyadic, (mid, radius): Enclosure) -> bool {
    if is_everything((mid, radius)) {
        return false;
    }
    let (mid, radius) = (Dyadic::of(mid), Dyadic::of(radius));
    let (lo, hi) = (&mid - &radius, &mid + &radius);
    hi.sign() < 0 || hi.square() < *x || (lo.sign() > 0 && lo.square() > *x)
}

fn wrong(operation: impl core::fmt::Debug, a: impl core::fmt::Debug, result: Enclosure) -> Finding {
    Finding::new(format!(
        "{operation:?} of {a:?} has results that are not in {result:?}"
    ))
}

/// Exact result of an operation on members of two balls.
fn exactly(operation: Operation, x: &Dyadic, y: &Dyadic) -> Option<Fraction> {
    Some(match operation {
        Operation::Add => Fraction::whole(x + y),
        Operation::Sub => Fraction::whole(x - y),
        Operation::Mul => Fraction::whole(x * y),
        Operation::Over if y.sign() != 0 => Fraction {
            over: x.clone(),
            under: y.clone(),
        },
        _ => return None,
    })
}

pub(super) fn run(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    if bytes.below(6) == 0 {
        return angles(bytes);
    }
    let operation = bytes.one_of(&OPERATIONS);
    let (a, b) = (ball(bytes), ball(bytes));
    let result = enclose(operation, a, b);
    for _ in 0..4 {
        let (x, y) = (member(a, bytes), member(b, bytes));
        let outside = if operation == Operation::Root {
            x.sign() >= 0 && root_is_outside(&x, result)
        } else {
            exactly(operation, &x, &y).is_some_and(|z| z.is_outside(result))
        };
        if outside {
            return Err(wrong(operation, (a, b, x.near(), y.near()), result));
        }
        if sign(a) != 0 && x.sign() != sign(a) {
            return Err(Finding::new(format!(
                "the sign of {a:?} is said to be {}",
                sign(a)
            )));
        }
    }
    Ok(4)
}

/// Cosines and sines of all angles of a ball.
fn angles(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let mid = bytes.orientation() * bytes.one_of(&[1.0, 1.0, 2.0, 0.5]);
    let radius = bytes.one_of(&[0.0, 1e-16, 1e-9, 1e-3, 0.5, 2.0, 7.0]);
    let results = enclose_cos_sin((mid, radius));
    let slack = Dyadic::of(1.0).shifted(ANGLE_ERROR);
    for k in [-1.0, -0.5, 0.0, 0.25, 1.0] {
        // A double that is a member.
        let x = mid + k * radius * (1.0 - f64::EPSILON);
        if (&Dyadic::of(x) - &Dyadic::of(mid)).abs() > Dyadic::of(radius) {
            continue;
        }
        let (cos, sin) = cos_sin(x);
        for (result, value) in results.into_iter().zip([cos, sin]) {
            let off = (&value - &Dyadic::of(result.0)).abs();
            if off > &Dyadic::of(result.1) + &slack {
                return Err(wrong("cosine and sine", (mid, radius, x), result));
            }
        }
    }
    Ok(10)
}

/// As above, for values with derivatives: sums, the rules of product and quotient, and (√f)′ = f′ / (2 √f).
pub(super) fn run_jet(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let operation = bytes.one_of(&OPERATIONS);
    let (a, b) = ([ball(bytes), ball(bytes)], [ball(bytes), ball(bytes)]);
    let result = enclose_jet(operation, a, b);
    for _ in 0..4 {
        let [x, dx] = a.map(|e| member(e, bytes));
        let [y, dy] = b.map(|e| member(e, bytes));
        let slope = match operation {
            Operation::Add => Fraction::whole(&dx + &dy),
            Operation::Sub => Fraction::whole(&dx - &dy),
            Operation::Mul => Fraction::whole(&(&dx * &y) + &(&x * &dy)),
            Operation::Over if y.sign() != 0 => Fraction {
                over: &(&dx * &y) - &(&x * &dy),
                under: y.square(),
            },
            Operation::Root if x.sign() > 0 => {
                if root_slope_is_outside(&x, &dx, result[1]) {
                    return Err(wrong("Root′", (a, x.near(), dx.near()), result[1]));
                }
                continue;
            }
            _ => continue,
        };
        if slope.is_outside(result[1]) {
            let members = (x.near(), dx.near(), y.near(), dy.near());
            return Err(wrong((operation, "′"), (a, b, members), result[1]));
        }
        let value = exactly(operation, &x, &y);
        if value.is_some_and(|z| z.is_outside(result[0])) {
            return Err(wrong(operation, (a, b), result[0]));
        }
    }
    Ok(4)
}

/// Whether dx / (2 √x) is certainly not in the ball: its square times 4 x is compared with dx², signs aside.
fn root_slope_is_outside(x: &Dyadic, dx: &Dyadic, (mid, radius): Enclosure) -> bool {
    if is_everything((mid, radius)) {
        return false;
    }
    let (mid, radius) = (Dyadic::of(mid), Dyadic::of(radius));
    let signed = |z: &Dyadic| {
        // The sign and square of 2 z √x.
        let square = &z.square().shifted(2) * x;
        if z.sign() < 0 { -&square } else { square }
    };
    let wanted = if dx.sign() < 0 {
        -&dx.square()
    } else {
        dx.square()
    };
    signed(&(&mid - &radius)) > wanted || signed(&(&mid + &radius)) < wanted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_that_are_not_enclosed_are_seen() {
        // 1/3 is between two doubles: the nearest alone does not enclose it.
        let third = Fraction {
            over: Dyadic::of(1.0),
            under: Dyadic::of(3.0),
        };
        assert!(third.is_outside((1.0 / 3.0, 0.0)));
        assert!(!third.is_outside((1.0 / 3.0, f64::EPSILON)));
        let two = Dyadic::of(2.0);
        assert!(root_is_outside(&two, (2f64.sqrt(), 0.0)));
        assert!(!root_is_outside(&two, (2f64.sqrt(), 1e-15)));
        // (√2)′ = 1 / (2 √2) for a slope of 1.
        let slope = 0.5 / 2f64.sqrt();
        let one = Dyadic::of(1.0);
        assert!(root_slope_is_outside(&two, &one, (slope, 0.0)));
        assert!(!root_slope_is_outside(&two, &one, (slope, 1e-15)));
        assert!(root_slope_is_outside(&two, &one, (-slope, 1e-15)));
    }
}
