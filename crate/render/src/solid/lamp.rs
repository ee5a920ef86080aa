//! How a scene of space is lit, and the same as the shader reads it.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};

use super::{Camera, MAX_OBJECTS};

/// What colours a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Paint {
    /// The first letter, as in the plane; the colour of its own where an object has one.
    #[default]
    Map,
    /// How high it lies, from the second colour of the palette to the first.
    Height,
}

/// How a scene is lit.
#[derive(Clone, Debug, PartialEq)]
pub struct Lighting {
    /// Towards the light, as the eye has it: right, up, away. Of any length but 0.
    pub towards: DVec3,
    /// How much of the light comes from everywhere: 0 to 1.
    pub ambient: f64,
    /// How dark hollows are: 0 to 1.
    pub hollows: f64,
    /// How dark cast shadows are: 0 to 1.
    pub shadows: f64,
    /// How soft their edges are: 0 for a small light, 1 for a large one.
    pub softness: f64,
    /// How much of the light from everywhere what is around keeps off: 0 to 1.
    pub occlusion: f64,
    /// How far the light from everywhere is that of a blue sky over brown ground, and the other warm: 0 to 1.
    pub sky: f64,
    /// How much light the surface mirrors, and how sharply: 0 is rough.
    pub gloss: f64,
    /// Whether the brightest tones are compressed, as on film, and not cut off.
    pub filmic: bool,
    /// How much fades into the ground colour at the farthest depth: 0 to 1.
    pub fog: f64,
    /// What fog fades into, sRGB from 0 to 1.
    pub ground: [f32; 3],
    /// What colours a pixel.
    pub paint: Paint,
    /// The heights that are painted lowest and highest, in units of space.
    pub heights: [f64; 2],
    /// One colour for all of an object, sRGB from 0 to 1; objects beyond the list have those of their maps.
    pub tints: Vec<Option<[f32; 3]>>,
}

impl Default for Lighting {
    fn default() -> Self {
        Self {
            towards: DVec3::new(-0.5, 0.8, -0.6),
            ambient: 0.35,
            hollows: 0.75,
            shadows: 0.0,
            softness: 0.0,
            occlusion: 0.0,
            sky: 0.0,
            gloss: 0.0,
            filmic: false,
            fog: 0.25,
            ground: [0.0; 3],
            paint: Paint::Map,
            heights: [-1.0, 1.0],
            tints: Vec::new(),
        }
    }
}

impl Lighting {
    /// Towards a light so far round to the side, in radians, and so far in front of the scene, 0 to 1.
    #[must_use]
    pub fn direction(side: f64, front: f64) -> DVec3 {
        let (sin, cos) = side.sin_cos();
        let front = front.clamp(0.0, 1.0);
        let grazing = (1.0 - front * front).sqrt();
        // As the eye has it, z is away from it.
        DVec3::new(sin * grazing, cos * grazing, -front)
    }
}

/// What `shader/solid/shade.wgsl` calls `Lamp`: a uniform buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Lamp {
    /// Towards the light; how much light comes from everywhere.
    pub towards: [f32; 4],
    /// What fog fades into; how much at the farthest depth.
    pub ground: [f32; 4],
    /// Upwards, as the eye has it; the height of the eye.
    pub up: [f32; 4],
    /// The nearest and the farthest depth; the lowest and the highest height that is painted.
    pub range: [f32; 4],
    /// Width and height of the source, in pixels.
    pub size: [i32; 2],
    /// Pixels a unit at depth 1.
    pub focal: f32,
    /// How dark hollows are.
    pub hollows: f32,
    /// 1 to paint by height, 0 by maps.
    pub height: f32,
    /// Pixels of the source for each one that is shown, each way.
    pub factor: i32,
    /// How far hollows are looked for: 1 in a picture that has as many pixels as it is to have in the end.
    pub reach: f32,
    /// How much of the light from everywhere what is around keeps off; the shader leaves that to the picture at rest.
    pub occlusion: f32,
    /// Sky light, gloss, 1 for the curve of film, and how dark cast shadows are, which the shader leaves alike.
    pub finish: [f32; 4],
    /// A colour for each object that has one: its alpha is 1.
    pub tints: [[f32; 4]; MAX_OBJECTS],
}

impl Lamp {
    /// The lamp of a scene in a source of `width` x `height` pixels, with `factor` x `factor` of them for each one
    /// shown; `range` is what depths there are.
    #[must_use]
    pub fn new(lighting: &Lighting, camera: &Camera, size: [u32; 2], factor: u32, range: [f32; 2]) -> Self {
        let part = |x: f64| x.clamp(0.0, 1.0) as f32;
        let towards = lighting.towards.as_vec3().try_normalize().unwrap_or(Vec3::Y);
        let up = camera.turn.col(2).as_vec3();
        let [r, g, b] = lighting.ground;
        let tint = |i: usize| match lighting.tints.get(i) {
            Some(Some([r, g, b])) => [*r, *g, *b, 1.0],
            _ => [0.0; 4],
        };
        Self {
            towards: towards.extend(part(lighting.ambient)).to_array(),
            ground: [r, g, b, part(lighting.fog)],
            up: up.extend(camera.eye.z as f32).to_array(),
            range: [range[0], range[1], lighting.heights[0] as f32, lighting.heights[1] as f32],
            size: size.map(|side| side as i32),
            focal: camera.focal(size[1]) as f32,
            hollows: part(lighting.hollows),
            height: f32::from(u8::from(lighting.paint == Paint::Height)),
            factor: factor.max(1) as i32,
            reach: 1.0,
            occlusion: part(lighting.occlusion),
            finish: [
                part(lighting.sky),
                part(lighting.gloss),
                f32::from(u8::from(lighting.filmic)),
                part(lighting.shadows),
            ],
            tints: std::array::from_fn(tint),
        }
    }
}
