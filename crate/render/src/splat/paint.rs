//! From codes to colours.
pub fn paint_codes() {}
