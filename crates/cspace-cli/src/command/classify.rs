//! `cspace classify`.
use crate::args::ClassifyArgs;
use crate::failure::Failure;

pub(crate) fn run(_: &ClassifyArgs) -> Result<(), Failure> {
    Err(Failure::work("later"))
}
