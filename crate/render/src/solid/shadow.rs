//! Cast shadows: what the lamp sees, and how much of it a point sees.

use std::f32::consts::TAU;
use std::ops::Range;

use glam::{DMat3, DVec3, Mat3A, Vec2, Vec3, Vec3A};

use super::{Camera, DepthBuffer, Lighting, Objects, Traversal};

/// How far off the lamp stands, by half the width of what it lights: its rays are nearly parallel.
const LAMP_DISTANCE: f64 = 24.0;
/// Half the angle of the largest lamp, as a slope.
const WIDEST_LAMP: f32 = 0.16;
/// The longest side of what the lamp sees, in pixels, and the shortest.
const SIDES: Range<u32> = 64..2048;
/// Rays that look for what stands before the lamp, and rays towards it.
const SEEKING: usize = 10;
const RAYS: usize = 16;
/// The widest search, by the width of what the lamp sees.
const WIDEST_SEARCH: f32 = 0.04;
/// Steeper slopes before the lamp are rounding.
const STEEPEST: f32 = 4.0;

/// Where the lamp stands for a picture, and how large a picture it takes.
#[derive(Clone, Copy, Debug)]
pub struct LampView {
    /// What the lamp sees.
    pub camera: Camera,
    /// Its sides, in pixels.
    pub side: u32,
}

impl LampView {
    /// For a picture of `size` pixels of these objects: it sees what casts shadows on what the camera sees.
    #[must_use]
    pub fn new(objects: &Objects, lighting: &Lighting, camera: &Camera, size: [u32; 2]) -> Option<Self> {
        let towards = camera.turn.transpose() * lighting.towards.try_normalize()?;
        let up = if towards.z.abs() < 0.9 { DVec3::Z } else { DVec3::X };
        let flat = Camera::looking(DVec3::ZERO, -towards, up, 1.0).ok()?.turn;
        let camera_focal = camera.focal(size[1]);
        let aspect = f64::from(size[0]) / f64::from(size[1].max(1));
        let slopes = [camera.slope * aspect, camera.slope];
        let (mut least, mut most) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (mut farthest, mut range) = (0.0_f64, [f64::INFINITY, 0.0_f64]);
        for bounds in objects.bounds() {
            let middle = flat * (bounds.centre - camera.eye);
            farthest = farthest.max(middle.length() + bounds.radius);
            let Some((low, high)) = seen_box(camera.seen(bounds.centre), bounds.radius, slopes) else {
                continue;
            };
            range = [range[0].min(low.z), range[1].max(high.z)];
            let corners = [low, high];
            let corner = |k: usize| DVec3::new(corners[k & 1].x, corners[k >> 1 & 1].y, corners[k >> 2].z);
            let turn = flat * camera.turn.transpose();
            let placed = (0..8).map(|k| turn * corner(k));
            let (a, b) =
                placed.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(a, b), p| (a.min(p), b.max(p)));
            least = least.min(a.max(middle - bounds.radius));
            most = most.max(b.min(middle + bounds.radius));
        }
        let half = 0.5 * (most - least).truncate().max_element() * 1.02;
        if !(half > 0.0 && half.is_finite()) {
            return None;
        }
        let centre = 0.5 * (least + most);
        let distance = LAMP_DISTANCE * half + 2.0 * farthest;
        let eye = camera.eye + flat.transpose() * (centre - DVec3::Z * distance);
        let target = camera.eye + flat.transpose() * centre;
        let camera = Camera::looking(eye, target, up, 2.0 * (half / distance).atan()).ok()?;
        // Its pixels are as wide as those of the picture, half way into it.
        let halfway = (range[0].max(1e-2 * range[1]) * range[1]).sqrt();
        let pixels = 2.0 * half * camera_focal / halfway.max(f64::MIN_POSITIVE);
        let side = (pixels as u32).clamp(SIDES.start, SIDES.end);
        Some(Self { camera, side })
    }
}

/// What a camera of these slopes can see of a ball, as it has it: a box around it.
fn seen_box(middle: DVec3, radius: f64, slopes: [f64; 2]) -> Option<(DVec3, DVec3)> {
    let far = middle.z + radius;
    if far <= 0.0 {
        return None;
    }
    let reach = DVec3::new(slopes[0] * far, slopes[1] * far, far);
    let low = (middle - radius).max(DVec3::new(-reach.x, -reach.y, 0.0));
    let high = (middle + radius).min(reach);
    low.cmplt(high).all().then_some((low, high))
}

/// What the lamp sees, before points of a picture.
#[derive(Clone, Debug)]
pub struct Shadows<'a> {
    depth: &'a [f32],
    side: usize,
    focal: f32,
    /// From the eye to the lamp.
    turn: Mat3A,
    shift: Vec3A,
    slope: f32,
    /// How wide a pixel of the picture is, at depth 1.
    pixel: f32,
    /// Points on a disc, turned a little further each time.
    turns: Vec<Vec2>,
    seeking: [Vec2; SEEKING],
    rays: [Vec2; RAYS],
}

/// Turns that differ: a pixel and its neighbours have different ones.
const TURNS: usize = 64;

