//! Pictures of space: what a renderer is given, and complete ones without a graphics card.

use frond_core::{Affine3, Bounds3, Ifs3, IfsError, MAX_MAPS};
use frond_render::solid::{
    Camera, CameraError, Cloud, Eye, Lamp, Lighting, MAX_OBJECTS, Paint, Traversal, depths, light,
};
use frond_render::{Colouring, Look};
use frond_scene::{PaintName, Row3, SpaceLight, SpaceView};
use glam::DVec3;
use js_sys::{Array, Float32Array, Float64Array, Uint8Array, Uint8ClampedArray, Uint32Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure, of_ifs};
use crate::boundary::look::read_palette;
use crate::boundary::value::{object, read};

#[derive(Deserialize)]
struct PlainObject {
    maps: Vec<Row3>,
    #[serde(default)]
    tint: Option<String>,
}

#[derive(Deserialize)]
struct PlainLook {
    width: f64,
    height: f64,
    factor: f64,
    #[serde(default)]
    palette: Vec<String>,
    ground: String,
}

struct LookOf {
    size: [u32; 2],
    factor: u32,
    palette: Vec<[u8; 3]>,
    ground: [f32; 3],
}

/// The longest side of a picture.
const MOST_SIDE: f64 = 8192.0;

fn side(what: &str, length: f64) -> Result<u32, JsValue> {
    if (1.0..=MOST_SIDE).contains(&length) {
        Ok(length as u32)
    } else {
        Err(bad_input(what, "a side of a picture is 1 to 8192 pixels long"))
    }
}

impl LookOf {
    fn read(value: JsValue) -> Result<Self, JsValue> {
        let plain: PlainLook = read("The look", value)?;
        let [ground] = read_palette(std::slice::from_ref(&plain.ground))?[..] else {
            return Err(bad_input("ground", "a colour is written #rrggbb"));
        };
        Ok(Self {
            size: [side("width", plain.width)?, side("height", plain.height)?],
            factor: if plain.factor >= 2.0 { 2 } else { 1 },
            palette: read_palette(&plain.palette)?,
            ground: ground.map(|c| f32::from(c) / 255.0),
        })
    }
}

