//! What a document says of fitting.

use frond_fit::{FractalFunction, FunctionError};
use serde::{Deserialize, Serialize};

use crate::curve::CurveShape;

/// The most pieces of a graph.
pub const MAX_PIECES: usize = 256;
/// How many numbers a fit may spend.
pub const NUMBERS: std::ops::RangeInclusive<u32> = 12..=2000;

/// What is fitted.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FitMode {
    /// A closed outline.
    #[default]
    Outline,
    /// The graph of a function.
    Graph,
}

/// What an outline is fitted by.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FitModel {
    /// Frond's closed curve.
    #[default]
    Closed,
    /// The fit of Cochran, Hart & Flynn.
    Collage,
}

/// What a graph is made of.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum GraphKind {
    /// Copies of all of it.
    #[default]
    Fif,
    /// Copies of what lies between knots.
    Rfif,
    /// Copies of any parts.
    Pfif,
}

/// A part of a graph.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct GraphPiece {
    /// a, b, c, d, e of t' = a t + d, x' = b t + c x + e (Cochran, Hart & Flynn, eq 1).
    pub map: [f64; 5],
    /// What it copies: from, to.
    pub domain: [f64; 2],
}

/// A fractal function.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Graph {
    /// What people take it for. Its pieces say all.
    pub kind: GraphKind,
    /// From left to right.
    pub pieces: Vec<GraphPiece>,
}

impl Graph {
    /// The function.
    ///
    /// # Errors
    /// Where it is none: see [`FractalFunction::pfif`].
    pub fn function(&self) -> Result<FractalFunction, FunctionError> {
        let maps: Vec<_> = self.pieces.iter().map(|piece| (piece.map, piece.domain)).collect();
        FractalFunction::pfif(&maps)
    }
}

/// How an outline or a graph was fitted last. What was fitted is not part of a document.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Fit {
    /// What is fitted.
    pub mode: FitMode,
    /// What an outline is fitted by.
    pub model: FitModel,
    /// How many numbers the closed curve may spend: within [`NUMBERS`].
    pub numbers: u32,
    /// How much an outline is smoothed first: 0 to 1.
    pub smoothing: f64,
    /// The last fit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<CurveShape>,
    /// The last graph.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub graph: Option<Graph>,
}

impl Default for Fit {
    fn default() -> Self {
        Self {
            mode: FitMode::Outline,
            model: FitModel::Closed,
            numbers: 260,
            smoothing: 0.0,
            curve: None,
            graph: None,
        }
    }
}
