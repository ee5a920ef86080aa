//! What the heading of a table calls its columns: which are x and y, which counts rows, which tells outlines apart.

use super::fields::Parted;

/// So many fields of a heading are looked at.
const MAX_NAMES: usize = 64;

/// The name of each column, as it is written; empty where it has none.
pub struct Heading {
    pub names: Vec<String>,
    /// Whether `ImageJ` wrote it: its column of row numbers is called by a blank, and y points down.
    pub imagej: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    X,
    Y,
}

/// What else stands in the name of a coordinate: units, and words for a coordinate.
const BESIDE: [&str; 41] = [
    "px",
    "pix",
    "pixel",
    "pixels",
    "mm",
    "cm",
    "dm",
    "m",
    "km",
    "um",
    "µm",
    "μm",
    "micron",
    "microns",
    "nm",
    "in",
    "inch",
    "inches",
    "ft",
    "pt",
    "deg",
    "degree",
    "degrees",
    "coord",
    "coords",
    "coordinate",
    "coordinates",
    "pos",
    "position",
    "point",
    "points",
    "pt",
    "location",
    "loc",
    "value",
    "values",
    "val",
    "axis",
    "achse",
    "wert",
    "koordinate",
];
/// Other names of coordinates.
const X_NAMES: [&str; 11] = [
    "lon",
    "long",
    "lng",
    "longitude",
    "easting",
    "east",
    "abscissa",
    "abscisse",
    "rechtswert",
    "xcoord",
    "xpos",
];
const Y_NAMES: [&str; 9] =
    ["lat", "latitude", "northing", "north", "ordinate", "ordonnée", "hochwert", "ycoord", "ypos"];
/// Names of columns that count rows.
const INDEX_NAMES: [&str; 15] = [
    "index", "idx", "row", "rows", "rownames", "rowname", "no", "nr", "num", "number", "n", "point", "pt",
    "vertex", "id",
];
/// Names of columns that tell outlines apart.
const GROUP_NAMES: [&str; 31] = [
    "leaf",
    "leaves",
    "id",
    "ids",
    "specimen",
    "sample",
    "shape",
    "outline",
    "object",
    "obj",
    "label",
    "name",
    "individual",
    "ind",
    "group",
    "image",
    "img",
    "file",
    "filename",
    "slice",
    "roi",
    "cell",
    "contour",
    "polygon",
    "feature",
    "plant",
    "blatt",
    "feuille",
    "track",
    "curve",
    "photo",
];

fn plain(name: &str) -> String {
    let name =
        name.trim_matches(|c: char| c.is_whitespace() || matches!(c, '"' | '\'' | '\u{feff}' | '\u{200b}'));
    name.to_lowercase()
}

fn words(name: &str) -> Vec<String> {
    let name = plain(name);
    name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(String::from).collect()
}

/// Which coordinate a column has, how far from plain its name is, and what the name of the other has in common with it.
fn axis(name: &str) -> Option<(Axis, u8, String)> {
    let words = words(name);
    for (axis, letter, names) in [(Axis::X, "x", &X_NAMES[..]), (Axis::Y, "y", &Y_NAMES[..])] {
        if let Some(at) = words.iter().position(|word| word == letter) {
            let mut rest = words;
            rest.remove(at);
            // Units in brackets, as in x (mm), say no more than the letter.
            let beside = rest.iter().all(|word| BESIDE.contains(&word.as_str()));
            let rank = if rest.is_empty() {
                0
            } else if beside {
                1
            } else {
                3
            };
            return Some((axis, rank, rest.join(" ")));
        }
        let known = |word: &String| names.contains(&word.as_str());
        if words.iter().any(known) && words.iter().all(|word| known(word) || BESIDE.contains(&word.as_str()))
        {
            return Some((axis, 2, String::new()));
        }
        // The corner of a box in ImageJ, posX, x0.
        if let [word] = &words[..] {
            let before = word.strip_suffix(letter).filter(|rest| rest.len() < 6 && !rest.is_empty());
            let after =
                word.strip_prefix(letter).filter(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()));
            let is_known = |rest: &str| rest == "b" || BESIDE.contains(&rest);
            if let Some(rest) = before.filter(|rest| is_known(rest)).or(after) {
                return Some((axis, 4, rest.to_owned()));
            }
        }
    }
    None
}

impl Heading {
    /// Reads a heading of rows with so many fields, whose first fields these are.
    pub fn of(line: &str, parted: Parted, fields: usize, first: &[&str]) -> Option<Self> {
        let in_way = |parted: Parted| {
            let mut names: Vec<String> = parted.fields(line).take(MAX_NAMES).map(String::from).collect();
            if parted == Parted::BySpaces {
                // Units in brackets are no names of their own.
                names.retain(|name| !name.starts_with(['(', '[']));
            }
            // R writes no name above the names of rows, and a blank or tab before the first name may be lost.
            if names.len() + 1 == fields && names.len() > 1 && counts_rows(first, parted) {
                names.insert(0, String::new());
            }
            while names.len() > fields && names.last().is_some_and(|name| name.trim().is_empty()) {
                names.pop();
            }
            (names.len() == fields && names.iter().any(|name| !name.trim().is_empty())).then_some(names)
        };
        let names = std::iter::once(parted).chain(Parted::ALL).find_map(in_way)?;
        let imagej =
            names[0].starts_with(' ') && names[0].trim().is_empty() && names.iter().any(|name| name == "X");
        Some(Self { names, imagej })
    }

