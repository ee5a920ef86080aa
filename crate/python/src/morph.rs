//! The way from one shape to another.

use frond_core::{Affine2, Mode, Morph, MorphOptions, probabilities_between};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::cross::{Problem, Rows, compute, flat_rows, maps, system};

/// What may be chosen about a morph: whether linear parts are interpolated element by element, the correspondence and
/// the turns.
pub(crate) type Chosen = (bool, Vec<usize>, Vec<i32>);

/// Both ends of a morph, and what was chosen.
pub(crate) type Asked<'py> = (Rows<'py>, Rows<'py>, Chosen);

pub(crate) struct Parts {
    from: Vec<Affine2>,
    to: Vec<Affine2>,
    options: MorphOptions,
}

impl Parts {
    pub(crate) fn of((from, to, chosen): Asked<'_>) -> Result<Self, Problem> {
        let (linear, correspondence, turns) = chosen;
        let mode = if linear { Mode::Linear } else { Mode::Polar };
        Ok(Self { from: maps(&from)?, to: maps(&to)?, options: MorphOptions { mode, correspondence, turns } })
    }

    pub(crate) fn morph(&self) -> Result<Morph, Problem> {
        Ok(Morph::new(&self.from, &self.to, &self.options)?)
    }
}

/// Two systems with the same number of maps, six numbers each, their probabilities, and a sentence for each step.
type Paired<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Vec<f64>, Vec<f64>, Vec<String>);

/// Brings two systems to the same number of maps.
#[pyfunction]
pub(crate) fn pair<'py>(
    py: Python<'py>,
    first: (Rows<'_>, Option<Vec<f64>>),
    last: (Rows<'_>, Option<Vec<f64>>),
) -> PyResult<Paired<'py>> {
    let [from, to] = [first, last].map(|(rows, probabilities)| (maps(&rows), probabilities));
    let found = compute(py, || {
        let [from, to] = [from, to].map(|(maps, given)| system(maps?, given.as_deref()));
        Ok(frond_core::pair(&from?, &to?))
    })?;
    let rows = [&found.from, &found.to].map(|maps| flat_rows(py, maps));
    let [from, to] = rows;
    Ok((from, to, found.from_probabilities, found.to_probabilities, found.steps))
}

/// The maps at (u, v, w), six numbers each, and the probabilities between those given.
#[pyfunction]
pub(crate) fn interpolate<'py>(
    py: Python<'py>,
    asked: Asked<'_>,
    probabilities: Option<(Vec<f64>, Vec<f64>)>,
    at: [f64; 3],
) -> PyResult<(Bound<'py, PyArray1<f64>>, Option<Vec<f64>>)> {
    let parts = Parts::of(asked)?;
    let [u, v, w] = at;
    let (maps, between) = compute(py, || {
        let between = |(from, to): (Vec<f64>, Vec<f64>)| {
            probabilities_between(&from, &to, &parts.options.correspondence, u)
        };
        Ok((parts.morph()?.at3(u, v, w), probabilities.map(between)))
    })?;
    Ok((flat_rows(py, &maps), between))
}
