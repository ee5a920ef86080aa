//! Why an outline is not fitted.

use thiserror::Error;

/// Why an outline is not fitted.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitError {
    /// Not between 12 and 2000.
    #[error("A fit has 12 to 2000 numbers, and {numbers} were asked for. Choose another number.")]
    BadNumbers {
        /// What was asked for.
        numbers: usize,
    },
}

impl FitError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::BadNumbers { .. } => "bad-numbers",
        }
    }
}