fn of_camera(error: CameraError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// A camera, in units of the scene.
fn camera_of(view: JsValue, unit: f64) -> Result<Camera, JsValue> {
    let view: SpaceView = read("The view", view)?;
    if !view.is_one() {
        let angle = view.angle > 0.0 && view.angle < std::f64::consts::PI;
        return Err(of_camera(match (angle, view.distance > 0.0) {
            (false, _) => CameraError::BadAngle,
            (true, false) => CameraError::NoDirection,
            (true, true) => CameraError::NotFinite,
        }));
    }
    let target = DVec3::from_array(view.target) / unit;
    Camera::around(target, view.distance / unit, view.turn, view.tilt, view.angle).map_err(of_camera)
}

/// All objects of a moment, as pictures need them.
#[derive(Clone)]
struct Things {
    systems: Vec<Ifs3>,
    bounds: Vec<Bounds3>,
    tints: Vec<Option<[f32; 3]>>,
    heights: [f64; 2],
    centre: DVec3,
    radius: f64,
    /// What lengths are divided by: a graphics card has single precision.
    unit: f64,
}

/// Scenes of sizes between these are drawn as they are.
const PLAIN_SIZES: std::ops::Range<f64> = 1e-6..1e6;

impl Things {
    fn new(systems: Vec<Ifs3>, tints: Vec<Option<[f32; 3]>>) -> Self {
        let mut systems = systems;
        let mut bounds: Vec<Bounds3> = systems.iter().map(Bounds3::coarse).collect();
        let size = bounds.iter().map(|b| b.min.abs().max(b.max.abs()).max_element()).fold(0.0, f64::max);
        let mut unit = 1.0;
        if size > 0.0 && size.is_finite() && !PLAIN_SIZES.contains(&size) {
            // A power of two, so that no number loses a digit.
            let two = size.log2().round().exp2();
            let by = Affine3::scaling(DVec3::splat(1.0 / two));
            if let Ok(smaller) = systems.iter().map(|ifs| ifs.conjugate(by)).collect::<Result<Vec<_>, _>>() {
                bounds = smaller.iter().map(Bounds3::coarse).collect();
                (systems, unit) = (smaller, two);
            }
        }
        let least = bounds.iter().map(|b| b.min).reduce(DVec3::min).unwrap_or(DVec3::ZERO);
        let largest = bounds.iter().map(|b| b.max).reduce(DVec3::max).unwrap_or(DVec3::ZERO);
        let (centre, radius) = match &bounds[..] {
            [only] => (only.centre, only.radius),
            _ => {
                let centre = 0.5 * (least + largest);
                let reach = |b: &Bounds3| (b.centre - centre).length() + b.radius;
                (centre, bounds.iter().map(reach).fold(0.0, f64::max))
            }
        };
        Self { systems, bounds, tints, heights: [least.z, largest.z], centre, radius, unit }
    }

    fn lighting(&self, plain: &SpaceLight, ground: [f32; 3]) -> Lighting {
        let (sin, cos) = plain.side.sin_cos();
        let front = plain.front.clamp(0.0, 1.0);
        let grazing = (1.0 - front * front).sqrt();
        Lighting {
            // As the eye has it, z is away from it.
            towards: DVec3::new(sin * grazing, cos * grazing, -front),
            ambient: plain.ambient,
            hollows: plain.hollows,
            fog: plain.fog,
            ground,
            paint: if plain.paint == PaintName::Height { Paint::Height } else { Paint::Map },
            heights: self.heights,
            tints: self.tints.clone(),
        }
    }

    fn look(&self, palette: &[[u8; 3]]) -> Look {
        let maps = self.systems.iter().map(Ifs3::len).max().unwrap_or(1);
        Look::new(Colouring::Map, palette, maps)
    }
}

/// The objects of one moment, ready to be drawn.
#[wasm_bindgen]
pub struct SpacePicture(Things);

#[wasm_bindgen]
impl SpacePicture {
    /// Of `{ maps, tint? }` each. Throws where one has no attractor; those that are too many are refused.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "{ maps: MapRow3[]; tint?: string }[]")] objects: Array,
    ) -> Result<Self, JsValue> {
        let count = objects.length() as usize;
        if count == 0 || count > MAX_OBJECTS {
            return Err(bad_input("The objects", "1 to 60 are allowed"));
        }
        let (mut systems, mut tints) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for value in objects.iter() {
            let plain: PlainObject = read("An object", value)?;
            if plain.maps.len() > MAX_MAPS {
                return Err(of_ifs(&IfsError::TooManyMaps { count: plain.maps.len() }));
            }
            let maps = plain.maps.into_iter().map(Affine3::from_row).collect();
            systems.push(Ifs3::new(maps).map_err(|error| of_ifs(&error))?);
            let tint = plain.tint.map(|tint| read_palette(&[tint])).transpose()?;
            tints.push(tint.map(|tint| tint[0].map(|c| f32::from(c) / 255.0)));
        }
        Ok(Self(Things::new(systems, tints)))
    }

    /// The middle of a ball around everything.
    #[wasm_bindgen(getter)]
    pub fn centre(&self) -> Float64Array {
        Float64Array::from(&(self.0.centre * self.0.unit).to_array()[..])
    }

    /// Its radius.
    #[wasm_bindgen(getter)]
    pub fn radius(&self) -> f64 {
        self.0.radius * self.0.unit
    }

    /// About so many points in all, shared by the objects: bytes for `SpaceRenderer.setClouds`.
    #[wasm_bindgen(unchecked_return_type = "{ vertices: Uint8Array; instances: Uint8Array; gap: number }[]")]
    pub fn clouds(&self, points: f64) -> Array {
        // Large objects take up more of the picture, and small ones want to be seen as well.
        let whole: f64 = self.0.bounds.iter().map(|bounds| bounds.radius).sum();
        let points = points.clamp(0.0, 1e8);
        let share = |radius: f64| {
            let part = if whole > 0.0 { radius / whole } else { 1.0 };
            ((points * part) as usize).max(1)
        };
        self.0
            .systems
            .iter()
            .zip(&self.0.bounds)
            .enumerate()
            .map(|(number, (ifs, bounds))| {
                let cloud = Cloud::new(ifs, number as u32, share(bounds.radius), 1 + number as u32);
                object(&[
                    ("vertices", bytes(bytemuck::cast_slice(&cloud.vertices))),
                    ("instances", bytes(bytemuck::cast_slice(&cloud.instances))),
                    ("gap", cloud.gap.into()),
                ])
            })
            .collect()
    }

    /// Bytes for `SpaceRenderer.setUniforms`. Throws where there is no such view.
    #[wasm_bindgen(
        unchecked_return_type = "{ eye: Uint8Array; lamp: Uint8Array; stillLamp: Uint8Array; look: Uint8Array }"
    )]
    pub fn uniforms(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] light: JsValue,
        #[wasm_bindgen(
            unchecked_param_type = "{ width: number; height: number; factor: number; palette: string[]; ground: string }"
        )]
        look: JsValue,
    ) -> Result<JsValue, JsValue> {
        let (camera, look) = (camera_of(view, self.0.unit)?, LookOf::read(look)?);
        let lighting = self.0.lighting(&read("The light", light)?, look.ground);
        let [width, height] = look.size;
        let range = depths(&self.0.bounds, &camera);
        let eye = Eye::new(&camera, width, height, range);
        let lamp = Lamp::new(&lighting, &camera, look.size, 1, range);
        let still = look.size.map(|side| side * look.factor);
        let still_lamp = Lamp::new(&lighting, &camera, still, look.factor, range);
        Ok(object(&[
            ("eye", bytes(bytemuck::bytes_of(&eye))),
            ("lamp", bytes(bytemuck::bytes_of(&lamp))),
            ("stillLamp", bytes(bytemuck::bytes_of(&still_lamp))),
            ("look", bytes(bytemuck::bytes_of(&self.0.look(&look.palette)))),
        ]))
    }

    /// Begins the complete picture. Throws where there is no such view.
    pub fn carve(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        width: f64,
        height: f64,
    ) -> Result<SpaceCarve, JsValue> {
        let camera = camera_of(view, self.0.unit)?;
        let traversal =
            Traversal::new(&self.0.systems, &camera, side("width", width)?, side("height", height)?);
        Ok(SpaceCarve { traversal, camera, things: self.0.clone() })
    }
}

