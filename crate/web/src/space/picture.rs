//! Pictures of space: what a renderer is given, and complete ones without a graphics card.

use std::ops::Range;

use frond_core::{Affine3, Ifs3, IfsError, MAX_MAPS};
use frond_deform::Bend3;
use frond_render::solid::{
    Bent, Camera, CameraError, Cloud, DepthBuffer, Eye, Lamp, LampView, Lighting, MAX_OBJECTS, Objects,
    Paint, Shadows, Traversal, depths_of_lamp, light_rows, reach_of,
};
use frond_scene::{PaintName, Row3, SpaceBend, SpaceLight, SpaceView};
use glam::DVec3;
use js_sys::{Array, Float32Array, Float64Array, Uint8Array, Uint8ClampedArray, Uint32Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::{bad_input, failure, of_ifs};
use crate::boundary::palette::read_palette;
use crate::boundary::value::{object, read};

#[derive(Deserialize)]
struct PlainObject {
    maps: Vec<Row3>,
    #[serde(default)]
    tint: Option<String>,
    #[serde(default)]
    bent: Option<PlainBent>,
}

/// The maps of an object as it was made, what was done to it then, and the bend between the two.
#[derive(Deserialize)]
struct PlainBent {
    maps: Vec<Row3>,
    moved: Row3,
    bend: SpaceBend,
}

impl PlainBent {
    /// Made ready; `before` is what was shown in its place.
    fn read(self, before: Option<&Bend3>) -> Result<Bent, JsValue> {
        let Self { maps, moved, bend } = self;
        if let Some(range) = bend.problem() {
            return Err(bad_input("The bend", range));
        }
        let ifs = system(maps)?;
        let bend = bend.bend(&ifs, before).map_err(|error| failure(error.code(), &error.to_string()))?;
        Ok(Bent::new(ifs, bend, Affine3::from_row(moved)))
    }
}

fn system(maps: Vec<Row3>) -> Result<Ifs3, JsValue> {
    if maps.len() > MAX_MAPS {
        return Err(of_ifs(&IfsError::TooManyMaps { count: maps.len() }));
    }
    Ifs3::new(maps.into_iter().map(Affine3::from_row).collect()).map_err(|error| of_ifs(&error))
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

fn lighting_of(plain: &SpaceLight, ground: [f32; 3]) -> Lighting {
    Lighting {
        towards: Lighting::direction(plain.side, plain.front),
        ambient: plain.ambient,
        hollows: plain.hollows,
        shadows: plain.shadows,
        softness: plain.softness,
        occlusion: plain.occlusion,
        sky: plain.sky,
        gloss: plain.gloss,
        filmic: plain.filmic,
        fog: plain.fog,
        ground,
        paint: if plain.paint == PaintName::Height { Paint::Height } else { Paint::Map },
        ..Lighting::default()
    }
}

/// Systems, the colours of those that have one for all of it, and the bends of those that have one.
type Systems = (Vec<Ifs3>, Vec<Option<[u8; 3]>>, Vec<Option<Bent>>);

/// The objects of one moment; `before` are the bends of another.
pub(super) fn read_objects(objects: &Array, before: &[Option<Bent>]) -> Result<Systems, JsValue> {
    let count = objects.length() as usize;
    if count == 0 || count > MAX_OBJECTS {
        return Err(bad_input("The objects", "1 to 60 are allowed"));
    }
    let (mut systems, mut tints, mut bends) = (Vec::with_capacity(count), Vec::new(), Vec::new());
    for (number, value) in objects.iter().enumerate() {
        let plain: PlainObject = read("An object", value)?;
        systems.push(system(plain.maps)?);
        let before = before.get(number).and_then(Option::as_ref).map(Bent::bend);
        bends.push(plain.bent.map(|bent| bent.read(before)).transpose()?);
        let tint = plain.tint.map(|tint| read_palette(&[tint])).transpose()?;
        tints.push(tint.map(|tint| tint[0]));
    }
    Ok((systems, tints, bends))
}

/// The objects of one moment, ready to be drawn.
#[wasm_bindgen]
pub struct SpacePicture(Objects);

#[wasm_bindgen]
impl SpacePicture {
    /// Throws where one has no attractor, or a bend that is none; those that are too many are refused.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "SpaceShown[]")] objects: Array,
    ) -> Result<Self, JsValue> {
        Self::after(&objects, &[])
    }

    /// Others in their place. Of their bends, all is kept that hangs on shape and detail alone.
    pub fn next(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceShown[]")] objects: Array,
    ) -> Result<Self, JsValue> {
        Self::after(&objects, self.0.bends())
    }

    fn after(objects: &Array, before: &[Option<Bent>]) -> Result<Self, JsValue> {
        let (systems, tints, bends) = read_objects(objects, before)?;
        let tints =
            tints.into_iter().map(|tint| tint.map(|tint| tint.map(|c| f32::from(c) / 255.0))).collect();
        Ok(Self(Objects::new(systems, tints, bends)))
    }

    /// The middle of a ball around everything.
    #[wasm_bindgen(getter)]
    pub fn centre(&self) -> Float64Array {
        Float64Array::from(&self.0.centre().to_array()[..])
    }

    /// Its radius.
    #[wasm_bindgen(getter)]
    pub fn radius(&self) -> f64 {
        self.0.radius()
    }

    /// About so many points in all, shared by the objects: bytes for `SpaceRenderer.setClouds`.
    #[wasm_bindgen(unchecked_return_type = "{ vertices: Uint8Array; instances: Uint8Array; gap: number }[]")]
    pub fn clouds(&self, points: f64) -> Array {
        let cloud = |cloud: Cloud| {
            object(&[
                ("vertices", bytes(bytemuck::cast_slice(&cloud.vertices))),
                ("instances", bytes(bytemuck::cast_slice(&cloud.instances))),
                ("gap", cloud.gap.into()),
            ])
        };
        self.0.clouds(points).into_iter().map(cloud).collect()
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
        let (camera, look) = (camera_of(view, self.0.unit())?, LookOf::read(look)?);
        let lighting = self.0.lit(lighting_of(&read("The light", light)?, look.ground));
        let [width, height] = look.size;
        let range = self.0.depths(&camera);
        let eye = Eye::new(&camera, width, height, range);
        let lamp = Lamp::new(&lighting, &camera, look.size, 1, range);
        let still = look.size.map(|side| side * look.factor);
        let still_lamp = Lamp::new(&lighting, &camera, still, look.factor, range);
        Ok(object(&[
            ("eye", bytes(bytemuck::bytes_of(&eye))),
            ("lamp", bytes(bytemuck::bytes_of(&lamp))),
            ("stillLamp", bytes(bytemuck::bytes_of(&still_lamp))),
            ("look", bytes(bytemuck::bytes_of(&self.0.colours(&look.palette)))),
        ]))
    }

    /// Begins the complete picture. Throws where there is no such view.
    pub fn carve(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        width: f64,
        height: f64,
    ) -> Result<SpaceCarve, JsValue> {
        self.band(view, width, height, 0.0, height, 0.0)
    }

    /// The same of the rows from `from` on, before `to`, and of so many more above and below as their light hangs on if
    /// its hollows have this `reach`: 1 is the usual one, 0 is none.
    #[wasm_bindgen(js_name = carveRows)]
    pub fn band(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        width: f64,
        height: f64,
        from: f64,
        to: f64,
        reach: f64,
    ) -> Result<SpaceCarve, JsValue> {
        let camera = camera_of(view, self.0.unit())?;
        let size = [side("width", width)?, side("height", height)?];
        if !(0.0 <= from && from < to && to <= f64::from(size[1])) {
            return Err(bad_input("The rows", "they are some of the picture's"));
        }
        let rows = from as u32..to as u32;
        let wide = Lighting { occlusion: 1.0, ..Lighting::default() };
        let lamp = Lamp { reach: reach as f32, ..Lamp::new(&wide, &camera, size, 1, [1.0; 2]) };
        let margin = if reach > 0.0 { reach_of(&lamp) } else { 0 };
        let top = rows.start.saturating_sub(margin);
        let traversal = self.0.band(&camera, size, top..rows.end.saturating_add(margin).min(size[1]));
        Ok(SpaceCarve { traversal, camera, objects: self.0.clone(), size, top, rows, reach: reach as f32 })
    }
}

/// Pixels that were carved before, with as many rows above and below those that are to be lit as the light hangs on.
#[derive(Deserialize)]
struct PlainRelief {
    /// The first row that there is, of the source.
    top: f64,
    /// Those to be lit, of the source: from this on, before that.
    rows: [f64; 2],
}

#[wasm_bindgen]
impl SpacePicture {
    /// Rows of the source that the light of a pixel hangs on, above and below it.
    #[wasm_bindgen(js_name = lightReach)]
    pub fn light_reach(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] light: JsValue,
        reach: f64,
    ) -> Result<u32, JsValue> {
        let camera = camera_of(view, self.0.unit())?;
        let lighting = lighting_of(&read("The light", light)?, [0.0; 3]);
        let lamp = Lamp::new(&lighting, &camera, [1; 2], 1, [1.0; 2]);
        Ok(reach_of(&Lamp { reach: reach as f32, ..lamp }))
    }

    /// The side of the picture that the lamp takes for cast shadows, in pixels: 0 where none are cast. `width` and
    /// `height` are those of the picture that is shown.
    #[wasm_bindgen(js_name = lampSide)]
    pub fn lamp_side(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] light: JsValue,
        width: f64,
        height: f64,
    ) -> Result<u32, JsValue> {
        Ok(self.lamp_view(view, light, width, height)?.map_or(0, |view| view.side))
    }

    /// Begins some rows of what the lamp sees. Throws where it sees nothing.
    #[wasm_bindgen(js_name = carveLamp)]
    pub fn carve_lamp(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] light: JsValue,
        width: f64,
        height: f64,
        from: f64,
        to: f64,
    ) -> Result<SpaceCarve, JsValue> {
        let view = self.lamp_view(view, light, width, height)?;
        let LampView { camera, side } = view.ok_or_else(|| bad_input("The light", "it casts no shadows"))?;
        if !(0.0 <= from && from < to && to <= f64::from(side)) {
            return Err(bad_input("The rows", "they are some of the picture's"));
        }
        let (size, rows) = ([side; 2], from as u32..to as u32);
        let traversal = self.0.band(&camera, size, rows.clone());
        Ok(SpaceCarve { traversal, camera, objects: self.0.clone(), size, top: rows.start, rows, reach: 0.0 })
    }

    /// Lights rows of a picture that was carved before: RGBA, straight alpha. `lamp` is all that the lamp sees, or
    /// nothing where no shadows are cast.
    #[allow(clippy::too_many_arguments, reason = "lists of numbers cross the boundary by themselves")]
    #[wasm_bindgen(js_name = lightRows, unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
    pub fn light(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceView")] view: JsValue,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] light: JsValue,
        #[wasm_bindgen(
            unchecked_param_type = "{ width: number; height: number; factor: number; palette: string[]; ground: string }"
        )]
        look: JsValue,
        #[wasm_bindgen(unchecked_param_type = "{ top: number; rows: readonly [number, number] }")]
        relief: JsValue,
        depth: Vec<f32>,
        codes: Vec<u32>,
        lamp: &[f32],
        reach: f64,
    ) -> Result<Uint8ClampedArray, JsValue> {
        let (camera, look) = (camera_of(view.clone(), self.0.unit())?, LookOf::read(look)?);
        let plain: SpaceLight = read("The light", light)?;
        let PlainRelief { top, rows } = read("The relief", relief)?;
        let size = look.size.map(|side| side * look.factor);
        let buffer =
            DepthBuffer::of(size[0], depth, codes).ok_or_else(|| bad_input("The relief", OTHER_SIZE))?;
        let held = 0.0 <= top
            && top <= rows[0]
            && rows[0] <= rows[1]
            && rows[1] <= f64::from(size[1])
            && rows[1] - top <= f64::from(buffer.height());
        let whole = rows.iter().all(|row| (*row as u32).is_multiple_of(look.factor));
        if !(held && whole) {
            return Err(bad_input("The relief", OTHER_SIZE));
        }
        let lighting = self.0.lit(lighting_of(&plain, look.ground));
        // As `paint` has it, whose bounds are closer than those that the card is told.
        let range = self.0.traversal(&camera, 1, 1).range();
        let view = LampView::new(&self.0, &lighting, &camera, look.size).filter(|_| plain.shadows > 0.0);
        let shadows = view.map(|view| {
            let shadows = Shadows::new(&view, lamp, &lighting, &camera, size[1]);
            shadows.ok_or_else(|| bad_input("The lamp", "it is of another size than what the lamp sees"))
        });
        let shadows = shadows.transpose()?;
        let made = Lamp::new(&lighting, &camera, size, look.factor, range);
        let made = Lamp { reach: if reach > 0.0 { reach as f32 } else { made.reach }, ..made };
        let colours = self.0.colours(&look.palette);
        let rows = rows[0] as u32 / look.factor..rows[1] as u32 / look.factor;
        let lit = light_rows(&buffer, top as u32, &made, &colours, shadows.as_ref(), rows);
        Ok(Uint8ClampedArray::from(&lit[..]))
    }
}

