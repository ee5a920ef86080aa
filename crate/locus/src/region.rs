//! What holds for a whole box of parameters at once.

pub(crate) mod certify_path;
pub(crate) mod derivative_bounds;
pub(crate) mod descent;
pub(crate) mod fill;
pub(crate) mod trap;
