//! The stage's picture: an attractor on a canvas, by the graphics card.

use frond_core::{Affine2, Colouring, Ifs};
use frond_deform::{Bend, Continuity, Settings};
use frond_render::View;
use frond_render::gpu::{Drawn, Make, Stage, Style};
use js_sys::{Promise, Reflect, global};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::bend::{PlainBend, of_bend};
use crate::boundary::error::{bad_input, of_ifs};
use crate::boundary::palette::read_palette;
use crate::boundary::photo::read_photo;
use crate::boundary::value::{object, read};
use crate::renderers::canvas::{Held, canvas_methods, open, pixels_of};

/// Draws one attractor on one canvas, on WebGPU or WebGL2. Lengths are device pixels.
///
/// Call `draw` once a frame until it says `settled`; then nothing changes until something is set.
#[wasm_bindgen]
pub struct Renderer {
    stage: Stage,
    held: Held,
    maps: Vec<Affine2>,
    /// What bends them.
    bend: Option<PlainBend>,
}

#[derive(Deserialize)]
struct PlainStyle {
    #[serde(default)]
    colouring: Colouring,
    #[serde(default)]
    palette: Vec<String>,
    exposure: Option<f32>,
    #[serde(rename = "lightGround")]
    light_ground: Option<bool>,
}

#[wasm_bindgen]
impl Renderer {
    /// Opens the graphics card for a canvas that has had no context yet. `onLost` is called once if the
    /// device or the context is lost: the canvas is of no use any more then, and every call does nothing.
    pub async fn create(
        #[wasm_bindgen(unchecked_param_type = "HTMLCanvasElement | OffscreenCanvas")] canvas: JsValue,
        #[wasm_bindgen(
            unchecked_optional_param_type = "{ backend?: \"auto\" | \"webgpu\" | \"webgl2\"; onLost?: (reason: string) => void }"
        )]
        options: JsValue,
    ) -> Result<Renderer, JsValue> {
        let (gpu, held) = open(canvas, options).await?;
        Ok(Self { stage: Stage::new(gpu), held, maps: Vec::new(), bend: None })
    }

    /// Sets the size of the canvas. Edges are smoothed where `pixelRatio` (device pixels for each CSS pixel;
    /// by default the window's) is below 2.
    pub fn resize(
        &mut self,
        width: u32,
        height: u32,
        #[wasm_bindgen(js_name = pixelRatio)] pixel_ratio: Option<f64>,
    ) {
        let own = || Reflect::get(&global(), &"devicePixelRatio".into()).ok()?.as_f64();
        self.stage.resize(width, height, pixel_ratio.or_else(own).unwrap_or(1.0));
    }

    /// Sets what is drawn: six numbers a map. What bends the shape bends the new one. Throws when the maps have no
    /// attractor; the picture stays then.
    #[wasm_bindgen(js_name = setIfs)]
    pub fn set_ifs(&mut self, maps: &[f64], probabilities: Option<Vec<f64>>) -> Result<(), JsValue> {
        let (rows, rest) = maps.as_chunks::<6>();
        if !rest.is_empty() {
            return Err(bad_input("The list of maps", "six numbers a map are needed"));
        }
        let maps: Vec<Affine2> = rows.iter().map(|row| Affine2::from_row(*row)).collect();
        let mut ifs = Ifs::new(maps.clone()).map_err(|error| of_ifs(&error))?;
        if let Some(list) = probabilities {
            ifs = ifs.with_probabilities(&list).map_err(|error| of_ifs(&error))?;
        }
        let other = maps != self.maps;
        let bend = self.bend.as_ref().filter(|_| other).map(|plain| made(&maps, plain)).transpose()?;
        self.stage.set_ifs(&ifs);
        self.maps = maps;
        if let Some(bend) = bend {
            self.put(bend);
        }
        Ok(())
    }

    /// Bends what is drawn, or no longer. Where nothing but the moves of its mesh is new this is cheap. Throws when
    /// there is no such bend; the picture stays then.
    #[wasm_bindgen(js_name = setBend)]
    pub fn set_bend(
        &mut self,
        #[wasm_bindgen(unchecked_optional_param_type = "Bend | null")] bend: JsValue,
    ) -> Result<(), JsValue> {
        if bend.is_undefined() || bend.is_null() {
            self.bend = None;
            self.stage.set_bend(None);
            return Ok(());
        }
        let plain = PlainBend::read(&bend)?;
        let moved = self.bend.as_ref().is_some_and(|last| last.same_but_moved(&plain));
        if !moved || !self.stage.move_mesh(&plain.displacements()) {
            // Without maps it waits for them.
            let ready = !self.maps.is_empty();
            match ready.then(|| made(&self.maps, &plain)).transpose()? {
                Some(bend) => self.put(bend),
                None => self.stage.set_bend(None),
            }
        }
        self.bend = Some(plain);
        Ok(())
    }

    /// Draws a picture in place of the attractor: RGBA with straight alpha, row 0 on top, at most 4096 pixels either
    /// way, on the rectangle [0, width / height] x [0, 1]; `null` goes back. For a bend to fit it, the maps must be the
    /// 4 or 9 parts of that rectangle, x first, from the lower left. Throws when it is no picture; the last one stays
    /// then.
    #[wasm_bindgen(js_name = setPicture)]
    pub fn set_picture(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | Uint8ClampedArray | null")] rgba: &JsValue,
        width: f64,
        height: f64,
    ) -> Result<(), JsValue> {
        let none = rgba.is_null() || rgba.is_undefined();
        let photo = if none { None } else { Some(read_photo(rgba, width, height)?) };
        self.stage.set_photo(photo);
        Ok(())
    }

    /// Sets the world point in the middle and how many pixels a unit takes.
    #[wasm_bindgen(js_name = setView)]
    pub fn set_view(&mut self, x: f64, y: f64, scale: f64) -> Result<(), JsValue> {
        if self.stage.set_view(View { x, y, scale }) {
            Ok(())
        } else {
            Err(bad_input("The view", "finite numbers and a scale above 0 are needed"))
        }
    }

    /// Sets how it looks.
    #[wasm_bindgen(js_name = setStyle)]
    pub fn set_style(
        &mut self,
        #[wasm_bindgen(
            unchecked_param_type = "{ colouring?: Colouring; palette?: string[]; exposure?: number; lightGround?: boolean }"
        )]
        style: JsValue,
    ) -> Result<(), JsValue> {
        let plain: PlainStyle = read("The style", style)?;
        self.stage.set_style(Style {
            colouring: plain.colouring,
            palette: read_palette(&plain.palette)?,
            exposure: plain.exposure.unwrap_or(1.0),
            light_ground: plain.light_ground,
        });
        Ok(())
    }

    /// Draws what is new, about `budget` points: first a whole picture, of fewer pixels if the budget is
    /// small; in the calls after that the complete one. `complete` says that the picture shown is complete,
    /// `settled` that further calls would change nothing, `points` how many points the picture has.
    #[wasm_bindgen(unchecked_return_type = "{ complete: boolean; settled: boolean; points: number }")]
    pub fn draw(&mut self, budget: f64) -> JsValue {
        let Drawn { complete, settled, points } = self.stage.draw(budget as u64);
        object(&[
            ("complete", complete.into()),
            ("settled", settled.into()),
            ("points", (points as f64).into()),
        ])
    }
}

