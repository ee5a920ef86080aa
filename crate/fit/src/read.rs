//! From a text file to outlines or a series: drawings, tables and GeoJSON.

mod content;
mod file;
mod gather;
mod geo;
mod problem;
mod sniff;
#[cfg(feature = "svg")]
mod svg;
mod table;
mod text;

pub use content::{FileContent, NamedOutline};
#[cfg(feature = "svg")]
pub use file::read_drawing;
pub use file::{ReadAs, read_file};
pub use problem::{ReadError, Remark};
pub use sniff::{FileKind, sniff};
