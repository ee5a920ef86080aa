//! Why a Fractint file cannot be read.

use thiserror::Error;

/// Why a file cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FileError {
    /// It is too long.
    #[error("The file has {bytes} bytes, and the most is 1 MiB. Cut it into several.")]
    TooLong {
        /// Its length.
        bytes: usize,
    },
    /// There is no system of space in it.
    #[error("There is no system in this file. One looks so: name (3D) {{ a b c d e f g h i x y z p .. }}")]
    Empty,
    /// There is no system in it.
    #[error(
        "There is no system in this file. One looks so: name {{ a b c d e f p .. }}, with a line for each map."
    )]
    None,
    /// There are systems, but all of the plane.
    #[error(
        "{} of the plane: no (3D) stands behind the name. Space opens systems of space: open the file in Morph. If they \
         are of space, write (3D) there.",
        whose(name, *count)
    )]
    Flat {
        /// The first of them.
        name: String,
        /// How many there are.
        count: usize,
    },
    /// A word where a number should be.
    #[error("Line {line}: \"{word}\" is no number. Mend it, or set a semicolon before a remark.")]
    Number {
        /// The line, from 1.
        line: usize,
        /// The word.
        word: String,
    },
    /// Maps with more or fewer numbers than they have.
    #[error("\"{name}\" at line {line} has {count} numbers. {}", needs(*needed))]
    Count {
        /// The system.
        name: String,
        /// The line where it begins, from 1.
        line: usize,
        /// How many numbers it has.
        count: usize,
        /// How many a map has, without its weight: 6 or 12.
        needed: usize,
    },
    /// A system with more than 64 maps.
    #[error("\"{name}\" at line {line} has {count} maps, and the most is 64. Leave some out.")]
    Maps {
        /// The system.
        name: String,
        /// The line where it begins, from 1.
        line: usize,
        /// How many maps it has.
        count: usize,
    },
    /// A brace that is not closed, or one too many.
    #[error("Line {line}: a brace is missing its partner. A system stands between {{ and }}.")]
    Brace {
        /// The line, from 1.
        line: usize,
    },
    /// A probability that is negative.
    #[error("\"{name}\" at line {line} has a negative probability. Write it without the sign.")]
    Probability {
        /// The system.
        name: String,
        /// The line where it begins, from 1.
        line: usize,
    },
}

const fn needs(needed: usize) -> &'static str {
    match needed {
        12 => "Each map has 13: nine of the matrix, three of the shift, one probability.",
        _ => "Each map has six, a b c d e f, or seven with its weight, in a line of its own.",
    }
}

fn whose(name: &str, count: usize) -> String {
    if count == 1 {
        format!("\"{name}\", the only system in this file, is")
    } else {
        format!("All {count} systems in this file, from \"{name}\" on, are")
    }
}

impl FileError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooLong { .. } => "ifs-too-long",
            Self::Empty | Self::None => "ifs-empty",
            Self::Flat { .. } => "ifs-flat",
            Self::Number { .. } => "ifs-number",
            Self::Count { .. } => "ifs-count",
            Self::Maps { .. } => "ifs-maps",
            Self::Brace { .. } => "ifs-brace",
            Self::Probability { .. } => "ifs-probability",
        }
    }
}
