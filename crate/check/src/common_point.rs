//! Points with two addresses.

use num_bigint::BigInt;

use crate::connected::Address;
use crate::polygon::Scene;

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

impl Scene {
    /// Whether two addresses are of one point. Letters are known to be maps, and those that repeat to contract.
    pub fn coincide(&self, [a, b]: &[Address; 2]) -> bool {
        let [a, b] = [self.point(a), self.point(b)];
        (0..2).all(|k| &a.over[k] * &b.under == &b.over[k] * &a.under)
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
