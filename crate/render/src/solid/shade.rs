//! From depths to a picture: a CPU twin of `shader/solid/shade.wgsl`.

use glam::{Vec3, Vec4};

use super::points::OBJECT_BIT;
use super::{DepthBuffer, Lamp};
use crate::picture::colour::Colours;

/// Pixels to each side that the lie of the surface is taken from.
const NORMAL_REACH: i32 = 2;
/// Rings of pixels at which hollows are looked for, and how much each counts.
const HOLLOW_RINGS: [(f32, f32); 4] = [(2.0, 0.2), (5.0, 0.3), (12.0, 0.3), (28.0, 0.2)];
/// Directions on a ring.
const RING_DIRECTIONS: usize = 8;

/// As deep as nothing is.
pub(super) const NOTHING_DEPTH: f32 = 1e30;

/// RGBA pixels of a depth buffer, row 0 on top, as `lamp` has it: `lamp.factor` x `lamp.factor` pixels of the buffer
/// make one.
#[must_use]
pub fn light(buffer: &DepthBuffer, lamp: &Lamp, colours: &Colours) -> Vec<u8> {
    let scene = Scene { buffer, lamp, colours };
    let factor = lamp.factor.max(1);
    let (width, height) = (lamp.size[0] / factor, lamp.size[1] / factor);
    let mut pixels = Vec::with_capacity(4 * (width.max(0) * height.max(0)) as usize);
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        let mut sum = Vec4::ZERO;
        for (dy, dx) in (0..factor).flat_map(|dy| (0..factor).map(move |dx| (dy, dx))) {
            sum += scene.lit(x * factor + dx, y * factor + dy);
        }
        let alpha = sum.w / (factor * factor) as f32;
        let scale = if sum.w > 0.0 { (1.0 + (alpha - 1.0) * colours.premultiply) / sum.w } else { 0.0 };
        let colour = (sum.truncate() * scale).extend(alpha);
        pixels.extend(colour.to_array().map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8));
    }
    pixels
}

fn to_linear(colour: Vec3) -> Vec3 {
    colour.max(Vec3::ZERO).powf(2.2)
}

struct Scene<'a> {
    buffer: &'a DepthBuffer,
    lamp: &'a Lamp,
    colours: &'a Colours,
}

