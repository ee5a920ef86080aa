//! Points with two addresses.

use num_bigint::BigInt;

use crate::connected::Address;
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::work::product;

/// An affine map: its row as whole numbers times `2^-bits`.
struct Map {
    row: [BigInt; 6],
    bits: u64,
}

/// A point of the plane: two whole numbers over a third.
pub(crate) struct Point {
    over: [BigInt; 2],
    under: BigInt,
}

impl Point {
    /// The step from here to another point, but for a positive factor.
    pub fn step_to(&self, other: &Self) -> [BigInt; 2] {
        let step = |k: usize| &other.over[k] * &self.under - &self.over[k] * &other.under;
        // Both are positive for words that contract; nothing hangs on that here.
        let turned = (self.under < BigInt::ZERO) != (other.under < BigInt::ZERO);
        [0, 1].map(|k| if turned { -step(k) } else { step(k) })
    }
}

impl Scene<'_> {
    /// What it takes to find the point of an address, and the binary digits of its numbers.
    pub fn cost_point(&self, Address { head, repeat }: &Address) -> (u64, u64) {
        let [head, repeat] = [head.len(), repeat.len()].map(|letters| letters as u64);
        let [once, round] = [head, repeat].map(|letters| letters * self.letter);
        // A product of maps for each letter; the point that repeats, and where the head takes it.
        let maps = [(head, once), (repeat, round)]
            .map(|(letters, end)| letters.saturating_mul(10 * product(end, self.letter)));
        let point = 8 * product(round, round) + 8 * product(once, 2 * round);
        (maps[0].saturating_add(maps[1]).saturating_add(point), once + 2 * round)
    }

    /// What [`Self::coincide`] takes.
    pub fn cost_coincide(&self, addresses: &[Address; 2]) -> u64 {
        if let Some((field, _)) = &self.exact {
            return field.cost_coincide(addresses);
        }
        let [a, b] = addresses.each_ref().map(|address| self.cost_point(address));
        a.0.saturating_add(b.0).saturating_add(4 * product(a.1, b.1))
    }

    /// Whether two addresses are of one point. Letters are known to be maps, and those that repeat to contract.
    pub fn coincide(&self, addresses: &[Address; 2]) -> Result<bool, Refused> {
        self.work.spend(self.cost_coincide(addresses))?;
        if let Some((field, _)) = &self.exact {
            return Ok(field.coincide(addresses));
        }
        let [a, b] = addresses.each_ref().map(|address| self.point(address));
        Ok((0..2).all(|k| &a.over[k] * &b.under == &b.over[k] * &a.under))
    }

    fn word(&self, word: &[u8]) -> Map {
        let unit = |k| BigInt::from(u8::from(k == 0 || k == 3));
        let mut whole = Map { row: std::array::from_fn(unit), bits: 0 };
        for &letter in word {
            let [p, q, r, s, t, u] = &self.maps.rows[usize::from(letter)];
            let [a, b, c, d, e, f] = &whole.row;
            let row = [
                a * p + b * r,
                a * q + b * s,
                c * p + d * r,
                c * q + d * s,
                a * t + b * u + (e << self.maps.bits),
                c * t + d * u + (f << self.maps.bits),
            ];
            whole = Map { row, bits: whole.bits + self.maps.bits };
        }
        whole
    }

    /// The image of a point under a map.
    pub fn image(&self, letter: usize, at: &Point) -> Point {
        let [a, b, c, d, e, f] = &self.maps.rows[letter];
        let ([x, y], under) = (&at.over, &at.under);
        let over = [a * x + b * y + e * under, c * x + d * y + f * under];
        Point { over, under: under << self.maps.bits }
    }

    /// The point of an address. Letters are known to be maps, and those that repeat to contract.
    pub fn point(&self, address: &Address) -> Point {
        // From (1 - M) x = t by Cramer's rule: no factor of a power of two is left over.
        let Map { row: [a, b, c, d, e, f], bits } = self.word(&address.repeat);
        let one = BigInt::from(1) << bits;
        let (a, d) = (&one - a, &one - d);
        let x = [&d * &e + &b * &f, &c * &e + &a * &f];
        let under = a * d - b * c;
        let Map { row: [a, b, c, d, e, f], bits } = self.word(&address.head);
        let [x, y] = &x;
        let over = [a * x + b * y + e * &under, c * x + d * y + f * &under];
        Point { over, under: under << bits }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::work::{WORK, Work, digits};

    /// What costs are computed from.
    #[test]
    fn numbers_are_not_longer_than_they_are_taken_to_be() {
        let (small, large) = (f64::from_bits(1), f64::MAX);
        for maps in [
            [[0.5, 0.25, -0.5, 0.75, 1.0, -2.0]; 2],
            [[large, large, -large, large, large, large]; 2],
            [[small, 0.0, 0.0, small, small, 1.0], [1.0, 1.0, -1.0, 1.0, large, small]],
        ] {
            let work = Work::at_most(WORK);
            let scene = Scene::new(&maps, &[[0.0, 0.0]], &work).unwrap();
            for (head, repeat) in [(0, 1), (1, 1), (30, 1), (1, 20), (9, 11)] {
                let word = |letters: u8| (0..letters).map(|k| k % 2).collect();
                let point = scene.point(&Address { head: word(head), repeat: word(repeat) });
                let most = (u64::from(head) + 2 * u64::from(repeat)) * scene.letter;
                assert!(digits(point.over.iter().chain([&point.under])) <= most, "{head} {repeat}");
            }
        }
    }
}
