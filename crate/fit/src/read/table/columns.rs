//! Which columns of a table hold its numbers, how they are parted, and how the numbers are written: whatever makes the
//! most sense of the first lines.

use std::cmp::Reverse;

use super::super::problem::Remark;
use super::super::text::short;
use super::fields::Parted;
use super::heading::Heading;
use super::number::{Style, may_be_parted};

/// As many fields of a line are looked at to find that out.
const MAX_FIELDS: usize = 64;

/// So many columns at most say to which outline a row belongs.
const MAX_GROUP_COLUMNS: usize = 4;

/// Why two columns are read and not the first two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Chosen {
    First,
    /// The heading calls them x and y.
    Named,
    /// The column before them counts rows, or says to which outline they belong.
    Counted,
}

/// A heading has at most so many lines that are looked at for names.
const HEADING_LINES: usize = 4;
/// As many rows one after another belong to one outline where nothing but a number says so.
const SHORTEST_RUN: usize = 4;

/// The columns that are read.
pub struct Columns {
    pub parted: Parted,
    pub style: Style,
    pub first: usize,
    pub second: Option<usize>,
    pub heading: Option<Heading>,
    /// Those that may say to which outline a row belongs.
    pub groups: Vec<usize>,
    /// Those that have numbers, the first of all.
    numeric: Vec<usize>,
    chosen: Chosen,
    /// Whether there are others.
    more: bool,
    /// Two columns go before one, then come those with fewer fields that are no numbers, and more lines.
    rank: (bool, Reverse<usize>, usize),
}

/// Finds the two columns that the heading calls x and y, or else the first two that do not count rows, among those in
/// which most of the lines after the heading have numbers. `remark` is the last one before them: it may be a heading.
pub fn columns(sample: &[&str], remark: Option<&str>) -> Option<Columns> {
    let mut found = parting(sample)?;
    found.choose(sample, remark);
    Some(found)
}

fn parting(sample: &[&str]) -> Option<Columns> {
    if let Some(style) = decimals(sample) {
        let rank = (false, Reverse(0), sample.len());
        return Some(Columns::new(Parted::By(';'), style, vec![0], false, rank));
    }
    let mut best: Option<Columns> = None;
    for parted in Parted::ALL {
        let lines: Vec<Vec<&str>> =
            sample.iter().map(|line| parted.fields(line).take(MAX_FIELDS).collect()).collect();
        for style in Style::ALL {
            if let Some(found) = in_style(parted, style, &lines)
                && best.as_ref().is_none_or(|best| found.rank > best.rank)
            {
                best = Some(found);
            }
        }
    }
    best
}

fn in_style(parted: Parted, style: Style, lines: &[Vec<&str>]) -> Option<Columns> {
    let is_number = |line: &Vec<&str>| line.iter().map(|field| style.number(field).is_some()).collect();
    let rows: Vec<Vec<bool>> = lines.iter().map(is_number).collect();
    let begin = rows.iter().position(|row| row.contains(&true))?;
    let (rows, lines) = (&rows[begin..], &lines[begin..]);
    let most = rows.iter().map(Vec::len).max()?;
    let count = |column: usize| rows.iter().filter(|row| row.get(column) == Some(&true)).count();
    let numeric: Vec<usize> = (0..most).filter(|&column| 2 * count(column) > rows.len()).collect();
    let (first, second) = (*numeric.first()?, numeric.get(1).copied());
    let fields = lines.iter().flatten().filter(|field| !field.trim().is_empty()).count();
    let numbers = rows.iter().flatten().filter(|&&is| is).count();
    let rank = (
        second.is_some(),
        Reverse(1000 * (fields - numbers) / fields),
        second.map_or(count(first), |second| count(first).min(count(second))),
    );
    let more = most > 1 + usize::from(second.is_some());
    Some(Columns::new(parted, style, numeric, more, rank))
}

/// Whether numbers go up by one, from 0 or 1.
fn counts(values: &[f64]) -> bool {
    values.len() > 2
        && [0.0, 1.0].contains(&values[0])
        && values.windows(2).all(|pair| pair[1] - pair[0] == 1.0)
}

/// Whether whole numbers stay as they are for many rows, and then go up by one.
fn runs(values: &[f64]) -> bool {
    let runs: Vec<usize> = values.chunk_by(|a, b| a == b).map(<[_]>::len).collect();
    let last = runs.len().saturating_sub(1);
    values.iter().all(|x| x.fract() == 0.0)
        && values.windows(2).all(|pair| [0.0, 1.0].contains(&(pair[1] - pair[0])))
        && runs.iter().enumerate().all(|(k, &run)| run >= SHORTEST_RUN || k == last && k > 0)
}

