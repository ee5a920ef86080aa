//! Shapes of one grid, given by digits, and what two of them share: in whole numbers, without rounding.

pub(crate) mod error;
pub(crate) mod intersection;
pub(crate) mod merging;
pub(crate) mod product;
pub(crate) mod reach;
pub(crate) mod shifts;
pub(crate) mod subsets;
pub(crate) mod system;
