//! Maps whose entries are numbers of one field `Q[x] / (p)`: what is equal there is decided, nothing is rounded.

mod deviation;
mod entries;
mod line;
mod numeral;
mod points;
mod ring;

pub(crate) use deviation::Deviation;
pub(crate) use entries::{Field, cost_reading};
