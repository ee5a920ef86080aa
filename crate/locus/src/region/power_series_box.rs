//! Whole boxes of parameters of the set M outside of it.
//!
//! The pieces of `s z - 1` and `s z + 1` are as far apart as twice the least `|f(s)|` of all power series
//! `f = 1 + a_1 z + a_2 z^2 + ..` with coefficients -1, 0 and 1. In a disc of radius h about c, whose points are no
//! farther than r < 1 from 0,
//!
//! ```text
//! |f(s)| >= |f(c)| - h |f'(c)| - h^2 / (1 - r)^3,
//! ```
//!
//! since `|f''(s)| <= sum k (k - 1) r^(k - 2) = 2 / (1 - r)^3`. Of those that begin with a polynomial p of degree
//! n - 1, `|f'(c)| <= |p'(c)| + sum k |c|^(k - 1)`, k = n, n + 1, .., and where `f(c)` lies, [`ComplexSeries`]
//! knows. So a polynomial is split into the three that follow it until that is as much as is to be shown.

use glam::DVec2;

use crate::gap::complex_series::{ComplexSeries, times};

/// Polynomials looked at for one box: where that is not enough, its quarters take less.
const MOST_LOOKS: usize = 100;
/// What rounding adds, at most, where `1 / (1 - r)` is 1.
const ROUNDING: f64 = 1e-14;

/// Memory for the search; kept for the next box.
#[derive(Clone, Debug, Default)]
pub(crate) struct PowerSeriesBoxes {
    series: ComplexSeries,
    open: Vec<Polynomial>,
}

/// The rest of a polynomial in the middle, its derivative there, how much both are magnified, and how many coefficients
/// it has.
#[derive(Clone, Copy, Debug)]
struct Polynomial {
    rest: DVec2,
    slope: DVec2,
    growth: f64,
    count: f64,
}

impl PowerSeriesBoxes {
    /// Whether `|f(s)| >= least` for all series and all s within `radius` of `middle`.
    pub fn stay_away(&mut self, middle: DVec2, radius: f64, least: f64) -> bool {
        let Self { series, open } = self;
        let (near, farthest) = (middle.length(), middle.length() + radius);
        // NaN is refused, too.
        if !(farthest < 0.99 && least > 0.0 && series.begin(middle)) {
            return false;
        }
        series.measure();
        let (inner, shrink) = (1.0 / (1.0 - near), 1.0 / (1.0 - farthest));
        let bent = radius * radius * shrink * shrink * shrink + ROUNDING * shrink * shrink;
        let back = series.back();
        open.clear();
        open.push(Polynomial { rest: DVec2::X, slope: DVec2::ZERO, growth: 1.0, count: 1.0 });
        for _ in 0..MOST_LOOKS {
            let Some(Polynomial { rest, slope, growth, count }) = open.pop() else { return true };
            // It is a series itself.
            if rest.length() < least * growth {
                return false;
            }
            let growth = growth / near;
            let (before, coefficients) = series.step(rest);
            let (slope, steeper) = (times(slope, back), back * count);
            // Of all that follows.
            let beyond = (count + 1.0 - count * near) * inner * inner;
            for a in coefficients {
                let (rest, slope) = (DVec2::new(before.x + a, before.y), slope + steeper * a);
                let room = (least + bent) * growth + radius * (slope.length() + beyond);
                if series.leads_within(rest, room) {
                    open.push(Polynomial { rest, slope, growth, count: count + 1.0 });
                }
            }
        }
        false
    }
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
    fn series_bend_in_a_wide_disc() {
        let mut boxes = PowerSeriesBoxes::default();
        for up in [0.01, 0.05] {
            let (middle, radius) = (DVec2::new(0.3, up), 0.05);
            // 1 - s - s^2 - .. falls ever faster towards 1.
            let s = middle + DVec2::new(radius, 0.0);
            let value = (DVec2::new(1.0 - 2.0 * s.x, -2.0 * s.y) / (DVec2::X - s).length()).length();
            assert!(boxes.stay_away(middle, radius, 0.97 * value), "{up}: {value}");
            assert!(!boxes.stay_away(middle, radius, 1.001 * value), "{up}: {value}");
        }
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