impl Scene<'_> {
    fn inside(&self, x: i32, y: i32) -> bool {
        x >= 0 && y >= 0 && x < self.buffer.width() as i32 && y < self.buffer.height() as i32
    }

    /// The code at a pixel; 0 beyond the border.
    fn code(&self, x: i32, y: i32) -> u32 {
        let at = || (y * self.buffer.width() as i32 + x) as usize;
        if self.inside(x, y) { self.buffer.codes()[at()] } else { 0 }
    }

    /// The depth at a pixel.
    fn depth(&self, x: i32, y: i32) -> f32 {
        if self.code(x, y) == 0 {
            return NOTHING_DEPTH;
        }
        self.buffer.depth()[(y * self.buffer.width() as i32 + x) as usize]
    }

    /// The colour of a pixel of the buffer, and 1 where there is something.
    fn lit(&self, x: i32, y: i32) -> Vec4 {
        let Some(place) = self.code(x, y).checked_sub(1) else { return Vec4::ZERO };
        let (lamp, colours, depth) = (self.lamp, self.colours, self.depth(x, y));
        let tint = Vec4::from(lamp.tints[((place >> OBJECT_BIT) as usize).min(lamp.tints.len() - 1)]);
        let mut colour = Vec3::from(colours.colour((place & 0x3_ffff) + 1));
        if tint.w > 0.5 {
            colour = tint.truncate();
        }
        let [near, far, low, high] = lamp.range;
        if lamp.height > 0.5 {
            let up = Vec4::from(lamp.up);
            let height = up.w + up.truncate().dot(self.point(x, y, depth));
            let share = ((height - low) / (high - low).max(1e-30)).clamp(0.0, 1.0);
            let paint = |k: usize| Vec4::from(colours.palette[k]).truncate();
            colour = paint(1).lerp(paint(0), share);
        }
        let towards = Vec4::from(lamp.towards);
        let normal = self.normal(x, y, depth);
        let facing = normal.dot(towards.truncate()).max(0.0);
        let open = 1.0 - lamp.hollows * self.hollow(x, y, depth, normal);
        let shine = (towards.w + (1.0 - towards.w) * facing) * open;
        // Light adds up as it is, not as it is written.
        let light = (to_linear(colour) * shine * 1.25).powf(1.0 / 2.2);
        let ground = Vec4::from(lamp.ground);
        let fog = ground.w * ((depth - near) / (far - near).max(1e-30)).clamp(0.0, 1.0);
        light.lerp(ground.truncate(), fog).clamp(Vec3::ZERO, Vec3::ONE).extend(1.0)
    }

    /// A pixel's point, as the eye has it.
    fn point(&self, x: i32, y: i32, depth: f32) -> Vec3 {
        let [width, height] = self.lamp.size;
        let (cx, cy) = (0.5 * width as f32, 0.5 * height as f32);
        Vec3::new((x as f32 + 0.5 - cx) / self.lamp.focal, (cy - y as f32 - 0.5) / self.lamp.focal, 1.0)
            * depth
    }

    /// The lie of the surface: a plane through what is near, by least squares, each pixel weighed by how near it is in
    /// depth.
    fn normal(&self, x: i32, y: i32, depth: f32) -> Vec3 {
        let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0_f32, 0.0_f32, 0.0_f32, 0.0_f32, 0.0_f32);
        for dy in -NORMAL_REACH..=NORMAL_REACH {
            for dx in -NORMAL_REACH..=NORMAL_REACH {
                let near = self.depth(x + dx, y + dy);
                if near >= NOTHING_DEPTH {
                    continue;
                }
                // In pixels. Of a plane it is the inverse of the depth that changes evenly from pixel to pixel.
                let step = self.lamp.focal * (1.0 - depth / near);
                let (fx, fy) = (dx as f32, dy as f32);
                let weight = 1.0 / (1.0 + 0.15 * step * step);
                xx += weight * fx * fx;
                xy += weight * fx * fy;
                yy += weight * fy * fy;
                xz += weight * fx * step;
                yz += weight * fy * step;
            }
        }
        let det = xx * yy - xy * xy;
        if det < 1e-3 {
            return Vec3::new(0.0, 0.0, -1.0);
        }
        let (gx, gy) = ((xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det);
        // Rows go down, y goes up; and beside the middle of the picture the eye looks at a slant.
        let slant = self.point(x, y, 1.0);
        Vec3::new(gx, -gy, slant.y * gy - slant.x * gx - 1.0).normalize()
    }

    /// How much of what is around stands out of the plane of the surface: 0 in the open, 1 in a deep hole. A slope
    /// alone is no hollow, and what lies beyond the border of the picture is not known: it does not count as open.
    fn hollow(&self, x: i32, y: i32, depth: f32, normal: Vec3) -> f32 {
        let unit = depth / self.lamp.focal;
        let own = self.point(x, y, depth);
        let mut sum = 0.0;
        for (ring, (radius, weight)) in HOLLOW_RINGS.into_iter().enumerate() {
            let (mut covered, mut known) = (0.0, 0.0_f32);
            for ray in 0..RING_DIRECTIONS {
                // Rings are turned against each other.
                let angle =
                    std::f32::consts::TAU * (ray as f32 + 0.25 * ring as f32) / RING_DIRECTIONS as f32;
                let (dx, dy) = ((radius * angle.cos()).round() as i32, (radius * angle.sin()).round() as i32);
                if !self.inside(x + dx, y + dy) {
                    continue;
                }
                known += 1.0;
                let there = self.depth(x + dx, y + dy);
                if there >= NOTHING_DEPTH {
                    continue;
                }
                let way = (self.point(x + dx, y + dy, there) - own) / (radius * unit);
                let rise = normal.dot(way);
                // What lies far before it is something else, and throws little shade.
                covered += if rise > 0.0 {
                    (0.7 * rise).min(1.0) / (1.0 + 0.02 * way.length_squared())
                } else {
                    0.0
                };
            }
            sum += weight * covered / known.max(1.0);
        }
        sum.min(1.0)
    }
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
}
