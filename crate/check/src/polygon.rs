//! The polygon, and how far its images reach.

use num_bigint::BigInt;

use crate::exact::Exact;
use crate::field::{Deviation, Field, cost_reading};
use crate::refused::Refused;
use crate::whole::{Factor, Whole};
use crate::work::{Work, digits, product};

/// The polygon and the maps as whole numbers, and the meter of what is done with them.
pub(crate) struct Scene<'a> {
    pub maps: Whole<6>,
    pub corners: Whole<2>,
    pub work: &'a Work,
    /// By so many binary digits numbers grow with each letter of a word.
    pub letter: u64,
    /// Binary digits of a corner.
    pub corner: u64,
    /// The leftmost corner, from which the lower side begins, and the rightmost, from which the upper one does.
    ends: [usize; 2],
    /// What entries of the maps are exactly, where they are not all their doubles.
    pub exact: Option<(Field, Deviation)>,
}

/// How far the image of the polygon reaches, as a whole number times `2^-bits`.
#[derive(Clone)]
pub(crate) struct Reach {
    pub far: BigInt,
    pub bits: u64,
}

impl Reach {
    /// Whether this one is less far.
    pub fn is_below(&self, other: &Self) -> bool {
        let most = self.bits.max(other.bits);
        (&self.far << (most - self.bits)) < (&other.far << (most - other.bits))
    }

    pub fn plus(&self, other: &Self) -> Self {
        let most = self.bits.max(other.bits);
        Self { far: (&self.far << (most - self.bits)) + (&other.far << (most - other.bits)), bits: most }
    }

    pub fn times(self, factor: &Factor) -> Self {
        Self { far: self.far * &factor.digits, bits: self.bits + factor.bits }
    }

    pub fn half(self) -> Self {
        Self { bits: self.bits + 1, ..self }
    }

    pub fn negative(self) -> Self {
        Self { far: -self.far, ..self }
    }
}

impl<'a> Scene<'a> {
    pub fn new(maps: &[[f64; 6]], polygon: &[[f64; 2]], work: &'a Work) -> Result<Self, Refused> {
        let maps = Whole::of(maps).ok_or(Refused::NotFinite { place: "maps" })?;
        let corners = Whole::of(polygon).ok_or(Refused::NotFinite { place: "corners" })?;
        let letter = digits(maps.rows.iter().flatten()).max(maps.bits) + 2;
        let corner = digits(corners.rows.iter().flatten()).max(corners.bits) + 2;
        let order = |&i: &usize, &j: &usize| corners.rows[i].cmp(&corners.rows[j]);
        let left = (0..polygon.len()).min_by(order).unwrap_or(0);
        let right = (0..polygon.len()).max_by(order).unwrap_or(0);
        Ok(Self { maps, corners, work, letter, corner, ends: [left, right], exact: None })
    }

    /// The same for maps whose entries are exact numbers. Words of `letters` letters take the polygon into itself,
    /// which is still to be checked.
    pub fn with_exact(
        mut self,
        exact: Option<&Exact>,
        maps: &[[f64; 6]],
        letters: usize,
    ) -> Result<Self, Refused> {
        let Some(exact) = exact else { return Ok(self) };
        self.work.afresh().spend(cost_reading(exact, maps)?)?;
        let field = Field::read(exact, maps)?;
        let deviation = Deviation::new(exact, maps, &self.corners, letters)?;
        self.exact = Some((field, deviation));
        Ok(self)
    }

    /// What it takes to read exact numbers, and [`Self::check_exact`].
    pub fn cost_exact(&self, exact: Option<&Exact>, maps: &[[f64; 6]]) -> Result<u64, Refused> {
        let read = exact.map_or(Ok(0), |exact| cost_reading(exact, maps))?;
        let check = self.exact.as_ref().map_or(0, |(field, deviation)| field.cost_check() + deviation.cost);
        Ok(read.saturating_add(check))
    }

    /// Checks that exact numbers are what they are said to be, and near their doubles.
    pub fn check_exact(&mut self, exact: Option<&Exact>, maps: &[[f64; 6]]) -> Result<(), Refused> {
        self.work.spend(self.cost_exact(exact, maps)?)?;
        self.exact.as_mut().map_or(Ok(()), |(field, _)| field.check(maps))
    }

