//! From text files to outlines and series, in modules that are fetched when somebody opens one: `text` reads tables and
//! JSON, `svg` drawings, for which it is as large as all the rest of the fit.

#[cfg(feature = "svg")]
use frond_fit::read_drawing;
use frond_fit::{FileContent, ReadError};
#[cfg(feature = "text")]
use frond_fit::{ReadAs, read_file};
use js_sys::Array;
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::object;
use crate::outlines::{flat, warnings};

fn of_read(error: &ReadError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// Reads a text file: a table of numbers or GeoJSON. `take` is `"outlines"`, `"series"` or undefined, and counts for
/// tables. A drawing is thrown back with the code `drawing`.
#[cfg(feature = "text")]
#[wasm_bindgen(js_name = readTextFile)]
pub fn read_text_file(bytes: &[u8], take: Option<String>) -> Result<JsValue, JsValue> {
    let read_as = match take.as_deref() {
        Some("outlines") => ReadAs::Outlines,
        Some("series") => ReadAs::Series,
        _ => ReadAs::Guess,
    };
    written(read_file(bytes, read_as))
}

/// Reads a drawing (SVG), in the same shape.
#[cfg(feature = "svg")]
#[wasm_bindgen(js_name = readDrawing)]
pub fn drawing(bytes: &[u8]) -> Result<JsValue, JsValue> {
    written(read_drawing(bytes))
}

fn written(content: Result<FileContent, ReadError>) -> Result<JsValue, JsValue> {
    match content.map_err(|error| of_read(&error))? {
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
