//! A shape, and what was done to it.

use crate::ifs::ifs2::Ifs;
use crate::ifs::ifs3::Ifs3;
use crate::linear::affine2::Affine2;
use crate::linear::affine3::Affine3;
use crate::linear::transform::TransformError;

/// A system that is moved by moving its parameters.
pub trait Conjugate: Clone {
    /// The transforms that move it.
    type Transform: Copy + PartialEq;

    /// The system of the moved shape (Darwish & Abd-El-Wahab, eq 1).
    ///
    /// # Errors
    /// [`TransformError`] where the transform cannot be undone, or the new numbers are too large.
    fn moved(&self, by: Self::Transform) -> Result<Self, TransformError>;

    /// First `inner`, then `outer`.
    fn after(outer: Self::Transform, inner: Self::Transform) -> Self::Transform;

    /// The transform that leaves all where it is.
    const STAY: Self::Transform;
}

impl Conjugate for Ifs {
    type Transform = Affine2;
    const STAY: Affine2 = Affine2::IDENTITY;

    fn moved(&self, by: Affine2) -> Result<Self, TransformError> {
        let back = by.undo()?;
        let ifs = Self::new(self.maps().iter().map(|&map| by * map * back).collect())?;
        Ok(ifs.with_probabilities(self.probabilities())?)
    }

    fn after(outer: Affine2, inner: Affine2) -> Affine2 {
        outer * inner
    }
}

impl Conjugate for Ifs3 {
    type Transform = Affine3;
    const STAY: Affine3 = Affine3::IDENTITY;

    fn moved(&self, by: Affine3) -> Result<Self, TransformError> {
        self.conjugate(by)
    }

    fn after(outer: Affine3, inner: Affine3) -> Affine3 {
        outer * inner
    }
}

/// A shape, the transforms that were done to it, and the parameters that came of them.
///
/// The parameters are always those of the shape as it was made, conjugated once by the product of all transforms: rounding
/// does not add up while a hand turns the shape for an hour, and what is taken back is back to the last bit, however
/// little the transform was an exact one.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose<S: Conjugate> {
    made: S,
    steps: Vec<S::Transform>,
    now: S,
}

/// More steps than this are drawn together, the oldest first.
const MOST: usize = 10_000;

impl<S: Conjugate> Pose<S> {
    /// A shape to which nothing was done yet.
    #[must_use]
    pub fn new(made: S) -> Self {
        Self { now: made.clone(), made, steps: Vec::new() }
    }

    /// The shape as it was made.
    #[must_use]
    pub const fn made(&self) -> &S {
        &self.made
    }

    /// The parameters as they are now.
    #[must_use]
    pub const fn now(&self) -> &S {
        &self.now
    }

    /// The transforms since, the first one first.
    #[must_use]
    pub fn steps(&self) -> &[S::Transform] {
        &self.steps
    }

    /// All transforms in one.
    #[must_use]
    pub fn transform(&self) -> S::Transform {
        self.steps.iter().fold(S::STAY, |so_far, &step| S::after(step, so_far))
    }

    /// Moves the shape.
    ///
    /// # Errors
    /// [`TransformError`] where the transform, or all of them in one, cannot be undone: the shape stays as it is.
    pub fn apply(&mut self, by: S::Transform) -> Result<(), TransformError> {
        // By itself, too: flat and back is not a way to go.
        self.made.moved(by)?;
        let now = self.made.moved(S::after(by, self.transform()))?;
        self.now = now;
        if self.steps.len() >= MOST {
            let first = S::after(self.steps[1], self.steps[0]);
            self.steps.splice(0..2, [first]);
        }
        self.steps.push(by);
        Ok(())
    }

    /// Takes the last transform back, exactly; `None` if there is none.
    pub fn undo(&mut self) -> Option<S::Transform> {
        let last = self.steps.pop()?;
        if let Ok(now) =
            if self.steps.is_empty() { Ok(self.made.clone()) } else { self.made.moved(self.transform()) }
        {
            self.now = now;
        }
        Some(last)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec2, DVec3};

    use super::*;

    fn pyramid() -> Ifs3 {
        let corners =
            [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [0.0, 0.0, 1.3]];
        let map = |c: [f64; 3]| Affine3::similitude(0.5, DQuat::IDENTITY, DVec3::from_array(c) * 0.5);
        Ifs3::new(corners.map(map).to_vec()).unwrap()
    }

    #[test]
    fn what_is_taken_back_is_back_to_the_last_bit() {
        let mut pose = Pose::new(pyramid());
        let turn = Affine3::rotation(DVec3::new(1.0, 2.0, 0.5), 0.7).unwrap();
        let shear = Affine3::shear([0.3, 0.0, 0.1, 0.0, 0.0, 0.2]);
        pose.apply(turn).unwrap();
        let turned = pose.now().clone();
        pose.apply(shear).unwrap();
        pose.apply(Affine3::scaling(DVec3::new(1e-3, 7.0, 1.0))).unwrap();
        assert_eq!(pose.undo(), Some(Affine3::scaling(DVec3::new(1e-3, 7.0, 1.0))));
        assert_eq!(pose.undo(), Some(shear));
        assert_eq!(pose.now(), &turned);
        pose.undo();
        assert_eq!(pose.undo(), None);
        assert_eq!(pose.now(), &pyramid());
    }

    #[test]
    fn rounding_does_not_add_up() {
        let mut pose = Pose::new(pyramid());
        let turn = Affine3::rotation(DVec3::new(1.0, 2.0, 0.5), std::f64::consts::TAU / 1000.0).unwrap();
        for _ in 0..1000 {
            pose.apply(turn).unwrap();
        }
        for (map, made) in pose.now().maps().iter().zip(pose.made().maps()) {
            for (x, y) in map.to_row().iter().zip(made.to_row()) {
                assert!((x - y).abs() < 1e-12, "{x} {y}");
            }
        }
    }

    #[test]
    fn what_cannot_be_done_leaves_the_shape_as_it_is() {
        let mut pose = Pose::new(pyramid());
        pose.apply(Affine3::moving(DVec3::new(15.0, 0.0, 0.0))).unwrap();
        let before = pose.clone();
        assert_eq!(pose.apply(Affine3::scaling(DVec3::new(1.0, 0.0, 1.0))), Err(TransformError::Singular));
        // One by one they can be undone, all in one they cannot be drawn.
        for _ in 0..3 {
            let _ = pose.apply(Affine3::scaling(DVec3::splat(1e-90)));
        }
        assert_eq!(pose.steps().len(), 2);
        pose.undo();
        assert_eq!(pose, before);
    }

    #[test]
    fn the_plane_has_the_same() {
        let maps =
            [[0.0, 0.0], [1.0, 0.0], [0.3, 1.0]].map(|t| Affine2::similitude(0.5, 0.3, DVec2::from_array(t)));
        let gasket = Ifs::new(maps.to_vec()).unwrap().with_probabilities(&[0.2, 0.3, 0.5]).unwrap();
        let mut pose = Pose::new(gasket.clone());
        pose.apply(Affine2::rotation(0.4)).unwrap();
        pose.apply(Affine2::shear(0.5, 0.0)).unwrap();
        assert_ne!(pose.now().maps(), gasket.maps());
        assert_eq!(pose.now().probabilities(), gasket.probabilities());
        pose.undo();
        pose.undo();
        assert_eq!(pose.now(), &gasket);
        assert!(pose.apply(Affine2::scaling(DVec2::splat(1e-300))).is_err());
    }
}
