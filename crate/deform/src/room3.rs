//! What a shape of space has room for.

use frond_core::{Bounds3, Ifs3};
use glam::DVec3;

use crate::bend3::DEEPEST_RAW;
use crate::continuity::corners3::Corners3;
use crate::continuity::lattice3::Lattice3;

/// How a shape can be bent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room3 {
    /// The least coordinates of a box around the shape, over which a mesh is laid.
    pub min: DVec3,
    /// The largest.
    pub max: DVec3,
    /// Whether its pieces meet in corners, so that nothing tears.
    pub continuous: bool,
    /// The greatest detail that memory allows.
    pub deepest: usize,
}

/// A box is at least this part as deep as it is long.
const LEAST_SIDE: f64 = 0.05;

impl Room3 {
    /// Of the attractor of a system. The box of a flat shape has a volume all the same.
    #[must_use]
    pub fn of(ifs: &Ifs3) -> Self {
        let corners = Corners3::find(ifs.maps());
        let (min, max) = match &corners {
            Some(corners) => {
                let points = corners.points().iter().copied();
                (
                    points.clone().fold(DVec3::INFINITY, DVec3::min),
                    points.fold(DVec3::NEG_INFINITY, DVec3::max),
                )
            }
            None => {
                let Bounds3 { min, max, .. } = Bounds3::of(ifs);
                (min, max)
            }
        };
        let longest = (max - min).max_element();
        // A point has a box as well.
        let least =
            if longest > 0.0 { LEAST_SIDE * longest } else { 1e-3 * min.abs().max_element().max(1.0) };
        let middle = 0.5 * (min + max);
        let half = 0.5 * (max - min).max(DVec3::splat(least));
        let deepest = corners.as_ref().map_or(DEEPEST_RAW, |corners| Lattice3::deepest(ifs.len(), corners));
        Self { min: middle - half, max: middle + half, continuous: corners.is_some(), deepest }
    }

    /// Its longest side, in units of space.
    #[must_use]
    pub fn size(&self) -> f64 {
        (self.max - self.min).max_element()
    }
}

#[cfg(test)]
mod tests {
    use frond_core::Affine3;

    use super::*;
    use crate::testing::{gasket3, grid3};

    #[test]
    fn boxes_are_those_of_the_corners_or_of_the_shape_and_never_flat() {
        let of = |maps: Vec<Affine3>| Room3::of(&Ifs3::new(maps).unwrap());
        let gasket = of(gasket3(0.5));
        assert!(gasket.continuous && gasket.deepest == 9);
        assert_eq!((gasket.min, gasket.max), (DVec3::ZERO, DVec3::ONE));
        assert_eq!(
            of(grid3(3, |[x, y, z]| u8::from(x == 1) + u8::from(y == 1) + u8::from(z == 1) < 2)).deepest,
            4
        );
        let overlapping = of(gasket3(0.55));
        assert!(!overlapping.continuous && (overlapping.max - DVec3::ONE).abs().max_element() < 0.02);
        let flat = of(gasket3(0.5)[..3].to_vec());
        assert!(!flat.continuous && (flat.max - flat.min).min_element() > 0.04, "{flat:?}");
        let point = of(vec![Affine3::scaling(DVec3::ZERO)]);
        assert!((point.max - point.min).min_element() > 0.0);
    }
}
