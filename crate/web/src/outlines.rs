//! What tracing a picture and reading a text have in common: points, and what is to be said of them.

use frond_fit::{Notice, Remark};
use glam::DVec2;
use js_sys::Float64Array;
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::boundary::value::write;

#[derive(Serialize)]
pub(crate) struct Warning {
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

pub(crate) fn warnings<'a, T: 'a>(all: &'a [T]) -> Result<JsValue, JsValue>
where
    Warning: From<&'a T>,
{
    write(&all.iter().map(Warning::from).collect::<Vec<_>>())
}

pub(crate) fn flat(points: &[DVec2]) -> JsValue {
    let numbers: Vec<f64> = points.iter().flat_map(|p| p.to_array()).collect();
    Float64Array::from(&numbers[..]).into()
}
