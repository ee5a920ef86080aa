//! Differences of points of an attractor whose maps have one linear part.

use num_bigint::{BigInt, Sign};

use crate::connected::Squares;
use crate::limits::FARTHEST_CELL;
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::whole::Whole;
use crate::work::{LOOK_UP, digits, product};

/// Squares that hold nothing but differences, once that is checked, and the way back: the inverse of the linear part.
pub(crate) struct Differences {
    /// The adjugate of the linear part, as whole numbers times `2^-bits` of the maps; its determinant, positive, times
    /// the square of that. The inverse is the one over the other.
    adjugate: [BigInt; 4],
    determinant: BigInt,
    /// Width and height of a square.
    size: Whole<2>,
    /// Column and row of each square, and the two maps whose translations' difference leads back.
    cells: Vec<(i32, i32, u8, u8)>,
    /// Which squares there are, sorted, each once.
    known: Vec<[i32; 2]>,
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
        let mut known: Vec<[i32; 2]> = squares.cells.iter().map(|&(x, y, ..)| [x, y]).collect();
        known.sort_unstable();
        known.dedup();
        Some(Self { adjugate, determinant, size, cells: squares.cells.clone(), known })
    }

    /// What [`Self::all_lead_back`] takes.
    pub fn cost_all(&self, scene: &Scene) -> u64 {
        self.cost_square(scene).saturating_mul(self.cells.len() as u64)
    }

    /// For each square its four corners, and a few look-ups to count the squares of a box.
    fn cost_square(&self, scene: &Scene) -> u64 {
        let size = self.size_digits();
        let start = size + u64::from(i32::BITS);
        let corner = 2 * product(size, u64::from(i32::BITS))
            + cost_back(scene, start)
            + self.cost_around(start + 2 * scene.letter);
        4 * corner + 8 * LOOK_UP
    }

    /// Whether every square leads back into squares: then all points in them are differences.
    pub fn all_lead_back(&self, scene: &Scene) -> Result<bool, Refused> {
        let mut boxes = Vec::with_capacity(self.cells.len());
        for &(x, y, k, l) in &self.cells {
            scene.work.spend(self.cost_square(scene))?;
            let corners = [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]];
            let corners = corners.map(|corner| self.back(scene, self.corner(corner), [k, l]));
            let Some(around) = self.around(&corners) else { return Ok(false) };
            boxes.push(around);
        }
        Ok(hold_all(&self.known, &boxes))
    }

    /// What [`Self::meet`] takes, for so many steps.
    pub fn cost_meet(&self, scene: &Scene, steps: usize) -> u64 {
        let steps = steps as u64 + 1;
        let end = steps * 2 * scene.letter + 1;
        steps.saturating_mul(cost_back(scene, end)).saturating_add(self.cost_around(end) + 4 * LOOK_UP)
    }

    /// Whether the pieces of two maps meet, as these steps back from the one to the other show.
    pub fn meet(&self, scene: &Scene, [i, j]: [usize; 2], steps: &[[u8; 2]]) -> Result<bool, Refused> {
        scene.work.spend(self.cost_meet(scene, steps.len()))?;
        let nothing = Fraction { over: [BigInt::ZERO, BigInt::ZERO], under: BigInt::from(1) };
        // The inverse of 0 - (t_i - t_j).
        let mut at = self.back(scene, nothing, [i as u8, j as u8]);
        for &digit in steps {
            at = self.back(scene, at, digit);
        }
        // Four squares at the most have one point.
        Ok(self.around(&[at]).is_some_and(|around| {
            let [[left, low], [right, high]] = [around.least, around.greatest];
            (left..=right).all(|x| (low..=high).all(|y| self.known.binary_search(&[x, y]).is_ok()))
        }))
    }

    fn size_digits(&self) -> u64 {
        digits(&self.size.rows[0]).max(self.size.bits)
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

    /// What [`Self::around`] takes, for a point whose numbers have so many binary digits.
    fn cost_around(&self, point: u64) -> u64 {
        let size = self.size_digits();
        2 * (product(point, size) + 4 * product(point + size, u64::from(i32::BITS)))
    }

    /// The squares about some points. `None` where they are too far away.
    fn around(&self, points: &[Fraction]) -> Option<Squared> {
        let (mut least, mut greatest) = ([i32::MAX; 2], [i32::MIN; 2]);
        for point in points {
            for n in 0..2 {
                let over = &point.over[n] << self.size.bits;
                let (low, is_exact) = floor(&over, &(&point.under * &self.size.rows[0][n]))?;
                least[n] = least[n].min(low);
                greatest[n] = greatest[n].max(if is_exact { low - 1 } else { low });
            }
        }
        // Points that are all on a line between squares: those on both sides are asked for.
        for n in 0..2 {
            (least[n], greatest[n]) = (least[n].min(greatest[n]), greatest[n].max(least[n]));
        }
        Some(Squared { least, greatest })
    }
}

/// What [`Differences::back`] takes, from a point whose numbers have so many binary digits. The next has twice the
/// digits of a letter more.
fn cost_back(scene: &Scene, point: u64) -> u64 {
    8 * product(point + scene.letter, 2 * scene.letter)
}

/// A box of squares: its least and its greatest column and row.
struct Squared {
    least: [i32; 2],
    greatest: [i32; 2],
}

impl Squared {
    /// How many squares it has.
    fn count(&self) -> i64 {
        let across = |n: usize| i64::from(self.greatest[n]) - i64::from(self.least[n]) + 1;
        across(0) * across(1)
    }
}