    /// What [`Self::check_convex`] takes.
    pub fn cost_convex(&self) -> u64 {
        let corners = self.corners.rows.len() as u64;
        corners * corners * 4 * product(self.corner, self.corner)
    }

    /// Checks that each edge has all other corners strictly on its left.
    ///
    /// That each edge supports the hull of all corners, and that each corner begins one, makes the list the boundary of
    /// that hull: no star, no corner twice, and an inside.
    pub fn check_convex(&self) -> Result<(), Refused> {
        self.work.spend(self.cost_convex())?;
        let corners = &self.corners.rows;
        for (edge, [x, y]) in corners.iter().enumerate() {
            let next = (edge + 1) % corners.len();
            let [along_x, along_y] = [&corners[next][0] - x, &corners[next][1] - y];
            for (corner, [p, q]) in corners.iter().enumerate() {
                let is_end = corner == edge || corner == next;
                if !is_end && &along_x * (q - y) - &along_y * (p - x) <= BigInt::ZERO {
                    return Err(Refused::Polygon { edge, corner });
                }
            }
        }
        Ok(())
    }

    /// What [`Self::check_inside`] takes, for a word of so many letters.
    pub fn cost_inside(&self, letters: usize) -> u64 {
        (self.corners.rows.len() as u64).saturating_mul(self.cost_farthest(self.corner, letters))
    }

    /// Checks that a word maps every corner strictly to the left of every edge.
    pub fn check_inside(&self, word: &[u8]) -> Result<(), Refused> {
        let corners = &self.corners.rows;
        for (edge, [x, y]) in corners.iter().enumerate() {
            let [next_x, next_y] = &corners[(edge + 1) % corners.len()];
            // The outer normal, and how far the edge itself is along it.
            let normal = [next_y - y, x - next_x];
            let most = Reach { far: &normal[0] * x + &normal[1] * y, bits: 2 * self.corners.bits };
            if !self.farthest(word, normal, self.corners.bits)?.is_below(&most) {
                return Err(Refused::NotInside { word: word.to_vec() });
            }
        }
        Ok(())
    }

    /// What [`Self::farthest`] takes, for a normal of so many binary digits and a word of so many letters.
    pub fn cost_farthest(&self, normal: u64, letters: usize) -> u64 {
        let letters = letters as u64;
        let corners = u64::from(self.corners.rows.len().ilog2());
        let end = normal + letters * self.letter + self.corner;
        let follow = letters.saturating_mul(8 * product(end, self.letter));
        let deviation = self.exact.as_ref().map_or(0, |(_, deviation)| {
            letters.saturating_mul(2 * product(end + deviation.digits, deviation.digits))
        });
        follow.saturating_add((2 * corners + 12) * product(end, self.corner)).saturating_add(deviation)
    }

    /// The greatest `normal . x` over the image of the polygon under a word, where `normal` is given as whole multiples
    /// of `2^-bits`.
    ///
    /// `n . w_i(x) = (M_i^T n) . x + n . t_i`: instead of multiplying the maps, the direction is followed down the
    /// word. The polygon is known to be convex.
    ///
    /// Of maps whose entries are exact numbers it is a bound from above, see [`Deviation`].
    pub fn farthest(&self, word: &[u8], normal: [BigInt; 2], bits: u64) -> Result<Reach, Refused> {
        self.work.spend(self.cost_farthest(digits(&normal), word.len()))?;
        let [mut n_x, mut n_y] = normal;
        let mut moved = BigInt::ZERO;
        let mut off = self.exact.as_ref().map(|(_, deviation)| deviation.sum(self.maps.bits));
        for &letter in word {
            if let Some(off) = &mut off {
                off.add(usize::from(letter), [&n_x, &n_y]);
            }
            let [a, b, c, d, e, f] = &self.maps.rows[usize::from(letter)];
            moved = (moved << self.maps.bits) + &n_x * e + &n_y * f;
            (n_x, n_y) = (&n_x * a + &n_y * c, &n_x * b + &n_y * d);
        }
        let far = self.farthest_corner(&[n_x, n_y])?;
        let letters = word.len() as u64 * self.maps.bits;
        let reach =
            Reach { far: far + (moved << self.corners.bits), bits: bits + letters + self.corners.bits };
        Ok(match off {
            Some(off) => {
                let (far, bits) = off.whole(bits + letters);
                reach.plus(&Reach { far, bits })
            }
            None => reach,
        })
    }

