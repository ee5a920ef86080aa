//! Pieces of an attractor that lies on a line.

use std::cmp::Ordering;

use crate::connected::Address;

use super::entries::Field;
use super::points::Point;
use super::ring::{Element, is_zero, minus, plus};

impl Field {
    /// What [`Self::stays_on_line`] takes.
    pub fn cost_line(&self, [p, q, _]: &[Address; 3]) -> u64 {
        let ends = [p, q].map(|address| self.cost_point(address));
        let [(p, near), (q, far)] = ends;
        let ring = &self.ring;
        let along = near + far + ring.growth + 1;
        let images = ends.map(|(_, digits)| {
            let image = digits + self.letter;
            let step = near + image + ring.growth + 1;
            let product = 4 * ring.cost_product(digits, self.letter) + 4 * ring.cost_product(near, image);
            product.saturating_add(2 * ring.cost_product(along, step))
        });
        let images = (self.rows.len() as u64).saturating_mul(images[0].saturating_add(images[1]));
        let step = 4 * ring.cost_product(near, far) + 2 * ring.cost_sign(along);
        p.saturating_add(q).saturating_add(step).saturating_add(images)
    }

    /// What [`Self::is_between`] takes.
    pub fn cost_between(&self, addresses: &[Address; 3]) -> u64 {
        let [p, q, r] = addresses.each_ref().map(|address| self.cost_point(address));
        let ring = &self.ring;
        let step = |a: u64, b: u64| a + b + ring.growth + 1;
        let along = step(p.1, q.1);
        let steps = [(p.1, q.1), (p.1, r.1), (r.1, q.1)].map(|(a, b)| {
            let forward = 2 * ring.cost_product(along, step(a, b));
            let sign = ring.cost_sign(along + step(a, b) + ring.growth + 1);
            forward.saturating_add(sign).saturating_add(4 * ring.cost_product(a, b))
        });
        steps.into_iter().fold(p.0.saturating_add(q.0).saturating_add(r.0), u64::saturating_add)
    }

    /// As of doubles: whether two points differ, and every map takes the line through them into itself.
    pub fn stays_on_line(&self, [p, q, _]: &[Address; 3]) -> bool {
        let [p, q] = [p, q].map(|address| self.point(address));
        let along = self.step(&p, &q);
        let is_on = |point: &Point| {
            let [x, y] = self.step(&p, point);
            let ways = [self.ring.product(&along[0], &y), self.ring.product(&along[1], &x)];
            is_zero(&minus(&ways[0], &ways[1]))
        };
        let stays = |k: usize| [&p, &q].iter().all(|at| is_on(&self.image(k, at)));
        self.is_somewhere(&along) && (0..self.rows.len()).all(stays)
    }

    /// As of doubles: of three points on a line, whether the third lies between the first two, which differ; or is one
    /// of them.
    pub fn is_between(&self, addresses: &[Address; 3]) -> bool {
        let [p, q, r] = addresses.each_ref().map(|address| self.point(address));
        let along = self.step(&p, &q);
        let is_forward = |[x, y]: [Element; 2]| {
            let far = plus(&self.ring.product(&along[0], &x), &self.ring.product(&along[1], &y));
            matches!(self.ring.sign(&far), Some(Ordering::Equal | Ordering::Greater))
        };
        self.is_somewhere(&along) && is_forward(self.step(&p, &r)) && is_forward(self.step(&r, &q))
    }

    /// Whether a step is one, as numbers.
    fn is_somewhere(&self, step: &[Element; 2]) -> bool {
        step.iter().any(|x| matches!(self.ring.sign(x), Some(Ordering::Less | Ordering::Greater)))
    }
}
