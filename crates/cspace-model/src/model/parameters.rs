//! Parameters of a model: their values, in the order in which they depend on each other, and their tolerances.

use cspace::{Ball, Dual, Real};
use cspace_drawing::Unit;

use super::error::ModelError;
use super::expression::{Expression, Wrong, is_name, is_taken};
use super::node::Node;
use super::place::Place;
use super::scope::{Entry, Result, Scope, Varied, in_text};
use super::suggest::did_you_mean;
use super::table::Table;
use super::tolerance::{Distribution, Nominal, PARAMETER, Position, Tolerance};
use super::value::Value;
use crate::angle::parse_angle;
use crate::shown::quoted;

/// The most parameters of a model.
const MOST: usize = 10_000;

/// A number of a model that has a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Name in expressions.
    pub name: String,
    /// Value; in radians if it is an angle.
    pub value: f64,
    /// Expression of the value, if it is written as one.
    pub expression: Option<String>,
    /// Whether the value is written as an angle, with a unit.
    pub is_angle: bool,
    /// Whether the value was set for this reading and differs from the file.
    pub is_set: bool,
    /// Largest deviations below and above the value, if the model gives them; one of them is below 0 if the value is outside its limits.
    pub deviations: Option<(f64, f64)>,
    /// Whether the limits are given themselves, and stay as they are whatever the value is set to.
    pub has_limits: bool,
    /// Distribution of the value within its tolerance, if the model gives one.
    pub distribution: Option<Distribution>,
    /// Position tolerance of the point of which it is a coordinate, if it has one.
    pub position: Option<Position>,
    /// The entries of the model in which numbers depend on it, such as `part "pin"`, and keys of the model itself.
    pub used_by: Vec<String>,
}

impl Parameter {
    /// Setting of the value plus a deviation; its expression is kept as a term.
    pub fn deviated(&self, by: f64) -> Setting {
        match &self.expression {
            Some(expression) => Setting {
                name: self.name.clone(),
                value: format!("({expression}) + ({by:?})"),
            },
            None => Setting::number(&self.name, self.value + by),
        }
    }
}

/// Settings of the middles of limits, of parameters whose values are outside of them, as the nominal size of a shaft is for most fits:
/// tolerances are about the middle then. A value that is set beside limits of its own stays.
pub(super) fn middles_of_limits(parameters: &[Parameter]) -> Vec<(usize, Setting)> {
    let middle = |(i, p): (usize, &Parameter)| {
        let (below, above) = p.deviations.filter(|_| !(p.is_set && p.has_limits))?;
        (below < 0.0 || above < 0.0).then(|| (i, p.deviated(0.5 * (above - below))))
    };
    parameters.iter().enumerate().filter_map(middle).collect()
}

/// A value for a parameter in place of the file's: its name, and a number or an expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// The name of the parameter.
    pub name: String,
    /// A number, an angle such as `18deg`, or an expression of other parameters.
    pub value: String,
}

impl Setting {
    /// A number, all digits of it.
    pub fn number(name: impl Into<String>, value: f64) -> Self {
        Self {
            name: name.into(),
            value: format!("{value:?}"),
        }
    }
}

/// The parameter by which a model is differentiated, and the ranges over which it is enclosed.
pub(super) struct Variation<'a> {
    pub(super) parameter: &'a str,
    /// Names of parameters, with how far the value of each may be off, from and to; others have their values.
    pub(super) ranges: &'a [(String, f64, f64)],
}

impl Variation<'_> {
    fn range(&self, name: &str) -> Option<Ball> {
        let known = self.ranges.iter().find(|r| r.0 == name)?;
        Some(Ball::between(known.1, known.2))
    }

    /// A parameter by its name and value, and whether it varies.
    fn of(&self, name: &str, value: f64) -> (Varied, bool) {
        let range = self.range(name);
        let is_varied = self.parameter == name;
        let value = Ball::constant(value) + range.unwrap_or(Ball::constant(0.0));
        let slope = [Ball::constant(f64::from(is_varied))];
        (Dual { value, slope }, is_varied || range.is_some())
    }
}

/// Parameters of a model, with their values.
#[derive(Default)]
pub(super) struct Parameters {
    all: Vec<Parameter>,
    /// For each parameter those that its value depends on directly.
    needs: Vec<Vec<u32>>,
    /// The values, for the numbers of the model.
    pub(super) scope: Scope,
}