    /// The greatest `normal . x` over the polygon.
    ///
    /// Along its lower side a direction that points down first rises, then falls, as each edge is turned further to the
    /// left; and so one that points up along the upper side. The corner where it ceases to rise is found by halving.
    /// A convex polygon lies between the lines from a corner to its neighbours: where neither of these is farther,
    /// nothing is.
    fn farthest_corner(&self, [n_x, n_y]: &[BigInt; 2]) -> Result<BigInt, Refused> {
        let corners = &self.corners.rows;
        let count = corners.len();
        let along = |k: usize| {
            let [x, y] = &corners[k % count];
            n_x * x + n_y * y
        };
        let [left, right] = self.ends;
        let (first, last) = if *n_y < BigInt::ZERO { (left, right) } else { (right, left) };
        let rises = |k: usize| {
            let ([x, y], [next_x, next_y]) = (&corners[k % count], &corners[(k + 1) % count]);
            n_x * (next_x - x) + n_y * (next_y - y) > BigInt::ZERO
        };
        let (mut low, mut high) = (first, first + (last + count - first) % count);
        while low < high {
            let middle = usize::midpoint(low, high);
            if rises(middle) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        let far = along(low);
        if along(low + 1) <= far && along(low + count - 1) <= far {
            return Ok(far);
        }
        // Only where it is not convex.
        self.work.spend(2 * count as u64 * product(digits([n_x, n_y]), self.corner))?;
        Ok((0..count).map(along).max().unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::ExactEntry;
    use crate::whole::unit;
    use crate::work::WORK;

    /// Against all corners, for polygons of whole numbers in all directions.
    #[test]
    fn the_farthest_corner_is_found() {
        let parabola = |from: i32, to: i32| -> Vec<[f64; 2]> {
            (from..=to).map(|x| [x, x * x]).map(|point| point.map(f64::from)).collect()
        };
        let both: Vec<[f64; 2]> =
            parabola(-3, 3).into_iter().chain([[2.0, 12.0], [0.0, 13.0], [-3.0, 11.0]]).collect();
        let polygons = [
            vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            vec![[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]],
            vec![[0.0, -2.0], [3.0, -2.0], [3.0, 1.0], [0.0, 5.0]],
            parabola(-20, 20),
            parabola(5, 70),
            both,
        ];
        for polygon in polygons {
            for turn in 0..polygon.len() {
                let mut polygon = polygon.clone();
                polygon.rotate_left(turn);
                let work = Work::at_most(WORK);
                let scene = Scene::new(&[[0.0; 6]], &polygon, &work).unwrap();
                scene.check_convex().unwrap();
                for (x, y) in (-9..=9).flat_map(|x| (-9..=9).map(move |y| (x, y))) {
                    let normal = [x, y].map(BigInt::from);
                    let dots = polygon.iter().map(|p| f64::from(x) * p[0] + f64::from(y) * p[1]);
                    let wanted = BigInt::from(dots.fold(f64::MIN, f64::max) as i64);
                    let before = work.spent();
                    assert_eq!(scene.farthest_corner(&normal), Ok(wanted), "{normal:?} {polygon:?}");
                    // It is not looked for among all.
                    assert_eq!(work.spent(), before);
                }
            }
        }
    }

    /// How long numbers become, which costs are computed from.
    #[test]
    fn numbers_are_not_longer_than_they_are_taken_to_be() {
        let (small, large) = (f64::from_bits(1), f64::MAX);
        for maps in [
            [[0.5, 0.25, -0.5, 0.75, 1.0, -2.0]; 2],
            [[large, large, -large, large, large, large]; 2],
            [[small, 0.0, 0.0, small, small, 1.0], [1.0, 1.0, -1.0, 1.0, large, small]],
            [[0.1, 0.2, 0.3, -0.4, 1e-300, 1e300], [3.0, 7.0, -7.0, 7.0, 0.0, 0.0]],
        ] {
            for corners in [[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], [[0.0, 0.0], [large, 0.0], [0.0, small]]] {
                let work = Work::at_most(u64::MAX);
                let scene = Scene::new(&maps, &corners, &work).unwrap();
                for (letters, normal) in [(0, [1.0, 1.0]), (1, [large, small]), (40, [-1.0, 3.0])] {
                    let word: Vec<u8> = (0..letters).map(|k| k % 2).collect();
                    let Whole { rows, bits } = Whole::of(&[normal]).unwrap();
                    let start = digits(&rows[0]).max(bits);
                    let end = start + word.len() as u64 * scene.letter + scene.corner;
                    let found = scene.farthest(&word, rows[0].clone(), bits).unwrap();
                    assert!(found.far.bits() <= end && found.bits <= end, "{letters} {normal:?}");
                }
            }
        }
    }

    /// Against maps whose entries are off by units in the last place.
    #[test]
    fn what_exact_numbers_reach_is_bounded() {
        // One letter takes points out of the box around this one, two do not.
        let slim = [[0.0, 20.0, 1.0 / 60.0, 0.0, 0.35, 0.0], [0.0, -20.0, 1.0 / 60.0, 0.0, -0.35, 0.0]];
        let wide = [[0.4, -0.3, 0.3, 0.4, 1.1, 0.5], [0.3, 0.2, -0.5, 0.1, -1.0, 0.0]];
        let square = [[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]];
        let mut seed = 5_u32;
        let mut roll = |most: u32| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 8) % most
        };
        for (maps, polygon, letters) in [
            (wide, square, 1),
            (wide, [[-4.0, -4.0], [4.0, -5.0], [5.0, 4.0], [-5.0, 5.0]], 1),
            (slim, square.map(|[x, y]| [x / 4.0, y / 400.0]), 2),
        ] {
            let work = Work::at_most(WORK);
            let listed: Vec<[u8; 2]> =
                (0..12).map(|k| [k / 6, k % 6]).filter(|_| letters > 1 || roll(3) > 0).collect();
            let entry = |&[map, entry]: &[u8; 2]| ExactEntry { map, entry, value: Vec::new() };
            let exact = Exact {
                polynomial: ["0", "1"].map(str::to_owned).to_vec(),
                root: ["-1", "1"].map(str::to_owned),
                entries: listed.iter().map(entry).collect(),
            };
            let plain = Scene::new(&maps, &polygon, &work).unwrap();
            let bound =
                Scene::new(&maps, &polygon, &work).unwrap().with_exact(Some(&exact), &maps, letters).unwrap();
            plain.check_convex().unwrap();
            for k in 0..4 {
                bound.check_inside(&[k % 2, k / 2][..letters]).unwrap();
            }
            // Of the bound this part is reached, in hundredths.
            let mut most = 0;
            for _ in 0..300 {
                let mut off = Scene::new(&maps, &polygon, &work).unwrap();
                let units = Whole::of(&maps.map(|row| row.map(unit))).unwrap();
                let bits = units.bits.max(off.maps.bits);
                for (k, row) in off.maps.rows.iter_mut().enumerate() {
                    for (n, x) in row.iter_mut().enumerate() {
                        *x <<= bits - plain.maps.bits;
                        if listed.contains(&[k as u8, n as u8]) {
                            *x += (&units.rows[k][n] << (bits - units.bits)) * (i64::from(roll(3)) - 1);
                        }
                    }
                }
                off.maps.bits = bits;
                let word: Vec<u8> = (0..=roll(6)).map(|_| roll(2) as u8).collect();
                let normal = [roll(9), roll(9)].map(|n| BigInt::from(n) - 4);
                let to = |scene: &Scene| scene.farthest(&word, normal.clone(), 0).unwrap();
                let [center, reached, bound] = [to(&plain), to(&off), to(&bound)];
                assert!(!bound.is_below(&reached), "{word:?} {normal:?}");
                let less = center.negative();
                let (part, all) = (reached.plus(&less), bound.plus(&less));
                let bits = part.bits.max(all.bits);
                let [part, all] = [part, all].map(|one| one.far << (bits - one.bits));
                if all != BigInt::ZERO {
                    most = most.max(i64::try_from(part * 100 / all).unwrap());
                }
            }
            assert!(most > 60, "{most}");
        }
    }
}
