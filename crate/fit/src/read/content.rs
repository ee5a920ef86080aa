//! What was in a file.

use glam::DVec2;

use super::problem::Remark;
use crate::outline::Outline;

/// An outline in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedOutline {
    /// As the file calls it, or what it was there.
    pub name: String,
    /// With y up; at most [`MAX_OUTLINE`](crate::MAX_OUTLINE) points.
    pub outline: Outline,
    /// How often it crosses itself, up to 100; None where that was too much to find out.
    pub crossings: Option<usize>,
}

/// What was in a file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileContent {
    /// Outlines, the largest first; never none.
    Outlines {
        /// `svg`, `csv` (tables, and TPS) or `geojson` (JSON of all kinds).
        format: &'static str,
        /// At most 100.
        outlines: Vec<NamedOutline>,
        /// What is to be said of it.
        remarks: Vec<Remark>,
    },
    /// Values x of a function of t: three points (t, x) or more, t growing.
    Series {
        /// At most [`MAX_OUTLINE`](crate::MAX_OUTLINE).
        points: Vec<DVec2>,
        /// What is to be said of it.
        remarks: Vec<Remark>,
        /// Whether the same numbers make an outline, too.
        or_outline: bool,
    },
}
