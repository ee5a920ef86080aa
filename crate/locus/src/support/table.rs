//! A convex polygon around the attractor as a table of support values.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::support::extremes::larger;
use crate::support::f64x4::{DVec2x4, F64x4};

/// The support function `h(d) = max { d . x : x in A }` of an attractor, bounded from above in a fan of
/// directions, with a point of the attractor that comes near each bound.
///
/// The directions lie evenly on the boundary of the square [-1, 1]^2 instead of the circle: then finding
/// the two that enclose a given one takes a division and no arc tangent. `h` is convex and homogeneous,
/// so that between two directions it lies below the line through its values.
#[derive(Clone, Debug)]
pub(crate) struct SupportTable {
    /// Directions on each side of the square.
    per: usize,
    /// Upper bounds of `h`; the first ones again at the end.
    values: [f64; TABLE],
    /// Points of the attractor far out in each direction; the first ones again at the end.
    points: [DVec2; TABLE],
    links: Vec<Lowering>,
}

/// How the supports in four neighbouring directions of the image under one map follow from the table.
#[derive(Clone, Copy, Debug)]
struct Lowering {
    low: [u8; 4],
    near: [u8; 4],
    from_low: F64x4,
    from_high: F64x4,
    shift: F64x4,
}

/// Where directions lie in the fan.
#[derive(Clone, Copy)]
struct Place {
    /// The one before, or at its very beginning the one itself.
    low: [usize; 4],
    /// The nearest one.
    near: [usize; 4],
    /// How far along the sector.
    along: F64x4,
    /// Their length in the maximum norm.
    length: F64x4,
}

/// 1.5 * 2^52: floats around here are whole, and hold their number in their lowest bits.
const ROUND_TO_WHOLE: f64 = 6_755_399_441_055_744.0;
/// As many as seven bits reach, and one more: so NaN, which may give any, reads nothing outside.
const TABLE: usize = INDEX_MASK as usize + 2;
const INDEX_MASK: u64 = 127;

/// Places four directions in a fan of `per` a side.
///
/// Directions come in no order, so that a branch on them would be guessed wrong half the time: there is none.
#[inline(always)]
fn locate(per: usize, d: DVec2x4) -> Place {
    let per = per as f64;
    let (across, up) = (d.x.abs(), d.y.abs());
    let large = across.choose_less(up, d.y, d.x);
    let small = across.choose_less(up, -d.x, d.y);
    // The sides in their order: right, top, left, bottom.
    let steep = across.choose_less(up, F64x4::splat(per), F64x4::default());
    let side = steep + large.choose_less(F64x4::default(), F64x4::splat(2.0 * per), F64x4::default());
    // Of the zero vector the quotient is NaN: it lies at the beginning of a side, at length 0. All others are within 1.
    let slope = (small / large).max(F64x4::splat(-1.0));
    let along = slope * F64x4::splat(0.5 * per) + F64x4::splat(0.5 * per);
    // The nearest whole number below, or that just above which is one sector on at its very beginning.
    let whole = along - F64x4::splat(0.5) + F64x4::splat(ROUND_TO_WHOLE);
    let index = |x: F64x4| x.to_array().map(|x| (x.to_bits() & INDEX_MASK) as usize);
    Place {
        low: index(whole + side),
        near: index(along + side + F64x4::splat(ROUND_TO_WHOLE)),
        along: along - (whole - F64x4::splat(ROUND_TO_WHOLE)),
        length: large.abs(),
    }
}

impl Default for SupportTable {
    fn default() -> Self {
        Self { per: FINE_PER_SIDE, values: [1.0; TABLE], points: [DVec2::ZERO; TABLE], links: Vec::new() }
    }
}

/// Directions a side of a fan that is to be as tight as can be, and of one that is to be made quickly.
const FINE_PER_SIDE: usize = 8;
const ROUGH_PER_SIDE: usize = 4;
/// The same where very many looks are to be saved.
const FINEST_PER_SIDE: usize = 16;

impl SupportTable {
    /// Bounds the attractor of `maps`, which is known to lie in the unit disc: support values are lowered
    /// from those of the disc by `h(d) <= max_i ( h(M_i^T d) + t_i . d )` until they settle to `accuracy`
    /// or after `rounds`.
    ///
    /// Every value on the way is a bound, so that new ones may be used at once.
    pub fn set(&mut self, maps: &[Affine2], accuracy: f64, rounds: usize) {
        self.bound(FINE_PER_SIDE, maps, accuracy, rounds);
    }

