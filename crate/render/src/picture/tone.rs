//! From coverage and density to alpha: the CPU twin of `shader/tone.wgsl`.

/// The alpha of a pixel of which the part `coverage` (0 to 1) is lit.
///
/// A curve that bulges, so that a line thinner than a pixel stays visible: a quarter counts as 0.44.
#[must_use]
pub fn cover(coverage: f32) -> f32 {
    coverage * (2.0 - coverage)
}

/// How the densities of a picture become tones: with a measure of this kind they vary by orders of magnitude in one
/// shape, and by a third in another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tone {
    /// The mass of a pixel that is a middle tone.
    pub middle: f64,
    /// How steep tones are there.
    pub slope: f32,
}

/// Within so many deviations from the middle, tones are told apart.
const DEVIATIONS: f64 = 1.5;
/// How steep tones are: enough to see what there is to be seen, and not so much that chance is.
const SLOPES: (f64, f64) = (0.6, 1.8);

impl Tone {
    /// The tone for logarithms of masses of such a mean and deviation.
    #[must_use]
    pub fn of(mean: f64, deviation: f64) -> Self {
        let slope = (DEVIATIONS / deviation.max(f64::MIN_POSITIVE)).clamp(SLOPES.0, SLOPES.1);
        Self { middle: (mean * std::f64::consts::LOG2_E).exp2(), slope: slope as f32 }
    }
}

/// Larger densities are no denser to the eye, and stay within what can be computed.
const MOST: f32 = 1e6;
/// The odds of a middle tone.
const MIDDLE: f32 = 1.25;
/// How much is made of thin mist.
const MIST: f32 = 300.0;
/// The logarithm to the base of 2 of 1 + [`MIST`].
const MOST_MIST: f32 = 8.233_62;
/// The part of alpha that mist may have.
const MIST_PART: f32 = 0.4;
/// Where alpha is all that it can be, and where light begins.
const FULL: f32 = 0.62;
const LIGHT_FROM: f32 = 0.45;
/// How much light there is at most.
const MOST_LIGHT: f32 = 0.8;

/// Where a density, in multiples of that of a middle tone, lies between none and all: its logarithm, levelled off at
/// both ends. The response of a receptor by Naka and Rushton (1966), as Reinhard and Devlin (2005) use it for pictures.
#[must_use]
pub fn respond(density: f32, slope: f32) -> f32 {
    // In double precision: what the first module has for other ends.
    let power = f64::from(slope) * f64::from(density.clamp(0.0, MOST)).log2();
    let odds = MIDDLE * power.exp2() as f32;
    odds / (1.0 + odds)
}

/// The alpha of a pixel of a density. What is thin is seen, however dense all else may be.
#[must_use]
pub fn tone(density: f32, response: f32) -> f32 {
    let mist = f64::from(1.0 + MIST * density.clamp(0.0, MOST)).log2() as f32 / MOST_MIST;
    MIST_PART * mist.min(1.0) + (1.0 - MIST_PART) * (response / FULL).min(1.0)
}

/// How far the colour of a density is moved away from the ground: nothing up to the middle tones.
#[must_use]
pub fn glow(response: f32) -> f32 {
    let over = ((response - LIGHT_FROM) / (1.0 - LIGHT_FROM)).max(0.0);
    MOST_LIGHT * over * (0.6 + 0.4 * over)
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
        let densities = [0.0, 1e-6, 1e-3, 0.1, 1.0, 3.0, 4.0, 1e9, f32::INFINITY];
        for slope in [0.6, 1.0, 2.0] {
            let responses = densities.map(|density| respond(density, slope));
            let tones: Vec<_> = densities.iter().zip(responses).map(|(d, r)| tone(*d, r)).collect();
            let glows = responses.map(glow);
            assert!(tones.is_sorted() && tones[0] == 0.0 && tones[8] == 1.0, "{tones:?}");
            assert!(glows.is_sorted() && glows[0] == 0.0 && glows[8] <= MOST_LIGHT, "{glows:?}");
            assert!(tones[4] > 0.85, "a middle density has the colour of its piece");
            assert!(glows[4] < 0.2, "and no other");
        }
    }

    #[test]
    fn what_varies_little_is_told_apart_and_what_varies_much_is_not_lost() {
        // A deviation below and above the mean, as the eye sees them: light and alpha.
        let seen = |tone_of: Tone, log: f64| {
            let density = (log.exp() / tone_of.middle) as f32;
            let response = respond(density, tone_of.slope);
            tone(density, response) + glow(response)
        };
        for deviation in [0.4, 0.7, 1.4, 2.0] {
            let tone_of = Tone::of(-9.0, deviation);
            let apart = seen(tone_of, -9.0 + deviation) - seen(tone_of, -9.0 - deviation);
            assert!(apart > 0.5, "{deviation}: {apart}");
        }
        // What is even has no deviation but that of chance.
        let even = Tone::of(-9.0, 0.0);
        assert!((seen(even, -8.9) - seen(even, -9.1)).abs() < 0.2);
    }
}
