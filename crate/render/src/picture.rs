//! Pictures: which part of the plane they show, which pixels are lit, and what colour these have.

pub mod bitmap;
pub mod colour;
pub mod resolve;
pub mod tone;
pub mod view;
pub mod window;
