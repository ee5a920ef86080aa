//! Stamps: a hash of what a step was made from, kept beside what it made, so that it is not made twice.

use std::fs;
use std::path::{Path, PathBuf};

use crate::command::{Outcome, root};

/// A 64-bit FNV-1a hash of files' names and contents. It finds changes; it keeps nobody out.
pub struct Hash(u64);

impl Hash {
    /// Starts from words that are no file, e.g. versions and flags.
    pub fn new(words: &[&str]) -> Self {
        let mut hash = Self(0xcbf2_9ce4_8422_2325);
        for word in words {
            hash.bytes(word.as_bytes());
        }
        hash
    }

    /// Adds a file, or all files below a directory, in the order of their names.
    pub fn path(&mut self, path: &Path) -> Outcome {
        for file in files(path)? {
            let name = file.strip_prefix(root()).unwrap_or(&file);
            self.bytes(name.to_string_lossy().as_bytes());
            self.bytes(&fs::read(&file)?);
        }
        Ok(())
    }

    /// The hash in hexadecimal.
    pub fn text(&self) -> String {
        format!("{:016x}", self.0)
    }

    fn bytes(&mut self, bytes: &[u8]) {
        // The length first, so that moving a byte from one piece to the next is a change.
        for byte in (bytes.len() as u64).to_le_bytes().iter().chain(bytes) {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// Whether the file holds this text.
pub fn holds(file: &Path, text: &str) -> bool {
    fs::read_to_string(file).is_ok_and(|old| old == text)
}

/// Writes a file, and the directories to it.
pub fn write(file: &Path, text: &str) -> Outcome {
    if let Some(parent) = file.parent() {
        fs::create_dir_all(parent)?;
    }
    Ok(fs::write(file, text)?)
}

/// Writes a file unless it holds this text already: whoever watches it need not look again.
pub fn write_changed(file: &Path, text: &str) -> Outcome {
    if holds(file, text) { Ok(()) } else { write(file, text) }
}

/// All files below a path, or the path itself where it is a file; none where it does not exist.
pub fn files(path: &Path) -> Outcome<Vec<PathBuf>> {
    let mut found = Vec::new();
    let mut open = vec![path.to_path_buf()];
    while let Some(next) = open.pop() {
        if next.is_dir() {
            for entry in fs::read_dir(&next)? {
                open.push(entry?.path());
            }
        } else if next.is_file() {
            found.push(next);
        }
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_a_word_ends_matters() {
        assert_ne!(Hash::new(&["ab", "c"]).text(), Hash::new(&["a", "bc"]).text());
        assert_ne!(Hash::new(&["", "a"]).text(), Hash::new(&["a", ""]).text());
        assert_eq!(Hash::new(&["a"]).text(), Hash::new(&["a"]).text());
    }

    #[test]
    fn a_missing_path_holds_no_files() {
        assert_eq!(files(Path::new("/no/such/path")).map(|found| found.len()).ok(), Some(0));
    }
}
