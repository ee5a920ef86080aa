//! Pieces of an attractor that lies on a line.

use num_bigint::BigInt;

use crate::common_point::Point;
use crate::connected::Address;
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::work::product;

impl Scene<'_> {
    /// What [`Self::stays_on_line`] takes.
    pub fn cost_line(&self, addresses: &[Address; 3]) -> u64 {
        if let Some((field, _)) = &self.exact {
            return field.cost_line(addresses);
        }
        let [p, q, _] = addresses;
        let ends = [p, q].map(|address| self.cost_point(address));
        let [(p, near), (q, far)] = ends;
        let images = ends.map(|(_, digits)| {
            let image = digits + 2 * self.letter;
            8 * product(digits, self.letter)
                + 4 * product(near, image)
                + 2 * product(near + far, near + image)
        });
        let images = (self.maps.rows.len() as u64).saturating_mul(images[0].saturating_add(images[1]));
        p.saturating_add(q).saturating_add(4 * product(near, far)).saturating_add(images)
    }

    /// What [`Self::is_between`] takes.
    pub fn cost_between(&self, addresses: &[Address; 3]) -> u64 {
        if let Some((field, _)) = &self.exact {
            return field.cost_between(addresses);
        }
        let [p, q, r] = addresses.each_ref().map(|address| self.cost_point(address));
        let steps = 4 * product(p.1, q.1) + 4 * product(p.1, r.1) + 4 * product(r.1, q.1);
        let ways = 2 * product(p.1 + q.1, p.1 + r.1) + 2 * product(p.1 + q.1, r.1 + q.1);
        p.0.saturating_add(q.0).saturating_add(r.0).saturating_add(steps).saturating_add(ways)
    }

    /// Whether two points differ, and every map takes the line through them into itself: then the attractor, which is
    /// in every closed set that they take into itself and that is not empty, lies on this line.
    pub fn stays_on_line(&self, addresses: &[Address; 3]) -> Result<bool, Refused> {
        self.work.spend(self.cost_line(addresses))?;
        if let Some((field, _)) = &self.exact {
            return Ok(field.stays_on_line(addresses));
        }
        let [p, q, _] = addresses;
        let [p, q] = [p, q].map(|address| self.point(address));
        let along = p.step_to(&q);
        let is_on = |point: &Point| is_zero(&cross(&along, &p.step_to(point)));
        let letters = 0..self.maps.rows.len();
        let stays = |k: usize| [&p, &q].iter().all(|at| is_on(&self.image(k, at)));
        Ok(!along.iter().all(is_zero) && letters.into_iter().all(stays))
    }

    /// Of three points on a line, whether the third lies between the first two, which differ; or is one of them.
    pub fn is_between(&self, addresses: &[Address; 3]) -> Result<bool, Refused> {
        self.work.spend(self.cost_between(addresses))?;
        if let Some((field, _)) = &self.exact {
            return Ok(field.is_between(addresses));
        }
        let [p, q, r] = addresses.each_ref().map(|address| self.point(address));
        let along = p.step_to(&q);
        let is_forward = |step: [BigInt; 2]| &along[0] * &step[0] + &along[1] * &step[1] >= BigInt::ZERO;
        Ok(!along.iter().all(is_zero) && is_forward(p.step_to(&r)) && is_forward(r.step_to(&q)))
    }
}

fn is_zero(x: &BigInt) -> bool {
    *x == BigInt::ZERO
}

fn cross(a: &[BigInt; 2], b: &[BigInt; 2]) -> BigInt {
    &a[0] * &b[1] - &a[1] * &b[0]
}
