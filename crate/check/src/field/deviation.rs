//! How far images of the polygon reach beyond those of doubles, where exact numbers are meant.

use num_bigint::BigInt;

use crate::exact::Exact;
use crate::refused::Refused;
use crate::whole::{Whole, unit};
use crate::work::{digits, product};

/// How far the exact map `w_i` is from the map `v_i` of doubles, anywhere that matters.
///
/// No entry is farther from its double than a unit in the last place of that. So on a box from `-r` to `r` with `r =
/// (r_1, r_2)` the first coordinate of `w_i(x) - v_i(x)` is at most `s_1 = u_a r_1 + u_b r_2 + u_e`, where `u` are the
/// units of what is not its double, and the second likewise.
///
/// For a word `u = i u'` one has `w_u - v_u = (w_i - v_i) w_u' + V_i (w_u' - v_u')`. Along a direction n the first term
/// is at most `|n_1| s_1 + |n_2| s_2` on the polygon P, if `w_u'(P)` is in the box. The second is what the shorter word
/// adds along `V_i^T n`, the direction that is followed down the word anyway.
///
/// The box holds P and its images under words of fewer letters than those that take P into itself. These are enough:
/// from a longer word the letters that are applied first can be taken away, that many at a time, for an image that is
/// larger. To show that they take P into itself no more than these are needed.
pub(crate) struct Deviation {
    /// For each map a bound of either coordinate, as whole multiples of `2^-bits`.
    most: Vec<[BigInt; 2]>,
    bits: u64,
    /// Binary digits of these.
    pub digits: u64,
    /// What it takes to find them.
    pub cost: u64,
}

/// What is added up down a word.
pub(crate) struct Sum<'a> {
    deviation: &'a Deviation,
    /// Binary digits behind the point of a map.
    letter: u64,
    far: BigInt,
}

impl Deviation {
    pub fn new(
        exact: &Exact,
        maps: &[[f64; 6]],
        corners: &Whole<2>,
        letters: usize,
    ) -> Result<Self, Refused> {
        let mut units = vec![[0.0; 6]; maps.len()];
        for entry in &exact.entries {
            let (map, entry) = (usize::from(entry.map), usize::from(entry.entry));
            units[map][entry] = unit(maps[map][entry]);
        }
        let both = Whole::of(&[maps, &units].concat()).ok_or(Refused::NotFinite { place: "maps" })?;
        let (rows, units) = both.rows.split_at(maps.len());
        let size = |x: &BigInt| BigInt::from(x.magnitude().clone());
        let across = |row: &[BigInt; 6], [x, y]: &[BigInt; 2], bits: u64| {
            let [a, b, c, d, e, f] = row;
            [a * x + b * y + (e << bits), c * x + d * y + (f << bits)]
        };
        let mut bits = corners.bits;
        let widest = |k: usize| corners.rows.iter().map(|corner| size(&corner[k])).max().unwrap_or_default();
        let mut reach = [widest(0), widest(1)];
        let wide = digits(both.rows.iter().flatten()).max(both.bits) + 2;
        let mut cost = 0_u64;
        for _ in 1..letters {
            let mut next = reach.each_ref().map(|x| x << both.bits);
            for (row, unit) in rows.iter().zip(units) {
                let row: [BigInt; 6] = std::array::from_fn(|k| size(&row[k]) + &unit[k]);
                let image = across(&row, &reach, bits);
                next = [0, 1].map(|k| next[k].clone().max(image[k].clone()));
            }
            cost = cost.saturating_add(maps.len() as u64 * 8 * product(wide, digits(&reach)));
            reach = next;
            bits += both.bits;
        }
        let most: Vec<_> = units.iter().map(|unit| across(unit, &reach, bits)).collect();
        let cost = cost.saturating_add(maps.len() as u64 * 8 * product(wide, digits(&reach)));
        let bits = bits + both.bits;
        let digits = digits(most.iter().flatten()).max(bits) + 2;
        Ok(Self { most, bits, digits, cost })
    }

    pub fn sum(&self, letter: u64) -> Sum<'_> {
        Sum { deviation: self, letter, far: BigInt::ZERO }
    }
}

impl Sum<'_> {
    /// One letter further down the word, along a direction that has as many times the binary digits of a letter behind
    /// the point as letters were added before.
    pub fn add(&mut self, letter: usize, [n_x, n_y]: [&BigInt; 2]) {
        let [x, y] = &self.deviation.most[letter];
        let more = BigInt::from(n_x.magnitude() * x.magnitude() + n_y.magnitude() * y.magnitude());
        self.far = (&self.far << self.letter) + more;
    }

    /// All of it, and how many binary digits it has behind the point, where the direction that comes next has so many.
    pub fn whole(self, bits: u64) -> (BigInt, u64) {
        // The last that was added has those of one letter fewer.
        (self.far << self.letter, bits + self.deviation.bits)
    }
}
