//! Differences of points of an attractor whose maps have one linear part.

use num_bigint::{BigInt, Sign};

use crate::connected::Squares;
use crate::polygon::Scene;
use crate::whole::Whole;

/// Squares that hold nothing but differences, once that is checked, and the way back: the inverse of the linear part.
pub(crate) struct Differences {
    /// The adjugate of the linear part, as whole numbers times `2^-bits` of the maps; its determinant, positive, times
    /// the square of that. The inverse is the one over the other.
    adjugate: [BigInt; 4],
    determinant: BigInt,
    /// Width and height of a square.
    size: Whole<2>,
    /// Which squares there are, sorted.
    known: Vec<[i32; 2]>,
    /// For each the two maps whose translations' difference leads back.
    by: Vec<[u8; 2]>,
}

/// Two numbers over a third one, which is positive.
struct Fraction {
    over: [BigInt; 2],
    under: BigInt,
}

impl Differences {
    /// `None` if the maps do not have one linear part with an inverse, a number is not finite, or a square not one.
    pub fn new(scene: &Scene, squares: &Squares) -> Option<Self> {
        let [first, rest @ ..] = &*scene.maps.rows else { return None };
        if rest.iter().any(|row| row[..4] != first[..4]) {
            return None;
        }
        let [a, b, c, d, ..] = first.clone();
        let determinant = &a * &d - &b * &c;
        let adjugate = [d, -b, -c, a];
        let (adjugate, determinant) = match determinant.sign() {
            Sign::NoSign => return None,
            Sign::Plus => (adjugate, determinant),
            Sign::Minus => (adjugate.map(|x| -x), -determinant),
        };
        let size = Whole::of(&[squares.size])?;
        if size.rows[0].iter().any(|x| x.sign() != Sign::Plus) {
            return None;
        }
        let mut cells = squares.cells.clone();
        cells.sort_unstable_by_key(|&(x, y, ..)| [x, y]);
        let known = cells.iter().map(|&(x, y, ..)| [x, y]).collect();
        Some(Self {
            adjugate,
            determinant,
            size,
            known,
            by: cells.iter().map(|&(.., k, l)| [k, l]).collect(),
        })
    }

    /// Whether every square leads back into squares: then all points in them are differences.
    pub fn all_lead_back(&self, scene: &Scene) -> bool {
        self.known.iter().zip(&self.by).all(|(&[x, y], &digit)| {
            let corners = [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]];
            let corners = corners.map(|corner| self.back(scene, self.corner(corner), digit));
            self.is_within(&corners)
        })
    }

    /// Whether the pieces of two maps meet, as these steps back from the one to the other show.
    pub fn meet(&self, scene: &Scene, [i, j]: [usize; 2], steps: &[[u8; 2]]) -> bool {
        let nothing = Fraction { over: [BigInt::ZERO, BigInt::ZERO], under: BigInt::from(1) };
        // The inverse of 0 - (t_i - t_j).
        let mut at = self.back(scene, nothing, [i as u8, j as u8]);
        for &digit in steps {
            at = self.back(scene, at, digit);
        }
        self.is_within(&[at])
    }

    fn corner(&self, [x, y]: [i32; 2]) -> Fraction {
        let [width, height] = &self.size.rows[0];
        Fraction { over: [width * x, height * y], under: BigInt::from(1) << self.size.bits }
    }

    /// The inverse of the linear part, at a point less the difference of the translations of two maps.
    fn back(&self, scene: &Scene, at: Fraction, [k, l]: [u8; 2]) -> Fraction {
        let rows = &scene.maps.rows;
        let bits = scene.maps.bits;
        let (from, to) = (&rows[usize::from(l)], &rows[usize::from(k)]);
        let less = |n: usize| (&at.over[n] << bits) - (&to[4 + n] - &from[4 + n]) * &at.under;
        // Over `under * 2^bits`.
        let (x, y) = (less(0), less(1));
        let [a, b, c, d] = &self.adjugate;
        // The adjugate has `2^bits` in it, the determinant its square: one is left over, and goes with that above.
        Fraction { over: [a * &x + b * &y, c * x + d * y], under: &self.determinant * at.under }
    }

    /// Whether the box about some points lies in squares that are known.
    fn is_within(&self, points: &[Fraction]) -> bool {
        let range = |n: usize| -> Option<(i32, i32)> {
            let wide = &self.size.rows[0][n];
            let cell = |p: &Fraction, up: bool| {
                let over = &p.over[n] << self.size.bits;
                let under = &p.under * wide;
                i32::try_from(if up { ceil(&over, &under) - 1 } else { floor(&over, &under) }).ok()
            };
            let mut low = i32::MAX;
            let mut high = i32::MIN;
            for point in points {
                low = low.min(cell(point, false)?);
                high = high.max(cell(point, true)?);
            }
            // A point on a line between squares: both are asked for.
            Some((low.min(high), high.max(low)))
        };
        let (Some((left, right)), Some((low, high))) = (range(0), range(1)) else { return false };
        let fits = |from: i32, to: i32| i64::from(to) - i64::from(from) < MOST_ACROSS;
        fits(left, right)
            && fits(low, high)
            && (left..=right).all(|x| (low..=high).all(|y| self.known.binary_search(&[x, y]).is_ok()))
    }
}

/// Squares that an image of one may reach across.
const MOST_ACROSS: i64 = 4096;

/// For a divisor above 0.
fn floor(over: &BigInt, under: &BigInt) -> BigInt {
    let whole = over / under;
    if over.sign() == Sign::Minus && &whole * under != *over { whole - 1 } else { whole }
}

fn ceil(over: &BigInt, under: &BigInt) -> BigInt {
    -floor(&-over, under)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_down_and_up() {
        for over in -20..20 {
            for under in 1..6 {
                let quotient = f64::from(over) / f64::from(under);
                let (p, q) = (BigInt::from(over), BigInt::from(under));
                assert_eq!(floor(&p, &q), BigInt::from(quotient.floor() as i64), "{over} / {under}");
                assert_eq!(ceil(&p, &q), BigInt::from(quotient.ceil() as i64), "{over} / {under}");
            }
        }
    }

    #[test]
    fn steps_back_are_those_of_the_inverse() {
        // The first as it is, the second mirrored.
        for [a, b, c, d] in [[0.375, -0.5, 0.25, 0.125], [0.375, 0.5, 0.25, -0.125]] {
            let maps = [[a, b, c, d, 0.5, -1.25], [a, b, c, d, 2.0, 3.5]];
            let corners = Whole::of(&[[0.0, 0.0]]).unwrap();
            let scene = Scene { maps: Whole::of(&maps).unwrap(), corners };
            let squares = Squares { size: [0.75, 1.5], cells: vec![(3, -2, 1, 0)] };
            let found = Differences::new(&scene, &squares).unwrap();
            let once = found.back(&scene, found.corner([3, -2]), [1, 0]);
            let twice = found.back(&scene, once, [0, 1]);
            assert!(twice.under > BigInt::ZERO);
            // And forth again, from (x, y) over z: x = d + L x'.
            let [x, y] = [0, 1].map(|k| twice.over[k].to_string().parse::<f64>().unwrap());
            let z = twice.under.to_string().parse::<f64>().unwrap();
            let forth =
                |[x, y]: [f64; 2], sign: f64| [a * x + b * y + sign * 1.5, c * x + d * y + sign * 4.75];
            let start = forth(forth([x / z, y / z], -1.0), 1.0);
            assert!((start[0] - 2.25).abs() < 1e-9 && (start[1] + 3.0).abs() < 1e-9, "{start:?}");
        }
    }
}
