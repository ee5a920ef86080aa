//! Fits of closed curves to outlines.

mod candidates;
mod choice;
mod distances;
mod final_refine;
mod fit_error;
mod fitter;
mod heights;
mod judge;
mod marks;
mod moves;
mod normal;
mod outlook;
mod partition;
mod progress;
mod refine;
mod search;
mod straight;

pub use fit_error::FitError;
pub use fitter::Fitter;
pub use judge::{DRAWING_LEVELS, DRAWING_TOLERANCE};
pub use partition::partition;
pub use progress::{ClosedFit, Progress, Stage};
pub(crate) use straight::Straight;