    /// The columns called x and y, of those that have numbers.
    pub fn axes(&self, numeric: &[usize]) -> Option<(usize, usize)> {
        let found: Vec<(usize, Axis, u8, String)> = numeric
            .iter()
            .filter_map(|&column| {
                let (axis, rank, rest) = axis(self.names.get(column)?)?;
                Some((column, axis, rank, rest))
            })
            .collect();
        let mut best: Option<((u8, bool), usize, usize)> = None;
        for (x, _, rank, rest) in found.iter().filter(|one| one.1 == Axis::X) {
            for (y, _, other_rank, other) in found.iter().filter(|one| one.1 == Axis::Y) {
                let rank = ((*rank).max(*other_rank), rest != other);
                if best.is_none_or(|(least, ..)| rank < least) {
                    best = Some((rank, *x, *y));
                }
            }
        }
        best.map(|(_, x, y)| (x, y))
    }

    /// Whether a column has no name, or one that says that it counts rows.
    pub fn is_index(&self, column: usize) -> bool {
        let words = self.names.get(column).map(|name| words(name)).unwrap_or_default();
        words.is_empty()
            || words[0] == "unnamed"
            || matches!(&words[..], [word] if INDEX_NAMES.contains(&word.as_str()))
    }

    /// Whether a column may say to which outline a row belongs.
    pub fn is_group(&self, column: usize) -> bool {
        let words = self.names.get(column).map(|name| words(name)).unwrap_or_default();
        words.iter().any(|word| GROUP_NAMES.contains(&word.trim_end_matches(|c: char| c.is_ascii_digit())))
    }

    /// Whether a line has the same names.
    pub fn is_at(&self, line: &str, parted: Parted) -> bool {
        let names = || self.names.iter().map(|name| name.trim()).filter(|name| !name.is_empty());
        parted.fields(line).take(MAX_NAMES).map(str::trim).filter(|name| !name.is_empty()).eq(names())
    }

    pub fn name(&self, column: usize) -> Option<String> {
        let name = self.names.get(column)?;
        let name = name.trim_matches(|c: char| c.is_whitespace() || matches!(c, '"' | '\''));
        (!name.is_empty()).then(|| super::short(name, 24))
    }
}

/// Whether the first fields of rows are names of rows as R writes them.
fn counts_rows(first: &[&str], parted: Parted) -> bool {
    let numbers: Option<Vec<f64>> = first
        .iter()
        .map(|field| field.trim_matches(|c: char| c.is_whitespace() || c == '"').parse::<f64>().ok())
        .collect();
    let Some(numbers) = numbers else { return true };
    let step = |pair: &[f64]| pair[1] - pair[0];
    let quoted = first.iter().all(|field| field.contains('"'));
    let growing = numbers.windows(2).all(|pair| step(pair) > 0.0) && numbers.iter().all(|x| x.fract() == 0.0);
    let counting = numbers.windows(2).all(|pair| step(pair) == 1.0) && numbers.len() > 2;
    quoted || counting || (growing && parted != Parted::By(','))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_known_by_their_names() {
        for (name, wanted) in [
            ("x", Some((Axis::X, 0))),
            (" \"Y\" ", Some((Axis::Y, 0))),
            ("X (px)", Some((Axis::X, 1))),
            ("y_mm", Some((Axis::Y, 1))),
            ("x [µm]", Some((Axis::X, 1))),
            ("x-coordinate", Some((Axis::X, 1))),
            ("POINT_Y", Some((Axis::Y, 1))),
            ("Longitude", Some((Axis::X, 2))),
            ("lat", Some((Axis::Y, 2))),
            ("leaf y", Some((Axis::Y, 3))),
            ("BX", Some((Axis::X, 4))),
            ("posY", Some((Axis::Y, 4))),
            ("x1", Some((Axis::X, 4))),
            ("max", None),
            ("day", None),
            ("index", None),
            ("", None),
        ] {
            assert_eq!(axis(name).map(|(axis, rank, _)| (axis, rank)), wanted, "{name}");
        }
    }

    #[test]
    fn the_plainest_pair_is_taken() {
        let heading = |line: &str| {
            let names: Vec<String> = line.split(',').map(String::from).collect();
            Heading { names, imagej: false }
        };
        for (line, wanted) in [
            ("y,x", Some((1, 0))),
            (" ,Area,BX,BY,X,Y", Some((4, 5))),
            (" ,Area,BX,BY", Some((2, 3))),
            ("lon,lat,x,y", Some((2, 3))),
            ("lat,lon", Some((1, 0))),
            ("leaf1_x,leaf2_y,leaf2_x,leaf1_y", Some((0, 3))),
            ("t,x", None),
            ("a,b", None),
        ] {
            let numeric: Vec<usize> = (0..line.split(',').count()).collect();
            assert_eq!(heading(line).axes(&numeric), wanted, "{line}");
        }
    }
}
