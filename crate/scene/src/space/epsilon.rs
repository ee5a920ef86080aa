//! The paper's projection: a scale that goes to 0.

use frond_core::Affine3;
use glam::{DMat3, DVec3};

use crate::space::preset::Row3;
use crate::space::project::{Plane, ProjectError};

/// A shape flattened by epsilon along the direction of view (Darwish & Abd-El-Wahab, section 3.5).
#[derive(Clone, Debug, PartialEq)]
pub struct EpsilonProjection {
    /// The maps in the coordinates of the picture: x to the right, y up, z along the view.
    pub maps: Vec<Row3>,
    /// The largest entry of all matrices.
    pub largest: f64,
    /// The entries that grow as 1 / epsilon: the map, and the row of the matrix, 0 or 1, of the third column.
    pub diverging: Vec<(usize, usize)>,
}

/// Conjugates maps by `diag(1, 1, epsilon)` in the coordinates of a picture.
///
/// The third row of each matrix is multiplied by epsilon and the third column divided by it, so that c and f become
/// c / epsilon and f / epsilon: the attractor goes to its shadow, but where some c or f is not 0 its maps go nowhere. Only where the
/// direction of view is kept do they have a limit: that of [`exact_projection`](crate::exact_projection).
///
/// # Errors
/// [`ProjectError::Epsilon`] unless epsilon is between 1e-100 and 1.
pub fn epsilon_projection(
    maps: &[Affine3],
    plane: &Plane,
    epsilon: f64,
) -> Result<EpsilonProjection, ProjectError> {
    if !(1e-100..=1.0).contains(&epsilon) {
        return Err(ProjectError::Epsilon);
    }
    let from = DMat3::from_cols(plane.right, plane.up, plane.direction());
    let mut largest = 0.0_f64;
    let mut diverging = Vec::new();
    let mut rows = Vec::with_capacity(maps.len());
    for (k, map) in maps.iter().enumerate() {
        let mut linear = from.transpose() * map.linear * from;
        let mut translation = from.transpose() * map.translation;
        // What is 0 but for the rounding of the coordinates must not be blown up.
        let rounding = 1e-14 * map.norm();
        for row in 0..2 {
            if linear.z_axis[row].abs() <= rounding {
                linear.z_axis[row] = 0.0;
            } else {
                diverging.push((k, row));
            }
        }
        linear.z_axis *= DVec3::new(1.0 / epsilon, 1.0 / epsilon, 1.0);
        for column in [0, 1] {
            linear.col_mut(column).z *= epsilon;
        }
        translation.z *= epsilon;
        largest = linear.to_cols_array().iter().fold(largest, |most, x| most.max(x.abs()));
        rows.push(Affine3::new(linear, translation).to_row());
    }
    Ok(EpsilonProjection { maps: rows, largest, diverging })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::preset::preset3;

    fn maps(id: &str) -> Vec<Affine3> {
        preset3(id).unwrap().maps.into_iter().map(Affine3::from_row).collect()
    }

    #[test]
    fn entries_diverge_as_one_over_epsilon_unless_the_direction_is_kept() {
        let plane = Plane::across(DVec3::new(0.0, 0.0, -1.0)).unwrap();
        let at = |id: &str, epsilon: f64| epsilon_projection(&maps(id), &plane, epsilon).unwrap();
        let (coarse, fine) = (at("fern", 1e-3), at("fern", 1e-6));
        assert!(!fine.diverging.is_empty() && fine.diverging.iter().all(|&(map, row)| map < 4 && row < 2));
        assert!((fine.largest / coarse.largest - 1e3).abs() < 1.0, "{} {}", fine.largest, coarse.largest);
        let sponge = at("sponge", 1e-6);
        assert!(sponge.diverging.is_empty() && sponge.largest < 0.34);
    }

    #[test]
    fn it_is_conjugation_by_the_flattening() {
        let plane = Plane::across(DVec3::new(0.3, -1.0, 0.2)).unwrap();
        let epsilon = 0.125;
        let found = epsilon_projection(&maps("fern"), &plane, epsilon).unwrap();
        let to = DMat3::from_cols(plane.right, plane.up, plane.direction()).transpose();
        let by = Affine3::new(DMat3::from_diagonal(DVec3::new(1.0, 1.0, epsilon)) * to, DVec3::ZERO);
        for (map, row) in maps("fern").iter().zip(found.maps) {
            for (x, y) in map.moved(by).unwrap().to_row().iter().zip(row) {
                assert!((x - y).abs() < 1e-12, "{x} {y}");
            }
        }
    }

    #[test]
    fn epsilons_that_are_none_are_refused() {
        let plane = Plane::across(DVec3::X).unwrap();
        for bad in [0.0, -1.0, 2.0, f64::NAN, 1e-300] {
            assert_eq!(epsilon_projection(&maps("fern"), &plane, bad), Err(ProjectError::Epsilon));
        }
        assert!(epsilon_projection(&maps("fern"), &plane, 1e-100).unwrap().largest.is_finite());
    }
}
