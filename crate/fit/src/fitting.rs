//! Fits of closed curves to outlines.
//!
//! What takes long is in functions of their own, which no other function may take in (`inline(never)`), here as in
//! `segment`: browsers optimise whole functions while the first fit waits for them, and small ones sooner.

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
