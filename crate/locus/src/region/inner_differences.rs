//! Differences of points of an attractor whose maps have one linear part: enough of them to prove that copies meet.
//!
//! Copies of one shape, size and direction never cross, so that no trap holds them together. But for maps
//! `w_i(x) = L x + t_i` the copies `A_i` and `A_j` meet just if `t_j - t_i = L (a - b)` for points a, b of A, which is
//! to say that `L^-1 (t_j - t_i)` lies in the set of differences `D = A - A`. That is an attractor itself, of the maps
//! `x -> L x + d` for all differences `d = t_i - t_j`, since `a - b = L (a' - b') + t_i - t_j`.
//!
//! **Theorem.** Let K be a bounded set, each point x of which has some d with `L^-1 (x - d)` in K. Then K lies in D.
//! *Proof.* From x follow `x_1 = L^-1 (x - d_1)`, `x_2 = L^-1 (x_1 - d_2)`, and so on, all in K. Then
//! `x = d_1 + L d_2 + .. + L^(n-1) d_n + L^n x_n`, where the last term vanishes as n grows, since K is bounded
//! and L contracts; and sums of such d with powers of L are what D consists of.
//!
//! Here K is made of squares of a grid: of those that D may reach, the ones are left out whose way back leads out of
//! what is left for every d, until none is. As boxes are compared with room for rounding, what is left is proved.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

/// Squares across; a row is a word of so many bits.
const SIDE: usize = 64;
/// What comparisons leave for rounding, in squares.
const ROOM: f64 = 1e-6;
/// Points looked at for one difference.
const MOST_LOOKS: usize = 400;

/// Squares that hold nothing but differences of two points of an attractor.
#[derive(Clone, Debug, Default)]
pub(crate) struct InnerDifferences {
    /// The inverse of the linear part, in squares.
    back: DMat2,
    /// The translations' differences, in squares.
    digits: Vec<DVec2>,
    /// Of a length, in squares.
    scale: DVec2,
    rows: Vec<u64>,
    /// The number of the digit by which each square was last seen to lead back, for the lower half.
    by: Vec<u8>,
    open: Vec<Step>,
}

/// Column and row of a square, from the middle, and two maps.
pub(crate) type Square = ([i32; 2], [u8; 2]);

/// A point on the ways back from a vector.
#[derive(Clone, Copy, Debug)]
struct Step {
    at: DVec2,
    /// The number of the point before, and of the digit that led from it; of the vector itself 0.
    from: u16,
    digit: u8,
}

impl InnerDifferences {
    /// Works them out for maps as [`are_equal`](crate::gap::difference_set::are_equal) tells, whose attractor is as
    /// wide and as high as `size`. Whether there are any.
    pub fn begin(&mut self, maps: &[Affine2], size: DVec2) -> bool {
        let linear = maps[0].linear;
        self.scale = DVec2::splat(0.5 * SIDE as f64) / size;
        if !self.scale.is_finite() {
            return false;
        }
        let squares = DMat2::from_diagonal(self.scale);
        self.back = (squares * linear * squares.inverse()).inverse();
        self.digits.clear();
        self.digits.push(DVec2::ZERO);
        for (k, map) in maps.iter().enumerate() {
            for other in &maps[..k] {
                let digit = (map.translation - other.translation) * self.scale;
                self.digits.extend([digit, -digit]);
            }
        }
        debug_assert!(self.digits.len() <= 256, "a byte tells them apart");
        // So few copies, so small, can not cover what they are copies of.
        if !self.back.is_finite() || self.digits.len() as f64 <= self.back.determinant().abs() {
            return false;
        }
        // What held for the system before mostly holds for this one: it is as good a beginning as any.
        if self.rows.iter().any(|&row| row != 0) && self.settle() {
            return true;
        }
        self.rows.clear();
        self.rows.resize(SIDE, !0);
        self.by.resize(SIDE * SIDE / 2, 0);
        self.settle()
    }

    /// Whether this shows that the pieces of two of the maps meet.
    pub fn join(&mut self, maps: &[Affine2], i: usize, j: usize) -> bool {
        let step = (maps[j].translation - maps[i].translation) * self.scale;
        self.way_back(self.back * step).is_some()
    }