/// A parameter as it is written, before it has a value.
struct Written<'a> {
    place: Place,
    value: Given<'a>,
    /// The value in place of the file's, if there is one.
    setting: Option<&'a Setting>,
    /// Whether the file has a text, whatever the value is set to.
    is_text: bool,
    tolerance: Option<(Table<'a>, Tolerance)>,
}

/// Source of a parameter's value.
enum Given<'a> {
    Value(f64),
    Text(&'a str, Expression),
}

impl Parameters {
    /// The parameters in the value of the key `parameter`, with the values that are set instead of the file's; with a variation,
    /// everything is also enclosed over its ranges and differentiated by its parameter.
    pub(super) fn read(
        node: Option<&Node>,
        place: &Place,
        set: &[Setting],
        variation: Option<&Variation<'_>>,
        unit: Option<Unit>,
    ) -> Result<Self> {
        let mut this = Self::default();
        let Some(node) = node else {
            return match set.first() {
                None => Ok(this),
                Some(setting) => Err(ModelError::of_file(format!(
                    "{} is set, and the model has no parameters",
                    quoted(&setting.name)
                ))
                .with_help("add it under [parameter], and use it in place of a number")),
            };
        };
        let Node::Table(entries) = node else {
            let found = node.describe();
            let message = format!("{found} where a table of parameters is expected");
            return Err(ModelError::new(place, message)
                .with_help("give parameters as [parameter] with lines such as pin = 6.0"));
        };
        if entries.len() > MOST {
            let message = format!("{} parameters, more than {MOST}", entries.len());
            return Err(
                ModelError::new(place, message).with_help("split the model into several files")
            );
        }
        for (i, name) in (0u32..).zip(entries.keys()) {
            can_be_named(name).map_err(|(message, help)| {
                let key = place.key(name).itself();
                let key = key.called(format!("parameter {}", quoted(name)));
                ModelError::new(&key, message).with_help(help)
            })?;
            this.scope.numbers.insert(name.clone(), i);
        }
        if let Some(setting) = set.iter().find(|s| !entries.contains_key(&s.name)) {
            let name = quoted(&setting.name);
            let message = format!("there is no parameter {name}, which is set");
            let names = entries.keys().map(String::as_str);
            let all = || format!("the parameters are {}", listed(entries.keys()));
            let help = did_you_mean(&setting.name, names, all);
            return Err(ModelError::new(place, message).with_help(help));
        }
        this.scope.uses.get_mut().resize(entries.len(), Vec::new());
        let literal = Scope::literal();
        let mut written = Vec::with_capacity(entries.len());
        for (name, node) in entries.iter() {
            let value = Value {
                node,
                place: (place.key(name)).called(format!("parameter {}", quoted(name))),
                scope: &literal,
            };
            let setting = set.iter().rev().find(|s| s.name == *name);
            written.push(this.add(name, value, setting)?);
        }
        this.evaluate(&written, variation)?;
        for (i, written) in written.iter().enumerate() {
            if let Some((table, tolerance)) = &written.tolerance {
                this.tolerate(i, table, tolerance, written.is_text, unit)?;
            }
        }
        Ok(this)
    }

