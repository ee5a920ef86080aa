//! Half floats.

/// The bits of the half float (IEEE 754 binary16) nearest to a number that is not negative; those too large
/// become the largest, 65504, and what is no number becomes 0.
#[must_use]
pub fn to_half(x: f32) -> u16 {
    const LARGEST: f32 = 65504.0;
    // Below the smallest normal number, 2^-14, halves are evenly spaced by 2^-24.
    const SMALLEST: f32 = 1.0 / 16384.0;
    const STEPS: f32 = 16_777_216.0;
    if x >= LARGEST {
        return 0x7bff;
    }
    if x >= SMALLEST {
        let bits = x.to_bits();
        // Half of the last place that is kept, less one where that place is even: ties go to even.
        let rounded = bits + 0x0fff + ((bits >> 13) & 1);
        return ((rounded >> 13) - ((127 - 15) << 10)) as u16;
    }
    // The cast takes NaN and negative numbers to 0.
    (x * STEPS).round_ties_even() as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a half float stands for.
    fn of_half(bits: u16) -> f32 {
        let (exponent, fraction) = (i32::from(bits >> 10), f32::from(bits & 0x3ff));
        if exponent == 0 {
            fraction / 16_777_216.0
        } else {
            (1.0 + fraction / 1024.0) * 2.0_f32.powi(exponent - 15)
        }
    }

    #[test]
    fn every_half_float_stays_itself_and_others_go_to_the_nearest() {
        for bits in 0..0x7bff_u16 {
            let (x, next) = (of_half(bits), of_half(bits + 1));
            assert_eq!(to_half(x), bits);
            assert_eq!(to_half(x + (next - x) * 0.49), bits, "{x}");
            assert_eq!(to_half(x + (next - x) * 0.51), bits + 1, "{x}");
            assert_eq!(to_half(x + (next - x) * 0.5) & 1, 0, "{x}: ties go to even");
        }
    }

    #[test]
    fn what_has_no_half_float_gets_one() {
        assert_eq!([0.0, -1.0, f32::NAN, 1e-10].map(to_half), [0; 4]);
        assert_eq!([65504.0, 1e9, f32::INFINITY].map(to_half), [0x7bff; 3]);
    }
}
