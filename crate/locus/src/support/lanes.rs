//! Support values of an attractor in several systems at once.
#![expect(clippy::needless_range_loop, reason = "a lane is the same place in several arrays")]

use frond_core::Affine2;
use glam::DVec2;

use crate::support::extremes::{larger, lesser};

/// Directions on each side of the square.
const DIRECTIONS_A_SIDE: usize = 8;
/// Directions in all.
pub(crate) const DIRECTIONS: usize = 4 * DIRECTIONS_A_SIDE;
/// The fan, once round and on, as far as [`locate`] may reach.
const TABLE: usize = 3 * DIRECTIONS_A_SIDE + 17;

/// One map in the systems of each lane.
pub(crate) type Maps<const L: usize> = [Affine2; L];
/// One point of the attractor, by its address, in the systems of each lane.
pub(crate) type Points<const L: usize> = [DVec2; L];

/// What [`SupportTable`](crate::support::table::SupportTable) is for one system, for L systems that differ little:
/// upper bounds of the support function of each, and points far out that have the same address in all.
#[derive(Clone, Debug)]
pub(crate) struct SupportLanes<const L: usize> {
    values: [[f64; L]; TABLE],
    points: [Points<L>; TABLE],
    links: Vec<Lowering<L>>,
}

/// How the supports in one direction of the images under one map follow from the table.
#[derive(Clone, Copy, Debug)]
struct Lowering<const L: usize> {
    low: [u32; L],
    near: u32,
    from_low: [f64; L],
    from_high: [f64; L],
    shift: [f64; L],
}

impl<const L: usize> Lowering<L> {
    /// Of no map.
    const NONE: Self =
        Self { low: [0; L], near: 0, from_low: [0.0; L], from_high: [0.0; L], shift: [0.0; L] };
}

/// Direction `k` of the fan, on the boundary of the square [-1, 1]^2, counter-clockwise.
pub(crate) fn direction(k: usize) -> DVec2 {
    let s = (k % DIRECTIONS_A_SIDE) as f64 * (2.0 / DIRECTIONS_A_SIDE as f64) - 1.0;
    match k / DIRECTIONS_A_SIDE % 4 {
        0 => DVec2::new(1.0, s),
        1 => DVec2::new(-s, 1.0),
        2 => DVec2::new(-1.0, -s),
        _ => DVec2::new(s, -1.0),
    }
}

/// The sector that `d` lies in, how far along it, and the length of `d` in the maximum norm; without a branch,
/// as in [`table`](crate::support::table).
#[inline(always)]
pub(crate) fn locate(d: DVec2) -> (usize, f64, f64) {
    let steep = d.x.abs() < d.y.abs();
    let (large, small) = if steep { (d.y, -d.x) } else { (d.x, d.y) };
    // Of the zero vector the quotient is NaN: it lies at the beginning of a side, at length 0. All others are within 1.
    let slope = larger(-1.0, small / large);
    let along = slope * (DIRECTIONS_A_SIDE as f64 / 2.0) + (DIRECTIONS_A_SIDE as f64 / 2.0);
    let side = 2 * (large.to_bits() >> 63) as usize + usize::from(steep);
    // 1.5 * 2^52: floats around there are whole, and hold the nearest whole number in their lowest bits.
    let low = ((along - 0.5 + 6_755_399_441_055_744.0).to_bits() & 15) as usize;
    (side * DIRECTIONS_A_SIDE + low, along - low as f64, large.abs())
}

impl<const L: usize> Default for SupportLanes<L> {
    fn default() -> Self {
        Self { values: [[1.0; L]; TABLE], points: [[DVec2::ZERO; L]; TABLE], links: Vec::new() }
    }
}

impl<const L: usize> SupportLanes<L> {
    /// Bounds the attractors of the systems, all known to lie in the unit disc; see
    /// [`SupportTable::set`](crate::support::table::SupportTable::set).
    pub fn set(&mut self, maps: &[Maps<L>], accuracy: f64, rounds: usize) {
        // Written in place, as each copy of one is a call in WebAssembly.
        self.links.resize(DIRECTIONS * maps.len(), Lowering::NONE);
        for (k, links) in self.links.chunks_exact_mut(maps.len()).enumerate() {
            let d = direction(k);
            for (map, link) in maps.iter().zip(links) {
                for l in 0..L {
                    let (low, along, length) = locate(map[l].linear.transpose() * d);
                    link.low[l] = low as u32;
                    link.from_low[l] = length * (1.0 - along);
                    link.from_high[l] = length * along;
                    link.shift[l] = map[l].translation.dot(d);
                    if l == 0 {
                        link.near = (low + usize::from(along > 0.5)) as u32;
                    }
                }
            }
            self.values[k] = [d.length() * (1.0 + 1e-12); L];
        }
        // One address for all lanes: that of the first map that has a fixed point in each.
        let start = maps.iter().find_map(|map| {
            let mut start = [DVec2::ZERO; L];
            for l in 0..L {
                start[l] = map[l].fixed_point()?;
            }
            Some(start)
        });
        self.points = [start.unwrap_or([DVec2::ZERO; L]); TABLE];
        self.wrap();
        for _ in 0..rounds {
            if self.lower(maps) < accuracy {
                break;
            }
        }
    }