    /// Adds a parameter, which has no value yet.
    fn add<'a>(
        &mut self,
        name: &str,
        value: Value<'a>,
        setting: Option<&'a Setting>,
    ) -> Result<Written<'a>> {
        let (value, tolerance) = match value.node {
            Node::Table(_) => {
                let table = Table::new(value, &PARAMETER)?;
                let value = table.needed("value", table.get("value"))?;
                let tolerance = Tolerance::read(&table)?;
                (value, Some((table, tolerance)))
            }
            _ => (value, None),
        };
        let number = value.number::<f64>()?.filter(|x| x.is_finite());
        let text = value.node.text();
        if text.is_none() && number.is_none() {
            let found = value.node.describe();
            let message = format!("{found} where a number or an expression is expected");
            let help = "give it as pin = 6.0, pin = \"2*gap\" or pin = { value = 6.0, tol = 0.02 }";
            return Err(value.error(message).with_help(help));
        }
        let given = match (setting.map(|s| s.value.as_str()).or(text), number) {
            (Some(text), _) => {
                let parsed = self.scope.parse(text);
                let parsed = parsed.map_err(|w| in_given(&value.place, text, &w, setting))?;
                Given::Text(text, parsed)
            }
            (None, number) => Given::Value(number.unwrap_or(f64::NAN)),
        };
        let needs: Vec<u32> = match &given {
            Given::Text(_, expression) => expression.names().collect(),
            Given::Value(_) => Vec::new(),
        };
        let is_expression = setting.is_none() && !needs.is_empty();
        self.all.push(Parameter {
            name: name.to_owned(),
            value: f64::NAN,
            expression: text.filter(|_| is_expression).map(str::to_owned),
            is_angle: text.and_then(parse_angle).is_some(),
            is_set: setting.is_some(),
            deviations: None,
            has_limits: false,
            distribution: None,
            position: None,
            used_by: Vec::new(),
        });
        self.needs.push(needs);
        Ok(Written {
            place: value.place,
            value: given,
            setting,
            is_text: text.is_some(),
            tolerance,
        })
    }

    /// Gives each parameter its value, after those that it depends on.
    fn evaluate(
        &mut self,
        written: &[Written<'_>],
        variation: Option<&Variation<'_>>,
    ) -> Result<()> {
        let order = self.order(|i| &written[i as usize].place)?;
        let scope = &mut self.scope;
        scope.values = vec![f64::NAN; written.len()];
        if variation.is_some() {
            scope.varied = vec![Varied::constant(0.0); written.len()];
            scope.moves = vec![false; written.len()];
        }
        for i in order.into_iter().map(|i| i as usize) {
            let written = &written[i];
            let parameter = &mut self.all[i];
            let wrong = |text: &str, w| in_given(&written.place, text, &w, written.setting);
            let value = match &written.value {
                Given::Value(value) => *value,
                Given::Text(text, expression) => {
                    (expression.evaluate(&scope.values)).map_err(|w| wrong(text, w))?
                }
            };
            scope.values[i] = value;
            parameter.value = value;
            let Some(variation) = variation else { continue };
            let moves = self.needs[i].iter().any(|&n| scope.moves[n as usize]);
            let (varied, is_varied) = match &written.value {
                Given::Value(value) => variation.of(&parameter.name, *value),
                Given::Text(text, expression) => {
                    // Its own deviation, and those of what it depends on.
                    let (own, is_varied) = variation.of(&parameter.name, 0.0);
                    let from = if moves {
                        (expression.evaluate(&scope.varied)).map_err(|w| wrong(text, w))?
                    } else {
                        Varied::constant(value)
                    };
                    (from + own, is_varied)
                }
            };
            scope.varied[i] = varied;
            scope.moves[i] = moves || is_varied;
        }
        Ok(())
    }

    /// Gives a parameter its tolerance.
    fn tolerate(
        &mut self,
        i: usize,
        table: &Table<'_>,
        tolerance: &Tolerance,
        is_text: bool,
        unit: Option<Unit>,
    ) -> Result<()> {
        let parameter = &self.all[i];
        let nominal = Nominal {
            value: parameter.value,
            is_set: parameter.is_set,
            may_be_angle: is_text,
            is_angle: parameter.is_angle,
            unit,
        };
        let deviations = tolerance.deviations(table, nominal)?;
        if let Some(Position { with, .. }) = &tolerance.position {
            let help = "name the parameter that is the other coordinate, which has no tolerance of its own";
            let error = |message: &str| Err(table.error("with", message).with_help(help));
            match self.scope.numbers.get(with) {
                None => return error(&format!("there is no parameter {}", quoted(with))),
                Some(&other) if other as usize == i => return error("it is the parameter itself"),
                Some(&other) => {
                    let other = &self.all[other as usize];
                    if other.deviations.is_some() || other.position.is_some() {
                        return error("the parameter has a tolerance of its own");
                    }
                }
            }
        }
        let parameter = &mut self.all[i];
        parameter.deviations = deviations;
        parameter.has_limits = tolerance.has_limits();
        parameter.distribution = tolerance.distribution.clone();
        parameter.position = tolerance.position.clone();
        Ok(())
    }

    /// The parameters in an order in which each comes after those that it needs.
    fn order<'p>(&self, place: impl Fn(u32) -> &'p Place) -> Result<Vec<u32>> {
        let count = self.needs.len();
        let mut needed_by = vec![Vec::new(); count];
        let mut open: Vec<usize> = Vec::with_capacity(count);
        for (i, needs) in (0u32..).zip(&self.needs) {
            open.push(needs.len());
            for &need in needs {
                needed_by[need as usize].push(i);
            }
        }
        let mut order: Vec<u32> = (0..count as u32)
            .filter(|&i| open[i as usize] == 0)
            .collect();
        let mut next = 0;
        while let Some(&i) = order.get(next) {
            next += 1;
            for &j in &needed_by[i as usize] {
                open[j as usize] -= 1;
                if open[j as usize] == 0 {
                    order.push(j);
                }
            }
        }
        // From one that is left to one that it needs and that is left, until one comes again.
        let Some(mut at) = (0..count as u32).find(|&i| open[i as usize] > 0) else {
            return Ok(order);
        };
        let mut seen = vec![false; count];
        let mut way = Vec::new();
        while !seen[at as usize] {
            seen[at as usize] = true;
            way.push(at);
            let needs = &self.needs[at as usize];
            at = needs
                .iter()
                .copied()
                .find(|&n| open[n as usize] > 0)
                .unwrap_or(at);
        }
        let circle = &way[way.iter().position(|&i| i == at).unwrap_or_default()..];
        let names = circle
            .iter()
            .chain([&at])
            .map(|&i| &self.all[i as usize].name);
        let message = format!("the value depends on itself: {}", chained(names));
        Err(ModelError::new(place(at), message).with_help("give one of them a number"))
    }

    /// Assigns to each parameter the entries that depend on it, directly or by other parameters; `words` describes an
    /// entry. Adds notes on parameters on which nothing depends.
    pub(super) fn used(
        mut self,
        place: &Place,
        words: impl Fn(&Entry) -> String,
    ) -> Result<(Vec<Parameter>, Vec<ModelError>)> {
        let order = self.order(|_| place)?;
        let all_uses = self.scope.uses.get_mut();
        // Dependent entries come before those that they depend on.
        for &i in order.iter().rev() {
            let mut uses = core::mem::take(&mut all_uses[i as usize]);
            uses.sort_unstable();
            uses.dedup();
            for &need in &self.needs[i as usize] {
                all_uses[need as usize].extend_from_slice(&uses);
            }
            self.all[i as usize].used_by = uses.iter().map(&words).collect();
        }
        let unused = self.all.iter().filter(|p| p.used_by.is_empty());
        let remark = |p: &Parameter| {
            let place = place
                .key(&p.name)
                .itself()
                .called(format!("parameter {}", quoted(&p.name)));
            ModelError::new(&place, "no number of the model depends on it")
        };
        let remarks = unused.map(remark).collect();
        Ok((self.all, remarks))
    }
}

