//! Maps of space in whole numbers, to say without rounding that two points are one.

use frond_core::Affine3;
use num_bigint::BigInt;

/// A map whose twelve numbers are whole, over one denominator.
#[derive(Clone, Debug)]
struct Whole {
    linear: [[BigInt; 3]; 3],
    translation: [BigInt; 3],
    over: BigInt,
}

/// A point whose coordinates are whole, over one denominator.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    at: [BigInt; 3],
    over: BigInt,
}

impl PartialEq for Point {
    fn eq(&self, other: &Self) -> bool {
        (0..3).all(|k| &self.at[k] * &other.over == &other.at[k] * &self.over)
    }
}

/// A system of space in whole numbers.
#[derive(Clone, Debug)]
pub(crate) struct Exact {
    maps: Vec<Whole>,
    /// Each number that is read as another one, and as which: "0.3333333333333333 is 1/3".
    pub assuming: Vec<String>,
}

/// Numbers below 2^-`MOST_BITS` would make fractions of more digits than are worth while.
const MOST_BITS: i32 = 300;
/// The largest denominator that a number is read with.
const LARGEST_DENOMINATOR: i64 = 360;

impl Exact {
    /// The maps as they are given: every double is a whole number over a power of two. `None` where one is too small.
    pub fn as_given(maps: &[Affine3]) -> Option<Self> {
        let maps: Option<Vec<_>> = maps.iter().map(|map| Whole::of(&map.to_row().map(dyadic))).collect();
        Some(Self { maps: maps?, assuming: Vec::new() })
    }

    /// The maps with numbers that come near a fraction of a small denominator read as that fraction. `None` where some
    /// number does not.
    pub fn as_meant(maps: &[Affine3]) -> Option<Self> {
        let mut assuming = Vec::new();
        let mut whole = Vec::new();
        for map in maps {
            let fractions = map.to_row().map(|x| {
                let (p, q) = fraction(x)?;
                let text = format!("{x} is {p}/{q}");
                // A power of two is what the double is already.
                if q & (q - 1) != 0 && !assuming.contains(&text) || p as f64 / q as f64 != x {
                    assuming.push(text);
                }
                Some((BigInt::from(p), BigInt::from(q)))
            });
            whole.push(Whole::of(&fractions)?);
        }
        Some(Self { maps: whole, assuming })
    }

    /// The point with the address `head`, then `repeat` without end; `None` where the repeated map has no fixed point.
    pub fn point(&self, head: &[u8], repeat: &[u8]) -> Option<Point> {
        let mut letters = repeat.iter().map(|&letter| &self.maps[usize::from(letter)]);
        let first = letters.next()?.clone();
        let word = letters.fold(first, |map, next| map.after(next));
        let mut point = word.fixed_point()?;
        for &letter in head.iter().rev() {
            point = self.maps[usize::from(letter)].apply(&point);
        }
        Some(point)
    }

    /// Whether `|det a| + |det b| >= 1`.
    pub fn volumes_fill(&self, a: usize, b: usize) -> bool {
        let volume = |map: &Whole| (absolute(determinant(&map.linear)), &map.over * &map.over * &map.over);
        let ((v, over_v), (w, over_w)) = (volume(&self.maps[a]), volume(&self.maps[b]));
        v * &over_w + w * &over_v >= over_v * over_w
    }
}

impl Whole {
    fn of(fractions: &[Option<(BigInt, BigInt)>; 12]) -> Option<Self> {
        let mut over = BigInt::from(1);
        for fraction in fractions {
            let (_, q) = fraction.as_ref()?;
            over = common(over, q);
        }
        let whole = |k: usize| fractions[k].as_ref().map(|(p, q)| p * (&over / q));
        let row = |r: usize| Some([whole(3 * r)?, whole(3 * r + 1)?, whole(3 * r + 2)?]);
        let (linear, translation) = ([row(0)?, row(1)?, row(2)?], row(3)?);
        Some(Self { linear, translation, over })
    }

    fn after(&self, inner: &Self) -> Self {
        let cell =
            |r: usize, c: usize| -> BigInt { (0..3).map(|k| &self.linear[r][k] * &inner.linear[k][c]).sum() };
        let row = |r: usize| -> BigInt {
            let turned: BigInt = (0..3).map(|k| &self.linear[r][k] * &inner.translation[k]).sum();
            turned + &self.translation[r] * &inner.over
        };
        Self {
            linear: std::array::from_fn(|r| std::array::from_fn(|c| cell(r, c))),
            translation: std::array::from_fn(row),
            over: &self.over * &inner.over,
        }
    }

    fn apply(&self, point: &Point) -> Point {
        let row = |r: usize| -> BigInt {
            let turned: BigInt = (0..3).map(|k| &self.linear[r][k] * &point.at[k]).sum();
            turned + &self.translation[r] * &point.over
        };
        Point { at: std::array::from_fn(row), over: &self.over * &point.over }
    }

