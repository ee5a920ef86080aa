//! The document: two shapes, the way between them and how they are looked at; and its form as a link.
//!
//! [`Scene`] is what a person works on. [`encode`] writes it as the fragment of a URL, [`decode`] reads it
//! back and never fails: what is damaged opens as the default, with a reason. [`presets`] is the gallery.

mod curve;
mod deformation;
mod fit;
mod link;
mod preset;
mod scene;
mod space;

pub use curve::{Curve, CurveEdge, CurveShape, Curves};
pub use deformation::{
    ContinuityName, Deformation, Key, MAX_KEYS, MAX_SIDE, RoughnessValue, SpinName, Subject, Tint, Tool,
};
pub use fit::{Fit, FitMode, FitModel, Graph, GraphKind, GraphPiece, MAX_PIECES, NUMBERS};
pub use link::{LinkError, MAX_LINK, VERSION, decode, encode};
pub use preset::{Preset, Row, preset, presets};
pub use scene::{
    Colouring, FamilyName, LocusView, MAX_WAY_POINTS, ModeName, Path, PathKind, Scene, Shape, WayPoint,
    Window,
};
pub use space::{
    Arrow, EpsilonProjection, FileError, Intersection, MeetError, MeetExample, Plane, Preset3, ProjectError,
    Row3, SpaceFile, Thing, epsilon_projection, exact_projection, intersection, invariant_directions,
    meet_examples, natural_scene, parse_ifs3, preset3, presets3, write_ifs3,
};
