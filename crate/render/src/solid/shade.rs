//! From depths to a picture: a CPU twin of `shader/solid/shade.wgsl`.

use std::f32::consts::TAU;
use std::ops::Range;

use glam::{BVec4A, Vec3, Vec4};

use super::points::OBJECT_BIT;
use super::{DepthBuffer, Lamp};
use crate::picture::colour::Colours;

/// Pixels to each side that the lie of the surface is taken from.
const NORMAL_REACH: i32 = 2;
/// Rings of pixels at which hollows are looked for, and how much each counts.
const HOLLOW_RINGS: [(f32, f32); 4] = [(2.0, 0.2), (5.0, 0.3), (12.0, 0.3), (28.0, 0.2)];
/// Directions on a ring.
const RING_DIRECTIONS: usize = 8;

/// What the reach of a lamp is held to: steps are to be of some length, and within the margin.
const LEAST_REACH: f32 = 1e-3;
const MOST_REACH: f32 = 4.0;

/// As deep as nothing is.
pub(super) const NOTHING_DEPTH: f32 = 1e30;
/// What stands for a depth beyond the border of the picture, where none is known.
const UNKNOWN_DEPTH: f32 = 0.0;
/// So many pixels of a row are lit side by side.
const LANES: usize = 4;

/// RGBA pixels of a depth buffer, row 0 on top, as `lamp` has it: `lamp.factor` x `lamp.factor` pixels of the buffer
/// make one.
#[must_use]
pub fn light(buffer: &DepthBuffer, lamp: &Lamp, colours: &Colours) -> Vec<u8> {
    let rows = (lamp.size[1] / lamp.factor.max(1)).max(0) as u32;
    light_rows(buffer, 0, lamp, colours, 0..rows)
}

/// Some rows of that picture, from a buffer that has those of its source from `top` on. It should have all that is to
/// be lit, and so many more above and below as [`reach_of`] says.
#[must_use]
pub fn light_rows(
    buffer: &DepthBuffer,
    top: u32,
    lamp: &Lamp,
    colours: &Colours,
    rows: Range<u32>,
) -> Vec<u8> {
    let factor = lamp.factor.max(1) as usize;
    let mut scene = Scene::new(buffer, top, lamp, colours);
    let width = lamp.size[0].max(0) as usize / factor;
    let mut pixels = Vec::with_capacity(4 * width * rows.len());
    let mut sums = vec![Vec4::ZERO; width];
    for row in rows {
        sums.fill(Vec4::ZERO);
        for y in (0..factor).map(|dy| row as usize * factor + dy) {
            let codes = scene.codes(y);
            for (group, codes) in codes[..codes.len().min(width * factor)].chunks(LANES).enumerate() {
                // Mostly there is nothing.
                if codes.iter().any(|&code| code != 0) {
                    for (lane, lit) in scene.lit(group * LANES, y, codes).into_iter().enumerate() {
                        if let Some(sum) = sums.get_mut((group * LANES + lane) / factor) {
                            *sum += lit;
                        }
                    }
                }
            }
        }
        for sum in &sums {
            if sum.w == 0.0 {
                pixels.extend([0; 4]);
                continue;
            }
            let alpha = sum.w / (factor * factor) as f32;
            let scale = (1.0 + (alpha - 1.0) * colours.premultiply) / sum.w;
            let colour = (sum.truncate() * scale).extend(alpha).clamp(Vec4::ZERO, Vec4::ONE);
            // A cast rounds down.
            pixels.extend((colour * 255.0 + 0.5).to_array().map(|c| c as u8));
        }
    }
    pixels
}

/// How far the light of a pixel hangs on others, in pixels of the source.
#[must_use]
pub fn reach_of(lamp: &Lamp) -> u32 {
    let widest = HOLLOW_RINGS[HOLLOW_RINGS.len() - 1].0 * lamp.reach.clamp(0.0, MOST_REACH);
    (widest.ceil() as u32).max(NORMAL_REACH as u32)
}