const OTHER_SIZE: &str = "it is of another size than what is to be lit";

impl SpacePicture {
    fn lamp_view(
        &self,
        view: JsValue,
        light: JsValue,
        width: f64,
        height: f64,
    ) -> Result<Option<LampView>, JsValue> {
        let camera = camera_of(view, self.0.unit())?;
        let plain: SpaceLight = read("The light", light)?;
        let size = [side("width", width)?, side("height", height)?];
        let lighting = lighting_of(&plain, [0.0; 3]);
        Ok(LampView::new(&self.0, &lighting, &camera, size).filter(|_| plain.shadows > 0.0))
    }
}

fn bytes(list: &[u8]) -> JsValue {
    Uint8Array::from(list).into()
}

/// A complete picture, or some rows of it, in the making.
#[wasm_bindgen]
pub struct SpaceCarve {
    traversal: Traversal,
    camera: Camera,
    objects: Objects,
    /// Of the whole picture.
    size: [u32; 2],
    /// The first row that is carved.
    top: u32,
    /// Those that are wanted.
    rows: Range<u32>,
    reach: f32,
}

#[wasm_bindgen]
impl SpaceCarve {
    /// Looks at `budget` pieces, or a few more. Whether it is done.
    pub fn run(&mut self, budget: f64) -> bool {
        self.traversal.run(budget.clamp(1.0, 1e9) as usize)
    }

