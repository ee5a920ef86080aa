//! A document and its changes.

use bolero::TypeGenerator;
use bolero::generator::bolero_generator::driver::{ByteSliceDriver, Options};

use crate::change::{Change, Source};
use crate::form::Form;
use crate::reader::Reader;

/// A document of a reader, with some changes, written in some way.
#[derive(Clone, Debug, TypeGenerator)]
pub struct Draft {
    document: u16,
    changes: Vec<Change>,
    form: Form,
}

impl Draft {
    /// The draft that so many random bytes stand for.
    #[must_use]
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        Self::generate(&mut ByteSliceDriver::new(bytes, &Options::default()))
    }

    /// The document, out of those of its reader.
    #[must_use]
    pub fn write(&self, reader: &Reader, documents: &[(String, Vec<u8>)]) -> Vec<u8> {
        let which = usize::from(self.document).checked_rem(documents.len());
        let mut text = which.map(|at| documents[at].1.clone()).unwrap_or_default();
        for change in &self.changes {
            change.apply(&mut text, Source { words: reader.words, documents });
        }
        self.form.write(text)
    }
}
