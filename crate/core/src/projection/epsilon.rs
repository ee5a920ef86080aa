//! The paper's projection: a scale that goes to 0.

use glam::{DMat3, DVec3};

use crate::linear::affine::Affine3;
use crate::projection::parallel::{Plane, ProjectError};

/// In which axes the maps of a flattened shape are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EpsilonFrame {
    /// Those of the picture: x to the right, y up, z along the view, away from the eye. These axes are left-handed, so
    /// that the maps are those of a mirror image: along z, of the shape mirrored in x.
    #[default]
    Picture,
    /// Those of the shape, as in the paper: the shape stays where it is and becomes thin along the direction. Along z
    /// the scale is `diag(1, 1, epsilon)`.
    Space,
}

/// A shape flattened by epsilon along the direction of view (Darwish & Abd-El-Wahab, section 3.5).
#[derive(Clone, Debug, PartialEq)]
pub struct EpsilonProjection {
    /// The maps in the axes of the frame.
    pub maps: Vec<Affine3>,
    /// The largest entry of all matrices.
    pub largest: f64,
    /// The entries that grow as 1 / epsilon: the map, and the row and the column of its matrix. In the axes of the
    /// picture, and along z in those of space, they stand in rows 0 and 1 of column 2.
    pub diverging: Vec<[usize; 3]>,
}

/// Conjugates maps by a scale of epsilon along the direction of view.
///
/// In axes of which z is that direction the scale is `diag(1, 1, epsilon)`. The third row of each matrix is multiplied
/// by epsilon and the third column divided by it, so that c and f become c / epsilon and f / epsilon: the attractor
/// goes to its shadow, but where some c or f is not 0 its maps go nowhere. Only where the direction of view is kept do
/// they have a limit: that of [`exact_projection`](crate::exact_projection).
///
/// # Errors
/// [`ProjectError::Epsilon`] unless epsilon is between 1e-100 and 1.
pub fn epsilon_projection(
    maps: &[Affine3],
    plane: &Plane,
    epsilon: f64,
    frame: EpsilonFrame,
) -> Result<EpsilonProjection, ProjectError> {
    if !(1e-100..=1.0).contains(&epsilon) {
        return Err(ProjectError::Epsilon);
    }
    let from = DMat3::from_cols(plane.right, plane.up, plane.direction());
    let mut largest = 0.0_f64;
    let mut diverging = Vec::new();
    let mut flattened = Vec::with_capacity(maps.len());
    for (k, map) in maps.iter().enumerate() {
        let mut linear = from.transpose() * map.linear * from;
        let mut translation = from.transpose() * map.translation;
        // What is 0 but for the rounding of the coordinates must not be blown up.
        let rounding = 1e-14 * map.norm();
        for row in 0..2 {
            if linear.z_axis[row].abs() <= rounding {
                linear.z_axis[row] = 0.0;
            }
        }
        // The part of the matrix that is divided by epsilon, in the axes of the frame.
        let mut growing = DMat3::from_cols(DVec3::ZERO, DVec3::ZERO, linear.z_axis.with_z(0.0));
        linear.z_axis *= DVec3::new(1.0 / epsilon, 1.0 / epsilon, 1.0);
        for column in [0, 1] {
            linear.col_mut(column).z *= epsilon;
        }
        translation.z *= epsilon;
        if frame == EpsilonFrame::Space {
            let back = |matrix: DMat3| from * matrix * from.transpose();
            (linear, translation, growing) = (back(linear), from * translation, back(growing));
        }
        for row in 0..3 {
            for column in 0..3 {
                if growing.col(column)[row].abs() > rounding {
                    diverging.push([k, row, column]);
                }
            }
        }
        largest = linear.to_cols_array().iter().fold(largest, |most, x| most.max(x.abs()));
        flattened.push(Affine3::new(linear, translation));
    }
    Ok(EpsilonProjection { maps: flattened, largest, diverging })
}
