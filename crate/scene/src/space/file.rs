//! Fractint's `.ifs` files of space.

use std::fmt::Write;

use frond_core::MAX_MAPS;
use thiserror::Error;

use crate::space::preset::Row3;

/// A system in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceFile {
    /// Its name there.
    pub name: String,
    /// Its maps.
    pub maps: Vec<Row3>,
    /// The probabilities that the file gives, one a map; their sum need not be 1.
    pub probabilities: Vec<f64>,
}

/// What a file has.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceSystems {
    /// Its systems of space, at least one, in their order.
    pub systems: Vec<SpaceFile>,
    /// How many systems of the plane were passed over.
    pub flat: usize,
}

/// Why a file cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FileError {
    /// It is too long.
    #[error("The file has {bytes} bytes, and the most is 1 MiB. Cut it into several.")]
    TooLong {
        /// Its length.
        bytes: usize,
    },
    /// There is no system in it.
    #[error("There is no system in this file. One looks so: name (3D) {{ a b c d e f g h i x y z p .. }}")]
    Empty,
    /// There are systems, but all of the plane.
    #[error(
        "{} of the plane: no (3D) stands behind the name. Space opens systems of space, and no other tool opens .ifs files \
         yet: type the maps in Morph. If they are of space, write (3D) there.",
        whose(name, *count)
    )]
    Flat {
        /// The first of them.
        name: String,
        /// How many there are.
        count: usize,
    },
    /// A word where a number should be.
    #[error("Line {line}: \"{word}\" is no number.")]
    Number {
        /// The line, from 1.
        line: usize,
        /// The word.
        word: String,
    },
    /// A map with more or fewer than 13 numbers.
    #[error(
        "\"{name}\" at line {line} has {count} numbers. Each map has 13: nine of the matrix, three of the shift, one probability."
    )]
    Count {
        /// The system.
        name: String,
        /// The line where it begins, from 1.
        line: usize,
        /// How many numbers it has.
        count: usize,
    },
    /// A system with more than 64 maps.
    #[error("\"{name}\" at line {line} has {count} maps, and the most is 64.")]
    Maps {
        /// The system.
        name: String,
        /// The line where it begins, from 1.
        line: usize,
        /// How many maps it has.
        count: usize,
    },
    /// A brace that is not closed, or one too many.
    #[error("Line {line}: a brace is missing its partner.")]
    Brace {
        /// The line, from 1.
        line: usize,
    },
    /// A probability that is negative.
    #[error("\"{name}\" at line {line} has a negative probability.")]
    Probability {
        /// The system.
        name: String,
        /// The line where it begins, from 1.
        line: usize,
    },
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
            Self::Empty => "ifs-empty",
            Self::Flat { .. } => "ifs-flat",
            Self::Number { .. } => "ifs-number",
            Self::Count { .. } => "ifs-count",
            Self::Maps { .. } => "ifs-maps",
            Self::Brace { .. } => "ifs-brace",
            Self::Probability { .. } => "ifs-probability",
        }
    }
}

/// The longest file.
const LONGEST_FILE: usize = 1 << 20;

