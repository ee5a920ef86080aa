//! Points of an attractor: at random, or one for each piece of a size; and what is counted from them.

pub(crate) mod adaptive_cut2;
pub(crate) mod adaptive_cut3;
pub(crate) mod box_dimension;
mod chaos_game;
pub(crate) mod chaos_game2;
pub(crate) mod chaos_game3;
pub(crate) mod colouring;
