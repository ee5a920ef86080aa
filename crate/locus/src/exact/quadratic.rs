//! Numbers a + b sqrt(d) with whole a and b of any length, and maps made of them.

use std::ops::{Add, Mul, Neg, Sub};

use frond_core::Affine2;
use num_bigint::BigInt;

use crate::exact::address::Address;

/// `a + b sqrt(d)`. Where `d` is 0 so is `b`; numbers with different other `d` are never mixed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Quadratic {
    pub a: BigInt,
    pub b: BigInt,
    pub d: u8,
}

impl PartialEq for Quadratic {
    /// Without a root it does not matter which one is not there.
    fn eq(&self, other: &Self) -> bool {
        self.a == other.a && self.b == other.b && (self.d == other.d || self.b == BigInt::ZERO)
    }
}
impl Eq for Quadratic {}

impl Quadratic {
    pub fn whole(a: BigInt) -> Self {
        Self { a, b: BigInt::ZERO, d: 0 }
    }

    /// The square root of `d` is irrational, so that both parts must be.
    pub fn is_zero(&self) -> bool {
        self.a == BigInt::ZERO && self.b == BigInt::ZERO
    }

    fn bits(&self) -> u64 {
        self.a.bits().max(self.b.bits())
    }
}

impl Add for &Quadratic {
    type Output = Quadratic;
    fn add(self, other: Self) -> Quadratic {
        Quadratic { a: &self.a + &other.a, b: &self.b + &other.b, d: self.d.max(other.d) }
    }
}

impl Sub for &Quadratic {
    type Output = Quadratic;
    fn sub(self, other: Self) -> Quadratic {
        Quadratic { a: &self.a - &other.a, b: &self.b - &other.b, d: self.d.max(other.d) }
    }
}

impl Neg for &Quadratic {
    type Output = Quadratic;
    fn neg(self) -> Quadratic {
        Quadratic { a: -&self.a, b: -&self.b, d: self.d }
    }
}

impl Mul for &Quadratic {
    type Output = Quadratic;
    fn mul(self, other: Self) -> Quadratic {
        let d = self.d.max(other.d);
        if self.d == 0 && other.d == 0 {
            return Quadratic::whole(&self.a * &other.a);
        }
        Quadratic {
            a: &self.a * &other.a + BigInt::from(d) * (&self.b * &other.b),
            b: &self.a * &other.b + &self.b * &other.a,
            d,
        }
    }
}

/// A map: the row `[a, b, c, d, e, f]` over a denominator.
#[derive(Clone, Debug)]
pub(crate) struct QuadraticMap {
    row: [Quadratic; 6],
    over: Quadratic,
}

/// A point as the fractions x / w, y / w.
pub(crate) type QuadraticPoint = [Quadratic; 3];

/// Numbers of more binary digits than this are not computed with.
const MOST_BITS: u64 = 40_000;

impl QuadraticMap {
    /// The map that applies `inner` first.
    fn after(&self, inner: &Self) -> Self {
        let [a, b, c, d, e, f] = &self.row;
        let [p, q, r, s, t, u] = &inner.row;
        let dot = |x: &Quadratic, y: &Quadratic, z: &Quadratic, w: &Quadratic| &(x * y) + &(z * w);
        let row = [
            dot(a, p, b, r),
            dot(a, q, b, s),
            dot(c, p, d, r),
            dot(c, q, d, s),
            &dot(a, t, b, u) + &(e * &inner.over),
            &dot(c, t, d, u) + &(f * &inner.over),
        ];
        Self { row, over: &self.over * &inner.over }
    }

    /// The image of a point.
    fn apply(&self, [x, y, w]: &QuadraticPoint) -> QuadraticPoint {
        let [a, b, c, d, e, f] = &self.row;
        let along = |p: &Quadratic, q: &Quadratic, r: &Quadratic| &(&(p * x) + &(q * y)) + &(r * w);
        [along(a, b, e), along(c, d, f), &self.over * w]
    }

    /// From `(1 - M) p = t` by Cramer's rule; `None` if there is no such point or more than one.
    fn fixed_point(&self) -> Option<QuadraticPoint> {
        let [a, b, c, d, e, f] = &self.row;
        let (p, s) = (&self.over - a, &self.over - d);
        let w = &(&p * &s) - &(b * c);
        (!w.is_zero()).then(|| [&(&s * e) + &(b * f), &(c * e) + &(&p * f), w])
    }
}