/// Reads the systems of space of a Fractint file: `name (3D) { .. }`, with the sign `(3D)` before the brace or behind
/// it.
///
/// A map has 13 numbers: the three rows of its matrix, its translation and its probability; ends of lines mean nothing,
/// and what follows a semicolon is a remark. Systems of the plane, without the sign, are passed over and counted.
///
/// # Errors
/// [`FileError`] with the line where it is.
pub fn parse_ifs3(text: &str) -> Result<SpaceSystems, FileError> {
    if text.len() > LONGEST_FILE {
        return Err(FileError::TooLong { bytes: text.len() });
    }
    let mut systems = Vec::new();
    let mut flat = 0;
    let mut first_flat = None;
    let mut open: Option<Entry> = None;
    let mut before = String::new();
    for (k, line) in text.lines().enumerate() {
        let line_number = k + 1;
        let (line, remark) = line.split_once(';').unwrap_or((line, ""));
        if let Some(entry) = &mut open {
            entry.solid |= entry.words.is_empty() && is_sign(remark);
        }
        let mut rest = line;
        loop {
            match (rest.find(['{', '}']), &mut open) {
                (None, Some(entry)) => {
                    entry.take(rest, line_number);
                    break;
                }
                (None, None) => {
                    before.push(' ');
                    before.push_str(rest);
                    break;
                }
                (Some(at), None) if rest[at..].starts_with('{') => {
                    before.push(' ');
                    before.push_str(&rest[..at]);
                    let solid = is_sign(&before) || is_sign(remark);
                    let name = before
                        .replace(['(', ')'], " ")
                        .split_whitespace()
                        .next()
                        .unwrap_or("unnamed")
                        .to_owned();
                    open = Some(Entry { name, solid, line: line_number, words: Vec::new() });
                    before.clear();
                    rest = &rest[at + 1..];
                }
                (Some(at), Some(entry)) if rest[at..].starts_with('}') => {
                    entry.take(&rest[..at], line_number);
                    if let Some(entry) = open.take() {
                        if entry.solid {
                            systems.push(entry.read()?);
                        } else {
                            flat += 1;
                            first_flat.get_or_insert(entry.name);
                        }
                    }
                    rest = &rest[at + 1..];
                }
                _ => return Err(FileError::Brace { line: line_number }),
            }
        }
    }
    if let Some(entry) = open {
        return Err(FileError::Brace { line: entry.line });
    }
    match (systems.is_empty(), first_flat) {
        (false, _) => Ok(SpaceSystems { systems, flat }),
        (true, Some(name)) => Err(FileError::Flat { name, count: flat }),
        (true, None) => Err(FileError::Empty),
    }
}

fn is_sign(text: &str) -> bool {
    text.to_ascii_lowercase().contains("(3d)")
}

/// A system that is being read.
struct Entry {
    name: String,
    solid: bool,
    line: usize,
    words: Vec<(String, usize)>,
}

impl Entry {
    fn take(&mut self, text: &str, line: usize) {
        let text = if is_sign(text) {
            self.solid = true;
            text.to_ascii_lowercase().replace("(3d)", " ")
        } else {
            text.to_owned()
        };
        self.words
            .extend(text.split([' ', '\t', ',']).filter(|w| !w.is_empty()).map(|w| (w.to_owned(), line)));
    }

    fn read(self) -> Result<SpaceFile, FileError> {
        let Self { name, line, words, .. } = self;
        let number = |(word, line): &(String, usize)| {
            let number = word.parse::<f64>().ok().filter(|x| x.is_finite());
            number.ok_or_else(|| FileError::Number { line: *line, word: word.chars().take(40).collect() })
        };
        let numbers: Vec<f64> = words.iter().map(number).collect::<Result<_, _>>()?;
        let (rows, left) = numbers.as_chunks::<13>();
        if !left.is_empty() || rows.is_empty() {
            return Err(FileError::Count { name, line, count: numbers.len() });
        }
        if rows.len() > MAX_MAPS {
            return Err(FileError::Maps { name, line, count: rows.len() });
        }
        let probabilities: Vec<f64> = rows.iter().map(|row| row[12]).collect();
        if probabilities.iter().any(|p| *p < 0.0) {
            return Err(FileError::Probability { name, line });
        }
        let maps = rows.iter().map(|row| std::array::from_fn(|k| row[k])).collect();
        Ok(SpaceFile { name, maps, probabilities })
    }
}