/// A step to a pixel on a ring.
#[derive(Clone, Copy, Debug)]
struct Step {
    dx: i32,
    dy: i32,
    /// The radius of the ring.
    radius: f32,
}

struct Scene<'a> {
    buffer: &'a DepthBuffer,
    top: usize,
    lamp: &'a Lamp,
    colours: &'a Colours,
    /// Depths with a margin all around, so that neighbours of pixels are there without being asked for.
    depths: Vec<f32>,
    margin: usize,
    stride: usize,
    rings: [[Step; RING_DIRECTIONS]; HOLLOW_RINGS.len()],
    /// The colour of the code that was seen last: pieces are seen in one place.
    last: (u32, Vec3),
}

/// What is known of some pixels side by side: points and directions, coordinate by coordinate.
#[derive(Clone, Copy)]
struct Lanes {
    x: Vec4,
    y: Vec4,
    z: Vec4,
}

impl Lanes {
    fn dot(self, other: Self) -> Vec4 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
}

impl<'a> Scene<'a> {
    fn new(buffer: &'a DepthBuffer, top: u32, lamp: &'a Lamp, colours: &'a Colours) -> Self {
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
        let step = |ring: usize, ray: usize| {
            let radius = HOLLOW_RINGS[ring].0 * lamp.reach.clamp(LEAST_REACH, MOST_REACH);
            // Rings are turned against each other.
            let angle = TAU * (ray as f32 + 0.25 * ring as f32) / RING_DIRECTIONS as f32;
            let along = |part: f32| (radius * part).round() as i32;
            Step { dx: along(angle.cos()), dy: along(angle.sin()), radius }
        };
        let rings = std::array::from_fn(|ring| std::array::from_fn(|ray| step(ring, ray)));
        let top = top as usize;
        Self { buffer, top, lamp, colours, depths, margin, stride, rings, last: (0, Vec3::ZERO) }
    }

    /// Depths of some pixels beside each other, `step` pixels of the margin away from the first of them.
    #[inline]
    fn depths_at(&self, first: usize, dx: i32, dy: i32) -> Vec4 {
        let at = first.wrapping_add_signed(dx as isize + dy as isize * self.stride as isize);
        Vec4::from_slice(&self.depths[at..at + LANES])
    }

