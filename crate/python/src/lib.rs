//! Frond for Python: what the package `frond` computes with.
//!
//! The package is in `package/frond`: it reads what its callers give, says what is wrong with it, and names the
//! answers. What is here takes arrays and plain numbers that are of the right form, and gives the same.
//!
//! # In which order to read it
//!
//! 1. `cross`: errors, maps, and how the lock of the interpreter is released while something is computed.
//! 2. `shape` shows best how a function is exported; `verdict`, `morph`, `way`, `document` and `fit` are a file
//!    for what belongs together.
//! 3. `elementary`: sine and its like, the same on every machine.
#![allow(clippy::missing_errors_doc)]

mod cross;
mod document;
#[cfg(unix)]
mod elementary;
mod fit;
mod morph;
mod shape;
mod verdict;
mod way;

use pyo3::prelude::*;

/// What the package `frond` computes with. It may change at any time.
#[pymodule]
mod _frond {
    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    #[pymodule_export]
    use super::document::{decode, encode, presets};
    #[pymodule_export]
    use super::fit::{fit_bytes, fit_numbers, measure, trace};
    #[pymodule_export]
    use super::morph::{interpolate, pair};
    #[pymodule_export]
    use super::shape::{attractor, bounds, checked, dimension, rasterize};
    #[pymodule_export]
    use super::verdict::{certificate, check, connected_certificate, connectedness};
    #[pymodule_export]
    use super::way::{certify_path, check_path, locus, plan_path};
}