    /// The same, with the steps by which `L^-1 (t_j - t_i)` leads into the squares: for each step the maps k and l
    /// of `x -> L^-1 (x - (t_k - t_l))`.
    pub fn steps(&mut self, maps: &[Affine2], i: usize, j: usize) -> Option<Vec<[u8; 2]>> {
        let step = (maps[j].translation - maps[i].translation) * self.scale;
        let mut at = self.way_back(self.back * step)?;
        let mut steps = Vec::new();
        while at != 0 {
            let Step { from, digit, .. } = self.open[at];
            steps.push(maps_of(digit));
            at = usize::from(from);
        }
        steps.reverse();
        Some(steps)
    }

    /// How wide and how high a square is; and of each one its column and its row, from the middle, with the maps k and
    /// l by whose translations' difference it leads back.
    pub fn squares(&self) -> (DVec2, Vec<Square>) {
        let half = SIDE as i32 / 2;
        let mut all = Vec::new();
        for y in 0..SIDE / 2 {
            for x in (0..SIDE).filter(|x| self.rows[y] >> x & 1 == 1) {
                let [k, l] = maps_of(self.by[y * SIDE + x]);
                let (x, y) = (x as i32 - half, y as i32 - half);
                all.push(([x, y], [k, l]));
                all.push(([-1 - x, -1 - y], [l, k]));
            }
        }
        (1.0 / self.scale, all)
    }

    /// Where a vector, in squares, leads into those that are left, so that it surely is a difference: the number of the
    /// point among those that were looked at.
    fn way_back(&mut self, difference: DVec2) -> Option<usize> {
        self.open.clear();
        self.open.push(Step { at: difference, from: 0, digit: 0 });
        let mut next = 0;
        while next < self.open.len() && next < MOST_LOOKS {
            let Step { at, .. } = self.open[next];
            if self.within(at, DVec2::ZERO) {
                return Some(next);
            }
            for (k, &digit) in self.digits.iter().enumerate() {
                let before = self.back * (at - digit);
                if before.abs().max_element() < 0.5 * SIDE as f64 && self.open.len() < MOST_LOOKS {
                    self.open.push(Step { at: before, from: next as u16, digit: k as u8 });
                }
            }
            next += 1;
        }
        None
    }

    /// Leaves out squares until all that are left lead to such as are left; whether there are any.
    fn settle(&mut self) -> bool {
        let half = 0.5 * (self.back.x_axis.abs() + self.back.y_axis.abs());
        loop {
            let mut changed = false;
            let mut left = false;
            // Differences lie alike about 0, so that half of the rows tell the others.
            for y in 0..SIDE / 2 {
                let mut row = self.rows[y];
                while row != 0 {
                    let x = row.trailing_zeros() as usize;
                    row &= row - 1;
                    let middle = DVec2::new(x as f64, y as f64) + 0.5 - 0.5 * SIDE as f64;
                    if self.leads_back(x, y, middle, half) {
                        left = true;
                    } else {
                        self.rows[y] &= !(1 << x);
                        self.rows[SIDE - 1 - y] &= !(1 << (SIDE - 1 - x));
                        changed = true;
                    }
                }
            }
            if !changed {
                return left;
            }
        }
    }

    fn leads_back(&mut self, x: usize, y: usize, middle: DVec2, half: DVec2) -> bool {
        let last = usize::from(self.by[y * SIDE + x]);
        if self.digits.get(last).is_some_and(|&digit| self.within(self.back * (middle - digit), half)) {
            return true;
        }
        let found = self.digits.iter().position(|&digit| self.within(self.back * (middle - digit), half));
        if let Some(k) = found {
            self.by[y * SIDE + x] = k as u8;
        }
        found.is_some()
    }