/// Writes a system as Fractint reads it. Numbers come back to the last bit.
#[must_use]
pub fn write_ifs3(file: &SpaceFile) -> String {
    let word = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' };
    let name: String = file.name.chars().map(word).collect();
    let mut text = format!("{} (3D) {{\n", if name.is_empty() { "unnamed" } else { &name });
    for (k, row) in file.maps.iter().enumerate() {
        let probability = file.probabilities.get(k).copied().unwrap_or(1.0 / file.maps.len() as f64);
        for x in row.iter().chain([&probability]) {
            // Writing to a string does not fail.
            let _ = write!(text, " {x}");
        }
        text.push('\n');
    }
    text.push_str("}\n");
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::preset::presets3;

    const FERN: &str = "
        ; a fern of space
        fern3d (3D) { ; from a book
          .00 .00 0 .0 .18 .0 0 0.0 0.00 0 0.0 0 .01
          .85 .00 0 .0 .85 .1 0 -0.1 0.85 0 1.6 0 .85
        }
        flat { .5 0 0 .5 0 0 .5
               .5 0 0 .5 1 0 .5 }
        behind { (3D)
          .2 -.2 0 .2 .2 0 0 0 .3 0 .8 0 .07 }";

    #[test]
    fn systems_of_space_are_read_and_those_of_the_plane_counted() {
        let SpaceSystems { systems: found, flat } = parse_ifs3(FERN).unwrap();
        assert_eq!(flat, 1);
        assert_eq!(found.iter().map(|file| &*file.name).collect::<Vec<_>>(), ["fern3d", "behind"]);
        assert_eq!(found[0].maps[1], [0.85, 0.0, 0.0, 0.0, 0.85, 0.1, 0.0, -0.1, 0.85, 0.0, 1.6, 0.0]);
        assert_eq!(found[0].probabilities, [0.01, 0.85]);
        assert_eq!(found[1].maps.len(), 1);
    }

    #[test]
    fn what_is_written_comes_back_to_the_last_bit() {
        for preset in presets3() {
            let probabilities = vec![1.0 / 3.0; preset.maps.len()];
            let file = SpaceFile { name: preset.id.to_owned(), maps: preset.maps.clone(), probabilities };
            let text = write_ifs3(&file);
            assert_eq!(parse_ifs3(&text), Ok(SpaceSystems { systems: vec![file], flat: 0 }));
        }
    }

    #[test]
    fn a_file_of_both_says_how_many_are_left_out() {
        let solid = "solid (3D) { .5 0 0 0 .5 0 0 0 .5 0 0 0 1 }\n";
        let flat = "flat { .5 0 0 .5 0 0 .5 }\n";
        let found = parse_ifs3(&format!("{}{}{}", flat.repeat(6), solid.repeat(7), flat.repeat(7))).unwrap();
        assert_eq!((found.systems.len(), found.flat), (7, 13));
        let told = |count: usize| parse_ifs3(&flat.repeat(count)).unwrap_err().to_string();
        assert!(
            told(13).starts_with("All 13 systems in this file, from \"flat\" on, are of the plane"),
            "{}",
            told(13)
        );
        assert!(
            told(1).starts_with("\"flat\", the only system in this file, is of the plane"),
            "{}",
            told(1)
        );
    }

    #[test]
    fn mistakes_are_named_with_their_line() {
        let code = |text: &str| parse_ifs3(text).map_or_else(|error| error.code(), |_| "done");
        assert_eq!(code(""), "ifs-empty");
        assert_eq!(code("; nothing"), "ifs-empty");
        assert_eq!(code("flat { 1 2 3 4 5 6 7 }"), "ifs-flat");
        assert_eq!(code("a (3D) { 1 2 3 }"), "ifs-count");
        assert_eq!(code("a (3D) { }"), "ifs-count");
        assert_eq!(code("a (3D) { 1 2 3"), "ifs-brace");
        assert_eq!(code("a (3D) }"), "ifs-brace");
        assert_eq!(code("a (3D) { {"), "ifs-brace");
        assert_eq!(code(&"x".repeat(2 << 20)), "ifs-too-long");
        assert_eq!(code("a (3D) { 0 0 0 0 0 0 0 0 0 0 0 0 -1 }"), "ifs-probability");
        let many = format!("a (3D) {{ {} }}", "0.1 ".repeat(13 * 65));
        assert_eq!(code(&many), "ifs-maps");
        assert_eq!(
            parse_ifs3("a (3D) {\n 1 2 nan\n}"),
            Err(FileError::Number { line: 2, word: "nan".to_owned() })
        );
        for word in ["1e999", "inf", "héllo", "--1"] {
            assert_eq!(code(&format!("a (3D) {{ {word} }}")), "ifs-number");
        }
    }
}
