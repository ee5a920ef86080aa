//! What the depths around a pixel say of it: how the surface lies, and what stands out of it.

use std::f32::consts::TAU;

use glam::{BVec4A, Vec4};

use super::{DepthBuffer, Lamp};

/// Pixels to each side that the lie of the surface is taken from.
const NORMAL_REACH: i32 = 2;
/// Rings of pixels at which the surroundings are sampled: the radius of each, and how much it counts in hollows and in
/// ambient occlusion.
const RINGS: [(f32, [f32; 2]); 5] =
    [(2.0, [0.2, 0.0]), (5.0, [0.3, 0.1]), (12.0, [0.3, 0.2]), (28.0, [0.2, 0.35]), (64.0, [0.0, 0.35])];
/// Rings that hollows need: the others are of ambient occlusion alone.
const HOLLOW_RINGS: usize = 4;
/// Directions on a ring.
const RING_DIRECTIONS: usize = 8;
/// What counts as covered in ambient occlusion of what is half covered: a ring meets few pixels of what is fine.
const OCCLUSION_GAIN: f32 = 1.6;

/// What the reach of a lamp is held to: steps are to be of some length, and within the margin.
const LEAST_REACH: f32 = 1e-3;
const MOST_REACH: f32 = 4.0;

/// As deep as nothing is.
pub(super) const NOTHING_DEPTH: f32 = 1e30;
/// What stands for a depth beyond the border of the picture, where none is known.
const UNKNOWN_DEPTH: f32 = 0.0;
/// So many pixels of a row are lit side by side.
pub(super) const LANES: usize = 4;

/// How far the light of a pixel hangs on others, in pixels of the source.
#[must_use]
pub fn reach_of(lamp: &Lamp) -> u32 {
    let widest = RINGS[rings_of(lamp) - 1].0 * lamp.reach.clamp(0.0, MOST_REACH);
    (widest.ceil() as u32).max(NORMAL_REACH as u32)
}

fn rings_of(lamp: &Lamp) -> usize {
    if lamp.occlusion > 0.0 { RINGS.len() } else { HOLLOW_RINGS }
}

/// What is known of some pixels side by side: points and directions, coordinate by coordinate.
#[derive(Clone, Copy)]
pub(super) struct Lanes {
    pub x: Vec4,
    pub y: Vec4,
    pub z: Vec4,
}

impl Lanes {
    pub fn dot(self, other: Self) -> Vec4 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
}

/// A step to a pixel on a ring.
#[derive(Clone, Copy, Debug)]
struct Step {
    dx: i32,
    dy: i32,
}

#[derive(Clone, Debug)]
struct Ring {
    radius: f32,
    shares: [f32; 2],
    /// Those of rows with an even number, and with an odd one.
    steps: [[Step; RING_DIRECTIONS]; 2],
}

/// The depths of a picture, with a margin all around, so that neighbours of pixels are there without being asked for.
pub(super) struct Around {
    depths: Vec<f32>,
    margin: usize,
    stride: usize,
    rings: Vec<Ring>,
    focal: f32,
    middle: [f32; 2],
    top: usize,
}

impl Around {
    pub fn new(buffer: &DepthBuffer, top: usize, lamp: &Lamp) -> Self {
        let margin = reach_of(lamp) as usize;
        let (width, height) = (buffer.width() as usize, buffer.height() as usize);
        // Lanes at the end of a row may look beyond its margin.
        let stride = width + 2 * margin + LANES;
        let mut depths = vec![UNKNOWN_DEPTH; stride * (height + 2 * margin)];
        for (row, from) in buffer.depth().chunks_exact(width).enumerate() {
            let at = (row + margin) * stride + margin;
            for (to, depth) in depths[at..at + width].iter_mut().zip(from) {
                *to = depth.min(NOTHING_DEPTH);
            }
        }
        // Where rows are shown together, each looks between the directions of the other.
        let turned = lamp.factor > 1 && lamp.occlusion > 0.0;
        let ring = |number: usize| {
            let (radius, shares) = RINGS[number];
            let radius = radius * lamp.reach.clamp(LEAST_REACH, MOST_REACH);
            let step = |odd: usize, ray: usize| {
                // Rings are turned against each other.
                let between = if turned { 0.5 * odd as f32 } else { 0.0 };
                let angle = TAU * (ray as f32 + 0.25 * number as f32 + between) / RING_DIRECTIONS as f32;
                let along = |part: f32| (radius * part).round() as i32;
                Step { dx: along(angle.cos()), dy: along(angle.sin()) }
            };
            let steps = std::array::from_fn(|odd| std::array::from_fn(|ray| step(odd, ray)));
            Ring { radius, shares, steps }
        };
        let rings = (0..rings_of(lamp)).map(ring).collect();
        let middle = lamp.size.map(|side| 0.5 * side as f32);
        Self { depths, margin, stride, rings, focal: lamp.focal, middle, top }
    }

