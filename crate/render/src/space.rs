//! Pictures of attractors of space, on the processor: complete, for stills and as truth for the graphics card.
//!
//! A [`Camera`] looks at one or more systems. A [`Carve`] walks down their trees of pieces, the nearest first, passes over
//! what is out of sight or behind what is there already, and leaves a [`Relief`]: for each pixel how far the nearest piece
//! is, and which. [`light`] makes a picture of it: light from the lie of the surface, shade in its hollows, fog.

//! A graphics card draws [`Cloud`]s of points in the time of a frame, [`Spread`]s them, [`mend`]s what holes are left and lights them alike; at rest it
//! is given the carved relief.

mod camera;
mod carve;
mod eye;
mod lamp;
mod light;
mod mend;
mod relief;
mod spread;

pub use camera::{Camera, CameraError};
pub use carve::{Carve, MAX_OBJECTS, depths};
pub use eye::{Cloud, Eye, Instance3, Vertex3};
pub use lamp::{Lamp, Lighting, Paint};
pub use light::light;
pub use mend::mend;
pub use relief::Relief;
pub use spread::Spread;
