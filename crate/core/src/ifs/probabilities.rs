//! How probable each map is in the chaos game, so that points fall evenly.

use glam::{DMat2, DMat3};

use crate::linear::svd2::singular_values;
use crate::linear::svd3::singular_values3;

/// Probabilities in proportion to |det|, so that points fall evenly; a map that is nearly singular
/// still gets a little, or its piece would never show.
pub(crate) fn by_area(linear: &[DMat2]) -> Vec<f64> {
    let areas: Vec<f64> = linear.iter().map(|m| m.determinant().abs()).collect();
    let total: f64 = areas.iter().sum();
    // Where all maps are singular, their lengths take the place of areas.
    let weights: Vec<f64> =
        if total > 0.0 { areas } else { linear.iter().map(|&m| singular_values(m).0).collect() };
    let total: f64 = weights.iter().sum();
    let floor = if total > 0.0 { 0.01 * total } else { 1.0 };
    shared(weights, floor)
}

/// Probabilities in proportion to how large the pieces are, so that points fall evenly; a small piece still gets a
/// little, or it would never show.
///
/// Pieces are measured by the volume of their maps, or, where all are flat, by the area or the length.
pub(crate) fn by_volume(linear: &[DMat3]) -> Vec<f64> {
    let values: Vec<[f64; 3]> = linear.iter().map(|&m| singular_values3(m)).collect();
    let largest = values.iter().map(|v| v[0]).fold(0.0, f64::max);
    let measure = |dimensions: usize| -> Vec<f64> {
        values.iter().map(|v| v[..dimensions].iter().map(|s| s / largest).product()).collect()
    };
    // Rounding makes a flat map seem a little thick.
    let weights = if largest > 0.0 {
        [3, 2, 1].map(measure).into_iter().find(|w| w.iter().sum::<f64>() > 1e-12)
    } else {
        None
    };
    let weights = weights.unwrap_or_else(|| vec![1.0; linear.len()]);
    let floor = 0.01 * weights.iter().sum::<f64>();
    shared(weights, floor)
}

/// Weights that are at least `floor`, scaled to the sum 1.
pub(crate) fn shared(weights: Vec<f64>, floor: f64) -> Vec<f64> {
    let weights: Vec<f64> = weights.into_iter().map(|w| w.max(floor)).collect();
    let total: f64 = weights.iter().sum();
    weights.into_iter().map(|w| w / total).collect()
}
