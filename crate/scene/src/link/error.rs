//! Why a link could not be read or written.

use frond_core::{DirectedError, IfsError};
use frond_fit::PackError;
use thiserror::Error;

/// The longest link, in bytes.
pub const MAX_LINK: usize = 64 * 1024;

/// Why a link could not be read, or a document not be written as one. The message says what to do.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum LinkError {
    /// Longer than [`MAX_LINK`].
    #[error(
        "This link has {bytes} bytes, and the most is 65536. It may have been pasted twice: copy it again."
    )]
    TooLong {
        /// Its length in bytes.
        bytes: usize,
    },
    /// A value is not of its form.
    #[error("This link is damaged: “{key}” cannot be {value}. Ask for the link again, or start from here.")]
    Value {
        /// The key.
        key: &'static str,
        /// What is wrong.
        value: String,
    },
    /// A shape of the link has no attractor.
    #[error("Shape {end} of this link cannot be drawn. {source}")]
    Shape {
        /// `A` or `B`.
        end: char,
        /// Why.
        source: IfsError,
    },
    /// A graph-directed shape of the link has no attractor.
    #[error("Shape {end} of this link cannot be drawn. {source}")]
    Directed {
        /// `A` or `B`.
        end: char,
        /// Why.
        source: DirectedError,
    },
    /// A closed curve of a document cannot be written.
    #[error("{which} cannot be kept in a link. {source}")]
    Curve {
        /// Which one.
        which: &'static str,
        /// Why.
        source: PackError,
    },
    /// What a document holds, or a link says, takes more than [`MAX_LINK`] to write.
    #[error(
        "This takes {bytes} bytes as a link, and the most is 65536. Remove waypoints, maps, keys or knots of curves."
    )]
    TooLarge {
        /// The length of its link, in bytes.
        bytes: usize,
    },
    /// A value of a document is one that no link may have.
    #[error("This cannot be kept in a link: “{key}” cannot be {value}. Set it anew.")]
    Unfit {
        /// The key.
        key: &'static str,
        /// What is wrong.
        value: String,
    },
    /// The link has the version of a later Frond.
    #[error(
        "This link was made by a later version of Frond. What this one understands is shown: reload the page to update it."
    )]
    Later,
}

impl LinkError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooLong { .. } | Self::TooLarge { .. } => "link-too-long",
            Self::Value { .. } => "link-damaged",
            Self::Shape { .. } | Self::Directed { .. } => "link-shape",
            Self::Curve { source, .. } => source.code(),
            Self::Unfit { .. } => "link-unfit",
            Self::Later => "link-later",
        }
    }
}
