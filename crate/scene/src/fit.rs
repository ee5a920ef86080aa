//! What a document says of fitting.

use frond_fit::{FractalFunction, FunctionError, LEAST_BYTES, MOST_BYTES, Spline, SplineError};
use serde::{Deserialize, Serialize};

use crate::curve::CurveShape;

/// The most pieces of a graph.
pub const MAX_PIECES: usize = 256;
/// How many numbers a fit may spend.
pub const NUMBERS: std::ops::RangeInclusive<u32> = 12..=2000;

/// How many bytes a spline may take.
pub const BYTES: std::ops::RangeInclusive<u32> = LEAST_BYTES as u32..=MOST_BYTES as u32;
/// How many it may take where a document says nothing.
pub const USUAL_BYTES: u32 = 150;

/// The most letters of a spline's word: four for three bytes.
const MOST_LETTERS: usize = (4 * MOST_BYTES).div_ceil(3);

/// What is fitted.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FitMode {
    /// A closed outline.
    #[default]
    Outline,
    /// The graph of a function.
    Graph,
    /// A curve of the plane.
    Plane,
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
    /// Corners and parabolas, within so many bytes.
    Spline,
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

/// A curve of corners and parabolas.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SplineShape {
    /// Its name.
    pub name: String,
    /// It packed, in letters: [`Spline::to_text`].
    pub word: String,
}

impl SplineShape {
    /// Whether its word has the letters, and is of the length, that words of splines may have.
    #[must_use]
    pub fn is_word(&self) -> bool {
        is_spline_word(&self.word)
    }

    /// The curve.
    ///
    /// # Errors
    /// Where the word is none.
    pub fn spline(&self) -> Result<Spline, SplineError> {
        Spline::from_text(&self.word)
    }
}

/// Whether a word has the letters, and is of the length, that words of splines may have.
#[must_use]
pub fn is_spline_word(word: &str) -> bool {
    let fair = |letter: u8| letter.is_ascii_alphanumeric() || letter == b'-' || letter == b'_';
    (2..=MOST_LETTERS).contains(&word.len()) && word.bytes().all(fair)
}

/// The longest word of a curve of the plane: 256 pieces of numbers with all their digits.
const MOST_PLANE: usize = 40_000;

/// Whether a word may be a curve of the plane: t, x, y of each point, and of each piece the rows of its factor and from
/// which point to which it copies (from 0, backwards where the first is the larger), `0,0,0;..:0.5,0,0,0.5,0,2;..`
/// (Cochran, Hart & Flynn, eq 9).
#[must_use]
pub fn is_plane_word(word: &str) -> bool {
    let fair = |letter: u8| letter.is_ascii_digit() || b",;:.-e".contains(&letter);
    (1..=MOST_PLANE).contains(&word.len()) && word.bytes().all(fair)
}

const fn usual_bytes() -> u32 {
    USUAL_BYTES
}

// Serde hands it over so.
#[allow(clippy::trivially_copy_pass_by_ref)]
const fn is_usual(bytes: &u32) -> bool {
    *bytes == USUAL_BYTES
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
    /// How many bytes a spline may take: within [`BYTES`].
    #[serde(default = "usual_bytes", skip_serializing_if = "is_usual")]
    pub bytes: u32,
    /// How much an outline is smoothed first: 0 to 1.
    pub smoothing: f64,
    /// The last fit by a closed curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<CurveShape>,
    /// The last fit by a spline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spline: Option<SplineShape>,
    /// The last graph.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub graph: Option<Graph>,
    /// The last curve of the plane, in numbers: see [`is_plane_word`]. Whether it is one is left to those who draw it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plane: Option<String>,
}

impl Default for Fit {
    fn default() -> Self {
        Self {
            mode: FitMode::Outline,
            model: FitModel::Closed,
            numbers: 260,
            bytes: USUAL_BYTES,
            smoothing: 0.0,
            curve: None,
            spline: None,
            graph: None,
            plane: None,
        }
    }
}
