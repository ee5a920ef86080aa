//! Space: its gallery, its files, and its shadows in the plane.

mod epsilon;
mod file;
mod meet;
mod natural;
mod preset;
mod project;

pub use epsilon::{EpsilonProjection, epsilon_projection};
pub use file::{FileError, SpaceFile, parse_ifs3, write_ifs3};
pub use meet::{Arrow, Intersection, MeetError, MeetExample, intersection, meet_examples};
pub use natural::{Thing, natural_scene};
pub use preset::{Preset3, Row3, preset3, presets3};
pub use project::{Plane, ProjectError, exact_projection, invariant_directions};
