//! Why a file cannot be read.

use thiserror::Error;

use super::fractint_error::FileError;
use crate::system::System;

/// Why a file has no maps that can be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ImportError {
    /// No bytes, or blanks only.
    #[error("The file is empty. Choose another.")]
    Empty,
    /// More bytes than are read of such a file.
    #[error("The file has {megabytes} MB, and of {format} at most {most} MB are read. Cut it into several.")]
    TooLarge {
        /// What it is.
        format: &'static str,
        /// Its size, rounded up.
        megabytes: usize,
        /// The largest size.
        most: usize,
    },
    /// A kind of file that holds no maps.
    #[error(
        "No maps are found in this file. Files with maps are .ifs (Fractint), .flame, .aifs (IFStile), Frond's JSON and \
         PNG, and tables with six or seven numbers a line."
    )]
    Unknown,
    /// A picture without a link of Frond.
    #[error(
        "This picture holds no link of Frond. Pictures that Frond saved do, unless another program has saved them again."
    )]
    NoLink,
    /// A Fractint file is miswritten.
    #[error(transparent)]
    Fractint(#[from] FileError),
    /// XML, JSON or a script is miswritten, or has what is not read.
    #[error("Line {line}: {why}")]
    At {
        /// A name that stays the same, for programs.
        code: &'static str,
        /// The line, from 1.
        line: usize,
        /// What is wrong and what to do.
        why: String,
    },
    /// The same where lines say nothing.
    #[error("{why}")]
    Within {
        /// A name that stays the same, for programs.
        code: &'static str,
        /// What is wrong and what to do.
        why: String,
    },
}

impl ImportError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Empty => "file-empty",
            Self::TooLarge { .. } => "file-too-large",
            Self::Unknown => "file-unknown",
            Self::NoLink => "file-no-link",
            Self::Fractint(error) => error.code(),
            Self::At { code, .. } | Self::Within { code, .. } => code,
        }
    }
}

/// Systems that were read, and what of others is to be said. Those that are miswritten are passed over where there are
/// good ones.
#[derive(Default)]
pub struct Gathered {
    pub systems: Vec<System>,
    pub remarks: Vec<String>,
    first: Option<ImportError>,
    wrong: usize,
}

/// The most systems of a file.
pub const MAX_SYSTEMS: usize = 1000;

impl Gathered {
    /// None yet, of a file with so many.
    pub fn of(count: usize) -> Self {
        let mut all = Self::default();
        if count > MAX_SYSTEMS {
            all.remarks.push(format!("The file has {count} systems: the first {MAX_SYSTEMS} are read."));
        }
        all
    }

    pub fn take(&mut self, read: Result<System, ImportError>) {
        match read {
            Ok(system) => self.systems.push(system),
            Err(error) => {
                self.wrong += 1;
                self.first.get_or_insert(error);
            }
        }
    }

    /// Several, no more than there may be.
    pub fn extend_with_all(&mut self, read: Vec<System>) {
        let room = MAX_SYSTEMS.saturating_sub(self.systems.len());
        self.systems.extend(read.into_iter().take(room));
    }

    /// All that was read, or the first that is wrong.
    pub fn finish(mut self, nothing: ImportError) -> Result<Self, ImportError> {
        match (self.systems.is_empty(), self.first.take()) {
            (false, None) => {}
            (false, Some(error)) => {
                let others =
                    if self.wrong == 1 { String::new() } else { format!(" And {} more.", self.wrong - 1) };
                self.remarks.push(format!("Left out: {error}{others}"));
            }
            (true, Some(error)) => return Err(error),
            (true, None) => return Err(nothing),
        }
        Ok(self)
    }
}
