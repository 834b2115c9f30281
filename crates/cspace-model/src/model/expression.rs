//! Expressions in place of numbers: `"pin + 2*gap"`, `"360deg/n"`.
//!
//! An expression is sums, products, powers and functions of numbers and names. It is parsed once and evaluated in numbers of any
//! kind, so that its derivatives are had by [`Dual`](cspace::Dual) numbers.

use core::f64::consts::{PI, TAU};

use cspace::Real;

use super::suggest::did_you_mean;
use crate::shown::quoted;

/// The longest expression, in characters.
const LONGEST: usize = 10_000;

/// The deepest nesting of parentheses, signs and powers: each takes some of the stack.
const DEEPEST: usize = 100;

/// Error in an expression, and its position in the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Wrong {
    /// Characters before it.
    pub(super) at: usize,
    pub(super) message: String,
    pub(super) help: String,
}

impl Wrong {
    fn new(at: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            at,
            message: message.into(),
            help: help.into(),
        }
    }
}

type Result<T> = core::result::Result<T, Wrong>;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Function {
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Hypot,
    Abs,
    Min,
    Max,
}

impl Function {
    const ALL: [(&'static str, Self); 12] = [
        ("sqrt", Self::Sqrt),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("asin", Self::Asin),
        ("acos", Self::Acos),
        ("atan", Self::Atan),
        ("atan2", Self::Atan2),
        ("hypot", Self::Hypot),
        ("abs", Self::Abs),
        ("min", Self::Min),
        ("max", Self::Max),
    ];

    /// The numbers of arguments that it takes.
    fn takes(self) -> core::ops::RangeInclusive<usize> {
        match self {
            Self::Atan2 | Self::Hypot => 2..=2,
            Self::Min | Self::Max => 1..=LONGEST,
            _ => 1..=1,
        }
    }
}

/// Names that stand for numbers. A unit behind a number multiplies it.
const CONSTANTS: [(&str, f64); 5] = [
    ("pi", PI),
    ("deg", PI / 180.0),
    ("°", PI / 180.0),
    ("rad", 1.0),
    ("turn", TAU),
];

/// The names of all constants and functions.
pub(super) fn taken_names() -> impl Iterator<Item = &'static str> {
    let constants = CONSTANTS.iter().map(|c| c.0);
    Function::ALL.iter().map(|f| f.0).chain(constants)
}

/// Whether a name is that of a function or a constant.
pub(super) fn is_taken(name: &str) -> bool {
    taken_names().any(|taken| taken == name)
}

/// Whether a name can be written in an expression: letters, digits and underscores, no digit first.
pub(super) fn is_name(name: &str) -> bool {
    name.starts_with(begins_name) && name.chars().all(continues_name)
}

fn begins_name(c: char) -> bool {
    c.is_alphabetic() || c == '_' || c == '°'
}

fn continues_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn constant(name: &str) -> Option<f64> {
    CONSTANTS.iter().find(|c| c.0 == name).map(|c| c.1)
}

fn function(name: &str) -> Option<Function> {
    Function::ALL.iter().find(|f| f.0 == name).map(|f| f.1)
}

/// Powers of enclosures up to this exponent are products.
const MOST_FACTORS: f64 = 16.0;

/// A step of the evaluation: operands are on a stack.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    Number(f64),
    /// The value of a parameter, by its number.
    Name(u32),
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Call(Function, u32),
}

/// An expression that was parsed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Expression {
    /// Steps in the order of evaluation, each with its position in the text.
    steps: Box<[(Step, u32)]>,
}

