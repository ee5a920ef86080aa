//! Maps from the files of other programs and for them: what the page fetches when a file is opened or saved.

mod locus;
mod read;
mod write;

pub use locus::*;
pub use read::*;
pub use write::*;
