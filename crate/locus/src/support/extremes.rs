//! The larger and the lesser of two numbers, for inner loops.
//!
//! `f64::max` and `f64::min` look for NaN in either, for which WebAssembly has no instruction: there each is a call,
//! and a loop with one is not made into vector instructions.

/// The larger of two; the first where one is NaN.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// The lesser of two; the first where one is NaN.
#[inline(always)]
pub(crate) fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}