/// Whether two points are the same.
pub(crate) fn same(p: &QuadraticPoint, q: &QuadraticPoint) -> bool {
    &p[0] * &q[2] == &q[0] * &p[2] && &p[1] * &q[2] == &q[1] * &p[2]
}

/// The maps of a system.
#[derive(Clone, Debug)]
pub(crate) struct QuadraticSystem {
    maps: Vec<QuadraticMap>,
    /// Digits that a letter adds.
    bits: u64,
}

impl QuadraticSystem {
    /// The numbers as they are given: doubles are whole multiples of a power of two. `None` if they are too long.
    pub fn as_given(maps: &[Affine2]) -> Option<Self> {
        let rows: Vec<[f64; 6]> = maps.iter().copied().map(Affine2::to_row).collect();
        let power = |x: f64| dyadic(x).1;
        let lowest =
            rows.iter().flatten().filter(|x| **x != 0.0).map(|x| power(*x)).min().unwrap_or(0).min(0);
        let whole = |x: f64| {
            let (digits, power) = dyadic(x);
            Quadratic::whole(if digits == 0 {
                BigInt::ZERO
            } else {
                BigInt::from(digits) << (power - lowest)
            })
        };
        let over = Quadratic::whole(BigInt::from(1) << lowest.unsigned_abs());
        Some(Self::new(rows.into_iter().map(|row| row.map(whole)).collect(), &over))
            .filter(|this| this.bits < 2000)
    }

    /// Maps of rows over one denominator.
    pub fn new(rows: Vec<[Quadratic; 6]>, over: &Quadratic) -> Self {
        let bits = rows.iter().flatten().chain([over]).map(Quadratic::bits).max().unwrap_or(0);
        Self { maps: rows.into_iter().map(|row| QuadraticMap { row, over: over.clone() }).collect(), bits }
    }

    /// The map of a word; `None` if its numbers would be too long.
    pub fn word(&self, word: &[u8]) -> Option<QuadraticMap> {
        let (first, rest) = word.split_first()?;
        if word.len() as u64 * self.bits > MOST_BITS {
            return None;
        }
        let map = |i: &u8| &self.maps[usize::from(*i)];
        Some(rest.iter().fold(map(first).clone(), |word, i| word.after(map(i))))
    }

    /// The point of an address.
    pub fn point(&self, address: &Address) -> Option<QuadraticPoint> {
        if (address.head.len() + 2 * address.repeat.len()) as u64 * self.bits > MOST_BITS {
            return None;
        }
        let fixed = self.word(&address.repeat)?.fixed_point()?;
        let back = address.head.iter().rev();
        Some(back.fold(fixed, |point, i| self.maps[usize::from(*i)].apply(&point)))
    }

    /// Whether two addresses are of one point.
    pub fn coincide(&self, a: &Address, b: &Address) -> bool {
        matches!((self.point(a), self.point(b)), (Some(p), Some(q)) if same(&p, &q))
    }

    /// Whether an address is of the same point in another system whose roots are the same.
    pub fn point_in(&self, other: &Self, address: &Address) -> bool {
        matches!((self.point(address), other.point(address)), (Some(p), Some(q)) if same(&p, &q))
    }

    /// The system of some of its maps.
    pub fn part(&self, maps: std::ops::Range<usize>) -> Self {
        Self { maps: self.maps[maps].to_vec(), bits: self.bits }
    }

    /// Whether `w_u^-1 w_v = w_s^-1 w_t`, for words whose maps have an inverse.
    pub fn same_neighbour(&self, (u, v): (&[u8], &[u8]), (s, t): (&[u8], &[u8])) -> bool {
        // w_v = w_u h and w_t = w_s h for one h: adj(w_u) w_v / det(w_u) is compared.
        let neighbour = |u: &[u8], v: &[u8]| Some(self.word(u)?.undo(&self.word(v)?));
        match (neighbour(u, v), neighbour(s, t)) {
            (Some((h, p)), Some((k, q))) => h.iter().zip(&k).all(|(x, y)| x * &q == y * &p),
            _ => false,
        }
    }
}

