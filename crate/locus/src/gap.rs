//! The widest gap: the widest edge of the minimum spanning tree of the distances between the pieces.

pub(crate) mod bracket;
pub(crate) mod difference_set;
pub(crate) mod greedy;
pub(crate) mod kruskal;
pub(crate) mod pair_descent;
pub(crate) mod piece_distance;
pub(crate) mod spanning_tree;
pub(crate) mod word_pairs;
pub(crate) mod word_tree;
