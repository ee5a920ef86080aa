//! One shape: whether there is one, its points, its picture, its bounds and its dimensions.

use frond_core::{ChaosGame, Colouring, Hull, Ifs, IfsError, affinity_dimension, similarity_dimension};
use frond_render::{RasterOptions, View};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::cross::{Problem, Rows, compute, flat, in_steps, maps, system};

/// The probabilities of an IFS, whose maps need not have an attractor: those given, scaled to sum 1, or in proportion
/// to the areas of the pieces; none where neither are there.
#[pyfunction]
#[pyo3(signature = (rows, probabilities))]
pub(crate) fn checked(
    py: Python<'_>,
    rows: Rows<'_>,
    probabilities: Option<Vec<f64>>,
) -> PyResult<Option<Vec<f64>>> {
    let maps = maps(&rows)?;
    compute(py, || {
        let count = maps.len();
        match Ifs::new(maps) {
            Ok(ifs) => {
                let Some(given) = probabilities else { return Ok(Some(ifs.probabilities().to_vec())) };
                Ok(Some(ifs.with_probabilities(&given)?.probabilities().to_vec()))
            }
            Err(IfsError::NoAttractor { .. } | IfsError::Unproved) => {
                let Some(given) = probabilities else { return Ok(None) };
                let sum: f64 = given.iter().sum();
                let sound = given.len() == count && given.iter().all(|p| *p >= 0.0);
                if !(sound && sum > 0.0 && sum.is_finite()) {
                    return Err(IfsError::Probabilities { maps: count }.into());
                }
                Ok(Some(given.iter().map(|p| p / sum).collect()))
            }
            Err(error) => Err(error.into()),
        }
    })
}

/// How many points are made between two looks at whether somebody wants to stop.
const AT_ONCE: usize = 1 << 18;

const MOST_POINTS: usize = 1 << 24;

/// Points of the chaos game, x0, y0, x1, y1, .., and the piece of each.
#[pyfunction]
pub(crate) fn attractor<'py>(
    py: Python<'py>,
    rows: Rows<'_>,
    probabilities: Option<Vec<f64>>,
    points: usize,
    seed: u32,
) -> PyResult<(Bound<'py, PyArray1<f32>>, Bound<'py, PyArray1<u8>>)> {
    let maps = maps(&rows)?;
    if points > MOST_POINTS {
        return Err(Problem::input("n", format!("it is at most {MOST_POINTS}")).into());
    }
    let ifs = compute(py, || system(maps, probabilities.as_deref()))?;
    let mut game = ChaosGame::new(&ifs, seed);
    let (mut positions, mut pieces) = (vec![0.0; 2 * points], vec![0; points]);
    let mut parts = positions.chunks_mut(2 * AT_ONCE).zip(pieces.chunks_mut(AT_ONCE));
    in_steps(py, || {
        let Some((positions, pieces)) = parts.next() else { return Ok(true) };
        game.fill(positions, pieces);
        Ok(false)
    })?;
    Ok((positions.into_pyarray(py), pieces.into_pyarray(py)))
}

/// What a picture shows, and how: width, height, view, colouring, palette, smooth, exposure, whether it is for a light
/// ground, and whether points are enough.
type Asked = (u32, u32, Option<[f64; 3]>, String, Vec<[u8; 3]>, bool, f32, Option<bool>, bool);

/// The picture of an attractor, four bytes a pixel.
#[pyfunction]
pub(crate) fn rasterize<'py>(
    py: Python<'py>,
    rows: Rows<'_>,
    probabilities: Option<Vec<f64>>,
    options: Asked,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let maps = maps(&rows)?;
    let (width, height, view, colouring, palette, smooth, exposure, light_ground, draft) = options;
    let colouring = match colouring.as_str() {
        "map" => Colouring::Map,
        "address" => Colouring::Address,
        "density" => Colouring::Density,
        _ => {
            return Err(
                Problem::input("The colouring", "\"map\", \"address\" and \"density\" are there").into()
            );
        }
    };
    let pixels = compute(py, || {
        let ifs = system(maps, probabilities.as_deref())?;
        let view = view.map(|[x, y, scale]| View { x, y, scale });
        let options = RasterOptions {
            width,
            height,
            view,
            colouring,
            palette: &palette,
            smooth,
            exposure,
            light_ground,
            draft,
            bend: None,
        };
        Ok(frond_render::rasterize(&ifs, &options)?)
    })?;
    Ok(pixels.into_pyarray(py))
}

/// The least and largest coordinates of an attractor, and the corners of a convex polygon around it.
#[pyfunction]
pub(crate) fn bounds<'py>(
    py: Python<'py>,
    rows: Rows<'_>,
) -> PyResult<([f64; 2], [f64; 2], Bound<'py, PyArray1<f64>>)> {
    let maps = maps(&rows)?;
    let hull = compute(py, || Ok(Hull::of(&system(maps, None)?)))?;
    Ok((hull.min().to_array(), hull.max().to_array(), flat(py, hull.vertices())))
}

/// The similarity dimension, where all maps are similitudes, and the affinity dimension.
#[pyfunction]
pub(crate) fn dimension(py: Python<'_>, rows: Rows<'_>) -> PyResult<(Option<f64>, f64)> {
    let maps = maps(&rows)?;
    compute(py, || {
        let ifs = system(maps, None)?;
        Ok((similarity_dimension(&ifs), affinity_dimension(&ifs)))
    })
}
