//! The widest gap: the widest edge of the minimum spanning tree of the distances between the pieces.
//!
//! `piece_distance` bounds the distance of two pieces; `pair_descent` splits pairs of pieces that are not told apart;
//! `bracket` and `kruskal` say which pairs to look into, and so does `pairs`, for pieces of any kind. `word_pairs` and
//! `difference_set` are two ways to name pieces: by their words, and, where all maps share one linear part, by how far
//! they are moved; of two maps of one linear part `power_series` and `complex_series` tell all. `trails` are ways to
//! near points, for the next system to follow.

pub(crate) mod bracket;
pub(crate) mod complex_series;
pub(crate) mod difference_set;
pub(crate) mod greedy;
pub(crate) mod kruskal;
pub(crate) mod pair_descent;
pub(crate) mod pairs;
pub(crate) mod piece_distance;
pub(crate) mod power_series;
pub(crate) mod spanning_tree;
pub(crate) mod trails;
pub(crate) mod word_pairs;
pub(crate) mod word_tree;