/// One column of decimal commas, and not two columns of whole numbers: no whole number is written 05.
fn decimals(sample: &[&str]) -> Option<Style> {
    let padded = |part: &str| part.len() > 1 && part.starts_with('0');
    let begin = sample.iter().position(|line| Style::Comma.number(line).is_some())?;
    let mut found = false;
    for line in &sample[begin..] {
        let (whole, rest) = line.trim().split_once(',')?;
        Style::Comma.number(line)?;
        if padded(whole.trim_start_matches(['+', '-'])) {
            return None;
        }
        found |= padded(rest);
    }
    found.then_some(Style::Comma)
}

impl Columns {
    fn new(
        parted: Parted,
        style: Style,
        numeric: Vec<usize>,
        more: bool,
        rank: (bool, Reverse<usize>, usize),
    ) -> Self {
        let (first, second) = (numeric.first().copied().unwrap_or(0), numeric.get(1).copied());
        let (heading, groups, chosen) = (None, Vec::new(), Chosen::First);
        Self { parted, style, first, second, heading, groups, numeric, chosen, more, rank }
    }

    fn is_row(&self, line: &str) -> bool {
        let numbers = |column: usize| {
            self.parted.fields(line).nth(column).is_some_and(|field| self.style.number(field).is_some())
        };
        numbers(self.first) && self.second.is_none_or(numbers)
    }

    /// Looks at the heading and at what columns hold, and chooses.
    fn choose(&mut self, sample: &[&str], remark: Option<&str>) {
        let Some(begin) = sample.iter().position(|line| self.is_row(line)) else { return };
        let rows: Vec<Vec<&str>> = sample[begin..]
            .iter()
            .filter(|line| self.is_row(line))
            .map(|line| self.parted.fields(line).take(MAX_FIELDS).collect())
            .collect();
        let width = rows.iter().map(Vec::len).max().unwrap_or(0);
        let first: Vec<&str> = rows.iter().filter_map(|row| row.first().copied()).collect();
        let is_number = |name: &String| self.style.number(name).is_some_and(f64::is_finite);
        let mut headings: Vec<Heading> = sample[begin.saturating_sub(HEADING_LINES)..begin]
            .iter()
            .rev()
            .copied()
            .chain(remark)
            .filter_map(|line| Heading::of(line, self.parted, width, &first))
            .filter(|heading| !heading.names.iter().any(is_number))
            .collect();
        // Names may stand above a line of units.
        let named = headings.iter().position(|heading| heading.axes(&self.numeric).is_some());
        if !headings.is_empty() {
            self.heading = Some(headings.swap_remove(named.unwrap_or(0)));
        }
        let values = |column: usize| -> Vec<f64> {
            rows.iter().filter_map(|row| self.style.number(row.get(column)?)).collect()
        };
        let before = values(self.first);
        let is_run = self.heading.is_none() && self.numeric.len() > 2 && runs(&before);
        if let Some((x, y)) = self.heading.as_ref().and_then(|heading| heading.axes(&self.numeric)) {
            (self.first, self.second, self.chosen) = (x, Some(y), Chosen::Named);
        } else if let [index, x, y, ..] = self.numeric[..] {
            let counted = self.heading.as_ref().map_or_else(
                || counts(&before) || is_run,
                |heading| heading.is_index(index) && (counts(&before) || heading.name(index).is_none()),
            );
            if counted {
                (self.first, self.second, self.chosen) = (x, Some(y), Chosen::Counted);
            }
        }
        // A sign behind the last number, as lists of programs have it, begins no column.
        let is_empty =
            |field: &&str| field.trim_matches([' ', ',', ')', ']', '}', '"', '\r', '\t']).is_empty();
        self.more = rows.iter().any(|row| {
            let others = row
                .iter()
                .enumerate()
                .filter(|&(column, _)| column != self.first && Some(column) != self.second);
            others.map(|(_, field)| field).any(|field| !is_empty(field))
        });
        let free = |column: &usize| *column != self.first && Some(*column) != self.second;
        self.groups = match &self.heading {
            Some(heading) => (0..width).filter(free).filter(|&column| heading.is_group(column)).collect(),
            // Without names, words tell outlines apart, or a number that stays for many rows.
            None => (0..width)
                .filter(free)
                .filter(|column| !self.numeric.contains(column) || is_run && self.numeric[0] == *column)
                .collect(),
        };
        self.groups.truncate(MAX_GROUP_COLUMNS);
    }

