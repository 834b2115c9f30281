//! Models to begin with: commented files, whose dimensions are parameters.

use cspace_model::Host;
use cspace_model::model::{Setting, Template as Text};

use crate::Error;

/// A model that `cspace new` writes, and that the page offers.
#[derive(Debug)]
pub struct Template {
    /// Name on the command line.
    pub name: &'static str,
    /// The file. Its first line says what it is a model of; the dimensions are the parameters down to the first empty line.
    pub text: &'static str,
}

macro_rules! templates {
    ($($name:literal)*) => {
        [$(Template { name: $name, text: include_str!(concat!($name, ".toml")) }),*]
    };
}

/// All of them.
pub static TEMPLATES: [Template; 6] = templates!["latch" "cam" "gears" "geneva" "ratchet" "peg"];

/// A dimension of a template.
struct Dimension {
    name: &'static str,
    value: &'static str,
    note: &'static str,
}

impl Template {
    /// The template with a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        TEMPLATES.iter().find(|t| t.name == name)
    }

    /// Title of the model, the first line of the file.
    pub fn title(&self) -> &'static str {
        let first = self.text.lines().next().unwrap_or_default();
        first.trim_start_matches("# ")
    }

    fn dimensions(&self) -> impl Iterator<Item = Dimension> {
        let mut lines = self.text.lines();
        lines.find(|l| *l == "[parameter]");
        lines
            .take_while(|l| !l.is_empty())
            .filter_map(|line: &'static str| {
                let (name, rest) = line.split_once(" = ")?;
                let (value, note) = rest.split_once(" # ")?;
                let value = value.trim_matches('"');
                Some(Dimension { name, value, note })
            })
    }

    /// The model with values for parameters, as the text of a TOML file.
    ///
    /// # Errors
    /// If there is no such parameter, or there is no such model with these values.
    pub fn with(&self, set: &[Setting]) -> Result<String, Error> {
        let text = Text::from_text(self.text.to_owned(), format!("{}.toml", self.name))?;
        let drawn = text.model(&Host::default())?;
        for Setting { name, .. } in set {
            if !drawn.parameters.iter().any(|p| p.name == *name) {
                let names: Vec<&str> = self.dimensions().map(|d| d.name).collect();
                let kind = self.name;
                return Err(
                    Error::new(format_args!("{kind} has no parameter {name:?}")).help(
                        format_args!("the parameters of {kind} are {}", names.join(", ")),
                    ),
                );
            }
        }
        let host = Host {
            set,
            ..Host::default()
        };
        let model = text.model(&host).map_err(|e| self.refused(set, &e))?;
        // Readers take lengths below 0 as they come, and draw something else.
        let is_below = |d: &Dimension| {
            let found = model.parameters.iter().find(|p| p.name == d.name);
            found.is_some_and(|p| p.value <= 0.0)
        };
        if let Some(Dimension { name, .. }) = self.dimensions().find(is_below) {
            return Err(self.refused(set, &format!("{name} must be above 0")));
        }
        (text.text_with(set)).ok_or_else(|| self.refused(set, &"it cannot be written"))
    }

    /// The failure of values that make no model.
    fn refused(&self, set: &[Setting], why: &dyn core::fmt::Display) -> Error {
        let given: Vec<String> = (set.iter())
            .map(|s| format!("{} = {}", s.name, s.value))
            .collect();
        let others: Vec<String> = (self.dimensions())
            .filter(|d| set.iter().any(|s| s.name == d.name))
            .map(|d| format!("{} = {}", d.name, d.value))
            .collect();
        let given = given.join(", ");
        let help = match others.is_empty() {
            true => "leave it out".to_owned(),
            false => format!("change it towards the default: {}", others.join(", ")),
        };
        Error::new(format_args!("{} with {given}: {why}", self.name)).help(help)
    }
}

/// The dimensions of all templates, for help.
pub fn dimensions() -> String {
    let of = |template: &Template| {
        let lines = template
            .dimensions()
            .map(|Dimension { name, value, note }| format!("    {name:<9}  {value:<5}  {note}\n"));
        format!("  {}\n{}", template.name, lines.collect::<String>())
    };
    TEMPLATES.iter().map(of).collect()
}
