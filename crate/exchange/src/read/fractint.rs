//! Fractint's `.ifs` files, and those that other programs write like them.
//!
//! `name { .. }`, with `(3D)` beside the name where it is of space. A map of the plane has six numbers,
//! x' = a x + b y + e and y' = c x + d y + f, and one of space twelve; one more is its weight in the chaos game. Blanks
//! and commas part numbers, and what follows a semicolon is a remark. Fractint counts numbers and does not look at
//! lines; others have a map a line. Both are read: by lines where each has as many as a map.

use frond_core::MAX_MAPS;

use super::fractint_error::FileError;
use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::system::{Maps, Row3, System};
use crate::text::{name_or, number, short};

/// A system of space in a file.
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

/// The longest file.
const LONGEST_FILE: usize = 1 << 20;

/// Reads the systems of space of a Fractint file: `name (3D) { .. }`, with the sign `(3D)` before the brace or behind
/// it. Systems of the plane, without the sign, are passed over and counted.
///
/// # Errors
/// [`FileError`] with the line where it is.
pub fn parse_ifs3(text: &str) -> Result<SpaceSystems, FileError> {
    let (solid, flat): (Vec<_>, Vec<_>) = entries(text)?.into_iter().partition(|entry| entry.solid);
    let read = |entry: &Entry<'_>| {
        let (maps, weights) = entry.rows::<12>()?;
        if weights.iter().flatten().any(|weight| *weight < 0.0) {
            return Err(FileError::Probability { name: entry.name.clone(), line: entry.line });
        }
        let probabilities = weights.into_iter().flatten().collect();
        Ok(SpaceFile { name: entry.name.clone(), maps, probabilities })
    };
    let systems: Vec<SpaceFile> = solid.iter().map(read).collect::<Result<_, _>>()?;
    match (systems.is_empty(), flat.first()) {
        (false, _) => Ok(SpaceSystems { systems, flat: flat.len() }),
        (true, Some(first)) => Err(FileError::Flat { name: first.name.clone(), count: flat.len() }),
        (true, None) => Err(FileError::Empty),
    }
}

/// Reads the systems of the plane and of space.
pub fn read_fractint(text: &str) -> Result<Gathered, ImportError> {
    let entries = entries(text)?;
    let mut all = Gathered::of(entries.len());
    for entry in entries.into_iter().take(MAX_SYSTEMS) {
        all.take(entry.read().map_err(ImportError::from));
    }
    all.finish(FileError::None.into())
}

/// The sign of a system of space.
const SIGN: &str = "(3d)";

fn is_sign(text: &str) -> bool {
    text.to_ascii_lowercase().contains(SIGN)
}

/// What is between braces, with the name before them.
fn entries(text: &str) -> Result<Vec<Entry<'_>>, FileError> {
    if text.len() > LONGEST_FILE {
        return Err(FileError::TooLong { bytes: text.len() });
    }
    let mut entries = Vec::new();
    let mut open: Option<Entry<'_>> = None;
    // The last line with something in it before a brace: the name.
    let mut before = "";
    for (k, line) in text.lines().enumerate() {
        let line_number = k + 1;
        let (line, remark) = line.split_once(';').unwrap_or((line, ""));
        let sign = is_sign(remark);
        if let Some(entry) = &mut open {
            entry.solid |= entry.words.is_empty() && sign;
        }
        let mut rest = line;
        loop {
            match (rest.find(['{', '}']), &mut open) {
                // What is only told has any words, and ends with the next brace.
                (Some(at), Some(entry)) if entry.told && rest[at..].starts_with('{') => {
                    rest = &rest[at + 1..];
                }
                (None, Some(entry)) => {
                    entry.take(rest, line_number);
                    break;
                }
                (None, None) => {
                    if !rest.trim().is_empty() {
                        before = rest;
                    }
                    break;
                }
                (Some(at), None) if rest[at..].starts_with('{') => {
                    if !rest[..at].trim().is_empty() {
                        before = &rest[..at];
                    }
                    open = Some(Entry::new(before, sign, line_number));
                    before = "";
                    rest = &rest[at + 1..];
                }
                (Some(at), Some(entry)) if rest[at..].starts_with('}') => {
                    entry.take(&rest[..at], line_number);
                    entries.extend(open.take().filter(|entry| !entry.told));
                    rest = &rest[at + 1..];
                }
                _ => return Err(FileError::Brace { line: line_number }),
            }
        }
    }
    match open {
        Some(entry) => Err(FileError::Brace { line: entry.line }),
        None => Ok(entries),
    }
}

