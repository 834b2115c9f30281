//! Comments of documentation name their subject: none of their lines begins with a word that refers to another item.

use std::path::Path;

use super::files;

/// Words with which no line begins: "The same of arcs" is "As above, for arcs".
const REFUSED: [&str; 6] = ["The same", "What", "Of", "That", "Those", "None of"];

/// The text of a line of documentation; `None` if the line is another one.
fn documentation(line: &str) -> Option<&str> {
    let line = line.trim_start();
    (line.strip_prefix("/// ")).or_else(|| line.strip_prefix("//! "))
}

/// Whether a text begins with a refused word: the whole word, not "Offset".
fn is_refused(text: &str) -> bool {
    REFUSED.iter().any(|word| {
        (text.strip_prefix(word)).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    })
}

#[test]
fn lines_of_documentation_name_their_subject() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let all = ["crates", "dev"].map(|folder| files(&root.join(folder)));
    let mut refused = Vec::new();
    let mut count = 0;
    for file in all.into_iter().flatten() {
        let text = std::fs::read_to_string(&file).unwrap();
        let name = file.strip_prefix(&root).unwrap().display().to_string();
        for (number, line) in (1..).zip(text.lines()) {
            let Some(text) = documentation(line) else {
                continue;
            };
            count += 1;
            if is_refused(text) {
                refused.push(format!("{name}:{number}: {text}"));
            }
        }
    }
    assert!(count > 10_000, "{count} lines of documentation are found");
    assert!(
        refused.is_empty(),
        "begin with a noun or a verb:\n{}",
        refused.join("\n")
    );
}

#[test]
fn whole_words_are_refused() {
    assert!(
        is_refused("The same of arcs.") && is_refused("What is left.") && is_refused("Of two.")
    );
    assert!(!is_refused("Offsets of a line.") && !is_refused("Whatever is left."));
}