    /// Whether a box lies in squares that are left.
    fn within(&self, middle: DVec2, half: DVec2) -> bool {
        let low = (middle - half - ROOM + 0.5 * SIDE as f64).floor();
        let high = (middle + half + ROOM + 0.5 * SIDE as f64).floor();
        if !(low.min_element() >= 0.0 && high.max_element() < SIDE as f64) {
            return false;
        }
        let mask = (!0 << low.x as u32) & (!0 >> (SIDE as u32 - 1 - high.x as u32));
        self.rows[low.y as usize..=high.y as usize].iter().all(|row| row & mask == mask)
    }
}

/// The maps k and l whose translations' difference is the digit of a number: first none, then those of 1 and 0, of 0
/// and 1, of 2 and 0, and so on.
fn maps_of(digit: u8) -> [u8; 2] {
    let Some(number) = digit.checked_sub(1) else { return [0, 0] };
    let (mut k, mut l) = (1, number / 2);
    while l >= k {
        l -= k;
        k += 1;
    }
    if number % 2 == 0 { [k, l] } else { [l, k] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn copies(factor: f64, translations: &[[f64; 2]]) -> Vec<Affine2> {
        translations.iter().map(|&[e, f]| Affine2::from_row([factor, 0.0, 0.0, factor, e, f])).collect()
    }

    #[test]
    fn a_filled_square_has_all_the_differences_of_a_square() {
        // Nine thirds of the unit square: their differences are 25 digits, and fill the square of twice its side.
        let thirds: Vec<[f64; 2]> =
            (0..9).map(|k| [f64::from(k % 3) * 2.0 / 3.0, f64::from(k / 3) * 2.0 / 3.0]).collect();
        let mut all = InnerDifferences::default();
        assert!(all.begin(&copies(1.0 / 3.0, &thirds), DVec2::splat(2.0)));
        for k in 0..200 {
            let angle = 0.1 * f64::from(k);
            let at = 1.9 * DVec2::from_angle(angle).clamp(DVec2::splat(-0.99), DVec2::splat(0.99));
            assert_eq!(all.way_back(at * all.scale).is_some(), at.abs().max_element() < 2.0, "{at}");
        }
        assert_eq!(all.way_back(DVec2::new(2.1, 0.0) * all.scale), None);
    }

    #[test]
    fn dust_has_none() {
        let corners = [[0.0, 0.0], [0.7, 0.0], [0.0, 0.7], [0.7, 0.7]];
        assert!(
            !InnerDifferences::default().begin(&copies(0.3, &corners), DVec2::ONE),
            "9 of 0.09 are too few"
        );
        // Seven of a line fill it, but nothing beside it.
        let line: Vec<[f64; 2]> = (0..7).map(|k| [f64::from(k) / 7.0, 0.0]).collect();
        assert!(!InnerDifferences::default().begin(&copies(0.5, &line), DVec2::new(1.7, 1.0)));
    }

    #[test]
    fn digits_are_of_the_maps_that_they_are_said_to_be_of() {
        let places: Vec<[f64; 2]> =
            (0..16).map(|k| [f64::from(k * k) / 256.0, f64::from(k % 5) / 8.0]).collect();
        let maps = copies(0.5, &places);
        let mut all = InnerDifferences::default();
        assert!(all.begin(&maps, DVec2::splat(2.0)));
        assert_eq!(all.digits.len(), 241);
        for (number, &digit) in all.digits.iter().enumerate() {
            let [k, l] = maps_of(number as u8).map(usize::from);
            let expected = (maps[k].translation - maps[l].translation) * all.scale;
            assert!(digit.abs_diff_eq(expected, 1e-12), "{number}: {k} {l}");
        }
    }

    #[test]
    fn what_held_before_does_not_lead_astray() {
        let corners = |at: f64| [[0.0, 0.0], [at, 0.0], [0.0, at], [at, at]];
        let mut all = InnerDifferences::default();
        assert!(all.begin(&copies(0.5, &corners(0.5)), DVec2::ONE));
        assert!(all.way_back(DVec2::splat(0.9) * all.scale).is_some());
        // The same with smaller copies: Cantor's dust, whose differences reach as far, but with holes.
        assert!(!all.begin(&copies(0.26, &corners(0.74)), DVec2::ONE));
    }
}