impl<'a> Shadows<'a> {
    /// Of what was carved before the lamp: depths, row by row from the top. `None` where they are not as many.
    #[must_use]
    pub fn new(
        view: &LampView,
        depth: &'a [f32],
        lighting: &Lighting,
        camera: &Camera,
        height: u32,
    ) -> Option<Self> {
        let side = view.side as usize;
        if depth.len() != side * side {
            return None;
        }
        let turn: DMat3 = view.camera.turn * camera.turn.transpose();
        let shift = view.camera.seen(camera.eye);
        let single = DMat3::as_mat3(&turn);
        let angle = |k: usize| {
            let (sin, cos) = (TAU * k as f32 / TURNS as f32).sin_cos();
            Vec2::new(cos, sin)
        };
        Some(Self {
            depth,
            side,
            focal: view.camera.focal(view.side) as f32,
            turn: Mat3A::from(single),
            shift: shift.as_vec3a(),
            slope: WIDEST_LAMP * (lighting.softness as f32).clamp(0.0, 1.0),
            pixel: (1.0 / camera.focal(height)) as f32,
            turns: (0..TURNS).map(angle).collect(),
            seeking: std::array::from_fn(|k| spiral(k, SEEKING)),
            rays: std::array::from_fn(|k| spiral(k, RAYS)),
        })
    }

    /// How much of the lamp is seen from a point before the eye: 0 to 1. `normal` is that of the surface there.
    #[must_use]
    pub fn lit(&self, point: Vec3, normal: Vec3, [x, y]: [usize; 2]) -> f32 {
        let normal = Vec3A::from(normal);
        let scale_there = (self.turn * Vec3A::from(point) + self.shift).z / self.focal;
        // Off the surface by what neither picture can tell.
        let off = 1.2 * scale_there + 1.0 * self.pixel * point.z;
        let place = self.turn * (Vec3A::from(point) + normal * off) + self.shift;
        let scale = self.focal / place.z;
        let middle = 0.5 * self.side as f32;
        let at = Vec2::new(middle + scale * place.x, middle - scale * place.y);
        // How deep the surface goes on from pixel to pixel of the lamp.
        let facing = self.turn * normal;
        let steep =
            |along: f32| (-along / facing.z.min(-1e-3) / scale).clamp(-STEEPEST / scale, STEEPEST / scale);
        let plane = Vec2::new(steep(facing.x), -steep(facing.y));
        let slack = 0.5 / scale;
        let turn = self.turns[(noise(x, y) * TURNS as f32) as usize % TURNS];
        // How far before it stands what is between: the farther the softer its shadow is.
        let widest = WIDEST_SEARCH * self.side as f32;
        let wide = (self.slope * self.side as f32).clamp(1.5, widest);
        let (mut sum, mut count) = (0.0, 0.0);
        for step in self.seeking {
            let step = turn.rotate(step) * wide;
            let there = self.depth_at(at + step);
            if there < place.z + plane.dot(step) - slack {
                sum += there;
                count += 1.0;
            }
        }
        // Well within the light, or the shadow.
        if count == 0.0 || count > SEEKING as f32 - 0.5 {
            return if count == 0.0 { 1.0 } else { 0.0 };
        }
        let apart = (place.z - sum / count).max(0.0);
        let radius = (self.slope * apart * scale).clamp(0.9, wide);
        let open = |ray: &&Vec2| {
            let step = turn.rotate(**ray) * radius;
            self.depth_at(at + step) >= place.z + plane.dot(step) - slack
        };
        self.rays.iter().filter(open).count() as f32 / RAYS as f32
    }

    fn depth_at(&self, at: Vec2) -> f32 {
        let side = self.side as f32;
        if at.x >= 0.0 && at.y >= 0.0 && at.x < side && at.y < side {
            self.depth[at.y as usize * self.side + at.x as usize]
        } else {
            f32::INFINITY
        }
    }
}

/// Points of a disc, spread evenly: the golden angle apart.
fn spiral(k: usize, count: usize) -> Vec2 {
    let (sin, cos) = (2.399_963_1 * k as f32).sin_cos();
    let radius = ((k as f32 + 0.5) / count as f32).sqrt();
    Vec2::new(cos, sin) * radius
}

/// A number from 0 to 1 that differs much from pixel to pixel and little on the average of a few (Jimenez, 2014).
fn noise(x: usize, y: usize) -> f32 {
    (52.982_918 * (0.067_110_56 * x as f32 + 0.005_837_15 * y as f32).fract()).fract()
}

/// What the lamp sees, carved in one go.
#[must_use]
pub fn depths_of_lamp(objects: &Objects, view: &LampView) -> DepthBuffer {
    let mut traversal: Traversal = objects.traversal(&view.camera, view.side, view.side);
    while !traversal.run(1 << 20) {}
    traversal.depth_buffer().clone()
}

#[cfg(test)]
mod tests {
    use frond_core::{Affine3, Ifs3};
    use glam::DQuat;

    use super::*;

