//! Bent photographs without a canvas.

use frond_render::{BentSheet, Photo, Sheet as Bare, SheetOptions, View, draw_sheet};
use js_sys::Uint8ClampedArray;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::bend::{PlainBend, bend_on};
use crate::boundary::error::{bad_input, failure};
use crate::boundary::photo::read_photo;
use crate::boundary::picture::PlainView;
use crate::boundary::value::read;

/// A photograph on the rectangle [0, width / height] x [0, 1], which a bend can bend: what `Renderer.setPicture` shows,
/// drawn on the processor.
#[wasm_bindgen]
pub struct Sheet {
    photo: Photo,
    /// The last bend, its parts, and what was made of it.
    last: Option<(PlainBend, usize, usize, BentSheet)>,
}

#[derive(Deserialize)]
struct Plain {
    width: f64,
    height: f64,
    view: Option<PlainView>,
    smooth: Option<bool>,
}

/// The most cells along a side of the sheet of a picture of so many pixels: smaller ones are not seen.
fn cells(width: u32, height: u32) -> usize {
    (width.max(height) as usize).clamp(64, Bare::FINEST)
}

#[wasm_bindgen]
impl Sheet {
    /// RGBA bytes with straight alpha, row 0 on top; at most 4096 pixels either way.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | Uint8ClampedArray")] rgba: &JsValue,
        width: f64,
        height: f64,
    ) -> Result<Sheet, JsValue> {
        Ok(Self { photo: read_photo(rgba, width, height)?, last: None })
    }

    /// Draws it as `bend` bends it, made for `parts` x `parts` maps (2 or 3): RGBA with straight alpha, row 0 on top,
    /// on a transparent background. A bend whose mesh alone has moved since the last call is quick.
    #[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
    pub fn draw(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Bend | null")] bend: JsValue,
        parts: f64,
        #[wasm_bindgen(
            unchecked_param_type = "{ width: number; height: number; view?: { x: number; y: number; scale: number }; smooth?: boolean }"
        )]
        options: JsValue,
    ) -> Result<Uint8ClampedArray, JsValue> {
        let plain: Plain = read("The options", options)?;
        let options = SheetOptions {
            // A cast of NaN or a negative number gives 0: an empty picture.
            width: plain.width as u32,
            height: plain.height as u32,
            view: plain.view.map(View::from),
            smooth: plain.smooth.unwrap_or(true),
        };
        let draw = |sheet: &Bare| {
            let pixels = draw_sheet(&self.photo, sheet, &options)
                .map_err(|error| failure(error.code(), &error.to_string()))?;
            Ok(Uint8ClampedArray::from(&pixels[..]))
        };
        if bend.is_null() || bend.is_undefined() {
            return draw(&Bare::at_rest(self.photo.aspect()));
        }
        let (parts, most) = (read_parts(parts)?, cells(options.width, options.height));
        let plain = PlainBend::read(&bend)?;
        // Refuses moves that are no numbers, or not as many as there should be.
        plain.parts()?;
        let same = |(last, p, m, _): &(PlainBend, usize, usize, BentSheet)| {
            last.same_but_moved(&plain) && (*p, *m) == (parts, most)
        };
        let mut bent = match self.last.take().filter(same) {
            Some((.., bent)) => bent,
            None => {
                let aspect = self.photo.aspect();
                BentSheet::new(&bend_on(&Bare::maps(aspect, parts), &bend)?, aspect, parts, most)
            }
        };
        bent.follow(&plain.displacements());
        let picture = draw(bent.sheet());
        self.last = Some((plain, parts, most, bent));
        picture
    }
}

fn read_parts(parts: f64) -> Result<usize, JsValue> {
    match parts {
        2.0 => Ok(2),
        3.0 => Ok(3),
        _ => Err(bad_input("The number of parts", "2 or 3 are possible")),
    }
}