    /// [`SupportTable::set`] in twice as many directions.
    pub fn set_finest(&mut self, maps: &[Affine2], accuracy: f64, rounds: usize) {
        self.bound(FINEST_PER_SIDE, maps, accuracy, rounds);
    }

    /// [`SupportTable::set`] in half as many directions.
    pub fn sketch(&mut self, maps: &[Affine2], accuracy: f64, rounds: usize) {
        self.bound(ROUGH_PER_SIDE, maps, accuracy, rounds);
    }

    /// Bounds the differences of two points of the attractor of maps that share one linear part, `powers[1]`: sums
    /// of `powers[k]` times a difference of two `shifts`, over all k. `rest` bounds the lengths of what the
    /// powers leave out.
    ///
    /// In a direction of the fan the sum of the widths of the shifts is what the support is, exactly; the
    /// differences that reach farthest, and 0 without end after, add up to a point.
    pub fn set_differences(&mut self, powers: &[DMat2], shifts: &[DVec2], rest: f64) {
        self.per = ROUGH_PER_SIDE;
        self.values = [4.0; TABLE];
        self.points = [DVec2::ZERO; TABLE];
        let half = 2 * self.per;
        for k in (0..half).step_by(4) {
            let four = [k, k + 1, k + 2, k + 3].map(|k| self.direction(k));
            let d = DVec2x4::new(four);
            let mut far = d.dot(d).sqrt() * F64x4::splat(rest);
            let mut point = DVec2x4::default();
            for power in powers {
                let pulled = DVec2x4 {
                    x: DVec2x4::splat(power.x_axis).dot(d),
                    y: DVec2x4::splat(power.y_axis).dot(d),
                };
                let (wide, difference) = match shifts {
                    [a, b] => width_of_two(*a - *b, pulled),
                    _ => width(shifts, pulled),
                };
                far = far + wide;
                let (x, y) = (DVec2x4::splat(power.x_axis), DVec2x4::splat(power.y_axis));
                point.x = point.x + x.x * difference.x + y.x * difference.y;
                point.y = point.y + x.y * difference.x + y.y * difference.y;
            }
            for l in 0..4 {
                let p = point.at(l);
                (self.values[k + l], self.points[k + l]) = (far.to_array()[l] * (1.0 + 1e-12), p);
                (self.values[k + l + half], self.points[k + l + half]) = (self.values[k + l], -p);
            }
        }
        self.wrap(|table, k, from| {
            (table.values[k], table.points[k]) = (table.values[from], table.points[from]);
        });
    }

    /// Points of the attractor, far out in every direction of the fan.
    pub fn points(&self) -> &[DVec2] {
        &self.points[..4 * self.per]
    }

    /// Whether it was last made by [`SupportTable::set`] or [`SupportTable::set_finest`].
    pub fn is_fine(&self) -> bool {
        self.per >= FINE_PER_SIDE
    }

    /// Whether it was last made by [`SupportTable::set_finest`].
    pub fn is_finest(&self) -> bool {
        self.per == FINEST_PER_SIDE
    }

    fn bound(&mut self, per: usize, maps: &[Affine2], accuracy: f64, rounds: usize) {
        self.per = per;
        // Nothing of what was here before is left, not even where only NaN looks.
        self.values = [1.5; TABLE];
        self.links.clear();
        for k in (0..4 * per).step_by(4) {
            let four = [k, k + 1, k + 2, k + 3].map(|k| self.direction(k));
            let d = DVec2x4::new(four);
            for map in maps {
                let (x, y) = (DVec2x4::splat(map.linear.x_axis), DVec2x4::splat(map.linear.y_axis));
                let place = locate(per, DVec2x4 { x: x.dot(d), y: y.dot(d) });
                self.links.push(Lowering {
                    low: place.low.map(|low| low as u8),
                    near: place.near.map(|near| near as u8),
                    from_low: place.length * (F64x4::splat(1.0) - place.along),
                    from_high: place.length * place.along,
                    shift: DVec2x4::splat(map.translation).dot(d),
                });
            }
            self.values[k..k + 4].copy_from_slice(&(d.dot(d).sqrt() * F64x4::splat(1.0 + 1e-12)).to_array());
        }
        self.wrap(|table, k, from| table.values[k] = table.values[from]);
        for _ in 0..rounds {
            if self.lower(maps.len()) < accuracy {
                break;
            }
        }
        self.reach(maps, accuracy, rounds);
    }

