//! Space: its document, its gallery and its links.

mod bend;
mod document;
mod evening;
mod film;
mod intersection_examples;
mod natural;
mod packed;
mod part;
mod preset;

pub use bend::{FARTHEST_MOVE3, MOST_DETAIL3, MOST_ROUGHNESS3, SpaceBend};
pub use document::{
    MAX_KEYS3, MAX_OBJECTS3, PaintName, Repeat, Shape3, Space, SpaceKey, SpaceLight, SpaceMorph, SpaceObject,
    Timeline, natural_objects, natural_space,
};
pub use film::{Film, FilmError, Moment, Moved};
pub use intersection_examples::{IntersectionExample, intersection_examples};
pub use natural::{Thing, natural_scene};
pub use packed::{MAX_PACKED, PackedError, pack, unpack};
pub(crate) use packed::{view_numbers, view_of};
pub use part::{Held, SpacePart, SpaceView};
pub use preset::{Preset3, Row3, preset3, presets3};
