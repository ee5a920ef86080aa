//! The fit of Cochran, Hart & Flynn, piece by piece.

use frond_fit::{CollageError, CollageFit, CollageOptions, Domains, RingMap};
use glam::DVec2;
use js_sys::Float64Array;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::outline::{figures, flat, outline_of};
use crate::boundary::error::failure;
use crate::boundary::value::{object, read, write};

#[derive(Deserialize)]
struct PlainCollage {
    maps: usize,
    features: usize,
    separable: bool,
    tied: bool,
    partitioned: bool,
}

/// The fit of Cochran, Hart & Flynn (section 3.2): `{ points, starts, gaps, widest, mean, collage, numbers, maps,
/// figures }`.
///
/// `points` are those of all pieces, one piece after the other, `starts` where each begins. `gaps`: x0, y0, x1, y1 of
/// the step from each piece to the next; `widest` and `mean` in percent of the diagonal. A row of `maps`: where its
/// domain begins (in feature points), whether it is reversed (0 or 1), the matrix of c's by rows, b, e.
#[wasm_bindgen(js_name = collageFit, unchecked_return_type = "Collage")]
pub fn collage_fit(
    points: &[f64],
    #[wasm_bindgen(unchecked_param_type = "CollageOptions")] options: JsValue,
) -> Result<JsValue, JsValue> {
    let outline = outline_of(points)?;
    let plain: PlainCollage = read("The options", options)?;
    let domains = if plain.partitioned { Domains::Partitioned } else { Domains::Recurrent };
    let options = CollageOptions {
        maps: plain.maps,
        separable: plain.separable,
        tied: plain.tied,
        domains,
        ..CollageOptions::default()
    };
    let fit = CollageFit::of(&outline, plain.features, &options).map_err(of_collage)?;
    let pieces = fit.pieces();
    let mut starts = vec![0.0];
    for piece in &pieces {
        starts.push(starts[starts.len() - 1] + piece.len() as f64);
    }
    let next = |k: usize| pieces[(k + 1) % pieces.len()].first().copied();
    let gaps: Vec<_> =
        pieces.iter().enumerate().flat_map(|(k, piece)| [piece.last().copied(), next(k)]).collect();
    let gaps: Vec<DVec2> = gaps.into_iter().flatten().collect();
    let share = 100.0 / outline.diagonal();
    let (widest, mean) = fit.gaps();
    let rows: Vec<Vec<f64>> = fit.maps.iter().map(row_of).collect();
    Ok(object(&[
        ("points", flat(&pieces.concat())),
        ("starts", Float64Array::from(&starts[..]).into()),
        ("gaps", flat(&gaps)),
        ("widest", (share * widest).into()),
        ("mean", (share * mean).into()),
        ("collage", fit.collage.into()),
        ("numbers", (fit.numbers() as f64).into()),
        ("maps", write(&rows)?),
        ("figures", figures(&outline, &pieces.concat())?),
    ]))
}

fn row_of(map: &RingMap) -> Vec<f64> {
    let m = map.factor;
    let reversed = f64::from(u8::from(map.reversed));
    let mut row = vec![map.start as f64, reversed, m.x_axis.x, m.y_axis.x, m.x_axis.y, m.y_axis.y];
    row.extend([map.step.x, map.step.y, map.offset.x, map.offset.y]);
    row
}

pub(super) fn of_collage(error: CollageError) -> JsValue {
    failure(error.code(), &error.to_string())
}
