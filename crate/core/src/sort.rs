//! One sort for lists of indices.

use std::cmp::Ordering;

/// Sorts indices by what they stand for; equal ones keep their order.
///
/// The standard library's sort is compiled anew for each way to compare, some 9 kB of a module for the browser each
/// time. This one is compiled once.
pub fn sort_indices(indices: &mut [usize], compare: &dyn Fn(usize, usize) -> Ordering) {
    indices.sort_by(|&a, &b| compare(a, b));
}
