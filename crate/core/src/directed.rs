//! Graph-directed systems: several shapes, each the union of smaller copies of shapes among them.

pub(crate) mod around;
pub(crate) mod chain;
pub(crate) mod chaos_game;
pub(crate) mod contraction;
pub(crate) mod cut;
pub(crate) mod dimension;
pub(crate) mod error;
pub(crate) mod hull;
pub(crate) mod levels;
pub(crate) mod map;
pub(crate) mod matching;
pub(crate) mod measure;
pub(crate) mod morph;
pub(crate) mod reach;
pub(crate) mod system;
