//! Fractint's `.ifs` files, and those that other programs write like them.
//!
//! `name { .. }`, with `(3D)` beside the name where it is of space. A map of the plane has six numbers,
//! x' = a x + b y + e and y' = c x + d y + f, and one of space twelve; one more is its weight in the chaos game. Blanks
//! and commas part numbers, and what follows a semicolon is a remark. Fractint counts numbers and does not look at
//! lines; others have a map a line. Both are read: by lines where each has as many as a map.

use std::borrow::Cow;

use frond_core::MAX_MAPS;

use super::decimal::{decimal_word, has_decimal_commas};
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
    /// The probabilities that the file gives, one a map; their sum need not be 1. Empty where it does not give each map
    /// one.
    pub probabilities: Vec<f64>,
    /// What was left out or changed in reading it, a sentence each.
    pub remarks: Vec<String>,
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

/// Reads the systems of space of a Fractint file as [`import`](crate::import) does: `name (3D) { .. }`, with the sign
/// `(3D)` before the brace or behind it. Systems of the plane, without the sign, are passed over and counted.
///
/// # Errors
/// [`FileError`] with the line where it is.
pub fn parse_ifs3(text: &str) -> Result<SpaceSystems, FileError> {
    let (mut systems, mut flat, mut first_flat) = (Vec::new(), 0, None);
    for entry in entries(text)? {
        if !entry.is_of_space() {
            flat += 1;
            first_flat.get_or_insert(entry.name);
            continue;
        }
        let line = entry.line;
        let (System { name, maps, probabilities, remarks, .. }, weights) = entry.read()?;
        if weights.iter().flatten().any(|weight| *weight < 0.0) {
            return Err(FileError::Probability { name, line });
        }
        if let Maps::Space(maps) = maps {
            systems.push(SpaceFile { name, maps, probabilities, remarks });
        }
    }
    match first_flat {
        _ if !systems.is_empty() => Ok(SpaceSystems { systems, flat }),
        Some(name) => Err(FileError::Flat { name, count: flat }),
        None => Err(FileError::Empty),
    }
}

