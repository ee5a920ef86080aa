//! Which map of space becomes which.

use crate::bounds::bounds3::Bounds3;
use crate::ifs::system::Ifs3;
use crate::linear::affine::Affine3;
use crate::morph::interpolation::Morph3;
use crate::morph::options::Kind;
use crate::morph::pairing::assignment;
use crate::morph::turn3::between;

impl Morph3 {
    /// Which map of `to` each map of `from` becomes so that pieces travel, turn and stretch least in all; in their own
    /// order where the numbers of maps differ.
    #[must_use]
    pub fn correspondence(from: &Ifs3, to: &Ifs3) -> Vec<usize> {
        if from.len() != to.len() {
            return (0..from.len()).collect();
        }
        let [a, b] = [from, to].map(Bounds3::of);
        let place = |bounds: &Bounds3, map: Affine3| {
            (map.apply(bounds.centre) - bounds.centre) / bounds.radius.max(f64::MIN_POSITIVE)
        };
        let cost = |x: Affine3, y: Affine3| {
            let (kind, turned, _) = between(x.linear, y.linear, 0);
            let travel = place(&a, x).distance_squared(place(&b, y));
            let turn = (turned.angle / std::f64::consts::PI).powi(2);
            let (s, t) = (x.singular_values(), y.singular_values());
            let stretch: f64 = (0..3).map(|k| (s[k] - t[k]).powi(2)).sum();
            let over = if kind == Kind::Opposite { 1.0 } else { 0.0 };
            let cost = travel + 0.25 * turn + 0.25 * stretch + over;
            if cost.is_finite() { cost.min(1e12) } else { 1e12 }
        };
        let table: Vec<Vec<f64>> =
            from.maps().iter().map(|&x| to.maps().iter().map(|&y| cost(x, y)).collect()).collect();
        assignment(&table)
    }
}