    /// How far away the nearest piece is, row 0 on top; infinite where there is none.
    pub fn depth(&self) -> Float32Array {
        Float32Array::from(&self.traversal.depth_buffer().depth()[self.wanted()])
    }

    /// Which piece it is, 0 where there is none.
    pub fn codes(&self) -> Uint32Array {
        Uint32Array::from(&self.traversal.depth_buffer().codes()[self.wanted()])
    }

    /// Where the rows that are wanted lie among those that are carved.
    fn wanted(&self) -> Range<usize> {
        let at = |row: u32| (row - self.top) as usize * self.size[0] as usize;
        at(self.rows.start)..at(self.rows.end)
    }

    /// The picture: RGBA, straight alpha, row 0 on top. `look` says what was carved: width x factor across, height x
    /// factor down.
    #[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
    pub fn paint(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SpaceLight")] plain: JsValue,
        #[wasm_bindgen(
            unchecked_param_type = "{ width: number; height: number; factor: number; palette: string[]; ground: string }"
        )]
        look: JsValue,
    ) -> Result<Uint8ClampedArray, JsValue> {
        let look = LookOf::read(look)?;
        let whole = |row: &u32| row.is_multiple_of(look.factor);
        let fits = look.size.map(|side| side * look.factor) == self.size;
        if !(fits && [self.rows.start, self.rows.end].iter().all(whole)) {
            return Err(bad_input("The look", "it is of another size than what was carved"));
        }
        let plain: SpaceLight = read("The light", plain)?;
        let lighting = self.objects.lit(lighting_of(&plain, look.ground));
        let view =
            LampView::new(&self.objects, &lighting, &self.camera, look.size).filter(|_| plain.shadows > 0.0);
        let seen = view.map(|view| (view, depths_of_lamp(&self.objects, &view)));
        let shadows = seen
            .as_ref()
            .and_then(|(view, seen)| Shadows::new(view, seen.depth(), &lighting, &self.camera, self.size[1]));
        let lamp = Lamp::new(&lighting, &self.camera, self.size, look.factor, self.traversal.range());
        let lamp = Lamp { reach: if self.reach > 0.0 { self.reach } else { lamp.reach }, ..lamp };
        let (buffer, colours) = (self.traversal.depth_buffer(), self.objects.colours(&look.palette));
        let rows = self.rows.start / look.factor..self.rows.end / look.factor;
        Ok(Uint8ClampedArray::from(
            &light_rows(buffer, self.top, &lamp, &colours, shadows.as_ref(), rows)[..],
        ))
    }
}
