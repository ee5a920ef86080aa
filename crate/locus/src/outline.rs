//! A convex polygon around the attractor as a table of support values.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

/// Directions on each side of the square.
const PER: usize = 8;
/// Directions in all.
pub(crate) const FAN: usize = 4 * PER;

/// The support function `h(d) = max { d . x : x in A }` of an attractor, bounded from above in a fan of
/// directions, with a point of the attractor that comes near each bound.
///
/// The directions lie evenly on the boundary of the square [-1, 1]^2 instead of the circle: then finding
/// the two that enclose a given one takes a division and no arc tangent. `h` is convex and homogeneous,
/// so that between two directions it lies below the line through its values.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    /// Upper bounds of `h`; the first ones again at the end.
    values: [f64; TABLE],
    /// Points of the attractor far out in each direction; the first ones again at the end.
    points: [DVec2; TABLE],
    links: Vec<Link>,
}

/// How the support in one direction of the image under one map follows from the table.
#[derive(Clone, Copy, Debug)]
struct Link {
    low: u32,
    near: u32,
    from_low: f64,
    from_high: f64,
    shift: f64,
}

/// Direction `k` of the fan.
pub(crate) fn direction(k: usize) -> DVec2 {
    let s = (k % PER) as f64 * (2.0 / PER as f64) - 1.0;
    match k / PER % 4 {
        0 => DVec2::new(1.0, s),
        1 => DVec2::new(-s, 1.0),
        2 => DVec2::new(-1.0, -s),
        _ => DVec2::new(s, -1.0),
    }
}

/// The sector that `d` lies in, how far along it, and the length of `d` in the maximum norm.
///
/// Directions come in no order, so that a branch on them would be guessed wrong half the time: there is none.
#[inline(always)]
fn locate(d: DVec2) -> (usize, f64, f64) {
    let steep = d.x.abs() < d.y.abs();
    let large = select(steep, d.y, d.x);
    let small = select(steep, -d.x, d.y);
    // The zero vector lies in any sector, at length 0.
    let slope = small / (large + f64::MIN_POSITIVE);
    let along = slope * (PER as f64 / 2.0) + (PER as f64 / 2.0);
    // The sides in their order: right, top, left, bottom.
    let side = 2 * (large.to_bits() >> 63) as usize + usize::from(steep);
    // The nearest whole number below, or that just above which is one sector on at its very beginning: a float
    // of this size holds it in its lowest bits. NaN gives any.
    let low = ((along - 0.5 + WHOLE).to_bits() & 15) as usize;
    (side * PER + low, along - low as f64, large.abs())
}

/// 1.5 * 2^52: floats around here are whole.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// The fan, once round and on, as far as [`locate`] may reach.
const TABLE: usize = 3 * PER + 17;

/// `a` if `first`, else `b`, without a branch.
#[inline(always)]
fn select(first: bool, a: f64, b: f64) -> f64 {
    let mask = u64::from(first).wrapping_neg();
    f64::from_bits(a.to_bits() & mask | b.to_bits() & !mask)
}

impl Default for Outline {
    fn default() -> Self {
        Self { values: [1.0; TABLE], points: [DVec2::ZERO; TABLE], links: Vec::new() }
    }
}

impl Outline {
    /// Bounds the attractor of `maps`, which is known to lie in the unit disc: support values are lowered
    /// from those of the disc by `h(d) <= max_i ( h(M_i^T d) + t_i . d )` until they settle to `accuracy`
    /// or after `rounds`.
    ///
    /// Every value on the way is a bound, so that new ones may be used at once.
    pub fn set(&mut self, maps: &[Affine2], accuracy: f64, rounds: usize) {
        self.links.clear();
        for k in 0..FAN {
            let d = direction(k);
            for map in maps {
                let pulled = map.linear.transpose() * d;
                let (low, along, length) = locate(pulled);
                self.links.push(Link {
                    low: low as u32,
                    near: (low + usize::from(along > 0.5)) as u32,
                    from_low: length * (1.0 - along),
                    from_high: length * along,
                    shift: map.translation.dot(d),
                });
            }
            self.values[k] = d.length() * (1.0 + 1e-12);
        }
        self.wrap();
        let start = maps.iter().find_map(|map| map.fixed_point()).unwrap_or(DVec2::ZERO);
        self.points = [start; TABLE];
        for _ in 0..rounds {
            if self.lower(maps) < accuracy {
                break;
            }
        }
    }

    /// One round; returns by how much a value fell at most.
    fn lower(&mut self, maps: &[Affine2]) -> f64 {
        let mut change = 0.0_f64;
        for (k, links) in self.links.chunks_exact(maps.len()).enumerate() {
            let mut best = f64::NEG_INFINITY;
            let mut arg = 0;
            for (i, link) in links.iter().enumerate() {
                let low = link.low as usize;
                let value =
                    link.from_low * self.values[low] + link.from_high * self.values[low + 1] + link.shift;
                if value > best {
                    best = value;
                    arg = i;
                }
            }
            self.points[k] = maps[arg].apply(self.points[links[arg].near as usize]);
            let fall = self.values[k] - best;
            if fall > 0.0 {
                change = change.max(fall);
                self.values[k] = best;
            }
        }
        self.wrap();
        change
    }

    /// Repeats the beginning of the fan at its end.
    fn wrap(&mut self) {
        for k in FAN..TABLE {
            self.values[k] = self.values[k - FAN];
            self.points[k] = self.points[k - FAN];
        }
    }

    /// An upper bound of `h(d)`, and a point of the attractor that comes near it.
    #[inline(always)]
    pub fn support(&self, d: DVec2) -> (f64, DVec2) {
        let (low, along, length) = locate(d);
        let (a, b) = (self.values[low], self.values[low + 1]);
        (length * (a + along * (b - a)), self.points[low + usize::from(along > 0.5)])
    }

    /// The diameter of the attractor, at most, where lengths are measured after `to_plane`.
    pub fn diameter(&self, to_plane: DMat2) -> f64 {
        let transposed = to_plane.transpose();
        let width = |k| {
            let d = direction(k);
            let pulled = transposed * d;
            (self.support(pulled).0 + self.support(-pulled).0) / d.length()
        };
        // The two points farthest apart lie along a direction at most half a step off one of the fan.
        (0..FAN / 2).map(width).fold(0.0, f64::max) / HALF_STEP_COSINE
    }
}

/// Cosine of half the widest angle between neighbouring directions, `atan(2 / PER) / 2`.
const HALF_STEP_COSINE: f64 = 0.992_507_556;
