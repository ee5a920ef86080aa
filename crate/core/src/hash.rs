//! Random numbers that are the same in Rust and in WGSL.
//!
//! There is no state to carry: the i-th number of a seed is a function of both, so any part of a
//! sequence can be made anywhere, in any order.

/// Mixes the bits of a number (the output permutation of a permuted congruential generator, on the
/// state after one step).
#[inline]
#[must_use]
pub const fn pcg(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// The `i`-th random number of a seed.
#[inline]
#[must_use]
pub const fn counter(seed: u32, i: u32) -> u32 {
    pcg(i ^ pcg(seed))
}

/// A number in [0, 1) from the upper 24 bits of `bits`, exact in `f32`.
#[inline]
#[must_use]
pub fn unit(bits: u32) -> f32 {
    #[expect(clippy::cast_precision_loss, reason = "24 bits fit an f32")]
    let whole = (bits >> 8) as f32;
    whole * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sequence_is_fixed_for_good() {
        // Links and pictures depend on these numbers: they must never change.
        assert_eq!([pcg(0), pcg(1), pcg(u32::MAX)], [129_708_002, 2_831_084_092, 3_861_530_882]);
        assert_ne!(counter(1, 7), counter(2, 7));
    }

    #[test]
    fn units_are_spread_evenly() {
        let mut bins = [0_u32; 16];
        for i in 0..16_000 {
            bins[(unit(counter(3, i)) * 16.0) as usize] += 1;
        }
        assert!(bins.iter().all(|&n| (900..1100).contains(&n)), "{bins:?}");
    }
}