    /// One round; returns by how much a value fell at most.
    fn lower(&mut self, maps: usize) -> f64 {
        let mut change = F64x4::default();
        for (chunk, links) in self.links.chunks_exact(maps).enumerate() {
            let mut best = F64x4::splat(f64::NEG_INFINITY);
            for link in links {
                best = best.max(self.far(link));
            }
            let values = &mut self.values[4 * chunk..4 * chunk + 4];
            let old = F64x4::new([values[0], values[1], values[2], values[3]]);
            change = change.max(old - best);
            values.copy_from_slice(&old.min(best).to_array());
        }
        self.wrap(|table, k, from| table.values[k] = table.values[from]);
        change.to_array().into_iter().fold(0.0, larger)
    }

    /// How far the image under a map reaches in four directions, as far as the table tells.
    #[inline(always)]
    fn far(&self, link: &Lowering) -> F64x4 {
        let gather = |step: usize| {
            F64x4::new(link.low.map(|low| self.values[(usize::from(low) & INDEX_MASK as usize) + step]))
        };
        link.from_low * gather(0) + link.from_high * gather(1) + link.shift
    }

    /// Finds points: each is the image of one before under the map that reaches farthest.
    fn reach(&mut self, maps: &[Affine2], accuracy: f64, rounds: usize) {
        let fan = 4 * self.per;
        let mut steps = [(0_u8, 0_u8); 4 * FINEST_PER_SIDE];
        for (chunk, links) in self.links.chunks_exact(maps.len()).enumerate() {
            let mut best = [f64::NEG_INFINITY; 4];
            for (i, link) in links.iter().enumerate() {
                let values = self.far(link).to_array();
                for k in 0..4 {
                    if values[k] > best[k] {
                        best[k] = values[k];
                        steps[4 * chunk + k] = (i as u8, link.near[k]);
                    }
                }
            }
        }
        let start = maps.iter().find_map(|map| map.fixed_point()).unwrap_or(DVec2::ZERO);
        self.points = [start; TABLE];
        // As many passes as shrink what the start is off to the accuracy.
        let square = |map: &Affine2| map.linear.x_axis.length_squared() + map.linear.y_axis.length_squared();
        let shrinks = maps.iter().map(|map| 0.5 * square(map)).fold(0.0, larger).clamp(1e-3, 0.9999);
        let passes = (2.0 * accuracy.ln() / shrinks.ln()).clamp(2.0, rounds as f64) as usize;
        for _ in 0..passes {
            for (k, &(i, near)) in steps[..fan].iter().enumerate() {
                self.points[k] = maps[usize::from(i)].apply(self.points[usize::from(near) % fan]);
            }
        }
        self.wrap(|table, k, from| table.points[k] = table.points[from]);
    }

    /// Repeats the beginning of the fan at its end, as far as [`locate`] may reach.
    #[inline(always)]
    fn wrap(&mut self, copy: impl Fn(&mut Self, usize, usize)) {
        let fan = 4 * self.per;
        for k in fan..fan + 3 {
            copy(self, k, k - fan);
        }
    }

    /// Direction `k` of the fan.
    fn direction(&self, k: usize) -> DVec2 {
        let s = (k % self.per) as f64 * (2.0 / self.per as f64) - 1.0;
        match k / self.per % 4 {
            0 => DVec2::new(1.0, s),
            1 => DVec2::new(-s, 1.0),
            2 => DVec2::new(-1.0, -s),
            _ => DVec2::new(s, -1.0),
        }
    }

    /// Upper bounds of `h(d)`, and points of the attractor that come near them.
    #[inline(always)]
    pub fn support4(&self, d: DVec2x4) -> (F64x4, DVec2x4) {
        let place = locate(self.per, d);
        let gather = |step: usize| F64x4::new(place.low.map(|low| self.values[low + step]));
        let (a, b) = (gather(0), gather(1));
        let points = place.near.map(|near| self.points[near]);
        let points = DVec2x4::new(points);
        (place.length * (a + place.along * (b - a)), points)
    }

    /// [`SupportTable::support4`] in one direction.
    pub fn support(&self, d: DVec2) -> (f64, DVec2) {
        let (far, points) = self.support4(DVec2x4::splat(d));
        (far.to_array()[0], points.at(0))
    }