/// Error in the value of a parameter, which may have been set from outside.
fn in_given(place: &Place, text: &str, wrong: &Wrong, setting: Option<&Setting>) -> ModelError {
    match setting {
        None => in_text(place, text, wrong),
        Some(_) => {
            let message = format!("the value {} that is set: {}", quoted(text), wrong.message);
            ModelError::new(place, message).with_help(wrong.help.as_str())
        }
    }
}

/// Checks that expressions can have a name; else what is wrong, and what to do.
fn can_be_named(name: &str) -> core::result::Result<(), (&'static str, &'static str)> {
    if !is_name(name) {
        let help = "use letters, digits and underscores, and no digit first, such as pin_diameter";
        return Err(("the name cannot be used in expressions", help));
    }
    if is_taken(name) {
        let message = "the name is that of a function or a constant";
        return Err((message, "choose another name"));
    }
    Ok(())
}

/// Names with commas between, the first of them where they are many.
fn listed<'n>(names: impl ExactSizeIterator<Item = &'n String>) -> String {
    const SHOWN: usize = 12;
    let more = names.len().saturating_sub(SHOWN);
    let shown: Vec<&str> = names.take(SHOWN).map(String::as_str).collect();
    let more = if more > 0 {
        format!(" and {more} more")
    } else {
        String::new()
    };
    shown.join(", ") + &more
}

