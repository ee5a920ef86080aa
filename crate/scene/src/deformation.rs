//! What a document says of bending.

use frond_deform::{Continuity, Roughness, Spin};
use serde::{Deserialize, Serialize};

/// The most control points along a side of the mesh.
pub const MAX_SIDE: usize = 16;
/// The most key frames.
pub const MAX_KEYS: usize = 32;

/// What is bent.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Subject {
    /// The shape of the studio.
    #[default]
    Shape,
    /// A picture on the unit square. The picture itself is not part of a document.
    Picture,
}

/// A colour function: sRGB colours "#rrggbb", one a control point, shuffled on its own.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Tint {
    /// One a control point.
    pub colours: Vec<String>,
    /// Its locality.
    pub kb: f64,
    /// Its detail.
    pub ke: f64,
    /// Its roughness.
    pub delta: f64,
    /// Whether all terms are summed.
    pub superposed: bool,
}

/// The mesh at one moment.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Key {
    /// 0 to 1.
    pub at: f64,
    /// dx, dy of each control point, row by row from the lower left.
    pub moves: Vec<f64>,
}

/// A fractal deformation with its key frames.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Deformation {
    /// Whether the morph shows it, too.
    pub on: bool,
    /// What is bent.
    pub subject: Subject,
    /// Parts each way of the square of a picture: 2 or 3.
    pub parts: u32,
    /// Control points across, 2 to 16.
    pub columns: usize,
    /// Control points up, 2 to 16.
    pub rows: usize,
    /// The mesh at rest: min x, min y, max x, max y.
    #[serde(rename = "box")]
    pub bounds: [f64; 4],
    /// 1 to 32, in order.
    pub keys: Vec<Key>,
    /// The moment, 0 to 1.
    pub phase: f64,
    /// How long once through takes, 0.5 to 60.
    pub seconds: f64,
    /// Whether the last key goes on to the first.
    #[serde(rename = "loop")]
    pub looped: bool,
    /// The locality.
    pub kb: f64,
    /// The detail.
    pub ke: f64,
    /// The roughness.
    pub delta: Roughness,
    /// How displacements turn.
    pub spin: Spin,
    /// What keeps pieces together.
    pub continuity: Continuity,
    /// Whether all terms are summed.
    pub superposed: bool,
    /// Colours that are carried along.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tint: Option<Tint>,
}

impl Deformation {
    /// A mesh of four by four at rest over a box.
    #[must_use]
    pub fn at_rest(bounds: [f64; 4]) -> Self {
        Self {
            on: true,
            subject: Subject::Shape,
            parts: 2,
            columns: 4,
            rows: 4,
            bounds,
            keys: vec![Key { at: 0.0, moves: vec![0.0; 32] }],
            phase: 0.0,
            seconds: 4.0,
            looped: true,
            kb: 0.0,
            ke: 9.0,
            delta: Roughness::Constant(0.75),
            spin: Spin::None,
            continuity: Continuity::Auto,
            superposed: true,
            tint: None,
        }
    }
}
