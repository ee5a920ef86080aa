//! The gallery, and links.

use frond_scene::Scene;
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::cross::{Problem, compute, flat_rows, read, write};

/// A shape of the gallery: id, name, what it is, and its maps, six numbers each.
type Told<'py> = (&'static str, &'static str, &'static str, Bound<'py, PyArray1<f64>>);

/// The gallery.
#[pyfunction]
pub(crate) fn presets(py: Python<'_>) -> Vec<Told<'_>> {
    let told = |preset: frond_scene::Preset| {
        let maps: Vec<_> = preset.maps.iter().map(|&row| frond_core::Affine2::from_row(row)).collect();
        (preset.id, preset.name, preset.about, flat_rows(py, &maps))
    };
    frond_scene::presets().into_iter().map(told).collect()
}

/// The fragment of the link of a document, which is given as JSON.
#[pyfunction]
pub(crate) fn encode(py: Python<'_>, scene: &str) -> PyResult<String> {
    compute(py, || {
        let scene: Scene = read("The document", scene)?;
        for shape in [&scene.a, &scene.b] {
            shape.ifs()?;
        }
        Ok(frond_scene::encode(&scene)?)
    })
}

/// The document of a link, as JSON.
#[pyfunction]
pub(crate) fn decode(py: Python<'_>, link: &str) -> PyResult<String> {
    compute(py, || match frond_scene::decode(link) {
        (scene, None) => write(&scene),
        (_, Some(problem)) => Err(Problem::from(problem)),
    })
}
