//! The document: two shapes, the way between them and how they are looked at; and its form as a link.
//!
//! [`Scene`] is what a person works on. [`encode`] writes it as the fragment of a URL, [`decode`] reads it
//! back and never fails: what is damaged opens as the default, with a reason. [`presets`] is the gallery.
//!
//! # The order in which to read it
//!
//! 1. `scene`: the document, and `preset`, the gallery of shapes it begins with.
//!    `directed` has a gallery of shapes of several states, too.
//! 2. `deformation`, `curve`, `directed`, `fit` and `space/`: what the tools keep in it. `space/` has a gallery
//!    ([`presets3`]) and key frames ([`Film`]) of its own.
//! 3. `link`: how each part is written and read, and that old links stay what they were.
//!
//! A link is a promise: what this crate writes today opens for ever. `tests/links.txt` holds links of every version.

mod curve;
mod deformation;
mod directed;
mod fit;
mod link;
mod preset;
mod scene;
mod space;

pub use curve::{Curve, CurveEdge, CurveShape, Curves};
pub use deformation::{Deformation, Key, MAX_KEYS, MAX_SIDE, Subject, Tint};
pub use directed::{Directed, DirectedCopy, DirectedPreset, DirectedShape, OutlineError, directed_presets};
pub use fit::{
    BYTES, Fit, FitMode, FitModel, Graph, GraphKind, GraphPiece, MAX_PIECES, NUMBERS, SplineShape,
    USUAL_BYTES, is_plane_word,
};
pub use link::{LinkError, MAX_LINK, VERSION, decode, decode_morph, encode};
pub use preset::{Preset, Row, preset, presets};
pub use scene::{
    FamilyName, LocusView, MAX_WAY_POINTS, Path, PathKind, Scene, Shape, Tool, WayPoint, Window,
};
pub use space::{
    FARTHEST_MOVE3, Film, FilmError, Held, IntersectionExample, MAX_KEYS3, MAX_OBJECTS3, MAX_PACKED,
    MOST_DETAIL3, MOST_ROUGHNESS3, Moment, Moved, PackedError, PaintName, Preset3, Repeat, Row3, Shape3,
    Space, SpaceBend, SpaceKey, SpaceLight, SpaceMorph, SpaceObject, SpacePart, SpaceView, Thing, Timeline,
    intersection_examples, natural_objects, natural_scene, natural_space, pack, preset3, presets3, unpack,
};