impl Expression {
    /// The expression in a text; `number` gives the number of a parameter, and `names` all of their names for suggestions.
    pub(super) fn parse<'n, N: Iterator<Item = &'n str>>(
        text: &str,
        number: impl Fn(&str) -> Option<u32>,
        names: impl Fn() -> N,
    ) -> Result<Self> {
        let chars: Vec<char> = text.chars().take(LONGEST + 1).collect();
        if chars.len() > LONGEST {
            return Err(Wrong::new(
                0,
                format!("the expression has more than {LONGEST} characters"),
                "give parts of it as parameters of their own",
            ));
        }
        let unknown = |name: &str| {
            let known = names().chain(taken_names().map(|name| -> &'n str { name }));
            did_you_mean(name, known, || {
                "add it to [parameter], or write a number".to_owned()
            })
        };
        let mut parser = Parser {
            chars: &chars,
            at: 0,
            depth: 0,
            steps: Vec::new(),
            number: &number,
            unknown: &unknown,
        };
        parser.sum()?;
        parser.skip();
        if let Some(&c) = parser.chars.get(parser.at) {
            let help = match c {
                ')' => "remove it, or add the parenthesis that it closes",
                ',' => {
                    "write a decimal point, as in 2.5; commas are between the arguments of a function"
                }
                _ => "write an operator between two values: + - * / or ^",
            };
            let message = format!("{} is not expected here", quoted(&c.to_string()));
            return Err(Wrong::new(parser.at, message, help));
        }
        Ok(Self {
            steps: parser.steps.into_boxed_slice(),
        })
    }

    /// The parameters that it names, by their numbers, some of them more than once.
    pub(super) fn names(&self) -> impl Iterator<Item = u32> + '_ {
        self.steps.iter().filter_map(|step| match step.0 {
            Step::Name(number) => Some(number),
            _ => None,
        })
    }

    /// Value for given values of all parameters.
    pub(super) fn evaluate<T: Real>(&self, values: &[T]) -> Result<T> {
        let mut stack: Vec<T> = Vec::new();
        for &(step, at) in &self.steps {
            let at = at as usize;
            let mut pop = || stack.pop().unwrap_or(T::constant(f64::NAN));
            let value = match step {
                Step::Number(x) => T::constant(x),
                Step::Name(i) => values[i as usize],
                Step::Negate => -pop(),
                Step::Call(function, count) => {
                    let from = stack.len().saturating_sub(count as usize);
                    let value = call(function, &stack[from..], at)?;
                    stack.truncate(from);
                    value
                }
                _ => {
                    let (b, a) = (pop(), pop());
                    match step {
                        Step::Add => a + b,
                        Step::Subtract => a - b,
                        Step::Multiply => a * b,
                        Step::Power => power(a, b),
                        _ if b.value() == 0.0 => {
                            let help = "check the values of the parameters in the divisor";
                            return Err(Wrong::new(at, "a division by zero", help));
                        }
                        _ => a / b,
                    }
                }
            };
            if !value.value().is_finite() {
                return Err(Wrong::new(
                    at,
                    "the value is no finite number",
                    "check the values of the parameters here: it is too large, or undefined",
                ));
            }
            stack.push(value);
        }
        Ok(stack.pop().unwrap_or(T::constant(f64::NAN)))
    }
}

/// aᵇ, with (∂/∂a, ∂/∂b) = (b aᵇ⁻¹, aᵇ ln a).
fn power<T: Real>(a: T, b: T) -> T {
    let (x, y) = (a.value(), b.value());
    if a.spread() > 0.0
        && b.spread() == 0.0
        && (1.0..=MOST_FACTORS).contains(&y)
        && y.fract() == 0.0
    {
        // Powers of an enclosure are multiplied factor by factor.
        return (1..y as u32).fold(a, |product, _| product * a);
    }
    let value = x.powf(y);
    let finite = |slope: f64| if slope.is_finite() { slope } else { 0.0 };
    let by_exponent = if x > 0.0 { finite(value * x.ln()) } else { 0.0 };
    let of_base = a.function(value, finite(y * x.powf(y - 1.0)));
    of_base + b.function(0.0, by_exponent)
}

fn call<T: Real>(function: Function, arguments: &[T], at: usize) -> Result<T> {
    let [x, ..] = arguments else {
        return Ok(T::constant(f64::NAN));
    };
    let (x, v) = (*x, x.value());
    let undefined = |of: &str, domain: &str| {
        let message = format!("the {of} of {v} is undefined");
        Err(Wrong::new(at, message, format!("its argument is {domain}")))
    };
    Ok(match function {
        Function::Sqrt if v < 0.0 => return undefined("square root", "not negative"),
        Function::Sqrt => x.sqrt(),
        Function::Sin => x.sin_cos().0,
        Function::Cos => x.sin_cos().1,
        Function::Tan => {
            let (sin, cos) = x.sin_cos();
            sin / cos
        }
        Function::Asin | Function::Acos if v.abs() > 1.0 => {
            return undefined("arc sine or cosine", "between -1 and 1");
        }
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Atan2 => x.atan2(arguments[1]),
        Function::Hypot => x.hypot(arguments[1]),
        Function::Abs => x.abs(),
        Function::Min | Function::Max => {
            let is_better = |a: &T, b: &T| (a.value() < b.value()) == (function == Function::Min);
            let better = |best: T, a: &T| {
                let better = if is_better(a, &best) { *a } else { best };
                let apart = (a.value() - best.value()).abs();
                if apart < a.spread() + best.spread() {
                    better.unknown()
                } else {
                    better
                }
            };
            arguments[1..].iter().fold(x, better)
        }
    })
}

/// Reads characters one after the other, and writes steps.
struct Parser<'a> {
    chars: &'a [char],
    at: usize,
    depth: usize,
    steps: Vec<(Step, u32)>,
    number: &'a dyn Fn(&str) -> Option<u32>,
    /// Advice about a name that there is not.
    unknown: &'a dyn Fn(&str) -> String,
}

