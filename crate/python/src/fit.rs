//! From pictures to outlines, and from outlines to curves.

use frond_fit::{
    DRAWING_LEVELS, DRAWING_TOLERANCE, FitError, Fitter, MaskOptions, Notice, Outline, OutlineError,
    PackError, SplineError, SplineFit, SplineFitter, TraceError, Tracer, box_slope, fidelity,
};
use glam::DVec2;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::cross::{Problem, Rows, coded, compute, flat, in_steps};

/// Sides of a parabola where a curve is measured and drawn.
const SIDES: usize = 16;

coded!(FitError, OutlineError, PackError, SplineError, TraceError);

/// Points (x, y), as the package checks and lays them out.
fn points(rows: &Rows<'_>) -> Result<Vec<DVec2>, Problem> {
    let rows = rows.as_array();
    if rows.ncols() != 2 {
        return Err(Problem::input("The outline", "a point has two numbers"));
    }
    Ok(rows.outer_iter().map(|row| DVec2::new(row[0], row[1])).collect())
}

/// What is to be said of a result: a code and a sentence each.
type Said = Vec<(&'static str, String)>;

/// The outline of what a picture shows: its points, its area, its length, and what is to be said of it.
#[pyfunction]
pub(crate) fn trace<'py>(
    py: Python<'py>,
    pixels: PyReadonlyArray1<'_, u8>,
    size: (usize, usize),
    threshold: f64,
    stalk: bool,
    component: usize,
) -> PyResult<(Bound<'py, PyArray1<f64>>, f64, f64, Said)> {
    let pixels = pixels.as_array().to_vec();
    let (width, height) = size;
    let traced = compute(py, || {
        let tracer = Tracer::new(width, height, &pixels)?;
        let options = MaskOptions { threshold, remove_stalks: !stalk, ..MaskOptions::default() };
        let mask = tracer.mask(&options);
        Ok(tracer.outline(&mask, component)?)
    })?;
    let said = traced.notices.iter().map(|notice: &Notice| (notice.code(), notice.message())).collect();
    Ok((flat(py, &traced.points), traced.area(), traced.length(), said))
}

/// The points of an outline in their order, counter-clockwise, its area, its length and its box dimension.
#[pyfunction]
pub(crate) fn measure<'py>(
    py: Python<'py>,
    outline: Rows<'_>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, f64, f64, f64)> {
    let given = points(&outline)?;
    let (outline, slope) = compute(py, || {
        let outline = Outline::new(&given)?;
        let slope = box_slope(outline.points(), &outline);
        Ok((outline, slope))
    })?;
    Ok((flat(py, outline.points()), outline.area(), outline.length(), slope))
}

/// How near a curve is to an outline: as `Fidelity` has it, in its order.
type Figures = (f64, f64, f64, f64, f64);

fn figures(outline: &Outline, line: &[DVec2]) -> Figures {
    let found = fidelity(outline, line);
    (found.rms, found.hausdorff, found.length_ratio, found.outline_slope, found.fit_slope)
}

/// An edge that copies: from which knot, over how many edges, whether backwards, and its free number.
type Edge = Option<(usize, usize, bool, f64)>;

/// A closed curve as a link brings it back: knots, edges, a polyline, figures, and its bytes.
type Fitted<'py> = (Bound<'py, PyArray1<f64>>, Vec<Edge>, Bound<'py, PyArray1<f64>>, Figures, usize);

/// Fits a closed curve of so many numbers to an outline.
#[pyfunction]
pub(crate) fn fit_numbers<'py>(py: Python<'py>, outline: Rows<'_>, numbers: usize) -> PyResult<Fitted<'py>> {
    let given = points(&outline)?;
    let (outline, mut fitter) = compute(py, || {
        let outline = Outline::new(&given)?;
        let fitter = Fitter::new(&outline, numbers)?;
        Ok((outline, fitter))
    })?;
    in_steps(py, || {
        fitter.step();
        Ok(fitter.is_done())
    })?;
    let (curve, line, found, bytes) = compute(py, || {
        let curve = fitter.best().curve.quantised()?;
        // Four letters for three bytes.
        let bytes = 3 * curve.to_text()?.len() / 4;
        let line = curve.polyline(DRAWING_TOLERANCE * outline.diagonal(), DRAWING_LEVELS);
        let found = figures(&outline, &line);
        Ok((curve, line, found, bytes))
    })?;
    let edges = curve
        .edges
        .iter()
        .map(|edge| edge.as_ref().map(|copy| (copy.from, copy.span, copy.reversed, copy.c)));
    Ok((flat(py, &curve.knots), edges.collect(), flat(py, &line), found, bytes))
}

/// A curve of corners and parabolas: its word, its bytes, corners, bends, a polyline and figures.
type Within<'py> = (String, Vec<u8>, usize, usize, Bound<'py, PyArray1<f64>>, Figures);

/// Fits a curve of corners and parabolas within so many bytes to an outline.
#[pyfunction]
pub(crate) fn fit_bytes<'py>(py: Python<'py>, outline: Rows<'_>, bytes: usize) -> PyResult<Within<'py>> {
    let given = points(&outline)?;
    let outline = compute(py, || Ok(Outline::new(&given)?))?;
    let mut fitter = compute(py, || Ok(SplineFitter::new(&outline, bytes)))?;
    in_steps(py, || {
        fitter.step();
        Ok(fitter.is_done())
    })?;
    let (word, bytes, corners, bends, line, found) = compute(py, || {
        let Some(SplineFit { spline, .. }) = fitter.best() else {
            return Err(Problem::new(
                "no-fit",
                "No curve was found within so many bytes: the outline is too thin, or too far from the origin. \
                 Allow more bytes.",
            ));
        };
        let line = spline.polyline(SIDES);
        let found = figures(&outline, &line);
        let bends = spline.nodes.len() - spline.corners();
        Ok((spline.to_text()?, spline.to_bytes()?, spline.corners(), bends, line, found))
    })?;
    Ok((word, bytes, corners, bends, flat(py, &line), found))
}
