//! One sort for lists of indices.

use std::cmp::Ordering;

/// Sorts indices by what they stand for; where that is equal, the lower index comes first.
///
/// By a heap (Williams 1964). The standard library's sort is quicker, and takes some 9 kB of a module for the browser
/// for each way to compare; what the first picture waits for has no other use for it.
pub fn sort_indices(indices: &mut [usize], compare: &dyn Fn(usize, usize) -> Ordering) {
    let below = |a: usize, b: usize| compare(a, b).then(a.cmp(&b)).is_lt();
    let sink = |heap: &mut [usize], mut top: usize| {
        loop {
            let mut child = 2 * top + 1;
            if child + 1 < heap.len() && below(heap[child], heap[child + 1]) {
                child += 1;
            }
            if child >= heap.len() || !below(heap[top], heap[child]) {
                return;
            }
            heap.swap(top, child);
            top = child;
        }
    };
    for top in (0..indices.len() / 2).rev() {
        sink(indices, top);
    }
    for end in (1..indices.len()).rev() {
        indices.swap(0, end);
        sink(&mut indices[..end], 0);
    }
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
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn they_come_as_the_standard_library_has_them(values in proptest::collection::vec(0..9_u8, 0..40)) {
            let mut order: Vec<usize> = (0..values.len()).rev().collect();
            sort_indices(&mut order, &|a, b| values[a].cmp(&values[b]));
            let mut expected: Vec<usize> = (0..values.len()).collect();
            expected.sort_by_key(|&i| values[i]);
            prop_assert_eq!(order, expected);
        }
    }

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
