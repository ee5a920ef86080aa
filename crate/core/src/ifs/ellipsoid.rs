//! The ellipsoid that all of some maps of space shrink.

use glam::{DMat3, DVec3};

use crate::hash;
use crate::linear::svd3::norm3;

/// Coordinates in which the maps shrink about as much as can be, and back: those of an ellipsoid, or as they are where
/// nothing is won that shows. `plain` is what the ball gives, and `least` a bound that no ellipsoid goes below.
pub(crate) fn best(linear: &[DMat3], plain: f64, least: f64) -> [DMat3; 2] {
    let found = Ellipsoid::best(linear, least);
    let factor = found.factor(linear);
    // The ball has no rounding errors of its own.
    let gains = 1.0 - factor > 1.5 * (1.0 - plain) && factor < 1.0 - 1e-9;
    let Ellipsoid { to, from } = if gains || plain >= 1.0 - 1e-9 { found } else { Ellipsoid::BALL };
    [to, from]
}

/// Coordinates in which an ellipsoid is the unit ball, and back.
#[derive(Clone, Copy, Debug)]
struct Ellipsoid {
    to: DMat3,
    from: DMat3,
}

/// Rounds of weighing the maps, and of trying nearby ellipsoids.
const WEIGHINGS: usize = 60;
const TRIES: u32 = 1500;

impl Ellipsoid {
    const BALL: Self = Self { to: DMat3::IDENTITY, from: DMat3::IDENTITY };

    fn norm(&self, m: DMat3) -> f64 {
        norm3(self.to * m * self.from)
    }

    fn factor(&self, linear: &[DMat3]) -> f64 {
        linear.iter().map(|&m| self.norm(m)).fold(0.0, f64::max)
    }

    /// The ellipsoid `x . P x = 1`; `None` where `P` is not definite enough.
    fn of(p: DMat3) -> Option<Self> {
        // Cholesky: P = R^T R, R upper triangular.
        let a = p.x_axis.x.sqrt();
        let (b, c) = (p.y_axis.x / a, p.z_axis.x / a);
        let d = (p.y_axis.y - b * b).sqrt();
        let e = (p.z_axis.y - b * c) / d;
        let f = (p.z_axis.z - c * c - e * e).sqrt();
        let to = DMat3::from_cols(DVec3::new(a, 0.0, 0.0), DVec3::new(b, d, 0.0), DVec3::new(c, e, f));
        let from = to.inverse();
        let fits = to.is_finite() && from.is_finite() && a.min(d).min(f) > 1e-7 * a.max(d).max(f);
        fits.then_some(Self { to, from })
    }

    /// An ellipsoid whose largest shrunk image is about as small as can be; `least` is a bound that none goes below.
    ///
    /// First `P` is a weighted sum of the images of itself under `P -> M^T P M / f^2`, as in Lyapunov's equation, with
    /// more weight on maps that stretch more. What comes of it is improved by random steps, which need no derivative
    /// where the largest of many norms has none.
    fn best(linear: &[DMat3], least: f64) -> Self {
        let mut best = (Self::BALL.factor(linear), Self::BALL);
        for slack in [1.02, 1.2, 2.0] {
            let scale = 1.0 / (slack * least.max(1e-3)).powi(2);
            let mut weights = vec![1.0 / linear.len() as f64; linear.len()];
            let mut p = DMat3::IDENTITY;
            for round in 0..WEIGHINGS {
                let mut next = DMat3::IDENTITY * 1e-3;
                for (&m, weight) in linear.iter().zip(&weights) {
                    next += m.transpose() * p * m * (weight * scale);
                }
                let size = (next.x_axis.x + next.y_axis.y + next.z_axis.z) / 3.0;
                p = p * 0.3 + next * (0.7 / size);
                let Some(tried) = Self::of(p) else { break };
                let norms: Vec<f64> = linear.iter().map(|&m| tried.norm(m)).collect();
                let factor = norms.iter().copied().fold(0.0, f64::max);
                if factor < best.0 {
                    best = (factor, tried);
                }
                let keen = 2.0 + round as f64 / 4.0;
                let raised: Vec<f64> =
                    norms.iter().zip(&weights).map(|(n, w)| w.sqrt() * (n / factor).powf(keen)).collect();
                let sum: f64 = raised.iter().sum();
                weights = raised.iter().map(|w| w / sum + 1e-4).collect();
            }
        }
        // Steps in the six numbers of the triangle, in coordinates where the best so far is round.
        let mut reach = 0.5_f64;
        for i in 0..TRIES {
            if best.0 <= least * (1.0 + 1e-6) || best.0 < 0.9 || reach < 1e-7 {
                break;
            }
            let random = |k: u32| {
                let u = |j| f64::from(hash::unit(hash::counter(17, 24 * i + 4 * k + j)));
                u(0) + u(1) + u(2) + u(3) - 2.0
            };
            let step = DMat3::from_cols(
                DVec3::new((reach * random(0)).exp(), 0.0, 0.0),
                DVec3::new(reach * random(1), (reach * random(2)).exp(), 0.0),
                DVec3::new(reach * random(3), reach * random(4), (reach * random(5)).exp()),
            );
            let to = step * best.1.to;
            let tried = Self { to, from: to.inverse() };
            let factor = tried.factor(linear);
            let thin = norm3(to) * norm3(tried.from) > 1e7;
            if factor < best.0 && !thin {
                best = (factor, tried);
                reach = (reach * 1.5).min(0.5);
            } else {
                reach *= 0.985;
            }
        }
        best.1
    }
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::{Affine3, Contraction3, IfsError};

