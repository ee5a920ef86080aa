//! From depths to a picture: a CPU twin of `shader/solid/shade.wgsl`.

use std::ops::Range;

use glam::{Vec3, Vec4};

use super::around::{Around, LANES};
use super::points::OBJECT_BIT;
use super::shadow::Shadows;
use super::tone::{film, light_of, written};
use super::{DepthBuffer, Lamp};
use crate::picture::colour::Colours;

/// RGBA pixels of a depth buffer, row 0 on top, as `lamp` has it: `lamp.factor` x `lamp.factor` pixels of the buffer
/// make one.
#[must_use]
pub fn light(buffer: &DepthBuffer, lamp: &Lamp, colours: &Colours, shadows: Option<&Shadows>) -> Vec<u8> {
    let rows = (lamp.size[1] / lamp.factor.max(1)).max(0) as u32;
    light_rows(buffer, 0, lamp, colours, shadows, 0..rows)
}

/// Some rows of that picture, from a buffer that has those of its source from `top` on. It should have all that is to
/// be lit, and so many more above and below as [`reach_of`](super::reach_of) says.
#[must_use]
pub fn light_rows(
    buffer: &DepthBuffer,
    top: u32,
    lamp: &Lamp,
    colours: &Colours,
    shadows: Option<&Shadows>,
    rows: Range<u32>,
) -> Vec<u8> {
    let factor = lamp.factor.max(1) as usize;
    let mut scene = Scene::new(buffer, top, lamp, colours, shadows);
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
                            // Light adds up as it is, not as it is written.
                            *sum += if factor > 1 { light_of(lit.truncate()).extend(lit.w) } else { lit };
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
            let scale = 1.0 + (alpha - 1.0) * colours.premultiply;
            let colour = sum.truncate() / sum.w;
            let colour = if factor > 1 { written(colour) } else { colour };
            let colour = (colour * scale).extend(alpha).clamp(Vec4::ZERO, Vec4::ONE);
            // A cast rounds down.
            pixels.extend((colour * 255.0 + 0.5).to_array().map(|c| c as u8));
        }
    }
    pixels
}

struct Scene<'a> {
    buffer: &'a DepthBuffer,
    top: usize,
    lamp: &'a Lamp,
    colours: &'a Colours,
    around: Around,
    shadows: Option<&'a Shadows<'a>>,
    /// The colour of the code that was seen last: pieces are seen in one place.
    last: (u32, Vec3),
}

impl<'a> Scene<'a> {
    fn new(
        buffer: &'a DepthBuffer,
        top: u32,
        lamp: &'a Lamp,
        colours: &'a Colours,
        shadows: Option<&'a Shadows<'a>>,
    ) -> Self {
        let top = top as usize;
        let around = Around::new(buffer, top, lamp);
        Self { buffer, top, lamp, colours, around, shadows, last: (0, Vec3::ZERO) }
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
        let first = self.around.place(x, y);
        let depth = self.around.depths_at(first, 0, 0);
        let slant = self.around.slant(x as f32, y as f32);
        let normal = self.around.normal(first, depth, slant);
        let lamp = self.lamp;
        let towards = Vec4::from(lamp.towards);
        let facing = (normal.x * towards.x + normal.y * towards.y + normal.z * towards.z).max(Vec4::ZERO);
        let [hollow, covered] = self.around.covered(first, y & 1 == 1, depth, slant, normal);
        let open = Vec4::ONE - hollow * lamp.hollows;
        let free = Vec4::ONE - covered * lamp.occlusion;
        let [near, far, ..] = lamp.range;
        let ground = Vec4::from(lamp.ground);
        let fog = (depth - near) / (far - near).max(1e-30);
        let fog = fog.clamp(Vec4::ZERO, Vec4::ONE) * ground.w;
        let [sky, gloss, filmic, dark] = lamp.finish;
        for (lane, &code) in codes.iter().enumerate() {
            let Some(place) = code.checked_sub(1) else { continue };
            let way = Vec3::new(slant.x[lane], slant.y[lane], 1.0);
            let point = way * depth[lane];
            let colour = self.colour(place, point);
            let normal = Vec3::new(normal.x[lane], normal.y[lane], normal.z[lane]);
            let mut lamplight = (1.0 - towards.w) * facing[lane];
            if let Some(shadows) = self.shadows.filter(|_| dark > 0.0 && facing[lane] > 0.0) {
                lamplight *= 1.0 - dark * (1.0 - shadows.lit(point, normal, [x + lane, y]));
            }
            let [lamplight, skylight] = [Vec3::splat(lamplight), Vec3::splat(towards.w * free[lane])];
            let rise = 0.5 + 0.5 * normal.dot(Vec4::from(lamp.up).truncate());
            let skylight = skylight * Vec3::ONE.lerp(GROUND_LIGHT.lerp(SKY_LIGHT, rise), sky);
            let lamplight = lamplight * Vec3::ONE.lerp(WARM_LIGHT, sky);
            let mut light = light_of(colour) * (skylight + lamplight);
            if gloss > 0.0 && facing[lane] > 0.0 {
                light += mirrored(gloss, way, normal, towards.truncate()) * lamplight;
            }
            light *= open[lane] * if filmic > 0.5 { FILM_EXPOSURE } else { PLAIN_EXPOSURE };
            let light = written(if filmic > 0.5 { film(light) } else { light });
            let light = light.lerp(ground.truncate(), fog[lane]).clamp(Vec3::ZERO, Vec3::ONE);
            lit[lane] = light.extend(1.0);
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
}

/// How much light white would give back if all fell on it: what is facing the lamp may be brighter than white where
/// nothing is cut off.
const PLAIN_EXPOSURE: f32 = 1.25;
const FILM_EXPOSURE: f32 = 1.85;
/// Light of the sky, of the ground, and of a low sun: white in the middle.
const SKY_LIGHT: Vec3 = Vec3::new(0.95, 1.25, 1.75);
const GROUND_LIGHT: Vec3 = Vec3::new(0.62, 0.48, 0.36);
const WARM_LIGHT: Vec3 = Vec3::new(1.22, 1.0, 0.74);

/// The exponent of a highlight, from broad to narrow: whole, so that it takes no logarithm.
fn sharpness(gloss: f32) -> i32 {
    (6.0 + 250.0 * gloss * gloss) as i32
}

/// How much of the lamp a surface of this gloss mirrors, by what falls on it: half way between eye and lamp most.
fn mirrored(gloss: f32, way: Vec3, normal: Vec3, towards: Vec3) -> f32 {
    let eye = -way.normalize();
    let half = (eye + towards).normalize_or_zero();
    let sharp = sharpness(gloss);
    let narrow = normal.dot(half).max(0.0).powi(sharp);
    let sharp = sharp as f32;
    // At a slant everything mirrors.
    let slanted = 0.04 + 0.96 * (1.0 - eye.dot(half).clamp(0.0, 1.0)).powi(5);
    gloss * slanted * narrow * (sharp + 8.0) * 0.25
}

#[cfg(test)]
mod tests {
    use frond_core::Colouring;
    use glam::DVec3;

    use super::*;
    use crate::solid::{Camera, Lighting, reach_of};

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
        let pixels = light(&buffer, &lamp, &colours, None);
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
                light(&buffer, &Lamp { focal: 200.0, ..lamp }, &colours, None)
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
            let whole = light(&buffer, &lamp, &colours, None);
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
                bands.extend(light_rows(&part, top, &lamp, &colours, None, band));
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
            let pixels = light(&buffer, &Lamp { reach, ..lit }, &colours, None);
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
