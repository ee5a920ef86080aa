//! Parallel projection.

use glam::{DMat2, DMat3, DVec2, DVec3};
use thiserror::Error;

use crate::linear::affine::Affine2;
use crate::linear::affine::Affine3;

/// A plane to project on, along its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// What goes to the right in the picture: a unit vector.
    pub right: DVec3,
    /// What goes up in it: a unit vector at a right angle to `right`.
    pub up: DVec3,
}

/// Why a projection cannot be made.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ProjectError {
    /// The direction is zero or not finite.
    #[error("The direction to look along must be three finite numbers that are not all 0.")]
    Direction,
    /// Some map turns the direction, so that the shadow is no attractor of maps of the plane.
    #[error(
        "Map {} turns the direction of view, so that points of one shadow part after it: the shadow is not the \
         attractor of maps of the plane. Look along a direction that all maps keep, or project the points.",
        .map + 1
    )]
    NotKept {
        /// The first such map, from 0.
        map: usize,
    },
    /// Epsilon is not between 0 and 1, or so small that the entries overflow.
    #[error("Epsilon must be between 1e-100 and 1: the entries grow as 1 / epsilon.")]
    Epsilon,
}

impl ProjectError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Direction => "project-direction",
            Self::NotKept { .. } => "project-not-kept",
            Self::Epsilon => "project-epsilon",
        }
    }
}

impl Plane {
    /// The plane across a direction: z is up in the picture as far as it can be, else y.
    ///
    /// # Errors
    /// [`ProjectError::Direction`] for a direction that is none.
    pub fn across(direction: DVec3) -> Result<Self, ProjectError> {
        let unit = (direction / direction.abs().max_element()).normalize();
        if !unit.is_finite() {
            return Err(ProjectError::Direction);
        }
        let upward = if unit.z.abs() > 1.0 - 1e-12 { DVec3::Y } else { DVec3::Z };
        let right = unit.cross(upward).normalize();
        Ok(Self { right, up: right.cross(unit) })
    }

    /// The direction that is looked along, away from the eye: a unit vector.
    #[must_use]
    pub fn direction(&self) -> DVec3 {
        self.up.cross(self.right)
    }

    /// The shadow of a point.
    #[must_use]
    pub fn shadow(&self, point: DVec3) -> DVec2 {
        DVec2::new(self.right.dot(point), self.up.dot(point))
    }

    /// The shadows of points `x0, y0, z0, x1, ..`, as `x0, y0, x1, ..`.
    #[must_use]
    pub fn shadows(&self, positions: &[f32]) -> Vec<f32> {
        let (right, up) = (self.right.as_vec3(), self.up.as_vec3());
        let (points, _) = positions.as_chunks::<3>();
        points.iter().map(|&p| glam::Vec3::from_array(p)).flat_map(|p| [right.dot(p), up.dot(p)]).collect()
    }
}

/// How far a direction may be turned and still be called kept, in radians.
const KEPT_ANGLE: f64 = 1e-9;

/// The maps of the plane whose attractor is the shadow of that of `maps`, exactly, where the direction of view is kept
/// by every map: points of one shadow then go to points of one shadow, and the shadow of the image is the image of the
/// shadow.
///
/// # Errors
/// [`ProjectError::NotKept`] where some map turns the direction. A map that takes the direction to 0 keeps it.
pub fn exact_projection(maps: &[Affine3], plane: &Plane) -> Result<Vec<Affine2>, ProjectError> {
    let along = plane.direction();
    let shadow = |(map, affine): (usize, &Affine3)| {
        let image = affine.linear * along;
        if plane.shadow(image).length() > KEPT_ANGLE * affine.norm() {
            return Err(ProjectError::NotKept { map });
        }
        let linear = DMat2::from_cols(
            plane.shadow(affine.linear * plane.right),
            plane.shadow(affine.linear * plane.up),
        );
        Ok(Affine2::new(linear, plane.shadow(affine.translation)))
    };
    maps.iter().enumerate().map(shadow).collect()
}

/// Directions, unit vectors, that every map keeps: one for each, or, where all directions of a plane or of space
/// are kept, two or three that span them. Empty where there are none.
#[must_use]
pub fn invariant_directions(maps: &[Affine3]) -> Vec<DVec3> {
    // Spaces of directions that all maps so far keep, each scaled by one factor of each map.
    let mut kept = vec![DVec3::AXES.to_vec()];
    for map in maps {
        let factors = eigenvalues(map.linear);
        let mut next: Vec<Vec<DVec3>> = Vec::new();
        for space in &kept {
            for &factor in &factors {
                let found =
                    common(map.linear - DMat3::from_diagonal(DVec3::splat(factor)), map.norm(), space);
                let new = !found.is_empty() && !next.iter().any(|other| spans(other, &found));
                if new {
                    next.push(found);
                }
            }
        }
        kept = next;
    }
    let mut all: Vec<DVec3> = Vec::new();
    for direction in kept.into_iter().flatten() {
        if all.iter().all(|other| other.dot(direction).abs() < 1.0 - 1e-9) {
            all.push(direction);
        }
    }
    all
}

/// Whether all of `found` lies in the span of `space`.
fn spans(space: &[DVec3], found: &[DVec3]) -> bool {
    found.iter().all(|&v| space.iter().fold(v, |rest, &axis| rest - axis * axis.dot(rest)).length() < 1e-7)
}