    fn similitude(scale: f64, axis: DVec3, angle: f64, at: DVec3) -> Affine3 {
        Affine3::similitude(scale, DQuat::from_axis_angle(axis.normalize(), angle), at)
    }

    fn holds(found: &Contraction3, maps: &[Affine3]) {
        // The ball holds the fixed points of all maps and of all words of two letters.
        let words = maps.iter().flat_map(|&a| maps.iter().map(move |&b| a * b)).chain(maps.iter().copied());
        for word in words {
            let fixed = word.fixed_point().unwrap();
            let away = (found.to_round * (fixed - found.centre)).length();
            assert!(away <= found.radius * (1.0 + 1e-9), "{away} {}", found.radius);
        }
    }

    #[test]
    fn plain_contractions_need_no_other_coordinates() {
        let maps = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|t| similitude(0.5, DVec3::X, 0.0, t));
        let found = Contraction3::find(&maps).unwrap();
        assert_eq!((found.factor, found.length, found.to_round), (0.5, 1, DMat3::IDENTITY));
        holds(&found, &maps);
    }

    #[test]
    fn sheared_maps_of_a_large_norm_contract_in_an_ellipsoid() {
        let shear = Affine3::shear([40.0, 5.0, 0.0, 20.0, 0.0, 0.0]);
        let axes = [DVec3::X, DVec3::new(1.0, 1.0, 0.3), DVec3::Z, DVec3::new(0.2, 1.0, -1.0)];
        let maps = axes.map(|axis| similitude(0.6, axis, 2.0, axis).conjugate(shear).unwrap());
        assert!(maps.iter().any(|map| norm3(map.linear) > 7.0));
        let found = Contraction3::find(&maps).unwrap();
        assert_eq!(found.length, 1);
        assert!(found.factor < 0.95, "{}", found.factor);
        holds(&found, &maps);
    }

    #[test]
    fn contractive_only_in_longer_words() {
        let a = Affine3::from_row([0.0, 1.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([0.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.0, 0.0, 0.3, 1.0, 1.0, 0.0]);
        let found = Contraction3::find(&[a, b]).unwrap();
        assert!(found.factor < 1.0 && found.radius.is_finite());
        // a b has the spectral radius (0.65 golden ratio)^2 = 1.106.
        let k = 0.65;
        let a = Affine3::from_row([k, k, 0.0, 0.0, k, 0.0, 0.0, 0.0, k, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([k, 0.0, 0.0, k, k, 0.0, 0.0, 0.0, k, 1.0, 0.0, 0.0]);
        let error = Contraction3::find(&[a, b]).unwrap_err();
        assert_eq!(error.code(), "no-attractor", "{error}");
        let k = 0.6;
        let a = Affine3::from_row([k, k, 0.0, 0.0, k, 0.0, 0.0, 0.0, k, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([k, 0.0, 0.0, k, k, 0.0, 0.0, 0.0, k, 1.0, 0.0, 0.0]);
        assert!(Contraction3::find(&[a, b]).unwrap().factor < 1.0);
    }

    #[test]
    fn a_short_word_that_does_not_contract_is_met_before_long_ones_are_followed() {
        let k = 0.65;
        let a = Affine3::from_row([k, k, 0.0, 0.0, k, 0.0, 0.0, 0.0, k, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([k, 0.0, 0.0, k, k, 0.0, 0.0, 0.0, k, 1.0, 0.0, 0.0]);
        let slow = similitude(0.9999, DVec3::X, 0.0, DVec3::Y);
        for maps in [[a, slow, b], [slow, a, b], [a, b, slow]] {
            let error = Contraction3::find(&maps).unwrap_err();
            assert_eq!(error.code(), "no-attractor", "{error}");
        }
    }

    #[test]
    fn expanding_and_neutral_maps_are_refused() {
        for map in [
            similitude(1.0, DVec3::X, 0.0, DVec3::X),
            similitude(1.0, DVec3::ONE, 1.0, DVec3::X),
            Affine3::scaling(DVec3::new(0.5, 0.5, 1.5)),
        ] {
            let error = Contraction3::find(&[map, similitude(0.5, DVec3::X, 0.0, DVec3::Y)]).unwrap_err();
            assert_eq!(error.code(), "no-attractor", "{error}");
        }
    }

    #[test]
    fn bad_lists_are_refused() {
        assert_eq!(Contraction3::find(&[]), Err(IfsError::NoMaps));
        let half = similitude(0.5, DVec3::X, 0.0, DVec3::Y);
        assert_eq!(
            Contraction3::find(&vec![half; 1_000_000]),
            Err(IfsError::TooManyMaps { count: 1_000_000 })
        );
        for bad in [f64::NAN, f64::INFINITY, 1e200] {
            let maps = [half, Affine3::moving(DVec3::splat(bad))];
            assert_eq!(Contraction3::find(&maps), Err(IfsError::NotFinite { map: 1 }));
        }
        let point = Affine3::new(DMat3::ZERO, DVec3::new(1.0, 2.0, 3.0));
        let found = Contraction3::find(&[point]).unwrap();
        assert_eq!((found.centre, found.radius), (DVec3::new(1.0, 2.0, 3.0), 0.0));
    }
}
