//! From pictures to outlines.

use frond_fit::{Mask, MaskOptions, Stroke, TraceError, Tracer};
use js_sys::Uint8Array;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::{object, read, write};
use crate::outlines::{flat, warnings};

fn of_trace(error: &TraceError) -> JsValue {
    failure(error.code(), &error.to_string())
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Petiole {
    Keep,
    Remove,
}

#[derive(Deserialize)]
struct PlainStroke {
    /// x0, y0, x1, y1, ..
    points: Vec<f64>,
    radius: f64,
    what: Petiole,
}

#[derive(Deserialize)]
struct PlainOptions {
    threshold: f64,
    petiole: Petiole,
    strokes: Vec<PlainStroke>,
    #[serde(default)]
    hints: Vec<PlainStroke>,
    #[serde(default)]
    invert: bool,
}

impl From<PlainOptions> for MaskOptions {
    fn from(plain: PlainOptions) -> Self {
        let stroke = |stroke: PlainStroke| Stroke {
            points: stroke.points.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect(),
            radius: stroke.radius,
            keep: matches!(stroke.what, Petiole::Keep),
        };
        Self {
            threshold: plain.threshold,
            invert: plain.invert,
            remove_stalks: matches!(plain.petiole, Petiole::Remove),
            hints: plain.hints.into_iter().map(stroke).collect(),
            strokes: plain.strokes.into_iter().map(stroke).collect(),
        }
    }
}

/// A piece of a mask.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PlainComponent {
    area: usize,
    r#box: [usize; 4],
    at: [usize; 2],
    touches_border: bool,
}

/// A picture that is traced: `mask` and then `outline`, as often as wished. Call `free()` when it is no longer needed.
#[wasm_bindgen]
pub struct PictureTracer {
    tracer: Tracer,
    mask: Option<Mask>,
}

#[wasm_bindgen]
impl PictureTracer {
    /// Looks at a picture of at most 4194304 pixels: red, green, blue and alpha of each, row after row from the top.
    #[wasm_bindgen(constructor)]
    pub fn new(width: usize, height: usize, rgba: &[u8]) -> Result<PictureTracer, JsValue> {
        let tracer = Tracer::new(width, height, rgba).map_err(|error| of_trace(&error))?;
        Ok(Self { tracer, mask: None })
    }

    /// Draws the mask for `{ threshold, petiole, strokes, hints?, invert? }`: strokes change what they cover, hints
    /// what looks like it around as well.
    #[wasm_bindgen(unchecked_return_type = "TracedMask")]
    pub fn mask(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "MaskOptions")] options: JsValue,
    ) -> Result<JsValue, JsValue> {
        let options: PlainOptions = read("The options of a mask", options)?;
        // One at a time: they are large.
        self.mask = None;
        let mask = self.tracer.mask(&options.into());
        let component = |part: &frond_fit::Component| PlainComponent {
            area: part.area,
            r#box: part.bounds,
            at: part.at,
            touches_border: part.touches_border,
        };
        let components: Vec<_> = mask.components().iter().map(component).collect();
        let (width, height) = mask.size();
        let channel = self.tracer.channel().map_or("none", |channel| channel.code());
        let result = object(&[
            ("width", (width as f64).into()),
            ("height", (height as f64).into()),
            ("mask", Uint8Array::from(&mask.bytes()[..]).into()),
            ("threshold", mask.level().into()),
            ("channel", channel.into()),
            ("components", write(&components)?),
            ("warnings", warnings(mask.notices())?),
        ]);
        self.mask = Some(mask);
        Ok(result)
    }

    /// The line round a piece of the last mask: `{ points, area, length, warnings }`.
    #[wasm_bindgen(unchecked_return_type = "TracedOutline")]
    pub fn outline(&self, component: usize) -> Result<JsValue, JsValue> {
        let Some(mask) = &self.mask else {
            return Err(failure("no-mask", "There is no mask yet. Ask for one before its outline."));
        };
        let traced = self.tracer.outline(mask, component).map_err(|error| of_trace(&error))?;
        Ok(object(&[
            ("points", flat(&traced.points)),
            ("area", traced.area().into()),
            ("length", traced.length().into()),
            ("warnings", warnings(&traced.notices)?),
        ]))
    }
}
