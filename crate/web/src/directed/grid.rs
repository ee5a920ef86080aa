//! Shapes of one grid, given by digits, and what two of them share.

use frond_core::{
    AddressCount, DigitError, DigitSystem, GridIntersection, MAX_MAPS, grid_intersection as intersect,
};
use glam::DVec2;
use js_sys::Reflect;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::boundary::error::failure;
use crate::boundary::value::{Row, longer_than, object, point, read, write};
use crate::directed::{PlainSystem, of_directed};

#[derive(Deserialize)]
struct PlainDigits {
    matrix: [i64; 4],
    digits: Vec<[i64; 2]>,
}

fn of_digits(error: &DigitError) -> JsValue {
    failure(error.code(), &error.to_string())
}

/// Digits that make a shape. Longer lists than allowed are refused before their entries are read.
fn read_digits(value: JsValue) -> Result<DigitSystem, JsValue> {
    let digits = Reflect::get(&value, &"digits".into()).unwrap_or(JsValue::UNDEFINED);
    if let Some(count) = longer_than(&digits, MAX_MAPS) {
        return Err(of_digits(&DigitError::TooManyDigits { count }));
    }
    let PlainDigits { matrix, digits } = read("The digits", value)?;
    DigitSystem::new(matrix, digits).map_err(|error| of_digits(&error))
}

#[derive(Deserialize)]
struct Moved {
    #[serde(default)]
    shift: [f64; 2],
}

/// The shape of a digit system, moved by a shift, as a graph-directed system of one state.
#[wasm_bindgen(js_name = digitShape, unchecked_return_type = "DirectedIfs")]
pub fn digit_shape(
    #[wasm_bindgen(unchecked_param_type = "DigitSystem")] system: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "{ shift?: [number, number] }")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let system = read_digits(system)?;
    let Moved { shift } = read("The options", options)?;
    let shape = system.shape(DVec2::from(shift)).map_err(|error| of_directed(&error))?;
    write(&PlainSystem::of(shape.states()))
}

#[derive(Deserialize)]
struct Shift {
    numerators: [i64; 2],
    denominator: i64,
}

#[derive(Serialize)]
struct PlainCopy {
    digit: usize,
    to: usize,
}

#[derive(Serialize)]
struct PlainState<'a> {
    shifts: &'a [[i64; 2]],
    copies: Vec<PlainCopy>,
}

/// What two shapes of one grid share, the second moved by a fraction, as a graph-directed system. Found in whole
/// numbers: nothing is rounded. Throws where there is no grid in common, or the graph becomes too large.
#[wasm_bindgen(js_name = gridIntersection, unchecked_return_type = "GridIntersection")]
pub fn grid_intersection(
    #[wasm_bindgen(unchecked_param_type = "DigitSystem")] first: JsValue,
    #[wasm_bindgen(unchecked_param_type = "DigitSystem")] second: JsValue,
    #[wasm_bindgen(unchecked_param_type = "{ numerators: [number, number]; denominator: number }")]
    shift: JsValue,
) -> Result<JsValue, JsValue> {
    let (first, second) = (read_digits(first)?, read_digits(second)?);
    let Shift { numerators, denominator } = read("The shift", shift)?;
    let found = intersect(&first, &second, numerators, denominator).map_err(|error| of_digits(&error))?;
    written(&found)
}

fn written(found: &GridIntersection) -> Result<JsValue, JsValue> {
    let system = found.system().map_err(|error| of_digits(&error))?;
    let copy = |&(digit, to): &(usize, usize)| PlainCopy { digit, to };
    let states: Vec<PlainState<'_>> = found
        .states
        .iter()
        .map(|state| PlainState { shifts: &state.shifts, copies: state.copies.iter().map(copy).collect() })
        .collect();
    let rows = found.attractor().map(|maps| maps.into_iter().map(|map| map.to_row()).collect::<Vec<Row>>());
    let mut fields = vec![
        ("system", system.map_or(Ok(JsValue::NULL), |system| write(&PlainSystem::of(system.states())))?),
        ("states", write(&states)?),
        ("denominator", (found.denominator as f64).into()),
        ("shifts", found.shifts.into()),
        ("isExact", found.is_exact.into()),
        ("attractor", rows.map_or(Ok(JsValue::NULL), |rows| write(&rows))?),
        ("points", {
            let points = found.points().map(|all| all.into_iter().map(point).collect::<Vec<_>>());
            points.map_or(Ok(JsValue::NULL), |points| write(&points))?
        }),
        (
            "addresses",
            match found.addresses() {
                AddressCount::Finite(count) => (count as f64).into(),
                AddressCount::Countable => "countable".into(),
                AddressCount::Uncountable => "uncountable".into(),
            },
        ),
    ];
    if let Some(dimension) = found.dimension() {
        fields.push(("dimension", dimension.into()));
    }
    Ok(object(&fields))
}
