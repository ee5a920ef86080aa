//! Points of addresses modulo a prime: what differs there differs, and it takes next to no time to see.

use frond_core::Affine2;

use crate::exact::address::Address;
use crate::exact::quadratic::dyadic;

/// The binary digits of the prime 2^61 - 1, of which 2 has a power for each.
const DIGITS: u32 = 61;
const PRIME: u64 = (1 << DIGITS) - 1;

/// The maps of a system modulo the prime: doubles are whole numbers times powers of 2, which all have residues.
#[derive(Clone, Debug, Default)]
pub(crate) struct Residues {
    maps: Vec<[u64; 6]>,
}

impl Residues {
    /// Takes other maps, whose numbers are finite.
    pub fn set(&mut self, maps: &[Affine2]) {
        self.maps.clear();
        self.maps.extend(maps.iter().map(|map| map.to_row().map(residue)));
    }

    /// Whether it is seen that two addresses are not of one point. `false` says nothing.
    pub fn differ(&self, a: &Address, b: &Address) -> bool {
        let (Some(p), Some(q)) = (self.point(a), self.point(b)) else { return false };
        (0..2).any(|k| times(p[k], q[2]) != times(q[k], p[2]))
    }

    /// The point x / w, y / w; `None` where w has no inverse.
    fn point(&self, address: &Address) -> Option<[u64; 3]> {
        let map = |&k: &u8| self.maps[usize::from(k)];
        let word = address.repeat.iter().map(map).reduce(after)?;
        let [a, b, c, d, e, f] = word;
        // By Cramer's rule, from (1 - M) p = t.
        let (p, s) = (less(1, a), less(1, d));
        let fixed = [dot(s, e, b, f), dot(c, e, p, f), less(times(p, s), times(b, c))];
        (fixed[2] != 0).then(|| {
            address.head.iter().rev().map(map).fold(fixed, |[x, y, w], [a, b, c, d, e, f]| {
                [plus(dot(a, x, b, y), times(e, w)), plus(dot(c, x, d, y), times(f, w)), w]
            })
        })
    }
}

/// The map that applies the second first.
fn after([a, b, c, d, e, f]: [u64; 6], [p, q, r, s, t, u]: [u64; 6]) -> [u64; 6] {
    [
        dot(a, p, b, r),
        dot(a, q, b, s),
        dot(c, p, d, r),
        dot(c, q, d, s),
        plus(dot(a, t, b, u), e),
        plus(dot(c, t, d, u), f),
    ]
}

fn dot(a: u64, x: u64, b: u64, y: u64) -> u64 {
    plus(times(a, x), times(b, y))
}

fn plus(a: u64, b: u64) -> u64 {
    (a + b) % PRIME
}

fn less(a: u64, b: u64) -> u64 {
    (a + PRIME - b) % PRIME
}

fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    // 2^61 is 1.
    ((product >> DIGITS) as u64 + (product as u64 & PRIME)) % PRIME
}

fn residue(x: f64) -> u64 {
    let (digits, power) = dyadic(x);
    let size = times(digits.unsigned_abs() % PRIME, 1 << power.rem_euclid(i64::from(DIGITS)));
    if digits < 0 { less(0, size) } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::quadratic::QuadraticSystem;

    #[test]
    fn numbers_are_what_they_are_modulo_the_prime() {
        assert_eq!([residue(0.0), residue(1.0), residue(-1.0), residue(3.0)], [0, 1, PRIME - 1, 3]);
        for x in [0.1, -0.3, 1e-300, 7e200, f64::from_bits(1), 0.5] {
            assert_eq!(times(residue(x), residue(2.0)), residue(2.0 * x), "{x}");
            assert_eq!(plus(residue(x), residue(-x)), 0, "{x}");
        }
        assert_eq!(times(PRIME - 1, PRIME - 1), 1);
    }

    #[test]
    fn points_differ_as_they_do_in_whole_numbers() {
        let address = |text: &str| Address::parse(text).expect("an address");
        let texts =
            ["1(2)", "2(1)", "1(3)", "3(1)", "3(12)", "331(21)", "33(12)", "12(3)", "13(2)", "(1)", "(23)"];
        let mut same = 0;
        for scale in [0.5, 0.5_f64.next_down(), 1.0 / 3.0] {
            let maps = [[0.0, 0.0], [1.0, 0.0], [0.3, 0.866_025_403_784_438_6]].map(|[x, y]| {
                Affine2::from_row([scale, 0.0, 0.0, scale, (1.0 - scale) * x, (1.0 - scale) * y])
            });
            let exact = QuadraticSystem::as_given(&maps).expect("short numbers");
            let mut residues = Residues::default();
            residues.set(&maps);
            for (a, b) in texts.iter().flat_map(|a| texts.iter().map(move |b| (address(a), address(b)))) {
                let coincide = exact.coincide(&a, &b);
                assert_eq!(residues.differ(&a, &b), !coincide, "{a:?} {b:?} at {scale}");
                same += usize::from(coincide);
            }
        }
        assert!(same > 40, "{same}");
    }
}
