//! A question of any kind, as data.

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::error::Error;
use crate::frame::{Answer, Content, Pairs};
use crate::host::Host;
use crate::subject::Subject;
use crate::tolerances::{allocation, along, analysis, zones};
use crate::{
    check, clearance, compute, disassemble, escape, info, modes, plan, play, simulate, solve, sweep,
};

/// Declares the kinds of questions, each with its type, its answer, and the function that asks.
macro_rules! questions {
    ($(#[doc = $about:literal] $name:ident($question:ty) -> $answer:ty, $ask:expr;)*) => {
        /// A question of any kind, whose name is its `question`.
        ///
        /// ```
        /// use cspace_api::{Deaf, Question, Subject};
        /// let text = "[[part]]\nname = \"pin\"\nloops = [[[-1, 0, 1], [1, 0, 1]]]\n";
        /// let document = cspace_model::read_from(text.as_bytes(), "pin.toml")?;
        /// let subject = Subject::of("pin.toml".into(), document, None, Vec::new());
        /// let question: Question = serde_json::from_str(r#"{ "question": "info" }"#)?;
        /// let answer = serde_json::to_value(question.ask(&subject, &Deaf)?)?;
        /// assert_eq!(answer["parts"][0]["name"], "pin");
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        #[derive(Debug, Deserialize, JsonSchema)]
        #[serde(tag = "question", rename_all = "kebab-case")]
        pub enum Question {
            $(#[doc = $about] $name($question),)*
        }

        /// The answer to a question of any kind.
        #[derive(Debug, Serialize)]
        #[serde(untagged)]
        pub enum AnyAnswer {
            $(#[doc = $about] $name(Box<Answer<$answer>>),)*
        }

        impl Question {
            /// All kinds of questions.
            pub fn kinds() -> Vec<Kind> {
                vec![$(Kind {
                    name: stringify!($name).to_ascii_lowercase(),
                    about: $about.trim(),
                    asked: inlined::<$question>(),
                    outcomes: words::<<$answer as Content>::Outcome>(),
                },)*]
            }

            /// Asks a model, or a saved space.
            ///
            /// # Errors
            /// If the question has no answer; the error says why, and what to do.
            pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<AnyAnswer, Error> {
                Ok(match self {
                    $(Self::$name(question) => {
                        let ask: fn(&$question, &Subject, &dyn Host) -> Result<Answer<$answer>, Error> = $ask;
                        AnyAnswer::$name(Box::new(ask(question, subject, host)?))
                    })*
                })
            }
        }
    };
}

/// A kind of question: what can be asked, and how it may come out.
#[derive(Debug, Clone)]
pub struct Kind {
    /// Its `question`.
    pub name: String,
    /// Subject of the answer.
    pub about: &'static str,
    /// The schema of what is asked, in one piece.
    pub asked: Schema,
    /// The words of its outcomes, each with its meaning.
    pub outcomes: Vec<(String, String)>,
}

/// The schema of what is asked, in one piece.
pub fn inlined<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::draft2020_12().with(|s| s.inline_subschemas = true);
    settings.into_generator().into_root_schema_for::<T>()
}

/// The words of an enumeration, each with its meaning.
pub(crate) fn words<T: JsonSchema>() -> Vec<(String, String)> {
    let schema = inlined::<T>();
    let variants = schema.get("oneOf").and_then(Value::as_array);
    let words = variants.into_iter().flatten().filter_map(|variant| {
        let text = |key| variant.get(key).and_then(Value::as_str);
        let meaning = text("description").unwrap_or_default();
        let meaning = meaning.trim_end_matches('.').replace('\n', " ");
        Some((text("const")?.to_owned(), meaning))
    });
    words.collect()
}

questions! {
    /// The tolerances of minimum cost at which the requirements are met.
    Allocation(allocation::Question) -> allocation::Allocation, allocation::Question::ask;
    /// Values and their extremes along a coordinate.
    Along(along::Question) -> along::Bands, along::Question::ask;
    /// Which requirements are met.
    Check(check::Question) -> check::Requirements, check::Question::ask;
    /// The gap of every two parts.
    Clearance(clearance::Question) -> clearance::Clearances, clearance::Question::ask;
    /// Summaries of contact spaces.
    Compute(compute::Question) -> Pairs<compute::Summary>, |question, subject, host| {
        question.ask(&subject.pairs(&question.which, host)?)
    };
    /// The order in which parts come apart.
    Disassemble(disassemble::Question) -> disassemble::Disassembly, disassemble::Question::ask;
    /// The least energy that lets a part out.
    Escape(escape::Question) -> Pairs<escape::Escape>, |question, subject, host| {
        question.ask(&[subject.one_pair(&question.which, host)?])
    };
    /// Parts, joints and pairs.
    Info(info::Question) -> info::Info, info::Question::ask;
    /// The operating modes of parts on axes.
    Modes(modes::Question) -> modes::OperatingModes, modes::Question::ask;
    /// A path, or that there is none.
    Plan(plan::Question) -> Pairs<plan::Plan>, |question, subject, host| {
        question.ask(&[subject.one_pair(&question.which, host)?])
    };
    /// Contacts and play at a configuration.
    Play(play::Question) -> Pairs<play::Play>, |question, subject, host| {
        question.ask(&question.pairs(subject, host)?)
    };
    /// The motion of a mechanism.
    Simulate(simulate::Question) -> simulate::Simulated, simulate::Question::ask;
    /// Values of parameters for which a condition holds.
    Solve(solve::Question) -> solve::Solutions, solve::Question::ask;
    /// Requirements over ranges of parameters or coordinates.
    Sweep(sweep::Question) -> sweep::Rows, sweep::Question::ask;
    /// The effect of tolerances on the requirements.
    Tolerances(analysis::Question) -> analysis::Analysis, analysis::Question::ask;
    /// Configurations that are free, blocked, or either within the tolerances.
    Zones(zones::Question) -> Pairs<zones::Zones>, zones::Question::ask;
}