    /// The codes of a row of the source; none where the buffer does not have it.
    fn codes(&self, y: usize) -> &'a [u32] {
        let width = self.buffer.width() as usize;
        let row = || self.buffer.codes().chunks_exact(width).nth(y.checked_sub(self.top)?);
        row().unwrap_or_default()
    }

    /// The colours of some pixels of the source, which have these codes, and 1 where there is something.
    fn lit(&mut self, x: usize, y: usize, codes: &[u32]) -> [Vec4; LANES] {
        let mut lit = [Vec4::ZERO; LANES];
        let first = (y - self.top + self.margin) * self.stride + x + self.margin;
        let depth = self.depths_at(first, 0, 0);
        let slant = self.slant(x as f32, y as f32);
        let normal = self.normal(first, depth, slant);
        let lamp = self.lamp;
        let towards = Vec4::from(lamp.towards);
        let facing = normal.x * towards.x + normal.y * towards.y + normal.z * towards.z;
        let open = Vec4::ONE - self.hollow(first, depth, slant, normal) * lamp.hollows;
        let shine = (facing.max(Vec4::ZERO) * (1.0 - towards.w) + towards.w) * open;
        let [near, far, ..] = lamp.range;
        let ground = Vec4::from(lamp.ground);
        let fog = (depth - near) / (far - near).max(1e-30);
        let fog = fog.clamp(Vec4::ZERO, Vec4::ONE) * ground.w;
        for (lane, &code) in codes.iter().enumerate() {
            let Some(place) = code.checked_sub(1) else { continue };
            let point = Vec3::new(slant.x[lane], slant.y[lane], 1.0) * depth[lane];
            let colour = self.colour(place, point);
            // Light adds up as it is, not as it is written.
            let light = colour.max(Vec3::ZERO) * (shine[lane] * 1.25).powf(1.0 / 2.2);
            let light = light.lerp(ground.truncate(), fog[lane]);
            lit[lane] = light.clamp(Vec3::ZERO, Vec3::ONE).extend(1.0);
        }
        lit
    }

    /// The colour of what is seen at a point, unlit.
    fn colour(&mut self, place: u32, point: Vec3) -> Vec3 {
        let lamp = self.lamp;
        if lamp.height > 0.5 {
            let [_, _, low, high] = lamp.range;
            let up = Vec4::from(lamp.up);
            let height = up.w + up.truncate().dot(point);
            let share = ((height - low) / (high - low).max(1e-30)).clamp(0.0, 1.0);
            let paint = |k: usize| Vec4::from(self.colours.palette[k]).truncate();
            return paint(1).lerp(paint(0), share);
        }
        if self.last.0 != place + 1 {
            let tint = Vec4::from(lamp.tints[((place >> OBJECT_BIT) as usize).min(lamp.tints.len() - 1)]);
            let own = || Vec3::from(self.colours.colour((place & 0x3_ffff) + 1));
            self.last = (place + 1, if tint.w > 0.5 { tint.truncate() } else { own() });
        }
        self.last.1
    }

    /// Where pixels are seen, at depth 1.
    fn slant(&self, x: f32, y: f32) -> Lanes {
        let Lamp { size: [width, height], focal, .. } = *self.lamp;
        let (cx, cy) = (0.5 * width as f32, 0.5 * height as f32);
        Lanes {
            x: (Vec4::new(x, x + 1.0, x + 2.0, x + 3.0) + (0.5 - cx)) / focal,
            y: Vec4::splat((cy - y - 0.5) / focal),
            z: Vec4::ONE,
        }
    }

    /// The lie of the surface: a plane through what is near, by least squares, each pixel weighed by how near it is in
    /// depth.
    fn normal(&self, first: usize, depth: Vec4, slant: Lanes) -> Lanes {
        let [mut xx, mut xy, mut yy, mut xz, mut yz] = [Vec4::ZERO; 5];
        for dy in -NORMAL_REACH..=NORMAL_REACH {
            for dx in -NORMAL_REACH..=NORMAL_REACH {
                let near = self.depths_at(first, dx, dy);
                let seen = seen(near);
                // In pixels. Of a plane it is the inverse of the depth that changes evenly from pixel to pixel.
                let step = (Vec4::ONE - depth / Vec4::select(seen, near, depth)) * self.lamp.focal;
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

    /// How much of what is around stands out of the plane of the surface: 0 in the open, 1 in a deep hole. A slope
    /// alone is no hollow, and what lies beyond the border of the picture is not known: it does not count as open.
    fn hollow(&self, first: usize, depth: Vec4, slant: Lanes, normal: Lanes) -> Vec4 {
        let focal = self.lamp.focal;
        let unit = depth / focal;
        let own = Lanes { x: slant.x * depth, y: slant.y * depth, z: depth };
        let mut sum = Vec4::ZERO;
        for (ring, (_, share)) in self.rings.iter().zip(HOLLOW_RINGS) {
            let (mut covered, mut known) = (Vec4::ZERO, Vec4::ZERO);
            let scale = (unit * ring[0].radius).recip();
            for step in ring {
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
            sum += covered * share / known.max(Vec4::ONE);
        }
        sum.min(Vec4::ONE)
    }
}

/// Where there is something.
fn seen(depth: Vec4) -> BVec4A {
    depth.cmpgt(Vec4::splat(UNKNOWN_DEPTH)) & depth.cmplt(Vec4::splat(NOTHING_DEPTH))
}

#[cfg(test)]
mod tests {
    use frond_core::Colouring;
    use glam::DVec3;

    use super::*;
    use crate::solid::{Camera, Lighting};

    fn camera() -> Camera {
        Camera::looking(DVec3::Z * 10.0, DVec3::ZERO, DVec3::Y, 0.8).unwrap()
    }

    /// The grey of each pixel of a buffer whose depth is given.
    fn greys(side: u32, depth: impl Fn(f32, f32) -> f32, lighting: &Lighting) -> Vec<u8> {
        let mut buffer = DepthBuffer::new(side, side);
        for (y, x) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
            let depth = depth(x as f32 / side as f32 - 0.5, 0.5 - y as f32 / side as f32);
            if depth.is_finite() {
                buffer.put(x, y, depth, 1);
            }
        }
        let colours = Colours::new(Colouring::Map, &[[200, 200, 200]], 1);
        let lamp = Lamp::new(lighting, &camera(), [side, side], 1, [10.0, 30.0]);
        let pixels = light(&buffer, &lamp, &colours);
        assert_eq!(pixels.len(), (side * side * 4) as usize);
        pixels.chunks(4).map(|p| if p[3] == 0 { 0 } else { p[0].max(1) }).collect()
    }

    #[test]
    fn a_slope_towards_the_light_is_brighter() {
        let lighting =
            Lighting { towards: DVec3::new(-1.0, 0.0, -1.0), hollows: 0.0, fog: 0.0, ..Lighting::default() };
        // Rising to the left means that it is nearer there, and faces right; and the other way round.
        let slope = |s: f32| greys(60, move |x, _| 10.0 + s * x * 8.0, &lighting)[30 * 60 + 30];
        let (left, flat, right) = (slope(-1.0), slope(0.0), slope(1.0));
        assert!(left > flat && flat > right, "{left} {flat} {right}");
    }

    #[test]
    fn a_plane_at_a_slant_is_of_one_brightness_up_to_the_border() {
        let lighting = Lighting { fog: 0.0, ..Lighting::default() };
        let lamp = Lamp::new(&lighting, &camera(), [120, 120], 1, [10.0, 30.0]);
        let across = 120.0 / lamp.focal;
        // The plane 1 = a x + b y + c z: over the picture the inverse of its depth changes evenly.
        for [a, b, c] in [[0.0, 0.0, 0.1_f32], [0.0, -0.2, 0.1], [0.08, 0.1, 0.1], [-0.2, 0.0, 0.1]] {
            let plane = |x: f32, y: f32| 1.0 / (across * (a * x + b * y) + c);
            let greys = greys(120, plane, &lighting);
            let (least, most) = (greys.iter().min().unwrap(), greys.iter().max().unwrap());
            assert!(most - least <= 1, "{a} {b}: {least} to {most}");
        }
    }

    #[test]
    fn a_rough_surface_has_no_rim_along_the_border() {
        // What is seen of it in a picture that goes on all around is what it should look like at the border of this
        // one.
        let (whole, part) = (180_u32, 100_u32);
        let margin = (whole - part) / 2;
        let lighting = Lighting { fog: 0.0, ..Lighting::default() };
        let colours = Colours::new(Colouring::Map, &[[200, 200, 200]], 1);
        for slant in [0.0, 0.08] {
            let rough = |x: u32, y: u32| {
                let (x, y) = (x as f32, y as f32);
                20.0 - slant * y + 1.2 * ((0.23 * x).sin() * (0.27 * y).sin() + (0.31 * x - 0.19 * y).sin())
            };
            let picture = |side: u32, from: u32| {
                let mut buffer = DepthBuffer::new(side, side);
                for (y, x) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
                    buffer.put(x, y, rough(x + from, y + from), 1);
                }
                let lamp = Lamp::new(&lighting, &camera(), [side, side], 1, [10.0, 30.0]);
                light(&buffer, &Lamp { focal: 200.0, ..lamp }, &colours)
            };
            let (wide, narrow) = (picture(whole, 0), picture(part, margin));
            let (mut sum, mut count) = (0.0, 0.0);
            for (y, x) in (0..part).flat_map(|y| (0..part).map(move |x| (y, x))) {
                if x.min(y).min(part - 1 - x).min(part - 1 - y) < 8 {
                    let there = (y + margin) * whole + x + margin;
                    sum +=
                        f64::from(narrow[4 * (y * part + x) as usize]) - f64::from(wide[4 * there as usize]);
                    count += 1.0;
                }
            }
            let rim: f64 = sum / count;
            assert!(rim.abs() < 1.0, "slant {slant}: {rim}");
        }
    }

    #[test]
    fn pits_are_dark_and_what_is_far_fades() {
        let lighting = Lighting { fog: 0.0, ..Lighting::default() };
        let pit = greys(80, |x, y| if x.hypot(y) < 0.06 { 11.0 } else { 10.0 }, &lighting);
        assert!(pit[40 * 80 + 40] + 25 < pit[40 * 80 + 8], "{} {}", pit[40 * 80 + 40], pit[40 * 80 + 8]);
        let steps = |x: f32, _| if x < 0.0 { 10.0 } else { 30.0 };
        let [plain, foggy] = [0.0, 1.0]
            .map(|fog| greys(80, steps, &Lighting { fog, hollows: 0.0, ..lighting.clone() })[40 * 80 + 70]);
        assert!(foggy < 10 && plain > 80, "{plain} {foggy}");
        let none = greys(8, |_, _| f32::INFINITY, &lighting);
        assert!(none.iter().all(|&grey| grey == 0));
    }

    fn pits(side: u32, factor: u32) -> (DepthBuffer, Lamp) {
        let mut buffer = DepthBuffer::new(side, side);
        for (y, x) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
            let at = |v: u32| v as f32 / side as f32;
            let depth = 20.0 + (25.0 * at(x)).sin() * (25.0 * at(y)).sin() + 0.6 * (9.0 * at(x + y)).sin();
            buffer.put(x, y, depth, 1 + ((x * 7 / side) << 12));
        }
        (buffer, Lamp::new(&Lighting::default(), &camera(), [side, side], factor, [10.0, 30.0]))
    }

    #[test]
    fn bands_are_lit_as_the_whole_picture_is() {
        let colours = Colours::new(Colouring::Map, &[[200, 120, 90], [60, 90, 200]], 7);
        for factor in [1, 2] {
            let (buffer, lamp) = pits(160, factor);
            let whole = light(&buffer, &lamp, &colours);
            let (rows, reach) = (160 / factor, reach_of(&lamp));
            let mut bands = Vec::new();
            for band in [0..rows / 2 - 3, rows / 2 - 3..rows] {
                let (top, end) =
                    ((band.start * factor).saturating_sub(reach), (band.end * factor + reach).min(160));
                let mut part = DepthBuffer::new(160, end - top);
                for (y, x) in (top..end).flat_map(|y| (0..160).map(move |x| (y, x))) {
                    let at = (y * 160 + x) as usize;
                    part.put(x, y - top, buffer.depth()[at], buffer.codes()[at]);
                }
                bands.extend(light_rows(&part, top, &lamp, &colours, band));
            }
            assert_eq!(bands, whole, "{factor}");
        }
    }

    #[test]
    fn hollows_of_a_smaller_picture_are_those_of_the_large_one() {
        let colours = Colours::new(Colouring::Map, &[[200, 200, 200]], 7);
        let greys = |side: u32, reach: f32| -> Vec<f64> {
            let (buffer, _) = pits(side, 1);
            // All light comes from everywhere: hollows alone are seen.
            let lighting = Lighting { ambient: 1.0, hollows: 1.0, fog: 0.0, ..Lighting::default() };
            let lit = Lamp::new(&lighting, &camera(), [side, side], 1, [10.0, 30.0]);
            let pixels = light(&buffer, &Lamp { reach, ..lit }, &colours);
            pixels.chunks(4).map(|pixel| f64::from(pixel[0])).collect()
        };
        let large = greys(320, 1.0);
        let off = |small: &[f64]| {
            let at =
                |(at, grey): (usize, &f64)| (grey - large[(at / 80 * 4 + 2) * 320 + at % 80 * 4 + 2]).abs();
            small.iter().enumerate().map(at).sum::<f64>() / small.len() as f64
        };
        let (matched, unmatched) = (off(&greys(80, 0.25)), off(&greys(80, 1.0)));
        assert!(matched < 6.0 && unmatched > 2.0 * matched, "{matched} {unmatched}");
    }
}
