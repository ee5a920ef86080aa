//! What decides and proves, for the workers.

mod certify;
mod connectedness;
mod evidence;
mod family;
mod locus;
mod path;
mod routes;
mod settle;

pub use {certify::*, connectedness::*, evidence::*, family::*, locus::*, path::*, routes::*, settle::*};
