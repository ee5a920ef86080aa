//! The maps of a sample in f32, in their frame. Shader twin: `set_frame` in crate/render/shader/locus.wgsl.

use glam::{Vec2, Vec4};

use super::descent::MAX_MAPS;
use super::map::SingleMap;
use super::support::{Map, ULP, image, norm};

/// Maps must contract by this in the plane's own norm.
const LARGEST_FACTOR: f32 = 0.97;
/// With a wider margin nothing worth knowing would be found.
const LARGEST_MARGIN: f32 = 0.01;

/// The system of a sample, in its frame: the attractor lies in the unit disc.
///
/// # Margin
///
/// Let `e` be `ULP`, `s` the contraction factor, and `o` the origin and `r` the radius of the frame, which are
/// exact by definition. The maps of the frame are off by `d`: what they were given with, and for the translation
/// `(M o + t - o) / r` the rounding of two products and three sums, at most `5 e (|M o| + |t| + |o|) / r`, and
/// of a division, `2.5 e |t'|`. An attractor whose maps are off by `d` in the unit disc is off by at most
/// `d / (1 - s)`, and so is each piece of it: twice that for the distance of two pieces.
///
/// The step between the middles of a pair begins as a difference of two translations, each at most `1 - s` long since
/// `r` is chosen so. Each split adds `M t_i`. After `k` splits of one piece `M` is off by at most `4 k e s^k` (each
/// product of matrices adds two roundings a product, over the absolute values of the entries, which is twice the
/// product of the norms), which sums up to `4 e s / (1 - s)` on each side; the products with `t_i` and their sums add
/// `3 e` on each side, and the subtractions, where the step is no longer than both pieces together, `4 e s / (1 - s)`.
/// The support values are raised by their own error (`SupportTable::new`), and the products of a look are off by `6 e`
/// at most. In all `e (16 + 12 s / (1 - s))`; a quarter is added.
pub(super) struct System {
    pub count: usize,
    pub maps: [Map; MAX_MAPS],
    pub factor: f32,
    /// How far the distance of two pieces may be off.
    pub margin: f32,
    /// The most that a matrix was given with.
    given: f32,
}

impl System {
    /// `None` where the maps do not contract in the plane's own norm, or nothing can be told apart.
    pub fn new(columns: &[SingleMap], rows: &[SingleMap]) -> Option<Self> {
        let count = columns.len();
        let mut maps = [Map::default(); MAX_MAPS];
        let mut mean = Map::default();
        let mut factor = 0.0_f32;
        let mut given = 0.0_f32;
        for i in 0..count {
            let (c, r) = (columns[i], rows[i]);
            let linear = Vec4::new(c[0] + r[0], c[1] + r[1], c[2] + r[2], c[3] + r[3]);
            let shift = Vec2::new(c[4] + r[4], c[5] + r[5]);
            maps[i] = Map { linear, shift };
            mean.linear += linear;
            mean.shift += shift;
            factor = factor.max(norm(linear) * (1.0 + 16.0 * ULP) + (c[6] + r[6]));
            given = given.max(c[6] + r[6]);
        }
        if factor >= LARGEST_FACTOR {
            return None;
        }
        // The fixed point of the mean of the maps; it need not be exact.
        let share = 1.0 / count as f32;
        let origin = fixed_point(Map { linear: mean.linear * share, shift: mean.shift * share });
        let far = origin.dot(origin).sqrt();
        // Translations about that point, and how far they may be off.
        let mut widest = 0.0_f32;
        let mut off = 0.0_f32;
        for i in 0..count {
            let (c, r) = (columns[i], rows[i]);
            let map = &mut maps[i];
            let size = map.shift.dot(map.shift).sqrt();
            // A matrix of absolute values may stretch by the root of two more.
            off = off.max((c[6] + r[6]) * far + (c[7] + r[7]) + 5.0 * ULP * (2.5 * far + size));
            map.shift = image(map.linear, origin) + map.shift - origin;
            widest = widest.max(map.shift.dot(map.shift).sqrt());
        }
        let rest = 1.0 - factor;
        let radius = (widest * (1.0 + 16.0 * ULP) + off) / rest * (1.0 + 16.0 * ULP);
        if radius <= 1e-12 {
            return None;
        }
        for map in &mut maps[..count] {
            map.shift /= radius;
        }
        let error = given + off / radius + 3.0 * ULP * rest;
        let margin = 2.0 * error / rest + ULP * (20.0 + 15.0 * factor / rest);
        if margin < LARGEST_MARGIN { Some(Self { count, maps, factor, margin, given }) } else { None }
    }

    /// Whether the areas of two maps leave no room between the pieces; `None` where f32 cannot tell.
    pub fn areas_fill(&self) -> Option<bool> {
        let area = |m: Vec4| (m.x * m.w - m.y * m.z).abs();
        let spare = area(self.maps[0].linear) + area(self.maps[1].linear) - 1.0;
        let slack = 16.0 * ULP + 16.0 * self.given;
        if spare >= slack {
            Some(true)
        } else if spare < -slack {
            Some(false)
        } else {
            None
        }
    }
}

/// The point that a map leaves where it is.
pub(super) fn fixed_point(map: Map) -> Vec2 {
    let (m, t) = (map.linear, map.shift);
    let determinant = (1.0 - m.x) * (1.0 - m.w) - m.y * m.z;
    Vec2::new((1.0 - m.w) * t.x + m.y * t.y, m.z * t.x + (1.0 - m.x) * t.y) / determinant
}
