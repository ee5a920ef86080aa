//! Tries what reads documents from outside on documents that somebody, or nobody, wrote.
//!
//! A [`Reader`] says what must hold of whatever it reads: no panic (with overflow checks and debug assertions), no more
//! than a second and 256 MB for any document that its size limits let in, and what it writes comes back as it was.
//! [`Reader::try_on`] tries it on one document.
//!
//! `tests/fuzz/<reader>` has documents of each reader: some that are right, and each that once broke it. Every run of
//! the tests tries all of them, and some [`Draft`]s, documents with a few changes. `cargo xtask test deep` has
//! libFuzzer make more of both, for a minute each, led by which code they reach.
//!
//! # In which order to read it
//!
//! `reader`: what is tried, and `readers/` for each. `guard`: the limits. `draft`: a document and its changes, `change`
//! each kind of them, `number` the numbers and `form` the ways to write a text down.

mod change;
mod draft;
mod form;
mod guard;
mod number;
mod reader;
mod readers;

pub use draft::Draft;
pub use reader::Reader;
pub use readers::*;
