//! Shuffles and bends as functions.

use frond_deform::{Continuity, MAX_SYMBOLS};
use glam::DVec2;
use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

use crate::boundary::bend::{bend_on, read_bend, with_bend};
use crate::boundary::error::bad_input;
use crate::boundary::value::{object, read, read_ifs};

/// The most points along a side of the display grid.
const MAX_GRID: u32 = 256;
/// The most points and letters that one call takes.
const MAX_POINTS: usize = 1 << 20;

/// `D_e-uni`: reverses the letters kb + 1 to ke of a code over `symbols` symbols, letters from 0 (Fujimoto et al., eq
/// 4).
#[wasm_bindgen]
pub fn shuffle(symbols: f64, kb: f64, ke: f64, code: Vec<f64>) -> Result<Vec<f64>, JsValue> {
    let whole = |x: f64, most: f64| (x.fract() == 0.0 && (0.0..=most).contains(&x)).then_some(x as usize);
    let most = code.len() as f64;
    let wrong = |why: &str| bad_input("The shuffle", why);
    let symbols = whole(symbols, MAX_SYMBOLS as f64)
        .filter(|&count| count > 0)
        .ok_or_else(|| wrong("1 to 256 symbols are needed"))?;
    let ke = whole(ke, most).ok_or_else(|| wrong("ke is a whole number from 0 to the length of the code"))?;
    let kb = whole(kb, ke as f64).ok_or_else(|| wrong("kb is a whole number from 0 to ke"))?;
    let letters: Option<Vec<u8>> =
        code.iter().map(|&x| whole(x, (symbols - 1) as f64).and_then(|x| u8::try_from(x).ok())).collect();
    let mut letters = letters.ok_or_else(|| wrong("letters are whole numbers from 0 to symbols - 1"))?;
    frond_deform::shuffle(&mut letters, kb, ke);
    Ok(letters.into_iter().map(f64::from).collect())
}

/// What comes of a bend on a shape.
#[wasm_bindgen(js_name = bendFacts, unchecked_return_type = "BendFacts")]
pub fn bend_facts(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Bend")] bend: JsValue,
) -> Result<JsValue, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let (_, settings, _) = read_bend(&bend)?;
    with_bend(ifs.maps(), &bend, |bend| {
        let continuity = match bend.continuity() {
            Continuity::Corners => "corners",
            Continuity::Splat => "splat",
            Continuity::Average => "average",
            Continuity::Published => "published",
            Continuity::Raw | Continuity::Auto => "raw",
        };
        Ok(object(&[
            ("continuity", continuity.into()),
            ("kb", settings.kb.min(bend.ke()).into()),
            ("ke", bend.ke().into()),
            ("deepest", (bend.deepest() as f64).into()),
            ("reach", bend.reach().into()),
        ]))
    })
}

/// Where `count` times `count` points of the mesh go, x0, y0, x1, y1, .. row by row from the lower left: the display
/// grid of Fujimoto et al., section 5.3.
#[wasm_bindgen(js_name = meshGrid)]
pub fn mesh_grid(
    #[wasm_bindgen(unchecked_param_type = "Bend")] bend: JsValue,
    count: u32,
) -> Result<Float64Array, JsValue> {
    if !(2..=MAX_GRID).contains(&count) {
        return Err(bad_input("The count", "2 to 256 points a side are needed"));
    }
    let (mesh, ..) = read_bend(&bend)?;
    let numbers: Vec<f64> = mesh.grid(count as usize).into_iter().flat_map(|p| p.to_array()).collect();
    Ok(Float64Array::from(&numbers[..]))
}

/// Where points of a shape go: x0, y0, x1, y1, .. Each point is a code, letters from 0 with the largest piece first,
/// and the point (`tails`) that the maps of its letters take to its place.
#[wasm_bindgen]
pub fn deform(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Bend")] bend: JsValue,
    #[wasm_bindgen(unchecked_param_type = "number[][]")] codes: JsValue,
    #[wasm_bindgen(unchecked_param_type = "[number, number][]")] tails: JsValue,
) -> Result<Float64Array, JsValue> {
    let ifs = read_ifs(&ifs)?;
    let bend = bend_on(ifs.maps(), &bend)?;
    let codes: Vec<Vec<usize>> = read("The codes", codes)?;
    let tails: Vec<[f64; 2]> = read("The tails", tails)?;
    if codes.len() != tails.len() || codes.len() > MAX_POINTS {
        return Err(bad_input("The points", "as many codes as tails are needed, at most 1048576"));
    }
    let mut numbers = Vec::with_capacity(2 * codes.len());
    for (code, &tail) in codes.iter().zip(&tails) {
        if code.iter().any(|&letter| letter >= ifs.len()) {
            return Err(bad_input("The codes", "letters are whole numbers from 0 to the number of maps - 1"));
        }
        let cursor = code.iter().fold(bend.whole(), |cursor, &letter| bend.child(&cursor, letter));
        numbers.extend(bend.point(&cursor, DVec2::from(tail)).to_array());
    }
    Ok(Float64Array::from(&numbers[..]))
}
