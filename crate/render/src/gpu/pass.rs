//! What is drawn, in words that both interfaces understand.

use super::interface::{Buffer, Pipeline, Texture};

/// What fills a [`Slot`](super::words::Slot).
#[derive(Clone, Copy, Debug)]
pub(super) enum Bound<'a> {
    Uniform(&'a Buffer),
    Texture(&'a Texture),
}

/// What several draws share.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass<'a> {
    pub pipeline: &'a Pipeline,
    pub bindings: &'a [(u32, Bound<'a>)],
    pub onto: &'a [&'a Texture],
    /// Where the pipeline has [`OnTop`].
    pub depth: Option<&'a Texture>,
    /// Whether it begins on nothing.
    pub clear: bool,
}

/// So many vertices, for so many instances.
#[derive(Clone, Copy, Debug)]
pub(super) struct Draw<'a> {
    /// The buffers of the pipeline, and the item that each begins with.
    pub buffers: [Option<(&'a Buffer, u32)>; 2],
    /// Which vertices, one after the other, where it is not all of them: whole numbers.
    pub indices: Option<&'a Buffer>,
    pub count: u32,
    pub instances: u32,
}

impl Draw<'_> {
    /// All of the target.
    pub const SCREEN: Self = Self { buffers: [None; 2], indices: None, count: 3, instances: 1 };
}
