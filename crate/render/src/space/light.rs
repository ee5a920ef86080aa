//! From depths to a picture.

use glam::Vec3;

use super::{Camera, Relief};
use crate::colour::Look;

/// What colours a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Paint {
    /// The first letter, as in the plane.
    #[default]
    Map,
    /// How high it lies, from the second colour of the palette to the first.
    Height,
}

/// How a scene is lit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// Towards the light, as the eye has it: right, up, away. Of any length but 0.
    pub towards: [f32; 3],
    /// How much of the light comes from everywhere: 0 to 1.
    pub ambient: f32,
    /// How dark hollows are: 0 to 1.
    pub hollows: f32,
    /// How much fades into the ground colour at the farthest depth: 0 to 1.
    pub fog: f32,
    /// What fog fades into, sRGB from 0 to 1.
    pub ground: [f32; 3],
    /// What colours a pixel.
    pub paint: Paint,
    /// The heights that are painted lowest and highest, in units of space.
    pub heights: [f32; 2],
}

impl Default for Lighting {
    fn default() -> Self {
        Self {
            towards: [-0.5, 0.8, -0.6],
            ambient: 0.35,
            hollows: 0.75,
            fog: 0.25,
            ground: [0.0; 3],
            paint: Paint::Map,
            heights: [-1.0, 1.0],
        }
    }
}

/// Pixels to each side that the lie of the surface is taken from.
const REACH: i32 = 2;
/// Rings of pixels at which hollows are looked for, and how much each counts.
const RINGS: [(f32, f32); 4] = [(2.0, 0.2), (5.0, 0.3), (12.0, 0.3), (28.0, 0.2)];
/// Directions on a ring.
const RAYS: usize = 8;

