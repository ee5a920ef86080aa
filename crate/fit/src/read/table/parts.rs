//! Several outlines in one table: told apart by a column, by lines between them, or by rows of NaN.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use glam::DVec2;

use super::super::gather::{About, FEWEST_POINTS, Gathered, Line, MAX_KEPT};
use super::super::problem::Remark;
use super::super::text::short;
use super::columns::Columns;
use super::rows::{Row, point, rows};

/// The most outlines that a column may tell apart.
const MAX_PARTS: usize = 1000;
/// The ends of a part may be so much farther from each other than its points are, if it is an outline.
const WIDEST_GAP: f64 = 1.5;

/// What tells the outlines of a table apart.
pub enum Parts {
    One,
    /// Columns; whether rows of one outline do not follow each other.
    Columns(Vec<usize>, bool),
    /// Blank lines or lines of words, and whether rows of NaN, too.
    Lines(bool),
}

/// What is seen of the parts while the table is read for the first time.
pub struct Survey {
    columns: Vec<Keys>,
    lines: Blocks,
    with_nan: Blocks,
}

impl Survey {
    pub fn of(columns: &Columns) -> Self {
        let columns = columns.groups.iter().map(|&column| Keys::of(column)).collect();
        Self { columns, lines: Blocks::default(), with_nan: Blocks::default() }
    }

    pub fn row(&mut self, columns: &Columns, line: &str, point: DVec2) {
        for keys in &mut self.columns {
            keys.take(columns.parted.fields(line).nth(keys.column).unwrap_or_default());
        }
        self.lines.take(point);
        self.with_nan.take(point);
    }

    /// What is no row: a blank line, words, or numbers that are none.
    pub fn gap(&mut self, columns: &Columns, line: &str) {
        match Gap::of(columns, line) {
            Gap::Blank => {
                self.lines.cut(false);
                self.with_nan.cut(false);
            }
            Gap::Words => {
                self.lines.cut(true);
                self.with_nan.cut(true);
            }
            Gap::Nan => self.with_nan.cut(false),
            Gap::Other => {}
        }
    }

    pub fn finish(mut self) -> Parts {
        let told: Vec<&Keys> = self.columns.iter().filter(|keys| keys.tell()).collect();
        if !told.is_empty() {
            let mixed = told.iter().any(|keys| keys.runs > keys.counts.len());
            return Parts::Columns(told.iter().map(|keys| keys.column).collect(), mixed);
        }
        if self.with_nan.tell() {
            return Parts::Lines(true);
        }
        if self.lines.tell() { Parts::Lines(false) } else { Parts::One }
    }
}

/// The values of a column that may tell outlines apart.
struct Keys {
    column: usize,
    counts: HashMap<u64, usize>,
    last: Option<u64>,
    runs: usize,
    too_many: bool,
}

impl Keys {
    fn of(column: usize) -> Self {
        Self { column, counts: HashMap::new(), last: None, runs: 0, too_many: false }
    }

    fn take(&mut self, field: &str) {
        if self.too_many {
            return;
        }
        let mut hasher = DefaultHasher::new();
        field.trim().hash(&mut hasher);
        let key = hasher.finish();
        *self.counts.entry(key).or_default() += 1;
        self.runs += usize::from(self.last.replace(key) != Some(key));
        self.too_many = self.counts.len() > MAX_PARTS;
    }

    fn tell(&self) -> bool {
        !self.too_many && self.counts.len() > 1 && self.counts.values().all(|&count| count >= FEWEST_POINTS)
    }
}

/// Rows between gaps.
#[derive(Default)]
struct Blocks {
    ends: Option<(DVec2, DVec2)>,
    count: usize,
    longest: f64,
    blocks: usize,
    /// Whether one is too short, or is only a part of an outline.
    broken: bool,
}

impl Blocks {
    fn take(&mut self, point: DVec2) {
        if let Some((_, last)) = self.ends {
            self.longest = self.longest.max(last.distance(point));
        }
        self.ends = Some((self.ends.map_or(point, |(first, _)| first), point));
        self.count += 1;
    }

    /// A gap; with words it parts outlines even where they are open.
    fn cut(&mut self, words: bool) {
        if let Some((first, last)) = self.ends.take() {
            let open = first.distance(last) > WIDEST_GAP * self.longest;
            self.broken |= self.count < FEWEST_POINTS || (open && !words);
            self.blocks += 1;
        }
        (self.count, self.longest) = (0, 0.0);
    }

    fn tell(&mut self) -> bool {
        let words = self.blocks > 0 && !self.broken;
        self.cut(words);
        self.blocks > 1 && !self.broken
    }
}

enum Gap {
    Blank,
    Words,
    Nan,
    Other,
}

