//! Places in a file: a description for people, and the path through its tree of values.

/// A step from a value into it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    /// Step to the value of a key.
    Key(String),
    /// Step to an item of a list.
    Item(usize),
}

/// A value of the file, or a key.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Place {
    words: String,
    way: Vec<Step>,
    is_key: bool,
}

impl Place {
    /// Description of the place.
    pub(super) fn words(&self) -> &str {
        &self.words
    }

    /// Path from the root.
    pub(super) fn way(&self) -> &[Step] {
        &self.way
    }

    /// Whether the place is the last key of the path, and not its value.
    pub(super) fn is_key(&self) -> bool {
        self.is_key
    }

    /// The value of a key, in the same words.
    pub(super) fn key(&self, key: &str) -> Self {
        self.step(Step::Key(key.to_owned()))
    }

    /// An item of a list, in the same words.
    pub(super) fn item(&self, index: usize) -> Self {
        self.step(Step::Item(index))
    }

    /// The key that leads here.
    pub(super) fn itself(mut self) -> Self {
        self.is_key = true;
        self
    }

    /// Copy of the place with other words.
    pub(super) fn called(mut self, words: impl Into<String>) -> Self {
        self.words = words.into();
        self
    }

    /// Copy of the place with more words.
    pub(super) fn further(mut self, words: &str) -> Self {
        if !self.words.is_empty() {
            self.words.push_str(", ");
        }
        self.words.push_str(words);
        self
    }

    fn step(&self, step: Step) -> Self {
        let mut next = self.clone();
        next.way.push(step);
        next
    }
}