    /// By Cramer's rule.
    fn fixed_point(&self) -> Option<Point> {
        let zero = BigInt::from(0);
        let less: [[BigInt; 3]; 3] = std::array::from_fn(|r| {
            std::array::from_fn(|c| {
                (if r == c { self.over.clone() } else { zero.clone() }) - &self.linear[r][c]
            })
        });
        let over = determinant(&less);
        if over == zero {
            return None;
        }
        let along = |k: usize| {
            let mut columns = less.clone();
            for (row, t) in columns.iter_mut().zip(&self.translation) {
                row[k] = t.clone();
            }
            determinant(&columns)
        };
        Some(Point { at: std::array::from_fn(along), over })
    }
}

fn determinant(m: &[[BigInt; 3]; 3]) -> BigInt {
    let minor = |a: usize, b: usize| &m[1][a] * &m[2][b] - &m[1][b] * &m[2][a];
    &m[0][0] * minor(1, 2) - &m[0][1] * minor(0, 2) + &m[0][2] * minor(0, 1)
}

fn absolute(x: BigInt) -> BigInt {
    if x < BigInt::from(0) { -x } else { x }
}

/// The least common multiple of positive numbers.
fn common(a: BigInt, b: &BigInt) -> BigInt {
    let (mut x, mut y) = (a.clone(), b.clone());
    while y != BigInt::from(0) {
        (x, y) = (y.clone(), x % y);
    }
    a / x * b
}

/// A double as a fraction over a power of two.
fn dyadic(x: f64) -> Option<(BigInt, BigInt)> {
    if !x.is_finite() {
        return None;
    }
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    let digits = bits & ((1 << 52) - 1);
    let mantissa = if exponent == 0 { digits } else { digits | 1 << 52 };
    if mantissa == 0 {
        return Some((BigInt::from(0), BigInt::from(1)));
    }
    let zeros = mantissa.trailing_zeros() as i32;
    let power = exponent.max(1) - 1075 + zeros;
    let whole = BigInt::from(mantissa >> zeros) * if x < 0.0 { -1 } else { 1 };
    match power {
        0..=MOST_BITS => Some((whole << power.unsigned_abs(), BigInt::from(1))),
        _ if (-MOST_BITS..0).contains(&power) => Some((whole, BigInt::from(1) << power.unsigned_abs())),
        _ => None,
    }
}

/// The fraction of the least denominator that a double comes near to within a few roundings.
fn fraction(x: f64) -> Option<(i64, i64)> {
    if x.is_nan() || x.abs() > 1e6 {
        return None;
    }
    (1..=LARGEST_DENOMINATOR).find_map(|q| {
        let p = (x * q as f64).round();
        let near = (x - p / q as f64).abs() <= 4.0 * f64::EPSILON * x.abs().max(1.0 / 16.0);
        near.then_some((p as i64, q))
    })
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn doubles_are_fractions() {
        for x in [0.0, 1.0, -0.75, 0.1, 1e-30, 3.0e40, -1234.5678] {
            let (p, q) = dyadic(x).unwrap();
            // Both fit f64 after the same shift, exactly.
            let value = |n: &BigInt| n.to_string().parse::<f64>().unwrap();
            assert!((value(&p) / value(&q) - x).abs() <= 1e-15 * x.abs(), "{x}");
        }
        assert!(dyadic(f64::NAN).is_none() && dyadic(1e-200).is_none());
        assert_eq!(fraction(1.0 / 3.0), Some((1, 3)));
        assert_eq!(fraction(-0.6), Some((-3, 5)));
        assert_eq!(fraction(std::f64::consts::FRAC_1_SQRT_2), None);
    }

    #[test]
    fn points_that_differ_in_the_last_digit_are_two() {
        let half = |at: DVec3| Affine3::scaling(DVec3::splat(0.5)).about(at);
        let maps = [half(DVec3::ZERO), half(DVec3::new(1.0, 3.0, -1.0))];
        let exact = Exact::as_given(&maps).unwrap();
        assert!(exact.point(&[0], &[1]) == exact.point(&[1], &[0]));
        assert!(exact.point(&[0], &[1]) != exact.point(&[0], &[0]));
        let mut less = maps;
        less[1].linear.x_axis.x -= f64::EPSILON / 2.0;
        let exact = Exact::as_given(&less).unwrap();
        assert!(exact.point(&[0], &[1]) != exact.point(&[1], &[0]));
        let third = Affine3::scaling(DVec3::splat(1.0 / 3.0));
        let two = [third, Affine3::new(third.linear, DVec3::X * (1.0 / 3.0))];
        assert_eq!(Exact::as_meant(&two).unwrap().assuming, ["0.3333333333333333 is 1/3"]);
    }

    #[test]
    fn volumes_are_added_exactly() {
        let box_of = |x: f64| Affine3::scaling(DVec3::new(x, 0.75, 0.75));
        let at = 0.888_888_888_888_888_8;
        let under = [box_of(at), box_of(at)];
        assert!(!Exact::as_given(&under).unwrap().volumes_fill(0, 1));
        let flush =
            [Affine3::scaling(DVec3::new(-1.0, 0.5, 1.0)), Affine3::scaling(DVec3::new(0.5, 1.0, 1.0))];
        assert!(Exact::as_given(&flush).unwrap().volumes_fill(0, 1));
    }
}
