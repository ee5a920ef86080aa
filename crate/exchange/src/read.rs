//! Files, a format each.

pub(crate) mod decimal;
pub(crate) mod equation;
pub(crate) mod flame;
pub(crate) mod fractint;
pub(crate) mod fractint_error;
pub(crate) mod ifstile;
pub(crate) mod import;
pub(crate) mod json;
pub(crate) mod json_map;
pub(crate) mod problem;
pub(crate) mod table;
pub(crate) mod tex;
