//! Exact numbers: fractions, and elements of number fields.

pub(crate) mod compositum;
pub(crate) mod factor;
pub(crate) mod field;
pub(crate) mod formula;
pub(crate) mod interval;
pub(crate) mod matrix;
pub(crate) mod modular;
pub(crate) mod nearest;
pub(crate) mod polynomial;
pub(crate) mod rational;
pub(crate) mod roots;
pub(crate) mod text;
pub(crate) mod value;
