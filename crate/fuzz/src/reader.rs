//! What is tried.

use std::fs;
use std::panic;
use std::path::{Path, PathBuf};

use crate::guard;

/// Something that reads documents from outside.
#[derive(Clone, Copy, Debug)]
pub struct Reader {
    /// Its name, and that of its folder in `tests/fuzz`.
    pub name: &'static str,
    /// Reads a document, and panics where what it gives is not as it must be.
    pub read: fn(&[u8]),
    /// Words of its language.
    pub words: &'static [&'static str],
}

impl Reader {
    /// Where its documents are.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/fuzz").join(self.name)
    }

    /// Its documents, by the names of their files.
    ///
    /// # Panics
    /// Where they cannot be read, or there are none.
    #[must_use]
    pub fn documents(&self) -> Vec<(String, Vec<u8>)> {
        let folder = self.folder();
        let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
        paths.sort();
        assert!(!paths.is_empty(), "{} is empty", folder.display());
        let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        paths.iter().map(|path| (name(path), fs::read(path).expect("a file"))).collect()
    }

    /// Reads a document within the limits. A document that breaks something is written into the folder that
    /// `FROND_FUZZ_FOUND` names, so that it can be kept; every document, before it is read, into the file that
    /// `FROND_FUZZ_LAST` names: there it is even where reading it ends the program.
    ///
    /// # Panics
    /// Where what is read is not as it must be, or the limits are broken.
    pub fn try_on(&self, document: &[u8]) {
        if let Some(path) = std::env::var_os("FROND_FUZZ_LAST") {
            fs::write(path, document).expect("a file that can be written");
        }
        let tried = panic::catch_unwind(|| guard::within_limits(|| (self.read)(document)));
        if let Err(problem) = tried {
            if let Some(folder) = std::env::var_os("FROND_FUZZ_FOUND") {
                let _ = fs::write(Path::new(&folder).join(self.name), document);
            }
            panic::resume_unwind(problem);
        }
    }
}