    /// The diameter of the attractor, at most, where lengths are measured after `to_plane`.
    pub fn diameter(&self, to_plane: DMat2) -> f64 {
        let (x, y) = (DVec2x4::splat(to_plane.x_axis), DVec2x4::splat(to_plane.y_axis));
        let mut widest = F64x4::default();
        for k in (0..2 * self.per).step_by(4) {
            let four = [k, k + 1, k + 2, k + 3].map(|k| self.direction(k));
            let d = DVec2x4::new(four);
            let pulled = DVec2x4 { x: x.dot(d), y: y.dot(d) };
            let (there, _) = self.support4(pulled);
            let (back, _) = self.support4(DVec2x4 { x: -pulled.x, y: -pulled.y });
            widest = widest.max((there + back) / d.dot(d).sqrt());
        }
        // The two points farthest apart lie along a direction at most half a step off one of the fan, and the
        // widest step is at the middle of a side.
        let cosine = match self.per {
            FINEST_PER_SIDE => 0.998_067_602,
            FINE_PER_SIDE => 0.992_507_556,
            _ => 0.973_248_989,
        };
        widest.to_array().into_iter().fold(0.0, larger) / cosine
    }
}

/// The widths of points in four directions, and the differences that they are the lengths of.
#[inline(always)]
fn width(points: &[DVec2], d: DVec2x4) -> (F64x4, DVec2x4) {
    let (mut most, mut least) = (F64x4::splat(f64::NEG_INFINITY), F64x4::splat(f64::INFINITY));
    let (mut first, mut last) = (DVec2x4::default(), DVec2x4::default());
    for &point in points {
        let p = DVec2x4::splat(point);
        let along = p.dot(d);
        let choose = |a: F64x4, b: F64x4, old: DVec2x4| DVec2x4 {
            x: a.choose_less(b, p.x, old.x),
            y: a.choose_less(b, p.y, old.y),
        };
        (first, last) = (choose(most, along, first), choose(along, least, last));
        (most, least) = (most.max(along), least.min(along));
    }
    (most - least, first - last)
}

/// [`width`] of two points with this difference.
#[inline(always)]
fn width_of_two(difference: DVec2, d: DVec2x4) -> (F64x4, DVec2x4) {
    let p = DVec2x4::splat(difference);
    let along = p.dot(d);
    let signed = |x: F64x4| along.choose_less(F64x4::default(), -x, x);
    (along.abs(), DVec2x4 { x: signed(p.x), y: signed(p.y) })
}

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
    fn a_piece_that_is_all_but_a_point_bounds_nothing_too_narrowly() {
        // Halves of the segment from 0 to 1/2, and a third map that shrinks all but to 0.
        let half = |e: f64| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, 0.0]);
        let mut table = SupportTable::default();
        for least in numbers().into_iter().filter(|x| x.abs() < 1e-100) {
            let point = Affine2::from_row([least, least, -least, 0.0, 0.0, 0.0]);
            for per in [ROUGH_PER_SIDE, FINE_PER_SIDE, FINEST_PER_SIDE] {
                table.bound(per, &[half(0.0), half(0.25), point], 1e-6, 64);
                for k in 0..4 * per {
                    let d = table.direction(k);
                    let (far, at) = table.support(d);
                    assert!(far.is_finite() && far >= d.x.max(0.0) * 0.5, "{least} {per} {k}: {far}");
                    assert!(at.is_finite() && (0.0..=0.5).contains(&at.x), "{least} {per} {k}: {at}");
                }
                assert!((0.5..0.52).contains(&table.diameter(DMat2::IDENTITY)), "{least} {per}");
            }
        }
    }

    #[test]
    fn vectors_of_all_sizes_have_a_support() {
        // The square from 0 to 1/2 of four quarters: the support along (x, y) is that of a corner.
        let quarter = |e: f64, f: f64| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]);
        let maps = [quarter(0.0, 0.0), quarter(0.25, 0.0), quarter(0.0, 0.25), quarter(0.25, 0.25)];
        let mut table = SupportTable::default();
        table.set(&maps, 1e-9, 200);
        for x in numbers() {
            for y in numbers() {
                let corner = 0.5 * (x.max(0.0) + y.max(0.0));
                let (far, _) = table.support(DVec2::new(x, y));
                let off = far - corner;
                let size = x.abs().max(y.abs());
                assert!(off >= -1e-15 * size - f64::from_bits(8), "{x} {y}: {far} {corner}");
                assert!(off <= 0.1 * size + f64::from_bits(8), "{x} {y}: {far} {corner}");
            }
        }
    }
}
