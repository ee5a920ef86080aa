//! Proofs that can be handed on: certificates that a shape is in one piece, or in several.

use frond_check::{Certificate, ConnectedCertificate, Proof};
use frond_core::Ifs;
use frond_locus::Options;
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

use crate::boundary::error::of_ifs;
use crate::boundary::resolution::read_options;
use crate::boundary::value::{object, read_maps, write};

fn read_asked(ifs: &JsValue, options: JsValue) -> Result<(Ifs, Options), JsValue> {
    let options = read_options(options)?;
    Ok((Ifs::new(read_maps(ifs)?).map_err(|error| of_ifs(&error))?, options))
}

/// A certificate that the attractor is in several pieces, or `null` where that is not proved.
#[wasm_bindgen(unchecked_return_type = "Certificate | null")]
pub fn certificate(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ epsilon?: number; budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let (ifs, options) = read_asked(&ifs, options)?;
    let Some(found) = frond_locus::certificate(&ifs, &options) else { return Ok(JsValue::NULL) };
    write(&Certificate::from(found))
}

/// A certificate that the attractor is in one piece, or `null` where none was found: proofs about what numbers are
/// meant to be are not written down.
#[wasm_bindgen(js_name = connectedCertificate, unchecked_return_type = "ConnectedCertificate | null")]
pub fn connected_certificate(
    #[wasm_bindgen(unchecked_param_type = "Ifs")] ifs: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ epsilon?: number; budget?: number }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let (ifs, options) = read_asked(&ifs, options)?;
    let Some(found) = frond_locus::connected_certificate(&ifs, &options) else { return Ok(JsValue::NULL) };
    write(&ConnectedCertificate::from(found))
}

/// Replays a certificate of either kind in exact arithmetic, with none of the code that finds them. What is no
/// certificate at all is refused like one that proves nothing.
#[wasm_bindgen(js_name = checkCertificate, unchecked_return_type = "CertificateCheck")]
pub fn check_certificate(
    #[wasm_bindgen(unchecked_param_type = "Certificate | ConnectedCertificate")] certificate: JsValue,
) -> Result<JsValue, JsValue> {
    let links = Reflect::get(&certificate, &"links".into()).unwrap_or_default();
    let proof = if links.is_undefined() {
        serde_wasm_bindgen::from_value(certificate).map(Proof::Disconnected)
    } else {
        serde_wasm_bindgen::from_value(certificate).map(Proof::Connected)
    };
    let checked = match proof {
        Err(error) => Err(format!("The certificate is not of the right form: {error}.")),
        Ok(proof) => proof.check().map_err(|refused| refused.to_string()),
    };
    let text = checked.as_ref().map_or_else(Clone::clone, ToString::to_string);
    let (kind, count, longest) = match checked {
        Ok(frond_check::CheckedProof::Disconnected(found)) => ("pairs", found.pairs, found.longest),
        Ok(frond_check::CheckedProof::Connected(found)) => ("links", found.links, found.longest),
        Err(_) => ("pairs", 0, 0),
    };
    let of_kind = |wanted: &str| if wanted == kind { (count as f64).into() } else { 0.into() };
    Ok(object(&[
        ("valid", checked.is_ok().into()),
        ("text", text.into()),
        ("pairs", of_kind("pairs")),
        ("links", of_kind("links")),
        ("longest", (longest as f64).into()),
    ]))
}