impl Gap {
    fn of(columns: &Columns, line: &str) -> Self {
        let mut fields = columns.parted.fields(line).map(|field| columns.style.number(field));
        let empty = |c: char| c.is_whitespace() || matches!(c, ',' | ';' | '"' | '\u{1a}');
        if line.trim_matches(empty).is_empty() {
            // A line of separators is a row with nothing in it.
            return if line.contains([',', ';']) { Self::Nan } else { Self::Blank };
        }
        let used = |column: usize| {
            let field = columns.parted.fields(line).nth(column).unwrap_or_default().trim();
            matches!(field.to_ascii_lowercase().as_str(), "nan" | "na" | "null" | "" | "-")
        };
        if used(columns.first) && columns.second.is_some_and(used) {
            return Self::Nan;
        }
        if fields.all(|number| number.is_none()) || line.chars().next().is_some_and(char::is_alphabetic) {
            Self::Words
        } else {
            Self::Other
        }
    }
}

/// Reads the outlines of a table.
pub fn gather(
    text: &str,
    columns: &Columns,
    parts: &Parts,
    rows_of_all: usize,
) -> (Gathered<String>, Vec<Remark>) {
    let mut all =
        Gather { gathered: Gathered::default(), open: Vec::new(), places: HashMap::new(), count: 0 };
    let mixed = matches!(parts, Parts::Columns(_, true)) && rows_of_all <= MAX_KEPT;
    let (mut row, mut title) = (0, String::new());
    let mut seen_row = false;
    for (_, kind) in rows(text) {
        let line = match kind {
            Row::Blank => "",
            Row::Remark(line) => {
                title = short(line, 40);
                continue;
            }
            Row::Line(line) => line,
        };
        let point = if line.is_empty() { None } else { point(columns, line, row) };
        match (point, parts) {
            (Some(point), Parts::Columns(keys, _)) => {
                let fields: Vec<&str> = columns.parted.fields(line).collect();
                let name = key_name(columns, keys, &fields);
                all.push(name, point, mixed);
            }
            (Some(point), _) => {
                if all.open.is_empty() {
                    let name =
                        if title.is_empty() { format!("outline {}", all.count + 1) } else { title.clone() };
                    title.clear();
                    all.open.push((name, Line::default()));
                    all.count += 1;
                }
                all.open[0].1.push(point);
            }
            (None, Parts::Lines(nan)) => match Gap::of(columns, line) {
                Gap::Blank => all.close(),
                Gap::Words => {
                    all.close();
                    // The heading above all is no name of an outline, nor are names of columns.
                    let heading =
                        columns.heading.as_ref().is_some_and(|heading| heading.is_at(line, columns.parted));
                    if !heading && (seen_row || columns.heading.is_some()) {
                        title = short(line, 40);
                    }
                }
                Gap::Nan if *nan => all.close(),
                _ => {}
            },
            (None, _) => {}
        }
        seen_row |= point.is_some();
        row += usize::from(point.is_some());
    }
    all.close();
    let remark = match parts {
        Parts::One => return (all.gathered, Vec::new()),
        Parts::Columns(keys, _) => {
            let names: Vec<String> = keys
                .iter()
                .map(|&key| {
                    let name = columns.heading.as_ref().and_then(|heading| heading.name(key));
                    name.map_or_else(|| (key + 1).to_string(), |name| format!("“{name}”"))
                })
                .collect();
            let word = if keys.len() > 1 { "Columns" } else { "Column" };
            let verb = if keys.len() > 1 { "tell" } else { "tells" };
            format!("{word} {} {verb} {} outlines apart.", names.join(" and "), all.count)
        }
        Parts::Lines(_) => format!("Lines without numbers part {} outlines.", all.count),
    };
    (all.gathered, vec![Remark::new("assumed", remark)])
}

/// What is read of the outlines so far.
struct Gather {
    gathered: Gathered<String>,
    /// The lines that may go on: one, or all where rows are mixed.
    open: Vec<(String, Line)>,
    places: HashMap<String, usize>,
    count: usize,
}

impl Gather {
    fn push(&mut self, name: String, point: DVec2, mixed: bool) {
        if !mixed && self.open.first().is_some_and(|(open, _)| *open != name) {
            self.close();
        }
        let place = if mixed { self.places.get(&name).copied() } else { self.open.len().checked_sub(1) };
        let place = place.unwrap_or_else(|| {
            let place = self.open.len();
            if mixed {
                self.places.insert(name.clone(), place);
            }
            self.open.push((name, Line::default()));
            self.count += 1;
            place
        });
        self.open[place].1.push(point);
    }

    fn close(&mut self) {
        for (label, line) in self.open.drain(..) {
            self.gathered.take(&line, About { label, closed: true, ground: false });
        }
    }
}

/// The name of an outline: the words of its columns, or a number with the name of its column.
fn key_name(columns: &Columns, keys: &[usize], fields: &[&str]) -> String {
    let names: Vec<String> = keys
        .iter()
        .map(|&key| {
            let field = fields.get(key).copied().unwrap_or_default();
            let field = field.trim_matches(|c: char| c.is_whitespace() || c == '"');
            match columns.heading.as_ref().and_then(|heading| heading.name(key)) {
                Some(name) if field.parse::<f64>().is_ok() => short(&format!("{name} {field}"), 40),
                None if field.parse::<f64>().is_ok() => short(&format!("outline {field}"), 40),
                _ => short(field, 40),
            }
        })
        .collect();
    names.join(", ")
}
