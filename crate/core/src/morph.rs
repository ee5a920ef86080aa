//! From one system to another: the family between them, and which map becomes which.

pub(crate) mod along;
pub(crate) mod correspondence;
pub(crate) mod morph2;
pub(crate) mod morph3;
pub(crate) mod pairing;
pub(crate) mod route;
