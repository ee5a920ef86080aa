//! Closed curves and graphs that are made of smaller copies of their own parts.

mod closed_curve;
mod file;
mod graph;
mod morph;
mod plane_graph;
mod read;
mod spline;

pub use {closed_curve::*, file::*, graph::*, morph::*, plane_graph::*, spline::*};