impl QuadraticMap {
    /// The six numbers of `self^-1 other`, and their common denominator.
    fn undo(&self, other: &Self) -> ([Quadratic; 6], Quadratic) {
        let [a, b, c, d, e, f] = &self.row;
        let [p, q, r, s, t, u] = &other.row;
        let dot = |x: &Quadratic, y: &Quadratic, z: &Quadratic, w: &Quadratic| &(x * y) - &(z * w);
        // self = (M x + e) / m, other = (N x + t) / n: M^-1 (m N x + m t - n e) / n.
        let (m, n) = (&self.over, &other.over);
        let (x, y) = (&(m * t) - &(n * e), &(m * u) - &(n * f));
        let linear = [dot(d, p, b, r), dot(d, q, b, s), dot(a, r, c, p), dot(a, s, c, q)].map(|z| &z * m);
        let [l0, l1, l2, l3] = linear;
        ([l0, l1, l2, l3, dot(d, &x, b, &y), dot(a, &y, c, &x)], &dot(a, d, b, c) * n)
    }
}

/// `(m, e)` with `x = m 2^e`, m odd or zero, for a finite number.
pub(crate) fn dyadic(x: f64) -> (i64, i64) {
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i64;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (digits, power) =
        if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    if digits == 0 {
        return (0, 0);
    }
    let even = digits.trailing_zeros();
    let digits = digits >> even;
    (if x < 0.0 { -digits } else { digits }, power + i64::from(even))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gasket(corner: [f64; 2], scale: f64) -> QuadraticSystem {
        let maps = [[0.0, 0.0], [1.0, 0.0], corner]
            .map(|[x, y]| Affine2::from_row([scale, 0.0, 0.0, scale, (1.0 - scale) * x, (1.0 - scale) * y]));
        QuadraticSystem::as_given(&maps).unwrap()
    }

    #[test]
    fn points_of_addresses_are_exact() {
        let address = |text: &str| Address::parse(text).unwrap();
        // Any triangle will do, though no digit of its corner is short.
        let ifs = gasket([0.3, 0.866_025_403_784_438_6], 0.5);
        for (a, b, wanted) in [
            ("1(2)", "2(1)", true),
            ("1(3)", "3(1)", true),
            ("3(12)", "3(12)", true),
            ("33(12)", "331(21)", true),
            ("1(2)", "2(3)", false),
            ("12(3)", "13(2)", true),
            ("(1)", "(2)", false),
        ] {
            assert_eq!(ifs.coincide(&address(a), &address(b)), wanted, "{a} {b}");
        }
        let smaller = gasket([0.5, 0.5], 0.5 - f64::EPSILON / 4.0);
        assert!(!smaller.coincide(&address("1(2)"), &address("2(1)")), "one digit less");
    }

    #[test]
    fn roots_multiply() {
        let surd = |a: i64, b: i64| Quadratic { a: a.into(), b: b.into(), d: 5 };
        // The golden ratio, doubled, squared: (1 + sqrt 5)^2 = 6 + 2 sqrt 5.
        assert_eq!(&surd(1, 1) * &surd(1, 1), surd(6, 2));
        assert_eq!(&surd(1, 1) - &surd(1, 1), surd(0, 0));
        assert!(surd(0, 0).is_zero() && !surd(0, 1).is_zero());
        assert_eq!(&surd(1, 1) * &surd(1, -1), Quadratic::whole((-4).into()));
        assert_eq!((&Quadratic::whole(3.into()) * &surd(1, -2)), surd(3, -6));
    }

    #[test]
    fn neighbours_are_compared_exactly() {
        let ifs = gasket([0.0, 1.0], 0.5);
        // Side by side, at every size.
        assert!(ifs.same_neighbour((&[0], &[1]), (&[2, 0], &[2, 1])));
        assert!(ifs.same_neighbour((&[0], &[1]), (&[0, 1], &[1, 0])));
        assert!(!ifs.same_neighbour((&[0], &[1]), (&[1], &[0])));
        let smaller = gasket([0.0, 1.0], 0.5 - f64::EPSILON / 4.0);
        assert!(!smaller.same_neighbour((&[0], &[1]), (&[0, 1], &[1, 0])));
    }
}