    /// One round; returns by how much a value fell at most.
    fn lower(&mut self, maps: &[Maps<L>]) -> f64 {
        let mut change = 0.0_f64;
        for (k, links) in self.links.chunks_exact(maps.len()).enumerate() {
            let mut best = [f64::NEG_INFINITY; L];
            let mut most = f64::NEG_INFINITY;
            let mut arg = 0;
            for (i, link) in links.iter().enumerate() {
                let mut sum = 0.0;
                for l in 0..L {
                    let low = link.low[l] as usize;
                    let value = link.from_low[l] * self.values[low][l]
                        + link.from_high[l] * self.values[low + 1][l]
                        + link.shift[l];
                    best[l] = larger(best[l], value);
                    sum += value;
                }
                if sum > most {
                    most = sum;
                    arg = i;
                }
            }
            let near = links[arg].near as usize;
            for l in 0..L {
                self.points[k][l] = maps[arg][l].apply(self.points[near][l]);
                let fall = self.values[k][l] - best[l];
                if fall > 0.0 {
                    change = larger(change, fall);
                    self.values[k][l] = best[l];
                }
            }
        }
        self.wrap();
        change
    }

    /// Repeats the beginning of the fan at its end.
    fn wrap(&mut self) {
        // In one go: WebAssembly calls out for each copy.
        self.values.copy_within(..TABLE - DIRECTIONS, DIRECTIONS);
        self.points.copy_within(..TABLE - DIRECTIONS, DIRECTIONS);
    }

    /// An upper bound of the support function of one lane's attractor, and the number of a point that comes
    /// near it.
    #[inline(always)]
    pub fn support(&self, d: DVec2, lane: usize) -> (f64, usize) {
        let (low, along, length) = locate(d);
        let (a, b) = (self.values[low][lane], self.values[low + 1][lane]);
        (length * (a + along * (b - a)), low + usize::from(along > 0.5))
    }

    /// A point by its number.
    #[inline(always)]
    pub fn point(&self, number: usize, lane: usize) -> DVec2 {
        self.points[number][lane]
    }

    /// The radius of a disc about the origin that holds the attractors of all lanes.
    pub fn radius(&self) -> f64 {
        // Between two directions the hull goes farther out by up to the cosine of half their angle.
        let far = |k: usize| self.values[k].iter().copied().fold(0.0, larger) / direction(k).length();
        (0..DIRECTIONS).map(far).fold(0.0, larger) / 0.992_507_556
    }

    /// An upper bound of the width of the attractors of all lanes in the direction of `d` over its length, the
    /// most over the fan, and a distance between two points of the attractor that is the least over the lanes.
    pub fn diameter(&self) -> (f64, f64) {
        let (mut upper, mut lower) = (0.0_f64, 0.0_f64);
        let apart = |k: usize, m: usize| {
            let each = self.points[k].iter().zip(&self.points[m]);
            each.map(|(p, q)| p.distance_squared(*q)).fold(f64::INFINITY, lesser)
        };
        for k in 0..DIRECTIONS / 2 {
            let length = direction(k).length();
            for l in 0..L {
                upper = larger(upper, (self.values[k][l] + self.values[k + DIRECTIONS / 2][l]) / length);
            }
            // The points farthest apart need not be opposite each other.
            for m in k + DIRECTIONS / 2 - DIRECTIONS_ASIDE..=k + DIRECTIONS / 2 + DIRECTIONS_ASIDE {
                lower = larger(lower, apart(k, m % DIRECTIONS));
            }
        }
        (upper / 0.992_507_556, lower.sqrt())
    }
}

/// How many directions off the opposite one the farthest point is looked for.
const DIRECTIONS_ASIDE: usize = 2;

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths that quotients and squares go wrong at, and usual ones.
    fn numbers() -> Vec<f64> {
        let least = f64::MIN_POSITIVE;
        let sizes = [
            0.0,
            f64::from_bits(1),
            0.5 * least,
            least.next_down(),
            least,
            1.5 * least,
            1e-300,
            1e-160,
            0.3,
            1.0,
        ];
        sizes.into_iter().chain([1e100]).flat_map(|x| [x, -x]).collect()
    }

    #[test]
    fn vectors_of_all_sizes_lie_in_their_sector() {
        for x in numbers() {
            for y in numbers() {
                let (low, along, length) = locate(DVec2::new(x, y));
                assert!(low < DIRECTIONS && (0.0..=1.0).contains(&along), "{x} {y}: {low} {along}");
                assert_eq!(length, x.abs().max(y.abs()));
                let there = direction(low).lerp(direction(low + 1), along) * length;
                let off = (there - DVec2::new(x, y)).abs().max_element();
                assert!(off <= 1e-15 * length + f64::from_bits(4), "{x} {y}: {there}");
            }
        }
    }

    #[test]
    fn a_piece_that_is_all_but_a_point_bounds_nothing_too_narrowly() {
        // Halves of the segment from 0 to 1/2, and a third map that shrinks all but to 0.
        let mut lanes = SupportLanes::<1>::default();
        for least in numbers().into_iter().filter(|x| x.abs() < 1e-100) {
            let half = |e: f64| [Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, 0.0])];
            let point = [Affine2::from_row([least, least, -least, 0.0, 0.0, 0.0])];
            lanes.set(&[half(0.0), half(0.25), point], 1e-6, 64);
            for k in 0..DIRECTIONS {
                let (far, _) = lanes.support(direction(k), 0);
                assert!(far.is_finite() && far >= direction(k).x.max(0.0) * 0.5, "{least} {k}: {far}");
            }
            assert!(lanes.radius() >= 0.5 && lanes.radius() <= 1.1, "{least}: {}", lanes.radius());
        }
    }
}