/// RGBA pixels, straight alpha, row 0 on top: `looks` holds one look for each object, the last for all further ones.
#[must_use]
pub fn light(relief: &Relief, camera: &Camera, looks: &[Look], lighting: &Lighting) -> Vec<u8> {
    let focal = camera.focal(relief.height()) as f32;
    let scene = Scene { relief, focal, width: relief.width() as i32, height: relief.height() as i32 };
    let towards = Vec3::from(lighting.towards).try_normalize().unwrap_or(Vec3::Y);
    let seen = || relief.depth().iter().copied().filter(|depth| depth.is_finite());
    let (near, far) = seen().fold((f32::INFINITY, 0.0_f32), |(a, b), depth| (a.min(depth), b.max(depth)));
    let up = camera.turn.col(1).as_vec3();
    let base = camera.eye.y as f32;
    let mut pixels = Vec::with_capacity(relief.codes().len() * 4);
    for (at, &code) in relief.codes().iter().enumerate() {
        let (Some(place), Some(look)) = (code.checked_sub(1), looks.get(object(code)).or(looks.last()))
        else {
            pixels.extend([0; 4]);
            continue;
        };
        let (x, y) = (at as i32 % scene.width, at as i32 / scene.width);
        let depth = relief.depth()[at];
        let colour = match lighting.paint {
            Paint::Map => look.colour(1 + (place & 0x3_ffff)),
            Paint::Height => {
                let [low, high] = lighting.heights;
                let height = base + up.dot(scene.point(x, y, depth));
                let share = ((height - low) / (high - low).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
                let [a, b] = [look.palette[1], look.palette[0]];
                [0, 1, 2].map(|k| a[k] + share * (b[k] - a[k]))
            }
        };
        let facing = scene.normal(x, y, depth).dot(towards).max(0.0);
        let open = 1.0 - lighting.hollows * scene.hollow(x, y, depth);
        let shine = (lighting.ambient + (1.0 - lighting.ambient) * facing) * open;
        let fog = lighting.fog * ((depth - near) / (far - near).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
        for (c, ground) in colour.into_iter().zip(lighting.ground) {
            // Light adds up as it is, not as it is written.
            let lit = to_srgb(to_linear(c) * shine * 1.25);
            let faded = lit + fog * (ground - lit);
            pixels.push((faded.clamp(0.0, 1.0) * 255.0).round() as u8);
        }
        pixels.push(255);
    }
    pixels
}

fn object(code: u32) -> usize {
    (code.saturating_sub(1) >> 18) as usize
}

fn to_linear(c: f32) -> f32 {
    c.max(0.0).powf(2.2)
}

fn to_srgb(c: f32) -> f32 {
    c.max(0.0).powf(1.0 / 2.2)
}

struct Scene<'a> {
    relief: &'a Relief,
    focal: f32,
    width: i32,
    height: i32,
}

impl Scene<'_> {
    /// The depth at a pixel; infinite beyond the border.
    fn depth(&self, x: i32, y: i32) -> f32 {
        let inside = x >= 0 && y >= 0 && x < self.width && y < self.height;
        if inside { self.relief.depth()[(y * self.width + x) as usize] } else { f32::INFINITY }
    }

    /// A pixel's point, as the eye has it.
    fn point(&self, x: i32, y: i32, depth: f32) -> Vec3 {
        let (cx, cy) = (0.5 * self.width as f32, 0.5 * self.height as f32);
        Vec3::new((x as f32 + 0.5 - cx) / self.focal, (cy - y as f32 - 0.5) / self.focal, 1.0) * depth
    }

    /// The lie of the surface: a plane through what is near, by least squares, each pixel weighed by how near it is in depth.
    fn normal(&self, x: i32, y: i32, depth: f32) -> Vec3 {
        let unit = depth / self.focal;
        let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0_f32, 0.0_f32, 0.0_f32, 0.0_f32, 0.0_f32);
        for dy in -REACH..=REACH {
            for dx in -REACH..=REACH {
                let step = (self.depth(x + dx, y + dy) - depth) / unit;
                if !step.is_finite() {
                    continue;
                }
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
        // Rows go down, y goes up.
        Vec3::new(gx, -gy, -1.0).normalize()
    }

    /// How much of what is around lies nearer than the surface: 0 in the open, 1 in a deep hole.
    fn hollow(&self, x: i32, y: i32, depth: f32) -> f32 {
        let unit = depth / self.focal;
        let mut sum = 0.0;
        for (ring, (radius, weight)) in RINGS.into_iter().enumerate() {
            let mut covered = 0.0;
            for ray in 0..RAYS {
                // Rings are turned against each other.
                let angle = std::f32::consts::TAU * (ray as f32 + 0.25 * ring as f32) / RAYS as f32;
                let (dx, dy) = ((radius * angle.cos()).round() as i32, (radius * angle.sin()).round() as i32);
                let rise = (depth - self.depth(x + dx, y + dy)) / (radius * unit);
                // What lies far before it is something else, and throws little shade.
                covered += if rise > 0.0 { (0.7 * rise).min(1.0) / (1.0 + 0.02 * rise * rise) } else { 0.0 };
            }
            sum += weight * covered / RAYS as f32;
        }
        sum.min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::colour::Colouring;

    fn camera() -> Camera {
        Camera::looking(DVec3::Z * 10.0, DVec3::ZERO, DVec3::Y, 0.8).unwrap()
    }

    /// The grey of each pixel of a relief whose depth is given.
    fn greys(side: u32, depth: impl Fn(f32, f32) -> f32, lighting: &Lighting) -> Vec<u8> {
        let mut relief = Relief::new(side, side);
        for (y, x) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
            let depth = depth(x as f32 / side as f32 - 0.5, 0.5 - y as f32 / side as f32);
            if depth.is_finite() {
                relief.put(x, y, depth, 1);
            }
        }
        let look = Look::new(Colouring::Map, &[[200, 200, 200]], 1);
        let pixels = light(&relief, &camera(), &[look], lighting);
        assert_eq!(pixels.len(), (side * side * 4) as usize);
        pixels.chunks(4).map(|p| if p[3] == 0 { 0 } else { p[0].max(1) }).collect()
    }

    #[test]
    fn a_slope_towards_the_light_is_brighter() {
        let lighting = Lighting { towards: [-1.0, 0.0, -1.0], hollows: 0.0, fog: 0.0, ..Lighting::default() };
        // Rising to the left means that it is nearer there, and faces right; and the other way round.
        let slope = |s: f32| greys(60, move |x, _| 10.0 + s * x * 8.0, &lighting)[30 * 60 + 30];
        let (left, flat, right) = (slope(-1.0), slope(0.0), slope(1.0));
        assert!(left > flat && flat > right, "{left} {flat} {right}");
    }

    #[test]
    fn pits_are_dark_and_what_is_far_fades() {
        let lighting = Lighting { fog: 0.0, ..Lighting::default() };
        let pit = greys(80, |x, y| if x.hypot(y) < 0.06 { 11.0 } else { 10.0 }, &lighting);
        assert!(pit[40 * 80 + 40] + 25 < pit[40 * 80 + 8], "{} {}", pit[40 * 80 + 40], pit[40 * 80 + 8]);
        let steps = |x: f32, _| if x < 0.0 { 10.0 } else { 30.0 };
        let [plain, foggy] =
            [0.0, 1.0].map(|fog| greys(80, steps, &Lighting { fog, hollows: 0.0, ..lighting })[40 * 80 + 70]);
        assert!(foggy < 10 && plain > 80, "{plain} {foggy}");
        let none = greys(8, |_, _| f32::INFINITY, &lighting);
        assert!(none.iter().all(|&grey| grey == 0));
    }
}
