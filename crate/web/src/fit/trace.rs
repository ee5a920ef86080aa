//! From files to outlines: pictures are traced, texts are read.

use frond_fit::{
    FileContent, Mask, MaskOptions, Notice, ReadAs, ReadError, Remark, Stroke, TraceError, Tracer, read_file,
};
use glam::DVec2;
use js_sys::{Array, Float64Array, Uint8Array};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::{object, read, write};

#[derive(Serialize)]
struct Warning {
    code: &'static str,
    message: String,
}

impl From<&Notice> for Warning {
    fn from(notice: &Notice) -> Self {
        Self { code: notice.code(), message: notice.message() }
    }
}

impl From<&Remark> for Warning {
    fn from(remark: &Remark) -> Self {
        Self { code: remark.code, message: remark.message.clone() }
    }
}

fn warnings<'a, T: 'a>(all: &'a [T]) -> Result<JsValue, JsValue>
where
    Warning: From<&'a T>,
{
    write(&all.iter().map(Warning::from).collect::<Vec<_>>())
}

fn flat(points: &[DVec2]) -> JsValue {
    let numbers: Vec<f64> = points.iter().flat_map(|p| p.to_array()).collect();
    Float64Array::from(&numbers[..]).into()
}

fn of_trace(error: &TraceError) -> JsValue {
    failure(error.code(), &error.to_string())
}

fn of_read(error: &ReadError) -> JsValue {
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
    pub fn mask(&mut self, options: JsValue) -> Result<JsValue, JsValue> {
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

/// Reads a text file: SVG, a table of numbers, or GeoJSON. `take` is `"outlines"`, `"series"` or undefined, and counts
/// for tables.
#[wasm_bindgen(js_name = readTextFile)]
pub fn read_text_file(bytes: &[u8], take: Option<String>) -> Result<JsValue, JsValue> {
    let read_as = match take.as_deref() {
        Some("outlines") => ReadAs::Outlines,
        Some("series") => ReadAs::Series,
        _ => ReadAs::Guess,
    };
    match read_file(bytes, read_as).map_err(|error| of_read(&error))? {
        FileContent::Series { points, remarks, or_outline } => Ok(object(&[
            ("kind", "series".into()),
            ("format", "csv".into()),
            ("points", flat(&points)),
            ("orOutline", or_outline.into()),
            ("warnings", warnings(&remarks)?),
        ])),
        FileContent::Outlines { format, outlines, remarks } => {
            let list: Array = outlines
                .iter()
                .map(|one| {
                    object(&[
                        ("name", (&one.name).into()),
                        ("points", flat(one.outline.points())),
                        ("area", one.outline.area().into()),
                        ("crossings", one.crossings.map_or(JsValue::NULL, |count| (count as f64).into())),
                    ])
                })
                .collect();
            Ok(object(&[
                ("kind", "outlines".into()),
                ("format", format.into()),
                ("outlines", list.into()),
                ("warnings", warnings(&remarks)?),
            ]))
        }
    }
}
