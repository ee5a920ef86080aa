//! Points with two addresses.

use num_bigint::BigInt;

use crate::connected::Address;

use super::entries::Field;
use super::ring::{Element, is_zero, minus, plus, times};

/// A point of the plane: two elements over a third, which is a positive number.
///
/// For an address it is `|1 - M|`, but for powers of the scale, where M is the linear part of a map that contracts: its
/// eigenvalues are less than 1 in magnitude, so that the product of `1 - l` over both is positive.
pub(crate) struct Point {
    over: [Element; 2],
    under: Element,
}

impl Field {
    /// What it takes to find the point of an address, and the binary digits of its numbers.
    pub fn cost_point(&self, Address { head, repeat }: &Address) -> (u64, u64) {
        let [head, repeat] = [head.len(), repeat.len()].map(|letters| letters as u64);
        let [once, round] = [head, repeat].map(|letters| letters * self.letter);
        let fixed = 2 * round + self.ring.growth + 3;
        let maps = [(head, once), (repeat, round)].map(|(letters, end)| {
            letters.saturating_mul(10).saturating_mul(self.ring.cost_product(end, self.letter))
        });
        let point = 6 * self.ring.cost_product(round, round) + 6 * self.ring.cost_product(once, fixed);
        (maps[0].saturating_add(maps[1]).saturating_add(point), once + fixed + self.ring.growth + 2)
    }

    /// What [`Self::coincide`] takes.
    pub fn cost_coincide(&self, addresses: &[Address; 2]) -> u64 {
        let [a, b] = addresses.each_ref().map(|address| self.cost_point(address));
        a.0.saturating_add(b.0).saturating_add(4 * self.ring.cost_product(a.1, b.1))
    }

    /// Whether two addresses are of one point. Letters are known to be maps, and those that repeat to contract.
    ///
    /// Elements that are equal are equal numbers. What both points are over is not 0, as a number.
    pub fn coincide(&self, addresses: &[Address; 2]) -> bool {
        let [a, b] = addresses.each_ref().map(|address| self.point(address));
        self.step(&a, &b).iter().all(is_zero)
    }

    /// Two products and a third number.
    fn combined(&self, [a, b]: [&Element; 2], [c, d]: [&Element; 2], rest: &Element) -> Element {
        plus(&plus(&self.ring.product(a, b), &self.ring.product(c, d)), rest)
    }

    /// The map of a word, times the power of the scale that has as many letters.
    fn word(&self, word: &[u8]) -> ([Element; 6], BigInt) {
        let none = self.ring.whole(BigInt::ZERO);
        let unit = |k: usize| self.ring.whole(BigInt::from(u8::from(k == 0 || k == 3)));
        let (mut row, mut scale): ([Element; 6], _) = (std::array::from_fn(unit), BigInt::from(1));
        for &letter in word {
            let [p, q, r, s, t, u] = &self.rows[usize::from(letter)];
            let [a, b, c, d, e, f] = &row;
            row = [
                self.combined([a, p], [b, r], &none),
                self.combined([a, q], [b, s], &none),
                self.combined([c, p], [d, r], &none),
                self.combined([c, q], [d, s], &none),
                self.combined([a, t], [b, u], &times(e, &self.scale)),
                self.combined([c, t], [d, u], &times(f, &self.scale)),
            ];
            scale *= &self.scale;
        }
        (row, scale)
    }

    /// The step from a point to another, but for a positive factor.
    pub fn step(&self, from: &Point, to: &Point) -> [Element; 2] {
        [0, 1].map(|k| {
            minus(&self.ring.product(&to.over[k], &from.under), &self.ring.product(&from.over[k], &to.under))
        })
    }

    /// The image of a point under a map.
    pub fn image(&self, letter: usize, at: &Point) -> Point {
        let [a, b, c, d, e, f] = &self.rows[letter];
        let ([x, y], under) = (&at.over, &at.under);
        let over = [
            self.combined([a, x], [b, y], &self.ring.product(e, under)),
            self.combined([c, x], [d, y], &self.ring.product(f, under)),
        ];
        Point { over, under: times(under, &self.scale) }
    }

    /// The point of an address, as the one of doubles is found. Letters are known to be maps, and those that repeat to
    /// contract.
    pub fn point(&self, address: &Address) -> Point {
        let none = self.ring.whole(BigInt::ZERO);
        let ([a, b, c, d, e, f], scale) = self.word(&address.repeat);
        let one = self.ring.whole(scale);
        let (a, d) = (minus(&one, &a), minus(&one, &d));
        let [x, y] = [self.combined([&d, &e], [&b, &f], &none), self.combined([&c, &e], [&a, &f], &none)];
        let under = minus(&self.ring.product(&a, &d), &self.ring.product(&b, &c));
        let ([a, b, c, d, e, f], scale) = self.word(&address.head);
        let over = [
            self.combined([&a, &x], [&b, &y], &self.ring.product(&e, &under)),
            self.combined([&c, &x], [&d, &y], &self.ring.product(&f, &under)),
        ];
        Point { over, under: times(&under, &scale) }
    }
}