    /// A square sheet at height z, and a smaller one over its middle.
    fn sheets(height: f64, side: f64) -> Objects {
        let sheet = |side: f64, z: f64| {
            let corner = |k: u32| {
                let at =
                    DVec3::new(f64::from(k & 1) - 0.5, f64::from(k >> 1) - 0.5, 0.0) * side + DVec3::Z * z;
                Affine3::similitude(0.5, DQuat::IDENTITY, at * 0.5)
            };
            Ifs3::new((0..4).map(corner).collect()).unwrap()
        };
        Objects::new(vec![sheet(4.0, 0.0), sheet(side, height)], vec![None; 2], vec![None; 2])
    }

    struct Seen {
        view: LampView,
        depths: DepthBuffer,
        lighting: Lighting,
        camera: Camera,
    }

    const SIZE: [u32; 2] = [300, 200];

    fn seen(objects: &Objects, towards: DVec3, softness: f64) -> Seen {
        let camera = Camera::looking(DVec3::new(0.0, -9.0, 5.0), DVec3::ZERO, DVec3::Z, 0.6).unwrap();
        let lighting = Lighting { towards: camera.turn * towards, softness, ..Lighting::default() };
        let view = LampView::new(objects, &lighting, &camera, SIZE).unwrap();
        let depths = depths_of_lamp(objects, &view);
        Seen { view, depths, lighting, camera }
    }

    impl Seen {
        /// How much of the lamp a place of the larger sheet sees.
        fn at(&self, x: f64, y: f64) -> f32 {
            let Self { view, depths, lighting, camera } = self;
            let shadows = Shadows::new(view, depths.depth(), lighting, camera, SIZE[1]).unwrap();
            let point = camera.seen(DVec3::new(x, y, 0.0)).as_vec3();
            let normal = (camera.turn * DVec3::Z).as_vec3();
            // Neighbours look in different directions.
            let rays = (0..16).map(|k| shadows.lit(point, normal, [k % 4, k / 4]));
            rays.sum::<f32>() / 16.0
        }
    }

    #[test]
    fn a_shadow_lies_where_the_lamp_is_covered_and_nowhere_else() {
        let objects = sheets(1.0, 1.0);
        for slope in [0.0, 0.5, -0.7] {
            let seen = seen(&objects, DVec3::new(slope, 0.0, 1.0), 0.0);
            // From 1 above, the shadow lies aside by what the lamp does.
            for k in -18..=18 {
                let x = 0.1 * f64::from(k);
                let beside = (x + slope).abs();
                if (beside - 0.5).abs() > 0.07 {
                    let lit = seen.at(x, 0.0);
                    assert_eq!(lit, f32::from(u8::from(beside > 0.5)), "{slope}: {x}");
                }
            }
        }
    }

    #[test]
    fn what_is_open_to_the_lamp_has_no_shadow_of_its_own() {
        // A sheet alone, before lamps from high to grazing.
        let objects = sheets(0.0, 0.5);
        for softness in [0.0, 0.5, 1.0] {
            for slope in [0.0, 1.0, 2.0, 3.5] {
                let seen = seen(&objects, DVec3::new(slope, 0.3, 1.0), softness);
                for (x, y) in (-9..=9).flat_map(|y| (-9..=9).map(move |x| (x, y))) {
                    let lit = seen.at(0.2 * f64::from(x), 0.2 * f64::from(y));
                    assert!(lit > 0.97, "{softness}, {slope}: {lit} at {x} {y}");
                }
            }
        }
    }

    #[test]
    fn a_large_lamp_and_what_is_far_throw_soft_shadows() {
        // How wide the edge is: places that see a part of the lamp.
        let edge = |height: f64, softness: f64| {
            let objects = sheets(height, 1.4);
            let seen = seen(&objects, DVec3::Z, softness);
            (0..200).filter(|&k| (0.05..0.95).contains(&seen.at(0.01 * f64::from(k), 0.0))).count()
        };
        let [sharp, near, far] = [edge(0.6, 0.0), edge(0.6, 1.0), edge(1.2, 1.0)];
        // A lamp of slope 0.16 blurs the edge by twice that of the height.
        assert!(sharp < 8, "{sharp}");
        assert!((10..30).contains(&near) && far > near + 6, "{near} {far}");
    }

    #[test]
    fn a_lamp_that_nothing_can_be_lit_by_is_none() {
        let camera = Camera::looking(DVec3::Z * 9.0, DVec3::ZERO, DVec3::Y, 0.6).unwrap();
        let objects = sheets(1.0, 1.0);
        for towards in [DVec3::ZERO, DVec3::NAN, DVec3::splat(f64::INFINITY)] {
            let lighting = Lighting { towards, ..Lighting::default() };
            assert!(LampView::new(&objects, &lighting, &camera, SIZE).is_none());
        }
        // Behind the eye nothing is seen.
        let away = Camera::looking(DVec3::Z * 9.0, DVec3::Z * 20.0, DVec3::Y, 0.6).unwrap();
        assert!(LampView::new(&objects, &Lighting::default(), &away, SIZE).is_none());
        let view = LampView::new(&objects, &Lighting::default(), &camera, SIZE).unwrap();
        assert!(Shadows::new(&view, &[1.0; 9], &Lighting::default(), &camera, 200).is_none());
    }
}
