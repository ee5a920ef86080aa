//! Whole boxes of parameters of the set M outside of it.
//!
//! The pieces of `s z - 1` and `s z + 1` are as far apart as twice the least `|f(s)|` of all power series
//! `f = 1 + a_1 z + a_2 z^2 + ..` with coefficients -1, 0 and 1. In a disc of radius h about c, whose points are no
//! farther than r < 1 from 0, those that begin with a polynomial p of degree n - 1 are
//!
//! ```text
//! |f(s)| >= |p(c)| - h |p'(c)| - h^2 / (1 - r)^3 - r^n / (1 - r)
//! ```
//!
//! since `|p''(s)| <= sum k (k - 1) r^(k - 2) = 2 / (1 - r)^3`. So a polynomial is split into the three that follow it
//! until that is as much as is to be shown.

use glam::DVec2;

/// Polynomials looked at for one box.
const MOST_LOOKS: usize = 400;
/// What rounding adds, at most, where `1 / (1 - r)` is 1.
const ROUNDING: f64 = 1e-14;

/// Memory for the search; kept for the next box.
#[derive(Clone, Debug, Default)]
pub(crate) struct PowerSeriesBoxes {
    open: Vec<Polynomial>,
    /// The powers of the middle, and their derivatives.
    powers: Vec<[DVec2; 2]>,
}

/// The value of a polynomial in the middle, its derivative there, how many coefficients it has, and how far all that
/// follows reaches.
#[derive(Clone, Copy, Debug)]
struct Polynomial {
    value: DVec2,
    slope: DVec2,
    count: usize,
    rest: f64,
}

impl PowerSeriesBoxes {
    /// Whether `|f(s)| >= least` for all series and all s within `radius` of `middle`.
    pub fn stay_away(&mut self, middle: DVec2, radius: f64, least: f64) -> bool {
        let farthest = middle.length() + radius;
        // NaN is refused, too.
        if !(farthest < 0.99 && least > 0.0) {
            return false;
        }
        let shrink = 1.0 / (1.0 - farthest);
        let bent = radius * radius * shrink * shrink * shrink + ROUNDING * shrink * shrink;
        self.powers.clear();
        self.powers.push([DVec2::X, DVec2::ZERO]);
        self.open.clear();
        self.open.push(Polynomial { value: DVec2::X, slope: DVec2::ZERO, count: 1, rest: farthest * shrink });
        for _ in 0..MOST_LOOKS {
            let Some(Polynomial { value, slope, count, rest }) = self.open.pop() else { return true };
            let away = value.length() - radius * slope.length() - bent;
            if away - rest >= least {
                continue;
            }
            // It is a series itself.
            if value.length() < least {
                return false;
            }
            let [power, steep] = self.power(middle, count);
            for sign in [-1.0, 0.0, 1.0] {
                let (value, slope) = (value + power * sign, slope + steep * sign);
                self.open.push(Polynomial { value, slope, count: count + 1, rest: rest * farthest });
            }
        }
        false
    }

    fn power(&mut self, middle: DVec2, k: usize) -> [DVec2; 2] {
        while self.powers.len() <= k {
            let [power, steep] = self.powers[self.powers.len() - 1];
            self.powers.push([times(middle, power), times(middle, steep) + power]);
        }
        self.powers[k]
    }
}

/// The product of two complex numbers.
fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

#[cfg(test)]
mod tests {
    use frond_core::hash;

    use super::*;

    #[test]
    fn no_series_comes_nearer_in_a_disc_than_is_said() {
        let unit = |seed: u32, k: u32| f64::from(hash::unit(hash::counter(seed, k)));
        let (mut boxes, mut shown, mut tight) = (PowerSeriesBoxes::default(), 0, 0);
        for seed in 0..600 {
            let middle = DVec2::from_angle(6.3 * unit(seed, 0)) * (0.2 + 0.45 * unit(seed, 1));
            let radius = 0.05 * unit(seed, 2).powi(2);
            let least = 0.6 * unit(seed, 3);
            if !boxes.stay_away(middle, radius, least) {
                continue;
            }
            shown += 1;
            for k in 0..20 {
                let s = middle + DVec2::from_angle(6.3 * unit(seed, 10 + k)) * radius;
                // A series that comes near: each coefficient as is best for the moment.
                let (mut value, mut power) = (DVec2::X, DVec2::X);
                for n in 0..80 {
                    power = times(power, s);
                    let all = [value, value + power, value - power];
                    let any = (unit(seed, 100 + 80 * k + n) * 3.0) as usize % 3;
                    let best =
                        all.into_iter().min_by(|a, b| a.length().total_cmp(&b.length())).expect("three");
                    value = if k % 4 == 0 { all[any] } else { best };
                }
                assert!(value.length() >= least, "{s} of {middle}, {radius}: {value} < {least}");
                tight += usize::from(value.length() < 1.3 * least);
            }
        }
        assert!(shown > 100 && tight > 50, "{shown} {tight}");
    }

    #[test]
    fn nothing_is_said_of_discs_that_meet_m_or_are_none() {
        let mut boxes = PowerSeriesBoxes::default();
        assert!(boxes.stay_away(DVec2::new(0.3, 0.3), 0.01, 1e-3));
        assert!(!boxes.stay_away(DVec2::new(0.49, 0.0), 0.02, 1e-9));
        assert!(!boxes.stay_away(DVec2::new(0.2, 0.67), 1e-9, 1e-9));
        for bad in [f64::NAN, f64::INFINITY, 2.0] {
            assert!(!boxes.stay_away(DVec2::new(0.1, 0.1), bad, 1e-9));
            assert!(!boxes.stay_away(DVec2::new(bad, 0.1), 0.01, 1e-9));
            assert!(!boxes.stay_away(DVec2::new(0.1, 0.1), 0.01, -bad));
        }
    }
}
