//! Which pieces meet, and what follows from it.

pub(crate) mod affinity;
pub(crate) mod analysis;
pub(crate) mod closed_form;
pub(crate) mod growth;
pub(crate) mod meeting;
pub(crate) mod neighbours;
pub(crate) mod types;
