//! From coverage and density to alpha: the CPU twin of `shader/tone.wgsl`.

/// The alpha of a pixel of which the part `coverage` (0 to 1) is lit.
///
/// A curve that bulges, so that a line thinner than a pixel stays visible: a quarter counts as 0.44.
#[must_use]
pub fn cover(coverage: f32) -> f32 {
    coverage * (2.0 - coverage)
}

/// How much is made of thin mist: the slope at density 0.
const SLOPE_AT_ZERO: f32 = 12.0;
/// The density, in multiples of the mean over the lit pixels, that is as bright as can be.
const WHITE_DENSITY: f32 = 4.0;

/// The alpha of a pixel of a density, 1 being the mean over the lit pixels: its logarithm, since a
/// measure of this kind varies by orders of magnitude.
#[must_use]
pub fn tone(density: f32) -> f32 {
    let value = (1.0 + SLOPE_AT_ZERO * density).log2() / (1.0 + SLOPE_AT_ZERO * WHITE_DENSITY).log2();
    value.clamp(0.0, 1.0)
}

/// How much the colour of a density is lightened: nothing up to the middle tones.
#[must_use]
pub fn glow(tone: f32) -> f32 {
    let over = (tone - 0.75).max(0.0);
    over * over * 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_rises_from_nothing_to_all_and_favours_thin_lines() {
        assert_eq!((cover(0.0), cover(1.0)), (0.0, 1.0));
        for quarter in 1..4 {
            let coverage = quarter as f32 / 4.0;
            assert!(cover(coverage) > coverage);
        }
    }

    #[test]
    fn tones_rise_with_density_and_stay_within_bounds() {
        let densities = [0.0, 1e-6, 1e-3, 0.1, 1.0, 3.0, WHITE_DENSITY, 1e9, f32::INFINITY];
        let tones = densities.map(tone);
        assert!(tones.is_sorted() && tones[0] == 0.0 && tones[8] == 1.0, "{tones:?}");
        assert!(tone(1.0) > 0.5 && tone(1.0) < 0.75, "the mean is a middle tone");
        assert!(tones.iter().all(|t| (0.0..=0.5).contains(&glow(*t))));
    }
}
