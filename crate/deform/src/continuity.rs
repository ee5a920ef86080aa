//! What keeps the pieces of a shuffled shape together: the shape without a tear, whatever it is made of.

pub mod average;
pub mod cells;
pub mod corners;
pub mod corners3;
pub mod delaunay;
pub mod footing;
pub mod grid;
pub mod lattice;
pub mod lattice3;
pub mod polygon;
pub mod smooth;
pub mod splat;
pub mod support;
