//! The tests of the literature, which estimate: Burch & Hart (1997), figures 1 and 2.

pub(crate) mod barnsley;
pub(crate) mod index_buffer;
