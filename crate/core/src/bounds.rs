//! Where an attractor lies.

pub(crate) mod bounds3;
pub(crate) mod hull2;
pub(crate) mod support_table3;
