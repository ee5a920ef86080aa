//! Systems of space: the twins of those of the plane, and how they move.
//!
//! What is said of [`Ifs`](crate::Ifs) holds for [`Ifs3`]: a point has one coordinate more, an ellipsoid takes the place
//! of an ellipse, a unit quaternion that of an angle.

mod bounds;
mod chaos;
mod contraction;
mod cut;
mod dimension;
mod fan;
mod ifs;
mod morph;
mod motion;
mod place;
mod pose;
mod spline;
#[cfg(test)]
mod testing;

pub use bounds::Bounds3;
pub use chaos::ChaosGame3;
pub use contraction::Contraction3;
pub use cut::{adaptive_cut3, word_map3};
pub use dimension::{BoxCount, affinity_dimension3, box_dimension, similarity_dimension3};
pub use fan::Fan3;
pub use ifs::Ifs3;
pub use morph::{Morph3, Turn3};
pub use motion::{Course, Ease, Key3, Motion3, MotionError};
pub use place::Place3;
pub use pose::{Conjugate, Pose};