/// Reads the systems of the plane and of space.
pub fn read_fractint(text: &str) -> Result<Gathered, ImportError> {
    let entries = entries(text)?;
    let mut all = Gathered::of(entries.len());
    for entry in entries.into_iter().take(MAX_SYSTEMS) {
        all.take(entry.read().map(|(system, _)| system).map_err(ImportError::from));
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
                    entries.extend(open.take().filter(|entry| !entry.told).map(Entry::settle));
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
    words: Vec<(Cow<'a, str>, u32)>,
    /// Whether commas are decimal ones.
    decimal: bool,
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
            decimal: false,
        }
    }

    fn take(&mut self, text: &'a str, line: usize) {
        if self.told {
            return;
        }
        // A file has no more lines than bytes, and those are few.
        let line = line as u32;
        let parts = |c: char| c.is_whitespace() || c == '\u{1a}';
        for word in text.split(parts).filter(|word| !word.is_empty()) {
            let sign = word.get(..SIGN.len()).is_some_and(|start| start.eq_ignore_ascii_case(SIGN));
            self.solid |= sign;
            let word = if sign { &word[SIGN.len()..] } else { word };
            if !word.is_empty() {
                self.words.push((word.into(), line));
            }
        }
    }

    /// Once all words are there: commas part them, or are decimal ones, where maps come of it.
    fn settle(mut self) -> Self {
        let lines = || self.words.chunk_by(|one, other| one.1 == other.1);
        let words =
            |line: &[(Cow<'a, str>, u32)]| line.iter().map(|(word, _)| &**word).collect::<Vec<_>>().join(" ");
        self.decimal = has_decimal_commas(lines().map(words));
        let decimal = self.decimal;
        self.words = std::mem::take(&mut self.words)
            .into_iter()
            .filter(|(word, _)| word.contains(|c| c != ','))
            .flat_map(|(word, line)| match word {
                _ if decimal => vec![(decimal_word(&word).into(), line)],
                Cow::Borrowed(word) => {
                    word.split(',').filter(|word| !word.is_empty()).map(|word| (word.into(), line)).collect()
                }
                Cow::Owned(word) => vec![(Cow::Owned(word), line)],
            })
            .collect();
        self
    }

    /// How many words each line has.
    fn widths(&self) -> impl Iterator<Item = usize> {
        self.words.chunk_by(|one, other| one.1 == other.1).map(<[_]>::len)
    }

    /// Its maps of `N` numbers, and the weight of each that has one.
    fn rows<const N: usize>(&self) -> Result<(Vec<[f64; N]>, Weights), FileError> {
        let Self { name, line, words, .. } = self;
        let read = |(word, line): &(Cow<'_, str>, u32)| {
            number(word).ok_or_else(|| FileError::Number { line: *line as usize, word: short(word, 40) })
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

    /// Whether it is of space though the sign is missing: each line has as many numbers as a map of space with its
    /// weight.
    fn is_unsaid(&self) -> bool {
        !self.solid && !self.words.is_empty() && self.widths().all(|width| width == 13)
    }

    fn is_of_space(&self) -> bool {
        self.solid || self.is_unsaid()
    }

    /// The system, and the weights as they stand in the file.
    fn read(self) -> Result<(System, Weights), FileError> {
        let unsaid = self.is_unsaid();
        let (maps, weights) = if self.is_of_space() {
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
        if self.decimal {
            system.remarks.push("Commas are taken for decimal points.".into());
        }
        system.take_weights(&weights);
        Ok((system, weights))
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
            let (name, maps) = (preset.id.to_owned(), preset.maps.clone());
            let file = SpaceFile { name, maps, probabilities, remarks: Vec::new() };
            let text = write_ifs3(&file);
            assert_eq!(parse_ifs3(&text), Ok(SpaceSystems { systems: vec![file], flat: 0 }));
        }
    }

    /// Against the numbers as they stand there, and against what reads files of any kind.
    #[test]
    fn decimal_commas_are_told_from_those_that_part_numbers() {
        let halves = [[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0]];
        for (text, is_decimal) in [
            ("a {\n 0,5 0 0 0,5 0 0 0,33\n 0,5 0 0 0,5 0,5 0 0,67\n}", true),
            ("a {\n 0,5, 0, 0, 0,5, 0, 0, 0,33\n 0,5, 0, 0, 0,5, 0,5, 0, 0,67\n}", true),
            ("a {\n .5,0,0,.5,0,0,.33\n .5, 0, 0, .5, .5, 0, .67\n}", false),
            ("a {\n .5 0 0 .5\u{a0}\u{2212}0 0 .33\n .5 0 0 .5 .5 0 .67\n}", false),
        ] {
            let found = read_fractint(text).unwrap().systems.remove(0);
            assert_eq!(found.maps, Maps::Plane(halves.to_vec()), "{text}");
            assert_eq!(found.probabilities, [0.33, 0.67], "{text}");
            assert_eq!(found.remarks.len(), usize::from(is_decimal), "{text}");
        }
        // Whole numbers stay what they are.
        let found = read_fractint("a { 1,2,3,4,5,6 }").unwrap().systems.remove(0);
        assert_eq!(found.maps, Maps::Plane(vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]]));
    }

    #[test]
    fn weights_belong_to_the_maps_they_stand_with() {
        let row = |x: usize| format!("{x} 0 0 0 .5 0 0 0 .5 0 0 0");
        let flat_row = |x: usize| format!("{x} 0 0 .5 0 0");
        for (weights, wanted) in [
            (["0.7", "0.2", "0.1"], &[0.7, 0.2, 0.1][..]),
            (["0.7", "", "0.2"], &[]),
            (["", "0.7", "0.2"], &[]),
            (["0.7", "0.2", ""], &[]),
            (["", "", ""], &[]),
            (["0", "0", "0"], &[]),
            (["1e308", "1e308", "1e308"], &[]),
            (["0", "5e-324", "0"], &[0.0, 5e-324, 0.0]),
        ] {
            let lines = |row: &dyn Fn(usize) -> String| {
                let lines = weights.iter().enumerate().map(|(k, weight)| format!("{} {weight}\n", row(k)));
                lines.collect::<String>()
            };
            let text = format!("a (3D) {{\n{}}}", lines(&row));
            let SpaceFile { maps, probabilities, remarks, .. } = parse_ifs3(&text).unwrap().systems.remove(0);
            let first: Vec<f64> = maps.iter().map(|map| map[0]).collect();
            assert_eq!((&*first, &*probabilities), (&[0.0, 1.0, 2.0][..], wanted), "{text}");
            let is_said = weights.concat().is_empty() || !wanted.is_empty();
            assert_eq!(remarks.is_empty(), is_said, "{text}: {remarks:?}");
            let system = read_fractint(&text).unwrap().systems.remove(0);
            assert_eq!((system.probabilities, system.remarks), (probabilities, remarks), "{text}");
            // In the plane, with a sign or without one.
            let plane = read_fractint(&format!("a {{\n{}}}", lines(&flat_row))).unwrap().systems.remove(0);
            assert_eq!((&*plane.probabilities, plane.remarks.is_empty()), (wanted, is_said), "{text}");
            let unsaid = text.replace("(3D)", "");
            let (one, all) =
                (parse_ifs3(&unsaid), read_fractint(&unsaid).map(|mut all| all.systems.remove(0)));
            match (one, all) {
                (Ok(one), Ok(all)) => {
                    assert_eq!(one.systems[0].probabilities, all.probabilities);
                    assert_eq!(Maps::Space(one.systems[0].maps.clone()), all.maps);
                }
                // Twelve numbers without a sign are two maps of the plane, for both.
                (Err(FileError::Flat { .. }), Ok(System { maps: Maps::Plane(_), .. })) => {}
                (Err(FileError::Flat { .. }), Err(_)) => {}
                (one, all) => panic!("{unsaid}: {one:?} {all:?}"),
            }
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
