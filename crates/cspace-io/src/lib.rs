//! Model files for `cspace`, and writers for contact spaces.