    /// Says which columns are read, where others could be meant.
    pub fn used(&self) -> Option<Remark> {
        let name = |column: usize| {
            let name = self.heading.as_ref().and_then(|heading| heading.name(column));
            name.map_or_else(|| (column + 1).to_string(), |name| format!("{} (“{name}”)", column + 1))
        };
        let Some(second) = self.second else {
            let message = format!("Only column {} of the table was read.", name(self.first));
            return self.more.then(|| Remark::new("ignored", message));
        };
        let (x, y) = (name(self.first), name(second));
        // As many numbers as a map has, with its weight and its number or without.
        let may_be_maps = self.chosen != Chosen::Named && matches!(self.numeric.len(), 6..=8 | 12..=14);
        let hint = if may_be_maps { " If its rows are maps, open it in Morph." } else { "" };
        match self.chosen {
            Chosen::Counted if self.heading.is_none() => Some(Remark::new(
                "assumed",
                format!(
                    "Column {} is taken to count rows or outlines: columns {x} and {y} are read as x and y.{hint}",
                    self.numeric[0] + 1
                ),
            )),
            Chosen::Named if self.first > second => Some(Remark::new(
                "assumed",
                format!("As the heading says, column {x} is read as x and column {y} as y."),
            )),
            _ if self.more => Some(Remark::new(
                "ignored",
                format!("Only columns {x} and {y} of the table were read.{hint}"),
            )),
            _ => None,
        }
    }

    /// What was assumed where it could be otherwise.
    pub fn assumed(&self, sample: &[&str]) -> Option<Remark> {
        let used: Vec<&str> = sample
            .iter()
            .flat_map(|line| self.parted.fields(line).enumerate().take(MAX_FIELDS))
            .filter(|&(column, _)| column == self.first || Some(column) == self.second)
            .map(|(_, field)| field)
            .filter(|field| self.style.number(field).is_some())
            .collect();
        let example = |sign: char| used.iter().copied().find(|field| field.contains(sign));
        let all_parted = |sign: char| {
            used.iter().filter(|field| field.contains(sign)).all(|field| may_be_parted(field, sign))
        };
        let taken = |what: &str, field: &str| {
            let value = self.style.number(field).unwrap_or_default();
            let field = short(field.trim().trim_matches('"'), 24);
            let columns = match self.second {
                Some(_) => format!("Columns are taken to be parted by {}, and ", self.parted.name()),
                None => "There is taken to be one column, and ".into(),
            };
            format!("{columns}{what}: “{field}” is {value}.")
        };
        let otherwise = " If it parts thousands, take it out of the file.";
        let comma = "the comma to be the decimal sign";
        let message = match (self.style, example(','), example('.')) {
            (Style::Point, ..) if self.parted == Parted::By(',') => self.narrow_heading(sample)?,
            (Style::Point, _, Some(field)) if self.parted == Parted::By(';') && all_parted('.') => {
                taken("the point to be the decimal sign", field) + otherwise
            }
            (Style::Comma, Some(field), _) if all_parted(',') => taken(comma, field) + otherwise,
            (Style::Comma, Some(field), _) => taken(comma, field),
            (Style::PointParts, _, Some(field)) => {
                taken(&format!("{comma}, and the point to part thousands"), field)
            }
            (Style::PointParts, Some(field), _) => taken(comma, field),
            (Style::CommaParts, Some(field), _) => taken("the comma to part thousands", field),
            (Style::Either, Some(field), _) => {
                taken("the comma to be a decimal sign, as the point is", field)
            }
            _ => return None,
        };
        Some(Remark::new("assumed", message))
    }

    /// What is said where the heading has other columns than the lines: their commas may be decimal ones.
    fn narrow_heading(&self, sample: &[&str]) -> Option<String> {
        if self.heading.is_some() {
            return None;
        }
        let count = |line: &str| self.parted.fields(line).count();
        let has_number = |line: &&str| {
            self.parted.fields(line).take(MAX_FIELDS).any(|field| self.style.number(field).is_some())
        };
        let begin = sample.iter().position(has_number)?;
        let (heading, line) = (sample.get(begin.checked_sub(1)?)?, sample[begin]);
        if count(heading) >= count(line) {
            return None;
        }
        Some(format!(
            "Commas are taken to part columns, so that “{}” is {} of them, though its heading has {}. Where they \
             are decimal signs, part the columns by semicolons.",
            short(line, 24),
            count(line),
            count(heading),
        ))
    }
}