/// Whether all squares of each box are known: if so many are known there as the box has. They are sorted, none is there
/// twice.
///
/// They are counted for all boxes in one sweep from column to column, by a tree of sums over the rows (Fenwick 1994):
/// square by square, large boxes would take the square of their number.
fn hold_all(known: &[[i32; 2]], boxes: &[Squared]) -> bool {
    let mut rows: Vec<i32> = known.iter().map(|&[_, y]| y).collect();
    rows.sort_unstable();
    rows.dedup();
    // How many rows lie below a row.
    let below = |y: i32| rows.partition_point(|&row| row < y);
    // Where a box begins, and where it has ended: what is known left of that, less what is left of its beginning.
    let mut sides: Vec<(i32, usize, i64)> = Vec::with_capacity(2 * boxes.len());
    for (k, Squared { least, greatest }) in boxes.iter().enumerate() {
        sides.extend([(least[0], k, -1), (greatest[0] + 1, k, 1)]);
    }
    sides.sort_unstable();
    let mut sums = vec![0_i64; rows.len() + 1];
    let mut counts = vec![0_i64; boxes.len()];
    let mut left = known.iter().peekable();
    for (column, k, sign) in sides {
        while let Some(&[_, y]) = left.next_if(|[x, _]| *x < column) {
            let mut at = below(y) + 1;
            while at < sums.len() {
                sums[at] += 1;
                at += at & at.wrapping_neg();
            }
        }
        let before = |row: usize| {
            let (mut at, mut sum) = (row, 0);
            while at > 0 {
                sum += sums[at];
                at &= at - 1;
            }
            sum
        };
        let Squared { least, greatest } = &boxes[k];
        counts[k] += sign * (before(below(greatest[1] + 1)) - before(below(least[1])));
    }
    boxes.iter().zip(counts).all(|(one, count)| one.count() == count)
}

/// A quotient rounded down, and whether that is the quotient itself, for a divisor above 0. `None` where it is farther
/// away than any square.
fn floor(over: &BigInt, under: &BigInt) -> Option<(i32, bool)> {
    // Nothing is divided whose quotient has too many digits.
    if over.bits() > under.bits() + u64::from(i32::BITS) {
        return None;
    }
    let whole = over / under;
    let is_exact = &whole * under == *over;
    let low = if over.sign() == Sign::Minus && !is_exact { whole - 1 } else { whole };
    let low = i32::try_from(low).ok()?;
    (low.unsigned_abs() <= 2 * FARTHEST_CELL).then_some((low, is_exact))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::work::{WORK, Work};

    #[test]
    fn numbers_are_rounded_down() {
        for over in -20..20 {
            for under in 1..6 {
                let quotient = f64::from(over) / f64::from(under);
                let wanted = (quotient.floor() as i32, over % under == 0);
                assert_eq!(floor(&over.into(), &under.into()), Some(wanted), "{over} / {under}");
            }
        }
        let far = BigInt::from(2 * FARTHEST_CELL);
        assert_eq!(floor(&far, &1.into()).unwrap().0, 2_000_000);
        assert_eq!(floor(&-&far, &1.into()).unwrap().0, -2_000_000);
        let long = &far << 100_000;
        for over in [&far + 1, -&far - 1, -&long, long] {
            assert_eq!(floor(&over, &1.into()), None, "{} digits", over.bits());
        }
    }

    /// Against looking at each square of a box.
    #[test]
    fn boxes_of_known_squares_are_counted() {
        // A plane of squares with holes, the first of them at chance (a linear congruence).
        let mut state = 1_u32;
        let mut next = |most: i32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as i32 % most
        };
        let (mut all, mut some) = (0, 0);
        for round in 0..200 {
            let holes = round % 5;
            let mut known: Vec<[i32; 2]> = (0..80).map(|k| [k % 8 - 4, k / 8 - 5]).collect();
            for _ in 0..holes {
                known.remove(next(known.len() as i32) as usize);
            }
            known.sort_unstable();
            let mut boxes = Vec::new();
            for _ in 0..4 {
                let (x, y) = (next(9) - 5, next(11) - 6);
                boxes.push(Squared { least: [x, y], greatest: [x + next(4), y + next(4)] });
                let is_held = |one: &Squared| {
                    (one.least[0]..=one.greatest[0])
                        .all(|x| (one.least[1]..=one.greatest[1]).all(|y| known.contains(&[x, y])))
                };
                let wanted = boxes.iter().all(is_held);
                assert_eq!(hold_all(&known, &boxes), wanted);
                if wanted { all += 1 } else { some += 1 }
            }
        }
        assert!(all > 50 && some > 50, "{all} {some}");
        assert!(hold_all(&[], &[]));
    }

    #[test]
    fn steps_back_are_those_of_the_inverse() {
        let work = Work::at_most(WORK);
        // The first as it is, the second mirrored.
        for [a, b, c, d] in [[0.375, -0.5, 0.25, 0.125], [0.375, 0.5, 0.25, -0.125]] {
            let maps = [[a, b, c, d, 0.5, -1.25], [a, b, c, d, 2.0, 3.5]];
            let scene = Scene::new(&maps, &[[0.0, 0.0]], &work).unwrap();
            let squares = Squares { size: [0.75, 1.5], cells: vec![(3, -2, 1, 0)] };
            let found = Differences::new(&scene, &squares).unwrap();
            let once = found.back(&scene, found.corner([3, -2]), [1, 0]);
            let twice = found.back(&scene, once, [0, 1]);
            // What costs are computed from.
            let longest = digits(twice.over.iter().chain([&twice.under]));
            assert!(longest <= found.size_digits() + 32 + 2 * 2 * scene.letter, "{longest}");
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
