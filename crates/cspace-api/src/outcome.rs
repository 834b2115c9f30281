//! How a question came out: one word of a list, which says yes, no, or that it is open.

use schemars::JsonSchema;
use serde::Serialize;

/// Whether the answer to a question is yes, which is also that of a question for a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Is {
    /// Yes, or a value.
    Yes,
    /// The question is open: nothing is decided.
    Open,
    /// No.
    No,
}

/// How a question came out.
pub trait Outcome: Copy + Eq + core::fmt::Debug + Serialize + JsonSchema {
    /// Outcome of a question about nothing.
    const NOTHING: Self;

    /// Whether it says yes.
    fn is(self) -> Is;

    /// The word, in JSON as in text.
    fn word(self) -> &'static str;
}

/// How a question came out that is about all of these: with no if one is no, otherwise open if one is.
pub fn worst<O: Outcome>(all: impl IntoIterator<Item = O>) -> O {
    let worse = |a: O, b: O| if b.is() > a.is() { b } else { a };
    all.into_iter().reduce(worse).unwrap_or(O::NOTHING)
}

/// Declares the outcomes of a question, each with its word and what it says; the first is that of a question about nothing.
macro_rules! outcomes {
    ($(#[$doc:meta])* $name:ident {
        $(#[$first_doc:meta])* $first:ident = $first_word:literal is $first_is:ident
        $(, $(#[$variant_doc:meta])* $variant:ident = $word:literal is $is:ident)* $(,)?
    }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, schemars::JsonSchema)]
        pub enum $name {
            $(#[$first_doc])*
            #[serde(rename = $first_word)]
            $first,
            $($(#[$variant_doc])* #[serde(rename = $word)] $variant,)*
        }

        impl $crate::Outcome for $name {
            const NOTHING: Self = Self::$first;

            fn is(self) -> $crate::Is {
                match self {
                    Self::$first => $crate::Is::$first_is,
                    $(Self::$variant => $crate::Is::$is,)*
                }
            }

            fn word(self) -> &'static str {
                match self {
                    Self::$first => $first_word,
                    $(Self::$variant => $word,)*
                }
            }
        }
    };
}

outcomes! {
    /// The outcome of a question for values, which are known.
    Done {
        /// The values are known.
        Done = "done" is Yes,
    }
}

pub(crate) use outcomes;