impl Parser<'_> {
    fn skip(&mut self) {
        while self.chars.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
    }

    /// The next character if it is one of some, and where it is.
    fn take(&mut self, some: &[char]) -> Option<(char, usize)> {
        self.skip();
        let c = *self.chars.get(self.at)?;
        some.contains(&c).then(|| {
            self.at += 1;
            (c, self.at - 1)
        })
    }

    fn push(&mut self, step: Step, at: usize) {
        self.steps.push((step, at as u32));
    }

    fn sum(&mut self) -> Result<()> {
        self.product()?;
        while let Some((c, at)) = self.take(&['+', '-']) {
            self.product()?;
            let step = if c == '+' { Step::Add } else { Step::Subtract };
            self.push(step, at);
        }
        Ok(())
    }

    fn product(&mut self) -> Result<()> {
        self.signed()?;
        while let Some((c, at)) = self.take(&['*', '/']) {
            self.signed()?;
            let step = if c == '*' {
                Step::Multiply
            } else {
                Step::Divide
            };
            self.push(step, at);
        }
        Ok(())
    }

    /// A power with a sign, if it has one: −a² is −(a²).
    fn signed(&mut self) -> Result<()> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Wrong::new(
                self.at,
                format!("the expression is nested more than {DEEPEST} deep"),
                "give parts of it as parameters of their own",
            ));
        }
        match self.take(&['+', '-']) {
            Some((c, at)) => {
                self.signed()?;
                if c == '-' {
                    self.push(Step::Negate, at);
                }
            }
            None => {
                self.value()?;
                if let Some((_, at)) = self.take(&['^']) {
                    self.signed()?;
                    self.push(Step::Power, at);
                }
            }
        }
        self.depth -= 1;
        Ok(())
    }

    fn value(&mut self) -> Result<()> {
        self.skip();
        let at = self.at;
        match self.chars.get(at) {
            None => Err(Wrong::new(
                at,
                "the expression ends where a value is expected",
                "add a number, a parameter or a function",
            )),
            Some('(') => {
                self.at += 1;
                self.sum()?;
                self.close(at)
            }
            Some(c) if c.is_ascii_digit() || *c == '.' => self.literal(),
            Some(&c) if begins_name(c) => {
                let name = self.name();
                self.named(&name, at)
            }
            Some(c) => Err(Wrong::new(
                at,
                format!(
                    "{} stands where a value is expected",
                    quoted(&c.to_string())
                ),
                "write a number, a parameter or a function",
            )),
        }
    }

    /// Reads a name, of which the first character is known.
    fn name(&mut self) -> String {
        let from = self.at;
        self.at += 1;
        while self.chars.get(self.at).is_some_and(|c| continues_name(*c)) {
            self.at += 1;
        }
        self.chars[from..self.at].iter().collect()
    }

    fn close(&mut self, opened: usize) -> Result<()> {
        match self.take(&[')']) {
            Some(_) => Ok(()),
            None if self.at < self.chars.len() => {
                let message = format!(
                    "{} stands where ) or an operator is expected",
                    quoted(&self.chars[self.at].to_string())
                );
                let help = "write an operator between two values: + - * / or ^";
                Err(Wrong::new(self.at, message, help))
            }
            None => Err(Wrong::new(
                opened,
                "the parenthesis is not closed",
                "add a ) where its part ends",
            )),
        }
    }

    /// A number, and the unit behind it.
    fn literal(&mut self) -> Result<()> {
        let from = self.at;
        let is =
            |this: &Self, at: usize, some: fn(&char) -> bool| this.chars.get(at).is_some_and(some);
        let digits = |this: &mut Self| {
            while is(this, this.at, |c| c.is_ascii_digit() || *c == '_') {
                this.at += 1;
            }
        };
        digits(self);
        if is(self, self.at, |c| *c == '.') {
            self.at += 1;
            digits(self);
        }
        if is(self, self.at, |c| matches!(c, 'e' | 'E')) {
            let sign = usize::from(is(self, self.at + 1, |c| matches!(c, '+' | '-')));
            if is(self, self.at + 1 + sign, char::is_ascii_digit) {
                self.at += 1 + sign;
                digits(self);
            }
        }
        let text: String = self.chars[from..self.at]
            .iter()
            .filter(|c| **c != '_')
            .collect();
        let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
        let Some(number) = number else {
            let message = format!("{} is no finite number", quoted(&text));
            return Err(Wrong::new(from, message, "write it as 2.5 or 1e-3"));
        };
        self.push(Step::Number(number), from);
        self.skip();
        let at = self.at;
        if self.chars.get(at).copied().is_some_and(begins_name) {
            let name = self.name();
            let unit = constant(&name).filter(|_| name != "pi");
            let Some(unit) = unit else {
                let message = format!("an operator is missing before {}", quoted(&name));
                let help = format!("write {text}*{name}; units are deg, rad and turn");
                return Err(Wrong::new(at, message, help));
            };
            self.push(Step::Number(unit), at);
            self.push(Step::Multiply, at);
        }
        Ok(())
    }

    /// Resolves a name: a parameter's number, or a constant.
    fn named(&mut self, name: &str, at: usize) -> Result<()> {
        if let Some(number) = (self.number)(name) {
            self.push(Step::Name(number), at);
            return Ok(());
        }
        if let Some(value) = constant(name) {
            self.push(Step::Number(value), at);
            return Ok(());
        }
        let Some(function) = function(name) else {
            let message = format!("there is no parameter {}", quoted(name));
            return Err(Wrong::new(at, message, (self.unknown)(name)));
        };
        let Some((_, opened)) = self.take(&['(']) else {
            let message = format!("{name} is a function, and has no arguments here");
            return Err(Wrong::new(at, message, format!("write {name}(...)")));
        };
        let mut count = 0;
        loop {
            self.sum()?;
            count += 1;
            if self.take(&[',']).is_none() {
                break;
            }
        }
        self.close(opened)?;
        if !function.takes().contains(&count) {
            let takes = function.takes().start().to_owned();
            let message = format!("{name} takes {takes} arguments, not {count}");
            let help = format!("give {name} what it takes, with commas between");
            return Err(Wrong::new(at, message, help));
        }
        self.push(Step::Call(function, count as u32), at);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Expression, Wrong};
    use core::f64::consts::{FRAC_PI_2, PI};
    use cspace::Dual;

    const NAMES: [&str; 3] = ["a", "b", "gap_2"];

    fn parse(text: &str) -> Result<Expression, Wrong> {
        let number = |name: &str| (0u32..).zip(NAMES).find(|n| n.1 == name).map(|n| n.0);
        Expression::parse(text, number, || NAMES.into_iter())
    }

    fn value(text: &str) -> Result<f64, Wrong> {
        parse(text)?.evaluate(&[2.0, 3.0, 0.25])
    }

    #[test]
    fn values_follow_the_rules_of_precedence() {
        for (text, expected) in [
            ("1", 1.0),
            (" -1.5e-2 ", -0.015),
            ("a + 2*gap_2", 2.5),
            ("a - b - 1", -2.0),
            ("a / b / 4", 1.0 / 6.0),
            ("-a^2", -4.0),
            ("2^-1", 0.5),
            ("2^b^2", 512.0),
            ("(a + b)*(a - b)", -5.0),
            ("360deg/b", 120f64.to_radians()),
            ("18 deg", 18f64.to_radians()),
            ("18°", 18f64.to_radians()),
            ("0.25turn", FRAC_PI_2),
            ("pi/2", FRAC_PI_2),
            ("sqrt(a^2 + b^2) - hypot(a, b)", 0.0),
            ("sin(30deg)", 0.5),
            ("cos(60deg)", 0.5),
            ("tan(45deg)", 1.0),
            ("asin(1) + acos(1)", FRAC_PI_2),
            ("4*atan(1)", PI),
            ("atan2(a, -a)", 0.75 * PI),
            ("abs(-a)", 2.0),
            ("min(a, b, 1) + max(a, b)", 4.0),
            ("1_000 + .5 + 2.", 1002.5),
        ] {
            let found = value(text).unwrap();
            assert!(
                (found - expected).abs() < 1e-15 * (1.0 + expected.abs()),
                "{text}: {found}"
            );
        }
    }

    #[test]
    fn what_is_wrong_is_named_with_its_place() {
        for (text, at, message, help) in [
            ("", 0, "ends where a value", "add a number"),
            ("a +", 3, "ends where a value", "add a number"),
            ("a b", 2, "\"b\" is not expected", "an operator"),
            ("2 a", 2, "operator is missing before \"a\"", "2*a"),
            ("2,5", 1, "\",\" is not expected", "decimal point"),
            ("(a", 0, "not closed", "add a )"),
            ("a)", 1, "\")\" is not expected", "remove it"),
            ("gap2", 0, "no parameter \"gap2\"", "did you mean `gap_2`?"),
            ("sqr(a)", 0, "no parameter \"sqr\"", "did you mean `sqrt`?"),
            (
                "width",
                0,
                "no parameter \"width\"",
                "add it to [parameter]",
            ),
            ("sqrt a", 0, "is a function", "sqrt(...)"),
            ("hypot(a)", 0, "takes 2 arguments, not 1", "commas"),
            ("1/(a - 2)", 1, "division by zero", "divisor"),
            ("a*sqrt(-a)", 2, "square root of -2", "not negative"),
            ("acos(b)", 0, "of 3 is undefined", "between -1 and 1"),
            ("1e308*10", 5, "no finite number", "too large"),
            ("1e999", 0, "no finite number", "2.5"),
            ("a $ b", 2, "\"$\" is not expected", "operator"),
        ] {
            let wrong = value(text).unwrap_err();
            assert_eq!(wrong.at, at, "{text}: {wrong:?}");
            assert!(wrong.message.contains(message), "{text}: {wrong:?}");
            assert!(wrong.help.contains(help), "{text}: {wrong:?}");
        }
    }

    #[test]
    fn hostile_texts_are_refused() {
        let deep =
            |n: usize, open: &str, close: &str| format!("{}1{}", open.repeat(n), close.repeat(n));
        assert!(value(&deep(90, "(", ")")).is_ok());
        for text in [
            deep(101, "(", ")"),
            deep(1_000_000, "(", ")"),
            deep(4_000, "(", ")"),
            deep(9_000, "-", ""),
            deep(1_000, "2^", ""),
            "1+".repeat(1_000_000),
        ] {
            let wrong = value(&text).unwrap_err();
            assert!(wrong.message.contains("more than"), "{wrong:?}");
        }
        assert!(value(&format!("1{}", "+1".repeat(4_000))).is_ok());
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        for text in [
            "a*b/gap_2 - b",
            "a^b + b^a + gap_2^2",
            "sqrt(a)*sin(b)*cos(gap_2) + tan(a)",
            "asin(gap_2) + acos(gap_2/a) + atan(a*b)",
            "atan2(a, b)*hypot(a, gap_2)",
            "abs(-a) + min(a, b) + max(gap_2, b)",
        ] {
            let expression = parse(text).unwrap();
            let at = [2.0, 3.0, 0.25];
            let variables = [0, 1, 2].map(|i: usize| Dual::<3>::variable(at[i], i));
            let exact = expression.evaluate(&variables).unwrap();
            for i in 0..3 {
                let h = 1e-5;
                let beside = |h: f64| {
                    let mut x = at;
                    x[i] += h;
                    expression.evaluate(&x).unwrap()
                };
                let difference = (beside(h) - beside(-h)) / (2.0 * h);
                let error = (difference - exact.slope[i]).abs();
                assert!(
                    error < 1e-8 * (1.0 + difference.abs()),
                    "{text} by {}: {error}",
                    NAMES[i]
                );
            }
        }
    }
}
