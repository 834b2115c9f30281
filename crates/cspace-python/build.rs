//! Lets Python's module be linked without Python, whoever builds it: maturin or Cargo.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
