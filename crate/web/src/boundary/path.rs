//! Ways through a locus.

use frond_locus::{PathCheck, PathOptions, PathPlan};
use glam::DVec3;
use serde::Deserialize;
use wasm_bindgen::JsValue;

use super::error::bad_input;
use super::grid::EPSILON;
use super::value::{object, read, write};

pub(crate) fn write_plan(plan: &PathPlan) -> Result<JsValue, JsValue> {
    let points: Vec<Vec<f64>> = plan.points.iter().map(|&at| parameter(at)).collect();
    let mut fields = vec![
        ("points", write(&points)?),
        ("gap", plan.gap.into()),
        ("holds", plan.holds.into()),
        ("clearance", plan.clearance.into()),
        ("apart", plan.apart.into()),
        ("step", plan.step.into()),
    ];
    if let Some(worst) = plan.worst {
        fields.push(("worst", write(&parameter(worst))?));
    }
    Ok(object(&fields))
}

/// `[u, v]` in the plane, else `[u, v, w]`.
fn parameter(at: DVec3) -> Vec<f64> {
    if at.z == 0.0 { vec![at.x, at.y] } else { at.to_array().to_vec() }
}

/// A path of points `[u, v]` or `[u, v, w]`.
pub(crate) fn read_path(points: JsValue) -> Result<Vec<DVec3>, JsValue> {
    let points: Vec<Vec<f64>> = read("The path", points)?;
    let point = |point: Vec<f64>| match point[..] {
        [u, v] => Some(DVec3::new(u, v, 0.0)),
        [u, v, w] => Some(DVec3::new(u, v, w)),
        _ => None,
    };
    let points = points.into_iter().map(|row| point(row).filter(|at| at.is_finite()));
    let points: Option<Vec<DVec3>> = points.collect();
    let points =
        points.ok_or_else(|| bad_input("The path", "each point must be two or three finite numbers"))?;
    if points.is_empty() {
        return Err(bad_input("The path", "it must have a point or more"));
    }
    Ok(points)
}

#[derive(Deserialize)]
struct Planning {
    epsilon: Option<f64>,
    size: Option<f64>,
}

/// How a path is planned, as far as the plane and space have it in common.
pub(crate) fn read_planning(options: JsValue) -> Result<PathOptions, JsValue> {
    let plain: Planning = read("The options", options)?;
    let default = PathOptions::default();
    Ok(PathOptions {
        epsilon: plain.epsilon.unwrap_or(default.epsilon),
        size: plain.size.map_or(default.size, |size| size as usize),
        ..default
    })
}

#[derive(Deserialize)]
struct Checking {
    epsilon: Option<f64>,
    samples: Option<f64>,
}

/// The epsilon of a check and how many samples it looks at, `samples` where nothing is said.
pub(crate) fn read_samples(options: JsValue, samples: f64) -> Result<(f64, usize), JsValue> {
    let plain: Checking = read("The options", options)?;
    let samples = plain.samples.unwrap_or(samples).clamp(2.0, 100_000.0) as usize;
    Ok((plain.epsilon.unwrap_or(EPSILON), samples))
}

pub(crate) fn write_check(found: &PathCheck) -> Result<JsValue, JsValue> {
    Ok(object(&[("gap", found.gap.into()), ("holds", found.holds.into()), ("breaks", write(&found.breaks)?)]))
}