/// Names that lead from one to the next, the first and last of them where they are many.
fn chained<'n>(names: impl Iterator<Item = &'n String>) -> String {
    const SHOWN: usize = 12;
    let names: Vec<&str> = names.map(String::as_str).collect();
    match names.len().checked_sub(SHOWN) {
        None | Some(0) => names.join(" → "),
        Some(left_out) => {
            let (first, last) = (&names[..SHOWN - 1], names[names.len() - 1]);
            format!("{} → ({left_out} more) → {last}", first.join(" → "))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::model::{Setting, from_toml};
    use crate::{Document, Host, read_from_hosted};

    const MODEL: &str = r#"
[parameter]
pin = 6.0
gap = { value = 0.1, plus = 0.05, minus = 0 }
slot = "pin + 2*gap"
n = 4

[[part]]
name = "pin"
loops = [{ circle = "pin/2", at = ["-gap", 0] }]
motion = { type = "revolute", center = [0, "gap"], range = ["-360deg/n", "90deg"] }
mass = "pin^2"

[[part]]
name = "plate"
loops = [[["-slot", "-slot"], ["slot", "-slot"], ["slot", "slot"], ["-slot", "slot", "tan(90deg/n)*0"]]]
symmetry = "n"
"#;

    fn read(text: &str, set: &[(&str, &str)]) -> Result<crate::Model, crate::ModelError> {
        let set: Vec<Setting> = (set.iter())
            .map(|(name, value)| Setting {
                name: (*name).into(),
                value: (*value).into(),
            })
            .collect();
        let host = Host {
            set: &set,
            ..Host::default()
        };
        match read_from_hosted(text.as_bytes(), "m.toml", &host)? {
            Document::Model(model) => Ok(*model),
            Document::Space(_) => panic!("it is a model"),
        }
    }

    #[test]
    fn numbers_are_expressions_of_parameters() {
        let model = read(MODEL, &[]).unwrap();
        let (pin, plate) = (&model.mechanism.parts[0], &model.mechanism.parts[1]);
        let bounds = pin.part.bounds();
        assert!((bounds.max.x - 2.9).abs() < 1e-15 && (bounds.min.y + 3.0).abs() < 1e-15);
        let range = pin.axis.unwrap().range.unwrap();
        assert!((range.0 + range.1).abs() < 1e-15);
        assert!((plate.part.bounds().max.x - 6.2).abs() < 1e-15);
        assert_eq!(plate.symmetry, Some(4));
        assert_eq!(
            model
                .mechanism
                .dynamics
                .part(0)
                .mass
                .map(|m| format!("{m:?}").contains("36")),
            Some(true)
        );
        let parameter = |name: &str| model.parameters.iter().find(|p| p.name == name).unwrap();
        assert_eq!(parameter("slot").expression.as_deref(), Some("pin + 2*gap"));
        assert_eq!(parameter("slot").used_by, ["part \"plate\""]);
        assert_eq!(parameter("pin").used_by, ["part \"pin\"", "part \"plate\""]);
        assert_eq!(parameter("gap").deviations, Some((0.0, 0.05)));
    }

    #[test]
    fn values_are_set() {
        let model = read(MODEL, &[("pin", "5"), ("gap", "pin/10"), ("n", "2*2")]).unwrap();
        assert!((model.mechanism.parts[1].part.bounds().max.x - 6.0).abs() < 1e-15);
        assert!(
            model
                .parameters
                .iter()
                .all(|p| p.is_set == (p.name != "slot"))
        );
        let wrong = |set: &[(&str, &str)]| read(MODEL, set).unwrap_err();
        let e = wrong(&[("pim", "5")]);
        assert_eq!(e.help(), Some("did you mean `pin`?"));
        let e = wrong(&[("pin", "5 mm")]);
        assert!(
            e.message().contains("the value \"5 mm\" that is set"),
            "{e}"
        );
        let e = wrong(&[("pin", "slot")]);
        assert!(e.message().contains("depends on itself"), "{e}");
        let e = read(
            "[[part]]\nname = \"a\"\nloops = [{ circle = 1, at = [0, 0] }]\n",
            &[("a", "1")],
        );
        assert!(e.unwrap_err().message().contains("no parameters"));
    }

    #[test]
    fn what_is_wrong_is_told_where_it_is() {
        for (from, to, expected, help) in [
            (
                "\"pin/2\"",
                "\"pim/2\"",
                "m.toml:10:22: part 0 \"pin\", loop 0: in \"pim/2\": there is no parameter \"pim\"",
                "did you mean `pin`?",
            ),
            (
                "\"-gap\"",
                "\"-gap)\"",
                "m.toml:10:41: part 0 \"pin\", loop 0: in \"-gap)\": \")\" is not expected here",
                "remove it",
            ),
            (
                "[\"slot\", \"slot\"]",
                "[\"slot\", \"1/(n-4)\"]",
                "m.toml:16:61: part 1 \"plate\", loop 0, vertex 2: in \"1/(n-4)\": a division by zero",
                "divisor",
            ),
            (
                "\"pin + 2*gap\"",
                "\"pin + 2*gpa\"",
                "m.toml:5:17: parameter \"slot\": in \"pin + 2*gpa\": there is no parameter \"gpa\"",
                "did you mean `gap`?",
            ),
            (
                "pin = 6.0",
                "pin = \"slot\"",
                "m.toml:3:7: parameter \"pin\": the value depends on itself: pin → slot → pin",
                "give one of them",
            ),
            (
                "\"-360deg/n\"",
                "\"-360deg/m\"",
                "in \"-360deg/m\": there is no parameter \"m\"",
                "did you mean `n`?",
            ),
            (
                "\"pin^2\"",
                "\"pin^^2\"",
                "in \"pin^^2\": \"^\" stands where a value",
                "write a number",
            ),
            (
                "\"n\"",
                "\"n/3\"",
                "`symmetry` is the number 1.3333333333333333 where a whole number",
                "whole number",
            ),
            (
                "n = 4",
                "sin = 4",
                "m.toml:6:1: parameter \"sin\": the name is that of a function",
                "another name",
            ),
            (
                "n = 4",
                "n-1 = 4",
                "m.toml:6:1: parameter \"n-1\": the name cannot",
                "underscores",
            ),
            (
                "n = 4",
                "n = [4]",
                "m.toml:6:5: parameter \"n\": a list of one item where a number",
                "pin = 6.0",
            ),
            (
                "plus = 0.05",
                "puls = 0.05",
                "unknown key \"puls\"",
                "did you mean `plus`?",
            ),
            (
                "name = \"plate\"",
                "nmae = \"plate\"",
                "unknown key \"nmae\"",
                "did you mean `name`?",
            ),
            (
                "mass = \"pin^2\"",
                "mass = \"18deg\"",
                "the text \"18deg\"",
                "2.5",
            ),
        ] {
            assert!(MODEL.contains(from), "{from}");
            let e = read(&MODEL.replacen(from, to, 1), &[]).unwrap_err();
            assert!(e.to_string().contains(expected), "{e}");
            assert!(
                e.help().unwrap_or_default().contains(help),
                "{e}: {:?}",
                e.help()
            );
        }
    }

    #[test]
    fn names_are_no_expressions() {
        // Both parts and a parameter are called pin.
        let model = read(&MODEL.replace("\"plate\"", "\"gap\""), &[]).unwrap();
        assert_eq!(model.mechanism.parts[1].part.name(), "gap");
    }

    #[test]
    fn hostile_parameters_are_refused_or_read_in_time() {
        let part = "[[part]]\nname = \"a\"\nloops = [{ circle = \"last\", at = [0, 0] }]\n";
        let chain = |n: usize, of: &dyn Fn(usize) -> String| {
            let lines: String = (1..n)
                .map(|i| format!("p{i} = \"{}\"\n", of(i - 1)))
                .collect();
            format!(
                "[parameter]\np0 = 1\n{lines}last = \"p{}*0 + 1\"\n{part}",
                n - 1
            )
        };
        let model = read(&chain(9_000, &|i| format!("p{i} + 1")), &[]).unwrap();
        assert!(model.parameters.iter().any(|p| p.value == 9_000.0));
        // Each is twice the one before: too large in the end.
        let e = read(&chain(2_000, &|i| format!("p{i} + p{i}")), &[]).unwrap_err();
        assert!(e.message().contains("no finite number"), "{e}");
        let e = read(&chain(100_000, &|i| format!("p{i}")), &[]).unwrap_err();
        assert!(e.message().contains("more than 10000"), "{e}");
        let circle = chain(5_000, &|i| format!("p{i}")).replacen("p0 = 1", "p0 = \"p4999\"", 1);
        let e = read(&circle, &[]).unwrap_err();
        assert!(e.message().contains("more) →"), "{e}");
        for bad in ["nan", "inf", "-inf"] {
            let e = read(&format!("[parameter]\nlast = {bad}\n{part}"), &[]).unwrap_err();
            assert!(e.message().contains("where a number"), "{e}");
        }
    }

    #[test]
    fn expressions_need_no_parameters() {
        let text =
            "[[part]]\nname = \"a\"\nloops = [{ circle = \"sqrt(2)/2\", at = [0, \"pi\"] }]\n";
        let model = from_toml(text, "m.toml").unwrap();
        assert!((model.parts[0].part.bounds().max.x - 0.5f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn parameters_that_nothing_uses_are_told() {
        let notes = std::cell::RefCell::new(Vec::new());
        let note = |text: &str| notes.borrow_mut().push(text.to_owned());
        let host = Host {
            note: &note,
            ..Host::default()
        };
        let text = MODEL.replacen("n = 4", "n = 4\nspare = \"gap\"", 1);
        read_from_hosted(text.as_bytes(), "m.toml", &host).unwrap();
        assert_eq!(
            *notes.borrow(),
            ["m.toml:7:1: parameter \"spare\": no number of the model depends on it"]
        );
    }
}
