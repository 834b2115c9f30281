//! The command `cspace`.

fn main() {}