    /// Where the depth of a pixel of the source is kept.
    pub fn place(&self, x: usize, y: usize) -> usize {
        (y - self.top + self.margin) * self.stride + x + self.margin
    }

    /// Depths of some pixels beside each other, so many pixels away from the first of them.
    #[inline]
    pub fn depths_at(&self, first: usize, dx: i32, dy: i32) -> Vec4 {
        let at = first.wrapping_add_signed(dx as isize + dy as isize * self.stride as isize);
        Vec4::from_slice(&self.depths[at..at + LANES])
    }

    /// Where pixels are seen, at depth 1.
    pub fn slant(&self, x: f32, y: f32) -> Lanes {
        let ([cx, cy], focal) = (self.middle, self.focal);
        Lanes {
            x: (Vec4::new(x, x + 1.0, x + 2.0, x + 3.0) + (0.5 - cx)) / focal,
            y: Vec4::splat((cy - y - 0.5) / focal),
            z: Vec4::ONE,
        }
    }

    /// The lie of the surface: a plane through what is near, by least squares, each pixel weighed by how near it is in
    /// depth.
    pub fn normal(&self, first: usize, depth: Vec4, slant: Lanes) -> Lanes {
        let [mut xx, mut xy, mut yy, mut xz, mut yz] = [Vec4::ZERO; 5];
        for dy in -NORMAL_REACH..=NORMAL_REACH {
            for dx in -NORMAL_REACH..=NORMAL_REACH {
                let near = self.depths_at(first, dx, dy);
                let seen = seen(near);
                // In pixels. Of a plane it is the inverse of the depth that changes evenly from pixel to pixel.
                let step = (Vec4::ONE - depth / Vec4::select(seen, near, depth)) * self.focal;
                let weight = Vec4::select(seen, (step * step * 0.15 + 1.0).recip(), Vec4::ZERO);
                let (fx, fy) = (dx as f32, dy as f32);
                xx += weight * (fx * fx);
                xy += weight * (fx * fy);
                yy += weight * (fy * fy);
                xz += weight * step * fx;
                yz += weight * step * fy;
            }
        }
        let det = xx * yy - xy * xy;
        let flat = det.cmplt(Vec4::splat(1e-3));
        let det = Vec4::select(flat, Vec4::ONE, det);
        let (gx, gy) = ((xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det);
        // Rows go down, y goes up; and beside the middle of the picture the eye looks at a slant.
        let z = slant.y * gy - slant.x * gx - 1.0;
        let length = (gx * gx + gy * gy + z * z).to_array().map(f32::sqrt);
        let scale = Vec4::from(length).recip();
        let side = |along: Vec4| Vec4::select(flat, Vec4::ZERO, along * scale);
        Lanes { x: side(gx), y: side(-gy), z: Vec4::select(flat, Vec4::NEG_ONE, z * scale) }
    }

    /// How much of what is around stands out of the plane of the surface, as hollows and as ambient occlusion count it:
    /// 0 in the open, 1 in a deep hole. A slope alone is no hollow, and what lies beyond the border of the picture is
    /// not known: it does not count as open.
    pub fn covered(&self, first: usize, odd: bool, depth: Vec4, slant: Lanes, normal: Lanes) -> [Vec4; 2] {
        let focal = self.focal;
        let unit = depth / focal;
        let own = Lanes { x: slant.x * depth, y: slant.y * depth, z: depth };
        let mut sums = [Vec4::ZERO; 2];
        for Ring { radius, shares, steps } in &self.rings {
            let (mut covered, mut known) = (Vec4::ZERO, Vec4::ZERO);
            let scale = (unit * *radius).recip();
            for step in &steps[usize::from(odd)] {
                let there = self.depths_at(first, step.dx, step.dy);
                known += Vec4::select(there.cmpgt(Vec4::splat(UNKNOWN_DEPTH)), Vec4::ONE, Vec4::ZERO);
                let (right, up) = (step.dx as f32 / focal, -step.dy as f32 / focal);
                let way = Lanes {
                    x: ((slant.x + right) * there - own.x) * scale,
                    y: ((slant.y + up) * there - own.y) * scale,
                    z: (there - own.z) * scale,
                };
                let rise = normal.dot(way);
                // What lies far before it is something else, and throws little shade.
                let shade = (rise * 0.7).min(Vec4::ONE) / (way.dot(way) * 0.02 + 1.0);
                covered += Vec4::select(seen(there) & rise.cmpgt(Vec4::ZERO), shade, Vec4::ZERO);
            }
            let share = covered / known.max(Vec4::ONE);
            sums = [0, 1].map(|kind| sums[kind] + share * shares[kind]);
        }
        [sums[0].min(Vec4::ONE), (sums[1] * OCCLUSION_GAIN).min(Vec4::ONE)]
    }
}

/// Where there is something.
fn seen(depth: Vec4) -> BVec4A {
    depth.cmpgt(Vec4::splat(UNKNOWN_DEPTH)) & depth.cmplt(Vec4::splat(NOTHING_DEPTH))
}
