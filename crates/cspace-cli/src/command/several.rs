//! One answer for each of several files.

use std::fmt;
use std::path::PathBuf;

use cspace_api::files::FileAnswer;
use cspace_api::{Answer, Content};

use crate::args::{Common, Format};
use crate::failure::Failure;

/// Answers about the file of `common` and about more, one after the other; `answer` gives that about one, and its [`text`]. About several
/// files, each text is headed by its file, and JSON is one list of answers or errors that name theirs. A file without an answer does not hold
/// back the others.
pub(super) fn run<T: Content>(
    common: &Common,
    more: &[PathBuf],
    answer: impl Fn(&Common) -> Result<(Answer<T>, String), Failure>,
) -> Result<(), Failure> {
    common.result.artefact(&[])?;
    if more.is_empty() {
        let (answer, text) = answer(common)?;
        return super::tell(&common.result, &answer, |printed, _| {
            printed.push_str(&text);
            Ok(())
        });
    }
    let (mut text, mut files) = (String::new(), Vec::new());
    for file in [&common.file].into_iter().chain(more) {
        let name = file.display().to_string();
        let one = Common {
            file: file.clone(),
            ..common.clone()
        };
        files.push(match answer(&one) {
            Ok((answer, of_file)) => {
                let between = if text.is_empty() { "" } else { "\n" };
                let heading = cspace_model::shown::text(&name);
                text += &format!("{between}== {heading}\n{of_file}");
                FileAnswer::Answered { file: name, answer }
            }
            Err(failure) => {
                failure.print_beside();
                let error = failure.error().clone();
                FileAnswer::Failed { file: name, error }
            }
        });
    }
    super::tell(&common.result, &Answer::of_files(files), |printed, _| {
        printed.push_str(&text);
        Ok(())
    })
}

/// The text of an answer; none where JSON is printed.
pub(super) fn text(
    common: &Common,
    describe: impl FnOnce(&mut String) -> fmt::Result,
) -> Result<String, Failure> {
    let mut text = String::new();
    if common.result.format() == Format::Text {
        describe(&mut text).map_err(Failure::new)?;
    }
    Ok(text)
}