fn bytes(list: &[u8]) -> JsValue {
    Uint8Array::from(list).into()
}

/// A complete picture in the making.
#[wasm_bindgen]
pub struct SpaceCarve {
    traversal: Traversal,
    camera: Camera,
    things: Things,
}

#[wasm_bindgen]
impl SpaceCarve {
    /// Looks at `budget` pieces at most. Whether it is done.
    pub fn run(&mut self, budget: f64) -> bool {
        self.traversal.run(budget.clamp(1.0, 1e9) as usize)
    }

    /// How far away the nearest piece is, row 0 on top; infinite where there is none.
    pub fn depth(&self) -> Float32Array {
        Float32Array::from(self.traversal.depth_buffer().depth())
    }

    /// Which piece it is, 0 where there is none.
    pub fn codes(&self) -> Uint32Array {
        Uint32Array::from(self.traversal.depth_buffer().codes())
    }

    /// The picture: RGBA, straight alpha, row 0 on top. `look` says what was carved: width x factor across, height x factor down.
    pub fn paint(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] plain: JsValue,
        #[wasm_bindgen(
            unchecked_param_type = "{ width: number; height: number; factor: number; palette: string[]; ground: string }"
        )]
        look: JsValue,
    ) -> Result<Uint8ClampedArray, JsValue> {
        let look = LookOf::read(look)?;
        let size = look.size.map(|side| side * look.factor);
        let buffer = self.traversal.depth_buffer();
        if size != [buffer.width(), buffer.height()] {
            return Err(bad_input("The look", "it is of another size than what was carved"));
        }
        let lighting = self.things.lighting(&read("The light", plain)?, look.ground);
        let lamp = Lamp::new(&lighting, &self.camera, size, look.factor, self.traversal.range());
        Ok(Uint8ClampedArray::from(&light(buffer, &lamp, &self.things.look(&look.palette))[..]))
    }
}
