//! What holds for a whole box of parameters at once: points of the attractor move smoothly, so that what is seen on the
//! edge of a box by a margin is true inside.

pub(crate) mod certify_path;
pub(crate) mod contacts;
pub(crate) mod derivative_bounds;
pub(crate) mod descent;
pub(crate) mod extent;
pub(crate) mod fill;
pub(crate) mod inner_differences;
pub(crate) mod joining;
pub(crate) mod joint_bound;
pub(crate) mod no_attractor;
pub(crate) mod power_series_box;
pub(crate) mod prove;
pub(crate) mod silhouette;
pub(crate) mod starts;
pub(crate) mod trap;
