//! Maps from the files of other programs, and for them.
//!
//! [`import`] says what a file is by what is in it, and reads the systems that it has; [`export`] writes one as text.
//! What is written as the text of doubles comes back to the last bit.
//!
//! ```
//! use frond_exchange::{ExportFormat, export, import};
//!
//! let found = import(b"binary { ; two halves\n .5 0 0 .5 0 0 .5\n .5, 0, 0, .5, .5, 0, .5 }")?;
//! assert_eq!(found.systems[0].name, "binary");
//! let python = export(&found.systems[0], ExportFormat::Python)?;
//! assert!(python.contains("import numpy"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is read
//!
//! | file | what of it |
//! |---|---|
//! | Fractint's `.ifs`, and others like it | six or seven numbers a map, in space (`(3D)`) twelve or thirteen |
//! | `.flame` (flam3, Apophysis, JWildfire) | the linear part of transforms, in space too, with `post`; colours |
//! | `.aifs` (IFStile) | all that describes systems (see `read/ifstile.rs`), graph-directed ones and subspaces too |
//! | JSON | `{ maps }` as the programming interface has it; rows, objects a to f, formulas; documents |
//! | tables | six or seven columns, in space twelve or thirteen; also as books, encyclopedias and LaTeX print them |
//! | PNG | the link that Frond wrote into it |
//!
//! Nothing in a file is run. Sizes are looked at before anything is read, and no input takes more than a few times its
//! own size.
//!
//! # In which order to read it
//!
//! 1. `system`: what is exchanged. `number`: how its numbers are written where exact ones are wanted. `formula`:
//!    how formulas are read. `colour`: as the web writes them. `ambient`: the exact system behind computed maps.
//! 2. `read/`: a file a format; `import` tells which it is, `problem` says what can be wrong.
//! 3. `write/`: a file a format; `export` chooses, and says what each is called.
//! 4. `png`: the link in a picture. `locus`: the samples of a locus, for other programs to work on.

mod ambient;
mod colour;
mod formula;
mod locus;
mod number;
mod png;
mod read;
mod system;
mod text;
mod write;

pub use ambient::{Ambient, AmbientMap, Cell, Subspace};
pub use locus::{LocusSamples, locus_csv, locus_npy};
pub use png::{link_in_png, png_with_link};
pub use read::fractint::{SpaceFile, SpaceSystems, parse_ifs3};
pub use read::fractint_error::FileError;
pub use read::import::{FileFormat, Imported, import};
pub use read::problem::ImportError;
pub use system::{Camera, DirectedCopy, Maps, Row, Row3, System};
pub use write::export::{ExportError, ExportFormat, export};
pub use write::fractint::write_ifs3;
