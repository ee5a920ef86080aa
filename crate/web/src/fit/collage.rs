//! The fit of Cochran, Hart & Flynn, piece by piece.

use frond_fit::{CollageFit, CollageOptions, Domains, Outline, RingMap, features, fit_collage};
use glam::DVec2;
use js_sys::Float64Array;
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::outline::{figures, flat, outline_of};
use crate::boundary::error::failure;
use crate::boundary::value::{object, read, write};

/// The most points of its polyline.
const MOST_DRAWN: usize = 1 << 17;

#[derive(Deserialize)]
struct PlainCollage {
    maps: usize,
    features: usize,
    separable: bool,
    tied: bool,
    partitioned: bool,
}

/// The fit of Cochran, Hart & Flynn (section 3.2): `{ points, starts, gaps, widest, mean, collage, numbers, maps, figures }`.
///
/// `points` are those of all pieces, one piece after the other, `starts` where each begins. `gaps`: x0, y0, x1, y1 of the
/// step from each piece to the next; `widest` and `mean` in percent of the diagonal. A row of `maps`: where its domain
/// begins (in feature points), whether it is reversed (0 or 1), the matrix of c's by rows, b, e.
#[wasm_bindgen(js_name = collageFit)]
pub fn collage_fit(points: &[f64], options: JsValue) -> Result<JsValue, JsValue> {
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
    let fit = collage_of(&outline, plain.features, &options)?;
    let pieces = pieces_of(&fit);
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

pub(super) fn collage_of(
    outline: &Outline,
    count: usize,
    options: &CollageOptions,
) -> Result<CollageFit, JsValue> {
    let ring: Vec<_> = features(outline, count).into_iter().map(|i| outline.points()[i]).collect();
    fit_collage(&ring, options).map_err(|error| failure(error.code(), &error.to_string()))
}

/// The attractor, piece by piece with both ends, at eight times as many points as there are feature points.
pub(super) fn pieces_of(fit: &CollageFit) -> Vec<Vec<DVec2>> {
    let points = fit.maps.len() * fit.intervals;
    let finer = (MOST_DRAWN / points.max(1)).clamp(1, 8);
    // The same maps between more points: a domain begins where it did.
    let mut fine = fit.clone();
    fine.intervals *= finer;
    fine.maps.iter_mut().for_each(|map| map.start *= finer);
    let (points, ends) = fine.attractor();
    let piece = |(part, end): (&[DVec2], DVec2)| part.iter().copied().chain([end]).collect();
    points.chunks(fine.intervals).zip(ends).map(piece).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use frond_fit::maple_leaf;

    #[test]
    fn pieces_of_the_papers_fit_pass_its_points_and_meet_where_they_are_tied() {
        let outline = Outline::new(&maple_leaf(2)).unwrap();
        for tied in [false, true] {
            let options = CollageOptions { tied, ..CollageOptions::default() };
            let fit = collage_of(&outline, 261, &options).unwrap();
            let pieces = pieces_of(&fit);
            assert_eq!(pieces.len(), 29);
            let (points, _) = fit.attractor();
            for (k, piece) in pieces.iter().enumerate() {
                assert_eq!(piece.len(), 8 * fit.intervals + 1);
                for m in 0..fit.intervals {
                    let missed = piece[8 * m].distance(points[k * fit.intervals + m]);
                    assert!(missed < 1e-9, "{missed}");
                }
            }
            let gap = |k: usize| pieces[k][pieces[k].len() - 1].distance(pieces[(k + 1) % 29][0]);
            let widest = (0..29).map(gap).fold(0.0, f64::max);
            assert!((widest - fit.gaps().0).abs() < 1e-9);
            assert_eq!(widest < 1e-9, tied);
        }
    }
}