canvas_methods!(Renderer);

impl Renderer {
    fn put(&mut self, (bend, make): Bends) {
        self.stage.set_bend(Some(bend));
        if let Some(make) = make {
            self.stage.set_bend_at_rest(make);
        }
    }
}

/// A bend to be drawn while things change, and what makes that for when they rest, if it is another one.
type Bends = (Bend, Option<Make>);

/// The most pieces of the deepest level of a bend that is made within a frame.
const AT_ONCE: f64 = 20_000.0;

fn made(maps: &[Affine2], plain: &PlainBend) -> Result<Bends, JsValue> {
    let (mesh, settings, tint) = plain.parts()?;
    let new =
        |settings| Bend::new(maps, mesh.clone(), settings, tint.clone()).map_err(|error| of_bend(&error));
    let deepest = AT_ONCE.log(maps.len().max(2) as f64).floor();
    if settings.ke <= deepest || settings.kb > settings.ke {
        return Ok((new(settings)?, None));
    }
    let quick = new(Settings { ke: deepest, kb: settings.kb.min(deepest), ..settings })?;
    // Where no corner of a piece is known beforehand, all depths are made alike.
    if quick.continuity() == Continuity::Raw {
        return Ok((new(settings)?, None));
    }
    let maps = maps.to_vec();
    let fine = Box::new(move || Bend::new(&maps, mesh, settings, tint).ok());
    Ok((quick, Some(fine)))
}
