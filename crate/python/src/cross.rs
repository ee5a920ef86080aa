//! What crosses the boundary to Python, and how.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use frond_core::{Affine2, Ifs, IfsError};
use glam::DVec2;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

pyo3::import_exception!(frond._errors, FrondError);

/// What is wrong, as the package says it: a stable code, and a sentence that says what to do.
#[derive(Debug)]
pub(crate) struct Problem {
    code: &'static str,
    message: String,
}

impl Problem {
    pub(crate) fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into() }
    }

    /// A value of the wrong form.
    pub(crate) fn input(what: &str, why: impl std::fmt::Display) -> Self {
        Self::new("bad-input", format!("{what} cannot be read: {why}."))
    }
}

impl From<Problem> for PyErr {
    fn from(problem: Problem) -> Self {
        FrondError::new_err((problem.message, problem.code))
    }
}

/// Errors of the crates, which have a code each.
macro_rules! coded {
    ($($error:ty),* $(,)?) => {
        $(impl From<$error> for Problem {
            fn from(error: $error) -> Self {
                Self::new(error.code(), error.to_string())
            }
        })*
    };
}
pub(crate) use coded;

coded!(
    IfsError,
    frond_core::MorphError,
    frond_locus::GridError,
    frond_locus::PathError,
    frond_render::RenderError,
    frond_scene::LinkError,
);

/// Computes without the interpreter's lock: other threads of Python go on. A failure of Frond itself is an error like
/// any other, since PyO3's own is none that `except Exception` would catch.
pub(crate) fn compute<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> Result<T, Problem> + Send,
) -> PyResult<T> {
    let internal = |_| {
        let say = "Frond has failed, which is no fault of yours. Please report what you asked for.";
        Err(Problem::new("internal", say))
    };
    Ok(py.detach(|| catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(internal))?)
}

/// How long a computation goes on before it listens to Ctrl-C.
const LISTENING: Duration = Duration::from_millis(50);

/// Computes step by step until `step` says that it is done, and gives up on Ctrl-C.
pub(crate) fn in_steps(
    py: Python<'_>,
    mut step: impl FnMut() -> Result<bool, Problem> + Send,
) -> PyResult<()> {
    loop {
        let done = compute(py, || {
            let start = Instant::now();
            loop {
                let done = step()?;
                if done || start.elapsed() > LISTENING {
                    return Ok(done);
                }
            }
        })?;
        py.check_signals()?;
        if done {
            return Ok(());
        }
    }
}

/// Rows of six numbers, as the package checks and lays them out.
pub(crate) type Rows<'py> = PyReadonlyArray2<'py, f64>;

pub(crate) fn maps(rows: &Rows<'_>) -> Result<Vec<Affine2>, Problem> {
    let rows = rows.as_array();
    if rows.ncols() != 6 {
        return Err(Problem::input("The maps", "a row has six numbers"));
    }
    Ok(rows.outer_iter().map(|row| Affine2::from_row(std::array::from_fn(|i| row[i]))).collect())
}

/// An IFS that has an attractor.
pub(crate) fn system(maps: Vec<Affine2>, probabilities: Option<&[f64]>) -> Result<Ifs, Problem> {
    let ifs = Ifs::new(maps)?;
    Ok(match probabilities {
        None => ifs,
        Some(list) => ifs.with_probabilities(list)?,
    })
}

/// The numbers of maps, six each.
pub(crate) fn flat_rows<'py>(py: Python<'py>, maps: &[Affine2]) -> Bound<'py, PyArray1<f64>> {
    maps.iter().flat_map(|map| map.to_row()).collect::<Vec<f64>>().into_pyarray(py)
}

/// The numbers of points, two each.
pub(crate) fn flat<'py>(py: Python<'py>, points: &[DVec2]) -> Bound<'py, PyArray1<f64>> {
    points.iter().flat_map(|point| point.to_array()).collect::<Vec<f64>>().into_pyarray(py)
}

/// What has many parts crosses as JSON.
pub(crate) fn write<T: Serialize>(value: &T) -> Result<String, Problem> {
    serde_json::to_string(value).map_err(|error| Problem::input("The result", error))
}

pub(crate) fn read<T: DeserializeOwned>(what: &str, text: &str) -> Result<T, Problem> {
    serde_json::from_str(text).map_err(|error| Problem::input(what, error))
}