/// An orthonormal basis of what a matrix takes to 0 within the span of `space`.
fn common(m: DMat3, size: f64, space: &[DVec3]) -> Vec<DVec3> {
    let size = size.max(f64::MIN_POSITIVE);
    let mut rows = vec![m.row(0) / size, m.row(1) / size, m.row(2) / size];
    rows.extend(DVec3::AXES.map(|e| space.iter().fold(e, |rest, &axis| rest - axis * axis.dot(e))));
    // What is at a right angle to all rows: take away the largest row again and again.
    let mut out: Vec<DVec3> = Vec::new();
    for _ in 0..3 {
        let rest = |row: &DVec3| out.iter().fold(*row, |rest, &axis: &DVec3| rest - axis * axis.dot(rest));
        let largest =
            rows.iter().map(rest).max_by(|a, b| a.length().total_cmp(&b.length())).unwrap_or(DVec3::ZERO);
        if largest.length() < 1e-8 {
            break;
        }
        out.push(largest.normalize());
    }
    match out[..] {
        [] => DVec3::AXES.to_vec(),
        [a] => {
            let b = a.any_orthonormal_vector();
            vec![b, a.cross(b)]
        }
        [a, b] => vec![a.cross(b).normalize()],
        _ => Vec::new(),
    }
}

/// Numbers among which are the real eigenvalues: the roots of the characteristic polynomial and, since a double root of
/// it is seen sharply only there, those of its derivatives.
fn eigenvalues(m: DMat3) -> Vec<f64> {
    let trace = m.x_axis.x + m.y_axis.y + m.z_axis.z;
    let minors = m.x_axis.x * m.y_axis.y - m.x_axis.y * m.y_axis.x + m.x_axis.x * m.z_axis.z
        - m.x_axis.z * m.z_axis.x
        + m.y_axis.y * m.z_axis.z
        - m.y_axis.z * m.z_axis.y;
    let determinant = m.determinant();
    let value = |x: f64| ((x - trace) * x + minors) * x - determinant;
    let middle = trace / 3.0;
    let root = (middle * middle - minors / 3.0).max(0.0).sqrt();
    let turns = [middle - root, middle + root];
    let far = 2.0 * (1.0 + m.to_cols_array().iter().fold(0.0_f64, |most, x| most.max(x.abs())) * 3.0);
    let mut found = vec![middle, turns[0], turns[1]];
    for (low, high) in [(-far, turns[0]), (turns[0], turns[1]), (turns[1], far)] {
        if value(low) * value(high) <= 0.0 {
            found.push(between(low, high, value));
        }
    }
    // Newton's steps sharpen a single root to the last digit.
    for x in &mut found[3..] {
        for _ in 0..3 {
            let slope = (3.0 * *x - 2.0 * trace) * *x + minors;
            let next = *x - value(*x) / slope;
            if next.is_finite() && (next - *x).abs() < 1e-6 {
                *x = next;
            }
        }
    }
    found
}

/// A root between two numbers where a function has different signs, by halving.
fn between(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    let rising = value(high) > value(low);
    for _ in 0..100 {
        let middle = f64::midpoint(low, high);
        if (value(middle) > 0.0) == rising { high = middle } else { low = middle }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moving_and_projecting_may_change_places() {
        let turn = Affine3::rotation(DVec3::Z, 0.7).unwrap();
        let flat = Affine3::new(
            turn.linear * DMat3::from_diagonal(DVec3::new(0.5, 0.5, 0.3)),
            DVec3::new(1.0, 2.0, 3.0),
        );
        let plane = Plane::across(DVec3::NEG_Z).unwrap();
        let shadow = exact_projection(&[flat], &plane).unwrap()[0];
        for point in [DVec3::ONE, DVec3::new(0.3, -2.0, 9.0)] {
            assert!(shadow.apply(plane.shadow(point)).distance(plane.shadow(flat.apply(point))) < 1e-14);
        }
    }

    #[test]
    fn planes_are_orthonormal_and_right_handed() {
        for direction in
            [DVec3::X, DVec3::NEG_Z, DVec3::new(1e-200, 2e-200, 0.0), DVec3::new(1.0, -4.0, 2.0), DVec3::MAX]
        {
            let Plane { right, up } = Plane::across(direction).unwrap();
            assert!(
                right.dot(up).abs() < 1e-12
                    && (right.length() - 1.0).abs() < 1e-12
                    && (up.length() - 1.0).abs() < 1e-12
            );
            let along = direction / direction.abs().max_element();
            assert!(up.cross(right).dot(along.normalize()) > 1.0 - 1e-12, "{direction}");
        }
        assert_eq!(Plane::across(DVec3::X).unwrap().up, DVec3::Z);
    }

    #[test]
    fn directions_that_are_none_are_refused() {
        for bad in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
            assert_eq!(Plane::across(bad), Err(ProjectError::Direction));
        }
    }

    #[test]
    fn directions_that_are_kept_are_found() {
        // A plane and a line, a line, none.
        let by = |x: f64, y: f64, z: f64| Affine3::scaling(DVec3::new(x, y, z));
        let found = invariant_directions(&[by(0.5, 0.5, 0.3), by(0.2, 0.4, 0.4)]);
        assert_eq!(found.len(), 3);
        let spin = Affine3::rotation(DVec3::new(1.0, 1.0, 0.0), 1.0).unwrap();
        let found = invariant_directions(&[spin, by(0.5, 0.5, 0.5)]);
        assert_eq!(found.len(), 1);
        assert!(found[0].cross(DVec3::new(1.0, 1.0, 0.0)).length() < 1e-9);
        assert!(invariant_directions(&[spin, by(0.5, 0.4, 0.3)]).is_empty());
    }
}
