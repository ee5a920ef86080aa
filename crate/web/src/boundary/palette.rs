//! Palettes.

use wasm_bindgen::JsValue;

use crate::boundary::error::bad_input;

/// Colours "#rrggbb".
pub(crate) fn read_palette(colours: &[String]) -> Result<Vec<[u8; 3]>, JsValue> {
    let colour = |text: &String| {
        let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6);
        let number = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        number.map(|n| [(n >> 16) as u8, (n >> 8) as u8, n as u8])
    };
    let all: Option<Vec<_>> = colours.iter().map(colour).collect();
    all.ok_or_else(|| bad_input("The palette", "colours are written #rrggbb"))
}