/// What the maps weigh in the chaos game, where that is said.
type Weights = Vec<Option<f64>>;

/// A system that is being read.
struct Entry<'a> {
    name: String,
    solid: bool,
    /// `comment { .. }`: Fractint keeps words in such entries.
    told: bool,
    line: usize,
    words: Vec<(&'a str, u32)>,
}

impl<'a> Entry<'a> {
    fn new(before: &str, solid: bool, line: usize) -> Self {
        let lower = before.to_ascii_lowercase();
        let sign = lower.find(SIGN);
        let name =
            sign.map_or(before.into(), |at| format!("{} {}", &before[..at], &before[at + SIGN.len()..]));
        let told = name.trim().eq_ignore_ascii_case("comment");
        Self {
            name: name_or(&name, "unnamed"),
            solid: solid || sign.is_some(),
            told,
            line,
            words: Vec::new(),
        }
    }

    fn take(&mut self, text: &'a str, line: usize) {
        if self.told {
            return;
        }
        // A file has no more lines than bytes, and those are few.
        let line = line as u32;
        for word in text.split([' ', '\t', ',', '\u{c}', '\u{1a}']).filter(|word| !word.is_empty()) {
            let sign = word.get(..SIGN.len()).is_some_and(|start| start.eq_ignore_ascii_case(SIGN));
            self.solid |= sign;
            let word = if sign { &word[SIGN.len()..] } else { word };
            if !word.is_empty() {
                self.words.push((word, line));
            }
        }
    }

    /// How many words each line has.
    fn widths(&self) -> impl Iterator<Item = usize> {
        self.words.chunk_by(|one, other| one.1 == other.1).map(<[_]>::len)
    }

    /// Its maps of `N` numbers, and the weight of each that has one.
    fn rows<const N: usize>(&self) -> Result<(Vec<[f64; N]>, Weights), FileError> {
        let Self { name, line, words, .. } = self;
        let read = |&(word, line): &(&str, u32)| {
            number(word).ok_or_else(|| FileError::Number { line: line as usize, word: short(word, 40) })
        };
        let numbers: Vec<f64> = words.iter().map(read).collect::<Result<_, _>>()?;
        let by_lines = self.widths().all(|width| width == N || width == N + 1);
        let widths: Vec<usize> = match (by_lines, numbers.len()) {
            (_, 0) => Vec::new(),
            (true, _) => self.widths().collect(),
            (false, count) if count % (N + 1) == 0 => vec![N + 1; count / (N + 1)],
            (false, count) if count % N == 0 => vec![N; count / N],
            _ => Vec::new(),
        };
        if widths.is_empty() {
            let (name, line, count) = (name.clone(), *line, numbers.len());
            return Err(FileError::Count { name, line, count, needed: N });
        }
        if widths.len() > MAX_MAPS {
            return Err(FileError::Maps { name: name.clone(), line: *line, count: widths.len() });
        }
        let (mut rest, mut rows, mut weights) = (&numbers[..], Vec::new(), Vec::new());
        for width in widths {
            let (row, after) = rest.split_at(width);
            rows.push(std::array::from_fn(|k| row[k]));
            weights.push(row.get(N).copied());
            rest = after;
        }
        Ok((rows, weights))
    }

    fn read(self) -> Result<System, FileError> {
        let unsaid = !self.solid && !self.words.is_empty() && self.widths().all(|width| width == 13);
        let (maps, weights) = if self.solid || unsaid {
            let (rows, weights) = self.rows::<12>()?;
            (Maps::Space(rows), weights)
        } else {
            let (rows, weights) = self.rows::<6>()?;
            (Maps::Plane(rows), weights)
        };
        let mut system = System::of(self.name, maps);
        if unsaid {
            let remark =
                "No (3D) stands behind the name, but each line has 13 numbers: read as a system of space.";
            system.remarks.push(remark.into());
        }
        system.take_weights(&weights);
        Ok(system)
    }
}

#[cfg(test)]
mod tests {
    use frond_scene::presets3;

    use super::*;
    use crate::write::fractint::write_ifs3;

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
