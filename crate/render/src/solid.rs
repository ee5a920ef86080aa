//! Pictures of attractors of space, on the processor: complete, for stills and as truth for the graphics card.
//!
//! A [`Camera`] looks at one or more systems. A [`Traversal`] walks down their trees of pieces, the nearest first,
//! passes over what is out of sight or behind what is there already, and leaves a [`DepthBuffer`]: for each pixel how
//! far the nearest piece is, and which. [`light`] makes a picture of it: light from the lie of the surface, shade in
//! its hollows, fog.
//!
//! A graphics card draws [`Cloud`]s of points in the time of a frame, splats them by [`SplatStep`]s, fills what holes
//! are left ([`fill_holes`]) and lights them alike; at rest it is given the complete depth buffer.

mod around;
mod bent;
mod camera;
mod depth_buffer;
mod fine;
mod hole_fill;
mod lamp;
mod lens;
mod objects;
mod points;
mod shade;
mod shadow;
mod shape;
mod splat;
mod tone;
mod traversal;

pub use around::reach_of;
pub use bent::Bent;
pub use camera::{Camera, CameraError};
pub use depth_buffer::DepthBuffer;
pub use hole_fill::fill_holes;
pub use lamp::{Lamp, Lighting, Paint};
pub use objects::Objects;
pub use points::{Cloud, Eye, Instance3, Vertex3};
pub use shade::{light, light_rows};
pub use shadow::{LampView, Shadows, depths_of_lamp};
pub use splat::SplatStep;
pub use traversal::{MAX_OBJECTS, Traversal, depths};
