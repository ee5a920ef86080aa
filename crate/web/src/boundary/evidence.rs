//! What holds a shape together.

use frond_locus::{Link, Reason};
use wasm_bindgen::prelude::*;

use crate::boundary::value::{object, point, write};

pub(crate) fn write_reason(reason: &Reason) -> Result<JsValue, JsValue> {
    let links = js_sys::Array::new();
    for link in &reason.links {
        links.push(&write_link(link)?);
    }
    let mut fields = vec![
        ("kind", reason.kind.name().into()),
        ("text", reason.text().into()),
        ("links", links.into()),
        ("assuming", write(&reason.assuming)?),
    ];
    if let Some(count) = reason.neighbours {
        fields.push(("neighbours", (count as f64).into()));
    }
    Ok(object(&fields))
}

fn write_link(link: &Link) -> Result<JsValue, JsValue> {
    let mut fields = vec![
        ("kind", link.kind.name().into()),
        ("pair", write(&link.pair)?),
        ("words", write(&link.words)?),
        ("at", write(&point(link.at))?),
    ];
    if !link.corners.is_empty() {
        let corners: Vec<[f64; 2]> = link.corners.iter().copied().map(point).collect();
        fields.push(("corners", write(&corners)?));
    }
    Ok(object(&fields))
}
