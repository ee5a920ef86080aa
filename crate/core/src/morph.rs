//! From one system to another: the family between them, and which map becomes which.

pub(crate) mod along;
mod chains;
pub(crate) mod correspondence2;
mod correspondence3;
pub(crate) mod interpolation;
pub(crate) mod options;
pub(crate) mod pairing;
pub(crate) mod route;
pub(crate) mod turn2;
pub(crate) mod turn3;
mod upright;
pub(crate) mod ways;
pub(crate) mod zipper;
