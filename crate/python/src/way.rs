//! The connectedness locus, and paths through it.

use frond_core::Morph;
use frond_locus::{
    Axes, Bounds, CertifyOptions, LocusGrid, Pass, PathOptions, PathPlan, PathSearch, Scratch, Slice,
};
use glam::DVec3;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::cross::{Problem, compute, in_steps};
use crate::morph::{Asked, Parts};

/// The state and the gap of every sample of a locus, row by row from the bottom.
#[pyfunction]
pub(crate) fn locus<'py>(
    py: Python<'py>,
    asked: Asked<'_>,
    bounds: [f64; 4],
    size: (usize, usize),
    epsilon: f64,
    w: f64,
) -> PyResult<(Bound<'py, PyArray1<u8>>, Bound<'py, PyArray1<f32>>)> {
    let parts = Parts::of(asked)?;
    let [u0, v0, u1, v1] = bounds;
    let (width, height) = size;
    let grid = LocusGrid::new(Bounds { u0, v0, u1, v1 }, width, height).map_err(Problem::from)?;
    let morph = compute(py, || parts.morph())?;
    let (mut state, mut gap) = (Vec::new(), Vec::new());
    let (mut scratch, mut row) = (Scratch::default(), 0);
    in_steps(py, || {
        let slice = Slice::new(&morph, w);
        let pass = Pass { rows: row..row + 1, stride: 1, first: true };
        let mut tile = grid.tile(&slice, epsilon, &pass, &mut scratch);
        state.append(&mut tile.state);
        gap.append(&mut tile.gap);
        row += 1;
        Ok(row == height)
    })?;
    Ok((state.into_pyarray(py), gap.into_pyarray(py)))
}

/// A path with what was met along it: points, gap, whether it holds, clearance, the worst point, whether the ends lie
/// apart, and how far the samples were from each other.
type Told = (Vec<[f64; 3]>, f64, bool, f64, Option<[f64; 3]>, bool, f64);

/// Looks for a path along which the shape stays in one piece.
#[pyfunction]
pub(crate) fn plan_path(
    py: Python<'_>,
    asked: Asked<'_>,
    epsilon: f64,
    size: Option<usize>,
    space: bool,
) -> PyResult<Told> {
    let parts = Parts::of(asked)?;
    let morph: Morph = compute(py, || parts.morph())?;
    let default = PathOptions::default();
    let axes = if space { Axes::Three } else { Axes::Two };
    let options = PathOptions { axes, epsilon, size: size.unwrap_or(default.size) };
    let mut search = PathSearch::new(morph, options);
    let mut plan = None;
    in_steps(py, || {
        plan = search.step()?;
        Ok(plan.is_some())
    })?;
    let plan: PathPlan = plan.ok_or_else(|| Problem::new("internal", "The search for a path found none."))?;
    Ok((
        plan.points.iter().map(|point| point.to_array()).collect(),
        plan.gap,
        plan.holds,
        plan.clearance,
        plan.worst.map(|point| point.to_array()),
        plan.apart,
        plan.step,
    ))
}

fn points(path: &[[f64; 3]]) -> Vec<DVec3> {
    path.iter().map(|&point| point.into()).collect()
}

/// Looks along a path at so many samples: the widest gap, whether it holds, and where it breaks.
#[pyfunction]
pub(crate) fn check_path(
    py: Python<'_>,
    asked: Asked<'_>,
    path: Vec<[f64; 3]>,
    epsilon: f64,
    samples: usize,
) -> PyResult<(f64, bool, Vec<(f64, f64)>)> {
    let parts = Parts::of(asked)?;
    compute(py, || {
        let found = frond_locus::check_path(&parts.morph()?, &points(&path), epsilon, samples);
        Ok((found.gap, found.holds, found.breaks))
    })
}

/// Proves a bound of the widest gap along a stretch of a path: the bound, whether it is small enough, the boxes, the
/// worst place, whether the question is answered, and the joints.
#[pyfunction]
pub(crate) fn certify_path(
    py: Python<'_>,
    asked: Asked<'_>,
    path: Vec<[f64; 3]>,
    within: f64,
    stretch: (f64, f64),
    budget: Option<usize>,
) -> PyResult<(f64, bool, usize, f64, bool, usize)> {
    let parts = Parts::of(asked)?;
    let (t0, t1) = stretch;
    let default = CertifyOptions::default();
    let options = CertifyOptions { within, t0, t1, budget: budget.unwrap_or(default.budget) };
    if options.stretch().is_none() {
        let why = "t0 must not be above t1, and some of the path from 0 to 1 must lie between them";
        return Err(Problem::input("The stretch", why).into());
    }
    compute(py, || {
        let found = frond_locus::certify_path(&parts.morph()?, &points(&path), &options);
        Ok((found.gap, found.holds, found.boxes, found.worst, found.complete, found.joints))
    })
}
