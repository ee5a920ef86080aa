//! Proofs that can be handed on: why a shape is in one piece, and certificates that it is not.

use frond_check::Pair;
use frond_core::Ifs;
use frond_locus::{Link, Reason};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::boundary::error::of_ifs;
use crate::boundary::resolution::read_options;
use crate::boundary::value::{Row, object, point, read_maps, write};

/// A certificate that the attractor is in several pieces, or `null` where that is not proved.
#[wasm_bindgen(unchecked_return_type = "Certificate | null")]
pub fn certificate(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ epsilon?: number; budget?: number } | undefined")]
    options: JsValue,
) -> Result<JsValue, JsValue> {
    let options = read_options(options)?;
    let ifs = Ifs::new(read_maps(&ifs)?).map_err(|error| of_ifs(&error))?;
    let Some(found) = frond_locus::certificate(&ifs, &options) else { return Ok(JsValue::NULL) };
    let polygon: Vec<[f64; 2]> = found.polygon.iter().copied().map(point).collect();
    let pairs = js_sys::Array::new();
    for pair in &found.pairs {
        pairs.push(&object(&[
            ("u", write(&pair.u)?),
            ("v", write(&pair.v)?),
            ("normal", write(&point(pair.normal))?),
        ]));
    }
    Ok(object(&[
        ("maps", write(&found.maps)?),
        ("polygon", write(&polygon)?),
        ("letters", (found.letters as f64).into()),
        ("side", write(&found.side)?),
        ("pairs", pairs.into()),
    ]))
}

#[derive(Deserialize)]
struct PlainCertificate {
    maps: Vec<Row>,
    polygon: Vec<[f64; 2]>,
    letters: u32,
    side: Vec<u8>,
    pairs: Vec<PlainPair>,
}

#[derive(Deserialize)]
struct PlainPair {
    u: Vec<u8>,
    v: Vec<u8>,
    normal: [f64; 2],
}

/// Replays a certificate in exact arithmetic, with none of the code that finds them. What is no certificate at all is
/// refused like one that proves nothing.
#[wasm_bindgen(js_name = checkCertificate, unchecked_return_type = "CertificateCheck")]
pub fn check_certificate(
    #[wasm_bindgen(unchecked_param_type = "Certificate")] certificate: JsValue,
) -> Result<JsValue, JsValue> {
    let checked = match serde_wasm_bindgen::from_value::<PlainCertificate>(certificate) {
        Err(error) => Err(format!("The certificate is not of the right form: {error}.")),
        Ok(plain) => frond_check::check(&frond_check::Certificate {
            maps: plain.maps,
            polygon: plain.polygon,
            letters: plain.letters as usize,
            side: plain.side,
            pairs: plain
                .pairs
                .into_iter()
                .map(|pair| Pair { u: pair.u, v: pair.v, normal: pair.normal })
                .collect(),
        })
        .map_err(|refused| refused.to_string()),
    };
    let (text, pairs, longest) = match &checked {
        Ok(found) => (found.to_string(), found.pairs, found.longest),
        Err(why) => (why.clone(), 0, 0),
    };
    Ok(object(&[
        ("valid", checked.is_ok().into()),
        ("text", text.into()),
        ("pairs", (pairs as f64).into()),
        ("longest", (longest as f64).into()),
    ]))
}

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
