//! One sort for lists of indices.

use std::cmp::Ordering;

/// Sorts indices by what they stand for; where that is equal, the lower index comes first.
///
/// The standard library's sort is compiled anew for each way to compare, some 9 kB of a module for the browser each
/// time. This one is compiled once.
pub fn sort_indices(indices: &mut [usize], compare: &dyn Fn(usize, usize) -> Ordering) {
    indices.sort_unstable_by(|&a, &b| compare(a, b).then(a.cmp(&b)));
}

/// Whether these are all indices below `count`, each once.
#[must_use]
pub fn is_permutation(indices: &[usize], count: usize) -> bool {
    let mut seen = vec![false; count];
    let is_new = |&index: &usize| seen.get_mut(index).is_some_and(|seen| !std::mem::replace(seen, true));
    indices.len() == count && indices.iter().all(is_new)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ones_stay_in_order_and_each_stands_once() {
        let values = [2, 0, 2, 1, 0, 2];
        let mut order: Vec<usize> = (0..values.len()).collect();
        sort_indices(&mut order, &|a, b| values[a].cmp(&values[b]));
        assert_eq!(order, [1, 4, 3, 0, 2, 5]);
        assert!(is_permutation(&order, 6) && is_permutation(&[], 0));
        for wrong in [&[0, 1, 1][..], &[0, 1], &[0, 1, 3], &[0, 1, 2, 2]] {
            assert!(!is_permutation(wrong, 3), "{wrong:?}");
        }
    }
}
