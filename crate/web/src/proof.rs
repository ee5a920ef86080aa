//! What decides and proves, for the workers.

mod certificates;
mod certify;
mod connectedness;
mod distance;
mod family;
mod locus;
mod path;
mod routes;
mod settle;

pub use {
    certificates::*, certify::*, connectedness::*, distance::*, family::*, locus::*, path::*, routes::*,
    settle::*,
};
