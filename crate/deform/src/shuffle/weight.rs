//! How much each depth counts in a superposition.

/// The weights of the terms k = kb .. ke: `delta^(k - kb)`, scaled to sum 1 (Fujimoto et al., eq 13). `delta` is
/// the roughness, 0 or more; 0 leaves the first term alone, 1 weighs all alike, above 1 the last count most.
///
/// Written as powers over their sum it needs no case for 1, and takes 0^0 as 1. A `delta` that is NaN or
/// negative counts as 0, and `ke` below `kb` as `kb`.
#[must_use]
pub fn weights(delta: f64, kb: usize, ke: usize) -> Vec<f64> {
    let mut list = vec![0.0; ke.saturating_sub(kb) + 1];
    weigh(delta, &mut list);
    list
}

/// [`weights`] of as many terms as there is room for.
pub(crate) fn weigh(delta: f64, list: &mut [f64]) {
    // Above 1 the powers are counted from the other end, so that none overflows.
    let (ratio, from_end) = if delta > 1.0 { (1.0 / delta, true) } else { (delta.max(0.0), false) };
    let (mut power, mut sum) = (1.0, 0.0);
    for slot in &mut *list {
        *slot = power;
        sum += power;
        power *= ratio;
    }
    if from_end {
        list.reverse();
    }
    list.iter_mut().for_each(|weight| *weight /= sum);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn they_sum_to_one_and_keep_their_ratio(delta in 0.0..5.0_f64, kb in 0..6_usize, more in 0..40_usize) {
            let list = weights(delta, kb, kb + more);
            prop_assert_eq!(list.len(), more + 1);
            prop_assert!((list.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            for pair in list.windows(2) {
                prop_assert!((pair[1] - delta * pair[0]).abs() <= 1e-12 * pair[1].max(pair[0]));
            }
        }
    }

    #[test]
    fn bad_and_huge_ratios() {
        for delta in [f64::NAN, -1.0, f64::NEG_INFINITY, 0.0] {
            assert_eq!(weights(delta, 2, 4), [1.0, 0.0, 0.0]);
        }
        assert_eq!(weights(f64::INFINITY, 0, 2), [0.0, 0.0, 1.0]);
        assert_eq!(weights(1e308, 0, 300)[300], 1.0);
        assert_eq!(weights(0.5, 7, 3), [1.0]);
    }
}
