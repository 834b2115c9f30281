//! The keys of a table of the file: what the reader takes, what its messages suggest, and what the schema says.

/// A key of a table.
#[derive(Clone, Copy)]
pub(super) struct Key {
    pub(super) name: &'static str,
    /// How its value is written: the name of a definition of the schema, `[name]` for a list of such, `a|b` for one of these texts, or `kind`.
    pub(super) value: &'static str,
    /// Meaning, for who writes a model.
    pub(super) about: &'static str,
    /// Whether every such table must have it.
    pub(super) is_needed: bool,
    /// Example, for who left it out where it is needed.
    pub(super) example: &'static str,
}

impl Key {
    /// A key that may be left out.
    pub(super) const fn new(name: &'static str, value: &'static str, about: &'static str) -> Self {
        Self {
            name,
            value,
            about,
            is_needed: false,
            example: "",
        }
    }

    /// How it is written.
    pub(super) const fn like(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

    /// A key that may not be left out, and how it is written.
    pub(super) const fn needed(self, example: &'static str) -> Self {
        Self {
            is_needed: true,
            ..self.like(example)
        }
    }
}

/// The keys of two tables in one.
pub(super) const fn joined<const A: usize, const B: usize, const N: usize>(
    first: [Key; A],
    second: [Key; B],
) -> [Key; N] {
    let mut all = [first[0]; N];
    let mut i = 1;
    while i < N {
        all[i] = if i < A { first[i] } else { second[i - A] };
        i += 1;
    }
    all
}

/// Kind of a table: its keys beside those that all kinds have.
pub(super) struct Kind {
    pub(super) name: &'static str,
    /// Keys that it must have.
    pub(super) needs: &'static [&'static str],
    /// Keys that it may have.
    pub(super) takes: &'static [&'static str],
}

impl Kind {
    pub(super) fn has(&self, key: &str) -> bool {
        self.needs.contains(&key) || self.takes.contains(&key)
    }
}

/// The kinds of a table, which one of its keys names.
pub(super) struct Kinds {
    /// Words for them: `type of joint`.
    pub(super) what: &'static str,
    /// The key.
    pub(super) key: &'static str,
    /// The kind of a table without it, if it may be left out.
    pub(super) default: Option<&'static str>,
    pub(super) all: &'static [Kind],
}

impl Kinds {
    /// The kind of a name.
    pub(super) fn get(&self, name: &str) -> Option<&'static Kind> {
        self.all.iter().find(|kind| kind.name == name)
    }

    /// Whether all kinds have a key.
    pub(super) fn are_indifferent_to(&self, key: &str) -> bool {
        !self.all.iter().any(|kind| kind.has(key))
    }
}

/// The keys of a table.
pub(super) struct Keys {
    /// Advice where there is something else than a table.
    pub(super) help: &'static str,
    pub(super) keys: &'static [Key],
    pub(super) kinds: Option<Kinds>,
}

impl Keys {
    /// The keys of a table of one kind.
    pub(super) const fn new(help: &'static str, keys: &'static [Key]) -> Self {
        Self {
            help,
            keys,
            kinds: None,
        }
    }

    pub(super) fn get(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }

    /// The names of all keys, or of those that a kind has.
    pub(super) fn names(&self, kind: Option<&Kind>) -> Vec<&'static str> {
        let names = self.keys.iter().map(|key| key.name);
        match (kind, &self.kinds) {
            (Some(kind), Some(kinds)) => names
                .filter(|key| kind.has(key) || kinds.are_indifferent_to(key))
                .collect(),
            _ => names.collect(),
        }
    }
}
