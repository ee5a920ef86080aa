//! Pieces of an attractor that lies on a line.

use num_bigint::BigInt;

use crate::common_point::Point;
use crate::connected::Address;
use crate::polygon::Scene;

impl Scene {
    /// Whether two points differ, and every map takes the line through them into itself: then the attractor, which is
    /// in every closed set that they take into itself and that is not empty, lies on this line.
    pub fn stays_on_line(&self, [p, q, _]: &[Address; 3]) -> bool {
        let [p, q] = [p, q].map(|address| self.point(address));
        let along = p.step_to(&q);
        let is_on = |point: &Point| is_zero(&cross(&along, &p.step_to(point)));
        let letters = 0..self.maps.rows.len();
        !along.iter().all(is_zero)
            && letters.into_iter().all(|k| [&p, &q].iter().all(|at| is_on(&self.image(k, at))))
    }

    /// Of three points on a line, whether the third lies between the first two, which differ; or is one of them.
    pub fn is_between(&self, addresses: &[Address; 3]) -> bool {
        let [p, q, r] = addresses.each_ref().map(|address| self.point(address));
        let along = p.step_to(&q);
        let is_forward = |step: [BigInt; 2]| &along[0] * &step[0] + &along[1] * &step[1] >= BigInt::ZERO;
        !along.iter().all(is_zero) && is_forward(p.step_to(&r)) && is_forward(r.step_to(&q))
    }
}

fn is_zero(x: &BigInt) -> bool {
    *x == BigInt::ZERO
}

fn cross(a: &[BigInt; 2], b: &[BigInt; 2]) -> BigInt {
    &a[0] * &b[1] - &a[1] * &b[0]
}
