//! Support values in f32. Shader twin: the first part of crate/render/shader/locus.wgsl.

use glam::{Vec2, Vec4};

/// Directions on each side of the square.
const DIRECTIONS_A_SIDE: usize = 8;
/// Directions in all.
pub(super) const DIRECTIONS: usize = 4 * DIRECTIONS_A_SIDE;
/// The relative error of one operation: a graphics card may round up or down.
pub(super) const ULP: f32 = f32::EPSILON;
/// What an evaluation of the table may be off, over the length of the direction: products and sums of the pulled
/// direction, and a division (2.5 units in the last place) that is multiplied by half of `DIRECTIONS_A_SIDE`, times the
/// difference of neighbouring values, which is at most 2 over `DIRECTIONS_A_SIDE`.
const SUPPORT_ERROR: f32 = 32.0 * ULP;
/// Cosine of half the widest angle between neighbouring directions.
const HALF_STEP_COSINE: f32 = 0.992_507_5;

/// A graphics card may take numbers below this for 0.
const SMALLEST_LENGTH: f32 = 1e-37;

/// A map: the rows of its matrix, and its translation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Map {
    pub linear: Vec4,
    pub shift: Vec2,
}

/// The image of a point under a matrix.
pub(super) fn image(m: Vec4, p: Vec2) -> Vec2 {
    Vec2::new(m.x * p.x + m.y * p.y, m.z * p.x + m.w * p.y)
}

/// The image of a direction under the transposed matrix.
pub(super) fn pulled(m: Vec4, d: Vec2) -> Vec2 {
    Vec2::new(m.x * d.x + m.z * d.y, m.y * d.x + m.w * d.y)
}

/// The product of two matrices.
pub(super) fn product(a: Vec4, b: Vec4) -> Vec4 {
    Vec4::new(a.x * b.x + a.y * b.z, a.x * b.y + a.y * b.w, a.z * b.x + a.w * b.z, a.z * b.y + a.w * b.w)
}

/// The largest factor by which a matrix stretches.
pub(super) fn norm(m: Vec4) -> f32 {
    let turning = Vec2::new(m.x + m.w, m.z - m.y);
    let flipping = Vec2::new(m.x - m.w, m.z + m.y);
    0.5 * (turning.dot(turning).sqrt() + flipping.dot(flipping).sqrt())
}

/// Direction `k` of the table: evenly on the boundary of the square [-1, 1]^2.
pub(super) fn direction(k: usize) -> Vec2 {
    let s = (k % DIRECTIONS_A_SIDE) as f32 * (2.0 / DIRECTIONS_A_SIDE as f32) - 1.0;
    match k / DIRECTIONS_A_SIDE {
        0 => Vec2::new(1.0, s),
        1 => Vec2::new(-s, 1.0),
        2 => Vec2::new(-1.0, -s),
        _ => Vec2::new(s, -1.0),
    }
}

/// A direction between two of the table.
#[derive(Clone, Copy, Debug)]
struct Place {
    low: usize,
    along: f32,
    length: f32,
}

fn locate(d: Vec2) -> Place {
    let steep = d.x.abs() < d.y.abs();
    let large = if steep { d.y } else { d.x };
    let small = if steep { -d.x } else { d.y };
    let length = large.abs();
    // The zero vector lies in any sector, at length 0; so does what a graphics card may take for it.
    let slope = if length >= SMALLEST_LENGTH { small / large } else { 0.0 };
    let along = slope * (DIRECTIONS_A_SIDE as f32 / 2.0) + (DIRECTIONS_A_SIDE as f32 / 2.0);
    let sector = along.floor().clamp(0.0, DIRECTIONS_A_SIDE as f32 - 1.0);
    // The sides in their order: right, top, left, bottom.
    let side = if large < 0.0 { 2 } else { 0 } + usize::from(steep);
    Place { low: side * DIRECTIONS_A_SIDE + sector as usize, along: along - sector, length }
}

/// Upper bounds of the support function of an attractor in the unit disc, and points of it far out.
#[derive(Clone, Debug)]
pub(super) struct SupportTable {
    values: [f32; DIRECTIONS],
    points: [Vec2; DIRECTIONS],
}

impl SupportTable {
    /// Lowers the support values of the disc by `h(d) <= max_i ( h(M_i^T d) + t_i . d )`, at most `rounds` times,
    /// until none falls by `accuracy`. Each is raised by its rounding error, so that it stays an upper bound.
    pub fn new(maps: &[Map], start: Vec2, accuracy: f32, rounds: usize) -> Self {
        let mut table = Self { values: [1.0; DIRECTIONS], points: [start; DIRECTIONS] };
        for k in 0..DIRECTIONS {
            let d = direction(k);
            table.values[k] = d.dot(d).sqrt() * (1.0 + SUPPORT_ERROR);
        }
        for _ in 0..rounds {
            let mut change = 0.0_f32;
            for k in 0..DIRECTIONS {
                let d = direction(k);
                let mut best = -4.0;
                let mut from = Vec2::ZERO;
                for map in maps {
                    let (reach, point) = table.support(pulled(map.linear, d));
                    let value = reach + map.shift.dot(d);
                    if value > best {
                        best = value;
                        from = image(map.linear, point) + map.shift;
                    }
                }
                table.points[k] = from;
                // Directions are at most 1.42 long.
                best += 1.5 * SUPPORT_ERROR;
                let fall = table.values[k] - best;
                if fall > 0.0 {
                    change = change.max(fall);
                    table.values[k] = best;
                }
            }
            if change < accuracy {
                break;
            }
        }
        // From here on no caller has to mind what an evaluation is off.
        for value in &mut table.values {
            *value += 1.5 * SUPPORT_ERROR;
        }
        table
    }

    /// An upper bound of `h(d)`, and a point of the attractor that comes near it.
    pub fn support(&self, d: Vec2) -> (f32, Vec2) {
        let Place { low, along, length } = locate(d);
        let high = if low + 1 == DIRECTIONS { 0 } else { low + 1 };
        let (a, b) = (self.values[low], self.values[high]);
        let near = if along > 0.5 { high } else { low };
        (length * (a + along * (b - a)), self.points[near])
    }

    /// The diameter of the attractor, at most.
    pub fn diameter(&self) -> f32 {
        let mut widest = 0.0_f32;
        for k in 0..DIRECTIONS / 2 {
            let d = direction(k);
            widest = widest.max((self.values[k] + self.values[k + DIRECTIONS / 2]) / d.dot(d).sqrt());
        }
        widest / HALF_STEP_COSINE
    }
}
